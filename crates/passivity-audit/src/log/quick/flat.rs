//! Rows where the force of the wall is the same everywhere: outside of a wall on one side, and where it is saturated.

use passivity_core::Scalar as _;
use passivity_core::counted::{Arc, Crossing, Resistance};

use super::grid::{nearest, power};
use super::{Bounds, LARGEST, Quick, SURELY, Sign, WIDEST, sign};
use crate::ball::unless;
use crate::log::counted::{Interval, Row, Walls, margin, resistances};
use crate::log::wall::Place;
use crate::plain::Plain;

/// Net energy under this excess over the wall's force: by how far an interval goes, in each direction that it may go in.
#[inline(always)]
fn arcs(crossing: &Crossing<Plain>, friction: &Resistance<Plain>) -> [Arc<Plain>; 2] {
    let (ticks, excess) = (crossing.ticks.0, crossing.excess);
    let ahead = if ticks >= 0.0 { excess } else { -excess };
    // Of what goes in one direction both are the same.
    let back = if ticks == 0.0 { -ahead } else { ahead };
    [
        arc(crossing, friction, ahead),
        arc(crossing, friction, back),
    ]
}

#[inline(always)]
fn arc(crossing: &Crossing<Plain>, friction: &Resistance<Plain>, excess: Plain) -> Arc<Plain> {
    Arc {
        bend: friction.own,
        slope: friction.sigma - excess,
        constant: Plain::zero(),
        ends: crossing.distances(),
    }
}

/// The least value and the largest one of an arc that is bent up.
#[inline(always)]
fn extremes(arc: &Arc<Plain>) -> [Plain; 2] {
    let ([from, to], turn) = (&arc.ends, arc.turn());
    let (first, last) = (arc.at(from), arc.at(to));
    [turn.min(first).min(last), first.max(last)]
}

impl Row<Plain> {
    /// As [`of`](Self::of), where the wall's force is the same everywhere: `level`, against the direction of positions.
    ///
    /// What that does it takes up, so only the excess f over it generates: fd, d anywhere from k − 1 to k + 1. Net energy
    /// βd²/Δτ + σ|d| − fd is largest at an end of that, and least there or where it turns.
    #[inline(always)]
    pub(crate) fn flat(
        (frictions, criteria): Walls<'_, Plain>,
        of: &Interval<Plain>,
        level: Plain,
        is_exact: bool,
        applied: bool,
    ) -> Self {
        let ticks = of.end - of.start;
        let (excess, force) = match applied {
            true => (of.force + level, of.force),
            false => (Plain::zero(), -level),
        };
        let crossing = Crossing { ticks, excess };
        let [least, most] = resistances(frictions, &of.lasts, is_exact);
        let [near, far] = crossing.distances();
        let taken = [least.taken(&near), most.taken(&far)];
        let ([a, b], [c, d]) = (arcs(&crossing, &least), arcs(&crossing, &most));
        let ([a, _], [b, _]) = (extremes(&a), extremes(&b));
        let ([_, c], [_, d]) = (extremes(&c), extremes(&d));
        let net = [a.min(b), c.max(d)];
        let back = (ticks - Plain::one()) * excess;
        let on = (ticks + Plain::one()) * excess;
        let generated = [back.min(on), back.max(on)];
        // V(ξ₁) − fρ₁ is a line.
        let potential = level * of.end - level.square().half();
        let rise = level - excess;
        let stored = [
            potential + rise.min(Plain::zero()),
            potential + rise.max(Plain::zero()),
        ];
        Self {
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: [generated, generated],
            net: [net, net],
            work: force * ticks,
            own: taken,
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
        let bounds = self.bounds(of, row, of_excess, &self.frictions[1]);
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
