//! The account of a stretch of a trace: sums, courses, tallies, the intervals worth showing.

use passivity_core::{BigRational, Truth};

use crate::audit::course::Course;
use crate::ledger::{Ledger, Row, Sample};
use crate::number::Number;
use crate::run::Tally;
use crate::sum::SpanSum;

/// An interval of the trace, with what its row is made of.
#[derive(Clone, Debug)]
pub(crate) struct Spot {
    pub(crate) h: u64,
    /// The samples up to its start, the latest first.
    pub(crate) samples: Vec<Sample>,
    pub(crate) end: Sample,
    pub(crate) dtau: Number,
}

impl Spot {
    pub(crate) fn row(&self, ledger: &Ledger) -> Option<Row> {
        ledger.row(&self.samples, &self.end, &self.dtau)
    }
}

/// A point of the plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// After how many intervals.
    pub h: u64,
    /// Net energy so far, E_d − E_gᴸ, at the least, in KΔ².
    pub net: f64,
    /// Σ f·Δξ so far: the passivity observer.
    pub observer: f64,
}

/// Where an energy was lowest.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Lowest {
    pub(crate) value: BigRational,
    pub(crate) h: u64,
}

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
    pub(crate) shortest: Option<Number>,
    pub(crate) longest: Option<Number>,
}

/// Sums and courses over consecutive intervals.
#[derive(Clone, Debug, Default)]
pub(crate) struct Account {
    pub(crate) intervals: u64,
    pub(crate) sums: [SpanSum; 5],
    /// The row that ends the stretch.
    pub(crate) last: Option<Row>,
    pub(crate) criterion: Tally,
    pub(crate) linear: Tally,
    pub(crate) quantized: Tally,
    /// Net energy, at the least.
    pub(crate) net: Course,
    /// The passivity observer.
    pub(crate) observer: Course,
    /// Net energy plus the wall's potential, at its lowest.
    pub(crate) supply: Option<Lowest>,
    /// The least net energy of an interval.
    pub(crate) worst: Option<(BigRational, Spot)>,
    /// The first interval of each kind, in the order of [`KINDS`].
    pub(crate) firsts: [Option<Spot>; 5],
    pub(crate) timing: Timing,
    /// Ledger rows as CSV without their first column.
    pub(crate) rows: Vec<u8>,
    pub(crate) points: Vec<Point>,
}

/// The kinds of intervals of which the first is kept.
pub(crate) const KINDS: [&str; 5] = [
    "linear",
    "possible_linear",
    "quantized",
    "possible_quantized",
    "criterion",
];

/// Which of [`KINDS`] a row with these truths is.
pub(crate) fn kinds(truths: [Truth; 3]) -> [bool; 5] {
    let [criterion, linear, quantized] = truths;
    [
        linear == Truth::Holds,
        linear == Truth::Depends,
        quantized == Truth::Holds,
        quantized == Truth::Depends,
        criterion == Truth::Fails,
    ]
}

impl Account {
    /// Goes on with the account of the intervals that follow.
    pub(crate) fn append(&mut self, mut other: Self) {
        let before = self.intervals;
        for (sum, other) in self.sums.iter_mut().zip(&other.sums) {
            sum.add_sum(other);
        }
        self.criterion.append(&other.criterion, before);
        self.linear.append(&other.linear, before);
        self.quantized.append(&other.quantized, before);
        if let Some(lowest) = other.supply {
            let value = self.net.total() + lowest.value;
            self.lower_supply(value, before + lowest.h);
        }
        if !other.points.is_empty() {
            let (net, observer) = (self.net.near(), self.observer.near());
            self.points.extend(other.points.iter().map(|point| Point {
                h: before + point.h,
                net: net + point.net,
                observer: observer + point.observer,
            }));
        }
        self.net.append(&other.net);
        self.observer.append(&other.observer);
        if let Some((value, mut spot)) = other.worst {
            spot.h += before;
            if self.worst.as_ref().is_none_or(|(worst, _)| value < *worst) {
                self.worst = Some((value, spot));
            }
        }
        for (first, other) in self.firsts.iter_mut().zip(other.firsts) {
            if let (None, Some(mut spot)) = (&first, other) {
                spot.h += before;
                *first = Some(spot);
            }
        }
        self.timing.append(other.timing, before);
        self.rows.append(&mut other.rows);
        self.last = other.last.or(self.last.take());
        self.intervals += other.intervals;
    }

    /// Takes note of net energy plus potential after `h` intervals.
    pub(crate) fn lower_supply(&mut self, value: BigRational, h: u64) {
        if self
            .supply
            .as_ref()
            .is_none_or(|lowest| value < lowest.value)
        {
            self.supply = Some(Lowest { value, h });
        }
    }
}

impl Timing {
    /// Counts the interval `h`, `times` over.
    pub(crate) fn add(&mut self, dtau: &Number, h: u64) {
        let one = Number::whole(1);
        if *dtau != one {
            self.uneven += 1;
            let beyond = crate::number::difference(dtau, &one);
            let missed = nearest(&beyond);
            if crate::number::is_positive(&beyond) {
                self.late += 1;
            }
            if missed > 0 {
                self.missed = self.missed.saturating_add(missed);
                self.first_missed.get_or_insert(h);
            }
        }
        let shorter =
            |than: &Number| crate::number::is_positive(&crate::number::difference(than, dtau));
        let longer =
            |than: &Number| crate::number::is_positive(&crate::number::difference(dtau, than));
        if self.shortest.as_ref().is_none_or(shorter) {
            self.shortest = Some(dtau.clone());
        }
        if self.longest.as_ref().is_none_or(longer) {
            self.longest = Some(dtau.clone());
        }
    }

    fn append(&mut self, other: Self, before: u64) {
        self.uneven += other.uneven;
        self.late += other.late;
        self.missed = self.missed.saturating_add(other.missed);
        if let (None, Some(first)) = (self.first_missed, other.first_missed) {
            self.first_missed = Some(before + first);
        }
        let difference = crate::number::difference;
        if let Some(theirs) = other.shortest {
            let shorter = |ours: &Number| crate::number::is_positive(&difference(ours, &theirs));
            if self.shortest.as_ref().is_none_or(shorter) {
                self.shortest = Some(theirs);
            }
        }
        if let Some(theirs) = other.longest {
            let longer = |ours: &Number| crate::number::is_positive(&difference(&theirs, ours));
            if self.longest.as_ref().is_none_or(longer) {
                self.longest = Some(theirs);
            }
        }
    }
}

/// The nearest whole number, at least 0.
fn nearest(x: &Number) -> u64 {
    use num_traits::ToPrimitive as _;
    let rounded = match x {
        Number::Small(n, d) => {
            let (n, d) = (i128::from(*n), i128::from(*d));
            num_integer::Integer::div_floor(&(2 * n + d), &(2 * d))
                .max(0)
                .to_u64()
        }
        Number::Big(x) => x.round().to_integer().to_u64(),
    };
    rounded.unwrap_or(0)
}
