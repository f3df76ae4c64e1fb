//! The native half of the Python package `passivity`: text and arrays in, JSON out. What users
//! see is `python/passivity/__init__.py`.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;

use passivity_audit::{Audit, Options, Positions, TraceError};
use passivity_oracle::protocol;
use passivity_scene::{AnyScene, Scene, SceneError};
use passivity_sim::report::Simulation as Report;
use passivity_sim::{Line, Method, Plan};
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

/// A scene as the Python half passes it: a file's path, or a JSON object.
fn read<T>(
    path: Option<PathBuf>,
    object: Option<&str>,
    from_path: fn(PathBuf) -> Result<T, SceneError>,
    from_json: fn(&serde_json::Value) -> Result<T, SceneError>,
) -> PyResult<T> {
    let refused = |error: &dyn std::fmt::Display| PyValueError::new_err(error.to_string());
    match (path, object) {
        (Some(path), _) => from_path(path).map_err(|error| refused(&error)),
        (None, Some(text)) => {
            let value = serde_json::from_str(text).map_err(|error| refused(&error))?;
            from_json(&value).map_err(|error| refused(&error))
        }
        (None, None) => Err(PyValueError::new_err("expected a scene")),
    }
}

/// A scene of a device of one joint.
fn read_scene(path: Option<PathBuf>, object: Option<&str>) -> PyResult<Scene> {
    read(path, object, Scene::read, Scene::from_json)
}

/// The verdict on a scene, as JSON.
#[pyfunction]
#[pyo3(signature = (path=None, object=None))]
fn check(py: Python<'_>, path: Option<PathBuf>, object: Option<&str>) -> PyResult<String> {
    let scene = read(path, object, AnyScene::read, AnyScene::from_json)?;
    Ok(py.detach(|| scene.check().to_json().to_string()))
}

/// Where an audit writes its rows.
fn rows_file(path: Option<PathBuf>) -> PyResult<Option<BufWriter<File>>> {
    match path {
        Some(path) => Ok(Some(BufWriter::new(
            File::create(path).map_err(|error| PyOSError::new_err(error.to_string()))?,
        ))),
        None => Ok(None),
    }
}

fn report(audit: Result<Audit, TraceError>) -> PyResult<String> {
    audit
        .map(|audit| audit.to_json().to_string())
        .map_err(|error| PyValueError::new_err(error.to_string()))
}

/// The audit of a trace in a file, as JSON.
#[pyfunction]
#[pyo3(signature = (trace, path=None, object=None, out=None, law=false, threads=0))]
fn audit_file(
    py: Python<'_>,
    trace: PathBuf,
    path: Option<PathBuf>,
    object: Option<&str>,
    out: Option<PathBuf>,
    law: bool,
    threads: u16,
) -> PyResult<String> {
    let scene = read_scene(path, object)?;
    let mut rows = rows_file(out)?;
    py.detach(|| {
        let options = Options {
            rows: rows.as_mut().map(|rows| rows as &mut (dyn Write + '_)),
            law,
            threads: threads.into(),
            ..Options::default()
        };
        report(passivity_audit::audit(&trace, &scene, options))
    })
}

/// The audit of a trace in memory, as JSON: 64-bit counts, or doubles under the name of a column,
/// in the machine's own byte order.
#[pyfunction]
#[pyo3(signature = (column, data, times=None, path=None, object=None, out=None, threads=0))]
#[allow(clippy::too_many_arguments)]
fn audit_arrays(
    py: Python<'_>,
    column: &str,
    data: &[u8],
    times: Option<(String, Vec<u8>)>,
    path: Option<PathBuf>,
    object: Option<&str>,
    out: Option<PathBuf>,
    threads: u16,
) -> PyResult<String> {
    let scene = read_scene(path, object)?;
    let mut rows = rows_file(out)?;
    let lengths = [Some(data.len()), times.as_ref().map(|(_, data)| data.len())];
    if lengths.iter().flatten().any(|length| length % 8 != 0) {
        let message = "expected 64-bit numbers, found bytes that are not a multiple of 8";
        return Err(PyValueError::new_err(message));
    }
    let positions = match column {
        "count" => Positions::Counts(words(data).map(i64::from_ne_bytes).collect()),
        name => Positions::Numbers(
            name.to_owned(),
            words(data).map(f64::from_ne_bytes).collect(),
        ),
    };
    let times = times.map(|(name, data)| (name, words(&data).map(f64::from_ne_bytes).collect()));
    py.detach(|| {
        let options = Options {
            rows: rows.as_mut().map(|rows| rows as &mut (dyn Write + '_)),
            threads: threads.into(),
            ..Options::default()
        };
        report(passivity_audit::audit_arrays(
            positions, times, &scene, options,
        ))
    })
}

/// Eight bytes at a time.
fn words(data: &[u8]) -> impl Iterator<Item = [u8; 8]> + '_ {
    data.chunks_exact(8).filter_map(|word| word.try_into().ok())
}

/// The answer to a request of the line protocol.
#[pyfunction]
fn answer(request: &[u8]) -> String {
    let mut answer = Vec::new();
    protocol::answer(request, &mut answer);
    // Answers are JSON text.
    String::from_utf8_lossy(&answer).into_owned()
}

/// The columns of a simulated trace.
const COLUMNS: [&str; 7] = [
    "xi0",
    "xi1",
    "v0",
    "v1",
    "generated_linear",
    "generated_quantized",
    "dissipated",
];

/// What a simulation gives: its report as JSON, and its columns as doubles in bytes.
type Simulation = (String, Vec<(&'static str, Vec<u8>)>);

/// The motion of a scene.
#[pyfunction]
#[pyo3(signature = (path=None, object=None, method="closed-form", intervals=None, trace=true))]
fn simulate(
    py: Python<'_>,
    path: Option<PathBuf>,
    object: Option<&str>,
    method: &str,
    intervals: Option<u64>,
    trace: bool,
) -> PyResult<Simulation> {
    let scene = read_scene(path, object)?;
    let mut point = scene.point();
    if let Some(intervals) = intervals {
        point.intervals = intervals;
    }
    let refused = |error: &dyn std::fmt::Display| PyValueError::new_err(error.to_string());
    let method = Method::parse(method).map_err(|error| refused(&error))?;
    let plan = Plan::compile(&point).map_err(|error| refused(&error))?;
    let mut columns: Vec<Vec<u8>> = vec![Vec::new(); if trace { COLUMNS.len() } else { 0 }];
    let begin = std::time::Instant::now();
    let run = py.detach(|| {
        let mut see = |line: &Line<'_>| {
            let entry = line.entry();
            let values = [
                entry.xi0,
                entry.xi1,
                entry.v0,
                entry.v1,
                entry.generated_linear,
                entry.generated_quantized,
                entry.dissipated,
            ];
            for (column, value) in columns.iter_mut().zip(values) {
                column.extend_from_slice(&value.to_ne_bytes());
            }
            true
        };
        let each = trace.then_some(&mut see as &mut dyn FnMut(&Line<'_>) -> bool);
        passivity_sim::simulate(&point, &method, each)
    });
    let run = run.map_err(|error| refused(&error))?;
    let seconds = begin.elapsed().as_secs_f64();
    let report = Report::new(&scene.name, &plan, &method, &run, Some(seconds));
    let report = report.map_err(|error| refused(&error))?;
    let report = serde_json::to_string(&report).map_err(|error| refused(&error))?;
    Ok((report, COLUMNS.into_iter().zip(columns).collect()))
}

/// The native functions.
#[pymodule]
fn _passivity(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_function(wrap_pyfunction!(check, module)?)?;
    module.add_function(wrap_pyfunction!(audit_file, module)?)?;
    module.add_function(wrap_pyfunction!(audit_arrays, module)?)?;
    module.add_function(wrap_pyfunction!(answer, module)?)?;
    module.add_function(wrap_pyfunction!(simulate, module)?)?;
    Ok(())
}
