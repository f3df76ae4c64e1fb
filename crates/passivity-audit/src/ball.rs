//! Doubles with a bound of how far off they may be: the fastest enclosures that the kernel's formulas
//! compute with.

use std::cmp::Ordering;

use passivity_core::{BigRational, Scalar as _};

use bits::{digits, is_double};
pub(crate) use bits::{is_exact_sum, over_power_of_two, rest_of_product, split, unless};

use crate::log::near_rational;
use crate::number::Number;
use crate::span::{BITS, Span};

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

    /// A double that is far from the least and from the largest ones.
    #[inline]
    pub(crate) fn of_double(x: f64) -> Option<Self> {
        let size = x.abs();
        // Zero has one form.
        (size == 0.0 || size > 1e-100 && size < WHOLE).then(|| Self::exactly(x + 0.0))
    }

    /// The ball with these [`parts`](Self::parts).
    #[inline(always)]
    pub(crate) const fn from_parts(middle: f64, radius: f64) -> Self {
        Self { middle, radius }
    }

    /// Around n/d.
    #[inline]
    pub(crate) fn of(x: &Number) -> Self {
        match x {
            Number::Small(n, d) => Self::ratio(*n, *d),
            Number::Tiny(n, k) => Self::tiny(*n, *k),
            Number::Big(x) => Self::of_rational(x),
        }
    }

    /// The same of a position or a force, [beside](Self::beside) a whole number that it is close to.
    #[inline]
    pub(crate) fn of_reading(x: &Number) -> Self {
        Self::of(x).as_reading(x)
    }

    /// The same of n/d in lowest terms, d > 0.
    #[inline]
    pub(crate) fn of_shortest(n: i64, d: i64) -> Self {
        let ball = match d {
            1 => Self::whole(n),
            _ => Self::quotient(n, d),
        };
        ball.as_reading(&Number::Small(n, d))
    }

    #[inline]
    #[allow(clippy::cast_precision_loss)] // of the gap no digit matters
    fn as_reading(self, x: &Number) -> Self {
        let ball = self;
        let Some(border) = ball.close_to() else {
            return ball;
        };
        let (side, gap) = match x {
            Number::Small(n, d) => {
                let side = i128::from(*n).cmp(&(i128::from(border) * i128::from(*d)));
                (side, 0.5 / *d as f64)
            }
            Number::Tiny(..) | Number::Big(_) => {
                let off = x.to_rational() - BigRational::from_integer(border.into());
                let gap = 0.9 * near_rational(&off).abs();
                (off.cmp(&BigRational::zero()), gap)
            }
        };
        ball.beside(border, side, gap).unwrap_or(ball)
    }

    /// n/2^k, where that is far from the least of the normal doubles.
    #[allow(clippy::cast_precision_loss)] // a double has no more digits
    fn tiny(n: i64, k: u32) -> Self {
        match k {
            0..=900 if n.unsigned_abs() < EXACT => match power_of_two(-i64::from(k)) {
                Some(unit) => Self::exactly(n as f64 * unit),
                None => Self::UNDEFINED,
            },
            _ => Self::of_rational(&Number::Tiny(n, k).to_rational()),
        }
    }

    /// Around n/d, d > 0.
    #[inline(always)]
    pub(crate) fn ratio(n: i64, d: i64) -> Self {
        if d == 1 {
            return Self::whole(n);
        }
        let odd = d >> d.trailing_zeros();
        if odd != 1 && (n.unsigned_abs() >= EXACT || d.unsigned_abs() >= EXACT) {
            // So that equal fractions are one ball.
            let divisor = num_integer::gcd(n, d);
            if divisor > 1 {
                return Self::of(&Number::Small(n / divisor, d / divisor));
            }
        }
        Self::quotient(n, d)
    }

    /// The same where they are short, or have no divisor in common.
    #[inline(always)]
    #[allow(clippy::cast_precision_loss)] // that is in the radius
    fn quotient(n: i64, d: i64) -> Self {
        let odd = d >> d.trailing_zeros();
        let middle = n as f64 / d as f64;
        // It is a double where what is odd of d divides n and n has no more digits: then the quotient has as
        // many fewer. Positions may be on the border between two ticks, and forces may be zero on balance.
        let bits = i64::BITS - odd.leading_zeros();
        let is_exact = match odd {
            1 => is_double(n),
            _ => digits(middle) + bits <= f64::MANTISSA_DIGITS + 1 && n % odd == 0,
        };
        if is_exact {
            return Self::exactly(middle);
        }
        // Of n, of d and of the quotient.
        Self::rounded(middle, 2.0)
    }

    /// Around n/d, d > 0, of a sum: which fraction of equal ones it is may be told.
    #[allow(clippy::cast_precision_loss)] // that is in the radius
    pub(crate) fn wide_ratio(n: i128, d: i128) -> Self {
        // Of n, of d and of the quotient.
        Self::rounded(n as f64 / d as f64, 3.0)
    }

    /// Around a big number.
    pub(crate) fn of_rational(x: &BigRational) -> Self {
        let middle = near_rational(x);
        if num_rational::BigRational::from_float(middle).as_ref() == Some(x) {
            return Self::exactly(middle);
        }
        // Below the normal doubles the nearest is not within a rounding of it.
        match middle.is_finite() && middle.abs() > TINY {
            true => Self::rounded(middle, 1.0),
            false => Self::UNDEFINED,
        }
    }

    /// [`of_reading`](Self::of_reading) of ±n/d·2^−k, n > 0, without big numbers; `None` where it is near the least or
    /// the largest doubles, or closer to a whole number than is told here.
    #[inline]
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // of 53 bits none is lost
    pub(crate) fn of_scaled_quotient(is_negative: bool, n: u128, d: u64, k: u32) -> Option<Self> {
        let up = n.leading_zeros();
        let (n, d) = (n.checked_shl(up)?, u128::from(d));
        let quotient = n.checked_div(d)?;
        // It has 64 bits at least, of which a double has the first 53.
        let down = u128::BITS - quotient.leading_zeros() - f64::MANTISSA_DIGITS;
        let (mantissa, half) = ((quotient >> down) as u64, 1_u128 << (down - 1));
        let rest = quotient & (2 * half - 1);
        let is_more = quotient * d != n;
        let rounds_up = rest > half || rest == half && (is_more || mantissa % 2 == 1);
        let exponent = i64::from(down) - i64::from(up) - i64::from(k);
        let unit = power_of_two(exponent)?;
        let size = (mantissa + u64::from(rounds_up)) as f64 * unit;
        let middle = if is_negative { -size } else { size };
        if rest == 0 && !is_more {
            return Some(Self::exactly(middle));
        }
        let ball = Self::rounded(middle, 1.0);
        let Some(border) = ball.close_to() else {
            return Some(ball);
        };
        // Rounding keeps the order, so that only the whole number itself leaves open on which side of it this is.
        let off = middle - border as f64;
        let (is_above, gap) = if off == 0.0 {
            let units = if rounds_up { 2 * half - 1 - rest } else { rest };
            (
                rounds_up == is_negative,
                units as f64 / (2 * half) as f64 * unit,
            )
        } else {
            (off > 0.0, 0.5 * off.abs())
        };
        let side = if is_above {
            Ordering::Greater
        } else {
            Ordering::Less
        };
        ball.beside(border, side, 0.5 * gap)
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

    /// A number on the grid, in units of 2⁻⁶⁴.
    #[inline]
    fn of_units(n: i128) -> Self {
        Self::of_span(Span::centred(n, 0))
    }

    /// Around what a span is around.
    #[inline]
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // both are in the radius
    pub(crate) fn of_span(span: Span) -> Self {
        let Some((middle, radius)) = span.parts() else {
            return Self::UNDEFINED;
        };
        let size = middle.unsigned_abs();
        let is_whole = radius == 0 && size as u64 == 0 && size < u128::from(EXACT) << BITS;
        let sign = if middle < 0 { -1.0 } else { 1.0 };
        let size = nearest_of_units(size);
        if is_whole {
            return Self::exactly(sign * size);
        }
        let ball = Self {
            middle: sign * size,
            radius: radius_of_span(radius as f64, size),
        };
        let Some(border) = ball.close_to() else {
            return ball;
        };
        let [below, above] = [-1, 1].map(|sign| middle + sign * i128::from(radius));
        let at_border = i128::from(border) << BITS;
        let side = match (below >= at_border, above < at_border) {
            (true, _) => Ordering::Greater,
            (_, true) => Ordering::Less,
            _ => Ordering::Equal,
        };
        // By a unit of the grid at the least.
        let gap = 1.0 / UNITS;
        ball.beside(border, side, gap).unwrap_or(ball)
    }

    /// The whole number that it is too close to for to tell on which side it is. Counts that were multiplied by the width
    /// of a tick are that close.
    #[inline]
    fn close_to(self) -> Option<i64> {
        /// Doubles around here are no further apart than a fourth.
        const LARGEST: f64 = (1_u64 << 50) as f64;
        let (whole, rest) = split(self.middle);
        let is_close =
            self.middle.abs() < LARGEST && self.radius > 0.0 && rest.abs() <= 2.0 * self.radius;
        is_close.then_some(whole)
    }

    /// The same number, moved to the side of a whole number that it is [close to](Self::close_to): so that it is known in
    /// which tick a position is. `None` where it is on no side, or where the `gap`, which it is away from the whole number
    /// at the least, is too small for to be below it.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // a double has it
    fn beside(self, border: i64, side: Ordering, gap: f64) -> Option<Self> {
        /// What of its radius is left between the ball and a whole number above it.
        const MARGIN: f64 = 1.0 / (1_u64 << 40) as f64;
        const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
        let border = border as f64;
        // The power of two above what the number may be off that: a multiple of what doubles are apart here.
        let reach = ((self.middle - border).abs() + self.radius) * OUTWARD;
        let width = f64::from_bits(((reach.to_bits() >> DIGITS) + 1) << DIGITS);
        match side {
            Ordering::Greater => Some(Self {
                middle: border + width,
                radius: width,
            }),
            Ordering::Less if gap >= MARGIN * width => Some(Self {
                middle: border - width,
                radius: width * (1.0 - MARGIN),
            }),
            _ => None,
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

/// The double nearest to so many units of the grid.
#[inline]
#[allow(clippy::cast_precision_loss)] // it is rounded once, to the nearest
fn nearest_of_units(n: u128) -> f64 {
    let up = n.leading_zeros().min(u128::BITS - 1);
    let shifted = n << up;
    // The last digit tells whether there are any behind it.
    let upper = (shifted >> BITS) as u64 | u64::from(shifted as u64 != 0);
    upper as f64 * f64::from_bits((1023 - u64::from(up)) << (f64::MANTISSA_DIGITS - 1))
}

/// The radius around a double that is the nearest to the middle of a span, of so many units.
#[inline(always)]
pub(crate) fn radius_of_span(units: f64, size: f64) -> f64 {
    // Of both roundings twice what each is off by.
    (units / UNITS + 2.0 * ROUNDING * size) * OUTWARD
}

/// 2^k, where that is far from the least and from the largest doubles.
#[inline]
fn power_of_two(k: i64) -> Option<f64> {
    /// The exponent of one.
    const ONE: i64 = 1023;
    let exponent = u64::try_from(ONE + k).ok()?;
    (-900..=900)
        .contains(&k)
        .then(|| f64::from_bits(exponent << (f64::MANTISSA_DIGITS - 1)))
}

/// The units of the grid that as many of 1, 2⁻³² and 2⁻⁶⁴ are.
#[inline(always)]
pub(crate) fn on_grid([whole, upper, lower]: [i64; 3]) -> i128 {
    (i128::from(whole) << BITS) + (i128::from(upper) << (BITS / 2)) + i128::from(lower)
}

mod bits;
mod operations;
#[cfg(test)]
mod tests;
