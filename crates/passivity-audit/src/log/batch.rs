//! The account of consecutive intervals whose rows doubles decide: sums of integers of fixed width.

use std::ops::Range;

use passivity_core::course::{Course, Least};

use crate::ledger::Truths;
use crate::log::account::{Account, Place, kinds};
use crate::log::error::TraceError;
use crate::log::lanes::{Sums, Tile};
use crate::log::motion::Addend;
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::{Bounds, NO_FORCE, Supplied, Supply};
use crate::run::Tallies;
use crate::span::on_grid;
use crate::sum::FigureSum;

/// The most intervals of a batch: of addends that are as wide as [`fits`](Addend::fits) allows, sums have room in
/// 128 bits.
const MOST: u64 = 1 << 20;

/// The least energy, in units of the grid.
fn lowest(least: Least<i128>) -> Option<Lowest> {
    let (value, h) = least.0?;
    Some(Lowest::new(on_grid(value), h))
}

/// Sums over consecutive intervals.
#[derive(Clone, Debug, Default)]
pub(crate) struct Batch {
    pub(crate) intervals: u64,
    /// The five figures that totals are kept of, at the least and at the most.
    sums: [[i128; 2]; 5],
    net: Course<i128>,
    observer: Course<i128>,
    /// Where net energy plus potential was least.
    stored: Least<i128>,
    /// What is left of what was stored at the start, where the verdict is about it, at the least and at the
    /// most; and where it was least with the potential.
    supply: [Course<i128>; 2],
    lowest: [Least<i128>; 2],
    /// The excess force of the last interval, where it had any.
    excess: Option<Bounds>,
    /// All but the latest intervals that are alike: how, from which one on, and how many.
    tallies: Tallies,
    alike: (Option<Truths>, u64, u64),
    /// The first interval of each kind, and the one with the least net energy.
    firsts: [Option<u64>; 5],
    worst: Least<i128>,
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
                sum.step(step, h);
                lowest.keep(sum.sum + end, h);
            }
            self.excess = supply.excess;
        }
        self.intervals = h;
        for ([lo, hi], [least, most]) in self.sums.iter_mut().zip(addend.sums) {
            *lo += least;
            *hi += most;
        }
        let [_, _, _, [least_net, _], _] = addend.sums;
        self.net.step(least_net, h);
        self.observer.step(addend.observed, h);
        let [least_potential, _] = addend.potential;
        self.stored.keep(self.net.sum + least_potential, h);
        self.worst.keep(least_net, h - 1);
        self.alike(addend.truths, h - 1, 1);
        Some(())
    }

    /// Adds an interval between known positions of a wall without memory, as [`add`](Self::add) does.
    #[inline(always)]
    pub(crate) fn add_known(&mut self, addend: &Addend, running: bool) -> Option<()> {
        let [_, _, _, net, _] = addend.sums;
        let supply = match running {
            true => Some(Supplied::known(net, addend.potential, self.excess())?),
            false => None,
        };
        self.add(addend, supply)
    }

    /// Adds decided rows of a tile, as [`add`](Self::add) does one after the other, for intervals without excess
    /// force: under the force in the log where that is `applied`. `None`, and nothing added, where the batch has no
    /// room for them.
    pub(crate) fn add_tile(
        &mut self,
        (tile, rows): (&Tile, Range<usize>),
        applied: bool,
        running: bool,
    ) -> Option<()> {
        let before = self.intervals;
        let len = rows.len() as u64;
        if before + len > MOST || self.excess.is_some() {
            return None;
        }
        let sums = tile.sums(&rows, applied);
        if !self.is_quiet(&sums, running) {
            return self.add_rows((tile, rows), applied, running);
        }
        let [_, _, _, net, _] = sums.sums;
        for ([lo, hi], [least, most]) in self.sums.iter_mut().zip(sums.sums) {
            *lo += least;
            *hi += most;
        }
        self.net.sum += net[0];
        match self.observer.sum + sums.least_observed >= self.observer.least {
            true => self.observer.sum += sums.observed,
            false => {
                let observed = tile.observed(applied);
                for (observed, h) in observed.get(rows.clone())?.iter().zip(before + 1..) {
                    self.observer.step(*observed, h);
                }
            }
        }
        if running {
            for (sum, step) in self.supply.iter_mut().zip(net) {
                sum.sum += step;
            }
        }
        self.intervals += len;
        let mut at = rows.start;
        while at < rows.end {
            let times = tile.alike(at..rows.end, applied);
            let h = before + (at - rows.start) as u64;
            self.alike(tile.truths(at, applied), h, times as u64);
            at += times;
        }
        Some(())
    }

    /// Whether no energy gets below the least that it was so far with the rows of these sums.
    fn is_quiet(&self, sums: &Sums, running: bool) -> bool {
        let stays =
            |least: &Least<i128>, found: i128| least.0.is_some_and(|(least, _)| found >= least);
        let supplied = |(sum, lowest): (&Course<i128>, &Least<i128>)| {
            sum.sum + sums.least_net >= sum.least && stays(lowest, sum.sum + sums.least_stored)
        };
        self.net.sum + sums.least_net >= self.net.least
            && stays(&self.stored, self.net.sum + sums.least_stored)
            && stays(&self.worst, sums.least_row)
            && (!running || self.supply.iter().zip(&self.lowest).all(supplied))
    }

    /// Adds decided rows of a tile one by one.
    fn add_rows(
        &mut self,
        (tile, rows): (&Tile, Range<usize>),
        applied: bool,
        running: bool,
    ) -> Option<()> {
        for i in rows {
            self.add_known(&tile.addend(i, applied)?, running)?;
        }
        Some(())
    }

    /// Takes note of so many intervals with the same answers, the first of them `h`.
    #[inline(always)]
    fn alike(&mut self, truths: Truths, h: u64, times: u64) {
        // Most intervals come after one like them.
        if self.alike.0 != Some(truths) {
            self.settle();
            self.alike = (Some(truths), h, 0);
            for (first, is) in self.firsts.iter_mut().zip(kinds(truths)) {
                if is {
                    first.get_or_insert(h);
                }
            }
        }
        self.alike.2 += times;
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
            net: RunningSum::of_grid(self.net, self.intervals),
            observer: RunningSum::of_grid(self.observer, self.intervals),
            tallies: self.tallies,
            ..Account::default()
        };
        if running {
            let sums = self
                .supply
                .map(|sum| RunningSum::of_grid(sum, self.intervals));
            let lowest = self.lowest.map(lowest);
            account.supply =
                Supply::from_parts(sums, lowest, Some(self.excess.unwrap_or(NO_FORCE)));
        } else {
            account.stored = lowest(self.stored);
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
