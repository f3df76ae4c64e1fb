//! Sums over the rows of a tile, and how low they may get on the way.

use std::ops::{Add, Range};

use multiversion::multiversion;
use passivity_core::course::{Course, Least};

use super::least::{courses, observer};
use super::{Column, TILE, Tile};
use crate::ball::{Ball, on_grid};
use crate::log::motion::figures;
use crate::log::supply::Bounds;

/// The sums of the lower and of the upper ends of the columns of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Totals {
    generated: [[i128; 2]; 2],
    more: [i128; 2],
    taken: [i128; 2],
    observed: [i128; 2],
}

/// Sums of some rows of a tile, in units of the grid.
#[derive(Clone, Debug)]
pub(crate) struct Sums {
    /// As [`Addend::sums`].
    pub(crate) sums: [[i128; 2]; 5],
    pub(crate) observed: i128,
    /// No sum of the first few rows is less than these of their own: of net energy at the least, of that and the
    /// potential after them, and of what the observer adds.
    pub(crate) least_net: i128,
    pub(crate) least_stored: i128,
    pub(crate) least_observed: i128,
    /// No net energy of a row is less than this.
    pub(crate) least_row: i128,
    /// What is added to T at the least and at the most, and what no sum of the first few rows of it is less than: alone,
    /// and with what T has beside after them.
    pub(crate) supply: [i128; 2],
    pub(crate) least_supply: [i128; 2],
    pub(crate) least_supplied: [i128; 2],
    /// The excess force of the last row, where it has any.
    pub(crate) excess: Option<Bounds>,
    /// What doubles near sums of some of the rows are off by at most.
    pub(crate) off: f64,
}

/// Of which sums it is asked where they are least.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Asked {
    pub(crate) net: bool,
    pub(crate) worst: bool,
    /// What is left of what was stored at the start, at the least and at the most.
    pub(crate) supply: [bool; 2],
}

/// What rows make of the sums of which the least is kept, from zero at the first of them. Rows are counted from 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Courses<T> {
    /// Net energy at the least; and where that and the potential were least, where the verdict is about that.
    pub(crate) net: Course<T>,
    pub(crate) stored: Least<T>,
    /// The least net energy of a row alone.
    pub(crate) worst: Least<T>,
    /// What is left of what was stored at the start, where the verdict is about it instead, at the least and at the most;
    /// and where it was least with the potential.
    pub(crate) supply: [Course<T>; 2],
    pub(crate) lowest: [Least<T>; 2],
}

impl<T: Copy + Default + PartialOrd + Add<Output = T>> Courses<T> {
    /// Goes on with row `h`: by net energy and the potential after it, and by what is added to T and what that has
    /// beside.
    #[inline(always)]
    pub(crate) fn step(&mut self, (net, potential): (T, T), supply: Option<[[T; 2]; 2]>, h: u64) {
        if let Some([steps, ends]) = supply {
            let sums = self.supply.iter_mut().zip(&mut self.lowest);
            for ((sum, lowest), (step, end)) in sums.zip(steps.into_iter().zip(ends)) {
                sum.step(step, h);
                lowest.keep(sum.sum + end, h);
            }
        }
        self.net.step(net, h);
        if supply.is_none() {
            self.stored.keep(self.net.sum + potential, h);
        }
        self.worst.keep(net, h);
    }

    /// Goes on with the rows that follow these `rows`.
    pub(crate) fn append(&mut self, other: &Self, rows: u64) {
        let ours = self.supply.iter_mut().zip(&mut self.lowest);
        for ((sum, lowest), (added, found)) in ours.zip(other.supply.iter().zip(&other.lowest)) {
            lowest.append(found, &sum.sum, rows);
            sum.append(added, rows);
        }
        self.stored.append(&other.stored, &self.net.sum, rows);
        self.net.append(&other.net, rows);
        self.worst.append(&other.worst, &T::default(), rows);
    }
}

/// Rows that were computed several at a time, all of them decided.
pub(crate) trait TileRows {
    /// Makes ready for sums over some rows, and over what they add to T where the verdict is about that, after one with
    /// this excess force; `None` where they are for one row after the other.
    fn add_up(&mut self, rows: &Range<usize>, running: bool, excess: Option<&Bounds>)
    -> Option<()>;

    /// Their sums.
    fn sums(&self, rows: &Range<usize>) -> Sums;

    /// The five figures of [`Sums::sums`] alone, before which nothing has to be [made ready](Self::add_up).
    fn totals(&self, rows: &Range<usize>) -> [[i128; 2]; 5];

    /// Where the sums that it is asked of are least, in units of the grid: without the sums of all rows.
    fn courses(&self, rows: &Range<usize>, of: (Asked, &Sums)) -> Courses<i128>;

    /// The same of what the observer sums up.
    fn observer(&self, rows: &Range<usize>, sums: &Sums) -> Course<i128>;

    /// What each row answers, as bits.
    fn covers(&self) -> &[u64; TILE];
}

/// The rows of a tile under the force in the log where that is `applied`, else under that of the wall.
pub(crate) struct Under<'a> {
    pub(super) tile: &'a Tile,
    pub(super) applied: bool,
    /// Whether the verdict is about T.
    pub(super) running: bool,
}

impl<'a> Under<'a> {
    pub(crate) const fn new(tile: &'a Tile, applied: bool) -> Self {
        Self {
            tile,
            applied,
            running: false,
        }
    }
}

impl TileRows for Under<'_> {
    fn add_up(&mut self, _: &Range<usize>, running: bool, excess: Option<&Bounds>) -> Option<()> {
        self.running = running;
        excess.is_none().then_some(())
    }

    fn sums(&self, rows: &Range<usize>) -> Sums {
        self.tile.sums(rows, self.applied)
    }

    fn totals(&self, rows: &Range<usize>) -> [[i128; 2]; 5] {
        self.tile.figures(rows, self.applied).0
    }

    fn courses(&self, rows: &Range<usize>, of: (Asked, &Sums)) -> Courses<i128> {
        courses(self, rows, of)
    }

    fn observer(&self, rows: &Range<usize>, sums: &Sums) -> Course<i128> {
        observer(self, rows, sums)
    }

    fn covers(&self) -> &[u64; TILE] {
        &self.tile.truths[usize::from(self.applied)]
    }
}

impl Tile {
    /// The five figures of rows that are decided, and what the observer adds.
    fn figures(&self, rows: &Range<usize>, applied: bool) -> ([[i128; 2]; 5], i128) {
        let some;
        let totals = match &self.whole {
            Some(totals) if *rows == (0..TILE) => totals,
            _ => {
                some = self.totals_of(rows);
                &some
            }
        };
        let more = if applied { totals.more } else { [0, 0] };
        let sums = figures(totals.generated, more, totals.taken);
        (sums, totals.observed[0] - more[1])
    }

    /// The sums of rows that are decided.
    pub(crate) fn sums(&self, rows: &Range<usize>, applied: bool) -> Sums {
        let (sums, observed) = self.figures(rows, applied);
        let ([least_net, least_stored, least_observed, least_row], off) =
            least(self, rows, applied);
        let [_, _, _, net, _] = sums;
        Sums {
            sums,
            observed,
            least_net,
            least_stored,
            least_observed,
            least_row,
            supply: net,
            least_supply: [least_net; 2],
            least_supplied: [least_stored; 2],
            excess: None,
            off,
        }
    }

    fn totals_of(&self, rows: &Range<usize>) -> Totals {
        let mut part = self.clone();
        let [taken, most] = &mut part.taken;
        let (linear, quantized, more) = (&mut part.linear, &mut part.quantized, &mut part.more);
        for column in [linear, quantized, more, taken, most, &mut part.observed] {
            column.cut(rows.end);
            column.middles[..rows.start].fill(0.0);
            column.radii[..rows.start].fill(0.0);
        }
        totals(&part)
    }

    #[inline(always)]
    fn totals(&self) -> Totals {
        let [least, most] = &self.taken;
        Totals {
            generated: [ends(&self.linear), ends(&self.quantized)],
            more: ends(&self.more),
            taken: [ends(least)[0], ends(most)[1]],
            observed: ends(&self.observed),
        }
    }

    /// Bounds from below, in units of the grid, and what doubles near them are off by at most: see [`Sums`].
    #[inline(always)]
    fn least(&self, rows: &Range<usize>, applied: bool) -> ([i128; 4], f64) {
        // Of each row: what it adds to net energy and to what the observer sums, the potential after it, and the
        // size of all of them.
        let mut found = [[0.0; TILE]; 4];
        let [nets, observations, potentials, sizes] = &mut found;
        for i in 0..TILE {
            let at = |column: &Column| (column.middles[i], column.radii[i]);
            let ((a, r), (b, s)) = (at(&self.taken[0]), at(&self.linear));
            let ((e, u), (g, v)) = (at(&self.observed), at(&self.potential));
            let (c, t) = if applied { at(&self.more) } else { (0.0, 0.0) };
            let more = c + t;
            nets[i] = (a - r) - (b + s) - more;
            observations[i] = (e - u) - more;
            potentials[i] = g - v;
            sizes[i] = a.abs() + b.abs() + c.abs() + e.abs() + g.abs() + (r + s + t + u + v);
        }
        if *rows == (0..TILE) {
            return least_of_parts(&found);
        }
        let [nets, observations, potentials, sizes] = &found;
        let [mut net, mut observed, mut size] = [0.0; 3];
        let mut least = [f64::INFINITY; 4];
        for i in rows.clone() {
            net += nets[i];
            observed += observations[i];
            size += sizes[i];
            let found = [net, net + potentials[i], observed, nets[i]];
            for (least, found) in least.iter_mut().zip(found) {
                *least = if found < *least { found } else { *least };
            }
        }
        let off = off(size);
        (least.map(|x| lowest(x, off)), off)
    }
}

/// [`Tile::least`] of all rows, a part of the tile at a time: in it, no sum of the first few rows is less than that of all
/// rows of the part that are below zero. So no sum has to wait for that of the row before.
#[inline(always)]
fn least_of_parts([nets, observations, potentials, sizes]: &[[f64; TILE]; 4]) -> ([i128; 4], f64) {
    let below_zero = |x: f64| if x < 0.0 { x } else { 0.0 };
    let [mut net, mut observed, mut size] = [0.0; 3];
    let mut least = [f64::INFINITY; 4];
    for part in (0..TILE).step_by(PART) {
        let lowest_net = net + added(nets, part, below_zero);
        let found = [
            lowest_net,
            lowest_net + lowest_of(&potentials[part..part + PART]),
            observed + added(observations, part, below_zero),
            lowest_of(&nets[part..part + PART]),
        ];
        for (least, found) in least.iter_mut().zip(found) {
            *least = less(*least, found);
        }
        net += added(nets, part, |x| x);
        observed += added(observations, part, |x| x);
        size += added(sizes, part, |x| x);
    }
    let off = off(size);
    (least.map(|x| lowest(x, off)), off)
}

/// How many rows a part has.
const PART: usize = 16;

/// Numbers that processors compute with at once.
const LANES: usize = 8;

#[inline(always)]
fn less(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The sum of what is made of the numbers of a part.
#[inline(always)]
fn added(column: &[f64; TILE], part: usize, change: impl Fn(f64) -> f64) -> f64 {
    let mut lanes = [0.0; LANES];
    for at in (part..part + PART).step_by(LANES) {
        for (lane, x) in lanes.iter_mut().zip(&column[at..at + LANES]) {
            *lane += change(*x);
        }
    }
    joined(lanes, |a, b| a + b)
}

/// The least of some numbers.
#[inline(always)]
pub(super) fn lowest_of(column: &[f64]) -> f64 {
    let (several, rest) = column.as_chunks::<LANES>();
    let mut lanes = [f64::INFINITY; LANES];
    for several in several {
        for (lane, x) in lanes.iter_mut().zip(several) {
            *lane = less(*lane, *x);
        }
    }
    let mut least = joined(lanes, less);
    for x in rest {
        least = less(least, *x);
    }
    least
}

/// What pairs of them come to, and pairs of these.
#[inline(always)]
pub(super) fn joined(
    [a, b, c, d, e, f, g, h]: [f64; LANES],
    pair: impl Fn(f64, f64) -> f64,
) -> f64 {
    let [a, c, e, g] = [pair(a, b), pair(c, d), pair(e, f), pair(g, h)];
    pair(pair(a, c), pair(e, g))
}

/// [`Tile::least`], in the widest instructions that there are.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least(tile: &Tile, rows: &Range<usize>, applied: bool) -> ([i128; 4], f64) {
    tile.least(rows, applied)
}

/// In units of the grid, what a sum of some rows is not below that doubles make this, which are off by so much at most.
#[inline(always)]
pub(super) fn lowest(x: f64, off: f64) -> i128 {
    below(x - off)
}

/// What a double near a sum of some rows is off by at most: of numbers of this size, together.
#[inline(always)]
pub(super) fn off(size: f64) -> f64 {
    // Each number is off by a few roundings of what it is made of, and rounded to the grid by a few units.
    const ROUNDING: f64 = 1.0 / (1_u64 << 42) as f64;
    const UNITS: f64 = 1.0 / (1_u64 << 50) as f64;
    size * ROUNDING + UNITS
}

/// A double as a number of units of the grid, rounded down, as far as 128 bits go.
#[allow(clippy::cast_possible_truncation)] // to the nearest of them
fn below(x: f64) -> i128 {
    const UNITS: f64 = 18_446_744_073_709_551_616.0;
    // There is room for sums with it.
    let most = UNITS * UNITS / 16.0;
    (x * UNITS).floor().clamp(-most, most) as i128
}

/// The sums of the lower and of the upper ends of a column.
#[inline(always)]
fn ends(column: &Column) -> [i128; 2] {
    let mut sums = [0_i64; 4];
    for (middle, radius) in column.middles.iter().zip(&column.radii) {
        let layers = Ball::from_parts(*middle, *radius).layers();
        for (sum, layer) in sums.iter_mut().zip(layers) {
            // A tile of numbers below 2^50.
            *sum = sum.wrapping_add(layer);
        }
    }
    let [whole, upper, lower, radius] = sums;
    let (middle, radius) = (on_grid([whole, upper, lower]), i128::from(radius));
    [middle - radius, middle + radius]
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn totals(tile: &Tile) -> Totals {
    tile.totals()
}
