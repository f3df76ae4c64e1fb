//! The text of a quantity: a number, a unit, and what is known of it: a tolerance, a range, a bound.

use std::ops::Range;

use num_traits::{One, Signed, Zero};
use passivity_core::parameter::Values;
use passivity_core::{BigRational, Exact, Scalar, pi};

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

/// On which side a value is bounded, where only one bound is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    AtMost,
    AtLeast,
}

/// A quantity as it was written, in its own unit.
#[derive(Clone, Debug)]
pub(super) struct Amount {
    pub(super) nominal: BigRational,
    /// The least and the largest value of the tolerance or range.
    pub(super) lo: BigRational,
    pub(super) hi: BigRational,
    /// Where the text gives one bound only: `nominal` is that bound.
    pub(super) bound: Option<Bound>,
    /// The unit's text and its place, when there is one.
    pub(super) unit_text: Option<(String, Range<usize>)>,
    pub(super) unit: Unit,
    /// Whether the masses of the unit are taken as weights.
    pub(super) is_weight: bool,
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

/// What may stand between the ends of a range; the longer before what it begins with.
const TO: [&str; 7] = ["...", "..", "…", "–", "—", "to ", "-"];

/// What may stand before a value that is one bound.
const BOUNDS: [(&str, Bound); 12] = [
    ("<=", Bound::AtMost),
    ("<", Bound::AtMost),
    ("≤", Bound::AtMost),
    ("at most", Bound::AtMost),
    ("max.", Bound::AtMost),
    ("max", Bound::AtMost),
    (">=", Bound::AtLeast),
    (">", Bound::AtLeast),
    ("≥", Bound::AtLeast),
    ("at least", Bound::AtLeast),
    ("min.", Bound::AtLeast),
    ("min", Bound::AtLeast),
];

impl Amount {
    /// Reads `9e-6 N m s/rad`, with a tolerance `9e-6 N m s/rad ± 10%`, `9e-6 ± 1e-6 N m s/rad` or
    /// `9e-6 N m s/rad (±10 %)`, as a range `4 … 6 mN m`, or as a bound `<0.05 N`.
    ///
    /// `read_unit` reads the unit's text: in a dimensionless scene there are others.
    pub(super) fn parse(
        text: &str,
        read_unit: impl Fn(&str) -> Result<Unit, UnitError>,
    ) -> Result<Self, Fault> {
        let (bound, start) = bound(text);
        let body = text.get(start..).unwrap_or_default();
        let (first, len) =
            parse_prefix(body, LIMITS).map_err(|e| Fault::number(&e, text, start))?;
        let rest_at = start + len;
        let rest = text.get(rest_at..).unwrap_or_default();
        let split = Split::of(rest);
        let unit_piece = Piece::new(text, rest_at..rest_at + split.unit_end);
        let sign = split.sign.as_ref();
        let tail = sign.map(|(range, is_range, opened)| {
            let sign = rest_at + range.start..rest_at + range.end;
            Tail::parse(text, sign, (*is_range, *opened))
        });
        let tail = tail.transpose()?;
        if let (Some(_), Some((range, ..))) = (bound, &split.sign) {
            let span = rest_at + range.start..rest_at + range.end;
            let message = "a value that is a bound has no tolerance and no other end";
            return Err(Fault::new(Kind::MalformedTolerance, span, message));
        }
        let tail_unit = tail.as_ref().and_then(|tail| tail.unit.clone());
        let piece = unit_piece.clone().or_else(|| tail_unit.clone());
        let unit = match &piece {
            Some(piece) => piece.read(&read_unit)?,
            None => Unit::one(),
        };
        // What the number of the tail counts, in the unit of the value.
        let mut factor = <BigRational as One>::one();
        if let (Some(_), Some(own)) = (&unit_piece, &tail_unit) {
            let own_unit = own.read(&read_unit)?;
            let same =
                own_unit.dimension() == unit.dimension() && own_unit.pi_power() == unit.pi_power();
            if !same || tail.as_ref().is_some_and(|tail| tail.percent) {
                let message = "the two ends or the tolerance are not in the unit of the value";
                return Err(Fault::new(
                    Kind::MalformedTolerance,
                    own.span.clone(),
                    message,
                ));
            }
            factor = own_unit.scale() / unit.scale();
        }
        let hundredth = || BigRational::new(1.into(), 100.into());
        let (nominal, lo, hi) = match tail {
            None => (first.clone(), first.clone(), first),
            Some(tail) if tail.is_range => {
                let last = tail.number * factor;
                if last < first {
                    let message = "the range ends below its beginning";
                    let span = start..text.len();
                    return Err(Fault::new(Kind::MalformedTolerance, span, message));
                }
                ((&first + &last).half(), first, last)
            }
            Some(tail) => {
                let half_width = if tail.percent {
                    Signed::abs(&first) * tail.number * hundredth()
                } else {
                    tail.number * factor
                };
                (first.clone(), &first - &half_width, first + half_width)
            }
        };
        Ok(Self {
            nominal,
            lo,
            hi,
            bound,
            unit_text: piece.map(|piece| (piece.text, piece.span)),
            unit,
            is_weight: false,
        })
    }

    /// The same with the open side of a bound closed: at zero, where zero is allowed, or a factor of
    /// [`OPEN`] away.
    pub(super) fn closed(mut self, values: Values) -> Self {
        let factor = BigRational::from_integer(OPEN.into());
        match self.bound {
            None => {}
            Some(Bound::AtLeast) => self.hi = &self.nominal * factor,
            Some(Bound::AtMost) if values == Values::NonNegative => {
                self.lo = <BigRational as Zero>::zero();
            }
            Some(Bound::AtMost) => self.lo = &self.nominal / factor,
        }
        self
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
}

/// The SI value where the file writes 1 of a unit.
fn typed_one(form: Form, unit: &Exact) -> Exact {
    let two_pi = pi::pi() + pi::pi();
    match form {
        Form::Value => unit.clone(),
        Form::Reciprocal => Exact::one().over(unit.clone()),
        Form::Cutoff => Exact::one().over(two_pi * unit.clone()),
        // A revolution over its counts.
        Form::Count => two_pi,
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

/// By how much the open side of a bound is taken to be away from it.
pub(super) const OPEN: i32 = 1000;

/// The bound that a text begins with, and where its number begins.
fn bound(text: &str) -> (Option<Bound>, usize) {
    let body = text.trim_start();
    let found = BOUNDS
        .iter()
        .find_map(|(word, bound)| Some((*bound, body.strip_prefix(word)?)));
    match found {
        Some((bound, rest)) => (Some(bound), text.len() - rest.trim_start().len()),
        None => (None, text.len() - body.len()),
    }
}

/// Where the parts of the text behind a number stand.
struct Split {
    /// Where the unit ends.
    unit_end: usize,
    /// The sign before a tolerance or the other end of a range: its place, whether it is a range, and
    /// whether a parenthesis opened before it.
    sign: Option<(Range<usize>, bool, bool)>,
}

impl Split {
    fn of(rest: &str) -> Self {
        let found = PLUS_MINUS
            .iter()
            .find_map(|s| Some((rest.find(s)?, s.len())));
        if let Some((at, len)) = found {
            let before = rest.get(..at).unwrap_or_default().trim_end();
            let opened = before.strip_suffix('(');
            return Self {
                unit_end: opened.unwrap_or(before).len(),
                sign: Some((at..at + len, false, opened.is_some())),
            };
        }
        // A dash or dots with a number behind: a unit has neither before a digit, but for a power.
        let is_end = |at: usize, sign: &str| {
            let before = rest.get(..at).unwrap_or_default();
            let after = rest.get(at + sign.len()..).unwrap_or_default();
            let is_power = before.ends_with('^');
            let after = after.trim_start();
            let digits = after.strip_prefix(['-', '−']).unwrap_or(after);
            digits.starts_with(|c: char| c.is_ascii_digit()) && !is_power
        };
        let range = TO.iter().find_map(|sign| {
            let (at, sign) = rest.match_indices(sign).find(|(at, s)| is_end(*at, s))?;
            // `m-1` may be a power: only after a number or a space is `-` a dash.
            let dash = sign != "-" || at == 0 || rest.get(..at)?.ends_with(' ');
            dash.then_some((at, sign.len()))
        });
        Self {
            unit_end: range.map_or(rest.len(), |(at, _)| at),
            sign: range.map(|(at, len)| (at..at + len, true, false)),
        }
    }
}

/// What stands after the sign of a tolerance or a range.
struct Tail {
    number: BigRational,
    percent: bool,
    unit: Option<Piece>,
    is_range: bool,
}

impl Tail {
    /// Reads what follows the sign at `sign`: the number of a tolerance, or the end of a range.
    fn parse(text: &str, sign: Range<usize>, is: (bool, bool)) -> Result<Self, Fault> {
        let (is_range, opened) = is;
        let malformed = |span, message| Fault::new(Kind::MalformedTolerance, span, message);
        let mut end = text.len();
        if opened {
            let trimmed = text.trim_end();
            if !trimmed.ends_with(')') {
                let message = "the parenthesis before the tolerance is not closed";
                return Err(malformed(sign, message));
            }
            end = trimmed.len() - 1;
        }
        let Some(piece) = Piece::new(text, sign.end..end) else {
            return Err(malformed(sign, "a tolerance is missing after the ±"));
        };
        let at = piece.span.start;
        let (number, len) =
            parse_prefix(&piece.text, LIMITS).map_err(|e| Fault::number(&e, text, at))?;
        if number.is_negative() && !is_range {
            return Err(malformed(at..at + len, "a tolerance cannot be negative"));
        }
        let rest = piece.text.get(len..).unwrap_or_default();
        let spaces = rest.len() - rest.trim_start().len();
        let percent = !is_range && rest.trim_start().starts_with('%');
        let unit_at = at + len + if percent { spaces + 1 } else { 0 };
        Ok(Self {
            number,
            percent,
            unit: Piece::new(text, unit_at..end),
            is_range,
        })
    }
}
