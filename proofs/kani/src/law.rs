//! TH-LAW and TH-UNI: force laws that are nowhere stiffer than the wall.

use passivity_core::{Law, Scalar, Step, generation, quantizer, spring};

use crate::Dyadic;
use crate::domain::{COARSE_EXPONENT, coarse_position, position};

/// Quarters: the force limit is in [0, 4), as far as positions go, 4 bits.
const FORCE_LIMIT: u8 = 16;

fn limit() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < FORCE_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// E_g of a step with the force held from its start, against the law's own potential.
fn generated(law: &Law<Dyadic>, step: &Step<Dyadic>) -> Dyadic {
    generation::generated(
        &law.held_force(&step.start),
        step,
        &law.potential(&step.start),
        &law.potential(&step.end),
    )
}

/// Whether a law's potential is the integral of its force, and the force nowhere too stiff.
///
/// Over ξ₀ ≤ ξ₁ a force that does not fall gains between f(ξ₀)·d and f(ξ₁)·d; cut fine enough,
/// that leaves the integral alone. Nowhere too stiff: f grows by at most d.
fn is_soft_spring(law: &Law<Dyadic>, step: &Step<Dyadic>) -> bool {
    let d = step.displacement();
    let (f0, f1) = (law.force(&step.start), law.force(&step.end));
    let gained = law.potential(&step.end) - law.potential(&step.start);
    f1 >= f0 && f1 - f0 <= d && gained >= f0 * d && gained <= f1 * d
}

/// TH-UNI: the one-sided wall generates at most ½d² + ½|d|.
#[kani::proof]
fn th_uni_bound() {
    let step = Step::new(position(), position());
    kani::cover!(
        step.start < Dyadic::zero() && step.end > Dyadic::zero(),
        "the wall is entered from outside"
    );
    kani::cover!(
        step.start > Dyadic::zero() && step.end < Dyadic::zero(),
        "the wall is left"
    );
    kani::assert(
        generated(&Law::unilateral(), &step) <= generation::bound_22(&step.displacement()),
        "TH-UNI: E_g ≤ ½d² + ½|d| for the one-sided wall",
    );
}

/// TH-UNI: the held force is zero exactly when the sample is outside, and never pulls.
#[kani::proof]
fn th_uni_force_is_zero_outside() {
    let xi = position();
    let held = Law::unilateral().held_force(&xi);
    kani::cover!(held == Dyadic::zero(), "outside");
    kani::assert(
        (held == Dyadic::zero()) == (xi < Dyadic::zero()) && held <= Dyadic::zero(),
        "TH-UNI: the held force is zero exactly outside",
    );
    kani::assert(
        kani::implies!(xi >= Dyadic::zero() => held == quantizer::held_force(&xi)),
        "TH-UNI: inside it is that of the wall on both sides",
    );
}

/// TH-UNI: its potential is the integral of its force, which is nowhere stiffer than the wall.
#[kani::proof]
fn th_uni_is_a_soft_spring() {
    let step = Step::new(coarse_position(), coarse_position());
    if step.start <= step.end {
        kani::cover!(
            step.start < Dyadic::zero() && step.end > Dyadic::zero(),
            "across the border"
        );
        kani::assert(
            is_soft_spring(&Law::unilateral(), &step),
            "TH-UNI: the potential is the integral of a force nowhere stiffer than 1",
        );
    }
}

/// TH-LAW: the law on both sides is the spring of the paper.
#[kani::proof]
fn th_law_on_both_sides_is_the_spring() {
    let xi = position();
    let law = Law::bilateral();
    kani::cover!(xi < Dyadic::zero(), "on the other side");
    kani::assert(
        law.force(&xi) == xi
            && law.held_force(&xi) == quantizer::held_force(&xi)
            && law.potential(&xi) == spring::linear_potential(&xi),
        "TH-LAW: the bilateral law is the linear spring",
    );
}

/// TH-LAW: the sample is off by at most ½, which is all that the theorem asks of it.
#[kani::proof]
fn th_law_sample_is_off_by_at_most_half() {
    let xi = position();
    let error = passivity_core::Quantized::of(&xi).measured() - xi;
    kani::cover!(error == Dyadic::new(1, 1), "off by a half");
    kani::assert(error.abs() <= Dyadic::new(1, 1), "TH-LAW: |e| ≤ ½");
}

/// TH-LAW: a saturated wall generates at most ½d² + ½|d|.
#[kani::proof]
fn th_law_saturated_bound() {
    let law = Law::bilateral().saturated(limit());
    let step = Step::new(coarse_position(), coarse_position());
    kani::cover!(
        law.force(&step.end) < step.end && law.force(&step.start) > step.start,
        "saturated at both ends, on both sides"
    );
    kani::assert(
        generated(&law, &step) <= generation::bound_22(&step.displacement()),
        "TH-LAW: E_g ≤ ½d² + ½|d| for the saturated wall",
    );
}

/// TH-LAW: a saturated one-sided wall generates at most ½d² + ½|d|.
#[kani::proof]
fn th_law_saturated_on_one_side_bound() {
    let law = Law::unilateral().saturated(limit());
    let step = Step::new(coarse_position(), coarse_position());
    kani::cover!(
        law.force(&step.start) < step.start && step.end < Dyadic::zero(),
        "from saturation to outside"
    );
    kani::assert(
        generated(&law, &step) <= generation::bound_22(&step.displacement()),
        "TH-LAW: E_g ≤ ½d² + ½|d| for the saturated one-sided wall",
    );
}

/// TH-LAW: saturation keeps the force within its limit and the law a soft spring.
#[kani::proof]
fn th_law_saturated_is_a_soft_spring() {
    let limit = limit();
    let law = Law::bilateral().saturated(limit);
    let step = Step::new(coarse_position(), coarse_position());
    if step.start <= step.end {
        kani::cover!(
            law.force(&step.end) == limit && limit < step.end,
            "saturated"
        );
        kani::assert(
            is_soft_spring(&law, &step),
            "TH-LAW: the potential is the integral of a force nowhere stiffer than 1",
        );
        kani::assert(
            law.force(&step.end).abs() <= limit,
            "TH-LAW: the force is within its limit",
        );
        let twice = law.saturated(limit + Dyadic::one());
        kani::assert(
            twice.force(&step.end) == law.force(&step.end),
            "TH-LAW: a wider limit changes nothing",
        );
    }
}
