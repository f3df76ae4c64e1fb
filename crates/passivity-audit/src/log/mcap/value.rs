//! A decoded message, and the paths to the numbers in it.

use std::borrow::Cow;
use std::fmt::{self, Write as _};

use crate::log::error::shown;
use crate::log::layout::MAX_COLUMNS;

/// How many elements of a list can be columns.
pub(crate) const MOST_ELEMENTS: usize = 64;

/// What a message, or a field of one, holds.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value<'a> {
    Number(Scalar),
    Text(Cow<'a, str>),
    /// A time or a duration, which messages have in two fields.
    Nanoseconds(i128),
    /// Its first [`MOST_ELEMENTS`] elements.
    List(Vec<Value<'a>>),
    Struct(Vec<(Cow<'a, str>, Value<'a>)>),
    /// What is true or false is no number.
    Truth(bool),
    /// What holds no number.
    Nothing,
}

/// A number, in the form in which it was recorded.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Scalar {
    Whole(i128),
    Single(f32),
    Double(f64),
    /// As JSON spells it.
    Spelt(String),
}

/// Floats as the shortest decimal that reads back as the same float.
impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole(n) => write!(f, "{n}"),
            Self::Single(x) => write!(f, "{x:?}"),
            Self::Double(x) => write!(f, "{x:?}"),
            Self::Spelt(text) => f.write_str(text),
        }
    }
}

impl Scalar {
    /// The double near by; `None` for NaN and infinities.
    pub(crate) fn near(&self) -> Option<f64> {
        #[allow(clippy::cast_precision_loss)] // a preview
        let near = match self {
            Self::Whole(n) => *n as f64,
            Self::Single(x) => f64::from(*x),
            Self::Double(x) => *x,
            Self::Spelt(text) => text.parse().ok()?,
        };
        near.is_finite().then_some(near)
    }
}

/// A step from a value to one within it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    Field(String),
    Element(usize),
    /// The element of a list whose name stands in the list `name` beside it, as the joints of a
    /// `JointState` have names.
    Named(String),
}

/// As it stands in the name of a column.
pub(crate) fn written(path: &[Step]) -> String {
    let mut text = String::new();
    for step in path {
        // Writing to a text cannot fail.
        let _ = match step {
            Step::Field(name) | Step::Named(name) => write!(text, ".{name}"),
            Step::Element(i) => write!(text, "[{i}]"),
        };
    }
    text
}

/// The names of the elements of lists in a message: those in its field `name`, where it has such a list and
/// each name is there once.
fn names<'v>(fields: &'v [(Cow<'_, str>, Value<'_>)]) -> Option<Vec<&'v str>> {
    let (_, list) = fields.iter().find(|(name, _)| name == "name")?;
    let Value::List(list) = list else { return None };
    let text = |value: &'v Value<'_>| match value {
        Value::Text(text) if !text.trim().is_empty() => Some(text.as_ref()),
        _ => None,
    };
    let names: Vec<&str> = list.iter().map(text).collect::<Option<_>>()?;
    let mut sorted = names.clone();
    sorted.sort_unstable();
    let once = sorted.windows(2).all(|pair| pair.first() != pair.last());
    once.then_some(names)
}

/// Why a message has no number at the end of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Missing {
    /// It is about other joints than the one of the path, or about none.
    Joint,
    /// It has no such field.
    Field,
    /// What it has there instead, in words.
    Other(String),
}

/// The element of a list that the list `name` beside it calls so.
fn named<'v, 'a>(
    fields: &[(Cow<'_, str>, Value<'_>)],
    list: &'v [Value<'a>],
    wanted: &str,
) -> Result<&'v Value<'a>, Missing> {
    let other = |what: &str| Missing::Other(format!("a list of {} there {what}", list.len()));
    let names = names(fields).ok_or_else(|| other("whose elements have no names of their own"))?;
    let at = names.iter().position(|name| *name == wanted);
    match at.and_then(|at| list.get(at)) {
        _ if list.len() != names.len() && (at.is_some() || !list.is_empty()) => {
            Err(other(&format!("beside a list `name` of {}", names.len())))
        }
        Some(value) => Ok(value),
        None if names.len() == MOST_ELEMENTS => Err(other(
            "or more, of which only these are read, and none has this name",
        )),
        None => Err(Missing::Joint),
    }
}

impl Value<'_> {
    /// The number, or the time, at the end of a path.
    pub(crate) fn at(&self, path: &[Step]) -> Result<Scalar, Missing> {
        match (self, path) {
            (Value::Number(number), []) => Ok(number.clone()),
            (Value::Nanoseconds(n), []) => Ok(Scalar::Whole(*n)),
            (Value::List(list), [Step::Element(i), rest @ ..]) => match list.get(*i) {
                Some(value) => value.at(rest),
                None => Err(Missing::Other(format!("{} there", self.words()))),
            },
            (Value::Struct(fields), [Step::Field(field), rest @ ..]) => {
                let value = fields.iter().find(|(name, _)| name == field);
                let (_, value) = value.ok_or(Missing::Field)?;
                match (rest, value) {
                    ([Step::Named(wanted), rest @ ..], Value::List(list)) => {
                        named(fields, list, wanted)?.at(rest)
                    }
                    _ => value.at(rest),
                }
            }
            _ => Err(Missing::Other(format!("{} there", self.words()))),
        }
    }

    /// What it is, in words.
    fn words(&self) -> String {
        match self {
            Value::Number(_) | Value::Nanoseconds(_) => "one number".to_owned(),
            Value::Text(text) => format!("the text `{}`", shown(text.as_bytes())),
            Value::List(list) => format!("a list of {}", list.len()),
            Value::Struct(_) => "other fields".to_owned(),
            Value::Truth(yes) => yes.to_string(),
            Value::Nothing => "null".to_owned(),
        }
    }

    /// The first numbers, as many as there can be columns.
    pub(crate) fn leaves(&self) -> Vec<Leaf> {
        let mut leaves = Vec::new();
        self.walk(&mut Vec::new(), None, &mut leaves);
        leaves
    }

    fn walk(&self, path: &mut Vec<Step>, names: Option<&[&str]>, leaves: &mut Vec<Leaf>) {
        if leaves.len() >= MAX_COLUMNS {
            return;
        }
        let mut within = |step: Step, value: &Value<'_>, names: Option<&[&str]>| {
            path.push(step);
            value.walk(path, names, leaves);
            path.pop();
        };
        match self {
            Value::Struct(fields) => {
                let own = self::names(fields);
                for (name, value) in fields {
                    within(Step::Field(name.to_string()), value, own.as_deref());
                }
            }
            Value::List(list) => {
                let names = names.filter(|names| names.len() == list.len());
                for (i, value) in list.iter().enumerate() {
                    let step = match names.and_then(|names| names.get(i)) {
                        Some(name) => Step::Named((*name).to_owned()),
                        None => Step::Element(i),
                    };
                    within(step, value, None);
                }
            }
            Value::Number(number) => leaves.push(Leaf {
                path: path.clone(),
                near: number.near(),
                is_time: false,
            }),
            Value::Nanoseconds(n) => leaves.push(Leaf {
                path: path.clone(),
                near: Scalar::Whole(*n).near(),
                is_time: true,
            }),
            Value::Text(_) | Value::Truth(_) | Value::Nothing => {}
        }
    }
}

/// A number in a message.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Leaf {
    pub(crate) path: Vec<Step>,
    pub(crate) near: Option<f64>,
    /// Whether it is in nanoseconds.
    pub(crate) is_time: bool,
}

/// Whether two fields are the seconds and nanoseconds of a time.
pub(crate) fn are_time(first: &str, second: &str) -> bool {
    ["sec", "secs"].contains(&first) && ["nsec", "nsecs", "nanosec"].contains(&second)
}

/// The nanoseconds of a time.
pub(crate) fn nanoseconds(seconds: i128, nanoseconds: i128) -> Option<i128> {
    seconds.checked_mul(1_000_000_000)?.checked_add(nanoseconds)
}
