//! Columns that look like a clock and are none: lengths of intervals, and times that stand still between two rows.

use passivity_scene::{Motion, Scene};

use super::clock::{Parts, UNITS, counter, parts_of_time, unit_of_word};
use super::kind::Kind;
use super::score::own_unit;
use super::words::words;
use crate::log::columns::same_unit;
use crate::log::header::{Heading, split};
use crate::log::preview::Preview;
use crate::log::step::TOO_COARSE;

/// What a length of an interval is called at the end of a name.
const LENGTHS: [&str; 13] = [
    "dt",
    "δt",
    "dtau",
    "deltat",
    "deltatime",
    "timedelta",
    "interval",
    "period",
    "looptime",
    "cycletime",
    "steptime",
    "sampletime",
    "timestep",
];

/// The same in two words, and what it is called in one with a unit of time, as in `loop_us`.
const PAIRS: [[&str; 2]; 7] = [
    ["delta", "t"],
    ["delta", "time"],
    ["time", "delta"],
    ["loop", "time"],
    ["cycle", "time"],
    ["step", "time"],
    ["sample", "time"],
];
const WITH_UNIT: [&str; 4] = ["loop", "cycle", "delta", "step"];

/// The unit of time that the name of a column gives, of those in which clocks tick.
fn unit(heading: &Heading) -> Option<(&'static str, f64)> {
    let own = own_unit(Kind::Time, heading, Motion::Linear);
    let own = own.or_else(|| {
        words(&heading.name)
            .last()
            .and_then(|it| unit_of_word(it))
            .map(str::to_owned)
    })?;
    let mut units = UNITS
        .iter()
        .map(|(name, per_second, _)| (*name, *per_second));
    units.find(|(name, _)| same_unit(name, &own))
}

/// Whether a column seems to have the lengths of the intervals: it is called so, and does not rise from row to row.
pub(super) fn has_lengths(heading: &Heading, column: usize, preview: &Preview) -> bool {
    let name = split(&heading.name).map_or(heading.name.as_str(), |split| split.stem);
    let mut words = words(name);
    // As in `dt_sec`.
    while words.len() > 1
        && words
            .last()
            .is_some_and(|it| it.len() > 1 && unit_of_word(it).is_some())
    {
        words.pop();
    }
    let is_pair = |pair: &[&str; 2]| words.ends_with(&pair.map(str::to_owned));
    let last = words.last().map_or("", String::as_str);
    let is_called = LENGTHS.contains(&last)
        || PAIRS.iter().any(is_pair)
        || name.ends_with("∆t")
        || (WITH_UNIT.contains(&last) && unit(heading).is_some());
    let is_positive = || preview.numbers(column).iter().all(|length| *length > 0.0);
    let is_number = || preview.no_number(column).is_none() && is_positive();
    is_called && is_number() && !preview.increases(column)
}

/// Whether the lengths of all intervals are a sampling period, in the unit of the column or in any: then they say no more
/// than the rows do.
pub(super) fn are_periods(
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let are = |per_period: f64| {
        let is_one = |length: &f64| (length / per_period - 1.0).abs() < 1e-9;
        preview.numbers(column).iter().all(is_one)
    };
    if scene.motion == Motion::Dimensionless {
        return are(1.0);
    }
    let period = super::clock::period(scene);
    let are_in = |per_second: f64| period.is_some_and(|period| are(period * per_second));
    match unit(heading) {
        Some((_, per_second)) => are_in(per_second),
        None => UNITS.iter().any(|(_, per_second, _)| are_in(*per_second)),
    }
}

/// Why a column that seems to be a clock is none, and what is to be done about it.
pub(super) fn no_clock(
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<String> {
    let heading = headings.get(column)?;
    if has_lengths(heading, column, preview) {
        let name = match unit(heading) {
            _ if scene.motion == Motion::Dimensionless => "tau".to_owned(),
            Some((unit, _)) => format!("t_{unit}"),
            None => "t_UNIT".to_owned(),
        };
        let number = column + 1;
        let example = preview.delimiter.map_or_else(String::new, |delimiter| {
            let apart = delimiter.to_string().replace('\t', "\\t");
            let unit = if name == "t_UNIT" { ", with their unit in the place of `UNIT`" } else { "" };
            format!(
                ", as with `awk -F'{apart}' -v OFS='{apart}' 'NR == 1 {{print \"{name}\", $0; next}} {{t += ${number}; \
                 print sprintf(\"%.9f\", t), $0}}' log.csv > timed.csv` where each is the time since the row before{unit}"
            )
        });
        return Some(format!(
            "it seems to have the lengths of the intervals: make times of them{example}"
        ));
    }
    let is_alone = matches!(parts_of_time(headings, preview, column), Parts::One);
    let row = preview
        .still(column)
        .filter(|_| is_alone && counter(headings, preview, column).is_none())?;
    Some(format!(
        "rows {row} and {} have the same time: {TOO_COARSE}",
        row + 1
    ))
}
