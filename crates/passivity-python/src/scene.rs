//! Scenes as they come from Python, and errors as they go there.

use std::path::{Path, PathBuf};

use passivity_scene::Scene;
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

/// A scene: a file's path, the text of one with a name for it, or a JSON object.
#[derive(Clone, FromPyObject)]
pub(crate) struct Source(
    /// Which of them, and the path or text.
    (String, String),
);

impl Source {
    /// The file that it is read from.
    pub(crate) fn path(&self) -> Option<&Path> {
        let (kind, text) = &self.0;
        (kind == "path").then(|| Path::new(text))
    }

    /// Reads the scene.
    pub(crate) fn read(&self, py: Python<'_>) -> PyResult<Scene> {
        let (kind, text) = &self.0;
        let scene = match kind.as_str() {
            "path" => Scene::read(PathBuf::from(text)),
            "text" => Scene::from_toml("scene", text),
            _ => {
                let value = serde_json::from_str(text)
                    .map_err(|error| PyValueError::new_err(error.to_string()))?;
                Scene::from_json(&value)
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

fn of_scene(py: Python<'_>, error: &passivity_scene::SceneError) -> PyErr {
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

pub(crate) fn of_simulation(error: &dyn std::fmt::Display) -> PyErr {
    SimulationError::new_err(error.to_string())
}
