//! Rows of counts several at a time.

use multiversion::multiversion;

use super::{Column, Length, TILE};
use crate::ball::{Ball, Lane};
use crate::log::counted::{Interval, Row};
use crate::log::numbers::Readings;
use crate::log::wall::Wall;

/// What some consecutive intervals between counts come to.
#[derive(Clone, Debug)]
pub(crate) struct Counted {
    of: Interval<Column>,
    row: Row<Column>,
    /// The first of them, and how many there are.
    at: usize,
    len: usize,
}

impl Counted {
    pub(crate) fn new() -> Box<Self> {
        let (one, two) = (|| Column::ZERO, || [Column::ZERO; 2]);
        Box::new(Self {
            of: Interval {
                start: one(),
                end: one(),
                lasts: one(),
                force: one(),
            },
            row: Row {
                taken: two(),
                margin: two(),
                generated: [two(), two()],
                net: [two(), two()],
                work: one(),
                own: two(),
                excess: one(),
                stored: two(),
            },
            at: 0,
            len: 0,
        })
    }

    /// The room of it, with no rows.
    pub(crate) const fn after(&mut self) -> &mut Self {
        self.len = 0;
        self
    }

    /// The row of interval `i`, where it is one of these.
    #[inline]
    pub(crate) fn get(&self, i: usize) -> Option<Row<Ball>> {
        let i = i.checked_sub(self.at).filter(|i| *i < self.len)?;
        let two = |columns: &[Column; 2]| columns.each_ref().map(|column| column.get(i));
        let row = &self.row;
        Some(Row {
            taken: two(&row.taken),
            margin: two(&row.margin),
            generated: row.generated.each_ref().map(two),
            net: row.net.each_ref().map(two),
            work: row.work.get(i),
            own: two(&row.own),
            excess: row.excess.get(i),
            stored: two(&row.stored),
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
            self.of.start.set(i, Ball::whole(*from));
            self.of.end.set(i, Ball::whole(*to));
            self.of.lasts.set(i, lasts.near());
            self.len = i + 1;
        }
        if let Some(forces) = forces {
            self.len = self.of.force.copy(&forces.near, at, self.len);
        }
        compute(self, wall, forces.is_some());
    }

    #[inline(always)]
    fn compute(&mut self, wall: &Wall<false>, is_exact: bool, applied: bool) {
        let (of, to) = (&self.of, &mut self.row);
        for i in 0..TILE {
            let at = |column: &Column| column.get(i).lane();
            let of = Interval {
                start: at(&of.start),
                end: at(&of.end),
                lasts: at(&of.lasts),
                force: at(&of.force),
            };
            let row = Row::of(wall, &of, is_exact, applied);
            let [linear, quantized] = &mut to.generated;
            let [net, net_quantized] = &mut to.net;
            let ([a, b], [c, d]) = (row.generated, row.net);
            set(&mut to.taken, i, row.taken);
            set(&mut to.margin, i, row.margin);
            set(linear, i, a);
            set(quantized, i, b);
            set(net, i, c);
            set(net_quantized, i, d);
            set(&mut to.own, i, row.own);
            set(&mut to.stored, i, row.stored);
            to.work.set(i, row.work);
            to.excess.set(i, row.excess);
        }
    }
}

#[inline(always)]
fn set([lo, hi]: &mut [Column; 2], i: usize, [least, most]: [Lane; 2]) {
    lo.set(i, least);
    hi.set(i, most);
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn compute(tile: &mut Counted, wall: &Wall<false>, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => tile.compute(wall, true, true),
        (true, false) => tile.compute(wall, true, false),
        (false, true) => tile.compute(wall, false, true),
        (false, false) => tile.compute(wall, false, false),
    }
}
