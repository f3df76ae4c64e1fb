//! Rows of one linear wall several at a time: the kernel's text on balls, without a branch on what they are,
//! so that processors compute several rows with each instruction.
//!
//! Each row is what [`Known`](crate::log::known::Known) makes of it, or of counts a [`Row`](crate::log::counted::Row) of its own, to the last bit:
//! one of positions of which not all is decided here is for the former.

#![expect(
    clippy::indexing_slicing,
    reason = "every index is that of a row of a tile, below the length of every column"
)]

use passivity_core::{Step, Truth};

pub(crate) use answers::{Answer, ByLaw, ManyByLaw, each_answer};
pub(crate) use compute::commanded;
pub(crate) use counted::Counted;
pub(crate) use lengths::Length;
pub(crate) use sums::{Asked, Courses, Sums, TileRows, Under};
pub(crate) use written::write;

use crate::ball::{Ball, Lane};
use crate::figure::not;
use crate::ledger::Truths;
use crate::log::chunk::{Chunk, Samples};
use crate::log::numbers::{Balls, Readings};
use crate::log::quick::Quick;
use crate::log::task::Task;
use crate::log::wall::Wall;
use exactly::{Counts, Exactly};
use sums::Totals;

/// How many rows are computed at once.
pub(crate) const TILE: usize = 64;

/// As many balls as there are rows.
#[derive(Clone, Debug)]
#[repr(C, align(64))] // columns start where lines of the cache do
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
    fn set<const BRANCHES: bool>(&mut self, i: usize, ball: Ball<BRANCHES>) {
        (self.middles[i], self.radii[i]) = ball.parts();
    }

    /// Takes the balls from `at` on, as many as there are and are asked for: how many that is.
    fn copy(&mut self, balls: &Balls, at: usize, most: usize) -> usize {
        balls.copy_to([&mut self.middles, &mut self.radii], at, most)
    }

    /// Makes all behind the first `len` zero.
    fn cut(&mut self, len: usize) {
        self.middles[len..].fill(0.0);
        self.radii[len..].fill(0.0);
    }
}

/// What is known of some consecutive intervals.
#[repr(C)] // columns first
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
#[repr(C)] // columns first
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

/// What a row answers, of what is at least, and at most, true of the criterion and of both accounts, as bits.
pub(crate) fn truths(bits: u64) -> Truths {
    let truth = |place: u32| Truth::over(bits >> place & 1 == 1, bits >> (place + 1) & 1 == 1);
    Truths {
        criterion_holds: truth(0),
        violates_linear: not(truth(2)),
        violates_quantized: not(truth(4)),
    }
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
        let most = lengths.len().min(TILE);
        let from_start = self.start.copy(&samples.near, at, most);
        let to_end = self.end.copy(&samples.near, at + 1, most);
        self.len = from_start.min(to_end);
        if let Some(forces) = forces {
            self.len = self.len.min(self.force.copy(&forces.near, at, most));
        }
        lengths::fill(&lengths[..self.len], &mut self.lasts);
        samples.written.mark_same(at, &mut self.still[..self.len]);
        // Nothing comes of nothing.
        for column in [&mut self.start, &mut self.end, &mut self.force] {
            column.cut(self.len);
        }
        self.lasts.cut(self.len);
        self.lasts.middles[self.len..].fill(1.0);
    }

    /// The same between counts, of which the ticks are told.
    fn read_counts(
        &mut self,
        counts: &[i64],
        forces: Option<&Readings>,
        at: usize,
        lengths: &[Length],
    ) {
        let pairs = counts.get(at..).unwrap_or_default().windows(2);
        self.len = 0;
        for ((pair, _), i) in pairs.zip(lengths).zip(0..TILE) {
            let [from, to] = pair else { break };
            self.start.set(i, Ball::whole(*from));
            self.end.set(i, Ball::whole(*to));
            self.len = i + 1;
        }
        lengths::fill(&lengths[..self.len], &mut self.lasts);
        if let Some(forces) = forces {
            self.len = self.len.min(self.force.copy(&forces.near, at, self.len));
        }
    }

    /// Where interval `i` starts and ends and how long it lasts, and its step.
    #[inline(always)]
    fn lanes(&self, i: usize) -> ([Lane; 3], Step<Lane>) {
        let [start, end, lasts] =
            [&self.start, &self.end, &self.lasts].map(|column| column.get(i).lane());
        // Of what stands still, any position that it may have stands for all.
        let step = match self.still[i] != 0 {
            true => Step::new(start.one_of(), start.one_of()),
            false => Step::new(start, end),
        };
        ([start, end, lasts], step)
    }
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

    /// Computes the rows of some intervals.
    fn fill(&mut self, wall: &Wall<false>, of: &Intervals, applied: bool) {
        match wall.reach {
            None => compute::compute(self, wall, of, applied),
            Some(_) => compute::compute_in_parts(self, wall, of),
        }
        self.len = of.len;
        let open = self.open.iter().flatten().fold(0, |all, open| all | open);
        self.whole = (self.len == TILE && open == 0).then(|| sums::totals(self));
    }

    /// Up to which row all are decided, from one of them on.
    pub(crate) fn decided(&self, from: usize, until: usize, applied: bool) -> usize {
        let until = until.min(self.len);
        if self.whole.is_some() {
            return until;
        }
        let rows = self.open[usize::from(applied)].get(from..until);
        let open = rows.unwrap_or_default().iter().position(|open| *open != 0);
        open.map_or(until, |rows| from + rows)
    }
}

/// The rows of a chunk, computed several at a time: [`TILE`] in each tile.
#[derive(Debug, Default)]
pub(crate) struct Tiles {
    pub(crate) tiles: Vec<Tile>,
    pub(crate) lengths: Vec<Length>,
    pub(crate) wall: Option<Wall<false>>,
    /// For counts.
    pub(crate) quick: Option<Quick>,
    /// For rows that are written.
    exactly: Option<Exactly>,
    exactly_counts: Option<Counts>,
}

impl Tiles {
    /// Computes those of a chunk, in the room of those before: none of counts, and of loops that are no plain
    /// walls.
    pub(crate) fn fill(&mut self, task: &Task<'_>, chunk: &Chunk) {
        self.quick = task.wall.as_ref().map(Quick::of);
        self.wall = task.wall.as_ref().map(Wall::lanes);
        let intervals = chunk.samples.len().saturating_sub(1);
        // Of counts without forces few are asked for, or by one account, unless rows are written.
        let is_written = task.rows.is_some() && !(chunk.times.is_empty() && chunk.dtaus.is_empty());
        let is_asked = matches!(chunk.samples, Samples::Any(_)) || task.applied || is_written;
        let is_asked = is_asked && self.wall.is_some();
        let lengths = if is_asked { intervals } else { 0 };
        self.lengths.resize(lengths, Length::OPEN);
        lengths::find(task.layout, chunk, &mut self.lengths);
        let (before, before_counts) = (self.exactly.take(), self.exactly_counts.take());
        if self.wall.is_some() && task.rows.is_some() {
            self.exactly = Exactly::find(task, chunk, &self.lengths, before);
            self.exactly_counts = Counts::find(task, chunk, &self.lengths, before_counts);
        }
        let (Some(wall), Samples::Any(samples)) = (&self.wall, &chunk.samples) else {
            self.tiles.clear();
            return;
        };
        let forces = task.applied.then_some(&chunk.forces.values);
        self.tiles.resize(intervals.div_ceil(TILE), Tile::new());
        let mut of = Intervals::new();
        let lengths = self.lengths.chunks(TILE);
        for ((tile, lengths), at) in self.tiles.iter_mut().zip(lengths).zip((0..).step_by(TILE)) {
            of.read(samples, forces, at, lengths);
            tile.fill(wall, &of, task.applied);
        }
    }
}

mod answers;
mod compute;
mod counted;
mod counted_sums;
mod crossed;
mod exactly;
mod least;
mod lengths;
mod sums;
#[cfg(test)]
mod tests;
mod written;
