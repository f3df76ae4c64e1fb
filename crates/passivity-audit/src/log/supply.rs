//! What is left of the energy that was stored at the start (TH-RUN): where it is below zero, the
//! operator has drawn more than that.
//!
//! After h intervals that is T = V(ξ_h) + Σ(E_d − E_gᴸ) = V(ξ₀) + Σ(E_d − F·d), of the force F that
//! was held: the least that friction took, less the work of the force. The kinetic energy is in no
//! trace; the operator can take it at any time, so it counts as drawn.
//!
//! Of counts each figure is enclosed. An interval alone leaves room for F times a tick or two, and
//! F may be hundreds of KΔ, but a position that ends one interval starts the next. So the force is
//! split into that of the wall at the middle of the tick, whose work the potential nearly takes up,
//! and an excess G, whose work is summed by parts: with n the lower end of what is known of ξ and
//! ρ = ξ − n, Σ G_i(ξ_{i+1} − ξ_i) = Σ G_i(n_{i+1} − n_i) − Σ (G_i − G_{i−1})ρ_i + G_last·ρ_h.

use passivity_core::BigRational;
use passivity_core::course::Last;

use super::running::{Lowest, RunningSum};
use crate::ball::Ball;
use crate::enclosure::Rectangle;
use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::Figure;
use crate::ledger::{Ledger, Logged, Row, on_entry};
use crate::log::computed::Accounted;
use crate::log::counted;
use crate::log::motion::WIDEST;
use crate::number::{Reduced, Written};
use crate::reading::Reading;
use crate::span::{ONE, below_on_grid, outward, units};

/// The two ends of what is known of a number.
pub(crate) type Bounds = [Reduced; 2];

/// What an interval adds to T.
#[derive(Clone, Debug)]
pub(crate) struct Contribution {
    /// Net energy under the wall's own force at the middle of the tick.
    net: Bounds,
    /// G.
    excess: Bounds,
    /// n₁ − n₀.
    advance: Reduced,
    /// The most that ρ₀ can be.
    room: Reduced,
    /// V(ξ₁) − G·ρ₁: what counts only as long as the trace ends here.
    end: Bounds,
    /// Whether the numbers are those of doubles.
    near: bool,
}

/// No excess force.
pub(crate) const NO_FORCE: Bounds = [Reduced::ZERO, Reduced::ZERO];

/// What an interval adds to T, in units of the grid: at the least and at the most.
#[derive(Clone, Debug)]
pub(crate) struct Supplied {
    pub(crate) step: [i128; 2],
    /// What T has beside as long as the trace ends here.
    pub(crate) end: [i128; 2],
    /// Its excess force, where it has any.
    pub(crate) excess: Option<Bounds>,
}

impl Supplied {
    /// Of an interval between known positions, with this net energy and this potential where it ends.
    #[inline]
    pub(crate) fn known(net: [i128; 2], end: [i128; 2], before: Option<&Bounds>) -> Option<Self> {
        if before.is_none() {
            return Some(Self {
                step: net,
                end,
                excess: None,
            });
        }
        Contribution::known(net, end).supplied(before)
    }

    /// Whether all of it has room in sums.
    pub(crate) fn fits(&self) -> bool {
        let ends = self.step.iter().chain(&self.end);
        ends.fold(0, |bits, n| bits | n.unsigned_abs()) < WIDEST
    }
}

/// The most that ρ₀ can be of a number that is enclosed: two steps of the coarse grid of readings.
const ROOM: Reduced = Reduced::Small(1, 1 << (crate::reading::GRID_BITS - 1));

impl Contribution {
    /// The contribution of an interval with this row; `None` when a number is undefined.
    pub(crate) fn of(ledger: &Ledger, interval: &Logged, row: &Accounted) -> Option<Self> {
        let row = match row {
            Accounted::Near(entry) => return contribution(ledger.near(), entry),
            Accounted::Quick(addend) => {
                if let Some(figures) = counted::Figures::of_interval(ledger, interval) {
                    return Some(figures.contribution());
                }
                let [_, _, _, net, _] = addend.sums;
                return Some(Self::known(net, addend.potential));
            }
            Accounted::Exact(row) => return Self::of_exact(ledger, interval, row),
            Accounted::Decided(row) => Self::of_exact(ledger, interval, row)?,
        };
        Some(Self {
            net: outward(row.net),
            excess: outward(row.excess),
            end: outward(row.end),
            ..row
        })
    }

    /// Of an interval between known positions, with this net energy and this potential where it ends.
    fn known(net: [i128; 2], end: [i128; 2]) -> Self {
        Self {
            net: net.map(|n| Reduced::Small(n, ONE)),
            excess: NO_FORCE,
            advance: Reduced::ZERO,
            room: ROOM,
            end: end.map(|n| Reduced::Small(n, ONE)),
            near: true,
        }
    }

    /// Of an interval between two counts, with this net energy under the wall's own force and this excess over it, in
    /// units of the grid.
    pub(crate) fn counted(
        net: [i128; 2],
        excess: [i128; 2],
        advance: Reduced,
        end: [i128; 2],
    ) -> Self {
        let on_grid = |ends: [i128; 2]| ends.map(|n| Reduced::Small(n, ONE));
        Self {
            net: on_grid(net),
            excess: on_grid(excess),
            advance,
            room: Reduced::Small(1, 1),
            end: on_grid(end),
            near: true,
        }
    }

    fn of_exact(ledger: &Ledger, interval: &Logged, row: &Row) -> Option<Self> {
        if let (Row::Fixed(entry), Some(ends)) = (row, ledger.fixed())
            && let Some(found) = contribution(ends, entry)
        {
            return Some(found);
        }
        match row {
            Row::Wide(entry) => contribution(ledger.ample(), entry),
            Row::Fixed(_) => contribution(ledger.ample(), &ledger.wide_entry(interval)?),
        }
    }

    /// The excess force.
    pub(crate) const fn excess(&self) -> &Bounds {
        &self.excess
    }

    /// Net energy under the wall's own force, the excess force and what counts where the trace ends here.
    #[cfg(test)]
    pub(crate) fn parts(self) -> [Bounds; 3] {
        [self.net, self.excess, self.end]
    }

    /// What the interval adds to T, after one with this excess force, in units of the grid; `None`
    /// where it is not on it.
    pub(crate) fn supplied(self, before: Option<&Bounds>) -> Option<Supplied> {
        let [least, most] = self.step(before.unwrap_or(&NO_FORCE))?;
        let [first, last] = &self.end;
        Some(Supplied {
            step: [units(&least)?, units(&most)?],
            end: [units(first)?, units(last)?],
            excess: (self.excess != NO_FORCE).then_some(self.excess),
        })
    }

    /// What the interval adds to Σ, after one with this excess force.
    fn step(&self, before: &Bounds) -> Option<Bounds> {
        if self.excess == NO_FORCE && *before == NO_FORCE {
            return Some(self.net.clone());
        }
        let on_grid = || self.step_on_grid(before);
        let in_doubles = || self.step_in::<Ball>(before);
        let near = self.near.then(|| on_grid().or_else(in_doubles)).flatten();
        near.or_else(|| self.step_in::<passivity_core::Fixed>(before))
            .or_else(|| self.step_in::<crate::number::Ample>(before))
    }

    /// The same of numbers on the grid and whole ticks, exactly.
    fn step_on_grid(&self, before: &Bounds) -> Option<Bounds> {
        let both = |[lo, hi]: &Bounds| units(lo).zip(units(hi));
        let whole = |x: &Reduced| match x {
            Reduced::Small(n, 1) => Some(*n),
            _ => None,
        };
        let (excess, before, net) = (both(&self.excess)?, both(before)?, both(&self.net)?);
        let (advance, room) = (whole(&self.advance)?, whole(&self.room)?);
        let (a, b) = (
            excess.0.checked_mul(advance)?,
            excess.1.checked_mul(advance)?,
        );
        let change = |from: i128, to: i128| to.checked_sub(from)?.checked_mul(room);
        let (fall, rise) = (change(before.1, excess.0)?, change(before.0, excess.1)?);
        let least = net.0.checked_sub(a.max(b))?.checked_add(fall.min(0))?;
        let most = net.1.checked_sub(a.min(b))?.checked_add(rise.max(0))?;
        Some([Reduced::Small(least, ONE), Reduced::Small(most, ONE)])
    }

    fn step_in<S: Written>(&self, before: &Bounds) -> Option<Bounds> {
        let both = |[lo, hi]: &Bounds| S::from_reduced(lo).zip(S::from_reduced(hi));
        let (excess, before, net) = (both(&self.excess)?, both(before)?, both(&self.net)?);
        let (advance, room) = (
            S::from_reduced(&self.advance)?,
            S::from_reduced(&self.room)?,
        );
        let work = [excess.0.clone(), excess.1.clone()].map(|force| force * advance.clone());
        let [a, b] = work;
        let change = (excess.0 - before.1, excess.1 - before.0);
        let least = net.0 - a.clone().max(b.clone()) + (change.0 * room.clone()).min(S::zero());
        let most = net.1 - a.min(b) + (change.1 * room).max(S::zero());
        Some([least.below()?, most.above()?])
    }
}

/// The contribution of a row.
pub(crate) fn contribution<S: Written>(ends: &Ends<S>, entry: &Entry<S>) -> Option<Contribution> {
    let (start, end) = (&entry.xi0, &entry.xi1);
    let law = ends.least.law();
    let bounds = |of: &Figure<S>| Some([of.lo().below()?, of.hi().above()?]);
    if let (true, Figure::Exact(to)) = (start.is_exact(), end) {
        return Some(Contribution {
            net: {
                let [least, most] = entry.kept();
                [least.below()?, most.above()?]
            },
            excess: NO_FORCE,
            advance: Reduced::ZERO,
            room: if S::EXACT { Reduced::ZERO } else { ROOM },
            near: !S::EXACT,
            end: bounds(&Figure::Exact(law.potential(to)))?,
        });
    }
    let own = law.held_force(start.lo());
    let excess = entry.held.minus(&Figure::Exact(own.clone()))?;
    let rectangle = Rectangle {
        ends,
        start,
        end,
        force: &Figure::Exact(own),
        dtau: &entry.dtau,
    };
    let potential =
        |xi: &S, force: &S| law.potential(xi) - force.clone() * (xi.clone() - end.lo().clone());
    // Convex in ξ, so least where the potential's slope is the force, or at an end.
    let balance = excess
        .hi()
        .clone()
        .max(end.lo().clone())
        .min(end.hi().clone());
    let least = [end.lo(), &balance, end.hi()].map(|xi| potential(xi, excess.hi()));
    let most = [end.lo(), end.hi()].map(|xi| potential(xi, excess.lo()));
    let [first, second, third] = least;
    let [fourth, fifth] = most;
    Some(Contribution {
        net: bounds(&rectangle.net_linear()?)?,
        excess: bounds(&excess)?,
        advance: (end.lo().clone() - start.lo().clone()).to_reduced()?,
        room: (start.hi().clone() - start.lo().clone()).above()?,
        end: [
            first.min(second).min(third).below()?,
            fourth.max(fifth).above()?,
        ],
        near: !S::EXACT,
    })
}

/// T over a stretch of a trace, from zero at its start.
#[derive(Clone, Debug, Default)]
pub(crate) struct Supply {
    /// Σ at the least and at the most.
    sums: [RunningSum; 2],
    /// The least that T was, taken at the least and at the most.
    lowest: [Option<Lowest>; 2],
    /// G of the last interval.
    pub(crate) excess: Option<Bounds>,
}

impl Supply {
    /// Goes on with an interval, the `h`th, from 1; `None` when a number is undefined.
    pub(crate) fn add(&mut self, contribution: &Contribution, h: u64) -> Option<()> {
        let before = self.excess.take().unwrap_or(NO_FORCE);
        let step = contribution.step(&before)?;
        let ends = step.iter().zip(&contribution.end);
        for ((sum, lowest), (step, end)) in self.sums.iter_mut().zip(&mut self.lowest).zip(ends) {
            sum.add(step);
            Lowest::keep_sum(lowest, sum, end, h);
        }
        self.excess = Some(contribution.excess.clone());
        Some(())
    }

    /// Goes on with what came after.
    pub(crate) fn append(&mut self, other: Self) {
        let others = other.sums.iter().zip(other.lowest);
        let ours = self.sums.iter_mut().zip(&mut self.lowest);
        for ((sum, lowest), (added, found)) in ours.zip(others) {
            Lowest::append(lowest, found, sum);
            sum.append(added);
        }
        let mut excess = Last(self.excess.take());
        excess.append(Last(other.excess));
        self.excess = excess.0;
    }

    /// Σ at the least and at the most.
    pub(crate) const fn sums(&self) -> &[RunningSum; 2] {
        &self.sums
    }

    /// What was kept elsewhere, of a stretch that another follows.
    pub(crate) const fn from_parts(
        sums: [RunningSum; 2],
        lowest: [Option<Lowest>; 2],
        excess: Option<Bounds>,
    ) -> Self {
        Self {
            sums,
            lowest,
            excess,
        }
    }

    /// The least that T was: taken at the least, and at the most.
    pub(crate) const fn lowest(&self) -> [Option<&Lowest>; 2] {
        let [least, most] = &self.lowest;
        [least.as_ref(), most.as_ref()]
    }
}

/// The least and the largest potential of the wall at a sample that is known on some kind of numbers, in
/// KΔ².
pub(crate) fn potential_on<S: Written>(ends: &Ends<S>, sample: &Figure<S>) -> Option<[Reduced; 2]> {
    let law = ends.least.law();
    // The potential is convex with its least value at 0, which no tick has inside it.
    let [a, b] = [sample.lo(), sample.hi()].map(|xi| law.potential(xi));
    Some([a.clone().min(b.clone()).below()?, a.max(b).above()?])
}

/// The least and the largest potential of the wall at a sample, in KΔ².
pub(crate) fn potential(ledger: &Ledger, sample: &Reading) -> Option<[Reduced; 2]> {
    let on_machine_integers = || potential_on(ledger.fixed()?, &sample.to_fixed()?);
    on_machine_integers().or_else(|| potential_on(ledger.ample(), &sample.to_ample()))
}

/// −F·Δξ over the interval of a row: what the passivity observer adds. Enclosed numbers are taken
/// at their lower end: a count as it is.
pub(crate) fn observed(row: &Accounted) -> Option<Reduced> {
    fn of<S: Written>(entry: &Entry<S>) -> Option<Reduced> {
        if let Some(work) = entry.observed().below() {
            return Some(work);
        }
        let numbers = [entry.held.lo(), entry.xi0.lo(), entry.xi1.lo()];
        let work = |[force, from, to]: [BigRational; 3]| -(force * (to - from));
        let [force, from, to] = numbers.map(Written::to_rational);
        let (force, from, to) = (force?, from?, to?);
        Some(work([force, from, to]).into())
    }
    match row {
        Accounted::Near(entry) => of(entry),
        Accounted::Quick(addend) => Some(Reduced::Small(addend.observed, ONE)),
        Accounted::Exact(row) => on_entry!(row, entry => of(entry)),
        Accounted::Decided(row) => on_entry!(row, entry => of(entry)).map(below_on_grid),
    }
}
