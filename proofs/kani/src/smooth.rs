//! Loops without an encoder: TH-SMOOTH, alone and with the effects of [`effects`](crate::effects).

use passivity_core::{
    Friction, Loop, Scalar, Step,
    extra_storage::{damping_storage, delay_storage},
};

use crate::Dyadic;
use crate::domain::{coarse_position, friction_coefficient, speed};
use crate::effects::{
    Interval, LOOP_FORCE_STEP, frictionless, generated_linear, held_before_rounding,
    little_damping, loop_position, more_damping,
};

/// TH-SMOOTH: with the position known exactly E_g is ½d², neither more nor less.
#[kani::proof]
fn th_smooth_generates_half_d_squared() {
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    kani::cover!(d < Dyadic::zero(), "downwards");
    kani::assert(
        generated_linear(-step.start, &step) == Loop::smooth(frictionless()).cost().bound(&d),
        "TH-SMOOTH: E_g = ½d²",
    );
}

/// TH-SMOOTH: (β − ½)v̄ + σ ≥ 0 makes friction cover ½d², for Δτ ≤ 1; with σ = 0 it is Colgate's
/// β ≥ ½.
#[kani::proof]
fn th_smooth_criterion() {
    let friction = Friction::new(friction_coefficient(), friction_coefficient());
    let d = coarse_position();
    let speed = speed();
    let the_loop = Loop::smooth(friction);
    let criterion = the_loop.criterion();
    if speed >= d.abs() && criterion.margin(&speed).is_at_least_zero() {
        kani::cover!(
            friction.sigma < Dyadic::new(1, 1)
                && friction.beta < Dyadic::new(1, 1)
                && d != Dyadic::zero(),
            "with less friction than an encoder needs"
        );
        kani::assert(
            the_loop.cost().bound(&d) <= friction.dissipated_lower(&d, &speed),
            "TH-SMOOTH: the criterion makes friction cover ½d²",
        );
    }
    kani::assert(
        criterion.viscous == friction.beta - Dyadic::new(1, 1)
            && criterion.coulomb == friction.sigma,
        "TH-SMOOTH: the criterion is (β − ½)v + σ ≥ 0",
    );
}

/// An interval of a loop without an encoder, one sample late, with virtual damping and a D/A converter.
fn smooth_late_and_damped(damping: Dyadic) -> Interval {
    let (older, old) = (loop_position(), loop_position());
    let step = Step::new(loop_position(), loop_position());
    let force_step = LOOP_FORCE_STEP;
    let d = step.displacement();
    let last = step.start - old;
    let before = old - older;
    let the_loop = Loop {
        delay: 1,
        damping: Some(damping),
        force_step: Some(force_step),
        ..Loop::smooth(frictionless())
    };
    let held = held_before_rounding(&the_loop, [step.start, old, older]) + force_step.half();
    let change = delay_storage(&[d]) - delay_storage(&[last])
        + damping_storage(&damping, &[d, last])
        - damping_storage(&damping, &[last, before]);
    Interval {
        generated_and_stored: generated_linear(held, &step) + change,
        cost: the_loop.cost().bound(&d),
        turning: before < Dyadic::zero() && d > Dyadic::zero() && damping > Dyadic::zero(),
    }
}

/// TH-SMOOTH: delay, damping and D/A steps without an encoder cost no B per |d|.
#[kani::proof]
#[kani::unwind(4)]
fn th_smooth_with_delay_little_damping_and_dac() {
    let interval = smooth_late_and_damped(little_damping());
    kani::cover!(interval.turning, "turning, with damping");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-SMOOTH: the costs add without an encoder too",
    );
}

/// TH-SMOOTH: the same with more damping.
#[kani::proof]
#[kani::unwind(4)]
fn th_smooth_with_delay_more_damping_and_dac() {
    let interval = smooth_late_and_damped(more_damping());
    kani::cover!(interval.turning, "turning, with damping");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-SMOOTH: the costs add without an encoder too",
    );
}
