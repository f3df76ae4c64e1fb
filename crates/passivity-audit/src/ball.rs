//! Doubles with a bound of how far off they may be: the fastest enclosures that the kernel's formulas
//! compute with.

use passivity_core::{BigRational, Scalar as _};

use bits::is_double;
pub(crate) use bits::{is_exact_sum, over_power_of_two, rest_of_product, split, unless};
pub(crate) use nearest::{Short, radius_of_span, scaled, scaled_decimals};

use crate::span::BITS;

/// A number that is no further than `radius` from `middle`.
///
/// Every operation takes the rounding of doubles into the radius, so that whatever the numbers are that
/// the operands stand for, the result of the exact operation is in the result. Comparisons are answered
/// only where they come out the same for all of them. What cannot be told has a radius that is infinite or
/// no number, and stays so: the caller then computes with numbers that are known more closely.
///
/// One by one they are computed with `BRANCHES` around what most do not need; several at a time, as [`Lane`]s,
/// without any. The results are the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball<const BRANCHES: bool = true> {
    middle: f64,
    radius: f64,
}

/// One of several that are computed at a time.
pub(crate) type Lane = Ball<false>;

/// Twice the most that rounding to the nearest double is off by, of the double: 2⁻⁵³.
const ROUNDING: f64 = f64::EPSILON;

/// What a radius is multiplied by after at most six roundings of its own: (1 − 2⁻⁵³)⁶·(1 + 2⁻⁵⁰) > 1.
const OUTWARD: f64 = 1.0 + 4.0 * f64::EPSILON;

/// More than what all the roundings of an operation can be off by near zero, where doubles are 2⁻¹⁰⁷⁴ apart.
const TINY: f64 = f64::MIN_POSITIVE;

/// Up to here whole numbers are doubles.
const WHOLE: f64 = 9_007_199_254_740_992.0;

/// [`WHOLE`], as a whole number.
const EXACT: u64 = 1 << f64::MANTISSA_DIGITS;

/// One, in units of the grid.
const UNITS: f64 = 18_446_744_073_709_551_616.0;

impl<const BRANCHES: bool> Ball<BRANCHES> {
    pub(crate) const UNDEFINED: Self = Self {
        middle: 0.0,
        radius: f64::INFINITY,
    };

    #[inline(always)]
    const fn exactly(middle: f64) -> Self {
        Self {
            middle,
            radius: 0.0,
        }
    }

    /// The middle and the radius.
    #[inline(always)]
    pub(crate) const fn parts(self) -> (f64, f64) {
        (self.middle, self.radius)
    }

    /// The same number, to be computed with several at a time.
    #[inline(always)]
    pub(crate) const fn lane(self) -> Lane {
        let (middle, radius) = self.parts();
        Ball { middle, radius }
    }

    /// The same number, to be computed with on its own.
    #[inline(always)]
    pub(crate) const fn alone(self) -> Ball {
        let (middle, radius) = self.parts();
        Ball { middle, radius }
    }

    /// Whether there are [`units`](Ball::units) of it.
    #[inline(always)]
    pub(crate) fn fits(self) -> bool {
        self.excess() == 0.0
    }

    /// Zero where there are [`units`](Ball::units) of it, else above that.
    #[inline(always)]
    pub(crate) fn excess(self) -> f64 {
        /// Room for sums.
        const LARGEST: f64 = (1_u64 << 35) as f64;
        const WIDEST: f64 = (1_u64 << 50) as f64;
        unless(self.middle.abs() < LARGEST) + unless(self.radius * UNITS < WIDEST)
    }

    #[inline(always)]
    fn is_defined(self) -> bool {
        self.radius < f64::INFINITY
    }

    #[inline(always)]
    pub(crate) fn is_zero(self) -> bool {
        self.size() == 0.0
    }

    /// Zero for zero alone: the magnitude of the middle and the radius.
    #[inline(always)]
    pub(crate) const fn size(self) -> f64 {
        self.middle.abs() + self.radius
    }

    /// The [`units`](Ball::units) as whole numbers of 1, 2⁻³² and 2⁻⁶⁴ and how many of the last they may be off,
    /// where they [fit](Self::fits): without a branch.
    #[inline(always)]
    pub(crate) fn layers(self) -> [i64; 4] {
        const HALF: f64 = (1_u64 << (BITS / 2)) as f64;
        // Exact: each rest has no digits that the number before it has not.
        let (whole, rest) = split(self.middle);
        let (upper, rest) = split(rest * HALF);
        let (lower, rest) = split(rest * HALF);
        // What is left is half a unit at most, as is what a radius loses to the nearest whole number.
        let radius = self.radius * UNITS;
        let (nearest, _) = split(radius);
        let is_exact = rest == 0.0 && radius == 0.0;
        let off = nearest.wrapping_add(i64::from(!is_exact));
        [whole, upper, lower, off]
    }

    /// A number that it may stand for.
    #[inline(always)]
    pub(crate) fn one_of(self) -> Self {
        match self.is_defined() {
            true => Self::exactly(self.middle),
            false => self,
        }
    }
}

impl Ball {
    /// Around a double that is the nearest but for `roundings` roundings.
    #[inline(always)]
    pub(crate) fn rounded(middle: f64, roundings: f64) -> Self {
        Self {
            middle,
            radius: roundings * ROUNDING * middle.abs(),
        }
    }

    /// A whole number.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // that is in the radius
    pub(crate) fn whole(n: i64) -> Self {
        let middle = n as f64;
        match is_double(n) {
            true => Self::exactly(middle),
            false => Self::rounded(middle, 1.0),
        }
    }

    /// The ball with these [`parts`](Self::parts).
    #[inline(always)]
    pub(crate) const fn from_parts(middle: f64, radius: f64) -> Self {
        Self { middle, radius }
    }

    /// Around n/d, d > 0, of a sum: which fraction of equal ones it is may be told.
    #[allow(clippy::cast_precision_loss)] // that is in the radius
    pub(crate) fn wide_ratio(n: i128, d: i128) -> Self {
        // Of n, of d and of the quotient.
        Self::rounded(n as f64 / d as f64, 3.0)
    }

    /// Around all numbers from one to another.
    pub(crate) fn around(lo: &BigRational, hi: &BigRational) -> Self {
        let middle = Self::of_rational(&(lo + hi).half());
        // Half of the distance and, twice over, what the middle is off by.
        let reach = Self::of_rational(&(hi - lo).half());
        Self {
            middle: middle.middle,
            radius: (middle.radius + reach.middle + reach.radius) * OUTWARD,
        }
    }

    /// The number in units of the grid, 2⁻⁶⁴, and how far off that may be; `None` where that is wide,
    /// past 2³⁵ or undefined.
    #[inline(always)]
    pub(crate) fn units(self) -> Option<(i128, i64)> {
        let [whole, upper, lower, radius] = self.layers();
        self.fits()
            .then(|| (on_grid([whole, upper, lower]), radius))
    }

    /// The ends in units of the grid, rounded outward; `None` as for [`units`](Self::units).
    #[inline(always)]
    pub(crate) fn on_grid(self) -> Option<[i128; 2]> {
        self.fits().then(|| self.ends_on_grid())
    }

    /// The same of a number that is known to [fit](Self::fits).
    #[inline(always)]
    pub(crate) fn ends_on_grid(self) -> [i128; 2] {
        let [whole, upper, lower, radius] = self.layers();
        let (middle, radius) = (on_grid([whole, upper, lower]), i128::from(radius));
        [middle - radius, middle + radius]
    }

    /// The double in the middle, where the number is defined.
    #[inline]
    pub(crate) fn near(self) -> Option<f64> {
        self.is_defined().then_some(self.middle)
    }
}

/// The units of the grid that as many of 1, 2⁻³² and 2⁻⁶⁴ are.
#[inline(always)]
pub(crate) fn on_grid([whole, upper, lower]: [i64; 3]) -> i128 {
    (i128::from(whole) << BITS) + (i128::from(upper) << (BITS / 2)) + i128::from(lower)
}

mod bits;
mod nearest;
mod operations;
#[cfg(test)]
mod tests;
