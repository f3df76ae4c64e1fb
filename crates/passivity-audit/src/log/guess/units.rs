//! Units that a name seems to give: in letters of another case, or in words that a header is not read by.

use passivity_scene::Motion;

use super::kind::Kind;
use super::words::{
    ASIDE, COUNTED, DEGREE, HELD, MEASURED, MICRO, NOT_MEASURED, PERHAPS_HELD, PERHAPS_WANTED,
    words,
};
use crate::log::error::shown;
use crate::log::header::{self, is_unit, is_unit_of_force, read_unit, read_unit_of_force};

/// The units that names of columns give, as they are proposed. Of units whose letters differ only in case, such as
/// `mN` and `MN`, those of a log.
const UNITS: [&str; 54] = [
    "s", "sec", "msec", "usec", "ms", "us", "ns", "m", "mm", "cm", "um", "in", "inch", "ft", "rad",
    "mrad", "urad", "deg", "gon", "arcmin", "arcsec", "rev", "turn", "m/s", "mm/s", "rad/s",
    "deg/s", "rpm", "N", "mN", "uN", "kN", "Nm", "mNm", "uNm", "Nmm", "Ncm", "g", "kg", "oz", "lb",
    "gf", "kgf", "ozf", "lbf", "oz in", "ozf in", "lb in", "lbf in", "lb ft", "ft lb", "kg cm",
    "kgf cm", "nm",
];

/// Those that may be a word, or a letter of another meaning.
const WORDS: [&str; 12] = [
    "s", "ms", "us", "ns", "m", "in", "rev", "turn", "N", "mN", "uN", "g",
];

/// Those that only the end of a name gives: within it they are other words or letters.
const LAST: [&str; 7] = ["s", "m", "in", "rev", "turn", "N", "g"];

/// Those that its start does not give: there they are a force and a torque, or a second one.
const NOT_FIRST: [&str; 2] = ["ft", "sec"];

/// Words for units that are not read or of something else, and for degrees or gradians.
const UNKNOWN: [&str; 14] = [
    "mil",
    "thou",
    "grad",
    "yard",
    "mile",
    "angstrom",
    "ångström",
    "pixel",
    "px",
    "percent",
    "volt",
    "millivolt",
    "ampere",
    "milliampere",
];

/// The letters of a unit, with those of a keyboard for its signs.
fn letters(text: &str) -> String {
    let is_joint = |c: &char| !matches!(c, ' ' | '_' | '-' | '.' | '*' | '·');
    text.replace(MICRO, "u")
        .replace(DEGREE, "deg")
        .chars()
        .filter(is_joint)
        .flat_map(char::to_lowercase)
        .collect()
}

/// Whether two texts are one unit in letters of another case.
pub(crate) fn same_letters(a: &str, b: &str) -> bool {
    letters(a) == letters(b)
}

/// Whether a unit is one of a kind.
fn fits(kind: Kind, unit: &str, motion: Motion) -> bool {
    let read = match kind {
        Kind::Force => read_unit_of_force(unit),
        _ => read_unit(unit),
    };
    read.is_ok_and(|unit| unit.dimension().with_angle(0) == kind.dimension(motion))
}

/// Whether the letters of a unit of this kind stand together where it is written so: N s and N·m are no ns and no nm, which
/// are no Nm either.
fn is_together(kind: Kind, unit: &str, (text, name): (&str, &str)) -> bool {
    let is_product = matches!(kind, Kind::Force | Kind::Velocity);
    let is_nano = unit == "nm" && letters(text) == unit;
    is_product
        || match is_nano {
            true => name.contains(unit),
            false => {
                name.to_lowercase().contains(&text.to_lowercase())
                    && !text.contains([' ', '.', '*', '·'])
            }
        }
}

/// The unit of a kind that has the letters of one that is not of this kind as it is written.
pub(super) fn respelt(kind: Kind, unit: &str, motion: Motion) -> Option<&'static str> {
    let found = spelt(kind, unit, motion).filter(|_| !fits(kind, unit, motion));
    found.filter(|found| is_together(kind, found, (unit, unit)))
}

fn spelt(kind: Kind, text: &str, motion: Motion) -> Option<&'static str> {
    let text = header::spelt(text).unwrap_or(text);
    let is_it = |unit: &&&str| same_letters(unit, text) && fits(kind, unit, motion);
    UNITS.iter().find(is_it).copied()
}

/// What stands in brackets and in parentheses in a name, each with what is before it.
fn groups(name: &str) -> Vec<(&str, &str)> {
    let pairs = [('[', ']'), ('(', ')')];
    let found = pairs.into_iter().flat_map(|(open, close)| {
        let starts = name.match_indices(open);
        starts.filter_map(move |(at, _)| {
            let (inner, _) = name.get(at + 1..)?.split_once(close)?;
            Some((name.get(..at)?, inner.trim()))
        })
    });
    let mut found: Vec<(&str, &str)> = found.collect();
    found.sort_by_key(|(before, _)| before.len());
    found
}

/// The unit in the last brackets or parentheses of a name that have one, wherever they are; or what stands in them that is
/// neither read as a unit nor known to say something else.
fn enclosed(kind: Kind, name: &str) -> Result<Option<&str>, String> {
    let groups = groups(name);
    if let Some((_, unit)) = groups.iter().rev().find(|(_, inner)| is_unit(inner)) {
        return Ok(Some(unit));
    }
    let says = |word: &String| {
        let lists: [&[&str]; 7] = [
            &ASIDE,
            &COUNTED,
            &HELD,
            &PERHAPS_HELD,
            &MEASURED,
            &NOT_MEASURED,
            &PERHAPS_WANTED,
        ];
        lists.iter().any(|list| list.contains(&word.as_str()))
            || Kind::ALL.into_iter().any(|kind| kind.is_named(word))
    };
    // A position labelled A is no current.
    let is_of_another = |inner: &&str| {
        OF_OTHERS.contains(inner) || LABELS.contains(inner) && kind != Kind::Position
    };
    let is_unknown = |inner: &&str| is_of_another(inner) || !words(inner).iter().all(says);
    match groups.iter().map(|(_, inner)| *inner).find(is_unknown) {
        None => Ok(None),
        Some(inner) => Err(format!(
            "`{}` is not read as a unit: write one behind the name, in brackets",
            shown(inner.as_bytes())
        )),
    }
}

/// Whether a unit of force stands in brackets or parentheses in a name.
pub(super) fn encloses_force(name: &str) -> bool {
    groups(name)
        .iter()
        .any(|(_, inner)| is_unit_of_force(inner))
}

/// Whether a name is nothing but a unit of force, or of a mass in its place, as `lbs`: a letter alone says something else.
pub(super) fn is_weight(name: &str) -> bool {
    let is_mass = || name.chars().count() > 1 && fits(Kind::Force, name, Motion::Linear);
    is_unit_of_force(name) || is_mass()
}

/// Units of what is no time, position, velocity or force.
const OF_OTHERS: [&str; 23] = [
    "°C", "℃", "degC", "deg C", "°F", "Hz", "kHz", "MHz", "W", "mW", "kW", "mbar", "Pa", "hPa",
    "kPa", "MPa", "psi", "dB", "Ω", "ohm", "Ohm", "lx", "rH",
];

/// Those that may be a label too, of an axis or a channel, or of signals in which something may be given that is called so.
const LABELS: [&str; 8] = ["C", "K", "bar", "V", "mV", "A", "mA", "%"];

/// Those of both that stand after an underscore or a space, where they can hardly be anything else.
const BEHIND: [&str; 5] = ["V", "mV", "Hz", "kHz", "degC"];

/// Whether the unit of a name says that it is of another kind, whatever the name.
pub(crate) fn is_of_another(kind: Kind, name: &str) -> bool {
    let name = name.trim();
    let behind = name
        .rsplit_once(['_', ' '])
        .filter(|(_, unit)| BEHIND.contains(unit));
    let Some((stem, unit)) = groups(name).pop().or(behind) else {
        return false;
    };
    // A velocity that is not read leaves nothing out.
    let is_named = || kind != Kind::Velocity && words(stem).iter().any(|word| kind.is_named(word));
    let has_other = || groups(name).iter().any(|(_, inner)| is_unit(inner));
    match OF_OTHERS.contains(&unit) {
        true => true,
        false => LABELS.contains(&unit) && !has_other() && !is_named(),
    }
}

/// What stands at the end of the name of a force or a position, behind an underscore or a space, and is the unit of what it
/// was made of: a voltage, a current or a share. A letter alone may be the label of an axis.
fn behind(name: &str) -> Option<&str> {
    let (_, last) = name.trim().rsplit_once(['_', ' '])?;
    let is_it = ["mV", "mA", "%", "pct", "percent"].contains(&last);
    let is_other = || last.chars().count() > 1 && OF_OTHERS.contains(&last);
    (is_it || is_other()).then_some(last)
}

/// Whether a number stands right before a word, as in `pos_100um`.
pub(super) fn is_multiple(name: &str, word: &str) -> bool {
    let name = name.to_lowercase();
    let before = name
        .match_indices(word)
        .filter_map(|(at, _)| name.get(..at));
    before
        .filter_map(|before| before.chars().last())
        .any(|c| c.is_ascii_digit())
}

/// What a path says of the column itself: from the part on that names its kind, or else its last segment. What is before
/// that, as a sensor `ft` of forces and torques, says where it comes from.
fn of_itself(kind: Kind, name: &str) -> &str {
    let Some((_, last)) = name.rsplit_once('/') else {
        return name;
    };
    let ends = name.match_indices(['/', '.']).map(|(at, _)| at + 1);
    let mut parts = std::iter::once(0)
        .chain(ends)
        .filter_map(|at| name.get(at..));
    let is_named = |part: &&str| {
        let part = part.split(['/', '.']).next().unwrap_or(part);
        words(part).iter().any(|word| kind.is_named(word))
    };
    parts.find(is_named).unwrap_or(last)
}

/// The unit of a kind that a name gives, if any; or why it can be none of this kind.
pub(super) fn said(kind: Kind, name: &str, motion: Motion) -> Result<Option<String>, String> {
    if let Some(unit) = enclosed(kind, name)? {
        let respelt = respelt(kind, unit, motion);
        let unit = respelt.unwrap_or(unit);
        return match fits(kind, unit, motion) {
            true => Ok(Some(unit.to_owned())),
            false => Err(no_unit(unit, kind, motion)),
        };
    }
    if let Some(unit) = behind(name).filter(|_| kind != Kind::Velocity) {
        return Err(no_unit(unit, kind, motion));
    }
    if let Some(of_heat) = of_heat(name) {
        return Err(no_unit(of_heat, kind, motion));
    }
    if kind == Kind::Force && is_weight(name) {
        return match fits(kind, name, motion) {
            true => Ok(Some(name.trim().to_owned())),
            false => Err(no_unit(name, kind, motion)),
        };
    }
    let own = of_itself(kind, name);
    match in_words(kind, own, motion, name.contains('/'))? {
        // What is before that may say it too, but what is of another kind there is no unit.
        None if own != name.trim_start_matches('/') => {
            Ok(in_words(kind, name, motion, true).unwrap_or(None))
        }
        found => Ok(found),
    }
}

/// The same of what the words of a name, or of a part of a path, give.
fn in_words(
    kind: Kind,
    name: &str,
    motion: Motion,
    is_path: bool,
) -> Result<Option<String>, String> {
    let starts = |text: &String| {
        let mut parts = name.split(|c| is_path && ['/', '.'].contains(&c));
        parts.any(|part| words(part).first() == Some(text))
    };
    let words = words(name);
    if let Some(unknown) = words.iter().find(|word| UNKNOWN.contains(&word.as_str())) {
        return Err(no_unit(unknown, kind, motion));
    }
    // The last one, of as many words as possible. One word alone is the name.
    for until in (1..=words.len()).rev().filter(|_| words.len() > 1) {
        for from in 0..until {
            let some = words.iter().take(until).skip(from);
            let text: String = some.map(String::as_str).collect();
            let is_first = NOT_FIRST.contains(&text.as_str()) && starts(&text);
            let may_be = |unit: &str| until == words.len() || !is_first && !LAST.contains(&unit);
            let is_it = |unit: &&str| may_be(unit) && is_together(kind, unit, (&text, name));
            if let Some(unit) = spelt(kind, &text, motion).filter(is_it) {
                let first = words.get(from).map_or("", String::as_str);
                return match is_multiple(name, first) {
                    true => Err(format!("a number stands before its unit, `{unit}`")),
                    false => Ok(Some(unit.to_owned())),
                };
            }
            let is_other =
                |unit: &&&str| !WORDS.contains(*unit) && may_be(unit) && same_letters(unit, &text);
            if let Some(other) = UNITS.iter().find(is_other) {
                return Err(no_unit(other, kind, motion));
            }
        }
    }
    let within =
        |word: &&String| kind == Kind::Position && ["rev", "turn"].contains(&word.as_str());
    match words.iter().find(within).filter(|_| words.len() > 1) {
        Some(word) => Err(format!(
            "`{word}` may be its unit: write that behind the name, in brackets"
        )),
        None => Ok(None),
    }
}

/// The unit of a temperature in a name.
fn of_heat(name: &str) -> Option<&'static str> {
    let (_, behind) = name.split_once(DEGREE)?;
    let mut behind = behind.chars();
    let unit = [('C', "°C"), ('F', "°F")];
    let letter = behind.next()?;
    let (_, unit) = unit.into_iter().find(|(of, _)| *of == letter)?;
    (!behind.next().is_some_and(char::is_alphabetic)).then_some(unit)
}

/// The same of a time, whose unit may be said by its steps: but not where its name has another.
pub(super) fn not_unknown(name: &str) -> Result<(), String> {
    enclosed(Kind::Time, name).map(|_| ())
}

pub(super) fn no_unit(unit: &str, kind: Kind, motion: Motion) -> String {
    let (unit, kind, own) = (shown(unit.as_bytes()), kind.name(), kind.unit(motion));
    format!("`{unit}` is no unit of {kind} like `{own}`")
}
