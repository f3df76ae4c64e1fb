//! What the model checker said elsewhere, of the sources of a commit: `proofs/kani/imported.json`.
//!
//! `make prove-kani REPORT=… COMMIT=…` writes it. Where the model checker does not run, its
//! records are made of it; they are bound to the sources as they were at that commit.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::claims::Claims;
use crate::collect::{self, Part, Report, Verdict};
use crate::record::{Engine, Evidence, Record, sha256};

/// Where it is, from the root of the workspace.
pub const FILE: &str = "proofs/kani/imported.json";

/// A run of the model checker in which every harness was proved.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Imported {
    /// The tool and its version: `Kani 0.67.0`.
    pub tool: String,
    /// What works under it: `CBMC 6.6.0` and the solver.
    pub below: Vec<String>,
    /// The commit whose sources were checked, all digits.
    pub commit: String,
    /// SHA-256 of the report.
    pub report_sha256: String,
    /// The harnesses of that commit, all of which were proved.
    pub harnesses: Vec<Harness>,
    /// What the harnesses of a claim speak of, by its id.
    pub claims: BTreeMap<String, Bound>,
    /// SHA-256 of each source of the harnesses at that commit.
    pub harness_files: BTreeMap<String, String>,
}

/// A harness that was proved.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Harness {
    /// File and function: `generation::th_lin_bound`.
    pub name: String,
    /// The ids of its claims.
    pub claims: Vec<String>,
    /// Its domain in words.
    pub domain: String,
    /// The time it took.
    pub seconds: f64,
}

/// A claim and its code, as they were at the commit.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Bound {
    /// What part of the claim the harnesses spoke of.
    pub scope: Option<String>,
    /// SHA-256 of the claim's text.
    pub claim_sha256: String,
    /// SHA-256 of each source file of the claim's code.
    pub sources: BTreeMap<String, String>,
}

/// The claims that harnesses speak of, from the text of `claims.toml` and the sources at a commit.
///
/// # Errors
///
/// A sentence, when the claims or a source can't be read, or a harness names an unknown claim.
pub fn bind(
    claims: &str,
    harnesses: &[Harness],
    read: impl Fn(&str) -> Result<String, String>,
) -> Result<BTreeMap<String, Bound>, String> {
    let claims: Claims =
        toml::from_str(claims).map_err(|e| format!("`claims.toml` of that commit: {e}"))?;
    let mut bound = BTreeMap::new();
    for harness in harnesses {
        for id in &harness.claims {
            let claim = claims
                .find(id)
                .ok_or_else(|| format!("{}: unknown claim `{id}`", harness.name))?;
            let hash = |file: String| {
                let text = read(&file)?;
                Ok((file, sha256(text.as_bytes())))
            };
            let sources: Result<_, String> = claim.files().into_iter().map(hash).collect();
            let entry = Bound {
                scope: claim.scope.get(&Engine::Kani).cloned(),
                claim_sha256: claim.sha256(),
                sources: sources?,
            };
            bound.insert(id.clone(), entry);
        }
    }
    Ok(bound)
}

impl Imported {
    /// Reads what was recorded in the tree at `root`; `None` when nothing was.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be read or is no such record.
    pub fn read(root: &Path) -> Result<Option<Self>, String> {
        let path = root.join(FILE);
        if !path.exists() {
            return Ok(None);
        }
        let read = serde_json::from_str(&crate::read(&path)?);
        read.map(Some)
            .map_err(|e| format!("{}: {e}", path.display()))
    }

    /// Records it in the tree at `root`.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be written.
    pub fn write(&self, root: &Path) -> Result<(), String> {
        let path = root.join(FILE);
        let text = serde_json::to_string_pretty(self).map_err(|e| e.to_string())?;
        std::fs::write(&path, format!("{text}\n")).map_err(|e| format!("{}: {e}", path.display()))
    }

    /// The tool and the commit, and no more than these: `Kani 0.67.0, at commit 5cb3f4e2695e`.
    #[must_use]
    pub fn words(&self) -> String {
        let commit = self.commit.get(..12).unwrap_or(&self.commit);
        format!("{}, at commit {commit}", self.tool)
    }

    /// The harness that took longest.
    #[must_use]
    pub fn slowest(&self) -> Option<&Harness> {
        let order = |a: &&Harness, b: &&Harness| a.seconds.total_cmp(&b.seconds);
        self.harnesses.iter().max_by(order)
    }

    /// The sources of a record's harnesses that have changed since: the files that they stand in,
    /// and those of the same crate in which no harness stands. None for a record of another run.
    ///
    /// # Errors
    ///
    /// A sentence, when a file can't be read.
    pub fn changed(&self, root: &Path, record: &Record) -> Result<Vec<String>, String> {
        if record.engine != Engine::Kani || record.tool != self.words() {
            return Ok(Vec::new());
        }
        let all: Vec<&String> = self.harnesses.iter().map(|h| &h.name).collect();
        let own: Vec<&String> = record.parts.iter().collect();
        let mut changed = Vec::new();
        for (file, hash) in &self.harness_files {
            let concerns = has_one_of(file, &own) || !has_one_of(file, &all);
            let path = root.join(file);
            if concerns && (!path.exists() || sha256(crate::read(&path)?.as_bytes()) != *hash) {
                changed.push(file.clone());
            }
        }
        Ok(changed)
    }

    /// What was said, in the form that all engines report in; of the claims that are still there.
    pub(crate) fn report(&self, claims: &Claims) -> Report {
        let part = |harness: &Harness| Part {
            claims: harness
                .claims
                .iter()
                .filter(|id| claims.find(id).is_some())
                .cloned()
                .collect(),
            name: harness.name.clone(),
            verdict: Verdict::AllInputs,
            domain: Some(harness.domain.clone()),
            cases: None,
            seconds: harness.seconds,
            failure: None,
        };
        Report {
            engine: Engine::Kani,
            tool: self.words(),
            parts: self.harnesses.iter().map(part).collect(),
            not_run: None,
        }
    }

    /// Binds a record to the claim and the sources as they were at the commit.
    pub(crate) fn bind(&self, record: &mut Record) {
        if let Some(bound) = self.claims.get(&record.claim) {
            record.scope.clone_from(&bound.scope);
            record.claim_sha256.clone_from(&bound.claim_sha256);
            record.sources.clone_from(&bound.sources);
        }
    }

    /// Puts its records into recorded evidence, in the place of what the model checker said before.
    ///
    /// # Errors
    ///
    /// A sentence, when a source of a claim can't be read.
    pub fn put_into(
        &self,
        root: &Path,
        claims: &Claims,
        evidence: &mut Evidence,
    ) -> Result<(), String> {
        let report = self.report(claims);
        if let Some(run) = evidence
            .runs
            .iter_mut()
            .find(|run| run.engine == Engine::Kani)
        {
            *run = collect::run(&report);
        }
        let mut records = Vec::new();
        for claim in &claims.claims {
            for engine in evidence.runs.iter().map(|run| run.engine) {
                let kept = || evidence.find(&claim.id, engine).cloned();
                let record = match engine {
                    Engine::Kani => collect::record(root, claim, &report, Some(self))?,
                    _ => kept(),
                };
                records.extend(record);
            }
        }
        evidence.records = records;
        Ok(())
    }
}

/// Whether one of the harnesses stands in a file: `generation::th_lin_bound` in `generation.rs`.
fn has_one_of(file: &str, harnesses: &[&String]) -> bool {
    let stem = Path::new(file).file_stem().and_then(|stem| stem.to_str());
    let module = |name: &&String| name.split("::").next() == stem;
    harnesses.iter().any(module)
}
