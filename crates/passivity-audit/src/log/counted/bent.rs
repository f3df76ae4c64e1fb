//! Rows where a wall is bent: between counts one of which is where it is linear and the other where its force is the same,
//! or of which one has both in its tick.
//!
//! With y the way from the bend to where the wall is linear, its energy is U(y) = ½·max(y, 0)² beyond what its force at
//! the bend does, and the quantized force max(t + ½, 0) less than that in the tick from t to t + 1. Every force below is
//! in the direction of y and without the force at the bend, so that where that is all there is nothing is generated,
//! exactly.
//!
//! With u the place within the upper one of both ticks and z that within the lower one, the distance is D = K + u − z. A
//! force φ in the direction of the motion generates φD, and the wall ΔU = U(h + u) − U(l + z) more on the way up, or less
//! on the way down. That grows with both places. So at each D net energy is extreme where z is 1 before D = K and u is 1
//! behind it, or where u is 0 before it and z is 0 behind it: along pieces of parabolas in D. Between two places in one
//! tick, K = 0, there is a way up and one down, each behind D = 0.

use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{Ordered as _, Scalar as _};

use super::{Interval, Row, Walls, margin, resistances};
use crate::ball::Ball;
use crate::log::wall::Bend;

/// What the energy of the wall rises by along a piece of a way, and where that is.
struct Piece {
    /// How often ½D² it is.
    bend: i32,
    slope: Ball,
    rest: Ball,
    ends: [Ball; 2],
}

/// The pieces of a way.
type Pieces = [Option<Piece>; 2];

/// Which part of a wall a tick is in.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Linear,
    Flat,
    Both,
}

/// Two ticks of which one is no lower than the other, each from its lower end: l, h, and K = h − l.
struct Ways {
    lower: (Ball, Side),
    upper: (Ball, Side),
    ticks: Ball,
}

/// ½·max(y, 0)².
fn energy(y: Ball) -> Ball {
    y.max(Ball::zero()).square().half()
}

/// The quantized force of the wall in the tick from t on, less that at the bend.
fn quantized(tick: Ball) -> Ball {
    (tick + Ball::one().half()).max(Ball::zero())
}

/// What is known of a tick; `None` where it is not told which part of the wall it is in.
fn side(tick: Ball) -> Option<Side> {
    let end = tick + Ball::one();
    if tick.is_nonnegative()? {
        Some(Side::Linear)
    } else if (-end).is_nonnegative()? {
        Some(Side::Flat)
    } else {
        Some(Side::Both)
    }
}

// Such rows are rare: what is called again and again need not be fast, but short.

/// The least and the largest of gρ + U(t + ρ) over a tick.
#[inline(never)]
fn over_tick(force: Ball, tick: Ball) -> [Ball; 2] {
    let (zero, one) = (Ball::zero(), Ball::one());
    let balance = ((-force).max(zero) - tick).max(zero).min(one);
    let [first, turn, last] = [zero, balance, one].map(|at| force * at + energy(tick + at));
    [first.min(turn).min(last), first.max(last)]
}

/// What the quantized energy rises by over some ticks, the first of which starts at t.
#[inline(never)]
fn over_ticks(tick: Ball, many: Ball) -> Ball {
    let (zero, one) = (Ball::zero(), Ball::one());
    let middle = tick + one.half();
    let skipped = (-middle.floor()).max(zero);
    let left = (many - skipped).max(zero);
    left * (middle + skipped) + (left * (left - one)).half()
}

/// The least value of an arc, or the largest one.
#[inline(never)]
fn extreme(arc: &Arc<Ball>, is_most: bool) -> Ball {
    let ([from, to], turn) = (&arc.ends, arc.turn());
    let (first, last) = (arc.at(from), arc.at(to));
    match is_most {
        true => turn.max(first).max(last),
        false => turn.min(first).min(last),
    }
}

impl Ways {
    /// The upper tick is moved through, from the place c − D on: U(c + D) − U(c).
    fn upwards(&self, from: Ball, ends: [Ball; 2]) -> Pieces {
        let zero = Ball::zero();
        let flat = |ends| Piece {
            bend: 0,
            slope: zero,
            rest: zero,
            ends,
        };
        let linear = |ends| Piece {
            bend: 1,
            slope: from,
            rest: from.min(zero).square().half(),
            ends,
        };
        let [first, last] = ends;
        match self.upper.1 {
            Side::Linear => [Some(linear(ends)), None],
            Side::Flat => [Some(flat(ends)), None],
            Side::Both => [Some(flat([first, -from])), Some(linear([-from, last]))],
        }
    }

    /// The lower one is, to the place e: U(e) − U(e − D).
    fn downwards(&self, to: Ball, ends: [Ball; 2]) -> Pieces {
        let zero = Ball::zero();
        let flat = |ends| Piece {
            bend: 0,
            slope: zero,
            rest: energy(to),
            ends,
        };
        let linear = |ends| Piece {
            bend: -1,
            slope: to,
            rest: zero,
            ends,
        };
        let [first, last] = ends;
        match self.lower.1 {
            Side::Linear => [Some(linear(ends)), None],
            Side::Flat => [Some(flat(ends)), None],
            Side::Both => [Some(linear([first, to])), Some(flat([to, last]))],
        }
    }

    /// Before and behind D = K, what the energy of the wall rises by, where it is the largest at each D, or the least.
    #[inline(never)]
    fn pieces(&self, is_largest: bool) -> [Pieces; 2] {
        let (k, one) = (self.ticks, Ball::one());
        let ((l, _), (h, _)) = (self.lower, self.upper);
        let (early, late) = ([k - one, k], [k, k + one]);
        let [before, behind] = match is_largest {
            true => [self.upwards(l + one, early), self.downwards(h + one, late)],
            false => [self.downwards(h, early), self.upwards(l, late)],
        };
        [self.unless_same(before), behind]
    }

    /// The same of its quantized form.
    #[inline(never)]
    fn quantized_pieces(&self, is_largest: bool) -> [Pieces; 2] {
        let (k, one) = (self.ticks, Ball::one());
        let ((l, _), (h, _)) = (self.lower, self.upper);
        let (low, high, between) = (quantized(l), quantized(h), over_ticks(l, k));
        // Without a distance nothing is generated: told so, for what is equal is not told to be.
        let unless = |is_zero: bool, rest: Ball| if is_zero { Ball::zero() } else { rest };
        let piece = |slope: Ball, rest: Ball, ends: [Ball; 2]| {
            let bend = 0;
            let piece = Piece {
                bend,
                slope,
                rest,
                ends,
            };
            [Some(piece), None]
        };
        let (early, late) = ([k - one, k], [k, k + one]);
        let (is_next, is_same) = (k == one, k.is_zero());
        let [before, behind] = match is_largest {
            true => [
                piece(
                    high,
                    unless(is_next, between - low - high * (k - one)),
                    early,
                ),
                piece(low, unless(is_same, between + high - low * (k + one)), late),
            ],
            false => [
                piece(low, unless(is_next, between - low * k), early),
                piece(high, unless(is_same, between - high * k), late),
            ],
        };
        [self.unless_same(before), behind]
    }

    /// Within one tick there is nothing before D = K.
    fn unless_same(&self, pieces: Pieces) -> Pieces {
        match self.ticks.is_zero() {
            true => [None, None],
            false => pieces,
        }
    }

    /// What the energy of the wall, or of its quantized form, rises by: where it is the largest at each D, and the least.
    fn rises(&self) -> [Rises; 2] {
        [
            [self.pieces(true), self.pieces(false)],
            [self.quantized_pieces(true), self.quantized_pieces(false)],
        ]
    }
}

/// Where the energy of a wall rises the most at each distance, and where it does the least: before and behind D = K.
type Rises = [[Pieces; 2]; 2];

/// Net energy on the way up or down under a force in that direction, at the least and at the most.
#[inline(never)]
fn net(
    [largest, least]: &Rises,
    frictions: &[Resistance<Ball>; 2],
    force: Ball,
    is_up: bool,
) -> [Ball; 2] {
    let end = |friction: &Resistance<Ball>, pieces: &[Pieces; 2], is_most: bool| {
        let taken = friction.sigma - force;
        let values = pieces.iter().flatten().flatten().map(|piece| {
            let (rises, slope, constant) = match is_up {
                true => (-piece.bend, taken - piece.slope, -piece.rest),
                false => (piece.bend, taken + piece.slope, piece.rest),
            };
            let bend = match rises {
                0 => friction.own,
                1.. => friction.more,
                _ => friction.less,
            };
            let ends = piece.ends;
            let arc = Arc {
                bend,
                slope,
                constant,
                ends,
            };
            extreme(&arc, is_most)
        });
        let further = |a: Ball, b: Ball| if is_most { a.max(b) } else { a.min(b) };
        values.reduce(further).unwrap_or(Ball::UNDEFINED)
    };
    let (of_least, of_most) = if is_up {
        (largest, least)
    } else {
        (least, largest)
    };
    let [low, high] = frictions;
    [end(low, of_least, false), end(high, of_most, true)]
}

impl Row<Ball> {
    /// As [`of`](Self::of), of counts in whose ticks, or between which, a wall is bent; `None` where the parts of it that
    /// they are in are not told.
    pub(crate) fn bent(
        (frictions, criteria): Walls<'_, Ball>,
        of: &Interval<Ball>,
        bend: &Bend,
        (is_exact, applied): (bool, bool),
    ) -> Option<Self> {
        let (zero, one) = (Ball::zero(), Ball::one());
        let (at, is_upper) = (bend.at, bend.is_upper);
        // In the direction of y.
        let along = |x: Ball| if is_upper { -x } else { x };
        let tick = |count: Ball| match is_upper {
            true => at - (count + one),
            false => count - at,
        };
        let (start, end) = (tick(of.start), tick(of.end));
        let middle = of.start + one.half();
        let held = match is_upper {
            true => -middle.min(at),
            false => -middle.max(at),
        };
        let ticks = of.end - of.start;
        let own = -quantized(start);
        let (work, force, excess) = match applied {
            true => (of.force * ticks, along(of.force + at), of.force - held),
            false => (held * ticks, own, zero),
        };
        let frictions = resistances(frictions, &of.lasts, is_exact);
        let crossing = Crossing { ticks, excess };
        let [near, far] = crossing.distances();
        let [least, most] = &frictions;

        let up = along(ticks);
        let is_same = up.is_zero();
        let is_up = is_same || up.is_positive()?;
        let (lower, upper) = if is_up { (start, end) } else { (end, start) };
        let ways = Ways {
            lower: (lower, side(lower)?),
            upper: (upper, side(upper)?),
            ticks: ticks.abs(),
        };
        let [linear, of_quantized] = ways.rises();
        let net = |rises: &Rises, force: Ball| {
            let ahead = if is_up { force } else { -force };
            let [lo, hi] = net(rises, &frictions, ahead, is_up);
            if !is_same {
                return [lo, hi];
            }
            let [lower, higher] = net(rises, &frictions, -ahead, false);
            [lo.min(lower), hi.max(higher)]
        };
        // A function of where the interval ends less one of where it starts.
        let base = force * up;
        let less = |[from, to]: [[Ball; 2]; 2], rise: Ball| {
            [
                base + rise + (to[0] - from[1]),
                base + rise + (to[1] - from[0]),
            ]
        };
        let in_ticks = |tick: Ball| {
            let slope = force + quantized(tick);
            [slope.min(zero), slope.max(zero)]
        };
        let between = over_ticks(lower, ways.ticks);
        let rise = if is_up { between } else { -between };
        // V(ξ₁) − fρ₁ is that and a line.
        let level = at * of.end - at.square().half();
        let over = at - excess;
        let (from, slope) = match is_upper {
            true => (level + over, -over),
            false => (level, over),
        };
        let against_wall = net(&linear, force);
        Some(Self {
            taken: [least.taken(&near), most.taken(&far)],
            margin: margin(criteria, [&near, &far], &of.lasts),
            generated: [
                less([start, end].map(|tick| over_tick(force, tick)), zero),
                less([start, end].map(in_ticks), rise),
            ],
            net: [against_wall, net(&of_quantized, force)],
            work,
            own: match applied {
                true => net(&linear, own),
                false => against_wall,
            },
            stored: over_tick(slope, end).map(|x| from + x),
            excess,
        })
    }
}
