//! Positions that were measured, and those that were made of them: after a filter, at another time, or of another device.

use passivity_scene::{Motion, Scene};

use super::axes::AXES;
use super::kind::Kind;
use super::score::called;
use super::words::{MADE, MEASURED, NOT_MEASURED, OF_ANOTHER, PERHAPS_WANTED, words};
use super::{LIKELY, beside_axes};
use crate::log::header::{Heading, split};
use crate::log::preview::Preview;

/// What a column is called, without its unit, which is no word: `y [m]` is not said to be measured.
fn stem(heading: &Heading) -> &str {
    split(&heading.name).map_or(heading.name.as_str(), |split| split.stem)
}

/// Whether the name of a column has a word of a list.
pub(super) fn has_one(heading: &Heading, list: &[&str]) -> bool {
    words(stem(heading))
        .iter()
        .any(|word| list.contains(&word.as_str()))
}

/// Whether a position is said to be measured.
fn is_measured(heading: &Heading) -> bool {
    has_one(heading, &MEASURED)
}

/// Whether nothing else is said of it, but which axis it is: `actual`, `y_meas`.
pub(super) fn is_plainly_measured(heading: &Heading) -> bool {
    let is_it = |word: &str| MEASURED.contains(&word) || AXES.contains(&word);
    is_measured(heading) && words(stem(heading)).iter().all(|word| is_it(word))
}

/// Whether a position is said to be made of another one, as a filtered one is: by the end of a path, as what is before it may
/// be the name of a program's model.
pub(super) fn was_made(heading: &Heading) -> bool {
    let end = stem(heading).rsplit('/').next().unwrap_or_default();
    let is_it = |word: &str| MADE.contains(&word) || OF_ANOTHER.contains(&word);
    words(end).iter().any(|word| is_it(word))
}

/// Whether a column that has positions may have those that were measured: it is called a position, or is said to be measured,
/// and is said to be neither made of another one nor wanted.
fn may_be_measured(heading: &Heading, motion: Motion) -> bool {
    let is_wanted = has_one(heading, &NOT_MEASURED) || has_one(heading, &PERHAPS_WANTED);
    let is_named = called(Kind::Position, heading, motion) >= LIKELY && !is_wanted;
    (is_named || is_measured(heading)) && !was_made(heading)
}

/// Of columns with positions those that go behind the others: what was made, where one of the others may be measured, and the
/// axis `x` where it rests and another one moves.
pub(super) fn behind(
    columns: &[usize],
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> Vec<usize> {
    let heading = |column: usize| headings.get(column);
    let mut all = columns.iter().filter_map(|column| heading(*column));
    let has_measured = all.any(|it| may_be_measured(it, scene.motion));
    let axis = beside_axes(headings, preview, scene).map(|x| x.column);
    let is_behind = |column: &usize| {
        let is_made = has_measured && heading(*column).is_some_and(was_made);
        is_made || axis == Some(*column) && !preview.moves(*column)
    };
    columns.iter().copied().filter(is_behind).collect()
}
