//! A factor with π in it, by which the numbers of a log become ticks or KΔ.

use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};
use passivity_core::{BigRational, Exact, Interval, Scalar};

use crate::ball::{Ball, over_power_of_two};
use crate::log::error::TraceError;
use crate::log::irrational::doubles::Halves;
use crate::log::numbers::{Kind, decimal};
use crate::log::running::near;
use crate::number::{MOST_DECIMALS, Number, power_of_ten};
use crate::reading::{Reading, Scaled};
use crate::span::{self, Span};

mod doubles;

/// A factor with π in it.
#[derive(Clone, Debug)]
pub(crate) struct Irrational {
    pub(crate) factor: Exact,
    /// Where it is.
    pub(crate) range: Interval<BigRational>,
    negative: bool,
    /// |factor|/10^k for short decimals, by k.
    by_decimals: Vec<Option<Mantissa>>,
    /// The same as doubles.
    halves: Vec<Halves>,
}

/// A number above `mantissa`/2^shift, by one unit of it at most.
#[derive(Clone, Copy, Debug)]
struct Mantissa {
    mantissa: u128,
    shift: u32,
}

impl Mantissa {
    /// As many bits as a product with 64 others leaves room for.
    const BITS: u64 = 120;

    /// Of a number in a range that is narrower than a unit; `None` where that cannot be had.
    fn of(lo: &BigRational, hi: &BigRational) -> Option<Self> {
        let bits = |x: &BigInt| i64::try_from(x.bits()).ok();
        let size = bits(lo.numer())? - bits(lo.denom())?;
        let shift = u32::try_from(i64::try_from(Self::BITS).ok()? - size).ok()?;
        let scaled =
            |x: &BigRational| (x * BigRational::from_integer(BigInt::from(1) << shift)).floor();
        let (below, above) = (scaled(lo), scaled(hi));
        let mantissa = below.to_integer().to_u128()?;
        (below == above && shift >= span::BITS).then_some(Self { mantissa, shift })
    }

    /// What n of it are, enclosed on the grid.
    #[inline]
    fn times(self, n: u64) -> Option<Span> {
        const WORD: u32 = 64;
        let shift = self.shift - span::BITS;
        let [upper, lower] = [self.mantissa >> WORD, self.mantissa & u128::from(u64::MAX)];
        let low = u128::from(n) * lower;
        // Below 2⁵⁶·2⁶⁴ and a little more. The product is high·2⁶⁴ and the lower half of low.
        let high = u128::from(n) * upper + (low >> WORD);
        let low = low & u128::from(u64::MAX);
        let product = match shift {
            0..WORD if high.leading_zeros() <= WORD - shift => return None,
            0..WORD => (high << (WORD - shift)) | (low >> shift),
            _ => high.checked_shr(shift - WORD).unwrap_or(0),
        };
        // What was cut off, and n times less than a unit of the mantissa.
        let above = 2 + n.checked_shr(shift).unwrap_or(0);
        let middle = i128::try_from(product).ok()?;
        let span = Span::centred(middle, above);
        span.defined().map(|_| span)
    }
}

/// A number in lowest terms as n over 10^k, with the least k; `None` of others.
fn over_tens(x: &Number) -> Option<(i64, u32)> {
    let (n, d) = match x {
        Number::Small(n, d) => (*n, u128::from(d.unsigned_abs())),
        Number::Big(x) => (x.numer().to_i64()?, x.denom().to_u128()?),
        Number::Tiny(..) => return None,
    };
    let twos = d.checked_ilog2().map(|_| d.trailing_zeros())?;
    let (mut rest, mut fives) = (d >> twos, 0);
    while rest % 5 == 0 {
        (rest, fives) = (rest / 5, fives + 1);
    }
    let k = twos.max(fives);
    let more = 2_i64
        .checked_pow(k - twos)?
        .checked_mul(5_i64.checked_pow(k - fives)?)?;
    (rest == 1).then_some((n.checked_mul(more)?, k))
}

impl Irrational {
    pub(crate) fn new(factor: Exact, range: Interval<BigRational>) -> Self {
        let [a, b] = [range.lo(), range.hi()].map(num_traits::Signed::abs);
        let (lo, hi) = (Ord::min(&a, &b), Ord::max(&a, &b));
        let by_decimals = (0..=MOST_DECIMALS).map(|k| {
            let power = BigRational::from_integer(BigInt::from(10).pow(k.into()));
            Mantissa::of(&(lo / &power), &(hi / &power))
        });
        let halves = (0..=MOST_DECIMALS).map(|k| {
            let over = range.lo() / BigRational::from_integer(BigInt::from(10).pow(k.into()));
            let nearest = near(&over);
            let rest = BigRational::from_float(nearest).map(|nearest| over - nearest);
            [nearest, rest.map_or(f64::NAN, |rest| near(&rest))]
        });
        Self {
            by_decimals: by_decimals.collect(),
            halves: halves.collect(),
            negative: range.lo().is_negative(),
            factor,
            range,
        }
    }

    /// A short decimal, scaled and enclosed; `None` for other numbers.
    fn short(&self, x: &Number) -> Option<Span> {
        let by = |decimals: u32| *self.by_decimals.get(usize::try_from(decimals).ok()?)?;
        let of_decimals = || {
            let (n, decimals) = over_tens(x)?;
            self.signed(n, by(decimals)?)
        };
        let (n, d) = match x {
            Number::Small(n, d) => (n, d),
            Number::Tiny(n, k) => return self.tiny(*n, *k),
            Number::Big(_) => return of_decimals(),
        };
        let decimals = d.ilog10();
        let by = if power_of_ten(decimals) == Some(*d) {
            by(decimals)?
        } else if d.is_positive() && d.count_ones() == 1 {
            let whole = by(0)?;
            Mantissa {
                shift: whole.shift + d.trailing_zeros(),
                ..whole
            }
        } else {
            return of_decimals();
        };
        self.signed(*n, by)
    }

    /// n/2^k, scaled and enclosed.
    fn tiny(&self, n: i64, k: u32) -> Option<Span> {
        let whole = (*self.by_decimals.first()?)?;
        let by = Mantissa {
            shift: whole.shift.checked_add(k)?,
            ..whole
        };
        self.signed(n, by)
    }

    fn signed(&self, n: i64, by: Mantissa) -> Option<Span> {
        let size = by.times(n.unsigned_abs())?;
        Some(match (n < 0) == self.negative {
            true => size,
            false => -size,
        })
    }

    /// What is known of n over 10^k as a position or a force; `None` where that takes longer to find out.
    #[inline]
    pub(crate) fn near(&self, kind: Kind, n: i64, k: u8) -> Option<Ball> {
        if n == 0 {
            return Some(Ball::whole(0));
        }
        let span = self.of_decimal(n, k)?;
        (kind == Kind::Force || span.is_within_a_tick()).then(|| Ball::of_span(span))
    }

    /// n over 10^k, n ≠ 0, scaled and enclosed, as [`short`](Self::short) does that.
    #[inline]
    fn of_decimal(&self, mut n: i64, mut k: u8) -> Option<Span> {
        if power_of_ten(k.into()).is_none() {
            // Such a number is read in lowest terms, whatever zeros end it.
            while k > 0 && n % 10 == 0 {
                (n, k) = (n / 10, k - 1);
            }
            if n % 5_i64.checked_pow(k.into())? == 0 {
                return self.short(&decimal(n, k));
            }
        }
        self.signed(n, (*self.by_decimals.get(usize::from(k))?)?)
    }

    /// The same of a double.
    #[inline]
    pub(crate) fn near_double(&self, kind: Kind, x: f64) -> Option<Ball> {
        if x == 0.0 {
            return Some(Ball::whole(0));
        }
        let span = self.short(&Number::from_f64(x)?)?;
        (kind == Kind::Force || span.is_within_a_tick()).then(|| Ball::of_span(span))
    }

    /// What [`near_double`](Self::near_double) finds of doubles, soonest: their middles and radii, with no number in the
    /// middle where that takes longer.
    pub(crate) fn of_several(&self, kind: Kind, values: &[f64], balls: (&mut [f64], &mut [f64])) {
        if let Some(halves) = self.halves.first() {
            doubles::balls(kind, values, *halves, balls);
        }
    }

    /// The same of [`near`](Self::near).
    pub(crate) fn of_decimals(
        &self,
        kind: Kind,
        decimals: (&[i64], &[u8]),
        balls: (&mut [f64], &mut [f64]),
    ) {
        doubles::balls_of_decimals(kind, decimals, &self.halves, balls);
    }

    /// What [`near_double`](Self::near_double) finds, sooner: of most doubles.
    ///
    /// A double is its digits over a power of two, which the product with the mantissa is cut off at. So none of it
    /// is to be brought to lowest terms first, and what is cut off is less than one unit of the grid.
    #[inline]
    pub(crate) fn of_double(&self, kind: Kind, x: f64) -> Option<Ball> {
        const WORD: u32 = 64;
        /// Within so many units of a tick, it is asked more closely which one it is in.
        const EDGE: u64 = 4;
        let by = self.by_decimals.first().copied().flatten()?;
        if x == 0.0 {
            return Some(Ball::whole(0));
        }
        let (digits, behind) = over_power_of_two(x)?;
        let shift = by.shift - span::BITS + behind;
        // Digits and mantissa are below 2⁵³ and 2¹²⁰: cut off here, the product has room.
        if !(WORD..2 * WORD).contains(&shift) {
            return None;
        }
        let [upper, lower] = [by.mantissa >> WORD, by.mantissa & u128::from(u64::MAX)];
        let low = u128::from(digits) * lower;
        let high = u128::from(digits) * upper + (low >> WORD);
        let product = high >> (shift - WORD);
        let within = (product as u64).wrapping_add(EDGE);
        if kind == Kind::Position && within < 2 * EDGE {
            return None;
        }
        // What was cut off, and less than a unit for that of the mantissa.
        let size = Span::centred(product.cast_signed(), 2);
        let is_below = x.is_sign_negative() != self.negative;
        Some(Ball::of_span(if is_below { -size } else { size }))
    }

    /// A position in ticks, enclosed within one of them.
    pub(crate) fn position(&self, x: Number) -> Result<Reading, TraceError> {
        if let Some(span) = self.short(&x)
            && span.is_within_a_tick()
            && !matches!(x, Number::Small(0, _))
        {
            return Ok(Reading::Within(Scaled::new(x, span)));
        }
        within_a_tick(x, &self.factor, &self.range)
    }

    /// A force in KΔ.
    pub(crate) fn force(&self, x: Number) -> Result<Reading, TraceError> {
        if matches!(x, Number::Small(0, _)) {
            return Ok(Reading::Exact(x));
        }
        if let Some(span) = self.short(&x) {
            return Ok(Reading::Within(Scaled::new(x, span)));
        }
        let written = x.to_rational();
        let range = Interval::hull(&written * self.range.lo(), &written * self.range.hi());
        enclosed(x, &range)
    }
}

/// x·`factor`, enclosed within one tick.
fn within_a_tick(
    x: Number,
    factor: &Exact,
    range: &Interval<BigRational>,
) -> Result<Reading, TraceError> {
    let written = x.to_rational();
    if written.is_zero() {
        return Ok(Reading::Exact(Number::whole(0)));
    }
    let fine = Interval::hull(&written * range.lo(), &written * range.hi());
    // No position is a whole number of ticks: π would be rational.
    let tick = match fine.lo().floor() == fine.hi().floor() {
        true => fine.lo().floor(),
        false => (Exact::of(&written) * factor.clone())
            .floor()
            .to_rational()
            .ok_or_else(|| {
                let message = "too close to the border between two ticks to tell which it is in";
                TraceError::new("position", message)
            })?,
    };
    let above = &tick + BigRational::one();
    // The enclosure may touch the next tick from below: that is its closure.
    let lo = Ord::max(fine.lo(), &tick).clone();
    let hi = Ord::min(fine.hi(), &above).clone();
    enclosed(x, &Interval::hull(lo, hi))
}

/// A number that is written as `x` and is in `range`.
fn enclosed(x: Number, range: &Interval<BigRational>) -> Result<Reading, TraceError> {
    match Span::around(range.lo(), range.hi()) {
        Some(span) => Ok(Reading::Within(Scaled::new(x, span))),
        None => {
            let message = format!("{x} is too large a number to compute with");
            Err(TraceError::new("number", message))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::pi;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_double_is_known_sooner_as_it_is_known_later(
            x in prop_oneof![prop::num::f64::ANY, -1e3..1e3, (-1000..1000_i32).prop_map(|n| f64::from(n) / 8.0)],
            counts in 1..100_000_i32, reversed: bool,
        ) {
            let sign = if reversed { -1 } else { 1 };
            let factor = Exact::of(&BigRational::new((sign * counts).into(), 2.into())).over(pi::pi());
            let range = factor.enclosure(256).unwrap();
            let by = Irrational::new(factor, range);
            for kind in [Kind::Position, Kind::Force] {
                let sooner = by.of_double(kind, x);
                // Below the grid, and from 2⁵³ on or so.
                prop_assert!(sooner.is_some() || !(1e-3..1e6).contains(&x.abs()));
                let (mut middle, mut radius) = ([0.0], [0.0]);
                by.of_several(kind, &[x], (&mut middle, &mut radius));
                let decided = (!middle[0].is_nan()).then(|| Ball::from_parts(middle[0], radius[0]));
                for found in [sooner, decided].into_iter().flatten() {
                    prop_assert_eq!(Some(found), by.near_double(kind, x));
                }
            }
        }

        #[test]
        fn a_short_decimal_is_enclosed_as_closely_as_by_big_numbers(
            n in prop_oneof![
                any::<i64>(), -10_000_000..10_000_000_i64, (1..900_i64, 0..16_u32).prop_map(|(n, k)| n * 10_i64.pow(k)),
                Just(5_i64.pow(27)),
            ],
            k in 0..=MOST_DECIMALS,
            counts in 1..100_000_i32, reversed: bool,
        ) {
            // A radian is N/2π ticks.
            let sign = if reversed { -1 } else { 1 };
            let factor = Exact::of(&BigRational::new((sign * counts).into(), 2.into())).over(pi::pi());
            let range = factor.enclosure(256).unwrap();
            let by = Irrational::new(factor, range.clone());
            let x = decimal(n, k);
            let Some(span) = by.short(&x) else {
                // Past 2⁶³ ticks.
                prop_assert!(u128::from(n.unsigned_abs()) / 10_u128.pow(k.into()) > 1 << 40);
                return Ok(());
            };
            let exact = Interval::hull(x.to_rational() * range.lo(), x.to_rational() * range.hi());
            let [lo, hi] = span.defined().unwrap();
            let at = |n: i128| BigRational::new(n.into(), (1_i128 << span::BITS).into());
            prop_assert!(at(lo) <= *exact.lo() && *exact.hi() <= at(hi));
            for kind in [Kind::Position, Kind::Force] {
                let read = match kind {
                    Kind::Position => by.position(x.clone()),
                    Kind::Force => by.force(x.clone()),
                };
                let near = by.near(kind, n, k);
                prop_assert!(near.is_none_or(|near| Some(near) == read.ok().map(|read| *read.to_near().lo())));
                let (mut middle, mut radius) = ([0.0], [0.0]);
                by.of_decimals(kind, (&[n], &[k]), (&mut middle, &mut radius));
                if !middle[0].is_nan() {
                    prop_assert_eq!(Some(Ball::from_parts(middle[0], radius[0])), by.near(kind, n, k));
                }
            }
            // A unit of the mantissa is at most a part in 2¹¹⁹ of it, and the radius is one more than that and
            // what was cut off.
            prop_assert!(hi - lo <= 4 + (hi.abs() >> 118));
        }
    }

    #[test]
    fn most_doubles_are_decided_several_at_a_time() {
        let factor = Exact::of(&BigRational::from_integer(4096.into())).over(pi::pi());
        let range = factor.enclosure(256).unwrap();
        let by = Irrational::new(factor, range);
        // Radians from 10 to 1300 ticks.
        let values: Vec<f64> = (1..1000).map(|i| f64::from(i) * 1.001e-3 + 7e-3).collect();
        let (mut middles, mut radii) = (vec![0.0; values.len()], vec![0.0; values.len()]);
        let mut open = |kind, values: &[f64]| {
            by.of_several(kind, values, (&mut middles, &mut radii));
            middles.iter().filter(|middle| middle.is_nan()).count()
        };
        // Above 8 doubles are 2^-49 apart: a part in 2^10 is within 2^-61 of a middle or of half that, on either side.
        let found = open(Kind::Position, &values);
        assert!(found < 10, "{found}");
        // Forces may be whole numbers of KΔ, as those of a wall that counts without half a tick are.
        let whole: Vec<f64> = (1..1000)
            .map(|n| f64::from(n) * (std::f64::consts::PI / 4096.0))
            .collect();
        let found = open(Kind::Force, &whole);
        assert!(found < 10, "{found}");
        assert_eq!(open(Kind::Position, &whole), whole.len());
    }

    #[test]
    fn counts_times_the_width_of_a_tick_are_known_to_be_in_one() {
        let factor = Exact::of(&BigRational::from_integer(4096.into())).over(pi::pi());
        let range = factor.enclosure(256).unwrap();
        let by = Irrational::new(factor, range);
        for n in (-3000..3000).filter(|n| *n != 0) {
            let x = f64::from(n) * (std::f64::consts::PI / 4096.0);
            let reading = by.position(Number::from_f64(x).unwrap()).unwrap();
            let tick = reading.to_rational().lo().floor();
            let (found, _) = reading.to_near().lo().floor().parts();
            assert_eq!(BigRational::from_float(found), Some(tick), "{n}");
            assert!(found == f64::from(n) || found == f64::from(n - 1));
            let sooner = by
                .of_double(Kind::Position, x)
                .or_else(|| by.near_double(Kind::Position, x));
            assert_eq!(sooner.as_ref(), Some(reading.to_near().lo()));
        }
    }
}
