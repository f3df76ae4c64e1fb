//! Effects of a real loop: TH-DAC, TH-DELAY, TH-DAMP, and their sum as the code has it.
//!
//! In each, E_g plus what the effect puts into its extra storage is at most the cost that
//! `Loop::cost` tells the criterion to subtract.

use passivity_core::{
    Controller, Friction, Loop, Scalar, Step,
    controller::rounded,
    extra_storage::{damping_storage, delay_storage, generated_by_damping, generated_by_delay},
    generation,
    quantizer::held_force,
    spring,
};

use crate::domain::{COARSE_EXPONENT, SHARE_LIMIT, below, coarse_position, share, up_to};
use crate::{Dyadic, Ratio};

/// Half ticks: displacements of the delay's sums in ±4, 4 bits, up to four of them.
const MOVE_LIMIT: i8 = 8;

fn displacement() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -MOVE_LIMIT && *n < MOVE_LIMIT);
    Dyadic::new(i32::from(n), 1)
}

/// Half ticks: positions of the combined effects in ±2, 3 bits, since up to four are multiplied.
const LOOP_LIMIT: i8 = 4;

pub(crate) fn loop_position() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -LOOP_LIMIT && *n < LOOP_LIMIT);
    Dyadic::new(i32::from(n), 1)
}

/// Quarters of a tick: positions of a damped loop in ±2, 4 bits, three of them and B multiplied.
const NEAR_LIMIT: i8 = 8;

fn near_position() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -NEAR_LIMIT && *n < NEAR_LIMIT);
    Dyadic::new(i32::from(n), COARSE_EXPONENT)
}

/// Step of the force where effects are combined, δ = ½; `th_dac_bound` has others.
pub(crate) const LOOP_FORCE_STEP: Dyadic = Dyadic::new(1, 1);

/// Halves: virtual damping of the combined effects, in [0, 2), 2 bits; the lower half and the upper
/// half of that have a harness each, since both at once take a model checker longer than the two.
const LOOP_SHARE_LIMIT: u8 = 4;

/// Virtual damping 0 or ½.
pub(crate) fn little_damping() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n < LOOP_SHARE_LIMIT / 2);
    Dyadic::new(i32::from(n), 1)
}

/// Virtual damping 1 or 3/2.
pub(crate) fn more_damping() -> Dyadic {
    let n = kani::any_where(|n: &u8| *n >= LOOP_SHARE_LIMIT / 2 && *n < LOOP_SHARE_LIMIT);
    Dyadic::new(i32::from(n), 1)
}

/// An interval of a loop with effects: what it generates with what the effects store, the cost that
/// must cover both, and whether the motion turns with the damping pushing on.
pub(crate) struct Interval {
    pub(crate) generated_and_stored: Dyadic,
    pub(crate) cost: Dyadic,
    pub(crate) turning: bool,
}

/// E_gᴸ of a step under a given held force.
pub(crate) fn generated_linear(held: Dyadic, step: &Step<Dyadic>) -> Dyadic {
    generation::generated(
        &held,
        step,
        &spring::linear_potential(&step.start),
        &spring::linear_potential(&step.end),
    )
}

/// A device without friction, of which the costs of effects are independent.
pub(crate) fn frictionless() -> Friction<Dyadic> {
    Friction::new(Dyadic::zero(), Dyadic::zero())
}

/// The force that the loop's controller holds, the positions at the samples given, the latest
/// first; before the D/A converter, whose error is a case of its own.
pub(crate) fn held_before_rounding<const N: usize>(
    the_loop: &Loop<Dyadic>,
    positions: [Dyadic; N],
) -> Dyadic {
    let controller = Controller::of(&Loop {
        force_step: None,
        ..the_loop.clone()
    });
    controller.held_force(&positions.map(|xi| controller.measured(&xi)))
}

/// TH-DAC: rounding to whole steps is off by at most half a step.
#[kani::proof]
fn th_dac_rounding_is_off_by_at_most_half_a_step() {
    let force = (below(32) - Ratio::integer(16)).half();
    let step = up_to(4).half();
    let to_step = rounded(&force, &step, &Ratio::one());
    let error = to_step - force;
    kani::cover!(error.double() == step, "off by half a step");
    kani::assert(
        error.abs().double() <= step,
        "TH-DAC: the force is off by at most ½δ",
    );
    let steps = to_step.over(step);
    kani::assert(
        steps == steps.floor(),
        "TH-DAC: the force is a whole number of steps",
    );
}

/// TH-DAC: a force that is off by up to ½δ generates at most ½d² + ½(1 + δ)|d|.
#[kani::proof]
fn th_dac_bound() {
    let quarters = kani::any_where(|n: &u8| *n < SHARE_LIMIT);
    let force_step = Dyadic::new(i32::from(quarters), COARSE_EXPONENT);
    // Eighths: half of a step in quarters.
    let eighths = kani::any_where(|n: &i8| *n >= -(quarters as i8) && *n <= quarters as i8);
    let error = Dyadic::new(i32::from(eighths), COARSE_EXPONENT + 1);
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    let the_loop = Loop {
        force_step: Some(force_step),
        ..Loop::plain(frictionless())
    };
    kani::cover!(
        error.double() == force_step && d > Dyadic::zero() && quarters > 0,
        "off by half a step"
    );
    kani::assert(
        generated_linear(held_force(&step.start) + error, &step) <= the_loop.cost().bound(&d),
        "TH-DAC: E_g ≤ ½d² + ½(1 + δ)|d|",
    );
}

/// TH-DELAY: a force held from an older sample adds d times what was travelled since.
#[kani::proof]
fn th_delay_adds_what_was_travelled_since() {
    let step = Step::new(coarse_position(), coarse_position());
    let d = step.displacement();
    let travelled = coarse_position();
    kani::cover!(
        travelled > Dyadic::zero() && d > Dyadic::zero(),
        "moving on"
    );
    let late = generated_linear(held_force(&(step.start - travelled)), &step);
    kani::assert(
        late <= generation::bound_22(&d) + generated_by_delay(&[travelled], &d),
        "TH-DELAY: a late force generates ½d² + ½|d| + d·Σd at most",
    );
}

/// TH-DELAY: one sample late, the extra term is at most d² and a drop of storage.
#[kani::proof]
#[kani::unwind(3)]
fn th_delay_of_one_sample() {
    let (d, d1) = (displacement(), displacement());
    let change = delay_storage(&[d]) - delay_storage(&[d1]);
    kani::cover!(
        d == d1 && d > Dyadic::zero(),
        "at constant speed the bound is reached"
    );
    kani::assert(
        generated_by_delay(&[d1], &d) + change <= d.square(),
        "TH-DELAY: k = 1 costs d²",
    );
}

/// TH-DELAY: two samples late, at most 2d² and a drop of storage.
#[kani::proof]
#[kani::unwind(4)]
fn th_delay_of_two_samples() {
    let (d, d1, d2) = (displacement(), displacement(), displacement());
    let change = delay_storage(&[d, d1]) - delay_storage(&[d1, d2]);
    kani::cover!(d1 < Dyadic::zero() && d2 > Dyadic::zero(), "turning");
    kani::assert(
        generated_by_delay(&[d1, d2], &d) + change <= d.square().double(),
        "TH-DELAY: k = 2 costs 2d²",
    );
}

/// TH-DELAY: three samples late, at most 3d² and a drop of storage.
#[kani::proof]
#[kani::unwind(5)]
fn th_delay_of_three_samples() {
    let (d, d1) = (displacement(), displacement());
    let (d2, d3) = (displacement(), displacement());
    let change = delay_storage(&[d, d1, d2]) - delay_storage(&[d1, d2, d3]);
    kani::cover!(
        d > Dyadic::zero() && d1 == d && d2 == d && d3 == d,
        "at constant speed the bound is reached"
    );
    kani::assert(
        generated_by_delay(&[d1, d2, d3], &d) + change <= d.square().double() + d.square(),
        "TH-DELAY: k = 3 costs 3d²",
    );
}

/// TH-DELAY: the storage kept for the delay is never negative.
#[kani::proof]
#[kani::unwind(4)]
fn th_delay_storage_is_never_negative() {
    let (d1, d2) = (displacement(), displacement());
    let stored = delay_storage(&[d1, d2]);
    kani::cover!(stored > Dyadic::zero(), "something is stored");
    kani::assert(
        stored == d1.square() + d2.square().half() && stored.is_at_least_zero(),
        "TH-DELAY: the storage is ½·2·d² of the last step and ½·d² of the one before",
    );
}

/// An interval of a damped loop, with positions near the border of the wall.
fn damped(damping: Dyadic) -> Interval {
    let previous = near_position();
    let step = Step::new(near_position(), near_position());
    let d = step.displacement();
    let before = Step::new(previous, step.start);
    let change =
        damping_storage(&damping, &[d]) - damping_storage(&damping, &[before.displacement()]);
    let ticks = before.ticks();
    let the_loop = Loop {
        damping: Some(damping),
        ..Loop::plain(frictionless())
    };
    // The force −(n + ½) − B·(q_h − q_{h−1}).
    let held = held_before_rounding(&the_loop, [step.start, previous]);
    Interval {
        generated_and_stored: generated_linear(held, &step) + change,
        cost: the_loop.cost().bound(&d),
        turning: ticks < Dyadic::zero() && d > Dyadic::zero() && damping > Dyadic::zero(),
    }
}

/// TH-DAMP: virtual damping costs Bd² + B|d| and a drop of storage, on top of the wall.
#[kani::proof]
#[kani::unwind(3)]
fn th_damp_bound_with_little_damping() {
    let interval = damped(little_damping());
    kani::cover!(interval.turning, "turning: the damping pushes on");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-DAMP: E_g ≤ (½ + B)d² + (½ + B)|d| and a drop of storage",
    );
}

/// TH-DAMP: the same with more damping.
#[kani::proof]
#[kani::unwind(3)]
fn th_damp_bound_with_more_damping() {
    let interval = damped(more_damping());
    kani::cover!(interval.turning, "turning: the damping pushes on");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-DAMP: E_g ≤ (½ + B)d² + (½ + B)|d| and a drop of storage",
    );
}

/// Whole ticks: what positions near the border can be apart, and one more, 3 bits.
const TICK_LIMIT: i8 = 4;

/// TH-DAMP: the parts that the bound is made of.
#[kani::proof]
#[kani::unwind(3)]
fn th_damp_generates_its_force_times_the_way() {
    let step = Step::new(near_position(), near_position());
    let damping = share();
    let n = kani::any_where(|n: &i8| *n >= -TICK_LIMIT && *n < TICK_LIMIT);
    let ticks = Dyadic::integer(i32::from(n));
    let d = step.displacement();
    kani::cover!(
        ticks < Dyadic::zero() && d > Dyadic::zero() && damping > Dyadic::zero(),
        "the damping pushes on"
    );
    let held = held_force(&step.start) - damping * ticks;
    kani::assert(
        generated_linear(held, &step)
            == generation::generated_linear(&step) + generated_by_damping(&damping, &ticks, &d),
        "TH-DAMP: damping adds −B·(q_h − q_{h−1})·d",
    );
    kani::assert(
        damping_storage(&damping, &[d]).double() == damping * d.square(),
        "TH-DAMP: the storage is ½B·d² of the last step",
    );
}

/// An interval of a loop one sample late, with virtual damping and a D/A converter: four positions
/// in a row, from the sample before the one that the controller acts on to the end of the interval.
fn late_damped_and_rounded(damping: Dyadic) -> Interval {
    let older = loop_position();
    let old = loop_position();
    let step = Step::new(loop_position(), loop_position());
    let force_step = LOOP_FORCE_STEP;
    let rounds_up: bool = kani::any();
    let d = step.displacement();
    let last = step.start - old;
    let before = Step::new(older, old);
    let the_loop = Loop {
        delay: 1,
        damping: Some(damping),
        force_step: Some(force_step),
        ..Loop::plain(frictionless())
    };
    // What it generates is linear in the rounding error, so the two ends of ±½δ are enough.
    let error = if rounds_up {
        force_step.half()
    } else {
        -force_step.half()
    };
    let held = held_before_rounding(&the_loop, [step.start, old, older]) + error;
    let change = delay_storage(&[d]) - delay_storage(&[last])
        + damping_storage(&damping, &[d, last])
        - damping_storage(&damping, &[last, before.displacement()]);
    Interval {
        generated_and_stored: generated_linear(held, &step) + change,
        cost: the_loop.cost().bound(&d),
        turning: before.ticks() < Dyadic::zero() && d > Dyadic::zero() && damping > Dyadic::zero(),
    }
}

/// TH-DELAY with TH-DAMP and TH-DAC: the costs add, as the code adds them.
#[kani::proof]
#[kani::unwind(4)]
fn th_delay_with_little_damping_and_dac() {
    let interval = late_damped_and_rounded(little_damping());
    kani::cover!(interval.turning, "turning, with damping");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-DELAY: with TH-DAMP and TH-DAC the costs add",
    );
}

/// TH-DELAY with TH-DAMP and TH-DAC: the same with more damping.
#[kani::proof]
#[kani::unwind(4)]
fn th_delay_with_more_damping_and_dac() {
    let interval = late_damped_and_rounded(more_damping());
    kani::cover!(interval.turning, "turning, with damping");
    kani::assert(
        interval.generated_and_stored <= interval.cost,
        "TH-DELAY: with TH-DAMP and TH-DAC the costs add",
    );
}

/// Delays whose cost is looked at: up to three samples.
const DELAY_LIMIT: u16 = 3;

/// TH-DELAY, TH-DAMP, TH-DAC, TH-SMOOTH: the terms that the criterion subtracts, one by one.
#[kani::proof]
fn th_delay_damping_and_dac_terms_of_the_criterion() {
    let delay = kani::any_where(|k: &u16| *k <= DELAY_LIMIT);
    let damping = share();
    let force_step = share();
    let late = Dyadic::new(1, 1) + Dyadic::integer(i32::from(delay));
    let friction = Friction::new(share(), share());
    let with_encoder = Loop {
        delay,
        damping: Some(damping),
        force_step: Some(force_step),
        ..Loop::plain(friction)
    };
    let cost = with_encoder.cost();
    kani::cover!(delay == 2 && damping > Dyadic::zero(), "late and damped");
    kani::assert(
        cost.viscous == late + damping
            && cost.coulomb == (Dyadic::one() + force_step).half() + damping,
        "TH-DELAY: the cost is ½ + k + B per d² and ½(1 + δ) + B per |d|",
    );
    let cost = Loop {
        resolution: None,
        ..with_encoder.clone()
    }
    .cost();
    kani::assert(
        cost.viscous == late + damping && cost.coulomb == force_step.half(),
        "TH-SMOOTH: without an encoder it is ½δ per |d|",
    );
    let criterion = with_encoder.criterion();
    let cost = with_encoder.cost();
    kani::assert(
        criterion.viscous == friction.beta - cost.viscous
            && criterion.coulomb == friction.sigma - cost.coulomb,
        "TH-DELAY: the criterion is friction less the cost",
    );
}
