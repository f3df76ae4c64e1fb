//! Rows of counts several at a time.

use std::ops::Range;

use multiversion::multiversion;

use super::answers::ManyByLaw;
use super::compute::whole;
use super::counted_sums::{Steps, totals_of};

use super::{Length, TILE, truths};
use crate::log::counted::{Figures, Interval};
use crate::log::numbers::Readings;
use crate::log::quick::{self, End, Quick, units};
use crate::log::wall::Reach;
use crate::plain::Plain;

/// The lower or the upper ends of numbers, both parts of each.
pub(super) type Ends = [[f64; TILE]; 2];

pub(super) const NONE: Ends = [[0.0; TILE]; 2];

/// From so many ticks on, products with excess forces have no room in sums.
const MANY: u64 = 1 << 5;

/// From this excess force on, products with ticks have no room in [sums](crate::log::supply::Supplied::fits).
const LARGE: f64 = (1_u64 << 30) as f64;

/// Rows under the force of the wall: what of them is not that under the force in the log too, or its own part.
#[derive(Clone, Debug)]
#[repr(C, align(64))] // as `Counted`
struct Law {
    generated: [[Ends; 2]; 2],
    taken: [Ends; 2],
    /// Against the quantized wall; against the wall it is [`Counted::own`].
    net_quantized: [Ends; 2],
    covers: [u64; TILE],
    open: [u64; TILE],
}

impl Law {
    const NONE: Self = Self {
        generated: [[NONE; 2]; 2],
        taken: [NONE; 2],
        net_quantized: [NONE; 2],
        covers: [0; TILE],
        open: [0; TILE],
    };
}

/// What some consecutive intervals between counts come to.
///
/// Columns start where lines of the cache do: the widest instructions then write no number into two of them.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
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
    apart: [u64; TILE],
    /// What is not negative, as bits: the margin of the criterion, net energy, and that against the quantized wall, each
    /// at the least and at the most.
    pub(super) covers: [u64; TILE],
    /// Not zero for the rows that are left open.
    open: [u64; TILE],
    /// The same under the force of the wall, where that is asked for beside the force in the log.
    law: Law,
    /// The room of what some of them add up to.
    pub(super) steps: Steps,
    /// The first of them, and how many there are.
    at: usize,
    len: usize,
    /// Whether all of them are decided and none is apart.
    is_whole: bool,
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
            apart: [0; TILE],
            covers: [0; TILE],
            open: [0; TILE],
            law: Law::NONE,
            at: 0,
            len: 0,
            is_whole: false,
            steps: Steps::NONE,
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
        if self.is_whole {
            return from..until.max(from);
        }
        let stays = |i: &usize| self.open[*i] | self.apart[*i] == 0;
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
    /// there are any; and beside them the sums of all of them `by_law`, under the force of the wall, where doubles decide
    /// these and none lasts one period.
    pub(crate) fn fill(
        &mut self,
        quick: &Quick,
        (counts, forces): (&[i64], Option<&Readings>),
        at: usize,
        lengths: &[Length],
        by_law: Option<&mut ManyByLaw>,
    ) {
        let (from, to) = (counts.get(at..), counts.get(at + 1..));
        let (from, to) = (from.unwrap_or_default(), to.unwrap_or_default());
        let len = to.len().min(lengths.len()).min(TILE);
        self.at = at;
        self.len = len;
        let mut open = [0.0; TILE];
        let [any_open, any_period] =
            read(self, [&from[..len], &to[..len]], &lengths[..len], &mut open);
        if any_open {
            for i in 0..len {
                if open[i] != 0.0 {
                    open[i] = self.read_longer([from[i], to[i]], lengths[i], i);
                }
            }
        }
        if let Some(forces) = forces {
            let [_, _, _, force, off] = &mut self.of;
            self.len = forces.near.copy_to([force, off], at, self.len);
        }
        match (&quick.reach, by_law.filter(|_| !any_period)) {
            (None, Some(by_law)) if quick.friction_is_exact && forces.is_some() => {
                compute_both(self, quick, &open);
                self.add_by_law(by_law);
            }
            (None, _) => compute(self, quick, &open, forces.is_some()),
            (Some(reach), _) => compute_in_parts(self, (quick, reach), &open, forces.is_some()),
        }
        mark(self, forces.is_none());
    }

    /// Adds what all rows come to under the force of the wall, where doubles leave nothing open.
    fn add_by_law(&self, by_law: &mut ManyByLaw) {
        let rows = 0..self.len;
        let open = self.law.open[rows.clone()]
            .iter()
            .fold(0, |all, open| all | open);
        if open == 0 {
            let [linear, quantized] = &self.law.generated;
            let columns = [
                linear,
                quantized,
                &self.law.taken,
                &self.own,
                &self.law.net_quantized,
            ];
            let sums = totals_of(columns, &rows);
            by_law.push(self.at, sums, &self.law.covers[rows]);
        }
    }

    /// Marks which rows are apart, of which those of one period are where there are no forces, and whether none is or is
    /// open.
    #[inline(always)]
    fn mark(&mut self, has_periods: bool) {
        // Of a number of rows that the compiler knows, processors mark several at a time.
        let left = match self.len {
            TILE => self.mark_first(TILE, has_periods),
            len => self.mark_first(len, has_periods),
        };
        self.is_whole = left == 0;
    }

    /// The same of the first rows: not zero where one of them is apart or open.
    #[inline(always)]
    fn mark_first(&mut self, len: usize, has_periods: bool) -> u64 {
        let mut left = 0;
        for i in 0..len {
            let is_period = self.lengths[i].0 == self.lengths[i].1;
            let apart = (self.crossed[i].unsigned_abs() >= MANY)
                | (has_periods & is_period)
                | (self.excess[0][0][i].abs() >= LARGE);
            self.apart[i] = apart.into();
            left |= self.open[i] | self.apart[i];
        }
        left
    }

    /// Where intervals start and end and how long they last, of most, and what is not zero for others: whether there are
    /// such, and whether one lasts one period.
    #[inline(always)]
    fn read(
        &mut self,
        counts: [&[i64]; 2],
        lengths: &[Length],
        open: &mut [f64; TILE],
    ) -> [bool; 2] {
        self.lengths[..lengths.len()].copy_from_slice(lengths);
        // Of whole arrays processors read several numbers at a time.
        if let [Ok(from), Ok(to)] = counts.map(<&[i64; TILE]>::try_from) {
            return self.read_all([from, to], open);
        }
        // What is behind the last interval is not looked at.
        self.lengths[lengths.len()..].fill(Length::OPEN);
        let mut whole = [[0; TILE]; 2];
        for (whole, some) in whole.iter_mut().zip(counts) {
            whole[..some.len()].copy_from_slice(some);
        }
        self.read_all(whole.each_ref(), open)
    }

    #[inline(always)]
    #[allow(clippy::cast_precision_loss)] // nothing is lost
    fn read_all(&mut self, [froms, tos]: [&[i64; TILE]; 2], open: &mut [f64; TILE]) -> [bool; 2] {
        let [starts, ends, durations, ..] = &mut self.of;
        let mut any = [0_u64; 2];
        for i in 0..TILE {
            let (from, to, Length(n, d)) = (froms[i], tos[i], self.lengths[i]);
            // What is too large for that is left open.
            self.crossed[i] = to.wrapping_sub(from);
            let is_known = quick::is_whole(from) & quick::is_whole(to) & Length(n, d).is_short();
            any[0] |= u64::from(!is_known);
            any[1] |= u64::from((n == d) & (d != 0));
            // Any motion, of what is left open.
            let of = |n: i64, other: i64| if is_known { n } else { other } as f64;
            (starts[i], ends[i]) = (of(from, 0), of(to, 0));
            durations[i] = of(n, 1) / of(d, 1);
            open[i] = of(0, 1);
        }
        any.map(|any| any != 0)
    }

    /// The same of interval `i`, whose numbers may be long: whether it is left open.
    fn read_longer(&mut self, [from, to]: [i64; 2], length: Length, i: usize) -> f64 {
        let (from, to) = (quick::whole(from), quick::whole(to));
        let (Some(from), Some(to), Some(lasts)) = (from, to, length.nearest()) else {
            return 1.0;
        };
        (self.of[0][i], self.of[1][i], self.of[2][i]) = (from, to, lasts);
        0.0
    }

    /// Computes all rows, those under the force of the wall beside them where that is the `LAW`.
    #[inline(always)]
    fn compute<const LAW: bool>(
        &mut self,
        quick: &Quick,
        open: &[f64; TILE],
        reach: Option<&Reach>,
        of: (bool, bool),
    ) {
        let [starts, ends, durations, forces, off] = &self.of;
        for i in 0..TILE {
            let interval = Interval {
                start: Plain(starts[i]),
                end: Plain(ends[i]),
                lasts: Plain(durations[i]),
                force: Plain(forces[i]),
            };
            let row = quick.row(&interval, off[i], reach, of);
            if LAW {
                let row = quick.row(&interval, 0.0, reach, (of.0, false));
                let [a, b, c, _, e] = row.sums;
                put(&mut self.law.generated[0], i, a);
                put(&mut self.law.generated[1], i, b);
                put(&mut self.law.taken, i, c);
                put(&mut self.law.net_quantized, i, e);
                self.law.covers[i] = whole(row.covers);
                self.law.open[i] = whole(row.open + open[i]);
            }
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
fn mark(tile: &mut Counted, has_periods: bool) {
    tile.mark(has_periods);
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn read(
    tile: &mut Counted,
    counts: [&[i64]; 2],
    lengths: &[Length],
    open: &mut [f64; TILE],
) -> [bool; 2] {
    tile.read(counts, lengths, open)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute(tile: &mut Counted, quick: &Quick, open: &[f64; TILE], applied: bool) {
    match (quick.friction_is_exact, applied) {
        (true, true) => tile.compute::<false>(quick, open, None, (true, true)),
        (true, false) => tile.compute::<false>(quick, open, None, (true, false)),
        // One text less.
        (false, applied) => tile.compute::<false>(quick, open, None, (false, applied)),
    }
}

/// The same under the forces in the log and under that of the wall.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute_both(tile: &mut Counted, quick: &Quick, open: &[f64; TILE]) {
    tile.compute::<true>(quick, open, None, (true, true));
}

/// The same of walls that are not linear everywhere.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute_in_parts(
    tile: &mut Counted,
    (quick, reach): (&Quick, &Reach),
    open: &[f64; TILE],
    applied: bool,
) {
    // One text less.
    tile.compute::<false>(quick, open, Some(reach), (false, applied));
}
