//! Drives another implementation through the vectors, over the line protocol.

use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read as _, Write as _};
use std::sync::mpsc;
use std::time::Duration;

use passivity_core::BigRational;
use passivity_scene::json::read_rational;
use passivity_scene::number::nearest_f64;
use serde_json::Value;

use crate::children::Children;
use crate::{Group, Test, witness};

/// How long to wait for the next answer where nobody says otherwise.
pub const PATIENCE: Duration = Duration::from_secs(60);

/// How long to listen, once every test is answered, to what ends nevertheless not.
const AFTERWARDS: Duration = Duration::from_secs(2);

/// The longest answer that is read, in bytes: many times the longest that a test expects.
const MAX_ANSWER: u64 = 1 << 20;

/// A test to which another implementation answers otherwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The group.
    pub group: &'static str,
    /// The test.
    pub id: u64,
    /// What differs, field by field: the field, as in `rows[2].net_linear`, and what was expected and
    /// found there. At least one.
    pub fields: Vec<(String, String)>,
    /// The request.
    pub request: Value,
    /// The answer that was expected; `None` where it is an error.
    pub expected: Option<Value>,
    /// The answer that came; `None` where none did.
    pub answer: Option<Value>,
}

/// What came of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// How many tests were run.
    pub tests: usize,
    /// The tests with another answer, in their order.
    pub differences: Vec<Difference>,
}

/// Runs `command` with the shell, asks it every test of `groups`, waits at most `patience` for each next
/// answer, and compares the answers. In the end the command is ended, with all that it started.
///
/// # Errors
///
/// When the command cannot be started.
pub fn against(command: &str, groups: &[Group], patience: Duration) -> std::io::Result<Outcome> {
    let mut child = Children::start(command)?;
    let lines: Vec<String> = groups
        .iter()
        .flat_map(|group| &group.tests)
        .map(Test::line)
        .collect();
    let mut input = child.process.stdin.take();
    // Asking and listening at once: neither side's pipe fills up.
    std::thread::spawn(move || {
        for line in lines {
            let Some(input) = &mut input else { return };
            if writeln!(input, "{line}").is_err() {
                return;
            }
        }
        drop(input);
    });
    // A few answers in advance: a flood of them waits in the pipe, not in memory.
    let (heard, answers) = mpsc::sync_channel(64);
    let output = child.process.stdout.take();
    std::thread::spawn(move || {
        let Some(output) = output else { return };
        let mut output = BufReader::new(output);
        while let Ok(Some(line)) = read_line(&mut output) {
            if heard.send(line).is_err() {
                return;
            }
        }
    });
    let mut judge = Judge::new(groups);
    // It may talk besides answering, but not without end.
    let mut lines_left = 2 * judge.open.len();
    while lines_left > 0 {
        lines_left -= 1;
        let patience = match judge.open.is_empty() {
            true => patience.min(AFTERWARDS),
            false => patience,
        };
        let Ok(line) = answers.recv_timeout(patience) else {
            break;
        };
        judge.hear(&line);
    }
    // Whatever it still does, it is asked nothing more.
    drop(child);
    Ok(judge.finish())
}

/// The next line, cut off after [`MAX_ANSWER`] bytes; `None` at the end.
fn read_line(input: &mut impl BufRead) -> std::io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    if input.take(MAX_ANSWER).read_until(b'\n', &mut line)? == 0 {
        return Ok(None);
    }
    if line.last() != Some(&b'\n') && input.skip_until(b'\n')? > 0 {
        // Too long to be an answer, and nothing that it says is used.
        line = format!("a line of more than {MAX_ANSWER} bytes").into_bytes();
    }
    Ok(Some(line))
}

/// Compares the answers of another implementation with what the tests expect, one by one.
///
/// # Example
///
/// ```
/// use passivity_vectors::{Judge, named};
///
/// let groups = named(&["errata"]).unwrap();
/// let mut judge = Judge::new(&groups);
/// judge.hear(br#"{"id": 1, "result": {}}"#);
/// judge.hear(b"Segmentation fault");
/// let outcome = judge.finish();
/// assert!(outcome.differences.len() >= outcome.tests);
/// ```
#[derive(Debug)]
pub struct Judge<'a> {
    groups: &'a [Group],
    /// The tests that have no answer yet.
    open: HashMap<u64, &'a Test>,
    /// What differs in each answer, and the answer.
    found: HashMap<u64, (Found, Value)>,
    /// How many lines it said.
    lines: usize,
    /// By the test that was to be answered next, the first line that is no answer to any.
    talk: HashMap<u64, String>,
}

impl<'a> Judge<'a> {
    /// Expects an answer to each test of `groups`.
    #[must_use]
    pub fn new(groups: &'a [Group]) -> Self {
        let tests = groups.iter().flat_map(|group| &group.tests);
        Self {
            groups,
            open: tests.map(|test| (test.id, test)).collect(),
            found: HashMap::new(),
            lines: 0,
            talk: HashMap::new(),
        }
    }

    /// Takes a line that the implementation says. One that is no answer to a test is a difference of the test that was
    /// to be answered next, but for blank ones, which are passed over; of several answers the first counts, and
    /// that there are more is a difference.
    pub fn hear(&mut self, line: &[u8]) {
        self.lines += 1;
        if line.trim_ascii().is_empty() {
            return;
        }
        let answer = serde_json::from_slice::<Value>(line).unwrap_or_default();
        let known = |id: &u64| self.open.contains_key(id) || self.found.contains_key(id);
        let Some(id) = answer["id"].as_u64().filter(known) else {
            return self.note(line);
        };
        if let Some(test) = self.open.remove(&id) {
            let mut found = Vec::new();
            judge(test, &answer, &mut found);
            self.found.insert(id, (found, answer));
        } else if let Some((found, _)) = self.found.get_mut(&id) {
            let again = (String::new(), "answered more than once".to_owned());
            if !found.contains(&again) {
                found.push(again);
            }
        }
    }

    /// Notes a line that is no answer.
    fn note(&mut self, line: &[u8]) {
        let mut tests = self.groups.iter().flat_map(|group| &group.tests);
        let next = tests.clone().find(|test| self.open.contains_key(&test.id));
        let Some(test) = next.or_else(|| tests.next_back()) else {
            return;
        };
        let text = String::from_utf8_lossy(line.trim_ascii());
        let message = format!("line {} is no answer to a test: {}", self.lines, cut(&text));
        self.talk.entry(test.id).or_insert(message);
    }

    /// What came of it.
    #[must_use]
    pub fn finish(mut self) -> Outcome {
        let mut outcome = Outcome::default();
        for group in self.groups {
            for test in &group.tests {
                outcome.tests += 1;
                let (mut fields, answer) = match self.found.remove(&test.id) {
                    Some((fields, answer)) => (fields, Some(answer)),
                    None => (vec![(String::new(), "no answer".to_owned())], None),
                };
                fields.extend(self.talk.remove(&test.id).map(|talk| (String::new(), talk)));
                if !fields.is_empty() {
                    outcome.differences.push(Difference {
                        group: group.name,
                        id: test.id,
                        fields,
                        request: test.request.clone(),
                        expected: test.result.clone(),
                        answer,
                    });
                }
            }
        }
        outcome
    }
}

/// Field and message of each difference.
type Found = Vec<(String, String)>;

fn judge(test: &Test, answer: &Value, found: &mut Found) {
    match (&test.result, answer.get("result"), answer.get("error")) {
        (None, None, Some(error)) if is_refusal(error) => {}
        (None, _, _) => {
            let message = "expected an error with a kind and a message, and no result";
            found.push((String::new(), message.to_owned()));
        }
        (Some(_), None, _) | (Some(_), _, Some(_)) => {
            let message = format!("expected a result and no error, found {}", short(answer));
            found.push((String::new(), message));
        }
        (Some(expected), Some(result), None) => {
            if test.request["op"] == "motion" {
                meets(expected, result, found);
            } else {
                differs(expected, result, "", found);
            }
            blame_formula(test, result, found);
            // A witness need not be the expected one, but it must draw energy.
            if result["verdict"] == "not_passive" {
                if let Err(message) = witness::check(&test.request["scene"], &result["witness"]) {
                    found.push(("witness".to_owned(), message));
                }
            } else if expected.get("witness").is_some()
                && result.get("witness") != Some(&Value::Null)
            {
                let message = "expected null, for a wall that is not called not passive";
                found.push(("witness".to_owned(), message.to_owned()));
            }
        }
    }
}

/// Whether an error says what kind of mistake it is, and says it to people.
fn is_refusal(error: &Value) -> bool {
    let mut fields = ["kind", "message"].iter().map(|field| &error[*field]);
    fields.all(|text| text.as_str().is_some_and(|text| !text.is_empty()))
}

/// Says so where a wrong verdict is that of a formula which circulates.
fn blame_formula(test: &Test, result: &Value, found: &mut Found) {
    let Some(formula) = &test.formula else { return };
    if (result["verdict"] == "passive") != (formula.says == "passive") {
        return;
    }
    for (_, message) in found.iter_mut().filter(|(field, _)| field == "verdict") {
        message.push_str(&format!(", as the wrong formula {} says", formula.name));
    }
}

/// Every expected field must be there; further fields are ignored.
fn differs(expected: &Value, actual: &Value, field: &str, found: &mut Found) {
    match (expected, actual) {
        _ if encloses(expected, actual) => {}
        (Value::Object(expected), Value::Object(actual)) => {
            for (name, expected) in expected.iter().filter(|(name, _)| *name != "witness") {
                let field = if field.is_empty() {
                    name.clone()
                } else {
                    format!("{field}.{name}")
                };
                match actual.get(name) {
                    Some(actual) => differs(expected, actual, &field, found),
                    None => found.push((field, "the field is missing".to_owned())),
                }
            }
        }
        (Value::Array(expected), Value::Array(actual)) if expected.len() == actual.len() => {
            for (i, (expected, actual)) in expected.iter().zip(actual).enumerate() {
                differs(expected, actual, &format!("{field}[{i}]"), found);
            }
        }
        _ if expected == actual => {}
        _ => {
            let message = format!("expected {}, found {}", short(expected), short(actual));
            found.push((field.to_owned(), message));
        }
    }
}

/// Whether both are enclosures of a figure that is not known exactly, as tight as 10⁻¹² of its
/// size, and meet: how tightly it is enclosed is each implementation's own.
fn encloses(expected: &Value, actual: &Value) -> bool {
    let [Some([lo, hi]), Some([least, most])] = [expected, actual].map(ends) else {
        return false;
    };
    let size = num_traits::Signed::abs(&hi) + BigRational::from_integer(1.into());
    let tight = size / BigRational::from_integer(1_000_000_000_000_i64.into());
    let is_open = lo < hi && least < most;
    is_open && least <= hi && lo <= most && &hi - &lo <= tight && &most - &least <= tight
}

/// Whether numbers are in the enclosures of the test, widened a little, as a whole: no part of an interval may be further
/// from them than a number may be.
fn meets(expected: &Value, actual: &Value, found: &mut Found) {
    for field in ["xi", "velocity"] {
        let ends = [&expected[field], &actual[field]].map(ends);
        let [Some([lo, hi]), Some([least, most])] = ends else {
            found.push((field.to_owned(), "expected a number or {lo, hi}".to_owned()));
            continue;
        };
        let tolerance = BigRational::new(1.into(), 1_000_000_000.into());
        let size = num_traits::Signed::abs(&hi) + BigRational::from_integer(1.into());
        let slack = tolerance * size;
        if least > most || most > &hi + &slack || least < &lo - &slack {
            let [lo, hi, least, most] = [lo, hi, least, most].map(|x| nearest_f64(&x));
            let message = format!("expected {lo} … {hi}, found {least} … {most}");
            found.push((field.to_owned(), message));
        }
    }
}

fn ends(value: &Value) -> Option<[BigRational; 2]> {
    match value {
        Value::Object(ends) => Some([
            read_rational(ends.get("lo")?).ok()?,
            read_rational(ends.get("hi")?).ok()?,
        ]),
        number => read_rational(number).ok().map(|x| [x.clone(), x]),
    }
}

fn short(value: &Value) -> String {
    cut(&value.to_string())
}

fn cut(text: &str) -> String {
    const MOST: usize = 120;
    match text.char_indices().nth(MOST) {
        Some((at, _)) => format!("{}…", text.get(..at).unwrap_or_default()),
        None => text.to_owned(),
    }
}
