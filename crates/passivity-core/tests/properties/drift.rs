//! TH-LTI: going to and fro below λ(0), by hand.

use passivity_core::Friction;
use passivity_core::drift::Drift;

use crate::common::{q, zero};
use crate::transfer::Controller;

/// A delay of one sample: λ(0) = 3/2 and Σ j·gⱼ = 1. With β a tenth less N is above 4/(1/10), and a step
/// above 2·41·3/(2·41/10 − 4).
#[test]
fn th_lti_drift_behind_a_delay() {
    let filter = Controller::wall().delayed(1).filter().unwrap();
    let drift = Drift::of(&filter, &Friction::new(q(14, 10), q(3, 1)));
    let expected = Drift {
        step: q(59, 1),
        samples: q(41, 1),
        gain: q(59 * 59 * 42, 10) - q(82 * 3 * 59, 1),
    };
    assert_eq!(drift, Some(expected));
}

/// Taps of 1, ½, ½ and −½ have the tail sums ½, 0 and −½: turning round costs nothing, and each way is longer
/// than the memory of three samples.
#[test]
fn th_lti_drift_is_longer_than_the_memory() {
    let taps = [q(1, 1), q(1, 2), q(1, 2), q(-1, 2)];
    let filter = Controller::new(taps, [q(1, 1)]).unwrap().filter().unwrap();
    assert_eq!(filter.tails, [q(1, 2), zero(), q(-1, 2)]);
    let drift = Drift::of(&filter, &Friction::new(zero(), q(1, 1))).unwrap();
    assert!(drift.samples >= q(3, 1));
}
