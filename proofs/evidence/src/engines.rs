//! What each engine left behind, read into parts: harnesses, queries, tests, theorems.
//!
//! `proofs/prove` runs the engines with `PASSIVITY_EVIDENCE_DIR` set. They leave `properties.txt`,
//! `verdicts.txt` and `certificates.txt` (the reports of the tests of the kernel, of verdicts over scenes
//! and of their certificates), `identify.txt` and `properties.jsonl` (their cases), `kani-standin.jsonl`, `kani.jsonl`, `smt.jsonl`, `rocq.json` and
//! `prusti.json`, and the version of the compiler in `rustc.txt`. What is not there did not run.

mod harnesses;
mod rocq;
mod smt;
mod tests;

use std::collections::BTreeSet;
use std::path::Path;

use passivity_evidence::{Claims, Engine, EvidenceError, Shown, Tool, read};
use serde::Deserialize;
use serde::de::DeserializeOwned;

pub(crate) use harnesses::shared as harness_build;

use crate::imported::Imported;
use crate::sources::Sources;

/// One harness, query, test or theorem, and the claims that it speaks of.
pub(crate) struct Part {
    pub(crate) claims: Vec<String>,
    pub(crate) name: String,
    /// What it shows when it passes.
    pub(crate) shows: Shown,
    pub(crate) domain: Option<String>,
    pub(crate) cases: Option<u64>,
    pub(crate) seconds: f64,
    pub(crate) failure: Option<String>,
    /// The files that are its own; it rests on what they rest on, too.
    pub(crate) files: BTreeSet<String>,
}

/// What every Rust program here is built by, whatever crate it is of.
const BUILD: [&str; 3] = [
    "Cargo.lock",
    "Cargo.toml",
    "crates/passivity-core/Cargo.toml",
];

/// What a Rust program is built by, beside its sources.
fn built_by(manifests: &[&str]) -> BTreeSet<String> {
    let files = BUILD.iter().chain(manifests);
    files.map(|path| (*path).to_owned()).collect()
}

/// All that an engine left.
pub(crate) struct Report {
    pub(crate) engine: Engine,
    pub(crate) ran: Ran,
}

/// What an engine that ran left.
pub(crate) struct Done {
    pub(crate) tools: Vec<Tool>,
    pub(crate) parts: Vec<Part>,
    /// The files that every part rests on.
    pub(crate) shared: BTreeSet<String>,
    /// The commit, when the run was made elsewhere.
    pub(crate) commit: Option<String>,
    /// What was recorded of that run, when it is that.
    pub(crate) imported: Option<Box<Imported>>,
}

/// Whether an engine ran.
pub(crate) enum Ran {
    Yes(Done),
    No(String),
}

impl Report {
    fn absent(engine: Engine, why: impl Into<String>) -> Self {
        Self {
            engine,
            ran: Ran::No(why.into()),
        }
    }

    pub(crate) fn done(engine: Engine, done: Done) -> Self {
        Self {
            engine,
            ran: Ran::Yes(done),
        }
    }

    /// The parts; none of an engine that did not run.
    pub(crate) fn parts(&self) -> &[Part] {
        match &self.ran {
            Ran::Yes(done) => &done.parts,
            Ran::No(_) => &[],
        }
    }
}

/// The reports of all engines, in the order of the table.
pub(crate) fn reports(
    root: &Path,
    folder: &Path,
    claims: &Claims,
) -> Result<Vec<Report>, EvidenceError> {
    // What Kani said elsewhere counts where it does not run.
    let mut kani = harnesses::kani(root, folder)?;
    if let (Ran::No(_), Some(imported)) = (&kani.ran, Imported::read(root)?) {
        kani = imported.report(claims);
    }
    Ok(vec![
        smt::report(&Sources::new(root, None), folder)?,
        rocq::report(&Sources::new(root, None), folder)?,
        kani,
        harnesses::stand_in(root, folder)?,
        tests::report(&Sources::new(root, None), folder, claims)?,
        prusti(folder)?,
    ])
}

/// Why the contracts were not checked. Nothing here reads a result of theirs.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Prusti {
    not_run: String,
}

fn prusti(folder: &Path) -> Result<Report, EvidenceError> {
    let run: Option<Prusti> = document(&folder.join("prusti.json"))?;
    let why = run.map_or_else(
        || "`make prove-prusti` was not called".to_owned(),
        |run| run.not_run,
    );
    Ok(Report::absent(Engine::Prusti, why))
}

/// A JSON document; `None` when there is no such file.
fn document<T: DeserializeOwned>(path: &Path) -> Result<Option<T>, EvidenceError> {
    if !path.exists() {
        return Ok(None);
    }
    let name = path.display().to_string();
    let read = serde_json::from_str(&read(path)?);
    read.map(Some)
        .map_err(|error| EvidenceError::within(&name, error))
}

/// The lines of a file with a JSON document a line; `None` when there is no such file.
fn lines<T: DeserializeOwned>(path: &Path) -> Result<Option<Vec<T>>, EvidenceError> {
    if !path.exists() {
        return Ok(None);
    }
    let name = path.display().to_string();
    let parse = |(index, line): (usize, &str)| {
        serde_json::from_str(line)
            .map_err(|error| EvidenceError::within(&name, format!("line {}: {error}", index + 1)))
    };
    let text = read(path)?;
    text.lines()
        .enumerate()
        .map(parse)
        .collect::<Result<_, _>>()
        .map(Some)
}

/// The files of a Rust test crate that hold the module of a part such as `region::th_region_x`.
pub(crate) struct Modules {
    files: BTreeSet<String>,
    folder: String,
}

impl Modules {
    pub(crate) fn new(sources: &Sources, folder: &str) -> Result<Self, EvidenceError> {
        Ok(Self {
            files: sources.under(folder)?,
            folder: folder.to_owned(),
        })
    }

    pub(crate) fn of(&self, part: &str) -> Result<BTreeSet<String>, EvidenceError> {
        let module = part.split("::").next();
        let file = module.map(|module| format!("{}/{module}.rs", self.folder));
        let within = module.map(|module| format!("{}/{module}/", self.folder));
        let holds = |path: &&String| {
            Some(*path) == file.as_ref() || within.as_ref().is_some_and(|w| path.starts_with(w))
        };
        let files: BTreeSet<String> = self.files.iter().filter(holds).cloned().collect();
        if files.is_empty() {
            let what = format!("there is no file with the module of `{part}`");
            return Err(EvidenceError::within(&self.folder, what));
        }
        Ok(files)
    }
}

/// A tool of ours, and the compiler that built it where the run recorded one.
fn built(name: &str, folder: &Path) -> Result<Vec<Tool>, EvidenceError> {
    let path = folder.join("rustc.txt");
    let mut tools = vec![tool(name, None)];
    if path.exists() {
        // `rustc 1.95.0 (59807616e 2026-04-14)`
        let said = read(&path)?;
        let version = said
            .split_whitespace()
            .nth(1)
            .ok_or_else(|| EvidenceError::within("rustc.txt", "there is no version in it"))?;
        tools.push(tool("rustc", Some(version.to_owned())));
    }
    Ok(tools)
}

fn tool(name: &str, version: Option<String>) -> Tool {
    Tool {
        name: name.to_owned(),
        version,
    }
}
