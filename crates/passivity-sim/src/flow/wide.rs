//! Several doubles at once: one text for a single motion and for as many as a vector register holds.
//!
//! Each operation is that of doubles, lane by lane, so that a motion has the same bits however many
//! others are computed beside it.

#![expect(clippy::indexing_slicing, reason = "both arrays have W lanes")]

use std::ops::{Add, Div, Mul, Neg, Sub};

/// W doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wide<const W: usize>(pub(crate) [f64; W]);

impl<const W: usize> Wide<W> {
    /// The same number in every lane.
    #[inline(always)]
    pub(crate) const fn splat(x: f64) -> Self {
        Self([x; W])
    }
}

impl<const W: usize> Add for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn add(mut self, other: Self) -> Self {
        for i in 0..W {
            self.0[i] += other.0[i];
        }
        self
    }
}

impl<const W: usize> Sub for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn sub(mut self, other: Self) -> Self {
        for i in 0..W {
            self.0[i] -= other.0[i];
        }
        self
    }
}

impl<const W: usize> Mul for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn mul(mut self, other: Self) -> Self {
        for i in 0..W {
            self.0[i] *= other.0[i];
        }
        self
    }
}

impl<const W: usize> Mul<f64> for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn mul(mut self, factor: f64) -> Self {
        for x in &mut self.0 {
            *x *= factor;
        }
        self
    }
}

impl<const W: usize> Div for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn div(mut self, other: Self) -> Self {
        for i in 0..W {
            self.0[i] /= other.0[i];
        }
        self
    }
}

impl<const W: usize> Neg for Wide<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for x in &mut self.0 {
            *x = -*x;
        }
        self
    }
}
