//! The account of consecutive intervals whose rows doubles decide: sums of integers of fixed width.

use crate::ledger::Truths;
use crate::log::account::{Account, Place, kinds};
use crate::log::error::TraceError;
use crate::log::motion::Addend;
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::{Bounds, NO_FORCE, Supplied, Supply};
use crate::run::Tallies;
use crate::span::on_grid;
use crate::sum::FigureSum;

/// The most intervals of a batch: of addends that are as wide as [`fits`](Addend::fits) allows, sums have room in
/// 128 bits.
const MOST: u64 = 1 << 20;

/// The least of some energies in units of the grid, and after how many intervals it was.
#[derive(Clone, Copy, Debug, Default)]
struct Least(Option<(i128, u64)>);

impl Least {
    #[inline]
    fn keep(&mut self, value: i128, h: u64) {
        if self.0.is_none_or(|(least, _)| value < least) {
            self.0 = Some((value, h));
        }
    }

    fn lowest(self) -> Option<Lowest> {
        let (value, h) = self.0?;
        Some(Lowest::new(on_grid(value), h))
    }
}

/// A sum in units of the grid, and its least value so far.
#[derive(Clone, Copy, Debug, Default)]
struct Course {
    now: i128,
    least: (i128, u64),
}

impl Course {
    #[inline]
    fn add(&mut self, step: i128, h: u64) {
        self.now += step;
        if self.now < self.least.0 {
            self.least = (self.now, h);
        }
    }

    fn running(self, steps: u64) -> RunningSum {
        RunningSum::of_grid(self.now, self.least, steps)
    }
}

/// Sums over consecutive intervals.
#[derive(Clone, Debug, Default)]
pub(crate) struct Batch {
    pub(crate) intervals: u64,
    /// The five figures that totals are kept of, at the least and at the most.
    sums: [[i128; 2]; 5],
    net: Course,
    observer: Course,
    /// Where net energy plus potential was least.
    stored: Least,
    /// What is left of what was stored at the start, where the verdict is about it, at the least and at the
    /// most; and where it was least with the potential.
    supply: [Course; 2],
    lowest: [Least; 2],
    /// The excess force of the last interval, where it had any.
    excess: Option<Bounds>,
    /// All but the latest intervals that are alike: how, from which one on, and how many.
    tallies: Tallies,
    alike: (Option<Truths>, u64, u64),
    /// The first interval of each kind, and the one with the least net energy.
    firsts: [Option<u64>; 5],
    worst: Least,
}

impl Batch {
    /// After an interval with this excess force.
    pub(crate) fn after(excess: Option<Bounds>) -> Self {
        Self {
            excess: excess.filter(|excess| *excess != NO_FORCE),
            ..Self::default()
        }
    }

    /// The excess force of the last interval, where it had any.
    pub(crate) const fn excess(&self) -> Option<&Bounds> {
        self.excess.as_ref()
    }

    /// Adds an interval, with what it adds to T where the verdict is about that; `None`, and nothing added,
    /// where the batch is full.
    #[inline(always)]
    pub(crate) fn add(&mut self, addend: &Addend, supply: Option<Supplied>) -> Option<()> {
        let h = self.intervals + 1;
        if h > MOST {
            return None;
        }
        if let Some(supply) = supply {
            let sums = self.supply.iter_mut().zip(&mut self.lowest);
            for ((sum, lowest), (step, end)) in sums.zip(supply.step.into_iter().zip(supply.end)) {
                sum.add(step, h);
                lowest.keep(sum.now + end, h);
            }
            self.excess = supply.excess;
        }
        self.intervals = h;
        for ([lo, hi], [least, most]) in self.sums.iter_mut().zip(addend.sums) {
            *lo += least;
            *hi += most;
        }
        let [_, _, _, [least_net, _], _] = addend.sums;
        self.net.add(least_net, h);
        self.observer.add(addend.observed, h);
        let [least_potential, _] = addend.potential;
        self.stored.keep(self.net.now + least_potential, h);
        self.worst.keep(least_net, h - 1);
        // Most intervals come after one like them.
        if self.alike.0 != Some(addend.truths) {
            self.settle();
            self.alike = (Some(addend.truths), h - 1, 0);
            for (first, is) in self.firsts.iter_mut().zip(kinds(addend.truths)) {
                if is {
                    first.get_or_insert(h - 1);
                }
            }
        }
        self.alike.2 += 1;
        Some(())
    }

    /// Counts the intervals that are alike.
    fn settle(&mut self) {
        if let (Some(truths), first, times) = self.alike {
            self.tallies.add_times(truths, first, times);
        }
    }

    /// The account of the intervals; `running` where the verdict is about what the operator has drawn.
    /// `place` gives an interval worth showing, by how many came before it.
    pub(crate) fn account(
        mut self,
        running: bool,
        place: impl Fn(u64) -> Result<Place, TraceError>,
    ) -> Result<Account, TraceError> {
        self.settle();
        let mut account = Account {
            intervals: self.intervals,
            sums: self.sums.map(FigureSum::of_grid),
            net: self.net.running(self.intervals),
            observer: self.observer.running(self.intervals),
            tallies: self.tallies,
            ..Account::default()
        };
        if running {
            let sums = self.supply.map(|sum| sum.running(self.intervals));
            let lowest = self.lowest.map(Least::lowest);
            account.supply =
                Supply::from_parts(sums, lowest, Some(self.excess.unwrap_or(NO_FORCE)));
        } else {
            account.stored = self.stored.lowest();
        }
        for (slot, first) in account.firsts.iter_mut().zip(self.firsts) {
            *slot = first.map(&place).transpose()?;
        }
        if let Some((least, h)) = self.worst.0 {
            account.worst = Some((on_grid(least), place(h)?));
        }
        Ok(account)
    }
}
