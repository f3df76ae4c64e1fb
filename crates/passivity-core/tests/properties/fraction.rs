//! The numbers themselves: unreduced fractions against big rationals, and their undefined value.

use std::cmp::Ordering::{Equal, Greater, Less};

use num_bigint::BigInt;
use passivity_core::fraction::Integer;
use passivity_core::rational::{from_fixed, from_wide, to_fixed, to_wide};
use passivity_core::{BigRational, Exact, Fixed, Fraction, Ordered, Scalar, Wide, pi};
use proptest::prelude::*;

use crate::common::{half, magnitude, number, q, sampled, squared, zero};

/// Every operation of a scalar on two numbers, the second not zero.
fn operations<S: Scalar>(a: &S, b: &S) -> Vec<S> {
    let (x, y) = (|| a.clone(), || b.clone());
    vec![
        x() + y(),
        x() - y(),
        x() * y(),
        -x(),
        x().half(),
        a.floor(),
        a.abs(),
        Scalar::max(x(), y()),
        Scalar::min(x(), y()),
        x().over(y()),
        S::zero(),
        S::one(),
        S::integer(-7),
        a.square(),
        a.double(),
    ]
}

/// The same by the operators of big rationals.
fn expected(a: &BigRational, b: &BigRational) -> Vec<BigRational> {
    let (larger, smaller) = if a < b { (b, a) } else { (a, b) };
    vec![
        a + b,
        a - b,
        a * b,
        -a,
        a * half(),
        a.floor(),
        magnitude(a),
        larger.clone(),
        smaller.clone(),
        a / b,
        zero(),
        q(1, 1),
        q(-7, 1),
        squared(a),
        a + a,
    ]
}

fn defined(a: Fixed) -> Option<(i128, i128)> {
    a.parts().map(|(n, d)| (*n, *d))
}

sampled! {
    fn num_exact_fraction_operations(a in number(), b in number()) {
        prop_assume!(b != zero());
        let expected = expected(&a, &b);
        prop_assert_eq!(&operations(&a, &b), &expected);
        let wide = operations(&to_wide(&a), &to_wide(&b));
        let read: Option<Vec<_>> = wide.iter().map(from_wide).collect();
        prop_assert_eq!(read.as_ref(), Some(&expected));
        for x in &wide {
            // Nothing undefined, and every denominator above zero.
            prop_assert!(x.parts().is_some_and(|(_, d)| *d > BigInt::ZERO));
        }
    }

    fn num_exact_fraction_operations_on_small_numbers(
        a in (-200i64..200, 1i64..60), b in (-200i64..200, 1i64..60), scale in 1i128..50
    ) {
        let (a, b) = (q(a.0, a.1), q(b.0, b.1));
        prop_assume!(b != zero());
        // Not in lowest terms, as intermediate results are.
        let unreduced = |x: &BigRational| {
            let (n, d) = defined(to_fixed(x).unwrap()).unwrap();
            Fixed::new(n * scale, d * scale)
        };
        let fixed = operations(&unreduced(&a), &unreduced(&b));
        let read: Option<Vec<_>> = fixed.iter().map(from_fixed).collect();
        prop_assert_eq!(read, Some(expected(&a, &b)));
        prop_assert_eq!(unreduced(&a).compare(&to_fixed(&b).unwrap()), Some(a.cmp(&b)));
        prop_assert!(unreduced(&a) == to_fixed(&a).unwrap());
    }

    fn num_exact_fraction_new_moves_the_sign(n in any::<i64>(), d in any::<i64>()) {
        let x = Fixed::new(n.into(), d.into());
        prop_assert_eq!(x.is_defined(), d != 0);
        if d != 0 {
            prop_assert_eq!(from_fixed(&x), Some(q(n, 1) / q(d, 1)));
            prop_assert!(x.parts().is_some_and(|(_, d)| *d > 0));
        }
    }

    fn num_exact_fraction_reduced(n in number(), k in 1u32..1000) {
        let (numerator, denominator) = (n.numer() * k, n.denom() * k);
        let wide = Wide::new(numerator, denominator);
        prop_assert_eq!(wide.reduced(), Some((n.numer().clone(), n.denom().clone())));
        prop_assert_eq!(from_wide(&wide), Some(n.clone()));
        prop_assert_eq!(to_wide(&n).reduced(), Some((n.numer().clone(), n.denom().clone())));
    }

    /// Shortened a number is the same, in lowest terms, and without a π that both of its parts have.
    fn num_exact_fraction_shortened(n in number(), k in 1i32..1000) {
        let long = to_wide(&n) * Wide::new(BigInt::from(k), BigInt::from(k));
        prop_assert_eq!(long.clone().shortened(), long.clone());
        let parts = long.shortened();
        let lowest = Some((n.numer(), n.denom()));
        prop_assert_eq!(parts.parts(), lowest);
        let turned = (Exact::of(&n) * Exact::integer(k) * pi::pi()).over(Exact::integer(k) * pi::pi());
        let turned = turned.shortened().to_wide().unwrap();
        prop_assert_eq!(turned.parts(), lowest);
        let with_pi = Exact::of(&n) + pi::pi();
        prop_assert_eq!(with_pi.clone().shortened(), with_pi);
    }

    fn num_exact_fraction_round_trip(n in any::<i128>(), d in 1i128..) {
        let big = BigRational::new(BigInt::from(n), BigInt::from(d));
        let fixed = to_fixed(&big).unwrap();
        prop_assert_eq!(from_fixed(&fixed), Some(big.clone()));
        let (m, e) = defined(fixed).unwrap();
        prop_assert_eq!((BigInt::from(m), BigInt::from(e)), (big.numer().clone(), big.denom().clone()));
        let beyond = big + BigRational::from_integer(BigInt::from(1) << 128);
        prop_assert_eq!(to_fixed(&beyond), None);
    }
}

/// Checked operations of one width at its ends.
fn edges<I: Integer + core::fmt::Debug>(least: I, most: I) {
    let n = I::from_i32;
    assert_eq!(most.add(&n(1)), None);
    assert_eq!(most.add(&n(0)), Some(most.clone()));
    assert_eq!(least.sub(&n(1)), None);
    assert_eq!(n(0).sub(&least), None);
    assert_eq!(least.mul(&n(-1)), None);
    assert_eq!(most.mul(&n(2)), None);
    assert_eq!(n(-7).div_floor(&n(2)), Some(n(-4)));
    assert_eq!(n(7).div_floor(&n(2)), Some(n(3)));
    assert_eq!(n(-6).div_floor(&n(3)), Some(n(-2)));
    assert_eq!(n(7).div_floor(&n(0)), None);
    assert_eq!(n(7).div_floor(&n(-2)), None);
    assert_eq!(n(7).div_floor(&n(1)), Some(n(7)));
    assert_eq!(
        (n(6).halved(), n(7).halved(), n(-6).halved()),
        (Some(n(3)), None, Some(n(-3)))
    );
    assert_eq!(
        (n(-2).signum(), n(0).signum(), n(2).signum()),
        (Some(Less), Some(Equal), Some(Greater))
    );
    // The fraction over it: an overflow is undefined for good.
    let one = Fraction::new(n(1), n(1));
    let over = Fraction::new(most.clone(), n(1)) + one.clone();
    assert!(!over.is_defined() && over.parts().is_none());
    for later in [
        over.clone() + one.clone(),
        one.clone() - over.clone(),
        over.clone() * one.clone(),
        -over.clone(),
        over.clone().half(),
        over.floor(),
        over.abs(),
        over.clone().max(one.clone()),
        one.clone().max(over.clone()),
        over.clone().min(one.clone()),
        one.clone().min(over.clone()),
        over.clone().over(one.clone()),
        one.clone().over(over.clone()),
        one.clone().over(Scalar::zero()),
    ] {
        assert!(!later.is_defined());
        assert_eq!(
            (later.sign(), later.is_nonnegative(), later.is_positive()),
            (None, None, None)
        );
        assert_eq!(later.compare(&one), None);
        assert_eq!(one.compare(&later), None);
        assert!(later != later.clone() && later.partial_cmp(&one).is_none());
    }
    assert!(!Fraction::new(least.clone(), n(-1)).is_defined());
    assert!(!Fraction::new(n(1), least).is_defined());
    // Two large fractions that cannot be brought to a common denominator.
    let tiny = Fraction::new(n(1), most.clone());
    assert_eq!(tiny.compare(&Fraction::new(n(2), n(3))), None);
    // Equal denominators need no products.
    assert_eq!(tiny.compare(&Fraction::new(n(2), most.clone())), Some(Less));
    assert!((tiny.clone() + tiny).is_defined());
    assert!(!Fraction::new(n(1), most).half().is_defined());
}

#[test]
fn num_exact_fraction_widths_at_their_ends() {
    edges(i32::MIN, i32::MAX);
    edges(i64::MIN, i64::MAX);
    edges(i128::MIN, i128::MAX);
}

#[test]
fn num_exact_fraction_of_big_integers_never_overflows() {
    let n = |n: i32| <BigInt as Integer>::from_i32(n);
    assert_eq!(n(-7).div_floor(&n(2)), Some(n(-4)));
    assert_eq!(
        (n(7).div_floor(&n(0)), n(7).div_floor(&n(-2))),
        (None, None)
    );
    assert_eq!(
        (n(6).halved(), n(7).halved(), n(-6).halved()),
        (Some(n(3)), None, Some(n(-3)))
    );
    assert_eq!(
        (
            Integer::signum(&n(-2)),
            Integer::signum(&n(0)),
            Integer::signum(&n(2))
        ),
        (Some(Less), Some(Equal), Some(Greater))
    );
    assert_eq!(
        (
            n(2).sub(&n(5)),
            Integer::add(&n(2), &n(5)),
            Integer::mul(&n(2), &n(5))
        ),
        (Some(n(-3)), Some(n(7)), Some(n(10)))
    );
    let nothing = Wide::new(n(1), n(0));
    assert!(!nothing.is_defined() && nothing.reduced().is_none() && from_wide(&nothing).is_none());
    assert_eq!(from_wide(&Wide::new(n(3), n(-6))), Some(q(-1, 2)));
}

#[test]
fn num_exact_fraction_halves_without_growing_where_it_can() {
    assert_eq!(defined(Fixed::new(6, 5).half()), Some((3, 5)));
    assert_eq!(defined(Fixed::new(3, 5).half()), Some((3, 10)));
    assert_eq!(defined(Fixed::new(1, 5) + Fixed::new(2, 5)), Some((3, 5)));
    assert_eq!(defined(Fixed::integer(-3)), Some((-3, 1)));
}

#[test]
fn num_exact_division_by_zero_of_big_rationals_gives_no_number() {
    let divided = std::panic::catch_unwind(|| q(3, 1).over(zero()));
    assert!(
        divided.is_err(),
        "a division by zero must not give a number"
    );
    assert_eq!(q(3, 1).over(q(2, 1)), q(3, 2));
    assert_eq!(to_fixed(&q(-3, 4)).and_then(defined), Some((-3, 4)));
    assert_eq!(from_fixed(&Fixed::new(1, 0)), None);
}
