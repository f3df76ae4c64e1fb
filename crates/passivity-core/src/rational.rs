//! The public number, [`BigRational`], and its roads to and from the fractions of the kernel.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use crate::fraction::{Fixed, Wide};
use crate::interval::Interval;
use crate::scalar::{Ordered, Scalar};
use crate::whole::{fraction, over_common};

/// Big rationals in lowest terms: exact on any size, and the slowest instance.
///
/// The type has no undefined value, so [`over`](Scalar::over) panics on a divisor of zero, as `/`
/// does: every caller in this crate divides by a quantity that its documentation says is not zero.
/// Use [`Wide`] where that is not known beforehand.
impl Scalar for BigRational {
    fn integer(n: i32) -> Self {
        Self::from_integer(BigInt::from(n))
    }

    fn half(self) -> Self {
        let (numerator, denominator) = self.into_raw();
        match numerator.is_even() {
            true => Self::new_raw(numerator / 2, denominator),
            false => Self::new_raw(numerator, denominator * 2),
        }
    }

    fn floor(&self) -> Self {
        Self::floor(self)
    }

    fn abs(&self) -> Self {
        Signed::abs(self)
    }

    fn max(self, other: Self) -> Self {
        if cross_compare(&self, &other) == Ordering::Less {
            other
        } else {
            self
        }
    }

    fn min(self, other: Self) -> Self {
        if cross_compare(&self, &other) == Ordering::Greater {
            other
        } else {
            self
        }
    }

    fn over(self, divisor: Self) -> Self {
        let factor = divisor.recip();
        fraction(self.numer() * factor.numer(), self.denom() * factor.denom())
    }

    fn sum_of_products(a: &[Self], b: &[Self]) -> Self {
        let [(a, of_a), (b, of_b)] = [a, b].map(over_common);
        let products = a.iter().zip(&b).map(|(a, b)| a * b);
        fraction(products.sum(), of_a * of_b)
    }

    fn square(&self) -> Self {
        // What has no common factor has none squared.
        Self::new_raw(self.numer() * self.numer(), self.denom() * self.denom())
    }

    fn double(&self) -> Self {
        let (numerator, denominator) = (self.numer(), self.denom());
        match denominator.is_even() {
            true => Self::new_raw(numerator.clone(), denominator / 2),
            false => Self::new_raw(numerator * 2, denominator.clone()),
        }
    }
}

impl Ordered for BigRational {
    fn sign(&self) -> Option<Ordering> {
        Some(self.numer().cmp(&BigInt::ZERO))
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(cross_compare(self, other))
    }
}

/// Compares by cross-multiplication.
///
/// The type's own order compares continued fractions: slower, and recursive, so that two long
/// numbers that nearly agree could exhaust the stack.
fn cross_compare(a: &BigRational, b: &BigRational) -> Ordering {
    // Denominators are positive: the type keeps its sign in the numerator.
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// The value as a fraction of 128-bit integers, or `None` when it does not fit.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Fixed, Scalar, rational};
///
/// let x = BigRational::integer(3).half();
/// assert_eq!(rational::to_fixed(&x), Some(Fixed::new(3, 2)));
/// ```
#[must_use]
pub fn to_fixed(x: &BigRational) -> Option<Fixed> {
    Some(Fixed::new(x.numer().to_i128()?, x.denom().to_i128()?))
}

/// The value as a fraction of big integers.
#[must_use]
pub fn to_wide(x: &BigRational) -> Wide {
    Wide::new(x.numer().clone(), x.denom().clone())
}

/// The value in any kind of number, as exactly as that can: made of its digits.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Fixed, Scalar, rational};
///
/// let x = BigRational::integer(-70_001).over(BigRational::integer(300));
/// assert_eq!(rational::to_scalar::<Fixed>(&x), Fixed::new(-70_001, 300));
/// ```
#[must_use]
pub fn to_scalar<S: Scalar>(x: &BigRational) -> S {
    let whole = |n: &BigInt| {
        let (sign, digits) = n.to_bytes_be();
        let magnitude = digits.into_iter().fold(S::zero(), |sum, digit| {
            sum * S::integer(256) + S::integer(digit.into())
        });
        match sign {
            Sign::Minus => -magnitude,
            Sign::NoSign | Sign::Plus => magnitude,
        }
    };
    if x.is_integer() {
        return whole(x.numer());
    }
    whole(x.numer()).over(whole(x.denom()))
}

/// Bits of numbers that a decision is tried with first: long numbers take long.
pub(crate) const SHORT: u32 = 64;

/// The value where numerator and denominator have at most so many bits, else two dyadic numbers around it whose numerators
/// have one more at most.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar, rational};
///
/// let third = BigRational::integer(1).over(BigRational::integer(3));
/// let around = rational::short(&third, 1);
/// assert_eq!((around.lo().to_string(), around.hi().to_string()), ("1/4".to_owned(), "1/2".to_owned()));
/// assert!(rational::short(&third, 2).is_point());
/// ```
#[must_use]
pub fn short(x: &BigRational, bits: u32) -> Interval<BigRational> {
    let bits = u64::from(bits);
    let (above, below) = (x.numer().bits(), x.denom().bits());
    if above.max(below) <= bits {
        return Interval::point(x.clone());
    }
    let raised = bits + below;
    let scaled = |lo: BigInt| match raised.checked_sub(above) {
        Some(up) => BigRational::new(lo, BigInt::from(1) << up),
        None => BigRational::from_integer(lo << (above - raised)),
    };
    let whole = match raised.checked_sub(above) {
        Some(up) => (x.numer() << up).div_floor(x.denom()),
        None => x.numer().div_floor(&(x.denom() << (above - raised))),
    };
    Interval::hull(scaled(whole.clone()), scaled(whole + 1))
}

impl Interval<BigRational> {
    /// The interval from the lower to the upper end of what [`short`] puts around its ends: as short
    /// numbers as that, and no narrower.
    #[must_use]
    pub fn shortened(&self, bits: u32) -> Self {
        let [lo, hi] = [self.lo(), self.hi()].map(|end| short(end, bits));
        Self::new_unchecked(lo.lo().clone(), hi.hi().clone())
    }
}

/// The value in lowest terms, or `None` when it is undefined.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Fixed, Scalar, rational};
///
/// assert_eq!(rational::from_fixed(&Fixed::new(6, 4)), Some(BigRational::integer(3).half()));
/// assert_eq!(rational::from_fixed(&Fixed::new(1, 0)), None);
/// ```
#[must_use]
pub fn from_fixed(x: &Fixed) -> Option<BigRational> {
    let (n, d) = x.parts()?;
    Some(BigRational::new(BigInt::from(*n), BigInt::from(*d)))
}

/// The value in lowest terms, or `None` when it is undefined.
#[must_use]
pub fn from_wide(x: &Wide) -> Option<BigRational> {
    let (n, d) = x.reduced()?;
    Some(BigRational::new_raw(n, d))
}

/// The fraction of least denominator in (lo, hi], for 0 ≤ lo < hi.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, rational::simplest_above};
///
/// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// assert_eq!(simplest_above(&ratio(314, 100), &ratio(315, 100)), ratio(22, 7));
/// assert_eq!(simplest_above(&ratio(1, 2), &ratio(2, 3)), ratio(2, 3));
/// ```
#[must_use]
pub fn simplest_above(lo: &BigRational, hi: &BigRational) -> BigRational {
    // By continued fractions: as long as no whole number is between the ends their common whole
    // part is kept, and the simplest fraction between the reciprocals of what is left comes next.
    let (mut lo, mut hi) = (lo.clone(), hi.clone());
    let mut closed_above = true;
    let mut wholes: Vec<BigInt> = Vec::new();
    let last = loop {
        let whole = lo.numer().div_floor(lo.denom());
        let kept = BigRational::from_integer(whole.clone());
        let at_lo = kept == lo;
        let next = if at_lo && !closed_above {
            kept.clone()
        } else {
            &kept + BigRational::one()
        };
        if next < hi || (closed_above && next == hi) {
            break next;
        }
        wholes.push(whole);
        let reciprocal = (hi - &kept).recip();
        if at_lo {
            // Above there is no end; from below it is closed exactly when the old end above was.
            let floor = BigRational::from_integer(reciprocal.numer().div_floor(reciprocal.denom()));
            let least = closed_above && floor == reciprocal;
            break if least {
                floor
            } else {
                floor + BigRational::one()
            };
        }
        // Reciprocals turn the order round: the closed end changes sides.
        hi = (lo - &kept).recip();
        lo = reciprocal;
        closed_above = !closed_above;
    };
    wholes.into_iter().rev().fold(last, |fraction, whole| {
        fraction.recip() + BigRational::from_integer(whole)
    })
}
