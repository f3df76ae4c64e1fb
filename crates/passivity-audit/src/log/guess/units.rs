//! Units that a name seems to give: in letters of another case, or in words that a header is not read by.

use passivity_scene::Motion;

use super::kind::Kind;
use super::words::words;
use crate::log::header::{read_unit, read_unit_of_force};

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
    let is_it = |unit: &&&str| same_letters(unit, text) && fits(kind, unit, motion);
    UNITS.iter().find(is_it).copied()
}

/// The unit of a kind with which a name ends; or one of another kind, of which it cannot be.
pub(super) fn said(
    kind: Kind,
    name: &str,
    motion: Motion,
) -> Result<Option<&'static str>, &'static str> {
    let words = words(name);
    let ends = (1..words.len()).map(|from| {
        words
            .iter()
            .skip(from)
            .map(String::as_str)
            .collect::<String>()
    });
    for end in ends {
        if let Some(unit) = spelt(kind, &end, motion) {
            return Ok(Some(unit));
        }
        let is_other = |unit: &&&str| !WORDS.contains(*unit) && same_letters(unit, &end);
        let other = UNITS.iter().find(is_other);
        if let Some(other) = other {
            return Err(other);
        }
    }
    Ok(None)
}
