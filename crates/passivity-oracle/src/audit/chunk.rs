//! A stretch of a trace, as read.

use crate::audit::error::TraceError;
use crate::ledger::Sample;
use crate::number::Number;

/// The samples of some consecutive rows, and what came with them.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    pub(crate) samples: Samples,
    /// One per sample, or none at all.
    pub(crate) times: Vec<Number>,
    /// Δτ of the interval that each row is, in a ledger.
    pub(crate) dtaus: Vec<Number>,
    /// Commanded force in KΔ, and how far off it may be written.
    pub(crate) forces: Vec<[f64; 2]>,
    /// Where the last row of a ledger ends.
    pub(crate) closing: Option<Sample>,
    /// Whether the last row, a whole one as it stands, lacks its line break.
    pub(crate) unended: bool,
    /// What is wrong with the row after the last sample.
    pub(crate) error: Option<TraceError>,
}

/// Positions, kept plain when they are counts.
#[derive(Debug)]
pub(crate) enum Samples {
    Counts(Vec<i64>),
    Any(Vec<Sample>),
}

impl Default for Samples {
    fn default() -> Self {
        Self::Any(Vec::new())
    }
}

impl Samples {
    pub(crate) const fn len(&self) -> usize {
        match self {
            Self::Counts(counts) => counts.len(),
            Self::Any(samples) => samples.len(),
        }
    }

    pub(crate) fn get(&self, i: usize) -> Option<Sample> {
        match self {
            Self::Counts(counts) => counts.get(i).map(|n| Sample::Count(*n)),
            Self::Any(samples) => samples.get(i).cloned(),
        }
    }

    /// The sample at `i` and up to `window` − 1 before it, the latest first.
    pub(crate) fn back_from(&self, i: usize, window: usize) -> Vec<Sample> {
        let from = (i + 1).saturating_sub(window);
        (from..=i).rev().filter_map(|i| self.get(i)).collect()
    }

    /// Keeps the first `len` samples.
    pub(crate) fn truncate(&mut self, len: usize) {
        match self {
            Self::Counts(counts) => counts.truncate(len),
            Self::Any(samples) => samples.truncate(len),
        }
    }
}
