//! Columns that look like a clock and are none: lengths of intervals, and times that stand still between two rows.

use passivity_scene::{Motion, Scene};

use super::clock::{Parts, UNITS, counter, nearest, parts_of_time, period, unit_of_word};
use super::kind::Kind;
use super::score::own_unit;
use super::words::words;
use crate::log::columns::same_unit;
use crate::log::header::{Heading, split};
use crate::log::preview::Preview;
use crate::log::step::TOO_COARSE;

/// What a length of an interval is called at the end of a name.
const LENGTHS: [&str; 11] = [
    "dt",
    "δt",
    "dtau",
    "deltat",
    "deltatime",
    "timedelta",
    "looptime",
    "cycletime",
    "steptime",
    "sampletime",
    "timestep",
];

/// The same in two words, and what it is called in one with a unit of time, as in `loop_us`; without one `period` is a setting.
const PAIRS: [[&str; 2]; 7] = [
    ["delta", "t"],
    ["delta", "time"],
    ["time", "delta"],
    ["loop", "time"],
    ["cycle", "time"],
    ["step", "time"],
    ["sample", "time"],
];
const WITH_UNIT: [&str; 6] = ["loop", "cycle", "delta", "step", "interval", "period"];

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

/// Whether a column is called as the lengths of intervals are, and does not rise from row to row as a clock does.
fn is_called(heading: &Heading, column: usize, preview: &Preview) -> bool {
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
    let is_it = LENGTHS.contains(&last)
        || PAIRS.iter().any(is_pair)
        || name.ends_with("∆t")
        || (WITH_UNIT.contains(&last) && unit(heading).is_some());
    is_it && !preview.increases(column)
}

/// The lengths in sampling periods, in the unit of the column or else in the one in which they are nearest to a period, but
/// for that of the first row, before which there is none; `None` where one is no number above zero.
fn in_periods(
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<Vec<f64>> {
    let fields = preview.columns.get(column)?.iter().skip(1).copied();
    let mut lengths: Vec<f64> = fields.collect::<Option<_>>()?;
    lengths.sort_by(f64::total_cmp);
    let middle = lengths.get(lengths.len() / 2).copied();
    lengths.first().filter(|length| **length > 0.0)?;
    let per_period = match unit(heading) {
        _ if scene.motion == Motion::Dimensionless => 1.0,
        Some((_, per_second)) => per_second * period(scene)?,
        None => middle? / nearest(middle, scene)?.1,
    };
    Some(lengths.iter().map(|length| length / per_period).collect())
}

/// Whether a column seems to have the lengths of the intervals. Those which are a sampling period each say no more than
/// the rows do. The middle one is half of a period at the least: what a controller took for its work is mostly less.
pub(super) fn has_lengths(
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> bool {
    const LEAST: f64 = 0.5;
    let lengths = in_periods(heading, column, preview, scene).unwrap_or_default();
    let is_one = |length: &f64| (length - 1.0).abs() < 1e-9;
    let is_long = lengths.get(lengths.len() / 2) >= Some(&LEAST);
    is_called(heading, column, preview) && is_long && !lengths.iter().all(is_one)
}

/// Whether a column is no clock, and nothing is to be done about it: other lengths, or one value in all rows.
pub(super) fn is_passed_over(
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let Some(heading) = headings.get(column) else {
        return false;
    };
    let is_length = is_called(heading, column, preview);
    let stands = || {
        let is_still = preview.still(column).is_some() && !preview.moves(column);
        is_still && is_whole_clock(headings, column, preview)
    };
    (is_length || stands()) && !has_lengths(heading, column, preview, scene)
}

/// Whether a column says alone when a sample was, if it is a clock, and is no counter.
fn is_whole_clock(headings: &[Heading], column: usize, preview: &Preview) -> bool {
    matches!(parts_of_time(headings, preview, column), Parts::One)
        && counter(headings, preview, column).is_none()
}

/// Why a column that seems to be a clock is none, and what is to be done about it.
pub(super) fn no_clock(
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<String> {
    let heading = headings.get(column)?;
    if is_passed_over(headings, column, preview, scene) {
        return Some("it does not go on".to_owned());
    }
    if has_lengths(heading, column, preview, scene) {
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
                ", as with `awk -F'{apart}' -v OFS='{apart}' 'NR == 1 {{print \"{name}\", $0; next}} NR > 2 {{t += ${number}}} \
                 {{print sprintf(\"%.9f\", t), $0}}' log.csv > timed.csv` where each is the time since the row before{unit}, of a log \
                 of one line of names and rows of numbers below it"
            )
        });
        return Some(format!(
            "it seems to have the lengths of the intervals: make times of them{example}"
        ));
    }
    let row = preview
        .still(column)
        .filter(|_| is_whole_clock(headings, column, preview))?;
    Some(format!(
        "rows {row} and {} have the same time: {TOO_COARSE}",
        row + 1
    ))
}
