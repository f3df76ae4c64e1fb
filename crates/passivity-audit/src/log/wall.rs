//! A loop that is nothing but a wall behind an encoder, in doubles: linear, but for where it ends or is saturated.

use passivity_core::{
    Criterion, Friction, Law, Loop, Ordered as _, Scalar as _, Step, ledger, quantizer,
};

use crate::ball::{Ball, Lane, unless};
use crate::ledger::Ledger;

/// A loop whose force is that of its wall, quantized and nothing else.
#[derive(Clone, Debug)]
pub(crate) struct Wall<const BRANCHES: bool = true> {
    /// The least friction and the most.
    pub(crate) frictions: [Friction<Ball<BRANCHES>>; 2],
    pub(crate) criteria: [Criterion<Ball<BRANCHES>>; 2],
    pub(crate) friction_is_exact: bool,
    /// Where it is linear; `None` for everywhere.
    pub(crate) reach: Option<Reach>,
    law: Law<Ball>,
}

/// Where a wall that is on one side, or saturated, is linear, and where its force is the same everywhere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Linear between these positions, in ticks.
    linear: [f64; 2],
    /// Up to the first of these and from the second one on, both the force and the quantized one are these.
    flat: [f64; 2],
    forces: [Lane; 2],
}

/// In which part of a wall an interval between two counts is, whose row depends on nothing else but how many ticks it goes
/// and how long it lasts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Where it is linear.
    Linear,
    /// Below and above that, where its force is the same everywhere.
    Below,
    Above,
}

impl Part {
    /// How many there are.
    pub(crate) const COUNT: usize = 3;

    /// What is kept for this part.
    pub(crate) const fn of<T>(self, [linear, below, above]: &[T; Self::COUNT]) -> &T {
        match self {
            Self::Linear => linear,
            Self::Below => below,
            Self::Above => above,
        }
    }
}

/// The counts in these parts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parts {
    /// From one to another.
    linear: [i64; 2],
    /// Up to one, and from another on.
    flat: [i64; 2],
    /// How large the force there is, at the least and at the most, in KΔ.
    forces: [[f64; 2]; 2],
}

impl Parts {
    #[inline(always)]
    pub(crate) fn of(&self, from: i64, to: i64) -> Option<Part> {
        let (low, high) = (from.min(to), from.max(to));
        let ([first, last], [below, above]) = (self.linear, self.flat);
        if low >= first && high <= last {
            Some(Part::Linear)
        } else if high <= below {
            Some(Part::Below)
        } else {
            (low >= above).then_some(Part::Above)
        }
    }

    /// Whether there is no force in a part.
    #[inline(always)]
    pub(crate) fn is_free(&self, part: Part) -> bool {
        let [[_, below], [_, above]] = self.forces;
        *part.of(&[false, below == 0.0, above == 0.0])
    }

    /// What twice the potential in the tick of a count in a part of one force is not below, in KΔ², as a whole number of at
    /// most 2⁴⁰.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation)] // it is within that
    pub(crate) fn twice_potential(&self, part: Part, count: i64) -> i128 {
        /// More than the few roundings of what it is made of.
        const ROUNDINGS: f64 = 1.0 / (1_u64 << 48) as f64;
        const MOST: f64 = (1_u64 << 40) as f64;
        let [below, above] = &self.forces;
        let [least, most] = *part.of(&[[0.0; 2], *below, *above]);
        // F(2ξ − F), with ξ no further than the end of the tick that is nearer to zero.
        let twice = 2.0 * (count.unsigned_abs() as f64 - 1.0);
        let bound = least * (twice - most) - least * (twice + most) * ROUNDINGS;
        bound.clamp(0.0, MOST) as i128
    }
}

/// Where a wall is bent: linear on one side of it, and of one force on the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bend {
    /// The position, and the force of the wall there, against the direction of positions.
    pub(crate) at: Ball,
    /// Whether it is linear below that.
    pub(crate) is_upper: bool,
}

/// The force of a wall where it is the same over a whole motion, and what is not zero where the motion is in no one part of
/// the wall.
pub(crate) struct Place {
    pub(crate) is_flat: bool,
    pub(crate) force: Lane,
    pub(crate) open: f64,
}

/// What an interval between two positions comes to under the force of a wall, in one part of it.
pub(crate) struct Held {
    /// The force that is held,
    pub(crate) commanded: Lane,
    /// what it generates against the wall's law and against its quantized form,
    pub(crate) generated: [Lane; 2],
    /// and the wall's potential where the interval ends.
    pub(crate) potential: Lane,
    /// Not zero where it is in no one part of the wall.
    pub(crate) open: f64,
}

impl Held {
    /// Of a wall that is linear within `reach`, or everywhere.
    ///
    /// The one text of rows that are computed several at a time and of those that are not: an interval may be of either,
    /// by where a log is cut.
    #[inline(always)]
    pub(crate) fn of(reach: Option<&Reach>, [start, end]: [Lane; 2], step: &Step<Lane>) -> Self {
        let mut commanded = quantizer::held_force(&start);
        let mut generated = ledger::generated_by_spring(step, &commanded, true);
        let mut potential = Law::bilateral().potential(&end);
        let mut open = 0.0;
        if let Some(reach) = reach {
            let place = reach.place(start, end);
            open = place.open;
            if place.is_flat {
                // A force that is the same everywhere generates nothing.
                generated = [Lane::zero(); 2];
                commanded = -place.force;
                potential = end * place.force - place.force.square().half();
            }
        }
        Self {
            commanded,
            generated,
            potential,
            open,
        }
    }
}

impl Reach {
    /// Of a law that is not linear everywhere.
    fn of(law: &Law<Ball>) -> Option<Self> {
        // A sample is in the middle of its tick for the law, half a tick away at most.
        let inside = |limit: Ball| (limit.parts().0 - limit.parts().1 - 0.5).next_down();
        let outside = |limit: Ball| (limit.parts().0 + limit.parts().1 + 0.5).next_up();
        let (below, above) = (law.lower, law.upper);
        let (from, below_from) = match below {
            // Where the wall ends at zero, so does a tick.
            Some(lower) if lower.is_zero() => (0.0, 0.0),
            Some(lower) => (-inside(-lower), -outside(-lower)),
            None => (f64::NEG_INFINITY, f64::NEG_INFINITY),
        };
        let [to, above_to] =
            [inside, outside].map(|end: fn(Ball) -> f64| above.map_or(f64::INFINITY, end));
        let force = |limit: Option<Ball>| limit.map_or(Lane::zero(), Ball::lane);
        (!law.is_linear()).then(|| Self {
            linear: [from, to],
            flat: [below_from, above_to],
            forces: [force(below), force(above)],
        })
    }

    /// In which part of the wall a motion between two positions is.
    #[inline(always)]
    pub(crate) fn place(&self, start: Lane, end: Lane) -> Place {
        let ((a, r), (b, s)) = (start.parts(), end.parts());
        let ([from, to], [below, above]) = (self.linear, self.flat);
        // A sample where a wall ends is one in it.
        let is_below = (a + r < below) & (b + s <= below);
        let is_above = (a - r >= above) & (b - s >= above);
        let is_flat = is_below | is_above;
        let outside = unless(a - r >= from)
            + unless(b - s >= from)
            + unless(a + r <= to)
            + unless(b + s <= to);
        Place {
            is_flat,
            force: if is_below {
                self.forces[0]
            } else {
                self.forces[1]
            },
            open: if is_flat { 0.0 } else { outside },
        }
    }

    /// The same anywhere within the ticks of two counts: each part of the wall is told half a tick from its end, so what is
    /// in it with the middle of a tick is so with all of it.
    #[inline(always)]
    pub(crate) fn ticks(&self, start: Lane, end: Lane) -> Place {
        let half = Lane::one().half();
        self.place(start + half, end + half)
    }
}

impl Wall {
    /// `None` for other loops.
    pub(crate) fn of(ledger: &Ledger) -> Option<Self> {
        let ends = ledger.near();
        let controller = &ends.controller;
        let is_plain = controller.encoder
            && controller.memory() == 0
            && controller.filter.ends()
            && controller.filter.sum == Ball::one()
            && controller.force_step.is_none();
        let law = ends.least.law();
        // What the controller does beside is what the law says.
        let is_one_sided = law.lower.is_some_and(Ball::is_zero);
        let is_plain =
            is_plain && controller.unilateral == is_one_sided && controller.max_force == law.upper;
        let friction =
            |of: &Loop<Ball>| Friction::new(of.viscous_friction(), of.coulomb_friction());
        (is_plain && ends.least.has_encoder()).then(|| Self {
            frictions: [friction(&ends.least), friction(&ends.most)],
            criteria: ends.criteria,
            friction_is_exact: ends.friction_is_exact(),
            reach: Reach::of(&law),
            law,
        })
    }

    /// Where it is bent within the ticks of two counts, or between them; `None` where that is in no one place, or is not told.
    pub(crate) fn bend(&self, counts: [Ball; 2]) -> Option<Bend> {
        let [from, to] = counts;
        let (low, high) = (from.min(to), from.max(to) + Ball::one());
        // Neither end of the ticks is on the other side of it.
        let is_clear = |gap: Option<Ball>| gap.map_or(Some(true), |gap| gap.is_nonnegative());
        let Law { lower, upper } = self.law;
        let lower_is_clear = is_clear(lower.map(|at| low - at))?;
        let upper_is_clear = is_clear(upper.map(|at| at - high))?;
        let (at, is_upper) = match (lower_is_clear, upper_is_clear) {
            (false, true) => (lower?, false),
            (true, false) => (upper?, true),
            _ => return None,
        };
        Some(Bend { at, is_upper })
    }

    /// The counts in its parts.
    #[allow(clippy::cast_possible_truncation)] // to the counts that there are
    pub(crate) fn parts(&self) -> Parts {
        let Some(reach) = &self.reach else {
            return Parts {
                linear: [i64::MIN, i64::MAX],
                flat: [i64::MIN, i64::MAX],
                forces: [[0.0; 2]; 2],
            };
        };
        // As in `ticks`, of the middle of each.
        let ([from, to], [below, above]) = (reach.linear, reach.flat);
        let forces = reach.forces.map(Lane::parts);
        let first = |from: f64| (from - 0.5).ceil() as i64;
        let last = |to: f64| (to - 0.5).floor() as i64;
        Parts {
            linear: [first(from), last(to)],
            flat: [last(below), first(above)],
            forces: forces.map(|(middle, radius)| {
                let (least, most) = (middle.abs() - radius, middle.abs() + radius);
                [
                    least.next_down().max(0.0),
                    if most > 0.0 { most.next_up() } else { 0.0 },
                ]
            }),
        }
    }

    /// The same, to compute several rows at a time.
    pub(crate) fn lanes(&self) -> Wall<false> {
        Wall {
            frictions: self
                .frictions
                .map(|of| Friction::new(of.beta.lane(), of.sigma.lane())),
            criteria: self.criteria.map(|of| Criterion {
                viscous: of.viscous.lane(),
                coulomb: of.coulomb.lane(),
            }),
            friction_is_exact: self.friction_is_exact,
            reach: self.reach,
            law: self.law,
        }
    }
}
