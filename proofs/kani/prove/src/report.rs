//! What `cargo kani` printed, harness by harness.
//!
//! Understands the terse format, of one thread or of several ("Thread 1: Checking harness …"),
//! and skips what the regular format has in addition.

use std::collections::BTreeMap;

/// The report on one harness.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Report {
    /// What follows `VERIFICATION:-`, or nothing when the run did not get there.
    pub(crate) verdict: Option<String>,
    /// Covers that are satisfied, and all of them.
    pub(crate) covers: (usize, usize),
    /// The messages of the checks that failed.
    pub(crate) failed: Vec<String>,
    /// What Kani took, in seconds.
    pub(crate) seconds: Option<f64>,
}

/// The reports by name of harness. A name that is reported twice is an error.
///
/// # Errors
///
/// A sentence about the line that does not fit.
pub(crate) fn read(output: &str) -> Result<BTreeMap<String, Report>, String> {
    let mut reports: BTreeMap<String, Report> = BTreeMap::new();
    // Which harness each thread is at; without threads, all is thread 0.
    let mut at: BTreeMap<u32, String> = BTreeMap::new();
    let mut thread = 0;
    for raw in output.lines() {
        let plain = without_colour(raw);
        let mut line = plain.trim();
        if let Some((number, rest)) = thread_prefix(line) {
            thread = number;
            line = rest;
        }
        if let Some(name) = between(line, "Checking harness ", "...") {
            let name = name
                .strip_prefix("passivity_kani::")
                .unwrap_or(name)
                .to_string();
            if reports.insert(name.clone(), Report::default()).is_some() {
                return Err(format!("harness `{name}` is reported twice"));
            }
            at.insert(thread, name);
            continue;
        }
        if line.starts_with("Manual Harness Summary:") || line.starts_with("Complete - ") {
            break;
        }
        let Some(report) = at.get(&thread).and_then(|name| reports.get_mut(name)) else {
            continue;
        };
        if let Some(verdict) = line.strip_prefix("VERIFICATION:- ") {
            if report.verdict.replace(verdict.to_string()).is_some() {
                return Err(format!("a harness has two verdicts: `{raw}`"));
            }
        } else if let Some(message) = line.strip_prefix("Failed Checks: ") {
            report.failed.push(message.to_string());
        } else if let Some(time) = between(line, "Verification Time: ", "s") {
            report.seconds = time.parse().ok();
        } else if let Some(counts) = cover_counts(line) {
            report.covers = counts;
        }
    }
    Ok(reports)
}

/// `** 2 of 3 cover properties satisfied (1 unreachable)`.
fn cover_counts(line: &str) -> Option<(usize, usize)> {
    let (counts, _) = line
        .strip_prefix("** ")?
        .split_once(" cover properties satisfied")?;
    let (satisfied, all) = counts.split_once(" of ")?;
    Some((satisfied.parse().ok()?, all.parse().ok()?))
}

fn thread_prefix(line: &str) -> Option<(u32, &str)> {
    let (number, rest) = line.strip_prefix("Thread ")?.split_once(':')?;
    Some((number.parse().ok()?, rest.trim()))
}

fn between<'a>(line: &'a str, before: &str, after: &str) -> Option<&'a str> {
    line.strip_prefix(before)?.strip_suffix(after)
}

/// The line without terminal colours, which are there when Kani believes in a terminal.
fn without_colour(line: &str) -> String {
    let mut plain = String::new();
    let mut rest = line.chars();
    while let Some(c) = rest.next() {
        if c == '\u{1b}' {
            // Up to the letter that ends the sequence.
            let _ = rest.by_ref().find(char::is_ascii_alphabetic);
        } else {
            plain.push(c);
        }
    }
    plain
}
