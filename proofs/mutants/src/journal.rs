//! What the tests said of each change, kept as it comes.

use std::collections::BTreeMap;
use std::fs::{self, File, OpenOptions};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::Path;
use std::process::Command;
use std::sync::Mutex;

use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::SUBJECTS;
use crate::changes::Change;
use crate::runs::{Outcome, Test};

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
    /// Of what was built: the crate whose test noticed with those below it, or else all.
    sources: u64,
    /// Of all their tests.
    tests: u64,
}

/// What is known of the changes.
pub(crate) struct Journal {
    /// Of each crate with those below it.
    sources: [u64; SUBJECTS.len()],
    tests: u64,
    inner: Mutex<(BTreeMap<String, Entry>, File)>,
}

impl Journal {
    /// Reads what earlier runs have found on the same sources. That a change was not noticed counts
    /// only with the same tests; that it was, as long as the crate of the test and those below it are
    /// the same.
    pub(crate) fn open(root: &Path, folder: &Path) -> Result<Self, String> {
        let (mut so_far, mut tests) = (DefaultHasher::new(), DefaultHasher::new());
        hash(&root.join("Cargo.lock"), &mut so_far)?;
        let mut sources = [0; SUBJECTS.len()];
        for (subject, sources) in SUBJECTS.iter().zip(&mut sources) {
            let folder = root.join(subject.folder);
            hash(&folder.join("src"), &mut so_far)?;
            hash(&folder.join("tests"), &mut tests)?;
            subject.tests.hash(&mut tests);
            *sources = so_far.finish();
        }
        let tests = tests.finish();
        let path = folder.join("journal.jsonl");
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
            let counts = entry.tests == tests
                || matches!(entry.outcome, Outcome::Noticed | Outcome::Unviable);
            if sources.contains(&entry.sources) && counts {
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

    /// Which sources and which tests it speaks of.
    pub(crate) const fn of(&self) -> ([u64; SUBJECTS.len()], u64) {
        (self.sources, self.tests)
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
        self.entry(mutant).is_some_and(|entry| {
            let open = matches!(entry.outcome, Outcome::Survived | Outcome::TimedOut);
            !open || entry.cases >= cases
        })
    }

    pub(crate) fn add(
        &self,
        mutant: &str,
        (outcome, test): (Outcome, Option<&Test>),
        cases: u32,
        seconds: f64,
    ) -> Result<(), String> {
        let entry = Entry {
            mutant: mutant.to_owned(),
            outcome,
            test: test.map(|test| test.name.clone()),
            cases,
            seconds,
            sources: self.sources[test.map_or(SUBJECTS.len() - 1, |test| test.subject)],
            tests: self.tests,
        };
        let line = serde_json::to_string(&entry).map_err(|e| e.to_string())?;
        let (entries, file) = &mut *self.inner.lock().expect("no thread fails");
        entries.insert(entry.mutant.clone(), entry);
        writeln!(file, "{line}").map_err(|e| format!("the journal: {e}"))
    }
}

/// Leaves what became of all changes, in the form of cargo-mutants.
pub(crate) fn write_whole(
    folder: &Path,
    journal: &Journal,
    changes: &[Change],
    left_out: &[String],
) -> Result<(), String> {
    let outcome = |change: &Change| {
        let missing = || format!("{}: no test was run", change.name);
        let entry = journal.entry(&change.name).ok_or_else(missing)?;
        let summary = match entry.outcome {
            Outcome::Noticed => "CaughtMutant",
            Outcome::Survived => "MissedMutant",
            Outcome::TimedOut => "Timeout",
            Outcome::Unviable => "Unviable",
        };
        Ok(json!({
            "scenario": {"Mutant": {"name": change.name, "file": change.file}},
            "summary": summary,
            "phase_results": [{"duration": entry.seconds}],
        }))
    };
    let outcomes: Result<Vec<_>, String> = changes.iter().map(outcome).collect();
    let version = Command::new("cargo")
        .args(["mutants", "--version"])
        .output()
        .map_err(|e| format!("cargo mutants: {e}"))?;
    let version = String::from_utf8_lossy(&version.stdout);
    let run = json!({
        "cargo_mutants_version": version.trim().trim_start_matches("cargo-mutants "),
        "end_time": "done",
        "outcomes": outcomes?,
        "left_out": left_out,
    });
    let path = folder.join("outcomes.json");
    fs::write(&path, run.to_string()).map_err(|e| format!("{}: {e}", path.display()))
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
