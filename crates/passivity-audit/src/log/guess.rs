//! What a header that is not understood may mean: the columns, offered as they can be typed.
//!
//! A guess is never acted upon. It goes by the words in a name, by the unit, and by the first rows: a
//! clock runs forward, and where its name says no unit, it is the one in which it ticks about once a sampling period.

use passivity_scene::{Motion, Scene};

use crate::log::columns::{Found, Role};
use crate::log::header::{Heading, is_of_recorder, is_unit_of_force, split};
use crate::log::preview::Preview;
pub(crate) use axes::beside_axes;
pub(crate) use clock::other_unit;
use clock::{Counter, Parts, counter, parts_of_time, unit_of_time};
pub(crate) use joints::others;
use kind::Kind;
pub(crate) use proposal::propose;
pub use proposal::{Otherwise, Proposal};
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
    // What only counts up goes behind another clock and another position. Of equals what is not zero goes before what
    // is, what is said together with the position before what is said elsewhere, what is of its joint before what is of
    // another, what moves before what does not, and then the first column: the sort is stable.
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
    let likely = |c: &Candidate| (!goes_behind(c), c.score, !preview.is_zero(c.column));
    let best = |kind: Kind| {
        let of_kind = candidates.iter().filter(|c| c.kind == kind);
        let most = of_kind
            .rev()
            .max_by_key(|c| (likely(c), preview.moves(c.column)));
        most.map(|c| c.column)
    };
    let position = said.iter().find(|found| found.is_position());
    let position = position.map(|found| found.column);
    let position = position.or_else(|| best(Kind::Position));
    let beside = |c: &Candidate| {
        position.map(|at| {
            let is_of = joints::is_of(at, (c.kind, c.column), headings);
            (preview.together(at, c.column), is_of)
        })
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
    candidates.sort_by_key(|c| {
        let likely = (!is_other(c), likely(c));
        std::cmp::Reverse((likely, beside(c), preview.moves(c.column)))
    });
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

/// What exactly a column of a kind says.
fn role(
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
