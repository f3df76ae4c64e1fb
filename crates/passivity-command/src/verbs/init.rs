//! `passivity init`: a scene file to begin with.

use std::path::PathBuf;

use passivity_scene::parse::Sketch;

use crate::exit::{Exit, Failure};
use crate::files::write_new;
use crate::output::emit;

/// Write a commented scene file to begin with.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity init rotary --out knob.toml
  passivity init linear | passivity check -
  passivity init joints --out arm.toml
  passivity schema > scene.schema.json")]
pub(crate) struct Args {
    /// The kind of device.
    #[arg(value_enum, default_value_t)]
    kind: Kind,
    /// Write to this file, which must not be there yet, in place of standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Kind {
    /// A knob, a wheel, a paddle.
    #[default]
    Rotary,
    /// A device that moves along a line.
    Linear,
    /// An arm of several joints.
    Joints,
    /// Numbers without units.
    Dimensionless,
}

/// Writes the file.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let sketch = match args.kind {
        Kind::Rotary => Sketch::Rotary,
        Kind::Linear => Sketch::Linear,
        Kind::Joints => Sketch::Joints,
        Kind::Dimensionless => Sketch::Dimensionless,
    };
    match &args.out {
        Some(path) => write_new(path, sketch.text())?,
        None => emit(sketch.text())?,
    }
    Ok(Exit::Holds)
}
