//! Sums over rows of counts, and how low they may get on the way.

use std::ops::Range;

use multiversion::multiversion;

use super::TILE;
use super::counted::{Counted, Ends, NONE, both, choose};
use super::sums::{Energies, Sums, TileRows, lowest};
use crate::ball::on_grid;
use crate::ledger::Truths;
use crate::log::supply::{Bounds, NO_FORCE};
use crate::number::Reduced;
use crate::span::{ONE, units};

/// What rows add to T, at the least and at the most.
pub(crate) struct Steps([Ends; 2]);

impl Steps {
    const NONE: Self = Self([NONE; 2]);
}

/// One number in layers of 1, 2⁻³² and 2⁻⁶⁴.
type Layers = [i64; 3];

#[inline(always)]
fn at(ends: &Ends, i: usize) -> Layers {
    [ends[0][i], ends[1][i], ends[2][i]]
}

#[inline(always)]
fn difference(a: Layers, b: Layers) -> Layers {
    [
        a[0].wrapping_sub(b[0]),
        a[1].wrapping_sub(b[1]),
        a[2].wrapping_sub(b[2]),
    ]
}

/// All bits where a number is below zero, else none.
#[inline(always)]
fn below_zero([whole, upper, lower]: Layers) -> i64 {
    // What is left of each layer, once it has given to the next what is too large for it, is not negative.
    let upper = upper.wrapping_add(lower >> 32);
    whole.wrapping_add(upper >> 32) >> 63
}

/// A number as a double, and the size of its layers.
#[inline(always)]
#[allow(clippy::cast_precision_loss)] // the slack has room for it
fn near([whole, upper, lower]: Layers) -> [f64; 2] {
    const HALF: f64 = 1.0 / (1_u64 << 32) as f64;
    let [a, b, c] = [
        whole as f64,
        upper as f64 * HALF,
        lower as f64 * (HALF * HALF),
    ];
    [a + b + c, a.abs() + b.abs() + c.abs()]
}

/// A number in units of the grid in layers; `None` where it is too large.
fn layers(n: i128) -> Option<Layers> {
    let low = |n: i128| i64::from((n & 0xffff_ffff) as u32);
    let whole = i64::try_from(n >> 64).ok()?;
    (whole.unsigned_abs() < 1 << 50).then(|| [whole, low(n >> 32), low(n)])
}

impl Counted {
    /// What each row adds to T, after rows with these excess forces: as [`Contribution::supplied`] has it.
    ///
    /// [`Contribution::supplied`]: crate::log::supply::Contribution::supplied
    #[inline(always)]
    fn steps(&self, before: &[Ends; 2]) -> Steps {
        let mut steps = [NONE; 2];
        for i in 0..TILE {
            let [least, most] = [0, 1].map(|end| at(&self.excess[end], i));
            let ticks = self.crossed[i];
            let is_ahead = ticks >= 0;
            let (high, low) = (choose(is_ahead, most, least), choose(is_ahead, least, most));
            let fall = difference(least, at(&before[1], i));
            let rise = difference(most, at(&before[0], i));
            let (falls, rises) = (below_zero(fall), !below_zero(rise));
            for layer in 0..3 {
                let own = [&self.own[0], &self.own[1]].map(|own| own[layer][i]);
                steps[0][layer][i] = own[0]
                    .wrapping_sub(high[layer].wrapping_mul(ticks))
                    .wrapping_add(fall[layer] & falls);
                steps[1][layer][i] = own[1]
                    .wrapping_sub(low[layer].wrapping_mul(ticks))
                    .wrapping_add(rise[layer] & rises);
            }
        }
        Steps(steps)
    }

    /// The excess forces of the rows before each of some rows; `None` where that before the first is not on the grid.
    fn before(&self, rows: &Range<usize>, excess: &Bounds) -> Option<[Ends; 2]> {
        let mut before = [NONE; 2];
        for (end, before) in before.iter_mut().enumerate() {
            let first = layers(units(&excess[end])?)?;
            for (layer, before) in before.iter_mut().enumerate() {
                let of = &self.excess[end][layer];
                before[1..].copy_from_slice(&of[..TILE - 1]);
                before[rows.start] = first[layer];
            }
        }
        Some(before)
    }

    #[inline(always)]
    fn totals(
        &self,
        rows: &Range<usize>,
        Steps(steps): &Steps,
    ) -> ([[i128; 2]; 5], i128, [i128; 2]) {
        let sum = |ends: &Ends| {
            on_grid([0, 1, 2].map(|layer| {
                let rows = &ends[layer][rows.clone()];
                // A tile of numbers below 2^57.
                rows.iter().fold(0_i64, |sum, n| sum.wrapping_add(*n))
            }))
        };
        let figures = self.sums.each_ref();
        (
            figures.map(|ends| ends.each_ref().map(sum)),
            sum(&self.observed),
            steps.each_ref().map(sum),
        )
    }

    /// Bounds from below of the sums of the first few rows, in units of the grid: see [`Sums`].
    #[inline(always)]
    fn least(&self, rows: &Range<usize>, Steps(steps): &Steps) -> [i128; 8] {
        let mut found = [[0.0; TILE]; 6];
        let mut sizes = [0.0; TILE];
        let net = &self.sums[3][0];
        let columns = [
            net,
            &self.observed,
            &steps[0],
            &steps[1],
            &self.stored[0],
            &self.stored[1],
        ];
        for (found, column) in found.iter_mut().zip(columns) {
            for i in 0..TILE {
                let [value, size] = near(at(column, i));
                found[i] = value;
                sizes[i] += size;
            }
        }
        let [
            nets,
            observations,
            least_steps,
            most_steps,
            least_ends,
            most_ends,
        ] = &found;
        let [mut net, mut observed, mut least, mut most, mut size] = [0.0; 5];
        let mut lows = [f64::INFINITY; 8];
        for i in rows.clone() {
            net += nets[i];
            observed += observations[i];
            least += least_steps[i];
            most += most_steps[i];
            size += sizes[i];
            let found = [
                net,
                net + least_ends[i],
                observed,
                nets[i],
                least,
                most,
                least + least_ends[i],
                most + most_ends[i],
            ];
            for (low, found) in lows.iter_mut().zip(found) {
                *low = if found < *low { found } else { *low };
            }
        }
        lows.map(|low| lowest(low, size))
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn steps(tile: &Counted, before: &[Ends; 2]) -> Steps {
    tile.steps(before)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn totals(tile: &Counted, rows: &Range<usize>, steps: &Steps) -> ([[i128; 2]; 5], i128, [i128; 2]) {
    tile.totals(rows, steps)
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn least(tile: &Counted, rows: &Range<usize>, steps: &Steps) -> [i128; 8] {
    tile.least(rows, steps)
}

impl TileRows for Counted {
    type Steps = Steps;

    fn steps(&self, rows: &Range<usize>, running: bool, excess: Option<&Bounds>) -> Option<Steps> {
        match running {
            true => Some(steps(self, &self.before(rows, excess?)?)),
            false => Some(Steps::NONE),
        }
    }

    fn sums(&self, rows: &Range<usize>, steps: &Steps) -> Sums {
        let (sums, observed, supply) = totals(self, rows, steps);
        let [
            least_net,
            least_stored,
            least_observed,
            least_row,
            least,
            most,
            least_end,
            most_end,
        ] = least(self, rows, steps);
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
        }
    }

    fn energies(&self, i: usize, Steps(steps): &Steps) -> Energies {
        Energies {
            net: on_grid(at(&self.sums[3][0], i)),
            step: both(steps, i),
            end: both(&self.stored, i),
        }
    }

    fn observed(&self) -> [i128; TILE] {
        std::array::from_fn(|i| on_grid(at(&self.observed, i)))
    }

    fn truths(&self, i: usize) -> Truths {
        self.answers(i)
    }

    fn alike(&self, rows: Range<usize>) -> usize {
        let kind = |i: usize| (self.covers[i], self.crossed[i].unsigned_abs() <= 1);
        let first = kind(rows.start);
        rows.take_while(|i| kind(*i) == first).count()
    }
}
