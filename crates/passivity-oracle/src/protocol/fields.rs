//! The fields of a request, each read once, with the place of every mistake.

use passivity_core::{BigRational, Interval, Ordered};
use passivity_scene::json::{read_interval, read_rational};
use passivity_scene::number::NumberError;
use serde_json::{Map, Value};

use super::{At, MAX_POSITIONS, Refusal, shown};
use passivity_audit::Reading;
use passivity_audit::number::{MAX_BITS, Number, is_bounded, is_positive};

/// What a request says.
pub(super) struct Fields<'a> {
    map: &'a Map<String, Value>,
}

impl<'a> Fields<'a> {
    pub(super) const fn new(map: &'a Map<String, Value>) -> Self {
        Self { map }
    }

    /// Refuses every field that the operation does not have.
    pub(super) fn only(&self, known: &[&str]) -> Result<(), Refusal> {
        let unknown = self
            .map
            .keys()
            .find(|key| !matches!(key.as_str(), "id" | "op") && !known.contains(&key.as_str()));
        match unknown {
            None => Ok(()),
            Some(key) => {
                let expected = match known {
                    [] => "this operation has no fields".to_owned(),
                    known => format!("expected one of {}", known.join(", ")),
                };
                Err(unknown_field("", key, &expected))
            }
        }
    }

    /// The first of several spellings of a field that is there.
    pub(super) fn get(&self, names: &[&'static str]) -> Option<(&'static str, &'a Value)> {
        names
            .iter()
            .find_map(|name| self.map.get(*name).map(|value| (*name, value)))
    }

    pub(super) fn text(&self, name: &'static str) -> Result<&'a str, Refusal> {
        match self.map.get(name) {
            Some(Value::String(text)) => Ok(text),
            Some(_) => Err(bad(name, "expected a string")),
            None => Err(missing(name)),
        }
    }

    pub(super) fn flag(&self, name: &'static str, otherwise: bool) -> Result<bool, Refusal> {
        match self.map.get(name) {
            None => Ok(otherwise),
            Some(Value::Bool(flag)) => Ok(*flag),
            Some(_) => Err(bad(name, "expected true or false")),
        }
    }

    /// A whole number from 0 to `most`.
    pub(super) fn natural(&self, name: &'static str, most: u64) -> Result<u64, Refusal> {
        let Some(value) = self.map.get(name) else {
            return Ok(0);
        };
        let x = read_rational(value).ok().filter(BigRational::is_integer);
        let n = x.and_then(|x| u64::try_from(x.numer()).ok());
        n.filter(|n| *n <= most).ok_or_else(|| {
            let message = format!("expected a whole number from 0 to {most}");
            bad(name, message)
        })
    }

    pub(super) fn rational(&self, name: &'static str) -> Result<BigRational, Refusal> {
        let value = self.map.get(name).ok_or_else(|| missing(name))?;
        let x = read_rational(value).map_err(|error| refused(&error, name.to_owned()))?;
        bounded(x, name)
    }

    /// A number, or an interval of them, that is at least zero.
    pub(super) fn friction(&self, name: &'static str) -> Result<Interval<BigRational>, Refusal> {
        let value = self.map.get(name).ok_or_else(|| missing(name))?;
        if let Value::Object(ends) = value {
            // An answer's interval has the double between its ends too.
            let known = |key: &str| matches!(key, "lo" | "hi" | "approx");
            if let Some(key) = ends.keys().find(|key| !known(key)) {
                return Err(unknown_field(
                    &format!("{name}."),
                    key,
                    "an interval has `lo` and `hi`",
                ));
            }
        }
        let range = read_interval(value).map_err(|error| refused(&error, name.to_owned()))?;
        if range.lo().is_nonnegative() != Some(true) {
            return Err(out_of_range(name.to_owned(), "zero or a value above it"));
        }
        if is_bounded(range.lo()) && is_bounded(range.hi()) {
            Ok(range)
        } else {
            Err(too_wide(name.to_owned()))
        }
    }

    /// An optional number that is above zero, or at least zero.
    pub(super) fn effect(
        &self,
        name: &'static str,
        zero_allowed: bool,
    ) -> Result<Option<BigRational>, Refusal> {
        let Some(value) = self.map.get(name) else {
            return Ok(None);
        };
        let x = read_rational(value).map_err(|error| refused(&error, name.to_owned()))?;
        let x = bounded(x, name)?;
        match (
            x.is_positive() == Some(true),
            x.is_nonnegative() == Some(true),
        ) {
            (true, _) => Ok(Some(x)),
            (false, true) if zero_allowed => Ok(Some(x)),
            _ if zero_allowed => Err(out_of_range(name.to_owned(), "zero or a value above it")),
            _ => Err(out_of_range(name.to_owned(), "a value above zero")),
        }
    }
}

/// A list of a bounded length.
pub(super) fn list<'v>(name: &str, value: &'v Value) -> Result<&'v [Value], Refusal> {
    match value {
        Value::Array(items) if items.len() <= MAX_POSITIONS => Ok(items),
        Value::Array(_) => Err(out_of_range(
            name.to_owned(),
            format!("at most {MAX_POSITIONS} items"),
        )),
        _ => Err(bad(name, "expected a list")),
    }
}

/// A number that is at `place`.
pub(super) fn number(value: &Value, place: impl Fn() -> String) -> Result<Number, Refusal> {
    let read = match value {
        Value::String(text) => Number::parse(text),
        Value::Number(n) => Number::parse(n.as_str()),
        other => read_rational(other).map(Number::from),
    };
    let x = read.map_err(|error| refused(&error, place()))?;
    if x.is_bounded() {
        Ok(x)
    } else {
        Err(too_wide(place()))
    }
}

fn bounded(x: BigRational, name: &str) -> Result<BigRational, Refusal> {
    if is_bounded(&x) {
        Ok(x)
    } else {
        Err(too_wide(name.to_owned()))
    }
}

fn too_wide(place: String) -> Refusal {
    let message = format!("a number of more than {MAX_BITS} bits");
    Refusal::new("number_too_long", At::Field(place), message)
}

/// Δτ: a number above zero.
pub(super) fn duration(value: &Value, place: impl Fn() -> String) -> Result<Number, Refusal> {
    let dtau = number(value, &place)?;
    if is_positive(&dtau) {
        Ok(dtau)
    } else {
        Err(out_of_range(place(), "a value above zero"))
    }
}

/// A position, or an encoder's count.
pub(super) fn sample(
    value: &Value,
    counted: bool,
    place: impl Fn() -> String,
) -> Result<Reading, Refusal> {
    if !counted {
        return number(value, place).map(Reading::Exact);
    }
    match number(value, &place)? {
        Number::Small(n, 1) => Ok(Reading::Count(n)),
        Number::Small(n, d) if n % d == 0 => Ok(Reading::Count(n / d)),
        _ => Err(bad(
            &place(),
            "expected a count, which is a whole number of at most 64 bits",
        )),
    }
}

fn refused(error: &NumberError, place: String) -> Refusal {
    let message = format!("{} (character {} of the number)", error, error.at() + 1);
    Refusal::new(error.kind().name(), At::Field(place), message)
}

/// The refusal of a key behind `path`.
fn unknown_field(path: &str, key: &str, expected: &str) -> Refusal {
    let key = shown(key);
    let message = format!("unknown field `{key}`; {expected}");
    Refusal::new("unknown_field", At::Field(format!("{path}{key}")), message)
}

pub(super) fn missing(name: &str) -> Refusal {
    let message = format!("the field `{name}` is missing");
    Refusal::new("missing_field", At::Field(name.to_owned()), message)
}

pub(super) fn bad(place: &str, message: impl Into<String>) -> Refusal {
    Refusal::new("bad_value", At::Field(place.to_owned()), message)
}

pub(super) fn out_of_range(place: String, expected: impl std::fmt::Display) -> Refusal {
    Refusal::new(
        "out_of_range",
        At::Field(place),
        format!("expected {expected}"),
    )
}
