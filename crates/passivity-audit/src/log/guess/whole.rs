//! Positions without a unit that may be counts: nobody knows how long a count is where the scene has no encoder.

use passivity_scene::{Motion, Scene};

use super::score::own_unit;
use super::{Kind, is_called_a_count, is_counted, propose};
use super::{side, units};
use crate::log::columns::{Found, Role};
use crate::log::header::Heading;
use crate::log::preview::Preview;
use crate::shell::shell_word;

/// What a scene without an encoder lacks for counts.
pub(crate) const fn no_encoder(motion: Motion) -> &'static str {
    match motion {
        Motion::Linear => {
            "counts need a scene with an encoder, which has the lines `[encoder]` and `resolution = \"… um\"`, the \
             length of a count"
        }
        _ => {
            "counts need a scene with an encoder, which has the lines `[encoder]` and `counts_per_revolution = …`"
        }
    }
}

/// Whether a column of positions has counts; or why that cannot be told, or they cannot be read.
pub(super) fn counts(
    heading: &Heading,
    column: usize,
    preview: &Preview,
    scene: &Scene,
) -> Result<bool, String> {
    let has_encoder = scene.given.has_encoder();
    let is_whole = preview.is_whole(column);
    if let Some(unit) = own_unit(Kind::Position, heading, scene.motion) {
        return match is_counted(&unit) && !has_encoder {
            true => Err(no_encoder(scene.motion).to_owned()),
            false => Ok(is_counted(&unit) && has_encoder && is_whole),
        };
    }
    let is_named = is_called_a_count(&heading.name);
    let is_bare = scene.motion == Motion::Dimensionless;
    if is_bare || units::said(Kind::Position, &heading.name, scene.motion) != Ok(None) {
        return Ok(has_encoder && is_whole && is_named);
    }
    let units = match scene.motion {
        Motion::Linear => "`m`, `mm` or `um`",
        _ if has_encoder => "`rad`, `deg` or `rev`",
        // Others are read only beside an encoder.
        _ => "`rad` or `mrad`",
    };
    match (is_whole, has_encoder) {
        (false, _) if !is_counted(&heading.name) => Ok(false),
        (false, true) => Err(format!(
            "it is called a count, and has numbers that are not whole: its name must give their unit, such as {units}"
        )),
        (true, true) if is_named || preview.moves(column) => Ok(true),
        // What does not move in a whole log does no work in any unit.
        (true, _) if !is_named && !preview.moves(column) && !preview.may_go_on() => Ok(false),
        (true, true) => Err(format!(
            "it has no unit, and its first rows have one and the same whole number, of counts or of a unit such as {units}"
        )),
        (_, false) => Err(format!(
            "it has numbers without a unit that may be counts: {}; if they are no counts, its name must give their unit, \
             such as {units}",
            no_encoder(scene.motion)
        )),
    }
}

/// Units in which positions are logged, each with that of velocities: first those that are assumed where the header gives none.
pub(crate) const fn units_of_motion(motion: Motion) -> [[&'static str; 2]; 2] {
    match motion {
        Motion::Linear => [["m", "m/s"], ["mm", "mm/s"]],
        _ => [["rad", "rad/s"], ["deg", "deg/s"]],
    }
}

/// Whether the name of a column gives no unit of what is read from it.
pub(crate) fn has_no_unit(found: &Found, headings: &[Heading], scene: &Scene) -> bool {
    let kind = Kind::of(found.role);
    headings.get(found.column).is_some_and(|heading| {
        own_unit(kind, heading, scene.motion).is_none()
            && units::said(kind, &heading.name, scene.motion) == Ok(None)
    })
}

/// Columns with a position that may be counts or have a unit: all ways to name it, as they can be typed.
pub(crate) fn either(
    column: usize,
    (known, headings, preview): (&[Found], &[Heading], &Preview),
    scene: &Scene,
) -> Option<String> {
    let heading = headings.get(column)?;
    let found = |role, unit: Option<&str>| Found {
        role,
        column,
        unit: unit.map(str::to_owned),
        reversed: false,
    };
    let has_none = has_no_unit(&found(Role::X, None), headings, scene);
    let is_open = scene.given.has_encoder() && has_none && preview.is_whole(column);
    // In a unit it would be one of a motor, and no position of the device.
    let is_at_motor = side::is_at_motor(Kind::Position, heading, scene);
    if !is_open || is_at_motor || scene.motion == Motion::Dimensionless {
        return None;
    }
    let typed = |found| {
        let all: Vec<Found> = known.iter().cloned().chain([found]).collect();
        propose(&all, headings).map(|proposal| shell_word(&proposal.columns))
    };
    let counts = typed(found(Role::Count, None))?;
    let [first, second] =
        units_of_motion(scene.motion).map(|[unit, _]| typed(found(Role::X, Some(unit))));
    Some(format!(
        "`--columns {counts}`, `--columns {}` or, say, `--columns {}`",
        first?, second?
    ))
}

/// Whether a name says that a column is the position, but not whether it has counts that can be read.
pub(crate) fn is_unclear(
    found: &Found,
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let is_open = match found.role {
        Role::X => found.unit.as_deref().is_none_or(is_counted),
        Role::Count => !scene.given.has_encoder(),
        _ => false,
    };
    let heading = headings.get(found.column);
    is_open && heading.is_some_and(|it| counts(it, found.column, preview, scene).is_err())
}
