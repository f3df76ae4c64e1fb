//! Rocq's verdict on the whole development, and which theorems speak of which claim.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{Engine, EvidenceError, Shown};
use serde::Deserialize;

use super::{Done, Part, Report, document, tool};
use crate::sources::Sources;

/// The development, from the root of the workspace.
const FOLDER: &str = "proofs/rocq";

/// What decides whether a run of it succeeds, within that folder.
const CHECKED_BY: [&str; 7] = [
    "Makefile",
    "_CoqProject",
    "assumptions.expected",
    "axioms.sh",
    "statements.expected",
    "statements.sh",
    "theorems.toml",
];

/// The definitions that `BridgeActuator` says are the kernel's.
const ACTUATORS: [&str; 4] = ["ActuatorCost", "OnePole", "LagForm", "LateLag"];

/// What `proofs/prove` recorded of the run.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Run {
    version: Option<String>,
    passed: bool,
    seconds: f64,
    not_run: Option<String>,
}

/// `theorems.toml`.
#[derive(Deserialize)]
struct List {
    claim: Vec<TheoremsOf>,
}

#[derive(Deserialize)]
struct TheoremsOf {
    id: String,
    theorems: Vec<String>,
}

pub(super) fn report(sources: &Sources, folder: &Path) -> Result<Report, EvidenceError> {
    let run: Option<Run> = document(&folder.join("rocq.json"))?;
    let Some(run) = run else {
        return Ok(Report::absent(
            Engine::Rocq,
            "`make prove-rocq` was not called",
        ));
    };
    if let Some(why) = run.not_run {
        return Ok(Report::absent(Engine::Rocq, why));
    }
    let development = Development::new(sources)?;
    let list = format!("{FOLDER}/theorems.toml");
    let theorems: List = toml::from_str(&sources.text(&list)?)
        .map_err(|error| EvidenceError::within(&list, error))?;
    let expected = sources.text(&format!("{FOLDER}/assumptions.expected"))?;
    // `Passivity.Module.theorem: the axioms that it rests on`, a theorem a line.
    let compiled: BTreeSet<&str> = expected
        .lines()
        .filter_map(|line| line.strip_prefix("Passivity.")?.split_once(':'))
        .map(|(name, _)| name)
        .collect();
    // A theorem that speaks of several claims is one part.
    let mut claims: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for TheoremsOf { id, theorems } in theorems.claim {
        for theorem in theorems {
            claims.entry(theorem).or_default().push(id.clone());
        }
    }
    let count =
        f64::from(u32::try_from(claims.len()).map_err(|e| EvidenceError::within(&list, e))?);
    let part = |(name, claims): (String, Vec<String>)| Part {
        files: development.of_theorem(&name),
        claims,
        shows: Shown::AllReals,
        domain: None,
        cases: None,
        // The development is compiled as one.
        seconds: run.seconds / count,
        failure: if !run.passed {
            Some("the development does not compile, or rests on other axioms".to_owned())
        } else if compiled.contains(name.as_str()) {
            None
        } else {
            Some("it is not in assumptions.expected".to_owned())
        },
        name,
    };
    Ok(Report::done(
        Engine::Rocq,
        Done {
            tools: vec![tool("Rocq", run.version)],
            parts: claims.into_iter().map(part).collect(),
            shared: development.shared(sources)?,
            commit: None,
            imported: None,
        },
    ))
}

/// The files of the development, and which of them each requires.
struct Development(BTreeMap<String, BTreeSet<String>>);

impl Development {
    fn new(sources: &Sources) -> Result<Self, EvidenceError> {
        let mut files = BTreeMap::new();
        for path in sources.under(FOLDER)? {
            let within = path.strip_prefix(FOLDER).and_then(|p| p.strip_prefix('/'));
            let Some(name) = within.and_then(|name| name.strip_suffix(".v")) else {
                continue;
            };
            // `From Passivity Require Import Definitions Quantizer.`, on a line or several.
            let text = sources.text(&path)?;
            let sentences = text.split("From Passivity Require").skip(1);
            let named = sentences.filter_map(|rest| rest.split_once(".\n"));
            let words = named.flat_map(|(names, _)| names.split_whitespace());
            files.insert(name.to_owned(), words.map(str::to_owned).collect());
        }
        Ok(Self(files))
    }

    /// What a theorem rests on beside what all do: its file and all that this requires, and where actuators
    /// are among that, the lemmas that these are the kernel's.
    fn of_theorem(&self, name: &str) -> BTreeSet<String> {
        let mut files = self.under(name.split('.').next());
        let is_actuator = |module| files.contains(&format!("{FOLDER}/{module}.v"));
        if ACTUATORS.into_iter().any(is_actuator) {
            files.extend(self.under(["BridgeActuator"]));
        }
        files
    }

    /// The files of modules and of all that they require, from the root of the workspace.
    fn under<'a>(&'a self, modules: impl IntoIterator<Item = &'a str>) -> BTreeSet<String> {
        let mut waiting: Vec<&str> = modules.into_iter().collect();
        let mut found = BTreeSet::new();
        while let Some(module) = waiting.pop() {
            if let Some(required) = self.0.get(module)
                && found.insert(format!("{FOLDER}/{module}.v"))
            {
                waiting.extend(required.iter().map(String::as_str));
            }
        }
        found
    }

    /// What every theorem rests on: the lemmas that the definitions are the kernel's, what prints
    /// them, what compares axioms and statements with the committed lists, and what compares the
    /// extracted checker with the kernel.
    fn shared(&self, sources: &Sources) -> Result<BTreeSet<String>, EvidenceError> {
        let printed = [
            "BridgePaper",
            "BridgeEffects",
            "BridgeUnits",
            "BridgeController",
            "Decisions",
        ];
        let mut files = self.under(printed);
        for folder in ["bridge/src", "bridge/examples", "checker"] {
            files.extend(sources.under(&format!("{FOLDER}/{folder}"))?);
        }
        files.extend(CHECKED_BY.map(|name| format!("{FOLDER}/{name}")));
        files.extend(
            ["lib.rs", "paths.rs", "rocq.rs", "term.rs"]
                .map(|name| format!("proofs/terms/src/{name}")),
        );
        Ok(files)
    }
}

#[cfg(test)]
mod tests {
    use super::super::Ran;
    use super::*;

    /// What becomes of a record of `proofs/prove`.
    fn says(name: &str, record: &str) -> Report {
        let folder = std::env::temp_dir().join(format!("passivity-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        std::fs::write(folder.join("rocq.json"), record).unwrap();
        let report = report(&Sources::new(&crate::root(), None), &folder);
        std::fs::remove_dir_all(&folder).unwrap();
        report.unwrap()
    }

    #[test]
    fn theorems_that_compiled_show_their_claims() {
        let record = r#"{"version": "8", "passed": true, "seconds": 60, "not_run": null}"#;
        let report = says("compiled", record);
        assert!(!report.parts().is_empty());
        for part in report.parts() {
            assert_eq!(part.failure, None, "{}", part.name);
        }
    }

    #[test]
    fn a_theorem_rests_on_what_its_file_requires() {
        let sources = Sources::new(&crate::root(), None);
        let development = Development::new(&sources).unwrap();
        let under = development.of_theorem("Generation.TH_QUANT");
        let expected = ["Definitions", "Generation", "Quantizer"];
        let expected: BTreeSet<String> = expected.map(|name| format!("{FOLDER}/{name}.v")).into();
        assert_eq!(under, expected);
        // The lemmas about actuators are under the theorems about these, and under no others.
        let bridge = format!("{FOLDER}/BridgeActuator.v");
        assert!(development.of_theorem("LagForm.any").contains(&bridge));
        assert!(!development.shared(&sources).unwrap().contains(&bridge));
        let combined = development.under(["Counterparts"]);
        assert!(combined.contains("proofs/rocq/Calculus.v"), "{combined:?}");
        assert!(!combined.contains("proofs/rocq/Active.v"), "{combined:?}");
        for file in development.shared(&sources).unwrap() {
            assert!(crate::root().join(&file).exists(), "{file}");
        }
    }

    #[test]
    fn theorems_that_did_not_compile_show_nothing() {
        let record = r#"{"version": "8", "passed": false, "seconds": 60, "not_run": null}"#;
        let report = says("not-compiled", record);
        assert!(!report.parts().is_empty());
        assert!(report.parts().iter().all(|part| part.failure.is_some()));
    }

    #[test]
    fn theorems_that_were_left_out_are_not_run() {
        let record = r#"{"version": null, "passed": false, "seconds": 0, "not_run": "left out"}"#;
        let report = says("left-out", record);
        assert!(matches!(report.ran, Ran::No(why) if why == "left out"));
    }
}
