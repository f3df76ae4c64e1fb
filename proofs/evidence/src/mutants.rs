//! What cargo-mutants found, against the committed list of survivors and their reasons.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_evidence::{EvidenceError, Mutation, Search, Sha256, Survivor, Tool, read};
use serde::Deserialize;

use crate::collect::counted;
use crate::sources::Sources;

/// The survivors that are known, from the root of the workspace.
const EXPLAINED: &str = "proofs/mutants/explained.toml";

/// The last mutation run, from the root of the workspace.
pub const LAST: &str = "proofs/mutants/last.json";

/// `proofs/mutants/explained.toml`: survivors that are known, and why they make no difference.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Explained {
    #[serde(default)]
    survivor: Vec<Group>,
    #[serde(default)]
    search: Vec<Searches>,
}

/// Survivors that make no difference for the same reason.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Group {
    mutants: Vec<String>,
    reason: String,
    /// Whether tests come to no end with them: it may be that one is asked first that notices them.
    #[serde(default)]
    endless: bool,
}

/// Functions that only look for a candidate, which the same code checks.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Searches {
    functions: Vec<String>,
    checked_by: String,
}

impl Explained {
    /// The list of the workspace.
    ///
    /// # Errors
    ///
    /// A list that cannot be read.
    pub fn read(root: &Path) -> Result<Self, EvidenceError> {
        toml::from_str(&read(&root.join(EXPLAINED))?)
            .map_err(|error| EvidenceError::within(EXPLAINED, error))
    }

    /// Whether a survivor is known, or changes a function that only searches; without its line.
    #[must_use]
    pub fn has(&self, mutant: &str) -> bool {
        self.reason(mutant).is_some() || self.checked_by(&function(mutant)).is_some()
    }

    fn reason(&self, mutant: &str) -> Option<&str> {
        let of = |group: &&Group| group.mutants.iter().any(|known| known == mutant);
        let group = self.survivor.iter().find(of)?;
        Some(&group.reason)
    }

    fn checked_by(&self, function: &str) -> Option<&str> {
        let of = |searches: &&Searches| searches.functions.iter().any(|known| known == function);
        let searches = self.search.iter().find(of)?;
        Some(&searches.checked_by)
    }
}

/// The file and the name of the function that a mutant changes, without its type:
/// `src/wave.rs: best_angle`.
fn function(mutant: &str) -> String {
    let (file, what) = mutant.split_once(": ").unwrap_or((mutant, ""));
    let what = what
        .rfind(" (")
        .filter(|_| what.ends_with(')'))
        .map_or(what, |at| &what[..at]);
    // `replace + with - in F`, or `replace F -> T with x`.
    let path = what.rsplit_once(" in ").map_or_else(
        || {
            let of = what.trim_start_matches("replace ");
            let end = of.find(" -> ").or_else(|| of.find(" with "));
            &of[..end.unwrap_or(of.len())]
        },
        |(_, path)| path,
    );
    let name = path.rsplit("::").next().unwrap_or_default();
    format!("{file}: {name}")
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
    explained: &Explained,
) -> Result<(Mutation, Vec<String>), EvidenceError> {
    let mut all = Run::default();
    all.read(&folder.join("outcomes.json"))?;
    let caught = all.noticed.values().filter(|noticed| **noticed).count();
    if caught == 0 {
        let message = "no mutant was noticed: the run is not one";
        return Err(EvidenceError::new(message));
    }
    let survived = all.names(|noticed| !noticed);
    let (survivors, searches, open) = sorted(&survived, explained);
    let mut faults = idle(&survived, &all.names(|_| true), explained);
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
        searches,
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

    /// The mutants, without their lines, of which it is so whether a test noticed them.
    fn names(&self, is: impl Fn(bool) -> bool) -> BTreeSet<String> {
        let mutants = self.noticed.iter().filter(|(_, noticed)| is(**noticed));
        mutants.map(|(name, _)| without_line(name)).collect()
    }
}

/// The survivors with their reasons, those of functions that only search, and those without a reason.
fn sorted(
    survived: &BTreeSet<String>,
    explained: &Explained,
) -> (Vec<Survivor>, Vec<Search>, Vec<String>) {
    let (mut survivors, mut open) = (Vec::new(), Vec::new());
    let mut searches: BTreeMap<String, Search> = BTreeMap::new();
    for mutant in survived.iter().cloned() {
        let function = function(&mutant);
        if let Some(reason) = explained.reason(&mutant) {
            let reason = reason.to_owned();
            survivors.push(Survivor { mutant, reason });
        } else if let Some(checked_by) = explained.checked_by(&function) {
            let search = searches.entry(function.clone()).or_insert_with(|| Search {
                function,
                checked_by: checked_by.to_owned(),
                survivors: Vec::new(),
            });
            search.survivors.push(mutant);
        } else {
            open.push(mutant);
        }
    }
    (survivors, searches.into_values().collect(), open)
}

/// Reasons that are not needed.
fn idle(survived: &BTreeSet<String>, all: &BTreeSet<String>, explained: &Explained) -> Vec<String> {
    let functions: BTreeSet<String> = survived.iter().map(|mutant| function(mutant)).collect();
    let gone = explained.survivor.iter().flat_map(|group| {
        let needed = if group.endless { all } else { survived };
        let mutants = group.mutants.iter();
        mutants.filter(|name| !needed.contains(*name))
    });
    let gone = gone.map(|name| format!("explained, but it was noticed or is gone: {name}"));
    let searches = explained.search.iter();
    let searches = searches.flat_map(|searches| &searches.functions);
    let whole = searches.filter(|name| !functions.contains(*name));
    let whole = whole.map(|name| format!("only searches, but no change of it survived: {name}"));
    gone.chain(whole).collect()
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

    const KNOWN: &str = r#"
        [[survivor]]
        mutants = ["a.rs: replace + with - in two", "a.rs: gone"]
        reason = "because"

        [[survivor]]
        mutants = ["a.rs: one", "a.rs: lost"]
        endless = true
        reason = "never ends"

        [[search]]
        functions = ["a.rs: guess", "a.rs: other"]
        checked_by = "`judged`"
    "#;

    #[test]
    fn functions_of_mutants() {
        for (mutant, name) in [
            ("replace + with - in harmonic (2 of 5)", "harmonic"),
            (
                "replace match guard a > 0 with true in X<S>::on_ray",
                "on_ray",
            ),
            (
                "replace X<Y<S>, S>::along_ray -> Option<Z<S>> with None",
                "along_ray",
            ),
            ("replace set with () (1 of 2)", "set"),
            ("replace .lo() with .hi() in angle", "angle"),
        ] {
            assert_eq!(
                function(&format!("a.rs: {mutant}")),
                format!("a.rs: {name}")
            );
        }
    }

    #[test]
    fn an_unexplained_survivor_is_a_fault() {
        let run = run_of(
            "one-run",
            &[
                ("a.rs:1:1: one", "CaughtMutant"),
                ("a.rs:2:1: replace + with - in two", "MissedMutant"),
                ("a.rs:3:1: three", "MissedMutant"),
                ("a.rs:4:1: four", "Unviable"),
                ("a.rs:5:1: five", "Timeout"),
                ("a.rs:6:1: replace guess -> u8 with 0", "MissedMutant"),
                ("b.rs:6:1: replace guess -> u8 with 0", "MissedMutant"),
            ],
        );
        let explained: Explained = toml::from_str(KNOWN).unwrap();
        let (mutation, faults) = judge(&crate::root(), &run, &explained).unwrap();
        std::fs::remove_dir_all(run).unwrap();
        let counts = (mutation.mutants, mutation.caught, mutation.unviable);
        assert_eq!(counts, (6, 1, 1));
        assert_eq!(mutation.survivors.len(), 1);
        assert_eq!(mutation.searches.len(), 1);
        let found = &mutation.searches[0];
        assert_eq!(
            (found.function.as_str(), found.survivors.len()),
            ("a.rs: guess", 1)
        );
        // Open: three, five and the one of b.rs; not needed: `gone`, `lost` and `other`. That `one` was noticed
        // is no fault.
        assert_eq!((mutation.open.len(), faults.len()), (3, 6), "{faults:?}");
    }
}
