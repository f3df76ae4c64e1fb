//! Many points at once: scenes of one controller in vector lanes, for sweeps.
//!
//! A batch holds [`WIDTH`] points as a structure of arrays. Each lane runs the very arithmetic of the
//! scalar loop (`motion`), both sides of its branches computed and selected, so that the
//! results are the same to the last bit. The compiler turns the loop over lanes into vector
//! instructions, once for each of the instruction sets named below; which one runs is found out at
//! run time. Lanes that have come to rest, are growing, or have run all their intervals are
//! retired and refilled from the queue. Points with λ ≤ 1/16 have a batch of their own: their series
//! is the shorter one. The paper's own scene has a loop to itself, any other controller another.
#![expect(
    clippy::indexing_slicing,
    reason = "every index is that of a lane, below the length of every array"
)]

mod batch;
mod edges;
mod flow;
mod late;
mod law;

use multiversion::multiversion;

use crate::flow::Kind as Motion;
use crate::law::HeldForce;
use crate::outcome::{End, ExactOutcome, Stop};
use crate::phi;
use crate::plan::{Plain, Plan};
use crate::rounding::{STRETCH, off_edge};
use crate::run;
use batch::Batch;
use flow::Flows;
use late::Late;
use law::Laws;

/// Lanes in a batch: four AVX-512 vectors, enough to hide the latency of each.
pub const WIDTH: usize = 32;

/// Of a lane that is not busy: the scalar loop must run its point.
const STRANGE: f64 = -1.0;

/// Of a lane that is not busy: its divergence is certain.
const GREW: f64 = -2.0;

/// Which vector instructions the lanes use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// The widest that this processor has.
    Best,
    /// At most AVX2, to measure it where there is more.
    Avx2,
    /// What every processor of the architecture has.
    Baseline,
}

/// What is run for a number of intervals.
struct Work {
    batch: Batch,
    kind: Kind,
    /// See [`long_series`].
    series: Vec<bool>,
}

/// What the points of a batch are.
enum Kind {
    /// The paper's own scene.
    Plain,
    /// Any controller.
    Law(Box<Laws>),
    /// Any controller, with a force that changes within the interval.
    Late(Box<Late>),
    /// Any controller, with an amplifier or an arm.
    Flow(Box<Flows>),
}

impl Work {
    #[inline(always)]
    fn stretch(&mut self, points: &Points, intervals: u32) {
        let batch = &mut self.batch;
        let long = self.series.contains(&true);
        match (&mut self.kind, long) {
            (Kind::Plain, false) => batch::stretch::<false>(batch, intervals),
            (Kind::Plain, true) => batch::stretch::<true>(batch, intervals),
            (Kind::Law(laws), false) => law::stretch::<false>(batch, laws, points, intervals),
            (Kind::Law(laws), true) => law::stretch::<true>(batch, laws, points, intervals),
            (Kind::Late(late), _) => late::stretch(batch, late, points, intervals),
            (Kind::Flow(flows), _) => flow::stretch(batch, flows, points, intervals),
        }
        let laws = match &mut self.kind {
            Kind::Plain => None,
            Kind::Law(laws) => Some(&mut **laws),
            Kind::Late(late) => Some(&mut late.laws),
            Kind::Flow(flows) => Some(&mut flows.laws),
        };
        if let Some(nearest) = laws.and_then(Laws::take_nearest) {
            batch.edges.nearest = nearest;
        }
        batch.edges.settle(intervals);
    }
}

#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw",
    "x86_64+avx2",
    "aarch64+neon"
))]
fn best(work: &mut Work, points: &Points, intervals: u32) {
    work.stretch(points, intervals);
}

#[multiversion(targets("x86_64+avx2"))]
fn avx2(work: &mut Work, points: &Points, intervals: u32) {
    work.stretch(points, intervals);
}

/// The widest instruction set that the lanes use on this processor.
#[must_use]
pub fn instructions() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    {
        if std::arch::is_x86_feature_detected!("avx512f")
            && std::arch::is_x86_feature_detected!("avx512dq")
            && std::arch::is_x86_feature_detected!("avx512vl")
            && std::arch::is_x86_feature_detected!("avx512bw")
        {
            return "AVX-512";
        }
        if std::arch::is_x86_feature_detected!("avx2") {
            return "AVX2";
        }
        "SSE2"
    }
    #[cfg(not(target_arch = "x86_64"))]
    "baseline"
}

/// Runs points of the paper's own scene, each for `intervals` intervals; `next` gives the next point
/// with its index, `done` takes the end of each, in the order in which they end.
///
/// # Example
///
/// ```
/// use passivity_sim::{Plain, Plan, lanes, run};
///
/// let points = [0.4, 0.5, 0.6].map(|beta| Plain { mu: 50.0, beta, sigma: 0.6, xi: 0.0, velocity: 2.0 });
/// let mut queue = points.iter().copied().enumerate();
/// let mut ends = vec![None; 3];
/// lanes::run(1000, || queue.next(), |index, end| ends[index] = Some(end));
/// for (point, end) in points.iter().zip(ends) {
///     assert_eq!(end, Some(run::outcome(&Plan::plain(point, 1000))));
/// }
/// ```
pub fn run(
    intervals: u64,
    next: impl FnMut() -> Option<(usize, Plain)>,
    done: impl FnMut(usize, End),
) {
    run_on(Instructions::Best, intervals, next, done);
}

/// [`run()`] with given vector instructions: the results are the same to the last bit.
pub fn run_on(
    instructions: Instructions,
    intervals: u64,
    mut next: impl FnMut() -> Option<(usize, Plain)>,
    done: impl FnMut(usize, End),
) {
    let next = || next().map(|(index, plain)| (index, Plan::plain(&plain, intervals)));
    run_plans(instructions, next, done);
}

/// Runs plans that differ in friction and start alone; `next` gives the next one with its index, `done`
/// takes the end of each, in the order in which they end.
///
/// Plans that the lanes cannot do, those of another controller than the first of their kind among them,
/// go through the scalar loop: the results are the same to the last bit.
pub fn run_plans(
    instructions: Instructions,
    mut next: impl FnMut() -> Option<(usize, Plan)>,
    mut done: impl FnMut(usize, End),
) {
    let mut lanes: Vec<Lanes> = Vec::new();
    let mut waiting = None;
    loop {
        // Fill until a point finds no free lane: it waits for one.
        while let Some(point) = waiting.take().or_else(|| next().map(Point::from)) {
            let series = long_series(&point.plan);
            let place = lanes.iter().position(|lanes| lanes.work.series == series);
            let place = place.unwrap_or_else(|| {
                lanes.push(Lanes::new(&point.plan, series));
                lanes.len() - 1
            });
            let lanes = &mut lanes[place];
            if !lanes.fits(&point.plan) {
                done(point.index, run::outcome(&point.plan));
                continue;
            }
            waiting = lanes.load(point);
            if waiting.is_some() {
                break;
            }
        }
        let mut at_work = false;
        for lanes in &mut lanes {
            at_work |= lanes.is_at_work();
            lanes.stretch(instructions);
            lanes.retire(&mut done);
        }
        if !at_work {
            return;
        }
    }
}

/// Whether the motion over an interval takes the longer series, or over each part of it: points for which it
/// does have lanes of their own.
fn long_series(plan: &Plan) -> Vec<bool> {
    let long = |plan: &Plan| plan.constants.lambda > phi::SMALL_LAMBDA;
    if let Some(fast) = &plan.fast {
        vec![fast.kind() == Motion::SlowArm]
    } else if plan.parts.is_empty() {
        vec![long(plan)]
    } else {
        plan.parts.iter().map(|(_, part)| long(part)).collect()
    }
}

/// A point of the queue with its plan.
struct Point {
    index: usize,
    plan: Plan,
}

impl From<(usize, Plan)> for Point {
    fn from((index, plan): (usize, Plan)) -> Self {
        Self { index, plan }
    }
}

impl Point {
    /// Whether friction may have taken the force to the last bit: then only the scalar loop tells rest
    /// from a speed that has underflowed.
    fn may_creep(&self, end: &End) -> bool {
        let [_, velocity] = self.plan.start;
        let forces = self.plan.constants.sigma + 0.5; // held forces are ½ off whole numbers
        velocity != 0.0 && end.outcome.exact == ExactOutcome::AtRest && forces == forces.floor()
    }
}

/// The point in each lane.
type Points = [Option<Point>; WIDTH];

/// A batch with its points.
struct Lanes {
    work: Work,
    points: Points,
    /// What all its points have in common.
    law: HeldForce,
    intervals: u64,
}

impl Lanes {
    /// Lanes for plans like this one.
    fn new(plan: &Plan, series: Vec<bool>) -> Self {
        Self {
            work: Work {
                batch: Batch::new(),
                kind: match &plan.fast {
                    Some(fast) => Kind::Flow(Box::new(Flows::new(plan, fast))),
                    None if plan.is_plain() => Kind::Plain,
                    None if !plan.parts.is_empty() => {
                        Kind::Late(Box::new(Late::new(plan, &series)))
                    }
                    None => Kind::Law(Box::new(Laws::new(&plan.law))),
                },
                series,
            },
            points: [const { None }; WIDTH],
            law: plan.law.clone(),
            intervals: plan.intervals,
        }
    }

    fn is_at_work(&self) -> bool {
        self.points.iter().any(Option::is_some)
    }

    /// Whether the lanes can do a point; the scalar loop does the others.
    ///
    /// With λ > ½ a reversal needs a logarithm. A start that is on an edge by rounding has no lane, nor has
    /// an amplifier or an arm behind a latency that leaves a part of a period.
    fn fits(&self, plan: &Plan) -> bool {
        let has_series = |plan: &Plan| plan.constants.lambda <= phi::MEDIUM_LAMBDA;
        let alike = plan.law == self.law && plan.intervals == self.intervals;
        let kind = match (&self.work.kind, &plan.fast) {
            (Kind::Flow(flows), Some(fast)) => {
                fast.in_lanes() && flows.kind == fast.kind() && plan.parts.is_empty()
            }
            (Kind::Late(late), None) => late.is_like(plan) && has_series(plan),
            (Kind::Plain | Kind::Law(_), None) => plan.parts.is_empty() && has_series(plan),
            _ => false,
        };
        let frictions = plan.viscous && plan.coulomb;
        // Of a real mode the square of the norm does not bound the speed.
        let is_bounded = plan.growth.s != 0.0;
        let [xi, _] = plan.start;
        let on_its_side = off_edge(xi) >= plan.start_error;
        alike && kind && frictions && plan.forces.is_none() && is_bounded && on_its_side
    }

    /// Takes a point into a free lane, or gives it back.
    fn load(&mut self, point: Point) -> Option<Point> {
        let Some(lane) = self.points.iter().position(Option::is_none) else {
            return Some(point);
        };
        self.work.batch.load(lane, &point.plan);
        match (&mut self.work.kind, &point.plan.fast) {
            (Kind::Law(laws), _) => laws.load(lane, &point.plan),
            (Kind::Late(late), _) => late.load(lane, &point.plan),
            (Kind::Flow(flows), Some(fast)) => {
                flows.load(lane, &point.plan, fast);
            }
            _ => {}
        }
        self.points[lane] = Some(point);
        None
    }

    /// Runs every busy lane for some intervals, none past its end.
    fn stretch(&mut self, instructions: Instructions) {
        let busy = self.points.iter().zip(&self.work.batch.count);
        let busy = busy.filter(|(point, _)| point.is_some());
        // Counts are whole numbers far below 2⁵³.
        let left = busy.map(|(_, count)| self.intervals - *count as u64);
        let Some(least) = left.min() else {
            return;
        };
        let length = u32::try_from(least).map_or(STRETCH, |least| least.min(STRETCH));
        match instructions {
            Instructions::Best => best(&mut self.work, &self.points, length),
            Instructions::Avx2 => avx2(&mut self.work, &self.points, length),
            Instructions::Baseline => self.work.stretch(&self.points, length),
        }
    }

    /// Hands over the ends of the points that are done, and frees their lanes.
    fn retire(&mut self, done: &mut impl FnMut(usize, End)) {
        for (lane, slot) in self.points.iter_mut().enumerate() {
            let Work { batch, kind, .. } = &mut self.work;
            let busy = batch.busy[lane];
            let finished = busy <= 0.0 || batch.count[lane] >= self.intervals as f64;
            if let Some(point) = slot.take_if(|_| finished) {
                let plan = &point.plan;
                let end = Some(lane).filter(|_| busy != STRANGE);
                let end = end.map(|lane| end_in(batch, lane, plan));
                let end = end.filter(|end| !matches!(kind, Kind::Plain) || !point.may_creep(end));
                done(point.index, end.unwrap_or_else(|| run::outcome(plan)));
                batch.busy[lane] = 0.0;
            }
        }
    }
}

/// How the point of a plan ended in a lane.
fn end_in(batch: &Batch, lane: usize, plan: &Plan) -> End {
    let (xi, velocity) = (batch.xi[lane], batch.v[lane]);
    let count = batch.count[lane] as u64;
    let stop = if batch.busy[lane] > 0.0 {
        Stop::Ran(count)
    } else if batch.busy[lane] == GREW {
        Stop::Growing(count)
    } else {
        Stop::Rest(count - plan.law.forgets_after())
    };
    let end = run::end(plan, stop, count, xi, velocity);
    if batch.edges.near[lane] > 0.0 && plan.law.has_edges() {
        run::look_closely(plan, end)
    } else {
        end
    }
}

#[cfg(test)]
mod tests;
