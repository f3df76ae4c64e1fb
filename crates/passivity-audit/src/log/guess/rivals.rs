//! Columns that are called as a role is, beside others that may be meant: the number of each row under the name `count`, a
//! force `f` beside one that is said to be commanded, a position `x` beside one that is said to be measured.

use passivity_scene::Scene;

use super::kind::Kind;
use super::made::{is_plainly_measured, was_made};
use super::score::{called, own_unit, score};
use super::words::{HELD, NOT_MEASURED, OF_ANOTHER, PERHAPS_HELD, PERHAPS_WANTED, words};
use super::{is_called_a_count, role};
use crate::log::columns::{Found, Role};
use crate::log::error::shown;
use crate::log::header::Heading;
use crate::log::names::by_name;
use crate::log::preview::Preview;
use crate::log::scale::position_scale;

/// How much a column is called like a kind by a word for it alone.
const NAMED: i32 = 4;

/// The columns that are called as a role is and may not be meant, as others may.
pub(crate) fn in_doubt(headings: &[Heading], preview: &Preview, scene: &Scene) -> Vec<Found> {
    let said = by_name(headings).unwrap_or_default();
    let is_free = |column: &usize| said.iter().all(|found| found.column != *column);
    let has_rival = |found: &Found| {
        let is_asked = found.is_position() || found.role == Role::F;
        let mut others = (0..headings.len()).filter(|column| is_asked && is_free(column));
        others.any(|column| is_rival(found, headings, column, preview, scene))
    };
    said.iter().filter(|it| has_rival(it)).cloned().collect()
}

/// Whether a column may be meant rather than one that is called as its role is.
fn is_rival(
    found: &Found,
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let kind = Kind::of(found.role);
    let is_likely = score(kind, headings, column, preview, scene).is_some();
    let Some(heading) = headings.get(column).filter(|_| is_likely) else {
        return false;
    };
    let called = |heading| called(kind, heading, scene.motion);
    let own = headings.get(found.column).map_or(0, called);
    let words = words(&heading.name);
    let has = |list: &[&str]| words.iter().any(|word| list.contains(&word.as_str()));
    // In one word, too: `Fcmd`.
    let is_held = |word: &String| {
        let behind = word.strip_prefix('f').unwrap_or(word);
        let is_in = |list: &[&str]| list.contains(&word.as_str()) || list.contains(&behind);
        is_in(&HELD) || is_in(&PERHAPS_HELD)
    };
    let is_held = found.role == Role::F && words.iter().any(is_held);
    let is_wanted = has(&NOT_MEASURED) || has(&PERHAPS_WANTED);
    // Nothing that stands still, that numbers the rows, too, or that is said to be something else than what was there.
    let is_none = !preview.moves(column) || numbers_rows(column, preview) || has(&OF_ANOTHER);
    if is_none || is_wanted && !is_held {
        return false;
    }
    match found.role {
        Role::Count => numbers_rows(found.column, preview) && called(heading) >= NAMED,
        // A flag is none, and `T_out` may be a temperature.
        Role::F => {
            let is_letter = words
                .first()
                .is_some_and(|word| ["t", "m"].contains(&word.as_str()));
            let is_flag =
                preview.is_mode(column) && own_unit(kind, heading, scene.motion).is_none();
            is_held && !is_letter && !is_flag
        }
        _ => {
            let other = role(kind, headings, column, preview, scene);
            let Some(other) = other.filter(|other| other.role == found.role) else {
                return false;
            };
            // In a unit, what an encoder says is rounded to its ticks, and not where the device was, if both moved alike.
            let is_rounded = found.role == Role::X
                && is_called_a_count(&heading.name)
                && !moved_apart([found, &other], headings, preview, scene);
            let is_said = called(heading) > own || is_plainly_measured(heading);
            is_said && !is_rounded && !was_made(heading)
        }
    }
}

/// Whether two positions in units moved from the first row on by lengths that are more ticks apart than rounding makes them.
fn moved_apart(
    columns: [&Found; 2],
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> bool {
    const TICKS: f64 = 2.0;
    let [Some(a), Some(b)] = columns.map(|found| {
        let own = own_unit(Kind::Position, headings.get(found.column)?, scene.motion);
        let scale = position_scale(found.unit.as_deref().or(own.as_deref()), scene).ok()?;
        let numbers = preview.numbers(found.column);
        let first = *numbers.first()?;
        let moved = numbers.into_iter().map(move |x| (x - first) * scale.size());
        Some(moved.collect::<Vec<f64>>())
    }) else {
        return false;
    };
    scene.given.has_encoder() && a.iter().zip(&b).any(|(a, b)| (a - b).abs() > TICKS)
}

/// Whether a column is the number of the row, from 0 or 1 on, of as many rows as tell: an encoder that moves evenly is none.
fn numbers_rows(column: usize, preview: &Preview) -> bool {
    let is_start = preview
        .first(column)
        .is_some_and(|first| first == 0.0 || first == 1.0);
    let is_next = preview.is_even(column) && preview.step(column) == Some(1.0);
    is_start && is_next && preview.no_number(column).is_none()
}

/// Why a column that is called as a role is may not be meant.
pub(crate) fn why_in_doubt(found: &Found) -> &'static str {
    match found.role {
        Role::Count => "is the number of the row in each of the first rows, and may be no position",
        Role::F => "may be another force than the one that was held",
        _ => "may be another position than the one that was measured",
    }
}

/// Where a column is meant that is called as its role is.
pub(crate) fn plain_is_meant(plain: &Found, headings: &[Heading]) -> String {
    let name = headings.get(plain.column).map_or("", |it| it.name.trim());
    let what = match plain.role {
        Role::F => "force that was held",
        _ => "position",
    };
    format!("`{}` is the {what}", shown(name.as_bytes()))
}

/// The columns with this one in the place of another of its kind.
pub(crate) fn with_plain(plain: &Found, found: &[Found]) -> Vec<Found> {
    let is_other = |found: &Found| Kind::of(found.role) == Kind::of(plain.role);
    let meant = |found: &Found| if is_other(found) { plain } else { found }.clone();
    let others = found
        .iter()
        .filter(|it| is_other(it) || it.column != plain.column);
    others.map(meant).collect()
}
