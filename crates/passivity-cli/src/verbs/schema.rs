//! `passivity schema`: the JSON Schema of scene files.

use crate::exit::{Exit, Failure};
use crate::output::emit_json;

/// Print the JSON Schema of scene files, for editors.
///
/// A scene file that begins with the line `#:schema scene.schema.json` gets completion, descriptions and
/// marks under mistakes in editors with Taplo or \"Even Better TOML\".
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  passivity schema > scene.schema.json")]
pub(crate) struct Args {}

/// Prints the schema.
pub(crate) fn run(_: &Args) -> Result<Exit, Failure> {
    emit_json(&passivity_scene::parse::schema())?;
    Ok(Exit::Holds)
}
