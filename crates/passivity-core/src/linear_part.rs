//! What the linear part of a loop and its actuator cost of friction, as numbers: the controller, its
//! delay, the latency before the output changes and the lag of the amplifier (TH-LTI, TH-LATENCY,
//! TH-LAG).
//!
//! Dimensionless: the viscous cost in KT, the Coulomb cost of an encoder in KΔ. The parameters are
//! intervals, and so are the costs; of a point they are as tight as asked for, and
//! [`decide`](LinearPart::decide) compares without an error.
//!
//! - A linear loop costs λ of viscous friction, the largest value over all frequencies.
//! - Behind a one-sided or saturated wall it costs H(1)(½ + k) + Σ|gⱼ|, the absolute tail sums: safe,
//!   not sharp.
//! - Behind an actuator it costs H(1)·κ + Σ|gⱼ|, where κ counts all delays: safe, and sharp without
//!   a controller.
//! - An encoder costs ½‖c‖₁ of Coulomb friction in each of them.

use alloc::sync::Arc;
use alloc::vec::Vec;
use core::cmp::Ordering;

use num_rational::BigRational;

use crate::absolute_sum;
use crate::actuator::Actuator;
use crate::control_loop::Cost;
use crate::frequency::ViscousCost;
use crate::interval::Interval;
use crate::rational::{self, SHORT, from_wide, to_wide};
use crate::scalar::{Ordered as _, Scalar};
use crate::transfer::TransferFunction;

/// The highest degree of the polynomial in cos θ that λ is decided with. Beyond it the absolute tail
/// sums are used.
pub const MOST_DEGREE: usize = 24;

/// In how many pieces a range of the filter's pole is looked at for what it costs.
const PIECES: i32 = 8;

/// The law that makes a command of the measured positions.
#[derive(Clone, Debug, PartialEq)]
#[expect(
    clippy::large_enum_variant,
    reason = "one of them is made for a decision, and none are kept"
)]
pub enum Command {
    /// The spring with virtual damping behind a one-pole filter,
    /// 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹).
    Spring {
        /// B ≥ 0, in KT.
        damping: Interval<BigRational>,
        /// a, from 0 to below 1.
        pole: Interval<BigRational>,
    },
    /// Any stable controller.
    Controller(Arc<TransferFunction<BigRational>>),
}

/// A controller with its delays, and what is done with its command.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearPart {
    /// The law, without delay.
    pub command: Command,
    /// k, whole samples of delay.
    pub delay: u16,
    /// Latency and time constant of the actuator, in periods; `None` without either.
    pub actuator: Option<Actuator<Interval<BigRational>>>,
    /// Whether the force is linear in the measured positions.
    pub linear: bool,
}

impl LinearPart {
    /// The costs, enclosed; the viscous one at most `width` wide for a point.
    ///
    /// `None` where that takes more than the kernel computes: a pole too near to the unit circle, or
    /// a lag of too many periods.
    #[must_use]
    pub fn cost(&self, width: &BigRational) -> Option<Cost<Interval<BigRational>>> {
        let viscous = match (&self.actuator, self.linear) {
            (Some(actuator), _) => {
                let kappa = self.kappa(actuator, width)?;
                sum(&scaled(&kappa, &self.at_one()), &self.tails(width)?)
            }
            (None, true) => match self.by_frequency() {
                Some((cost, wobble)) => match self.over_pieces(width) {
                    Some(range) => range,
                    None => widened(&cost.enclosure(width), &wobble),
                },
                None if self.delay == 0 => self.without_delay(width)?,
                None => self.crude(width)?,
            },
            (None, false) => self.crude(width)?,
        };
        Some(Cost {
            viscous,
            coulomb: self.coulomb_cost(width)?,
        })
    }

    /// Whether β is at least the viscous cost, for every β of an interval and every value of the
    /// parameters, or for none; `None` where it depends, or where `width` does not tell.
    ///
    /// For a point, and a point β, a linear loop's answer is exact.
    #[must_use]
    pub fn decide(&self, beta: &Interval<BigRational>, width: &BigRational) -> Option<bool> {
        if self.costs_lambda() {
            // Of short numbers around these, in less time; of these, exactly.
            let around = |x: &Interval<BigRational>| x.shortened(SHORT);
            let near = self.map(around).by_frequency();
            let near = near.and_then(|near| decided_by(&near, &around(beta)));
            if near.is_some() {
                return near;
            }
            if let Some(exact) = self.by_frequency() {
                return decided_by(&exact, beta);
            }
        }
        if let (Some(answer), true) = (self.decide_actuator(beta), beta.is_point()) {
            return Some(answer);
        }
        let cost = self.cost(width)?.viscous;
        if beta.lo().compare(cost.hi())? != Ordering::Less {
            return Some(true);
        }
        (beta.hi().compare(cost.lo())? == Ordering::Less).then_some(false)
    }

    /// Whether λ, the largest cost over all frequencies, is what a linear loop costs.
    const fn costs_lambda(&self) -> bool {
        self.actuator.is_none() && self.linear
    }

    /// The same law with the intervals of its damping and its pole taken to others around them.
    fn map(&self, around: impl Fn(&Interval<BigRational>) -> Interval<BigRational>) -> Self {
        let command = match &self.command {
            Command::Spring { damping, pole } if around(pole).hi() < &BigRational::one() => {
                Command::Spring {
                    damping: around(damping),
                    pole: around(pole),
                }
            }
            exact => exact.clone(),
        };
        Self {
            command,
            ..self.clone()
        }
    }

    /// The exact decision behind an actuator whose parameters and tail sums are points.
    fn decide_actuator(&self, beta: &Interval<BigRational>) -> Option<bool> {
        let actuator = self.actuator.as_ref()?;
        let tails = self.tails(&BigRational::one())?;
        let at_one = self.at_one();
        let point = |x: &Interval<BigRational>| x.is_point().then(|| x.lo().clone());
        let exact = Actuator {
            latency: point(&actuator.latency)? + BigRational::from_integer(self.delay.into()),
            time_constant: point(&actuator.time_constant)?,
        };
        let rest = beta.lo() - point(&tails)?;
        if at_one == BigRational::zero() {
            return rest.is_nonnegative();
        }
        exact.decide(&rest.over(at_one))
    }

    /// ½‖c‖₁: a delay does not change it.
    pub(crate) fn coulomb_cost(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        match &self.command {
            Command::Spring { damping, pole } => {
                let of = |b: &BigRational, a: &BigRational| {
                    from_wide(&filtered_cost(&to_wide(b), &to_wide(a)).coulomb)
                };
                let lo = of(damping.lo(), pole.hi())?;
                Some(Interval::hull(lo, of(damping.hi(), pole.lo())?))
            }
            Command::Controller(controller) => {
                let whole = absolute_sum::enclosure(controller, width)?;
                Some(whole.map(|x| x.clone().half()))
            }
        }
    }

    /// H(1).
    #[must_use]
    pub fn at_one(&self) -> BigRational {
        match &self.command {
            Command::Spring { .. } => BigRational::one(),
            Command::Controller(controller) => controller.at_one(),
        }
    }

    /// Σ|gⱼ| of the law without delay: B of damping, filtered or not.
    fn tails(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        match &self.command {
            Command::Spring { damping, .. } => Some(damping.clone()),
            Command::Controller(controller) => absolute_sum::enclosure(&controller.tails(), width),
        }
    }

    /// H(1)(½ + k) + Σ|gⱼ|.
    fn crude(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        let samples = BigRational::one().half() + BigRational::from_integer(self.delay.into());
        let of_wall = self.at_one() * samples;
        Some(self.tails(width)?.map(|tail| tail + &of_wall))
    }

    /// ½ + B(1 − a)/(1 + a), the closed form of filtered damping; no more than the absolute tails of
    /// another controller.
    fn without_delay(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        let Command::Spring { damping, pole } = &self.command else {
            return self.crude(width);
        };
        let of = |b: &BigRational, a: &BigRational| {
            from_wide(&filtered_cost(&to_wide(b), &to_wide(a)).viscous)
        };
        let lo = of(damping.lo(), pole.hi())?;
        Some(Interval::hull(lo, of(damping.hi(), pole.lo())?))
    }

    /// λ(θ) at the middle of the parameters; `None` behind an actuator or a law that is not linear, or
    /// of too high a degree.
    #[must_use]
    pub fn frequency_response(&self) -> Option<ViscousCost> {
        if !self.linear || self.actuator.is_some() {
            return None;
        }
        let (middle, _) = self.middle()?;
        self.cost_of(middle)
    }

    /// λ(θ) of a law behind the delay; `None` where the degree is too high.
    fn cost_of(&self, law: TransferFunction<BigRational>) -> Option<ViscousCost> {
        let length = law.numerator().len().max(law.denominator().len());
        let degree = length + usize::from(self.delay);
        (degree <= MOST_DEGREE).then(|| ViscousCost::of(&law.delayed(self.delay)))
    }

    /// λ(θ) for the middle of the parameters, and how far it is at most from that of any others;
    /// `None` where a closed form says it, or where the degree is too high.
    fn by_frequency(&self) -> Option<(ViscousCost, BigRational)> {
        if self.delay == 0 && matches!(self.command, Command::Spring { .. }) {
            return None;
        }
        let (middle, wobble) = self.middle()?;
        let wobble = match self.swing() {
            Some(swing) => Scalar::min(wobble, swing),
            None => wobble,
        };
        Some((self.cost_of(middle)?, wobble))
    }

    /// How far λ of filtered damping is at most from that at the middle of its parameters: with u = a/(1 − a) a change of u
    /// changes the filter 1/(1 + uw), w = 1 − e^(−iθ), by at most Δu/(2√(u(1 + u))), which is less than Δu/2u. `None` of
    /// another law, and of a filter that may be none.
    fn swing(&self) -> Option<BigRational> {
        let Command::Spring { damping, pole } = &self.command else {
            return None;
        };
        let [from, middle, to] = [pole.lo(), &pole.middle(), pole.hi()].map(periods);
        let twice = from.clone().double();
        let off = Scalar::max(&middle - &from, to - middle);
        let relative = (twice != BigRational::zero()).then(|| off / twice)?;
        Some(damping.radius() + damping.hi() * relative)
    }

    /// The viscous cost of filtered damping over a wide range of the pole, in pieces: at most what the ends of one cost with
    /// what it bends between them, at least what its middle costs less its swing. `None` where the pole is known.
    fn over_pieces(&self, width: &BigRational) -> Option<Interval<BigRational>> {
        let Command::Spring { damping, pole } = &self.command else {
            return None;
        };
        let narrow = BigRational::new(1.into(), (1 << 20).into());
        if pole.radius() <= narrow || damping.hi() == &BigRational::zero() {
            return None;
        }
        // Costs are at least ½.
        let close = BigRational::new(1.into(), (1 << 24).into());
        let width = Scalar::max(width.clone(), close);
        let short = |x: &BigRational| rational::short(x, SHORT);
        let damping = damping.shortened(SHORT);
        let share = |i: i32| BigRational::new(i.into(), PIECES.into());
        let inner = |i| pole.lo() + (pole.hi() - pole.lo()) * share(i);
        let mut cuts = alloc::vec![short(pole.lo()).lo().clone()];
        cuts.extend((1..PIECES).map(|i| short(&inner(i)).lo().clone()));
        cuts.push(Some(short(pole.hi()).hi().clone()).filter(|last| last < &BigRational::one())?);
        let of = |damping: Interval<BigRational>, pole| {
            let command = Command::Spring { damping, pole };
            let part = Self {
                command,
                ..self.clone()
            };
            let (cost, wobble) = part.by_frequency()?;
            Some(widened(&cost.enclosure(&width), &wobble))
        };
        let mut at_cuts = Vec::new();
        for cut in &cuts {
            let at = |b: &BigRational| of(Interval::point(b.clone()), Interval::point(cut.clone()));
            at_cuts.push(Scalar::max(
                at(damping.lo())?.hi().clone(),
                at(damping.hi())?.hi().clone(),
            ));
        }
        let mut range: Option<Interval<BigRational>> = None;
        for (ends, costs) in cuts.windows(2).zip(at_cuts.windows(2)) {
            let ([from, to], [first, last]) = (ends, costs) else {
                return None;
            };
            let most = Scalar::max(first.clone(), last.clone());
            let most = most + bend(damping.hi(), &[periods(from), periods(to)]);
            let least = of(damping.clone(), Interval::hull(from.clone(), to.clone()))?;
            let here = Interval::hull(least.lo().clone(), most);
            range = Some(match range {
                Some(range) => range.joined(&here),
                None => here,
            });
        }
        range
    }

    /// The law at the middle of its parameters, and Σ|Δgⱼ| from it at most: with
    /// gⱼ = −B(1 − a)aʲ⁻¹ a change of B by ΔB makes ΔB, and one of a by Δa at most 2BΔa/(1 − a).
    pub(crate) fn middle(&self) -> Option<(TransferFunction<BigRational>, BigRational)> {
        match &self.command {
            Command::Controller(controller) => {
                Some((controller.as_ref().clone(), BigRational::zero()))
            }
            Command::Spring { damping, pole } => {
                let (b, a) = (damping.middle(), pole.middle());
                let per_pole = b.clone().double() / (BigRational::one() - pole.hi());
                let wobble = damping.radius() + per_pole * pole.radius();
                let law = TransferFunction::filtered_damping(&b, &a).ok()?;
                Some((law, wobble))
            }
        }
    }

    /// κ of the actuator with the whole samples of delay before it (TH-LAG).
    ///
    /// Over a box it is that of the middle with the mean delay at its ends, and a variance that is
    /// off by at most the widths: a delay that grows by dm changes Var = ∫G² − m² by 2∫(G − m)dG,
    /// where dG ≥ 0 and ∫dG = dm, and G varies by at most 1, so by at most 2dm.
    fn kappa(
        &self,
        actuator: &Actuator<Interval<BigRational>>,
        width: &BigRational,
    ) -> Option<Interval<BigRational>> {
        let delay = BigRational::from_integer(self.delay.into());
        let Actuator {
            latency,
            time_constant,
        } = actuator;
        let at_middle = Actuator {
            latency: latency.middle() + &delay,
            time_constant: time_constant.middle(),
        };
        if latency.is_point() && time_constant.is_point() {
            return at_middle.cost(width);
        }
        let error = latency.hi() - latency.lo() + time_constant.hi() - time_constant.lo();
        let ends = [
            (latency.lo() + time_constant.lo() + &delay, -error.clone()),
            (latency.hi() + time_constant.hi() + &delay, error),
        ];
        let [lo, hi] = ends.map(|(mean, error)| at_middle.cost_with(&mean, &error, width));
        Some(lo?.joined(&hi?))
    }
}

/// u = a/(1 − a) of a pole a: the filter's time constant in sampling periods.
fn periods(pole: &BigRational) -> BigRational {
    pole / (BigRational::one() - pole)
}

/// How far λ of filtered damping up to B is at most, between two values of u, above what the harder one costs: |φ″|(Δu)²/8 of
/// B, see [`cells`](crate::cells).
pub(crate) fn bend(damping: &BigRational, [from, to]: &[BigRational; 2]) -> BigRational {
    let step = to - from;
    // 4/(3√3) is below 77/100.
    let (most, bent) = (BigRational::integer(8), BigRational::integer(77));
    let around = from * (BigRational::one() + from) * BigRational::integer(100);
    let curvature = match around > BigRational::zero() {
        true => Scalar::min(bent / around, most),
        false => most,
    };
    let bend = damping * curvature * step.square() / BigRational::integer(8);
    rational::short(&bend, SHORT).hi().clone()
}

/// Whether β is at least a cost that is off by so much at most, for every β of an interval, or for none.
fn decided_by(
    (cost, wobble): &(ViscousCost, BigRational),
    beta: &Interval<BigRational>,
) -> Option<bool> {
    if cost.is_enough(&(beta.lo() - wobble)) {
        return Some(true);
    }
    (!cost.is_enough(&(beta.hi() + wobble))).then_some(false)
}

/// What the wall with virtual damping behind a one-pole filter costs, 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹),
/// without a delay: ½ + B(1 − a)/(1 + a) of viscous friction and, of an encoder, ½ + B(1 − a) of Coulomb
/// friction (TH-LTI).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, linear_part::filtered_cost};
///
/// let cost = filtered_cost(&Fixed::integer(1), &Fixed::new(1, 2));
/// assert_eq!((cost.viscous, cost.coulomb), (Fixed::new(5, 6), Fixed::integer(1)));
/// ```
#[must_use]
pub fn filtered_cost<S: Scalar>(damping: &S, pole: &S) -> Cost<S> {
    let passed = S::one() - pole.clone();
    let share = passed.clone().over(S::one() + pole.clone());
    Cost {
        viscous: S::one().half() + damping.clone() * share,
        coulomb: S::one().half() + damping.clone() * passed,
    }
}

/// An interval times a number that is not negative.
fn scaled(x: &Interval<BigRational>, by: &BigRational) -> Interval<BigRational> {
    x.map(|end| end * by)
}

fn sum(a: &Interval<BigRational>, b: &Interval<BigRational>) -> Interval<BigRational> {
    Interval::hull(a.lo() + b.lo(), a.hi() + b.hi())
}

fn widened(x: &Interval<BigRational>, by: &BigRational) -> Interval<BigRational> {
    Interval::hull(x.lo() - by, x.hi() + by)
}
