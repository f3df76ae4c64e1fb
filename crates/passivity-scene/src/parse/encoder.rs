//! The encoder: its resolution, or its counts per revolution, at the device or at the motor.

use num_bigint::BigInt;
use num_traits::ToPrimitive as _;
use passivity_core::{BigRational, Exact, Interval, Parameter, pi};

use crate::diagnostic::{Diagnostic, Kind};
use crate::number::{self, parse_prefix};
use crate::parse::build::{self, Parameters};
use crate::parse::keys::shorten;
use crate::parse::node::{Content, Entry, Node};
use crate::parse::reader::{Reader, Section, UnitNote};
use crate::scene::{Given, Motion};
use crate::written::{Form, Written};

/// The most counts per revolution that are believed of an encoder.
pub const MAX_COUNTS: u64 = 1_000_000_000_000;

/// Words that may follow the counts of a revolution.
const COUNTS: [&str; 8] = [
    "cpr",
    "count",
    "counts",
    "counts/rev",
    "counts/turn",
    "counts per revolution",
    "counts per turn",
    "ticks/rev",
];

/// Words for lines of a disc, of which quadrature makes four counts each.
const LINES: [&str; 6] = ["ppr", "lines", "line", "pulses", "pulses/rev", "lpr"];

pub(super) fn read(mut section: Section, parameters: &mut Parameters, reader: &mut Reader<'_>) {
    let side = section.take("encoder.side");
    let at_motor = side.is_some_and(|entry| is_at_motor(&entry, reader));
    let keys = ["encoder.resolution", "encoder.counts_per_revolution"];
    let [resolution, counts] = reader.either(&mut section, keys);
    if resolution.is_none() && counts.is_none() {
        let what = "`counts_per_revolution` or `resolution`";
        reader.missing(Some(&section), section.name, what);
    }
    reader.leftovers(section);
    let entry = resolution.map(|entry| (keys[0], entry));
    let entry = entry.or(counts.map(|entry| (keys[1], entry)));
    let given = entry
        .and_then(|(key, entry)| build::value(Parameter::Resolution, key, at_motor, entry, reader));
    parameters.insert(Parameter::Resolution, given);
}

/// Whether `side` says that the encoder sits on the motor.
fn is_at_motor(entry: &Entry, reader: &mut Reader<'_>) -> bool {
    let found = match &entry.node.content {
        Content::Text(text, _) => match (text.as_str(), &reader.transmission) {
            ("motor", Some(_)) => return true,
            ("device", _) => return false,
            ("motor", None) if !reader.problems.is_empty() => return false,
            ("motor", None) => {
                let message = "an encoder on the motor needs a [transmission]";
                let diagnostic = Diagnostic::new(Kind::MissingKey, message)
                    .at(entry.node.span.clone())
                    .key("transmission")
                    .expected("`[transmission]` with `ratio`");
                reader.report(diagnostic);
                return false;
            }
            (other, _) => format!("`{}`", shorten(other)),
        },
        _ => entry.node.words().to_owned(),
    };
    let diagnostic = Diagnostic::new(Kind::OutOfBounds, "this is no side of a transmission")
        .at(entry.node.span.clone())
        .key("encoder.side")
        .expected("`\"motor\"` or `\"device\"`")
        .found(found);
    reader.report(diagnostic);
    false
}

/// Δ = 2π/N of N counts per revolution, over the ratio where the encoder sits on the motor.
pub(super) fn counts_per_revolution(
    entry: &Entry,
    key: &'static str,
    at_motor: bool,
    reader: &mut Reader<'_>,
) -> Option<Given> {
    let counts = match &entry.node.content {
        Content::Text(text, _) => match in_words(text) {
            Some(Words::Counts(counts)) => counts,
            Some(Words::Lines(lines)) => {
                let message = "lines or pulses of a disc are not the counts that a decoder makes";
                let help = format!(
                    "with quadrature decoding {} is `{}`",
                    shorten(text),
                    lines.saturating_mul(4)
                );
                let diagnostic = Diagnostic::new(Kind::WrongUnit, message)
                    .at(entry.node.span.clone())
                    .key(key)
                    .expected("the counts per revolution behind the decoder")
                    .found(format!("`{}`", shorten(text)))
                    .help(Some(help));
                reader.report(diagnostic);
                return None;
            }
            None => match unknown(text) {
                Some(kind) => {
                    let found = format!("`{}`", shorten(text));
                    let expected =
                        format!("a whole number from 1 to {MAX_COUNTS}, or bits such as `14 bit`");
                    let diagnostic = Diagnostic::new(kind, format!("`{key}` cannot be {found}"))
                        .at(entry.node.span.clone())
                        .key(key)
                        .expected(expected)
                        .found(found);
                    reader.report(diagnostic);
                    return None;
                }
                None => reader.whole(entry, key, (1, MAX_COUNTS))?,
            },
        },
        _ => reader.whole(entry, key, (1, MAX_COUNTS))?,
    };
    if !at_motor {
        reader.unit_notes.push(UnitNote {
            key,
            measure: None,
            motion: Motion::Rotary,
            unit: "counts per revolution".to_owned(),
            span: entry.node.span.clone(),
        });
    }
    let turn = BigRational::new(BigInt::from(2), BigInt::from(counts));
    let mut nominal = Exact::of(&turn) * pi::pi();
    let mut written = Written::new(Form::Count, "", pi::pi() + pi::pi());
    if at_motor {
        let factor = reader.factor(Parameter::Resolution)?;
        nominal = nominal * factor.clone();
        written = written.at_motor(&factor);
    }
    Some(Given {
        key,
        value: Interval::point(nominal.clone()),
        nominal,
        text: text_of(&entry.node, counts),
        written,
        span: entry.node.span.clone(),
        remark: None,
        parts: None,
    })
}

fn text_of(node: &Node, counts: u64) -> String {
    match &node.content {
        Content::Text(text, _) if number::parse(text).is_err() => text.clone(),
        _ => counts.to_string(),
    }
}

/// Counts or lines, where words say which.
enum Words {
    Counts(u64),
    Lines(u64),
}

/// A number and the word behind it, which may be empty.
fn parts(text: &str) -> Option<(BigRational, String)> {
    let text = text.trim();
    let limits = number::Limits {
        chars: 20,
        exponent: 12,
    };
    let (value, len) = parse_prefix(text, limits).ok()?;
    let word = text.get(len..)?.trim_start_matches([' ', '-']);
    Some((value, word.to_lowercase()))
}

/// What is wrong with a number that has a word behind it: the number, where the word is one for counts.
fn unknown(text: &str) -> Option<Kind> {
    let (_, word) = parts(text)?;
    let word = word.as_str();
    match word {
        "" => None,
        "bit" | "bits" => Some(Kind::OutOfBounds),
        _ if COUNTS.contains(&word) || LINES.contains(&word) => Some(Kind::OutOfBounds),
        _ => Some(Kind::WrongUnit),
    }
}

/// `8192 cpr`, `14 bit` or `500 lines`; `None` for a plain number and for what is none of these.
fn in_words(text: &str) -> Option<Words> {
    let (value, word) = parts(text)?;
    let whole = value
        .is_integer()
        .then(|| value.numer().to_u64())
        .flatten()?;
    let in_range = |counts: &u64| (1..=MAX_COUNTS).contains(counts);
    if COUNTS.contains(&word.as_str()) {
        return Some(whole).filter(in_range).map(Words::Counts);
    }
    if LINES.contains(&word.as_str()) {
        return Some(Words::Lines(whole));
    }
    let bits = u32::try_from(whole).ok().filter(|bits| *bits < 40)?;
    let counts = matches!(word.as_str(), "bit" | "bits").then(|| 2u64.pow(bits))?;
    Some(counts).filter(in_range).map(Words::Counts)
}
