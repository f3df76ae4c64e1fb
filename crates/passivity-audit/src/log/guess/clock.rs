//! Clocks: in which unit they tick, and whether they are in two columns.

use passivity_scene::Scene;

use super::kind::Kind;
use super::units::is_multiple;
use super::words::{COUNTED, OF_PERIODS, OF_TICKS, words};
use crate::log::columns::Found;
use crate::log::header::{Heading, split};
use crate::log::preview::Preview;

/// Units of clocks, how many of each are in a second, and the words that say them.
pub(super) const UNITS: [(&str, f64, &[&str]); 4] = [
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

/// The unit that a name gives, where it is a multiple of it that the clock ticks in: `time_100us`.
pub(super) fn multiple(name: &str) -> Option<&'static str> {
    let is_it = |word: &String| unit_of_word(word).is_some() && is_multiple(name, word);
    words(name)
        .iter()
        .find(|word| is_it(word))
        .and_then(|word| unit_of_word(word))
}

/// The unit of a clock: the one that its name says, or else the one in which it goes on by about a sampling period from
/// row to row.
pub(super) fn unit_of_time(name: &str, step: Option<f64>, scene: &Scene) -> &'static str {
    unit_said(name).unwrap_or_else(|| nearest_unit(step, scene))
}

/// The unit in which a clock goes on by about a sampling period from row to row; where two are about as far from that, the
/// one in which it goes on by more.
pub(super) fn nearest_unit(step: Option<f64>, scene: &Scene) -> &'static str {
    let [longer, _] = within_reach(step, scene);
    let nearest = || nearest(step, scene).map(|(name, _)| name);
    longer.or_else(nearest).unwrap_or("s")
}

/// The other unit in which a clock without one may tick as well, as that of a log printed every 50 ms with a scene of 1 ms:
/// in microseconds the times would say that a period has twenty rows.
pub(crate) fn other_unit(
    found: &Found,
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> Option<&'static str> {
    let heading = headings.get(found.column)?;
    let has_own = heading.unit.is_some() || split(&heading.name).ok()?.unit.is_some();
    let is_open = !has_own && unit_said(&heading.name).is_none();
    let [longer, shorter] = within_reach(preview.step(found.column), scene);
    shorter.filter(|_| is_open && longer == found.unit.as_deref())
}

/// Two units in which a clock goes on by between a hundredth of a sampling period and a hundred of them, where it does not
/// go on by about one in either.
fn within_reach(step: Option<f64>, scene: &Scene) -> [Option<&'static str>; 2] {
    const FAR: f64 = 100.0;
    let periods = in_periods(step, scene).unwrap_or_default();
    let is_clear = periods.iter().any(|(_, periods)| is_about_one(*periods));
    let is_near = |(_, periods): &&(_, f64)| !is_clear && (1.0 / FAR..=FAR).contains(periods);
    let mut near = periods.iter().filter(is_near).map(|(name, _)| *name);
    match (near.next(), near.next()) {
        (Some(longer), Some(shorter)) => [Some(longer), Some(shorter)],
        _ => [None, None],
    }
}

/// The sampling period in seconds; `None` of a scene without units.
pub(super) fn period(scene: &Scene) -> Option<f64> {
    let period = scene.given.map(|_, given| given.nominal.clone()).period;
    Some(passivity_scene::number::nearest_f64(&period.to_rational()?))
}

/// How many sampling periods a step is in each unit, the longest unit first.
fn in_periods(step: Option<f64>, scene: &Scene) -> Option<[(&'static str, f64); 4]> {
    let (period, step) = (period(scene)?, step?);
    Some(UNITS.map(|(name, per_second, _)| (name, step / per_second / period)))
}

/// The unit in which a step is nearest to a sampling period, and how many of them it is.
pub(super) fn nearest(step: Option<f64>, scene: &Scene) -> Option<(&'static str, f64)> {
    let periods = in_periods(step, scene)?;
    let off = |periods: f64| periods.ln().abs();
    let best = periods.into_iter();
    best.min_by(|(_, a), (_, b)| off(*a).total_cmp(&off(*b)))
}

/// What a column without a unit counts, that rises from row to row and is called so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Counter {
    Periods,
    Ticks,
}

/// What a column counts where it seems to be a clock: the name of no time, nor that of a position.
pub(super) fn counter(headings: &[Heading], preview: &Preview, column: usize) -> Option<Counter> {
    let heading = headings.get(column)?;
    let split = split(&heading.name).ok()?;
    if split.unit.is_some() || heading.unit.is_some() || unit_said(&heading.name).is_some() {
        return None;
    }
    let words = words(split.stem);
    let has = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
    let is_other = |word: &String| {
        let is_place = Kind::Position.words().contains(&word.as_str());
        Kind::Time.is_named(word) || is_place && !COUNTED.contains(&word.as_str())
    };
    // `xTaskGetTickCount` is no `x`.
    let is_asked = words.windows(2).any(|pair| pair == ["get", "tick"]);
    let counter = match () {
        () if is_asked => Counter::Ticks,
        () if words.iter().any(is_other) => return None,
        () if has(&OF_PERIODS) => Counter::Periods,
        () if has(&OF_TICKS) => Counter::Ticks,
        () => return None,
    };
    let goes_on = match counter {
        Counter::Periods => preview.increases(column),
        // One of a millisecond stands still in shorter periods.
        Counter::Ticks => preview.moves(column) && !preview.runs_backward(column),
    };
    (preview.is_whole(column) && goes_on).then_some(counter)
}

/// Whether ticks of a clock are long enough to tell rows apart, and about a sampling period goes on from row to row in
/// some unit.
pub(super) fn has_a_unit(preview: &Preview, column: usize, scene: &Scene) -> bool {
    let near = nearest(preview.step(column), scene);
    preview.increases(column) && near.is_some_and(|(_, periods)| is_about_one(periods))
}

/// Whether a step of so many sampling periods is about one of them.
pub(super) fn is_about_one(periods: f64) -> bool {
    const MOST: f64 = 1.5;
    (1.0 / MOST..=MOST).contains(&periods)
}

/// What is said of a clock whose steps are no sampling periods in any unit.
pub(super) const NO_TICK: &str = "nothing says how long one of its ticks is";

/// What is larger than a second, and how many of each are in the next.
const LARGER: [(&[&str], f64); 3] = [
    (&["min", "minute"], 60.0),
    (&["h", "hr", "hour", "std", "stunde"], 24.0),
    (&["d", "day", "tag"], 366.0),
];

/// Which columns say together when a sample was.
pub(super) enum Parts {
    /// One alone.
    One,
    /// Whole ones of a unit, and what the time is beyond them.
    Two([usize; 2]),
    /// Others, which are not read.
    More,
}

/// The columns that say together with this one when a sample was, as `stamp.sec` and `stamp.nanosec` do.
pub(super) fn parts_of_time(headings: &[Heading], preview: &Preview, column: usize) -> Parts {
    // The word that a name ends with, and what is before it.
    let named = |column: usize| {
        let name = &headings.get(column)?.name;
        let (word, lower) = (words(name).pop()?, name.to_lowercase());
        let before = lower.rfind(&word).and_then(|at| lower.get(..at))?;
        Some((before.to_owned(), word))
    };
    let Some((before, word)) = named(column) else {
        return Parts::One;
    };
    let per_second = |word: &str| {
        let unit = unit_of_word(word)?;
        UNITS
            .iter()
            .find(|(name, ..)| *name == unit)
            .map(|(_, n, _)| *n)
    };
    let Some(own) = per_second(&word) else {
        return Parts::One;
    };
    let beside = (0..headings.len()).filter_map(|other| {
        let (its, word) = named(other)?;
        (its == before && other != column).then_some((other, word))
    });
    let (mut parts, mut has_larger) = (vec![(own, column)], false);
    for (other, word) in beside {
        match per_second(&word) {
            Some(its) => parts.push((its, other)),
            None => {
                let larger = LARGER
                    .iter()
                    .find(|(words, _)| words.contains(&word.as_str()));
                let is_part = |(_, most): &(_, f64)| preview.is_within(other, *most);
                has_larger |= larger.is_some_and(is_part);
            }
        }
    }
    parts.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    // Otherwise they are several clocks.
    let is_part = |pair: &[(f64, usize)]| match pair {
        [(whole, _), (finer, at)] => preview.is_within(*at, finer / whole),
        _ => false,
    };
    let is_split = parts.windows(2).all(is_part);
    match parts.as_slice() {
        _ if has_larger => Parts::More,
        [(_, whole), (_, beyond)] if is_split && preview.is_whole(*whole) => {
            Parts::Two([*whole, *beyond])
        }
        [_, _, _, ..] if is_split => Parts::More,
        _ => Parts::One,
    }
}
