//! Columns that are called as a role is, beside others that may be meant: the number of each row under the name `count`, a
//! force `f` beside one that is said to be commanded, a position `x` beside one that is said to be measured.

use passivity_scene::Scene;

use super::kind::Kind;
use super::score::{called, score};
use super::words::{HELD, words};
use super::{is_called_a_count, role};
use crate::log::columns::{Found, Role};
use crate::log::error::shown;
use crate::log::header::Heading;
use crate::log::names::by_name;
use crate::log::preview::Preview;

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
    let is_held = || {
        let words = words(&heading.name);
        called(heading) >= NAMED && words.iter().any(|word| HELD.contains(&word.as_str()))
    };
    match found.role {
        Role::Count if numbers_rows(found.column, preview) => true,
        Role::F => is_held(),
        _ => {
            let other = role(kind, headings, column, preview, scene);
            let is_alike = other.is_some_and(|other| other.role == found.role);
            // In a unit, what an encoder says is rounded to its ticks, and not where the device was.
            let is_rounded = found.role == Role::X && is_called_a_count(&heading.name);
            is_alike && !is_rounded && called(heading) > own
        }
    }
}

/// Whether a column goes on by the same step in each row, as the number of a row does.
fn numbers_rows(column: usize, preview: &Preview) -> bool {
    preview.is_even(column) && preview.increases(column) && preview.no_number(column).is_none()
}

/// Why a column that is called as a role is may not be meant.
pub(crate) fn why_in_doubt(found: &Found, preview: &Preview) -> &'static str {
    match found.role {
        Role::Count if numbers_rows(found.column, preview) => {
            "goes on by the same step in each row, as the number of a row does, and may be no position"
        }
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
