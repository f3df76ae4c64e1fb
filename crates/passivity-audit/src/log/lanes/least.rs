//! Where sums over rows of a tile are least on the way. Doubles near them tell which rows that may be, and only there
//! the sums are made exactly: most often, of one row.

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::course::{Course, Least};

use super::sums::{Asked, Courses, Under, less};
use super::{Column, TILE};
use crate::ball::on_grid;

/// Numbers in units of the grid, one of each row.
pub(super) trait OnGrid {
    fn at(&self, i: usize) -> i128;

    /// The sum of some rows.
    fn sum(&self, rows: Range<usize>) -> i128;
}

/// What rows add to a sum, from zero at the first of them.
pub(super) struct Way<'a, C> {
    pub(super) rows: &'a Range<usize>,
    /// Near by, in doubles,
    pub(super) steps: &'a [f64; TILE],
    pub(super) exactly: &'a C,
    /// What sums of the doubles are off by at most.
    pub(super) off: f64,
}

impl<C: OnGrid> Way<'_, C> {
    /// The least that the sum becomes.
    #[inline(always)]
    pub(super) fn least(&self) -> Course<i128> {
        match self.with(&[0.0; TILE], |_| 0).0 {
            Some((least, at)) if least < 0 => Course { sum: 0, least, at },
            _ => Course::default(),
        }
    }

    /// Where the sum is least with what stands beside it after each row: near by, and in units of the grid.
    #[inline(always)]
    pub(super) fn with(&self, beside: &[f64; TILE], end: impl Fn(usize) -> i128) -> Least<i128> {
        let mut near = [0.0; TILE];
        let (mut sum, mut lowest) = (0.0, f64::INFINITY);
        for i in self.rows.clone() {
            sum += self.steps[i];
            near[i] = sum + beside[i];
            lowest = less(lowest, near[i]);
        }
        let mut least = Least::default();
        let mut candidates = self.candidates(&near, lowest);
        // Most often the sum falls up to the last row.
        let Some(last) = candidates.next_back() else {
            return least;
        };
        let first = candidates.next().unwrap_or(last);
        let mut sum = self.exactly.sum(self.rows.start..first);
        for i in first..=last {
            sum += self.exactly.at(i);
            least.keep(sum + end(i), self.number(i));
        }
        least
    }

    /// The least that a row adds.
    #[inline(always)]
    pub(super) fn worst(&self) -> Least<i128> {
        let mut least = Least::default();
        let steps = self.steps[self.rows.clone()].iter();
        let lowest = steps.fold(f64::INFINITY, |least, x| less(least, *x));
        for i in self.candidates(self.steps, lowest) {
            least.keep(self.exactly.at(i), self.number(i));
        }
        least
    }

    /// The rows where numbers that these doubles are near, of which this is the lowest, may be least.
    #[inline(always)]
    fn candidates(
        &self,
        near: &[f64; TILE],
        lowest: f64,
    ) -> impl DoubleEndedIterator<Item = usize> {
        let most = lowest + 2.0 * self.off;
        self.rows.clone().filter(move |i| near[*i] <= most)
    }

    /// The number of a row, from 1.
    const fn number(&self, i: usize) -> u64 {
        (i - self.rows.start) as u64 + 1
    }
}

/// A column of numbers on the grid, as whole numbers of 1, 2⁻³² and 2⁻⁶⁴.
struct Layers([[i64; TILE]; 3]);

impl OnGrid for Layers {
    #[inline(always)]
    fn at(&self, i: usize) -> i128 {
        on_grid([self.0[0][i], self.0[1][i], self.0[2][i]])
    }

    #[inline(always)]
    fn sum(&self, rows: Range<usize>) -> i128 {
        // Of rows that are decided each layer is below 2^54.
        let mut sums = [0_i64; 3];
        for (sum, layer) in sums.iter_mut().zip(&self.0) {
            for n in &layer[rows.clone()] {
                *sum = sum.wrapping_add(*n);
            }
        }
        on_grid(sums)
    }
}

/// What each row adds to a sum: exactly, and near by in doubles.
type Steps = (Layers, [f64; TILE]);

#[inline(always)]
fn way<'a>((exactly, steps): &'a Steps, rows: &'a Range<usize>, off: f64) -> Way<'a, Layers> {
    Way {
        rows,
        steps,
        exactly,
        off,
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

/// What is left of one column without two others, at the least or at the most.
#[inline(always)]
fn left<const LEAST: bool>(from: &Column, less: [&Column; 2]) -> Steps {
    let (mut layers, mut near) = (Layers([[0; TILE]; 3]), [0.0; TILE]);
    let outward = |off: i64| if LEAST { off.wrapping_neg() } else { off };
    for i in 0..TILE {
        let [a, b, c] = [from.get(i), less[0].get(i), less[1].get(i)];
        // Of rows that are decided each layer is below 2^51.
        let [a_layers, b_layers, c_layers] = [a.layers(), b.layers(), c.layers()];
        let off = a_layers[3]
            .wrapping_add(b_layers[3])
            .wrapping_add(c_layers[3]);
        for (n, layer) in layers.0.iter_mut().enumerate() {
            layer[i] = a_layers[n]
                .wrapping_sub(b_layers[n])
                .wrapping_sub(c_layers[n]);
        }
        layers.0[2][i] = layers.0[2][i].wrapping_add(outward(off));
        let ((a, r), (b, s), (c, t)) = (a.parts(), b.parts(), c.parts());
        let radius = r + s + t;
        near[i] = (a - b - c) + if LEAST { -radius } else { radius };
    }
    (layers, near)
}

/// As [`TileRows::courses`], where the verdict is about what was stored at the start and where it is not.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn courses(
    Under { tile, applied }: &Under<'_>,
    rows: &Range<usize>,
    running: bool,
    (asked, off): (Asked, f64),
) -> Courses<i128> {
    let more = if *applied { &tile.more } else { &Column::ZERO };
    let ([least, most], generated) = (&tile.taken, [&tile.linear, more]);
    let potential = &tile.potential;
    let mut courses = Courses::default();
    let [low, high] = asked.supply;
    if asked.net || asked.worst || low {
        let steps = left::<true>(least, generated);
        let way = way(&steps, rows, off);
        // What is added to T at the least is net energy.
        courses.net = way.least();
        courses.supply[0] = courses.net;
        let with = way.with(&end::<true>(potential), |i| {
            potential.get(i).ends_on_grid()[0]
        });
        match running {
            true => courses.lowest[0] = with,
            false => courses.stored = with,
        }
        if asked.worst {
            courses.worst = way.worst();
        }
    }
    if high {
        let steps = left::<false>(most, generated);
        let way = way(&steps, rows, off);
        courses.supply[1] = way.least();
        courses.lowest[1] = way.with(&end::<false>(potential), |i| {
            potential.get(i).ends_on_grid()[1]
        });
    }
    courses
}

/// As [`TileRows::observer`].
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn observer(
    Under { tile, applied }: &Under<'_>,
    rows: &Range<usize>,
    off: f64,
) -> Course<i128> {
    let more = if *applied { &tile.more } else { &Column::ZERO };
    let steps = left::<true>(&tile.observed, [more, &Column::ZERO]);
    way(&steps, rows, off).least()
}
