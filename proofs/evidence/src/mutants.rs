//! What cargo-mutants found, against the committed list of survivors and their reasons.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde::Deserialize;
use serde_json::Value;

use crate::record::{Mutation, Survivor, sha256};

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
/// A sentence, when the list can't be read.
pub fn explained(root: &Path) -> Result<Vec<Survivor>, String> {
    let path = root.join("proofs/mutants/explained.toml");
    let list: Explained =
        toml::from_str(&crate::read(&path)?).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(list.survivor)
}

/// Reads the folders `mutants.out` of runs, of which a later one has asked again about survivors of
/// an earlier one. Also gives what is wrong: survivors that nobody explained, and explanations of
/// mutants that were noticed.
///
/// # Errors
///
/// A sentence, when a folder is not that of a finished run.
pub fn judge(
    root: &Path,
    folders: &[&Path],
    explained: &[Survivor],
) -> Result<(Mutation, Vec<String>), String> {
    let mut all = Runs::default();
    for folder in folders {
        all.read(&folder.join("outcomes.json"))?;
    }
    let caught = all.noticed.values().filter(|noticed| **noticed).count();
    if caught == 0 {
        return Err("no mutant was noticed: the run is not one".to_owned());
    }
    let survived: BTreeSet<String> = all
        .noticed
        .iter()
        .filter(|(_, noticed)| !**noticed)
        .map(|(name, _)| without_line(name))
        .collect();
    let known: BTreeMap<&str, &Survivor> = explained
        .iter()
        .map(|survivor| (survivor.mutant.as_str(), survivor))
        .collect();
    let mut faults = Vec::new();
    let mut survivors = Vec::new();
    for name in &survived {
        match known.get(name.as_str()) {
            Some(survivor) => survivors.push((*survivor).clone()),
            None => faults.push(format!("survived, and nobody says why: {name}")),
        }
    }
    for name in known.keys().filter(|name| !survived.contains(**name)) {
        faults.push(format!("explained, but it was noticed or is gone: {name}"));
    }
    let hash = |file: &String| {
        let source = crate::read(&root.join(file))?;
        Ok((file.clone(), sha256(source.as_bytes())))
    };
    let sources: Result<BTreeMap<String, String>, String> = all.files.iter().map(hash).collect();
    let count = |number: usize| u64::try_from(number).unwrap_or(u64::MAX);
    let mutation = Mutation {
        tool: format!("cargo-mutants {}", all.version),
        files: all.files.into_iter().collect(),
        mutants: count(all.noticed.len()),
        caught: count(caught),
        survivors,
        seconds: all.seconds.round(),
        sources: sources?,
    };
    Ok((mutation, faults))
}

/// What runs of cargo-mutants said, the last word on each mutant that compiles.
#[derive(Default)]
struct Runs {
    /// Whether a test noticed it.
    noticed: BTreeMap<String, bool>,
    files: BTreeSet<String>,
    seconds: f64,
    version: String,
}

impl Runs {
    fn read(&mut self, path: &Path) -> Result<(), String> {
        let bad = |what: &str| format!("{}: {what}", path.display());
        let run: Value =
            serde_json::from_str(&crate::read(path)?).map_err(|e| bad(&e.to_string()))?;
        if run["end_time"].is_null() {
            return Err(bad("the run was not finished"));
        }
        let version = run["cargo_mutants_version"].as_str();
        self.version = version.unwrap_or("of unknown version").to_owned();
        for outcome in run["outcomes"]
            .as_array()
            .ok_or_else(|| bad("no outcomes"))?
        {
            let phases = outcome["phase_results"].as_array();
            let phases = phases.map_or(&[][..], Vec::as_slice);
            let durations = phases.iter().filter_map(|phase| phase["duration"].as_f64());
            self.seconds += durations.sum::<f64>();
            let mutant = &outcome["scenario"]["Mutant"];
            let Some(name) = mutant["name"].as_str() else {
                continue;
            };
            let file = mutant["file"].as_str();
            let file = file.ok_or_else(|| bad("a mutant has no file"))?;
            self.files.insert(file.to_owned());
            let noticed = match outcome["summary"].as_str() {
                Some("CaughtMutant" | "Timeout") => true,
                Some("MissedMutant") => false,
                Some("Unviable") => continue,
                other => return Err(bad(&format!("`{name}` ended as {other:?}"))),
            };
            self.noticed.insert(name.to_owned(), noticed);
        }
        Ok(())
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
            ],
        );
        let (mutation, faults) = judged(&[run], &[because("a.rs: two"), because("a.rs: gone")]);
        assert_eq!(
            (mutation.mutants, mutation.caught, mutation.survivors.len()),
            (3, 1, 1)
        );
        assert_eq!(faults.len(), 2, "{faults:?}");
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
