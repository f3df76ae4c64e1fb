//! What a number must do to carry the kernel's formulas.
//!
//! The formulas never branch on a value: they use [`floor`](Scalar::floor),
//! [`abs`](Scalar::abs), [`max`](Scalar::max) and [`min`](Scalar::min) instead. So the text that
//! computes with fractions also builds the terms of a solver's query. Constants are made of small
//! integers and halves, which every exact type has.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A number that the kernel's formulas can be computed with.
///
/// An operation that has no result (overflow of a fixed width, division by zero) gives an
/// *undefined* value that stays undefined through every later operation, so that the formulas
/// need no error paths. [`Ordered::sign`] is where it surfaces.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar};
///
/// fn half_square<S: Scalar>(x: S) -> S {
///     (x.clone() * x).half()
/// }
/// assert_eq!(half_square(Fixed::new(2, 3)), Fixed::new(2, 9));
/// ```
pub trait Scalar:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
    /// The integer `n`.
    fn integer(n: i32) -> Self;

    /// Half of the value, exactly.
    #[must_use]
    fn half(self) -> Self;

    /// The largest integer that is not above the value: ⌊x⌋, also for negative x.
    #[must_use]
    fn floor(&self) -> Self;

    /// The magnitude |x|.
    #[must_use]
    fn abs(&self) -> Self;

    /// The larger of the two values.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// The smaller of the two values.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The quotient `self / divisor`; undefined when the divisor is zero.
    #[must_use]
    fn over(self, divisor: Self) -> Self;

    /// The same value, with common factors of its parts divided out where it is made of big ones: what
    /// a long sum of fractions is worth.
    #[must_use]
    fn shortened(self) -> Self {
        self
    }

    /// Σ aᵢbᵢ of two lists, up to the end of the shorter.
    #[must_use]
    fn sum_of_products(a: &[Self], b: &[Self]) -> Self {
        let products = a.iter().zip(b).map(|(a, b)| a.clone() * b.clone());
        products.fold(Self::zero(), |sum, product| sum + product)
    }

    /// Zero.
    #[inline(always)]
    #[must_use]
    fn zero() -> Self {
        Self::integer(0)
    }

    /// One.
    #[inline(always)]
    #[must_use]
    fn one() -> Self {
        Self::integer(1)
    }

    /// The square x².
    #[inline(always)]
    #[must_use]
    fn square(&self) -> Self {
        self.clone() * self.clone()
    }

    /// Twice the value.
    #[inline(always)]
    #[must_use]
    fn double(&self) -> Self {
        self.clone() + self.clone()
    }
}

/// A [`Scalar`] whose values can be compared: what a verdict needs and a formula does not.
///
/// # Example
///
/// ```
/// use core::cmp::Ordering;
/// use passivity_core::{Fixed, Ordered, Scalar};
///
/// assert_eq!(Fixed::new(-1, 3).sign(), Some(Ordering::Less));
/// assert_eq!(Fixed::new(i128::MAX, 1).square().sign(), None); // overflow is not a sign
/// ```
pub trait Ordered: Scalar {
    /// How the value compares with zero, or `None` for an undefined value.
    fn sign(&self) -> Option<Ordering>;

    /// How the value compares with `other`, or `None` when either is undefined.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        (self.clone() - other.clone()).sign()
    }

    /// Whether the value is at least zero; `None` when it is undefined.
    fn is_nonnegative(&self) -> Option<bool> {
        self.sign().map(|s| s != Ordering::Less)
    }

    /// Whether the value is above zero; `None` when it is undefined.
    fn is_positive(&self) -> Option<bool> {
        self.sign().map(|s| s == Ordering::Greater)
    }
}
