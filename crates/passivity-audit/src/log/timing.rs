//! The durations of the intervals of a trace: uneven, late and missed samples.

use multiversion::multiversion;
use num_traits::ToPrimitive as _;
use passivity_core::course::First;

use crate::log::lanes::Length;
use crate::number::{Number, difference, is_less, is_positive};

/// How long intervals were.
#[derive(Clone, Debug, Default)]
pub(crate) struct Timing {
    /// Intervals of another length than one period.
    pub(crate) uneven: u64,
    /// Intervals longer than one period.
    pub(crate) late: u64,
    /// Samples that are missing: whole periods beyond the first, to the nearest.
    pub(crate) missed: u64,
    /// Intervals in which a sample is missing.
    pub(crate) gaps: u64,
    pub(crate) first_missed: Option<u64>,
    /// The shortest and the longest.
    pub(crate) range: Option<[Number; 2]>,
    /// Intervals of at most as many periods as [`SHORT`] has.
    pub(crate) short: [u64; 2],
}

/// How long, in periods, intervals are at the most of a clock that is too fast, and of a log with several rows of a sample.
///
/// - Milliseconds for seconds are a thousand times too fast, minutes for seconds sixty times.
/// - Of a log with one row a period intervals last a period on average: if 9 of 10 took no more than 3/4 of one, the others
///   would take more than three. Several rows of a sample are at most half a period apart on average, and may jitter.
pub(crate) const SHORT: [(i64, i64); 2] = [(1, 32), (3, 4)];

/// How long, in periods, an interval is at the least in which a sample is missing.
pub(crate) const GAP: (i64, i64) = (3, 2);

/// The largest numerators of lengths over a denominator that are as short as [`SHORT`] says.
#[inline(always)]
const fn most_short(one: i64) -> [i64; 2] {
    // Down from a fraction of what need not be a multiple of it, without a product that could overflow.
    let below = one - 1;
    [one >> 5, below - (below >> 2)]
}

impl Timing {
    /// Counts the interval `h`.
    pub(crate) fn add(&mut self, dtau: &Number, h: u64) {
        const ONE: Number = Number::whole(1);
        /// A sample is missing from here on.
        const MISSING: Number = Number::Small(GAP.0, GAP.1);
        // The denominator is above zero.
        let is_one = matches!(dtau, Number::Small(n, d) if n == d);
        if !is_one {
            self.uneven += 1;
            if is_less(&ONE, dtau) {
                self.late += 1;
            }
            if !is_less(dtau, &MISSING) {
                let missed = nearest(&difference(dtau, &ONE));
                self.missed = self.missed.saturating_add(missed);
                self.gaps += 1;
                self.first_missed.get_or_insert(h);
            }
            for (count, (n, d)) in self.short.iter_mut().zip(SHORT) {
                *count += u64::from(!is_less(&Number::Small(n, d), dtau));
            }
        }
        self.widen([dtau, dtau]);
    }

    /// Counts intervals of these lengths, as fractions of two positive numbers, from the interval `h` on.
    pub(crate) fn add_all(&mut self, lengths: &[Length], h: u64) {
        let Some(first) = lengths.first() else {
            return;
        };
        let of_one = over_one_denominator(lengths, *first);
        let ([shortest, longest], [uneven, late, very, rather]) = of_one.unwrap_or_else(|| {
            let (mut shortest, mut longest) = (*first, *first);
            let mut counts = [0; 4];
            for length in lengths {
                let Length(n, d) = length;
                if is_shorter(length, &shortest) {
                    shortest = *length;
                }
                if is_shorter(&longest, length) {
                    longest = *length;
                }
                count(&mut counts, *n, *d, most_short(*d));
            }
            ([shortest, longest], counts)
        });
        if i128::from(longest.0) * i128::from(GAP.1) >= i128::from(longest.1) * i128::from(GAP.0) {
            // A sample is missing.
            for (Length(n, d), h) in lengths.iter().zip(h..) {
                self.add(&Number::Small(*n, *d), h);
            }
            return;
        }
        self.uneven += uneven;
        self.late += late;
        add_to(&mut self.short, [very, rather]);
        let range = [shortest, longest].map(|Length(n, d)| Number::Small(n, d));
        self.widen(range.each_ref());
    }

    /// Whether samples are missing on the whole: in at least half of so many intervals, less those that are short as
    /// [`SHORT`] says. Of rows that come in pairs every second interval is long, every other one as short, and none is missing.
    pub(crate) const fn is_sparse(&self, intervals: u64) -> bool {
        let [_, rather] = self.short;
        // One alone may be a pause.
        self.gaps >= 2 && 2 * self.gaps.saturating_sub(rather) >= intervals
    }

    fn widen(&mut self, [shortest, longest]: [&Number; 2]) {
        match &mut self.range {
            None => self.range = Some([shortest.clone(), longest.clone()]),
            Some([least, most]) => {
                if is_less(shortest, least) {
                    *least = shortest.clone();
                }
                if is_less(most, longest) {
                    *most = longest.clone();
                }
            }
        }
    }

    /// Adds the intervals that came after the first `before`.
    pub(crate) fn append(&mut self, other: Self, before: u64) {
        self.uneven += other.uneven;
        self.late += other.late;
        add_to(&mut self.short, other.short);
        self.missed = self.missed.saturating_add(other.missed);
        self.gaps += other.gaps;
        let mut first = First(self.first_missed);
        first.append(First(other.first_missed), before);
        self.first_missed = first.0;
        if let Some([shortest, longest]) = &other.range {
            self.widen([shortest, longest]);
        }
    }
}

fn add_to(counts: &mut [u64; 2], others: [u64; 2]) {
    for (count, other) in counts.iter_mut().zip(others) {
        *count += other;
    }
}

/// Counts a length that is not one period, one that is longer, and those that are [`SHORT`].
#[inline(always)]
fn count([uneven, late, very, rather]: &mut [u64; 4], n: i64, one: i64, short: [i64; 2]) {
    // There are not as many as to overflow.
    *uneven = uneven.wrapping_add(u64::from(n != one));
    *late = late.wrapping_add(u64::from(n > one));
    *very = very.wrapping_add(u64::from(n <= short[0]));
    *rather = rather.wrapping_add(u64::from(n <= short[1]));
}

/// The shortest and the longest of some lengths, and what [`count`] counts of them, where all have the denominator of the
/// first: decimals with as many digits do.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn over_one_denominator(lengths: &[Length], first: Length) -> Option<([Length; 2], [u64; 4])> {
    let Length(n, one) = first;
    let (mut shortest, mut longest) = (n, n);
    let (mut counts, mut others) = ([0; 4], 0_u64);
    let short = most_short(one);
    for Length(n, d) in lengths {
        shortest = shortest.min(*n);
        longest = longest.max(*n);
        count(&mut counts, *n, one, short);
        others |= u64::from(*d != one);
    }
    let ends = [Length(shortest, one), Length(longest, one)];
    (others == 0).then_some((ends, counts))
}

/// Whether one length is less than another.
#[inline(always)]
fn is_shorter(Length(n, d): &Length, Length(m, e): &Length) -> bool {
    i128::from(*n) * i128::from(*e) < i128::from(*m) * i128::from(*d)
}

/// The nearest whole number, at least 0 and at most the largest of 64 bits.
fn nearest(x: &Number) -> u64 {
    let rounded = match x {
        Number::Small(n, d) => {
            let (n, d) = (i128::from(*n), i128::from(*d));
            num_integer::Integer::div_floor(&(2 * n + d), &(2 * d)).into()
        }
        x => x.to_rational().round().to_integer(),
    };
    match rounded.to_u64() {
        Some(n) => n,
        None if is_positive(x) => u64::MAX,
        None => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn lengths_are_counted_together_as_one_by_one(
            lengths in prop::collection::vec((1..40_i64, 0..4_u32), 0..40), same: bool, h: u32, one in 12..1400_i64,
        ) {
            // From some 1/64 of a period to some periods, over powers of two and over one denominator.
            let length = |(n, k): &(i64, u32)| Length(*n, if same { one } else { 8 << (2 * k) });
            let lengths: Vec<Length> = lengths.iter().map(length).collect();
            let (mut one, mut all) = (Timing::default(), Timing::default());
            for (Length(n, d), h) in lengths.iter().zip(u64::from(h)..) {
                one.add(&Number::Small(*n, *d), h);
            }
            all.add_all(&lengths, h.into());
            prop_assert_eq!((one.uneven, one.late, one.missed, one.gaps, one.short), (all.uneven, all.late, all.missed, all.gaps, all.short));
            prop_assert_eq!((one.first_missed, one.range), (all.first_missed, all.range));
        }
    }
}
