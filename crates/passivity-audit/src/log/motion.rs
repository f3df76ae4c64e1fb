//! What a motion between two samples comes to in spans, and what a force makes of it.

use std::collections::HashMap;

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{Criterion, Friction, Loop, Ordered as _, Step, Truth, dissipation};

use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::{Figure, not};
use crate::ledger::{Ledger, Read, Truths};
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::UNIT;
use crate::log::layout::Layout;
use crate::log::step::{check_jump, duration};
use crate::log::supply::{self, Bounds, Supplied};
use crate::number::{Number, Written as _};
use crate::reading::Reading;
use crate::span::Span;

/// What is computed of an interval once, for all accounts that are kept of it.
#[derive(Clone, Debug)]
pub(crate) enum Motion {
    /// Between two known positions: what it comes to under any force.
    Known(Known),
    /// Between two counts, whose account under the wall's own law is part of that under another force.
    Counted(Box<Addend>),
}

/// What an interval between two known positions comes to under any force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known {
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

/// What of motions is kept from chunk to chunk.
#[derive(Debug, Default)]
pub(crate) struct Motions {
    /// What intervals between counts add, by the ticks they cross and by Δτ: of an interval from 0.
    counted: HashMap<[i64; 3], Addend>,
}

/// The most intervals between counts that are kept.
const MOST: usize = 1 << 14;

impl Motions {
    /// The motions of all intervals of a chunk for which `is_asked`, where spans leave nothing open; empty where
    /// there is none of them, and of a loop whose force remembers earlier samples.
    pub(crate) fn all(
        &mut self,
        ledger: &Ledger,
        layout: &Layout,
        chunk: &Chunk,
        is_asked: impl Fn(usize, &Number) -> bool,
    ) -> Vec<Option<Motion>> {
        let intervals = chunk.samples.len().saturating_sub(1);
        let lasts = |i: usize| {
            let dtau = duration(layout, chunk, i).ok()?.unwrap_or(UNIT);
            is_asked(i, &dtau).then_some(dtau)
        };
        if ledger.has_memory() || !(0..intervals).any(|i| lasts(i).is_some()) {
            return Vec::new();
        }
        let motion = |i: usize| {
            let dtau = lasts(i)?;
            match &chunk.samples {
                Samples::Any(samples) => {
                    let (from, to) = (samples.get(i)?, samples.get(i + 1)?);
                    let known = Known::of(ledger.near(), from, to, &Span::of(&dtau))?;
                    Some(Motion::Known(known))
                }
                Samples::Counts(counts) => {
                    let counts = [*counts.get(i)?, *counts.get(i + 1)?];
                    Some(Motion::Counted(Box::new(
                        self.counted(ledger, counts, &dtau)?,
                    )))
                }
            }
        };
        (0..intervals).map(motion).collect()
    }

    /// What an interval between counts adds under the force of the wall alone, which depends on where it
    /// starts only by what the observer adds and by the potential where it ends.
    fn counted(&mut self, ledger: &Ledger, [from, to]: [i64; 2], dtau: &Number) -> Option<Addend> {
        check_jump(from, to).ok()?;
        let Number::Small(n, d) = dtau else {
            return None;
        };
        if !ledger.is_plain() {
            return None;
        }
        let crossed = to - from;
        let key = [crossed, *n, *d];
        let addend = match self.counted.get(&key) {
            Some(addend) => addend.clone(),
            None => {
                let [start, end] = [0, crossed].map(Reading::Count);
                let read = Read {
                    samples: std::slice::from_ref(&start).iter(),
                    end: &end,
                    force: None,
                };
                let entry = ledger.near_entry(read, dtau)?;
                let addend = Addend::of_entry(ledger.near(), &entry, None, None)?;
                if self.counted.len() < MOST {
                    self.counted.insert(key, addend.clone());
                }
                addend
            }
        };
        let (start, end) = (Span::whole(from), Reading::Count(to).to_near());
        let force = ledger.near().least.law().held_force(&start);
        let observed = -(force * (*end.lo() - start));
        let [potential, _] = supply::potential_on(ledger.near(), &end)?;
        Some(Addend {
            observed: observed.defined()?[0],
            potential: crate::span::units(&potential)?,
            ..addend
        })
    }
}

impl Known {
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
        let taken = dissipated(&ends.least);
        let moves = speed.is_positive()?;
        let at_least = !moves || holds(least)?;
        // Friction that is known has one end.
        let (most_taken, at_most) = match ends.friction_is_exact() {
            true => (taken, at_least),
            false => (dissipated(&ends.most), !moves || holds(most)?),
        };
        Some(Self {
            dissipated: [taken, most_taken],
            criterion_holds: Truth::over(at_least, at_most),
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
    /// What a row adds; after an interval with the excess force `before`, where the account is of T, and with
    /// this net energy under the wall's own force, where that is known.
    pub(crate) fn of_entry(
        ends: &Ends<Span>,
        entry: &Entry<Span>,
        before: Option<Option<&Bounds>>,
        own: Option<[i128; 2]>,
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
                Some(before) => Some(supply::contribution(ends, entry, own)?.supplied(before)?),
                None => None,
            },
        })
    }
}
