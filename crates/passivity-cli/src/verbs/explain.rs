//! `passivity explain`: the derivation with the scene's numbers.

use std::path::PathBuf;

use passivity_scene::explain::explain;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};

/// Show the derivation of the verdict with the scene's numbers filled in.
///
/// Lists the effects in the scene and those left out, the equations in force, the theorems used,
/// and what a simulation of the scene computes.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:
  passivity explain scenes/re35.toml")]
pub(crate) struct Args {
    /// The scene file.
    scene: PathBuf,
    /// For people or for programs.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Explains the scene.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let explanation = explain(&read_scene(&args.scene)?);
    match args.format {
        Format::Text => emit(&explanation.to_text())?,
        Format::Json => emit_json(&explanation.to_json())?,
    }
    Ok(Exit::Holds)
}
