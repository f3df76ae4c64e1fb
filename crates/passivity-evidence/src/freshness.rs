//! Whether records still speak of what is there now.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

use crate::claims::{Claim, Claims};
use crate::engine::Engine;
use crate::error::EvidenceError;
use crate::record::{Evidence, Failure, Outcome, Record};
use crate::sha256::Sha256;

/// A source file as it is now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Now {
    /// It has this sum.
    Is(Sha256),
    /// It is no longer there.
    Gone,
    /// It is not known here: a program that was built from some sources does not carry all files
    /// that the engines read.
    NotAtHand,
}

impl Now {
    /// How a file differs from what was recorded of it.
    pub(crate) fn change_of(self, path: &str, recorded: &Sha256) -> Option<Change> {
        match self {
            Self::Is(sum) if sum == *recorded => None,
            Self::Is(_) | Self::Gone => Some(Change::Source(path.to_owned())),
            Self::NotAtHand => None,
        }
    }
}

/// A file of the tree at `root`, as it is now.
///
/// # Errors
///
/// A file that is there and cannot be read.
pub fn in_tree(root: &Path, path: &str) -> Result<Now, EvidenceError> {
    let file = root.join(path);
    match std::fs::read(&file) {
        Ok(bytes) => Ok(Now::Is(Sha256::of(&bytes))),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Now::Gone),
        Err(error) => Err(EvidenceError::io(&file, &error)),
    }
}

/// What has changed since evidence was recorded.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Change {
    /// The claim, its scope, an assumption or a caveat reads differently.
    Statement,
    /// A file that was read is another one now, or is gone.
    Source(String),
    /// A file that the claim's code is in was not read.
    NotCovered(String),
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Statement => f.write_str("claim text"),
            Self::Source(path) => f.write_str(path),
            Self::NotCovered(path) => write!(f, "{path} (not covered)"),
        }
    }
}

/// How a record stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Freshness {
    /// The claim's text and every source are as they were recorded.
    Fresh,
    /// These have changed.
    Stale(Vec<Change>),
    /// It was not run here, for this reason.
    NotRun(String),
    /// It ran, and did not show the claim.
    Failed(Vec<Failure>),
}

impl fmt::Display for Freshness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joined = |items: Vec<String>, between| items.join(between);
        match self {
            Self::Fresh => f.write_str("fresh"),
            Self::Stale(changes) => {
                let changes = changes.iter().map(ToString::to_string).collect();
                write!(f, "stale: changed since: {}", joined(changes, ", "))
            }
            Self::NotRun(why) => write!(f, "not run here: {why}"),
            Self::Failed(failures) => {
                let failures = failures.iter().map(ToString::to_string).collect();
                write!(f, "failed: {}", joined(failures, "; "))
            }
        }
    }
}

/// What one engine has said, or should have said, of one claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessed {
    /// The claim's id.
    pub claim: String,
    /// The engine.
    pub engine: Engine,
    /// Whether the claim asks for evidence of this engine.
    pub required: bool,
    /// The record; `None` when there is none.
    pub record: Option<Record>,
    /// How it stands.
    pub freshness: Freshness,
}

impl Assessed {
    /// The claim's id and the engine, which name the record: `TH-LIN/smt`.
    #[must_use]
    pub fn id(&self) -> String {
        format!("{}/{}", self.claim, self.engine)
    }
}

/// Compares the evidence with the claims and with the sources as `now` gives them: an entry for each
/// claim and each engine that was asked or has spoken, in the order of claims and engines.
///
/// # Errors
///
/// A source that cannot be looked up, and a claim that refers to what is not there.
pub fn assess(
    claims: &Claims,
    evidence: &Evidence,
    now: impl Fn(&str) -> Result<Now, EvidenceError>,
) -> Result<Vec<Assessed>, EvidenceError> {
    // Records share most of their sources.
    let seen: RefCell<BTreeMap<String, Now>> = RefCell::default();
    let now = |path: &str| {
        if let Some(known) = seen.borrow().get(path) {
            return Ok(*known);
        }
        let found = now(path)?;
        seen.borrow_mut().insert(path.to_owned(), found);
        Ok(found)
    };
    let mut all = Vec::new();
    for claim in &claims.claims {
        for engine in Engine::ALL {
            let record = evidence.find(&claim.id, engine);
            let required = claim.evidence.contains(&engine);
            let freshness = match record {
                None if !required => continue,
                None => Freshness::NotRun("no record".to_owned()),
                Some(record) => freshness(claims, claim, evidence, record, now)?,
            };
            all.push(Assessed {
                claim: claim.id.clone(),
                engine,
                required,
                record: record.cloned(),
                freshness,
            });
        }
    }
    Ok(all)
}

fn freshness(
    claims: &Claims,
    claim: &Claim,
    evidence: &Evidence,
    record: &Record,
    now: impl Fn(&str) -> Result<Now, EvidenceError>,
) -> Result<Freshness, EvidenceError> {
    match &record.outcome {
        Outcome::NotRun(why) => return Ok(Freshness::NotRun(why.clone())),
        Outcome::Failed(failures) => return Ok(Freshness::Failed(failures.clone())),
        Outcome::Shown(_) => {}
    }
    let mut changes = Vec::new();
    if claims.statement(claim, record.engine)? != record.statement {
        changes.push(Change::Statement);
    }
    for path in &record.sources {
        let recorded = evidence
            .run(record.engine)
            .and_then(|run| run.files.get(path))
            .ok_or_else(|| {
                EvidenceError::new(format!("{}: no sum of `{path}` is recorded", record.id()))
            })?;
        changes.extend(now(path)?.change_of(path, recorded));
    }
    let uncovered = claim
        .files()
        .into_iter()
        .filter(|file| !record.sources.contains(file));
    changes.extend(uncovered.map(Change::NotCovered));
    changes.sort();
    Ok(if changes.is_empty() {
        Freshness::Fresh
    } else {
        Freshness::Stale(changes)
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::record::{FORMAT, Run, RunOutcome, Shown};

    const CLAIMS: &str = r#"
        assumption = []
        caveat = []
        [[claim]]
        id = "TH-X"
        sentence = "One."
        formula = ""
        equation = "(1)"
        code = ["generation::x", "spring::y"]
        evidence = ["smt", "kani"]
        assumptions = []
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

    /// Evidence of z3 and cvc5 for both claims, with a query of its own for each.
    fn evidence() -> Evidence {
        let claims = Claims::parse("c", CLAIMS).unwrap();
        let mut files = BTreeMap::new();
        let records = claims.claims.iter().map(|claim| {
            let mut sources: Vec<String> = claim.files().into_iter().collect();
            sources.push(format!("queries/{}", claim.id));
            files.extend(
                sources
                    .iter()
                    .map(|path| (path.clone(), Sha256::of(b"old"))),
            );
            Record {
                claim: claim.id.clone(),
                engine: Engine::Smt,
                outcome: Outcome::Shown(vec![Shown::AllReals]),
                scope: None,
                domains: Vec::new(),
                cases: None,
                seconds: 1.0,
                parts: vec!["q".to_owned()],
                statement: claims.statement(claim, Engine::Smt).unwrap(),
                sources,
            }
        });
        Evidence {
            format: FORMAT,
            records: records.collect(),
            runs: vec![Run {
                engine: Engine::Smt,
                tools: Vec::new(),
                commit: None,
                outcome: RunOutcome::Ran {
                    parts: 2,
                    seconds: 2.0,
                },
                files,
            }],
            mutation: None,
        }
    }

    /// How each record stands when the files that end in `changed` are as `now` says.
    fn standing(
        claims: &str,
        evidence: &Evidence,
        changed: &str,
        now: Now,
    ) -> Vec<(String, String)> {
        let claims = Claims::parse("c", claims).unwrap();
        let look = |path: &str| {
            let changed = path.ends_with(changed);
            Ok(if changed {
                now
            } else {
                Now::Is(Sha256::of(b"old"))
            })
        };
        let all = assess(&claims, evidence, look).unwrap();
        all.iter()
            .map(|a| (a.id(), a.freshness.to_string()))
            .collect()
    }

    const NEW: fn() -> Now = || Now::Is(Sha256::of(b"new"));

    fn of(standing: &[(String, String)], id: &str) -> String {
        let found = standing.iter().find(|(found, _)| found == id);
        found.map(|(_, words)| words.clone()).unwrap()
    }

    #[test]
    fn a_changed_file_makes_its_evidence_stale_and_no_other() {
        let files = ["crates/passivity-core/src/spring.rs", "queries/TH-X"];
        for (file, now) in files.into_iter().flat_map(|f| [(f, NEW()), (f, Now::Gone)]) {
            let all = standing(CLAIMS, &evidence(), file, now);
            assert_eq!(
                of(&all, "TH-X/smt"),
                format!("stale: changed since: {file}")
            );
            assert_eq!(of(&all, "TH-Y/smt"), "fresh");
        }
        let all = standing(CLAIMS, &evidence(), "nothing", NEW());
        assert_eq!(of(&all, "TH-X/smt"), "fresh");
        let all = standing(CLAIMS, &evidence(), "queries/TH-X", Now::NotAtHand);
        assert_eq!(of(&all, "TH-X/smt"), "fresh");
    }

    #[test]
    fn a_changed_claim_or_another_file_of_code_makes_its_evidence_stale() {
        let all = standing(
            &CLAIMS.replace("Two.", "Three."),
            &evidence(),
            "nothing",
            NEW(),
        );
        assert_eq!(of(&all, "TH-Y/smt"), "stale: changed since: claim text");
        assert_eq!(of(&all, "TH-X/smt"), "fresh");
        let more = CLAIMS.replace("\"region::z\"", "\"region::z\", \"law::w\"");
        let all = standing(&more, &evidence(), "nothing", NEW());
        let file = "crates/passivity-core/src/law.rs (not covered)";
        assert_eq!(
            of(&all, "TH-Y/smt"),
            format!("stale: changed since: {file}")
        );
    }

    #[test]
    fn evidence_that_is_missing_not_run_or_failed_says_so() {
        let mut evidence = evidence();
        let failure = Failure {
            part: "region".into(),
            why: "wrong".into(),
        };
        evidence.records[0].outcome = Outcome::NotRun("not here".into());
        evidence.records[1].outcome = Outcome::Failed(vec![failure]);
        let all = standing(CLAIMS, &evidence, "nothing", NEW());
        assert_eq!(of(&all, "TH-X/smt"), "not run here: not here");
        assert_eq!(of(&all, "TH-X/kani"), "not run here: no record");
        assert_eq!(of(&all, "TH-Y/smt"), "failed: region: wrong");
        assert_eq!(all.len(), 3);
    }
}
