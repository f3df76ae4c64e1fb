//! The tests that claims name: what the test runner says decides, the records add the cases.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{Claims, Engine, EvidenceError, Shown, read};
use serde::Deserialize;

use super::{Done, Modules, Part, Report, built, built_by, lines};
use crate::sources::Sources;
use crate::trace;

/// A test program, and what it left.
struct Program {
    /// What the test runner said.
    said: &'static str,
    /// The file of the tests, or the folder of their modules, from the root of the workspace.
    tests: &'static str,
    /// What every test of it is built of.
    shared: &'static [&'static str],
}

/// The tests of the kernel, of what `check` says of scenes, of the certificates that the second
/// implementation checks, and of the identification.
const PROGRAMS: [Program; 4] = [
    Program {
        said: "properties.txt",
        tests: "crates/passivity-core/tests/properties",
        shared: &[
            "crates/passivity-core/tests/Cargo.toml",
            "crates/passivity-core/tests/properties/main.rs",
        ],
    },
    Program {
        said: "verdicts.txt",
        tests: "crates/passivity-scene/tests/decisions",
        shared: &[
            "crates/passivity-scene/Cargo.toml",
            "crates/passivity-scene/tests/decisions/main.rs",
        ],
    },
    Program {
        said: "certificates.txt",
        tests: "crates/passivity-scene/tests/files",
        shared: &[
            "crates/passivity-scene/Cargo.toml",
            "crates/passivity-scene/tests/files/main.rs",
            "tests/conformance/certificate.py",
            "tests/conformance/costs.py",
            "tests/conformance/drawn.py",
            "tests/conformance/frequencies.py",
            "tests/conformance/passivity_ref.py",
        ],
    },
    Program {
        said: "identify.txt",
        tests: "crates/passivity-identify/tests/identify.rs",
        shared: &[
            "crates/passivity-identify/Cargo.toml",
            "crates/passivity-identify/tests/trial/mod.rs",
        ],
    },
];

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
    for program in &PROGRAMS {
        if !folder.join(program.said).exists() {
            let why = format!("there is no `{}`: the tests were not run", program.said);
            return Ok(Report::absent(Engine::Tests, why));
        }
    }
    let recorded: Option<Vec<Sampled>> = lines(&folder.join("properties.jsonl"))?;
    let sampled: BTreeMap<String, Sampled> = recorded
        .into_iter()
        .flatten()
        .map(|line| (line.test.clone(), line))
        .collect();
    let mut parts = Vec::new();
    for program in &PROGRAMS {
        let path = folder.join(program.said);
        let before = parts.len();
        for line in read(&path)?.lines() {
            parts.extend(program.part(sources, claims, &sampled, line)?);
        }
        if parts.len() == before {
            let name = path.display().to_string();
            return Err(EvidenceError::within(&name, "no test ran"));
        }
    }
    Ok(Report::done(
        Engine::Tests,
        Done {
            tools: built("cargo test", folder)?,
            shared: built_by(&[]),
            parts,
            commit: None,
            imported: None,
        },
    ))
}

impl Program {
    /// The test that a line of the test runner speaks of: `test region::th_region_x ... ok`.
    fn part(
        &self,
        sources: &Sources,
        claims: &Claims,
        sampled: &BTreeMap<String, Sampled>,
        line: &str,
    ) -> Result<Option<Part>, EvidenceError> {
        let Some((name, outcome)) = line
            .strip_prefix("test ")
            .and_then(|rest| rest.split_once(" ... "))
        else {
            return Ok(None);
        };
        let function = name
            .rsplit_once("::")
            .map_or(name, |(_, function)| function);
        // A test that samples nothing is one case.
        let (cases, seconds) = sampled
            .get(name)
            .map_or((1, 0.0), |line| (line.cases, line.seconds));
        let outcome = outcome.trim();
        let mut files: BTreeSet<String> = self.shared.iter().map(|s| (*s).to_owned()).collect();
        if self.tests.ends_with(".rs") {
            files.insert(self.tests.to_owned());
        } else {
            files.extend(Modules::new(sources, self.tests)?.of(name)?);
        }
        Ok(Some(Part {
            claims: trace::named(claims, function),
            name: name.to_owned(),
            shows: Shown::Sampled { cases },
            domain: None,
            cases: Some(cases),
            seconds,
            failure: (outcome != "ok").then(|| outcome.to_owned()),
            files,
        }))
    }
}
