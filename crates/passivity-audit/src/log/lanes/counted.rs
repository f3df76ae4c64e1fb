//! Rows of counts several at a time.

use std::ops::Range;

use multiversion::multiversion;

use super::compute::{is_nonnegative, whole};
use super::{Column, Length, TILE};
use crate::ball::{Ball, Lane, on_grid};
use crate::ledger::Truths;
use crate::log::counted::{Figures, Interval, Row, truths};
use crate::log::numbers::Readings;
use crate::log::wall::Wall;

/// The lower or the upper ends of numbers, in layers of 1, 2⁻³² and 2⁻⁶⁴.
pub(super) type Ends = [[i64; TILE]; 3];

pub(super) const NONE: Ends = [[0; TILE]; 3];

/// From so many ticks on, products with excess forces have no room in sums of 64 bits: layers are below 2^51, and there
/// are 2^6 of them.
const MANY: u64 = 1 << 5;

/// From this excess force on, products with ticks have no room in [sums](crate::log::supply::Supplied::fits).
const LARGE: u64 = 1 << 30;

/// What some consecutive intervals between counts come to.
#[derive(Clone, Debug)]
pub(crate) struct Counted {
    of: Interval<Column>,
    /// As [`Figures`] has it.
    pub(super) sums: [[Ends; 2]; 5],
    pub(super) observed: Ends,
    pub(super) own: [Ends; 2],
    pub(super) excess: [Ends; 2],
    pub(super) stored: [Ends; 2],
    /// How long each is, and how many ticks it crosses.
    lengths: [Length; TILE],
    pub(super) crossed: [i64; TILE],
    /// Whether each is for sums of its own: it crosses many ticks, its force is large, or it lasts one
    /// period under the force of the wall.
    apart: [bool; TILE],
    /// What is not negative, as bits: the margin of the criterion, net energy, and that against the quantized wall, each
    /// at the least and at the most.
    pub(super) covers: [u64; TILE],
    /// Not zero for the rows that are left open.
    open: [u64; TILE],
    /// The first of them, and how many there are.
    at: usize,
    len: usize,
}

impl Counted {
    pub(crate) fn new() -> Box<Self> {
        Box::new(Self {
            of: Interval {
                start: Column::ZERO,
                end: Column::ZERO,
                lasts: Column::ZERO,
                force: Column::ZERO,
            },
            sums: [[NONE; 2]; 5],
            observed: NONE,
            own: [NONE; 2],
            excess: [NONE; 2],
            stored: [NONE; 2],
            lengths: [Length::OPEN; TILE],
            crossed: [0; TILE],
            apart: [false; TILE],
            covers: [0; TILE],
            open: [0; TILE],
            at: 0,
            len: 0,
        })
    }

    /// The same room, without rows.
    pub(crate) const fn cleared(&mut self) -> &mut Self {
        self.len = 0;
        self
    }

    /// Whether interval `i` is one of these.
    #[inline]
    pub(crate) const fn has(&self, i: usize) -> bool {
        self.at <= i && i - self.at < self.len
    }

    /// The rows from interval `i` on whose sums can be taken at a time, of as many as are asked for.
    pub(crate) fn decided(&self, i: usize, most: usize) -> Range<usize> {
        let from = i.saturating_sub(self.at).min(self.len);
        let until = self.len.min(from.saturating_add(most));
        let stays = |i: &usize| self.open[*i] == 0 && !self.apart[*i];
        from..from + (from..until).take_while(stays).count()
    }

    /// How long some rows are.
    pub(crate) fn lengths(&self, rows: Range<usize>) -> &[Length] {
        &self.lengths[rows]
    }

    /// What interval `i` comes to; `None` where doubles leave something open.
    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Figures> {
        let i = i.checked_sub(self.at).filter(|i| *i < self.len)?;
        self.figures(i)
    }

    /// What a row answers.
    pub(super) fn answers(&self, i: usize) -> Truths {
        let is = |place: u32| self.covers[i] >> place & 1 == 1;
        let covers = [[is(0), is(1)], [is(2), is(3)], [is(4), is(5)]];
        truths(covers, self.crossed[i])
    }

    /// What a row comes to; `None` where doubles leave something open.
    #[inline]
    pub(super) fn figures(&self, i: usize) -> Option<Figures> {
        if self.open[i] != 0 {
            return None;
        }
        let crossed = self.crossed[i];
        let [linear, quantized, taken, net, net_quantized] = &self.sums;
        Some(Figures {
            sums: [
                both(linear, i),
                both(quantized, i),
                both(taken, i),
                both(net, i),
                both(net_quantized, i),
            ],
            observed: one(&self.observed, i),
            own: both(&self.own, i),
            excess: both(&self.excess, i),
            stored: both(&self.stored, i),
            truths: self.answers(i),
            crossed,
        })
    }

    /// Computes the rows from interval `at` on, which are as long as `lengths` says, under the forces in the log where
    /// there are any.
    pub(crate) fn fill(
        &mut self,
        wall: &Wall<false>,
        (counts, forces): (&[i64], Option<&Readings>),
        at: usize,
        lengths: impl Iterator<Item = Length>,
    ) {
        let pairs = counts.get(at..).unwrap_or_default().windows(2);
        self.at = at;
        self.len = 0;
        for ((pair, lasts), i) in pairs.zip(lengths).zip(0..TILE) {
            let [from, to] = pair else { break };
            let Some(crossed) = to.checked_sub(*from) else {
                break;
            };
            let Length(n, d) = lasts;
            (self.lengths[i], self.crossed[i]) = (lasts, crossed);
            self.apart[i] = crossed.unsigned_abs() >= MANY || n == d && forces.is_none();
            self.of.start.set(i, Ball::whole(*from));
            self.of.end.set(i, Ball::whole(*to));
            self.of.lasts.set(i, lasts.near());
            self.len = i + 1;
        }
        if let Some(forces) = forces {
            self.len = self.of.force.copy(&forces.near, at, self.len);
        }
        compute(self, wall, forces.is_some());
        for (apart, whole) in self.apart.iter_mut().zip(&self.excess[0][0]) {
            *apart |= whole.unsigned_abs() >= LARGE;
        }
    }

    #[inline(always)]
    fn compute(&mut self, wall: &Wall<false>, is_exact: bool, applied: bool) {
        for i in 0..TILE {
            let of = Interval {
                start: self.of.start.get(i).lane(),
                end: self.of.end.get(i).lane(),
                lasts: self.of.lasts.get(i).lane(),
                force: self.of.force.get(i).lane(),
            };
            let row = Row::of(wall, &of, is_exact, applied);
            let ([linear, quantized], [net, net_quantized]) = (row.generated, row.net);
            let mut open = 0.0;
            let [generated, stairs, taken, left, stairs_left] = &mut self.sums;
            open += set(generated, i, linear);
            open += set(stairs, i, quantized);
            open += set(taken, i, row.taken);
            open += set(left, i, net);
            open += set(stairs_left, i, net_quantized);
            open += set(&mut self.own, i, row.own);
            open += set(&mut self.excess, i, [row.excess, row.excess]);
            open += set(&mut self.stored, i, row.stored);
            let observed = -row.work;
            open += observed.excess();
            put(&mut self.observed, i, lower(observed));
            let (holds, margin) = covers(row.margin);
            let (linear, of_linear) = covers(net);
            let (quantized, of_quantized) = covers(net_quantized);
            self.covers[i] = whole(holds + 4.0 * linear + 16.0 * quantized);
            self.open[i] = whole(open + margin + of_linear + of_quantized);
        }
    }
}

/// The one number where that is so, else the other.
#[inline(always)]
pub(super) fn choose(is: bool, [a, b, c]: [i64; 3], [d, e, f]: [i64; 3]) -> [i64; 3] {
    [
        if is { a } else { d },
        if is { b } else { e },
        if is { c } else { f },
    ]
}

/// An end in units of the grid.
#[inline(always)]
fn one(ends: &Ends, i: usize) -> i128 {
    on_grid([ends[0][i], ends[1][i], ends[2][i]])
}

/// Both of them.
#[inline(always)]
pub(super) fn both([lo, hi]: &[Ends; 2], i: usize) -> [i128; 2] {
    [one(lo, i), one(hi, i)]
}

/// Sets the lower end of one number and the upper end of another; zero where both are on the grid, else above that.
#[inline(always)]
fn set([lo, hi]: &mut [Ends; 2], i: usize, [least, most]: [Lane; 2]) -> f64 {
    put(lo, i, lower(least));
    let [whole, upper, lower, off] = most.layers();
    put(hi, i, [whole, upper, lower.wrapping_add(off)]);
    least.excess() + most.excess()
}

/// The layers of the lower end.
#[inline(always)]
fn lower(of: Lane) -> [i64; 3] {
    let [whole, upper, lower, off] = of.layers();
    [whole, upper, lower.wrapping_sub(off)]
}

#[inline(always)]
fn put(ends: &mut Ends, i: usize, [whole, upper, lower]: [i64; 3]) {
    ends[0][i] = whole;
    ends[1][i] = upper;
    ends[2][i] = lower;
}

/// Whether a number is not negative at the least and at the most, as two bits; and zero where that is decided, else above
/// that.
#[inline(always)]
fn covers([lo, hi]: [Lane; 2]) -> (f64, f64) {
    let ([a, b], [c, d]) = (is_nonnegative(lo), is_nonnegative(hi));
    (3.0 - (a + 2.0 * c), a * b + c * d)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute(tile: &mut Counted, wall: &Wall<false>, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => tile.compute(wall, true, true),
        (true, false) => tile.compute(wall, true, false),
        (false, true) => tile.compute(wall, false, true),
        (false, false) => tile.compute(wall, false, false),
    }
}
