//! The ledger over a sequence of samples: rows, and exact totals.

use passivity_core::course::First;
use passivity_core::{BigRational, Interval, Truth};
use serde::Serialize;

use crate::figure::Figure;
use crate::ledger::{Ledger, Logged, Row, Truths};
use crate::number::Number;
use crate::reading::Reading;
use crate::sum::FigureSum;

/// Σ E_gᴸ, Σ E_g, Σ of the least dissipation, and the two differences, in KΔ².
pub(crate) type Figures = [Figure<BigRational>; 5];

/// The totals of a run, and which of its intervals broke what.
///
/// The totals of encoder counts are enclosures for the run as a whole, tighter than the sums of
/// the rows' enclosures: a residue that ends one interval starts the next.
///
/// What was generated, what is left of what friction took, and how many intervals violate an account are `None` of a log
/// that is not accounted for: the force that acted is not known.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Totals {
    /// How many intervals.
    pub intervals: u64,
    /// Σ E_gᴸ, in KΔ².
    pub generated_linear: Option<Figure<BigRational>>,
    /// Σ E_g.
    pub generated_quantized: Option<Figure<BigRational>>,
    /// Σ of the least dissipation.
    pub dissipated_lower: Figure<BigRational>,
    /// Σ of the net energies of the linear account.
    pub net_linear: Option<Figure<BigRational>>,
    /// Σ of those of the quantized account.
    pub net_quantized: Option<Figure<BigRational>>,
    /// In how many intervals the criterion failed.
    pub criterion_fails: u64,
    /// In how many it depends.
    pub criterion_depends: u64,
    /// How many intervals violate the linear account.
    pub violates_linear: Option<u64>,
    /// In how many it depends.
    pub depends_linear: Option<u64>,
    /// How many intervals violate the quantized account.
    pub violates_quantized: Option<u64>,
    /// In how many it depends.
    pub depends_quantized: Option<u64>,
    /// The first interval that violates the linear account.
    pub first_linear: Option<u64>,
    /// The first that violates the quantized account.
    pub first_quantized: Option<u64>,
}

/// How often a statement held, failed and depended, and where first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// How often it held.
    pub holds: u64,
    /// How often it failed.
    pub fails: u64,
    /// How often it depended on what the trace does not say.
    pub depends: u64,
    /// The first interval where it held.
    pub first_holds: Option<u64>,
    /// The first interval where it failed.
    pub first_fails: Option<u64>,
    /// The first interval where it depended.
    pub first_depends: Option<u64>,
}

impl Tally {
    /// Adds the tally of what came after the first `before` intervals.
    fn append(&mut self, other: &Self, before: u64) {
        for (truth, times, first) in [
            (Truth::Holds, other.holds, other.first_holds),
            (Truth::Fails, other.fails, other.first_fails),
            (Truth::Depends, other.depends, other.first_depends),
        ] {
            if let Some(first) = first {
                self.add_times(truth, before + first, times);
            }
        }
    }

    /// Counts `times` intervals, the first of them `h`.
    fn add_times(&mut self, truth: Truth, h: u64, times: u64) {
        let (count, first) = match truth {
            Truth::Holds => (&mut self.holds, &mut self.first_holds),
            Truth::Fails => (&mut self.fails, &mut self.first_fails),
            Truth::Depends => (&mut self.depends, &mut self.first_depends),
        };
        *count += times;
        let mut earliest = First(*first);
        earliest.keep(h);
        *first = earliest.0;
    }
}

/// How often the criterion held and the accounts were violated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tallies {
    /// Whether the criterion held.
    pub criterion: Tally,
    /// Whether the linear account was violated.
    pub linear: Tally,
    /// Whether the quantized account was violated.
    pub quantized: Tally,
}

impl Tallies {
    /// Counts `times` intervals, the first of them `h`.
    pub(crate) fn add_times(&mut self, truths: Truths, h: u64, times: u64) {
        self.criterion.add_times(truths.criterion_holds, h, times);
        self.linear.add_times(truths.violates_linear, h, times);
        let quantized = truths.violates_quantized;
        self.quantized.add_times(quantized, h, times);
    }

    /// Adds the tallies of what came after the first `before` intervals.
    pub(crate) fn append(&mut self, other: &Self, before: u64) {
        self.criterion.append(&other.criterion, before);
        self.linear.append(&other.linear, before);
        self.quantized.append(&other.quantized, before);
    }
}

impl Totals {
    pub(crate) fn new(intervals: u64, figures: Figures, tallies: &Tallies) -> Self {
        let [
            generated_linear,
            generated_quantized,
            dissipated_lower,
            net_linear,
            net_quantized,
        ] = figures;
        Self {
            intervals,
            generated_linear: Some(generated_linear),
            generated_quantized: Some(generated_quantized),
            dissipated_lower,
            net_linear: Some(net_linear),
            net_quantized: Some(net_quantized),
            criterion_fails: tallies.criterion.fails,
            criterion_depends: tallies.criterion.depends,
            violates_linear: Some(tallies.linear.holds),
            depends_linear: Some(tallies.linear.depends),
            violates_quantized: Some(tallies.quantized.holds),
            depends_quantized: Some(tallies.quantized.depends),
            first_linear: tallies.linear.first_holds,
            first_quantized: tallies.quantized.first_holds,
        }
    }

    /// Without what is of a force that is not the one that acted.
    pub(crate) fn of_positions(self) -> Self {
        Self {
            generated_linear: None,
            generated_quantized: None,
            net_linear: None,
            net_quantized: None,
            violates_linear: None,
            depends_linear: None,
            violates_quantized: None,
            depends_quantized: None,
            first_linear: None,
            first_quantized: None,
            ..self
        }
    }
}

/// The ledger of samples that come one after the other.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    ledger: &'a Ledger,
    /// The latest samples, the latest first: as many as a row needs.
    samples: Vec<Reading>,
    intervals: u64,
    sums: [FigureSum; 5],
    last: Option<Row>,
    /// Whether all samples are counts and every force is the law's, so that residues telescope.
    telescopes: bool,
    tallies: Tallies,
}

impl<'a> Run<'a> {
    /// A run that has not started.
    #[must_use]
    pub fn new(ledger: &'a Ledger) -> Self {
        Self {
            ledger,
            samples: Vec::new(),
            intervals: 0,
            sums: Default::default(),
            last: None,
            telescopes: ledger.is_plain(),
            tallies: Tallies::default(),
        }
    }

    /// How many intervals there were.
    #[must_use]
    pub const fn intervals(&self) -> u64 {
        self.intervals
    }

    /// Takes the next sample, `dtau` after the one before, and gives the row of the interval that
    /// it ends: none for the first sample. `force` is what was applied over the interval, `None` for
    /// the loop's own force. `None` when a figure is not defined.
    pub fn step(
        &mut self,
        sample: Reading,
        dtau: &Number,
        force: Option<Reading>,
    ) -> Option<Option<Row>> {
        self.telescopes &= matches!(sample, Reading::Count(_)) && force.is_none();
        let mut row = None;
        if !self.samples.is_empty() {
            let interval = Logged {
                samples: std::mem::take(&mut self.samples),
                end: sample.clone(),
                dtau: dtau.clone(),
                force,
            };
            let found = self.ledger.row(&interval)?;
            self.samples = interval.samples;
            self.account(&found)?;
            row = Some(found);
        }
        self.samples.insert(0, sample);
        self.samples.truncate(self.ledger.window());
        Some(row)
    }

    fn account(&mut self, row: &Row) -> Option<()> {
        row.add_to(&mut self.sums, 1)?;
        self.tallies.add_times(row.truths(), self.intervals, 1);
        self.intervals += 1;
        self.last = Some(row.clone());
        Some(())
    }

    /// How many bits the widest denominator of its sums has, where machine integers do not hold it.
    #[must_use]
    pub fn width(&self) -> u64 {
        let widths = self.sums.iter().map(FigureSum::width);
        widths.max().unwrap_or(0)
    }

    /// The totals so far; `None` when a figure is not defined.
    #[must_use]
    pub fn totals(&self) -> Option<Totals> {
        let mut figures = self.sums.each_ref().map(FigureSum::value);
        if let (true, Some(last)) = (self.telescopes, &self.last) {
            figures = tightened(figures, last)?;
        }
        Some(Totals::new(self.intervals, figures, &self.tallies))
    }
}

/// The totals of plain counts, with what is known of the run as a whole; `None` when a figure is
/// undefined.
///
/// Each residue inside the run enters Σ E_gᴸ linearly (TH-TELESCOPE), so that the total is
/// enclosed exactly by Σ E_g of all rows but the last and E_gᴸ of the last. Net energy is enclosed
/// by the sum of rows and by the difference of the totals, so by what both have in common.
pub(crate) fn tightened(figures: Figures, last: &Row) -> Option<Figures> {
    let [_, quantized, dissipated, net_linear, net_quantized] = figures;
    let [linear_last, quantized_last] = last.generated()?;
    // Of the three only the total is long.
    let swapped =
        |total: &BigRational, out: &BigRational, within: &BigRational| total + (within - out);
    let linear = Figure::between(
        swapped(quantized.lo(), quantized_last.lo(), linear_last.lo()),
        swapped(quantized.hi(), quantized_last.hi(), linear_last.hi()),
    )?;
    let common = |rows: Figure<BigRational>, totals: &Figure<BigRational>| {
        let lo = Ord::max(rows.lo(), totals.lo()).clone();
        Interval::new(lo, Ord::min(rows.hi(), totals.hi()).clone()).map(Figure::Enclosed)
    };
    let net_linear = common(net_linear, &dissipated.minus(&linear)?)?;
    let net_quantized = common(net_quantized, &dissipated.minus(&quantized)?)?;
    Some([linear, quantized, dissipated, net_linear, net_quantized])
}
