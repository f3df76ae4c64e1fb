//! From margins to a verdict, for a loop and for a box of loops.
//!
//! A box is a [`Loop`] of intervals: every parameter anywhere in its own, independently of the
//! others. Each parameter makes the criterion harder in one direction ([`Hurts`]), but for the
//! sampling period: with an encoder and virtual damping a longer period costs viscous friction and
//! a shorter one Coulomb friction, BΔ/T. What is said of a box is said of every loop in it:
//! [`Truth::Holds`] when the criterion holds for all of them, [`Truth::Fails`] when for none.

use num_rational::BigRational;

use crate::criterion::Criterion;
use crate::fraction::Wide;
use crate::interval::{Interval, Truth};
use crate::parameter::{Hurts, Loop, Parameter};
use crate::rational::{to_fixed, to_wide};
use crate::region::Region;
use crate::scalar::Ordered;
use crate::start;
use crate::stiffness;

/// Up to which speed the criterion is asked to hold, in the units of the loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Speeds<V> {
    /// At every speed.
    All,
    /// At every speed up to V > 0.
    UpTo(V),
    /// At every speed up to V ≥ 0, of which the square is known (TH-START).
    UpToSquared(V),
}

impl<V: Clone> Loop<V> {
    /// The speeds that a verdict on the loop is about: all, or those up to `operator.max_speed`.
    #[must_use]
    pub fn speeds(&self) -> Speeds<V> {
        match &self.max_speed {
            Some(v) => Speeds::UpTo(v.clone()),
            None => Speeds::All,
        }
    }
}

/// What the criterion says of one loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decision {
    /// The region of the (β, σ) plane, with the terms of the effects (TH-REGION).
    pub region: Region,
    /// Whether the criterion holds at the speeds that were asked for.
    pub holds: bool,
}

/// Region and truth of a criterion; `None` when a number is undefined.
#[must_use]
pub fn decide<S: Ordered>(criterion: &Criterion<S>, speeds: &Speeds<S>) -> Option<Decision> {
    let region = Region::of(criterion)?;
    let holds = match (region, speeds) {
        (Region::GloballyStable, _) => true,
        (Region::LocallyStable, Speeds::UpTo(v)) => criterion.margin(v).is_nonnegative()?,
        (Region::LocallyStable, Speeds::UpToSquared(v)) => start::holds_up_to(criterion, v)?,
        (_, _) => false,
    };
    Some(Decision { region, holds })
}

/// The decision for a loop of big rationals, exact whatever their size.
///
/// It is computed on fractions of 128-bit integers where they are wide enough, and on big integers
/// where they are not. `None` only for a loop with a zero sampling period or stiffness.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Friction, Loop, Scalar};
/// use passivity_core::verdict::{self, Speeds};
///
/// let half = BigRational::integer(1).half();
/// let corner = Loop::plain(Friction::new(half.clone(), half));
/// assert!(verdict::of_loop(&corner, &Speeds::All).unwrap().holds); // equality is passive
/// ```
#[must_use]
pub fn of_loop(the_loop: &Loop<BigRational>, speeds: &Speeds<BigRational>) -> Option<Decision> {
    let fixed = the_loop
        .try_map(|_, x| to_fixed(x))
        .zip(speeds.try_map(to_fixed));
    if let Some(decision) = fixed.and_then(|(fixed, speeds)| decide(&fixed.criterion(), &speeds)) {
        return Some(decision);
    }
    let wide: Loop<Wide> = the_loop.map(|_, x| to_wide(x));
    decide(&wide.criterion(), &speeds.try_map(|x| Some(to_wide(x)))?)
}

impl<V> Speeds<V> {
    /// The same speeds with the number taken through `f`; `None` when `f` gives up on it.
    pub fn try_map<U>(&self, f: impl Fn(&V) -> Option<U>) -> Option<Speeds<U>> {
        Some(match self {
            Self::All => Speeds::All,
            Self::UpTo(v) => Speeds::UpTo(f(v)?),
            Self::UpToSquared(v) => Speeds::UpToSquared(f(v)?),
        })
    }
}

/// An end of the tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Where the criterion is hardest to meet.
    Hardest,
    /// Where it is easiest to meet.
    Easiest,
}

impl End {
    /// The end of a parameter's interval at which the criterion is hardest, or easiest, to meet.
    ///
    /// The upper end for a parameter that has no part in the criterion.
    pub const fn of<S>(self, parameter: Parameter, interval: &Interval<S>) -> &S {
        match (self, parameter.row().hurts) {
            (Self::Hardest, Hurts::Less) | (Self::Easiest, Hurts::More) => interval.lo(),
            (Self::Hardest, Hurts::More) | (Self::Easiest, Hurts::Less) => interval.hi(),
            (_, Hurts::Neither) => interval.hi(),
        }
    }
}

impl<S: Ordered> Speeds<Interval<S>> {
    /// The speeds at an end of their tolerance: the higher, the harder.
    #[must_use]
    pub fn at(&self, end: End) -> Speeds<S> {
        let of = |v: &Interval<S>| match end {
            End::Hardest => v.hi().clone(),
            End::Easiest => v.lo().clone(),
        };
        match self {
            Self::All => Speeds::All,
            Self::UpTo(v) => Speeds::UpTo(of(v)),
            Self::UpToSquared(v) => Speeds::UpToSquared(of(v)),
        }
    }
}

impl<S: Ordered> Loop<Interval<S>> {
    /// The loop of the box at one end of every tolerance.
    ///
    /// The period is at the end that is hardest, or easiest, for viscous friction.
    #[must_use]
    pub fn at(&self, end: End) -> Loop<S> {
        self.map(|parameter, interval| end.of(parameter, interval).clone())
    }

    /// Whether the sampling period pulls both ways: virtual damping behind an encoder.
    #[must_use]
    pub const fn period_pulls_both_ways(&self) -> bool {
        self.damping.is_some() && self.resolution.is_some() && self.coulomb_cost.is_none()
    }

    /// The loops of the box among which the criterion is hardest to meet, whatever is asked: all
    /// tolerances at their hardest, with the longest and with the shortest period.
    ///
    /// At a given speed the margin is a concave function of the period, −KT(½ + k)v − BΔ/T and a
    /// constant, so it is least at an end.
    #[must_use]
    pub fn hardest(&self) -> [Loop<S>; 2] {
        self.with_either_period(End::Hardest)
    }

    /// The loops of the box among which the criterion is easiest to meet at the ends of the period:
    /// all other tolerances at their easiest. With another period it may be easier still.
    #[must_use]
    pub fn easiest(&self) -> [Loop<S>; 2] {
        self.with_either_period(End::Easiest)
    }

    /// The loop at one end of every tolerance, with the longest and with the shortest period.
    fn with_either_period(&self, end: End) -> [Loop<S>; 2] {
        let corner = self.at(end);
        [self.period.hi(), self.period.lo()]
            .map(|period| corner.clone().with(Parameter::Period, period.clone()))
    }

    /// Enclosure of the criterion (11) over the box, term by term: at its hardest and its easiest.
    ///
    /// Every loop of the box lies between the two, and each coefficient is reached.
    #[must_use]
    pub fn criteria(&self) -> [Criterion<S>; 2] {
        let of = |end: End, period_for_coulomb: &S| {
            let corner = self.at(end);
            let other = corner
                .clone()
                .with(Parameter::Period, period_for_coulomb.clone());
            Criterion {
                viscous: corner.criterion().viscous,
                // BΔ/T is largest at the shortest period.
                coulomb: other.criterion().coulomb,
            }
        };
        [
            of(End::Hardest, self.period.lo()),
            of(End::Easiest, self.period.hi()),
        ]
    }

    /// Whether the criterion holds over the box at every speed asked for: for all of its loops, for
    /// none, or for some (TH-CHECK). `None` when a number is undefined.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, Interval, Loop, Scalar, Truth, verdict::Speeds};
    ///
    /// let friction = Friction::new(Fixed::new(2, 5), Fixed::new(3, 5));
    /// let point = Loop::plain(friction).map(|_, x| Interval::point(*x));
    /// let up_to = |lo, hi| Speeds::UpTo(Interval::hull(Fixed::new(lo, 2), Fixed::new(hi, 2)));
    /// assert_eq!(point.decide(&up_to(1, 2)), Some(Truth::Holds)); // the critical speed is 1
    /// assert_eq!(point.decide(&up_to(1, 3)), Some(Truth::Depends));
    /// assert_eq!(point.decide(&up_to(3, 4)), Some(Truth::Fails));
    /// ```
    #[must_use]
    pub fn decide(&self, speeds: &Speeds<Interval<S>>) -> Option<Truth> {
        let hardest = speeds.at(End::Hardest);
        let mut holds = true;
        for corner in self.hardest() {
            holds &= decide(&corner.criterion(), &hardest)?.holds;
        }
        let easiest = speeds.at(End::Easiest);
        Some(Truth::over(holds, self.some_loop_holds(&easiest)?))
    }

    /// Whether the criterion holds for a loop of the box.
    ///
    /// Where the period pulls both ways, the periods that meet the criterion with all else at its
    /// easiest are a stretch. If it reaches into the interval at all, then an end of the interval is
    /// in it, or its own shortest period, which Coulomb friction sets near rest, or the period that
    /// is best at the bound.
    ///
    /// For a bound of which only the square is known the answer may be `true` where no loop holds.
    fn some_loop_holds(&self, speeds: &Speeds<S>) -> Option<bool> {
        let mut holds = false;
        for corner in self.easiest() {
            holds |= decide(&corner.criterion(), speeds)?.holds;
        }
        if holds || !self.period_pulls_both_ways() {
            return Some(holds);
        }
        let corner = self.at(End::Easiest);
        let undamped = Loop {
            damping: None,
            ..corner.clone()
        };
        if !undamped.criterion().coulomb.is_positive()? {
            // Nothing is left for BΔ/T; and where B is zero, the shortest period was the easiest.
            return Some(false);
        }
        let at_the_bound = match speeds {
            Speeds::UpTo(v) => Some(stiffness::best_period_at_speed(&corner, v)),
            Speeds::All | Speeds::UpToSquared(_) => None,
        };
        let candidates = [stiffness::shortest_period(&corner), at_the_bound];
        for period in candidates.into_iter().flatten() {
            let inside = period.compare(self.period.lo())?.is_ge()
                && period.compare(self.period.hi())?.is_le();
            let other = corner.clone().with(Parameter::Period, period);
            if inside && decide(&other.criterion(), speeds)?.holds {
                return Some(true);
            }
        }
        match speeds {
            Speeds::All | Speeds::UpTo(_) => Some(false),
            Speeds::UpToSquared(_) => {
                let [_, best] = self.criteria();
                Some(decide(&best, speeds)?.holds)
            }
        }
    }

    /// The region of every loop of the box, or `None` when it depends or a number is undefined.
    ///
    /// The hardest loops have the least of either coefficient and the easiest ones the most. So
    /// where all four are in one region, no loop between them has a coefficient of another sign.
    #[must_use]
    pub fn region(&self) -> Option<Region> {
        let corners = self.hardest().into_iter().chain(self.easiest());
        let mut regions = corners.map(|corner| Region::of(&corner.criterion()));
        let first = regions.next()??;
        regions.all(|region| region == Some(first)).then_some(first)
    }
}
