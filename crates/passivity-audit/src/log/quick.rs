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

use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{Criterion, Friction, Scalar as _, dissipation};

use crate::ball::{Ball, unless};
use crate::log::counted::{Figures, Interval, Row};
use crate::log::lanes::{Length, truths};
use crate::log::wall::Wall;
use crate::plain::Plain;
use crate::span::BITS;

/// An end of a number: a multiple of 2⁻¹¹ and, of the rest, one of 2⁻⁵⁸. Sums of as many as a tile has rows are exact.
pub(crate) type End = [f64; 2];

/// Binary digits after the point of both.
const UPPER: i32 = 11;
const LOWER: i32 = 58;

/// 2⁻ⁿ.
const fn power(n: i32) -> f64 {
    f64::from_bits(((1023 - n) as u64) << 52)
}

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

/// The nearest multiple of 2⁻ⁿ, of a number that is below 2⁵⁰⁻ⁿ.
#[inline(always)]
fn nearest<const N: i32>(x: f64) -> f64 {
    let middle = 1.5 * power(N - 52);
    (x + middle) - middle
}

/// How far an end is moved for a number that is off by so much at most, and is rounded to the grid: on the grid too.
#[inline(always)]
fn outward(off: f64) -> f64 {
    let moved = nearest::<LOWER>(off + 1.5 * power(LOWER));
    if off == 0.0 { 0.0 } else { moved }
}

/// The end that is so far from a number.
#[inline(always)]
fn end(x: f64, moved: f64) -> End {
    let upper = nearest::<UPPER>(x);
    [upper, nearest::<LOWER>(x - upper) + moved]
}

/// The ends of a number that is between two, each moved outward by so much.
#[inline(always)]
fn around([least, most]: [Plain; 2], moved: f64) -> [End; 2] {
    [end(least.0, -moved), end(most.0, moved)]
}

/// An end in units of the grid.
#[inline(always)]
#[allow(clippy::cast_possible_truncation)] // both are whole numbers below 2⁶³
pub(crate) fn units([upper, lower]: End) -> i128 {
    let (upper, lower) = (upper * power(-UPPER), lower * power(-LOWER));
    (i128::from(upper as i64) << (BITS as i32 - UPPER))
        + (i128::from(lower as i64) << (BITS as i32 - LOWER))
}

/// A number in units of the grid as an end; `None` where it has no room, or is on a finer grid.
#[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation)] // nothing is lost
pub(crate) fn parts(n: i128) -> Option<End> {
    const FINER: i128 = (1 << (BITS as i32 - LOWER)) - 1;
    let upper = n >> (BITS as i32 - UPPER);
    let lower = (n - (upper << (BITS as i32 - UPPER))) as i64;
    let has_room = upper.unsigned_abs() < 1 << (UPPER + 35) && n & FINER == 0;
    has_room.then(|| {
        [
            upper as f64 * power(UPPER),
            lower as f64 * power(BITS as i32),
        ]
    })
}

/// The same end, with what is too large for the lower part in the upper one.
#[inline(always)]
pub(crate) fn carried([upper, lower]: End) -> End {
    let more = nearest::<UPPER>(lower);
    [upper + more, lower - more]
}

#[inline(always)]
fn both([lo, hi]: [End; 2]) -> [i128; 2] {
    [units(lo), units(hi)]
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
        }
    }

    /// What an interval comes to, whose force is off by so much at most, under the force in the log where that is
    /// `applied`, else under that of the wall; `is_exact` says whether friction has one value.
    #[inline(always)]
    pub(crate) fn row(
        &self,
        of: &Interval<Plain>,
        off: f64,
        is_exact: bool,
        applied: bool,
    ) -> Near {
        let row = Row::of((&self.frictions, &self.criteria), of, is_exact, applied);
        let off = if applied { off } else { 0.0 };
        let bounds = self.bounds(of, &row, off);
        let [least, _] = &self.frictions;
        let least = Resistance::new(least, &of.lasts);
        let ticks = of.end - of.start;
        let may_stand = ticks.0.abs() <= 1.0;
        let crossing = Crossing {
            ticks,
            excess: row.excess,
        };
        let ([[linear, _], [quantized, _]], own) = (row.net, row.own);
        let signs = lowest(&crossing, &least, [linear, quantized]).map(|x| sign(x, bounds.energy));
        let own_signs = match applied {
            true => lowest(&Crossing::own(ticks), &least, [own[0]; 2]).map(|x| sign(x, bounds.own)),
            false => signs,
        };
        let (covers, open) = self.answers(of, &row, (signs, bounds.energy), is_exact);

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
            open: open + bounds.too_large,
        }
    }

    /// What the figures of a row are off by, whose force is off by so much.
    #[inline(always)]
    fn bounds(&self, of: &Interval<Plain>, row: &Row<Plain>, off: f64) -> Bounds {
        let ([_, most], [viscous, coulomb]) = (&self.frictions, self.off);
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
        let most_of = |x: Plain| match ticks.0.abs() <= 1.0 {
            // Zero is among what it may be.
            true => [0.0, 1.0],
            false => sign(x.0, off),
        };
        let [[_, linear], [_, quantized]] = row.net;
        let (holds, of_margin) = covers(margin);
        // Had nothing moved, it would hold.
        let may_hold = holds == 0.0 && ticks.0.abs() <= 1.0;
        let holds = if may_hold { 2.0 } else { holds };
        let (linear, of_linear) = covers([signs[0], most_of(linear)]);
        let (quantized, of_quantized) = covers([signs[1], most_of(quantized)]);
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
        let near = self.row(&of, off, self.friction_is_exact, applied);
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
