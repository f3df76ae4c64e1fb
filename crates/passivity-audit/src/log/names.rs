//! Headers whose names say themselves what their columns are.

use passivity_scene::{Motion, Scene};

use crate::log::columns::{Found, Role};
use crate::log::error::TraceError;
use crate::log::guess;
use crate::log::header::{Heading, split};
use crate::log::layout::header;
use crate::log::preview::Preview;

/// The columns whose names say themselves what they are: `t [s]`, `x_rad`, `count`.
pub(crate) fn by_name(headings: &[Heading]) -> Result<Vec<Found>, TraceError> {
    let mut said: Vec<Found> = Vec::new();
    for (column, heading) in headings.iter().enumerate() {
        let split = split(&heading.name);
        let stem = match &split {
            Ok(split) => split.stem,
            Err((stem, _)) => stem,
        };
        let Some(role) = Role::ALL.into_iter().find(|role| role.name() == stem) else {
            // The name of something else, where no bracket is open.
            if let Err((_, message)) = split {
                return Err(header(message).column(&heading.name));
            }
            continue;
        };
        let split = split.map_err(|(_, message)| header(message).column(&heading.name))?;
        if role == Role::Tau && split.unit.is_some() {
            // A torque, or a time that is not in sampling periods.
            continue;
        }
        if said.iter().any(|found| found.role == role) {
            return Err(header(format!("the column `{stem}` is given twice")).column(&heading.name));
        }
        said.push(Found {
            role,
            column,
            unit: split.unit.map(|unit| unit.into_owned()),
            reversed: false,
        });
    }
    // Beside another clock `tau` is no time: it may be a torque.
    if said.iter().any(|found| found.role == Role::T) {
        said.retain(|found| found.role != Role::Tau);
    }
    Ok(said)
}

/// Whether a column `tau` is no time: another column looks like one, or it runs backward. It may be a
/// torque.
pub(crate) fn is_no_clock(
    said: &[Found],
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let Some(tau) = said.iter().find(|found| found.role == Role::Tau) else {
        return false;
    };
    let others: Vec<Found> = said
        .iter()
        .filter(|f| f.role != Role::Tau)
        .cloned()
        .collect();
    let unread = guess::named(headings, preview, scene, &others);
    let is_other = |f: &Found| {
        let is_clock = matches!(f.role, Role::T | Role::Tau) && f.column != tau.column;
        is_clock && !guess::is_counter(headings, preview, f.column)
    };
    let backward = scene.motion != Motion::Dimensionless && preview.runs_backward(tau.column);
    backward || unread.iter().any(is_other)
}

/// Whether a column is a time by its name, without a unit, whose values are something else than numbers: which unit they
/// are in is not the question then.
pub(crate) fn is_no_time(found: &Found, headings: &[Heading], preview: &Preview) -> bool {
    let heading = headings.get(found.column);
    let has_unit = found.unit.is_some() || heading.is_some_and(|heading| heading.unit.is_some());
    matches!(found.role, Role::T | Role::Tau) && !has_unit && preview.has_no_numbers(found.column)
}

/// Whether a column `x_m` is one of a device that turns: it may have been measured in another unit.
pub(crate) fn is_no_length(found: &Found, headings: &[Heading], scene: &Scene) -> bool {
    let heading = headings.get(found.column);
    found.role == Role::X && heading.is_some_and(|heading| heading.is_no_length(scene.motion))
}
