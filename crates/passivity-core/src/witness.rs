//! A motion that draws energy from a display that is not passive (TH-ACTIVE).

use core::cmp::Ordering;

use crate::dissipation::Friction;
use crate::quantizer::held_force;
use crate::scalar::{Ordered, Scalar};

/// A cycle from one position to another and back, each way at constant speed within one sampling
/// interval.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction, Scalar, witness};
///
/// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(2, 5));
/// let cycle = witness::quantized(&friction, None).unwrap();
/// assert_eq!(cycle.gain, Fixed::new(1, 120));
/// assert_eq!(cycle.gain, witness::gain(&cycle.from, &cycle.to, &friction));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle<S> {
    /// Where the cycle starts and ends, a sampling instant: ticks, or the unit of length.
    pub from: S,
    /// Where it turns, a sampling instant.
    pub to: S,
    /// Energy that the operator gains each time round, in KΔ²; above zero.
    pub gain: S,
}

/// Energy gained in a cycle `from` → `to` → `from`, from the held force (5) and friction (23)
/// alone, in KΔ².
///
/// Each way takes one sampling interval at constant speed, and both turning points are sampling
/// instants.
#[must_use]
pub fn gain<S: Scalar>(from: &S, to: &S, friction: &Friction<S>) -> S {
    let there = to.clone() - from.clone();
    let work = held_force(from) * there.clone() - held_force(to) * there.clone();
    work - friction.dissipated_lower(&there, &there.abs()).double()
}

/// The gain by the formula of TH-ACTIVE, d·(m + 1 − 2βd − 2σ) with d = m + a, in KΔ².
///
/// For a cycle between n − a and n + m with whole n, m ≥ 0 and 0 < a ≤ 1.
#[must_use]
pub fn gain_formula<S: Scalar>(m: &S, a: &S, friction: &Friction<S>) -> S {
    let d = m.clone() + a.clone();
    let held = m.clone() + S::one();
    let spent = (friction.beta.clone() * d.clone() + friction.sigma.clone()).double();
    d * (held - spent)
}

/// A cycle that gains energy from a sampled and quantized wall, within the wall ξ ≥ 0; `None`
/// when β ≥ ½ and σ ≥ ½, when no such cycle stays below `speed_bound` (ticks per sample), or when
/// a number is undefined.
///
/// Without a bound it finds one whenever β < ½ or σ < ½ (TH-ACTIVE).
#[must_use]
pub fn quantized<S: Ordered>(friction: &Friction<S>, speed_bound: Option<&S>) -> Option<Cycle<S>> {
    let one = S::one();
    // What a long, slow cycle has left per tick of m, and what is missing at m = 0.
    let per_tick = one.clone() - friction.beta.double();
    let short = friction.sigma.double() - one.clone();
    let m = match (short.sign()?, per_tick.sign()?) {
        (Ordering::Less, _) => S::zero(),
        // The least whole m with m(1 − 2β) > 2σ − 1.
        (_, Ordering::Greater) => short.clone().over(per_tick.clone()).floor() + one.clone(),
        (_, _) => return None,
    };
    // With m fixed the gain is positive for a below `room`, and largest near half of it.
    let over = m.clone() * per_tick - short;
    let mut a = one.clone();
    if friction.beta.is_positive()? {
        a = a.min(over.over(friction.beta.double()).half());
    }
    if let Some(bound) = speed_bound {
        a = a.min(bound.clone() - m.clone());
    }
    if !a.is_positive()? {
        return None;
    }
    // Rounded down to a unit fraction, at least half of it: the same gain or less, and readable.
    let mut pieces = -(-(one.clone().over(a))).floor();
    if let Some(bound) = speed_bound {
        // Strictly below the bound: a hand that turns round within it is faster in between.
        let at_bound = m.clone() + one.clone().over(pieces.clone());
        if !(bound.clone() - at_bound).is_positive()? {
            pieces = pieces + one.clone();
        }
    }
    let a = one.clone().over(pieces);
    // From 1 − a ≥ 0 to 1 + m, so that a wall on one side only has the cycle as well (TH-UNI).
    let from = one.clone() - a;
    let to = one + m;
    let gain = gain(&from, &to, friction);
    gain.is_positive()?.then_some(Cycle { from, to, gain })
}

/// A cycle that gains energy from a sampled wall without an encoder: 0 → d → 0 (TH-SMOOTH).
///
/// σ here is c/K over the unit of length, which is also the unit of the answer. The gain is
/// 2(½d² − βd² − σd). `None` when β ≥ ½ or when `speed_bound` (length per sample) leaves no room.
#[must_use]
pub fn smooth<S: Ordered>(friction: &Friction<S>, speed_bound: Option<&S>) -> Option<Cycle<S>> {
    let spare = S::one().half() - friction.beta.clone();
    if !spare.is_positive()? {
        return None;
    }
    // Positive from this displacement on.
    let least = friction.sigma.clone().over(spare.clone());
    let mut d = if least.is_positive()? {
        least.double()
    } else {
        S::one()
    };
    if let Some(bound) = speed_bound {
        // Strictly below the bound: a hand that turns round within it is faster in between.
        d = d.min((least.max(S::zero()) + bound.clone()).half());
    }
    let gain = (d.clone() * (spare * d.clone() - friction.sigma.clone())).double();
    gain.is_positive()?.then_some(Cycle {
        from: S::zero(),
        to: d,
        gain,
    })
}
