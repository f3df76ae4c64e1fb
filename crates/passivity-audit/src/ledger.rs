//! Rows on machine integers where they fit, on big integers where they do not: the same answers.

use num_integer::Integer as _;
use passivity_core::verdict::End;
use passivity_core::{BigRational, Effect, Exact, Fixed, Interval, Loop, Truth, Wide, rational};
use passivity_scene::Scene;

use crate::ball::Ball;
use crate::ends::{Ends, NotExact};
use crate::entry::{Entry, Recorded, entry};
use crate::figure::Figure;
use crate::number::{Ample, Number, Written};
use crate::reading::Reading;
use crate::sum::FigureSum;

/// A loop ready to account for intervals.
///
/// # Example
///
/// ```
/// use passivity_core::{Friction, Interval, Loop, Truth};
/// use passivity_audit::{Ledger, Logged, Number, Reading};
///
/// let three_fifths = Number::Small(3, 5).to_rational();
/// let plain = Loop::plain(Friction::new(three_fifths.clone(), three_fifths));
/// let ledger = Ledger::new(&plain.map(|_, x| Interval::point(x.clone()))).unwrap();
/// let at = |text| Reading::Exact(Number::parse(text).unwrap());
/// let interval = Logged { samples: vec![at("1")], end: at("1/2"), dtau: Number::whole(1), force: None };
/// let row = ledger.row(&interval).unwrap();
/// assert_eq!(row.truths().violates_quantized, Truth::Holds);
/// ```
#[derive(Clone, Debug)]
pub struct Ledger {
    fixed: Option<Ends<Fixed>>,
    wide: Ends<Wide>,
    ample: Ends<Ample>,
    near: Ends<Ball>,
}

/// A sampling interval of a trace, with all that its row is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct Logged {
    /// The samples up to its start, the latest first: as many as the loop remembers.
    pub samples: Vec<Reading>,
    /// Where it ends.
    pub end: Reading,
    /// Δτ, in sampling periods.
    pub dtau: Number,
    /// The force that was applied, in KΔ; `None` for that of the loop's controller.
    pub force: Option<Reading>,
}

/// A row on whichever integers it needed.
#[derive(Clone, Debug)]
pub enum Row {
    /// On 128-bit integers.
    Fixed(Box<Entry<Fixed>>),
    /// On whole numbers of any size.
    Wide(Box<Entry<Ample>>),
}

/// What a row answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Truths {
    /// Whether the criterion holds at the mean speed.
    pub criterion_holds: Truth,
    /// Whether the linear account is short.
    pub violates_linear: Truth,
    /// Whether the quantized account is short.
    pub violates_quantized: Truth,
}

impl Ledger {
    /// The ledger of a dimensionless loop, whose friction may lie anywhere in its intervals.
    ///
    /// # Errors
    ///
    /// [`NotExact`] when something else than friction is an interval.
    pub fn new(dimensionless: &Loop<Interval<BigRational>>) -> Result<Self, NotExact> {
        let ends = Ends::of(dimensionless)?;
        Ok(Self {
            fixed: ends.to_fixed(),
            near: ends.to_near(),
            wide: ends.to_wide(),
            ample: ends.to_ample(),
        })
    }

    /// The ledger of a scene: its friction in ticks over all tolerances, with π enclosed; other
    /// parameters at their nominal values. Of a scene with filtered damping or a controller of its own it
    /// is the ledger of the wall's spring.
    #[must_use]
    pub fn of_scene(scene: &Scene) -> Self {
        let bounds = scene.bounds();
        let hardest = bounds.at(End::Hardest).friction();
        let easiest = bounds.at(End::Easiest).friction();
        let mut dimensionless = scene.point().at.map(|_, x| Interval::point(x.clone()));
        for (slot, lo, hi) in [
            (&mut dimensionless.viscous, hardest.beta, easiest.beta),
            (&mut dimensionless.coulomb, hardest.sigma, easiest.sigma),
        ] {
            *slot = slot.as_ref().map(|_| outward(&lo, &hi));
        }
        // What these remember is not in a log: the forces that it has are accounted for against the
        // wall's spring.
        if scene.has(Effect::DampingFilter) || scene.has(Effect::Controller) {
            dimensionless = Loop {
                damping: None,
                damping_time_constant: None,
                controller: None,
                delay: 0,
                ..dimensionless
            };
        }
        match Self::new(&dimensionless) {
            Ok(ledger) => ledger,
            Err(error) => unreachable!("only friction is an interval here: {error}"),
        }
    }

    /// The loop over machine integers, when its numbers fit.
    #[must_use]
    pub const fn fixed(&self) -> Option<&Ends<Fixed>> {
        self.fixed.as_ref()
    }

    /// The loop over big integers.
    #[must_use]
    pub const fn wide(&self) -> &Ends<Wide> {
        &self.wide
    }

    /// The loop over whole numbers of any size.
    #[must_use]
    pub const fn ample(&self) -> &Ends<Ample> {
        &self.ample
    }

    /// Whether a row depends on nothing but its two positions.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.wide.is_plain()
    }

    /// Whether the force, or what is stored, depends on samples before the present one.
    #[must_use]
    pub fn has_memory(&self) -> bool {
        self.wide.controller.memory() > 0
    }

    /// How many samples, up to the start of an interval, its row depends on: the storage of a
    /// delay looks one displacement further back than the force.
    #[must_use]
    pub fn window(&self) -> usize {
        match self.wide.controller.memory() {
            0 => 1,
            memory => memory + 2,
        }
    }

    /// The row of an interval; `None` for no samples or a Δτ that is not above zero.
    #[must_use]
    pub fn row(&self, interval: &Logged) -> Option<Row> {
        let dtau = interval.dtau.to_fixed();
        let fixed = self.fixed.as_ref().zip(dtau).and_then(|(ends, dtau)| {
            let row = |known: &dyn Fn(&Reading) -> Option<Figure<Fixed>>| {
                interval.read().row(ends, self.window(), &dtau, known)
            };
            // Over one denominator sums of positions and forces are no longer fractions than these.
            let common = interval.denominator();
            let over_common = common.and_then(|common| row(&|reading| reading.over(common)));
            over_common.or_else(|| row(&Reading::to_fixed))
        });
        match fixed {
            Some(entry) => Some(Row::Fixed(Box::new(entry))),
            None => Some(Row::Wide(Box::new(self.wide_entry(interval)?))),
        }
    }

    /// The row of an interval on whole numbers of any size.
    pub(crate) fn wide_entry(&self, interval: &Logged) -> Option<Entry<Ample>> {
        let wide = |reading: &Reading| Some(reading.to_ample());
        interval
            .read()
            .row(&self.ample, self.window(), &interval.dtau.to_ample(), wide)
    }

    /// The row of an interval, enclosed by doubles; `None` where these leave something open that exact numbers
    /// decide.
    pub(crate) fn near_entry<'r, R>(&self, read: Read<'r, R>, dtau: &Number) -> Option<Entry<Ball>>
    where
        R: Iterator<Item = &'r Reading>,
    {
        let near = |reading: &Reading| Some(reading.to_near());
        read.row(&self.near, self.window(), &Ball::of(dtau), near)
    }

    /// The loop in doubles.
    pub(crate) const fn near(&self) -> &Ends<Ball> {
        &self.near
    }
}

/// What was read of an interval.
pub(crate) struct Read<'r, R> {
    /// The samples up to its start, the latest first.
    pub(crate) samples: R,
    pub(crate) end: &'r Reading,
    pub(crate) force: Option<&'r Reading>,
}

impl Logged {
    /// The least denominator of all short fractions among positions and force, where 64 bits hold it.
    fn denominator(&self) -> Option<i64> {
        let readings = self.samples.iter().chain([&self.end]).chain(&self.force);
        let mut denominators = readings.filter_map(|reading| match reading {
            Reading::Exact(Number::Small(_, d)) => Some(*d),
            _ => None,
        });
        let first = denominators.next()?;
        denominators.try_fold(first, |all, d| match all % d {
            0 => Some(all),
            _ => all.checked_mul(d / all.gcd(&d)),
        })
    }

    pub(crate) fn read(&self) -> Read<'_, std::slice::Iter<'_, Reading>> {
        Read {
            samples: self.samples.iter(),
            end: &self.end,
            force: self.force.as_ref(),
        }
    }
}

impl<'r, R: Iterator<Item = &'r Reading>> Read<'r, R> {
    /// The row on one kind of numbers; `None` when one of them is undefined.
    fn row<S: Written>(
        mut self,
        ends: &Ends<S>,
        window: usize,
        dtau: &S,
        known: impl Fn(&Reading) -> Option<Figure<S>>,
    ) -> Option<Entry<S>> {
        let start = self.samples.next()?;
        let still = start.is_same(self.end);
        let (xi0, xi1) = (known(start)?, known(self.end)?);
        // Of what stands still, any position that it may have stands for all.
        let at = |figure: &Figure<S>| match still {
            true => Figure::Exact(figure.lo().one_of()),
            false => figure.clone(),
        };
        let one = [at(&xi0)];
        let several: Vec<Figure<S>>;
        let samples = match window {
            1 => &one[..],
            window => {
                let earlier = self.samples.take(window - 1).map(&known);
                several = one
                    .into_iter()
                    .map(Some)
                    .chain(earlier)
                    .collect::<Option<_>>()?;
                &several
            }
        };
        let force = match self.force {
            Some(force) => Some(known(force)?),
            None => None,
        };
        let recorded = Recorded {
            samples,
            end: &at(&xi1),
            dtau,
            force: force.as_ref(),
        };
        let entry = entry(ends, &recorded)?;
        Some(Entry { xi0, xi1, ..entry })
    }
}

/// A rational interval that holds both numbers, which are not negative: they themselves, or, with a π
/// in them that does not cancel, short numbers close by, which machine integers compute with.
fn outward(lo: &Exact, hi: &Exact) -> Interval<BigRational> {
    /// How close: relative to the number, as a power of two.
    const BITS: u32 = 47;
    let Some((lo, hi)) = lo.enclosure(2 * BITS).zip(hi.enclosure(2 * BITS)) else {
        unreachable!("a scene's numbers are defined: its units are above zero")
    };
    let near = BigRational::new(1.into(), num_bigint::BigInt::from(1) << BITS);
    let below = match lo.is_point() {
        true => lo.lo().clone(),
        false => simplest(&(lo.lo() - lo.lo() * &near), lo.lo()),
    };
    let above = match hi.is_point() {
        true => hi.hi().clone(),
        false => simplest(hi.hi(), &(hi.hi() + hi.hi() * near)),
    };
    Interval::hull(below, above)
}

/// The fraction with the smallest denominator in [lo, hi], 0 < lo < hi.
fn simplest(lo: &BigRational, hi: &BigRational) -> BigRational {
    let above = rational::simplest_above(lo, hi);
    match lo.denom() <= above.denom() {
        true => lo.clone(),
        false => above,
    }
}

/// Runs an expression on the entry inside a row, whatever its integers.
macro_rules! on_entry {
    ($row:expr, $entry:ident => $body:expr) => {
        match $row {
            Row::Fixed($entry) => $body,
            Row::Wide($entry) => $body,
        }
    };
}
pub(crate) use on_entry;

impl Row {
    /// What the row answers.
    #[must_use]
    pub fn truths(&self) -> Truths {
        on_entry!(self, entry => entry.truths())
    }

    /// `net_linear`, in lowest terms.
    #[must_use]
    pub fn net_linear(&self) -> Option<Figure<BigRational>> {
        on_entry!(self, entry => entry.account.net_linear.try_map(Written::to_rational))
    }

    /// The five figures that totals are kept of, in lowest terms.
    pub(crate) fn figures(&self) -> Option<[Figure<BigRational>; 5]> {
        on_entry!(self, entry => {
            let [a, b, c, d, e] = entry.summed().map(|figure| figure.try_map(Written::to_rational));
            Some([a?, b?, c?, d?, e?])
        })
    }

    /// E_gᴸ and E_g, in lowest terms.
    pub(crate) fn generated(&self) -> Option<[Figure<BigRational>; 2]> {
        on_entry!(self, entry => Some([
            entry.account.generated_linear.try_map(Written::to_rational)?,
            entry.account.generated_quantized.try_map(Written::to_rational)?,
        ]))
    }

    /// Adds the five figures that totals are kept of, `times` over; `None` when one is undefined.
    pub(crate) fn add_to(&self, sums: &mut [FigureSum; 5], times: u64) -> Option<()> {
        on_entry!(self, entry => entry.add_to(sums, times))
    }
}

#[cfg(test)]
mod tests {
    use passivity_core::Friction;
    use proptest::prelude::*;

    use super::*;

    fn number() -> impl Strategy<Value = Number> {
        let denominator = prop_oneof![
            Just(1_i64),
            1..40_i64,
            (0..10_u32).prop_map(|k| 10_i64.pow(k)),
            Just(i64::MAX),
        ];
        let numerator = prop_oneof![-50..50_i64, -1_000_000_000..1_000_000_000_i64, any::<i64>()];
        (numerator, denominator).prop_map(|(n, d)| Number::Small(n, d))
    }

    proptest! {
        #[test]
        fn rows_over_one_denominator_are_those_of_big_integers(
            [start, end, force] in prop::array::uniform3(number()),
            (is_counted, is_forced) in any::<(bool, bool)>(),
            (n, d) in (1..2000_i64, 1..2000_i64),
        ) {
            let friction = |n, d| Number::Small(n, d).to_rational();
            let plain = Loop::plain(Friction::new(friction(3, 7), friction(5, 11)));
            let ledger = Ledger::new(&plain.map(|_, x| Interval::point(x.clone()))).unwrap();
            let at = |x: Number, n: i64| match is_counted {
                true => Reading::Count(n),
                false => Reading::Exact(x),
            };
            let interval = Logged {
                samples: vec![at(start, n)],
                end: at(end, d),
                dtau: Number::Small(n, d),
                force: is_forced.then_some(Reading::Exact(force)),
            };
            let (row, wide) = (ledger.row(&interval), ledger.wide_entry(&interval));
            let (row, wide) = (row.unwrap(), Row::Wide(Box::new(wide.unwrap())));
            let form = crate::rows::Form { enclosures: true, force: true, accounted: true };
            let written = |row: &Row| {
                let mut text = Vec::new();
                form.write_positions(row, &mut text)?;
                form.write_account(row, &mut text)?;
                Some(text)
            };
            prop_assert_eq!(row.truths(), wide.truths());
            prop_assert_eq!(written(&row), written(&wide));
            let big = |reading: &Reading| Some(reading.to_wide());
            let dtau = interval.dtau.to_wide();
            let big = interval.read().row(&ledger.wide, ledger.window(), &dtau, big).unwrap();
            let number = |x: &Wide| x.to_rational();
            let big = big.summed().map(|figure| figure.try_map(number));
            prop_assert_eq!(row.figures().map(|all| all.map(Some)), Some(big.clone()));
            prop_assert_eq!(wide.figures().map(|all| all.map(Some)), Some(big));
        }
    }
}
