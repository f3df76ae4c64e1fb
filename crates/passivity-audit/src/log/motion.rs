//! What a motion between two samples comes to in spans, and what a force makes of it.

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Criterion, Friction, Loop, Ordered as _, Step, Truth, dissipation};

use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::{Figure, not};
use crate::ledger::{Ledger, Truths};
use crate::log::chunk::{Chunk, Samples};
use crate::log::layout::Layout;
use crate::log::step::duration;
use crate::log::supply::{self, Bounds, Supplied};
use crate::number::Written as _;
use crate::reading::Reading;
use crate::span::Span;

/// What an interval between two known positions comes to under any force: computed once for all accounts
/// that are kept of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    /// The least that friction takes (26), of the loop with the least and with the most friction.
    dissipated: [Span; 2],
    /// Whether the criterion holds at the mean speed.
    criterion_holds: Truth,
    /// The wall's potential where it ends.
    potential: Span,
}

/// What an interval adds to the sums of an account, in units of the grid.
#[derive(Clone, Debug)]
pub(crate) struct Addend {
    /// The five figures that totals are kept of, at the least and at the most.
    pub(crate) sums: [[i128; 2]; 5],
    /// What the observer adds.
    pub(crate) observed: i128,
    /// The least potential where the interval ends.
    pub(crate) potential: i128,
    pub(crate) truths: Truths,
    /// What it adds to T, where the verdict is about that.
    pub(crate) supply: Option<Supplied>,
}

impl Motion {
    /// The motions of all intervals of a chunk, where they are of known positions and spans leave nothing
    /// open; none of a loop whose force remembers earlier samples.
    pub(crate) fn all(ledger: &Ledger, layout: &Layout, chunk: &Chunk) -> Vec<Option<Self>> {
        let Samples::Any(samples) = &chunk.samples else {
            return Vec::new();
        };
        if ledger.has_memory() {
            return Vec::new();
        }
        let near = ledger.near();
        let motion = |(i, pair): (usize, &[Reading])| {
            let [from, to] = pair else { return None };
            let dtau = duration(layout, chunk, i).ok()?;
            let dtau = dtau.map_or_else(|| Span::whole(1), |dtau| Span::of(&dtau));
            Self::of(near, from, to, &dtau)
        };
        samples.windows(2).enumerate().map(motion).collect()
    }

    fn of(ends: &Ends<Span>, from: &Reading, to: &Reading, dtau: &Span) -> Option<Self> {
        let step = step(from, to)?;
        let d = step.displacement();
        let speed = dissipation::mean_speed(&d, dtau);
        let dissipated = |of: &Loop<Span>| {
            let friction = Friction::new(of.viscous_friction(), of.coulomb_friction());
            friction.dissipated_lower(&d, &speed)
        };
        let holds = |criterion: &Criterion<Span>| criterion.margin(&speed).is_nonnegative();
        let [least, most] = &ends.criteria;
        let criterion_holds = match (speed.is_positive()?, ends.friction_is_exact()) {
            (false, _) => Truth::Holds,
            (true, true) => truth(holds(least)?),
            (true, false) => Truth::over(holds(least)?, holds(most)?),
        };
        let taken = dissipated(&ends.least);
        Some(Self {
            dissipated: match ends.friction_is_exact() {
                true => [taken, taken],
                false => [taken, dissipated(&ends.most)],
            },
            criterion_holds,
            potential: ends.least.law().potential(&known(to)?),
        })
    }

    /// What the interval adds to an account, under the force that the log has or, without one, under that of
    /// the loop's controller; `None` where spans leave something open. After an interval with the excess
    /// force `before`, where the account is of T.
    pub(crate) fn addend(
        &self,
        ends: &Ends<Span>,
        [from, to]: [&Reading; 2],
        force: Option<&Reading>,
        before: Option<Option<&Bounds>>,
    ) -> Option<Addend> {
        let step = step(from, to)?;
        let force = match force {
            Some(force) => known(force)?,
            None => ends
                .controller
                .held_force(&[ends.controller.measured(&step.start)]),
        };
        let observed = -(force * step.displacement());
        let held = HeldInterval {
            step,
            force,
            // What is generated does not depend on it.
            dtau: Span::whole(1),
            extra_storage: None,
        };
        let [linear, quantized] = ledger::generated(&ends.least, &held);
        let [least, most] = self.dissipated;
        let (net_linear, net_quantized) = (
            [least - linear, most - linear],
            [least - quantized, most - quantized],
        );
        let sums = [
            between(linear, linear)?,
            between(quantized, quantized)?,
            between(least, most)?,
            between(net_linear[0], net_linear[1])?,
            between(net_quantized[0], net_quantized[1])?,
        ];
        let potential = self.potential.defined()?;
        let [observed, _] = observed.defined()?;
        Some(Addend {
            observed,
            potential: potential[0],
            truths: Truths {
                criterion_holds: self.criterion_holds,
                violates_linear: violates(&net_linear)?,
                violates_quantized: violates(&net_quantized)?,
            },
            supply: match before {
                Some(before) => Some(Supplied::known(sums[3], potential, before)?),
                None => None,
            },
            sums,
        })
    }
}

/// The lower end of one number and the upper end of another, in units of the grid.
#[inline]
fn between(least: Span, most: Span) -> Option<[i128; 2]> {
    match (least.defined(), most.defined()) {
        (Some([lo, _]), Some([_, hi])) => Some([lo, hi]),
        _ => None,
    }
}

/// Whether an account is short with this net energy, at the least and at the most friction.
#[inline]
fn violates([least, most]: &[Span; 2]) -> Option<Truth> {
    let kept = Truth::over(least.is_nonnegative()?, most.is_nonnegative()?);
    Some(not(kept))
}

const fn truth(holds: bool) -> Truth {
    Truth::over(holds, holds)
}

/// What is known of a number, where it is one span.
#[inline]
fn known(reading: &Reading) -> Option<Span> {
    match reading.to_near() {
        Figure::Exact(x) => Some(x),
        Figure::Enclosed(_) => None,
    }
}

/// The step between two samples. Of what stands still, any position that it may have stands for all.
#[inline]
fn step(from: &Reading, to: &Reading) -> Option<Step<Span>> {
    let (start, end) = (known(from)?, known(to)?);
    Some(match from.is_same(to) {
        true => Step::new(start.one_of(), start.one_of()),
        false => Step::new(start, end),
    })
}

impl Addend {
    /// What a row adds, where it is known that everything fits; after an interval with the excess force
    /// `before`, where the account is of T.
    pub(crate) fn of_entry(
        ends: &Ends<Span>,
        entry: &Entry<Span>,
        before: Option<Option<&Bounds>>,
    ) -> Option<Self> {
        let [a, b, c, d, e] = entry
            .summed()
            .map(|figure| between(*figure.lo(), *figure.hi()));
        let [potential, _] = supply::potential_on(ends, &entry.xi1)?;
        Some(Self {
            sums: [a?, b?, c?, d?, e?],
            observed: entry.observed().defined()?[0],
            potential: crate::span::units(&potential)?,
            truths: entry.truths(),
            supply: match before {
                Some(before) => Some(supply::contribution(ends, entry)?.supplied(before)?),
                None => None,
            },
        })
    }
}
