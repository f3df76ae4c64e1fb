//! The source tree that a case is about: where it is, its commit, and the hashes of its files.

use std::path::{Path, PathBuf};

/// The file that marks the root of the tree.
pub const CLAIMS: &str = passivity_evidence::Claims::PATH;

/// The nearest folder, from `from` up, that holds the claims.
#[must_use]
pub fn find_root(from: &Path) -> Option<PathBuf> {
    from.ancestors()
        .find(|folder| folder.join(CLAIMS).is_file())
        .map(Path::to_owned)
}

/// The commit that is checked out in `root`, read from git's own files; `None` when there is none
/// or it is stored in a way that this does not read.
#[must_use]
pub fn commit(root: &Path) -> Option<String> {
    let git = root.join(".git");
    let head = std::fs::read_to_string(git.join("HEAD")).ok()?;
    let head = head.trim();
    let Some(name) = head.strip_prefix("ref: ") else {
        return is_commit(head).then(|| head.to_owned());
    };
    if let Ok(commit) = std::fs::read_to_string(git.join(name)) {
        let commit = commit.trim();
        return is_commit(commit).then(|| commit.to_owned());
    }
    let packed = std::fs::read_to_string(git.join("packed-refs")).ok()?;
    let line = packed
        .lines()
        .find(|line| line.ends_with(&format!(" {name}")))?;
    let commit = line.split(' ').next()?;
    is_commit(commit).then(|| commit.to_owned())
}

fn is_commit(text: &str) -> bool {
    text.len() >= 40 && text.bytes().all(|b| b.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_hexadecimal_names_are_commits() {
        assert!(is_commit(&"a1".repeat(20)));
        assert!(!is_commit("ref: refs/heads/main"));
        assert!(!is_commit(&"z".repeat(40)));
    }
}
