//! The columns of a trace: which there are, in which units, and how their values become ticks,
//! sampling periods and KΔ.

use passivity_scene::Scene;

use crate::log::columns::{Columns, Found, Role, unit_of};
use crate::log::digits::Digits;
use crate::log::error::{TraceError, shown};
use crate::log::findings::Beside;
use crate::log::guess::{self, Unreadable};
use crate::log::header::Heading;
use crate::log::names::{by_name, is_no_clock, is_no_length, is_no_time};
use crate::log::preview::Preview;
use crate::log::scale::{Scale, force_scale, position_scale, time_scale, velocity_scale};
use crate::number::{Number, difference, is_positive, quotient};
use fine::Fine;
pub use form::Form;
use form::form;
use refused::{not_read, proposal, unknown_position};

/// The most columns of a trace.
pub(crate) const MAX_COLUMNS: usize = 4096;

/// What the header says.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub(crate) form: Form,
    /// The column of the position; of `xi0` in a ledger.
    pub(crate) position: usize,
    /// The column of `xi1` in a ledger.
    pub(crate) end: Option<usize>,
    pub(crate) dtau: Option<usize>,
    pub(crate) time: Option<usize>,
    /// The second column of the time, where it is in two.
    pub(crate) fine: Option<Fine>,
    pub(crate) force: Option<usize>,
    pub(crate) velocity: Option<usize>,
    /// The columns as they were told, each with what it says.
    pub(crate) headings: Vec<Heading>,
    said: Vec<Found>,
    /// What the file says beside them.
    pub(crate) beside: Beside,
    scale: Scale,
    /// Units of time over the sampling period.
    per_period: Number,
    per_force: Scale,
    /// KΔ in a unit of force.
    pub(crate) size_of_force: f64,
    /// Of the forces, as far as the first rows of a text show.
    pub(crate) digits: Digits,
    /// Ticks per sampling period in a unit of velocity.
    pub(crate) per_velocity: f64,
}

impl Layout {
    /// Reads the names of the columns: as they are `told`, or by the names that say it themselves.
    pub(crate) fn read(
        headings: Vec<Heading>,
        told: Option<&Columns>,
        preview: &Preview,
        scene: &Scene,
    ) -> Result<Self, TraceError> {
        if headings.len() > MAX_COLUMNS {
            return Err(header(format!("a trace may have {MAX_COLUMNS} columns")));
        }
        // No proposal leaves out what the header says itself.
        let proposed = |mut error: TraceError, said: &[Found]| {
            let of = |said| proposal(&headings, said, preview, scene);
            let found = of(said).or_else(|| of(&[]));
            error.proposal = found.filter(|proposal| proposal.said >= said.len());
            error
        };
        let said = match told {
            Some(columns) => columns.find(&headings).map_err(|mut error| {
                // What was typed is kept.
                let meant = columns.meant(&headings, preview, scene);
                error.proposal = meant.and_then(|said| proposal(&headings, &said, preview, scene));
                error
            })?,
            None => {
                if let Some(layout) = Self::of_ledger(&headings, scene)? {
                    return Ok(layout);
                }
                let mut said = by_name(&headings).map_err(|e| proposed(e, &[]))?;
                let is_no_clock = is_no_clock(&said, &headings, preview, scene);
                let mut in_doubt = guess::in_doubt(&headings, preview, scene);
                in_doubt.extend(guess::beside_axes(&headings, preview, scene));
                said.retain(|found| {
                    !(is_no_clock && found.role == Role::Tau
                        || in_doubt.contains(found)
                        || is_no_time(found, &headings, preview)
                        || guess::is_another(found, &headings)
                        || is_no_length(found, &headings, scene)
                        || guess::is_unclear(found, &headings, preview, scene))
                });
                let unread = guess::unread(&headings, preview, scene, &said);
                let known: Vec<Found> = said.iter().chain(&unread).cloned().collect();
                let unreadable = guess::unreadable(&headings, preview, scene, &known);
                if !(unread.is_empty() && unreadable.is_empty()) {
                    let why = not_read(&said, &unread, &unreadable, (&headings, preview), scene);
                    let mut error = proposed(why, &said);
                    let is_there = unreadable.iter().any(Unreadable::is_position);
                    error.message += &match known.iter().any(Found::is_position) {
                        true => String::new(),
                        false if is_there => {
                            "; if this is not the position, `--columns` names the column that is"
                                .to_owned()
                        }
                        false => unknown_position(&known, &headings, scene),
                    };
                    return Err(error);
                }
                said
            }
        };
        if told.is_some() && !said.iter().any(Found::is_position) {
            let message = "`--columns` leaves the position out: name its column there, too, as `count`, `x` or `xi`";
            return Err(proposed(header(message), &said));
        }
        let sound = |found: Result<Self, TraceError>| match told {
            // What was typed is not offered again.
            Some(_) => found,
            None => found.map_err(|error| proposed(error, &said)),
        };
        sound(Self::of(&said, &headings, scene))
    }

    /// The layout of columns that say these things.
    fn of(said: &[Found], headings: &[Heading], scene: &Scene) -> Result<Self, TraceError> {
        let find = |role: Role| said.iter().find(|found| found.role == role);
        let name = |found: &Found| match headings.get(found.column) {
            Some(heading) => heading.name.clone(),
            None => format!("number {}", found.column + 1),
        };
        let (form, position) = form(said, headings)?;
        if form == Form::Count && !scene.given.has_encoder() {
            return Err(header(guess::no_encoder(scene.motion)).column(name(position)));
        }
        let scale = match (form, &position.unit) {
            (Form::X, unit) => position_scale(unit.as_deref(), scene)
                .map_err(|error| error.column(name(position)))?,
            (Form::Count, Some(unit)) if !guess::is_counted(unit) => {
                return Err(header("a count has no unit").column(name(position)));
            }
            (Form::Xi, Some(_)) => {
                let message = "ticks have no unit: `x [unit]` is for positions with one";
                return Err(header(message).column(name(position)));
            }
            _ => Scale::One,
        };
        let signed = |scale: Scale, found: &Found| match found.reversed {
            true => scale.reversed(),
            false => scale,
        };
        let is_clock = |found: &&Found| {
            let unit = headings.get(found.column).and_then(|heading| heading.unit);
            !matches!(found.role, Role::T | Role::Fine) && unit.is_some()
        };
        if let Some(clock) = said.iter().find(is_clock) {
            let message = format!(
                "the type of this column is a time, and `{}` is none",
                clock.role.name()
            );
            return Err(TraceError::new("type", message).column(name(clock)));
        }
        let (time, tau) = (find(Role::T), find(Role::Tau));
        if let (Some(_), Some(tau)) = (time, tau) {
            let message = "the time is given twice, as `t` and as `tau`";
            return Err(header(message).column(name(tau)));
        }
        let mut per_period = match time {
            Some(found) => time_scale(unit_of(found, headings)?.as_deref(), scene)
                .map_err(|error| error.column(name(found)))?,
            None => Number::whole(1),
        };
        let fine = match find(Role::Fine) {
            Some(found) => {
                let named = |error: TraceError| error.column(name(found));
                let unit = unit_of(found, headings)?;
                let own = time_scale(unit.as_deref(), scene).map_err(named)?;
                let fine = Fine::new(found.column, &own, &per_period).map_err(named)?;
                per_period = own;
                Some(fine)
            }
            None => None,
        };
        let per_force = match find(Role::F) {
            Some(found) => {
                let scale = force_scale(found.unit.as_deref(), scene);
                signed(scale.map_err(|error| error.column(name(found)))?, found)
            }
            None => Scale::One,
        };
        let per_velocity = match find(Role::V) {
            Some(found) => {
                let scale = velocity_scale(found.unit.as_deref(), scene);
                let scale = scale.map_err(|error| error.column(name(found)))?;
                if found.reversed { -scale } else { scale }
            }
            None => 1.0,
        };
        Ok(Self {
            form,
            position: position.column,
            end: None,
            dtau: None,
            time: time.or(tau).map(|found| found.column),
            fine,
            force: find(Role::F).map(|found| found.column),
            velocity: find(Role::V).map(|found| found.column),
            headings: headings.to_vec(),
            said: said.to_vec(),
            beside: Beside::default(),
            scale: signed(scale, position),
            per_period,
            size_of_force: per_force.size(),
            digits: Digits::default(),
            per_force,
            per_velocity,
        })
    }

    /// The name of a column.
    pub(crate) fn name(&self, column: usize) -> String {
        match self.headings.get(column) {
            Some(heading) => heading.name.clone(),
            None => format!("number {}", column + 1),
        }
    }

    /// What is read, as it can be asked for.
    pub(crate) fn proposal(&self) -> Option<Box<guess::Proposal>> {
        guess::propose(&self.said, &self.headings).map(Box::new)
    }

    /// What is read, as it can be typed; with the sign of the force turned, where that is asked for.
    pub(crate) fn typed(&self, turned: bool) -> Option<String> {
        let mut said = self.said.clone();
        for found in said.iter_mut().filter(|f| turned && f.role == Role::F) {
            found.reversed = !found.reversed;
        }
        Some(guess::propose(&said, &self.headings)?.columns)
    }

    /// The columns that are read.
    pub(crate) fn read_columns(&self) -> impl Iterator<Item = usize> {
        let read = [
            Some(self.position),
            self.end,
            self.dtau,
            self.time,
            self.fine_column(),
            self.force,
            self.velocity,
        ];
        read.into_iter().flatten()
    }

    /// The columns that are not read. What else a ledger says follows from its positions.
    pub(crate) fn not_read(&self) -> Vec<String> {
        if self.form == Form::Ledger {
            return Vec::new();
        }
        let unread =
            (0..self.width()).filter(|column| self.read_columns().all(|read| read != *column));
        let names = unread.map(|column| match self.name(column).trim() {
            "" => format!("number {}", column + 1),
            name => shown(name.as_bytes()),
        });
        names.chain(self.beside.topics.iter().cloned()).collect()
    }

    /// How many columns there are.
    pub(crate) fn width(&self) -> usize {
        self.headings.len()
    }

    /// Whether positions, or forces that are `applied`, are known only between two ends.
    pub(crate) const fn encloses(&self, applied: bool) -> bool {
        matches!(self.form, Form::Count)
            || self.scale.is_irrational()
            || (applied && self.per_force.is_irrational())
    }

    /// Δτ between two times; `None` unless the second is later.
    pub(crate) fn duration(&self, from: &Number, to: &Number) -> Option<Number> {
        if let Some(found) = self.short_duration(from, to) {
            return found;
        }
        let dt = difference(to, from);
        is_positive(&dt).then(|| quotient(&dt, &self.per_period))
    }

    /// As [`duration`](Self::duration), as a fraction, between two times over the same power of ten; `None` where
    /// that does not fit, or is not above zero.
    #[inline]
    pub(crate) fn periods(&self, from: i64, to: i64, power: i64) -> Option<(i64, i64)> {
        let (factor, denominator) = self.periods_over(power)?;
        let dt = to.checked_sub(from).filter(|dt| *dt > 0)?;
        Some((dt.checked_mul(factor)?, denominator))
    }

    /// What a difference of times over a power of ten is multiplied by, and the denominator of what that makes.
    #[inline]
    pub(crate) fn periods_over(&self, power: i64) -> Option<(i64, i64)> {
        match &self.per_period {
            Number::Small(n @ 1.., m) => Some((*m, power.checked_mul(*n)?)),
            _ => None,
        }
    }

    /// As [`duration`](Self::duration), for times with as many digits that small integers are enough for;
    /// `None` where they are not.
    #[inline]
    fn short_duration(&self, from: &Number, to: &Number) -> Option<Option<Number>> {
        let (Number::Small(a, d), Number::Small(b, e), Number::Small(n, m)) =
            (from, to, &self.per_period)
        else {
            return None;
        };
        if *n <= 0 {
            return None;
        }
        // Decimals and doubles have denominators of which one divides the other.
        let (a, b, d) = match (d, e) {
            _ if d == e => (*a, *b, d),
            _ if e % d == 0 => (a.checked_mul(e / d)?, *b, e),
            _ if d % e == 0 => (*a, b.checked_mul(d / e)?, d),
            _ => return None,
        };
        let dt = b.checked_sub(a)?;
        if dt <= 0 {
            return Some(None);
        }
        let periods = Number::Small(dt.checked_mul(*m)?, d.checked_mul(*n)?);
        Some(Some(periods))
    }

    /// How positions become ticks.
    pub(crate) const fn scale(&self) -> &Scale {
        &self.scale
    }

    /// How forces become multiples of KΔ.
    pub(crate) const fn per_force(&self) -> &Scale {
        &self.per_force
    }
}

pub(crate) fn header(message: impl Into<String>) -> TraceError {
    TraceError::new("header", message)
}

mod even;
mod fine;
mod form;
pub(super) mod refused;
