//! Net energy where it is extreme between the corners of what counts leave room for, and not at one of them.
//!
//! On each side of d = k the extreme of each distance is α|d|² + γ|d| + κ (TH-COUNTS), which turns at κ − γ²/4α. With
//! the denominator D of net energy, Dγ = G is a whole number, and over the length n of an interval β′/Δτ = b₁/b₂n, so that
//! 4α = 2w/b₂n with w = 2b₁ or 2b₁ ± b₂n: it turns at κ − G²b₂n/2D²w.

use num_traits::ToPrimitive as _;
use passivity_core::counted::{Arc, Crossing, Resistance};
use passivity_core::{BigRational, Ordered as _, Scalar as _};

use super::super::Sum;
use super::super::row::QuotientOf;
use super::Friction;
use crate::ball::Ball;
use crate::number::{Exact as _, Factored, Primes, Term, Total};

/// What parabolas of net energy are made of, where that is short.
#[derive(Clone, Debug)]
pub(super) struct Turns {
    /// b₁ and b₂.
    viscous: [i64; 2],
    /// 2D² of each part of the wall.
    squares: [Factored; 3],
}

impl Turns {
    pub(super) fn of(beta: &BigRational, net: &[Sum<3>; 3]) -> Option<Self> {
        let square = |of: &Sum<3>| of.over.times(&of.over)?.times(&Factored::TWO);
        let [a, b, c] = net;
        Some(Self {
            viscous: [beta.numer().to_i64()?, beta.denom().to_i64()?],
            squares: [square(a)?, square(b)?, square(c)?],
        })
    }
}

/// A parabola on one side of d = k.
#[derive(Clone, Copy)]
pub(super) struct Parabola<T> {
    /// α less β′/Δτ, in halves.
    bend: i64,
    /// σ − γ, over the denominator of what is generated.
    force: T,
    /// κ.
    constant: i64,
}

/// The parabolas before and behind d = k.
type Sides<T> = [Parabola<T>; 2];

/// How they are made, one being so much over the denominator.
pub(super) type Parabolas<T> = fn(&Ways<T>, i64) -> Option<Sides<T>>;

/// Of an interval between counts: what is held beyond the force of the wall, in the direction of the part before d = k and of
/// that behind it, and how many ticks that is.
pub(super) struct Ways<T> {
    excess: [T; 2],
    ticks: i64,
}

impl<T: Term> Ways<T> {
    /// Of k ticks, under an excess.
    pub(super) fn of(k: i64, excess: T) -> Option<Self> {
        let against = T::zero().minus(excess)?;
        Some(Self {
            excess: match k {
                0 => [against, excess],
                1.. => [excess; 2],
                _ => [against; 2],
            },
            ticks: k.checked_abs()?,
        })
    }

    /// With these bends, so many halves less in γ than σ, and these constants; one is so much over the denominator.
    fn parabolas(
        &self,
        one: i64,
        halves: [i64; 2],
        bends: [i64; 2],
        constants: [i64; 2],
    ) -> Option<Sides<T>> {
        let half = one / 2;
        let side = |i: usize| {
            let more = T::from(half.checked_mul(halves[i])?);
            Some(Parabola {
                bend: bends[i],
                force: self.excess[i].plus(more)?,
                constant: constants[i],
            })
        };
        Some([side(0)?, side(1)?])
    }

    /// As [`Crossing::least_linear`].
    pub(super) fn least_linear(&self, one: i64) -> Option<Sides<T>> {
        let bend = if self.ticks == 0 { 1 } else { -1 };
        let behind = self.ticks.checked_mul(2)?.checked_add(1)?;
        self.parabolas(one, [1, behind], [bend, 1], [0; 2])
    }

    /// As [`Crossing::most_linear`].
    pub(super) fn most_linear(&self, one: i64) -> Option<Sides<T>> {
        let bend = if self.ticks == 0 { -1 } else { 1 };
        let before = self.ticks.checked_mul(2)?.checked_sub(1)?;
        self.parabolas(one, [before, -1], [bend, -1], [0; 2])
    }

    /// As [`Crossing::least_quantized`].
    pub(super) fn least_quantized(&self, one: i64) -> Option<Sides<T>> {
        let k = self.ticks;
        let triangle = k.checked_mul(k.checked_sub(1)?)? / 2;
        let behind = triangle.checked_add(k)?.checked_neg()?;
        self.parabolas(one, [k.checked_mul(2)?, 0], [0; 2], [triangle, behind])
    }

    /// Where the force of the wall is the same everywhere.
    pub(super) fn flat(&self) -> Option<Sides<T>> {
        self.parabolas(0, [0; 2], [0; 2], [0; 2])
    }
}

/// Which extreme is asked for.
#[derive(Clone, Copy)]
enum Extreme {
    Least,
    Most,
}

impl Extreme {
    /// The number whose least is asked for.
    #[inline(always)]
    fn of(self, x: Ball) -> Ball {
        match self {
            Self::Least => x,
            Self::Most => -x,
        }
    }

    /// Whether a parabola is extreme between its ends.
    #[inline(always)]
    fn is_within(self, arc: &Arc<Ball>) -> Option<bool> {
        let slope = |d: Ball| self.of(arc.slope + (arc.bend.square * d).double());
        let [from, to] = arc.ends.map(|d| slope(d).is_nonnegative());
        match (from, to) {
            (Some(a), Some(b)) if a == b => Some(false),
            (from, to) => match (-self.of(arc.bend.square)).is_nonnegative() {
                Some(true) => Some(false),
                Some(false) => (from == Some(false) && to == Some(true)).then_some(true),
                None => None,
            },
        }
    }
}

/// Which of the parabolas before and behind d = k is extreme between its ends, and more than all corners are; none where a
/// corner is.
pub(super) type Place = Option<usize>;

impl Extreme {
    /// Where net energy is extreme, of which that at the corners is near; `None` where it is not decided.
    #[inline(always)]
    fn place(
        self,
        [before, behind]: &[Arc<Ball>; 2],
        corner: impl FnOnce() -> Ball,
    ) -> Option<Place> {
        let within = [self.is_within(before)?, self.is_within(behind)?];
        if within == [false; 2] {
            return Some(None);
        }
        let is_below = |a: Ball, b: Ball| self.of(b - a).is_nonnegative();
        let [a, b] = [before.turn(), behind.turn()];
        let (at, value) = match within {
            [true, true] if is_below(a, b)? => (0, a),
            [true, false] => (0, a),
            _ => (1, b),
        };
        Some(is_below(value, corner())?.then_some(at))
    }
}

/// Where net energy is least against a linear wall and against its quantized form, and where it is most against the first.
#[inline(never)]
pub(super) fn linear(
    of: &Crossing<Ball>,
    [least, most]: [&Resistance<Ball>; 2],
) -> Option<[Place; 3]> {
    let corner_at_least = || {
        let ([corner, _], [first, last]) = of.net_at_corners(least);
        corner.min(first).min(last)
    };
    let corner_at_most = || {
        let ([_, corner], [first, last]) = of.net_at_corners(most);
        corner.max(first).max(last)
    };
    Some([
        Extreme::Least.place(&of.least_linear(least), corner_at_least)?,
        Extreme::Least.place(&of.least_quantized(least), corner_at_least)?,
        Extreme::Most.place(&of.most_linear(most), corner_at_most)?,
    ])
}

/// Where it is least where the force of the wall is the same everywhere, under an excess over this number. It is bent upwards: a
/// corner has the most.
#[inline(never)]
pub(super) fn flat<T: Term>(of: &Ways<T>, over: i64, least: &Resistance<Ball>) -> Option<Place> {
    let (k, one) = (Ball::whole(of.ticks), Ball::one());
    let arc = |excess: T, ends: [Ball; 2]| Arc {
        bend: least.own,
        slope: least.sigma - excess.near(over),
        constant: Ball::zero(),
        ends,
    };
    let [back, ahead] = of.excess;
    let from = (k - one).max(Ball::zero());
    let arcs = [arc(back, [from, from + one]), arc(ahead, [k, k + one])];
    Extreme::Least.place(&arcs, || {
        let [before, behind] = arcs.each_ref().map(|arc| {
            let [from, to] = arc.ends.each_ref().map(|d| arc.at(d));
            from.min(to)
        });
        before.min(behind)
    })
}

impl Friction {
    /// Where a parabola turns, over an interval that lasts so long.
    #[inline(never)]
    pub(super) fn at_turn<T: Term>(
        &self,
        primes: &Primes,
        part: usize,
        parabola: &Parabola<T>,
        n: i64,
    ) -> Option<QuotientOf<T>> {
        let turns = self.turns.as_ref()?;
        let over = turns.squares.get(part)?;
        let [_, b, c] = self.net.get(part)?.factors;
        let slope = T::from(1).by(b)?.plus(parabola.force.by(c)?)?;
        // Where there is no viscous friction the length has no part in it.
        let (twice_viscous, over_length) = match turns.viscous {
            [0, _] => (0, 1),
            [b1, b2] => (b1.checked_mul(2)?, b2.checked_mul(n)?),
        };
        let w = over_length
            .checked_mul(parabola.bend)?
            .checked_add(twice_viscous)?;
        let constant = T::from(parabola.constant).by(over.to_i128()?)?.by(w)?;
        let at = constant.minus(slope.square()?.by(over_length)?)?;
        // Over a number above zero.
        let at = if w < 0 { T::Sum::zero().minus(at)? } else { at };
        let beside = primes.split(w.unsigned_abs()).beside_sum(at);
        let over = over.times(&beside.known)?;
        beside.divided(at).quotient(primes, &over, beside.rest)
    }
}
