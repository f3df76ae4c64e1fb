//! A part of a trace, as it was read.

use crate::log::error::TraceError;
use crate::log::source::Place;
use crate::number::Number;
use crate::reading::Reading;

/// The samples of some consecutive rows, and what came with them.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    pub(crate) samples: Samples,
    /// One per sample, or none at all.
    pub(crate) times: Vec<Number>,
    /// Δτ of the interval that each row is, in a ledger.
    pub(crate) dtaus: Vec<Number>,
    /// One per sample, or none at all.
    pub(crate) forces: Vec<Force>,
    /// In ticks per sampling period; one per sample, or none at all.
    pub(crate) velocities: Vec<f64>,
    /// Where in the log it is.
    pub(crate) place: Place,
    /// Where the last row of a ledger ends.
    pub(crate) closing: Option<Reading>,
    /// Whether the last row, a whole one as it stands, lacks its line break.
    pub(crate) unended: bool,
    /// What is wrong with the row after the last sample.
    pub(crate) error: Option<TraceError>,
}

/// A commanded force.
#[derive(Clone, Debug)]
pub(crate) struct Force {
    /// In KΔ, as it is written.
    pub(crate) value: Reading,
    /// Half a unit of its last digit, in KΔ: how far off what was commanded may have been rounded.
    pub(crate) rounding: f64,
}

/// Positions, kept plain when they are counts.
#[derive(Debug)]
pub(crate) enum Samples {
    Counts(Vec<i64>),
    Any(Vec<Reading>),
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

    pub(crate) fn get(&self, i: usize) -> Option<Reading> {
        match self {
            Self::Counts(counts) => counts.get(i).map(|n| Reading::Count(*n)),
            Self::Any(samples) => samples.get(i).cloned(),
        }
    }

    /// The sample at `i` and up to `window` − 1 before it, the latest first.
    pub(crate) fn back_from(&self, i: usize, window: usize) -> Vec<Reading> {
        let from = (i + 1).saturating_sub(window);
        (from..=i).rev().filter_map(|i| self.get(i)).collect()
    }
}

impl Chunk {
    /// Keeps the first `len` rows.
    pub(crate) fn truncate(&mut self, len: usize) {
        match &mut self.samples {
            Samples::Counts(counts) => counts.truncate(len),
            Samples::Any(samples) => samples.truncate(len),
        }
        self.times.truncate(len);
        self.dtaus.truncate(len);
        self.forces.truncate(len);
        self.velocities.truncate(len);
    }

    /// Ends the chunk with the sample at `i`, for the row after it is wrong.
    pub(crate) fn cut(&mut self, i: usize, error: TraceError) {
        let len = i + 1;
        self.truncate(len);
        self.closing = None;
        self.error = Some(error.row(len as u64));
    }
}
