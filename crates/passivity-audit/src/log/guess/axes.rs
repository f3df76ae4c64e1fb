//! A position `x` that is one of several axes, as `x`, `y` and `z` are.

use passivity_scene::Scene;

use super::kind::Kind;
use super::{role, score};
use crate::log::columns::{Found, Role};
use crate::log::header::{Heading, split};
use crate::log::names::by_name;
use crate::log::preview::Preview;

/// The axes of a space, each of which is a position where it stands beside another.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// Whether a column is called as an axis is, by that letter alone, and not as the position is.
pub(super) fn is_axis(heading: &Heading) -> bool {
    split(&heading.name).is_ok_and(|split| {
        let stem = split.stem.to_lowercase();
        stem != "x" && AXES.contains(&stem.as_str())
    })
}

/// The column `x` where another axis moves in the first rows: which one the wall is at is not said.
pub(crate) fn beside_axes(headings: &[Heading], preview: &Preview, scene: &Scene) -> Option<Found> {
    let said = by_name(headings).ok()?;
    let x = said.into_iter().find(|found| found.role == Role::X)?;
    let is_other = |(column, heading): (usize, &Heading)| {
        is_axis(heading)
            && preview.moves(column)
            && score(Kind::Position, headings, column, preview, scene).is_some()
            && role(Kind::Position, headings, column, preview, scene)
                .is_some_and(|other| other.role == Role::X)
    };
    (0..).zip(headings).any(is_other).then_some(x)
}
