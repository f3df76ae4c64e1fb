//! What the tests said of each change, kept as it comes.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::Subject;
use crate::changes::Change;
use crate::runs::Outcome;

/// A line of the journal.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub(crate) struct Entry {
    pub(crate) mutant: String,
    pub(crate) outcome: Outcome,
    /// The test that noticed.
    pub(crate) test: Option<String>,
    /// How many inputs a property test was given.
    pub(crate) cases: u32,
    pub(crate) seconds: f64,
    /// Of the crate's sources and of those below it.
    sources: u64,
    /// Of the crate's tests.
    tests: u64,
}

/// What is known of a crate's changes.
pub(crate) struct Journal {
    sources: u64,
    tests: u64,
    inner: Mutex<(BTreeMap<String, Entry>, File)>,
}

impl Journal {
    /// Reads what earlier runs have found on the same sources. That a change was not noticed counts
    /// only with the same tests.
    pub(crate) fn open(root: &Path, subject: &Subject, folder: &Path) -> Result<Self, String> {
        let mut sources = DefaultHasher::new();
        for folder in subject.folders {
            hash(&root.join(folder).join("src"), &mut sources)?;
        }
        hash(&root.join("Cargo.lock"), &mut sources)?;
        let mut tests = DefaultHasher::new();
        hash(&root.join(subject.folder()).join("tests"), &mut tests)?;
        let (sources, tests) = (sources.finish(), tests.finish());
        let path = folder.join(format!("{}.jsonl", subject.package));
        let failed = |e: std::io::Error| format!("{}: {e}", path.display());
        let text = if path.exists() {
            fs::read_to_string(&path).map_err(failed)?
        } else {
            String::new()
        };
        let mut entries = BTreeMap::new();
        // The last line of a run that was stopped may not be whole.
        for entry in text
            .lines()
            .filter_map(|line| serde_json::from_str::<Entry>(line).ok())
        {
            let counts = entry.outcome == Outcome::Noticed || entry.tests == tests;
            if entry.sources == sources && counts {
                entries.insert(entry.mutant.clone(), entry);
            }
        }
        let mut file = OpenOptions::new()
            .create(true)
            .append(true)
            .open(&path)
            .map_err(failed)?;
        if !text.is_empty() && !text.ends_with('\n') {
            writeln!(file).map_err(failed)?;
        }
        Ok(Self {
            sources,
            tests,
            inner: Mutex::new((entries, file)),
        })
    }

    fn entry(&self, mutant: &str) -> Option<Entry> {
        self.inner
            .lock()
            .expect("no thread fails")
            .0
            .get(mutant)
            .cloned()
    }

    pub(crate) fn outcome(&self, mutant: &str) -> Option<Outcome> {
        self.entry(mutant).map(|entry| entry.outcome)
    }

    /// Whether the tests have been asked with as many inputs, or need not be.
    pub(crate) fn has(&self, mutant: &str, cases: u32) -> bool {
        self.entry(mutant)
            .is_some_and(|entry| entry.outcome != Outcome::Survived || entry.cases >= cases)
    }

    pub(crate) fn add(
        &self,
        mutant: &str,
        (outcome, test): (Outcome, Option<String>),
        cases: u32,
        seconds: f64,
    ) -> Result<(), String> {
        let entry = Entry {
            mutant: mutant.to_owned(),
            outcome,
            test,
            cases,
            seconds,
            sources: self.sources,
            tests: self.tests,
        };
        let line = serde_json::to_string(&entry).map_err(|e| e.to_string())?;
        let (entries, file) = &mut *self.inner.lock().expect("no thread fails");
        entries.insert(entry.mutant.clone(), entry);
        writeln!(file, "{line}").map_err(|e| format!("the journal: {e}"))
    }
}

/// What became of all changes, in the form of cargo-mutants.
pub(crate) struct Whole {
    version: String,
    left_out: Vec<String>,
    outcomes: Vec<Value>,
}

impl Whole {
    pub(crate) fn new(left_out: Vec<String>) -> Result<Self, String> {
        let output = Command::new("cargo")
            .args(["mutants", "--version"])
            .output()
            .map_err(|e| format!("cargo mutants: {e}"))?;
        let version = String::from_utf8_lossy(&output.stdout);
        let version = version.trim().trim_start_matches("cargo-mutants ");
        Ok(Self {
            version: version.to_owned(),
            left_out,
            outcomes: Vec::new(),
        })
    }

    /// Takes in the changes of a crate, and those with which it does not compile.
    pub(crate) fn add(
        &mut self,
        journal: &Journal,
        changes: &[Change],
        unviable: Vec<Change>,
    ) -> Result<(), String> {
        for change in changes {
            let missing = || format!("{}: no test was run", change.name);
            let entry = journal.entry(&change.name).ok_or_else(missing)?;
            let summary = match entry.outcome {
                Outcome::Noticed => "CaughtMutant",
                Outcome::Survived => "MissedMutant",
                Outcome::TimedOut => "Timeout",
            };
            self.push(change, summary, entry.seconds);
        }
        for change in unviable {
            self.push(&change, "Unviable", 0.0);
        }
        Ok(())
    }

    fn push(&mut self, change: &Change, summary: &str, seconds: f64) {
        self.outcomes.push(json!({
            "scenario": {"Mutant": {"name": change.name, "file": change.file}},
            "summary": summary,
            "phase_results": [{"duration": seconds}],
        }));
    }

    /// Leaves it in a folder.
    pub(crate) fn write(self, folder: &Path) -> Result<(), String> {
        let path = folder.join("outcomes.json");
        let run = json!({
            "cargo_mutants_version": self.version,
            "end_time": "done",
            "outcomes": self.outcomes,
            "left_out": self.left_out,
        });
        fs::write(&path, run.to_string()).map_err(|e| format!("{}: {e}", path.display()))
    }
}

/// Takes in a file, or all below a folder in the order of their names.
fn hash(path: &Path, hasher: &mut DefaultHasher) -> Result<(), String> {
    let failed = |e: std::io::Error| format!("{}: {e}", path.display());
    if path.is_dir() {
        let entries: Result<Vec<_>, _> = fs::read_dir(path).map_err(failed)?.collect();
        let mut paths: Vec<_> = entries.map_err(failed)?.iter().map(|e| e.path()).collect();
        paths.sort();
        return paths.iter().try_for_each(|path| hash(path, hasher));
    }
    path.file_name().hash(hasher);
    fs::read(path).map_err(failed)?.hash(hasher);
    Ok(())
}
