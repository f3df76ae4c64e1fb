//! Rocq's verdict on the whole development, and which theorems speak of which claim.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{Engine, EvidenceError, Shown};
use serde::Deserialize;

use super::{Done, Part, Report, document, tool};
use crate::sources::Sources;

/// The development, from the root of the workspace.
const FOLDER: &str = "proofs/rocq";

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
        files: BTreeSet::new(),
        name,
    };
    // The theories, what they are compared with, and what compares the extracted checker.
    let of_the_development = |path: &String| {
        let path = Path::new(path);
        path.extension()
            .is_some_and(|extension| extension == "v" || extension == "expected")
            || path.starts_with(format!("{FOLDER}/checker"))
            || path.ends_with("bridge/examples/verdicts.rs")
    };
    let files = sources.under(FOLDER)?;
    Ok(Report::done(
        Engine::Rocq,
        Done {
            tools: vec![tool("Rocq", run.version)],
            parts: claims.into_iter().map(part).collect(),
            shared: files.into_iter().filter(of_the_development).collect(),
            commit: None,
            imported: None,
        },
    ))
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
