//! A controller with any of its effects, in lanes.
//!
//! Every lane of a batch has the same controller, so that what is not in it is skipped for all of them
//! at once. Each effect is a loop of its own over the lanes, with the very operations of the table in
//! [`law`]. A lane that meets what only the scalar loop decides is *strange*: it stops, and its point
//! is run again there from its start.

use super::batch::{Batch, Lane, floor_lane, select};
use super::{GREW, Points, STRANGE, WIDTH};
use crate::flow::State;
use crate::law::{self, HeldForce};
use crate::plan::Plan;

/// The controllers of a batch.
pub(super) struct Laws {
    pub(super) law: HeldForce,
    /// The samples under way, a ring that all lanes share the index of.
    line: Vec<Lane>,
    next: usize,
    /// The sample before, for virtual damping.
    previous: Lane,
    /// What a filter remembers: samples and its own output, the latest first.
    samples: Vec<Lane>,
    past: Vec<Lane>,
    /// The held force.
    pub(super) held: Lane,
    /// How near to a jump of the law the samples of a stretch were, and the greatest |q| of all.
    nearest: Lane,
    reach: Lane,
    /// The force that is held in the end if the device stays where it is, where that is another one.
    settled: Option<Lane>,
    /// For how many intervals the device has been at rest.
    pub(super) resting: Lane,
    /// Past how many of them the controller has forgotten every other sample.
    pub(super) needed: f64,
}

impl Laws {
    pub(super) fn new(law: &HeldForce) -> Self {
        let zero = [0.0; WIDTH];
        let delay = if law.has(law::DELAY) { law.delay } else { 0 };
        Self {
            line: vec![zero; delay],
            next: 0,
            previous: zero,
            samples: vec![zero; law.filter.tails.len()],
            past: vec![zero; law.filter.poles.len()],
            held: zero,
            nearest: [f64::INFINITY; WIDTH],
            reach: zero,
            settled: law.lingers().then_some(zero),
            resting: zero,
            needed: law.forgets_after() as f64,
            law: law.clone(),
        }
    }

    pub(super) fn load(&mut self, lane: usize, plan: &Plan) {
        let [xi, _] = plan.start;
        let sample = self.law.sample(xi);
        for samples in self.line.iter_mut().chain(&mut self.samples) {
            samples[lane] = sample;
        }
        for past in &mut self.past {
            past[lane] = 0.0;
        }
        self.held[lane] = self.law.settled(xi);
        self.previous[lane] = sample;
        self.resting[lane] = 0.0;
        (self.nearest[lane], self.reach[lane]) = (f64::INFINITY, xi.abs());
    }

    /// The held forces of the samples at the positions of all lanes.
    #[inline(always)]
    pub(super) fn sample(&mut self, xi: &Lane) {
        let law = &self.law;
        let mut q = *xi;
        if law.has(law::ENCODER) {
            for q in &mut q {
                *q = floor_lane(*q) + 0.5;
            }
        }
        if self.settled.is_some() {
            let force = q.map(|q| law.filter.sum * q);
            self.settled = Some(limited(law, &q, force, steps_of(law, &force)));
        }
        if let Some(samples) = self.line.get_mut(self.next) {
            std::mem::swap(samples, &mut q);
            self.next = (self.next + 1) % self.line.len();
        }
        let (mut force, mut steps) = (q, None);
        if law.has(law::FILTER) {
            filter(law, &mut self.samples, &mut self.past, &mut force);
        } else if law.has(law::DAMPING) {
            if law.has(law::FORCE_STEP) {
                let [of_q, of_d, whole] = law.whole;
                let mut parts = q;
                for i in 0..WIDTH {
                    parts[i] = q[i] * of_q + (q[i] - self.previous[i]) * of_d;
                }
                steps = Some((parts, whole));
            }
            for i in 0..WIDTH {
                force[i] += law.damping * (q[i] - self.previous[i]);
            }
            self.previous = q;
        }
        let steps = steps.unwrap_or_else(|| steps_of(law, &force));
        if law.jumps() {
            for i in 0..WIDTH {
                self.reach[i] = self.reach[i].max(q[i].abs());
                let off = law.off_jump(q[i], force[i], self.reach[i]);
                self.nearest[i] = self.nearest[i].min(off);
            }
        }
        self.held = limited(law, &q, force, steps);
    }

    /// Without an encoder, how near to a jump of the law the samples were since this was asked before.
    #[inline(always)]
    pub(super) fn take_nearest(&mut self) -> Option<Lane> {
        let nothing = [f64::INFINITY; WIDTH];
        (self.law.jumps()).then(|| std::mem::replace(&mut self.nearest, nothing))
    }

    /// The samples that the controller of a lane remembers, the latest first.
    fn latest_first(&self, lane: usize) -> impl Iterator<Item = f64> + '_ {
        let older = self.line.iter().skip(self.next);
        let newer = self.line.iter().take(self.next);
        let late = newer.rev().chain(older.rev());
        let all = late.chain(&self.samples).chain([&self.previous]);
        all.map(move |samples| samples[lane])
    }

    /// The forces that are held in the end, where the device stays.
    #[inline(always)]
    pub(super) fn in_the_end(&self) -> &Lane {
        self.settled.as_ref().unwrap_or(&self.held)
    }
}

/// Ends the lanes in which divergence is certain; `outputs` are those of amplifiers.
#[inline(always)]
pub(super) fn grow(batch: &mut Batch, laws: &Laws, outputs: &Lane, points: &Points) {
    let mut any = false;
    for i in 0..WIDTH {
        any |= batch.exceeds(i, batch.size(i)) & (batch.busy[i] > 0.0);
    }
    if any {
        look(batch, laws, outputs, points);
    }
}

/// Looks closely at the lanes that call for it.
#[cold]
#[inline(never)]
fn look(batch: &mut Batch, laws: &Laws, outputs: &Lane, points: &Points) {
    for (i, point) in points.iter().enumerate() {
        let Some(point) = point else { continue };
        let state = State {
            xi: batch.xi[i],
            velocity: batch.v[i],
            output: outputs[i],
        };
        if batch.busy[i] > 0.0 && point.plan.growth.certain(&state, laws.latest_first(i)) {
            batch.busy[i] = GREW;
        }
    }
}

/// What a filter makes of samples, in their place.
#[inline(always)]
fn filter(law: &HeldForce, samples: &mut [Lane], past: &mut [Lane], q: &mut Lane) {
    let mut y = [0.0; WIDTH];
    for (r, before) in law.filter.poles.iter().zip(&*past) {
        for i in 0..WIDTH {
            y[i] -= r * before[i];
        }
    }
    let mut later = *q;
    for (tail, samples) in law.filter.tails.iter().zip(&mut *samples) {
        for i in 0..WIDTH {
            y[i] += tail * (samples[i] - later[i]);
        }
        std::mem::swap(samples, &mut later);
    }
    for y in &mut y {
        *y = (*y + law::VANISHING) - law::VANISHING;
    }
    let mut newest = y;
    for past in past {
        std::mem::swap(past, &mut newest);
    }
    for i in 0..WIDTH {
        q[i] = law.filter.sum * q[i] + y[i];
    }
}

/// Forces in steps of the D/A converter: numerators, and the denominator.
#[inline(always)]
fn steps_of(law: &HeldForce, force: &Lane) -> (Lane, f64) {
    let [numerator, denominator] = law.force_step;
    (force.map(|force| force * denominator), numerator)
}

/// The held forces of the wall's: what sides, steps and limits make of them.
#[inline(always)]
fn limited(law: &HeldForce, q: &Lane, mut force: Lane, steps: (Lane, f64)) -> Lane {
    let (mut parts, whole) = steps;
    if law.has(law::UNILATERAL) {
        for i in 0..WIDTH {
            force[i] = select(q[i] < 0.0, 0.0, force[i]);
            parts[i] = select(q[i] < 0.0, 0.0, parts[i]);
        }
    }
    let mut held = force.map(|force| -force);
    if law.has(law::FORCE_STEP) {
        let [numerator, denominator] = law.force_step;
        for i in 0..WIDTH {
            held[i] = floor_lane(-parts[i] / whole + 0.5) * numerator / denominator;
        }
    }
    if law.has(law::SATURATION) {
        let most = law.max_force;
        for held in &mut held {
            *held = select(*held < -most, -most, select(*held > most, most, *held));
        }
    }
    held
}

/// Runs every busy lane for `intervals` intervals.
#[inline(always)]
pub(super) fn stretch<const MEDIUM: bool>(
    batch: &mut Batch,
    laws: &mut Laws,
    points: &Points,
    intervals: u32,
) {
    for _ in 0..intervals {
        grow(batch, laws, &laws.held, points);
        laws.sample(&batch.xi);
        // A copy, so that no store is in the way of a load.
        let in_the_end = *laws.in_the_end();
        for (i, in_the_end) in in_the_end.iter().enumerate() {
            let (xi, v, held) = (batch.xi[i], batch.v[i], laws.held[i]);
            let beyond = batch.beyond(i, held);
            let rests = v == 0.0 && beyond == 0.0 && in_the_end.abs() <= batch.sigma[i];
            let resting = select(rests, laws.resting[i] + 1.0, 0.0);
            let [new_xi, new_v] = batch.moved::<MEDIUM>(i, held, beyond);
            // A speed that has underflowed under a force that friction just takes: no stop.
            let creeps = new_v == 0.0 && v != 0.0 && held == batch.sigma[i].copysign(v);
            let size = batch.size(i);
            batch.edges.see(i, new_xi, size);
            let busy = batch.busy[i];
            let busy = select(creeps && busy > 0.0, STRANGE, busy);
            let busy = select(resting > laws.needed && busy > 0.0, 0.0, busy);
            batch.xi[i] = select(busy > 0.0, new_xi, xi);
            batch.v[i] = select(busy > 0.0, new_v, v);
            batch.count[i] += select(busy > 0.0, 1.0, 0.0);
            batch.busy[i] = busy;
            laws.resting[i] = resting;
        }
    }
}
