//! What a number must do to carry a motion: doubles, arbitrary precision, rationals, intervals.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;
use passivity_core::BigRational;

/// A comparison or a floor that the number at hand cannot tell: an interval that straddles an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undecided;

/// A number that the text of a motion can be computed with.
pub trait Real:
    Clone
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number n/m, as precise as `self` is.
    #[must_use]
    fn ratio(&self, n: i32, m: i32) -> Self;

    /// The sign of the number.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the number is not known well enough.
    fn sign(&self) -> Result<Ordering, Undecided>;

    /// ⌊x⌋.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the number is not known well enough.
    fn floor(&self) -> Result<Self, Undecided>;

    /// A double near the number.
    fn approximate(&self) -> f64;

    /// How many bits the number is good for: where a series may stop.
    fn bits(&self) -> u32;

    /// The number, where its error may be up to |`bound`|: intervals grow by it, others do not.
    #[must_use]
    fn widened(self, bound: &Self) -> Self {
        let _ = bound;
        self
    }

    /// What holds both numbers, when a comparison could not tell which of them is right.
    #[must_use]
    fn join(self, other: Self) -> Self {
        let _ = other;
        self
    }

    /// How many bits it takes to write the number down, if that can grow.
    fn length(&self) -> u64 {
        0
    }

    /// How `self` compares with `other`.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the numbers are not known well enough.
    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        (self.clone() - other.clone()).sign()
    }

    /// Zero.
    #[must_use]
    fn zero(&self) -> Self {
        self.ratio(0, 1)
    }

    /// One.
    #[must_use]
    fn one(&self) -> Self {
        self.ratio(1, 1)
    }

    /// |x|.
    ///
    /// # Errors
    ///
    /// [`Undecided`] when the sign is.
    fn magnitude(&self) -> Result<Self, Undecided> {
        Ok(match self.sign()? {
            Ordering::Less => -self.clone(),
            _ => self.clone(),
        })
    }
}

impl Real for BigRational {
    fn ratio(&self, n: i32, m: i32) -> Self {
        Self::new(BigInt::from(n), BigInt::from(m))
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        Ok(self.numer().cmp(&BigInt::ZERO))
    }

    fn floor(&self) -> Result<Self, Undecided> {
        Ok(Self::floor(self))
    }

    fn approximate(&self) -> f64 {
        crate::plan::to_double(self)
    }

    fn bits(&self) -> u32 {
        0 // No series is ever summed: there is none at β = 0.
    }

    fn length(&self) -> u64 {
        self.numer().bits() + self.denom().bits()
    }

    fn compare(&self, other: &Self) -> Result<Ordering, Undecided> {
        Ok(self.cmp(other))
    }
}

impl Real for f64 {
    fn ratio(&self, n: i32, m: i32) -> Self {
        Self::from(n) / Self::from(m)
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        self.partial_cmp(&0.0).ok_or(Undecided)
    }

    fn floor(&self) -> Result<Self, Undecided> {
        Ok(crate::law::floor(*self))
    }

    fn approximate(&self) -> f64 {
        *self
    }

    fn bits(&self) -> u32 {
        53
    }
}
