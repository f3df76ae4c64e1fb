//! The account of consecutive intervals whose rows spans decide: sums of integers of fixed width.

use crate::entry::Entry;
use crate::figure::Figure;
use crate::log::account::{Account, Place, kinds};
use crate::log::error::TraceError;
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::{Bounds, Contribution, Supply};
use crate::run::Tallies;
use crate::span::Span;
use crate::sum::FigureSum;

/// A running sum in units of the grid, from zero, and the least value it had, the start included.
#[derive(Clone, Copy, Debug, Default)]
struct Course {
    now: i128,
    least: i128,
    at: u64,
}

impl Course {
    /// With another step, the `h`th, from 1; `None` where it does not fit.
    fn with(self, step: i128, h: u64) -> Option<Self> {
        let now = self.now.checked_add(step)?;
        Some(match now < self.least {
            true => Self {
                now,
                least: now,
                at: h,
            },
            false => Self { now, ..self },
        })
    }

    fn sum(self, steps: u64) -> RunningSum {
        RunningSum::of_grid([self.now, self.least], self.at, steps)
    }
}

/// The least of some energies in units of the grid, and after how many intervals it was.
#[derive(Clone, Copy, Debug, Default)]
struct Least(Option<(i128, u64)>);

impl Least {
    fn keep(&mut self, value: i128, h: u64) {
        if self.0.is_none_or(|(least, _)| value < least) {
            self.0 = Some((value, h));
        }
    }

    fn lowest(self) -> Option<Lowest> {
        let (value, h) = self.0?;
        Some(Lowest::new(crate::span::on_grid(value), h))
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
    /// What is left of what was stored at the start, where the verdict is about it.
    supply: Supply,
    tallies: Tallies,
    /// The first interval of each kind, and the one with the least net energy.
    firsts: [Option<u64>; 5],
    worst: Least,
}

impl Batch {
    /// After an interval with this excess force.
    pub(crate) fn after(excess: Option<Bounds>) -> Self {
        Self {
            supply: Supply::after(excess),
            ..Self::default()
        }
    }

    /// Adds an interval, with the least potential where it ends and, where that is asked for, what it
    /// contributes to what is left; `None`, and nothing added, where something does not fit.
    pub(crate) fn add(
        &mut self,
        entry: &Entry<Span>,
        potential: i128,
        contribution: Option<&Contribution>,
    ) -> Option<()> {
        let h = self.intervals + 1;
        let account = &entry.account;
        let mut sums = self.sums;
        for ([lo, hi], figure) in sums.iter_mut().zip(entry.summed()) {
            let [least, most] = ends(figure)?;
            *lo = lo.checked_add(least)?;
            *hi = hi.checked_add(most)?;
        }
        let [least_net, _] = ends(&account.net_linear)?;
        let [observed, _] = entry.observed().defined()?;
        let [net, observer] = [
            self.net.with(least_net, h)?,
            self.observer.with(observed, h)?,
        ];
        let stored = net.now.checked_add(potential)?;
        if let Some(contribution) = contribution {
            self.supply.add(contribution, h)?;
        }
        // Everything fits.
        self.intervals = h;
        (self.sums, self.net, self.observer) = (sums, net, observer);
        self.stored.keep(stored, h);
        self.worst.keep(least_net, h - 1);
        let truths = entry.truths();
        self.tallies.add_times(truths, h - 1, 1);
        for (first, is) in self.firsts.iter_mut().zip(kinds(truths)) {
            if is {
                first.get_or_insert(h - 1);
            }
        }
        Some(())
    }

    /// The account of the intervals; `running` where the verdict is about what the operator has drawn.
    /// `place` gives an interval worth showing, by how many came before it.
    pub(crate) fn account(
        self,
        running: bool,
        place: impl Fn(u64) -> Result<Place, TraceError>,
    ) -> Result<Account, TraceError> {
        let mut account = Account {
            intervals: self.intervals,
            sums: self.sums.map(FigureSum::of_grid),
            net: self.net.sum(self.intervals),
            observer: self.observer.sum(self.intervals),
            tallies: self.tallies,
            ..Account::default()
        };
        if running {
            account.supply = self.supply;
        } else {
            account.stored = self.stored.lowest();
        }
        for (slot, first) in account.firsts.iter_mut().zip(self.firsts) {
            *slot = first.map(&place).transpose()?;
        }
        if let Some((least, h)) = self.worst.0 {
            account.worst = Some((crate::span::on_grid(least), place(h)?));
        }
        Ok(account)
    }
}

fn ends(figure: &Figure<Span>) -> Option<[i128; 2]> {
    let ([lo, _], [_, hi]) = (figure.lo().defined()?, figure.hi().defined()?);
    Some([lo, hi])
}
