//! NUM-EXACT: the simplest fraction of an interval, against all of small denominators, and short ways to what
//! the operators of the library give.

use passivity_core::rational::simplest_above;
use passivity_core::{BigRational, Fixed, Scalar};
use proptest::prelude::*;

use crate::common::{number, q, sampled, zero};

sampled! {
    /// In lowest terms, and with the sign in the numerator.
    fn num_exact_short_ways_are_those_of_the_library(a in number(), b in number()) {
        let two = q(2, 1);
        for a in [&a, &b, &(&a * &b), &(&a - &a)] {
            prop_assert_eq!(a.square().into_raw(), (a * a).into_raw());
            prop_assert_eq!(a.double().into_raw(), (a * &two).into_raw());
            prop_assert_eq!(a.clone().half().into_raw(), (a / &two).into_raw());
            if b != zero() {
                let quotient = Scalar::over(a.clone(), b.clone());
                prop_assert_eq!(quotient.into_raw(), (a / &b).into_raw());
            }
        }
    }

    /// Up to the end of the shorter list.
    fn num_exact_sums_of_products_are_those_of_the_library(
        a in prop::collection::vec(number(), 0..5), b in prop::collection::vec(number(), 0..5),
    ) {
        let products = a.iter().zip(&b).map(|(a, b)| a * b);
        let sum = products.fold(zero(), |sum, product| sum + product);
        prop_assert_eq!(BigRational::sum_of_products(&a, &b).into_raw(), sum.into_raw());
        let fixed = |n: i64| Fixed::new(n.into(), 3);
        prop_assert_eq!(Fixed::sum_of_products(&[2, -7, 1].map(fixed), &[5, 4].map(fixed)), fixed(-6));
    }
}

#[test]
#[should_panic(expected = "division by zero")]
fn num_exact_nothing_is_divided_by_zero() {
    let _ = BigRational::one().over(zero());
}

#[test]
fn num_exact_the_simplest_fraction_above() {
    let mut met = 0;
    for d in 1..=12_i64 {
        for n in 0..=3 * d {
            let lo = q(n, d);
            for (wide, parts) in [
                (1, 1),
                (5, 2),
                (1, 2),
                (1, 3),
                (2, 7),
                (1, 10),
                (1, 60),
                (1, 97),
                (1, 132),
            ] {
                let hi = &lo + q(wide, parts);
                // The first denominator that has a numerator, and its least one.
                let expected = (1..).find_map(|d| {
                    let above =
                        q((&lo * q(d, 1)).floor().to_integer().try_into().unwrap(), 1) + q(1, 1);
                    let found = above / q(d, 1);
                    (found <= hi).then_some(found)
                });
                let found = simplest_above(&lo, &hi);
                met += i32::from(found == hi);
                assert_eq!(Some(found), expected, "({lo}, {hi}]");
            }
        }
    }
    assert!(met > 50, "{met}");
}

/// A whole number that is the upper end itself.
#[test]
fn num_exact_the_simplest_fraction_is_the_upper_end() {
    assert_eq!(simplest_above(&q(1, 2), &q(1, 1)), q(1, 1));
}
