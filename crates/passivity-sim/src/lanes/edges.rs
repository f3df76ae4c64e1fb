//! Which lanes may have a sample within rounding of an edge.
//!
//! The bounds are those of [`Coarse`], in lanes. A lane whose samples stay farther off every edge has none
//! to report; of any other the scalar loop looks for it.

use super::WIDTH;
use super::batch::{Lane, select};
use crate::plan::Plan;
use crate::rounding::{Coarse, off_edge};

/// The bounds of a batch.
pub(super) struct Edges {
    bounds: Coarse<Lane>,
    /// How near to an edge a sample of the stretch was.
    pub(super) nearest: Lane,
    /// The greatest square of the norm of the state in the stretch.
    size: Lane,
    /// 1 where a sample may have been within rounding of an edge.
    pub(super) near: Lane,
}

impl Edges {
    pub(super) const fn new() -> Self {
        let zero = [0.0; WIDTH];
        Self {
            bounds: Coarse {
                parts: [zero; 2],
                each: [zero; 2],
                forces: [zero; 3],
                spring: zero,
                fades: [zero; 2],
                errors: [zero; 3],
            },
            nearest: [1.0; WIDTH],
            size: zero,
            near: zero,
        }
    }

    pub(super) fn load(&mut self, lane: usize, plan: &Plan) {
        let bounds = Coarse::new(plan);
        let all = &mut self.bounds;
        for part in 0..2 {
            all.parts[part][lane] = bounds.parts[part];
            all.each[part][lane] = bounds.each[part];
            all.fades[part][lane] = bounds.fades[part];
        }
        for part in 0..3 {
            all.forces[part][lane] = bounds.forces[part];
            all.errors[part][lane] = bounds.errors[part];
        }
        all.spring[lane] = bounds.spring;
        (self.nearest[lane], self.size[lane]) = (1.0, 0.0);
        self.near[lane] = 0.0;
    }

    /// Sees where an interval leads, and the square of the norm of the state that it starts from.
    #[inline(always)]
    pub(super) fn see(&mut self, i: usize, xi: f64, size: f64) {
        let off = off_edge(xi);
        let nearest = self.nearest[i];
        self.nearest[i] = select(off < nearest, off, nearest);
        let most = self.size[i];
        self.size[i] = select(size > most, size, most);
    }

    /// Ends a stretch of so many intervals.
    #[inline(always)]
    pub(super) fn settle(&mut self, intervals: u32) {
        let n = f64::from(intervals);
        let all = &mut self.bounds;
        for i in 0..WIDTH {
            let mut bounds = Coarse {
                parts: [all.parts[0][i], all.parts[1][i]],
                each: [all.each[0][i], all.each[1][i]],
                forces: [all.forces[0][i], all.forces[1][i], all.forces[2][i]],
                spring: all.spring[i],
                fades: [all.fades[0][i], all.fades[1][i]],
                errors: [all.errors[0][i], all.errors[1][i], all.errors[2][i]],
            };
            let far = bounds.settle(self.nearest[i], self.size[i], n);
            self.near[i] = select(far, self.near[i], 1.0);
            let [reach, position, velocity] = bounds.errors;
            all.errors[0][i] = reach;
            all.errors[1][i] = position;
            all.errors[2][i] = velocity;
            (self.nearest[i], self.size[i]) = (1.0, 0.0);
        }
    }
}
