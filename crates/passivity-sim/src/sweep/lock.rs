//! The file beside a sweep that says whose rows these are, held by one process at a time.
//!
//! It is locked for as long as its process lives: the system gives the lock back however that ends. Where a file
//! system has no locks, a sweep goes on without one.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read as _, Seek as _, Write as _};
use std::path::{Path, PathBuf};

use passivity_scene::files::sync_folder;

use crate::error::SimError;
use crate::sweep::disk::{BESIDE, failed};

/// How it begins, whichever sweep it is of.
const SWEEP: &[u8] = b"passivity sweep ";

/// The file, and that no other process has it.
#[derive(Debug)]
pub(super) struct Lock {
    mark: PathBuf,
    file: File,
}

impl Lock {
    /// Locks the file `mark` of the sweep whose rows go to `path`. An empty one is made where there is none, and is
    /// removed in the end if it is empty still.
    pub(super) fn take(path: &Path, mark: &Path) -> Result<Self, SimError> {
        let wrong = |error: io::Error| failed(mark, &error);
        let mut options = OpenOptions::new();
        options.read(true).write(true).create(true).truncate(false);
        loop {
            let file = options.open(mark).map_err(wrong)?;
            if let Err(TryLockError::WouldBlock) = file.try_lock() {
                let message =
                    "another process is writing this file: wait for it, or give another --out";
                return Err(failed(path, &message));
            }
            // The process that had it may have removed it before it was locked here.
            if has_name(&file, mark).map_err(wrong)? {
                let mark = mark.to_owned();
                return Ok(Self { mark, file });
            }
        }
    }

    /// What it says, if it is the file of a sweep.
    pub(super) fn read(&mut self) -> Result<String, SimError> {
        let mut text = Vec::new();
        let read = self.file.rewind();
        let read = read.and_then(|()| self.file.read_to_end(&mut text));
        read.map_err(|error| failed(&self.mark, &error))?;
        // One that was being written may not say all.
        match text.starts_with(SWEEP) || SWEEP.starts_with(&text) {
            true => Ok(String::from_utf8_lossy(&text).into_owned()),
            false => Err(failed(&self.mark, &BESIDE)),
        }
    }

    /// Has it say this, on the disk.
    pub(super) fn write(&mut self, text: &str) -> Result<(), SimError> {
        let file = &mut self.file;
        let written = file.set_len(0).and_then(|()| file.rewind());
        let written = written.and_then(|()| file.write_all(text.as_bytes()));
        let written = written.and_then(|()| file.sync_all());
        let written = written.and_then(|()| sync_folder(&self.mark));
        written.map_err(|error| failed(&self.mark, &error))
    }

    /// Removes it: the sweep is finished.
    pub(super) fn remove(self) -> Result<(), SimError> {
        fs::remove_file(&self.mark).map_err(|error| failed(&self.mark, &error))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if self.file.metadata().is_ok_and(|there| there.len() == 0) {
            // What stays is empty, and does no harm.
            let _ = fs::remove_file(&self.mark);
        }
    }
}

/// Whether a file that was opened is the one that has this name now.
#[cfg(unix)]
fn has_name(file: &File, path: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt as _;
    let own = file.metadata()?;
    Ok(fs::metadata(path).is_ok_and(|there| (there.dev(), there.ino()) == (own.dev(), own.ino())))
}

/// Elsewhere a file that is open keeps its name.
#[cfg(not(unix))]
fn has_name(_: &File, _: &Path) -> io::Result<bool> {
    Ok(true)
}
