//! Rows on machine integers where they fit, on big integers where they do not: the same answers.

use passivity_core::verdict::End;
use passivity_core::{BigRational, Exact, Fixed, Interval, Loop, Scalar as _, Truth, Wide};
use passivity_scene::Scene;

use crate::ends::{Ends, NotExact};
use crate::entry::{Entry, Recorded, entry};
use crate::figure::Figure;
use crate::number::{Number, Reduced, Written};
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
    /// On big integers.
    Wide(Box<Entry<Wide>>),
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
            wide: ends.to_wide(),
        })
    }

    /// The ledger of a scene: its friction in ticks over all tolerances, with π enclosed; other
    /// parameters at their nominal values.
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
        let on_machine_integers = || {
            let kept = interval.samples.iter().take(self.window());
            let samples: Option<Vec<_>> = kept.map(Reading::to_fixed).collect();
            let force = match &interval.force {
                Some(force) => Some(force.to_fixed()?),
                None => None,
            };
            let recorded = Recorded {
                samples: &samples?,
                end: &interval.end.to_fixed()?,
                dtau: &interval.dtau.to_fixed()?,
                force: force.as_ref(),
            };
            entry(self.fixed.as_ref()?, &recorded)
        };
        if let Some(entry) = on_machine_integers() {
            return Some(Row::Fixed(Box::new(entry)));
        }
        let entry = self.wide_entry(interval)?;
        Some(Row::Wide(Box::new(entry)))
    }

    /// The row of an interval on big integers.
    pub(crate) fn wide_entry(&self, interval: &Logged) -> Option<Entry<Wide>> {
        let kept = interval.samples.iter().take(self.window());
        let samples: Vec<_> = kept.map(Reading::to_wide).collect();
        let force = interval.force.as_ref().map(Reading::to_wide);
        let recorded = Recorded {
            samples: &samples,
            end: &interval.end.to_wide(),
            dtau: &interval.dtau.to_wide(),
            force: force.as_ref(),
        };
        entry(&self.wide, &recorded)
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

/// The fraction with the smallest denominator in [lo, hi], 0 < lo ≤ hi, by its continued fraction.
fn simplest(lo: &BigRational, hi: &BigRational) -> BigRational {
    let whole = lo.floor();
    if whole == *lo {
        return whole;
    }
    let above = &whole + BigRational::one();
    if above <= *hi {
        return above;
    }
    let rest = simplest(&(hi - &whole).recip(), &(lo - &whole).recip());
    whole + rest.recip()
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
        on_entry!(self, entry => Truths {
            criterion_holds: entry.criterion_holds,
            violates_linear: entry.violates_linear,
            violates_quantized: entry.violates_quantized,
        })
    }

    /// `net_linear`, in lowest terms.
    #[must_use]
    pub fn net_linear(&self) -> Option<Figure<BigRational>> {
        on_entry!(self, entry => entry.account.net_linear.try_map(Written::to_rational))
    }

    /// E_gᴸ and E_g, in lowest terms.
    pub(crate) fn generated(&self) -> Option<[Figure<BigRational>; 2]> {
        on_entry!(self, entry => Some([
            entry.account.generated_linear.try_map(Written::to_rational)?,
            entry.account.generated_quantized.try_map(Written::to_rational)?,
        ]))
    }

    /// The least that `net_linear` may be.
    pub(crate) fn least_net(&self) -> Option<Reduced> {
        on_entry!(self, entry => entry.account.net_linear.lo().to_reduced())
    }

    /// Adds the five figures that totals are kept of, `times` over; `None` when one is undefined.
    pub(crate) fn add_to(&self, sums: &mut [FigureSum; 5], times: u64) -> Option<()> {
        on_entry!(self, entry => {
            let account = &entry.account;
            let figures = [
                &account.generated_linear,
                &account.generated_quantized,
                &account.dissipated_lower,
                &account.net_linear,
                &account.net_quantized,
            ];
            for (sum, figure) in sums.iter_mut().zip(figures) {
                sum.add_times(figure, times)?;
            }
            Some(())
        })
    }
}
