//! Sums over rows of counts, and how low they may get on the way.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::course::Course;

use super::TILE;
use super::counted::{Counted, Ends, NONE, both, one};
use super::least::{OnGrid, Way, sums_up_to};
use super::sums::{Asked, Courses, Sums, TileRows, lowest, lowest_of, off};
use crate::log::quick::{End, carried, parts, units, whole};
use crate::log::supply::{Bounds, NO_FORCE};
use crate::number::Reduced;
use crate::span::{ONE, units as below};

/// What rows add to T, at the least and at the most, where the verdict is about that.
pub(crate) struct Steps {
    supply: Option<[Ends; 2]>,
    /// [Near the sums](sums_up_to) of net energy, of what the observer adds, and of what is added to T.
    sums: [[f64; TILE]; 4],
    /// What these are off by at most.
    off: f64,
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

/// The size of all numbers of some columns and rows.
#[inline(always)]
fn size(columns: &[&Ends], rows: &Range<usize>) -> f64 {
    const LANES: usize = 8;
    let mut sizes = [0.0; LANES];
    for part in columns.iter().flat_map(|column| column.iter()) {
        let (several, rest) = part[rows.clone()].as_chunks::<LANES>();
        for several in several {
            for (size, x) in sizes.iter_mut().zip(several) {
                *size += x.abs();
            }
        }
        for (size, x) in sizes.iter_mut().zip(rest) {
            *size += x.abs();
        }
    }
    sizes.iter().sum()
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
#[expect(
    clippy::manual_map,
    reason = "a closure would be compiled for any processor"
)]
fn steps(tile: &Counted, rows: &Range<usize>, excess: Option<[End; 2]>) -> Steps {
    let supply = match excess {
        Some(excess) => Some(tile.steps(rows.start, excess)),
        None => None,
    };
    let (net, [low, high]) = (&tile.sums[3][0], &tile.stored);
    let (least, most) = match &supply {
        Some([least, most]) => (least, most),
        None => (&NONE, &NONE),
    };
    let near = [near(net), near(&tile.observed), near(least), near(most)];
    let size = size(&[net, &tile.observed, least, most, low, high], rows);
    Steps {
        sums: sums_up_to(rows, near.each_ref()),
        off: off(size),
        supply,
    }
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

/// Bounds from below: as [`Sums`] has them of net energy, of that and what is stored after it, of what the observer adds,
/// and of the net energy of a row alone; and of what is added to T, alone and with what T has beside.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least(tile: &Counted, rows: &Range<usize>, steps: &Steps) -> [f64; 8] {
    let [low, high] = [near(&tile.stored[0]), near(&tile.stored[1])];
    let [net, observed, least, most] = &steps.sums;
    let (row, rows) = (near(&tile.sums[3][0]), rows.clone());
    let mut beside = [*net, *least, *most];
    for (sums, stored) in beside.iter_mut().zip([&low, &low, &high]) {
        for (sum, stored) in sums.iter_mut().zip(stored) {
            *sum += stored;
        }
    }
    let [with_stored, least_supplied, most_supplied] = &beside;
    [
        lowest_of(&net[rows.clone()]),
        lowest_of(&with_stored[rows.clone()]),
        lowest_of(&observed[rows.clone()]),
        lowest_of(&row[rows.clone()]),
        lowest_of(&least[rows.clone()]),
        lowest_of(&most[rows.clone()]),
        lowest_of(&least_supplied[rows.clone()]),
        lowest_of(&most_supplied[rows]),
    ]
}

/// As [`TileRows::courses`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn courses(
    tile: &Counted,
    rows: &Range<usize>,
    steps: &Steps,
    (asked, sums): (Asked, &Sums),
) -> Courses<i128> {
    let [up_to, _, least, most] = &steps.sums;
    let [_, _, _, [total, _], _] = sums.sums;
    let off = steps.off;
    let mut courses = Courses::default();
    if asked.net || asked.worst {
        let net = &tile.sums[3][0];
        let way = Way {
            rows,
            sums: up_to,
            exactly: net,
            total,
            off,
        };
        courses.net = way.least();
        if steps.supply.is_none() {
            courses.stored = way.with(&near(&tile.stored[0]), |i| one(&tile.stored[0], i));
        }
        if asked.worst {
            courses.worst = way.worst(&near(net));
        }
    }
    let ends = steps.supply.iter().flatten().zip([least, most]);
    for (end, ((exactly, up_to), total)) in ends.zip(sums.supply).enumerate() {
        if asked.supply[end] {
            let way = Way {
                rows,
                sums: up_to,
                exactly,
                total,
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
fn observer(tile: &Counted, rows: &Range<usize>, steps: &Steps, total: i128) -> Course<i128> {
    let [_, up_to, ..] = &steps.sums;
    Way {
        rows,
        sums: up_to,
        exactly: &tile.observed,
        total,
        off: steps.off,
    }
    .least()
}

impl TileRows for Counted {
    type Steps = Steps;

    fn steps(&self, rows: &Range<usize>, running: bool, excess: Option<&Bounds>) -> Option<Steps> {
        let before = match running {
            true => {
                let [least, most] = excess?;
                Some([parts(below(least)?)?, parts(below(most)?)?])
            }
            false => None,
        };
        Some(steps(self, rows, before))
    }

    fn sums(&self, rows: &Range<usize>, steps: &Steps) -> Sums {
        let (sums, observed, supply) = totals(self, rows, steps.supply.as_ref());
        let found = least(self, rows, steps).map(|low| lowest(low, steps.off));
        let [
            least_net,
            least_stored,
            least_observed,
            least_row,
            least,
            most,
            least_end,
            most_end,
        ] = found;
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
            off: steps.off,
        }
    }

    fn courses(&self, rows: &Range<usize>, steps: &Steps, of: (Asked, &Sums)) -> Courses<i128> {
        courses(self, rows, steps, of)
    }

    fn observer(&self, rows: &Range<usize>, steps: &Steps, sums: &Sums) -> Course<i128> {
        observer(self, rows, steps, sums.observed)
    }

    fn covers(&self) -> &[u64; TILE] {
        &self.covers
    }
}
