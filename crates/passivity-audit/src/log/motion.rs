//! What a motion between two samples comes to in spans, and what a force makes of it.

use std::collections::HashMap;

use passivity_core::ledger::{self, HeldInterval};
use passivity_core::{
    Controller, Criterion, Friction, Loop, Ordered as _, Scalar as _, Step, Truth, dissipation,
};

use crate::ball::Ball;
use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::{Figure, not};
use crate::ledger::{Ledger, Logged, Read, Truths};
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::UNIT;
use crate::log::layout::Layout;
use crate::log::step::{check_jump, duration};
use crate::log::supply;
use crate::number::Number;
use crate::reading::Reading;
use crate::span::{Span, units};

/// What is computed of an interval once, for all accounts that are kept of it.
#[derive(Clone, Debug)]
pub(crate) enum Motion {
    /// Between two known positions: what it comes to under any force.
    Known(Known),
    /// Between two counts, whose account under the wall's own law is part of that under another force.
    Counted(Box<Addend>),
}

/// What an interval between two known positions comes to under any force, in doubles.
#[derive(Clone, Debug)]
pub(crate) struct Known {
    /// Δτ.
    pub(crate) lasts: Number,
    displacement: Ball,
    /// The force of the loop's controller, and what it generates against the wall's law and against its
    /// quantized form.
    commanded: Ball,
    generated: [Ball; 2],
    /// The least that friction takes (26), of the loop with the least and with the most friction.
    dissipated: [Ball; 2],
    /// Whether the criterion holds at the mean speed.
    criterion_holds: Truth,
    /// The wall's potential where it ends.
    potential: Ball,
}

/// What an interval adds to the sums of an account, in units of the grid.
#[derive(Clone, Debug)]
pub(crate) struct Addend {
    /// The five figures that totals are kept of, at the least and at the most.
    pub(crate) sums: [[i128; 2]; 5],
    /// What the observer adds.
    pub(crate) observed: i128,
    /// The potential where the interval ends, at the least and at the most.
    pub(crate) potential: [i128; 2],
    pub(crate) truths: Truths,
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
        let mut motions = Vec::with_capacity(intervals);
        match (&chunk.samples, ledger.quick()) {
            (Samples::Any(samples), Some(ends)) => {
                let mut starts = Starts::default();
                for (i, pair) in samples.windows(2).enumerate() {
                    let [from, to] = pair else { continue };
                    let known = match lasts(i) {
                        Some(dtau) => Known::of(ends, &mut starts, [from, to], dtau),
                        None => {
                            starts.start = None;
                            None
                        }
                    };
                    motions.push(known.map(Motion::Known));
                }
            }
            (Samples::Counts(counts), _) => {
                for (i, pair) in counts.windows(2).enumerate() {
                    let [from, to] = pair else { continue };
                    let counted =
                        lasts(i).and_then(|dtau| self.counted(ledger, [*from, *to], &dtau));
                    motions.push(counted.map(|addend| Motion::Counted(Box::new(addend))));
                }
            }
            (Samples::Any(_), None) => {}
        }
        motions
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
                let addend = Addend::of_entry(ledger.near(), &entry)?;
                if self.counted.len() < MOST {
                    self.counted.insert(key, addend.clone());
                }
                addend
            }
        };
        let (start, end) = (Span::whole(from), Reading::Count(to).to_near());
        let force = ledger.near().least.law().held_force(&start);
        let observed = -(force * (*end.lo() - start));
        let addend = Addend {
            observed: observed.defined()?[0],
            potential: potential(ledger.near(), &end)?,
            ..addend
        };
        addend.fits().then_some(addend)
    }
}

/// The forces of the loop's controller that some motions start with, near by, where they are known.
pub(crate) fn commanded(motions: &[Option<Motion>]) -> Vec<Option<f64>> {
    let force = |motion: &Option<Motion>| match motion {
        Some(Motion::Known(known)) => known.commanded.near(),
        _ => None,
    };
    motions.iter().map(force).collect()
}

/// What an interval starts with, kept from the one before it.
#[derive(Debug, Default)]
struct Starts {
    /// Where it starts, if that is where the last one ended.
    start: Option<Ball>,
    /// What was measured last, and the force for that: most steps are short.
    measured: Option<(Ball, Ball)>,
}

impl Starts {
    /// The force of a controller without memory.
    fn commanded(&mut self, controller: &Controller<Ball>, start: &Ball) -> Ball {
        let measured = controller.measured(start);
        match self.measured {
            Some((before, force)) if before == measured => force,
            _ => {
                let force = controller.held_force(&[measured]);
                self.measured = Some((measured, force));
                force
            }
        }
    }
}

impl Known {
    /// Of an interval of its own; `None` between counts, and of a loop whose force remembers earlier samples.
    pub(crate) fn of_interval(ledger: &Ledger, interval: &Logged) -> Option<Self> {
        match interval.samples.as_slice() {
            [start] if !ledger.has_memory() => Self::of(
                ledger.quick()?,
                &mut Starts::default(),
                [start, &interval.end],
                interval.dtau.clone(),
            ),
            _ => None,
        }
    }

    fn of(
        ends: &Ends<Ball>,
        starts: &mut Starts,
        [from, to]: [&Reading; 2],
        lasts: Number,
    ) -> Option<Self> {
        let start = match starts.start.take() {
            Some(start) => start,
            None => from.to_ball()?,
        };
        let end = to.to_ball()?;
        starts.start = Some(end);
        // Of what stands still, any position that it may have stands for all.
        let step = match from.is_same(to) {
            true => Step::new(start.one_of(), start.one_of()),
            false => Step::new(start, end),
        };
        let d = step.displacement();
        let speed = dissipation::mean_speed(&d, &Ball::of(&lasts));
        let dissipated = |of: &Loop<Ball>| {
            let friction = Friction::new(of.viscous_friction(), of.coulomb_friction());
            friction.dissipated_lower(&d, &speed)
        };
        let holds = |criterion: &Criterion<Ball>| criterion.margin(&speed).is_nonnegative();
        let [least, most] = &ends.criteria;
        let taken = dissipated(&ends.least);
        let moves = speed.is_positive()?;
        let at_least = !moves || holds(least)?;
        // Friction that is known has one end.
        let (most_taken, at_most) = match ends.friction_is_exact() {
            true => (taken, at_least),
            false => (dissipated(&ends.most), !moves || holds(most)?),
        };
        let commanded = starts.commanded(&ends.controller, &start);
        let held = HeldInterval {
            step,
            force: commanded,
            // What is generated does not depend on it.
            dtau: Ball::one(),
            extra_storage: None,
        };
        Some(Self {
            lasts,
            displacement: d,
            commanded,
            generated: ledger::generated(&ends.least, &held),
            dissipated: [taken, most_taken],
            criterion_holds: Truth::over(at_least, at_most),
            potential: ends.least.law().potential(&end),
        })
    }

    /// What the interval adds to an account, under the force that the log has or, without one, under that of
    /// the loop's controller; `None` where doubles leave something open.
    #[inline(always)]
    pub(crate) fn addend(&self, force: Option<&Reading>) -> Option<Addend> {
        let d = self.displacement;
        let (force, generated) = match force {
            None => (self.commanded, self.generated),
            Some(force) => {
                let force = force.to_ball()?;
                // What a force generates is its work and what no force changes.
                let more = (force - self.commanded) * d;
                (force, self.generated.map(|own| own + more))
            }
        };
        let [least, most] = self.dissipated;
        let is_one = least == most;
        let violates = |generated: Ball| {
            let at_least = (least - generated).is_nonnegative()?;
            let at_most = match is_one {
                true => at_least,
                false => (most - generated).is_nonnegative()?,
            };
            Some(not(Truth::over(at_least, at_most)))
        };
        let [linear, quantized] = generated;
        let truths = Truths {
            criterion_holds: self.criterion_holds,
            violates_linear: violates(linear)?,
            violates_quantized: violates(quantized)?,
        };
        let (linear, quantized) = (linear.on_grid()?, quantized.on_grid()?);
        let mut taken = least.on_grid()?;
        if !is_one {
            taken[1] = most.on_grid()?[1];
        }
        let net = |generated: [i128; 2]| [taken[0] - generated[1], taken[1] - generated[0]];
        Some(Addend {
            sums: [linear, quantized, taken, net(linear), net(quantized)],
            observed: (-(force * d)).on_grid()?[0],
            potential: self.potential.on_grid()?,
            truths,
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

impl Addend {
    /// What a row adds; `None` where something does not fit.
    pub(crate) fn of_entry(ends: &Ends<Span>, entry: &Entry<Span>) -> Option<Self> {
        let [a, b, c, d, e] = entry
            .summed()
            .map(|figure| between(*figure.lo(), *figure.hi()));
        let addend = Self {
            sums: [a?, b?, c?, d?, e?],
            observed: entry.observed().defined()?[0],
            potential: potential(ends, &entry.xi1)?,
            truths: entry.truths(),
        };
        addend.fits().then_some(addend)
    }

    /// Whether all of it is below 2³⁷ KΔ²: past that it is for exact numbers.
    fn fits(&self) -> bool {
        // The bits of all of them: together they are as wide as the widest.
        let ends = self.sums.iter().flatten().chain(&self.potential);
        let bits = ends.fold(self.observed.unsigned_abs(), |bits, n| {
            bits | n.unsigned_abs()
        });
        bits < WIDEST
    }
}

/// Past what any sum has room for as many of as a batch may have.
pub(crate) const WIDEST: u128 = 1 << 101;

/// The wall's potential at a sample, in units of the grid.
fn potential(ends: &Ends<Span>, sample: &Figure<Span>) -> Option<[i128; 2]> {
    let [least, most] = supply::potential_on(ends, sample)?;
    Some([units(&least)?, units(&most)?])
}
