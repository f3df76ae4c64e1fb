//! The sources as they are at a commit, from `git`.

use std::path::Path;
use std::process::Command;

/// The sources of a commit.
pub(crate) struct Sources<'a> {
    root: &'a Path,
    /// All 40 digits of its name.
    pub(crate) commit: String,
}

impl<'a> Sources<'a> {
    /// The sources of a commit of the repository at `root`.
    pub(crate) fn of(root: &'a Path, commit: &str) -> Result<Self, String> {
        let found = git(
            root,
            &[
                "rev-parse",
                "--verify",
                "--quiet",
                "--end-of-options",
                &format!("{commit}^{{commit}}"),
            ],
        )
        .map_err(|_| format!("`{commit}` is no commit of this repository"))?;
        let commit = found.trim().to_string();
        Ok(Self { root, commit })
    }

    /// The text of a file.
    pub(crate) fn read(&self, path: &str) -> Result<String, String> {
        git(self.root, &["show", &format!("{}:{path}", self.commit)])
            .map_err(|why| format!("`{path}` of that commit can't be read: {why}"))
    }
}

/// The commit of the tree here, and whether the tree has changes; `unknown` without `git`.
pub(crate) fn here() -> String {
    let root = crate::root();
    let commit = git(&root, &["rev-parse", "HEAD"]);
    let changes = git(&root, &["status", "--porcelain"]);
    match (commit, changes) {
        (Ok(commit), Ok(changes)) if changes.is_empty() => commit.trim().to_string(),
        (Ok(commit), Ok(_)) => format!("{}, with changes", commit.trim()),
        _ => "unknown".to_string(),
    }
}

fn git(root: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("git")
        .arg("-C")
        .arg(root)
        .args(arguments)
        .output()
        .map_err(|e| format!("`git` can't be run: {e}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).trim().to_string());
    }
    String::from_utf8(output.stdout).map_err(|_| "it is not text".to_string())
}
