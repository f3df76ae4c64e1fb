//! What is known of doubles after a factor with π in it, several at a time.

use multiversion::multiversion;

use crate::ball::{radius_of_span, rest_of_product, unless};
use crate::log::numbers::Kind;

/// A factor, as the sum of the double nearest to it and of the one nearest to what that leaves.
pub(super) type Halves = [f64; 2];

/// 2^k.
const fn power(k: i32) -> f64 {
    f64::from_bits(((1023 + k) as u64) << 52)
}

/// Products of these sizes are decided: of larger ones what is computed here is not known well enough, and smaller ones
/// are rounded to the grid of spans before.
const SMALLEST: f64 = power(-4);
const LARGEST: f64 = power(29);

/// How near to the middle between two doubles nothing is decided. Of products below [`LARGEST`] the sum of both parts is off
/// by a few 2⁻⁷⁰, and on the grid by one 2⁻⁶⁴.
const MIDDLE: f64 = power(-61);

/// How near to a whole number nothing is decided: of positions, which are within a tick. A ball has a radius of 2⁻²² at most.
const fn border(kind: Kind) -> f64 {
    match kind {
        Kind::Position => power(-20),
        Kind::Force => -1.0,
    }
}

/// The ball of a number scaled by a factor, with no number in the middle where it is not decided: otherwise that around
/// the [span](crate::span::Span) on the grid that the product is cut off to, to the last bit.
///
/// The middle of that is the double nearest to a number that is less than two units of the grid nearer to zero than the
/// product is. So it is the double nearest to the product, where that is not as near to the middle between two doubles.
#[inline(always)]
fn ball(x: f64, [factor, rest]: Halves, border: f64) -> (f64, f64) {
    const EXPONENT: u64 = 0x7ff << 52;
    const ONES: f64 = 1.5 * power(52);
    let product = x * factor;
    let low = rest_of_product(x, factor) + x * rest;
    let middle = product + low;
    let off = ((product - middle) + low).abs();
    let size = middle.abs();
    // Half of what doubles of this size are apart; below a power of two they are half as far.
    let half = f64::from_bits(size.to_bits() & EXPONENT) * power(-53);
    let whole = (size + ONES) - ONES;
    let open = unless((off - half).abs() > MIDDLE)
        + unless((off - 0.5 * half).abs() > MIDDLE)
        + unless(size >= SMALLEST)
        + unless(size < LARGEST)
        + unless((size - whole).abs() > border);
    let found = if open == 0.0 { middle } else { f64::NAN };
    let radius = radius_of_span(2.0, size);
    // Nothing is scaled to nothing.
    let is_zero = x == 0.0;
    let both = |of: f64| if is_zero { 0.0 } else { of };
    (both(found), both(radius))
}

/// The [balls](ball) of numbers: their middles and radii.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn balls(
    kind: Kind,
    values: &[f64],
    factor: Halves,
    (middles, radii): (&mut [f64], &mut [f64]),
) {
    let border = border(kind);
    for ((x, middle), radius) in values.iter().zip(middles).zip(radii) {
        (*middle, *radius) = ball(*x, factor, border);
    }
}

/// The same of n over 10^k, given the factor over each power of ten.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[allow(clippy::cast_precision_loss)] // what has more digits is left open
pub(super) fn balls_of_decimals(
    kind: Kind,
    (numerators, powers): (&[i64], &[u8]),
    factors: &[Halves],
    (middles, radii): (&mut [f64], &mut [f64]),
) {
    let (border, decimals) = (border(kind), numerators.iter().zip(powers));
    for ((decimal, middle), radius) in decimals.zip(middles).zip(radii) {
        let (n, k) = decimal;
        let unknown = [f64::NAN; 2];
        let factor = factors.get(usize::from(*k)).copied().unwrap_or(unknown);
        let is_exact = n.unsigned_abs() < 1 << f64::MANTISSA_DIGITS;
        let n = if is_exact { *n as f64 } else { f64::NAN };
        (*middle, *radius) = ball(n, factor, border);
    }
}
