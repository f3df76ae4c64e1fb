//! What a number must do to carry a motion: doubles, arbitrary precision, rationals, intervals.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

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
