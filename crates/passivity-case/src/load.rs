//! Reading claims and recorded evidence from a source tree, or from what the build carries, and
//! finding out how fresh the evidence is.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use passivity_evidence as recorded;
use passivity_evidence::{Engine, sha256};

use crate::error::CaseError;
use crate::manifest::read_text;
use crate::records::{Assumption, Claim, Evidence, Freshness, Origin, Records};
use crate::tree;

mod embedded {
    include!(concat!(env!("OUT_DIR"), "/embedded.rs"));
}

/// Claims and evidence are no larger than this.
const MOST_BYTES: u64 = 64 << 20;

/// Where evidence is recorded: by the last run here, or by the last one that was committed.
const EVIDENCE: [&str; 2] = ["target/evidence.json", "proofs/evidence.json"];

/// The records of the tree at `root`; without one, those that the build carries.
///
/// `evidence` is a file to read in the place of the recorded evidence.
///
/// # Errors
///
/// Claims or evidence that are not there, cannot be read or are not what they should be.
pub fn records(root: Option<&Path>, evidence: Option<&Path>) -> Result<Records, CaseError> {
    let (name, claims) = match root {
        Some(root) => {
            let path = root.join(tree::CLAIMS);
            (path.display().to_string(), read_text(&path, MOST_BYTES)?)
        }
        None => (
            format!("{} of this build", tree::CLAIMS),
            embedded::CLAIMS.to_owned(),
        ),
    };
    let (evidence_name, evidence) = match (evidence, root) {
        (Some(path), _) => (path.display().to_string(), read_text(path, MOST_BYTES)?),
        (None, Some(root)) => {
            let path = evidence_in(root)?;
            (path.display().to_string(), read_text(&path, MOST_BYTES)?)
        }
        (None, None) => (
            "evidence of this build".to_owned(),
            embedded::EVIDENCE.to_owned(),
        ),
    };
    let mut records = combine(
        (&name, &claims),
        (&evidence_name, &evidence),
        |path| match root {
            Some(root) => std::fs::read(root.join(path))
                .ok()
                .map(|bytes| sha256(&bytes)),
            None => {
                let source = embedded::SOURCES.iter().find(|(name, _)| *name == path);
                source.map(|(_, text)| sha256(text))
            }
        },
    )?;
    if let Some(root) = root {
        records.origin = Origin::Tree;
        records.commit = tree::commit(root);
    }
    Ok(records)
}

fn evidence_in(root: &Path) -> Result<PathBuf, CaseError> {
    let paths = EVIDENCE.map(|file| root.join(file));
    paths
        .iter()
        .find(|path| path.is_file())
        .cloned()
        .ok_or_else(|| {
            CaseError::new(format!(
                "`{}`: no evidence is recorded: `make prove` records it",
                paths[1].display()
            ))
        })
}

/// Claims with their evidence; `hash` gives the hash of a source as it is now.
fn combine(
    (claims_name, claims): (&str, &str),
    (evidence_name, evidence): (&str, &str),
    hash: impl Fn(&str) -> Option<String>,
) -> Result<Records, CaseError> {
    let read: recorded::Claims = toml::from_str(claims).map_err(|error| {
        CaseError::new(format!("`{claims_name}`: {}", error.to_string().trim_end()))
    })?;
    // A build that was made without recorded evidence carries an empty text.
    let found: recorded::Evidence =
        if evidence.is_empty() && evidence_name.ends_with("of this build") {
            recorded::Evidence::default()
        } else {
            serde_json::from_str(evidence)
                .map_err(|error| CaseError::new(format!("`{evidence_name}`: {error}")))?
        };
    let claims_list = read.claims.iter().map(|claim| {
        let now: BTreeMap<String, String> = claim
            .files()
            .into_iter()
            .filter_map(|file| Some((file.clone(), hash(&file)?)))
            .collect();
        Claim {
            id: claim.id.clone(),
            sentence: claim.sentence.clone(),
            formula: claim.formula.clone(),
            equation: claim.equation.clone(),
            refutes: claim.refutes,
            code: claim.code.clone(),
            assumptions: claim.assumptions.clone(),
            caveats: claim.caveats.clone(),
            evidence: Engine::ALL
                .into_iter()
                .filter_map(|engine| evidence_of(claim, engine, &found, &now))
                .collect(),
        }
    });
    let known = |id: &str| read.find(id).is_some();
    let mut unknown: Vec<String> = found
        .records
        .iter()
        .map(|r| r.claim.clone())
        .filter(|id| !known(id))
        .collect();
    unknown.dedup();
    let assumption = |a: &recorded::Assumption| Assumption {
        id: a.id.clone(),
        sentence: a.sentence.clone(),
        check: a.check.clone(),
    };
    Ok(Records {
        claims: claims_list.collect(),
        assumptions: read.assumptions.iter().map(assumption).collect(),
        caveats: read
            .caveats
            .iter()
            .map(|c| (c.id.clone(), c.text.clone()))
            .collect(),
        unknown,
        origin: Origin::Build,
        claims_sha256: sha256(claims.as_bytes()),
        evidence_sha256: sha256(evidence.as_bytes()),
        commit: None,
        mutation: found.mutation.as_ref().map(mutation),
    })
}

/// What an engine says of a claim; `None` when it says nothing and was not asked to.
fn evidence_of(
    claim: &recorded::Claim,
    engine: Engine,
    found: &recorded::Evidence,
    now: &BTreeMap<String, String>,
) -> Option<Evidence> {
    let id = format!("{}/{engine}", claim.id);
    let Some(record) = found.find(&claim.id, engine) else {
        return claim.evidence.contains(&engine).then(|| Evidence {
            id,
            engine,
            result: "not run here".to_owned(),
            tool: String::new(),
            sources: BTreeMap::new(),
            freshness: Freshness::NotRun("no record".to_owned()),
        });
    };
    let changed = record.stale(&claim.sha256(), now);
    let freshness = if let Some(why) = &record.not_run {
        Freshness::NotRun(why.clone())
    } else if !record.failures.is_empty() || record.result.is_none() {
        Freshness::Failed(record.failures.join("; "))
    } else if changed.is_empty() {
        Freshness::Fresh
    } else {
        Freshness::Stale(changed)
    };
    let mut result = record
        .result
        .clone()
        .unwrap_or_else(|| "not shown".to_owned());
    if let (Some(part), None) = (&record.scope, &record.not_run) {
        result = format!("{result} for {part}");
    }
    if !record.domain.is_empty() && record.not_run.is_none() {
        let domain = record.domain.join("; ");
        // What the solvers are asked of a false statement is that statement, and they answer with a model.
        let refuted = match engine {
            Engine::Smt if claim.refutes => "refuted: ",
            _ => "",
        };
        result = format!("{result} ({refuted}{domain})");
    }
    Some(Evidence {
        id,
        engine,
        result,
        tool: record.tool.clone(),
        sources: record.sources.clone(),
        freshness,
    })
}

fn mutation(run: &recorded::Mutation) -> String {
    format!(
        "Changing the kernel here and there ({}): of {} changes that compile, tests notice {}; {} are \
         explained in proofs/mutants.",
        run.tool,
        run.mutants,
        run.caught,
        run.survivors.len()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLAIMS: &str = r#"
        caveat = []
        [[assumption]]
        id = "A-X"
        sentence = "It is so."
        check = "Look."
        [[claim]]
        id = "TH-X"
        sentence = "One."
        formula = ""
        equation = "(1)"
        code = ["generation::x", "spring::y"]
        evidence = ["smt", "kani"]
        assumptions = ["A-X", "A-GONE"]
        caveats = []
        [[claim]]
        id = "TH-Y"
        sentence = "Two."
        formula = ""
        equation = "(2)"
        code = ["region::z"]
        evidence = ["smt"]
        assumptions = []
        caveats = []
    "#;

    /// Evidence of z3 and cvc5 for both claims, all sources with the hash `old`.
    fn evidence() -> recorded::Evidence {
        let claims: recorded::Claims = toml::from_str(CLAIMS).expect("claims");
        let record = |claim: &recorded::Claim| recorded::Record {
            claim: claim.id.clone(),
            engine: Engine::Smt,
            tool: "z3".to_owned(),
            result: Some("proved for all reals".to_owned()),
            scope: None,
            domain: Vec::new(),
            cases: None,
            seconds: 1.0,
            parts: Vec::new(),
            failures: Vec::new(),
            not_run: None,
            claim_sha256: claim.sha256(),
            sources: claim
                .files()
                .into_iter()
                .map(|file| (file, "old".to_owned()))
                .collect(),
        };
        recorded::Evidence {
            records: claims.claims.iter().map(record).collect(),
            ..recorded::Evidence::default()
        }
    }

    fn combined(claims: &str, evidence: &recorded::Evidence, changed: &str) -> Records {
        let text = evidence.text().expect("text");
        let hash = |path: &str| {
            (path != "gone").then(|| {
                if path.ends_with(changed) {
                    "new"
                } else {
                    "old"
                }
                .to_owned()
            })
        };
        combine(("c", claims), ("e", &text), hash).expect("records")
    }

    #[test]
    fn a_changed_source_makes_its_evidence_stale_and_no_other() {
        let records = combined(CLAIMS, &evidence(), "spring.rs");
        let stale = vec!["crates/passivity-core/src/spring.rs".to_owned()];
        assert_eq!(
            records.claims[0].evidence[0].freshness,
            Freshness::Stale(stale)
        );
        assert_eq!(records.claims[1].evidence[0].freshness, Freshness::Fresh);
        let unchanged = combined(CLAIMS, &evidence(), "nothing.rs");
        assert_eq!(unchanged.claims[0].evidence[0].freshness, Freshness::Fresh);
    }

    #[test]
    fn a_changed_claim_makes_its_evidence_stale() {
        let records = combined(&CLAIMS.replace("Two.", "Three."), &evidence(), "nothing.rs");
        let stale = vec!["claim text".to_owned()];
        assert_eq!(
            records.claims[1].evidence[0].freshness,
            Freshness::Stale(stale)
        );
        assert_eq!(records.claims[0].evidence[0].freshness, Freshness::Fresh);
    }

    #[test]
    fn evidence_that_is_missing_or_failed_says_so() {
        let mut evidence = evidence();
        evidence.records[1]
            .failures
            .push("region: wrong".to_owned());
        evidence.records[1].result = None;
        let records = combined(CLAIMS, &evidence, "nothing.rs");
        // Kani was expected, and there is no record of it.
        let kani = &records.claims[0].evidence[1];
        assert_eq!(
            (kani.id.as_str(), kani.words()),
            ("TH-X/kani", "not run here: no record".to_owned())
        );
        assert_eq!(
            records.claims[1].evidence[0].words(),
            "failed: region: wrong"
        );
        let linkage = records.linkage();
        assert_eq!(linkage.linked, ["TH-X", "TH-Y"]);
        assert!(linkage.unknown.contains("A-GONE"));
    }

    #[test]
    fn a_record_of_no_claim_is_unknown() {
        let mut evidence = evidence();
        evidence.records[0].claim = "TH-Z".to_owned();
        let records = combined(CLAIMS, &evidence, "nothing.rs");
        assert_eq!(records.unknown, ["TH-Z"]);
    }

    #[test]
    fn what_cannot_be_read_is_an_error_with_its_place() {
        let hash = |_: &str| None;
        let error = combine(("claims.toml", "[[claim]]\nid = 3"), ("e", "{}"), hash)
            .expect_err("no claims");
        assert!(error.to_string().contains("claims.toml"), "{error}");
        let error =
            combine(("c", CLAIMS), ("evidence.json", "{\"runs\": [}"), hash).expect_err("no JSON");
        assert!(error.to_string().contains("evidence.json"), "{error}");
        assert!(
            combine(("c", CLAIMS), ("e", ""), hash).is_err(),
            "an empty file is no evidence"
        );
    }

    #[test]
    fn the_build_carries_the_claims_and_the_hash_of_every_source() {
        let records = records(None, None).expect("the records of this build");
        assert!(records.claims.len() >= 20 && records.assumptions.len() >= 5);
        let claims: recorded::Claims = toml::from_str(embedded::CLAIMS).expect("claims");
        for file in claims.claims.iter().flat_map(recorded::Claim::files) {
            assert!(
                embedded::SOURCES.iter().any(|(name, _)| *name == file),
                "{file}"
            );
        }
    }
}
