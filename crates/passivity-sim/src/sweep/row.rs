//! The outcome of a point of a sweep.

use crate::error::SimError;
use crate::outcome::{End, ExactOutcome, PaperOutcome};

/// The outcome of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// By the paper's detector.
    pub paper: PaperOutcome,
    /// As far as it is certain.
    pub exact: ExactOutcome,
    /// The interval of rest or of certain growth.
    pub at_interval: Option<u64>,
    /// ξ at the end.
    pub xi: f64,
    /// ξ̇ at the end.
    pub velocity: f64,
    /// The first sample within rounding of an edge; files do not keep it.
    pub within_rounding_of_edge: Option<u64>,
}

impl Row {
    /// Whether the run ended before its outcome was certain.
    #[must_use]
    pub fn is_undecided(self) -> bool {
        self.exact == ExactOutcome::Undecided
    }

    /// What a file has of it.
    pub(super) fn as_in_file(self) -> Self {
        Self {
            within_rounding_of_edge: None,
            ..self
        }
    }

    pub(super) fn of(end: &End) -> Self {
        Self {
            paper: end.outcome.paper,
            exact: end.outcome.exact,
            at_interval: end.outcome.at_interval,
            xi: end.xi,
            velocity: end.velocity,
            within_rounding_of_edge: end.within_rounding_of_edge,
        }
    }
}

/// A row as a file has it, with its values of the grid's axes.
pub(super) type Found = ([f64; 3], Row);

/// Is given the rows of a file one after another, each with its number from 0, and may end the reading.
pub(super) type Each<'e> = &'e mut dyn FnMut(usize, Found) -> Result<(), SimError>;
