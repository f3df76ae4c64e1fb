//! What the model checker said elsewhere, of the sources of a commit: `proofs/kani/imported.json`.
//!
//! `make prove-kani REPORT=… COMMIT=…` writes it. Where the model checker does not run, its
//! records are made of it; they are bound to the sources as they were at that commit.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{Claims, Engine, Evidence, EvidenceError, Sha256, Shown, Tool, read};
use serde::{Deserialize, Serialize};

use crate::collect::{Collector, run};
use crate::engines::{Done, Modules, Part, Report, harness_build};
use crate::reads::Reads;
use crate::sources::Sources;

/// Where the harnesses are, from the root of the workspace.
pub const HARNESSES: &str = "proofs/kani/src";

/// The list of the harnesses, from the root of the workspace.
pub const LIST: &str = "proofs/kani/harnesses.toml";

/// Where it is, from the root of the workspace.
pub const FILE: &str = "proofs/kani/imported.json";

/// A run of the model checker in which every harness was proved.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Imported {
    /// The tool and its version: `Kani 0.67.0`.
    pub tool: Tool,
    /// What works under it: `CBMC 6.6.0` and the solver.
    pub below: Vec<String>,
    /// The commit whose sources were checked, all digits.
    pub commit: String,
    /// SHA-256 of the report.
    pub report_sha256: Sha256,
    /// The harnesses of that commit, all of which were proved.
    pub harnesses: Vec<Harness>,
    /// What the harnesses of a claim speak of, by its id.
    pub claims: BTreeMap<String, Bound>,
    /// SHA-256 of each file that these rest on, as it was at that commit.
    pub files: BTreeMap<String, Sha256>,
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
    /// [`Claims::statement`], of the claims at that commit.
    pub statement: Sha256,
    /// The files that its code and its harnesses rested on.
    pub sources: BTreeSet<String>,
}

/// Claims as they were at a commit, by their ids, and the sums of the files there.
pub type AtCommit = (BTreeMap<String, Bound>, BTreeMap<String, Sha256>);

/// The claims that harnesses speak of, as they and the sources are at a commit.
///
/// # Errors
///
/// A sentence, when the claims or a source can't be read, or a harness names an unknown claim.
pub fn bind(root: &Path, commit: &str, harnesses: &[Harness]) -> Result<AtCommit, EvidenceError> {
    let sources = Sources::new(root, Some(commit.to_owned()));
    let claims = Claims::parse("claims.toml of that commit", &sources.text(Claims::PATH)?)?;
    let (reads, modules) = (Reads::new(&sources)?, Modules::new(&sources, HARNESSES)?);
    let mut roots: BTreeMap<&str, BTreeSet<String>> = BTreeMap::new();
    for harness in harnesses {
        for id in &harness.claims {
            let claim = claims.find(id).ok_or_else(|| {
                EvidenceError::new(format!("{}: unknown claim `{id}`", harness.name))
            })?;
            let roots = roots.entry(&claim.id).or_default();
            roots.extend(claim.files());
            roots.extend(modules.of(&harness.name)?);
        }
    }
    let (mut bound, mut sums) = (BTreeMap::new(), BTreeMap::new());
    for claim in &claims.claims {
        let Some(roots) = roots.remove(claim.id.as_str()) else {
            continue;
        };
        let mut files = reads.of(&sources, roots)?;
        files.extend(harness_build());
        for file in &files {
            if !sums.contains_key(file) {
                sums.insert(file.clone(), sources.sum(file)?);
            }
        }
        let entry = Bound {
            scope: claim.scope.get(&Engine::Kani).cloned(),
            statement: claims.statement(claim, Engine::Kani)?,
            sources: files,
        };
        bound.insert(claim.id.clone(), entry);
    }
    Ok((bound, sums))
}

impl Imported {
    /// Reads what was recorded in the tree at `root`; `None` when nothing was.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be read or is no such record.
    pub fn read(root: &Path) -> Result<Option<Self>, EvidenceError> {
        let path = root.join(FILE);
        if !path.exists() {
            return Ok(None);
        }
        let read = serde_json::from_str(&read(&path)?);
        read.map(Some)
            .map_err(|error| EvidenceError::within(FILE, error))
    }

    /// Records it in the tree at `root`.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be written.
    pub fn write(&self, root: &Path) -> Result<(), EvidenceError> {
        let path = root.join(FILE);
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| EvidenceError::within(FILE, error))?;
        std::fs::write(&path, format!("{text}\n")).map_err(|error| EvidenceError::io(&path, &error))
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

    /// What was said, in the form that all engines report in; of the claims that are still there.
    pub(crate) fn report(self, claims: &Claims) -> Report {
        let part = |harness: &Harness| {
            let known = |id: &&String| claims.find(id).is_some();
            Part {
                claims: harness.claims.iter().filter(known).cloned().collect(),
                name: harness.name.clone(),
                shows: Shown::AllInputs { domains: 1 },
                domain: Some(harness.domain.clone()),
                cases: None,
                seconds: harness.seconds,
                failure: None,
                files: BTreeSet::new(),
            }
        };
        let parts: Vec<Part> = self.harnesses.iter().map(part).collect();
        Report::done(
            Engine::Kani,
            Done {
                tools: vec![self.tool.clone()],
                shared: BTreeSet::new(),
                parts,
                commit: Some(self.commit.clone()),
                imported: Some(Box::new(self)),
            },
        )
    }

    /// A claim as it was at the commit, and the sums of the files that it rested on there; `None`
    /// when no harness spoke of it.
    pub(crate) fn bound(&self, claim: &str) -> Option<(&Bound, BTreeMap<String, Sha256>)> {
        let bound = self.claims.get(claim)?;
        let of = |file: &String| Some((file.clone(), *self.files.get(file)?));
        Some((bound, bound.sources.iter().filter_map(of).collect()))
    }

    /// Puts its records into recorded evidence, in the place of what the model checker said before.
    ///
    /// # Errors
    ///
    /// A harness without a source, and a claim that refers to what is not there.
    pub fn put_into(
        &self,
        root: &Path,
        claims: &Claims,
        evidence: &mut Evidence,
    ) -> Result<(), EvidenceError> {
        let report = self.clone().report(claims);
        let collector = Collector::new(root, claims)?;
        let (mut records, mut files) = (Vec::new(), BTreeMap::new());
        for claim in &claims.claims {
            for engine in evidence.runs.iter().map(|run| run.engine) {
                records.extend(match engine {
                    Engine::Kani => collector.record(claim, &report, &mut files)?,
                    _ => evidence.find(&claim.id, engine).cloned(),
                });
            }
        }
        evidence.records = records;
        let new = run(report, files)?;
        let mut runs = evidence.runs.iter_mut();
        if let Some(old) = runs.find(|run| run.engine == Engine::Kani) {
            *old = new;
        }
        Ok(())
    }
}
