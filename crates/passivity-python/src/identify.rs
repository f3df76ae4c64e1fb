//! Identification: friction and inertia of a device from logs of its motion.

use std::path::{Path, PathBuf};

use passivity_audit::dialects;
use passivity_identify::{
    Identified, IdentifyError, Inertia, LogReport, Options, Provenance, Report, TraceError,
    identify as search, read, read_sketch, sha256,
};
use passivity_scene::parse::named_text;
use passivity_scene::{Scene, files};
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, Value};

use crate::audit::dialect;
use crate::output::can_be_written;
use crate::scene::{Source, of_identification, of_scene, of_trace};
use crate::watch::follow;

/// What is asked for, as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asked {
    columns: Option<String>,
    delimiter: Option<String>,
    decimal_comma: bool,
    count_error: f64,
    force_error: f64,
    scale_error: Option<f64>,
    free_inertia: bool,
    /// In millions of intervals of motion.
    effort: Option<u64>,
    device: Option<String>,
    date: Option<String>,
}

/// The report as JSON, the scene that was found, the picture, where there is one, and why there is no scene.
type Answer = (String, Option<String>, Option<String>, Option<String>);

/// Why there is no answer.
enum Failed {
    Log(TraceError),
    /// With the file of the log, where it is about one.
    Search(IdentifyError, Option<String>),
    File(String),
}

/// Looks for the friction of a device, and its inertia.
#[pyfunction]
#[pyo3(signature = (logs, sketch, asked, out=None, progress=None))]
pub(crate) fn identify(
    py: Python<'_>,
    logs: Vec<PathBuf>,
    sketch: Source,
    asked: Asked,
    out: Option<PathBuf>,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Answer> {
    let inputs: Vec<&Path> = logs
        .iter()
        .map(PathBuf::as_path)
        .chain(sketch.path())
        .collect();
    if let Some(out) = &out {
        can_be_written(out, &inputs)?;
    }
    let said = Provenance::new(asked.device, asked.date);
    let mut said = said.map_err(|error| PyValueError::new_err(error.to_string()))?;
    let (columns, delimiter) = (asked.columns.as_deref(), asked.delimiter.as_deref());
    let dialect = dialect(py, columns, delimiter, asked.decimal_comma)?;
    let (name, text) = text_of(py, &sketch)?;
    let scene = read_sketch(&name, &text).map_err(|error| of_scene(py, &error))?;
    let answer = follow(py, progress.as_ref(), move |watch| {
        let mut sampled = Vec::new();
        let refused = |path: &Path, error: TraceError| {
            let file = Some(path.display().to_string());
            Failed::Log(TraceError { file, ..error })
        };
        let paths: Vec<&Path> = logs.iter().map(PathBuf::as_path).collect();
        let each = dialects(&paths, &scene, &dialect);
        let each = each.map_err(|it| refused(it.0, it.1))?;
        for (path, dialect) in logs.iter().zip(&each) {
            let log = read(path, &scene, dialect).map_err(|error| refused(path, error))?;
            let hash = sha256(path);
            said.logs.push(LogReport {
                file: path.display().to_string(),
                sha256: hash.map_err(|error| failed(path, &error))?,
            });
            sampled.push(log);
        }
        LogReport::once(&said.logs).map_err(|error| Failed::Search(error, None))?;
        let rows = sampled.iter().map(|log| log.positions.len()).sum();
        let options = Options {
            count_error: asked.count_error,
            force_error: asked.force_error,
            scale_error: asked.scale_error,
            inertia: match asked.free_inertia {
                true => Inertia::Free,
                false => Inertia::Sketch,
            },
            effort: match asked.effort {
                Some(millions) => millions * 1_000_000,
                None => Options::effort_for(rows),
            },
        };
        let found = search(&sampled, &scene, &options, |steps| watch.set(steps));
        let found = found.map_err(|error| {
            let log = error.log().and_then(|log| said.logs.get(log));
            let file = log.map(|log| log.file.clone());
            Failed::Search(error, file)
        })?;
        answer(&found, &scene, &text, said, out.as_deref())
    })?;
    answer.map_err(|error| match error {
        Failed::Log(error) => of_trace(py, &error),
        Failed::Search(error, file) => of_identification(py, &error, file.as_deref()),
        Failed::File(message) => PyOSError::new_err(message),
    })
}

fn failed(path: &Path, error: &std::io::Error) -> Failed {
    Failed::File(format!("{}: {error}", path.display()))
}

fn answer(
    found: &Identified,
    scene: &Scene,
    sketch: &str,
    said: Provenance,
    out: Option<&Path>,
) -> Result<Answer, Failed> {
    let report = Report::new(scene, found, said.logs.clone());
    let report = serde_json::to_string(&report);
    let report = report.map_err(|error| Failed::File(error.to_string()))?;
    let names: Vec<&str> = said.logs.iter().map(|log| log.file.as_str()).collect();
    // Where nothing can be drawn there is no picture.
    let picture = found
        .picture(&format!("{}: {}", scene.name, names.join(", ")))
        .ok();
    let written = match found.unwritten() {
        Some(why) => Err(why),
        None => found
            .scene(sketch, &said)
            .map_err(|error| error.to_string()),
    };
    if let (Some(out), Ok(written)) = (out, &written) {
        files::write(out, written).map_err(|error| failed(out, &error))?;
    }
    let why = written.as_ref().err().cloned();
    Ok((report, written.ok(), picture, why))
}

/// The name and the text of a sketch. What is no text of a scene is refused as every scene is.
fn text_of(py: Python<'_>, sketch: &Source) -> PyResult<(String, String)> {
    match sketch {
        Source::Path(path) => named_text(path).map_err(|error| of_scene(py, &error)),
        Source::Text(text) => Ok(("scene".to_owned(), text.clone())),
        Source::Object(text) => Ok(("scene".to_owned(), toml_of(text)?)),
    }
}

/// The text of a sketch that is a mapping: a section for each of its own mappings.
fn toml_of(json: &str) -> PyResult<String> {
    let wrong = |message: &str| PyValueError::new_err(message.to_owned());
    let json: serde_json::Value =
        serde_json::from_str(json).map_err(|error| wrong(&error.to_string()))?;
    let serde_json::Value::Object(fields) = json else {
        return Err(wrong("expected a mapping of sections"));
    };
    let mut document = DocumentMut::new();
    for (key, json) in fields {
        let item = match json {
            serde_json::Value::Object(fields) => {
                let mut table = Table::new();
                for (key, json) in fields {
                    table.insert(&key, Item::Value(value(json)?));
                }
                Item::Table(table)
            }
            other => Item::Value(value(other)?),
        };
        document.insert(&key, item);
    }
    Ok(document.to_string())
}

fn value(json: serde_json::Value) -> PyResult<Value> {
    Ok(match json {
        serde_json::Value::Null => return Err(PyValueError::new_err("a scene cannot hold None")),
        serde_json::Value::Bool(yes) => yes.into(),
        serde_json::Value::String(text) => text.into(),
        serde_json::Value::Number(number) => {
            // As it is spelt, which a scene reads exactly.
            let number = number.to_string();
            number.parse().unwrap_or_else(|_| Value::from(number))
        }
        serde_json::Value::Array(list) => {
            let list: Vec<Value> = list.into_iter().map(value).collect::<PyResult<_>>()?;
            list.into_iter().collect::<Array>().into()
        }
        serde_json::Value::Object(fields) => {
            let mut table = InlineTable::new();
            for (key, json) in fields {
                table.insert(key, value(json)?);
            }
            table.into()
        }
    })
}
