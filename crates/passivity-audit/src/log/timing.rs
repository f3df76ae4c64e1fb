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
    pub(crate) first_missed: Option<u64>,
    /// The shortest and the longest.
    pub(crate) range: Option<[Number; 2]>,
}

impl Timing {
    /// Counts the interval `h`.
    pub(crate) fn add(&mut self, dtau: &Number, h: u64) {
        const ONE: Number = Number::whole(1);
        /// From here on, a sample is missing.
        const MISSING: Number = Number::Small(3, 2);
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
                self.first_missed.get_or_insert(h);
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
        let ([shortest, longest], [uneven, late]) = of_one.unwrap_or_else(|| {
            let (mut shortest, mut longest) = (*first, *first);
            let [mut uneven, mut late] = [0, 0];
            for length in lengths {
                let Length(n, d) = length;
                if is_shorter(length, &shortest) {
                    shortest = *length;
                }
                if is_shorter(&longest, length) {
                    longest = *length;
                }
                uneven += u64::from(n != d);
                late += u64::from(n > d);
            }
            ([shortest, longest], [uneven, late])
        });
        if i128::from(longest.0) * 2 >= i128::from(longest.1) * 3 {
            // A sample is missing.
            for (Length(n, d), h) in lengths.iter().zip(h..) {
                self.add(&Number::Small(*n, *d), h);
            }
            return;
        }
        self.uneven += uneven;
        self.late += late;
        let range = [shortest, longest].map(|Length(n, d)| Number::Small(n, d));
        self.widen(range.each_ref());
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
        self.missed = self.missed.saturating_add(other.missed);
        let mut first = First(self.first_missed);
        first.append(First(other.first_missed), before);
        self.first_missed = first.0;
        if let Some([shortest, longest]) = &other.range {
            self.widen([shortest, longest]);
        }
    }
}

/// The shortest and the longest of some lengths, and how many are not one period and longer than that, where all have the
/// denominator of the first: decimals with as many digits do.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn over_one_denominator(lengths: &[Length], first: Length) -> Option<([Length; 2], [u64; 2])> {
    let Length(n, one) = first;
    let (mut shortest, mut longest) = (n, n);
    let [mut uneven, mut late, mut others] = [0_u64; 3];
    for Length(n, d) in lengths {
        shortest = shortest.min(*n);
        longest = longest.max(*n);
        // There are not as many as to overflow.
        uneven = uneven.wrapping_add(u64::from(*n != one));
        late = late.wrapping_add(u64::from(*n > one));
        others |= u64::from(*d != one);
    }
    let ends = [Length(shortest, one), Length(longest, one)];
    (others == 0).then_some((ends, [uneven, late]))
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
            lengths in prop::collection::vec((1..40_i64, 0..4_u32), 0..40), same: bool, h: u32,
        ) {
            // About a period, over powers of two or over one denominator.
            let length = |(n, k): &(i64, u32)| Length(n + 10, if same { 20 } else { 8 << k });
            let lengths: Vec<Length> = lengths.iter().map(length).collect();
            let (mut one, mut all) = (Timing::default(), Timing::default());
            for (Length(n, d), h) in lengths.iter().zip(u64::from(h)..) {
                one.add(&Number::Small(*n, *d), h);
            }
            all.add_all(&lengths, h.into());
            prop_assert_eq!((one.uneven, one.late, one.missed), (all.uneven, all.late, all.missed));
            prop_assert_eq!((one.first_missed, one.range), (all.first_missed, all.range));
        }
    }
}
