//! Rows across the end of a wall on one side: between a count in it, where it is linear, and one outside, where there is no
//! force.
//!
//! With u the place within tick p ≥ 0 in the wall, and w that within tick q < 0 outside, the distance is D = K + u − w,
//! K = p − q. A force φ in the direction of the motion generates φD, and the wall ½(p + u)² more on the way in, or less on
//! the way out; its quantized form ½p² + (p + ½)u. Both grow with u. So at each D net energy is extreme where w is 1 before
//! D = K and u is 1 behind it, or where u is 0 before it and w is 0 behind it: along parabolas in D.

use passivity_core::Ordered;
use passivity_core::counted::{Arc, Crossing, Resistance};

use super::{Interval, Row, Walls, margin, resistances};

/// Where such a row goes: the tick in the wall, K, and whether it goes into the wall.
struct Across<S> {
    inside: S,
    ticks: S,
    is_inward: bool,
}

/// What the energy of a wall is along D: ½D² in it or not, what D is times, and the rest.
struct Stored<S> {
    is_bent: bool,
    slope: S,
    rest: S,
}

impl<S: Ordered> Across<S> {
    /// The energy of the wall, or of its quantized form, at the place u.
    fn at(&self, u: S, is_quantized: bool) -> Stored<S> {
        let p = self.inside.clone();
        Stored {
            is_bent: false,
            slope: S::zero(),
            rest: match is_quantized {
                true => p.square().half() + (p + S::one().half()) * u,
                false => (p + u).square().half(),
            },
        }
    }

    /// The same at u = D + `place`.
    fn along(&self, place: S, is_quantized: bool) -> Stored<S> {
        let p = self.inside.clone();
        Stored {
            is_bent: !is_quantized,
            slope: match is_quantized {
                true => p + S::one().half(),
                false => p + place.clone(),
            },
            rest: self.at(place, is_quantized).rest,
        }
    }

    /// Net energy under such a force, before and behind D = K, where u is the largest at each D, or the least.
    fn arcs(
        &self,
        friction: &Resistance<S>,
        force: &S,
        is_largest: bool,
        is_quantized: bool,
    ) -> [Arc<S>; 2] {
        let (k, one) = (self.ticks.clone(), S::one());
        let [before, behind] = match is_largest {
            true => [
                self.along(one.clone() - k.clone(), is_quantized),
                self.at(one.clone(), is_quantized),
            ],
            false => [
                self.at(S::zero(), is_quantized),
                self.along(-k.clone(), is_quantized),
            ],
        };
        let taken = friction.sigma.clone() - force.clone();
        let arc = |stored: Stored<S>, ends: [S; 2]| {
            let Resistance {
                own, less, more, ..
            } = friction;
            let (bend, slope, constant) = match self.is_inward {
                true => (less, taken.clone() - stored.slope, -stored.rest),
                false => (more, taken.clone() + stored.slope, stored.rest),
            };
            Arc {
                bend: if stored.is_bent { bend } else { own }.clone(),
                slope,
                constant,
                ends,
            }
        };
        let [from, to] = [k.clone() - one.clone(), k.clone() + one];
        [arc(before, [from, k.clone()]), arc(behind, [k, to])]
    }

    // Such rows are rare: what is called again and again need not be fast, but short.

    /// Net energy under such a force, at the least and at the most, against the wall or its quantized form.
    #[inline(never)]
    fn net(&self, [least, most]: &[Resistance<S>; 2], force: &S, is_quantized: bool) -> [S; 2] {
        let [a, b] = self.arcs(least, force, self.is_inward, is_quantized);
        let [c, d] = self.arcs(most, force, !self.is_inward, is_quantized);
        let ([low, _], [lower, _]) = (extremes(&a), extremes(&b));
        let ([_, high], [_, higher]) = (extremes(&c), extremes(&d));
        [low.min(lower), high.max(higher)]
    }

    /// What is generated under such a force, at the least and at the most: φu and the energy of the wall, less φw, beside
    /// φK.
    #[inline(never)]
    fn generated(&self, force: &S, is_quantized: bool) -> [S; 2] {
        let (zero, one) = (S::zero(), S::one());
        let of = |u: S| {
            let stored = self.at(u.clone(), is_quantized).rest;
            let work = force.clone() * u;
            if self.is_inward {
                work + stored
            } else {
                work - stored
            }
        };
        // Where the wall balances the force.
        let balance = match (is_quantized, self.is_inward) {
            (true, _) => zero.clone(),
            (false, true) => -force.clone() - self.inside.clone(),
            (false, false) => force.clone() - self.inside.clone(),
        };
        let balance = balance.max(zero.clone()).min(one.clone());
        let [first, turn, last] = [zero.clone(), balance, one].map(of);
        let base = force.clone() * self.ticks.clone();
        [
            base.clone() + first.clone().min(turn.clone()).min(last.clone())
                - force.clone().max(zero.clone()),
            base + first.max(turn).max(last) - force.clone().min(zero),
        ]
    }
}

/// The least value and the largest one of an arc.
#[inline(never)]
fn extremes<S: Ordered>(arc: &Arc<S>) -> [S; 2] {
    let ([from, to], turn) = (&arc.ends, arc.turn());
    let (first, last) = (arc.at(from), arc.at(to));
    let least = turn.clone().min(first.clone()).min(last.clone());
    [least, turn.max(first).max(last)]
}

impl<S: Ordered> Row<S> {
    /// As [`of`](Self::of), from outside of a wall on one side to where it is linear, or back; `is_inward` says which.
    pub(crate) fn across(
        (frictions, criteria): Walls<'_, S>,
        of: &Interval<S>,
        (is_inward, is_exact, applied): (bool, bool, bool),
    ) -> Self {
        let ticks = of.end.clone() - of.start.clone();
        // The force of the wall is that of the first tick.
        let own = match is_inward {
            true => S::zero(),
            false => -(of.start.clone() + S::one().half()),
        };
        let force = if applied {
            of.force.clone()
        } else {
            own.clone()
        };
        let excess = force.clone() - own.clone();
        let ahead = |force: &S| match is_inward {
            true => force.clone(),
            false => -force.clone(),
        };
        let across = Across {
            inside: match is_inward {
                true => of.end.clone(),
                false => of.start.clone(),
            },
            ticks: ticks.abs(),
            is_inward,
        };
        let frictions = resistances(frictions, &of.lasts, is_exact);
        let crossing = Crossing {
            ticks: ticks.clone(),
            excess: excess.clone(),
        };
        let ([near, far], held) = (crossing.distances(), ahead(&force));
        let [least, most] = &frictions;
        Self {
            taken: [least.taken(&near), most.taken(&far)],
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: [false, true].map(|quantized| across.generated(&held, quantized)),
            net: [false, true].map(|quantized| across.net(&frictions, &held, quantized)),
            work: force * ticks,
            own: across.net(&frictions, &ahead(&own), false),
            // Outside of the wall there is no potential.
            stored: match is_inward {
                true => crossing.stored(&of.end),
                false => [
                    (-excess.clone()).min(S::zero()),
                    (-excess.clone()).max(S::zero()),
                ],
            },
            excess,
        }
    }
}
