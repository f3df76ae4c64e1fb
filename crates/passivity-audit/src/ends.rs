//! A dimensionless loop whose friction, and what it costs of it, lie between two ends, with its controller.

use passivity_core::verdict::End;
use passivity_core::{
    BigRational, Controller, Criterion, Fixed, Interval, Loop, Ordered, Parameter, Scalar, Wide,
    rational,
};

use crate::ball::Ball;
use crate::number::{Ample, to_ample};

/// A dimensionless loop at the least and at the most that its friction may be.
///
/// What it costs of viscous friction (TH-LTI) may be enclosed only, which matters to the margin alone. All
/// else is exact: it shapes the force or scales the trace, and an account is of one force.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction, Loop};
/// use passivity_audit::Ends;
///
/// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
/// assert!(Ends::exact(Loop::plain(friction)).is_plain());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Ends<S> {
    /// The loop with the least friction, and the highest cost.
    pub least: Loop<S>,
    /// The loop with the most friction, and the lowest cost.
    pub most: Loop<S>,
    /// The controller of both.
    pub controller: Controller<S>,
    /// The criterion with the terms of the effects, at the least and at the most friction.
    pub criteria: [Criterion<S>; 2],
    is_exact: IsExact,
}

/// What of a loop is known exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct IsExact {
    friction: bool,
    cost: bool,
}

/// Why a loop cannot be accounted for: something else than its friction and its cost is an interval.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotExact(pub Parameter);

impl std::fmt::Display for NotExact {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let name = self.0.row().name;
        write!(
            f,
            "an account needs one value of the {name}, not an interval"
        )
    }
}

impl std::error::Error for NotExact {}

impl<S: Scalar> Ends<S> {
    /// A loop that is known exactly.
    #[must_use]
    pub fn exact(dimensionless: Loop<S>) -> Self {
        let is_exact = IsExact {
            friction: true,
            cost: true,
        };
        Self::between(dimensionless.clone(), dimensionless, is_exact)
    }

    fn between(least: Loop<S>, most: Loop<S>, is_exact: IsExact) -> Self {
        Self {
            controller: Controller::of(&least),
            criteria: [least.criterion(), most.criterion()],
            least,
            most,
            is_exact,
        }
    }

    /// Whether friction is known exactly.
    #[must_use]
    pub const fn friction_is_exact(&self) -> bool {
        self.is_exact.friction
    }

    /// Whether the criterion is known exactly: friction, and what the loop costs of it.
    #[must_use]
    pub const fn criterion_is_exact(&self) -> bool {
        self.is_exact.friction && self.is_exact.cost
    }

    /// Whether an encoder, at most, is all there is beside the hold, so that a row depends on
    /// nothing but the difference of its two positions in ticks and on what is within the ticks.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.least.has_encoder() && self.least.is_plain() && self.least.law().is_linear()
    }

    /// The force held over an interval, in KΔ, from the samples up to its start, the latest first.
    ///
    /// A sample is all that is known of a position: within its tick, so that the encoder's count is
    /// known. Before the first one the device is taken to have stood where that finds it.
    #[must_use]
    pub fn held_force(&self, samples: &[crate::Figure<S>]) -> S {
        let known = samples.iter().take(self.controller.memory() + 1);
        let measured: Vec<S> = known
            .map(|sample| self.controller.measured(sample.lo()))
            .collect();
        self.controller.held_force(&measured)
    }

    /// The same loop with every number taken through `f`; `None` when `f` gives up on one.
    pub fn try_map<U: Scalar>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Ends<U>> {
        let loops = [&self.least, &self.most].map(|ends| ends.try_map(|_, x| f(x)));
        let [least, most] = loops;
        Some(Ends::between(least?, most?, self.is_exact))
    }
}

impl<S: Ordered> Ends<S> {
    /// The two ends of a dimensionless loop.
    ///
    /// # Errors
    ///
    /// [`NotExact`] when something else than friction and what the loop costs of it is an interval.
    pub fn of(dimensionless: &Loop<Interval<S>>) -> Result<Self, NotExact> {
        let mut is_exact = IsExact {
            friction: true,
            cost: true,
        };
        for (parameter, range) in dimensionless.given() {
            match parameter {
                _ if range.is_point() => {}
                Parameter::Viscous | Parameter::Coulomb => is_exact.friction = false,
                Parameter::ViscousCost => is_exact.cost = false,
                _ => return Err(NotExact(parameter)),
            }
        }
        let [least, most] = [End::Hardest, End::Easiest].map(|end| dimensionless.at(end));
        Ok(Self::between(least, most, is_exact))
    }
}

impl Ends<BigRational> {
    /// The loop over checked 128-bit fractions, when its numbers fit.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Ends<Fixed>> {
        self.try_map(rational::to_fixed)
    }

    /// The loop in doubles. One that does not fit is undefined there.
    #[must_use]
    pub(crate) fn to_near(&self) -> Ends<Ball> {
        /// Friction that is known as closely as this is one ball, which saves half of the work.
        const NARROW: i64 = 1 << 40;
        let narrow = |least: &BigRational, most: &BigRational| {
            (most - least) * BigRational::from_integer(NARROW.into()) < BigRational::one()
        };
        let friction = |of: &Loop<BigRational>| [of.viscous.clone(), of.coulomb.clone()];
        let mut both = friction(&self.least).into_iter().zip(friction(&self.most));
        let is_narrow = both.all(|ends| match ends {
            (Some(least), Some(most)) => narrow(&least, &most),
            (least, most) => least.is_none() && most.is_none(),
        });
        if !is_narrow || !self.is_exact.cost {
            let [least, most] =
                [&self.least, &self.most].map(|ends| ends.map(|_, x| Ball::of_rational(x)));
            return Ends::between(least, most, self.is_exact);
        }
        let mut one = self.least.map(|_, x| Ball::of_rational(x));
        let around = |least: &Option<BigRational>, most: &Option<BigRational>| {
            Some(Ball::around(least.as_ref()?, most.as_ref()?))
        };
        one.viscous = around(&self.least.viscous, &self.most.viscous);
        one.coulomb = around(&self.least.coulomb, &self.most.coulomb);
        Ends::exact(one)
    }

    /// The loop over whole numbers of any size.
    #[must_use]
    pub fn to_ample(&self) -> Ends<Ample> {
        let [least, most] = [&self.least, &self.most].map(|ends| ends.map(|_, x| to_ample(x)));
        Ends::between(least, most, self.is_exact)
    }

    /// The loop over big integers.
    #[must_use]
    pub fn to_wide(&self) -> Ends<Wide> {
        let [least, most] =
            [&self.least, &self.most].map(|ends| ends.map(|_, x| rational::to_wide(x)));
        Ends::between(least, most, self.is_exact)
    }
}
