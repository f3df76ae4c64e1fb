//! Columns that are called alike, as those of several joints: which go together, and which may be meant as well.

use passivity_scene::Scene;

use super::kind::Kind;
use super::made::was_made;
use super::{LIKELY, score};
use crate::log::columns::Found;
use crate::log::error::shown;
use crate::log::header::{Heading, is_of_recorder, split};
use crate::log::preview::Preview;

/// What a name says beside the words of its kind: `knob` of `position.knob`, `joint1` of `joint1_pos`.
fn joint(kind: Kind, heading: &Heading) -> Vec<String> {
    let stem = match split(&heading.name) {
        Ok(split) => split.stem,
        Err((stem, _)) => stem,
    };
    let parts = stem.split(|c: char| !c.is_alphanumeric());
    let parts = parts.filter(|part| !part.is_empty()).map(str::to_lowercase);
    parts
        .filter(|part| !kind.words().contains(&part.as_str()))
        .collect()
}

/// Whether a column of a kind seems to be of the joint of which this position is.
pub(super) fn is_of(position: usize, (kind, column): (Kind, usize), headings: &[Heading]) -> bool {
    let [of_position, own] = [(Kind::Position, position), (kind, column)]
        .map(|(kind, column)| headings.get(column).map(|heading| joint(kind, heading)));
    of_position == own
}

/// The columns that may be the position, or the force, as well as those that were found and not said.
pub(crate) fn others(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    (said, found): (&[Found], &[Found]),
) -> Vec<String> {
    let guessed = found
        .iter()
        .filter(|it| said.iter().all(|other| other.column != it.column));
    let alike = guessed.flat_map(|guessed| {
        let kind = Kind::of(guessed.role);
        let score = move |column| score(kind, headings, column, preview, scene);
        // A position of which it is less clear, as `x_d` beside `x_m`, may be it still.
        let less = if kind == Kind::Position { 3 } else { 0 };
        let least = score(guessed.column).map(|score| score - less);
        // Of one that was made of another, all others.
        let made = headings
            .get(guessed.column)
            .filter(|it| kind == Kind::Position && was_made(it));
        let least = made.map_or(least, |_| Some(LIKELY));
        // Of other clocks only those of a recorder are named.
        let is_asked = move |column: &usize| match kind {
            Kind::Position | Kind::Force => true,
            Kind::Time => is_of_recorder(headings, *column),
            Kind::Velocity => false,
        };
        let columns = (0..headings.len()).filter(is_asked);
        columns.filter(move |column| {
            found.iter().all(|it| it.column != *column) && score(*column) >= least
        })
    });
    let names = alike.filter_map(|column| headings.get(column));
    names
        .map(|heading| shown(heading.name.as_bytes()))
        .collect()
}
