//! How much a column looks like what it may be: by its name, its unit and its first rows.

use passivity_scene::{Motion, Scene};

use super::clock::{
    Counter, NO_TICK, Parts, counter, has_a_unit, multiple, parts_of_time, unit_of_word,
};
use super::kind::Kind;
use super::words::{
    COMMANDED, COMMANDER, FORCE_PAIRS, HELD, MEASURED, NO_FORCE, NO_LETTER, NO_POSITION, NO_TIME,
    NOT_MEASURED, OF_FORCE, OF_LETTER, PERHAPS_WANTED, words,
};
use super::{LIKELY, axes, has_force, is_counted, is_none_of, lengths, made, side, units, whole};
use crate::log::error::shown;
use crate::log::header::{Heading, is_unit_of_force, read_unit, read_unit_of_force, split};
use crate::log::preview::Preview;

/// The unit that a column has of its own, where it is of a kind. Of a device that turns, `theta_m` is no length.
pub(super) fn own_unit(kind: Kind, heading: &Heading, motion: Motion) -> Option<String> {
    let is_no_length = kind == Kind::Position && heading.is_no_length(motion);
    let unit = split(&heading.name).ok()?.unit.filter(|_| !is_no_length);
    unit.as_deref().or(heading.unit).map(str::to_owned)
}

/// How much a heading is called like a kind.
pub(super) fn called(kind: Kind, heading: &Heading, motion: Motion) -> i32 {
    let stem = match split(&heading.name) {
        Ok(split) => split.stem,
        Err((stem, _)) => stem,
    };
    let words = words(stem);
    let mut named: Vec<bool> = words.iter().map(|word| kind.is_named(word)).collect();
    // A time may be called by its unit alone; one of one letter is more often something else.
    if let (Kind::Time, Some(word), Some(last)) = (kind, words.last(), named.last_mut()) {
        *last |= word.len() > 1 && unit_of_word(word).is_some();
    }
    // Everything on a topic of this name has the word; of the thing itself it is the last, but for a component, and for the
    // field of a message that has but one.
    let is_more = |word: &&String| word.len() > 1 && *word != "data";
    let last = words.iter().rev().find(is_more);
    let is_pair = |pair: &[&str; 2]| words.ends_with(&pair.map(str::to_owned));
    if kind == Kind::Force
        && (last.is_some_and(|word| word == "wrench") || FORCE_PAIRS.iter().any(is_pair))
    {
        named.push(true);
    }
    let has = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
    let mut score = 0;
    if named.contains(&true) {
        score += 4;
        // The last word says most: a `velocity_time` is a time.
        score += i32::from(named.last() == Some(&true));
    }
    if kind == Kind::Force {
        score += i32::from(has(&HELD));
        // Of a wrench, which has both.
        let other: &[&str] = match motion {
            Motion::Linear => &["torque", "moment"],
            _ => &["force"],
        };
        score -= i32::from(has(other));
        // Its unit says more: of forces after a limit, these were held.
        let is_none =
            !has_force(heading) && last.is_some_and(|word| NO_FORCE.contains(&word.as_str()));
        score -= if is_none { 6 } else { 0 };
    } else if has(&NOT_MEASURED) {
        // A `command_time` is a time, though a `time` beside it is meant first.
        let is_time = kind == Kind::Time && !has(&NO_TIME);
        score -= if is_time { 1 } else { 4 };
    }
    if kind == Kind::Position {
        score -= if has(&NO_POSITION) { 4 } else { 0 };
        score += if named.contains(&true) && has(&MEASURED) {
            2
        } else {
            0
        };
        score -= i32::from(has(&PERHAPS_WANTED));
    }
    score
}

/// Whether a column without a unit may be a force by what else it is called: as a command is, or by the unit alone. One
/// of text has commands of another kind, one that rises by whole numbers is `N`, their number, and one of few whole numbers
/// is a flag or a mode.
pub(super) fn may_be_force(
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let has_letter = has_letter(&heading.name, scene.motion);
    // The m in `T_m` is none, and the one in `T [m]` is.
    let is_said = !has_letter || heading.name.contains(['[', '(']);
    let has_unit = is_said && split(&heading.name).map_or(true, |split| split.unit.is_some());
    let is_number = preview.is_whole(column) && preview.increases(column);
    let is_none = !preview.moves(column) || is_number || preview.is_mode(column);
    if has_unit || is_none || preview.no_number(column).is_some() {
        return false;
    }
    let words = words(&heading.name);
    let is_in = |list: &[&str], word: &String| list.contains(&word.as_str());
    if words.iter().any(|word| is_in(&["error", "err"], word)) {
        return false;
    }
    // As in `cmdN`; an n before a command is a speed.
    let is_newton = |word: &String| word == "n" && heading.name.ends_with('N');
    let is_unit = |word: &String| word.len() > 1 && is_unit_of_force(word) || is_newton(word);
    let says = |word: &String| is_in(&COMMANDED, word) || is_unit(word);
    let is_command = words
        .iter()
        .all(|word| says(word) || is_in(&COMMANDER, word))
        && words.iter().any(says);
    let is_unit = units::is_weight(&heading.name)
        && units::said(Kind::Force, &heading.name, scene.motion).is_ok();
    has_letter || is_command || is_unit
}

/// Whether a name has the letter of a force or a torque with what is known to stand behind it: `Fd`, `taum`, and of a device
/// that turns `Tm` and `M_soll`, or `T` and `M` alone. By what stands there, as `frame`, `Time` and `mode` are none.
fn has_letter(name: &str, motion: Motion) -> bool {
    let is_torque = |word: &str| motion == Motion::Rotary && ["T", "M"].contains(&word);
    let is_behind = |rest: &str| {
        let rest = rest.to_lowercase();
        OF_FORCE.contains(&rest.as_str()) || OF_LETTER.contains(&rest.as_str())
    };
    let in_one = |word: &str| {
        let letters = ["F", "f", "T", "M", "tau", "Tau", "τ"].into_iter();
        let mut letters = letters.filter(|it| !["T", "M"].contains(it) || is_torque(it));
        letters.any(|letter| {
            let rest = word.strip_prefix(letter);
            rest.is_some_and(|rest| {
                let is_capital = rest.len() == 1 && rest.chars().all(char::is_uppercase);
                is_behind(rest) && !is_capital && !NO_LETTER.contains(&word)
            })
        })
    };
    let parts = name.split(|c: char| !c.is_alphabetic());
    let mut parts = parts.filter(|part| !part.is_empty());
    match parts.clone().next() {
        // `T` alone may be a temperature, or a time.
        Some("T") if is_torque("T") => parts.clone().count() > 1 && parts.skip(1).all(is_behind),
        Some(first) if is_torque(first) => parts.skip(1).all(is_behind),
        _ => parts.any(in_one),
    }
}

/// How much what a column holds looks like a kind; or why it cannot be of that kind.
pub(super) fn held(
    kind: Kind,
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Result<i32, String> {
    let heading = headings.get(column).ok_or("there is no such column")?;
    split(&heading.name).map_err(|(_, why)| why.to_owned())?;
    if let Some(why) = side::not_at_device(kind, heading, column, preview, scene) {
        return Err(why);
    }
    if kind == Kind::Time
        && let Some(why) = lengths::no_clock(headings, column, preview, scene)
    {
        return Err(why);
    }
    if let Some(why) = preview.without_number(column) {
        return Err(why);
    }
    match (own_unit(kind, heading, scene.motion).as_deref(), kind) {
        (_, Kind::Time) if matches!(parts_of_time(headings, preview, column), Parts::More) => {
            Err("it is one of several columns that say together when a sample was".to_owned())
        }
        (None, Kind::Time) => match multiple(&heading.name) {
            Some(unit) => Err(format!("a number stands before its unit, `{unit}`")),
            None if scene.motion != Motion::Dimensionless
                && counter(headings, preview, column) == Some(Counter::Ticks)
                && !has_a_unit(preview, column, scene) =>
            {
                Err(NO_TICK.to_owned())
            }
            None => units::not_unknown(&heading.name).map(|()| 0),
        },
        (None, Kind::Velocity) => units::not_unknown(&heading.name).map(|()| 0),
        (None, _) if scene.motion == Motion::Dimensionless => Ok(0),
        (None, Kind::Position) => {
            units::said(kind, &heading.name, scene.motion)?;
            whole::counts(heading, column, preview, scene).map(|_| 0)
        }
        (None, _) => units::said(kind, &heading.name, scene.motion).map(|_| 0),
        (Some(unit), Kind::Position) if is_counted(unit) => {
            whole::counts(heading, column, preview, scene).map(|_| 2)
        }
        (Some(unit), _) if scene.motion == Motion::Dimensionless => {
            let unit = shown(unit.as_bytes());
            Err(format!(
                "the scene has no units, and the column has `{unit}`"
            ))
        }
        (Some(unit), _) => {
            let unit = units::respelt(kind, unit, scene.motion).unwrap_or(unit);
            let read = match kind {
                Kind::Force => read_unit_of_force(unit),
                _ => read_unit(unit),
            };
            let dimension = read.map_err(|error| error.message)?.dimension();
            match dimension.with_angle(0) == kind.dimension(scene.motion) {
                // A bare mass is no sign of a force.
                true if kind == Kind::Force && !is_unit_of_force(unit) => Ok(0),
                true => Ok(2),
                false => Err(units::no_unit(unit, kind, scene.motion)),
            }
        }
    }
}

/// Of a heading: how much it looks like a kind; `None` when it cannot be.
pub(super) fn score(
    kind: Kind,
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<i32> {
    let heading = headings.get(column)?;
    if is_none_of(kind, heading, column, preview) {
        return None;
    }
    let of_unit = held(kind, headings, column, preview, scene).ok()?;
    let of_name = called(kind, heading, scene.motion);
    let mut score = of_unit + of_name;
    // What has a unit of positions needs no word for one where nothing else is said than that it was measured, or which axis
    // it is.
    let is_open = kind == Kind::Position && of_unit > 0 && of_name == 0;
    if is_open && (made::is_plainly_measured(heading) || axes::is_axis(heading)) {
        score += 2;
    }
    if kind == Kind::Force && may_be_force(heading, column, preview, scene) {
        score += LIKELY;
    }
    match counter(headings, preview, column).filter(|_| kind == Kind::Time) {
        Some(Counter::Periods) => return Some(LIKELY),
        Some(Counter::Ticks) => return Some(LIKELY + 1),
        None => {}
    }
    if kind == Kind::Time {
        score += match parts_of_time(headings, preview, column) {
            Parts::Two(_) | Parts::More => 4,
            Parts::One if preview.increases(column) => 0,
            Parts::One => -3,
        };
    }
    (score >= LIKELY).then_some(score)
}
