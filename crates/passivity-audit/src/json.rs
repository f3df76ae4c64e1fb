//! Figures, rows and totals as JSON, with the field names of the interface.
//!
//! Exact figures are strings in lowest terms, enclosures `{"lo", "hi", "approx"}`, truths `true`,
//! `false` and `null` for "it depends". Of JSON that is read: whether it has a key twice.

use std::io;

use passivity_core::{BigRational, Scalar as _, Truth};
use passivity_scene::number::nearest_f64;
use serde::ser::{Error as _, SerializeStruct as _};
use serde::{Serialize, Serializer};
use serde_json::ser::Formatter;

use crate::entry::{Entry, Margin};
use crate::figure::Figure;
use crate::ledger::{Row, on_entry};
use crate::number::Written;

/// A number as a string in lowest terms.
pub(crate) struct Lowest<'a, S>(pub(crate) &'a S);

impl<S: Written> Serialize for Lowest<'_, S> {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        let mut text = Vec::with_capacity(24);
        let undefined = || T::Error::custom("a figure is not defined");
        self.0.write(&mut text).ok_or_else(undefined)?;
        let text = std::str::from_utf8(&text).map_err(T::Error::custom)?;
        serializer.serialize_str(text)
    }
}

/// Writes an interval with ends that may be missing: an end without bound is null.
///
/// `approx` is the double nearest to the middle; null where there is none.
fn interval<S: Written, T: Serializer>(
    lo: Option<&S>,
    hi: Option<&S>,
    serializer: T,
) -> Result<T::Ok, T::Error> {
    let middle = lo.zip(hi).map(|(lo, hi)| {
        let undefined = || T::Error::custom("a figure is not defined");
        middle(lo, hi).ok_or_else(undefined)
    });
    // Past the doubles there is no nearest one.
    let approx = middle.transpose()?.filter(|x| x.is_finite());
    let mut object = serializer.serialize_struct("Interval", 3)?;
    object.serialize_field("lo", &lo.map(Lowest))?;
    object.serialize_field("hi", &hi.map(Lowest))?;
    object.serialize_field("approx", &approx)?;
    object.end()
}

/// The double nearest to the middle of two numbers; `None` when one is undefined.
fn middle<S: Written>(lo: &S, hi: &S) -> Option<f64> {
    let short = (lo.clone() + hi.clone()).half().to_rational();
    // Their sum may be too long for machine integers that hold each of them.
    let middle = short.or_else(|| Some((lo.to_rational()? + hi.to_rational()?).half()));
    middle.map(|x| nearest_f64(&x))
}

impl<S: Written> Serialize for Figure<S> {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        match self {
            Self::Exact(x) => Lowest(x).serialize(serializer),
            Self::Enclosed(range) => interval(Some(range.lo()), Some(range.hi()), serializer),
        }
    }
}

impl<S: Written> Serialize for Margin<S> {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        match self {
            Self::At(x) => Lowest(x).serialize(serializer),
            Self::Between(lo, hi) => interval(lo.as_ref(), hi.as_ref(), serializer),
        }
    }
}

/// `true`, `false`, and `null` for what depends.
pub(crate) const fn truth(truth: Truth) -> Option<bool> {
    match truth {
        Truth::Holds => Some(true),
        Truth::Fails => Some(false),
        Truth::Depends => None,
    }
}

/// A row of the interface.
#[derive(Serialize)]
#[serde(bound = "")]
struct LedgerRow<'a, S: Written> {
    h: u64,
    xi0: &'a Figure<S>,
    xi1: &'a Figure<S>,
    dtau: Lowest<'a, S>,
    generated_linear: Option<&'a Figure<S>>,
    generated_quantized: Option<&'a Figure<S>>,
    bound_22: &'a Figure<S>,
    bound_quantized: &'a Figure<S>,
    dissipated_lower: &'a Figure<S>,
    net_linear: Option<&'a Figure<S>>,
    net_quantized: Option<&'a Figure<S>>,
    margin: Option<&'a Margin<S>>,
    criterion_holds: Option<bool>,
    violates_linear: Option<bool>,
    violates_quantized: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    extra_storage: Option<&'a Figure<S>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<&'a Figure<S>>,
}

impl<'a, S: Written> LedgerRow<'a, S> {
    fn of(h: u64, entry: &'a Entry<S>, accounted: bool) -> Self {
        let account = &entry.account;
        let of_force = |figure| accounted.then_some(figure);
        let violated = |is_violated| truth(is_violated).filter(|_| accounted);
        Self {
            h,
            xi0: &entry.xi0,
            xi1: &entry.xi1,
            dtau: Lowest(&entry.dtau),
            generated_linear: of_force(&account.generated_linear),
            generated_quantized: of_force(&account.generated_quantized),
            bound_22: &account.bound_22,
            bound_quantized: &account.bound_quantized,
            dissipated_lower: &account.dissipated_lower,
            net_linear: of_force(&account.net_linear),
            net_quantized: of_force(&account.net_quantized),
            margin: entry.margin.as_ref(),
            criterion_holds: truth(entry.criterion_holds),
            violates_linear: violated(entry.violates_linear),
            violates_quantized: violated(entry.violates_quantized),
            extra_storage: entry.extra_storage.as_ref().filter(|_| accounted),
            force: entry.force(),
        }
    }
}

/// A row with its number: the ledger row of the interface.
///
/// # Example
///
/// ```
/// use passivity_core::{Friction, Interval, Loop};
/// use passivity_audit::{Ledger, Logged, Number, NumberedRow, Reading, json};
///
/// let three_fifths = Number::Small(3, 5).to_rational();
/// let plain = Loop::plain(Friction::new(three_fifths.clone(), three_fifths));
/// let ledger = Ledger::new(&plain.map(|_, x| Interval::point(x.clone()))).unwrap();
/// let at = |text| Reading::Exact(Number::parse(text).unwrap());
/// let interval = Logged { samples: vec![at("1")], end: at("1/2"), dtau: Number::whole(1), force: None };
/// let mut text = Vec::new();
/// let row = NumberedRow { h: 0, row: ledger.row(&interval).unwrap(), accounted: true };
/// json::write(&row, &mut text).unwrap();
/// let start = br#"{"h": 0, "xi0": "1", "xi1": "1/2", "dtau": "1", "generated_linear": "3/8", "#;
/// assert!(text.starts_with(start));
/// ```
#[derive(Clone, Debug)]
pub struct NumberedRow {
    /// Which interval it is, from 0.
    pub h: u64,
    /// Its row.
    pub row: Row,
    /// Whether its force is the one that acted: if not, what that generated is null.
    pub accounted: bool,
}

impl Serialize for NumberedRow {
    fn serialize<T: Serializer>(&self, serializer: T) -> Result<T::Ok, T::Error> {
        on_entry!(&self.row, entry => LedgerRow::of(self.h, entry, self.accounted).serialize(serializer))
    }
}

/// Writes a rational as a string in lowest terms: for `#[serde(serialize_with = …)]`.
pub(crate) fn rational<T: Serializer>(x: &BigRational, serializer: T) -> Result<T::Ok, T::Error> {
    serializer.collect_str(x)
}

/// Spaces after colons and commas, and no line breaks: how the line protocol writes.
struct Spaced;

impl Formatter for Spaced {
    fn begin_array_value<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        if first { Ok(()) } else { out.write_all(b", ") }
    }

    fn begin_object_key<W: ?Sized + io::Write>(
        &mut self,
        out: &mut W,
        first: bool,
    ) -> io::Result<()> {
        if first { Ok(()) } else { out.write_all(b", ") }
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, out: &mut W) -> io::Result<()> {
        out.write_all(b": ")
    }
}

/// Appends a value as JSON on one line, with a space after every colon and comma.
///
/// # Errors
///
/// Those of the value, as when a figure is not defined.
pub fn write<T: Serialize + ?Sized>(value: &T, out: &mut Vec<u8>) -> serde_json::Result<()> {
    value.serialize(&mut serde_json::Serializer::with_formatter(out, Spaced))
}

/// Whether an object in a JSON text has a key twice, of which `value`, which was read from it, has the last one: then
/// the text has more colons outside of strings than the value has entries.
///
/// # Example
///
/// ```
/// use passivity_audit::json::has_key_twice;
///
/// for (text, twice) in [(r#"{"x": 1, "y": {"x": ":"}}"#, false), (r#"{"x": 1, "x": 1}"#, true)] {
///     assert_eq!(has_key_twice(text.as_bytes(), &serde_json::from_str(text).unwrap()), twice);
/// }
/// ```
#[must_use]
pub fn has_key_twice(text: &[u8], value: &serde_json::Value) -> bool {
    colons(text) != entries(value)
}

fn colons(text: &[u8]) -> usize {
    let (mut count, mut inside, mut escaped) = (0, false, false);
    for byte in text {
        match byte {
            _ if escaped => escaped = false,
            b'\\' if inside => escaped = true,
            b'"' => inside = !inside,
            b':' if !inside => count += 1,
            _ => {}
        }
    }
    count
}

fn entries(value: &serde_json::Value) -> usize {
    match value {
        serde_json::Value::Object(fields) => {
            fields.len() + fields.values().map(entries).sum::<usize>()
        }
        serde_json::Value::Array(items) => items.iter().map(entries).sum(),
        _ => 0,
    }
}
