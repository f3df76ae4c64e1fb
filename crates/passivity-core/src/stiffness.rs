//! The stiffest wall, and the border value of every other parameter (TH-STIFF).
//!
//! Each function solves the criterion (11), with the terms of the effects, for one parameter and
//! leaves the others as they are. `None` means that the criterion does not limit the parameter.

use core::cmp::Ordering;

use crate::effects::delay_number;
use crate::rig::Rig;
use crate::scalar::{Ordered, Scalar};

/// Friction that is left for the wall itself once damping and D/A steps have taken their share.
struct Spare<S> {
    viscous: S,
    coulomb: S,
    /// T(½ + k): viscous friction that a unit of stiffness takes.
    viscous_per_stiffness: S,
    /// Δ/2 with an encoder: Coulomb friction that a unit of stiffness takes.
    coulomb_per_stiffness: Option<S>,
}

fn spare<S: Scalar>(rig: &Rig<S>) -> Spare<S> {
    // A wall of no stiffness leaves only what the other effects cost.
    let slack = Rig {
        stiffness: S::zero(),
        ..rig.clone()
    }
    .criterion();
    let samples_late = S::one().half() + delay_number(rig.effects.delay);
    Spare {
        viscous: slack.viscous,
        coulomb: slack.coulomb,
        viscous_per_stiffness: rig.period.clone() * samples_late,
        coulomb_per_stiffness: rig.effects.encoder.then(|| rig.length.clone().half()),
    }
}

/// The largest stiffness that viscous friction allows at any speed: 2b/T without effects.
///
/// # Example
///
/// ```
/// use passivity_core::{effects::Effects, Fixed, Rig, Scalar, stiffness};
///
/// let rig = Rig {
///     viscous: Fixed::new(9, 1_000_000),
///     coulomb: Fixed::new(2, 1000),
///     stiffness: Fixed::integer(1),
///     period: Fixed::new(1, 1000),
///     length: Fixed::new(1, 1000),
///     effects: Effects::encoder(),
/// };
/// assert_eq!(stiffness::viscous_limit(&rig), Fixed::new(18, 1000));
/// assert_eq!(stiffness::coulomb_limit(&rig), Some(Fixed::integer(4)));
/// ```
#[must_use]
pub fn viscous_limit<S: Scalar>(rig: &Rig<S>) -> S {
    let spare = spare(rig);
    spare.viscous.over(spare.viscous_per_stiffness)
}

/// The largest stiffness that Coulomb friction allows at any speed: 2c/Δ without effects; `None`
/// without an encoder.
#[must_use]
pub fn coulomb_limit<S: Scalar>(rig: &Rig<S>) -> Option<S> {
    let spare = spare(rig);
    spare
        .coulomb_per_stiffness
        .map(|per| spare.coulomb.over(per))
}

/// The largest stiffness at which the criterion holds at every speed: min(2b/T, 2c/Δ).
///
/// Not above zero when no wall at all is passive at every speed.
#[must_use]
pub fn limit_at_all_speeds<S: Ordered>(rig: &Rig<S>) -> S {
    near_rest(rig, viscous_limit(rig))
}

/// `limit`, or less where a wall that stiff fails near rest.
fn near_rest<S: Ordered>(rig: &Rig<S>, limit: S) -> S {
    if let Some(at_rest) = coulomb_limit(rig) {
        return limit.min(at_rest);
    }
    // Without an encoder stiffness costs no Coulomb friction, but D/A steps may already cost more
    // than there is: then no stiffness is low enough.
    let slack = spare(rig).coulomb;
    match slack.sign() {
        Some(Ordering::Less) => limit.min(S::zero()),
        Some(_) => limit,
        None => slack,
    }
}

/// The largest stiffness at which the criterion holds at speed v > 0: 2(bv + c)/(Tv + Δ).
#[must_use]
pub fn limit_at_speed<S: Scalar>(rig: &Rig<S>, speed: &S) -> S {
    let spare = spare(rig);
    let friction = spare.viscous * speed.clone() + spare.coulomb;
    let mut per_stiffness = spare.viscous_per_stiffness * speed.clone();
    if let Some(per) = spare.coulomb_per_stiffness {
        per_stiffness = per_stiffness + per;
    }
    friction.over(per_stiffness)
}

/// The largest stiffness at which the criterion holds at every speed up to v > 0.
///
/// The limit at a speed lies between the limits at rest and at the bound, so the smaller of these
/// two it is. Not above zero when no wall at all is passive up to that speed.
#[must_use]
pub fn limit_up_to_speed<S: Ordered>(rig: &Rig<S>, speed: &S) -> S {
    near_rest(rig, limit_at_speed(rig, speed))
}

/// The least viscous friction for the criterion at every speed: KT(½ + k) + B.
#[must_use]
pub fn viscous_needed<S: Scalar>(rig: &Rig<S>) -> S {
    rig.viscous.clone() - rig.criterion().viscous
}

/// The least viscous friction for the criterion at speed v > 0, Coulomb friction as it is.
#[must_use]
pub fn viscous_needed_at_speed<S: Scalar>(rig: &Rig<S>, speed: &S) -> S {
    let margin = rig.criterion().margin(speed);
    rig.viscous.clone() - margin.over(speed.clone())
}

/// The least Coulomb friction for the criterion at every speed: KΔ/2 + BΔ/T + F/2.
#[must_use]
pub fn coulomb_needed<S: Scalar>(rig: &Rig<S>) -> S {
    rig.coulomb.clone() - rig.criterion().coulomb
}

/// The least Coulomb friction for the criterion at every speed up to v, viscous friction as it is.
#[must_use]
pub fn coulomb_needed_up_to_speed<S: Scalar>(rig: &Rig<S>, speed: &S) -> S {
    rig.coulomb.clone() - rig.criterion().margin_up_to(speed)
}

/// The longest sampling period that viscous friction allows at every speed: (b − B)/(K(½ + k)).
///
/// With an encoder and virtual damping a shorter period also costs Coulomb friction, BΔ/T: check
/// the verdict at the period returned.
#[must_use]
pub fn longest_period<S: Scalar>(rig: &Rig<S>) -> S {
    (spare(rig).viscous * rig.period.clone())
        .over(spare(rig).viscous_per_stiffness * rig.stiffness.clone())
}

/// The longest sampling period for the criterion at speed v > 0, the term BΔ/T kept as it is.
#[must_use]
pub fn longest_period_at_speed<S: Scalar>(rig: &Rig<S>, speed: &S) -> S {
    let per_period =
        rig.stiffness.clone() * (S::one().half() + delay_number(rig.effects.delay)) * speed.clone();
    rig.period.clone() + rig.criterion().margin(speed).over(per_period)
}

/// The coarsest encoder for the criterion at every speed: 2c/K without effects; `None` without an
/// encoder.
#[must_use]
pub fn coarsest_resolution<S: Scalar>(rig: &Rig<S>) -> Option<S> {
    let margin = rig.criterion().coulomb;
    coulomb_per_length(rig).map(|per| rig.length.clone() + margin.over(per))
}

/// The coarsest encoder for the criterion at every speed up to v; `None` without an encoder.
#[must_use]
pub fn coarsest_resolution_up_to_speed<S: Scalar>(rig: &Rig<S>, speed: &S) -> Option<S> {
    let margin = rig.criterion().margin_up_to(speed);
    coulomb_per_length(rig).map(|per| rig.length.clone() + margin.over(per))
}

/// K/2 + B/T: Coulomb friction that a unit of encoder resolution takes.
fn coulomb_per_length<S: Scalar>(rig: &Rig<S>) -> Option<S> {
    let damping = rig
        .effects
        .damping
        .clone()
        .map(|b| b.over(rig.period.clone()));
    let stiffness = rig.stiffness.clone().half();
    rig.effects.encoder.then(|| match damping {
        Some(damping) => stiffness + damping,
        None => stiffness,
    })
}
