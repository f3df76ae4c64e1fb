//! Sums over rows of counts, and how low they may get on the way.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::course::Course;

use super::TILE;
use super::counted::{Counted, Ends, NONE, both, one};
use super::least::{OnGrid, Way};
use super::sums::{Asked, Courses, Sums, TileRows, lowest, off};
use crate::log::quick::{End, carried, parts, units, whole};
use crate::log::supply::{Bounds, NO_FORCE};
use crate::number::Reduced;
use crate::span::{ONE, units as below};

/// What rows add to T, at the least and at the most, where the verdict is about that.
pub(crate) struct Steps(Option<[Ends; 2]>);

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
    /// What each row adds to T, as [`Contribution::supplied`] has it: the first of them after one with this excess force.
    ///
    /// [`Contribution::supplied`]: crate::log::supply::Contribution::supplied
    #[inline(always)]
    fn steps(&self, first: usize, excess: [End; 2]) -> [Ends; 2] {
        let mut steps = [NONE; 2];
        for i in 1..TILE {
            let before = self.excess.each_ref().map(|end| at(end, i - 1));
            self.step(&mut steps, i, before);
        }
        self.step(&mut steps, first, excess);
        steps
    }

    /// The same of a row, after one with this excess force.
    #[inline(always)]
    fn step(&self, steps: &mut [Ends; 2], i: usize, before: [End; 2]) {
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
        for (steps, (own, force, change)) in steps.iter_mut().zip(added) {
            // Nothing is rounded: forces are below 2^30, ticks below 2^5 and the rest below that.
            let [upper, lower] =
                [0, 1].map(|part| (own[part] - force[part] * ticks) + change[part]);
            [steps[0][i], steps[1][i]] = carried([upper, lower]);
        }
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

/// The least that some numbers become from row to row, which are made of the sums of columns up to a row and of the
/// row: bounds from below of them, in units of the grid.
#[inline(always)]
fn least_of<const N: usize>(
    rows: &Range<usize>,
    columns: [&Ends; N],
    of: impl Fn([f64; N], [f64; N]) -> [f64; 4],
) -> ([i128; 4], f64) {
    let mut found = [[0.0; N]; TILE];
    let mut sizes = [0.0; TILE];
    for (n, column) in columns.into_iter().enumerate() {
        for i in 0..TILE {
            let [upper, lower] = at(column, i);
            found[i][n] = upper + lower;
            sizes[i] += upper.abs() + lower.abs();
        }
    }
    let (mut sums, mut size) = ([0.0; N], 0.0);
    let mut lows = [f64::INFINITY; 4];
    for i in rows.clone() {
        for (sum, value) in sums.iter_mut().zip(found[i]) {
            *sum += value;
        }
        size += sizes[i];
        for (low, found) in lows.iter_mut().zip(of(sums, found[i])) {
            *low = if found < *low { found } else { *low };
        }
    }
    (lows.map(|low| lowest(low, size)), off(size))
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn steps(tile: &Counted, first: usize, excess: [End; 2]) -> [Ends; 2] {
    tile.steps(first, excess)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn totals(
    tile: &Counted,
    rows: &Range<usize>,
    steps: Option<&[Ends; 2]>,
) -> ([[i128; 2]; 5], i128, [i128; 2]) {
    // A closure within a `map` would be compiled for any processor.
    let mut sums = [[0; 2]; 5];
    for (sum, ends) in sums.iter_mut().zip(&tile.sums) {
        *sum = sum_both(ends, rows);
    }
    let supply = match steps {
        Some(steps) => sum_both(steps, rows),
        None => [0; 2],
    };
    (sums, tile.observed.sum(rows.clone()), supply)
}

/// Of net energy, of that and what is stored after it, of what the observer adds, and of the net energy of a row alone.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least(tile: &Counted, rows: &Range<usize>) -> ([i128; 4], f64) {
    let columns = [&tile.sums[3][0], &tile.observed, &tile.stored[0]];
    least_of(rows, columns, |[net, observed, _], [row, _, stored]| {
        [net, net + stored, observed, row]
    })
}

/// Of what is added to T at the least and at the most, and of that with what T has beside.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least_supply(tile: &Counted, rows: &Range<usize>, steps: &[Ends; 2]) -> ([i128; 4], f64) {
    let ([least, most], [low, high]) = (steps, &tile.stored);
    least_of(
        rows,
        [least, most, low, high],
        |[least, most, ..], [.., low, high]| [least, most, least + low, most + high],
    )
}

/// As [`TileRows::courses`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn courses(
    tile: &Counted,
    rows: &Range<usize>,
    steps: Option<&[Ends; 2]>,
    (asked, off): (Asked, f64),
) -> Courses<i128> {
    let mut courses = Courses::default();
    if asked.net || asked.worst {
        let net = &tile.sums[3][0];
        let way = Way {
            rows,
            steps: &near(net),
            exactly: net,
            off,
        };
        courses.net = way.least();
        if steps.is_none() {
            courses.stored = way.with(&near(&tile.stored[0]), |i| one(&tile.stored[0], i));
        }
        if asked.worst {
            courses.worst = way.worst();
        }
    }
    for (end, steps) in steps.into_iter().flatten().enumerate() {
        if asked.supply[end] {
            let way = Way {
                rows,
                steps: &near(steps),
                exactly: steps,
                off,
            };
            let stored = &tile.stored[end];
            courses.supply[end] = way.least();
            courses.lowest[end] = way.with(&near(stored), |i| one(stored, i));
        }
    }
    courses
}

/// As [`TileRows::observer`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn observer(observed: &Ends, rows: &Range<usize>, off: f64) -> Course<i128> {
    Way {
        rows,
        steps: &near(observed),
        exactly: observed,
        off,
    }
    .least()
}

impl TileRows for Counted {
    type Steps = Steps;

    fn steps(&self, rows: &Range<usize>, running: bool, excess: Option<&Bounds>) -> Option<Steps> {
        if !running {
            return Some(Steps(None));
        }
        let [least, most] = excess?;
        let before = [parts(below(least)?)?, parts(below(most)?)?];
        Some(Steps(Some(steps(self, rows.start, before))))
    }

    fn sums(&self, rows: &Range<usize>, Steps(steps): &Steps) -> Sums {
        let (sums, observed, supply) = totals(self, rows, steps.as_ref());
        let ([least_net, least_stored, least_observed, least_row], off) = least(self, rows);
        let ([least, most, least_end, most_end], off_supply) = match steps {
            Some(steps) => least_supply(self, rows, steps),
            // Nothing is added to it, and no one asks what it has beside.
            None => ([0, 0, i128::MIN, i128::MIN], 0.0),
        };
        let last = both(&self.excess, rows.end - 1).map(|n| Reduced::Small(n, ONE));
        Sums {
            sums,
            observed,
            least_net,
            least_stored,
            least_observed,
            least_row,
            supply,
            least_supply: [least, most],
            least_supplied: [least_end, most_end],
            excess: (last != NO_FORCE).then_some(last),
            off: off.max(off_supply),
        }
    }

    fn courses(
        &self,
        rows: &Range<usize>,
        Steps(steps): &Steps,
        of: (Asked, f64),
    ) -> Courses<i128> {
        courses(self, rows, steps.as_ref(), of)
    }

    fn observer(&self, rows: &Range<usize>, off: f64) -> Course<i128> {
        observer(&self.observed, rows, off)
    }

    fn covers(&self) -> &[u64; TILE] {
        &self.covers
    }
}
