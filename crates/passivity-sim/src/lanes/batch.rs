//! A batch of points as a structure of arrays, and the motion of all its lanes over an interval.

use super::edges::Edges;
use super::{GREW, WIDTH};
use crate::motion::Constants;
use crate::phi;
use crate::plan::Plan;

/// A number of every lane.
pub(super) type Lane = [f64; WIDTH];

/// The state and the constants of a batch.
pub(super) struct Batch {
    pub(super) xi: Lane,
    pub(super) v: Lane,
    /// 1 while the lane is at work, 0 once it is at rest; or [`GREW`], or [`STRANGE`](super::STRANGE).
    pub(super) busy: Lane,
    /// How many intervals it has been at work.
    pub(super) count: Lane,
    pub(super) sigma: Lane,
    pub(super) motion: Motion,
    growth_c: Lane,
    growth_s: Lane,
    growth_square: Lane,
    pub(super) edges: Edges,
}

/// The constants of the motion over an interval, or over a part of it.
pub(super) struct Motion {
    inverse_mu: Lane,
    lambda: Lane,
    decay: Lane,
    phi1: Lane,
    phi2: Lane,
}

impl Motion {
    pub(super) const fn new() -> Self {
        // An idle lane computes with harmless numbers.
        Self {
            inverse_mu: [1.0; WIDTH],
            lambda: [0.0; WIDTH],
            decay: [1.0; WIDTH],
            phi1: [1.0; WIDTH],
            phi2: [0.5; WIDTH],
        }
    }

    pub(super) fn load(&mut self, lane: usize, k: &Constants) {
        self.inverse_mu[lane] = k.inverse_mu;
        self.lambda[lane] = k.lambda;
        self.decay[lane] = k.decay;
        self.phi1[lane] = k.phi1;
        self.phi2[lane] = k.phi2;
    }

    /// ξ and ξ̇ after the motion from a state under a held force, of which friction does not take `beyond`.
    #[inline(always)]
    pub(super) fn moved<const MEDIUM: bool>(
        &self,
        i: usize,
        [xi, v]: [f64; 2],
        sigma: f64,
        [held, beyond]: [f64; 2],
    ) -> [f64; 2] {
        let a = (held - sigma.copysign(v)) * self.inverse_mu[i];
        let velocity = self.decay[i] * v + self.phi1[i] * a;
        let d = self.phi1[i] * v + self.phi2[i] * a;
        let keeps = (v > 0.0 && velocity >= 0.0) || (v < 0.0 && velocity <= 0.0);

        let lambda = self.lambda[i];
        let r = select(v == 0.0, 0.0, -v / a);
        let f = self.phi1[i] - self.decay[i] * r;
        let f = select(f > 0.0, f, 0.0);
        let onward = beyond * self.inverse_mu[i];
        let stopping = v * r * h::<MEDIUM>(-(lambda * r));
        let then = onward * f * f * h::<MEDIUM>(lambda * f);
        [
            xi + select(keeps, d, stopping + then),
            select(keeps, velocity, onward * f),
        ]
    }
}

impl Batch {
    pub(super) fn new() -> Self {
        let zero = [0.0; WIDTH];
        Self {
            xi: zero,
            v: zero,
            busy: zero,
            count: zero,
            sigma: [1.0; WIDTH],
            motion: Motion::new(),
            growth_c: zero,
            growth_s: zero,
            growth_square: [f64::MAX; WIDTH],
            edges: Edges::new(),
        }
    }

    pub(super) fn load(&mut self, lane: usize, plan: &Plan) {
        let (k, growth) = (&plan.constants, &plan.growth);
        [self.xi[lane], self.v[lane]] = plan.start;
        self.busy[lane] = 1.0;
        self.count[lane] = 0.0;
        self.sigma[lane] = k.sigma;
        self.motion.load(lane, k);
        self.growth_c[lane] = growth.c;
        self.growth_s[lane] = growth.s;
        self.growth_square[lane] = growth.square;
        self.edges.load(lane, plan);
    }

    /// The square of the norm of the state of a lane.
    #[inline(always)]
    pub(super) fn size(&self, i: usize) -> f64 {
        let (xi, v) = (self.xi[i], self.v[i]);
        let real = xi + self.growth_c[i] * v;
        let imaginary = self.growth_s[i] * v;
        real * real + imaginary * imaginary
    }

    /// Whether a state with a norm of this square is past the radius of the lane's plan.
    #[inline(always)]
    pub(super) fn exceeds(&self, i: usize, size: f64) -> bool {
        size > self.growth_square[i]
    }

    /// What of a held force friction does not take: 0 if and only if |held| ≤ σ, exactly.
    #[inline(always)]
    pub(super) fn beyond(&self, i: usize, held: f64) -> f64 {
        let sigma = self.sigma[i];
        held - select(held > sigma, sigma, select(held < -sigma, -sigma, held))
    }

    /// ξ and ξ̇ after an interval under a held force.
    #[inline(always)]
    pub(super) fn moved<const MEDIUM: bool>(&self, i: usize, held: f64, beyond: f64) -> [f64; 2] {
        let (state, sigma) = ([self.xi[i], self.v[i]], self.sigma[i]);
        self.motion.moved::<MEDIUM>(i, state, sigma, [held, beyond])
    }
}

/// `a` where `which`, else `b`: a blend, not a branch.
#[inline(always)]
pub(super) fn select(which: bool, a: f64, b: f64) -> f64 {
    if which { a } else { b }
}

/// [`crate::number::floor`] as an instruction, where there is one for vectors.
#[inline(always)]
pub(super) fn floor_lane(x: f64) -> f64 {
    x.floor()
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

/// Runs every busy lane of the paper's own scene for `intervals` intervals.
#[inline(always)]
pub(super) fn stretch<const MEDIUM: bool>(batch: &mut Batch, intervals: u32) {
    for _ in 0..intervals {
        for i in 0..WIDTH {
            let (xi, v) = (batch.xi[i], batch.v[i]);
            let held = -(floor_lane(xi) + 0.5);
            let beyond = batch.beyond(i, held);
            let rests = v == 0.0 && beyond == 0.0;
            let size = batch.size(i);
            let busy = select(rests, 0.0, batch.busy[i]);
            let busy = select(batch.exceeds(i, size) && batch.busy[i] > 0.0, GREW, busy);
            let [new_xi, new_v] = batch.moved::<MEDIUM>(i, held, beyond);
            batch.edges.see(i, new_xi, size);
            batch.xi[i] = select(busy > 0.0, new_xi, xi);
            batch.v[i] = select(busy > 0.0, new_v, v);
            batch.busy[i] = busy;
            batch.count[i] += select(busy > 0.0, 1.0, 0.0);
        }
    }
}
