//! Exact identities of the paper: the quantized spring (16), (17) and generated energy (18)–(20).

use passivity_core::{Scalar, Step, generation, quantizer::held_force, spring};

use crate::Dyadic;
use crate::domain::{POSITION_EXPONENT, coarse_position, friction_coefficient, position};

/// Ticks of the first harness: ±4, as for positions.
const TICK_LIMIT: i8 = 4;

/// Sixteenths of a tick: the closed range 0..=16 has both borders of the tick, where H_e bends.
const TICK_PARTS: u8 = 1 << POSITION_EXPONENT;

/// EQ-16/17: over each closed tick H_e grows with the slope n + ½, which is minus the force.
///
/// Closed ticks share their borders, so this also says that H_e is continuous: it is the potential
/// of the quantized spring and nothing else.
#[kani::proof]
fn eq_16_17_quantized_potential_has_the_force_for_slope() {
    let n = i32::from(kani::any_where(|n: &i8| {
        *n >= -TICK_LIMIT && *n < TICK_LIMIT
    }));
    let a = i32::from(kani::any_where(|a: &u8| *a <= TICK_PARTS));
    let b = i32::from(kani::any_where(|b: &u8| *b <= TICK_PARTS));
    let tick = Dyadic::integer(n);
    let from = tick + Dyadic::new(a, POSITION_EXPONENT);
    let to = tick + Dyadic::new(b, POSITION_EXPONENT);
    kani::cover!(a == 0 && b == 16, "a whole tick, border to border");
    let gained = spring::quantized_potential(&to) - spring::quantized_potential(&from);
    kani::assert(
        gained == -(held_force(&tick) * (to - from)),
        "EQ-16/17: H_e is the potential of the quantized spring",
    );
    kani::assert(
        held_force(&tick) == -(tick + Dyadic::new(1, 1)),
        "EQ-16/17: the quantized spring pulls back from the middle of the tick",
    );
}

/// EQ-16/17: ½μξ̇² grows by force times distance.
///
/// Over a time t at constant acceleration (v₁ − v₀)/t the distance is ½(v₀ + v₁)t, so the work is
/// ½μ(v₁ − v₀)(v₁ + v₀), whatever t.
#[kani::proof]
fn eq_16_17_kinetic_energy_grows_by_work() {
    let mu = friction_coefficient();
    let v0 = coarse_position();
    let v1 = coarse_position();
    kani::cover!(
        v0 < Dyadic::zero() && v1 > Dyadic::zero(),
        "the motion turns"
    );
    let gained = spring::kinetic(&mu, &v1) - spring::kinetic(&mu, &v0);
    kani::assert(
        gained == (mu * ((v1 - v0) * (v1 + v0))).half(),
        "EQ-16/17: kinetic energy grows by the work done",
    );
}

/// EQ-16/17: H_T and S are kinetic energy and the potential.
#[kani::proof]
fn eq_16_17_storage_is_kinetic_energy_and_potential() {
    let mu = friction_coefficient();
    let xi = coarse_position();
    let v = coarse_position();
    let kinetic = spring::kinetic(&mu, &v);
    kani::cover!(
        kinetic > Dyadic::zero() && xi < Dyadic::zero(),
        "both kinds of energy"
    );
    kani::assert(
        spring::storage(&mu, &xi, &v) == kinetic + spring::linear_potential(&xi),
        "EQ-16/17: S is kinetic energy and the linear potential",
    );
    kani::assert(
        spring::quantized_storage(&mu, &xi, &v) == kinetic + spring::quantized_potential(&xi),
        "EQ-16/17: H_T is kinetic energy and H_e",
    );
}

/// EQ-19/20: (19) with (20) is ½D² + D(ρ₁ − ½).
#[kani::proof]
fn eq_19_20_is_the_form_in_whole_ticks() {
    let step = Step::new(position(), position());
    kani::cover!(
        step.ticks() < Dyadic::integer(-1),
        "several ticks are crossed downwards"
    );
    kani::assert(
        generation::generated_as_in_19(&step) == generation::generated_quantized(&step),
        "EQ-19/20: (19) with (20) is ½D² + D(ρ₁ − ½)",
    );
}

/// EQ-19/20: ½D² + D(ρ₁ − ½) is the integral (18) against the quantized spring.
#[kani::proof]
fn eq_19_20_is_the_integral_18() {
    let step = Step::new(position(), position());
    kani::cover!(
        step.ticks() > Dyadic::integer(1),
        "several ticks are crossed upwards"
    );
    let integral = generation::generated(
        &held_force(&step.start),
        &step,
        &spring::quantized_potential(&step.start),
        &spring::quantized_potential(&step.end),
    );
    kani::assert(
        integral == generation::generated_quantized(&step),
        "EQ-19/20: E_g is the integral (18)",
    );
}
