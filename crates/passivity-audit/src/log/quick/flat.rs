//! Rows where the force of the wall is the same everywhere: outside of a wall on one side, and where it is saturated.

use std::cmp::Ordering;

use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{Ordered, Scalar as _};

use super::grid::{nearest, power};
use super::{Bounds, LARGEST, Quick, SURELY, Sign, WIDEST, sign};
use crate::ball::unless;
use crate::log::counted::{Interval, Row, Walls, margin, resistances};
use crate::log::wall::Place;
use crate::plain::Plain;

/// Net energy under this excess over the wall's force: by how far an interval goes, in each direction that it may go in.
#[inline(always)]
fn arcs<S: Ordered>(crossing: &Crossing<S>, friction: &Resistance<S>) -> [Arc<S>; 2] {
    let ahead = match crossing.ticks.is_nonnegative() {
        Some(false) => -crossing.excess.clone(),
        _ => crossing.excess.clone(),
    };
    // Of what goes in one direction both are the same.
    let back = match crossing.ticks.sign() {
        Some(Ordering::Equal) => -ahead.clone(),
        _ => ahead.clone(),
    };
    [
        arc(crossing, friction, ahead),
        arc(crossing, friction, back),
    ]
}

#[inline(always)]
fn arc<S: Ordered>(crossing: &Crossing<S>, friction: &Resistance<S>, excess: S) -> Arc<S> {
    Arc {
        bend: friction.own.clone(),
        slope: friction.sigma.clone() - excess,
        constant: S::zero(),
        ends: crossing.distances(),
    }
}

/// The least value and the largest one of an arc that is bent up.
#[inline(always)]
fn extremes<S: Ordered>(arc: &Arc<S>) -> [S; 2] {
    let ([from, to], turn) = (&arc.ends, arc.turn());
    let (first, last) = (arc.at(from), arc.at(to));
    [turn.min(first.clone()).min(last.clone()), first.max(last)]
}

impl<S: Ordered> Row<S> {
    /// As [`of`](Self::of), where the wall's force is the same everywhere: `level`, against the direction of positions.
    ///
    /// What that does it takes up, so only the excess f over it generates: fd, d anywhere from k − 1 to k + 1. Net energy
    /// βd²/Δτ + σ|d| − fd is largest at an end of that, and least there or where it turns.
    #[inline(always)]
    pub(crate) fn flat(
        (frictions, criteria): Walls<'_, S>,
        of: &Interval<S>,
        level: &S,
        is_exact: bool,
        applied: bool,
    ) -> Self {
        let ticks = of.end.clone() - of.start.clone();
        let (excess, force) = match applied {
            true => (of.force.clone() + level.clone(), of.force.clone()),
            false => (S::zero(), -level.clone()),
        };
        let crossing = Crossing {
            ticks: ticks.clone(),
            excess: excess.clone(),
        };
        let [least, most] = resistances(frictions, &of.lasts, is_exact);
        let [near, far] = crossing.distances();
        let taken = [least.taken(&near), most.taken(&far)];
        let ([a, b], [c, d]) = (arcs(&crossing, &least), arcs(&crossing, &most));
        let ([a, _], [b, _]) = (extremes(&a), extremes(&b));
        let ([_, c], [_, d]) = (extremes(&c), extremes(&d));
        let net = [a.min(b), c.max(d)];
        let back = (ticks.clone() - S::one()) * excess.clone();
        let on = (ticks.clone() + S::one()) * excess.clone();
        let generated = [back.clone().min(on.clone()), back.max(on)];
        // V(ξ₁) − fρ₁ is a line.
        let potential = level.clone() * of.end.clone() - level.square().half();
        let rise = level.clone() - excess.clone();
        let stored = [
            potential.clone() + rise.clone().min(S::zero()),
            potential + rise.max(S::zero()),
        ];
        Self {
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: [generated.clone(), generated],
            net: [net.clone(), net],
            work: force * ticks,
            own: taken.clone(),
            taken,
            stored,
            excess,
        }
    }
}

/// The sign of the least net energy of such a row.
#[inline(always)]
pub(super) fn sign_of(
    row: &Row<Plain>,
    least: &Resistance<Plain>,
    ticks: Plain,
    of: &Bounds,
) -> Sign {
    let excess = row.excess;
    let [ahead, back] = arcs(&Crossing { ticks, excess }, least);
    let [[net, _], _] = row.net;
    // Where the device may have stood still, net energy is not negative where it rises from there.
    let lowest = match ticks.0.abs() <= 1.0 {
        true => ahead.slope.min(back.slope),
        false => net,
    };
    // Friction alone only takes.
    match excess.0 == 0.0 && of.excess == 0.0 {
        true => SURELY,
        false => sign(lowest.0, of.energy),
    }
}

impl Quick {
    /// What the figures of such a row are off by, whose force is off by so much.
    #[inline(always)]
    pub(super) fn flat_bounds(
        &self,
        of: &Interval<Plain>,
        row: &Row<Plain>,
        (off, place): (f64, &Place),
        applied: bool,
    ) -> Bounds {
        let (level, of_level) = place.force.parts();
        let of_excess = if applied { off + of_level } else { 0.0 };
        let bounds = self.bounds(of, row, of_excess);
        let (k, end) = ((of.end - of.start).0.abs(), of.end.0.abs());
        let (level, f, work) = (level.abs(), row.excess.0.abs(), row.work.0.abs());
        let is_short = of_level == 0.0 && nearest::<4>(level) == level && bounds.excess == 0.0;
        let unless_short = |off: f64| if is_short { 0.0 } else { off };
        // What V(ξ₁) − fρ₁ is made of: four roundings of no more than this.
        let stored = level * end + level * level + (f + level + 1.0);
        let of_stored = of_excess + of_level * (end + level + 2.0);
        Bounds {
            work: unless_short(k * (off + of_level) + work * power(50)),
            stored: unless_short(stored * power(50) + of_stored),
            too_large: bounds.too_large + unless(stored < LARGEST) + unless(of_stored < WIDEST),
            ..bounds
        }
    }
}
