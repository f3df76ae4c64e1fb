//! Clocks: in which unit they tick, and whether they are in two columns.

use passivity_scene::Scene;

use super::words::words;
use crate::log::header::Heading;
use crate::log::preview::Preview;

/// Units of clocks, how many of each are in a second, and the words that say them.
const UNITS: [(&str, f64, &[&str]); 4] = [
    ("s", 1.0, &["s", "sec", "second"]),
    (
        "ms",
        1e3,
        &["ms", "msec", "milli", "millisec", "millisecond"],
    ),
    (
        "us",
        1e6,
        &["us", "µs", "μs", "usec", "micro", "microsec", "microsecond"],
    ),
    ("ns", 1e9, &["ns", "nsec", "nano", "nanosec", "nanosecond"]),
];

/// The unit that a word says.
pub(super) fn unit_of_word(word: &str) -> Option<&'static str> {
    let mut units = UNITS.iter().filter(|(.., words)| words.contains(&word));
    units.next().map(|(unit, ..)| *unit)
}

/// The unit that the words of a name say, the last that says one.
fn unit_said(name: &str) -> Option<&'static str> {
    let words = words(name);
    let last = words.len().checked_sub(1)?;
    let lower = name.to_lowercase();
    words.iter().enumerate().rev().find_map(|(i, word)| {
        // Within a name these may be other words, but for `seconds` and `millis`.
        let is_another = match word.as_str() {
            "s" => i < last,
            "second" | "milli" | "micro" | "nano" => {
                i < last && !lower.contains(&format!("{word}s"))
            }
            _ => false,
        };
        unit_of_word(word).filter(|_| !is_another)
    })
}

/// The unit of a clock: the one that its name says, or else the one in which it goes on by about a sampling period from
/// row to row.
pub(super) fn unit_of_time(name: &str, step: Option<f64>, scene: &Scene) -> &'static str {
    unit_said(name).unwrap_or_else(|| nearest_unit(step, scene))
}

/// The unit in which a clock goes on by about a sampling period from row to row.
fn nearest_unit(step: Option<f64>, scene: &Scene) -> &'static str {
    let period = scene.given.map(|_, given| given.nominal.clone()).period;
    let seconds = period
        .to_rational()
        .map(|x| passivity_scene::number::nearest_f64(&x));
    let (Some(step), Some(period)) = (step, seconds) else {
        return "s";
    };
    let off = |per_second: f64| (step / per_second / period).ln().abs();
    let best = UNITS
        .iter()
        .min_by(|(_, a, _), (_, b, _)| off(*a).total_cmp(&off(*b)));
    best.map_or("s", |(name, ..)| name)
}

/// The columns of a time in whole seconds and of what it is beyond them, as `stamp.sec` and `stamp.nanosec`, of which
/// one is this column.
pub(super) fn parts_of_time(
    headings: &[Heading],
    preview: &Preview,
    column: usize,
) -> Option<[usize; 2]> {
    // The unit that a name ends with, and what is before it.
    let part = |column: usize| {
        let name = &headings.get(column)?.name;
        let (word, lower) = (words(name).pop()?, name.to_lowercase());
        let before = lower.rfind(&word).and_then(|at| lower.get(..at))?;
        Some((before.to_owned(), unit_of_word(&word)?))
    };
    let (before, unit) = part(column)?;
    let is_alike = |other: &Heading| {
        let start = other.name.get(..before.len());
        start.is_some_and(|start| start.to_lowercase() == before)
    };
    let is_other = |other: &usize| {
        headings.get(*other).is_some_and(is_alike)
            && part(*other).is_some_and(|(own, its)| own == before && (its == "s") != (unit == "s"))
    };
    let other = (0..headings.len()).find(is_other)?;
    let [whole, beyond] = if unit == "s" {
        [column, other]
    } else {
        [other, column]
    };
    let (_, unit) = part(beyond)?;
    let (_, most, _) = UNITS.iter().find(|(name, ..)| *name == unit)?;
    // Otherwise they are two clocks.
    let is_split = preview.is_whole(whole) && preview.is_within(beyond, *most);
    is_split.then_some([whole, beyond])
}
