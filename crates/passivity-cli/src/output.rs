//! Writing results: text or JSON on standard output, pictures as SVG or PNG files.

use std::io::{IsTerminal as _, Write as _};
use std::path::Path;

use passivity_scene::Scene;

use crate::exit::Failure;

/// For whom the result is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// Text for people.
    #[default]
    Text,
    /// One JSON document for programs.
    Json,
}

/// Writes `text` and a line break to standard output.
pub(crate) fn emit(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.write_all(if text.ends_with('\n') { b"" } else { b"\n" }))
        .and_then(|()| out.flush())
        .map_err(|error| Failure::io("standard output", &error))
}

/// Writes a JSON document to standard output.
pub(crate) fn emit_json(document: &impl serde::Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(document);
    emit(&text.map_err(|error| Failure::input(format!("this result cannot be JSON: {error}")))?)
}

/// Reads a scene file, with every diagnostic when it cannot be read.
pub(crate) fn read_scene(path: &Path) -> Result<Scene, Failure> {
    Scene::read(path).map_err(|error| Failure::Scene(error.render(std::io::stderr().is_terminal())))
}
