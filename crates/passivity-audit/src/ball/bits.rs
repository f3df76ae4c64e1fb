//! What the bits of doubles say: how long they are, and what is exact.

use super::{EXACT, WHOLE};

/// The nearest whole number, and what is left: for numbers below 2⁵⁰ in magnitude.
#[inline(always)]
#[allow(clippy::cast_possible_wrap)] // both are below 2⁶³
pub(super) fn split(x: f64) -> (i64, f64) {
    /// Doubles from here to the next power of two are whole numbers, and in order as their bits are.
    const MIDDLE: f64 = 1.5 * WHOLE / 2.0;
    let shifted = x + MIDDLE;
    let whole = shifted.to_bits() as i64 - MIDDLE.to_bits() as i64;
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
#[inline]
pub(super) fn is_exact_sum(a: f64, b: f64) -> bool {
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

/// Whether a product has no more digits than a double: never so where it is not, and always of short numbers.
#[inline]
pub(super) fn is_exact_product(a: f64, b: f64) -> bool {
    // The bits of a number without the zeros at their end, and the leading one that is not written.
    let digits =
        |x: f64| f64::MANTISSA_DIGITS - x.to_bits().trailing_zeros().min(f64::MANTISSA_DIGITS - 1);
    let is_far_from_zero = |x: f64| x.abs() > 1e-100 && x.abs() < 1e100;
    is_far_from_zero(a) && is_far_from_zero(b) && digits(a) + digits(b) <= f64::MANTISSA_DIGITS
}
