//! Names of the files of a sweep, and errors that name them.

use std::fs::File;
use std::io::{ErrorKind, Read as _};
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

/// Why a file beside a sweep that no sweep wrote is not replaced.
pub(super) const BESIDE: &str = "a sweep writes a file of this name beside its own, and would lose this one, which no sweep \
                                 wrote: move it away, or give another --out";

/// Why one where the rows are to be is not replaced.
pub(super) const OTHER: &str = "the rows of a sweep would take the place of this file, which no sweep wrote: move it away, or \
                                give another --out";

/// Refuses, and says why, to lose a file which does not begin as that of a sweep does. An empty one is no loss.
pub(super) fn is_own(
    path: &Path,
    why: &str,
    begins: impl Fn(&[u8]) -> bool,
) -> Result<(), SimError> {
    // As much as a header may have.
    const START: u64 = 1 << 16;
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(START).read_to_end(&mut start));
    match read {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(()),
        Err(error) => Err(failed(path, &error)),
        Ok(_) if start.is_empty() || begins(&start) => Ok(()),
        Ok(_) => Err(failed(path, &why)),
    }
}
