//! In what form positions are: as they are or counted, one in each row, or both of an interval, as in a ledger.

use passivity_scene::Scene;

use super::{Layout, header};
use crate::log::columns::{Found, Role};
use crate::log::digits::Digits;
use crate::log::error::{TraceError, shown};
use crate::log::findings::Beside;
use crate::log::guess;
use crate::log::header::Heading;
use crate::log::scale::Scale;
use crate::number::Number;

/// In what form the trace gives positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `xi`, in ticks.
    Xi,
    /// `x [unit]`.
    X,
    /// `count`.
    Count,
    /// `xi0`, `xi1` and perhaps `dtau`: the rows of a ledger.
    Ledger,
}

impl Form {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Xi => "xi",
            Self::X => "x",
            Self::Count => "count",
            Self::Ledger => "ledger",
        }
    }
}

/// The form of positions and the column that has them.
pub(super) fn form<'f>(
    said: &'f [Found],
    headings: &[Heading],
) -> Result<(Form, &'f Found), TraceError> {
    let forms = [
        (Form::Xi, Role::Xi),
        (Form::X, Role::X),
        (Form::Count, Role::Count),
    ];
    let mut present = forms.into_iter().filter_map(|(form, role)| {
        let found = said.iter().find(|found| found.role == role)?;
        Some((form, found))
    });
    match (present.next(), present.next()) {
        (Some(found), None) => Ok(found),
        (Some((form, _)), Some((other, _))) => Err(header(format!(
            "expected one of `xi`, `x [unit]` and `count`, found `{}` and `{}`",
            form.name(),
            other.name()
        ))),
        (None, _) => {
            let found = headings.iter().take(8).map(|h| shown(h.name.as_bytes()));
            let found = found.collect::<Vec<_>>().join("`, `");
            Err(header(format!(
                "expected a column `xi`, `x [unit]` or `count`, found `{found}`"
            )))
        }
    }
}

impl Layout {
    /// The layout of a ledger, which repeats its positions in columns of its own.
    pub(super) fn of_ledger(
        headings: &[Heading],
        scene: &Scene,
    ) -> Result<Option<Self>, TraceError> {
        let find = |base: &str| {
            let mut named = (0..).zip(headings).filter(|(_, h)| h.name.trim() == base);
            match (named.next(), named.next()) {
                (_, Some(_)) => Err(twice(base)),
                (found, None) => Ok(found.map(|(column, _)| column)),
            }
        };
        let (Some(start), Some(end)) = (find("xi0")?, find("xi1")?) else {
            if find("xi0_lo")?.is_some() && find("xi1_hi")?.is_some() {
                let message = "a ledger of bounds, with columns like `xi0_lo` and `xi0_hi`, is no trace: \
                    audit the log that it was made of";
                return Err(header(message));
            }
            return Ok(None);
        };
        let (dtau, force) = (find("dtau")?, find("force")?);
        let is_missed = |heading: &&Heading| {
            let is_called = |role| guess::is_called(role, heading, scene.motion);
            match is_called(Role::T) {
                true => dtau.is_none(),
                false => force.is_none() && is_called(Role::F),
            }
        };
        if let Some(missed) = headings.iter().find(is_missed) {
            let message = "this column is not read from a ledger of `xi0` and `xi1`, which says how long an interval was as `dtau`, in \
                sampling periods, and the force as `force`, in KΔ: write them so, or take the column away";
            return Err(header(message).column(&missed.name));
        }
        Ok(Some(Self {
            form: Form::Ledger,
            position: start,
            end: Some(end),
            dtau,
            time: None,
            fine: None,
            // A ledger says under which force its intervals were, when that is not the law's.
            force,
            velocity: None,
            headings: headings.to_vec(),
            said: Vec::new(),
            beside: Beside::default(),
            scale: Scale::One,
            per_period: Number::whole(1),
            per_force: Scale::One,
            size_of_force: 1.0,
            digits: Digits::default(),
            per_velocity: 1.0,
        }))
    }
}

fn twice(name: &str) -> TraceError {
    header(format!("the column `{name}` is given twice")).column(name)
}
