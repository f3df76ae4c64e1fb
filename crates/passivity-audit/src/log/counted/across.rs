//! Rows across the end of a wall on one side: between a count in it, where it is linear, and one outside, where there is no
//! force.
//!
//! With u the place within tick p ≥ 0 in the wall, and w that within tick q < 0 outside, the distance is D = K + u − w,
//! K = p − q. A force φ in the direction of the motion generates φD, and the wall ½(p + u)² more on the way in, or less on
//! the way out; its quantized form ½p² + (p + ½)u. Both grow with u. So at each D net energy is extreme where w is 1 before
//! D = K and u is 1 behind it, or where u is 0 before it and w is 0 behind it: along parabolas in D.

use passivity_core::Scalar as _;
use passivity_core::counted::{Arc, Crossing, Resistance};

use super::{Interval, Row, Walls, margin, resistances};
use crate::ball::Ball;

/// Where such a row goes: the tick in the wall, K, and whether it goes into the wall.
struct Across {
    inside: Ball,
    ticks: Ball,
    is_inward: bool,
}

/// What the energy of a wall is along D: ½D² in it or not, what D is times, and the rest.
struct Stored {
    is_bent: bool,
    slope: Ball,
    rest: Ball,
}

impl Across {
    /// The energy of the wall, or of its quantized form, at the place u.
    fn at(&self, u: Ball, is_quantized: bool) -> Stored {
        let p = self.inside;
        Stored {
            is_bent: false,
            slope: Ball::zero(),
            rest: match is_quantized {
                true => p.square().half() + (p + Ball::one().half()) * u,
                false => (p + u).square().half(),
            },
        }
    }

    /// The same at u = D + `place`.
    fn along(&self, place: Ball, is_quantized: bool) -> Stored {
        let p = self.inside;
        Stored {
            is_bent: !is_quantized,
            slope: match is_quantized {
                true => p + Ball::one().half(),
                false => p + place,
            },
            rest: self.at(place, is_quantized).rest,
        }
    }

    /// Net energy under such a force, before and behind D = K, where u is the largest at each D, or the least.
    fn arcs(
        &self,
        friction: &Resistance<Ball>,
        force: Ball,
        is_largest: bool,
        is_quantized: bool,
    ) -> [Arc<Ball>; 2] {
        let (k, one) = (self.ticks, Ball::one());
        let [before, behind] = match is_largest {
            true => [
                self.along(one - k, is_quantized),
                self.at(one, is_quantized),
            ],
            false => [
                self.at(Ball::zero(), is_quantized),
                self.along(-k, is_quantized),
            ],
        };
        let taken = friction.sigma - force;
        let arc = |stored: Stored, ends: [Ball; 2]| {
            let Resistance {
                own, less, more, ..
            } = friction;
            let (bend, slope, constant) = match self.is_inward {
                true => (less, taken - stored.slope, -stored.rest),
                false => (more, taken + stored.slope, stored.rest),
            };
            Arc {
                bend: if stored.is_bent { *bend } else { *own },
                slope,
                constant,
                ends,
            }
        };
        let [from, to] = [k - one, k + one];
        [arc(before, [from, k]), arc(behind, [k, to])]
    }

    // Such rows are rare: what is called again and again need not be fast, but short.

    /// Net energy under such a force, at the least and at the most, against the wall or its quantized form.
    #[inline(never)]
    fn net(
        &self,
        [least, most]: &[Resistance<Ball>; 2],
        force: Ball,
        is_quantized: bool,
    ) -> [Ball; 2] {
        let [a, b] = self.arcs(least, force, self.is_inward, is_quantized);
        let [c, d] = self.arcs(most, force, !self.is_inward, is_quantized);
        let ([low, _], [lower, _]) = (extremes(&a), extremes(&b));
        let ([_, high], [_, higher]) = (extremes(&c), extremes(&d));
        [low.min(lower), high.max(higher)]
    }

    /// What is generated under such a force, at the least and at the most: φu and the energy of the wall, less φw, beside
    /// φK.
    #[inline(never)]
    fn generated(&self, force: Ball, is_quantized: bool) -> [Ball; 2] {
        let (zero, one) = (Ball::zero(), Ball::one());
        let of = |u: Ball| {
            let stored = self.at(u, is_quantized).rest;
            let work = force * u;
            if self.is_inward {
                work + stored
            } else {
                work - stored
            }
        };
        // Where the wall balances the force.
        let balance = match (is_quantized, self.is_inward) {
            (true, _) => zero,
            (false, true) => -force - self.inside,
            (false, false) => force - self.inside,
        };
        let balance = balance.max(zero).min(one);
        let [first, turn, last] = [zero, balance, one].map(of);
        let base = force * self.ticks;
        [
            base + first.min(turn).min(last) - force.max(zero),
            base + first.max(turn).max(last) - force.min(zero),
        ]
    }
}

/// The least value and the largest one of an arc.
#[inline(never)]
fn extremes(arc: &Arc<Ball>) -> [Ball; 2] {
    let ([from, to], turn) = (&arc.ends, arc.turn());
    let (first, last) = (arc.at(from), arc.at(to));
    let least = turn.min(first).min(last);
    [least, turn.max(first).max(last)]
}

impl Row<Ball> {
    /// As [`of`](Self::of), from outside of a wall on one side to where it is linear, or back; `is_inward` says which.
    pub(crate) fn across(
        (frictions, criteria): Walls<'_, Ball>,
        of: &Interval<Ball>,
        (is_inward, is_exact, applied): (bool, bool, bool),
    ) -> Self {
        let ticks = of.end - of.start;
        // The force of the wall is that of the first tick.
        let own = match is_inward {
            true => Ball::zero(),
            false => -(of.start + Ball::one().half()),
        };
        let force = if applied { of.force } else { own };
        let excess = force - own;
        let ahead = |force: Ball| match is_inward {
            true => force,
            false => -force,
        };
        let across = Across {
            inside: match is_inward {
                true => of.end,
                false => of.start,
            },
            ticks: ticks.abs(),
            is_inward,
        };
        let frictions = resistances(frictions, &of.lasts, is_exact);
        let crossing = Crossing { ticks, excess };
        let ([near, far], held) = (crossing.distances(), ahead(force));
        let [least, most] = &frictions;
        Self {
            taken: [least.taken(&near), most.taken(&far)],
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: [false, true].map(|quantized| across.generated(held, quantized)),
            net: [false, true].map(|quantized| across.net(&frictions, held, quantized)),
            work: force * ticks,
            own: across.net(&frictions, ahead(own), false),
            // Outside of the wall there is no potential.
            stored: match is_inward {
                true => crossing.stored(&of.end),
                false => [(-excess).min(Ball::zero()), (-excess).max(Ball::zero())],
            },
            excess,
        }
    }
}
