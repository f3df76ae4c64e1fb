//! Audits: of files, of arrays, of pieces.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use passivity_audit::{
    Audit, Dialect, Options, Partial, Stretch, TraceError, Values, audit_columns, audit_files,
    audit_part, legible, merge_parts,
};
use pyo3::buffer::{Element, PyBuffer, ReadOnlyCell};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::output::{Rows, rows_file};
use crate::scene::{Source, of_trace};
use crate::watch::follow;

/// How a trace is read, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Reading {
    columns: Option<String>,
    delimiter: Option<String>,
    decimal_comma: bool,
    law: bool,
    threads: u16,
}

impl Reading {
    fn dialect(&self, py: Python<'_>) -> PyResult<Dialect> {
        let (columns, delimiter) = (self.columns.as_deref(), self.delimiter.as_deref());
        dialect(py, columns, delimiter, self.decimal_comma)
    }

    fn options<'a>(&self, dialect: Dialect, watch: &'a dyn Fn(u64) -> bool) -> Options<'a> {
        Options {
            law: self.law,
            threads: self.threads.into(),
            dialect,
            watch: Some(watch),
            ..Options::default()
        }
    }
}

/// How the columns of a file are called, and how its numbers are written.
pub(crate) fn dialect(
    py: Python<'_>,
    columns: Option<&str>,
    delimiter: Option<&str>,
    decimal_comma: bool,
) -> PyResult<Dialect> {
    let delimiter = match delimiter {
        None => None,
        Some("tab" | "\t") => Some(b'\t'),
        Some(text) => match text.as_bytes() {
            [byte] => Some(*byte),
            _ => return Err(PyValueError::new_err("delimiter: expected one character")),
        },
    };
    let columns = columns.map(str::parse).transpose();
    Ok(Dialect {
        columns: columns.map_err(|error| of_trace(py, &error))?,
        delimiter,
        decimal_comma,
    })
}

/// A report with its certificate, as JSON.
type Report = (String, Option<String>);

/// The error of a log, with the file that it says nothing of where that cannot be opened.
fn of_log(log: &Path) -> impl Fn(TraceError) -> TraceError {
    move |mut error| {
        if error.kind == "io" && File::open(log).is_err() {
            let (log, message) = (legible(&log.to_string_lossy()), &error.message);
            error.message = format!("`{log}`: {message}; a text is the path of a file");
            error.file = None;
        }
        error
    }
}

fn report(py: Python<'_>, audit: Result<Audit, TraceError>) -> PyResult<Report> {
    let audit = audit.map_err(|error| of_trace(py, &error))?;
    let certificate = audit.certificate().map(serde_json::to_string).transpose();
    let certificate = certificate.map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok((audit.to_json().to_string(), certificate))
}

/// The audit of a trace in files, as JSON.
#[pyfunction]
#[pyo3(signature = (traces, scene, reading, out=None, progress=None))]
pub(crate) fn audit_file(
    py: Python<'_>,
    traces: Vec<PathBuf>,
    scene: Source,
    reading: Reading,
    out: Option<PathBuf>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Report> {
    let inputs: Vec<&Path> = traces
        .iter()
        .map(PathBuf::as_path)
        .chain(scene.path())
        .collect();
    let mut rows = rows_file(out, &inputs)?;
    let dialect = reading.dialect(py)?;
    let scene = scene.read(py)?;
    let (audit, rows) = follow(py, progress.as_ref(), move |watch| {
        let look = |samples| watch.set(samples);
        let written = rows.as_mut().map(|rows| &mut rows.file);
        let options = Options {
            rows: written.map(|file| file as &mut (dyn Write + '_)),
            ..reading.options(dialect, &look)
        };
        let first = traces.first().map_or(Path::new(""), PathBuf::as_path);
        let audit = audit_files(&traces, &scene, options).map_err(of_log(first));
        (audit, rows)
    })?;
    reported(py, audit, rows)
}

/// The report, once the rows have their name; without one, what was there stays.
fn reported(
    py: Python<'_>,
    audit: Result<Audit, TraceError>,
    rows: Option<Rows>,
) -> PyResult<Report> {
    let report = report(py, audit)?;
    rows.map_or(Ok(()), Rows::keep)?;
    Ok(report)
}

/// The numbers of an array of 64-bit integers or doubles.
fn values(py: Python<'_>, name: &str, array: &Bound<'_, PyAny>) -> PyResult<Values> {
    // Where there is nothing it has no address, and PyO3 takes no such buffer.
    if array.len()? == 0 {
        return Ok(Values::Whole(Vec::new()));
    }
    if let Ok(buffer) = PyBuffer::<i64>::get(array) {
        return copy(py, &buffer).map(Values::Whole);
    }
    match PyBuffer::<f64>::get(array) {
        Ok(buffer) => copy(py, &buffer).map(Values::Doubles),
        Err(_) => Err(PyValueError::new_err(format!(
            "{name}: expected 64-bit integers or doubles"
        ))),
    }
}

/// The numbers of a buffer. Between blocks of them other threads run, and an interrupt ends it.
fn copy<T: Element + Sync>(py: Python<'_>, buffer: &PyBuffer<T>) -> PyResult<Vec<T>> {
    /// A few megabytes, which take a few milliseconds.
    const BLOCK: usize = 1 << 19;
    // What has gaps was closed up before.
    let Some(cells) = buffer.as_slice(py) else {
        return buffer.to_vec(py);
    };
    let mut values = Vec::with_capacity(cells.len());
    for block in cells.chunks(BLOCK) {
        values.extend(block.iter().map(ReadOnlyCell::get));
        py.check_signals()?;
        py.detach(|| ());
    }
    Ok(values)
}

/// The audit of a trace in memory, as JSON.
#[pyfunction]
#[pyo3(signature = (columns, scene, reading, out=None, progress=None))]
pub(crate) fn audit_arrays(
    py: Python<'_>,
    columns: Vec<(String, Bound<'_, PyAny>)>,
    scene: Source,
    reading: Reading,
    out: Option<PathBuf>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Report> {
    let inputs: Vec<&Path> = scene.path().into_iter().collect();
    let mut rows = rows_file(out, &inputs)?;
    let dialect = reading.dialect(py)?;
    let mut read = Vec::new();
    for (name, array) in columns {
        let values = values(py, &name, &array)?;
        read.push((name, values));
    }
    let scene = scene.read(py)?;
    let (audit, rows) = follow(py, progress.as_ref(), move |watch| {
        let look = |samples| watch.set(samples);
        let written = rows.as_mut().map(|rows| &mut rows.file);
        let options = Options {
            rows: written.map(|file| file as &mut (dyn Write + '_)),
            ..reading.options(dialect, &look)
        };
        (audit_columns(read, &scene, options), rows)
    })?;
    reported(py, audit, rows)
}

/// The exact account of a piece of a trace, as JSON for `audit_merge`, with its numbers of samples and
/// intervals; `stretch` is `a:b` in samples, `i/n` for one of n pieces, or `i-j/n` for several.
#[pyfunction]
#[pyo3(signature = (trace, scene, reading, stretch, progress=None))]
pub(crate) fn audit_piece(
    py: Python<'_>,
    trace: PathBuf,
    scene: Source,
    reading: Reading,
    stretch: &str,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<(String, u64, u64)> {
    let stretch = match stretch.contains('/') {
        true => Stretch::parse_shard(stretch),
        false => stretch.parse(),
    };
    let stretch = stretch.map_err(|error| of_trace(py, &error))?;
    let dialect = reading.dialect(py)?;
    let scene = scene.read(py)?;
    let part = follow(py, progress.as_ref(), move |watch| {
        let look = |samples| watch.set(samples);
        let options = reading.options(dialect, &look);
        let part = audit_part(&trace, &scene, stretch, options).map_err(of_log(&trace))?;
        Ok((part.to_json()?, part.samples(), part.intervals()))
    })?;
    part.map_err(|error: TraceError| of_trace(py, &error))
}

/// The report of the whole from the accounts of its pieces, each with a name.
#[pyfunction]
pub(crate) fn audit_merge(
    py: Python<'_>,
    parts: Vec<(String, String)>,
    scene: Source,
) -> PyResult<Report> {
    let scene = scene.read(py)?;
    let audit = follow(py, None, move |_| {
        let mut read = Vec::new();
        for (name, text) in parts {
            let part = Partial::from_json(&text)?;
            read.push((name, part));
        }
        merge_parts(&read, &scene)
    })?;
    report(py, audit)
}
