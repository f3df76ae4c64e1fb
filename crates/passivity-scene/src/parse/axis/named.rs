//! The text that names an axis: a key, a unit and the side of a transmission.

use passivity_core::{BigRational, Scalar as _};

use super::side::At;
use crate::parse::amount::Amount;
use crate::parse::measure::{Measure, describe};
use crate::scene::Motion;
use crate::units::Unit;
use crate::written::{Form, Written};

/// `coulomb [mN m at the motor]` in its parts, of which the last two may be empty.
pub(super) struct Named<'a> {
    pub(super) name: &'a str,
    pub(super) unit: &'a str,
    pub(super) side: Option<At>,
}

impl<'a> Named<'a> {
    /// Takes the text apart; says what is wrong with its brackets or with its side.
    pub(super) fn of(text: &'a str) -> Result<Self, String> {
        let (name, rest) = match text.trim().split_once('[') {
            None => (text, ""),
            Some((name, rest)) => {
                let unit = rest.strip_suffix(']');
                (name, unit.ok_or("the unit needs its closing `]`")?)
            }
        };
        let word = |(at, _): &(usize, &str)| {
            let [before, behind] =
                [rest.get(..*at), rest.get(at + 2..)].map(Option::unwrap_or_default);
            let is_apart = before.is_empty() || before.ends_with(char::is_whitespace);
            is_apart && (behind.is_empty() || behind.starts_with(char::is_whitespace))
        };
        let (unit, side) = match rest.match_indices("at").find(word) {
            None => (rest, None),
            Some((at, _)) => {
                let (unit, side) = rest.split_at(at);
                (unit, Some(At::parse(side)?))
            }
        };
        Ok(Self {
            name: name.trim(),
            unit: unit.trim(),
            side,
        })
    }
}

/// A unit that was typed for a key, when it fits.
pub(super) fn unit_written(
    unit: &str,
    form: Form,
    measure: Measure,
    motion: Motion,
) -> Result<Written, String> {
    let plain = Amount {
        nominal: BigRational::one(),
        lo: BigRational::one(),
        hi: BigRational::one(),
        bound: None,
        unit_text: None,
        unit: Unit::one(),
        is_weight: false,
    };
    let needs_none = form == Form::Count || motion == Motion::Dimensionless;
    if needs_none {
        return match unit {
            "" => Ok(plain.written(form)),
            unit => Err(format!("expected a plain number, found the unit `{unit}`")),
        };
    }
    let accepts = |unit: &Unit| match measure.accepts(unit.dimension()) {
        Some(found) => found.is_none_or(|found| found == motion),
        None => false,
    };
    // As in a scene, `oz in` in place of a torque is a weight.
    let as_weight = |unit: &Unit| measure.weight(unit).filter(accepts);
    let fits = |unit: &Unit| accepts(unit) || as_weight(unit).is_some();
    let parsed = Unit::parse_for(unit, fits).map_err(|error| match error.help() {
        Some(help) => format!("{error}: {help}"),
        None => error.to_string(),
    })?;
    let weight = as_weight(&parsed).filter(|_| !accepts(&parsed));
    let parsed = weight.unwrap_or(parsed);
    if !accepts(&parsed) {
        let (found, expected) = (describe(parsed.dimension()), measure.expected(Some(motion)));
        return Err(format!("the unit is that of {found}, expected {expected}"));
    }
    let amount = Amount {
        unit_text: Some((unit.to_owned(), 0..unit.len())),
        unit: parsed,
        ..plain
    };
    Ok(amount.written(form))
}
