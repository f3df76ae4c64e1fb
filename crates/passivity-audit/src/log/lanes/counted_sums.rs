//! Sums over rows of counts, and how low they may get on the way.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::course::{Course, Least};

use super::TILE;
use super::counted::{Counted, Ends, NONE, both, one};
use super::least::{OnGrid, Way, sums_up_to};
use super::sums::{Asked, Courses, Sums, TileRows, joined, lowest, lowest_of, off};
use crate::log::quick::{End, carried, parts, units, whole};
use crate::log::supply::{Bounds, NO_FORCE};
use crate::number::Reduced;
use crate::span::{ONE, units as below};

/// What rows add up to on the way, and what they add to T where the verdict is about that.
#[derive(Clone, Debug)]
#[repr(C, align(64))] // as `Counted`
pub(super) struct Steps {
    /// At the least and at the most, where it is `running`.
    supply: [Ends; 2],
    /// [Near the sums](sums_up_to) of net energy, of what the observer adds, and of what is added to T.
    up_to: [[f64; TILE]; 4],
    running: bool,
    /// What these are off by at most.
    off: f64,
}

impl Steps {
    pub(super) const NONE: Self = Self {
        supply: [NONE; 2],
        running: false,
        up_to: [[0.0; TILE]; 4],
        off: 0.0,
    };
}

#[inline(always)]
fn at(ends: &Ends, i: usize) -> End {
    [ends[0][i], ends[1][i]]
}

/// Nothing less than zero of a difference of two ends, and nothing more: exactly.
#[inline(always)]
fn difference([upper, lower]: End, [upper_less, lower_less]: End) -> [End; 2] {
    let parts = [upper - upper_less, lower - lower_less];
    // Of what is on the grid a sum has the right sign.
    match parts[0] + parts[1] < 0.0 {
        true => [parts, [0.0; 2]],
        false => [[0.0; 2], parts],
    }
}

impl Counted {
    /// Finds what each row adds to T, as [`Contribution::supplied`] has it: the first of them after one with this excess
    /// force.
    ///
    /// [`Contribution::supplied`]: crate::log::supply::Contribution::supplied
    #[inline(always)]
    fn supply(&mut self, first: usize, excess: [End; 2]) {
        for i in 1..TILE {
            let before = self.excess.each_ref().map(|end| at(end, i - 1));
            self.step(i, before);
        }
        self.step(first, excess);
    }

    /// The same of a row, after one with this excess force.
    #[inline(always)]
    fn step(&mut self, i: usize, before: [End; 2]) {
        let [least, most] = self.excess.each_ref().map(|end| at(end, i));
        let ticks = whole(self.crossed[i]).unwrap_or(0.0);
        let (high, low) = if ticks < 0.0 {
            (least, most)
        } else {
            (most, least)
        };
        let [fall, _] = difference(least, before[1]);
        let [_, rise] = difference(most, before[0]);
        let own = self.own.each_ref().map(|end| at(end, i));
        let added = [(own[0], high, fall), (own[1], low, rise)];
        for (steps, (own, force, change)) in self.steps.supply.iter_mut().zip(added) {
            // Nothing is rounded: forces are below 2^30, ticks below 2^5 and the rest below that.
            let [upper, lower] =
                [0, 1].map(|part| (own[part] - force[part] * ticks) + change[part]);
            [steps[0][i], steps[1][i]] = carried([upper, lower]);
        }
    }

    /// Adds up what some rows add to each sum.
    #[inline(always)]
    fn add_up(&mut self, rows: &Range<usize>, excess: Option<[End; 2]>) {
        self.steps.running = excess.is_some();
        if let Some(excess) = excess {
            self.supply(rows.start, excess);
        }
        let (net, observed, [low, high]) = (&self.sums[3][0], &self.observed, &self.stored);
        let Steps {
            supply: [least, most],
            running,
            up_to: [to_net, to_observed, to_least, to_most],
            off: of_all,
        } = &mut self.steps;
        let columns = [near(net), near(observed)];
        let size = match running {
            true => {
                let [a, b] = columns;
                let columns = [a, b, near(least), near(most)];
                let sums = [to_net, to_observed, to_least, to_most];
                sums_up_to(rows, columns.each_ref(), sums);
                size(&[net, observed, least, most, low, high], rows)
            }
            false => {
                sums_up_to(rows, columns.each_ref(), [to_net, to_observed]);
                size(&[net, observed, low, high], rows)
            }
        };
        *of_all = off(size);
    }
}

/// Doubles near the numbers of a column.
#[inline(always)]
fn near([upper, lower]: &Ends) -> [f64; TILE] {
    let mut near = *upper;
    for (near, lower) in near.iter_mut().zip(lower) {
        *near += lower;
    }
    near
}

impl OnGrid for Ends {
    #[inline(always)]
    fn is_zero(&self, i: usize) -> bool {
        at(self, i) == [0.0; 2]
    }

    #[inline(always)]
    fn at(&self, i: usize) -> i128 {
        units(at(self, i))
    }

    #[inline(always)]
    fn sum(&self, rows: Range<usize>) -> i128 {
        // Several sums at a time: in which order what is not rounded is added does not matter.
        const LANES: usize = 8;
        let mut both = [0.0; 2];
        for (sum, part) in both.iter_mut().zip(self) {
            let (several, rest) = part[rows.clone()].as_chunks::<LANES>();
            let mut sums = [0.0; LANES];
            for several in several {
                for (sum, x) in sums.iter_mut().zip(several) {
                    *sum += x;
                }
            }
            *sum = sums.iter().chain(rest).sum();
        }
        units(both)
    }
}

/// The same of the lower and of the upper ends.
#[inline(always)]
fn sum_both([lo, hi]: &[Ends; 2], rows: &Range<usize>) -> [i128; 2] {
    [lo.sum(rows.clone()), hi.sum(rows.clone())]
}

/// The same of several columns.
#[inline(always)]
fn sum_each(columns: [&[Ends; 2]; 5], rows: &Range<usize>) -> [[i128; 2]; 5] {
    // A closure within a `map` would be compiled for any processor.
    let mut sums = [[0; 2]; 5];
    for (sum, ends) in sums.iter_mut().zip(columns) {
        *sum = sum_both(ends, rows);
    }
    sums
}

/// The same, in the widest instructions that there are.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn totals_of(columns: [&[Ends; 2]; 5], rows: &Range<usize>) -> [[i128; 2]; 5] {
    sum_each(columns, rows)
}

/// No less than the size of all numbers of some columns and rows.
#[inline(always)]
fn size(columns: &[&Ends], rows: &Range<usize>) -> f64 {
    const LANES: usize = 8;
    /// More than the lower part of an end: half of what the upper one is a multiple of, and how far it was moved.
    const LOWER: f64 = 1.0 / (1 << 11) as f64;
    let mut sizes = [0.0; LANES];
    for [upper, _] in columns {
        let (several, rest) = upper[rows.clone()].as_chunks::<LANES>();
        for several in several {
            for (size, x) in sizes.iter_mut().zip(several) {
                *size += x.abs();
            }
        }
        for (size, x) in sizes.iter_mut().zip(rest) {
            *size += x.abs();
        }
    }
    joined(sizes, |a, b| a + b) + LOWER * (columns.len() * rows.len()) as f64
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn add_up(tile: &mut Counted, rows: &Range<usize>, excess: Option<[End; 2]>) {
    tile.add_up(rows, excess);
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn totals(tile: &Counted, rows: &Range<usize>) -> ([[i128; 2]; 5], i128, [i128; 2]) {
    let sums = sum_each(tile.sums.each_ref(), rows);
    let supply = match tile.steps.running {
        true => sum_both(&tile.steps.supply, rows),
        false => [0; 2],
    };
    (sums, tile.observed.sum(rows.clone()), supply)
}

/// The least net energy of a row, exactly, as two numbers to be added; and bounds from below: as [`Sums`] has them of net
/// energy, of that and what is stored after it, and of what the observer adds; and of what is added to T, alone and with
/// what T has beside.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least(tile: &Counted, rows: &Range<usize>) -> ([f64; 2], [f64; 7]) {
    let [low, high] = [near(&tile.stored[0]), near(&tile.stored[1])];
    let [net, observed, least, most] = &tile.steps.up_to;
    let row = least_row(&tile.sums[3][0], rows);
    let [a, b] = [net, observed].map(|sums| lowest_of(&sums[rows.clone()]));
    let with_stored = lowest_beside(net, &low, rows);
    if !tile.steps.running {
        return (row, [a, with_stored, b, 0.0, 0.0, 0.0, 0.0]);
    }
    let [c, d] = [least, most].map(|sums| lowest_of(&sums[rows.clone()]));
    let beside = [
        lowest_beside(least, &low, rows),
        lowest_beside(most, &high, rows),
    ];
    (row, [a, with_stored, b, c, d, beside[0], beside[1]])
}

/// The least of some numbers, exactly: a double near it, and what that is short of it.
#[inline(always)]
fn least_row(column @ [upper, lower]: &Ends, rows: &Range<usize>) -> [f64; 2] {
    // The double nearest to the least number is the least of those nearest to all of them. What that leaves of the least
    // number is on the grid and not rounded, and of all others no less, rounded or not.
    let nearest = lowest_of(&near(column)[rows.clone()]);
    let mut left = [0.0; TILE];
    for ((left, upper), lower) in left.iter_mut().zip(upper).zip(lower) {
        *left = (upper - nearest) + lower;
    }
    [nearest, lowest_of(&left[rows.clone()])]
}

/// The lowest that sums are with what stands beside them.
#[inline(always)]
fn lowest_beside(sums: &[f64; TILE], beside: &[f64; TILE], rows: &Range<usize>) -> f64 {
    let mut both = *sums;
    for (sum, beside) in both.iter_mut().zip(beside) {
        *sum += beside;
    }
    lowest_of(&both[rows.clone()])
}

/// As [`TileRows::courses`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn courses(tile: &Counted, rows: &Range<usize>, (asked, sums): (Asked, &Sums)) -> Courses<i128> {
    let Steps {
        supply,
        running,
        up_to: [up_to, _, least, most],
        off,
    } = &tile.steps;
    let ([_, _, _, [total, _], _], off) = (sums.sums, *off);
    let mut courses = Courses::default();
    let net = &tile.sums[3][0];
    let way = Way {
        rows,
        sums: up_to,
        exactly: net,
        total,
        off,
    };
    if asked.net {
        courses.net = way.least();
        if !running {
            courses.stored = with(&way, &tile.stored[0]);
        }
    }
    if asked.worst {
        courses.worst = way.worst(&near(net));
    }
    let ends = supply.iter().zip([least, most]);
    for (end, ((exactly, up_to), total)) in ends.zip(sums.supply).enumerate() {
        if asked.supply[end] {
            let way = Way {
                rows,
                sums: up_to,
                exactly,
                total,
                off,
            };
            courses.supply[end] = way.least();
            courses.lowest[end] = with(&way, &tile.stored[end]);
        }
    }
    courses
}

/// Where a sum is least with what is stored after each row.
#[inline(always)]
fn with(way: &Way<'_, Ends>, stored: &Ends) -> Least<i128> {
    let stays = |i: usize| at(stored, i) == at(stored, i - 1);
    way.with(&near(stored), (|i: usize| one(stored, i), stays))
}

/// As [`TileRows::observer`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn observer(tile: &Counted, rows: &Range<usize>, total: i128) -> Course<i128> {
    let [_, up_to, ..] = &tile.steps.up_to;
    Way {
        rows,
        sums: up_to,
        exactly: &tile.observed,
        total,
        off: tile.steps.off,
    }
    .least()
}

impl TileRows for Counted {
    fn add_up(
        &mut self,
        rows: &Range<usize>,
        running: bool,
        excess: Option<&Bounds>,
    ) -> Option<()> {
        let before = match running {
            true => {
                let [least, most] = excess?;
                Some([parts(below(least)?)?, parts(below(most)?)?])
            }
            false => None,
        };
        add_up(self, rows, before);
        Some(())
    }

    fn sums(&self, rows: &Range<usize>) -> Sums {
        let (sums, observed, supply) = totals(self, rows);
        let off = self.steps.off;
        let (row, found) = least(self, rows);
        let [
            least_net,
            least_stored,
            least_observed,
            least,
            most,
            least_end,
            most_end,
        ] = found.map(|low| lowest(low, off));
        let last = both(&self.excess, rows.end - 1).map(|n| Reduced::Small(n, ONE));
        Sums {
            sums,
            observed,
            least_net,
            least_stored,
            least_observed,
            least_row: lowest(row[0], 0.0) + lowest(row[1], 0.0),
            supply,
            least_supply: [least, most],
            least_supplied: [least_end, most_end],
            excess: (last != NO_FORCE).then_some(last),
            off,
        }
    }

    fn totals(&self, rows: &Range<usize>) -> [[i128; 2]; 5] {
        totals_of(self.sums.each_ref(), rows)
    }

    fn courses(&self, rows: &Range<usize>, of: (Asked, &Sums)) -> Courses<i128> {
        courses(self, rows, of)
    }

    fn observer(&self, rows: &Range<usize>, sums: &Sums) -> Course<i128> {
        observer(self, rows, sums.observed)
    }

    fn covers(&self) -> &[u64; TILE] {
        &self.covers
    }
}
