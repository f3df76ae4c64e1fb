//! The account of a stretch of a log as a file has it: exactly, as text.

use num_bigint::BigInt;
use passivity_core::{BigRational, Interval};
use serde::{Deserialize, Serialize};

use crate::ledger::Logged;
use crate::log::account::{Account, Place};
use crate::log::error::TraceError;
use crate::log::running::{Lowest, RunningSum};
use crate::log::supply::Supply;
use crate::log::timing::Timing;
use crate::number::Number;
use crate::reading::{Reading, Scaled};
use crate::run::{Tallies, Tally};
use crate::span::{Span, on_grid};
use crate::sum::FigureSum;

/// A rational number as text, `3/8`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Ratio(String);

/// The most samples or intervals of a piece: many more than any file holds, and few enough to be added up.
const MOST: u64 = 1 << 48;

/// Refuses numbers of samples or intervals that no log has.
pub(crate) fn counted(counts: impl IntoIterator<Item = u64>) -> Result<(), TraceError> {
    match counts.into_iter().all(|count| count <= MOST) {
        true => Ok(()),
        false => Err(wrong("it counts more than a log can hold")),
    }
}

/// Why a file is not read.
pub(crate) fn wrong(what: &str) -> TraceError {
    TraceError::new("partial", format!("this is no partial account: {what}"))
}

impl Ratio {
    pub(crate) fn of(x: &BigRational) -> Self {
        Self(x.to_string())
    }

    pub(crate) fn value(&self) -> Result<BigRational, TraceError> {
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
pub(crate) enum SavedReading {
    Exact(Ratio),
    Count(i64),
    /// As the log has it, and scaled.
    Within(Ratio, [Ratio; 2]),
}

impl SavedReading {
    pub(crate) fn of(x: &Reading) -> Self {
        match x {
            Reading::Exact(x) => Self::Exact(Ratio::of(&x.to_rational())),
            Reading::Count(n) => Self::Count(*n),
            Reading::Within(x) => {
                let ends = x.ends().map(|end| Ratio::of(&on_grid(end)));
                Self::Within(Ratio::of(&x.written().to_rational()), ends)
            }
        }
    }

    pub(crate) fn value(&self) -> Result<Reading, TraceError> {
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
pub(crate) struct SavedInterval {
    samples: Vec<SavedReading>,
    end: SavedReading,
    dtau: Ratio,
    force: Option<SavedReading>,
}

impl SavedInterval {
    pub(crate) fn of(x: &Logged) -> Self {
        Self {
            samples: x.samples.iter().map(SavedReading::of).collect(),
            end: SavedReading::of(&x.end),
            dtau: Ratio::of(&x.dtau.to_rational()),
            force: x.force.as_ref().map(SavedReading::of),
        }
    }

    pub(crate) fn value(&self) -> Result<Logged, TraceError> {
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
            self.total.value()?,
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
            value: Ratio::of(&x.value()),
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
    gaps: u64,
    first_missed: Option<u64>,
    range: Option<[Ratio; 2]>,
    short: [u64; 2],
}

/// An [`Account`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SavedAccount {
    pub(crate) intervals: u64,
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
    pub(crate) fn of(x: &Account) -> Self {
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
                gaps: x.timing.gaps,
                first_missed: x.timing.first_missed,
                range: x
                    .timing
                    .range
                    .as_ref()
                    .map(|range| range.each_ref().map(|dtau| Ratio::of(&dtau.to_rational()))),
                short: x.timing.short,
            },
        }
    }

    pub(crate) fn value(&self) -> Result<Account, TraceError> {
        let timing = &self.timing;
        let tallies = self.tallies.iter().flat_map(|tally| {
            let first = tally.first.into_iter().flatten();
            [tally.holds, tally.fails, tally.depends]
                .into_iter()
                .chain(first)
        });
        let running = [&self.net, &self.observer].into_iter().chain(&self.supply);
        let lowest = self.lowest.iter().chain([&self.stored]).flatten();
        let places = self
            .firsts
            .iter()
            .flatten()
            .chain(self.worst.iter().map(|(_, place)| place));
        counted(
            [self.intervals, timing.uneven, timing.late, timing.gaps]
                .into_iter()
                .chain(timing.first_missed)
                .chain(timing.short)
                .chain(tallies)
                .chain(running.flat_map(|sum| [sum.at, sum.steps]))
                .chain(lowest.map(|lowest| lowest.h))
                .chain(places.map(|place| place.h)),
        )?;
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
                None,
            ),
            worst: maybe(self.worst.as_ref(), |(net, place)| {
                Ok((net.value()?, place.value()?))
            })?,
            firsts,
            timing: Timing {
                uneven: self.timing.uneven,
                late: self.timing.late,
                missed: self.timing.missed,
                gaps: self.timing.gaps,
                first_missed: self.timing.first_missed,
                range,
                short: self.timing.short,
            },
            rows: Vec::new(),
            points: Vec::new(),
        })
    }
}
