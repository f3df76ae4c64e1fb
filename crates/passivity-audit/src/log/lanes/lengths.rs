//! How long intervals are.

use std::borrow::Cow;

use multiversion::multiversion;

use super::Column;
use crate::ball::{Ball, over_power_of_two};
use crate::log::chunk::Chunk;
use crate::log::exact::power;
use crate::log::layout::Layout;
use crate::log::numbers::{Numbers, all};
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
    let times = over_one_denominator(layout, &chunk.times);
    let known = times.map_or(0, |times| between(&times, lengths));
    for (i, length) in lengths.iter_mut().enumerate().skip(known) {
        *length = Length::of(layout, chunk, i);
    }
}

/// Times over one denominator, and what differences of them are in periods.
struct Times<'a> {
    numerators: Cow<'a, [i64]>,
    /// Each is this many
    factor: i64,
    /// over this.
    denominator: i64,
    /// The longest that are found together.
    longest: i64,
}

/// The times of a chunk over one power of ten, or one of two.
fn over_one_denominator<'a>(layout: &Layout, times: &'a Numbers) -> Option<Times<'a>> {
    let (numerators, one) = match times {
        Numbers::Decimals(numerators, powers) => {
            let first = powers.first()?;
            let numerators = all(powers, |power| power == first).then_some(numerators)?;
            (numerators.into(), power_of_ten((*first).into())?)
        }
        Numbers::Doubles(times) => {
            let (numerators, twos) = whole_numbers(times)?;
            (numerators.into(), power_of_two(twos)?)
        }
        Numbers::Any(_) => return None,
    };
    let (mut factor, mut denominator) = layout.periods_over(one)?;
    let mut longest = i64::MAX / factor;
    if let Numbers::Doubles(_) = times {
        // One by one these are in lowest terms, which most are doubles in.
        let twos = factor.trailing_zeros().min(denominator.trailing_zeros());
        (factor, denominator) = (factor >> twos, denominator >> twos);
        longest = (Length::MOST - 1) / factor;
        (denominator < Length::MOST).then_some(())?;
    }
    Some(Times {
        numerators,
        factor,
        denominator,
        longest,
    })
}

/// 2^k, where that has room.
fn power_of_two(k: u32) -> Option<i64> {
    (k < i64::BITS - 1).then(|| 1 << k)
}

/// Doubles as whole numbers over the least power of two, and which that is; `None` where they have no room.
fn whole_numbers(values: &[f64]) -> Option<(Vec<i64>, u32)> {
    // What makes the least of them a whole number makes the others whole too.
    let (_, twos) = over_power_of_two(least_size(values))?;
    let places = i32::try_from(twos).ok().filter(|k| *k < f64::MAX_EXP)?;
    let mut whole = vec![0; values.len()];
    let bits = scale(values, power(places), &mut whole)?;
    let zeros = bits.trailing_zeros().min(twos);
    for n in &mut whole {
        *n >>= zeros;
    }
    Some((whole, twos - zeros))
}

/// The size of the least number that is not zero.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least_size(values: &[f64]) -> f64 {
    let mut least = u64::MAX;
    for x in values {
        // The bits of sizes are in the order of these, and none are less than those of zero.
        least = least.min(x.abs().to_bits().wrapping_sub(1));
    }
    f64::from_bits(least.wrapping_add(1))
}

/// Multiplies doubles by a power of two that makes them whole numbers, and gives the bits of all of these; `None` where one
/// has no room.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[allow(clippy::cast_possible_truncation)] // of whole numbers nothing is cut off
fn scale(values: &[f64], by: f64, whole: &mut [i64]) -> Option<i64> {
    const LARGEST: f64 = (1_u64 << 62) as f64;
    let (mut bits, mut is_large) = (0, false);
    for (n, x) in whole.iter_mut().zip(values) {
        let product = x * by;
        is_large |= product.abs() >= LARGEST;
        *n = product as i64;
        bits |= *n;
    }
    (!is_large).then_some(bits)
}

/// The lengths of the intervals between these times, as [`Layout::periods`] has them: of how many, which is none where one of
/// them takes longer to find.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn between(times: &Times<'_>, lengths: &mut [Length]) -> usize {
    let Times {
        numerators,
        factor,
        denominator,
        longest,
    } = times;
    let Some((_, next)) = numerators.split_first() else {
        return 0;
    };
    let mut open = false;
    for ((from, to), length) in numerators.iter().zip(next).zip(lengths.iter_mut()) {
        // A difference that overflows is below zero, or one of times that are not in order.
        let dt = to.wrapping_sub(*from);
        open |= (to <= from) | (dt <= 0) | (dt > *longest);
        *length = Length(dt.wrapping_mul(*factor), *denominator);
    }
    match open {
        true => 0,
        false => next.len().min(lengths.len()),
    }
}

/// Sets a column to [`Length::near`] of these lengths.
pub(super) fn fill(lengths: &[Length], lasts: &mut Column) {
    if !near(lengths, lasts) {
        for (i, length) in lengths.iter().enumerate() {
            lasts.set(i, length.near());
        }
    }
}

/// [`Length::near`] of lengths over one denominator, of which all or none are doubles; whether that is all of them.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[allow(clippy::cast_precision_loss)] // nothing is lost
fn near(lengths: &[Length], lasts: &mut Column) -> bool {
    let Some(Length(_, d @ 1..)) = lengths.first() else {
        return false;
    };
    let odd = d >> d.trailing_zeros();
    let bits = i64::BITS - odd.leading_zeros();
    if bits >= f64::MANTISSA_DIGITS || *d >> f64::MANTISSA_DIGITS != 0 {
        return false;
    }
    let are_doubles = odd == 1;
    let roundings = if are_doubles { 0.0 } else { 1.0 };
    // Another quotient that is a double has as many digits less as there are in what is odd of the denominator.
    let behind = (1_u64 << (bits - 1)) - 1;
    let mut open = false;
    for (i, Length(n, own)) in lengths.iter().enumerate() {
        let middle = *n as f64 / *d as f64;
        lasts.set(i, Ball::rounded(middle, roundings));
        let is_double = middle.to_bits() & behind == 0;
        open |= (own != d) | (n >> f64::MANTISSA_DIGITS != 0) | (is_double != are_doubles);
    }
    !open
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use passivity_core::BigRational;
    use passivity_scene::Scene;
    use proptest::prelude::*;

    use super::super::TILE;
    use super::*;
    use crate::log::header::Heading;
    use crate::log::preview::Preview;
    use crate::log::step::duration;

    /// Of counts with times in seconds.
    fn layout(period: &str) -> Layout {
        let scene = format!(
            "[device]\ninertia = \"6e-6 kg m^2\"\nviscous = \"9e-6 N m s/rad\"\ncoulomb = \"0 N m\"\n[sampling]\nperiod = \"{period}\"\n\
             [encoder]\ncounts_per_revolution = 4096\n[wall]\nstiffness = \"1 N m/rad\"\n"
        );
        let scene = Scene::from_toml("s", &scene).unwrap();
        let headings = ["t [s]", "count"].map(|name| Heading::plain(name.to_owned()));
        Layout::read(headings.into(), None, &Preview::of_rows(&[]), &scene).unwrap()
    }

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
            in_order: bool,
            factor in prop_oneof![1..100_i64, 1..=i64::MAX],
        ) {
            let mut times = times;
            if in_order {
                times.sort_unstable();
            }
            let mut found = vec![Length(1, 2); times.len()];
            let together = Times { numerators: (&times).into(), factor, denominator: 7, longest: i64::MAX / factor };
            let len = between(&together, &mut found);
            let lengths: Option<Vec<Length>> = times.windows(2).map(|pair| {
                let dt = pair[1].checked_sub(pair[0]).filter(|dt| *dt > 0);
                dt.and_then(|dt| dt.checked_mul(factor)).map(|n| Length(n, 7))
            }).collect();
            let lengths = lengths.unwrap_or_default();
            prop_assert_eq!(&lengths, &found[..len]);
        }
    }

    proptest! {
        #[test]
        fn doubles_are_whole_numbers_over_a_power_of_two(
            values in prop::collection::vec(prop_oneof![
                (any::<u32>(), 0..70_u32).prop_map(|(n, k)| f64::from(n) / 2_f64.powi(k as i32)),
                (1.0..2000.0_f64), Just(0.0), prop::num::f64::NORMAL,
            ], 1..20),
        ) {
            if let Some((whole, twos)) = whole_numbers(&values) {
                for (n, x) in whole.iter().zip(&values) {
                    let ratio = BigRational::new((*n).into(), BigInt::from(1) << twos);
                    prop_assert_eq!(BigRational::from_float(*x).unwrap(), ratio);
                }
                // None that is less would do.
                prop_assert!(twos == 0 || whole.iter().any(|n| n % 2 != 0));
            }
        }
    }

    proptest! {
        #[test]
        fn lengths_between_doubles_are_what_each_is_alone(
            start in prop_oneof![Just(0.0), 0.001..2000.0_f64, Just(1.7e9)],
            steps in prop::collection::vec(prop_oneof![Just(1_000_000_u32), 900_000..1_100_000_u32, 1..2_000_000_000_u32], 1..30),
            period in prop_oneof![Just("1 ms"), Just("3 ms"), Just("400 us"), Just("1 s")],
        ) {
            let mut t = start;
            let times: Vec<f64> = steps.iter().map(|dt| { t += f64::from(*dt) * 1e-9; t }).collect();
            let layout = layout(period);
            // Both ways are gone: of times near zero, or far apart, there is no one denominator.
            let is_short = start >= 0.001 && steps.iter().all(|dt| *dt < 2_000_000);
            prop_assert!(!is_short || over_one_denominator(&layout, &Numbers::Doubles(times.clone())).is_some());
            let chunk = Chunk { times: Numbers::Doubles(times.clone()), ..Chunk::default() };
            let mut lengths = vec![Length::OPEN; times.len() - 1];
            find(&layout, &chunk, &mut lengths);
            for (i, length) in lengths.iter().enumerate() {
                if *length != Length::OPEN {
                    let exact = duration(&layout, &chunk, i).unwrap().unwrap();
                    prop_assert_eq!(BigRational::new(length.0.into(), length.1.into()), exact.to_rational());
                }
                let alone = Length::of(&layout, &chunk, i);
                if alone != Length::OPEN {
                    prop_assert_eq!(length.near().parts(), alone.near().parts());
                    prop_assert_eq!(length.nearest(), alone.nearest());
                }
            }
        }
    }

    #[test]
    fn lengths_in_nanoseconds_are_found_several_at_a_time() {
        let lengths = [999_731, 1_000_001, 1_012_347].map(|n| Length(n, 1_000_000));
        assert!(near(&lengths, &mut { Column::ZERO }));
    }
}
