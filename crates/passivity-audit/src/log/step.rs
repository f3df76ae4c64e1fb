//! The intervals of a trace: their durations, and displacements that are too large to be a motion.

use super::chunk::{Chunk, Samples};
use super::computed::UNIT;
use super::error::TraceError;
use super::layout::Layout;
use super::numbers::Numbers;
use super::running::near_number;
use crate::ball::{is_exact_sum, over_power_of_two};
use crate::ledger::Logged;
use crate::number::{Number, power_of_ten};

/// A count that jumps by this much in one interval is no motion.
pub(crate) const MAX_JUMP: i64 = 1 << 31;

/// Δτ of the interval that starts at sample `i`, not in lowest terms; `None` when the trace does not say.
#[inline]
pub(crate) fn duration(
    layout: &Layout,
    chunk: &Chunk,
    i: usize,
) -> Result<Option<Number>, TraceError> {
    // Most logs of counts have no times, and cost no more than this question.
    if i + 1 < chunk.times.len()
        && let (Some(from), Some(to)) = (chunk.times.get(i), chunk.times.get(i + 1))
    {
        return between(layout, &from, &to).map(Some);
    }
    Ok(chunk.dtaus.get(i).cloned())
}

/// Δτ as a row of a ledger gives it.
pub(crate) fn above_zero(dtau: Number) -> Result<Number, TraceError> {
    match crate::number::is_positive(&dtau) {
        true => Ok(dtau),
        false => {
            let message = format!("expected a duration above zero, found {dtau}");
            Err(TraceError::new("time", message))
        }
    }
}

/// The error of a row of a ledger that does not go on from the row before it.
pub(crate) fn gap(layout: &Layout) -> TraceError {
    let message = "a row of a ledger starts where the row before it ends";
    TraceError::new("gap", message).column(layout.name(layout.position))
}

/// As [`duration`], as a fraction; `None` where that is too long, or for [`duration`] to refuse.
#[inline]
pub(crate) fn periods(layout: &Layout, chunk: &Chunk, i: usize) -> Option<(i64, i64)> {
    if let Numbers::Decimals(numerators, powers) = &chunk.times
        && let (Some([from, to]), Some([k, l])) = (numerators.get(i..i + 2), powers.get(i..i + 2))
        && k == l
    {
        return layout.periods(*from, *to, power_of_ten((*k).into())?);
    }
    if let Numbers::Doubles(times) = &chunk.times
        && let Some([from, to]) = times.get(i..i + 2)
        && let Some((n, d)) = difference_of_doubles(*from, *to)
    {
        return layout.periods(0, n, d);
    }
    match duration(layout, chunk, i).ok()?.unwrap_or(UNIT) {
        Number::Small(n, d) => Some((n, d)),
        Number::Tiny(..) | Number::Big(_) => None,
    }
}

/// The second double less the first one in lowest terms, where that is a double above zero and as short a fraction as
/// most are.
#[inline(always)]
fn difference_of_doubles(from: f64, to: f64) -> Option<(i64, i64)> {
    let difference = to - from;
    if !(difference > 0.0 && is_exact_sum(to, -from)) {
        return None;
    }
    let (digits, twos) = over_power_of_two(difference)?;
    let zeros = digits.trailing_zeros();
    let twos = twos.checked_sub(zeros)?;
    (twos < i64::BITS - 1).then(|| ((digits >> zeros).cast_signed(), 1 << twos))
}

/// Δτ between two times.
pub(crate) fn between(layout: &Layout, from: &Number, to: &Number) -> Result<Number, TraceError> {
    layout.duration(from, to).ok_or_else(|| {
        let hint = after_a_break(near_number(from), near_number(to));
        let message = format!("expected a time after {from}, found {to}{hint}");
        let error = TraceError::new("time", message);
        match layout.time {
            Some(column) => error.column(layout.name(column)),
            None => error,
        }
    })
}

/// What is wrong with a clock that stands still.
pub(super) const TOO_COARSE: &str = "a clock that stands still between two rows is too coarse: log a finer one, such as `micros()` for `millis()`";

/// What a clock that runs backward may have done: gone around, as `micros()` of an Arduino does, or started again.
fn after_a_break(from: f64, to: f64) -> String {
    const AROUND: f64 = 4_294_967_296.0;
    // Two minutes of microseconds: far more than a sampling period, and far less than the way around.
    const MOST: f64 = 1.2e8;
    let step = to + AROUND - from;
    let is_whole = from.fract() == 0.0 && to.fract() == 0.0;
    let says = match from > to && to >= 0.0 {
        _ if from == to => {
            return format!(
                " ({TOO_COARSE}, or leave it out of `--columns`, where all rows are taken to be one sampling period apart)"
            );
        }
        true if is_whole && from < AROUND && step < MOST => {
            " (a clock of 32 bits goes on from 4294967295 at 0: add 4294967296 to its times from this row on)"
        }
        true if 10.0 * to <= from => {
            " (if the recording starts again here, make what follows a log of its own)"
        }
        _ => "",
    };
    says.to_owned()
}

/// Refuses a step of counts that no device makes.
pub(super) fn jump(samples: &Samples, i: usize) -> Result<(), TraceError> {
    let Samples::Counts(counts) = samples else {
        return Ok(());
    };
    match counts.get(i).zip(counts.get(i + 1)) {
        Some((from, to)) => check_jump(*from, *to),
        None => Ok(()),
    }
}

/// Refuses a step that no device makes.
pub(crate) fn check_jump(from: i64, to: i64) -> Result<(), TraceError> {
    if from.abs_diff(to) < MAX_JUMP.unsigned_abs() {
        return Ok(());
    }
    let message = format!(
        "the count jumps from {from} to {to} in one interval: has a counter wrapped around?"
    );
    Err(TraceError::new("jump", message).column("count"))
}

/// The interval that starts at sample `i` of a chunk and lasts `dtau`, with up to `window` samples;
/// under the force of its row where `applied`. `None` when it does not end in the chunk.
pub(crate) fn interval(
    chunk: &Chunk,
    i: usize,
    window: usize,
    applied: bool,
    dtau: Number,
) -> Option<Logged> {
    let force = match applied {
        true => Some(chunk.forces.get(i)?),
        false => None,
    };
    Some(Logged {
        samples: chunk.samples.back_from(i, window),
        end: chunk.samples.get(i + 1)?,
        dtau,
        force,
    })
}

/// Why an interval has no row: no trace that was read leads there.
pub(crate) fn undefined() -> TraceError {
    TraceError::new("undefined", "the figures of this interval are not defined")
}
