//! Net energy where it is extreme between the corners of what counts leave room for, and not at one of them.
//!
//! On each side of d = k the extreme of each distance is α|d|² + γ|d| + κ (TH-COUNTS), which turns at κ − γ²/4α. With
//! the denominator D of net energy, Dγ = G is a whole number, and over the length n of an interval β′/Δτ = b₁/b₂n, so that
//! 4α = 2w/b₂n with w = 2b₁ or 2b₁ ± b₂n: it turns at κ − G²b₂n/2D²w.

use num_traits::ToPrimitive as _;
use passivity_core::counted::{Arc, Bend, Crossing};
use passivity_core::{BigRational, Ordered as _, Scalar as _};

use super::super::Sum;
use super::super::row::QuotientOf;
use super::{Counts, Friction};
use crate::ball::Ball;
use crate::number::{Factored, Primes, Term, Total};

/// What parabolas of net energy are made of, where that is short.
#[derive(Clone, Debug)]
pub(super) struct Turns {
    /// b₁ and b₂.
    viscous: [i64; 2],
    /// 2D² of each part of the wall.
    squares: [(i128, Factored); 3],
}

impl Turns {
    pub(super) fn of(beta: &BigRational, net: &[Sum<3>; 3]) -> Option<Self> {
        let square = |of: &Sum<3>| {
            let square = of.over.times(&of.over)?.times(&Factored::TWO)?;
            Some((square.to_i128()?, square))
        };
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

/// Of an interval between counts: what is held beyond the force of the wall, in the direction of the part before d = k and of
/// that behind it, and how many ticks that is.
pub(super) struct Ways<T> {
    excess: [T; 2],
    ticks: i64,
}

impl<T: Term> Ways<T> {
    /// Of k ticks, under an excess.
    pub(super) fn of(k: i64, excess: T) -> Option<Self> {
        let against = T::whole(0).minus(excess)?;
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
            let more = T::whole(half.checked_mul(halves[i])?);
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

/// The parabolas of [`Ways::flat`], near by.
pub(super) fn flat(
    Crossing { ticks, excess }: &Crossing<Ball>,
    (sigma, bend): (Ball, &Bend<Ball>),
) -> [Arc<Ball>; 2] {
    let arc = |excess: Ball, ends: [Ball; 2]| Arc {
        bend: bend.clone(),
        slope: sigma - excess,
        constant: Ball::zero(),
        ends,
    };
    let (k, one) = (ticks.abs(), Ball::one());
    let back = if ticks.is_zero() { -*excess } else { *excess };
    let [back, ahead] = match ticks.is_nonnegative() {
        Some(true) => [back, *excess],
        _ => [-*excess; 2],
    };
    let from = (k - one).max(Ball::zero());
    [arc(back, [from, from + one]), arc(ahead, [k, k + one])]
}

/// Which extreme is asked for.
#[derive(Clone, Copy)]
pub(super) enum Extreme {
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

impl Counts {
    /// Net energy where one of the parabolas turns, if it is extreme there and not at the corners, of which that value is
    /// near; `None` where that is not decided, or too long.
    #[inline(always)]
    pub(super) fn turned<T: Term>(
        &self,
        extreme: Extreme,
        (friction, part, n): (&Friction, usize, i64),
        (parabolas, arcs): (impl FnOnce() -> Option<Sides<T>>, &[Arc<Ball>; 2]),
        corner: impl FnOnce() -> Ball,
    ) -> Option<Option<QuotientOf<T>>> {
        let [before, behind] = arcs;
        let within = [extreme.is_within(before)?, extreme.is_within(behind)?];
        if within == [false; 2] {
            return Some(None);
        }
        let is_below = |a: Ball, b: Ball| extreme.of(b - a).is_nonnegative();
        let [a, b] = [before.turn(), behind.turn()];
        let (at, value) = match within {
            [true, true] if is_below(a, b)? => (0, a),
            [true, false] => (0, a),
            _ => (1, b),
        };
        match is_below(value, corner())? {
            true => friction
                .at_turn(&self.primes, part, parabolas()?.get(at)?, n)
                .map(Some),
            false => Some(None),
        }
    }
}

impl Friction {
    /// Where a parabola turns, over an interval that lasts so long.
    #[inline(never)]
    fn at_turn<T: Term>(
        &self,
        primes: &Primes,
        part: usize,
        parabola: &Parabola<T>,
        n: i64,
    ) -> Option<QuotientOf<T>> {
        let turns = self.turns.as_ref()?;
        let (twice, over) = turns.squares.get(part)?;
        let [_, b, c] = self.net.get(part)?.factors;
        let slope = T::whole(1).by(b)?.plus(parabola.force.by(c)?)?;
        // Where there is no viscous friction the length has no part in it.
        let (twice_viscous, over_length) = match turns.viscous {
            [0, _] => (0, 1),
            [b1, b2] => (b1.checked_mul(2)?, b2.checked_mul(n)?),
        };
        let w = over_length
            .checked_mul(parabola.bend)?
            .checked_add(twice_viscous)?;
        let constant = T::whole(parabola.constant).by(*twice)?.by(w)?;
        let at = constant.minus(slope.square()?.by(over_length)?)?;
        // Over a number above zero.
        let at = if w < 0 { T::Sum::ZERO.minus(at)? } else { at };
        let beside = primes.split(w.unsigned_abs()).beside_sum(at);
        let over = over.times(&beside.known)?;
        beside.divided(at).quotient(primes, &over, beside.rest)
    }
}
