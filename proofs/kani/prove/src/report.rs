//! What `cargo kani` printed, harness by harness.
//!
//! Understands the regular format, which names every check, and the terse one, which counts them,
//! of one thread or of several ("Thread 1: Checking harness …").

use std::collections::{BTreeMap, BTreeSet};

/// What was printed by one run.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Run {
    /// The version of Kani, from its first line.
    pub(crate) kani: Option<String>,
    /// The versions of CBMC, where the format says them: `6.8.0`.
    pub(crate) cbmc: BTreeSet<String>,
    /// The solvers, where the format says them: `CaDiCaL 2.0.0`.
    pub(crate) solvers: BTreeSet<String>,
    /// The commit that the harnesses were taken from, where `prove-kani` has noted it.
    pub(crate) commit: Option<String>,
    /// The reports by name of harness.
    pub(crate) harnesses: BTreeMap<String, Report>,
}

/// The report on one harness.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Report {
    /// What follows `VERIFICATION:-`, or nothing when the run did not get there.
    pub(crate) verdict: Option<String>,
    /// What became of its covers.
    pub(crate) covers: Covers,
    /// The messages of the checks that failed.
    pub(crate) failed: Vec<String>,
    /// What Kani took, in seconds.
    pub(crate) seconds: Option<f64>,
    /// Whether the check that is being read is a cover, and whether it is satisfied.
    reading: (bool, bool),
}

/// What became of the covers of a harness. The compiler may copy a cover, and of the copies some
/// may be out of reach.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Covers {
    /// Copies that are satisfied, and all copies, as the summary counts them.
    pub(crate) counted: (usize, usize),
    /// For each message whether any copy of it is satisfied; empty in the terse format.
    pub(crate) satisfied: BTreeMap<String, bool>,
}

/// Reads what was printed. A harness that is reported twice is an error.
///
/// # Errors
///
/// A sentence about the line that does not fit.
pub(crate) fn read(output: &str) -> Result<Run, String> {
    let mut run = Run::default();
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
            if run
                .harnesses
                .insert(name.clone(), Report::default())
                .is_some()
            {
                return Err(format!("harness `{name}` is reported twice"));
            }
            at.insert(thread, name);
            continue;
        }
        if line.starts_with("Manual Harness Summary:") || line.starts_with("Complete - ") {
            break;
        }
        if run.read_tool(line) {
            continue;
        }
        if let Some(report) = at.get(&thread).and_then(|name| run.harnesses.get_mut(name)) {
            report.read(line).map_err(|why| format!("{why}: `{raw}`"))?;
        }
    }
    Ok(run)
}

impl Run {
    /// Reads a line that speaks of the tools, or says that it is no such line.
    fn read_tool(&mut self, line: &str) -> bool {
        let first = |text: &str| text.split_whitespace().next().map(str::to_string);
        if let Some(rest) = line.strip_prefix("Kani Rust Verifier ") {
            self.kani = first(rest);
        } else if let Some(rest) = line.strip_prefix("CBMC version ") {
            self.cbmc.extend(first(rest));
        } else if let Some(solver) = line.strip_prefix("Solving with ") {
            let solver = solver.strip_suffix(" with simplifier").unwrap_or(solver);
            self.solvers.insert(solver.to_string());
        } else if let Some(commit) = line.strip_prefix("Commit: ") {
            self.commit = Some(commit.to_string());
        } else {
            return false;
        }
        true
    }
}

impl Report {
    /// Reads a line of a harness; a line of which nothing is wanted is left alone.
    fn read(&mut self, line: &str) -> Result<(), &'static str> {
        if let Some(verdict) = line.strip_prefix("VERIFICATION:- ") {
            if self.verdict.replace(verdict.to_string()).is_some() {
                return Err("a harness has two verdicts");
            }
        } else if let Some(message) = line.strip_prefix("Failed Checks: ") {
            self.failed.push(message.to_string());
        } else if let Some(time) = between(line, "Verification Time: ", "s") {
            let seconds = time.parse().map_err(|_| "the time is not a number")?;
            self.seconds = Some(seconds);
        } else if let Some(counts) = cover_counts(line) {
            self.covers.counted = counts;
        } else if line.starts_with("Check ") {
            // `Check 3: module::harness.cover.2`
            self.reading = (line.rsplit('.').nth(1) == Some("cover"), false);
        } else if let Some(status) = line.strip_prefix("- Status: ") {
            self.reading.1 = status == "SATISFIED";
        } else if let (true, Some(message)) =
            (self.reading.0, between(line, "- Description: \"", "\""))
        {
            let satisfied = self.covers.satisfied.entry(message.to_string());
            *satisfied.or_default() |= self.reading.1;
        }
        Ok(())
    }
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
