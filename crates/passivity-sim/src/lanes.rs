//! Many points at once: the paper's own scene in vector lanes, for sweeps.
//!
//! A batch holds [`WIDTH`] points as a structure of arrays. Each lane runs the very arithmetic of the
//! scalar loop (`motion`), both sides of its branches computed and selected, so that the
//! results are the same to the last bit. The compiler turns the loop over lanes into vector
//! instructions, once for each of the instruction sets named below; which one runs is found out at
//! run time. Lanes that have come to rest, are growing, or have run all their intervals are
//! retired and refilled from the queue. Points with λ ≤ 1/16 have a batch of their own: their series
//! is the shorter one.
#![expect(
    clippy::indexing_slicing,
    reason = "every index is that of a lane, below the length of every array"
)]

use multiversion::multiversion;

use crate::outcome::{End, ExactOutcome, Stop};
use crate::phi;
use crate::plan::{Plain, Plan};
use crate::run;

/// Lanes in a batch: four AVX-512 vectors, enough to hide the latency of each.
pub const WIDTH: usize = 32;

/// Intervals between two looks at which lanes are done.
const STRETCH: u32 = 64;

type Lane = [f64; WIDTH];

/// The state and the constants of a batch.
struct Batch {
    xi: Lane,
    v: Lane,
    /// 1 while the lane is at work, 0 once it is at rest or growing.
    busy: Lane,
    /// How many intervals it has been at work.
    count: Lane,
    inverse_mu: Lane,
    sigma: Lane,
    lambda: Lane,
    decay: Lane,
    phi1: Lane,
    phi2: Lane,
    growth_c: Lane,
    growth_s: Lane,
    growth_square: Lane,
}

impl Batch {
    fn new() -> Self {
        let zero = [0.0; WIDTH];
        Self {
            xi: zero,
            v: zero,
            busy: zero,
            count: zero,
            // An idle lane computes with harmless numbers.
            inverse_mu: [1.0; WIDTH],
            sigma: [1.0; WIDTH],
            lambda: zero,
            decay: [1.0; WIDTH],
            phi1: [1.0; WIDTH],
            phi2: [0.5; WIDTH],
            growth_c: zero,
            growth_s: zero,
            growth_square: [f64::MAX; WIDTH],
        }
    }

    fn load(&mut self, lane: usize, plan: &Plan) {
        let (k, growth) = (&plan.constants, &plan.growth);
        [self.xi[lane], self.v[lane]] = plan.start;
        self.busy[lane] = 1.0;
        self.count[lane] = 0.0;
        self.inverse_mu[lane] = k.inverse_mu;
        self.sigma[lane] = k.sigma;
        self.lambda[lane] = k.lambda;
        self.decay[lane] = k.decay;
        self.phi1[lane] = k.phi1;
        self.phi2[lane] = k.phi2;
        self.growth_c[lane] = growth.c;
        self.growth_s[lane] = growth.s;
        self.growth_square[lane] = growth.square;
    }

    /// How the point of this plan ended in a lane.
    fn end(&self, lane: usize, plan: &Plan) -> End {
        let (xi, velocity) = (self.xi[lane], self.v[lane]);
        let count = self.count[lane] as u64;
        let stop = if self.busy[lane] > 0.0 {
            Stop::Ran(count)
        } else if plan.growth.exceeds(xi, velocity) {
            Stop::Growing(count)
        } else {
            Stop::Rest(count)
        };
        End {
            intervals: count,
            xi,
            velocity,
            outcome: run::facts(plan).judge(stop, xi, velocity, &plan.growth.words()),
        }
    }
}

/// `a` where `which`, else `b`: a blend, not a branch.
#[inline(always)]
fn select(which: bool, a: f64, b: f64) -> f64 {
    if which { a } else { b }
}

/// [`crate::number::floor`] for |x| < 2⁵¹, without its branch: see [`fits`].
#[inline(always)]
fn floor_lane(x: f64) -> f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    let nearest = (x + MAGIC) - MAGIC;
    nearest - select(nearest > x, 1.0, 0.0)
}

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

#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw",
    "x86_64+avx2",
    "x86_64+sse4.1",
    "aarch64+neon"
))]
fn best(batch: &mut Batch, intervals: u32) {
    stretch::<false>(batch, intervals);
}

#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw",
    "x86_64+avx2",
    "x86_64+sse4.1",
    "aarch64+neon"
))]
fn best_medium(batch: &mut Batch, intervals: u32) {
    stretch::<true>(batch, intervals);
}

#[multiversion(targets("x86_64+avx2"))]
fn avx2(batch: &mut Batch, intervals: u32) {
    stretch::<false>(batch, intervals);
}

#[multiversion(targets("x86_64+avx2"))]
fn avx2_medium(batch: &mut Batch, intervals: u32) {
    stretch::<true>(batch, intervals);
}

/// H for the points of a batch: [`phi::h_medium`] or [`phi::h_series`].
#[inline(always)]
fn h<const MEDIUM: bool>(x: f64) -> f64 {
    if MEDIUM {
        phi::h_medium(x)
    } else {
        phi::h_series(x)
    }
}

/// Runs every busy lane for `intervals` intervals.
#[inline(always)]
fn stretch<const MEDIUM: bool>(batch: &mut Batch, intervals: u32) {
    for _ in 0..intervals {
        for i in 0..WIDTH {
            let (xi, v, sigma) = (batch.xi[i], batch.v[i], batch.sigma[i]);
            let held = -(floor_lane(xi) + 0.5);
            let real = xi + batch.growth_c[i] * v;
            let imaginary = batch.growth_s[i] * v;
            let grows = real * real + imaginary * imaginary > batch.growth_square[i];
            // Exact where it matters: 0 if and only if |held| ≤ σ.
            let beyond = held - select(held > sigma, sigma, select(held < -sigma, -sigma, held));
            let rests = v == 0.0 && beyond == 0.0;
            let busy = select(grows || rests, 0.0, batch.busy[i]);

            let a = (held - sigma.copysign(v)) * batch.inverse_mu[i];
            let velocity = batch.decay[i] * v + batch.phi1[i] * a;
            let d = batch.phi1[i] * v + batch.phi2[i] * a;
            let keeps = (v > 0.0 && velocity >= 0.0) || (v < 0.0 && velocity <= 0.0);

            let lambda = batch.lambda[i];
            let r = select(v == 0.0, 0.0, -v / a);
            let f = batch.phi1[i] - batch.decay[i] * r;
            let f = select(f > 0.0, f, 0.0);
            let onward = beyond * batch.inverse_mu[i];
            let stopping = v * r * h::<MEDIUM>(-(lambda * r));
            let then = onward * f * f * h::<MEDIUM>(lambda * f);

            let new_xi = xi + select(keeps, d, stopping + then);
            let new_v = select(keeps, velocity, onward * f);
            batch.xi[i] = select(busy > 0.0, new_xi, xi);
            batch.v[i] = select(busy > 0.0, new_v, v);
            batch.busy[i] = busy;
            batch.count[i] += busy;
        }
    }
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
    mut done: impl FnMut(usize, End),
) {
    let [mut small, mut medium] = [Lanes::new(false), Lanes::new(true)];
    let mut waiting = None;
    loop {
        // Fill until a point finds no free lane: it waits for one.
        while let Some(point) = waiting.take().or_else(|| Point::from(&mut next, intervals)) {
            if !fits(&point.plan) {
                done(point.index, run::outcome(&point.plan));
                continue;
            }
            let lanes = if point.plan.constants.lambda > phi::SMALL_LAMBDA {
                &mut medium
            } else {
                &mut small
            };
            waiting = lanes.load(point);
            if waiting.is_some() {
                break;
            }
        }
        let [small, medium] = [&mut small, &mut medium];
        if !small.is_at_work() && !medium.is_at_work() {
            return;
        }
        for lanes in [small, medium] {
            lanes.stretch(instructions, intervals);
            lanes.retire(intervals, &mut done);
        }
    }
}

/// A point of the queue with its plan.
struct Point {
    index: usize,
    plan: Plan,
}

impl Point {
    fn from(next: &mut impl FnMut() -> Option<(usize, Plain)>, intervals: u64) -> Option<Self> {
        let (index, plain) = next()?;
        let plan = Plan::plain(&plain, intervals);
        Some(Self { index, plan })
    }

    /// Whether friction may have taken the force to the last bit: then only the scalar loop tells rest
    /// from a speed that has underflowed.
    fn may_creep(&self, end: &End) -> bool {
        let [_, velocity] = self.plan.start;
        let forces = self.plan.constants.sigma + 0.5; // held forces are ½ off whole numbers
        velocity != 0.0 && end.outcome.exact == ExactOutcome::AtRest && forces == forces.floor()
    }
}

/// A batch with the point in each lane.
struct Lanes {
    batch: Batch,
    points: [Option<Point>; WIDTH],
    /// Whether its points take the longer series.
    medium: bool,
}

impl Lanes {
    fn new(medium: bool) -> Self {
        Self {
            batch: Batch::new(),
            points: [const { None }; WIDTH],
            medium,
        }
    }

    fn is_at_work(&self) -> bool {
        self.points.iter().any(Option::is_some)
    }

    /// Takes a point into a free lane, or gives it back.
    fn load(&mut self, point: Point) -> Option<Point> {
        let Some(lane) = self.points.iter().position(Option::is_none) else {
            return Some(point);
        };
        self.batch.load(lane, &point.plan);
        self.points[lane] = Some(point);
        None
    }

    /// Runs every busy lane for some intervals, none past its end.
    fn stretch(&mut self, instructions: Instructions, intervals: u64) {
        let busy = self.points.iter().zip(&self.batch.count);
        let busy = busy.filter(|(point, _)| point.is_some());
        // Counts are whole numbers far below 2⁵³.
        let left = busy.map(|(_, count)| intervals - *count as u64);
        let Some(least) = left.min() else {
            return;
        };
        let length = u32::try_from(least).map_or(STRETCH, |least| least.min(STRETCH));
        let batch = &mut self.batch;
        match (instructions, self.medium) {
            (Instructions::Best, false) => best(batch, length),
            (Instructions::Best, true) => best_medium(batch, length),
            (Instructions::Avx2, false) => avx2(batch, length),
            (Instructions::Avx2, true) => avx2_medium(batch, length),
            (Instructions::Baseline, false) => stretch::<false>(batch, length),
            (Instructions::Baseline, true) => stretch::<true>(batch, length),
        }
    }

    /// Hands over the ends of the points that are done, and frees their lanes.
    fn retire(&mut self, intervals: u64, done: &mut impl FnMut(usize, End)) {
        for (lane, slot) in self.points.iter_mut().enumerate() {
            let batch = &mut self.batch;
            let finished = batch.busy[lane] == 0.0 || batch.count[lane] >= intervals as f64;
            if let Some(point) = slot.take_if(|_| finished) {
                let mut end = batch.end(lane, &point.plan);
                if point.may_creep(&end) {
                    end = run::outcome(&point.plan);
                }
                done(point.index, end);
                batch.busy[lane] = 0.0;
            }
        }
    }
}

/// Whether the lanes can do a point; the scalar loop does the others.
///
/// With λ > ½ a reversal needs a logarithm, and positions must stay below 2⁵¹: an unforced stable
/// motion does not get past its first energy by more than the ticks that TH-START leaves it, and a
/// growing one ends at its radius.
fn fits(plan: &Plan) -> bool {
    const FAR: f64 = 1e12;
    let [xi, v] = plan.start;
    let reach = xi.abs() + v.abs() * plan.constants.mu.sqrt();
    let radius = if plan.growth.is_possible() {
        plan.growth.square.sqrt()
    } else {
        0.0
    };
    plan.constants.lambda <= phi::MEDIUM_LAMBDA && reach < FAR && radius < FAR
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(mu: f64, speeds: &[f64]) -> Vec<Plain> {
        let mut points = Vec::new();
        for i in 0..20 {
            for j in 0..20 {
                for &velocity in speeds {
                    points.push(Plain {
                        mu,
                        beta: (f64::from(i) + 0.5) / 20.0,
                        sigma: 1.5 * (f64::from(j) + 0.5) / 20.0,
                        xi: 0.0,
                        velocity,
                    });
                }
            }
        }
        points
    }

    fn all(points: &[Plain], intervals: u64) -> Vec<End> {
        by(Instructions::Best, points, intervals)
    }

    fn by(instructions: Instructions, points: &[Plain], intervals: u64) -> Vec<End> {
        let mut queue = points.iter().copied().enumerate();
        let mut ends: Vec<Option<End>> = vec![None; points.len()];
        run_on(
            instructions,
            intervals,
            || queue.next(),
            |i, end| ends[i] = Some(end),
        );
        ends.into_iter()
            .map(|end| end.expect("every point ends"))
            .collect()
    }

    #[test]
    fn lanes_and_scalar_loop_agree_to_the_last_bit() {
        // μ = 50 as in Fig. 5; μ = 8 takes λ past 1/16 for half of the points, μ = 1 past ½.
        for (mu, intervals) in [(50.0, 5_000), (8.0, 777), (1.0, 777)] {
            let points = grid(mu, &[0.5, 1.0, 2.0, 5.0]);
            for (point, end) in points.iter().zip(all(&points, intervals)) {
                let scalar = run::outcome(&Plan::plain(point, intervals));
                assert_eq!(end, scalar, "{point:?}");
                assert_eq!(end.xi.to_bits(), scalar.xi.to_bits(), "{point:?}");
            }
        }
    }

    #[test]
    fn points_of_every_kind_in_any_order_end_as_they_do_alone() {
        let mut points = grid(8.0, &[2.0]);
        points.extend(grid(0.7, &[1.0]));
        points.extend(grid(50.0, &[5.0]));
        // 7 and 1200 have no common divisor: every point once, kinds mixed.
        let mixed: Vec<Plain> = (0..1200).map(|i| points[i * 7 % 1200]).collect();
        for (point, end) in mixed.iter().zip(all(&mixed, 300)) {
            assert_eq!(end, run::outcome(&Plan::plain(point, 300)), "{point:?}");
        }
    }

    #[test]
    fn every_instruction_set_gives_the_same_bits() {
        let mut points = grid(50.0, &[1.0, 5.0]);
        points.extend(grid(4.0, &[1.0]));
        let best = by(Instructions::Best, &points, 2_000);
        for instructions in [Instructions::Avx2, Instructions::Baseline] {
            let other = by(instructions, &points, 2_000);
            for (a, b) in best.iter().zip(&other) {
                assert_eq!(a, b, "{instructions:?}");
                assert_eq!(a.xi.to_bits(), b.xi.to_bits(), "{instructions:?}");
            }
        }
    }

    #[test]
    fn edges_are_met_in_lanes_as_in_the_scalar_loop() {
        let mut points = Vec::new();
        for sigma in [0.5_f64, 0.5_f64.next_down(), 0.5_f64.next_up(), 0.0] {
            for beta in [0.0, 0.5, 1e-300, 20.0] {
                for velocity in [0.0, 5e-324, -1.0, 1e-9] {
                    for xi in [0.0, -1.0, 1.0_f64.next_down(), 1e15] {
                        points.push(Plain {
                            mu: 50.0,
                            beta,
                            sigma,
                            xi,
                            velocity,
                        });
                    }
                }
            }
        }
        for intervals in [0, 1, 63, 64, 65, 1000] {
            for (point, end) in points.iter().zip(all(&points, intervals)) {
                assert_eq!(
                    end,
                    run::outcome(&Plan::plain(point, intervals)),
                    "{point:?}"
                );
            }
        }
    }
}
