//! Files that are written, with the protections of the command.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

/// Refuses to write over what is read, and over what is no plain file: a device, a pipe, a folder, or a link.
pub(crate) fn may_be_written(output: &Path, inputs: &[&Path]) -> PyResult<()> {
    let refuse = |why: &str| {
        Err(PyValueError::new_err(format!(
            "{}: {why}",
            output.display()
        )))
    };
    // What does not exist yet is no input, and nothing that is lost.
    let Ok(there) = output.symlink_metadata() else {
        return Ok(());
    };
    let same = |input: &&Path| match (output.canonicalize(), input.canonicalize()) {
        (Ok(output), Ok(input)) => output == input,
        _ => false,
    };
    if inputs.iter().any(same) {
        return refuse("is read, and cannot be written");
    }
    if there.is_symlink() {
        return refuse("is a symbolic link: give the name of the file itself");
    }
    match there.is_file() {
        true => Ok(()),
        false => refuse("is no plain file, and is not replaced"),
    }
}

/// Where rows are written.
pub(crate) fn rows_file(
    path: Option<PathBuf>,
    inputs: &[&Path],
) -> PyResult<Option<BufWriter<File>>> {
    let Some(path) = path else {
        return Ok(None);
    };
    may_be_written(&path, inputs)?;
    let file = File::create(&path)
        .map_err(|error| PyOSError::new_err(format!("{}: {error}", path.display())))?;
    Ok(Some(BufWriter::new(file)))
}
