//! The property tests: what the test runner says decides, the records add the cases.

use std::collections::BTreeMap;
use std::path::Path;

use passivity_evidence::{Claims, Engine, EvidenceError, Shown, read};
use serde::Deserialize;

use super::{Done, Modules, Part, Report, lines, tool};
use crate::sources::Sources;
use crate::trace;

/// The tests, from the root of the workspace.
const TESTS: &str = "crates/passivity-core/tests/properties";

/// What a test that samples recorded.
#[derive(Deserialize)]
struct Sampled {
    test: String,
    cases: u64,
    seconds: f64,
}

pub(super) fn report(
    sources: &Sources,
    folder: &Path,
    claims: &Claims,
) -> Result<Report, EvidenceError> {
    let path = folder.join("properties.txt");
    if !path.exists() {
        return Ok(Report::absent(
            Engine::Tests,
            "the tests of passivity-core were not run",
        ));
    }
    let recorded: Option<Vec<Sampled>> = lines(&folder.join("properties.jsonl"))?;
    let sampled: BTreeMap<String, Sampled> = recorded
        .into_iter()
        .flatten()
        .map(|line| (line.test.clone(), line))
        .collect();
    let modules = Modules::new(sources, TESTS)?;
    let mut parts = Vec::new();
    for line in read(&path)?.lines() {
        // `test region::th_region_x ... ok`, as the test runner prints it.
        let Some((name, outcome)) = line
            .strip_prefix("test ")
            .and_then(|rest| rest.split_once(" ... "))
        else {
            continue;
        };
        let function = name
            .rsplit_once("::")
            .map_or(name, |(_, function)| function);
        // A test that samples nothing is one case.
        let (cases, seconds) = sampled
            .get(name)
            .map_or((1, 0.0), |line| (line.cases, line.seconds));
        let outcome = outcome.trim();
        parts.push(Part {
            claims: trace::named(claims, function),
            name: name.to_owned(),
            shows: Shown::Sampled { cases },
            domain: None,
            cases: Some(cases),
            seconds,
            failure: (outcome != "ok").then(|| outcome.to_owned()),
            files: modules.of(name)?,
        });
    }
    if parts.is_empty() {
        let name = path.display().to_string();
        return Err(EvidenceError::within(&name, "no test ran"));
    }
    Ok(Report::done(
        Engine::Tests,
        Done {
            tools: vec![tool("cargo test -p passivity-core", None)],
            shared: modules.shared(&parts),
            parts,
            commit: None,
        },
    ))
}
