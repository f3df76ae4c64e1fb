//! Rational enclosures of e⁻ʸ and of square roots, as tight as one likes.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use crate::interval::Interval;
use crate::scalar::Scalar as _;
use crate::whole::dyadic;

/// An enclosure of e⁻ʸ for y ≥ 0, at most 2^−`bits` wide, within [0, 1].
///
/// e^(y/2ᵏ) by its series, with a bound of what is left out, the reciprocal, and k squares; all in
/// fixed point, rounded outwards.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar, exponential::decay};
///
/// let e = decay(&BigRational::integer(1), 20); // 0.3678794…
/// let millionths = |n: i64| BigRational::new(n.into(), 1_000_000.into());
/// assert!(*e.lo() > millionths(367_878) && *e.hi() < millionths(367_881));
/// ```
#[must_use]
pub fn decay(y: &BigRational, bits: u32) -> Interval<BigRational> {
    if *y >= BigRational::from_integer(BigInt::from(bits)) {
        // e > 2.
        return Interval::hull(dyadic(BigInt::zero(), bits), dyadic(BigInt::one(), bits));
    }
    let mut spare = 32;
    loop {
        let working = bits + spare;
        let [lo, hi] = decay_in_units(y, working);
        if &hi - &lo <= BigInt::one() << spare {
            return Interval::hull(dyadic(lo, working), dyadic(hi, working));
        }
        spare *= 2;
    }
}

/// Whole numbers around e⁻ʸ·2^`bits`, not below 0 and not above 2^`bits`.
fn decay_in_units(y: &BigRational, bits: u32) -> [BigInt; 2] {
    let one = BigInt::one() << bits;
    let mut squares = 0_u32;
    let mut small = y.clone();
    let half = dyadic(BigInt::one(), 1_u32);
    while small > half {
        small = small.half();
        squares += 1;
    }
    let [below, above] = [
        (small.numer() * &one).div_floor(small.denom()),
        (small.numer() * &one).div_ceil(small.denom()),
    ];
    // The terms tⁱ/i! of e^t, rounded down and up. With t ≤ ½ all that come after one are together
    // no more than that one.
    let (mut least, mut most) = (one.clone(), one.clone());
    let [mut sum_least, mut sum_most] = [one.clone(), one.clone()];
    let mut i = 0_u32;
    while most > BigInt::one() {
        i += 1;
        least = (&least * &below).div_floor(&(&one * i));
        most = (&most * &above).div_ceil(&(&one * i));
        sum_least += &least;
        sum_most += &most;
    }
    sum_most += &most;
    let square = &one * &one;
    let [mut lo, mut hi] = [square.div_floor(&sum_most), square.div_ceil(&sum_least)];
    for _ in 0..squares {
        lo = (&lo * &lo).div_floor(&one);
        hi = (&hi * &hi).div_ceil(&one);
    }
    [lo, hi.min(one)]
}

/// An enclosure of √x for x ≥ 0, at most 2^−`bits` wide; a point where it is met exactly.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Interval, Scalar, exponential::root};
///
/// let quarter = BigRational::integer(1).half().half();
/// assert_eq!(root(&quarter, 8), Interval::point(BigRational::integer(1).half()));
/// ```
#[must_use]
pub fn root(x: &BigRational, bits: u32) -> Interval<BigRational> {
    let one = BigInt::one() << bits;
    let squared = x.numer() * &one * &one;
    let below = squared.div_floor(x.denom()).max(BigInt::zero()).sqrt();
    let exact = &below * &below * x.denom() == squared;
    let above = if exact { below.clone() } else { &below + 1 };
    Interval::hull(dyadic(below, bits), dyadic(above, bits))
}
