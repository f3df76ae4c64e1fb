//! TH-LTI: digital controllers, their responses and whether they are stable.

use passivity_core::extra_storage::{one_pole_spare, one_pole_storage};
use passivity_core::transfer::{Refused, TransferFunction, is_stable};
use passivity_core::{BigRational, Fixed, Scalar as _};
use proptest::prelude::*;

use crate::common::{coefficient, magnitude, q, sampled, zero};

pub(crate) type Controller = TransferFunction<BigRational>;

/// A product of polynomials in z⁻¹.
pub(crate) fn times(a: &[BigRational], b: &[BigRational]) -> Vec<BigRational> {
    let mut product = vec![zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

/// A fraction of small numbers.
pub(crate) fn small() -> impl Strategy<Value = BigRational> {
    (-12i64..=12, 1i64..6).prop_map(|(n, d)| q(n, d))
}

/// A polynomial in z⁻¹ with all roots inside the unit circle: real ones and pairs r·e^(±iφ).
fn stable_factor() -> impl Strategy<Value = Vec<BigRational>> {
    prop_oneof![
        (-19i64..20).prop_map(|r| vec![q(1, 1), q(-r, 20)]),
        // The cosine of the angle in eighths, the radius in tenths.
        (-8i64..9, 0i64..10).prop_map(|(c, r)| vec![q(1, 1), q(-2 * c * r, 80), q(r * r, 100)]),
    ]
}

/// Controllers of denominators up to sixth order, numerators up to the sixth, H(1) ≥ 0.
pub(crate) fn controller() -> impl Strategy<Value = Controller> {
    let numerator = prop::collection::vec(small(), 1..8);
    let denominator = prop::collection::vec(stable_factor(), 0..4);
    (numerator, denominator).prop_map(|(numerator, factors)| {
        let factors = factors.iter();
        let denominator = factors.fold(vec![q(1, 1)], |product, f| times(&product, f));
        let upright = |sign: i64| {
            let numerator: Vec<_> = numerator.iter().map(|n| n * q(sign, 1)).collect();
            Controller::new(numerator, denominator.clone())
        };
        upright(1)
            .or_else(|_| upright(-1))
            .expect("a stable controller")
    })
}

/// Controllers whose response ends, of at most six coefficients and a delay.
pub(crate) fn finite_controller() -> impl Strategy<Value = Controller> {
    (prop::collection::vec(small(), 1..6), 0u16..3).prop_map(|(taps, delay)| {
        let sum = taps.iter().fold(zero(), |sum, c| sum + c);
        let sign = if sum < zero() { q(-1, 1) } else { q(1, 1) };
        let taps: Vec<_> = taps.into_iter().map(|c| c * &sign).collect();
        Controller::new(taps, [q(1, 1)])
            .expect("stable")
            .delayed(delay)
    })
}

/// The response by long division, written out.
pub(crate) fn response(controller: &Controller, count: usize) -> Vec<BigRational> {
    let (n, d) = (controller.numerator(), controller.denominator());
    let mut c: Vec<BigRational> = Vec::new();
    for j in 0..count {
        let mut next = n.get(j).cloned().unwrap_or_else(zero);
        for i in 1..d.len().min(j + 1) {
            next -= &d[i] * &c[j - i];
        }
        c.push(next / &d[0]);
    }
    c
}

sampled! {
    fn th_lti_response_and_tail_sums(controller in controller()) {
        let c = response(&controller, 20);
        prop_assert_eq!(controller.impulse_response(20), c.clone());
        let mut rest = controller.at_one();
        for (c, g) in c.into_iter().zip(controller.tail_sums(20)) {
            rest -= c;
            prop_assert_eq!(&g, &rest);
        }
        // The tail sums are the response of the function that `tails` gives, from z⁻¹ on.
        let tails = controller.tails();
        let of_tails = tails.impulse_response(21);
        prop_assert_eq!(of_tails[0].clone(), zero());
        prop_assert_eq!(of_tails[1..].to_vec(), controller.tail_sums(20));
    }

    /// A product of factors with known roots is stable exactly when all roots are inside.
    fn th_lti_stability(
        inside in prop::collection::vec(stable_factor(), 0..4),
        more in (-3i64..4, 1i64..4),
        leading in 1i64..5,
    ) {
        let product = inside.iter().fold(vec![q(leading, 1)], |product, f| times(&product, f));
        prop_assert_eq!(is_stable(&product), Some(true));
        let root = q(more.0, more.1);
        let with_root = times(&product, &[q(1, 1), -&root]);
        prop_assert_eq!(is_stable(&with_root), Some(magnitude(&root) < q(1, 1)));
        // A pair on the circle, at an angle whose cosine is rational.
        let on_circle = times(&product, &[q(1, 1), q(2 * more.0, 4), q(1, 1)]);
        prop_assert_eq!(is_stable(&on_circle), Some(false));
    }

    /// The kernel's filter of a finite controller gives the same output.
    fn th_lti_filter(
        controller in finite_controller(), samples in prop::collection::vec(small(), 8)
    ) {
        let filter = controller.filter().unwrap();
        let by_hand = response(&controller, 8)
            .iter().zip(&samples).fold(zero(), |sum, (c, q)| sum + c * q);
        prop_assert_eq!(filter.output(&samples), by_hand);
    }

    fn th_lti_effects(damping in coefficient(), pole in 0i64..20, delay in 0u16..5) {
        let a = q(pole, 20);
        let filtered = Controller::filtered_damping(&damping, &a).unwrap().delayed(delay);
        let mut expected = vec![zero(); usize::from(delay)];
        expected.push(q(1, 1) + &damping * (q(1, 1) - &a));
        // −B(1 − a)²aʲ⁻¹
        let mut next = -(&damping * (q(1, 1) - &a) * (q(1, 1) - &a));
        for _ in 0..5 {
            expected.push(next.clone());
            next *= &a;
        }
        prop_assert_eq!(filtered.impulse_response(expected.len()), expected);
        prop_assert_eq!(filtered.at_one(), q(1, 1));
    }
}

sampled! {
    /// The step of a one-pole filter leaves a square to spare, and its damping draws no more than
    /// the charge and the change of storage, over any motion.
    fn th_lti_one_pole_step(
        a in 0i64..20, start in small(), steps in prop::collection::vec(small(), 1..12)
    ) {
        let a = q(a, 20);
        let one = q(1, 1);
        let share = (&one - &a) / (&one + &a);
        let stored = |w: &BigRational| w * w / (q(2, 1) * (&one - &a));
        let mut w = start.clone();
        let (mut drawn, mut charged) = (zero(), zero());
        for d in &steps {
            let root = (&one + &a) * &w + (&one - &a) * d;
            let square = &root * &root / (q(2, 1) * (&one + &a));
            prop_assert_eq!(one_pole_spare(&a, &w, d), square);
            drawn -= d * &w;
            charged += &share * d * d;
            w = &a * &w + (&one - &a) * d;
        }
        prop_assert_eq!(one_pole_storage(&a, &w), stored(&w));
        prop_assert!(drawn + stored(&w) <= charged + stored(&start));
    }
}

#[test]
fn th_lti_refused() {
    let new = |n: &[i64], d: &[i64]| {
        let fixed = |of: &[i64]| {
            of.iter()
                .map(|x| Fixed::new(i128::from(*x), 1))
                .collect::<Vec<_>>()
        };
        TransferFunction::new(fixed(n), fixed(d))
    };
    assert_eq!(new(&[1], &[]), Err(Refused::Improper));
    assert_eq!(new(&[1], &[0, 1]), Err(Refused::Improper));
    assert_eq!(new(&[1], &[1, -1]), Err(Refused::Unstable));
    assert_eq!(new(&[1, -2], &[1, -2]), Err(Refused::Unstable));
    // A common factor on the unit circle, and a double pole there.
    assert_eq!(new(&[1, 1], &[1, 1]), Err(Refused::Unstable));
    assert_eq!(new(&[1], &[1, 0, 2, 0, 1]), Err(Refused::Unstable));
    assert_eq!(new(&[-1], &[2, 1]), Err(Refused::NegativeStiffness));
    let undefined = [Fixed::new(1, 0)];
    assert_eq!(
        TransferFunction::new(undefined, [Fixed::integer(1)]),
        Err(Refused::Undefined)
    );
    // The sign of the denominator does not matter, nor do zeros at its end.
    assert_eq!(
        new(&[-1, 0], &[-2, 1, 0]).map(|h| h.at_one()),
        Ok(Fixed::integer(1))
    );
    assert!(Controller::filtered_damping(&q(1, 1), &q(1, 1)).is_err());
}

#[test]
fn th_lti_zeros_at_the_end_are_left_out() {
    let controller = Controller::new([q(2, 1), zero()], [q(1, 1), zero(), zero()]).unwrap();
    assert_eq!(controller.numerator(), [q(2, 1)]);
    assert_eq!(controller.denominator(), [q(1, 1)]);
}
