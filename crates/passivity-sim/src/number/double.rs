//! Doubles as numbers of the kernel.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use passivity_core::{BigRational, Ordered, Scalar};

use super::rational::to_double;
use super::real::Real;

/// A double that the kernel's formulas can be computed with; NaN is its undefined value.
///
/// A type of its own, because the kernel knows no floating point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Double(pub f64);

/// 1.5·2⁵²: what is added to it is rounded to a whole number.
pub(crate) const MAGIC: f64 = 6_755_399_441_055_744.0;

/// ⌊x⌋ without a library call and without the instruction that a plain x86-64 lacks.
///
/// Adding 1.5·2⁵² rounds to the nearest integer; beyond 2⁵¹ the library takes over.
#[inline(always)]
pub(crate) fn floor(x: f64) -> f64 {
    const LIMIT: f64 = 2_251_799_813_685_248.0;
    if x.abs() >= LIMIT {
        return x.floor();
    }
    let nearest = (x + MAGIC) - MAGIC;
    nearest - if nearest > x { 1.0 } else { 0.0 }
}

impl From<&BigRational> for Double {
    fn from(x: &BigRational) -> Self {
        Self(to_double(x))
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Double {
    fn integer(n: i32) -> Self {
        Self(f64::from(n))
    }

    fn half(self) -> Self {
        Self(0.5 * self.0)
    }

    fn floor(&self) -> Self {
        Self(floor(self.0))
    }

    fn abs(&self) -> Self {
        Self(self.0.abs())
    }

    fn max(self, other: Self) -> Self {
        // The library's maximum passes over NaN, which here must stay.
        match self.0.partial_cmp(&other.0) {
            Some(Ordering::Less) => other,
            Some(_) => self,
            None => Self(f64::NAN),
        }
    }

    fn min(self, other: Self) -> Self {
        match self.0.partial_cmp(&other.0) {
            Some(Ordering::Greater) => other,
            Some(_) => self,
            None => Self(f64::NAN),
        }
    }

    fn over(self, divisor: Self) -> Self {
        if divisor.0 == 0.0 {
            Self(f64::NAN)
        } else {
            Self(self.0 / divisor.0)
        }
    }
}

impl Ordered for Double {
    fn sign(&self) -> Option<Ordering> {
        self.0.partial_cmp(&0.0)
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl Real for Double {
    fn approximate(&self) -> f64 {
        self.0
    }

    fn is_defined(&self) -> bool {
        !self.0.is_nan()
    }

    fn bits(&self) -> u32 {
        53
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floor_is_floor() {
        let edges = [
            0.0,
            1.0,
            0.5,
            1.5,
            2.5,
            1e15,
            2.251_799_813_685_248e15,
            1e300,
            5e-324,
        ];
        for x in edges
            .into_iter()
            .flat_map(|x: f64| [x, x.next_up(), x.next_down()])
        {
            assert_eq!(floor(x), x.floor(), "{x:e}");
            assert_eq!(floor(-x), (-x).floor(), "{:e}", -x);
        }
    }
}
