//! What a header that is not understood may mean: the columns, offered as they can be typed.
//!
//! A guess is never acted upon. It goes by the words in a name, by the unit, and by the first rows: a
//! clock runs forward, and where its name says no unit, it is the one in which it ticks about once a sampling period.

use std::cell::LazyCell;

use passivity_scene::{Motion, Scene};

use crate::log::columns::{Found, Role};
use crate::log::header::{Heading, is_of_recorder, is_unit_of_force, split};
use crate::log::preview::Preview;
pub(crate) use axes::beside_axes;
pub(crate) use clock::other_unit;
use clock::{Parts, counter, parts_of_time};
use joints::Joints;
pub(crate) use joints::{of_two, others};
use kind::Kind;
pub(crate) use proposal::propose;
pub use proposal::{Otherwise, Proposal};
use read::role;
pub(crate) use read::with_unit;
pub(crate) use rising::only_rises;
pub(crate) use rivals::{in_doubt, plain_is_meant, why_in_doubt, with_plain};
use score::{called, held, may_be_force, own_unit, score};
pub(crate) use units::same_letters;
pub(crate) use whole::{either, has_no_unit, is_unclear, no_encoder, units_of_motion};
use words::{COUNTED, OF_STEPS, words};

mod axes;
mod clock;
mod joints;
mod kind;
mod lengths;
mod made;
mod proposal;
mod read;
mod rising;
mod rivals;
mod score;
mod side;
mod units;
mod whole;
mod words;

/// Whether two roles are about the same.
pub(crate) fn are_kin(a: Role, b: Role) -> bool {
    Kind::of(a) == Kind::of(b)
}

/// Whether a column is called like what this role says, where its unit is none of a force, or is a force by its unit.
pub(crate) fn is_called(role: Role, heading: &Heading, motion: Motion) -> bool {
    let is_force = role == Role::F;
    match has_force(heading) {
        true => is_force,
        false => called(Kind::of(role), heading, motion) >= LIKELY,
    }
}

/// Whether the unit of a column says that it is something else than its name does.
pub(crate) fn is_another(found: &Found, headings: &[Heading]) -> bool {
    let heading = headings.get(found.column);
    heading.is_some_and(|heading| units::is_of_another(Kind::of(found.role), &heading.name))
}

/// Whether a column that is read as a value at the device seems to be one at the motor.
pub(crate) fn is_at_motor(
    found: &Found,
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let heading = headings.get(found.column);
    let not_at_device =
        |heading| side::not_at_device(Kind::of(found.role), heading, found.column, preview, scene);
    heading.and_then(not_at_device).is_some()
}

impl Found {
    pub(crate) fn is_position(&self) -> bool {
        Kind::of(self.role) == Kind::Position
    }
}

/// Whether a column only counts sampling periods, or ticks of a clock.
pub(crate) fn is_counter(headings: &[Heading], preview: &Preview, column: usize) -> bool {
    counter(headings, preview, column).is_some()
}

/// From this score on a column is taken for what it looks like.
const LIKELY: i32 = 2;

/// A column that may be what is looked for.
struct Candidate {
    kind: Kind,
    column: usize,
    score: i32,
}

/// A column that is called like something that is not said, or has a unit of force, and cannot be read.
pub(crate) struct Unreadable {
    pub(crate) column: usize,
    pub(crate) why: String,
    kind: Kind,
    /// Whether it is taken for a clock for nothing but its rise from row to row.
    pub(crate) rises: bool,
    /// Whether it is called as a clock is and seems to be none, which says what is to be done about it.
    pub(crate) is_no_clock: bool,
    /// Whether it seems to be a value at the motor, behind a transmission.
    pub(crate) is_at_motor: bool,
}

impl Unreadable {
    pub(crate) fn is_clock(&self) -> bool {
        self.kind == Kind::Time
    }

    pub(crate) fn is_force(&self) -> bool {
        self.kind == Kind::Force
    }

    pub(crate) fn is_position(&self) -> bool {
        self.kind == Kind::Position
    }
}

/// Whether a column is nothing of a kind, by the unit in its name; or no position, as its steps rise from row to row or are of
/// a time, and may be those of a program.
fn is_none_of(kind: Kind, heading: &Heading, column: usize, preview: &Preview) -> bool {
    let words = words(&heading.name);
    let has_step = words.iter().any(|word| OF_STEPS.contains(&word.as_str()));
    let numbers_rows = preview.increases(column) && preview.first(column) >= Some(0.0);
    let is_of_time = numbers_rows || words.iter().any(|it| Kind::Time.is_named(it));
    let has_unit = split(&heading.name).is_ok_and(|split| split.unit.is_some());
    let may_number_rows = kind == Kind::Position && has_step && is_of_time && !has_unit;
    may_number_rows || units::is_of_another(kind, &heading.name)
}

/// Whether a column is taken for a force by nothing but a word of command, or a unit, in the place of its name.
pub(crate) fn is_only_command(
    found: &Found,
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
) -> bool {
    let is_it = |heading: &Heading| {
        may_be_force(heading, found.column, preview, scene)
            && called(Kind::Force, heading, scene.motion) < LIKELY
    };
    found.role == Role::F && headings.get(found.column).is_some_and(is_it)
}

/// Whether the name of a column gives a unit of force, wherever it stands.
fn has_force(heading: &Heading) -> bool {
    let unit = split(&heading.name).ok().and_then(|split| split.unit);
    unit.is_some_and(|unit| is_unit_of_force(&unit)) || units::encloses_force(&heading.name)
}

/// The columns that look like something that is not said, and cannot be read: the most likely of each kind.
pub(crate) fn unreadable(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    said: &[Found],
) -> Vec<Unreadable> {
    // A counter stands in for no other clock.
    let is_it = |found: &Found| found.is_position() || !is_counter(headings, preview, found.column);
    let said_of = |kind| said.iter().filter(move |f| Kind::of(f.role) == kind);
    let is_open = |kind: &Kind| !said_of(*kind).any(is_it);
    let of_kind = |kind: Kind| {
        let columns = (0..).zip(headings);
        let free = columns.filter(|(column, _)| !said.iter().any(|f| f.column == *column));
        let called = free.filter_map(|(column, heading)| {
            let mut score = called(kind, heading, scene.motion);
            if kind == Kind::Force
                && (has_force(heading) || may_be_force(heading, column, preview, scene))
            {
                score += LIKELY;
            }
            let is_time = kind == Kind::Time;
            let has_lengths = is_time && lengths::has_lengths(heading, column, preview, scene);
            if has_lengths || is_time && is_counter(headings, preview, column) {
                score = LIKELY;
            } else if is_time && preview.still(column).is_some() {
                // As of a clock that does not rise where it can be read.
                let has_unit = own_unit(kind, heading, scene.motion).is_some();
                score -= if has_unit { 1 } else { 3 };
            }
            let is_passed_over =
                is_time && lengths::is_passed_over(headings, column, preview, scene);
            if is_passed_over || is_none_of(kind, heading, column, preview) {
                return None;
            }
            let why = held(kind, headings, column, preview, scene).err()?;
            let no_clock = || lengths::no_clock(headings, column, preview, scene);
            let is_no_clock = is_time && no_clock().as_ref() == Some(&why);
            let unreadable = Unreadable {
                column,
                why,
                kind,
                rises: false,
                is_no_clock,
                is_at_motor: side::is_at_motor(kind, heading, scene),
            };
            (score >= LIKELY).then_some((score, unreadable))
        });
        // Of equals the first column.
        let called: Vec<_> = called.collect();
        called.into_iter().rev().max_by_key(|(score, ..)| *score)
    };
    let open = Kind::ALL.into_iter().filter(is_open);
    let mut found: Vec<Unreadable> = Vec::new();
    for (_, unreadable) in open.filter_map(of_kind) {
        if found.iter().all(|other| other.column != unreadable.column) {
            found.push(unreadable);
        }
    }
    if !found.iter().any(Unreadable::is_clock) {
        found.extend(rising::unreadable_clock(headings, preview, scene, said));
    }
    found
}

/// Whether a unit is that of an encoder's counts.
pub(crate) fn is_counted(unit: &str) -> bool {
    words(unit)
        .iter()
        .any(|word| COUNTED.contains(&word.as_str()))
}

/// Whether a name says that a column has the counts of an encoder.
fn is_called_a_count(name: &str) -> bool {
    let is_it = |word: &String| ["encoder", "enc"].contains(&word.as_str());
    is_counted(name) || words(name).iter().any(is_it)
}

/// The columns that look like something that is not yet said, the most likely of each kind; or, where nothing is called like
/// a clock, one that rises like one.
pub(crate) fn unread(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    said: &[Found],
) -> Vec<Found> {
    let mut found = named(headings, preview, scene, said);
    let known: Vec<Found> = said.iter().chain(&found).cloned().collect();
    found.extend(rising::clock(headings, preview, scene, &known));
    found
}

/// Those that are called so, or have its unit.
pub(crate) fn named(
    headings: &[Heading],
    preview: &Preview,
    scene: &Scene,
    said: &[Found],
) -> Vec<Found> {
    let mut candidates: Vec<Candidate> = Vec::new();
    for kind in Kind::ALL {
        if said.iter().any(|found| Kind::of(found.role) == kind) {
            continue;
        }
        for column in 0..headings.len() {
            if said.iter().any(|found| found.column == column) {
                continue;
            }
            if let Some(score) = score(kind, headings, column, preview, scene) {
                candidates.push(Candidate {
                    kind,
                    column,
                    score,
                });
            }
        }
    }
    // What is of the joint of the position goes before what is of another. What only counts up goes behind another clock and
    // another position. Of equals what is not zero goes before what is, what is said together with the position before what is
    // said elsewhere, what says its joint before what does not, what moves before what does not, and then the first column: the
    // sort is stable.
    let counts_up = |c: &Candidate| {
        is_counter(headings, preview, c.column)
            || c.kind == Kind::Position && preview.counts_rows(c.column)
    };
    let [has_clock, has_place] = [Kind::Time, Kind::Position].map(|kind| {
        let mut of_kind = candidates.iter().filter(|c| c.kind == kind);
        of_kind.any(|c| !counts_up(c))
    });
    let is_timed = has_clock || said.iter().any(|f| Kind::of(f.role) == Kind::Time);
    // Alone with what is not known, as even as a clock is none but one.
    let is_clock = |column| !is_timed && headings.len() > 1 && preview.is_even(column);
    let in_doubt = in_doubt(headings, preview, scene);
    let places = candidates
        .iter()
        .filter(|c| c.kind == Kind::Position && !counts_up(c));
    let places: Vec<usize> = places.map(|c| c.column).collect();
    let behind = made::behind(&places, headings, preview, scene);
    let goes_behind = |c: &Candidate| match c.kind {
        _ if in_doubt.iter().any(|found| found.column == c.column) => true,
        Kind::Time => has_clock && counts_up(c),
        Kind::Position if behind.contains(&c.column) => true,
        Kind::Position => (has_place || is_clock(c.column)) && counts_up(c),
        Kind::Force | Kind::Velocity => false,
    };
    let columns_of = |kind: Kind| -> Vec<usize> {
        let columns = candidates
            .iter()
            .filter(|c| c.kind == kind)
            .map(|c| c.column);
        let said = said.iter().filter(|found| Kind::of(found.role) == kind);
        columns.chain(said.map(|found| found.column)).collect()
    };
    let [forces, velocities] = [Kind::Force, Kind::Velocity].map(columns_of);
    let joints = |kind, columns| {
        LazyCell::new(move || Joints::new((kind, columns), (headings, preview), scene))
    };
    let of_forces = joints(Kind::Force, forces.as_slice());
    let of_velocities = joints(Kind::Velocity, velocities.as_slice());
    let force = said.iter().find(|found| found.role == Role::F);
    let has_force = |at: usize| {
        forces.is_empty()
            || forces
                .iter()
                .any(|it| of_forces.is_of(at, *it) != Some(false))
    };
    let likely = |c: &Candidate| {
        let is_place = c.kind == Kind::Position;
        let behind = goes_behind(c) || is_place && force.is_some() && !has_force(c.column);
        (!behind, c.score, !preview.is_zero(c.column))
    };
    // Of equal positions one whose joint has a force, where others have one.
    let best = |kind: Kind| {
        let of_kind = candidates.iter().filter(|c| c.kind == kind);
        let key = |c: &Candidate| (likely(c), preview.moves(c.column));
        let most = of_kind.clone().map(key).max();
        let mut equal = of_kind.filter(|c| Some(key(c)) == most).map(|c| c.column);
        let first = equal.clone().next();
        equal.find(|at| has_force(*at)).or(first)
    };
    let position = said.iter().find(|found| found.is_position());
    let position = position.map(|found| found.column);
    let position = position.or_else(|| best(Kind::Position));
    // The force and the velocity of its joint, even where they are zero in the first rows.
    let is_of = |c: &Candidate| match (position?, c.kind) {
        (at, Kind::Force) => of_forces.is_of(at, c.column),
        (at, Kind::Velocity) => of_velocities.is_of(at, c.column),
        (at, Kind::Position) => (c.column == at).then_some(true),
        (_, Kind::Time) => None,
    };
    // The clock of the messages that say the position goes before that of the recorder, and of other messages.
    let is_own = |c: &Candidate| {
        c.kind == Kind::Time
            && !counts_up(c)
            && position.is_some_and(|at| preview.together(at, c.column))
            && !is_of_recorder(headings, c.column)
    };
    let owns: Vec<usize> = candidates
        .iter()
        .filter(|c| is_own(c))
        .map(|c| c.column)
        .collect();
    let is_other =
        |c: &Candidate| c.kind == Kind::Time && !owns.is_empty() && !owns.contains(&c.column);
    candidates.sort_by_cached_key(|c| {
        let (is_near, score, is_moved) = likely(c);
        let is_own = is_of(c);
        let first = (!is_other(c), is_own != Some(false), is_near, score);
        let together = position.map(|at| preview.together(at, c.column));
        let second = (is_moved, together, is_own == Some(true));
        std::cmp::Reverse((first, second, preview.moves(c.column)))
    });
    // A velocity of another joint says nothing of this one.
    candidates.retain(|c| c.kind != Kind::Velocity || is_of(c) != Some(false));
    let mut found: Vec<Found> = Vec::new();
    for Candidate { kind, column, .. } in candidates {
        if found
            .iter()
            .any(|f| f.column == column || Kind::of(f.role) == kind)
        {
            continue;
        }
        let read = |column| role(kind, headings, column, preview, scene);
        let parts = parts_of_time(headings, preview, column);
        if let (Kind::Time, Parts::Two([whole, beyond])) = (kind, parts) {
            // Neither part says alone when a sample was.
            if scene.motion != Motion::Dimensionless {
                found.extend(read(whole));
                let role = Role::Fine;
                found.extend(read(beyond).map(|found| Found { role, ..found }));
            }
            continue;
        }
        found.extend(read(column));
    }
    found
}
