//! The native half of the Python package `passivity`: text and arrays in, JSON out. What users
//! see is in `python/passivity`.

mod audit;
mod identify;
mod output;
mod scene;
mod simulate;
mod sweep;
mod watch;

use passivity_oracle::protocol;
use pyo3::prelude::*;

use crate::scene::{IdentificationError, SceneError, SimulationError, Source, TraceError};

/// The verdict on a scene, as JSON.
#[pyfunction]
fn check(py: Python<'_>, scene: Source) -> PyResult<String> {
    let scene = scene.read_any(py)?;
    watch::follow(py, None, move |_| scene.check().to_json().to_string())
}

/// The answer to a request of the line protocol.
#[pyfunction]
fn answer(request: &[u8]) -> String {
    let mut answer = Vec::new();
    protocol::answer(request, &mut answer);
    // Answers are JSON text.
    String::from_utf8_lossy(&answer).into_owned()
}

/// The native functions.
#[pymodule]
fn _passivity(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("MAX_INTERVALS", passivity_scene::parse::MAX_INTERVALS)?;
    let effort = passivity_identify::Options::MILLIONS;
    module.add("EFFORT", effort.into_inner())?;
    module.add("SceneError", py.get_type::<SceneError>())?;
    module.add("TraceError", py.get_type::<TraceError>())?;
    module.add("SimulationError", py.get_type::<SimulationError>())?;
    module.add("IdentificationError", py.get_type::<IdentificationError>())?;
    module.add_function(wrap_pyfunction!(check, module)?)?;
    module.add_function(wrap_pyfunction!(answer, module)?)?;
    module.add_function(wrap_pyfunction!(audit::audit_file, module)?)?;
    module.add_function(wrap_pyfunction!(audit::audit_arrays, module)?)?;
    module.add_function(wrap_pyfunction!(audit::audit_piece, module)?)?;
    module.add_function(wrap_pyfunction!(audit::audit_merge, module)?)?;
    module.add_function(wrap_pyfunction!(identify::identify, module)?)?;
    module.add_function(wrap_pyfunction!(simulate::simulate, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::grid, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep_merge, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep_points, module)?)?;
    Ok(())
}
