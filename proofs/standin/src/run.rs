//! One harness as a test: what it promises against what was seen.

use std::path::Path;
use std::time::Instant;

use crate::explore::{Seen, explore};
use crate::list::{self, Entry};
use crate::record;

/// What a harness's own text says of it; made by `#[kani::proof]`.
#[derive(Clone, Copy, Debug)]
pub struct Harness {
    /// The folder of its crate, where `harnesses.toml` is.
    pub manifest_dir: &'static str,
    /// `crate::file::function`.
    pub path: &'static str,
    /// Whether it has `#[kani::should_panic]`.
    pub must_fail: bool,
    /// The messages of its covers.
    pub covers: &'static [&'static str],
    /// The messages of its assertions.
    pub assertions: &'static [&'static str],
}

/// Explores a harness, writes its record when `PASSIVITY_EVIDENCE_DIR` names a folder, and
/// panics with every fault found.
///
/// # Panics
///
/// When the harness does not keep what it promises; see the crate's documentation.
pub fn check(harness: &Harness, body: fn()) {
    let name = harness
        .path
        .split_once("::")
        .map_or(harness.path, |(_, name)| name);
    let list = list::read(Path::new(harness.manifest_dir)).unwrap_or_else(|e| panic!("{e}"));
    let Some(entry) = list.find(name) else {
        panic!("the harness `{name}` is not in harnesses.toml");
    };
    let started = Instant::now();
    let seen = explore(name, entry.must_fail.as_deref(), body);
    let seconds = started.elapsed().as_secs_f64();
    let mut faults = compare(harness, entry);
    faults.extend(judge(entry, &seen));
    if let Some(folder) = std::env::var_os("PASSIVITY_EVIDENCE_DIR") {
        record::append(Path::new(&folder), entry, &seen, &faults, seconds)
            .unwrap_or_else(|e| panic!("cannot write the record of `{name}`: {e}"));
    }
    // Shown with `cargo test -- --show-output`, and with a failure.
    eprintln!(
        "{name}: {:?}, {} inputs, {} cases, {seconds:.2} s, covers {:?}",
        seen.mode, seen.inputs, seen.cases, seen.hits
    );
    assert!(faults.is_empty(), "{name}:\n  {}", faults.join("\n  "));
}

/// Where the list and the text of a harness disagree.
fn compare(harness: &Harness, entry: &Entry) -> Vec<String> {
    let mut faults = Vec::new();
    if entry.covers != harness.covers {
        faults.push(format!(
            "harnesses.toml lists the covers {:?}, its text has {:?}",
            entry.covers, harness.covers
        ));
    }
    if harness.covers.is_empty() {
        faults.push("it has no cover".into());
    }
    if harness.assertions.is_empty() {
        faults.push("it asserts nothing".into());
    }
    match (&entry.must_fail, harness.must_fail) {
        (None, false) => {}
        (Some(message), true) if harness.assertions == [message.as_str()] => {}
        (Some(message), true) => faults.push(format!(
            "it must fail with \"{message}\" and assert nothing else, but asserts {:?}",
            harness.assertions
        )),
        (listed, _) => faults.push(format!(
            "harnesses.toml and its text disagree on whether it must fail (listed: {listed:?})"
        )),
    }
    if !entry.claims.iter().any(|id| mentions(&entry.name, id)) {
        faults.push(format!(
            "its name has none of its claims {:?}",
            entry.claims
        ));
    }
    faults
}

/// Whether a harness's name begins with a claim's id: `th_lin_bound` with `TH-LIN`.
fn mentions(name: &str, id: &str) -> bool {
    let id = id
        .to_lowercase()
        .replace("..", "-")
        .replace(['-', '/'], "_");
    name.rsplit("::")
        .next()
        .is_some_and(|function| function.starts_with(&id))
}

/// Where what was seen is not what was promised.
fn judge(entry: &Entry, seen: &Seen) -> Vec<String> {
    let mut faults = Vec::new();
    if seen.cases == 0 {
        faults.push("no input meets its assumptions: it says nothing".into());
    }
    for cover in &entry.covers {
        // What is left early may not have come to all of them.
        if !seen.is_left() && !seen.hits.contains_key(cover.as_str()) {
            faults.push(format!("its cover is never hit: \"{cover}\""));
        }
    }
    for (message, (count, first)) in &seen.failures {
        if entry.must_fail.as_ref() != Some(message) {
            let more = if seen.is_left() { "and more " } else { "" };
            faults.push(format!(
                "{count} {more}inputs fail \"{message}\"; the first{first}"
            ));
        }
    }
    if let Some(message) = &entry.must_fail {
        if !seen.failures.contains_key(message) {
            faults.push(format!("it must fail with \"{message}\" and does not"));
        }
    }
    faults
}
