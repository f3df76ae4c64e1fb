//! Files that are there whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use crate::error::SimError;

pub(super) fn failed(path: &Path, error: &dyn std::fmt::Display) -> SimError {
    SimError::File(format!("`{}`: {error}", path.display()))
}

pub(super) fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

/// Refuses to write to what is no plain file.
pub(super) fn plain(path: &Path) -> Result<(), SimError> {
    match path.symlink_metadata() {
        Ok(there) if !there.is_file() => {
            Err(failed(path, &"is no plain file, and is not replaced"))
        }
        // What does not exist yet is nothing that is lost.
        _ => Ok(()),
    }
}

/// Writes a small file whole: beside it first, on the disk, and then in its place.
pub(super) fn write_whole(path: &Path, text: &str) -> io::Result<()> {
    let beside = with_suffix(path, ".tmp");
    let mut file = File::create(&beside)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    drop(file);
    put_in_place(&beside, path)
}

/// Gives a file that is on the disk its name, in place of what had it.
pub(super) fn put_in_place(beside: &Path, path: &Path) -> io::Result<()> {
    fs::rename(beside, path)?;
    sync_folder(path)
}

/// Brings a new name in a folder to the disk, where folders can be opened.
fn sync_folder(path: &Path) -> io::Result<()> {
    #[cfg(unix)]
    if let Some(folder) = path.parent() {
        let folder = match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        };
        File::open(folder)?.sync_all()?;
    }
    #[cfg(not(unix))]
    let _ = path;
    Ok(())
}
