//! What names are of: the same file, or something that is not replaced.

use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

/// Whether two names are of one file: by links of either kind, or, where neither is there yet, in the same folder.
///
/// ```
/// use passivity_scene::files::are_same;
///
/// assert!(are_same("Cargo.toml".as_ref(), "./src/../Cargo.toml".as_ref()));
/// assert!(are_same("new.csv".as_ref(), "src/../new.csv".as_ref()));
/// assert!(!are_same("new.csv".as_ref(), "src/new.csv".as_ref()));
/// ```
#[must_use]
pub fn are_same(one: &Path, other: &Path) -> bool {
    match (identity(one), identity(other)) {
        (Some(one), Some(other)) => one == other,
        (None, None) => one == other || (place(one).is_some() && place(one) == place(other)),
        _ => false,
    }
}

/// What a file has whatever it is called; `None` where there is none.
#[cfg(unix)]
fn identity(path: &Path) -> Option<(u64, u64)> {
    use std::os::unix::fs::MetadataExt as _;
    let there = path.metadata().ok()?;
    Some((there.dev(), there.ino()))
}

/// The one name that a file has, but for hard links; `None` where there is none.
#[cfg(not(unix))]
fn identity(path: &Path) -> Option<PathBuf> {
    path.canonicalize().ok()
}

/// Where a file will be that is not there yet.
fn place(path: &Path) -> Option<PathBuf> {
    Some(folder(path)?.canonicalize().ok()?.join(path.file_name()?))
}

/// The folder of a file.
pub(crate) fn folder(path: &Path) -> Option<&Path> {
    let folder = path.parent()?;
    Some(match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    })
}

/// Says whether a file may take a name.
///
/// # Errors
///
/// A name that no file can have, `-`, which stands for standard input or output elsewhere, and one of what is no plain
/// file: a device, a pipe, a folder, or a link to whatever it may be.
pub fn may_be_replaced(path: &Path) -> io::Result<()> {
    let refuse = |why: &str| Err(io::Error::new(io::ErrorKind::InvalidInput, why));
    let ends_a_folder = |c: char| std::path::is_separator(c);
    if path.file_name().is_none() || path.to_string_lossy().ends_with(ends_a_folder) {
        return refuse("expected the name of a file");
    }
    if path.as_os_str() == "-" {
        return refuse(
            "is not standard output here: expected the name of a file, or `./-` for one that is called so",
        );
    }
    match path.symlink_metadata() {
        Ok(there) if there.is_symlink() => {
            refuse("is a symbolic link: give the name of the file itself")
        }
        Ok(there) if !there.is_file() => refuse("is no plain file, and is not replaced"),
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        // What does not exist yet is nothing that is lost.
        Ok(_) | Err(_) => Ok(()),
    }
}

/// Refuses to write CSV under a name that ends like another format's, or like a compressed file's.
///
/// # Errors
///
/// The name, and the ending that is expected.
///
/// # Example
///
/// ```
/// let error = passivity_scene::files::csv_name("rows.csv.gz".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "`rows.csv.gz`: these rows are CSV: expected a name that ends in .csv");
/// ```
pub fn csv_name(path: &Path) -> io::Result<()> {
    const OTHERS: [&str; 17] = [
        "parquet", "mcap", "json", "jsonl", "arrow", "feather", "h5", "mat", "npy", "npz", "xlsx",
        "gz", "zst", "bz2", "xz", "lz4", "zip",
    ];
    let is_other = |end: &OsStr| OTHERS.iter().any(|other| end.eq_ignore_ascii_case(other));
    match path.extension().is_some_and(is_other) {
        true => Err(io::Error::other(format!(
            "`{}`: these rows are CSV: expected a name that ends in .csv",
            path.display()
        ))),
        false => Ok(()),
    }
}
