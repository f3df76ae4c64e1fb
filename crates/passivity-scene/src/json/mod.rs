//! Exact numbers in JSON: rationals as strings in lowest terms, intervals as `lo`, `hi`, `approx`.

pub mod shape;

use passivity_core::{BigRational, Interval};
use serde::Serialize;
use serde_json::{Value, json};

use crate::number::{self, NumberError, NumberErrorKind, nearest_f64};

/// A rational as a string in lowest terms: `"3/8"`, `"-2"`, `"0"`.
///
/// # Example
///
/// ```
/// use passivity_scene::{json, number};
///
/// assert_eq!(json::rational(&number::parse("0.375").unwrap()), "3/8");
/// ```
#[must_use]
pub fn rational(x: &BigRational) -> Value {
    Value::String(x.to_string())
}

/// An interval as `{"lo": "3/5", "hi": "3/5", "approx": 0.6}`.
///
/// `approx` is the double nearest to the midpoint, and null when that is past the doubles.
///
/// # Example
///
/// ```
/// use passivity_core::Interval;
/// use passivity_scene::{json, number};
///
/// let x = Interval::point(number::parse("0.6").unwrap());
/// let expected = serde_json::json!({"lo": "3/5", "hi": "3/5", "approx": 0.6});
/// assert_eq!(json::interval(&x), expected);
/// ```
#[must_use]
pub fn interval(x: &Interval<BigRational>) -> Value {
    let middle = x.middle();
    json!({
        "lo": x.lo().to_string(),
        "hi": x.hi().to_string(),
        "approx": approx(&middle),
    })
}

/// The double nearest to an exact number as a JSON number, or null when it is past the doubles: its
/// ends are exact beside it.
#[must_use]
pub fn approx(x: &BigRational) -> Value {
    // `from_f64` refuses infinities.
    serde_json::Number::from_f64(nearest_f64(x)).map_or(Value::Null, Value::Number)
}

/// A report as JSON.
pub(crate) fn of(report: &impl Serialize) -> Value {
    match serde_json::to_value(report) {
        Ok(value) => value,
        Err(error) => unreachable!("a report has nothing that JSON cannot hold: {error}"),
    }
}

/// Reads a rational: a string such as `"3/8"` or `"3.75e-1"`, or a JSON number, which is taken as
/// the decimal it spells and not as a double.
///
/// # Errors
///
/// [`NumberError`] when the value is neither, or the number is not one that
/// [`number::parse`] reads.
///
/// # Example
///
/// ```
/// use passivity_scene::json::read_rational;
///
/// let tenth = serde_json::from_str("0.1").unwrap();
/// assert_eq!(read_rational(&tenth).unwrap().to_string(), "1/10");
/// ```
pub fn read_rational(value: &Value) -> Result<BigRational, NumberError> {
    match value {
        Value::String(text) => number::parse(text),
        Value::Number(n) => number::parse(n.as_str()),
        other => Err(NumberError::new(
            NumberErrorKind::Malformed,
            0,
            format!(
                "expected a number such as `\"3/8\"` or `0.375`, found {}",
                kind_of(other)
            ),
        )),
    }
}

/// Reads an interval: an object with `lo` and `hi`, or anything [`read_rational`] takes.
///
/// # Errors
///
/// As [`read_rational`]; also when `lo` or `hi` is missing or `lo` > `hi`.
///
/// # Example
///
/// ```
/// use passivity_scene::json::read_interval;
///
/// let value = serde_json::from_str(r#"{"lo": "1/3", "hi": 0.5}"#).unwrap();
/// assert_eq!(read_interval(&value).unwrap().hi().to_string(), "1/2");
/// ```
pub fn read_interval(value: &Value) -> Result<Interval<BigRational>, NumberError> {
    let Value::Object(fields) = value else {
        return read_rational(value).map(Interval::point);
    };
    let end = |name: &str| match fields.get(name) {
        Some(end) => read_rational(end),
        None => Err(NumberError::new(
            NumberErrorKind::Malformed,
            0,
            format!("the end `{name}` of an interval is missing"),
        )),
    };
    Interval::new(end("lo")?, end("hi")?).ok_or_else(|| {
        NumberError::new(
            NumberErrorKind::Malformed,
            0,
            "the end `lo` of an interval is above its end `hi`",
        )
    })
}

/// What a JSON value is, in words.
pub(crate) const fn kind_of(value: &Value) -> &'static str {
    match value {
        Value::Null => "null",
        Value::Bool(_) => "a boolean",
        Value::Number(_) => "a number",
        Value::String(_) => "a string",
        Value::Array(_) => "a list",
        Value::Object(_) => "an object",
    }
}
