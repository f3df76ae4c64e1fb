//! Scenes as they come from Python, and errors as they go there.

use std::path::{Path, PathBuf};

use passivity_scene::{AnyScene, Scene};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

pyo3::create_exception!(
    passivity,
    SceneError,
    PyValueError,
    "A scene that cannot be read: `line`, `column` and `key` say where, `kind` what, and `diagnostics` all that is wrong."
);
pyo3::create_exception!(
    passivity,
    TraceError,
    PyValueError,
    "A log that cannot be read, or rows that cannot be written: `row` and `column` say where, `kind` what."
);
pyo3::create_exception!(
    passivity,
    SimulationError,
    PyValueError,
    "A scene that cannot be simulated as asked, or a sweep that cannot be written or merged."
);

pyo3::create_exception!(
    passivity,
    IdentificationError,
    PyValueError,
    "A sketch or a log by which no parameters can be looked for; `not_covered` says whether the sketch has an effect that is not covered."
);

/// A scene as it comes from Python: which of these it is, with the path or text.
#[derive(Clone)]
pub(crate) enum Source {
    /// The path of a file, whose name need not be UTF-8.
    Path(PathBuf),
    /// The text of a file.
    Text(String),
    /// A JSON object.
    Object(String),
}

impl FromPyObject<'_, '_> for Source {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        let (kind, given): (String, Bound<'_, PyAny>) = given.extract()?;
        Ok(match kind.as_str() {
            "path" => Self::Path(given.extract()?),
            "text" => Self::Text(given.extract()?),
            _ => Self::Object(given.extract()?),
        })
    }
}

impl Source {
    /// The file that it is read from.
    pub(crate) fn path(&self) -> Option<&Path> {
        match self {
            Self::Path(path) => Some(path),
            Self::Text(_) | Self::Object(_) => None,
        }
    }

    /// Reads the scene of a device of one joint.
    pub(crate) fn read(&self, py: Python<'_>) -> PyResult<Scene> {
        self.read_by(py, Scene::read, Scene::from_toml, Scene::from_json)
    }

    /// Reads the scene of a device of one joint or of several.
    pub(crate) fn read_any(&self, py: Python<'_>) -> PyResult<AnyScene> {
        self.read_by(py, AnyScene::read, AnyScene::from_toml, AnyScene::from_json)
    }

    fn read_by<T>(
        &self,
        py: Python<'_>,
        from_path: fn(PathBuf) -> Result<T, passivity_scene::SceneError>,
        from_toml: fn(&str, &str) -> Result<T, passivity_scene::SceneError>,
        from_json: fn(&serde_json::Value) -> Result<T, passivity_scene::SceneError>,
    ) -> PyResult<T> {
        let scene = match self {
            Self::Path(path) => from_path(path.clone()),
            Self::Text(text) => from_toml("scene", text),
            Self::Object(text) => {
                let value = serde_json::from_str(text)
                    .map_err(|error| PyValueError::new_err(error.to_string()))?;
                from_json(&value)
            }
        };
        scene.map_err(|error| of_scene(py, &error))
    }
}

/// Sets what an exception says of its place.
fn with(
    py: Python<'_>,
    error: PyErr,
    set: impl FnOnce(&Bound<'_, PyAny>) -> PyResult<()>,
) -> PyErr {
    match set(error.value(py)) {
        Ok(()) => error,
        Err(other) => other,
    }
}

pub(crate) fn of_scene(py: Python<'_>, error: &passivity_scene::SceneError) -> PyErr {
    let raised = SceneError::new_err(error.to_string());
    with(py, raised, |raised| {
        let first = error.diagnostics().first();
        raised.setattr("line", first.and_then(|first| first.line()))?;
        raised.setattr("column", first.and_then(|first| first.column()))?;
        raised.setattr("key", first.and_then(|first| first.scene_key()))?;
        raised.setattr("kind", first.map(|first| first.kind().name()))?;
        raised.setattr("diagnostics", error.to_json().to_string())
    })
}

pub(crate) fn of_trace(py: Python<'_>, error: &passivity_audit::TraceError) -> PyErr {
    let raised = TraceError::new_err(error.to_string());
    with(py, raised, |raised| {
        raised.setattr("row", error.row)?;
        raised.setattr("column", error.column.as_deref())?;
        raised.setattr("kind", error.kind)?;
        raised.setattr("file", error.file.as_deref())
    })
}

pub(crate) fn of_identification(
    py: Python<'_>,
    error: &passivity_identify::IdentifyError,
    file: Option<&str>,
) -> PyErr {
    let raised = IdentificationError::new_err(match file {
        Some(file) => format!("{file}: {error}"),
        None => error.to_string(),
    });
    with(py, raised, |raised| {
        raised.setattr("not_covered", error.is_not_covered())
    })
}

pub(crate) fn of_simulation(error: &dyn std::fmt::Display) -> PyErr {
    SimulationError::new_err(error.to_string())
}
