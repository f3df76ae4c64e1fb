//! The text of a quantity: a number, a unit, a tolerance.

use std::ops::Range;

use num_traits::{Signed, Zero};
use passivity_core::{BigRational, Exact, Interval, Scalar, pi};

use crate::diagnostic::Kind;
use crate::number::{Limits, NumberError, parse_prefix};
use crate::units::{Unit, UnitError};
use crate::written::{Form, Written};

/// The longest number of a quantity, in bytes: a verdict multiplies several of them.
pub const MAX_NUMBER_CHARS: usize = 500;

/// The largest magnitude of the decimal exponent of a quantity: past that of every double.
pub const MAX_NUMBER_EXPONENT: u32 = 500;

const LIMITS: Limits = Limits {
    chars: MAX_NUMBER_CHARS,
    exponent: MAX_NUMBER_EXPONENT,
};

/// A quantity as it was written, in its own unit.
#[derive(Clone, Debug)]
pub(super) struct Amount {
    pub(super) nominal: BigRational,
    /// Half the width of the tolerance, in the unit of the value.
    pub(super) tolerance: BigRational,
    /// The unit's text and its place, when there is one.
    pub(super) unit_text: Option<(String, Range<usize>)>,
    pub(super) unit: Unit,
}

/// Why a text is not a quantity: a place in the text and what to say about it.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    pub(super) kind: Kind,
    pub(super) span: Range<usize>,
    pub(super) message: String,
    pub(super) help: Option<String>,
}

impl Fault {
    fn new(kind: Kind, span: Range<usize>, message: impl Into<String>) -> Self {
        Self {
            kind,
            span,
            message: message.into(),
            help: None,
        }
    }

    pub(super) fn number(error: &NumberError, text: &str, offset: usize) -> Self {
        let at = offset + error.at();
        let len = text
            .get(at..)
            .and_then(|rest| rest.chars().next())
            .map_or(0, char::len_utf8);
        Self::new(Kind::Number(error.kind()), at..at + len, error.to_string())
    }

    fn unit(error: &UnitError, offset: usize) -> Self {
        let kind = if error.is_unknown_symbol() {
            Kind::UnknownUnit
        } else {
            Kind::MalformedUnit
        };
        let span = error.span();
        Self {
            help: error.help().map(str::to_owned),
            ..Self::new(
                kind,
                offset + span.start..offset + span.end,
                error.to_string(),
            )
        }
    }
}

/// What may stand between a value and its tolerance.
const PLUS_MINUS: [&str; 3] = ["±", "+/-", "+-"];

impl Amount {
    /// Reads `9e-6 N m s/rad`, `9e-6 N m s/rad ± 10%` or `9e-6 ± 1e-6 N m s/rad`.
    ///
    /// `read_unit` reads the unit's text: in a dimensionless scene there are others.
    pub(super) fn parse(
        text: &str,
        read_unit: impl Fn(&str) -> Result<Unit, UnitError>,
    ) -> Result<Self, Fault> {
        let start = text.len() - text.trim_start().len();
        let body = text.get(start..).unwrap_or_default();
        let (nominal, len) =
            parse_prefix(body, LIMITS).map_err(|e| Fault::number(&e, text, start))?;
        let rest_at = start + len;
        let rest = text.get(rest_at..).unwrap_or_default();
        let sign = PLUS_MINUS
            .iter()
            .find_map(|s| Some((rest.find(s)?, s.len())));
        let unit_end = sign.map_or(rest.len(), |(at, _)| at);
        let unit_piece = Piece::new(text, rest_at..rest_at + unit_end);
        let tail = match sign {
            Some((at, len)) => Some(Tail::parse(text, rest_at + at, len)?),
            None => None,
        };
        let tail_unit = tail.as_ref().and_then(|tail| tail.unit.clone());
        let piece = unit_piece.clone().or_else(|| tail_unit.clone());
        let unit = match &piece {
            Some(piece) => piece.read(&read_unit)?,
            None => Unit::one(),
        };
        let mut tolerance = match &tail {
            Some(tail) if tail.percent => {
                Signed::abs(&nominal) * &tail.number / BigRational::from_integer(100.into())
            }
            Some(tail) => tail.number.clone(),
            None => <BigRational as Zero>::zero(),
        };
        if let (Some(_), Some(own)) = (&unit_piece, &tail_unit) {
            let own_unit = own.read(&read_unit)?;
            let same =
                own_unit.dimension() == unit.dimension() && own_unit.pi_power() == unit.pi_power();
            if !same || tail.as_ref().is_some_and(|tail| tail.percent) {
                let message = "the tolerance is not in the unit of the value";
                return Err(Fault::new(
                    Kind::MalformedTolerance,
                    own.span.clone(),
                    message,
                ));
            }
            tolerance = tolerance * own_unit.scale() / unit.scale();
        }
        Ok(Self {
            nominal,
            tolerance,
            unit_text: piece.map(|piece| (piece.text, piece.span)),
            unit,
        })
    }

    /// The unit in SI units.
    fn one(&self) -> Exact {
        Exact::of(self.unit.scale()) * power_of_pi(self.unit.pi_power())
    }

    /// The unit as the text writes it, and what the number in it stands for.
    pub(super) fn written(&self, form: Form) -> Written {
        let unit = self.unit_text.as_ref().map_or("", |(unit, _)| unit);
        Written::new(form, unit, typed_one(form, &self.one()))
    }

    /// The values in SI units, with the tolerance and without; every number must be above 0 where
    /// its reciprocal is the value.
    pub(super) fn exact(&self, form: Form) -> (Interval<Exact>, Exact) {
        let written = self.written(form);
        let lo = written.typed(&(&self.nominal - &self.tolerance));
        let hi = written.typed(&(&self.nominal + &self.tolerance));
        (Interval::hull(lo, hi), written.typed(&self.nominal))
    }
}

/// The SI value where the file writes 1 of a unit.
fn typed_one(form: Form, unit: &Exact) -> Exact {
    let two_pi = pi::pi() + pi::pi();
    match form {
        Form::Value => unit.clone(),
        Form::Reciprocal => Exact::one().over(unit.clone()),
        Form::Count | Form::Cutoff => Exact::one().over(two_pi * unit.clone()),
    }
}

/// π to a power.
fn power_of_pi(power: i8) -> Exact {
    let size = (0..power.unsigned_abs()).fold(Exact::one(), |x, _| x * pi::pi());
    if power < 0 {
        Exact::one().over(size)
    } else {
        size
    }
}

/// A part of the text without the spaces around it.
#[derive(Clone)]
struct Piece {
    text: String,
    span: Range<usize>,
}

impl Piece {
    fn new(text: &str, range: Range<usize>) -> Option<Self> {
        let raw = text.get(range.clone())?;
        let trimmed = raw.trim();
        let start = range.start + raw.len() - raw.trim_start().len();
        (!trimmed.is_empty()).then(|| Self {
            text: trimmed.to_owned(),
            span: start..start + trimmed.len(),
        })
    }

    fn read(&self, read_unit: impl Fn(&str) -> Result<Unit, UnitError>) -> Result<Unit, Fault> {
        read_unit(&self.text).map_err(|e| Fault::unit(&e, self.span.start))
    }
}

/// What stands after the ±.
struct Tail {
    number: BigRational,
    percent: bool,
    unit: Option<Piece>,
}

impl Tail {
    fn parse(text: &str, sign_at: usize, sign_len: usize) -> Result<Self, Fault> {
        let after = sign_at + sign_len;
        let Some(piece) = Piece::new(text, after..text.len()) else {
            let message = "a tolerance is missing after the ±";
            let fault = Fault::new(Kind::MalformedTolerance, sign_at..after, message);
            return Err(fault);
        };
        let at = piece.span.start;
        let (number, len) =
            parse_prefix(&piece.text, LIMITS).map_err(|e| Fault::number(&e, text, at))?;
        if number.is_negative() {
            let message = "a tolerance cannot be negative";
            return Err(Fault::new(Kind::MalformedTolerance, at..at + len, message));
        }
        let rest = piece.text.get(len..).unwrap_or_default();
        let spaces = rest.len() - rest.trim_start().len();
        let percent = rest.trim_start().starts_with('%');
        let unit_at = at + len + if percent { spaces + 1 } else { 0 };
        Ok(Self {
            number,
            percent,
            unit: Piece::new(text, unit_at..text.len()),
        })
    }
}
