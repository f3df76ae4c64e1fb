//! TH-LTI: ‖c‖₁ of a controller, exact or enclosed.

use passivity_core::frequency::ViscousCost;
use passivity_core::{BigRational, Interval, absolute_sum};
use proptest::prelude::*;

use crate::common::{coefficient, half, magnitude, q, sampled, squared, zero};
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

/// A first term that is less than the unit that is computed with is taken for zero. What is left of the
/// enclosure is its error: Gε of the step, and (G − 1)(0 + Gε) of what comes after it, so G²ε.
fn errors_alone(denominator: &[BigRational]) -> BigRational {
    let tiny = q(if denominator[0] < zero() { -1 } else { 1 }, 1 << 60);
    let controller = Controller::new([tiny], denominator).unwrap();
    let found = absolute_sum::enclosure(&controller, &q(2, 1)).unwrap();
    assert_eq!(*found.lo(), -found.hi());
    found.hi().clone()
}

/// G = (1 + ρ₀)(1 + ρ₁)…/(1 − ρₘ) of the companion matrix, by its exact powers; ρₘ the first that is at
/// most ½.
fn growth(denominator: &[BigRational]) -> BigRational {
    let order = denominator.len() - 1;
    let companion = |i: usize, j: usize| match i {
        0 => -&denominator[j + 1] / &denominator[0],
        _ => q(i64::from(i == j + 1), 1),
    };
    let square = |at: &dyn Fn(usize, usize) -> BigRational| -> Vec<Vec<BigRational>> {
        let row = |i| (0..order).map(|j| at(i, j)).collect();
        (0..order).map(row).collect()
    };
    let mut power = square(&companion);
    let mut growth = q(1, 1);
    loop {
        let column = |j: usize| {
            power
                .iter()
                .fold(zero(), |sum, row| sum + magnitude(&row[j]))
        };
        let norm = (0..order).map(column).max().unwrap();
        if norm <= half() {
            return growth / (q(1, 1) - norm);
        }
        growth *= q(1, 1) + norm;
        let entry = |i: usize, j: usize| {
            (0..order).fold(zero(), |sum, k| sum + &power[i][k] * &power[k][j])
        };
        power = square(&entry);
    }
}

/// G is never less than by exact powers, and hardly more: an entry is off by less than 2⁻¹²⁸ at first, and
/// by at most 2‖Aⁿ‖ times as much and as many units as there are rows after each squaring; here at most
/// (2·200)¹⁰ < 2⁸⁸ units at the end.
#[test]
fn th_lti_growth_is_that_of_the_powers() {
    let little = q(1, 1 << 30);
    for denominator in [
        times(&[q(1, 1), q(-1, 4)], &[q(1, 1), q(-1, 4)]),
        times(&[q(1, 1), q(1, 3)], &[q(1, 1), q(1, 3)]),
        times(&[q(3, 1), q(-2, 1)], &[q(1, 1), q(-3, 5)]),
        times(&[q(-3, 1), q(1, 1)], &[q(1, 1), q(3, 5)]),
        // The square has a norm of 7/10, above ½ and below 1.
        vec![q(1, 1), zero(), q(7, 10)],
        vec![q(1, 1), zero(), q(1, 16)],
        // The norms are 600/601 to powers of two, and what is rounded doubles with each squaring.
        vec![q(1, 1), zero(), q(-600, 601)],
        vec![q(1, 1), q(-1, 3), q(1, 7), q(-1, 11)],
        times(&[q(1, 1), q(-6, 7)], &[q(1, 1), q(-6, 7)]),
        times(&[q(1, 1), q(-24, 25)], &[q(1, 1), q(-1, 3)]),
        times(&[q(1, 1), q(24, 25)], &[q(1, 1), q(1, 3)]),
    ] {
        let growth = growth(&denominator);
        let mut unit = errors_alone(&denominator) / squared(&growth);
        assert!(unit < q(1, 1));
        while unit < q(1, 1) {
            unit *= q(2, 1);
        }
        assert!(unit < q(1, 1) + &little, "{denominator:?}: {unit}");
    }
}

/// G to the last unit of 2⁻¹²⁸, all of them rounded up: A has the norm 1 and is taken to be off by one unit, so A² by
/// 1·(1 + 1) of them and a part, and by one more for each of its two rows: by 3 + 2. Its norm is 1/16.
#[test]
fn th_lti_what_is_rounded_in_a_power_is_counted() {
    let one = (0..128).fold(q(1, 1), |one, _| one * q(2, 1));
    let growth = (&one * q(2, 1) + q(1, 1)) / (&one * q(15, 16) - q(5, 1));
    let mut unit = errors_alone(&[q(1, 1), zero(), q(1, 16)]) / squared(&growth);
    while unit < q(1, 1) {
        unit *= q(2, 1);
    }
    assert_eq!(unit, q(1, 1));
}

/// A pole in the other half, a leading coefficient other than 1, and a width above 1.
#[test]
fn th_lti_sums_by_hand() {
    // ½(−½)ʲ: together 1.
    let halves = Controller::new([q(1, 1)], [q(2, 1), q(1, 1)]).unwrap();
    let sum = absolute_sum::enclosure(&halves, &q(1, 1));
    assert_eq!(sum, Some(Interval::point(q(1, 1))));
    // Two poles at ¼: 1/(1 − ¼)².
    for leading in [1, -1, 6] {
        let factors = [[q(1, 1), q(-1, 4)], [q(leading, 1), q(-leading, 4)]];
        let double = Controller::new([q(leading, 1)], times(&factors[0], &factors[1])).unwrap();
        for width in [q(4, 1), q(2, 1), q(1, 1_000_000)] {
            let sum = absolute_sum::enclosure(&double, &width).unwrap();
            assert!(*sum.lo() <= q(16, 9) && q(16, 9) <= *sum.hi());
            assert!(sum.hi() - sum.lo() <= width);
        }
    }
}

/// Rounded down each term of a response that has died away stays at −1 unit: what that adds up to is in the
/// error.
#[test]
fn th_lti_errors_of_all_terms_are_counted() {
    let tiny = q(1, 1 << 60);
    let mut numerator = vec![zero(); 5000];
    numerator[0] = -&tiny;
    numerator[4999] = tiny.clone();
    let double = times(&[q(1, 1), q(-1, 4)], &[q(1, 1), q(-1, 4)]);
    let controller = Controller::new(numerator, double).unwrap();
    let sum = absolute_sum::enclosure(&controller, &q(2, 1)).unwrap();
    // Each of the two adds up to 16/9 of itself at most, and to itself at least.
    assert!(*sum.lo() <= tiny && tiny * q(32, 9) <= *sum.hi());
}
