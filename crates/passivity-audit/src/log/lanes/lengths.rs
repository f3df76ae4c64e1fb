//! How long intervals are.

use multiversion::multiversion;

use super::Column;
use crate::ball::Ball;
use crate::log::chunk::Chunk;
use crate::log::layout::Layout;
use crate::log::numbers::Numbers;
use crate::log::step::periods;
use crate::number::power_of_ten;

/// How long an interval is, in periods, as a fraction; nothing where that is left open.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Length(pub(crate) i64, pub(crate) i64);

impl Length {
    pub(crate) const OPEN: Self = Self(0, 0);

    /// Up to here whole numbers are doubles.
    const MOST: i64 = 1 << f64::MANTISSA_DIGITS;

    /// Of the interval that starts at sample `i` of a chunk.
    #[inline]
    pub(crate) fn of(layout: &Layout, chunk: &Chunk, i: usize) -> Self {
        periods(layout, chunk, i).map_or(Self::OPEN, |(n, d)| Self(n, d))
    }

    #[inline]
    fn near(self) -> Ball {
        match self.1 {
            0 => Ball::UNDEFINED,
            _ => Ball::ratio(self.0, self.1),
        }
    }

    /// The nearest double, where both numbers in lowest terms are doubles.
    #[inline(always)]
    #[allow(clippy::cast_precision_loss)] // nothing is lost
    pub(crate) fn nearest(self) -> Option<f64> {
        let Self(mut n, mut d) = self;
        if n >= Self::MOST || d >= Self::MOST {
            let divisor = num_integer::gcd(n, d);
            (n, d) = (n / divisor, d / divisor);
        }
        Self(n, d).is_short().then(|| n as f64 / d as f64)
    }

    /// Whether both numbers are above zero, and doubles.
    #[inline(always)]
    pub(super) const fn is_short(self) -> bool {
        let Self(n, d) = self;
        (n > 0) & (d > 0) & (n < Self::MOST) & (d < Self::MOST)
    }
}

/// Finds how long the first intervals of a chunk are.
pub(super) fn find(layout: &Layout, chunk: &Chunk, lengths: &mut [Length]) {
    let times = decimals(layout, &chunk.times);
    let known = times.map_or(0, |(times, over)| between(times, over, lengths));
    for (i, length) in lengths.iter_mut().enumerate().skip(known) {
        *length = Length::of(layout, chunk, i);
    }
}

/// Times over one power of ten, and what [periods](Layout::periods_over) of them are made with.
fn decimals<'a>(layout: &Layout, times: &'a Numbers) -> Option<(&'a [i64], (i64, i64))> {
    let Numbers::Decimals(numerators, powers) = times else {
        return None;
    };
    let first = powers.first()?;
    // Of several at a time it is asked whether all of them are the same.
    let alike = powers
        .iter()
        .fold(true, |all, power| all & (power == first));
    let over = layout.periods_over(power_of_ten((*first).into())?)?;
    alike.then_some((numerators, over))
}

/// The lengths of the intervals between these times, as [`Layout::periods`] has them: of how many.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn between(times: &[i64], (factor, denominator): (i64, i64), lengths: &mut [Length]) -> usize {
    let Some((_, next)) = times.split_first() else {
        return 0;
    };
    let longest = i64::MAX / factor;
    for ((from, to), length) in times.iter().zip(next).zip(lengths.iter_mut()) {
        // A difference that overflows is below zero, or one of times that are not in order.
        let dt = to.wrapping_sub(*from);
        let is_known = (to > from) & (dt > 0) & (dt <= longest);
        let known = |n: i64| if is_known { n } else { 0 };
        *length = Length(known(dt.wrapping_mul(factor)), known(denominator));
    }
    next.len().min(lengths.len())
}

/// Sets a column to [`Length::near`] of these lengths.
pub(super) fn fill(lengths: &[Length], lasts: &mut Column) {
    if !near(lengths, lasts) {
        for (i, length) in lengths.iter().enumerate() {
            lasts.set(i, length.near());
        }
    }
}

/// [`Length::near`] of lengths over one denominator, of which none may be a double; whether that is all of them.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[allow(clippy::cast_precision_loss)] // nothing is lost
fn near(lengths: &[Length], lasts: &mut Column) -> bool {
    let Some(Length(_, d @ 1..)) = lengths.first() else {
        return false;
    };
    let odd = d >> d.trailing_zeros();
    let bits = i64::BITS - odd.leading_zeros();
    if odd == 1 || bits >= f64::MANTISSA_DIGITS || *d >> f64::MANTISSA_DIGITS != 0 {
        return false;
    }
    // A quotient that is a double has as many digits less as there are in what is odd of the denominator.
    let behind = (1_u64 << (bits - 1)) - 1;
    let mut open = false;
    for (i, Length(n, own)) in lengths.iter().enumerate() {
        let middle = *n as f64 / *d as f64;
        lasts.set(i, Ball::rounded(middle, 1.0));
        open |= (own != d) | (n >> f64::MANTISSA_DIGITS != 0) | (middle.to_bits() & behind == 0);
    }
    !open
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::TILE;
    use super::*;

    proptest! {
        #[test]
        fn lengths_are_near_what_each_is_alone(
            lengths in prop::collection::vec((1..3000_i64, 0..50_u32), 1..TILE),
            d in prop_oneof![1..2000_i64, Just(1_000_000), Just(1 << 40), Just((1 << 52) + 2), any::<i64>()],
            other in prop_oneof![Just(None), (1..TILE).prop_map(Some)],
        ) {
            let mut lengths: Vec<Length> = lengths.iter().map(|(n, k)| Length(n << k, d)).collect();
            if let Some(length) = other.and_then(|i| lengths.get_mut(i)) {
                length.1 = 999;
            }
            let mut lasts = Column::ZERO;
            if near(&lengths, &mut lasts) {
                for (i, length) in lengths.iter().enumerate() {
                    prop_assert_eq!(lasts.get(i).parts(), length.near().parts());
                }
            }
        }
    }

    proptest! {
        #[test]
        fn lengths_between_times_are_found_together_as_one_by_one(
            times in prop::collection::vec(prop_oneof![0..3000_i64, any::<i64>(), Just(i64::MIN), Just(i64::MAX)], 0..20),
            factor in prop_oneof![1..100_i64, 1..=i64::MAX],
        ) {
            let mut found = vec![Length(1, 2); times.len()];
            let len = between(&times, (factor, 7), &mut found);
            prop_assert_eq!(len, times.len().saturating_sub(1));
            for (pair, found) in times.windows(2).zip(&found) {
                let dt = pair[1].checked_sub(pair[0]).filter(|dt| *dt > 0);
                let length = dt.and_then(|dt| dt.checked_mul(factor)).map(|n| Length(n, 7));
                prop_assert_eq!(length.unwrap_or(Length::OPEN), *found);
            }
        }
    }

    #[test]
    fn lengths_in_nanoseconds_are_found_several_at_a_time() {
        let lengths = [999_731, 1_000_001, 1_012_347].map(|n| Length(n, 1_000_000));
        assert!(near(&lengths, &mut { Column::ZERO }));
    }
}
