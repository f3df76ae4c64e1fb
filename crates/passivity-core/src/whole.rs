//! Whole numbers of any size: their greatest common divisor, and fractions in lowest terms.

use alloc::vec::Vec;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, ToPrimitive as _, Zero as _};

/// The greatest common divisor, not negative; of zero and a number its absolute value.
///
/// By Lehmer's method: the leading digits of both numbers tell several steps of Euclid's algorithm, which are
/// then made at once. Each must be a change of both numbers that can be undone in whole numbers, so that no common
/// divisor is gained or lost whatever the leading digits said. Source: D. E. Knuth, *The Art of Computer Programming*,
/// vol. 2, 4.5.2, algorithm L.
///
/// # Example
///
/// ```
/// use num_bigint::BigInt;
/// use passivity_core::whole::gcd;
///
/// let [a, b] = [5_u32, 3].map(|n| BigInt::from(n).pow(100));
/// let both = BigInt::from(7).pow(80);
/// assert_eq!(gcd(&(a * &both), &-(b * &both)), both);
/// ```
#[must_use]
pub fn gcd(a: &BigInt, b: &BigInt) -> BigInt {
    let twos = [a, b].map(|x| x.trailing_zeros().unwrap_or(0));
    let common = match (a.is_zero(), b.is_zero()) {
        (true, _) => return b.abs(),
        (_, true) => return a.abs(),
        _ => twos.into_iter().min().unwrap_or(0),
    };
    // Of fractions that were doubles little is left.
    let (mut a, mut b) = (a.abs() >> twos[0], b.abs() >> twos[1]);
    if a < b {
        core::mem::swap(&mut a, &mut b);
    }
    loop {
        if let Some(small) = b.to_u64() {
            let odd = match small {
                0 => a,
                _ => small.gcd(&(&a % small).to_u64().unwrap_or_default()).into(),
            };
            return odd << common;
        }
        let shift = a.bits().saturating_sub(LEADING);
        let leading = [&a, &b].map(|x| (x >> shift).to_i64().unwrap_or_default());
        (a, b) = match steps(leading).filter(can_be_undone) {
            Some([[p, q], [r, s]]) => (&a * p + &b * q, &a * r + &b * s),
            None => {
                let rest = &a % &b;
                (b, rest)
            }
        };
    }
}

/// Whether two numbers that are made of two others with these factors give those back in whole numbers: whether the
/// determinant is one, of either sign.
fn can_be_undone([[p, q], [r, s]]: &[[i64; 2]; 2]) -> bool {
    let [p, q, r, s] = [p, q, r, s].map(|factor| i128::from(*factor));
    let products = p.checked_mul(s).zip(q.checked_mul(r));
    products.is_some_and(|(a, b)| a.abs_diff(b) == 1)
}

/// How many leading binary digits tell the steps of Euclid's algorithm.
const LEADING: u64 = 62;

/// The steps of Euclid's algorithm that two numbers a and b with these leading digits surely make, as what they
/// make of both: the numbers that a and b are to be multiplied with. `None` where that is no step.
fn steps([mut x, mut y]: [i64; 2]) -> Option<[[i64; 2]; 2]> {
    let [mut of_a, mut of_b] = [[1_i64, 0], [0, 1]];
    loop {
        // The quotient for the largest and for the smallest numbers with these digits.
        let ([p, q], [r, s]) = (of_a, of_b);
        let quotient = |p: i64, r: i64| x.checked_add(p)?.checked_div(y.checked_add(r)?);
        let next = quotient(p, r).filter(|n| quotient(q, s) == Some(*n));
        let less = |a: i64, b: i64| a.checked_sub(next?.checked_mul(b)?);
        let Some(((t, u), rest)) = less(p, r).zip(less(q, s)).zip(less(x, y)) else {
            return (q != 0).then_some([of_a, of_b]);
        };
        (of_a, of_b) = (of_b, [t, u]);
        (x, y) = (y, rest);
    }
}

/// The fraction with this numerator and this denominator, which must be above zero, in lowest terms.
///
/// # Example
///
/// ```
/// use num_bigint::BigInt;
/// use passivity_core::{BigRational, Scalar, whole::fraction};
///
/// let [three, four] = [3, 4].map(BigRational::integer);
/// assert_eq!(fraction(BigInt::from(30), BigInt::from(40)), three.over(four));
/// ```
#[must_use]
pub fn fraction(numerator: BigInt, denominator: BigInt) -> BigRational {
    let divisor = gcd(&numerator, &denominator);
    if divisor.is_one() {
        return BigRational::new_raw(numerator, denominator);
    }
    BigRational::new_raw(numerator / &divisor, denominator / divisor)
}

/// The number n/2^`bits` in lowest terms.
///
/// # Example
///
/// ```
/// use num_bigint::BigInt;
/// use passivity_core::{BigRational, Scalar, whole::dyadic};
///
/// assert_eq!(dyadic(BigInt::from(-12), 3_u32), BigRational::integer(-3).half());
/// ```
#[must_use]
pub fn dyadic(n: BigInt, bits: impl Into<u64>) -> BigRational {
    let bits = bits.into();
    let common = n.trailing_zeros().unwrap_or(bits).min(bits);
    BigRational::new_raw(n >> common, BigInt::one() << (bits - common))
}

/// Fractions over their least common denominator: the numerators, and the denominator, which is above zero.
///
/// # Example
///
/// ```
/// use num_bigint::BigInt;
/// use passivity_core::{BigRational, Scalar, whole::over_common};
///
/// let [half, sixth] = [2, 6].map(|n| BigRational::integer(1).over(BigRational::integer(n)));
/// assert_eq!(over_common(&[half, -sixth]), ([3, -1].map(BigInt::from).to_vec(), BigInt::from(6)));
/// ```
#[must_use]
pub fn over_common(fractions: &[BigRational]) -> (Vec<BigInt>, BigInt) {
    let denominators = fractions.iter().map(BigRational::denom);
    let common = denominators.fold(BigInt::one(), |common, d| least_multiple(&common, d));
    let numerators = fractions.iter().map(|x| x.numer() * (&common / x.denom()));
    (numerators.collect(), common)
}

/// The least common multiple of two numbers above zero.
pub(crate) fn least_multiple(a: &BigInt, b: &BigInt) -> BigInt {
    a / gcd(a, b) * b
}
