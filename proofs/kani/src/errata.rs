//! What the paper claims and what is false: each harness must fail, and for the named reason.
//!
//! Nothing else in them can fail, so the counterexample is one of the claim itself.

use passivity_core::{
    Criterion, Friction, Law, Scalar, Step, generation, quantizer::held_force, spring,
};

use crate::Dyadic;
use crate::domain::{coarse_position, friction_coefficient, position};

/// ERR-21/22: the bound (22) as printed; ξ: 1 → ½ breaks it (½ against 3/8).
#[kani::proof]
#[kani::should_panic]
fn err_21_22_bound_as_printed() {
    let step = Step::new(position(), position());
    let d = step.displacement();
    kani::cover!(d == Dyadic::new(-1, 1), "half a tick down");
    kani::assert(
        generation::generated_quantized(&step) <= generation::bound_22(&d),
        "ERR-21/22: E_g is within the printed bound (22)",
    );
}

/// ERR-27: passivity per interval as printed, at constant speed over one whole interval.
#[kani::proof]
#[kani::should_panic]
fn err_27_criterion_against_the_quantized_spring() {
    let step = Step::new(coarse_position(), coarse_position());
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = step.displacement();
    let speed = d.abs();
    if Criterion::of_friction(&friction)
        .margin(&speed)
        .is_at_least_zero()
    {
        kani::cover!(
            d < Dyadic::zero(),
            "the criterion holds and something moves"
        );
        kani::assert(
            generation::generated_quantized(&step) <= friction.dissipated_lower(&d, &speed),
            "ERR-27: the criterion makes E_g at most E_d for the paper's own E_g",
        );
    }
}

/// ERR-19-start: started after the sampling instant, the held force is that of an older position;
/// then even the linear counterpart breaks (22).
#[kani::proof]
#[kani::should_panic]
fn err_19_start_linear_counterpart() {
    let sampled_at = coarse_position();
    let step = Step::new(coarse_position(), coarse_position());
    let generated = generation::generated(
        &held_force(&sampled_at),
        &step,
        &spring::linear_potential(&step.start),
        &spring::linear_potential(&step.end),
    );
    kani::cover!(
        sampled_at < step.start && step.start < step.end,
        "started on the way"
    );
    kani::assert(
        generated <= generation::bound_22(&step.displacement()),
        "ERR-19-start: the linear counterpart is within (22) from any start",
    );
}

/// ERR-19-start: the same for the quantized counterpart and its own tight bound.
#[kani::proof]
#[kani::should_panic]
fn err_19_start_quantized_counterpart() {
    let sampled_at = coarse_position();
    let step = Step::new(coarse_position(), coarse_position());
    let generated = generation::generated(
        &held_force(&sampled_at),
        &step,
        &spring::quantized_potential(&step.start),
        &spring::quantized_potential(&step.end),
    );
    kani::cover!(
        sampled_at < step.start && step.start < step.end,
        "started on the way"
    );
    kani::assert(
        generated <= generation::bound_quantized(&step.displacement()),
        "ERR-19-start: the quantized counterpart is within its bound from any start",
    );
}

/// ERR-IV-C: a wall that is switched on at a depth has energy to give that nobody put in.
#[kani::proof]
#[kani::should_panic]
fn err_iv_c_switching_adds_nothing() {
    let depth = position();
    let added = Law::bilateral().switching_energy(false, true, &depth);
    kani::cover!(Dyadic::zero() < depth, "within the wall");
    kani::assert(
        added <= Dyadic::zero(),
        "ERR-IV-C: switching the wall on adds nothing to what is stored",
    );
}
