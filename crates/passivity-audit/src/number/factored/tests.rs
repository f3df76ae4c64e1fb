//! Fractions of known primes against big numbers.

use passivity_core::BigRational;
use proptest::prelude::*;

use super::*;

fn text<S: Size>(quotient: Quotient<S>) -> String {
    let mut room = [0; Line::ROOM];
    let mut line = Line::new(&mut room, 0);
    quotient.write(&mut line).unwrap();
    str::from_utf8(line.text()).unwrap()[1..].to_owned()
}

fn made_of(primes: &[u64], powers: &[u32]) -> BigInt {
    let factors = primes.iter().zip(powers);
    factors.fold(BigInt::from(1), |n, (p, k)| n * BigInt::from(*p).pow(*k))
}

const PRIMES: [u64; 6] = [2, 3, 5, 823, 379_721, 4_294_967_291];

proptest! {
    #[test]
    fn fractions_are_written_as_big_numbers_are(
        n in any::<i128>(), shift in 0..128_u32,
        common in prop::array::uniform6(0..3_u32), powers in prop::array::uniform6(0..3_u32),
        (x, product) in (1..u64::MAX, prop::array::uniform3(any::<u64>())), bits in 0..64_u32,
    ) {
        let primes = Primes::of(&PRIMES.map(BigInt::from)).unwrap();
        let over = made_of(&PRIMES, &powers);
        let Some(factored) = primes.factored(&over) else {
            return Ok(());
        };
        let n = n >> shift;
        let factor = made_of(&PRIMES[..4], &common[..4]).to_i128().unwrap();
        for n in [n, (n >> 64).wrapping_mul(factor), factor, -1, 0] {
            let found = text(primes.quotient(n, &factored, 1).unwrap());
            prop_assert_eq!(found, BigRational::new(n.into(), over.clone()).to_string());
        }
        // The same of wide ones, over powers of two of their own.
        for (more, twos) in [(1, 0), (factor, shift), (n, shift)] {
            let wide = I256::from(n) * I256::from(more >> 2);
            let Some(found) = primes.wide_quotient((wide, twos), &factored, 1) else {
                continue;
            };
            let numerator = BigInt::from(n) * (more >> 2);
            let expected = BigRational::new(numerator, &over << twos);
            prop_assert_eq!(text(found), expected.to_string());
        }
        for [a, b] in [[x, product[0]], [product[1], x >> bits], [x, x]] {
            prop_assert_eq!(divisor_of_odd(a | 1, b), num_integer::gcd(a | 1, b));
        }
        // Of n·x + product, all that it can have in common with the rest of x is what the product has.
        let x = (x >> bits).max(1);
        let product = product.map(|n| n >> bits.max(24) >> 20);
        let beside = primes.split(x).beside(product.map(u128::from));
        let whole: i128 = product.iter().map(|n| i128::from(*n)).product();
        let n = (n >> 70) * i128::from(x) + whole;
        prop_assert_eq!(n % i128::from(beside.common), 0);
        prop_assert_eq!(n / i128::from(beside.common), beside.divided(n));
        if let Some(all) = beside.known.times(&factored)
            && let Some(found) = primes.quotient(beside.divided(n), &all, beside.rest)
        {
            let expected = BigRational::new(n.into(), over * x).to_string();
            prop_assert_eq!(text(found), expected);
        }
    }
}

#[test]
fn primes_are_found_or_given_up() {
    let found = |n: &[u64]| {
        let numbers: Vec<_> = n.iter().map(|n| BigInt::from(*n)).collect();
        let primes = Primes::of(&numbers)?;
        Some(primes.0.iter().map(|prime| prime.of).collect::<Vec<_>>())
    };
    assert_eq!(found(&[12_345, 1_000]), Some(vec![3, 5, 823]));
    assert_eq!(found(&[4_294_967_291]), Some(vec![4_294_967_291]));
    assert_eq!(found(&[4_294_967_291 * 3]), Some(vec![3, 4_294_967_291]));
    assert_eq!(found(&[65_537 * 65_537]), None);
    let many = [
        3 * 5 * 7 * 11 * 13 * 17 * 19 * 23,
        29 * 31 * 37 * 41 * 43 * 47 * 53,
    ];
    assert!(found(&many).is_some());
    assert_eq!(found(&[many[0], many[1], 59 * 61]), None);
}
