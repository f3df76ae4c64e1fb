//! The bounds of rounding over stretches of intervals: never below those of every interval, and cheap.

use super::{OF_POSITION, Rounding, STRETCH, off_edge};
use crate::law;
use crate::plan::{Forces, Plan};

/// The same bounds, carried over a stretch of intervals at once, with the greatest position and speed in
/// it: never below those, and cheap. In numbers, or in lanes of them.
#[derive(Clone, Debug)]
pub(crate) struct Coarse<T> {
    /// |ξ| and |ξ̇| are at most these parts of the norm that growth is judged by.
    pub(crate) parts: [T; 2],
    /// What an interval rounds, of the speed and of the forces.
    pub(crate) each: [T; 2],
    /// The forces: a constant part, and parts of |ξ| + 1 and of |ξ̇|.
    pub(crate) forces: [T; 3],
    /// What an error of ξ adds to that of ξ̇ through an arm's spring.
    pub(crate) spring: T,
    /// e^(−λ) over [`STRETCH`] intervals, and the most that an error of ξ̇ in each adds up to, over one.
    pub(crate) fades: [T; 2],
    /// The greatest |ξ| so far, and what ξ and ξ̇ may be off by.
    pub(crate) errors: [T; 3],
}

impl Coarse<f64> {
    /// At the start of a plan.
    pub(crate) fn new(plan: &Plan) -> Self {
        let growth = &plan.growth;
        let Rounding {
            position,
            velocity,
            scene,
            ..
        } = Rounding::new(plan);
        let [damping, stiffness] = scene.arm;
        // What is held is at most so much of |ξ| + 1, beside a step of a D/A converter.
        let held = 1.0 + 2.0 * plan.law.gain() + scene.law;
        let [numerator, denominator] = plan.law.force_step;
        // An amplifier's output was held before, and what it is off by has not faded; behind a latency the
        // force of the sample before acts too.
        let faded = if scene.lag > 0.0 {
            1.0 + 2.0 / (1.0 - scene.lag)
        } else {
            1.0
        };
        let output = if scene.lag > 0.0 || !plan.parts.is_empty() {
            2.0 * held
        } else {
            held
        };
        let force = plan.forces.as_ref().map_or(0.0, Forces::largest);
        let held_by_spring = stiffness > 0.0;
        Self {
            parts: [1.0 + (growth.c / growth.s).abs(), 1.0 / growth.s.abs()],
            each: [scene.each, scene.each * scene.inverse_mass * faded],
            forces: [
                scene.sigma + force + numerator / denominator,
                output + stiffness,
                damping,
            ],
            spring: (stiffness * scene.inverse_mass).sqrt(),
            fades: if held_by_spring {
                [1.0, f64::INFINITY]
            } else {
                let over = scene.decay.powi(STRETCH.cast_signed());
                [over, 1.0 / (1.0 - scene.decay)]
            },
            errors: [0.0, position, velocity],
        }
    }

    /// Ends a stretch of so many intervals, in which the square of the norm was at most `size`; whether
    /// an edge that was `nearest` away was farther off than rounding leads.
    #[inline(always)]
    pub(crate) fn settle(&mut self, nearest: f64, size: f64, intervals: f64) -> bool {
        let norm = size.sqrt();
        let [reach, position, velocity] = self.errors;
        let [farthest, speed] = self.parts.map(|part| part * norm);
        let reach = if farthest > reach { farthest } else { reach };
        let [constant, of_position, of_speed] = self.forces;
        let forces = constant + of_position * (reach + 1.0) + of_speed * speed;
        let rounded = self.each[0] * speed + self.each[1] * forces + f64::MIN_POSITIVE;
        let shift = rounded + OF_POSITION * reach;
        let kick = rounded + self.spring * shift;
        let (once, sum) = (intervals * kick, self.fades[1] * kick);
        let added = if once < sum { once } else { sum };
        let whole = intervals == f64::from(STRETCH);
        let faded = if whole { self.fades[0] } else { 1.0 };
        let position = position + intervals * (velocity + added + shift);
        self.errors = [reach, position, faded * velocity + added];
        // False of what is no number any more.
        nearest >= position
    }
}

/// What a stretch had: how near to an edge a sample was, and the greatest square of the norm.
///
/// Apart from [`Stretches`], so that it stays in registers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Seen {
    pub(crate) nearest: f64,
    size: f64,
}

impl Seen {
    pub(crate) const NOTHING: Self = Self {
        nearest: 1.0,
        size: 0.0,
    };

    /// Sees where an interval leads, and the square of the norm of the state that it starts from.
    #[inline(always)]
    pub(crate) fn see(&mut self, xi: f64, size: f64) {
        let off = off_edge(xi);
        self.nearest = if off < self.nearest {
            off
        } else {
            self.nearest
        };
        self.size = if size > self.size { size } else { self.size };
    }
}

/// How the samples of a run lie to the edges, stretch by stretch.
#[derive(Clone, Debug)]
pub(crate) struct Stretches {
    bounds: Coarse<f64>,
    /// How many intervals the stretches before had.
    done: u64,
    /// Whether a sample may be within rounding of an edge.
    pub(crate) near: bool,
}

impl Stretches {
    /// At the start of a plan.
    pub(crate) fn new(plan: &Plan) -> Self {
        let [xi, _] = plan.start;
        Self {
            bounds: Coarse::new(plan),
            done: 0,
            near: plan.law.has(law::ENCODER) && off_edge(xi) < plan.start_error,
        }
    }

    /// Ends a stretch after `h` intervals of the run; the last one when the run ends.
    #[inline(never)]
    pub(crate) fn settle(&mut self, seen: Seen, h: u64) -> Seen {
        // At most a stretch.
        let intervals = (h - self.done) as f64;
        self.near |= !self.bounds.settle(seen.nearest, seen.size, intervals);
        self.done = h;
        Seen::NOTHING
    }
}
