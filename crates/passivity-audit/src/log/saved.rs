//! The account of a stretch of a log as a file has it: exactly, as text.

use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

use num_bigint::BigInt;
use passivity_core::{BigRational, Interval};
use serde::{Deserialize, Serialize};

use crate::ledger::{Ledger, Logged};
use crate::log::account::{Account, Place};
use crate::log::comparison::Comparison;
use crate::log::error::TraceError;
use crate::log::exact::ExactSum;
use crate::log::merge::{Findings, ROWS_IN_REPORT};
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::Supply;
use crate::log::timing::Timing;
use crate::log::velocity::Velocities;
use crate::number::Number;
use crate::reading::{Reading, Scaled};
use crate::run::{Tallies, Tally};
use crate::span::{Span, on_grid};
use crate::sum::FigureSum;

/// How wide the common denominator of all numbers of a log may be for sums of it to be exact however they
/// are grouped. The sums of an account round past twice that.
pub(crate) const MOST_BITS: u64 = crate::sum::MAX_DENOMINATOR_BITS_OF_LOG / 2;

/// A rational number as text, `3/8`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Ratio(String);

/// Why a file is not read.
pub(crate) fn wrong(what: &str) -> TraceError {
    TraceError::new("partial", format!("this is no partial account: {what}"))
}

impl Ratio {
    pub(crate) fn of(x: &BigRational) -> Self {
        Self(x.to_string())
    }

    fn value(&self) -> Result<BigRational, TraceError> {
        let refuse = || {
            wrong(&format!(
                "`{}` is no number",
                crate::log::error::shown(self.0.as_bytes())
            ))
        };
        let (n, d) = self.0.split_once('/').unwrap_or((&self.0, "1"));
        let whole = |text: &str| text.parse::<BigInt>().map_err(|_| refuse());
        let (n, d) = (whole(n)?, whole(d)?);
        match d.sign() {
            num_bigint::Sign::Plus => Ok(BigRational::new(n, d)),
            _ => Err(refuse()),
        }
    }

    fn number(&self) -> Result<Number, TraceError> {
        self.value().map(Number::from)
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum SavedReading {
    Exact(Ratio),
    Count(i64),
    /// As the log has it, and scaled.
    Within(Ratio, [Ratio; 2]),
}

impl SavedReading {
    fn of(x: &Reading) -> Self {
        match x {
            Reading::Exact(x) => Self::Exact(Ratio::of(&x.to_rational())),
            Reading::Count(n) => Self::Count(*n),
            Reading::Within(x) => {
                let ends = x.ends().map(|end| Ratio::of(&on_grid(end)));
                Self::Within(Ratio::of(&x.written().to_rational()), ends)
            }
        }
    }

    fn value(&self) -> Result<Reading, TraceError> {
        Ok(match self {
            Self::Exact(x) => Reading::Exact(x.number()?),
            Self::Count(n) => Reading::Count(*n),
            Self::Within(written, [lo, hi]) => {
                let range = Interval::new(lo.value()?, hi.value()?);
                let range = range.ok_or_else(|| wrong("an empty interval"))?;
                let span = Span::around(range.lo(), range.hi());
                let span = span.ok_or_else(|| wrong("an interval that is too large"))?;
                Reading::Within(Scaled::new(written.number()?, span))
            }
        })
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedInterval {
    samples: Vec<SavedReading>,
    end: SavedReading,
    dtau: Ratio,
    force: Option<SavedReading>,
}

impl SavedInterval {
    fn of(x: &Logged) -> Self {
        Self {
            samples: x.samples.iter().map(SavedReading::of).collect(),
            end: SavedReading::of(&x.end),
            dtau: Ratio::of(&x.dtau.to_rational()),
            force: x.force.as_ref().map(SavedReading::of),
        }
    }

    fn value(&self) -> Result<Logged, TraceError> {
        let samples = self.samples.iter().map(SavedReading::value);
        Ok(Logged {
            samples: samples.collect::<Result<_, _>>()?,
            end: self.end.value()?,
            dtau: self.dtau.number()?,
            force: self.force.as_ref().map(SavedReading::value).transpose()?,
        })
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedPlace {
    h: u64,
    interval: SavedInterval,
}

impl SavedPlace {
    fn of(x: &Place) -> Self {
        Self {
            h: x.h,
            interval: SavedInterval::of(&x.interval),
        }
    }

    fn value(&self) -> Result<Place, TraceError> {
        Ok(Place {
            h: self.h,
            interval: self.interval.value()?,
        })
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedSum {
    lo: Ratio,
    hi: Option<Ratio>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedRunning {
    total: Ratio,
    least: Ratio,
    at: u64,
    steps: u64,
}

impl SavedRunning {
    fn of(x: &RunningSum) -> Self {
        let (least, at) = x.least();
        Self {
            total: Ratio::of(&x.total()),
            least: Ratio::of(&least),
            at,
            steps: x.steps(),
        }
    }

    fn value(&self) -> Result<RunningSum, TraceError> {
        let least = (self.least.value()?, self.at);
        Ok(RunningSum::from_parts(
            &self.total.value()?,
            least,
            self.steps,
        ))
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedLowest {
    value: Ratio,
    h: u64,
}

impl SavedLowest {
    fn of(x: &Lowest) -> Self {
        Self {
            value: Ratio::of(&x.value),
            h: x.h,
        }
    }

    fn value(&self) -> Result<Lowest, TraceError> {
        Ok(Lowest::new(self.value.value()?, self.h))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct SavedTally {
    holds: u64,
    fails: u64,
    depends: u64,
    first: [Option<u64>; 3],
}

impl SavedTally {
    const fn of(x: &Tally) -> Self {
        Self {
            holds: x.holds,
            fails: x.fails,
            depends: x.depends,
            first: [x.first_holds, x.first_fails, x.first_depends],
        }
    }

    const fn value(self) -> Tally {
        let [first_holds, first_fails, first_depends] = self.first;
        Tally {
            holds: self.holds,
            fails: self.fails,
            depends: self.depends,
            first_holds,
            first_fails,
            first_depends,
        }
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedTiming {
    uneven: u64,
    late: u64,
    missed: u64,
    first_missed: Option<u64>,
    range: Option<[Ratio; 2]>,
}

/// An [`Account`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedAccount {
    intervals: u64,
    sums: [SavedSum; 5],
    last: Option<SavedInterval>,
    tallies: [SavedTally; 3],
    net: SavedRunning,
    observer: SavedRunning,
    stored: Option<SavedLowest>,
    supply: [SavedRunning; 2],
    lowest: [Option<SavedLowest>; 2],
    worst: Option<(Ratio, SavedPlace)>,
    firsts: [Option<SavedPlace>; 5],
    timing: SavedTiming,
}

impl SavedAccount {
    fn of(x: &Account) -> Self {
        let tallies = [
            &x.tallies.criterion,
            &x.tallies.linear,
            &x.tallies.quantized,
        ];
        Self {
            intervals: x.intervals,
            sums: x.sums.each_ref().map(|sum| {
                let (lo, hi) = sum.ends();
                SavedSum {
                    lo: Ratio::of(&lo),
                    hi: hi.as_ref().map(Ratio::of),
                }
            }),
            last: x.last.as_ref().map(SavedInterval::of),
            tallies: tallies.map(SavedTally::of),
            net: SavedRunning::of(&x.net),
            observer: SavedRunning::of(&x.observer),
            stored: x.stored.as_ref().map(SavedLowest::of),
            supply: x.supply.sums().each_ref().map(SavedRunning::of),
            lowest: x.supply.lowest().map(|lowest| lowest.map(SavedLowest::of)),
            worst: x
                .worst
                .as_ref()
                .map(|(net, place)| (Ratio::of(net), SavedPlace::of(place))),
            firsts: x
                .firsts
                .each_ref()
                .map(|first| first.as_ref().map(SavedPlace::of)),
            timing: SavedTiming {
                uneven: x.timing.uneven,
                late: x.timing.late,
                missed: x.timing.missed,
                first_missed: x.timing.first_missed,
                range: x
                    .timing
                    .range
                    .as_ref()
                    .map(|range| range.each_ref().map(|dtau| Ratio::of(&dtau.to_rational()))),
            },
        }
    }

    fn value(&self) -> Result<Account, TraceError> {
        fn maybe<S, T>(
            saved: Option<&S>,
            value: impl Fn(&S) -> Result<T, TraceError>,
        ) -> Result<Option<T>, TraceError> {
            saved.map(value).transpose()
        }
        let mut sums: [FigureSum; 5] = Default::default();
        for (sum, saved) in sums.iter_mut().zip(&self.sums) {
            *sum = FigureSum::from_ends(
                &saved.lo.value()?,
                maybe(saved.hi.as_ref(), Ratio::value)?.as_ref(),
            );
        }
        let mut firsts: [Option<Place>; 5] = Default::default();
        for (first, saved) in firsts.iter_mut().zip(&self.firsts) {
            *first = maybe(saved.as_ref(), SavedPlace::value)?;
        }
        let [least, most] = &self.supply;
        let [low, high] = &self.lowest;
        let lowest = |saved: &Option<SavedLowest>| maybe(saved.as_ref(), SavedLowest::value);
        let [criterion, linear, quantized] = self.tallies.map(SavedTally::value);
        let range = maybe(self.timing.range.as_ref(), |[shortest, longest]| {
            Ok([shortest.number()?, longest.number()?])
        })?;
        Ok(Account {
            intervals: self.intervals,
            sums,
            last: maybe(self.last.as_ref(), SavedInterval::value)?,
            tallies: Tallies {
                criterion,
                linear,
                quantized,
            },
            net: self.net.value()?,
            observer: self.observer.value()?,
            stored: lowest(&self.stored)?,
            supply: Supply::from_parts(
                [least.value()?, most.value()?],
                [lowest(low)?, lowest(high)?],
            ),
            worst: maybe(self.worst.as_ref(), |(net, place)| {
                Ok((net.value()?, place.value()?))
            })?,
            firsts,
            timing: Timing {
                uneven: self.timing.uneven,
                late: self.timing.late,
                missed: self.timing.missed,
                first_missed: self.timing.first_missed,
                range,
            },
            rows: Vec::new(),
            points: Vec::new(),
        })
    }
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedAgreement {
    mismatches: [(u64, Option<u64>); 2],
    products: [Option<String>; 2],
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedComparison {
    compared: u64,
    squares: Option<String>,
    lags: Vec<SavedAgreement>,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedVelocities {
    compared: u64,
    squares: Option<String>,
    products: Vec<[Option<String>; 2]>,
}

fn exact_sum(text: &Option<String>) -> Result<ExactSum, TraceError> {
    ExactSum::from_text(text.as_deref()).ok_or_else(|| wrong("a sum that is no number"))
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
    /// All intervals, of a short stretch.
    head: Vec<SavedInterval>,
    error: Option<SavedError>,
    unended: bool,
    /// A denominator of all that was summed, and not only of the sums.
    denominator: Ratio,
}

impl SavedFindings {
    pub(crate) const fn intervals(&self) -> u64 {
        self.account.intervals
    }

    pub(crate) fn of(x: &Findings<'_>) -> Self {
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
                lags: found
                    .lags
                    .iter()
                    .map(|lag| SavedAgreement {
                        mismatches: lag.mismatches,
                        products: lag.products.each_ref().map(ExactSum::to_text),
                    })
                    .collect(),
            }),
            velocities: x.velocities.as_ref().map(|found| SavedVelocities {
                compared: found.compared,
                squares: found.squares.to_text(),
                products: found
                    .products
                    .iter()
                    .map(|sums| sums.each_ref().map(ExactSum::to_text))
                    .collect(),
            }),
            head,
            error: x.error.as_ref().map(|error| SavedError {
                kind: error.kind.to_string(),
                row: error.row,
                column: error.column.clone(),
                message: error.message.clone(),
            }),
            unended: x.unended,
            denominator: Ratio::of(&BigRational::from_integer(x.denominator())),
        }
    }

    /// A denominator of all that was summed.
    pub(crate) fn denominator(&self) -> Result<BigInt, TraceError> {
        self.denominator.value().map(|x| x.to_integer())
    }

    pub(crate) fn value<'a>(&self, ledger: &'a Ledger) -> Result<Findings<'a>, TraceError> {
        let comparison = match &self.comparison {
            None => None,
            Some(saved) => {
                let mut found = Comparison::new(ledger);
                found.compared = saved.compared;
                found.squares = exact_sum(&saved.squares)?;
                if found.lags.len() != saved.lags.len() {
                    return Err(wrong("forces that are compared at other delays"));
                }
                for (lag, saved) in found.lags.iter_mut().zip(&saved.lags) {
                    let [mixed, own] = &saved.products;
                    lag.mismatches = saved.mismatches;
                    lag.products = [exact_sum(mixed)?, exact_sum(own)?];
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
                if found.products.len() != saved.products.len() {
                    return Err(wrong("velocities that are compared at other delays"));
                }
                for (sums, [mixed, own]) in found.products.iter_mut().zip(&saved.products) {
                    *sums = [exact_sum(mixed)?, exact_sum(own)?];
                }
                Some(found)
            }
        };
        let head = self.head.iter().map(SavedInterval::value);
        Ok(Findings {
            account: self.account.value()?,
            samples: self.samples,
            first: self.first.as_ref().map(SavedReading::value).transpose()?,
            comparison,
            velocities,
            head: head.collect::<Result<_, _>>()?,
            error: self.error.as_ref().map(SavedError::value).transpose()?,
            unended: self.unended,
            file: None,
            before_file: 0,
        })
    }
}

impl Findings<'_> {
    /// Goes on with what was found in the stretch that follows.
    pub(crate) fn append(&mut self, next: Self) {
        let before = self.samples;
        if self.account.intervals + next.account.intervals <= ROWS_IN_REPORT as u64 {
            self.head.extend(next.head);
        }
        self.account.append(next.account);
        self.samples += next.samples;
        self.first = self.first.take().or(next.first);
        if let (Some(own), Some(next)) = (&mut self.comparison, &next.comparison) {
            own.append(next);
        }
        if let (Some(own), Some(next)) = (&mut self.velocities, &next.velocities) {
            own.append(next);
        }
        self.error = next.error.map(|error| TraceError {
            row: error.row.map(|row| before + row),
            ..error
        });
        self.unended |= next.unended;
    }

    /// The common denominator of the sums.
    pub(crate) fn denominator(&self) -> BigInt {
        let account = &self.account;
        let figures = account.sums.iter().map(FigureSum::denominator);
        let running = [&account.net, &account.observer]
            .into_iter()
            .chain(account.supply.sums())
            .map(RunningSum::common);
        let all = figures.chain(running);
        all.fold(BigInt::from(1), num_integer::lcm)
    }

    /// Whether a sum was rounded.
    pub(crate) fn is_rounded(&self) -> bool {
        self.account.sums.iter().any(FigureSum::is_rounded)
    }
}
