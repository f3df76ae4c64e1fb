//! What was found in a stretch of a log as a file has it, and what two stretches give together.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use serde::{Deserialize, Serialize};

use crate::ledger::Ledger;
use crate::log::comparison::{Comparison, Unlike};
use crate::log::error::TraceError;
use crate::log::exact::ExactSum;
use crate::log::found::{Findings, ROWS_IN_REPORT};
use crate::log::held::Held;
use crate::log::saved::{SavedAccount, SavedInterval, SavedReading, counted, wrong};
use crate::log::ticks::Steps;
use crate::log::velocity::Velocities;
use crate::log::wraps::Wrapped;

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedAgreement {
    mismatches: [(u64, Option<u64>); 2],
    products: [Option<String>; 2],
    left_out: (u64, [Option<String>; 3]),
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedComparison {
    compared: u64,
    squares: Option<String>,
    roundings: Option<String>,
    lags: Vec<SavedAgreement>,
    acting: u64,
    edges: [u64; 2],
    unlike: Option<[String; 2]>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedVelocities {
    compared: u64,
    squares: Option<String>,
    spare: Option<String>,
    products: Vec<[Option<String>; 2]>,
    long: [Option<String>; 3],
}

fn exact_sum(text: &Option<String>) -> Result<ExactSum, TraceError> {
    ExactSum::from_text(text.as_deref()).ok_or_else(|| wrong("a sum that is no number"))
}

fn whole(text: &str) -> Result<i128, TraceError> {
    text.parse().map_err(|_| wrong("a sum that is no number"))
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedError {
    kind: String,
    row: Option<u64>,
    column: Option<String>,
    message: String,
}

impl SavedError {
    fn value(&self) -> Result<TraceError, TraceError> {
        Ok(TraceError {
            row: self.row,
            column: self.column.clone(),
            ..TraceError::new(kept(&self.kind)?, self.message.clone())
        })
    }
}

/// The kind of an error for as long as the program runs: there are few.
fn kept(kind: &str) -> Result<&'static str, TraceError> {
    static KINDS: Mutex<BTreeSet<&'static str>> = Mutex::new(BTreeSet::new());
    const MOST: usize = 100;
    let mut kinds = KINDS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = kinds.get(kind) {
        return Ok(known);
    }
    if kinds.len() >= MOST || kind.len() > MOST {
        return Err(wrong("a kind of error that there is not"));
    }
    let new: &'static str = Box::leak(kind.to_owned().into_boxed_str());
    kinds.insert(new);
    Ok(new)
}

/// What was found in a stretch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SavedFindings {
    account: SavedAccount,
    pub(crate) samples: u64,
    first: Option<SavedReading>,
    comparison: Option<SavedComparison>,
    velocities: Option<SavedVelocities>,
    wrapped: Wrapped,
    steps: Steps,
    /// All intervals, of a short stretch.
    head: Vec<SavedInterval>,
    error: Option<SavedError>,
    unended: bool,
}

impl SavedFindings {
    pub(crate) const fn intervals(&self) -> u64 {
        self.account.intervals
    }

    pub(crate) fn of(x: &Findings) -> Self {
        let head = match x.account.intervals > ROWS_IN_REPORT as u64 {
            true => Vec::new(),
            false => x.head.iter().map(SavedInterval::of).collect(),
        };
        Self {
            account: SavedAccount::of(&x.account),
            samples: x.samples,
            first: x.first.as_ref().map(SavedReading::of),
            comparison: x.comparison.as_ref().map(|found| SavedComparison {
                compared: found.compared,
                squares: found.squares.to_text(),
                roundings: found.roundings.to_text(),
                lags: found
                    .lags
                    .iter()
                    .map(|lag| SavedAgreement {
                        mismatches: lag.mismatches,
                        products: lag.products.each_ref().map(ExactSum::to_text),
                        left_out: (
                            lag.left_out.0,
                            lag.left_out.1.each_ref().map(ExactSum::to_text),
                        ),
                    })
                    .collect(),
                acting: found.unlike.acting,
                edges: found.unlike.edges,
                unlike: found
                    .unlike
                    .sums
                    .map(|sums| sums.map(|sum| sum.to_string())),
            }),
            velocities: x.velocities.as_ref().map(|found| SavedVelocities {
                compared: found.compared,
                squares: found.squares.to_text(),
                spare: found.spare.to_text(),
                products: found
                    .products
                    .iter()
                    .map(|sums| sums.each_ref().map(ExactSum::to_text))
                    .collect(),
                long: found.long.each_ref().map(ExactSum::to_text),
            }),
            wrapped: x.wrapped,
            steps: x.steps,
            head,
            error: x.error.as_ref().map(|error| SavedError {
                kind: error.kind.to_string(),
                row: error.row,
                column: error.column.clone(),
                message: error.message.clone(),
            }),
            unended: x.unended,
        }
    }

    pub(crate) fn value(&self, ledger: &Ledger) -> Result<Findings, TraceError> {
        let compared = self.comparison.iter().flat_map(|found| {
            let mismatches = found.lags.iter().flat_map(|lag| lag.mismatches);
            let counts = mismatches.flat_map(|(count, first)| [Some(count), first]);
            let left_out = found.lags.iter().map(|lag| lag.left_out.0);
            counts
                .flatten()
                .chain(left_out)
                .chain([found.compared, found.acting])
                .chain(found.edges)
        });
        counted(
            compared
                .chain([self.samples, self.steps.moves])
                .chain(self.wrapped.counts())
                .chain(self.velocities.iter().map(|found| found.compared))
                .chain(self.error.iter().filter_map(|error| error.row)),
        )?;
        let comparison = match &self.comparison {
            None => None,
            Some(saved) => {
                let mut found = Comparison::new(ledger);
                found.compared = saved.compared;
                found.squares = exact_sum(&saved.squares)?;
                found.roundings = exact_sum(&saved.roundings)?;
                found.unlike = Unlike {
                    acting: saved.acting,
                    edges: saved.edges,
                    sums: match &saved.unlike {
                        Some([forces, laws]) => Some([whole(forces)?, whole(laws)?]),
                        None => None,
                    },
                };
                if found.lags.len() != saved.lags.len() {
                    return Err(wrong("forces that are compared at other delays"));
                }
                for (lag, saved) in found.lags.iter_mut().zip(&saved.lags) {
                    let [mixed, own] = &saved.products;
                    lag.mismatches = saved.mismatches;
                    lag.products = [exact_sum(mixed)?, exact_sum(own)?];
                    let (rows, [squares, mixed, law]) = &saved.left_out;
                    let sums = [exact_sum(squares)?, exact_sum(mixed)?, exact_sum(law)?];
                    lag.left_out = (*rows, sums);
                }
                Some(found)
            }
        };
        let velocities = match &self.velocities {
            None => None,
            Some(saved) => {
                let mut found = Velocities::default();
                found.compared = saved.compared;
                found.squares = exact_sum(&saved.squares)?;
                found.spare = exact_sum(&saved.spare)?;
                if found.products.len() != saved.products.len() {
                    return Err(wrong("velocities that are compared at other delays"));
                }
                for (sums, [mixed, own]) in found.products.iter_mut().zip(&saved.products) {
                    *sums = [exact_sum(mixed)?, exact_sum(own)?];
                }
                for (sum, saved) in found.long.iter_mut().zip(&saved.long) {
                    *sum = exact_sum(saved)?;
                }
                Some(found)
            }
        };
        let head = self.head.iter().map(SavedInterval::value);
        Ok(Findings {
            account: self.account.value()?,
            samples: self.samples,
            first: self.first.as_ref().map(SavedReading::value).transpose()?,
            // A piece does not keep when its samples were taken.
            duration: None,
            comparison,
            velocities,
            wrapped: self.wrapped,
            steps: self.steps,
            // A log of which pieces are accounted for leaves out none.
            held: Held::default(),
            head: head.collect::<Result<_, _>>()?,
            error: self.error.as_ref().map(SavedError::value).transpose()?,
            unended: self.unended,
            // A piece is of one file.
            unended_rows: Vec::new(),
            file: None,
            before_file: 0,
        })
    }
}
