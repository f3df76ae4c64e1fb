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
    survivor: Vec<Group>,
}

/// Survivors that make no difference for the same reason.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    mutants: Vec<String>,
    reason: String,
}

/// The survivors that are known, and why nothing can notice them.
///
/// # Errors
///
/// A list that cannot be read.
pub fn explained(root: &Path) -> Result<Vec<Survivor>, EvidenceError> {
    let list: Explained = toml::from_str(&read(&root.join(EXPLAINED))?)
        .map_err(|error| EvidenceError::within(EXPLAINED, error))?;
    let each = |group: Group| {
        let Group { mutants, reason } = group;
        let of = move |mutant| Survivor {
            mutant,
            reason: reason.clone(),
        };
        mutants.into_iter().map(of)
    };
    Ok(list.survivor.into_iter().flat_map(each).collect())
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

/// Reads what a run left in a folder. Also gives what is wrong: survivors that nobody explained, and
/// explanations of mutants that were noticed.
///
/// # Errors
///
/// A folder that is not that of a finished run.
pub fn judge(
    root: &Path,
    folder: &Path,
    explained: &[Survivor],
) -> Result<(Mutation, Vec<String>), EvidenceError> {
    let mut all = Run::default();
    all.read(&folder.join("outcomes.json"))?;
    let caught = all.noticed.values().filter(|noticed| **noticed).count();
    if caught == 0 {
        let message = "no mutant was noticed: the run is not one";
        return Err(EvidenceError::new(message));
    }
    let (survivors, open, mut faults) = all.survivors(explained);
    let nobody = open.iter();
    faults.extend(nobody.map(|name| format!("survived, and nobody says why: {name}")));
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
        open,
        unviable: all.unviable,
        left_out: all.left_out,
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
    #[serde(default)]
    left_out: Vec<String>,
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

/// What became of each mutant.
#[derive(Default)]
struct Run {
    /// Whether a test noticed it.
    noticed: BTreeMap<String, bool>,
    files: BTreeSet<String>,
    seconds: f64,
    version: Option<String>,
    unviable: u64,
    left_out: Vec<String>,
}

impl Run {
    fn read(&mut self, path: &Path) -> Result<(), EvidenceError> {
        let name = path.display().to_string();
        let run: Outcomes = serde_json::from_str(&read(path)?)
            .map_err(|error| EvidenceError::within(&name, error))?;
        if run.end_time.is_none() {
            return Err(EvidenceError::within(&name, "the run was not finished"));
        }
        self.version = run.cargo_mutants_version;
        self.left_out = run.left_out;
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
                Summary::Unviable => {
                    self.unviable += 1;
                    continue;
                }
                Summary::Success | Summary::Failure => {
                    let what = format!("`{mutant}` came to no end that is known");
                    return Err(EvidenceError::within(&name, what));
                }
            };
            self.noticed.insert(mutant, noticed);
        }
        Ok(())
    }

    /// The survivors with their reasons, those without, and reasons that are not needed.
    fn survivors(&self, explained: &[Survivor]) -> (Vec<Survivor>, Vec<String>, Vec<String>) {
        let missed = self.noticed.iter().filter(|(_, noticed)| !**noticed);
        let survived: BTreeSet<String> = missed.map(|(name, _)| without_line(name)).collect();
        let known: BTreeMap<&str, &Survivor> = explained
            .iter()
            .map(|survivor| (survivor.mutant.as_str(), survivor))
            .collect();
        let mut survivors = Vec::new();
        let mut open = Vec::new();
        for name in &survived {
            match known.get(name.as_str()) {
                Some(survivor) => survivors.push((*survivor).clone()),
                None => open.push(name.clone()),
            }
        }
        let idle = known.keys().filter(|name| !survived.contains(**name));
        let idle = idle.map(|name| format!("explained, but it was noticed or is gone: {name}"));
        (survivors, open, idle.collect())
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

    fn judged(run: &Path, explained: &[Survivor]) -> (Mutation, Vec<String>) {
        let judged = judge(&crate::root(), run, explained).unwrap();
        std::fs::remove_dir_all(run).unwrap();
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
        let (mutation, faults) = judged(&run, &[because("a.rs: two"), because("a.rs: gone")]);
        assert_eq!(
            (mutation.mutants, mutation.caught, mutation.survivors.len()),
            (4, 1, 1)
        );
        assert_eq!(
            (mutation.open.len(), mutation.unviable, faults.len()),
            (2, 1, 3),
            "{faults:?}"
        );
    }
}
