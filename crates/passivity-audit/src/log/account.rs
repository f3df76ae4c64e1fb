//! The account of a part of a trace: sums, counts, and the intervals that are reported.

use passivity_core::course::{First, Least};
use passivity_core::{BigRational, Truth};

use crate::ledger::{Logged, Truths};
use crate::log::computed::Accounted;
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::Supply;
use crate::log::timing::Timing;
use crate::number::Reduced;
use crate::run::Tallies;
use crate::sum::FigureSum;

/// An interval worth showing.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) h: u64,
    pub(crate) interval: Logged,
}

/// A point of the plot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// After how many intervals.
    pub h: u64,
    /// When, in sampling periods from the first sample on; without a clock, rows are taken to be one apart.
    pub time: f64,
    /// Net energy so far, E_d − E_gᴸ, at the least, in KΔ².
    pub net: f64,
    /// −Σ F·Δξ so far: the passivity observer.
    pub observer: f64,
}

/// Sums and courses over consecutive intervals.
#[derive(Clone, Debug)]
pub(crate) struct Account {
    pub(crate) intervals: u64,
    pub(crate) sums: [FigureSum; 5],
    /// The interval that ends the stretch.
    pub(crate) last: Option<Logged>,
    pub(crate) tallies: Tallies,
    /// Net energy, at the least.
    pub(crate) net: RunningSum,
    /// The passivity observer.
    pub(crate) observer: RunningSum,
    /// Net energy plus the wall's potential, at its lowest: T of the wall's own force.
    pub(crate) stored: Option<Lowest>,
    /// T, where the verdict is about it.
    pub(crate) supply: Supply,
    /// The least net energy of an interval.
    pub(crate) worst: Option<(BigRational, Place)>,
    /// The first interval of each kind, in the order of [`kinds`].
    pub(crate) firsts: [Option<Place>; 5],
    pub(crate) timing: Timing,
    /// Ledger rows as CSV without their first column.
    pub(crate) rows: Vec<u8>,
    pub(crate) points: Vec<Point>,
}

impl Default for Account {
    fn default() -> Self {
        Self {
            intervals: 0,
            sums: std::array::from_fn(|_| FigureSum::of_log()),
            last: None,
            tallies: Tallies::default(),
            net: RunningSum::default(),
            observer: RunningSum::default(),
            stored: None,
            supply: Supply::default(),
            worst: None,
            firsts: Default::default(),
            timing: Timing::default(),
            rows: Vec::new(),
            points: Vec::new(),
        }
    }
}

/// The kinds of intervals of which the first is kept, and whether a row with these truths is one:
/// the linear account is short, or may be; the quantized one is, or may be; the criterion fails.
pub(crate) fn kinds(truths: Truths) -> [bool; 5] {
    [
        truths.violates_linear == Truth::Holds,
        truths.violates_linear == Truth::Depends,
        truths.violates_quantized == Truth::Holds,
        truths.violates_quantized == Truth::Depends,
        truths.criterion_holds == Truth::Fails,
    ]
}

impl Account {
    /// Takes note of an interval with this row, `times` over, the first of them `h`; `place` gives
    /// the interval where it is worth showing. `None` when a number is undefined.
    pub(crate) fn note(
        &mut self,
        row: &Accounted,
        net: &Reduced,
        h: u64,
        times: u64,
        place: impl Fn() -> Option<Place>,
    ) -> Option<()> {
        let truths = row.truths();
        row.add_to(&mut self.sums, times)?;
        self.tallies.add_times(truths, h, times);
        for (first, is) in self.firsts.iter_mut().zip(kinds(truths)) {
            if is && First(first.as_ref().map(|first| first.h)).keep(h) {
                *first = Some(place()?);
            }
        }
        let is_lower = |(worst, place): &(BigRational, Place)| {
            let net = net.to_rational();
            net < *worst || (net == *worst && h < place.h)
        };
        if self.worst.as_ref().is_none_or(is_lower) {
            self.worst = Some((net.to_rational(), place()?));
        }
        Some(())
    }

    /// The intervals worth showing, and the last one.
    pub(crate) fn shown(&self) -> impl Iterator<Item = &Logged> {
        let worst = self.worst.iter().map(|(_, place)| place);
        let places = worst.chain(self.firsts.iter().flatten());
        places.map(|place| &place.interval).chain(&self.last)
    }

    /// Its sums, with what rows answer and where it ends.
    pub(crate) fn sums_alone(self) -> Self {
        Self {
            intervals: self.intervals,
            sums: self.sums,
            last: self.last,
            tallies: self.tallies,
            ..Self::default()
        }
    }

    /// Goes on with the account of the intervals that follow.
    pub(crate) fn append(&mut self, mut other: Self) {
        let before = self.intervals;
        for (sum, other) in self.sums.iter_mut().zip(&other.sums) {
            sum.add_sum(other);
        }
        self.tallies.append(&other.tallies, before);
        Lowest::append(&mut self.stored, other.stored, &self.net);
        self.supply.append(other.supply);
        if !other.points.is_empty() {
            let (net, observer) = (self.net.near(), self.observer.near());
            self.points.extend(other.points.iter().map(|point| Point {
                h: before + point.h,
                time: point.time,
                net: net + point.net,
                observer: observer + point.observer,
            }));
        }
        self.net.append(&other.net);
        self.observer.append(&other.observer);
        if let Some((value, mut place)) = other.worst {
            place.h += before;
            let mut worst = Least(self.worst.as_ref().map(|(worst, at)| (worst, at.h)));
            if worst.keep(&value, place.h) {
                self.worst = Some((value, place));
            }
        }
        for (first, other) in self.firsts.iter_mut().zip(other.firsts) {
            let [ours, theirs] =
                [&*first, &other].map(|first| First(first.as_ref().map(|at| at.h)));
            let mut both = ours;
            if both.append(theirs, before)
                && let (Some(mut place), Some(h)) = (other, both.0)
            {
                place.h = h;
                *first = Some(place);
            }
        }
        self.timing.append(other.timing, before);
        // What is long is moved rather than copied; room is kept where there is nothing to move.
        match self.rows.is_empty() && !other.rows.is_empty() {
            true => self.rows = other.rows,
            false => self.rows.append(&mut other.rows),
        }
        self.last = other.last.or(self.last.take());
        self.intervals += other.intervals;
    }

    /// Adds a point to the plot.
    pub(crate) fn plot(&mut self) {
        self.points.push(Point {
            h: self.intervals,
            // Where samples are joined it is known when they were taken.
            time: 0.0,
            net: self.net.near(),
            observer: self.observer.near(),
        });
    }
}

#[cfg(test)]
mod tests;
