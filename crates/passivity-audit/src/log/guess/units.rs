//! Units that a name seems to give: in letters of another case, or in words that a header is not read by.

use passivity_scene::Motion;

use super::kind::Kind;
use super::words::words;
use crate::log::error::shown;
use crate::log::header::{is_unit, read_unit, read_unit_of_force};

/// The units that names of columns give, as they are proposed. Of units whose letters differ only in case, such as
/// `mN` and `MN`, those of a log.
const UNITS: [&str; 50] = [
    "s", "sec", "msec", "usec", "ms", "us", "ns", "m", "mm", "cm", "um", "in", "inch", "ft", "rad",
    "mrad", "urad", "deg", "rev", "turn", "m/s", "mm/s", "rad/s", "deg/s", "rpm", "N", "mN", "uN",
    "kN", "Nm", "mNm", "uNm", "Nmm", "Ncm", "g", "kg", "oz", "lb", "gf", "kgf", "ozf", "lbf",
    "oz in", "ozf in", "lb in", "lbf in", "lb ft", "ft lb", "kg cm", "kgf cm",
];

/// Those that may be a word, or a letter of another meaning.
const WORDS: [&str; 12] = [
    "s", "ms", "us", "ns", "m", "in", "rev", "turn", "N", "mN", "uN", "g",
];

/// Those that only the end of a name gives: within it they are other words or letters.
const LAST: [&str; 7] = ["s", "m", "in", "rev", "turn", "N", "g"];

/// Units in words, as [`words`] has them.
const SPELT: [(&str, &str); 23] = [
    ("inche", "in"),
    ("meter", "m"),
    ("metre", "m"),
    ("millimeter", "mm"),
    ("millimetre", "mm"),
    ("centimeter", "cm"),
    ("centimetre", "cm"),
    ("micrometer", "um"),
    ("micrometre", "um"),
    ("micron", "um"),
    ("radian", "rad"),
    ("milliradian", "mrad"),
    ("degree", "deg"),
    ("revolution", "rev"),
    ("newton", "N"),
    ("millinewton", "mN"),
    ("kilonewton", "kN"),
    ("newtonmeter", "Nm"),
    ("newtonmetre", "Nm"),
    ("gram", "g"),
    ("kilogram", "kg"),
    ("ounce", "oz"),
    ("pound", "lb"),
];

/// Words for units that are not read, and for degrees or gradians.
const UNKNOWN: [&str; 3] = ["mil", "thou", "grad"];

/// The letters of a unit.
fn letters(text: &str) -> String {
    let is_joint = |c: &char| !matches!(c, ' ' | '_' | '-' | '.' | '*' | '·');
    text.chars()
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

/// The unit of a kind that has the letters of one that is not of this kind as it is written.
pub(super) fn respelt(kind: Kind, unit: &str, motion: Motion) -> Option<&'static str> {
    spelt(kind, unit, motion).filter(|_| !fits(kind, unit, motion))
}

fn spelt(kind: Kind, text: &str, motion: Motion) -> Option<&'static str> {
    let in_words = SPELT.iter().find(|(words, _)| *words == text);
    let text = in_words.map_or(text, |(_, unit)| unit);
    let is_it = |unit: &&&str| same_letters(unit, text) && fits(kind, unit, motion);
    UNITS.iter().find(is_it).copied()
}

/// The unit in the last brackets or parentheses of a name that have one, wherever they are.
fn enclosed(name: &str) -> Option<&str> {
    let pairs = [('[', ']'), ('(', ')')];
    let found = pairs.into_iter().flat_map(|(open, close)| {
        let starts = name.match_indices(open);
        starts.filter_map(move |(at, _)| {
            let (inner, _) = name.get(at + 1..)?.split_once(close)?;
            is_unit(inner.trim()).then_some((at, inner.trim()))
        })
    });
    found.max_by_key(|(at, _)| *at).map(|(_, unit)| unit)
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

/// The unit of a kind that a name gives, if any; or why it can be none of this kind.
pub(super) fn said(kind: Kind, name: &str, motion: Motion) -> Result<Option<String>, String> {
    if let Some(unit) = enclosed(name) {
        let respelt = respelt(kind, unit, motion);
        let unit = respelt.unwrap_or(unit);
        return match fits(kind, unit, motion) {
            true => Ok(Some(unit.to_owned())),
            false => Err(no_unit(unit, kind, motion)),
        };
    }
    let words = words(name);
    if let Some(unknown) = words.iter().find(|word| UNKNOWN.contains(&word.as_str())) {
        return Err(no_unit(unknown, kind, motion));
    }
    // The last one, of as many words as possible.
    for until in (2..=words.len()).rev() {
        for from in 1..until {
            let some = words.iter().take(until).skip(from);
            let text: String = some.map(String::as_str).collect();
            let is_last = until == words.len();
            if let Some(unit) = spelt(kind, &text, motion)
                && (is_last || !LAST.contains(&unit))
            {
                let first = words.get(from).map_or("", String::as_str);
                return match is_multiple(name, first) {
                    true => Err(format!("a number stands before its unit, `{unit}`")),
                    false => Ok(Some(unit.to_owned())),
                };
            }
            let is_other = |unit: &&&str| !WORDS.contains(*unit) && same_letters(unit, &text);
            let other = UNITS.iter().find(is_other);
            if let Some(other) = other.filter(|_| is_last) {
                return Err(no_unit(other, kind, motion));
            }
        }
    }
    Ok(None)
}

pub(super) fn no_unit(unit: &str, kind: Kind, motion: Motion) -> String {
    let (unit, kind, own) = (shown(unit.as_bytes()), kind.name(), kind.unit(motion));
    format!("`{unit}` is no unit of {kind} like `{own}`")
}
