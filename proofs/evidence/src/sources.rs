//! The files that engines read, in the tree as it is or as a commit has it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_evidence::{EvidenceError, Sha256};

/// Where the files of a run are looked up.
pub(crate) struct Sources {
    root: PathBuf,
    commit: Option<String>,
}

impl Sources {
    /// The files of the tree as they are now, or as they were at a commit.
    pub(crate) fn new(root: &Path, commit: Option<String>) -> Self {
        Self {
            root: root.to_owned(),
            commit,
        }
    }

    /// The bytes of a file.
    pub(crate) fn bytes(&self, path: &str) -> Result<Vec<u8>, EvidenceError> {
        match &self.commit {
            None => {
                let file = self.root.join(path);
                std::fs::read(&file).map_err(|error| EvidenceError::io(&file, &error))
            }
            Some(commit) => self.git(&["show", &format!("{commit}:{path}")]),
        }
    }

    /// The SHA-256 of a file.
    pub(crate) fn sum(&self, path: &str) -> Result<Sha256, EvidenceError> {
        Ok(Sha256::of(&self.bytes(path)?))
    }

    /// The text of a file.
    pub(crate) fn text(&self, path: &str) -> Result<String, EvidenceError> {
        String::from_utf8(self.bytes(path)?).map_err(|error| EvidenceError::within(path, error))
    }

    /// The files under a folder, from the root, in order.
    pub(crate) fn under(&self, folder: &str) -> Result<BTreeSet<String>, EvidenceError> {
        if let Some(commit) = &self.commit {
            let list = self.git(&[
                "ls-tree",
                "-r",
                "--name-only",
                commit,
                &format!("{folder}/"),
            ])?;
            let list = String::from_utf8(list).map_err(|e| EvidenceError::within(folder, e))?;
            return Ok(list.lines().map(str::to_owned).collect());
        }
        let mut files = BTreeSet::new();
        let mut folders = vec![folder.to_owned()];
        while let Some(folder) = folders.pop() {
            let path = self.root.join(&folder);
            let failed = |error| EvidenceError::io(&path, &error);
            for entry in std::fs::read_dir(&path).map_err(failed)? {
                let entry = entry.map_err(failed)?;
                let name = format!("{folder}/{}", entry.file_name().to_string_lossy());
                if entry.file_type().map_err(failed)?.is_dir() {
                    folders.push(name);
                } else {
                    files.insert(name);
                }
            }
        }
        Ok(files)
    }

    fn git(&self, arguments: &[&str]) -> Result<Vec<u8>, EvidenceError> {
        let words = || format!("git {}", arguments.join(" "));
        let output = Command::new("git")
            .args(arguments)
            .current_dir(&self.root)
            .output()
            .map_err(|error| EvidenceError::within(&words(), error))?;
        if output.status.success() {
            return Ok(output.stdout);
        }
        let errors = String::from_utf8_lossy(&output.stderr);
        Err(EvidenceError::within(&words(), errors.trim()))
    }
}
