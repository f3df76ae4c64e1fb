//! Rows of one linear wall several at a time: the kernel's text on balls, without a branch on what they are,
//! so that processors compute several rows with each instruction.
//!
//! Each row is what [`Known`] makes of it, to the last bit: a row of which not all is decided here is for that.

#![expect(
    clippy::indexing_slicing,
    reason = "every index is that of a row of a tile, below the length of every column"
)]

use std::ops::Range;

use multiversion::multiversion;
use passivity_core::ledger;
use passivity_core::{Criterion, Friction, Law, Scalar as _, Step, Truth, dissipation, quantizer};

use crate::ball::{Ball, on_grid};
use crate::figure::not;
use crate::ledger::{Ledger, Truths};
use crate::log::chunk::{Chunk, Samples};
use crate::log::known::Known;
use crate::log::motion::Addend;
use crate::log::numbers::Readings;
use crate::log::step::periods;
use crate::log::task::Task;
use crate::number::{Number, Written as _};

/// How many rows are computed at once.
pub(crate) const TILE: usize = 64;

/// A loop whose force is that of its linear wall, quantized and nothing else.
#[derive(Clone, Debug)]
pub(crate) struct Wall {
    /// The least friction and the most.
    frictions: [Friction<Ball>; 2],
    criteria: [Criterion<Ball>; 2],
    friction_is_exact: bool,
}

impl Wall {
    /// `None` for other loops.
    pub(crate) fn of(ledger: &Ledger) -> Option<Self> {
        let ends = ledger.near();
        let controller = &ends.controller;
        let is_plain = controller.encoder
            && controller.memory() == 0
            && controller.filter.ends()
            && controller.filter.sum == Ball::one()
            && !controller.unilateral
            && controller.force_step.is_none()
            && controller.max_force.is_none();
        let friction = |of: &passivity_core::Loop<Ball>| {
            Friction::new(of.viscous_friction(), of.coulomb_friction())
        };
        (is_plain && ends.least.has_encoder() && ends.least.law().is_linear()).then(|| Self {
            frictions: [friction(&ends.least), friction(&ends.most)],
            criteria: ends.criteria,
            friction_is_exact: ends.friction_is_exact(),
        })
    }
}

/// As many balls as there are rows.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    middles: [f64; TILE],
    radii: [f64; TILE],
}

impl Column {
    const ZERO: Self = Self {
        middles: [0.0; TILE],
        radii: [0.0; TILE],
    };

    #[inline(always)]
    pub(crate) fn get(&self, i: usize) -> Ball {
        Ball::from_parts(self.middles[i], self.radii[i])
    }

    #[inline(always)]
    fn set(&mut self, i: usize, ball: Ball) {
        (self.middles[i], self.radii[i]) = ball.parts();
    }

    /// Makes all behind the first `len` zero.
    fn cut(&mut self, len: usize) {
        self.middles[len..].fill(0.0);
        self.radii[len..].fill(0.0);
    }
}

/// What is known of some consecutive intervals.
struct Intervals {
    start: Column,
    end: Column,
    lasts: Column,
    force: Column,
    /// Not zero where the device stands still.
    still: [u64; TILE],
    len: usize,
}

/// What some consecutive intervals come to, under the force of the wall and under that in the log.
#[derive(Clone, Debug)]
pub(crate) struct Tile {
    /// What is generated against the wall and against its quantized form, by its own force,
    linear: Column,
    quantized: Column,
    /// and what the force in the log does more work than that.
    more: Column,
    /// The least that friction takes, of the least friction and of the most.
    taken: [Column; 2],
    observed: Column,
    potential: Column,
    /// What is at least, and at most, true of the criterion and of both accounts, as bits: under the force of the
    /// wall, and under that in the log.
    truths: [[u64; TILE]; 2],
    /// Not zero for the rows that are left open.
    open: [[u64; TILE]; 2],
    len: usize,
    /// Sums of all columns, where no row is left open.
    whole: Option<Totals>,
}

/// The sums of the lower and of the upper ends of the columns of a tile.
#[derive(Clone, Copy, Debug)]
struct Totals {
    generated: [[i128; 2]; 2],
    more: [i128; 2],
    taken: [i128; 2],
    observed: [i128; 2],
}

/// Sums of some rows of a tile, in units of the grid.
#[derive(Clone, Copy, Debug)]
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
}

impl Intervals {
    const fn new() -> Self {
        Self {
            start: Column::ZERO,
            end: Column::ZERO,
            lasts: Column::ZERO,
            force: Column::ZERO,
            still: [0; TILE],
            len: 0,
        }
    }

    /// The intervals of a chunk from sample `at` on, as long as these: as many as there are and have room.
    fn read(
        &mut self,
        samples: &Readings,
        forces: Option<&Readings>,
        at: usize,
        lengths: &[Length],
    ) {
        self.len = 0;
        for (i, length) in lengths.iter().enumerate().take(TILE) {
            let force = match forces {
                Some(forces) => forces.ball(at + i),
                None => Some(Ball::zero()),
            };
            let (Some(start), Some(end), Some(force)) =
                (samples.ball(at + i), samples.ball(at + i + 1), force)
            else {
                break;
            };
            self.start.set(i, start);
            self.end.set(i, end);
            self.force.set(i, force);
            self.lasts.set(i, length.near());
            self.still[i] = u64::from(samples.written.is_same(at + i, at + i + 1));
            self.len = i + 1;
        }
        // Nothing comes of nothing.
        for column in [&mut self.start, &mut self.end, &mut self.force] {
            column.cut(self.len);
        }
        self.lasts.cut(self.len);
        self.lasts.middles[self.len..].fill(1.0);
    }
}

/// How long an interval is, in periods, as a fraction; nothing where that is left open.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Length(pub(crate) i64, pub(crate) i64);

impl Length {
    const OPEN: Self = Self(0, 0);

    #[inline]
    fn near(self) -> Ball {
        match self.1 {
            0 => Ball::UNDEFINED,
            _ => Ball::of(&Number::Small(self.0, self.1)),
        }
    }
}

#[inline(always)]
fn bit(is: bool, place: usize) -> u64 {
    u64::from(is) << place
}

/// Whether a number is surely not negative, and whether it surely is.
#[inline(always)]
fn is_nonnegative(ball: Ball) -> [bool; 2] {
    let (middle, radius) = ball.parts();
    [middle >= radius, -middle > radius]
}

/// Whether what is taken is surely at least as much as two parts that are generated, and whether it is surely
/// less: on the grid too, to which each is rounded outward.
#[inline(always)]
fn covers(taken: Ball, own: Ball, more: Ball) -> [bool; 2] {
    const UNIT: f64 = 1.0 / (1_u64 << 60) as f64;
    const ROUNDING: f64 = 1.0 / (1_u64 << 48) as f64;
    let ((a, r), (b, s), (c, t)) = (taken.parts(), own.parts(), more.parts());
    let rest = a - (b + c);
    let radius = r + s + t;
    let reach = radius + ((a.abs() + b.abs() + c.abs() + radius) * ROUNDING + UNIT);
    let nothing = taken.is_zero() & own.is_zero() & more.is_zero();
    [(rest > reach) | nothing, -rest > reach]
}

/// Whether what both accounts answer is left open, and what they answer, as bits, where a force does so much more
/// work.
#[inline(always)]
fn answers<const EXACT: bool>(
    ([taken, most], [linear, quantized]): ([Ball; 2], [Ball; 2]),
    more: Ball,
) -> (bool, u64) {
    let [linear_yes, linear_no] = covers(taken, linear, more);
    let [quantized_yes, quantized_no] = covers(taken, quantized, more);
    let mut open = !more.fits() | !(linear_yes | linear_no) | !(quantized_yes | quantized_no);
    let (mut linear_most, mut quantized_most) = (linear_yes, quantized_yes);
    if !EXACT {
        let [yes, no] = covers(most, linear, more);
        (linear_most, open) = (yes, open | !(yes | no));
        let [yes, no] = covers(most, quantized, more);
        (quantized_most, open) = (yes, open | !(yes | no));
    }
    let linear = bit(linear_yes, 2) | bit(linear_most, 3);
    (
        open,
        linear | bit(quantized_yes, 4) | bit(quantized_most, 5),
    )
}

impl Tile {
    const fn new() -> Self {
        Self {
            linear: Column::ZERO,
            quantized: Column::ZERO,
            more: Column::ZERO,
            taken: [Column::ZERO; 2],
            observed: Column::ZERO,
            potential: Column::ZERO,
            truths: [[0; TILE]; 2],
            open: [[0; TILE]; 2],
            len: 0,
            whole: None,
        }
    }

    #[inline(always)]
    fn compute<const EXACT: bool, const APPLIED: bool>(&mut self, wall: &Wall, of: &Intervals) {
        for i in 0..TILE {
            let (start, end, lasts) = (of.start.get(i), of.end.get(i), of.lasts.get(i));
            // Of what stands still, any position that it may have stands for all.
            let step = match of.still[i] != 0 {
                true => Step::new(start.one_of(), start.one_of()),
                false => Step::new(start, end),
            };
            let d = step.displacement();
            let speed = dissipation::mean_speed(&d, &lasts);
            let commanded = quantizer::held_force(&start);
            let taken = wall.frictions[0].dissipated_lower(&d, &speed);
            let most = match EXACT {
                true => taken,
                false => wall.frictions[1].dissipated_lower(&d, &speed),
            };
            let [linear, quantized] = ledger::generated_by_spring(&step, &commanded, true);
            let observed = -(commanded * d);
            let potential = Law::bilateral().potential(&end);
            let [rests, moves] = is_nonnegative(-speed);
            let mut open = !(rests | moves);
            for ball in [linear, quantized, taken, most, observed, potential] {
                open |= !ball.fits();
            }
            let mut criterion = 0;
            for place in 0..2 {
                let [yes, no] = is_nonnegative(wall.criteria[place].margin(&speed));
                open |= moves & !(yes | no);
                criterion |= bit(rests | yes, place);
            }
            let accounts = ([taken, most], [linear, quantized]);
            let (left, truths) = answers::<EXACT>(accounts, Ball::zero());
            self.open[0][i] = u64::from(open | left);
            self.truths[0][i] = criterion | truths;
            if APPLIED {
                let more = (of.force.get(i) - commanded) * d;
                let (left, truths) = answers::<EXACT>(accounts, more);
                self.open[1][i] = u64::from(open | left);
                self.truths[1][i] = criterion | truths;
                self.more.set(i, more);
            }
            self.linear.set(i, linear);
            self.quantized.set(i, quantized);
            self.taken[0].set(i, taken);
            self.taken[1].set(i, most);
            self.observed.set(i, observed);
            self.potential.set(i, potential);
        }
    }

    /// Computes the rows of some intervals.
    fn fill(&mut self, wall: &Wall, of: &Intervals, applied: bool) {
        compute(self, wall, of, applied);
        self.len = of.len;
        let open = self.open.iter().flatten().fold(0, |all, open| all | open);
        self.whole = (self.len == TILE && open == 0).then(|| totals(self));
    }

    /// Up to which row all are decided, from one of them on.
    pub(crate) fn decided(&self, from: usize, until: usize, applied: bool) -> usize {
        let until = until.min(self.len);
        let rows = self.open[usize::from(applied)].get(from..until);
        let open = rows.unwrap_or_default().iter().position(|open| *open != 0);
        open.map_or(until, |rows| from + rows)
    }

    /// The sums of rows that are decided.
    pub(crate) fn sums(&self, rows: &Range<usize>, applied: bool) -> Sums {
        let totals = match &self.whole {
            Some(totals) if *rows == (0..TILE) => *totals,
            _ => self.totals_of(rows),
        };
        let Totals {
            generated,
            more,
            taken,
            observed,
        } = totals;
        let more = if applied { more } else { [0, 0] };
        let generated = generated.map(|own| [own[0] + more[0], own[1] + more[1]]);
        let net = |generated: [i128; 2]| [taken[0] - generated[1], taken[1] - generated[0]];
        let [least_net, least_stored, least_observed, least_row] = self.least(rows, applied);
        Sums {
            sums: [
                generated[0],
                generated[1],
                taken,
                net(generated[0]),
                net(generated[1]),
            ],
            observed: observed[0] - more[1],
            least_net,
            least_stored,
            least_observed,
            least_row,
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

    /// Bounds from below, in units of the grid: see [`Sums`].
    fn least(&self, rows: &Range<usize>, applied: bool) -> [i128; 4] {
        // Each number is off by a few roundings of what it is made of, and rounded to the grid by a few units.
        const ROUNDING: f64 = 1.0 / (1_u64 << 42) as f64;
        const UNITS: f64 = 1.0 / (1_u64 << 50) as f64;
        let [mut net, mut observed, mut size] = [0.0; 3];
        let mut least = [f64::INFINITY; 4];
        for i in rows.clone() {
            let at = |column: &Column| (column.middles[i], column.radii[i]);
            let ((a, r), (b, s)) = (at(&self.taken[0]), at(&self.linear));
            let ((e, u), (g, v)) = (at(&self.observed), at(&self.potential));
            let (c, t) = if applied { at(&self.more) } else { (0.0, 0.0) };
            let more = c + t;
            let row = (a - r) - (b + s) - more;
            net += row;
            observed += (e - u) - more;
            let found = [net, net + (g - v), observed, row];
            for (least, found) in least.iter_mut().zip(found) {
                *least = if found < *least { found } else { *least };
            }
            size += a.abs() + b.abs() + c.abs() + e.abs() + g.abs() + (r + s + t + u + v);
        }
        let slack = size * ROUNDING + UNITS;
        least.map(|x| below(x - slack))
    }

    /// What a row answers.
    pub(crate) fn truths(&self, i: usize, applied: bool) -> Truths {
        let bits = self.truths[usize::from(applied)][i];
        let truth = |place: u32| Truth::over(bits >> place & 1 == 1, bits >> (place + 1) & 1 == 1);
        Truths {
            criterion_holds: truth(0),
            violates_linear: not(truth(2)),
            violates_quantized: not(truth(4)),
        }
    }

    /// How many of some rows, from the first one on, answer the same.
    pub(crate) fn alike(&self, rows: Range<usize>, applied: bool) -> usize {
        let rows = &self.truths[usize::from(applied)][rows];
        rows.iter()
            .take_while(|bits| rows.first() == Some(bits))
            .count()
    }

    /// What the observer adds for a row.
    pub(crate) fn observed(&self, i: usize, applied: bool) -> Option<i128> {
        let more = match applied {
            true => self.more.get(i).on_grid()?[1],
            false => 0,
        };
        Some(self.observed.get(i).on_grid()?[0] - more)
    }

    /// What a row adds.
    pub(crate) fn addend(&self, i: usize, applied: bool) -> Option<Addend> {
        let at = |column: &Column| column.get(i).on_grid();
        let known = Known {
            displacement: Ball::zero(),
            commanded: Ball::zero(),
            generated: [at(&self.linear)?, at(&self.quantized)?],
            observed: at(&self.observed)?,
            dissipated: [at(&self.taken[0])?, at(&self.taken[1])?],
            criterion_holds: self.truths(i, applied).criterion_holds,
            potential: at(&self.potential)?,
        };
        known.with_work(if applied { at(&self.more)? } else { [0, 0] })
    }
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
    const LANES: usize = 8;
    let mut sums = [[0_i64; LANES]; 4];
    for i in 0..TILE {
        let layers = Ball::from_parts(column.middles[i], column.radii[i]).layers();
        for (sums, layer) in sums.iter_mut().zip(layers) {
            // A tile of numbers below 2^50.
            sums[i % LANES] = sums[i % LANES].wrapping_add(layer);
        }
    }
    let [whole, upper, lower, radius] =
        sums.map(|lanes| lanes.into_iter().fold(0, i64::wrapping_add));
    let (middle, radius) = (on_grid([whole, upper, lower]), i128::from(radius));
    [middle - radius, middle + radius]
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn compute(tile: &mut Tile, wall: &Wall, of: &Intervals, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => tile.compute::<true, true>(wall, of),
        (true, false) => tile.compute::<true, false>(wall, of),
        (false, true) => tile.compute::<false, true>(wall, of),
        (false, false) => tile.compute::<false, false>(wall, of),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn totals(tile: &Tile) -> Totals {
    tile.totals()
}

/// The rows of a chunk, computed several at a time: [`TILE`] in each tile.
#[derive(Debug, Default)]
pub(crate) struct Tiles {
    pub(crate) tiles: Vec<Tile>,
    pub(crate) lengths: Vec<Length>,
}

impl Tiles {
    /// None of counts, and of loops that are no plain walls.
    pub(crate) fn of(task: &Task<'_>, chunk: &Chunk) -> Self {
        let (Some(wall), Samples::Any(samples)) = (Wall::of(task.ledger), &chunk.samples) else {
            return Self::default();
        };
        let intervals = samples.len().saturating_sub(1);
        let lengths = (0..intervals)
            .map(|i| periods(task.layout, chunk, i).map_or(Length::OPEN, |(n, d)| Length(n, d)));
        let lengths: Vec<Length> = lengths.collect();
        let forces = task.applied.then_some(&chunk.forces.values);
        let mut tiles = vec![Tile::new(); lengths.len().div_ceil(TILE)];
        let mut of = Intervals::new();
        let starts = (0..).step_by(TILE);
        for ((tile, lengths), at) in tiles.iter_mut().zip(lengths.chunks(TILE)).zip(starts) {
            of.read(samples, forces, at, lengths);
            tile.fill(&wall, &of, task.applied);
        }
        Self { tiles, lengths }
    }
}

/// The force of the law from each sample of a chunk, near by, as far as that is known; nothing of loops that
/// are no plain walls.
pub(crate) fn commanded(ledger: &Ledger, chunk: &Chunk) -> Vec<f64> {
    match (Wall::of(ledger), &chunk.samples) {
        (Some(_), Samples::Any(samples)) => {
            let mut forces = vec![f64::NAN; samples.len()];
            held(&samples.near.middles, &samples.near.radii, &mut forces);
            forces
        }
        _ => Vec::new(),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn held(middles: &[f64], radii: &[f64], forces: &mut [f64]) {
    for ((middle, radius), force) in middles.iter().zip(radii).zip(forces) {
        let (held, radius) = quantizer::held_force(&Ball::from_parts(*middle, *radius)).parts();
        *force = if radius == 0.0 { held } else { f64::NAN };
    }
}

#[cfg(test)]
mod tests;
