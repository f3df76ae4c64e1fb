//! Propagators that are computed once: the same slopes and durations come again and again.

use std::collections::HashMap;

use crate::propagator::{Propagator, range};

/// How long an interval is, in sampling periods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Duration {
    pub(crate) lo: f64,
    pub(crate) hi: f64,
    /// Which of the log's different durations it is.
    pub(crate) index: usize,
}

/// How many different durations have their propagators kept.
pub(crate) const KEPT: usize = 4096;

/// How many slopes λ have theirs kept.
const SLOPES: usize = 32;

/// The propagators of one log, by the slope and the duration.
#[derive(Debug, Default)]
pub(crate) struct Propagators {
    by_slope: HashMap<u64, Vec<Option<Propagator>>>,
}

impl Propagators {
    /// Those of a slope; the others are forgotten when there are too many.
    pub(crate) fn of_slope(&mut self, slope: f64) -> &mut Vec<Option<Propagator>> {
        if self.by_slope.len() >= SLOPES && !self.by_slope.contains_key(&slope.to_bits()) {
            self.by_slope.clear();
        }
        self.by_slope.entry(slope.to_bits()).or_default()
    }
}

/// The propagator of a slope over a duration, computed once where it is kept.
pub(crate) fn propagator(
    kept: &mut Vec<Option<Propagator>>,
    slope: f64,
    duration: &Duration,
) -> Propagator {
    let compute = || Propagator::new(&range(slope, slope), &range(duration.lo, duration.hi));
    if duration.index >= KEPT {
        return compute();
    }
    if kept.len() <= duration.index {
        kept.resize(duration.index + 1, None);
    }
    match kept.get_mut(duration.index) {
        Some(kept) => *kept.get_or_insert_with(compute),
        None => compute(),
    }
}
