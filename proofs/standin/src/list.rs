//! `harnesses.toml`: which harnesses there are, and what each of them promises.

use std::path::Path;

use serde::Deserialize;

/// The list of harnesses.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct List {
    /// The harnesses, in the order of their files.
    pub harness: Vec<Entry>,
}

/// What the list says of one harness.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Entry {
    /// File and function: `generation::th_lin_bound`.
    pub name: String,
    /// The ids of the claims it speaks of.
    pub claims: Vec<String>,
    /// Its domain in words, with bounds.
    pub domain: String,
    /// The messages of its covers.
    pub covers: Vec<String>,
    /// For a harness that must fail: the message of the assertion that fails.
    pub must_fail: Option<String>,
    /// An edit of the kernel that makes it fail (or, where it must fail, pass): file, old, new.
    pub mutation: Option<[String; 3]>,
}

/// Reads `harnesses.toml` in `folder`.
///
/// # Errors
///
/// A sentence, when the file can't be read or is not such a list.
pub fn read(folder: &Path) -> Result<List, String> {
    let path = folder.join("harnesses.toml");
    let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    parse(&text).map_err(|e| format!("{}: {e}", path.display()))
}

/// Reads the text of a `harnesses.toml`.
///
/// # Errors
///
/// A sentence, when the text is not such a list.
pub fn parse(text: &str) -> Result<List, String> {
    toml::from_str(text).map_err(|e| e.to_string())
}

impl List {
    /// The harness of that name.
    #[must_use]
    pub fn find(&self, name: &str) -> Option<&Entry> {
        self.harness.iter().find(|entry| entry.name == name)
    }
}
