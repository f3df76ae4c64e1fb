//! Rows of counts several at a time.

use std::ops::Range;

use multiversion::multiversion;

use super::compute::whole;
use super::{Length, TILE, truths};
use crate::log::counted::{Figures, Interval};
use crate::log::numbers::Readings;
use crate::log::quick::{self, End, Quick, units};
use crate::plain::Plain;

/// The lower or the upper ends of numbers, both parts of each.
pub(super) type Ends = [[f64; TILE]; 2];

pub(super) const NONE: Ends = [[0.0; TILE]; 2];

/// From so many ticks on, products with excess forces have no room in sums.
const MANY: u64 = 1 << 5;

/// From this excess force on, products with ticks have no room in [sums](crate::log::supply::Supplied::fits).
const LARGE: f64 = (1_u64 << 30) as f64;

/// What some consecutive intervals between counts come to.
#[derive(Clone, Debug)]
pub(crate) struct Counted {
    /// Where each starts and ends, how long it lasts, its force and what that is off by at most.
    of: [[f64; TILE]; 5],
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
            of: [[0.0; TILE]; 5],
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
            truths: truths(self.covers[i]),
            crossed,
        })
    }

    /// Computes the rows from interval `at` on, which are as long as `lengths` says, under the forces in the log where
    /// there are any.
    pub(crate) fn fill(
        &mut self,
        quick: &Quick,
        (counts, forces): (&[i64], Option<&Readings>),
        at: usize,
        lengths: impl Iterator<Item = Length>,
    ) {
        let pairs = counts.get(at..).unwrap_or_default().windows(2);
        self.at = at;
        self.len = 0;
        let mut open = [0.0; TILE];
        let [starts, ends, durations, force, off] = &mut self.of;
        for ((pair, lasts), i) in pairs.zip(lengths).zip(0..TILE) {
            let [from, to] = pair else { break };
            let Some(crossed) = to.checked_sub(*from) else {
                break;
            };
            (self.lengths[i], self.crossed[i]) = (lasts, crossed);
            let is_period = lasts.0 == lasts.1;
            self.apart[i] = crossed.unsigned_abs() >= MANY || is_period && forces.is_none();
            match (quick::whole(*from), quick::whole(*to), lasts.nearest()) {
                (Some(from), Some(to), Some(lasts)) => {
                    (starts[i], ends[i], durations[i]) = (from, to, lasts);
                }
                _ => {
                    // Any motion: it is left open.
                    (starts[i], ends[i], durations[i]) = (0.0, 0.0, 1.0);
                    open[i] = 1.0;
                }
            }
            self.len = i + 1;
        }
        if let Some(forces) = forces {
            self.len = forces.near.copy_to([force, off], at, self.len);
        }
        compute(self, quick, &open, forces.is_some());
        for (apart, upper) in self.apart.iter_mut().zip(&self.excess[0][0]) {
            *apart |= upper.abs() >= LARGE;
        }
    }

    #[inline(always)]
    fn compute(&mut self, quick: &Quick, open: &[f64; TILE], is_exact: bool, applied: bool) {
        let [starts, ends, durations, forces, off] = &self.of;
        for i in 0..TILE {
            let of = Interval {
                start: Plain(starts[i]),
                end: Plain(ends[i]),
                lasts: Plain(durations[i]),
                force: Plain(forces[i]),
            };
            let row = quick.row(&of, off[i], is_exact, applied);
            // One by one: loops of these would keep the loop over rows from becoming vector instructions.
            let [a, b, c, d, e] = row.sums;
            put(&mut self.sums[0], i, a);
            put(&mut self.sums[1], i, b);
            put(&mut self.sums[2], i, c);
            put(&mut self.sums[3], i, d);
            put(&mut self.sums[4], i, e);
            put(&mut self.own, i, row.own);
            put(&mut self.excess, i, row.excess);
            put(&mut self.stored, i, row.stored);
            [self.observed[0][i], self.observed[1][i]] = row.observed;
            self.covers[i] = whole(row.covers);
            self.open[i] = whole(row.open + open[i]);
        }
    }
}

#[inline(always)]
fn put(ends: &mut [Ends; 2], i: usize, both: [End; 2]) {
    let [[a, b], [c, d]] = both;
    (ends[0][0][i], ends[0][1][i]) = (a, b);
    (ends[1][0][i], ends[1][1][i]) = (c, d);
}

/// An end in units of the grid.
#[inline(always)]
pub(super) fn one(ends: &Ends, i: usize) -> i128 {
    units([ends[0][i], ends[1][i]])
}

/// Both of them.
#[inline(always)]
pub(super) fn both([lo, hi]: &[Ends; 2], i: usize) -> [i128; 2] {
    [one(lo, i), one(hi, i)]
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute(tile: &mut Counted, quick: &Quick, open: &[f64; TILE], applied: bool) {
    match (quick.friction_is_exact, applied) {
        (true, true) => tile.compute(quick, open, true, true),
        (true, false) => tile.compute(quick, open, true, false),
        (false, true) => tile.compute(quick, open, false, true),
        (false, false) => tile.compute(quick, open, false, false),
    }
}
