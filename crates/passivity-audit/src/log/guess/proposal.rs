//! A proposal, as it can be typed.

use std::fmt;

use super::is_called_a_count;
use crate::log::columns::{Found, Role, same_unit, typed};
use crate::log::header::{Heading, split};

/// The columns that a header seems to mean, as `passivity audit` takes them.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Proposal {
    /// For `--columns`.
    pub columns: String,
    /// For `--delimiter`, where it is not a comma.
    pub delimiter: Option<char>,
    /// Whether numbers are written with a comma.
    pub decimal_comma: bool,
    /// The units that the header does not give.
    pub assumed: Vec<String>,
    /// Columns that may be the position or the force as well, as those of other joints.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<String>,
    /// Other ways to read them, which the header leaves open as well.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub otherwise: Vec<Otherwise>,
    /// Whether one of them is the force.
    #[serde(skip)]
    pub(crate) has_force: bool,
    /// How many columns are read.
    #[serde(skip)]
    pub(crate) said: usize,
}

/// Another way to read the columns of a header, as `passivity audit` takes it.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Otherwise {
    /// Where it is meant: where the clock is none, as it is one only by its rise from row to row, where times or positions without
    /// a unit are in another one than is assumed, where what is called as a command is no force, or where a column is meant that
    /// is called `count`, `x` or `f`.
    pub condition: String,
    /// For `--columns`.
    pub columns: String,
}

impl fmt::Display for Proposal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "did you mean {}", self.columns)?;
        for Otherwise { condition, columns } in &self.otherwise {
            write!(f, ", or {columns} where {condition}")?;
        }
        f.write_str("?")?;
        if !self.assumed.is_empty() {
            let assumed = self.assumed.join(", ");
            write!(
                f,
                " (units that the header does not give are assumed: {assumed})"
            )?;
        }
        if !self.others.is_empty() {
            const SHOWN: usize = 6;
            let others: Vec<String> = self
                .others
                .iter()
                .take(SHOWN)
                .map(|it| format!("`{it}`"))
                .collect();
            let more = match self.others.len().saturating_sub(SHOWN) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            write!(
                f,
                " (these may be meant as well: {}{more})",
                others.join(", ")
            )?;
        }
        Ok(())
    }
}

/// The proposal to name these columns; `None` when there is no position among them, or when a name
/// cannot be typed.
pub(crate) fn propose(found: &[Found], headings: &[Heading]) -> Option<Proposal> {
    let mut sorted: Vec<&Found> = found.iter().collect();
    sorted.sort_by_key(|found| found.role);
    if !sorted.iter().any(|found| found.is_position()) {
        return None;
    }
    let mut columns = String::new();
    let mut assumed = Vec::new();
    let said = sorted.len();
    let has_force = sorted.iter().any(|found| found.role == Role::F);
    for found in sorted {
        let heading = headings.get(found.column)?;
        let own = split(&heading.name).ok().and_then(|split| split.unit);
        let is_new = |unit: &&str| match &own {
            Some(own) => own != unit && !same_unit(own, unit),
            None => true,
        };
        let added = found.unit.as_deref().filter(is_new);
        columns.push_str(&typed(found, heading, added, columns.is_empty())?);
        if found.role == Role::Count && own.is_none() && !is_called_a_count(&heading.name) {
            assumed.push("the position in counts, as its numbers are whole".to_owned());
        }
        if let Some(unit) = added.filter(|_| found.role != Role::Fine) {
            assumed.push(format!("{} in {unit}", found.role.name()));
        }
    }
    Some(Proposal {
        said,
        has_force,
        columns,
        delimiter: None,
        decimal_comma: false,
        assumed,
        others: Vec::new(),
        otherwise: Vec::new(),
    })
}
