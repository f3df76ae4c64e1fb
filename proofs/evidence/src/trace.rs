//! From claims to code and back: ids in doc comments, items of the kernel, names of tests.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use passivity_evidence::{Claim, Claims, Engine, EvidenceError, read};

/// Beginnings of the ids of claims.
const KINDS: [&str; 5] = ["CHECK-", "EQ-", "ERR-", "TH-", "NUM-"];

/// The ids that a text mentions, as they are written.
///
/// # Example
///
/// ```
/// let ids = passivity_collect::trace::ids("Equal to (19), see EQ-19/20, and TH-LIN.");
/// assert_eq!(ids, ["EQ-19/20", "TH-LIN"]);
/// assert_eq!(passivity_collect::trace::ids("the record `TH-LIN/smt`"), ["TH-LIN"]);
/// ```
#[must_use]
pub fn ids(text: &str) -> Vec<String> {
    let part_of_id = |c: char| c.is_ascii_alphanumeric() || "-/.".contains(c);
    let mut found = Vec::new();
    for word in text.split(|c: char| !part_of_id(c)) {
        let word = word.trim_end_matches(['.', '-', '/']);
        if KINDS
            .iter()
            .any(|kind| word.strip_prefix(kind).is_some_and(|rest| !rest.is_empty()))
        {
            // A record is named by claim and engine.
            let record = Engine::ALL
                .iter()
                .find_map(|e| word.strip_suffix(e.name())?.strip_suffix('/'));
            found.push(record.unwrap_or(word).to_owned());
        }
    }
    found
}

/// The ids in the doc comments of the Rust sources under a folder, and the files that have them.
///
/// # Errors
///
/// A file or folder that cannot be read.
pub fn in_doc_comments(folder: &Path) -> Result<BTreeMap<String, BTreeSet<String>>, EvidenceError> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in rust_files(folder)? {
        let name = path.display().to_string();
        for line in read(&path)?.lines() {
            let line = line.trim_start();
            if line.starts_with("//!") || line.starts_with("///") {
                for id in ids(line) {
                    found.entry(id).or_default().insert(name.clone());
                }
            }
        }
    }
    Ok(found)
}

/// The Rust files under a folder, outside of `target`.
///
/// # Errors
///
/// A folder that cannot be read.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>, EvidenceError> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let failed = |error| EvidenceError::io(&folder, &error);
        for entry in std::fs::read_dir(&folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            let name = path.file_name().map(|name| name.to_string_lossy());
            let hidden = name.is_none_or(|name| name == "target" || name.starts_with('.'));
            if path.is_dir() && !hidden {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Whether the source of a module declares an item: `Row::violates_linear` needs both the type, or
/// an `impl` of it, and the function.
#[must_use]
pub fn declares(source: &str, item: &str) -> bool {
    let words = ["fn", "struct", "enum", "trait", "type", "const", "const fn"];
    let implemented = |name: &str| {
        let generic = format!(" {name}<");
        source
            .lines()
            .any(|line| line.starts_with("impl") && line.contains(&generic))
    };
    item.split("::").all(|name| {
        implemented(name)
            || words.iter().any(|word| {
                source
                    .match_indices(&format!("{word} {name}"))
                    .any(|(at, found)| {
                        let after = source
                            .get(at + found.len()..)
                            .and_then(|rest| rest.chars().next());
                        after.is_none_or(|c| !c.is_alphanumeric() && c != '_')
                    })
            })
    })
}

/// The claims that the name of a test, a harness or a query begins with: one after the other.
///
/// # Example
///
/// ```
/// use passivity_collect::{root, trace::named};
///
/// let claims = passivity_evidence::Claims::read(&root()).unwrap();
/// assert_eq!(named(&claims, "th_dac_th_delay_combined"), ["TH-DAC", "TH-DELAY"]);
/// assert_eq!(named(&claims, "err_19_start_counterexample"), ["ERR-19-start"]);
/// ```
#[must_use]
pub fn named(claims: &Claims, name: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut rest = name;
    while let Some((claim, after)) = claims.claims.iter().find_map(|claim| {
        let after = rest.strip_prefix(&in_names(claim))?;
        (after.is_empty() || after.starts_with('_')).then_some((claim, after))
    }) {
        found.push(claim.id.clone());
        rest = after.trim_start_matches('_');
    }
    found
}

/// The id of a claim as names have it: `th_lin`, `eq_23_26`.
#[must_use]
pub fn in_names(claim: &Claim) -> String {
    claim
        .id
        .to_lowercase()
        .replace("..", "_")
        .replace(['-', '/'], "_")
}
