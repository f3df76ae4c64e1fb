//! What friction dissipates: the lower bound (26) in its discrete form.
//!
//! A motion is approximated as closely as one likes by pieces of constant velocity. Merging two
//! neighbouring pieces into one of the same length and displacement never gains dissipation; that
//! is the step of an induction which ends with one piece, and with (26).

use passivity_core::{Friction, Ordered, Scalar, dissipation::mean_speed};

use crate::domain::{below, coarse_position, friction_coefficient, up_to};
use crate::{Dyadic, Ratio};

/// Half ticks per sample: velocities in ±4, 4 bits, since four of them are multiplied.
const VELOCITY_LIMIT: i8 = 8;

/// Quarters of a sampling period: a piece lasts up to two periods, 3 bits.
const DURATION_LIMIT: u8 = 8;

fn velocity() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -VELOCITY_LIMIT && *n < VELOCITY_LIMIT);
    Dyadic::new(i32::from(n), 1)
}

fn duration() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n >= 1 && *n <= DURATION_LIMIT);
    Dyadic::new(i32::from(n), 2)
}

/// Friction with β = 1 and nothing else.
const VISCOUS: Friction<Dyadic> = Friction::new(Dyadic::new(1, 0), Dyadic::new(0, 0));

/// Friction with σ = 1 and nothing else.
const COULOMB: Friction<Dyadic> = Friction::new(Dyadic::new(0, 0), Dyadic::new(1, 0));

/// EQ-23..26: two pieces of constant velocity dissipate at least what (26) says of their sum.
///
/// Viscous and Coulomb friction one by one (Cauchy–Schwarz, triangle inequality): all is linear in
/// β and σ, see the next harnesses. The viscous bound is multiplied by the time, βd²/Δτ·Δτ = β|d|·|d|.
#[kani::proof]
fn eq_23_26_merging_two_pieces_gains_nothing() {
    let (v0, t0) = (velocity(), duration());
    let (v1, t1) = (velocity(), duration());
    let d = v0 * t0 + v1 * t1;
    kani::cover!(
        v0 > Dyadic::zero() && v1 < Dyadic::zero(),
        "the motion turns between them"
    );
    let sum = |friction: Friction<Dyadic>| {
        friction.dissipated_at_constant_velocity(&v0, &t0)
            + friction.dissipated_at_constant_velocity(&v1, &t1)
    };
    kani::assert(
        sum(VISCOUS) * (t0 + t1) >= VISCOUS.dissipated_lower(&d, &d.abs()),
        "EQ-23..26: viscous dissipation is at least βd²/Δτ",
    );
    kani::assert(
        sum(COULOMB) >= COULOMB.dissipated_lower(&d, &Dyadic::zero()),
        "EQ-23..26: Coulomb dissipation is at least σ|d|",
    );
}

/// EQ-23..26: power is linear in β and σ.
#[kani::proof]
fn eq_23_26_power_is_linear_in_friction() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let v = coarse_position();
    kani::cover!(v < Dyadic::zero(), "downwards");
    kani::assert(
        friction.power(&v)
            == friction.beta * VISCOUS.power(&v) + friction.sigma * COULOMB.power(&v),
        "EQ-23..26: power is linear in β and σ",
    );
    kani::assert(
        VISCOUS.power(&v) == v.square() && COULOMB.power(&v) == v.abs(),
        "EQ-23..26: power is βξ̇² + σ|ξ̇|",
    );
}

/// EQ-23..26: viscous and Coulomb friction add up in the lower bound of power's integral.
///
/// With the next harness the bound is linear in β and σ. One equation of the four numbers together
/// takes a model checker many times as long as the two.
#[kani::proof]
fn eq_23_26_bound_is_that_of_each_friction_and_their_sum() {
    let (beta, sigma) = (friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let v = coarse_position();
    kani::cover!(
        d < Dyadic::zero() && v > Dyadic::zero(),
        "against the velocity"
    );
    let speed = v.abs();
    let lower = |beta, sigma| Friction::new(beta, sigma).dissipated_lower(&d, &speed);
    kani::assert(
        lower(beta, sigma) == lower(beta, Dyadic::zero()) + lower(Dyadic::zero(), sigma),
        "EQ-23..26: viscous and Coulomb friction add up in the lower bound",
    );
}

/// EQ-23..26: the lower bound is proportional to β without Coulomb friction, and to σ without
/// viscous friction.
#[kani::proof]
fn eq_23_26_bound_is_linear_in_each_friction() {
    let (beta, sigma) = (friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let v = coarse_position();
    kani::cover!(
        d < Dyadic::zero() && v > Dyadic::zero(),
        "against the velocity"
    );
    let speed = v.abs();
    let lower = |friction: Friction<Dyadic>| friction.dissipated_lower(&d, &speed);
    kani::assert(
        lower(Friction::new(beta, Dyadic::zero())) == beta * lower(VISCOUS),
        "EQ-23..26: the lower bound is linear in β",
    );
    kani::assert(
        lower(Friction::new(Dyadic::zero(), sigma)) == sigma * lower(COULOMB),
        "EQ-23..26: the lower bound is linear in σ",
    );
}

/// EQ-23..26: the lower bound is what a motion at constant speed dissipates.
#[kani::proof]
fn eq_23_26_is_reached_at_constant_speed() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let (v, t) = (velocity(), duration());
    let d = v * t;
    kani::cover!(v < Dyadic::zero(), "downwards");
    kani::assert(
        friction.dissipated_at_constant_velocity(&v, &t) == friction.dissipated_lower(&d, &v.abs()),
        "EQ-23..26: the bound is reached at constant speed",
    );
}

/// EQ-23..26: mean speed times time is the distance.
#[kani::proof]
fn eq_23_26_mean_speed_is_distance_over_time() {
    let d = below(16) - Ratio::integer(8);
    let t = up_to(4).half();
    kani::cover!(d.is_nonnegative() == Some(false), "downwards");
    kani::assert(
        mean_speed(&d, &t) * t == d.abs(),
        "EQ-23..26: the mean speed is |d|/Δτ",
    );
}
