//! From claims to code and back: ids in doc comments, items of the kernel, names of tests.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::record::Engine;

/// Beginnings of the ids of claims.
const KINDS: [&str; 4] = ["EQ-", "ERR-", "TH-", "NUM-"];

/// The ids that a text mentions, as they are written.
///
/// # Example
///
/// ```
/// let ids = passivity_evidence::trace::ids("Equal to (19), see EQ-19/20, and TH-LIN.");
/// assert_eq!(ids, ["EQ-19/20", "TH-LIN"]);
/// assert_eq!(passivity_evidence::trace::ids("the record `TH-LIN/smt`"), ["TH-LIN"]);
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
/// A sentence, when a file or folder can't be read.
pub fn in_doc_comments(folder: &Path) -> Result<BTreeMap<String, BTreeSet<String>>, String> {
    let mut found: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for path in rust_files(folder)? {
        let name = path
            .strip_prefix(folder)
            .unwrap_or(&path)
            .display()
            .to_string();
        for line in crate::read(&path)?.lines() {
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
/// A sentence, when a folder can't be read.
pub fn rust_files(folder: &Path) -> Result<Vec<std::path::PathBuf>, String> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let entries =
            std::fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        for entry in entries {
            let path = entry
                .map_err(|e| format!("{}: {e}", folder.display()))?
                .path();
            let name = path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            if path.is_dir() && name != "target" && !name.starts_with('.') {
                folders.push(path);
            } else if name.ends_with(".rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Whether the source of a module declares an item: `Row::violates_linear` needs both the type and
/// the function.
#[must_use]
pub fn declares(source: &str, item: &str) -> bool {
    let words = ["fn", "struct", "enum", "trait", "type", "const", "const fn"];
    item.split("::").all(|name| {
        words.iter().any(|word| {
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
