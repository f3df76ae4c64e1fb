//! TH-LTI: ‖c‖₁ of a controller, exact or enclosed.

use passivity_core::frequency::ViscousCost;
use passivity_core::{BigRational, Interval, absolute_sum};
use proptest::prelude::*;

use crate::common::{coefficient, magnitude, q, sampled, zero};
use crate::transfer::{Controller, controller, finite_controller, response, times};

fn partial(controller: &Controller, terms: usize) -> BigRational {
    response(controller, terms)
        .iter()
        .fold(zero(), |sum, c| sum + magnitude(c))
}

sampled! {
    fn th_lti_sum_of_a_finite_response(controller in finite_controller()) {
        let sum = absolute_sum::enclosure(&controller, &q(1, 1)).unwrap();
        prop_assert_eq!(sum, Interval::point(partial(&controller, 8)));
    }

    /// ½‖c‖₁ = ½ + B(1 − a) for one-pole damping, with any delay.
    fn th_lti_sum_of_filtered_damping(damping in coefficient(), pole in 0i64..50, delay in 0u16..4) {
        let a = q(pole, 50);
        let controller = Controller::filtered_damping(&damping, &a).unwrap().delayed(delay);
        let expected = q(1, 1) + q(2, 1) * damping * (q(1, 1) - a);
        let sum = absolute_sum::enclosure(&controller, &q(1, 1)).unwrap();
        prop_assert_eq!(sum, Interval::point(expected));
    }

    /// No partial sum is above the enclosure, and a long one is in it or just below.
    fn th_lti_sum_is_enclosed(controller in controller()) {
        let width = q(1, 1_000_000);
        let sum = absolute_sum::enclosure(&controller, &width).unwrap();
        prop_assert!(sum.hi() - sum.lo() <= width);
        prop_assert!(partial(&controller, 30) <= *sum.hi());
        let tighter = absolute_sum::enclosure(&controller, &q(1, 1_000_000_000)).unwrap();
        prop_assert!(tighter.lo() <= sum.hi() && tighter.hi() >= sum.lo());
    }

    /// ½H(1) + Σ|gⱼ|, and never below the sharp cost of the linear wall.
    fn th_lti_bound_of_any_law(controller in finite_controller()) {
        let tails = controller.tail_sums(8);
        let expected = tails.iter().fold(controller.at_one() / q(2, 1), |sum, g| sum + magnitude(g));
        let bound = absolute_sum::viscous_bound(&controller, &q(1, 1)).unwrap();
        prop_assert_eq!(bound, Interval::point(expected.clone()));
        prop_assert!(ViscousCost::of(&controller).decide(&expected).is_nonnegative());
    }

    /// With poles and a numerator above zero it is H(1), with alternating signs H(−1).
    fn th_lti_sum_of_one_sign(poles in prop::collection::vec(0i64..99, 2..5), alternate in any::<bool>()) {
        let sign = if alternate { -1 } else { 1 };
        let factors = poles.iter().map(|a| [q(1, 1), q(-sign * a, 100)]);
        let denominator = factors.fold(vec![q(1, 1)], |product, f| times(&product, &f));
        let controller = Controller::new([q(1, 1)], denominator).unwrap();
        let expected = poles.iter().fold(q(1, 1), |sum, a| sum / (q(1, 1) - q(*a, 100)));
        let width = q(1, 1000);
        let sum = absolute_sum::enclosure(&controller, &width).unwrap();
        prop_assert!(*sum.lo() <= expected && expected <= *sum.hi());
        prop_assert!(sum.hi() - sum.lo() <= width);
    }
}

#[test]
fn th_lti_sum_with_a_pole_at_the_circle() {
    // Two poles at 1 − 10⁻³ and a pair at 0.999·e^(±iπ/3): long, and still enclosed.
    let near = q(999, 1000);
    let double = times(&[q(1, 1), -&near], &[q(1, 1), -&near]);
    let pair = [q(1, 1), -&near, &near * &near];
    let slow = Controller::new([q(1, 1_000_000)], double.clone()).unwrap();
    let sum = absolute_sum::enclosure(&slow, &q(1, 1000)).unwrap();
    assert!(*sum.lo() <= q(1, 1) && q(1, 1) <= *sum.hi());
    let ringing = Controller::new([q(1, 1_000_000)], times(&double, &pair)).unwrap();
    assert!(absolute_sum::enclosure(&ringing, &q(1, 1000)).is_some());
    // 10⁻⁹ from the circle it is said that there is no answer.
    let close = q(999_999_999, 1_000_000_000);
    let stuck = times(&[q(1, 1), -&close], &[q(1, 1), close.clone()]);
    let stuck = Controller::new([q(1, 1)], stuck).unwrap();
    assert_eq!(absolute_sum::enclosure(&stuck, &q(1, 1000)), None);
}
