//! How results are written, by whatever crate: whole or not at all.
//!
//! A file is made beside the one that it is to be, under a name that nobody else has, brought to the disk, and given
//! its name at the end. What had the name before stays until then, and stays for good where the work is refused or
//! the process is killed. Nothing is written through a link.

mod names;

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

pub use names::{are_same, csv_name, may_be_replaced};

/// A file that has its name once it is [kept](Output::keep), and is gone if it is dropped before.
///
/// # Example
///
/// ```
/// use std::io::Write as _;
/// use passivity_scene::files::Output;
///
/// let path = std::env::temp_dir().join(format!("example-{}.csv", std::process::id()));
/// let mut file = Output::create(&path).unwrap();
/// file.write_all(b"xi\n").unwrap();
/// assert!(!path.exists());
/// file.keep().unwrap();
/// assert_eq!(std::fs::read(&path).unwrap(), b"xi\n");
/// drop(Output::create(&path).unwrap());
/// assert_eq!(std::fs::read(&path).unwrap(), b"xi\n");
/// # std::fs::remove_file(&path).unwrap();
/// ```
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    beside: PathBuf,
    file: BufWriter<File>,
    kept: bool,
}

impl Output {
    /// Many rows at once.
    const BUFFER: usize = 1 << 16;

    /// Starts a file that is to have this name.
    ///
    /// # Errors
    ///
    /// A name of what is not replaced, see [`may_be_replaced`], a file that may not be written to, or a folder in
    /// which none can be made.
    pub fn create(path: &Path) -> io::Result<Self> {
        may_be_replaced(path)?;
        let old = match path.exists() {
            true => Some(OpenOptions::new().append(true).open(path)?.metadata()?),
            false => None,
        };
        let (beside, file) = fresh(path)?;
        let output = Self {
            path: path.to_owned(),
            beside,
            file: BufWriter::with_capacity(Self::BUFFER, file),
            kept: false,
        };
        if let Some(old) = old {
            // Before there is anything to read in it: what was private stays so.
            output.file.get_ref().set_permissions(old.permissions())?;
        }
        Ok(output)
    }

    /// Gives the file its name, in place of what had it, once all of it is on the disk.
    ///
    /// # Errors
    ///
    /// What the system reports: then what had the name has it still.
    pub fn keep(mut self) -> io::Result<()> {
        self.file.flush()?;
        self.file.get_ref().sync_all()?;
        fs::rename(&self.beside, &self.path)?;
        self.kept = true;
        sync_folder(&self.path)
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }

    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        if !self.kept {
            // What stays behind has a name of its own, and does no harm.
            let _ = fs::remove_file(&self.beside);
        }
    }
}

/// Writes a file whole, in place of what had its name.
///
/// # Errors
///
/// As [`Output`]: then what had the name has it still.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let mut file = Output::create(path)?;
    file.write_all(bytes.as_ref())?;
    file.keep()
}

/// A new file in the folder of another. Its name is short, as that of the other may be as long as names can be, and
/// whatever already has it is left alone.
fn fresh(path: &Path) -> io::Result<(PathBuf, File)> {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    loop {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!(".passivity-{}-{number}.tmp", std::process::id());
        let beside = path.with_file_name(name);
        match File::create_new(&beside) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            made => return made.map(|file| (beside, file)),
        }
    }
}

/// Brings the name of a file that was made, renamed or removed to the disk, where folders can be opened.
///
/// # Errors
///
/// What the system reports.
///
/// # Example
///
/// ```
/// let path = std::env::temp_dir().join(format!("named-{}", std::process::id()));
/// std::fs::write(&path, "").unwrap();
/// passivity_scene::files::sync_folder(&path).unwrap();
/// # std::fs::remove_file(&path).unwrap();
/// ```
pub fn sync_folder(path: &Path) -> io::Result<()> {
    #[cfg(unix)]
    if let Some(folder) = names::folder(path)
        && let Ok(folder) = File::open(folder)
    {
        folder.sync_all()?;
    }
    #[cfg(not(unix))]
    let _ = path;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A new folder, and the names in it.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("files-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn what_was_there_stays_until_the_new_file_is_whole() {
        let folder = folder("whole");
        let path = folder.join("rows.csv");
        fs::write(&path, "old").unwrap();
        let mut file = Output::create(&path).unwrap();
        file.write_all(b"new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"old");
        drop(file);
        assert_eq!(fs::read(&path).unwrap(), b"old");
        write(&path, "new").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"new");
        assert_eq!(names(&folder), ["rows.csv"]);
        // As long a name as there can be.
        let long = folder.join("n".repeat(255));
        write(&long, "long").unwrap();
        assert_eq!(fs::read(&long).unwrap(), b"long");
        assert!(Output::create(&folder.join("n".repeat(256))).is_err());
        for nothing in [folder.join("new/"), folder.join(".."), PathBuf::new()] {
            assert!(Output::create(&nothing).is_err(), "{nothing:?}");
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_and_names_of_others_are_left_alone() {
        use std::os::unix::fs::{PermissionsExt as _, symlink};
        let folder = folder("links");
        let [victim, path] = ["victim", "rows.csv"].map(|name| folder.join(name));
        fs::write(&victim, "kept").unwrap();
        // Planted where the next files are to be made.
        for number in 0..50 {
            let name = format!(".passivity-{}-{number}.tmp", std::process::id());
            symlink(&victim, folder.join(name)).unwrap();
        }
        write(&path, "rows").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"rows");
        assert_eq!(fs::read(&victim).unwrap(), b"kept");
        for (link, to) in [("link", "victim"), ("nowhere", "none")] {
            symlink(folder.join(to), folder.join(link)).unwrap();
            let error = write(&folder.join(link), "rows").unwrap_err().to_string();
            assert!(error.contains("symbolic link"), "{error}");
        }
        assert_eq!(fs::read(&victim).unwrap(), b"kept");
        assert!(!folder.join("none").exists());
        // What may be read by its owner alone stays so.
        fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        write(&path, "more").unwrap();
        let mode = path.metadata().unwrap().permissions().mode();
        assert_eq!(mode & 0o777, 0o600);
        fs::remove_dir_all(folder).unwrap();
    }
}
