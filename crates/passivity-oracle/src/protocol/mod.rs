//! The line protocol: a request a line, an answer a line, and no request that ends the process.

mod duplicate;
mod fields;
mod ops;
mod serve;
mod work;

pub use serve::{MAX_LINE, serve};

use serde::Serialize;
use serde_json::Value;

use crate::protocol::fields::Fields;
use crate::protocol::work::Work;
use passivity_audit::json;

/// The number of this protocol.
pub const PROTOCOL: u32 = 1;

/// What each line is to be.
const REQUEST: &str = r#"an object such as {"id": 1, "op": "version"}"#;

/// The most positions in a `run`.
pub const MAX_POSITIONS: usize = 1_000_000;

/// The longest answer, in bytes: that of a `run` of a million plain positions is shorter. Numbers
/// with thousands of digits each would fill the memory.
pub const MAX_ANSWER: usize = 512 << 20;

/// Why a request has no result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// What kind of mistake it is, for programs.
    pub kind: String,
    /// What is wrong, for people.
    pub message: String,
    /// The field, as in `xi[3]`; or the byte of the line, from 1, where it is no JSON.
    pub at: At,
}

/// The place of a mistake.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum At {
    /// The request as a whole.
    Request,
    /// A field.
    Field(String),
    /// A byte of the line, from 1.
    Byte(usize),
}

impl Refusal {
    pub(crate) fn new(kind: &str, at: At, message: impl Into<String>) -> Self {
        Self {
            kind: kind.to_owned(),
            message: message.into(),
            at,
        }
    }
}

/// Appends the answer to one request, without a line break.
///
/// # Example
///
/// ```
/// let mut answer = Vec::new();
/// passivity_oracle::protocol::answer(br#"{"id": 7, "op": "interval", "xi0": "1/0"}"#, &mut answer);
/// let answer = String::from_utf8(answer).unwrap();
/// assert!(answer.starts_with(r#"{"id": 7, "error": {"kind": "zero_denominator""#));
/// ```
pub fn answer(line: &[u8], out: &mut Vec<u8>) {
    let request: Value = match serde_json::from_slice(line) {
        Ok(request) => request,
        Err(error) => {
            let at = At::Byte(byte_of(&error, line));
            // What stands in the place of an object may be anything: what a reader of JSON makes of it helps nobody.
            let message = match line.trim_ascii_start().first() {
                Some(b'{') => format!("this is not JSON: {}", plain(&error)),
                _ => format!("this is not JSON: expected {REQUEST}"),
            };
            let refusal = Refusal::new("bad_json", at, message);
            return refuse(&Value::Null, &refusal, out);
        }
    };
    if let Some(duplicate) = duplicate::find(line, &request) {
        let key = shown(&duplicate.key);
        if duplicate.key == duplicate::RESERVED {
            // It may stand in the id.
            let message = format!("the key `{key}` cannot be used: it stands for a number here");
            let refusal = Refusal::new("bad_request", At::Byte(duplicate.at), message);
            return refuse(&Value::Null, &refusal, out);
        }
        let message = format!("the key `{key}` is given twice in one object");
        let refusal = Refusal::new("duplicate_key", At::Byte(duplicate.at), message);
        return refuse(request.get("id").unwrap_or(&Value::Null), &refusal, out);
    }
    let Value::Object(map) = &request else {
        let message = format!("a request is {REQUEST}");
        return refuse(
            &Value::Null,
            &Refusal::new("bad_request", At::Request, message),
            out,
        );
    };
    let id = map.get("id").unwrap_or(&Value::Null);
    let start = out.len();
    open(id, "result", out);
    match ops::run(&Fields::new(map), Work::of_request(line.len()), out) {
        Ok(()) => out.push(b'}'),
        Err(refusal) => {
            out.truncate(start);
            refuse(id, &refusal, out);
        }
    }
}

/// The byte, from 1, at which a text is no JSON. A request of a library may have line breaks.
fn byte_of(error: &serde_json::Error, text: &[u8]) -> usize {
    let lines = text.split_inclusive(|byte| *byte == b'\n');
    let before = lines.take(error.line().saturating_sub(1)).map(<[u8]>::len);
    (before.sum::<usize>() + error.column()).max(1)
}

/// Text of a request as a message shows it: short.
fn shown(text: &str) -> String {
    const MOST: usize = 40;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", text.get(..end).unwrap_or_default()),
        None => text.to_owned(),
    }
}

/// The error without its place, which the answer has on its own.
fn plain(error: &serde_json::Error) -> String {
    let text = error.to_string();
    let message = text
        .rsplit_once(" at line ")
        .map_or(&*text, |(message, _)| message);
    // As the library calls what begins like these.
    message.replace("expected ident", "expected `true`, `false` or `null`")
}

fn open(id: &Value, key: &str, out: &mut Vec<u8>) {
    out.extend_from_slice(b"{\"id\": ");
    out.extend_from_slice(id.to_string().as_bytes());
    out.extend_from_slice(b", \"");
    out.extend_from_slice(key.as_bytes());
    out.extend_from_slice(b"\": ");
}

fn refuse(id: &Value, refusal: &Refusal, out: &mut Vec<u8>) {
    open(id, "error", out);
    if let Err(error) = json::write(refusal, out) {
        unreachable!("a refusal is text and numbers: {error}");
    }
    out.push(b'}');
}
