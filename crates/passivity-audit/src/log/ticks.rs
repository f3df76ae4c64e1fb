//! Positions in units of length or angle that are whole ticks apart, as they are where a controller writes down what its
//! encoder counted, times the tick: each stands for a position anywhere within its tick, not for a true one.
//!
//! Taken for true positions they say nothing of how far within its tick the device was, which is what quantization costs: of
//! the middles of ticks none of the Coulomb friction ½KΔ that it asks for is left.
//!
//! - A step is by whole ticks if the position stays as it is or moves by a number of ticks that is at most 1/8 off a whole one,
//!   above zero. That is room for positions with few digits, which are off by half of the last one at either end of a step,
//!   and for single precision up to 2²⁰ ticks.
//! - One step in [`PER_OFF`] may be another, and [`FEW`] in all, as those from a row of zeros before the first reading.
//! - True positions move by any part of a tick, or by multiples of the last digit that they are rounded to. Of the former a
//!   quarter is as near to whole ticks, and of the latter 3 of 10 with a digit of a tenth of a tick. So [`MANY`] steps that all
//!   are by whole ticks are by chance in one log of 10¹⁶ at the most. With k others, k from 1 to 8, there are 256 k by whole
//!   ticks, and at most (257 k)ᵏ choices of the others: less than one log in 10¹³⁰.
//! - Where the last digit is a multiple of the tick, all true positions are whole ticks apart by their digits. So steps with
//!   a common divisor above one tick tell nothing, nor do decimals, where a text shows them, that end at about a tick or above.

use multiversion::multiversion;
use num_integer::Integer as _;
use num_traits::ToPrimitive as _;
use passivity_scene::display::figures;
use serde::{Deserialize, Serialize};

use crate::log::chunk::{Chunk, Samples};
use crate::log::digits::half_a_unit;
use crate::log::findings::Finding;
use crate::log::layout::{Form, Layout};
use crate::log::numbers::Numbers;
use crate::log::task::Task;

/// How far off a whole number of ticks a step may be.
const OFF: f64 = 1.0 / 8.0;

/// So many steps tell that positions are whole ticks apart.
const MANY: u64 = 32;

/// Of so many steps by whole ticks one other is let pass.
const PER_OFF: u64 = 256;

/// The most others in a log.
const FEW: u64 = 8;

/// The decimals of numbers that are none, as doubles are.
const UNKNOWN: u8 = u8::MAX;

/// What the steps of a log are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Steps {
    /// How many are by a tick or more, as far as that matters.
    pub(crate) moves: u64,
    /// How many are not by whole ticks: more than [`FEW`] are as many as one likes.
    off: u64,
    /// The greatest common divisor of the others in ticks; 0 where the position stays as it is.
    divisor: u64,
    /// The most decimals of a position.
    decimals: u8,
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
        let (false, Samples::Any(samples)) = (self.found.is_other(), &chunk.samples) else {
            return;
        };
        let positions = samples.near.middles.get(..rows).unwrap_or_default();
        if let (Some(latest), Some(first)) = (self.latest, positions.first()) {
            self.found.append(Steps::of(&[latest, *first]));
        }
        self.found.append(Steps::of(positions));
        self.found.decimals = self.found.decimals.max(match &samples.written {
            Numbers::Decimals(_, decimals) => decimals.iter().take(rows).max().map_or(0, |k| *k),
            Numbers::Doubles(_) | Numbers::Any(_) => UNKNOWN,
        });
        self.latest = positions.last().copied().or(self.latest);
    }

    /// Forgets what was found, not what came before.
    pub(crate) fn forget(&mut self) {
        self.found = Steps::default();
    }
}

/// By how many ticks a position moves, if by whole ones.
#[inline(always)]
fn whole(from: f64, to: f64) -> Option<f64> {
    let size = (to - from).abs();
    let whole = size.round_ties_even();
    (whole >= 1.0 && (size - whole).abs() <= OFF).then_some(whole)
}

/// How many of the steps between these positions are by whole ticks, and how many by others.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn count(positions: &[f64]) -> [u64; 2] {
    let (mut moves, mut off) = (0_u64, 0_u64);
    for (from, to) in positions.iter().zip(positions.get(1..).unwrap_or_default()) {
        let is_whole = whole(*from, *to).is_some();
        moves = moves.wrapping_add(u64::from(is_whole));
        // What is no number is no step by whole ticks.
        off = off.wrapping_add(u64::from(!(is_whole || from == to)));
    }
    [moves, off]
}

/// The greatest common divisor of the whole steps between these positions; looks no further once that is 1.
fn divisor(positions: &[f64]) -> u64 {
    let pairs = positions.iter().zip(positions.get(1..).unwrap_or_default());
    let mut divisor = 0;
    for step in pairs.filter_map(|(from, to)| whole(*from, *to)) {
        if divisor == 1 {
            break;
        }
        // Of steps that no integer holds nothing is known.
        divisor = step.to_u64().map_or(1, |step| divisor.gcd(&step));
    }
    divisor
}

impl Steps {
    /// What the steps between these positions are.
    fn of(positions: &[f64]) -> Self {
        let [moves, off] = count(positions);
        let mut steps = Self {
            moves,
            off,
            ..Self::default()
        };
        if moves > 0 && !steps.is_other() {
            steps.divisor = divisor(positions);
        }
        steps
    }

    /// Whether so many are not by whole ticks that no more matter.
    const fn is_other(&self) -> bool {
        self.off > FEW
    }

    /// Goes on with the steps that follow.
    pub(crate) fn append(&mut self, next: Self) {
        *self = Self {
            moves: self.moves + next.moves,
            off: self.off.saturating_add(next.off),
            divisor: self.divisor.gcd(&next.divisor),
            decimals: self.decimals.max(next.decimals),
        };
        if self.is_other() {
            *self = Self {
                off: FEW + 1,
                ..Self::default()
            };
        }
    }

    /// Whether positions are whole ticks apart by their digits alone.
    fn is_by_digits(self, layout: &Layout) -> bool {
        let digit = 2.0 * half_a_unit(self.decimals.into()) * layout.scale().size();
        self.divisor > 1 || (self.decimals != UNKNOWN && digit >= 1.0 - OFF)
    }

    /// What is said of positions that are whole ticks apart.
    pub(crate) fn finding(self, layout: &Layout) -> Option<Finding> {
        let is_counted = self.moves >= MANY.max(PER_OFF * self.off) && !self.is_other();
        if !is_counted || self.is_by_digits(layout) {
            return None;
        }
        let but = match self.off {
            0 => String::new(),
            1 => "but for one step ".to_owned(),
            off => format!("but for {off} steps "),
        };
        let column = layout.name(layout.position);
        let tick = figures(1.0 / layout.scale().size(), 6);
        Some(Finding {
            kind: "counted_positions",
            says: format!(
                "{but}all positions are whole ticks of the scene's encoder apart, as what it counts is: the device may have been \
                 anywhere within these ticks, but `{column}` is taken for where it was"
            ),
            fix: format!(
                "log what the encoder counted, in a column `count`: whole numbers, of which one more is {tick} more in `{column}`"
            ),
        })
    }
}
