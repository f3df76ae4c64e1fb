//! What cargo-mutants found, against the committed list of survivors and their reasons.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{EvidenceError, Mutation, Sha256, Survivor, Tool, read};
use serde::Deserialize;

use crate::collect::counted;
use crate::sources::Sources;

/// The survivors that are known, from the root of the workspace.
const EXPLAINED: &str = "proofs/mutants/explained.toml";

/// The last mutation run, from the root of the workspace.
pub const LAST: &str = "proofs/mutants/last.json";

/// `proofs/mutants/explained.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Explained {
    #[serde(default)]
    survivor: Vec<Survivor>,
}

/// The survivors that are known, and why nothing can notice them.
///
/// # Errors
///
/// A list that cannot be read.
pub fn explained(root: &Path) -> Result<Vec<Survivor>, EvidenceError> {
    let list: Explained = toml::from_str(&read(&root.join(EXPLAINED))?)
        .map_err(|error| EvidenceError::within(EXPLAINED, error))?;
    Ok(list.survivor)
}

/// The last mutation run, when there was one.
pub(crate) fn last(root: &Path) -> Result<Option<Mutation>, EvidenceError> {
    let path = root.join(LAST);
    if !path.exists() {
        return Ok(None);
    }
    let run = serde_json::from_str(&read(&path)?);
    run.map(Some)
        .map_err(|error| EvidenceError::within(LAST, error))
}

/// Reads the folders `mutants.out` of runs, of which a later one has asked again about survivors of
/// an earlier one. Also gives what is wrong: survivors that nobody explained, and explanations of
/// mutants that were noticed.
///
/// # Errors
///
/// A folder that is not that of a finished run.
pub fn judge(
    root: &Path,
    folders: &[&Path],
    explained: &[Survivor],
) -> Result<(Mutation, Vec<String>), EvidenceError> {
    let mut all = Runs::default();
    for folder in folders {
        all.read(&folder.join("outcomes.json"))?;
    }
    let caught = all.noticed.values().filter(|noticed| **noticed).count();
    if caught == 0 {
        let message = "no mutant was noticed: the run is not one";
        return Err(EvidenceError::new(message));
    }
    let (survivors, faults) = all.survivors(explained);
    let tree = Sources::new(root, None);
    let sum = |file: &String| Ok((file.clone(), tree.sum(file)?));
    let sources: Result<BTreeMap<String, Sha256>, EvidenceError> =
        all.files.iter().map(sum).collect();
    let mutation = Mutation {
        tool: Tool {
            name: "cargo-mutants".to_owned(),
            version: all.version,
        },
        mutants: counted(all.noticed.len())?,
        caught: counted(caught)?,
        survivors,
        seconds: all.seconds.round(),
        sources: sources?,
    };
    Ok((mutation, faults))
}

/// `outcomes.json`, as far as it matters here.
#[derive(Deserialize)]
struct Outcomes {
    cargo_mutants_version: Option<String>,
    end_time: Option<String>,
    outcomes: Vec<Outcome>,
}

#[derive(Deserialize)]
struct Outcome {
    scenario: Scenario,
    summary: Summary,
    phase_results: Vec<Phase>,
}

/// The tests of the unchanged code, or of a mutant.
#[derive(Deserialize)]
enum Scenario {
    Baseline,
    Mutant { name: String, file: String },
}

#[derive(Deserialize)]
enum Summary {
    Success,
    CaughtMutant,
    Timeout,
    MissedMutant,
    Unviable,
    Failure,
}

#[derive(Deserialize)]
struct Phase {
    duration: f64,
}

/// What runs of cargo-mutants said, the last word on each mutant that compiles.
#[derive(Default)]
struct Runs {
    /// Whether a test noticed it.
    noticed: BTreeMap<String, bool>,
    files: BTreeSet<String>,
    seconds: f64,
    version: Option<String>,
}

impl Runs {
    fn read(&mut self, path: &Path) -> Result<(), EvidenceError> {
        let name = path.display().to_string();
        let run: Outcomes = serde_json::from_str(&read(path)?)
            .map_err(|error| EvidenceError::within(&name, error))?;
        if run.end_time.is_none() {
            return Err(EvidenceError::within(&name, "the run was not finished"));
        }
        // Swaps of our own are left in the same form, without a version.
        self.version = run.cargo_mutants_version.or(self.version.take());
        for outcome in run.outcomes {
            let durations = outcome.phase_results.iter().map(|phase| phase.duration);
            self.seconds += durations.sum::<f64>();
            let Scenario::Mutant { name: mutant, file } = outcome.scenario else {
                continue;
            };
            self.files.insert(file);
            let noticed = match outcome.summary {
                Summary::CaughtMutant => true,
                // What does not come to an end says nothing: somebody has to say why it does not.
                Summary::MissedMutant | Summary::Timeout => false,
                Summary::Unviable => continue,
                Summary::Success | Summary::Failure => {
                    let what = format!("`{mutant}` came to no end that is known");
                    return Err(EvidenceError::within(&name, what));
                }
            };
            self.noticed.insert(mutant, noticed);
        }
        Ok(())
    }

    /// The survivors with their reasons, and what is wrong with them.
    fn survivors(&self, explained: &[Survivor]) -> (Vec<Survivor>, Vec<String>) {
        let missed = self.noticed.iter().filter(|(_, noticed)| !**noticed);
        let survived: BTreeSet<String> = missed.map(|(name, _)| without_line(name)).collect();
        let known: BTreeMap<&str, &Survivor> = explained
            .iter()
            .map(|survivor| (survivor.mutant.as_str(), survivor))
            .collect();
        let mut survivors = Vec::new();
        let mut faults = Vec::new();
        for name in &survived {
            match known.get(name.as_str()) {
                Some(survivor) => survivors.push((*survivor).clone()),
                None => faults.push(format!("survived, and nobody says why: {name}")),
            }
        }
        for name in known.keys().filter(|name| !survived.contains(**name)) {
            faults.push(format!("explained, but it was noticed or is gone: {name}"));
        }
        (survivors, faults)
    }
}

/// The name of a mutant without its line and column, which change with every edit above it.
fn without_line(name: &str) -> String {
    let mut parts = name.splitn(4, ':');
    match (parts.next(), parts.next(), parts.next(), parts.next()) {
        (Some(file), Some(_), Some(_), Some(what)) => format!("{file}:{what}"),
        _ => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;

    #[test]
    fn names_lose_their_lines() {
        let name = "crates/x/src/region.rs:12:34: replace < with <= in Region::of";
        assert_eq!(
            without_line(name),
            "crates/x/src/region.rs: replace < with <= in Region::of"
        );
    }

    /// A folder with the record of a run, in which the mutants ended as said.
    fn run_of(name: &str, mutants: &[(&str, &str)]) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("passivity-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let mut outcomes = vec![
            serde_json::json!({"scenario": "Baseline", "summary": "Success", "phase_results": []}),
        ];
        outcomes.extend(mutants.iter().map(|(name, summary)| {
            serde_json::json!({
                "scenario": {"Mutant": {"name": name, "file": "proofs/claims.toml"}},
                "summary": summary,
                "phase_results": [{"duration": 1.0}],
            })
        }));
        let run = serde_json::json!({
            "cargo_mutants_version": "1", "end_time": "now", "outcomes": outcomes,
        });
        std::fs::write(folder.join("outcomes.json"), run.to_string()).unwrap();
        folder
    }

    fn because(mutant: &str) -> Survivor {
        Survivor {
            mutant: mutant.into(),
            reason: "because".into(),
        }
    }

    fn judged(runs: &[PathBuf], explained: &[Survivor]) -> (Mutation, Vec<String>) {
        let folders: Vec<&Path> = runs.iter().map(PathBuf::as_path).collect();
        let judged = judge(&crate::root(), &folders, explained).unwrap();
        for folder in runs {
            std::fs::remove_dir_all(folder).unwrap();
        }
        judged
    }

    #[test]
    fn an_unexplained_survivor_is_a_fault() {
        let run = run_of(
            "one-run",
            &[
                ("a.rs:1:1: one", "CaughtMutant"),
                ("a.rs:2:1: two", "MissedMutant"),
                ("a.rs:3:1: three", "MissedMutant"),
                ("a.rs:4:1: four", "Unviable"),
                ("a.rs:5:1: five", "Timeout"),
            ],
        );
        let (mutation, faults) = judged(&[run], &[because("a.rs: two"), because("a.rs: gone")]);
        assert_eq!(
            (mutation.mutants, mutation.caught, mutation.survivors.len()),
            (4, 1, 1)
        );
        assert_eq!(faults.len(), 3, "{faults:?}");
    }

    #[test]
    fn a_second_run_has_the_last_word() {
        let first = [
            ("a.rs:1:1: one", "CaughtMutant"),
            ("a.rs:2:1: two", "MissedMutant"),
            ("a.rs:3:1: three", "MissedMutant"),
        ];
        let second = [
            ("a.rs:2:1: two", "CaughtMutant"),
            ("a.rs:3:1: three", "MissedMutant"),
        ];
        let runs = [run_of("first-run", &first), run_of("second-run", &second)];
        let (mutation, faults) = judged(&runs, &[because("a.rs: three")]);
        assert_eq!((mutation.mutants, mutation.caught), (3, 2));
        assert!(faults.is_empty(), "{faults:?}");
    }
}
