//! Clocks by what they hold, under whatever name: columns that are not read and rise from row to row.

use passivity_scene::{Motion, Scene};

use super::clock::{NO_TICK, is_about_one, nearest, nearest_unit};
use super::kind::Kind;
use super::score::own_unit;
use super::units::{is_of_another, not_unknown};
use super::words::words;
use super::{Unreadable, in_doubt, score, unreadable};
use crate::log::columns::{Found, Role};
use crate::log::header::{Heading, read_unit, split};
use crate::log::preview::Preview;

/// Names under which programs write the number of a row where nothing else was asked for.
const OF_ROWS: [&str; 4] = ["", "index", "level_0", "__index_level_0__"];

/// Words of what is counted one by one: rows, and so sampling periods.
const OF_NUMBERS: [&str; 24] = [
    "abtastung",
    "count",
    "counter",
    "cycle",
    "frame",
    "id",
    "idx",
    "index",
    "k",
    "line",
    "loop",
    "message",
    "msg",
    "n",
    "no",
    "nr",
    "number",
    "packet",
    "period",
    "row",
    "step",
    "takt",
    "zeile",
    "zyklus",
];

/// Whether a column is the number of each row, as pandas and R write it: it says no more than the rows do.
fn is_row_number(heading: &Heading, preview: &Preview, column: usize) -> bool {
    let name = heading.name.trim();
    (OF_ROWS.contains(&name) || name.starts_with("Unnamed: "))
        && preview.counts_rows(column)
        && [Some(0.0), Some(1.0)].contains(&preview.first(column))
}

/// The unit in which a column is a clock; `None` where it counts sampling periods.
fn unit(
    heading: &Heading,
    preview: &Preview,
    column: usize,
    scene: &Scene,
) -> Result<Option<String>, String> {
    if preview.lasting.contains(&column) {
        return Err("durations and times of day are not read".to_owned());
    }
    split(&heading.name).map_err(|(_, why)| why.to_owned())?;
    let bare = scene.motion == Motion::Dimensionless;
    if let Some(own) = own_unit(Kind::Time, heading, scene.motion) {
        read_unit(&own).map_err(|error| error.message)?;
        return match bare {
            true => Err("the scene has no units".to_owned()),
            false => Ok(Some(own)),
        };
    }
    not_unknown(&heading.name)?;
    let middle = preview.middle_step(column);
    let steps = [middle, preview.step(column)];
    let periods = |step: Option<f64>| match bare {
        true => step,
        false => nearest(step, scene).map(|(_, periods)| periods),
    };
    let is_near = |step| periods(step).is_some_and(is_about_one);
    let is_whole = preview.is_whole(column);
    let is_one_each = is_whole && middle == Some(1.0);
    // A unit of a clock that is a sampling period long is one, whatever is counted.
    let is_period = periods(Some(1.0)).is_some_and(|n| (n - 1.0).abs() < 1e-9);
    let words = words(&heading.name);
    let is_number = words.is_empty() || words.iter().any(|it| OF_NUMBERS.contains(&it.as_str()));
    if is_one_each && (is_number || is_period) {
        return Ok(None);
    }
    if is_one_each || (is_whole || bare) && !steps.into_iter().any(is_near) {
        return Err(NO_TICK.to_owned());
    }
    Ok((!bare).then(|| nearest_unit(middle, scene).to_owned()))
}

/// The columns that rise as a clock does, the most likely first, where a position is known and no clock: how each is read,
/// or why it cannot be.
fn rising(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    known: &[Found],
) -> Vec<Result<Found, Unreadable>> {
    let has_clock = known.iter().any(|found| Kind::of(found.role) == Kind::Time);
    if has_clock || !known.iter().any(Found::is_position) {
        return Vec::new();
    }
    let columns = (0..).zip(headings);
    let free = columns.filter(|(column, _)| known.iter().all(|found| found.column != *column));
    let rises = free.filter(|(column, heading)| {
        (preview.rises(*column) || preview.lasting.contains(column))
            && !is_row_number(heading, preview, *column)
            && !is_no_time(heading)
    });
    let read = |(column, heading): (usize, &Heading)| {
        let unit = unit(heading, preview, column, scene).map_err(|why| Unreadable {
            column,
            why,
            kind: Kind::Time,
            rises: true,
            is_no_clock: false,
            is_at_motor: false,
        })?;
        Ok(Found {
            role: if unit.is_some() { Role::T } else { Role::Tau },
            column,
            unit: unit.filter(|_| heading.unit.is_none()),
            reversed: false,
        })
    };
    let mut found: Vec<Result<Found, Unreadable>> = rises.map(read).collect();
    // What is called `count` may be a position rather than a clock that cannot be read.
    let in_doubt = in_doubt(headings, preview, scene);
    found.retain(|found| match found {
        Ok(_) => true,
        Err(it) => in_doubt.iter().all(|plain| plain.column != it.column),
    });
    // What has a unit says more than a counter; of equals the first column, as the sort is stable.
    found.sort_by_key(|found| match found {
        Ok(found) if found.role == Role::T => 0,
        Ok(_) => 1,
        Err(_) => 2,
    });
    found
}

/// Whether a name has the unit of something else.
fn is_no_time(heading: &Heading) -> bool {
    let unit = split(&heading.name).ok().and_then(|split| split.unit);
    if is_of_another(Kind::Time, &heading.name) {
        return true;
    }
    let read = unit.and_then(|unit| read_unit(&unit).ok());
    read.is_some_and(|unit| unit.dimension() != Kind::Time.dimension(Motion::Linear))
}

/// The clock among them, beside what is known already.
pub(super) fn clock(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    known: &[Found],
) -> Option<Found> {
    let rising = rising(headings, preview, scene, known);
    let found = rising.into_iter().find_map(Result::ok)?;
    // A clock that is called so, and cannot be read, is not replaced.
    let unreadable = unreadable(headings, preview, scene, known);
    (!unreadable.iter().any(Unreadable::is_clock)).then_some(found)
}

/// The one of them that cannot be read, where none can.
pub(super) fn unreadable_clock(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    known: &[Found],
) -> Option<Unreadable> {
    let rising = rising(headings, preview, scene, known);
    rising.into_iter().next()?.err()
}

/// Whether a column is taken for a clock for nothing but its rise from row to row.
pub(crate) fn only_rises(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    found: &Found,
) -> bool {
    Kind::of(found.role) == Kind::Time
        && score(Kind::Time, headings, found.column, preview, scene).is_none()
}
