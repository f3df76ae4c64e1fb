//! Where an interval has a stop: the node of the table that it is nearest to.

use super::fast::{Attempt, Fast};
use super::short::{Inner, dot};
use super::turn::Near;

impl Fast {
    /// About when the velocity changes its sign, between 0 and 1: a root of the parabola with its values at both
    /// ends and its slope at the start, and a step of Newton's from there on the cubic that has its slope at the
    /// end too.
    #[inline(always)]
    pub(crate) fn guess(&self, attempt: &Attempt) -> f64 {
        let [v, ..] = attempt.inner;
        let [first, last] = attempt.slopes;
        let first = first * self.turns.inverse_mass;
        let last = last * self.turns.inverse_mass;
        let bend = (attempt.velocity - v) - first;
        let root = (first * first - 4.0 * bend * v).sqrt().copysign(v);
        let time = 2.0 * v / (root - first);
        // The slope of the parabola is −root there.
        let cubic = (last - first) - 2.0 * bend;
        time - cubic * time * time * (1.0 - time) / root
    }

    /// The node that a stop is nearest to; from about where to look for it.
    #[inline(always)]
    pub(crate) fn near<const LAG: bool, const ARM: bool>(
        &self,
        inner: &Inner,
        guess: f64,
    ) -> Option<(usize, Near)> {
        /// How far the nearest node may be off, in cells: half a cell and what the estimate is off by.
        const NEAREST: f64 = 0.55;
        const MOST_NODES: u32 = 24;
        let k = &self.turns;
        let [v, p, e] = *inner;
        let mut node = self.table.node(guess).min(self.table.cells());
        let (mut low, mut high) = (0, self.table.cells() + 1);
        for _ in 0..MOST_NODES {
            let map = self.table.map(node);
            let velocity = partly::<LAG>(&map.velocity, inner);
            let way = partly::<LAG>(&map.way, inner);
            let (mut force, mut excess) = (p, e);
            if LAG {
                excess = map.excess * e;
                force += e - excess;
            }
            if ARM {
                force -= k.stiffness * way;
            }
            let slope = force * k.inverse_mass - k.lambda * velocity;
            let mut bend = -(k.lambda * slope);
            if LAG {
                bend += k.driven * excess;
            }
            if ARM {
                bend -= k.spring * velocity;
            }
            let over = 1.0 / slope;
            let first = -(velocity * over);
            let time = first - 0.5 * bend * over * first * first;
            if time.abs() <= NEAREST * k.cell {
                let near = Near {
                    way,
                    velocity,
                    slope,
                    bend,
                    excess,
                    time,
                };
                return Some((node, near));
            }
            if velocity * v > 0.0 {
                low = node + 1;
            } else {
                high = node;
            }
            if low >= high {
                return None;
            }
            let next = self.table.node(time + node as f64 * k.cell);
            node = if (low..high).contains(&next) {
                next
            } else {
                low.midpoint(high - 1)
            };
        }
        None
    }
}

/// The sum of products, without the last one where there is no amplifier: it is 0.
#[inline(always)]
pub(super) fn partly<const LAG: bool>(a: &Inner, b: &Inner) -> f64 {
    if LAG {
        dot(a, b)
    } else {
        let ([a0, a1, _], [b0, b1, _]) = (*a, *b);
        a0 * b0 + a1 * b1
    }
}
