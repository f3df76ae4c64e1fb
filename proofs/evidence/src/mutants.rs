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

/// Reads the folder `mutants.out` of a run; also gives what is wrong with it: survivors that nobody
/// explained, and explanations of mutants that were noticed.
///
/// # Errors
///
/// A sentence, when the folder is not that of a finished run.
pub fn judge(
    root: &Path,
    folder: &Path,
    explained: &[Survivor],
) -> Result<(Mutation, Vec<String>), String> {
    let path = folder.join("outcomes.json");
    let bad = |what: &str| format!("{}: {what}", path.display());
    let run: Value = serde_json::from_str(&crate::read(&path)?).map_err(|e| bad(&e.to_string()))?;
    let outcomes = run["outcomes"]
        .as_array()
        .ok_or_else(|| bad("no outcomes"))?;
    let (mut caught, mut survived, mut files) = (0, BTreeSet::new(), BTreeSet::new());
    let mut seconds = 0.0;
    for outcome in outcomes {
        let phases = outcome["phase_results"]
            .as_array()
            .map_or(&[][..], Vec::as_slice);
        seconds += phases
            .iter()
            .filter_map(|phase| phase["duration"].as_f64())
            .sum::<f64>();
        let mutant = &outcome["scenario"]["Mutant"];
        let Some(name) = mutant["name"].as_str() else {
            continue;
        };
        files.insert(
            mutant["file"]
                .as_str()
                .ok_or_else(|| bad("a mutant has no file"))?
                .to_owned(),
        );
        match outcome["summary"].as_str() {
            Some("CaughtMutant" | "Timeout") => caught += 1,
            Some("MissedMutant") => {
                survived.insert(without_line(name));
            }
            Some("Unviable") => {}
            other => return Err(bad(&format!("`{name}` ended as {other:?}"))),
        }
    }
    if caught == 0 {
        return Err(bad("no mutant was noticed: the run is not one"));
    }
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
        Ok((
            file.clone(),
            sha256(crate::read(&root.join(file))?.as_bytes()),
        ))
    };
    let sources: Result<BTreeMap<String, String>, String> = files.iter().map(hash).collect();
    let version = run["cargo_mutants_version"]
        .as_str()
        .unwrap_or("of unknown version");
    let mutation = Mutation {
        tool: format!("cargo-mutants {version}"),
        files: files.into_iter().collect(),
        mutants: caught + u64::try_from(survived.len()).unwrap_or(u64::MAX),
        caught,
        survivors,
        seconds: seconds.round(),
        sources: sources?,
    };
    Ok((mutation, faults))
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
    use super::*;

    #[test]
    fn names_lose_their_lines() {
        let name = "crates/x/src/region.rs:12:34: replace < with <= in Region::of";
        assert_eq!(
            without_line(name),
            "crates/x/src/region.rs: replace < with <= in Region::of"
        );
    }

    #[test]
    fn an_unexplained_survivor_is_a_fault() {
        let folder = std::env::temp_dir().join(format!("passivity-mutants-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let mutant = |name: &str, summary: &str| {
            serde_json::json!({
                "scenario": {"Mutant": {"name": name, "file": "proofs/claims.toml"}},
                "summary": summary,
                "phase_results": [{"duration": 1.0}],
            })
        };
        let run = serde_json::json!({
            "cargo_mutants_version": "1",
            "outcomes": [
                {"scenario": "Baseline", "summary": "Success", "phase_results": []},
                mutant("a.rs:1:1: one", "CaughtMutant"),
                mutant("a.rs:2:1: two", "MissedMutant"),
                mutant("a.rs:3:1: three", "MissedMutant"),
            ],
        });
        std::fs::write(folder.join("outcomes.json"), run.to_string()).unwrap();
        let because = |mutant: &str| Survivor {
            mutant: mutant.into(),
            reason: "because".into(),
        };
        let (mutation, faults) = judge(
            &crate::root(),
            &folder,
            &[because("a.rs: two"), because("a.rs: gone")],
        )
        .unwrap();
        std::fs::remove_dir_all(&folder).unwrap();
        assert_eq!(
            (mutation.mutants, mutation.caught, mutation.survivors.len()),
            (3, 1, 1)
        );
        assert_eq!(faults.len(), 2, "{faults:?}");
    }
}
