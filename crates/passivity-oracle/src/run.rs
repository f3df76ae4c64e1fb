//! The ledger over a sequence of samples: rows, and exact totals.

use std::collections::VecDeque;

use passivity_core::{BigRational, Truth};

use crate::ledger::{Ledger, Row, Sample};
use crate::number::Number;
use crate::row::write_span;
use crate::span::Span;
use crate::sum::SpanSum;

/// The totals of a run, and which of its intervals broke what.
///
/// The totals of encoder counts are enclosures for the run as a whole, tighter than the sums of
/// the rows' enclosures: a residue that ends one interval starts the next.
#[derive(Clone, Debug, PartialEq)]
pub struct Totals {
    /// How many intervals.
    pub intervals: u64,
    /// Σ E_gᴸ, Σ E_g, Σ of the least dissipation, and the two differences, in KΔ².
    pub figures: [Span<BigRational>; 5],
    /// In how many intervals the criterion held, failed, and depended.
    pub criterion: Tally,
    /// How many intervals violated the linear account.
    pub linear: Tally,
    /// How many intervals violated the quantized account.
    pub quantized: Tally,
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
    /// Counts an interval.
    pub fn add(&mut self, truth: Truth, h: u64) {
        self.add_times(truth, h, 1);
    }

    /// Adds the tally of what came after the first `before` intervals.
    pub(crate) fn append(&mut self, other: &Self, before: u64) {
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
    pub fn add_times(&mut self, truth: Truth, h: u64, times: u64) {
        let (count, first) = match truth {
            Truth::Holds => (&mut self.holds, &mut self.first_holds),
            Truth::Fails => (&mut self.fails, &mut self.first_fails),
            Truth::Depends => (&mut self.depends, &mut self.first_depends),
        };
        *count += times;
        *first = Some(first.map_or(h, |first| first.min(h)));
    }
}

/// Names of the totals, as in a row.
pub(crate) const TOTALS: [&str; 5] = [
    "generated_linear",
    "generated_quantized",
    "dissipated_lower",
    "net_linear",
    "net_quantized",
];

impl Totals {
    /// Appends the totals as a JSON object.
    pub fn write_json(&self, out: &mut Vec<u8>) {
        out.extend_from_slice(format!("{{\"intervals\": {}", self.intervals).as_bytes());
        for (name, figure) in TOTALS.iter().zip(&self.figures) {
            out.extend_from_slice(format!(", \"{name}\": ").as_bytes());
            write_span(figure, out);
        }
        let first = |h: Option<u64>| h.map_or_else(|| "null".to_owned(), |h| h.to_string());
        let text = format!(
            ", \"criterion_fails\": {}, \"criterion_depends\": {}, \"violates_linear\": {}, \
             \"depends_linear\": {}, \"violates_quantized\": {}, \"depends_quantized\": {}, \
             \"first_linear\": {}, \"first_quantized\": {}}}",
            self.criterion.fails,
            self.criterion.depends,
            self.linear.holds,
            self.linear.depends,
            self.quantized.holds,
            self.quantized.depends,
            first(self.linear.first_holds),
            first(self.quantized.first_holds),
        );
        out.extend_from_slice(text.as_bytes());
    }
}

/// The ledger of samples that come one after the other.
#[derive(Clone, Debug)]
pub struct Run<'a> {
    ledger: &'a Ledger,
    /// The latest samples, the latest first: as many as a row needs.
    samples: VecDeque<Sample>,
    intervals: u64,
    sums: [SpanSum; 5],
    last: Option<Row>,
    counted: bool,
    criterion: Tally,
    linear: Tally,
    quantized: Tally,
}

impl<'a> Run<'a> {
    /// A run that has not started.
    #[must_use]
    pub fn new(ledger: &'a Ledger) -> Self {
        Self {
            ledger,
            samples: VecDeque::new(),
            intervals: 0,
            sums: Default::default(),
            last: None,
            counted: ledger.model().is_plain(),
            criterion: Tally::default(),
            linear: Tally::default(),
            quantized: Tally::default(),
        }
    }

    /// How many intervals there were.
    #[must_use]
    pub const fn intervals(&self) -> u64 {
        self.intervals
    }

    /// Takes the next sample, `dtau` after the one before, and gives the row of the interval that
    /// it ends: none for the first sample. `None` when a figure is not defined.
    pub fn step(&mut self, sample: Sample, dtau: &Number) -> Option<Option<Row>> {
        self.counted &= matches!(sample, Sample::Count(_));
        let row = if self.samples.is_empty() {
            None
        } else {
            let row = self
                .ledger
                .row(self.samples.make_contiguous(), &sample, dtau)?;
            self.account(&row);
            Some(row)
        };
        self.samples.push_front(sample);
        self.samples.truncate(self.ledger.window());
        Some(row)
    }

    fn account(&mut self, row: &Row) {
        row.add_to(&mut self.sums, 1);
        let [criterion, linear, quantized] = row.truths();
        self.criterion.add(criterion, self.intervals);
        self.linear.add(linear, self.intervals);
        self.quantized.add(quantized, self.intervals);
        self.intervals += 1;
        self.last = Some(row.clone());
    }

    /// The totals so far.
    #[must_use]
    pub fn totals(&self) -> Totals {
        let mut figures = self.sums.each_ref().map(SpanSum::value);
        if let (true, Some(last)) = (self.counted, &self.last) {
            figures = tightened(figures, last);
        }
        Totals {
            intervals: self.intervals,
            figures,
            criterion: self.criterion,
            linear: self.linear,
            quantized: self.quantized,
        }
    }
}

/// The totals of plain counts, with what is known of the run as a whole.
///
/// Each residue inside the run enters Σ E_gᴸ linearly (TH-TELESCOPE), so that the total is
/// enclosed exactly by Σ E_g of all rows but the last and E_gᴸ of the last. Net energy is enclosed
/// by the sum of rows and by the difference of the totals, so by what both have in common.
pub(crate) fn tightened(figures: [Span<BigRational>; 5], last: &Row) -> [Span<BigRational>; 5] {
    let [
        rows_linear,
        quantized,
        dissipated,
        net_linear,
        net_quantized,
    ] = figures;
    let [linear_last, quantized_last] = match last.generated() {
        Some(generated) => generated,
        None => {
            return [
                rows_linear,
                quantized,
                dissipated,
                net_linear,
                net_quantized,
            ];
        }
    };
    let swapped =
        |total: &BigRational, out: &BigRational, within: &BigRational| total - out + within;
    let linear = Span::Between(
        swapped(quantized.lo(), quantized_last.lo(), linear_last.lo()),
        swapped(quantized.hi(), quantized_last.hi(), linear_last.hi()),
    );
    let common = |rows: Span<BigRational>, totals: Span<BigRational>| {
        let lo = Ord::max(rows.lo(), totals.lo()).clone();
        Span::Between(lo, Ord::min(rows.hi(), totals.hi()).clone())
    };
    let net_linear = common(net_linear, dissipated.minus(&linear));
    let net_quantized = common(net_quantized, dissipated.minus(&quantized));
    [linear, quantized, dissipated, net_linear, net_quantized]
}
