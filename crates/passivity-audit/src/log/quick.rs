//! What an interval between two counts comes to, in doubles that are off by no more than a bound that is known
//! beforehand: the fastest that most rows of counts are computed.
//!
//! [`Row::of`] is computed with plain doubles, and what all of its roundings together come to is bounded by one number
//! for each row. With u = 2⁻⁵³, what a rounding is off by at most; K = |k| + 1 for the k ticks from one count to the
//! other; r = β/Δτ, σ and f as in [`passivity_core::counted`], whose β, σ and f are known but for δβ, δσ and ρ; that bound
//! is
//!
//! e = 2⁻⁴⁶·s + K·(K·δβ/Δτ + δσ + ρ), s = K·(K·(r + 1) + σ + |f|).
//!
//! * Counts are whole and exact, as are k, the force of the wall at the middle of a tick and whatever is made of them
//!   and of halves alone. An energy changes with r by at most K², with σ and f by at most K, and so do the least and the
//!   largest of such energies. That is the second part of e, and of the first one 2u·K²·r + u·K·|f|, as r is a double
//!   that is off by two roundings of its own and f by one. From here on both are these doubles.
//! * Each energy is a sum of at most six terms whose sizes are together at most 2s, each a product of at most three
//!   factors: rounding takes at most 20u of 2s.
//! * The place where a parabola of bend α and slope γ turns is off too: by δ ≤ |d|·(2δα/α + 3u) + δγ/α with
//!   δα ≤ u·(r + ½) and δγ ≤ 3u·(σ + K + |f|). The value there is off by at most 3αδ: next to its turn a parabola is flat,
//!   and a turn that is beyond an end of the arc, or is taken to be, is no further from it than δ. As d is K at most that
//!   is at most 6u·K·(r + ½) + 9u·K·α + 9u·(σ + K + |f|). Where α is not told from zero, or is of the other sign, the
//!   parabola is off its chord by at most ¼·|α| ≤ δα.
//!
//! Together that is less than 70u·s, and 2⁻⁴⁶ is 128u.
//!
//! A figure that is surely zero, or surely not rounded, is not widened: what standing still draws decides many a trace, and
//! where the least of it stays the same the first such row is told. Where the device may have stood still, |k| ≤ 1, the
//! least net energy is zero or below, and which of both is told by what each parabola rises with from there.
//!
//! Where the force of the wall is the same everywhere, energies have fewer terms, and f is off by what that force is too.

mod flat;
mod grid;

use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{Criterion, Friction, Scalar as _, dissipation};

pub(crate) use grid::{End, carried, parts, units};

use crate::ball::{Ball, unless};
use crate::log::counted::{Figures, Interval, Row};
use crate::log::lanes::{Length, truths};
use crate::log::wall::{Reach, Wall};
use crate::plain::Plain;
use grid::{around, both, end, nearest, outward, power};

/// What a [`Quick::row`] may be off by at most, of its size.
const ROUNDING: f64 = power(46);

/// Sizes have room for sums.
const LARGEST: f64 = power(-33);
const WIDEST: f64 = power(14);

/// The friction and the criteria of a wall, in plain doubles.
#[derive(Clone, Debug)]
pub(crate) struct Quick {
    frictions: [Friction<Plain>; 2],
    criteria: [Criterion<Plain>; 2],
    /// What both frictions are off by at most: viscous and Coulomb friction.
    off: [f64; 2],
    /// What the numbers of each criterion are off by.
    off_criteria: [[f64; 2]; 2],
    pub(crate) friction_is_exact: bool,
    /// Where the wall is linear; `None` for everywhere.
    pub(crate) reach: Option<Reach>,
}

/// What an interval comes to, on the grid: as [`Row`]. Pairs are at the least and at the most.
pub(crate) struct Near {
    /// As [`Figures`] has it.
    pub(crate) sums: [[End; 2]; 5],
    pub(crate) observed: End,
    pub(crate) own: [End; 2],
    pub(crate) excess: [End; 2],
    pub(crate) stored: [End; 2],
    /// What is not negative, as bits: the margin of the criterion, net energy, and that against the quantized wall, each
    /// at the least and at the most.
    pub(crate) covers: f64,
    /// Zero where all is decided, else above that.
    pub(crate) open: f64,
}

/// What is told of a number: zero where it is surely not negative, else one; and the same of whether it surely is.
type Sign = [f64; 2];

/// Of what is surely not negative.
const SURELY: Sign = [0.0, 1.0];

/// The sign of a number that is off by so much at most.
#[inline(always)]
fn sign(x: f64, off: f64) -> Sign {
    [unless(x >= off), unless(-x > off)]
}

/// Whether numbers at the least and at the most are not negative, as two bits; and zero where that is decided, else above
/// that.
#[inline(always)]
fn covers([least, most]: [Sign; 2]) -> (f64, f64) {
    let ([a, b], [c, d]) = (least, most);
    (3.0 - (a + 2.0 * c), a * b + c * d)
}

/// A whole number as a double, where nothing that is made of it is rounded.
#[inline(always)]
#[allow(clippy::cast_precision_loss)] // it has fewer digits
pub(crate) fn whole(n: i64) -> Option<f64> {
    is_whole(n).then_some(n as f64)
}

/// Whether [`whole`] has it.
#[inline(always)]
pub(crate) const fn is_whole(n: i64) -> bool {
    n.unsigned_abs() < 1 << 40
}

/// What a parabola rises with from zero to one, at the least.
#[inline(always)]
fn rise(of: &Arc<Plain>) -> Plain {
    of.slope.min(of.bend.square + of.slope)
}

/// The least net energy against the wall and against its quantized form; where the device may have stood still, a number
/// that is not negative exactly where they are not.
#[inline(always)]
fn lowest(
    crossing: &Crossing<Plain>,
    least: &Resistance<Plain>,
    [linear, quantized]: [Plain; 2],
) -> [f64; 2] {
    let ticks = crossing.ticks;
    let ([same, _], [first, last]) = crossing.net_at_corners(least);
    let far = if ticks.0 >= 0.0 { last } else { first };
    let of = |[before, behind]: [Arc<Plain>; 2], least: Plain| {
        let still = rise(&before).min(rise(&behind));
        let one = rise(&before).min(same).min(far).min(behind.turn());
        match ticks.abs().0 {
            0.0 => still.0,
            1.0 => one.0,
            _ => least.0,
        }
    };
    [
        of(crossing.least_linear(least), linear),
        of(crossing.least_quantized(least), quantized),
    ]
}

/// The signs of the margin of a criterion at two speeds, whose viscous and Coulomb parts are off by so much.
#[inline(always)]
fn margins(
    criterion: &Criterion<Plain>,
    [viscous, coulomb]: [f64; 2],
    speeds: [Plain; 2],
) -> [Sign; 2] {
    const MARGIN: f64 = power(50);
    speeds.map(|speed| {
        // At rest nothing is rounded.
        let moves = if speed.0 > 0.0 { 1.0 } else { 0.0 };
        let size = criterion.viscous.0.abs() * speed.0 + criterion.coulomb.0.abs() * moves;
        let off = size * MARGIN + viscous * speed.0 + coulomb;
        sign(criterion.margin(&speed).0, off)
    })
}

/// What the figures of a row are off by at most.
struct Bounds {
    /// e, of net energy and of what friction takes,
    energy: f64,
    /// the same of the wall's own force,
    own: f64,
    /// and what is made of ticks and of the force alone.
    generated: f64,
    work: f64,
    stored: f64,
    excess: f64,
    /// Zero where all of it has room in sums, else above that.
    too_large: f64,
}

impl Quick {
    pub(crate) fn of(wall: &Wall) -> Self {
        let plain = |ball: &Ball| Plain(ball.parts().0);
        let off = |ball: &Ball| ball.parts().1;
        let larger = |of: [&Ball; 2]| off(of[0]).max(off(of[1]));
        let [least, most] = &wall.frictions;
        let criteria = wall.criteria.each_ref();
        Self {
            frictions: [least, most].map(|of| Friction::new(plain(&of.beta), plain(&of.sigma))),
            criteria: criteria.map(|of| Criterion {
                viscous: plain(&of.viscous),
                coulomb: plain(&of.coulomb),
            }),
            off: [
                larger([&least.beta, &most.beta]),
                larger([&least.sigma, &most.sigma]),
            ],
            off_criteria: criteria.map(|of| [off(&of.viscous), off(&of.coulomb)]),
            friction_is_exact: wall.friction_is_exact,
            reach: wall.reach,
        }
    }

    /// What an interval comes to, whose force is off by so much at most, under the force in the log where that is
    /// `applied`, else under that of the wall, which is linear within `reach`; `is_exact` says whether friction has one
    /// value.
    #[inline(always)]
    pub(crate) fn row(
        &self,
        of: &Interval<Plain>,
        off: f64,
        reach: Option<&Reach>,
        (is_exact, applied): (bool, bool),
    ) -> Near {
        let walls = (&self.frictions, &self.criteria);
        let mut row = Row::of(walls, of, is_exact, applied);
        let off = if applied { off } else { 0.0 };
        let [least, most] = &self.frictions;
        // Of friction of one value what it takes is found once.
        let mut bounds = self.bounds(of, &row, off, if is_exact { least } else { most });
        let least = Resistance::new(least, &of.lasts);
        let ticks = of.end - of.start;
        let may_stand = ticks.0.abs() <= 1.0;
        let crossing = Crossing {
            ticks,
            excess: row.excess,
        };
        let ([[linear, _], [quantized, _]], own) = (row.net, row.own);
        let mut signs =
            lowest(&crossing, &least, [linear, quantized]).map(|x| sign(x, bounds.energy));
        let mut own_signs = match applied {
            true => lowest(&Crossing::own(ticks), &least, [own[0]; 2]).map(|x| sign(x, bounds.own)),
            false => signs,
        };
        let mut left = 0.0;
        if let Some(reach) = reach {
            let place = reach.ticks(
                Ball::from_parts(of.start.0, 0.0).lane(),
                Ball::from_parts(of.end.0, 0.0).lane(),
            );
            left = place.open;
            let (level, _) = place.force.parts();
            let flat = Row::flat(walls, of, Plain(level), is_exact, applied);
            let of_flat = self.flat_bounds(of, &flat, (off, &place), applied);
            let sign = flat::sign_of(&flat, &least, ticks, &of_flat);
            if place.is_flat {
                (row, bounds) = (flat, of_flat);
                // The wall's own force leaves what friction takes.
                (signs, own_signs) = ([sign; 2], [SURELY; 2]);
            }
        }
        let (own, open) = (row.own, left);
        let (covers, left) = self.answers(of, &row, (signs, bounds.energy), is_exact);

        let moved = outward(bounds.energy);
        let least_of = |is_zero: bool, x: Plain, moved: f64| match is_zero {
            true => [0.0; 2],
            false => end(x.0, -moved),
        };
        let net = |[least, most]: [Plain; 2], [yes, _]: Sign, moved: f64| {
            let is_zero = may_stand && yes == 0.0;
            [least_of(is_zero, least, moved), end(most.0, moved)]
        };
        let generated = outward(bounds.generated);
        let [taken, taken_at_most] = row.taken;
        Near {
            sums: [
                around(row.generated[0], generated),
                around(row.generated[1], generated),
                [
                    least_of(may_stand, taken, moved),
                    end(taken_at_most.0, moved),
                ],
                net(row.net[0], signs[0], moved),
                net(row.net[1], signs[1], moved),
            ],
            observed: end(-row.work.0, -outward(bounds.work)),
            own: net(own, own_signs[0], outward(bounds.own)),
            excess: around([row.excess; 2], outward(bounds.excess)),
            stored: around(row.stored, outward(bounds.stored)),
            covers,
            open: open + left + bounds.too_large,
        }
    }

    /// What the figures of a row are off by, whose force is off by so much, beside the most friction.
    #[inline(always)]
    fn bounds(
        &self,
        of: &Interval<Plain>,
        row: &Row<Plain>,
        off: f64,
        most: &Friction<Plain>,
    ) -> Bounds {
        let [viscous, coulomb] = self.off;
        let (k, f) = ((of.end - of.start).0.abs(), row.excess.0.abs());
        // Sixteenths are: no product of them and of whole numbers is rounded. Most devices are outside of any wall, where
        // no force is held, for a good part of their time, and under the wall's own force there is no excess.
        let is_short = off == 0.0 && nearest::<4>(f) == f;
        let unless_short = |off: f64| if is_short { 0.0 } else { off };
        let reach = k + 1.0;
        let steady = reach * (reach * (most.beta.over(of.lasts).0 + 1.0) + most.sigma.0);
        let size = steady + reach * f;
        let known = reach * (reach * (viscous / of.lasts.0) + coulomb);
        let energy = size * ROUNDING + (known + reach * off);
        let stored = (0.5 * (of.end.0 * of.end.0) + of.end.0.abs()) + (f + 1.0);
        let work = row.work.0.abs();
        let bounds = Bounds {
            energy,
            own: steady * ROUNDING + known,
            generated: unless_short(energy),
            work: unless_short(k * off + work * power(50)),
            stored: unless_short(stored * power(50) + off),
            excess: unless_short(off + f * power(52)),
            too_large: 0.0,
        };
        let all = energy + bounds.stored + bounds.work;
        let is_small = [size, 0.25 * stored, work].map(|size| unless(size < LARGEST));
        Bounds {
            too_large: is_small[0] + is_small[1] + is_small[2] + unless(all < WIDEST),
            ..bounds
        }
    }

    /// What a row answers, as [`Near::covers`], and zero where it is decided, else above that: given the signs of what
    /// [`lowest`] says, and what net energy is off by.
    #[inline(always)]
    fn answers(
        &self,
        of: &Interval<Plain>,
        row: &Row<Plain>,
        (signs, off): ([Sign; 2], f64),
        is_exact: bool,
    ) -> (f64, f64) {
        let ticks = of.end - of.start;
        let speeds = Crossing::own(ticks)
            .distances()
            .map(|d| dissipation::mean_speed(&d, &of.lasts));
        let [low, high] = &self.criteria;
        let [of_low, of_high] = self.off_criteria;
        let least = margins(low, of_low, speeds);
        let most = match is_exact {
            true => least,
            false => margins(high, of_high, speeds),
        };
        // The least margin is not negative where both are, and the largest where one is.
        let ([[a, b], [c, d]], [[e, f], [g, h]]) = (least, most);
        let margin = [[unless(a + c == 0.0), b * d], [e * g, unless(f + h == 0.0)]];
        // Zero, or what is above it, is among what it may be.
        let may_hold = |[yes, _]: Sign| ticks.0.abs() <= 1.0 || yes == 0.0;
        let most_of = |least: Sign, x: Plain| match may_hold(least) {
            true => SURELY,
            false => sign(x.0, off),
        };
        let [[_, linear], [_, quantized]] = row.net;
        let (holds, of_margin) = covers(margin);
        // Had nothing moved, it would hold.
        let may_hold = holds == 0.0 && ticks.0.abs() <= 1.0;
        let holds = if may_hold { 2.0 } else { holds };
        let (linear, of_linear) = covers([signs[0], most_of(signs[0], linear)]);
        let (quantized, of_quantized) = covers([signs[1], most_of(signs[1], quantized)]);
        (
            holds + 4.0 * linear + 16.0 * quantized,
            of_margin + of_linear + of_quantized,
        )
    }

    /// The figures of an interval between these counts that lasts so long, under the force in the log where there is any;
    /// `None` where these doubles leave something open.
    pub(crate) fn figures(
        &self,
        [from, to]: [i64; 2],
        lasts: Length,
        force: Option<Ball>,
    ) -> Option<Figures> {
        let applied = force.is_some();
        let (force, off) = force.map_or((0.0, 0.0), Ball::parts);
        let of = Interval {
            start: Plain(whole(from)?),
            end: Plain(whole(to)?),
            lasts: Plain(lasts.nearest()?),
            force: Plain(force),
        };
        let reach = self.reach.as_ref();
        let near = self.row(&of, off, reach, (self.friction_is_exact, applied));
        (near.open == 0.0).then(|| near.figures(to - from))
    }
}

impl Near {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // six bits
    fn figures(&self, crossed: i64) -> Figures {
        Figures {
            sums: self.sums.map(both),
            observed: units(self.observed),
            own: both(self.own),
            excess: both(self.excess),
            stored: both(self.stored),
            truths: truths(self.covers as u64),
            crossed,
        }
    }
}

#[cfg(test)]
mod tests;
