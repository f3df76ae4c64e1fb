//! Names of the files of a sweep, and errors that name them.

use std::path::{Path, PathBuf};

use passivity_scene::files::may_be_replaced;

use crate::error::SimError;

pub(super) fn failed(path: &Path, error: &dyn std::fmt::Display) -> SimError {
    SimError::File(format!("`{}`: {error}", path.display()))
}

pub(super) fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

/// The files that a sweep makes beside its own, or removes: whose rows these are, the rows on the way to a Parquet
/// file, and which shard it is.
#[must_use]
pub fn side_files(path: &Path) -> [PathBuf; 3] {
    [RUN, ROWS, MANIFEST].map(|suffix| with_suffix(path, suffix))
}

pub(super) const RUN: &str = ".run";
pub(super) const ROWS: &str = ".rows";
pub(super) const MANIFEST: &str = ".manifest";

/// Refuses to write to what is no plain file.
pub(super) fn plain(path: &Path) -> Result<(), SimError> {
    may_be_replaced(path).map_err(|error| failed(path, &error))
}
