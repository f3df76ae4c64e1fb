//! Headers that are refused: why, and what they may mean.

use passivity_scene::{Motion, Scene};

use super::{Layout, header};
use crate::log::columns::{Columns, Found, Role};
use crate::log::error::{TraceError, shown};
use crate::log::guess::{self, Otherwise, Unreadable};
use crate::log::header::{Heading, read_unit, split};
use crate::log::preview::Preview;
use crate::log::scale::{force_scale, in_radians, needs_radians};
use crate::shell::shell_word;

/// Why a header with columns that look like something else is refused, some of which cannot be read.
pub(super) fn not_read(
    known: &[Found],
    unread: &[Found],
    unreadable: &[Unreadable],
    (headings, preview): (&[Heading], &Preview),
    scene: &Scene,
) -> TraceError {
    let name = |column: usize| match headings.get(column).map_or("", |it| it.name.trim()) {
        "" => format!("number {}, which has no name,", column + 1),
        name => format!("`{}`", shown(name.as_bytes())),
    };
    let only_rises = |found: &&Found| guess::only_rises(headings, preview, scene, found);
    let (rising, called): (Vec<&Found>, Vec<&Found>) = unread.iter().partition(only_rises);
    let axis = guess::beside_axes(headings, preview, scene);
    let mut columns: Vec<usize> = called.iter().map(|found| found.column).collect();
    columns.retain(|column| axis.as_ref().is_none_or(|it| it.column != *column));
    columns.sort_unstable();
    let names: Vec<String> = columns.into_iter().map(name).collect();
    let mut said = match names.as_slice() {
        [] => Vec::new(),
        [name] => vec![format!("the column {name} is not read under this name")],
        names => vec![format!(
            "the columns {} are not read under these names",
            names.join(", ")
        )],
    };
    said.extend(rising.iter().map(|found| {
        format!(
            "the column {} rises from row to row as a clock does, and is not read: without a clock all rows are taken to be one \
             sampling period apart",
            name(found.column)
        )
    }));
    let in_doubt = guess::in_doubt(headings, preview, scene);
    said.extend(in_doubt.iter().map(|found| {
        let why = guess::why_in_doubt(found);
        format!("the column {} {why}", name(found.column))
    }));
    said.extend(axis.map(|found| {
        let name = name(found.column);
        format!(
            "the column {name} is one of several axes, and may not be the one that the wall is at"
        )
    }));
    let cannot_be_read = |column: usize, why: &str, put_right: &str| {
        format!(
            "the column {} cannot be read ({why}): {put_right}",
            name(column)
        )
    };
    let force = |column: usize, why: &str| cannot_be_read(column, why, FORCE) + LAW;
    let read: Vec<Found> = known.iter().chain(unread).cloned().collect();
    let others = guess::propose(&read, headings).map(|proposal| proposal.columns);
    said.extend(unreadable.iter().map(|unreadable| {
        let put_right = match scene.motion {
            _ if unreadable.is_at_motor => {
                let left_out = if unreadable.is_force() { LAW } else { "" };
                return format!("the column {} is not read: {}{left_out}", name(unreadable.column), unreadable.why);
            }
            _ if unreadable.rises => {
                let others = others.as_ref().map(|others| format!(": `--columns '{others}'`"));
                return format!(
                    "the column {} rises from row to row as a clock does, and cannot be read as one ({}): write its times as \
                     numbers in a unit that its name gives, as in `time [s]`, or, where it is no clock, name the others{}",
                    name(unreadable.column),
                    unreadable.why,
                    others.unwrap_or_default(),
                );
            }
            _ if unreadable.is_force() => return force(unreadable.column, &unreadable.why),
            _ if unreadable.is_position() => {
                let either = guess::either(unreadable.column, (&read, headings, preview), scene);
                let either = either.map_or_else(String::new, |ways| format!(": {ways}"));
                return format!("the column {} cannot be read: {}{either}", name(unreadable.column), unreadable.why);
            }
            _ if unreadable.is_no_clock => {
                return format!(
                    "the column {} cannot be read as a clock: {}; if `--columns` leaves it out, all rows are taken to be one \
                     sampling period apart",
                    name(unreadable.column),
                    unreadable.why
                );
            }
            _ if !unreadable.is_clock() => "name the others to leave it out",
            Motion::Dimensionless => {
                "write its times in sampling periods, as in `tau`; if `--columns` leaves it out, all rows are taken to be \
                 one apart"
            }
            _ => {
                "write its times as numbers in a unit that its name gives, as in `time [s]`, or in CSV as dates like \
                 `2023-11-14T22:13:20.5Z`; if `--columns` leaves it out, all rows are taken to be one sampling period apart"
            }
        };
        cannot_be_read(unreadable.column, &unreadable.why, put_right)
    }));
    said.extend(read.iter().filter_map(|found| {
        let heading = headings.get(found.column).filter(|_| found.role == Role::X)?;
        let own = split(&heading.name).ok()?.unit;
        let unit = read_unit(found.unit.as_deref().or(own.as_deref())?).ok()?;
        let in_radians = in_radians(&unit, scene)?;
        let name = name(found.column);
        let number = found.column + 1;
        let example = preview.delimiter.map_or_else(String::new, |delimiter| {
            let apart = delimiter.to_string().replace('\t', "\\t");
            format!(
                ", as with `awk -F'{apart}' -v OFS='{apart}' 'NR == 1 {{${number} = \"x [rad]\"}} NR > 1 {{${number} = \
                 sprintf(\"%.15g\", ${number} * {in_radians:?})}} 1' log.csv > radians.csv` of a log of one line of names and rows of \
                 numbers below it"
            )
        });
        Some(format!("the column {name} cannot be read: {}{example}", needs_radians(in_radians)))
    }));
    // Nor is a force of this name read, where its unit is another's.
    said.extend(known.iter().filter_map(|found| {
        let unit = found.unit.as_deref().filter(|_| found.role == Role::F)?;
        let why = force_scale(Some(unit), scene).err()?;
        Some(force(found.column, &why.message))
    }));
    said.extend(guess::of_two((known, &read), (headings, preview), scene));
    header(said.join("; "))
}

/// What is said where no column is known to be the position: the others as they can be typed, with a name in the place of
/// its column that the header does not have. None is filled in, for it may be anything, and would be read.
pub(super) fn unknown_position(known: &[Found], headings: &[Heading], scene: &Scene) -> String {
    const NAME: &str = "NAME";
    const UNIT: &str = "UNIT";
    let role = match scene.motion {
        _ if scene.given.has_encoder() => Role::Count,
        Motion::Dimensionless => Role::Xi,
        _ => Role::X,
    };
    let is_taken = headings.iter().any(|it| it.name.contains(NAME));
    let named = headings
        .iter()
        .cloned()
        .chain([Heading::plain(NAME.to_owned())]);
    let position = Found {
        role,
        column: headings.len(),
        unit: (role == Role::X).then(|| UNIT.to_owned()),
        reversed: false,
    };
    let all: Vec<Found> = known.iter().cloned().chain([position]).collect();
    let proposal = guess::propose(&all, &named.collect::<Vec<_>>()).filter(|_| !is_taken);
    let or_unit = match role {
        Role::Count => format!(", or `x={NAME} [{UNIT}]` with its unit where it has no counts"),
        Role::X => format!(", and its unit in place of `{UNIT}`"),
        _ => String::new(),
    };
    let example = proposal.map_or_else(String::new, |proposal| {
        let columns = shell_word(&proposal.columns);
        format!(", as in `--columns {columns}` with the name of its column in place of `{NAME}`{or_unit}")
    });
    format!("; and no column is known to be the position: `--columns` names it{example}")
}

/// What to do about a force that cannot be read.
const FORCE: &str =
    "write a number in each row, in a unit of the scene's forces that the name of the column gives";

/// What leaving it out would do, where an account is made.
pub(in crate::log) const LAW: &str = "; if `--columns` leaves it out, the account is of the force of the wall's law, not of the one that was \
    held";

/// What a header may mean, beyond what its columns say themselves, where that can be read and leaves out no clock, without
/// which late and missed samples would not be seen, and no force, without which the wall's law would be taken for it.
pub(super) fn proposal(
    headings: &[Heading],
    said: &[Found],
    preview: &Preview,
    scene: &Scene,
) -> Option<Box<guess::Proposal>> {
    let complete = |found| guess::with_unit(found, headings, preview, scene);
    let mut all: Vec<Found> = said.iter().map(complete).collect();
    all.extend(guess::unread(headings, preview, scene, said));
    let unreadable = guess::unreadable(headings, preview, scene, &all);
    if unreadable.iter().any(|it| it.is_clock() || it.is_force()) {
        return None;
    }
    // Nor what was typed of the motor, with a mistake, as if it were of the device.
    let is_at_motor = |found: &Found| guess::is_at_motor(found, headings, preview, scene);
    let of_two = guess::of_two((said, &all), (headings, preview), scene);
    if of_two.is_some() || all.iter().any(is_at_motor) {
        return None;
    }
    let mut proposal = guess::propose(&all, headings)?;
    let is_said = |found: &Found| said.iter().any(|it| it.column == found.column);
    let is_sure =
        |found: &&Found| is_said(found) || !guess::only_rises(headings, preview, scene, found);
    let sure: Vec<Found> = all.iter().filter(is_sure).cloned().collect();
    let in_doubt = guess::in_doubt(headings, preview, scene);
    proposal.others = guess::others(headings, preview, scene, (said, &all));
    // What is called as a role is has a command of its own.
    let has_command = |name: &String| {
        let mut plain = in_doubt.iter().filter_map(|it| headings.get(it.column));
        plain.any(|heading| *name == shown(heading.name.as_bytes()))
    };
    proposal.others.retain(|name| !has_command(name));
    let told = said.iter().filter_map(|found| {
        let unit = found.unit.as_ref()?;
        Some(format!("{} in {unit}", found.role.name()))
    });
    let told: Vec<String> = told.collect();
    proposal.assumed.retain(|assumed| !told.contains(assumed));
    // What is offered must be read when it is typed.
    let is_read = |columns: &str| {
        let found = columns.parse().and_then(|it: Columns| it.find(headings));
        found.is_ok_and(|found| Layout::of(&found, headings, scene).is_ok())
    };
    if !is_read(&proposal.columns) {
        return None;
    }
    let is_typed = |found: &Found| {
        let mut typed = said.iter().filter(|it| it.unit.is_some());
        typed.any(|it| it.column == found.column)
    };
    let is_assumed = |found: &Found| !is_typed(found) && guess::has_no_unit(found, headings, scene);
    let [_, [of_positions, of_velocities]] = guess::units_of_motion(scene.motion);
    let in_other_unit = |found: &Found| {
        let unit = match found.role {
            Role::X => of_positions,
            Role::V => of_velocities,
            _ => return found.clone(),
        };
        let unit = match is_assumed(found) {
            true => Some(unit.to_owned()),
            false => found.unit.clone(),
        };
        Found {
            unit,
            ..found.clone()
        }
    };
    let in_unit = format!("positions are in {of_positions}");
    let typed = |found: &[Found]| guess::propose(found, headings).map(|it| it.columns);
    // What the header leaves open as well: where each is meant, and what it makes of the columns.
    let mut ways: Vec<(Vec<String>, Vec<Found>)> = vec![(Vec::new(), all.clone())];
    let mut leaves_open = |condition: &str, other: &dyn Fn(&[Found]) -> Vec<Found>| {
        for (conditions, found) in ways.clone() {
            let found = other(&found);
            if ways.iter().all(|(_, own)| typed(own) != typed(&found)) {
                let conditions = conditions.into_iter().chain([condition.to_owned()]);
                ways.push((conditions.collect(), found));
            }
        }
    };
    leaves_open("it is no clock", &|_| sure.clone());
    for found in all.iter().filter(|it| it.role == Role::T && !is_typed(it)) {
        if let Some(unit) = guess::other_unit(found, headings, preview, scene) {
            leaves_open(&format!("times are in {unit}"), &|columns| {
                let mut columns = columns.to_vec();
                for it in columns.iter_mut().filter(|it| it.column == found.column) {
                    it.unit = Some(unit.to_owned());
                }
                columns
            });
        }
    }
    if all.iter().any(|it| it.role == Role::X && is_assumed(it)) {
        leaves_open(&in_unit, &|found| found.iter().map(in_other_unit).collect());
    }
    let is_only_command =
        |it: &&Found| !is_said(it) && guess::is_only_command(it, headings, preview, scene);
    // Where another column is called a force that one is meant then.
    let has_plain = in_doubt.iter().any(|plain| plain.role == Role::F);
    if let Some(force) = all.iter().find(is_only_command).filter(|_| !has_plain) {
        let name = headings.get(force.column).map_or("", |it| it.name.trim());
        leaves_open(
            &format!("`{}` is no force", shown(name.as_bytes())),
            &|found| {
                found
                    .iter()
                    .filter(|it| it.role != Role::F)
                    .cloned()
                    .collect()
            },
        );
    }
    for plain in in_doubt.iter().filter(|plain| !is_said(plain)) {
        leaves_open(&guess::plain_is_meant(plain, headings), &|found| {
            guess::with_plain(plain, found)
        });
    }
    for (conditions, found) in ways.into_iter().skip(1) {
        let columns = typed(&found)?;
        if is_read(&columns) {
            let condition = conditions.join(" and ");
            proposal.otherwise.push(Otherwise { condition, columns });
        } else if conditions == [in_unit.as_str()] {
            // Without an encoder angles are read only in radians.
            let assumed = format!("positions in {of_positions} are to be converted first");
            proposal.assumed.push(assumed);
        }
    }
    Some(Box::new(proposal))
}
