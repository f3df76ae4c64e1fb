//! Doubles as they are: what the kernel's formulas compute with where what rounding does is bounded beforehand.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use passivity_core::{Ordered, Scalar};

/// A double, which stands for a number that it is near to.
///
/// Of what is no number nothing is promised: whoever computes with these leaves out what is too large or too small.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plain(pub(crate) f64);

impl Add for Plain {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Plain {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Plain {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Plain {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Plain {
    #[inline(always)]
    fn integer(n: i32) -> Self {
        Self(n.into())
    }

    #[inline(always)]
    fn half(self) -> Self {
        Self(0.5 * self.0)
    }

    #[inline(always)]
    fn floor(&self) -> Self {
        Self(self.0.floor())
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    // One instruction of vector code each, which the library's are not: they look for what is no number.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self.0 > other.0 { self } else { other }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self.0 < other.0 { self } else { other }
    }

    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        Self(self.0 / divisor.0)
    }
}

impl Ordered for Plain {
    #[inline(always)]
    fn sign(&self) -> Option<Ordering> {
        self.0.partial_cmp(&0.0)
    }

    #[inline(always)]
    fn is_nonnegative(&self) -> Option<bool> {
        Some(self.0 >= 0.0)
    }
}
