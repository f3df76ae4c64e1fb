//! TH-LATENCY: β ≥ κ without a root. TH-LTI: a sample of filtered damping.

extern crate alloc;

use alloc::collections::VecDeque;

use passivity_core::Scalar;
use passivity_core::actuator::{Actuator, spare};
use passivity_core::controller::Filter;

use crate::Dyadic;
use crate::domain::share;

/// Eighths up to which β goes: below 4, past κ of two samples, 5 bits.
const FRICTION_LIMIT: u8 = 32;

/// Sixteenths up to which variances go: below ½, twice the largest of a latency, 3 bits.
const VARIANCE_LIMIT: u8 = 8;

/// Sixteenths of a sampling period up to which latencies go: below 4, 6 bits.
const LATENCY_LIMIT: u8 = 64;

/// Quarters: poles 0, ¼, ½ and ¾, 2 bits.
const POLE_LIMIT: u8 = 4;

/// Half ticks: positions and states of the filter in ±2, 3 bits, since three of them are squared.
const STATE_LIMIT: i8 = 4;

fn state() -> Dyadic {
    let n = kani::any_where(|n: &i8| *n >= -STATE_LIMIT && *n < STATE_LIMIT);
    Dyadic::new(i32::from(n), 1)
}

/// TH-LATENCY: the two numbers of the decision are what the squares say.
#[kani::proof]
fn th_latency_decision_is_by_squares() {
    let beta = kani::any_where(|n: &u8| *n < FRICTION_LIMIT);
    let beta = Dyadic::new(i32::from(beta), 3);
    let mean_delay = share();
    let variance = kani::any_where(|n: &u8| *n < VARIANCE_LIMIT);
    let variance = Dyadic::new(i32::from(variance), 4);
    let [over, square] = spare(&beta, &mean_delay, &variance);
    let first = Dyadic::integer(1).half() + mean_delay;
    let rest = beta.double() - first;
    let by_squares =
        rest.is_at_least_zero() && (rest.square() - first.square() - variance).is_at_least_zero();
    kani::cover!(
        square.is_at_least_zero() && !over.is_at_least_zero(),
        "the square alone would do without friction"
    );
    kani::assert(
        (over.is_at_least_zero() && square.is_at_least_zero()) == by_squares,
        "TH-LATENCY: β ≥ κ is decided by squares",
    );
}

/// TH-LATENCY: whole samples of latency do not vary with the phase, half a sample does most.
#[kani::proof]
fn th_latency_variance_is_of_the_fraction() {
    let n = kani::any_where(|n: &u8| *n < LATENCY_LIMIT);
    let late = Actuator {
        latency: Dyadic::new(i32::from(n), 4),
        time_constant: Dyadic::zero(),
    };
    let part = i32::from(n % 16);
    kani::cover!(part == 8, "half a sample");
    kani::assert(
        late.variance_of_latency() == Dyadic::new(part * (16 - part), 8),
        "TH-LATENCY: the variance is f(1 − f)",
    );
}

/// TH-LTI: a displacement charged with (1 − a)/(1 + a) covers what the filter draws and stores.
#[kani::proof]
#[kani::unwind(4)]
fn th_lti_one_pole_step() {
    let pole = kani::any_where(|n: &u8| *n < POLE_LIMIT);
    let pole = Dyadic::new(i32::from(pole), 2);
    let (from, to, before) = (state(), state(), state());
    let filter = Filter::filtered_damping(&Dyadic::integer(1), &pole);
    let mut past = VecDeque::with_capacity(2);
    past.push_back(before);
    let after = filter.next(&[to, from], &mut past) - to;
    let d = to - from;
    // D·w + D²(1 − a)/(1 + a) − (w′² − w²)/(2(1 − a)), times 2(1 − a)(1 + a).
    let (passed, kept) = (Dyadic::integer(1) - pole, Dyadic::integer(1) + pole);
    let charged = passed * (kept * before * d + passed * d.square());
    let slack = charged.double() - kept * (after.square() - before.square());
    kani::cover!(
        !(before * d).is_at_least_zero() && slack == Dyadic::zero(),
        "all that is charged is spent"
    );
    kani::assert(
        slack.is_at_least_zero(),
        "TH-LTI: the charge covers what the filter draws and stores",
    );
}
