//! Scenes with a latency that is no whole number of periods, in lanes: two motions in an interval.
//!
//! See [`crate::latency`]: in the first part the force of the sample before acts, in the second this one's,
//! each part with its length as the unit of time.

use super::batch::{Batch, Lane, Motion, select};
use super::law::{Laws, grow};
use super::{Points, WIDTH};
use crate::plan::Plan;

/// The controllers of a batch, and the motions in the parts of an interval.
pub(super) struct Late {
    pub(super) laws: Laws,
    parts: Vec<Part>,
}

/// A part of an interval.
struct Part {
    /// Its length, in periods.
    time: f64,
    motion: Motion,
    /// Whether its points take the longer series.
    long: bool,
}

impl Late {
    pub(super) fn new(plan: &Plan, long_series: &[bool]) -> Self {
        let part = |((time, _), long): (&(f64, Plan), &bool)| Part {
            time: *time,
            motion: Motion::new(),
            long: *long,
        };
        Self {
            laws: Laws::new(&plan.law),
            parts: plan.parts.iter().zip(long_series).map(part).collect(),
        }
    }

    /// Whether the force of a plan changes when it does in these lanes.
    pub(super) fn is_like(&self, plan: &Plan) -> bool {
        let times = plan.parts.iter().map(|(time, _)| *time);
        times.eq(self.parts.iter().map(|part| part.time))
    }

    pub(super) fn load(&mut self, lane: usize, plan: &Plan) {
        self.laws.load(lane, plan);
        for (part, (_, plan)) in self.parts.iter_mut().zip(&plan.parts) {
            part.motion.load(lane, &plan.constants);
        }
    }
}

/// Runs every busy lane for `intervals` intervals.
#[inline(always)]
pub(super) fn stretch(batch: &mut Batch, late: &mut Late, points: &Points, intervals: u32) {
    for _ in 0..intervals {
        grow(batch, &late.laws, &late.laws.held, points);
        let mut force = late.laws.held;
        late.laws.sample(&batch.xi);
        judge(batch, &mut late.laws, &force);
        let (mut xi, mut v) = (batch.xi, batch.v);
        for part in &late.parts {
            if part.long {
                lead::<true>(batch, part, &force, &mut xi, &mut v);
            } else {
                lead::<false>(batch, part, &force, &mut xi, &mut v);
            }
            force = late.laws.held;
        }
        for i in 0..WIDTH {
            let busy = batch.busy[i];
            batch.edges.see(i, xi[i], batch.size(i));
            batch.xi[i] = select(busy > 0.0, xi[i], batch.xi[i]);
            batch.v[i] = select(busy > 0.0, v[i], batch.v[i]);
            batch.count[i] += select(busy > 0.0, 1.0, 0.0);
        }
    }
}

/// Finds out which lanes rest; `earlier` are the forces of the sample
/// before.
#[inline(always)]
fn judge(batch: &mut Batch, laws: &mut Laws, earlier: &Lane) {
    // A copy, so that no store is in the way of a load.
    let in_the_end = *laws.in_the_end();
    for i in 0..WIDTH {
        let sigma = batch.sigma[i];
        let taken = |force: f64| force.abs() <= sigma;
        let forces = taken(earlier[i]) & taken(laws.held[i]) & taken(in_the_end[i]);
        let rests = (batch.v[i] == 0.0) & forces;
        let resting = select(rests, laws.resting[i] + 1.0, 0.0);
        let busy = batch.busy[i];
        batch.busy[i] = select((resting > laws.needed) & (busy > 0.0), 0.0, busy);
        laws.resting[i] = resting;
    }
}

/// Leads all lanes over a part of an interval.
#[inline(always)]
fn lead<const MEDIUM: bool>(batch: &Batch, part: &Part, force: &Lane, xi: &mut Lane, v: &mut Lane) {
    for i in 0..WIDTH {
        // As the scalar loop adds the operator's force, which is none: no force of −0.
        let held = force[i] + 0.0;
        let forces = [held, batch.beyond(i, held)];
        let state = [xi[i], v[i] * part.time];
        let [position, velocity] = part
            .motion
            .moved::<MEDIUM>(i, state, batch.sigma[i], forces);
        (xi[i], v[i]) = (position, velocity / part.time);
    }
}
