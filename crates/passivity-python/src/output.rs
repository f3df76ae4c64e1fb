//! Files that are written, with the protections of the command.

use std::path::{Path, PathBuf};

use passivity_scene::files::{Output, are_same, csv_name, may_be_replaced};

use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

/// Refuses to write over what is read, and over what is no plain file: a device, a pipe, a folder, or a link.
pub(crate) fn may_be_written(output: &Path, inputs: &[&Path]) -> PyResult<()> {
    let refused = |why: &str| PyValueError::new_err(format!("{}: {why}", output.display()));
    // What does not exist yet is no input.
    if output.exists() && inputs.iter().any(|input| are_same(output, input)) {
        return Err(refused("is read, and cannot be written"));
    }
    may_be_replaced(output).map_err(|error| refused(&error.to_string()))
}

/// Refuses, before any work is done, what [`may_be_written`] does and a name under which no file can be made, as
/// in a folder that is not there.
pub(crate) fn can_be_written(output: &Path, inputs: &[&Path]) -> PyResult<()> {
    may_be_written(output, inputs)?;
    let made = Output::create(output);
    made.map(drop).map_err(|error| failed(output, &error))
}

/// Where rows are written.
pub(crate) fn rows_file(path: Option<PathBuf>, inputs: &[&Path]) -> PyResult<Option<Rows>> {
    let Some(path) = path else {
        return Ok(None);
    };
    csv_name(&path).map_err(|error| PyValueError::new_err(error.to_string()))?;
    may_be_written(&path, inputs)?;
    let file = Output::create(&path).map_err(|error| failed(&path, &error))?;
    Ok(Some(Rows { path, file }))
}

/// Rows that are written, and where they will be.
pub(crate) struct Rows {
    path: PathBuf,
    pub(crate) file: Output,
}

impl Rows {
    /// Gives the file its name, in place of what had it.
    pub(crate) fn keep(self) -> PyResult<()> {
        let Self { path, file } = self;
        file.keep().map_err(|error| failed(&path, &error))
    }
}

fn failed(path: &Path, error: &std::io::Error) -> PyErr {
    PyOSError::new_err(format!("{}: {error}", path.display()))
}
