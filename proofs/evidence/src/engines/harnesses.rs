//! The proof harnesses: decided by Kani, and run as tests.

use std::collections::BTreeSet;
use std::path::Path;

use passivity_evidence::{Engine, EvidenceError, Shown};
use serde::Deserialize;

use super::{Done, Modules, Part, Report, built, built_by, lines, tool};
use crate::imported::{HARNESSES, LIST};
use crate::sources::Sources;

/// What runs them as tests, and what it draws numbers with.
const STAND_IN: [&str; 2] = ["proofs/standin", "crates/passivity-random"];

/// What every harness is built of.
pub(crate) fn shared() -> BTreeSet<String> {
    let mut files = built_by(&["proofs/kani/Cargo.toml"]);
    files.extend([LIST, "proofs/kani/src/lib.rs"].map(str::to_owned));
    files
}

/// What Kani said of a harness.
#[derive(Deserialize)]
struct Decided {
    harness: String,
    claims: Vec<String>,
    domain: String,
    version: String,
    passed: bool,
    result: String,
    seconds: Option<f64>,
    /// Why it was not run.
    reason: Option<String>,
}

/// What running a harness as a test said.
#[derive(Deserialize)]
struct Explored {
    harness: String,
    claims: Vec<String>,
    domain: String,
    mode: Mode,
    cases: u64,
    passed: bool,
    result: String,
    seconds: f64,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Mode {
    Exhausted,
    Sampled,
}

pub(super) fn kani(root: &Path, folder: &Path) -> Result<Report, EvidenceError> {
    let name = "kani.jsonl";
    let Some(lines) = lines::<Decided>(&folder.join(name))? else {
        return Ok(Report::absent(
            Engine::Kani,
            "`make prove-kani` was not called",
        ));
    };
    let Some(first) = lines.first() else {
        return Err(EvidenceError::within(name, "there is no harness in it"));
    };
    if let Some(why) = lines.iter().find_map(|line| line.reason.clone()) {
        return Ok(Report::absent(Engine::Kani, why));
    }
    let version = first.version.clone();
    if lines.iter().any(|line| line.version != version) {
        return Err(EvidenceError::within(
            name,
            "its lines are of several versions",
        ));
    }
    let sources = Sources::new(root, None);
    let modules = Modules::new(&sources, HARNESSES)?;
    let part = |line: Decided| {
        let seconds = line.seconds.ok_or_else(|| {
            EvidenceError::within(name, format!("{}: it has no time", line.harness))
        })?;
        Ok(Part {
            claims: line.claims,
            shows: Shown::AllInputs { domains: 1 },
            domain: Some(line.domain),
            cases: None,
            seconds,
            failure: (!line.passed).then_some(line.result),
            files: modules.of(&line.harness)?,
            name: line.harness,
        })
    };
    let parts: Vec<Part> = lines.into_iter().map(part).collect::<Result<_, _>>()?;
    Ok(Report::done(
        Engine::Kani,
        Done {
            tools: vec![tool("Kani", Some(version))],
            shared: shared(),
            parts,
            commit: None,
            imported: None,
        },
    ))
}

pub(super) fn stand_in(root: &Path, folder: &Path) -> Result<Report, EvidenceError> {
    let Some(lines) = lines::<Explored>(&folder.join("kani-standin.jsonl"))? else {
        return Ok(Report::absent(
            Engine::StandIn,
            "the tests of proofs/kani were not run",
        ));
    };
    let sources = Sources::new(root, None);
    let modules = Modules::new(&sources, HARNESSES)?;
    let part = |line: Explored| {
        Ok(Part {
            claims: line.claims,
            shows: match line.mode {
                Mode::Exhausted => Shown::Exhausted { domains: 1 },
                Mode::Sampled => Shown::Sampled { cases: line.cases },
            },
            domain: Some(line.domain),
            cases: Some(line.cases),
            seconds: line.seconds,
            failure: (!line.passed).then_some(line.result),
            files: modules.of(&line.harness)?,
            name: line.harness,
        })
    };
    let parts: Vec<Part> = lines.into_iter().map(part).collect::<Result<_, _>>()?;
    let mut shared = shared();
    for folder in STAND_IN {
        shared.extend(sources.under(folder)?);
    }
    Ok(Report::done(
        Engine::StandIn,
        Done {
            tools: built("cargo test -p passivity-kani", folder)?,
            shared,
            parts,
            commit: None,
            imported: None,
        },
    ))
}
