//! z3 and cvc5: a statement is shown when both gave the expected answer to all its scripts.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{Engine, EvidenceError, Shown};
use serde::Deserialize;

use super::{Done, Part, Report, built_by, lines, tool};
use crate::sources::Sources;

/// The scripts, from the root of the workspace.
const QUERIES: &str = "proofs/smt/queries";

/// What prints every script, asks the solvers and reads their answers.
const SHARED: [&str; 12] = [
    "crates/passivity-core/src/rational.rs",
    "proofs/smt/Cargo.toml",
    "proofs/smt/install",
    "proofs/smt/requirements.txt",
    "proofs/smt/run_solver.py",
    "proofs/smt/src/formula.rs",
    "proofs/smt/src/query.rs",
    "proofs/smt/src/replay.rs",
    "proofs/smt/src/run.rs",
    "proofs/smt/src/solvers.rs",
    "proofs/terms/Cargo.toml",
    "proofs/terms/src/smt.rs",
];

/// What one solver said of one script.
#[derive(Deserialize)]
struct Line {
    engine: String,
    version: String,
    claim: String,
    says: String,
    script: String,
    /// The file that it is written in.
    source: String,
    passed: bool,
    fault: Option<String>,
    seconds: f64,
}

pub(super) fn report(sources: &Sources, folder: &Path) -> Result<Report, EvidenceError> {
    let Some(lines) = lines::<Line>(&folder.join("smt.jsonl"))? else {
        return Ok(Report::absent(
            Engine::Smt,
            "z3 and cvc5 were not installed",
        ));
    };
    let scripts = sources.under(QUERIES)?;
    let mut versions = BTreeMap::new();
    let mut queries: BTreeMap<String, Vec<Line>> = BTreeMap::new();
    for line in lines {
        versions.insert(line.engine.clone(), line.version.clone());
        // A statement has several scripts: `NAME`, `NAME.premises`, `NAME.mutant`.
        let (name, _) = line.script.split_once('.').unwrap_or((&line.script, ""));
        queries.entry(name.to_owned()).or_default().push(line);
    }
    let parts = queries
        .into_iter()
        .map(|(name, lines)| part(name, &lines, &scripts));
    Ok(Report::done(
        Engine::Smt,
        Done {
            parts: parts.collect::<Result<_, _>>()?,
            tools: versions
                .into_iter()
                .map(|(name, version)| tool(&name, Some(version)))
                .collect(),
            shared: built_by(&SHARED),
            commit: None,
            imported: None,
        },
    ))
}

fn part(name: String, lines: &[Line], scripts: &BTreeSet<String>) -> Result<Part, EvidenceError> {
    let claims: BTreeSet<&String> = lines.iter().map(|line| &line.claim).collect();
    let says: BTreeSet<&String> = lines.iter().map(|line| &line.says).collect();
    let (Some(says), 1, 1) = (lines.first(), claims.len(), says.len()) else {
        return Err(EvidenceError::within(
            "smt.jsonl",
            format!("the scripts of `{name}` do not speak of one and the same"),
        ));
    };
    let fault = |line: &&Line| (!line.passed || line.fault.is_some()).then_some(());
    let failed = lines.iter().find(|line| fault(line).is_some());
    let times = |solver: &str| lines.iter().filter(|line| line.engine == solver).count();
    let failure = match failed {
        Some(line) => Some(format!(
            "{} on {}: {}",
            line.engine,
            line.script,
            line.fault
                .as_deref()
                .unwrap_or("another answer than expected")
        )),
        None if times("z3") != times("cvc5") || times("z3") < 2 => {
            Some("the two solvers were not asked the same".to_owned())
        }
        None => None,
    };
    let own = format!("{QUERIES}/{name}.");
    let mut files: BTreeSet<String> = lines.iter().map(|line| line.source.clone()).collect();
    files.extend(
        scripts
            .iter()
            .filter(|path| path.starts_with(&own))
            .cloned(),
    );
    Ok(Part {
        claims: claims.into_iter().cloned().collect(),
        shows: Shown::AllReals,
        domain: Some(says.says.clone()),
        cases: None,
        seconds: lines.iter().map(|line| line.seconds).sum(),
        failure,
        files,
        name,
    })
}
