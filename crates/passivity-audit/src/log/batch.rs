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
    net: RunningSum,
    observer: RunningSum,
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
            net: RunningSum::on_grid(),
            observer: RunningSum::on_grid(),
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
        let (mut net, mut observer) = (self.net.clone(), self.observer.clone());
        if !(net.add_scaled(least_net) && observer.add_scaled(observed)) {
            return None;
        }
        let stored = net.now().checked_add(potential)?;
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
            net: self.net,
            observer: self.observer,
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
