//! Loops whose costs have no closed form that the checker of boxes knows: as its words, the kernel's
//! verdict on them, and random ones.

use std::sync::Arc;

use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Interval, Loop, Scalar, Truth, rational};

use crate::Bounds;
use crate::random::Random;

/// Bits to which the costs are enclosed that friction is drawn about.
const BITS: u32 = 40;

/// The loop with each number at the least of its tolerance; friction keeps its own.
pub(crate) fn point(of: &Bounds) -> Bounds {
    Loop {
        viscous: of.viscous.clone(),
        coulomb: of.coulomb.clone(),
        ..of.map(|_, x| Interval::point(x.lo().clone()))
    }
}

/// A loop of points but for friction in the words of the checker; `None` where it decides none such:
/// a response that does not end.
pub(crate) fn words(of: &Bounds) -> Option<String> {
    let number = |x: &Interval<BigRational>| x.lo().to_string();
    let optional = |x: &Option<_>| x.as_ref().map_or("-".to_owned(), number);
    let friction = |x: &Option<Interval<BigRational>>| {
        let zero = Interval::point(BigRational::zero());
        let range = x.as_ref().unwrap_or(&zero);
        format!("{}:{}", range.lo(), range.hi())
    };
    let damping = of
        .damping
        .as_ref()
        .map_or(BigRational::zero(), |b| b.lo().clone());
    let (kind, others) = if of.has_actuator() {
        let latency = of
            .latency
            .as_ref()
            .map_or(BigRational::zero(), |x| x.lo().clone());
        let late = latency / of.period.lo();
        let samples = late.floor() + BigRational::integer(of.delay.into());
        let fraction = &late - late.floor();
        let response = response(of)?;
        match &of.time_constant {
            Some(time) => (
                "lag",
                format!("{samples} {fraction} {} {response}", time.lo()),
            ),
            None if fraction == BigRational::zero() => return None,
            None => ("latency", format!("{samples} {fraction} {response}")),
        }
    } else if !of.is_linear() {
        ("gated", format!("{} {}", of.delay, response(of)?))
    } else if of.controller.is_some() {
        ("filter", format!("{} {}", of.delay, response(of)?))
    } else if let Some(tau) = &of.damping_time_constant {
        if of.delay > 0 {
            return None;
        }
        ("one_pole", format!("{damping} {}", tau.lo()))
    } else {
        ("damped", format!("{} {damping}", of.delay))
    };
    let head = [
        friction(&of.viscous),
        friction(&of.coulomb),
        number(&of.stiffness),
        number(&of.period),
        optional(&of.resolution),
        optional(&of.force_step),
        optional(&of.max_speed),
    ];
    Some(format!("{kind} {} {others}", head.join(" ")))
}

/// c₀, c₁, … without the delay; `None` where they do not end.
fn response(of: &Bounds) -> Option<String> {
    let response = match (&of.controller, &of.damping) {
        (Some(controller), _) if controller.denominator().len() > 1 => return None,
        (Some(controller), _) => controller.impulse_response(controller.numerator().len()),
        (None, Some(_)) if of.damping_time_constant.is_some() => return None,
        (None, Some(damping)) => {
            let b = damping.lo() / of.stiffness.lo() / of.period.lo();
            vec![BigRational::one() + &b, -b]
        }
        (None, None) => vec![BigRational::one()],
    };
    let words: Vec<_> = response.iter().map(ToString::to_string).collect();
    Some(if words.is_empty() {
        "0".to_owned()
    } else {
        words.join(",")
    })
}

/// What the kernel says of a loop.
pub(crate) fn verdict(of: &Bounds) -> Option<Truth> {
    let wide = of.map(|_, x| x.map(rational::to_wide));
    wide.truth(&wide.speeds())
}

/// 10⁻³⁰.
fn tiny() -> BigRational {
    let tenth = BigRational::integer(10).recip();
    (0..30).fold(BigRational::one(), |tiny, _| tiny * &tenth)
}

/// Loops with a sample of delay and damping of B ≥ ¼ that have just the friction that is asked for,
/// ½ + B + 1/(8B) and ½ + B (TH-LTI), and with 10⁻³⁰ less of viscous friction.
pub(crate) fn borders() -> Vec<[Bounds; 2]> {
    let half = BigRational::one().half();
    let point = |x: &BigRational| Some(Interval::point(x.clone()));
    let one = || Interval::point(BigRational::one());
    let of = |eighths: i32| {
        let b = BigRational::integer(eighths) / BigRational::integer(8);
        let viscous = &half + &b + BigRational::integer(eighths).recip();
        [viscous.clone(), viscous - tiny()].map(|viscous| Loop {
            viscous: point(&viscous),
            coulomb: point(&(&half + &b)),
            resolution: Some(one()),
            damping: point(&b),
            delay: 1,
            ..Loop::new(one(), one())
        })
    };
    (2..=32).map(of).collect()
}

impl Random {
    fn some(&mut self, least: i32) -> Option<Interval<BigRational>> {
        (self.below(2) > 0).then(|| Interval::point(self.eighths(least)))
    }

    /// A response of up to six coefficients behind the first, with H(1) ≥ 0.
    fn response(&mut self) -> Arc<TransferFunction<BigRational>> {
        loop {
            let order = self.below(7);
            let response: Vec<_> = (0..=order)
                .map(|_| self.eighths(0) - BigRational::integer(2))
                .collect();
            if let Ok(controller) = TransferFunction::new(response, [BigRational::one()]) {
                return Arc::new(controller);
            }
        }
    }

    /// k + f samples in seconds, 0 < f < 1. For every other one κ is a fraction: with
    /// f = (r² − (½ + k)²)/(2 + 2k) its root is r.
    fn latency(&mut self, period: &BigRational) -> BigRational {
        let k = BigRational::integer(self.below(3).into());
        let part = BigRational::integer(1 + i32::from(self.below(7))) / BigRational::integer(8);
        let fraction = if self.below(2) > 0 {
            let at_least = BigRational::one().half() + &k;
            let root = &at_least + part;
            (root.square() - at_least.square()) / (BigRational::one() + &k).double()
        } else {
            part
        };
        (k + fraction) * period
    }

    /// Any loop with a computed cost. Friction is drawn about the border, and within 10⁻³⁰ of it, or
    /// on it where the cost is a fraction.
    pub(crate) fn any_computed(&mut self) -> Option<Bounds> {
        let (stiffness, period) = (self.eighths(1), self.eighths(1));
        let mut of: Bounds = Loop {
            resolution: self.some(1),
            force_step: self.some(1),
            max_speed: self.some(1),
            delay: self.below(4),
            ..Loop::new(Interval::point(stiffness), Interval::point(period.clone()))
        };
        let kind = self.below(6);
        match (kind, self.below(3)) {
            (0, _) | (3 | 4, 0) => of.damping = Some(Interval::point(self.eighths(1))),
            (1 | 5, _) | (3 | 4, 1) => of.controller = Some(self.response()),
            (2, _) => {
                of.delay = 0;
                of.damping = Some(Interval::point(self.eighths(1)));
                of.damping_time_constant = Some(Interval::point(self.eighths(0)));
            }
            _ => {}
        }
        if kind == 3 || (kind == 4 && self.below(2) > 0) {
            of.latency = Some(Interval::point(self.latency(&period)));
        }
        if kind == 4 {
            of.time_constant = Some(Interval::point(self.eighths(1)));
        }
        if kind == 5 {
            of.unilateral = self.below(2) > 0;
            if !of.unilateral {
                of.max_force = Some(Interval::point(self.eighths(1)));
            }
        }
        self.with_friction(of)
    }

    fn with_friction(&mut self, of: Bounds) -> Option<Bounds> {
        let costs = of.map(|_, x| x.map(rational::to_wide)).with_costs(BITS)?;
        let end = if self.below(2) == 0 {
            costs.map(|_, x| x.lo().clone())
        } else {
            costs.map(|_, x| x.hi().clone())
        };
        let cost = end.cost();
        let mut viscous = rational::from_wide(&cost.viscous)?;
        let mut coulomb = rational::from_wide(&cost.coulomb)?;
        if self.below(3) == 0 {
            // Coulomb friction to spare, which does for viscous friction at the bound.
            let spare = self.eighths(0);
            if let Some(v) = &of.max_speed {
                viscous -= &spare / v.lo();
            }
            coulomb += spare;
        }
        match self.below(8) {
            0 => viscous -= tiny(),
            1 => viscous += tiny(),
            2 => coulomb -= tiny(),
            3 | 4 => viscous *= self.eighths(4).half(),
            _ => {}
        }
        let width = match self.below(4) {
            0 => self.eighths(0),
            _ => BigRational::zero(),
        };
        let within = |least: BigRational| {
            let lo = Scalar::max(least, BigRational::zero());
            Some(Interval::hull(lo.clone(), lo + &width))
        };
        Some(Loop {
            viscous: within(viscous),
            coulomb: within(coulomb),
            ..of
        })
    }
}
