//! The stiffest wall, and the border value of every other parameter (TH-STIFF).
//!
//! Each function solves the criterion (11), with the terms of the effects, for one parameter and
//! leaves the others as they are. `None` means that the criterion does not limit the parameter.

use core::cmp::Ordering;

use crate::parameter::{Loop, Parameter};
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

fn spare<S: Scalar>(the_loop: &Loop<S>) -> Spare<S> {
    // A wall of no stiffness leaves only what the other effects cost, and no other effect costs
    // anything where the wall is all there is.
    let slack = the_loop
        .clone()
        .with(Parameter::Stiffness, S::zero())
        .criterion();
    let wall_alone = Loop {
        damping: None,
        force_step: None,
        ..the_loop.clone().with(Parameter::Stiffness, S::one())
    };
    let cost = wall_alone.cost();
    Spare {
        viscous: slack.viscous,
        coulomb: slack.coulomb,
        viscous_per_stiffness: cost.viscous,
        coulomb_per_stiffness: the_loop.has_encoder().then_some(cost.coulomb),
    }
}

/// The largest stiffness that viscous friction allows at any speed: 2b/T without effects.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Loop, Scalar, stiffness};
///
/// let re35 = Loop {
///     viscous: Some(Fixed::new(9, 1_000_000)),
///     coulomb: Some(Fixed::new(2, 1000)),
///     resolution: Some(Fixed::new(1, 1000)),
///     ..Loop::new(Fixed::integer(1), Fixed::new(1, 1000))
/// };
/// assert_eq!(stiffness::viscous_limit(&re35), Fixed::new(18, 1000));
/// assert_eq!(stiffness::coulomb_limit(&re35), Some(Fixed::integer(4)));
/// ```
#[must_use]
pub fn viscous_limit<S: Scalar>(the_loop: &Loop<S>) -> S {
    let spare = spare(the_loop);
    spare.viscous.over(spare.viscous_per_stiffness)
}

/// The largest stiffness that Coulomb friction allows at any speed: 2c/Δ without effects; `None`
/// without an encoder.
#[must_use]
pub fn coulomb_limit<S: Scalar>(the_loop: &Loop<S>) -> Option<S> {
    let spare = spare(the_loop);
    spare
        .coulomb_per_stiffness
        .map(|per| spare.coulomb.over(per))
}

/// The largest stiffness at which the criterion holds at every speed: min(2b/T, 2c/Δ).
///
/// Not above zero when no wall at all is passive at every speed.
#[must_use]
pub fn limit_at_all_speeds<S: Ordered>(the_loop: &Loop<S>) -> S {
    near_rest(the_loop, viscous_limit(the_loop))
}

/// `limit`, or less where a wall that stiff fails near rest.
fn near_rest<S: Ordered>(the_loop: &Loop<S>, limit: S) -> S {
    if let Some(at_rest) = coulomb_limit(the_loop) {
        return limit.min(at_rest);
    }
    // Without an encoder stiffness costs no Coulomb friction, but D/A steps may already cost more
    // than there is: then no stiffness is low enough.
    let slack = spare(the_loop).coulomb;
    match slack.sign() {
        Some(Ordering::Less) => limit.min(S::zero()),
        Some(_) => limit,
        None => slack,
    }
}

/// The largest stiffness at which the criterion holds at speed v > 0: 2(bv + c)/(Tv + Δ).
#[must_use]
pub fn limit_at_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> S {
    let spare = spare(the_loop);
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
pub fn limit_up_to_speed<S: Ordered>(the_loop: &Loop<S>, speed: &S) -> S {
    near_rest(the_loop, limit_at_speed(the_loop, speed))
}

/// The least viscous friction for the criterion at every speed: KT(½ + k) + B.
#[must_use]
pub fn viscous_needed<S: Scalar>(the_loop: &Loop<S>) -> S {
    the_loop.viscous_friction() - the_loop.criterion().viscous
}

/// The least viscous friction for the criterion at speed v > 0, Coulomb friction as it is.
#[must_use]
pub fn viscous_needed_at_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> S {
    let margin = the_loop.criterion().margin(speed);
    the_loop.viscous_friction() - margin.over(speed.clone())
}

/// The least Coulomb friction for the criterion at every speed: KΔ/2 + BΔ/T + F/2.
#[must_use]
pub fn coulomb_needed<S: Scalar>(the_loop: &Loop<S>) -> S {
    the_loop.coulomb_friction() - the_loop.criterion().coulomb
}

/// The least Coulomb friction for the criterion at every speed up to v, viscous friction as it is.
#[must_use]
pub fn coulomb_needed_up_to_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> S {
    the_loop.coulomb_friction() - the_loop.criterion().margin_up_to(speed)
}

/// The longest sampling period that viscous friction allows at every speed: (b − B)/(K(½ + k)).
///
/// With an encoder and virtual damping a shorter period also costs Coulomb friction, BΔ/T: see
/// [`shortest_period`].
#[must_use]
pub fn longest_period<S: Scalar>(the_loop: &Loop<S>) -> S {
    let unit_period = spare(&the_loop.clone().with(Parameter::Period, S::one()));
    unit_period
        .viscous
        .over(unit_period.viscous_per_stiffness * the_loop.stiffness.clone())
}

/// The shortest sampling period that Coulomb friction allows near rest, BΔ/(c − KΔ/2 − F/2); `None`
/// without virtual damping behind an encoder.
///
/// Not above zero, or undefined, where no period at all is long enough.
#[must_use]
pub fn shortest_period<S: Scalar>(the_loop: &Loop<S>) -> Option<S> {
    let (damping, resolution) = the_loop
        .damping
        .as_ref()
        .zip(the_loop.resolution.as_ref())?;
    let undamped = Loop {
        damping: None,
        ..the_loop.clone()
    };
    let per_tick = damping.clone() * resolution.clone();
    Some(per_tick.over(undamped.criterion().coulomb))
}

/// The longest sampling period for the criterion at speed v > 0, where a period costs nothing but
/// viscous friction: without virtual damping behind an encoder.
#[must_use]
pub fn longest_period_at_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> S {
    let spare = spare(&the_loop.clone().with(Parameter::Period, S::one()));
    let per_period = spare.viscous_per_stiffness * the_loop.stiffness.clone() * speed.clone();
    the_loop.period.clone() + the_loop.criterion().margin(speed).over(per_period)
}

/// The sampling period with the largest product of period and margin at speed v > 0:
/// (c − KΔ/2 − F/2 + (b − B)v)/(2K(½ + k)v).
///
/// With virtual damping behind an encoder the margin at v is c − KΔ/2 − F/2 + (b − B)v −
/// K(½ + k)v·T − BΔ/T. Times T it is a parabola that opens downwards, so the periods that meet the
/// criterion at v are a stretch around this one, or there are none.
#[must_use]
pub fn best_period_at_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> S {
    let undamped = Loop {
        damping: None,
        ..the_loop.clone().with(Parameter::Period, S::one())
    };
    let damping = the_loop.damping.clone().unwrap_or_else(S::zero);
    let viscous = the_loop.viscous_friction() - damping;
    let per_period = undamped.cost().viscous * speed.clone();
    (undamped.criterion().coulomb + viscous * speed.clone()).over(per_period.double())
}

/// The coarsest encoder for the criterion at every speed: 2c/K without effects; `None` without an
/// encoder.
#[must_use]
pub fn coarsest_resolution<S: Scalar>(the_loop: &Loop<S>) -> Option<S> {
    coarsest(the_loop, the_loop.criterion().coulomb)
}

/// The coarsest encoder for the criterion at every speed up to v; `None` without an encoder.
#[must_use]
pub fn coarsest_resolution_up_to_speed<S: Scalar>(the_loop: &Loop<S>, speed: &S) -> Option<S> {
    coarsest(the_loop, the_loop.criterion().margin_up_to(speed))
}

/// The resolution at which a margin, which falls by K/2 + B/T a unit of resolution, is zero.
fn coarsest<S: Scalar>(the_loop: &Loop<S>, margin: S) -> Option<S> {
    let resolution = the_loop.resolution.clone()?;
    let of_unit = the_loop
        .clone()
        .with(Parameter::Resolution, S::one())
        .cost();
    let of_none = the_loop
        .clone()
        .with(Parameter::Resolution, S::zero())
        .cost();
    Some(resolution + margin.over(of_unit.coulomb - of_none.coulomb))
}
