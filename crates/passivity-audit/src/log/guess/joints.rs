//! Columns that are called alike, as those of several joints: which go together, and which may be meant as well.

use std::collections::{BTreeMap, BTreeSet};

use passivity_scene::Scene;

use super::axes::AXES;
use super::kind::Kind;
use super::made::was_made;
use super::words::{
    COMMANDED, COMMANDER, HELD, MADE, MEASURED, NOT_MEASURED, OF_ANOTHER, PERHAPS_HELD,
    PERHAPS_WANTED, words,
};
use super::{LIKELY, score};
use crate::log::columns::{Found, Role};
use crate::log::error::shown;
use crate::log::header::{Heading, is_of_recorder, split};
use crate::log::preview::Preview;

/// The parts of a name, in lower case: words, numbers, and a letter behind one of its kind, as that of the axis in `fx`.
fn parts(kind: Kind, heading: &Heading) -> Vec<String> {
    let stem = match split(&heading.name) {
        Ok(split) => split.stem,
        Err((stem, _)) => stem,
    };
    let mut runs: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in stem.chars() {
        let continues = c.is_numeric() == before.is_numeric()
            && before.is_alphanumeric()
            && (before.is_uppercase() || !c.is_uppercase());
        match runs.last_mut() {
            Some(run) if continues => run.extend(c.to_lowercase()),
            _ if c.is_alphanumeric() => runs.push(c.to_lowercase().collect()),
            _ => {}
        }
        before = c;
    }
    let is_of_kind = |word: &str| {
        let is_letter = kind == Kind::Force && ["t", "m"].contains(&word);
        is_letter || kind.words().contains(&word)
    };
    let split = |run: String| match run.char_indices().next_back() {
        Some((at, _)) if at > 0 && is_of_kind(run.split_at(at).0) => {
            let (word, letter) = run.split_at(at);
            vec![word.to_owned(), letter.to_owned()]
        }
        _ => vec![run],
    };
    runs.into_iter().flat_map(split).collect()
}

/// Whether a part of a name says something of one and the same thing, as that it was measured, and not of which joint it is.
fn is_said_of_one(part: &str) -> bool {
    let lists: [&[&str]; 9] = [
        &MEASURED,
        &MADE,
        &NOT_MEASURED,
        &PERHAPS_WANTED,
        &OF_ANOTHER,
        &HELD,
        &PERHAPS_HELD,
        &COMMANDED,
        &COMMANDER,
    ];
    lists.iter().any(|list| list.contains(&part))
}

/// The columns of a kind by the parts of their names, and the parts that stand in each place of names which are alike but for it.
#[derive(Default)]
struct Alike {
    columns: BTreeMap<usize, Vec<String>>,
    places: BTreeMap<(usize, String), BTreeSet<String>>,
}

impl Alike {
    fn new(columns: impl Iterator<Item = (usize, Vec<String>)>) -> Self {
        let mut alike = Self::default();
        for (column, parts) in columns {
            for (at, part) in parts.iter().enumerate() {
                let place = alike.places.entry((at, but(&parts, at))).or_default();
                place.insert(part.clone());
            }
            alike.columns.insert(column, parts);
        }
        alike
    }

    /// Whether a name has the part by which that of a column differs from others, or one of theirs; `None` for neither, or both.
    fn has_part(&self, column: usize, parts: &[String]) -> Option<bool> {
        let own = self.columns.get(&column)?;
        let of_place = |(at, part): (usize, &String)| {
            let place = self.places.get(&(at, but(own, at)))?;
            let is_other = |it: &String| it != part && place.contains(it) && !is_said_of_one(it);
            let has_other = parts.iter().any(is_other);
            let has = place.len() > 1 && parts.contains(part);
            (has != has_other).then_some(has)
        };
        let places = own.iter().enumerate();
        let of_joint = places.filter(|(_, part)| !is_said_of_one(part));
        of_joint.filter_map(of_place).min()
    }
}

/// A name but for the part in one place.
fn but(parts: &[String], at: usize) -> String {
    let [before, after] = [parts.get(..at), parts.get(at + 1..)].map(Option::unwrap_or_default);
    format!("{} {}", before.join(" "), after.join(" "))
}

/// Which positions go with which forces, or velocities.
pub(super) struct Joints {
    positions: Alike,
    others: Alike,
}

impl Joints {
    /// Of the forces, or the velocities, in these columns.
    pub(super) fn new(
        (kind, columns): (Kind, &[usize]),
        (headings, preview): (&[Heading], &Preview),
        scene: &Scene,
    ) -> Self {
        let positions = (0..).zip(headings).filter_map(|(column, heading)| {
            let parts = parts(Kind::Position, heading);
            let is_axis = matches!(parts.as_slice(), [only] if AXES.contains(&only.as_str()));
            let is_position =
                is_axis || score(Kind::Position, headings, column, preview, scene).is_some();
            is_position.then_some((column, parts))
        });
        let others = columns.iter().filter_map(|column| {
            let heading = headings.get(*column)?;
            Some((*column, parts(kind, heading)))
        });
        Self {
            positions: Alike::new(positions),
            others: Alike::new(others),
        }
    }

    /// Whether one of these is of the joint, or the axis, of which a position is, by the parts in which names that are alike
    /// differ; `None` where they do not say.
    pub(super) fn is_of(&self, position: usize, column: usize) -> Option<bool> {
        let [at, own] = [
            self.positions.columns.get(&position)?,
            self.others.columns.get(&column)?,
        ];
        let by_position = self.positions.has_part(position, own);
        by_position
            .into_iter()
            .chain(self.others.has_part(column, at))
            .min()
    }
}

/// The columns that may be forces, with those that are.
fn forces(headings: &[Heading], preview: &Preview, scene: &Scene, found: &[Found]) -> Vec<usize> {
    let is_found = |column| {
        found
            .iter()
            .any(|it| it.role == Role::F && it.column == column)
    };
    let may_be = |column| score(Kind::Force, headings, column, preview, scene).is_some();
    (0..headings.len())
        .filter(|column| is_found(*column) || may_be(*column))
        .collect()
}

/// A position and a force that seem to be of two joints, where one of them is not said: what is to be said about them.
pub(crate) fn of_two(
    (said, found): (&[Found], &[Found]),
    (headings, preview): (&[Heading], &Preview),
    scene: &Scene,
) -> Option<String> {
    let position = found.iter().find(|found| found.is_position())?;
    let force = found.iter().find(|found| found.role == Role::F)?;
    let is_said = |it: &Found| said.iter().any(|other| other.column == it.column);
    if is_said(position) && is_said(force) {
        return None;
    }
    let forces = forces(headings, preview, scene, found);
    let joints = Joints::new((Kind::Force, &forces), (headings, preview), scene);
    let is_of = joints.is_of(position.column, force.column);
    let name = |column: usize| {
        let name = headings.get(column).map_or("", |it| it.name.trim());
        shown(name.as_bytes())
    };
    (is_of == Some(false)).then(|| {
        format!(
            "`{}` seems to be the force of another joint or axis than `{}`: `--columns` names the position and the force of one",
            name(force.column),
            name(position.column)
        )
    })
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
    let is_found = |column: usize| found.iter().any(|it| it.column == column);
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
        // A force that was commanded is the one that counts.
        let is_commanded = move |column| {
            let heading: Option<&Heading> = headings.get(column);
            let words = heading.map_or_else(Vec::new, |it| words(&it.name));
            let is_it = |word: &String| {
                let lists: [&[&str]; 3] = [&HELD, &PERHAPS_HELD, &COMMANDED];
                lists.iter().any(|list| list.contains(&word.as_str()))
            };
            kind == Kind::Force && preview.moves(column) && words.iter().any(is_it)
        };
        let columns = (0..headings.len()).filter(is_asked);
        columns.filter(move |column| {
            let score = score(*column);
            !is_found(*column) && (score >= least || score.is_some() && is_commanded(*column))
        })
    });
    let mut alike: Vec<usize> = alike.collect();
    // Beside a position of the header the force of another joint, with the position of that.
    let forces = forces(headings, preview, scene, found);
    if let Some(position) = found.iter().find(|found| found.is_position())
        && forces.iter().any(|force| alike.contains(force))
    {
        let joints = Joints::new((Kind::Force, &forces), (headings, preview), scene);
        let positions = joints.positions.columns.keys().copied();
        let is_of = |at, force: usize| joints.is_of(at, force);
        let is_theirs = |at: &usize| {
            let mut forces = forces.iter().filter(|force| alike.contains(force));
            forces.any(|force| {
                is_of(position.column, *force) == Some(false) && is_of(*at, *force) == Some(true)
            })
        };
        let theirs = positions.filter(|at| !is_found(*at) && is_theirs(at));
        let theirs: Vec<usize> = theirs.collect();
        alike.extend(theirs);
    }
    let mut names: Vec<String> = Vec::new();
    for heading in alike.iter().filter_map(|column| headings.get(*column)) {
        let name = shown(heading.name.as_bytes());
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names
}
