//! Balls around exact numbers: the doubles nearest to them, moved to the right side of a whole number that is close.

use std::cmp::Ordering;

use multiversion::multiversion;
use passivity_core::{BigRational, Scalar as _};

use super::bits::{rest_of_product, split, unless};
use super::{Ball, EXACT, OUTWARD, ROUNDING, TINY, UNITS};
use crate::log::near_rational;
use crate::number::Number;
use crate::span::{BITS, Span};

/// Of two positions beside a whole number, what of its radius is left between the ball and the one above it.
const MARGIN: f64 = 1.0 / (1_u64 << 40) as f64;

impl Ball {
    /// Around n/d.
    #[inline]
    pub(crate) fn of(x: &Number) -> Self {
        match x {
            Number::Small(n, d) => Self::ratio(*n, *d),
            Number::Tiny(n, k) => Self::tiny(*n, *k),
            Number::Big(x) => Self::of_rational(x),
        }
    }

    /// The same of a position or a force, [beside](beside) a whole number that it is close to.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // of the gap no digit matters
    pub(crate) fn of_reading(x: &Number) -> Self {
        let ball = Self::of(x);
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

    /// Around n/d, d > 0: equal fractions are one ball.
    #[inline(always)]
    #[allow(clippy::cast_precision_loss)] // none is lost
    pub(crate) fn ratio(n: i64, d: i64) -> Self {
        if d == 1 {
            return Self::whole(n);
        }
        if n.unsigned_abs() >= EXACT || d.unsigned_abs() >= EXACT {
            let nearest = nearest(n < 0, n.unsigned_abs().into(), d.unsigned_abs(), 0);
            return nearest.map_or(Self::UNDEFINED, |(ball, _)| ball);
        }
        let (numerator, d) = (n as f64, d as f64);
        let middle = numerator / d;
        // It is a double where it gives back the numerator: positions may be on the border between two ticks, and forces
        // may be zero on balance.
        match middle * d == numerator && rest_of_product(middle, d) == 0.0 {
            true => Self::exactly(middle),
            false => Self::rounded(middle, 1.0),
        }
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

    /// [`of_reading`](Self::of_reading) of ±n/d·2^−k without big numbers; `None` where it is near the least or
    /// the largest doubles, or closer to a whole number than is told here.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // of 53 bits none is lost
    pub(crate) fn of_scaled_quotient(is_negative: bool, n: u128, d: u64, k: u32) -> Option<Self> {
        let (ball, (is_further, by)) = nearest(is_negative, n, d, k)?;
        let Some(border) = ball.close_to() else {
            return Some(ball);
        };
        // Rounding keeps the order, so that only the whole number itself leaves open on which side of it this is.
        let off = ball.middle - border as f64;
        let (is_above, gap) = match off == 0.0 {
            true => (is_further != is_negative, by),
            false => (off > 0.0, 0.5 * off.abs()),
        };
        let side = match is_above {
            true => Ordering::Greater,
            false => Ordering::Less,
        };
        ball.beside(border, side, 0.5 * gap)
    }

    /// A number on the grid, in units of 2⁻⁶⁴.
    #[inline]
    pub(super) fn of_units(n: i128) -> Self {
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

    /// The whole number that it is [close](is_close) to.
    #[inline]
    fn close_to(self) -> Option<i64> {
        let (whole, rest) = split(self.middle);
        is_close(self.parts(), rest).then_some(whole)
    }

    /// The same number, moved to the side of a whole number that it is close to: so that it is known in which tick a
    /// position is. `None` where it is on no side, or where the `gap`, which it is away from the whole number at the
    /// least, is too small for to be below it.
    #[inline]
    #[allow(clippy::cast_precision_loss)] // a double has it
    fn beside(self, border: i64, side: Ordering, gap: f64) -> Option<Self> {
        let border = border as f64;
        let width = width(self.parts(), border);
        let is_on_a_side = match side {
            Ordering::Less => gap >= MARGIN * width,
            Ordering::Equal => false,
            Ordering::Greater => true,
        };
        let (middle, radius) = beside(border, width, side.is_gt());
        is_on_a_side.then_some(Self { middle, radius })
    }
}

/// Whether a ball is too close to the nearest whole number, of which it is so far off, for to tell on which side of it
/// it is. Counts that were multiplied by the width of a tick are that close.
#[inline(always)]
fn is_close((middle, radius): (f64, f64), rest: f64) -> bool {
    /// Doubles around here are no further apart than a fourth.
    const LARGEST: f64 = (1_u64 << 50) as f64;
    let open =
        unless(middle.abs() < LARGEST) + unless(radius > 0.0) + unless(rest.abs() <= 2.0 * radius);
    open == 0.0
}

/// The power of two above what a ball reaches away from a whole number: a multiple of what doubles are apart here.
#[inline(always)]
fn width((middle, radius): (f64, f64), border: f64) -> f64 {
    const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
    let reach = ((middle - border).abs() + radius) * OUTWARD;
    f64::from_bits(((reach.to_bits() >> DIGITS) + 1) << DIGITS)
}

/// All numbers from a whole one up to twice the width above or below it.
#[inline(always)]
fn beside(border: f64, width: f64, is_above: bool) -> (f64, f64) {
    match is_above {
        true => (border + width, width),
        false => (border - width, width * (1.0 - MARGIN)),
    }
}

/// A short rational factor, as two doubles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Short {
    numerator: f64,
    denominator: f64,
}

impl Short {
    /// Numerators and denominators up to here: see [`times`](Self::times).
    const LARGEST: f64 = (1_u64 << 34) as f64;
    const DENOMINATOR: f64 = (1_u64 << 49) as f64;

    /// p/q, q > 0.
    #[allow(clippy::cast_precision_loss)] // then it is not short
    pub(crate) const fn new(p: i64, q: i64) -> Self {
        Self {
            numerator: p as f64,
            denominator: q as f64,
        }
    }

    /// Over a power of ten, or any whole number.
    #[inline(always)]
    fn over(self, n: f64) -> Self {
        Self {
            denominator: self.denominator * n,
            ..self
        }
    }

    /// [`Ball::of_reading`] of the product with a double: its middle and its radius, with no number in the middle where
    /// that is not decided here.
    ///
    /// With x < 2⁵³, p ≤ 2³⁴ and q ≤ 2⁴⁹, all of these are exact: the product x·p as a sum of two doubles, and what a
    /// first quotient, which is off by less than two units in its last place, leaves of it. That is a multiple of one in
    /// the last place of x or of the quotient, of which it has at most 4·max(p, q). So is its distance from the middle
    /// between two doubles, which is hence none, or more than a rounding: the quotient with its rest over q is the nearest
    /// double. And no product that is no whole number is as close to one as 2⁻⁴⁰ of the width of a ball.
    #[inline(always)]
    pub(crate) fn times(self, x: f64) -> (f64, f64) {
        const SMALLEST: f64 = 1e-60;
        let (p, q) = (self.numerator, self.denominator);
        let product = x * p;
        let first = product / q;
        let back = first * q;
        let left = (product - back) + (rest_of_product(x, p) - rest_of_product(first, q));
        let middle = first + left / q;
        let rest = left - (middle - first) * q;
        let open = unless(x.abs() >= SMALLEST)
            + unless(x.abs() < EXACT as f64)
            + unless(p.abs() <= Self::LARGEST)
            + unless(q <= Self::DENOMINATOR);
        let radius = if rest == 0.0 {
            0.0
        } else {
            ROUNDING * middle.abs()
        };
        let border = middle - split(middle).1;
        let off = middle - border;
        let is_above = if off == 0.0 { rest } else { off } > 0.0;
        let ball = (middle, radius);
        let moved = beside(border, width(ball, border), is_above);
        let ball = if is_close(ball, off) { moved } else { ball };
        let known = if open == 0.0 { ball } else { (f64::NAN, 0.0) };
        // Nothing is scaled to nothing.
        if x == 0.0 { (0.0, 0.0) } else { known }
    }
}

/// The balls of doubles times a factor.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(crate) fn scaled(values: &[f64], factor: Short, (middles, radii): (&mut [f64], &mut [f64])) {
    for ((x, middle), radius) in values.iter().zip(middles).zip(radii) {
        (*middle, *radius) = factor.times(*x);
    }
}

/// The same of n over 10^k.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[allow(clippy::cast_precision_loss)] // from 2⁵³ on nothing is decided
pub(crate) fn scaled_decimals(
    (numerators, powers): (&[i64], &[u8]),
    factor: Short,
    (middles, radii): (&mut [f64], &mut [f64]),
) {
    /// As many as are short.
    const TENS: [f64; 15] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14,
    ];
    let decimals = numerators.iter().zip(powers);
    for ((decimal, middle), radius) in decimals.zip(middles).zip(radii) {
        let (n, k) = decimal;
        let ten = TENS.get(usize::from(*k)).copied().unwrap_or(f64::NAN);
        (*middle, *radius) = factor.over(ten).times(*n as f64);
    }
}

/// The ball around the double that is nearest to ±n/d·2^−k, d > 0, and what that is off by: whether the number is further
/// from zero, and by how much, rounded down. `None` where it is near the least or the largest doubles.
#[inline]
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // of 53 bits none is lost
fn nearest(is_negative: bool, n: u128, d: u64, k: u32) -> Option<(Ball, (bool, f64))> {
    if n == 0 {
        return Some((Ball::exactly(0.0), (false, 0.0)));
    }
    let up = n.leading_zeros();
    let (n, d) = (n << up, u128::from(d));
    let quotient = n.checked_div(d)?;
    // It has 64 bits at least, of which a double has the first 53.
    let down = u128::BITS - quotient.leading_zeros() - f64::MANTISSA_DIGITS;
    let (mantissa, half) = ((quotient >> down) as u64, 1_u128 << (down - 1));
    let rest = quotient & (2 * half - 1);
    let is_more = quotient * d != n;
    let rounds_up = rest > half || rest == half && (is_more || mantissa % 2 == 1);
    let unit = power_of_two(i64::from(down) - i64::from(up) - i64::from(k))?;
    let size = (mantissa + u64::from(rounds_up)) as f64 * unit;
    let middle = if is_negative { -size } else { size };
    if rest == 0 && !is_more {
        return Some((Ball::exactly(middle), (false, 0.0)));
    }
    let units = if rounds_up { 2 * half - 1 - rest } else { rest };
    let by = units as f64 / (2 * half) as f64 * unit;
    Some((Ball::rounded(middle, 1.0), (!rounds_up, by)))
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
