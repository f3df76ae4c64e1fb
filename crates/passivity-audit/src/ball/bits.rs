//! What the bits of doubles say: how long they are, and what is exact.

use super::{EXACT, WHOLE};

/// The nearest whole number, and what is left: for numbers below 2⁵⁰ in magnitude.
#[inline(always)]
#[allow(clippy::cast_possible_wrap)] // both are below 2⁶³
pub(super) fn split(x: f64) -> (i64, f64) {
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

/// Whether a whole number is a double.
#[inline(always)]
pub(super) fn is_double(n: i64) -> bool {
    let size = n.unsigned_abs();
    size < EXACT || size >> size.trailing_zeros() < EXACT
}

/// Whether a sum is a double.
#[inline(always)]
pub(crate) fn is_exact_sum(a: f64, b: f64) -> bool {
    // What rounding takes off, exactly.
    let sum = a + b;
    let part = sum - a;
    (a - (sum - part)) + (b - part) == 0.0
}

/// The bits of a number without the zeros at their end, with the leading one that is not written.
#[inline]
pub(super) fn digits(x: f64) -> u32 {
    f64::MANTISSA_DIGITS - x.to_bits().trailing_zeros().min(f64::MANTISSA_DIGITS - 1)
}

/// Whether a product is a double: of numbers that are far from the least and the largest doubles.
#[inline(always)]
pub(super) fn is_exact_product(a: f64, b: f64) -> bool {
    /// Takes the upper half of the digits apart.
    const UPPER: f64 = ((1_u64 << 27) + 1) as f64;
    let halves = |x: f64| {
        let shifted = UPPER * x;
        let upper = shifted - (shifted - x);
        [upper, x - upper]
    };
    let is_far_from_zero = |x: f64| x.abs() > 1e-100 && x.abs() < 1e100;
    let ([a1, a2], [b1, b2]) = (halves(a), halves(b));
    // What rounding takes off, exactly.
    let rest = ((a1 * b1 - a * b) + a1 * b2 + a2 * b1) + a2 * b2;
    is_far_from_zero(a) && is_far_from_zero(b) && rest == 0.0
}
