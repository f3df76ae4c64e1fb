//! Rows of a CSV trace that are nothing but short decimals, read in one pass.

use crate::log::chunk::{Chunk, Samples};
use crate::log::columns::Role;
use crate::log::csv::Notation;
use crate::log::header::Heading;
use crate::log::layout::{Form, Layout};
use crate::log::numbers::decimal;
use crate::log::running::near_number;
use crate::number::leading_decimal;

/// What the columns of a log hold, for rows of nothing but short decimals.
pub(crate) struct Slots {
    /// By column.
    roles: Vec<Option<Role>>,
    delimiter: u8,
}

impl Slots {
    /// `None` for other logs.
    pub(crate) fn of(layout: &Layout, notation: Notation) -> Option<Self> {
        let is_dated = |time| layout.headings.get(time).is_some_and(Heading::is_dated);
        let is_plain = layout.form != Form::Ledger
            && !notation.decimal_comma
            && layout.fine.is_none()
            && !layout.time.is_some_and(is_dated);
        if !is_plain || notation.delimiter == b'.' || notation.delimiter == b'-' {
            return None;
        }
        let mut roles = vec![None; layout.width()];
        let columns = [
            (Some(layout.position), Role::X),
            (layout.time, Role::T),
            (layout.force, Role::F),
            (layout.velocity, Role::V),
        ];
        for (column, role) in columns {
            if let Some(column) = column {
                *roles.get_mut(column)? = Some(role);
            }
        }
        Some(Self {
            roles,
            delimiter: notation.delimiter,
        })
    }

    /// Appends the row at the start of a text, and gives its length with its line break; `None`, and nothing
    /// appended, for a row that is for the careful parser. What is known of its position and of its force is for
    /// [`Chunk::complete`] to find out.
    #[inline(always)]
    pub(crate) fn push(&self, text: &[u8], layout: &Layout, chunk: &mut Chunk) -> Option<usize> {
        let rows = chunk.samples.len();
        let length = self.append(text, layout, chunk);
        if length.is_none() {
            chunk.truncate(rows);
        }
        length
    }

    /// The same, but for `None`: then there may be parts of a row.
    #[inline(always)]
    fn append(&self, text: &[u8], layout: &Layout, chunk: &mut Chunk) -> Option<usize> {
        let mut at = 0;
        let mut ended = false;
        for role in &self.roles {
            if ended {
                return None;
            }
            if self.delimiter == b' ' {
                at += text.get(at..)?.iter().take_while(|c| **c == b' ').count();
            }
            let rest = text.get(at..)?;
            let length = match role {
                // In quotes what stands between fields may be part of one.
                None => memchr::memchr3(self.delimiter, b'\n', b'"', rest)
                    .filter(|end| rest.get(*end) != Some(&b'"'))?,
                Some(role) => {
                    let ((n, k), length) = leading_decimal(rest, self.delimiter)?;
                    match (role, &mut chunk.samples) {
                        (Role::T, _) => chunk.times.push_decimal(n, k),
                        (Role::F, _) => {
                            chunk.forces.values.push_decimal(n, k);
                            let rounding = layout.digits.half_a_unit_of(n, k);
                            chunk.forces.roundings.push(rounding * layout.size_of_force);
                        }
                        (Role::V, _) => {
                            let near = near_number(&decimal(n, k));
                            chunk.velocities.push(near * layout.per_velocity);
                        }
                        (_, Samples::Any(samples)) => samples.push_decimal(n, k),
                        (_, Samples::Counts(counts)) if k == 0 => counts.push(n),
                        (_, Samples::Counts(_)) => return None,
                    }
                    length
                }
            };
            let end = rest.get(length)?;
            ended = *end != self.delimiter;
            at += length + if *end == b'\r' { 2 } else { 1 };
        }
        ended.then_some(at)
    }
}
