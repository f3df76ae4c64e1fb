//! The source tree that a case is about: where it is, its commit, and the hashes of its files.

use std::path::{Path, PathBuf};

use sha2::{Digest as _, Sha256};

/// The file that marks the root of the tree.
pub const CLAIMS: &str = "proofs/claims.toml";

/// SHA-256 in lower-case hexadecimal digits.
///
/// # Example
///
/// ```
/// use passivity_case::tree::sha256;
///
/// assert!(sha256(b"").starts_with("e3b0c44298fc1c14"));
/// ```
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

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
    fn hashes_are_those_of_the_standard() {
        // FIPS 180-2, example B.1.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(sha256(b"abc"), expected);
    }

    #[test]
    fn only_hexadecimal_names_are_commits() {
        assert!(is_commit(&"a1".repeat(20)));
        assert!(!is_commit("ref: refs/heads/main"));
        assert!(!is_commit(&"z".repeat(40)));
    }
}
