//! Where sums over rows of a tile are least on the way. Doubles near them tell which rows that may be, and only there
//! the sums are made exactly: most often, of one row.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::course::{Course, Least};

use super::sums::{Asked, Courses, Sums, Under, lowest_of};
use super::{Column, TILE};

/// Numbers in units of the grid, one of each row.
pub(super) trait OnGrid {
    fn at(&self, i: usize) -> i128;

    /// Whether that is known to be zero without making it.
    fn is_zero(&self, i: usize) -> bool;

    /// The sum of some rows.
    fn sum(&self, rows: Range<usize>) -> i128;
}

/// Finds doubles near the sums of columns up to each of some rows, from zero at the first of them.
///
/// The columns are added up side by side: each sum waits for that of the row before.
#[inline(always)]
pub(super) fn sums_up_to<const N: usize>(
    rows: &Range<usize>,
    columns: [&[f64; TILE]; N],
    mut up_to: [&mut [f64; TILE]; N],
) {
    let mut sums = [0.0; N];
    for i in rows.clone() {
        for ((sum, column), up_to) in sums.iter_mut().zip(columns).zip(&mut up_to) {
            *sum += column[i];
            up_to[i] = *sum;
        }
    }
}

/// What rows add to a sum, from zero at the first of them.
pub(super) struct Way<'a, C> {
    pub(super) rows: &'a Range<usize>,
    /// Doubles near the sums [up to each row](sums_up_to).
    pub(super) sums: &'a [f64; TILE],
    pub(super) exactly: &'a C,
    /// The sum of all rows.
    pub(super) total: i128,
    /// What the doubles are off by at most.
    pub(super) off: f64,
}

impl<C: OnGrid> Way<'_, C> {
    /// The least that the sum becomes.
    #[inline(always)]
    pub(super) fn least(&self) -> Course<i128> {
        match self.where_least(self.sums, (|_| 0, |_| true)).0 {
            Some((least, at)) if least < 0 => Course { sum: 0, least, at },
            _ => Course::default(),
        }
    }

    /// Where the sum is least with what stands beside it after each row: near by, and in units of the grid; given whether it
    /// is known to be what it was after the row before.
    #[inline(always)]
    pub(super) fn with(
        &self,
        beside: &[f64; TILE],
        end: (impl Fn(usize) -> i128, impl Fn(usize) -> bool),
    ) -> Least<i128> {
        let mut near = *self.sums;
        for (near, beside) in near.iter_mut().zip(beside) {
            *near += beside;
        }
        self.where_least(&near, end)
    }

    /// Where sums that these doubles are near are least, given what stands beside them, and whether that stays what it was.
    #[inline(always)]
    fn where_least(
        &self,
        near: &[f64; TILE],
        (end, stays): (impl Fn(usize) -> i128, impl Fn(usize) -> bool),
    ) -> Least<i128> {
        let mut least = Least::default();
        let Range { start, end: behind } = *self.rows;
        let Some(last) = behind.checked_sub(1).filter(|last| *last >= start) else {
            return least;
        };
        // Most often the sum falls up to the last row.
        let before = lowest_of(&near[start..last]);
        let (first, last) = if near[last] + 2.0 * self.off < before {
            (last, last)
        } else {
            let mut candidates = self.candidates(near);
            let last = candidates.next_back().unwrap_or(last);
            (candidates.next().unwrap_or(last), last)
        };
        let mut sum = match first - start < behind - first {
            true => self.exactly.sum(start..first),
            false => self.total - self.exactly.sum(first..behind),
        };
        for i in first..=last {
            // Of a device that rests, most rows change nothing.
            if i > first && self.exactly.is_zero(i) && stays(i) {
                continue;
            }
            sum += self.exactly.at(i);
            least.keep(sum + end(i), self.number(i));
        }
        least
    }

    /// The least that a row adds, near by what these doubles are.
    #[inline(always)]
    pub(super) fn worst(&self, steps: &[f64; TILE]) -> Least<i128> {
        let mut least = Least::default();
        for i in self.candidates(steps) {
            least.keep(self.exactly.at(i), self.number(i));
        }
        least
    }

    /// The rows where numbers that these doubles are near may be least.
    #[inline(always)]
    fn candidates(&self, near: &[f64; TILE]) -> impl DoubleEndedIterator<Item = usize> {
        let most = lowest_of(&near[self.rows.clone()]) + 2.0 * self.off;
        self.rows.clone().filter(move |i| near[*i] <= most)
    }

    /// The number of a row, from 1.
    const fn number(&self, i: usize) -> u64 {
        (i - self.rows.start) as u64 + 1
    }
}

/// What is left of one column without two others, at the least or else at the most.
struct Left<'a> {
    from: &'a Column,
    less: [&'a Column; 2],
    at_least: bool,
}

impl Left<'_> {
    /// Doubles near it.
    #[inline(always)]
    fn near(&self) -> [f64; TILE] {
        let mut near = [0.0; TILE];
        let outward = if self.at_least { -1.0 } else { 1.0 };
        for (i, near) in near.iter_mut().enumerate() {
            let (a, r) = self.from.get(i).parts();
            let [(b, s), (c, t)] = [self.less[0].get(i).parts(), self.less[1].get(i).parts()];
            *near = (a - b - c) + outward * (r + s + t);
        }
        near
    }
}

impl OnGrid for Left<'_> {
    #[inline(always)]
    fn is_zero(&self, i: usize) -> bool {
        // A closure within a `map` would be compiled for any processor.
        let size = |of: &Column| of.get(i).size();
        let [b, c] = self.less;
        (size(self.from) == 0.0) & (size(b) == 0.0) & (size(c) == 0.0)
    }

    #[inline(always)]
    fn at(&self, i: usize) -> i128 {
        let a = self.from.get(i).ends_on_grid();
        let [b, c] = self.less;
        let (b, c) = (b.get(i).ends_on_grid(), c.get(i).ends_on_grid());
        match self.at_least {
            true => a[0] - b[1] - c[1],
            false => a[1] - b[0] - c[0],
        }
    }

    #[inline(always)]
    fn sum(&self, rows: Range<usize>) -> i128 {
        rows.map(|i| self.at(i)).sum()
    }
}

/// Doubles near the lower or the upper ends of the numbers of a column.
#[inline(always)]
fn end<const LEAST: bool>(Column { middles, radii }: &Column) -> [f64; TILE] {
    let mut ends = *middles;
    for (end, radius) in ends.iter_mut().zip(radii) {
        *end += if LEAST { -radius } else { *radius };
    }
    ends
}

/// As [`TileRows::courses`], where the verdict is about what was stored at the start and where it is not.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn courses(
    Under {
        tile,
        applied,
        running,
    }: &Under<'_>,
    rows: &Range<usize>,
    (asked, sums): (Asked, &Sums),
) -> Courses<i128> {
    let more = if *applied { &tile.more } else { &Column::ZERO };
    let ([least, most], less) = (&tile.taken, [&tile.linear, more]);
    let [low, high] = [(least, true), (most, false)].map(|(from, at_least)| Left {
        from,
        less,
        at_least,
    });
    let steps = [low.near(), high.near()];
    let mut up_to = [[0.0; TILE]; 2];
    sums_up_to(rows, steps.each_ref(), up_to.each_mut());
    let [to_low, to_high] = up_to;
    let [_, _, _, [net_at_least, net_at_most], _] = sums.sums;
    let off = sums.off;
    let potential = &tile.potential;
    let stays = |i: usize| potential.get(i) == potential.get(i - 1);
    let mut courses = Courses::default();
    if asked.net || asked.worst || asked.supply[0] {
        let way = Way {
            rows,
            sums: &to_low,
            exactly: &low,
            total: net_at_least,
            off,
        };
        // What is added to T at the least is net energy.
        courses.net = way.least();
        courses.supply[0] = courses.net;
        let end_of = |i: usize| potential.get(i).ends_on_grid()[0];
        let with = way.with(&end::<true>(potential), (end_of, stays));
        match running {
            true => courses.lowest[0] = with,
            false => courses.stored = with,
        }
        if asked.worst {
            courses.worst = way.worst(&steps[0]);
        }
    }
    if asked.supply[1] {
        let way = Way {
            rows,
            sums: &to_high,
            exactly: &high,
            total: net_at_most,
            off,
        };
        courses.supply[1] = way.least();
        let end_of = |i: usize| potential.get(i).ends_on_grid()[1];
        courses.lowest[1] = way.with(&end::<false>(potential), (end_of, stays));
    }
    courses
}

/// As [`TileRows::observer`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn observer(
    Under { tile, applied, .. }: &Under<'_>,
    rows: &Range<usize>,
    sums: &Sums,
) -> Course<i128> {
    let more = if *applied { &tile.more } else { &Column::ZERO };
    let left = Left {
        from: &tile.observed,
        less: [more, &Column::ZERO],
        at_least: true,
    };
    let mut up_to = [0.0; TILE];
    sums_up_to(rows, [&left.near()], [&mut up_to]);
    Way {
        rows,
        sums: &up_to,
        exactly: &left,
        total: sums.observed,
        off: sums.off,
    }
    .least()
}
