//! Ends of numbers on the grid, as two doubles each.

use crate::plain::Plain;
use crate::span::BITS;

/// An end of a number: a multiple of 2⁻¹¹ and, of the rest, one of 2⁻⁵⁸. Sums of as many as a tile has rows are exact.
pub(crate) type End = [f64; 2];

/// Binary digits after the point of both.
const UPPER: i32 = 11;
pub(super) const LOWER: i32 = 58;

/// 2⁻ⁿ.
pub(super) const fn power(n: i32) -> f64 {
    f64::from_bits(((1023 - n) as u64) << 52)
}

/// The nearest multiple of 2⁻ⁿ, of a number that is below 2⁵⁰⁻ⁿ.
#[inline(always)]
pub(super) fn nearest<const N: i32>(x: f64) -> f64 {
    let middle = 1.5 * power(N - 52);
    (x + middle) - middle
}

/// How far an end is moved for a number that is off by so much at most, and is rounded to the grid: on the grid too.
#[inline(always)]
pub(super) fn outward(off: f64) -> f64 {
    let moved = nearest::<LOWER>(off + 1.5 * power(LOWER));
    if off == 0.0 { 0.0 } else { moved }
}

/// The end that is so far from a number.
#[inline(always)]
pub(super) fn end(x: f64, moved: f64) -> End {
    let upper = nearest::<UPPER>(x);
    [upper, nearest::<LOWER>(x - upper) + moved]
}

/// The ends of a number that is between two, each moved outward by so much.
#[inline(always)]
pub(super) fn around([least, most]: [Plain; 2], moved: f64) -> [End; 2] {
    [end(least.0, -moved), end(most.0, moved)]
}

/// An end in units of the grid.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // both are whole numbers below 2⁶³
pub(crate) fn units([upper, lower]: End) -> i128 {
    let (upper, lower) = (upper * power(-UPPER), lower * power(-LOWER));
    (i128::from(upper as i64) << (BITS as i32 - UPPER))
        + (i128::from(lower as i64) << (BITS as i32 - LOWER))
}

/// A number in units of the grid as an end; `None` where it has no room, or is on a finer grid.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // nothing is lost
pub(crate) fn parts(n: i128) -> Option<End> {
    const FINER: i128 = (1 << (BITS as i32 - LOWER)) - 1;
    let upper = n >> (BITS as i32 - UPPER);
    let lower = (n - (upper << (BITS as i32 - UPPER))) as i64;
    let has_room = upper.unsigned_abs() < 1 << (UPPER + 35) && n & FINER == 0;
    has_room.then(|| {
        [
            upper as f64 * power(UPPER),
            lower as f64 * power(BITS as i32),
        ]
    })
}

/// The same end, with what is too large for the lower part in the upper one.
#[inline(always)]
pub(crate) fn carried([upper, lower]: End) -> End {
    let more = nearest::<UPPER>(lower);
    [upper + more, lower - more]
}

#[inline(always)]
pub(super) fn both([lo, hi]: [End; 2]) -> [i128; 2] {
    [units(lo), units(hi)]
}
