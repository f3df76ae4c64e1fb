//! NUM-EXACT: greatest common divisors of whole numbers, against Stein's method of the library.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer as _;
use num_traits::Pow as _;
use passivity_core::BigRational;
use passivity_core::whole::{dyadic, fraction, gcd};
use proptest::prelude::*;

use crate::common::sampled;

/// Of up to 640 binary digits, of either sign.
fn whole() -> impl Strategy<Value = BigInt> {
    let digits = proptest::collection::vec(any::<u32>(), 0..20);
    (digits, any::<bool>()).prop_map(|(digits, negative)| {
        let size = BigInt::from(BigUint::new(digits));
        if negative { -size } else { size }
    })
}

sampled! {
    fn num_exact_divisors_are_those_of_the_library(a in whole(), b in whole(), factor in whole()) {
        prop_assert_eq!(gcd(&a, &b), a.gcd(&b));
        let [a, b] = [a * &factor, b * &factor];
        prop_assert_eq!(gcd(&a, &b), a.gcd(&b));
        if b > BigInt::ZERO {
            let lowest = BigRational::new(a.clone(), b.clone());
            let found = fraction(a, b);
            prop_assert_eq!(found.numer(), lowest.numer());
            prop_assert_eq!(found.denom(), lowest.denom());
        }
    }
}

sampled! {
    fn num_exact_halves_of_halves_are_in_lowest_terms(n in whole(), shift in 0u32..99, bits in 0u32..99) {
        let n = n << shift;
        let lowest = BigRational::new(n.clone(), BigInt::from(2).pow(bits));
        prop_assert_eq!(dyadic(n, bits).into_raw(), lowest.into_raw());
    }
}

/// Neighbours in Fibonacci's sequence take the most steps of Euclid's algorithm, each of quotient one; one beside a
/// power of two that it nearly divides, the fewest.
#[test]
fn num_exact_divisors_of_the_hardest_numbers() {
    let one = BigInt::from(1);
    let (mut a, mut b) = (one.clone(), one.clone());
    for _ in 0..700 {
        assert_eq!(gcd(&a, &b), one);
        assert_eq!(
            gcd(&(&a * 30), &(&b * -42)),
            a.gcd(&BigInt::from(7)) * b.gcd(&BigInt::from(5)) * 6
        );
        (a, b) = (b.clone(), a + b);
    }
    for bits in [1_u32, 61, 62, 63, 64, 65, 126, 127, 128, 129, 640] {
        let power: BigInt = BigInt::from(2).pow(bits);
        for (x, y) in [(-1, 0), (0, 0), (1, 0), (-1, 1), (0, 1), (1, -1)] {
            let (x, y) = (&power + x, &power + y);
            assert_eq!(gcd(&x, &y), x.gcd(&y), "2^{bits}");
            let squared = &x * &x;
            assert_eq!(gcd(&squared, &x), x);
            assert_eq!(gcd(&(squared + 1), &x), one);
        }
        assert_eq!(gcd(&BigInt::ZERO, &-&power), power);
        assert_eq!(gcd(&power, &BigInt::ZERO), power);
    }
    assert_eq!(gcd(&BigInt::ZERO, &BigInt::ZERO), BigInt::ZERO);
}
