//! What the bits of doubles say: how long they are, and what is exact.

use super::{EXACT, WHOLE};

/// The nearest whole number, and what is left: for numbers below 2⁵⁰ in magnitude.
#[inline(always)]
#[allow(clippy::cast_possible_wrap)] // both are below 2⁶³
pub(crate) fn split(x: f64) -> (i64, f64) {
    /// Doubles from here to the next power of two are whole numbers, and in order as their bits are.
    const MIDDLE: f64 = 1.5 * WHOLE / 2.0;
    let shifted = x + MIDDLE;
    let whole = (shifted.to_bits() as i64).wrapping_sub(MIDDLE.to_bits() as i64);
    (whole, x - (shifted - MIDDLE))
}

/// Whether a size is above zero: with one comparison, which most sizes pass.
#[inline(always)]
pub(super) fn is_more(size: f64) -> bool {
    size > 0.0
}

/// Nothing where that is so, else one.
///
/// Several conditions are looked at by one comparison of the sum of these: vector code has as many of them at once as
/// of numbers, where it would have to make conditions narrower first to combine them.
#[inline(always)]
pub(crate) fn unless(is: bool) -> f64 {
    if is { 0.0 } else { 1.0 }
}

/// Whether a whole number is a double.
#[inline(always)]
pub(super) fn is_double(n: i64) -> bool {
    let size = n.unsigned_abs();
    size < EXACT || size >> size.trailing_zeros() < EXACT
}

/// Whether a sum is a double.
#[inline(always)]
pub(crate) fn is_exact_sum(a: f64, b: f64) -> bool {
    rest_of_sum(a, b) == 0.0
}

/// What rounding takes off a sum, exactly.
#[inline(always)]
pub(super) fn rest_of_sum(a: f64, b: f64) -> f64 {
    let sum = a + b;
    let part = sum - a;
    (a - (sum - part)) + (b - part)
}

/// The digits of a double and how many of them, in binary, are behind its point: of normal numbers below 2⁵³ in size that
/// are no zero; whatever its sign.
#[inline(always)]
pub(crate) fn over_power_of_two(x: f64) -> Option<(u64, u32)> {
    const FRACTION: u32 = f64::MANTISSA_DIGITS - 1;
    /// The exponent, as it is stored, of doubles whose digits are those of a whole number.
    const WHOLE: u32 = 1023 + FRACTION;
    let bits = x.to_bits();
    let exponent = (bits >> FRACTION & 0x7ff) as u32;
    let digits = bits & ((1 << FRACTION) - 1) | 1 << FRACTION;
    (1..=WHOLE)
        .contains(&exponent)
        .then(|| (digits, WHOLE - exponent))
}

/// What rounding takes off a product, exactly, where neither number is near the least or the largest doubles.
#[inline(always)]
pub(crate) fn rest_of_product(a: f64, b: f64) -> f64 {
    /// Takes the upper half of the digits apart.
    const UPPER: f64 = ((1_u64 << 27) + 1) as f64;
    let halves = |x: f64| {
        let shifted = UPPER * x;
        let upper = shifted - (shifted - x);
        [upper, x - upper]
    };
    let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
    ((a1 * b1 - a * b) + a1 * b2 + a2 * b1) + a2 * b2
}

/// Zero where a product is a double, of which rounding takes off that much, and above that where it is none, or where
/// one of the numbers is near the least or the largest doubles.
#[inline(always)]
pub(super) fn off_product(a: f64, b: f64, rest: f64) -> f64 {
    let (a, b) = (a.abs(), b.abs());
    let (least, most) = if a < b { (a, b) } else { (b, a) };
    rest.abs() + (unless(least > 1e-100) + unless(most < 1e100))
}
