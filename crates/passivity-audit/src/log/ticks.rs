//! Positions in units of length or angle that are whole ticks apart, as they are where a controller writes down what its
//! encoder counted, times the tick: each stands for a position anywhere within its tick, not for a true one.
//!
//! Taken for true positions they say nothing of how far within its tick the device was, which is what quantization costs: of
//! the middles of ticks none of the Coulomb friction ½KΔ that it asks for is left.
//!
//! - A step is by whole ticks if the position stays as it is or moves by a number of ticks that is at most 1/8 off a whole one,
//!   above zero. That is room for positions with few digits, which are off by half of the last one at either end of a step,
//!   and for single precision up to 2²⁰ ticks.
//! - True positions move by any part of a tick, or by multiples of the last digit that they are rounded to. Of the former a
//!   quarter is as near to whole ticks, and of the latter 3 of 10 with a digit of a tenth of a tick. So [`MANY`] steps that all
//!   are by whole ticks are by chance in one log of 10¹⁶ at the most.

use multiversion::multiversion;
use passivity_scene::display::figures;
use serde::{Deserialize, Serialize};

use crate::log::chunk::{Chunk, Samples};
use crate::log::findings::Finding;
use crate::log::layout::{Form, Layout};
use crate::log::task::Task;

/// How far off a whole number of ticks a step may be.
const OFF: f64 = 1.0 / 8.0;

/// So many steps tell that positions are whole ticks apart.
const MANY: u64 = 32;

/// What the steps of a log are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Steps {
    /// How many are by a tick or more, as far as that matters.
    pub(crate) moves: u64,
    /// Whether some step is not by whole ticks.
    is_off: bool,
}

/// The steps of a log, as its chunks come.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ticks {
    latest: Option<f64>,
    pub(crate) found: Steps,
}

impl Ticks {
    /// `None` where there are no ticks, or positions are given in them.
    pub(crate) fn new(task: &Task<'_>) -> Option<Self> {
        let is_apart = task.layout.form == Form::X && task.periods.counts;
        (is_apart && task.compares).then(Self::default)
    }

    /// Looks at the steps to the first `rows` samples of a chunk.
    pub(crate) fn feed(&mut self, chunk: &Chunk, rows: usize) {
        // Nearly all logs of true positions are told from their first rows.
        let (false, Samples::Any(samples)) = (self.found.is_off, &chunk.samples) else {
            return;
        };
        let positions = samples.near.middles.get(..rows).unwrap_or_default();
        if let (Some(latest), Some(first)) = (self.latest, positions.first()) {
            self.found.append(of_steps(&[latest, *first]));
        }
        self.found.append(of_steps(positions));
        self.latest = positions.last().copied().or(self.latest);
    }

    /// Forgets what was found, not what came before.
    pub(crate) fn forget(&mut self) {
        self.found = Steps::default();
    }
}

/// What the steps between these positions are.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn of_steps(positions: &[f64]) -> Steps {
    let (mut moves, mut is_off) = (0_u64, false);
    for (from, to) in positions.iter().zip(positions.get(1..).unwrap_or_default()) {
        let size = (to - from).abs();
        let whole = size.round_ties_even();
        let is_whole = whole >= 1.0 && (size - whole).abs() <= OFF;
        // What is no number is no step by whole ticks.
        is_off |= !(size == 0.0 || is_whole);
        moves = moves.wrapping_add(u64::from(is_whole));
    }
    Steps { moves, is_off }
}

impl Steps {
    /// Goes on with the steps that follow.
    pub(crate) fn append(&mut self, next: Self) {
        self.is_off |= next.is_off;
        self.moves = match self.is_off {
            true => 0,
            false => self.moves + next.moves,
        };
    }

    /// What is said of positions that are whole ticks apart.
    pub(crate) fn finding(self, layout: &Layout) -> Option<Finding> {
        if self.is_off || self.moves < MANY {
            return None;
        }
        let column = layout.name(layout.position);
        let tick = figures(1.0 / layout.scale().size(), 6);
        Some(Finding {
            kind: "counted_positions",
            says: format!(
                "all positions are whole ticks of the scene's encoder apart, as what it counts is: the device may have been \
                 anywhere within these ticks, but `{column}` is taken for where it was"
            ),
            fix: format!(
                "log what the encoder counted, in a column `count`: whole numbers, of which one more is {tick} more in `{column}`"
            ),
        })
    }
}
