//! What is asked of an identification.

use std::ops::RangeInclusive;

use crate::identified::IdentifyError;

/// What the inertia is taken to be.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Inertia {
    /// What the sketch says, over its tolerance; looked for where it says nothing.
    #[default]
    Sketch,
    /// Looked for, whatever the sketch says.
    Free,
}

/// What is known of the logs, and how much work a search may be.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// By how many ticks a count may be off to either side: count n says that the device is between n − e
    /// and n + 1 + e ticks.
    pub count_error: f64,
    /// By how much the force may be off to either side, in SI units (KΔ where the sketch is
    /// dimensionless).
    pub force_error: f64,
    /// By what share of itself every force may be off, all alike, as by the torque constant of the motor: from 0 to below 1;
    /// `None` where nobody says.
    pub scale_error: Option<f64>,
    /// What the inertia is taken to be.
    pub inertia: Inertia,
    /// How many sampling intervals of motion are computed at the most, in the search for the box.
    pub effort: u64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            count_error: 1.0,
            force_error: 0.0,
            scale_error: None,
            inertia: Inertia::Sketch,
            effort: 20_000_000,
        }
    }
}

impl Options {
    /// How much work may be asked for, in millions of intervals of motion.
    pub const MILLIONS: RangeInclusive<u64> = 1..=100_000;

    /// Refuses errors that are none.
    pub(crate) fn check(&self) -> Result<(), IdentifyError> {
        let is_error = |x: f64| x >= 0.0 && x.is_finite();
        let share = self.scale_error.unwrap_or(0.0);
        let all = [
            (
                "of a count",
                self.count_error,
                is_error(self.count_error),
                "a number of ticks, zero or above it",
            ),
            (
                "of the force",
                self.force_error,
                is_error(self.force_error),
                "a force, zero or above it",
            ),
            (
                "of the scale",
                share,
                is_error(share) && share < 1.0,
                "a share of the force, from 0 to below 1",
            ),
        ];
        match all.iter().find(|(_, _, is_error, _)| !is_error) {
            None => Ok(()),
            Some((of, found, _, expected)) => Err(IdentifyError::new(format!(
                "the error {of}: expected {expected}, found {found}"
            ))),
        }
    }

    /// How much work the search is, unless another bound is asked for: more for logs of many rows.
    #[must_use]
    pub fn effort_for(rows: usize) -> u64 {
        (rows as u64).max(20_000) * 1_000
    }
}
