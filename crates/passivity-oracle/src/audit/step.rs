//! How long the steps of a trace last, and which are too long to be a motion.

use super::chunk::{Chunk, Samples};
use super::error::TraceError;
use super::layout::Layout;
use crate::number::Number;

/// A count that jumps by this much in one interval is no motion.
pub(crate) const MAX_JUMP: i64 = 1 << 31;

/// Δτ of the interval that starts at sample `i`; `None` when the trace does not say.
pub(crate) fn duration(
    layout: &Layout,
    chunk: &Chunk,
    i: usize,
) -> Result<Option<Number>, TraceError> {
    if let Some((from, to)) = chunk.times.get(i).zip(chunk.times.get(i + 1)) {
        return between(layout, from, to).map(Some);
    }
    match chunk.dtaus.get(i) {
        Some(dtau) if !crate::number::is_positive(dtau) => {
            let message = "expected a duration above zero";
            Err(TraceError::new("time", message).column("dtau"))
        }
        dtau => Ok(dtau.cloned()),
    }
}

/// Δτ between two times.
pub(crate) fn between(layout: &Layout, from: &Number, to: &Number) -> Result<Number, TraceError> {
    layout.duration(from, to).ok_or_else(|| {
        let name = layout.time.map_or("", |column| layout.name(column));
        TraceError::new("time", format!("expected a time after {from}, found {to}")).column(name)
    })
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
