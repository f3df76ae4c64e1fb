//! What a column is read as: its role, and its unit.

use passivity_scene::{Motion, Scene};

use super::clock::{Counter, counter, unit_of_time};
use super::kind::Kind;
use super::score::own_unit;
use super::{units, whole};
use crate::log::columns::{Found, Role};
use crate::log::header::Heading;
use crate::log::preview::Preview;

/// What exactly a column of a kind says.
pub(super) fn role(
    kind: Kind,
    headings: &[Heading],
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Option<Found> {
    let heading = headings.get(column)?;
    let own = own_unit(kind, heading, scene.motion);
    let counts = kind == Kind::Position
        && whole::counts(heading, column, preview, scene).is_ok_and(|counts| counts);
    let bare = scene.motion == Motion::Dimensionless;
    let role = match kind {
        _ if counts => Role::Count,
        Kind::Time if bare || counter(headings, preview, column) == Some(Counter::Periods) => {
            Role::Tau
        }
        Kind::Time => Role::T,
        Kind::Position if bare => Role::Xi,
        Kind::Position => Role::X,
        Kind::Velocity => Role::V,
        Kind::Force => Role::F,
    };
    let unit = match own.as_deref() {
        _ if bare || role.is_bare() => None,
        Some(unit) => units::respelt(kind, unit, scene.motion).map(str::to_owned),
        None => Some(unit_said(kind, heading, column, preview, scene)),
    };
    Some(Found {
        role,
        column,
        unit,
        reversed: false,
    })
}

/// What a column says, with the unit that its name should give.
pub(crate) fn with_unit(
    found: &Found,
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> Found {
    let bare = scene.motion == Motion::Dimensionless || found.role.is_bare();
    let heading = headings.get(found.column);
    let typed = heading.is_some_and(|heading| heading.unit.is_some());
    if bare || typed || found.unit.is_some() {
        return found.clone();
    }
    let kind = Kind::of(found.role);
    if kind == Kind::Position
        && let Some(counts) = heading.map(|it| whole::counts(it, found.column, preview, scene))
        && counts != Ok(false)
    {
        let role = counts.map_or(found.role, |_| Role::Count);
        return Found {
            role,
            ..found.clone()
        };
    }
    // A name with a unit of something else is given none.
    let is_open =
        |it: &&Heading| kind == Kind::Time || units::said(kind, &it.name, scene.motion).is_ok();
    let unit = heading.filter(is_open);
    let unit = unit.map(|heading| unit_said(kind, heading, found.column, preview, scene));
    Found {
        unit,
        ..found.clone()
    }
}

/// The unit that the name of a column seems to give, or else the one that is assumed.
fn unit_said(
    kind: Kind,
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> String {
    let said = units::said(kind, &heading.name, scene.motion);
    match (kind, said) {
        (Kind::Time, _) => unit_of_time(&heading.name, preview.step(column), scene).to_owned(),
        (_, Ok(Some(unit))) => unit,
        (kind, _) => kind.unit(scene.motion).to_owned(),
    }
}
