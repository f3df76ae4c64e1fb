//! The result of a simulation: its end, its sums, and every interval.

use passivity_core::BigRational;

use crate::ledger::{Entry, Totals};
use crate::model::IntervalRow;
use crate::number::{Double, Enclosed};
use crate::outcome::{End, ExactOutcome, Outcome};

/// An interval of a run, in the numbers of the method.
#[derive(Clone, Debug)]
pub enum Line<'a> {
    /// Doubles.
    Double(&'a Entry),
    /// Rationals.
    Exact(&'a IntervalRow<BigRational>),
    /// Intervals of doubles.
    Enclosed(&'a IntervalRow<Enclosed<Double>>),
}

impl Line<'_> {
    /// The number of the interval.
    pub(crate) const fn interval(&self) -> u64 {
        match self {
            Self::Double(entry) => entry.h,
            Self::Exact(row) => row.h,
            Self::Enclosed(row) => row.h,
        }
    }

    /// The interval in doubles.
    #[must_use]
    pub fn entry(&self) -> Entry {
        match self {
            Self::Double(entry) => **entry,
            Self::Exact(row) => row.entry(),
            Self::Enclosed(row) => row.entry(),
        }
    }
}

/// The state at the end in the method's own numbers, where they say more than doubles.
#[derive(Clone, Debug, PartialEq)]
pub enum Detail {
    /// Doubles are all there is.
    None,
    /// ξ and ξ̇ in lowest terms.
    Exact([String; 2]),
    /// ξ and ξ̇ in decimal.
    Digits([String; 2]),
    /// Enclosures of ξ and ξ̇, and the bits of the numbers that decided.
    Enclosed {
        /// The enclosures of ξ and ξ̇.
        ends: [[f64; 2]; 2],
        /// 53 for doubles.
        bits: u32,
    },
}

/// What a simulation gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Simulated {
    /// The state at the end and the outcome.
    pub end: End,
    /// Sums over the run.
    pub totals: Totals,
    /// The state at the end in the method's own numbers.
    pub detail: Detail,
}

impl Simulated {
    /// The same, with an outcome that was certain earlier; why it has fewer intervals than were `asked` for
    /// is told.
    pub(crate) fn judged_as(mut self, mut outcome: Outcome, asked: u64) -> Self {
        let Self { end, .. } = &mut self;
        if end.intervals < asked {
            outcome.because += &format!(
                "; the motion is known up to interval {}: {}",
                end.intervals, end.outcome.because
            );
        }
        end.outcome = outcome;
        self
    }

    /// Whether the numbers could not tell how the motion goes on after its end.
    pub(crate) fn is_cut_short(&self) -> bool {
        let outcome = &self.end.outcome;
        outcome.exact == ExactOutcome::Undecided && outcome.at_interval.is_some()
    }
}

/// Who sees every interval of a run; saying `false` stops it.
pub type Each<'a> = &'a mut dyn FnMut(&Line<'_>) -> bool;
