//! The account of consecutive intervals whose rows doubles decide: sums of integers of fixed width.

use std::ops::Range;

use passivity_core::course::{Course, Least};

use crate::ledger::Truths;
use crate::log::account::{Account, Place, kinds};
use crate::log::error::TraceError;
use crate::log::lanes::{Answer, Asked, ByLaw, Courses, Sums, TileRows, each_answer};
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
    Some(Lowest::of_grid(value, h))
}

/// Sums over consecutive intervals.
#[derive(Clone, Debug, Default)]
pub(crate) struct Batch {
    pub(crate) intervals: u64,
    /// Whether [sums](crate::log::task::Task::sums_alone) are all that is told of rows computed several at a time.
    sums_alone: bool,
    /// The five figures that totals are kept of, at the least and at the most.
    sums: [[i128; 2]; 5],
    courses: Courses<i128>,
    observer: Course<i128>,
    /// The excess force of the last interval, where it had any.
    excess: Option<Bounds>,
    /// What intervals answer, the first of those that are alike and how many.
    tallied: Vec<(Truths, u64, u64)>,
    /// The first interval of each kind.
    firsts: [Option<u64>; 5],
}

impl Batch {
    /// After an interval with this excess force.
    pub(crate) fn after(excess: Option<Bounds>, sums_alone: bool) -> Self {
        Self {
            excess: excess.filter(|excess| *excess != NO_FORCE),
            sums_alone,
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
        self.intervals = h;
        for ([lo, hi], [least, most]) in self.sums.iter_mut().zip(addend.sums) {
            *lo += least;
            *hi += most;
        }
        let ([_, _, _, [net, _], _], [potential, _]) = (addend.sums, addend.potential);
        let steps = supply.as_ref().map(|supply| [supply.step, supply.end]);
        self.courses.step((net, potential), steps, h);
        if let Some(supply) = supply {
            self.excess = supply.excess;
        }
        self.observer.step(addend.observed, h);
        self.tally(addend.truths, h - 1, 1);
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

    /// Adds decided rows of a tile, as [`add`](Self::add) does one after the other: how many.
    pub(crate) fn add_tile(
        &mut self,
        (tile, rows): (&mut impl TileRows, Range<usize>),
        running: bool,
    ) -> usize {
        let before = self.intervals;
        if rows.is_empty() || before + rows.len() as u64 > MOST {
            return 0;
        }
        if self.sums_alone {
            let sums = tile.totals(&rows);
            return self.add_rows(&sums, (tile, &rows));
        }
        if tile.add_up(&rows, running, self.excess()).is_none() {
            return 0;
        }
        let sums = tile.sums(&rows);
        let asked = self.asked(&sums, running);
        let mut courses = match asked == Asked::default() {
            true => Courses::default(),
            false => tile.courses(&rows, (asked, &sums)),
        };
        let [_, _, _, [net, _], _] = sums.sums;
        courses.net.sum = net;
        if running {
            for (course, sum) in courses.supply.iter_mut().zip(sums.supply) {
                course.sum = sum;
            }
        }
        self.courses.append(&courses, before);
        let mut observer = match self.observer.sum + sums.least_observed >= self.observer.least {
            true => Course::default(),
            false => tile.observer(&rows, &sums),
        };
        observer.sum = sums.observed;
        self.observer.append(&observer, before);
        if running {
            self.excess = sums.excess;
        }
        self.add_rows(&sums.sums, (tile, &rows))
    }

    /// Adds rows under the force of the wall that were computed beside others, where [sums](Self::sums_alone) are all that
    /// is told: how many.
    pub(crate) fn add_by_law(&mut self, rows: &ByLaw, answers: &[Answer]) -> usize {
        let before = self.intervals;
        if before + rows.len as u64 > MOST {
            return 0;
        }
        self.add_sums(&rows.sums, rows.len);
        for (truths, first, times) in answers {
            self.tally(*truths, before + *first as u64, *times as u64);
        }
        rows.len
    }

    /// Adds the sums of some rows of a tile and what these answer: how many they are.
    fn add_rows(
        &mut self,
        sums: &[[i128; 2]; 5],
        (tile, rows): (&impl TileRows, &Range<usize>),
    ) -> usize {
        let before = self.intervals;
        self.add_sums(sums, rows.len());
        let covers = tile.covers().get(rows.clone()).unwrap_or_default();
        each_answer(covers, |truths, first, times| {
            self.tally(truths, before + first as u64, times as u64);
        });
        rows.len()
    }

    fn add_sums(&mut self, sums: &[[i128; 2]; 5], rows: usize) {
        for ([lo, hi], [least, most]) in self.sums.iter_mut().zip(sums) {
            *lo += least;
            *hi += most;
        }
        self.intervals += rows as u64;
    }

    /// Which energies may get below the least that they were so far, with the rows of these sums.
    fn asked(&self, sums: &Sums, running: bool) -> Asked {
        let falls = |sum: &Course<i128>, by: i128| sum.sum + by < sum.least;
        let gets_below =
            |least: &Least<i128>, found: i128| least.0.is_none_or(|(least, _)| found < least);
        let courses = &self.courses;
        let falls_with =
            |sum: &Course<i128>, lowest: &Least<i128>, [alone, with_end]: [i128; 2]| {
                falls(sum, alone) || gets_below(lowest, sum.sum + with_end)
            };
        let net = [sums.least_net, sums.least_stored];
        let ([low, high], [lowest, highest]) = (&courses.supply, &courses.lowest);
        let ([a, b], [c, d]) = (sums.least_supply, sums.least_supplied);
        Asked {
            net: match running {
                true => falls(&courses.net, sums.least_net),
                false => falls_with(&courses.net, &courses.stored, net),
            },
            worst: gets_below(&courses.worst, sums.least_row),
            supply: [
                running && falls_with(low, lowest, [a, c]),
                running && falls_with(high, highest, [b, d]),
            ],
        }
    }

    /// Takes note of so many intervals with the same answers, the first of them `h`.
    #[inline(always)]
    fn tally(&mut self, truths: Truths, h: u64, times: u64) {
        if let Some((_, _, count)) = self.tallied.iter_mut().find(|(of, ..)| *of == truths) {
            *count += times;
            return;
        }
        self.tallied.push((truths, h, times));
        for (first, is) in self.firsts.iter_mut().zip(kinds(truths)) {
            if is {
                first.get_or_insert(h);
            }
        }
    }

    /// The account of the intervals; `running` where the verdict is about what the operator has drawn.
    /// `place` gives an interval worth showing, by how many came before it.
    pub(crate) fn account(
        self,
        running: bool,
        place: impl Fn(u64) -> Result<Place, TraceError>,
    ) -> Result<Account, TraceError> {
        let mut tallies = Tallies::default();
        for (truths, first, times) in self.tallied {
            tallies.add_times(truths, first, times);
        }
        let mut account = Account {
            intervals: self.intervals,
            sums: self.sums.map(FigureSum::of_grid),
            net: RunningSum::of_grid(self.courses.net, self.intervals),
            observer: RunningSum::of_grid(self.observer, self.intervals),
            tallies,
            ..Account::default()
        };
        if running {
            let sums = self
                .courses
                .supply
                .map(|sum| RunningSum::of_grid(sum, self.intervals));
            let lowest = self.courses.lowest.map(lowest);
            account.supply =
                Supply::from_parts(sums, lowest, Some(self.excess.unwrap_or(NO_FORCE)));
        } else {
            account.stored = lowest(self.courses.stored);
        }
        for (slot, first) in account.firsts.iter_mut().zip(self.firsts) {
            *slot = first.map(&place).transpose()?;
        }
        if let Some((least, h)) = self.courses.worst.0 {
            account.worst = Some((on_grid(least), place(h - 1)?));
        }
        Ok(account)
    }
}
