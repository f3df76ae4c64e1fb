//! The name of a column: what it is called, and the unit that is written with it, in brackets, in
//! parentheses or after an underscore, a slash or a comma.

use std::borrow::Cow;

use passivity_scene::Motion;
use passivity_scene::units::{Dimension, Unit};

use crate::log::dates;
use crate::log::error::{TraceError, shown};
use crate::log::guess::is_counted;

/// The name of a column as the log has it, and the unit that its type has of itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Heading {
    pub(crate) name: String,
    /// As a timestamp of Parquet and a column of dates have one.
    pub(crate) unit: Option<&'static str>,
}

impl Heading {
    pub(crate) const fn plain(name: String) -> Self {
        Self { name, unit: None }
    }

    /// Whether its name ends with what may be metres, or short for `measured` or `motor`: `theta_m`.
    pub(crate) fn may_be_metres(&self) -> bool {
        self.name.trim().ends_with("_m")
    }

    /// The same of a device that turns, whose positions are no metres.
    pub(crate) fn is_no_length(&self, motion: Motion) -> bool {
        motion != Motion::Linear && self.may_be_metres()
    }

    /// Whether its column holds dates with a time of day.
    pub(crate) fn is_dated(&self) -> bool {
        self.unit == Some(dates::UNIT)
    }
}

/// What the names of the times end with at which a message was recorded and sent.
pub(crate) const RECORDER: [&str; 2] = [".log_time [ns]", ".publish_time [ns]"];

/// Whether a column is when a message was recorded or sent, which each message of MCAP has beside what it says itself, and each
/// row of `rostopic echo -p`, where it is called `%time` and all else a field.
pub(crate) fn is_of_recorder(headings: &[Heading], column: usize) -> bool {
    let name = |heading: &Heading| heading.name.trim().to_owned();
    let own = headings.get(column).map(name).unwrap_or_default();
    let mut others = (0..).zip(headings).filter(|(other, _)| *other != column);
    let is_of_fields = headings.len() > 1 && others.all(|(_, it)| name(it).starts_with("field."));
    RECORDER.iter().any(|end| own.ends_with(end))
        || ["time", "%time"].contains(&&*own) && is_of_fields
}

/// A name apart from its unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Split<'n> {
    pub(crate) stem: &'n str,
    pub(crate) unit: Option<Cow<'n, str>>,
}

/// `x [rad]`, `x (rad)`, `x_rad`, `x/rad` and `x, rad` as `x` and `rad`; or why the brackets say nothing.
///
/// What stands in brackets is a unit, unless it is a number (`position[0]`). What stands in
/// parentheses or after an underscore, a slash or a comma is one where it reads as one.
pub(crate) fn split(name: &str) -> Result<Split<'_>, (&str, &'static str)> {
    let name = name.trim();
    let plain = Split {
        stem: name,
        unit: None,
    };
    if let Some((stem, inner)) = enclosed(name, '[', ']') {
        let is_index = inner.chars().all(|c| c.is_ascii_digit()) && !inner.is_empty();
        let unit = Some(Cow::Borrowed(inner));
        return Ok(if is_index {
            plain
        } else {
            Split { stem, unit }
        });
    }
    if let Some((stem, rest)) = name.rsplit_once('[')
        && !rest.contains(']')
    {
        return Err((stem.trim(), "the bracket is not closed"));
    }
    if let Some((stem, inner)) = enclosed(name, '(', ')') {
        let unit = Some(Cow::Borrowed(inner));
        return Ok(if is_unit(inner) {
            Split { stem, unit }
        } else {
            plain
        });
    }
    if let Some((stem, rest)) = name.rsplit_once('(')
        && !rest.contains(')')
        && is_unit(rest)
    {
        return Err((stem.trim(), "the parenthesis is not closed"));
    }
    let ends = name.match_indices('_').filter(|(at, _)| *at > 0);
    for (at, _) in ends {
        let (Some(stem), Some(rest)) = (name.get(..at), name.get(at + 1..)) else {
            continue;
        };
        if let Some(unit) = after_underscore(rest) {
            let unit = Some(Cow::Owned(unit));
            return Ok(Split { stem, unit });
        }
    }
    Ok(after_sign(name).unwrap_or(plain))
}

/// What stands before a closed pair at the end of the name, and in it.
fn enclosed(name: &str, open: char, close: char) -> Option<(&str, &str)> {
    let (stem, inner) = name.strip_suffix(close)?.rsplit_once(open)?;
    // As in `v/(m/s)`.
    let bare = stem.trim_end_matches([' ', '/', ',']);
    let stem = if bare.is_empty() { stem } else { bare };
    Some((stem.trim(), inner.trim()))
}

/// A unit after a slash or a comma: `M/Nm`, `omega/rad/s`, `phi, rad`.
fn after_sign(name: &str) -> Option<Split<'_>> {
    let comma = name.rmatch_indices(',').take(1);
    let mut ends = name.match_indices('/').chain(comma);
    ends.find_map(|(at, sign)| {
        let (stem, unit) = (name.get(..at)?.trim(), name.get(at + 1..)?.trim());
        let last = stem.rsplit('/').next().unwrap_or(stem);
        // `N/m` and `counts/s` are quotients of units, and `/stamp/sec` is a field of a topic.
        let is_other = sign == "/" && (is_unit(last) || is_counted(last) || name.starts_with('/'));
        let is_unit = is_unit_of_force(unit) || read_unit(unit).is_ok_and(|unit| measures(&unit));
        let unit = Some(Cow::Borrowed(unit));
        (is_unit && !is_other && stem.contains(char::is_alphabetic)).then_some(Split { stem, unit })
    })
}

/// A unit after an underscore, written as one: `us`, `deg`, `rad_s`, `m_per_s`, `N_m`.
fn after_underscore(text: &str) -> Option<String> {
    // What is also a word, a letter of another meaning, or no unit of a log.
    const WORDS: [&str; 12] = [
        "in", "inch", "ft", "min", "turn", "g", "lb", "oz", "h", "d", "a", "p",
    ];
    if WORDS.contains(&text) {
        return None;
    }
    let joined = match text.split_once("_per_").or_else(|| {
        let (first, second) = text.split_once('_')?;
        (second == "s").then_some((first, second))
    }) {
        Some((above, below)) => format!("{above}/{below}"),
        None => text.replace('_', " "),
    };
    let unit = read_unit(&joined).ok()?;
    measures(&unit).then_some(joined)
}

/// Whether a unit measures what a log can hold.
fn measures(unit: &Unit) -> bool {
    let known = [
        Dimension::new(0, 0, 1, 0),
        Dimension::new(0, 1, 0, 0),
        Dimension::new(0, 1, -1, 0),
        Dimension::new(0, 0, -1, 1),
        Dimension::new(0, 0, 0, 1),
    ];
    known.contains(&unit.dimension()) || is_force(unit)
}

pub(crate) fn is_unit(text: &str) -> bool {
    read_unit(text).is_ok()
}

/// Reads a unit as scenes write it, or as logs do: `N.m`, `N-m`, `usec`, `degrees`.
pub(crate) fn read_unit(text: &str) -> Result<Unit, TraceError> {
    let error = match Unit::parse(text) {
        Ok(unit) => return Ok(unit),
        Err(error) => error,
    };
    if let Ok(unit) = Unit::parse(&as_scenes_write(text)) {
        return Ok(unit);
    }
    let message = format!("`{}`: {error}", shown(text.as_bytes()));
    Err(TraceError::new("unit", message))
}

/// A force, and a torque.
const FORCES: [Dimension; 2] = [Dimension::new(1, 1, -2, 0), Dimension::new(1, 2, -2, 0)];

/// Reads the unit of a column that holds forces or torques, in which a mass is its weight: `oz in`, `kg`.
pub(crate) fn read_unit_of_force(text: &str) -> Result<Unit, TraceError> {
    let unit = read_unit(text)?;
    let weight = unit.as_weight().filter(is_force);
    Ok(weight.filter(|_| !is_force(&unit)).unwrap_or(unit))
}

fn is_force(unit: &Unit) -> bool {
    FORCES.contains(&unit.dimension())
}

/// Whether a unit is one of force or torque by itself: a bare mass is one only of what is called a force.
pub(crate) fn is_unit_of_force(text: &str) -> bool {
    let is_mass = |unit: Unit| unit.dimension() == Dimension::new(1, 0, 0, 0);
    read_unit_of_force(text).is_ok_and(|unit| is_force(&unit))
        && !read_unit(text).is_ok_and(is_mass)
}

/// Units in words and in Cyrillic letters, and their symbols. `Grad` is none of them.
const SPELT: [(&str, &str); 83] = [
    ("inche", "in"),
    ("zoll", "in"),
    ("feet", "ft"),
    ("nanometer", "nm"),
    ("nanometre", "nm"),
    ("zentimeter", "cm"),
    ("mikrometer", "um"),
    ("revs", "rev"),
    ("umdrehung", "rev"),
    ("umdrehungen", "rev"),
    ("gons", "gon"),
    ("meter", "m"),
    ("metre", "m"),
    ("centimeter", "cm"),
    ("centimetre", "cm"),
    ("micrometer", "um"),
    ("micrometre", "um"),
    ("micron", "um"),
    ("radian", "rad"),
    ("milliradian", "mrad"),
    ("degree", "deg"),
    ("revolution", "rev"),
    ("millinewton", "mN"),
    ("kilonewton", "kN"),
    ("newtonmeter", "Nm"),
    ("newtonmetre", "Nm"),
    ("gram", "g"),
    ("kilogram", "kg"),
    ("ounce", "oz"),
    ("pound", "lb"),
    ("lbs", "lb"),
    ("microsecond", "us"),
    ("micros", "us"),
    ("millisecond", "ms"),
    ("millis", "ms"),
    ("nanosecond", "ns"),
    ("nanos", "ns"),
    ("secs", "s"),
    ("sekunde", "s"),
    ("sekunden", "s"),
    ("seconde", "s"),
    ("segundo", "s"),
    ("secondi", "s"),
    ("millisekunden", "ms"),
    ("milliseconde", "ms"),
    ("milisegundo", "ms"),
    ("millisecondi", "ms"),
    ("mikrosekunden", "us"),
    ("microseconde", "us"),
    ("microsegundo", "us"),
    ("degs", "deg"),
    ("degré", "deg"),
    ("grado", "deg"),
    ("gradi", "deg"),
    ("rads", "rad"),
    ("radiane", "rad"),
    ("radiani", "rad"),
    ("radianti", "rad"),
    ("mètre", "m"),
    ("metro", "m"),
    ("metri", "m"),
    ("millimetre", "mm"),
    ("millimeter", "mm"),
    ("millimètre", "mm"),
    ("milímetro", "mm"),
    ("millimetri", "mm"),
    ("Newton", "N"),
    ("newton", "N"),
    ("с", "s"),
    ("мс", "ms"),
    ("мкс", "us"),
    ("нс", "ns"),
    ("м", "m"),
    ("см", "cm"),
    ("мм", "mm"),
    ("мкм", "um"),
    ("рад", "rad"),
    ("мрад", "mrad"),
    ("град", "deg"),
    ("об", "rev"),
    ("Н", "N"),
    ("мН", "mN"),
    ("Нм", "Nm"),
];

/// The symbol of a unit in words: those of many letters in any case.
pub(crate) fn spelt(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    let is_it = |name: &str| name == word || name.chars().count() > 3 && name == lower;
    SPELT
        .iter()
        .find(|(name, _)| is_it(name))
        .map(|(_, symbol)| *symbol)
}

/// Points and hyphens between units as spaces, and units spelt out as their symbols.
fn as_scenes_write(text: &str) -> String {
    let symbol = |word: &str| {
        let single = word.strip_suffix('s').filter(|rest| rest.len() > 3);
        match spelt(word).or_else(|| single.and_then(spelt)) {
            Some(symbol) => symbol.to_owned(),
            None => match single {
                Some(single) if Unit::parse(word).is_err() => single.to_owned(),
                _ => word.to_owned(),
            },
        }
    };
    let mut written = String::new();
    let mut word = String::new();
    for c in text.chars().chain(std::iter::once('\0')) {
        if c.is_alphabetic() || c == '°' || c == '\u{b5}' {
            word.push(c);
            continue;
        }
        if !word.is_empty() {
            written.push_str(&symbol(&word));
            word.clear();
        }
        match c {
            '\0' => {}
            // The sign of a power.
            '-' if written.ends_with('^') => written.push('-'),
            '.' | '-' | '_' => written.push(' '),
            c => written.push(c),
        }
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_in_brackets_parentheses_or_after_an_underscore() {
        for (name, stem, unit) in [
            ("x [rad]", "x", Some("rad")),
            ("x[rad]", "x", Some("rad")),
            ("x (rad)", "x", Some("rad")),
            ("x_rad", "x", Some("rad")),
            ("motor_torque [N.m]", "motor_torque", Some("N.m")),
            ("paddle_speed_deg_s", "paddle_speed", Some("deg/s")),
            ("v_m_per_s", "v", Some("m/s")),
            ("torque_N_m", "torque", Some("N m")),
            ("time_us", "time", Some("us")),
            ("timestep [us]", "timestep", Some("us")),
            (
                "/joint_states/position[0]",
                "/joint_states/position[0]",
                None,
            ),
            ("position[0] [rad]", "position[0]", Some("rad")),
            ("position (filtered)", "position (filtered)", None),
            ("x_ref", "x_ref", None),
            ("motor_in", "motor_in", None),
            ("t", "t", None),
            ("_s", "_s", None),
            ("M/Nm", "M", Some("Nm")),
            ("time / s", "time", Some("s")),
            ("omega/rad/s", "omega", Some("rad/s")),
            ("v_m/s", "v", Some("m/s")),
            ("v/(m/s)", "v", Some("m/s")),
            ("T_motor/mN m", "T_motor", Some("mN m")),
            ("Weg s/mm", "Weg s", Some("mm")),
            ("phi, rad", "phi", Some("rad")),
            ("force,N", "force", Some("N")),
            ("M / [oz in]", "M", Some("oz in")),
            ("rad/s", "rad/s", None),
            ("N/m", "N/m", None),
            ("counts/s", "counts/s", None),
            ("K/N/m", "K/N/m", None),
            ("/pose/m", "/pose/m", None),
            ("/stamp/sec", "/stamp/sec", None),
            ("/joint/torque", "/joint/torque", None),
            ("x, y", "x, y", None),
            ("/s", "/s", None),
        ] {
            let found = split(name).unwrap();
            assert_eq!((found.stem, found.unit.as_deref()), (stem, unit), "{name}");
        }
        for open in ["x [rad", "x [", "t [s", "x (rad"] {
            assert!(split(open).is_err(), "{open}");
        }
    }

    #[test]
    fn units_are_read_as_logs_write_them() {
        let same = |a: &str, b: &str| {
            let (a, b) = (read_unit(a).unwrap(), read_unit(b).unwrap());
            assert_eq!(a, b);
        };
        same("N.m", "N m");
        same("N-m", "N m");
        same("mN.m", "mN m");
        same("usec", "us");
        same("microseconds", "us");
        same("seconds", "s");
        same("degrees", "deg");
        same("radians/s", "rad/s");
        same("deg.s^-1", "deg/s");
        for (words, latin) in [
            ("с", "s"),
            ("мс", "ms"),
            ("Н·м", "N m"),
            ("мН м", "mN m"),
            ("рад/с", "rad/s"),
            ("мм", "mm"),
            ("degrés", "deg"),
            ("Grados", "deg"),
            ("gradi/s", "deg/s"),
            ("mètres", "m"),
            ("metri", "m"),
            ("radianes", "rad"),
            ("Sekunden", "s"),
        ] {
            same(words, latin);
        }
        assert!(read_unit("parsec").is_err());
    }
}
