//! Which column of a log says what: `t=timestep [us], x=encoder_paddle_pos [deg], f=motor_torque [N.m]`.

use std::fmt;
use std::str::FromStr;

use crate::log::error::{TraceError, shown};
use crate::log::guess::same_letters;
use crate::log::header::{Heading, is_unit, read_unit, split};

mod meant;

/// What a column says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    /// The time of the sample, in a unit.
    T,
    /// What the time is beyond whole ones of its unit, in a smaller one.
    Fine,
    /// The time of the sample, in sampling periods.
    Tau,
    /// The position, in ticks.
    Xi,
    /// The position, in a unit.
    X,
    /// What the encoder counted.
    Count,
    /// The velocity, in a unit.
    V,
    /// The force that was held, in a unit.
    F,
}

impl Role {
    pub(crate) const ALL: [Self; 7] = [
        Self::T,
        Self::Tau,
        Self::Xi,
        Self::X,
        Self::Count,
        Self::V,
        Self::F,
    ];

    /// The name of a column that says it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::T | Self::Fine => "t",
            Self::Tau => "tau",
            Self::Xi => "xi",
            Self::X => "x",
            Self::Count => "count",
            Self::V => "v",
            Self::F => "f",
        }
    }

    /// Whether the role has no unit of its own.
    pub(crate) const fn is_bare(self) -> bool {
        matches!(self, Self::Tau | Self::Xi | Self::Count)
    }

    /// Whether a column with the other sign can say it.
    const fn has_sign(self) -> bool {
        matches!(self, Self::Xi | Self::X | Self::V | Self::F)
    }
}

/// A column that says something: which one, in which unit, and whether with the other sign.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Found {
    pub(crate) role: Role,
    pub(crate) column: usize,
    pub(crate) unit: Option<String>,
    pub(crate) reversed: bool,
}

/// What the columns of a log say, by their names: `t=timestep [us], x=encoder_paddle_pos [deg]`.
///
/// A name is written as in the header, with or without its unit; a unit in brackets is for a header
/// that has none. A minus sign before the name turns the sign of its numbers. A name with a comma, an
/// equals sign or a quote in it stands in double quotes, the quote twice. A time may be in two columns: `t=stamp.sec [s] + stamp.nanosec [ns]`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Columns(Vec<Assignment>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Assignment {
    role: Role,
    /// The name with its unit, as it was typed.
    text: String,
    /// Whether the name was in quotes: then it is the header's, letter by letter.
    quoted: bool,
    /// The unit typed after a quoted name.
    unit: Option<String>,
}

/// The kind of the error of a header that has none of a name.
pub(crate) const NO_COLUMN: &str = "no_column";

fn refuse(message: impl Into<String>) -> TraceError {
    TraceError::new("columns", message)
}

impl FromStr for Columns {
    type Err = TraceError;

    fn from_str(text: &str) -> Result<Self, TraceError> {
        let mut assignments: Vec<Assignment> = Vec::new();
        for part in parts(text, ",")? {
            let Some((role, name)) = part.split_once('=') else {
                let message = format!(
                    "expected `role=column`, as in `x=position [rad]`, found `{}`",
                    shown(part.as_bytes())
                );
                return Err(refuse(message));
            };
            let known = Role::ALL.into_iter().find(|r| r.name() == role.trim());
            let Some(role) = known else {
                let message = format!(
                    "`{}` is nothing that a column can say: expected one of t, tau, xi, x, count, v and f",
                    shown(role.trim().as_bytes())
                );
                return Err(refuse(message));
            };
            let names = match role {
                Role::T if name.contains(PLUS) => parts(name, PLUS)?,
                _ => vec![name.trim()],
            };
            for (i, name) in names.into_iter().enumerate() {
                let role = if i > 0 { Role::Fine } else { role };
                let assignment = Assignment::read(role, name)?;
                if assignments.iter().any(|other| other.role == role) {
                    return Err(refuse(format!("`{}` is given twice", role.name())));
                }
                assignments.push(assignment);
            }
        }
        Ok(Self(assignments))
    }
}

impl Assignment {
    fn read(role: Role, text: &str) -> Result<Self, TraceError> {
        if text.is_empty() {
            return Err(refuse(format!("`{}=` names no column", role.name())));
        }
        let sign = usize::from(text.starts_with("-\""));
        let Some(rest) = text.get(sign..).and_then(|rest| rest.strip_prefix('"')) else {
            return Ok(Self {
                role,
                text: text.to_owned(),
                quoted: false,
                unit: None,
            });
        };
        let Some((name, rest)) = unquoted(rest) else {
            return Err(refuse(format!(
                "the quotes after `{}=` are not closed",
                role.name()
            )));
        };
        let rest = rest.trim();
        let unit = rest.strip_prefix('[').and_then(|r| r.strip_suffix(']'));
        if unit.is_none() && !rest.is_empty() {
            return Err(refuse(format!(
                "expected a unit in brackets after `\"{}\"`, found `{}`",
                shown(name.as_bytes()),
                shown(rest.as_bytes())
            )));
        }
        Ok(Self {
            role,
            text: format!("{}{name}", if sign > 0 { "-" } else { "" }),
            quoted: true,
            unit: unit.map(|unit| unit.trim().to_owned()),
        })
    }

    /// The column of this name.
    fn find(&self, headings: &[Heading]) -> Result<Found, TraceError> {
        if let Some(found) = self.named(&self.text, false, headings)? {
            return Ok(found);
        }
        if let Some(rest) = self.text.strip_prefix('-')
            && let Some(found) = self.named(rest.trim_start(), true, headings)?
        {
            if !self.role.has_sign() {
                let message = format!("`{}` has no sign to turn", self.role.name());
                return Err(refuse(message));
            }
            return Ok(found);
        }
        let names = headings.iter().take(8).map(|h| shown(h.name.as_bytes()));
        let names = names.collect::<Vec<_>>().join("`, `");
        let more = if headings.len() > 8 { ", …" } else { "" };
        let message = format!(
            "there is no column `{}`: the header has `{names}`{more}",
            shown(self.text.as_bytes())
        );
        Err(TraceError::new(NO_COLUMN, message))
    }

    fn named(
        &self,
        text: &str,
        reversed: bool,
        headings: &[Heading],
    ) -> Result<Option<Found>, TraceError> {
        let typed = match (self.quoted, split(text)) {
            (false, Ok(typed)) if typed.unit.is_some() => Some(typed),
            _ => None,
        };
        let stem_of = |heading: &Heading| split(&heading.name).ok().map(|s| s.stem.to_owned());
        let stem = typed.as_ref().map(|typed| typed.stem);
        let ways: [&dyn Fn(&Heading) -> bool; 4] = [
            // The whole name, as the header has it.
            &|heading| heading.name.trim() == text,
            // The name in the header, with a unit added here.
            &|heading| stem.is_some_and(|stem| heading.name.trim() == stem),
            // The name without the unit that the header gives.
            &|heading| stem_of(heading).is_some_and(|own| own == text),
            // The name with its unit written in another way.
            &|heading| stem.is_some_and(|stem| stem_of(heading).is_some_and(|own| own == stem)),
        ];
        for (way, fits) in ways.iter().enumerate() {
            let mut fitting = (0..).zip(headings).filter(|(_, heading)| fits(heading));
            let Some((column, heading)) = fitting.next() else {
                continue;
            };
            if fitting.next().is_some() {
                let message = format!(
                    "the header has the column `{}` more than once",
                    shown(text.as_bytes())
                );
                return Err(refuse(message));
            }
            let own = split(&heading.name).ok().and_then(|own| own.unit);
            let added = match (&self.unit, way) {
                (Some(unit), _) => Some(unit.clone()),
                (None, 1 | 3) => typed
                    .as_ref()
                    .and_then(|typed| typed.unit.as_deref().map(str::to_owned)),
                (None, _) => None,
            };
            if let (Some(added), Some(own)) = (&added, &own)
                && contradicts(added, own)
                && (is_length(added) || !heading.may_be_metres())
            {
                let message = format!(
                    "the header says that `{}` is in `{}`, not in `{}`",
                    shown(heading.name.as_bytes()),
                    shown(own.as_bytes()),
                    shown(added.as_bytes())
                );
                return Err(refuse(message));
            }
            return Ok(Some(Found {
                role: self.role,
                column,
                unit: added.or(own.map(|own| own.into_owned())),
                reversed,
            }));
        }
        Ok(None)
    }
}

/// A name in quotes, in which one of its own is written twice.
pub(crate) fn quoted(name: &str) -> String {
    format!("\"{}\"", name.replace('"', "\"\""))
}

/// The name before closing quotes, and what is after them.
fn unquoted(text: &str) -> Option<(String, &str)> {
    let mut name = String::new();
    let mut rest = text;
    loop {
        let (before, after) = rest.split_once('"')?;
        name.push_str(before);
        match after.strip_prefix('"') {
            Some(after) => rest = after,
            None => return Some((name, after)),
        }
        name.push('"');
    }
}

/// The unit of a column: that of its type, where it has one, which the header may only repeat.
pub(crate) fn unit_of(found: &Found, headings: &[Heading]) -> Result<Option<String>, TraceError> {
    let heading = headings.get(found.column);
    let Some(own) = heading.and_then(|heading| heading.unit) else {
        return Ok(found.unit.clone());
    };
    match &found.unit {
        Some(unit) if !same_unit(unit, own) => {
            let message = format!(
                "the type of this column says that it is in `{own}`, not in `{}`",
                shown(unit.as_bytes())
            );
            let name = heading.map(|heading| heading.name.clone());
            Err(TraceError::new("unit", message).column(name.unwrap_or_default()))
        }
        _ => Ok(Some(own.to_owned())),
    }
}

/// Whether two names are of one unit.
pub(crate) fn same_unit(a: &str, b: &str) -> bool {
    matches!((read_unit(a), read_unit(b)), (Ok(a), Ok(b)) if a == b)
}

fn is_length(unit: &str) -> bool {
    matches!((read_unit(unit), read_unit("m")), (Ok(a), Ok(b)) if a.dimension() == b.dimension())
}

/// Whether a unit that was typed is another one than the header's. `torque_nm [N m]` is not.
fn contradicts(typed: &str, own: &str) -> bool {
    let (Ok(typed_unit), Ok(own_unit)) = (read_unit(typed), read_unit(own)) else {
        return is_unit(own);
    };
    let is_respelt = same_letters(typed, own) && typed_unit.dimension() != own_unit.dimension();
    typed_unit != own_unit && !is_respelt
}

/// What stands between the two parts of a time.
const PLUS: &str = " + ";

/// The text between separators that stand outside quotes and brackets.
fn parts<'t>(text: &'t str, separator: &str) -> Result<Vec<&'t str>, TraceError> {
    let mut parts = Vec::new();
    let (mut start, mut depth, mut quoted) = (0, 0_usize, false);
    for (at, c) in text.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '[' | '(' if !quoted => depth += 1,
            ']' | ')' if !quoted => depth = depth.saturating_sub(1),
            _ if quoted || depth > 0 => {}
            _ if text
                .get(at..)
                .is_some_and(|rest| rest.starts_with(separator)) =>
            {
                parts.extend(text.get(start..at));
                start = at + separator.len();
            }
            _ => {}
        }
    }
    if depth > 0 {
        return Err(refuse("a bracket is not closed"));
    }
    parts.extend(text.get(start..));
    let parts: Vec<&str> = parts.into_iter().map(str::trim).collect();
    if parts.iter().any(|part| part.is_empty()) {
        return Err(refuse(
            "expected `role=column` between commas, found nothing",
        ));
    }
    Ok(parts)
}

impl Columns {
    /// Whether a column of this topic is named.
    #[cfg(feature = "mcap")]
    pub(crate) fn mentions(&self, topic: &str) -> bool {
        let is_within = |text: &str| {
            text.strip_prefix(topic)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[', ' ']))
        };
        let texts = self.0.iter().map(|assignment| assignment.text.as_str());
        texts
            .flat_map(|text| [text, text.strip_prefix('-').unwrap_or(text).trim_start()])
            .any(is_within)
    }

    /// The columns of a header that these names say, each said once.
    pub(crate) fn find(&self, headings: &[Heading]) -> Result<Vec<Found>, TraceError> {
        let mut found: Vec<Found> = Vec::new();
        for assignment in &self.0 {
            let next = assignment.find(headings)?;
            if let Some(other) = found.iter().find(|other| other.column == next.column) {
                return Err(refuse(format!(
                    "the column `{}` is named for `{}` and for `{}`",
                    shown(assignment.text.as_bytes()),
                    other.role.name(),
                    next.role.name()
                )));
            }
            found.push(next);
        }
        Ok(found)
    }
}

/// As it can be typed.
impl fmt::Display for Columns {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, assignment) in self.0.iter().enumerate() {
            f.write_str(&before(assignment.role, i == 0))?;
            match (assignment.quoted, &assignment.unit) {
                (false, _) => f.write_str(&assignment.text)?,
                (true, unit) => {
                    f.write_str(&quoted(&assignment.text))?;
                    if let Some(unit) = unit {
                        write!(f, " [{unit}]")?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// What stands before the name of a column.
fn before(role: Role, is_first: bool) -> String {
    match role {
        Role::Fine => PLUS.to_owned(),
        role if is_first => format!("{}=", role.name()),
        role => format!(", {}=", role.name()),
    }
}

/// One assignment as it can be typed after another, with a unit that the header does not give; `None` when the name
/// cannot be shown or typed.
pub(crate) fn typed(
    found: &Found,
    heading: &Heading,
    unit: Option<&str>,
    is_first: bool,
) -> Option<String> {
    let name = heading.name.trim();
    if crate::log::error::is_hidden(name) {
        return None;
    }
    let balanced = name.matches('[').count() == name.matches(']').count()
        && name.matches('(').count() == name.matches(')').count();
    let plain = balanced
        && !name.is_empty()
        && !name.contains([',', '=', '"'])
        && !name.contains(PLUS)
        && !name.starts_with('-');
    let unit = unit.map_or_else(String::new, |unit| format!(" [{unit}]"));
    let sign = if found.reversed { "-" } else { "" };
    let before = before(found.role, is_first);
    Some(match plain {
        true => format!("{before}{sign}{name}{unit}"),
        false => format!("{before}{sign}{}{unit}", quoted(name)),
    })
}
