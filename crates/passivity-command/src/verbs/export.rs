//! `passivity export`: the constants that a control program asks for.

use std::path::PathBuf;

use passivity_scene::check::{Target, constants};

use crate::exit::{Exit, Failure};
use crate::files::write_new;
use crate::output::{emit, emit_json, json_text, read_scene, tell};

/// Write the constants that a control program asks for: stiffness, damping, rate, speed.
///
/// Every number is a double on the safe side. The largest stiffness passes beside the scene's damping, the
/// largest damping beside the scene's stiffness, and not the two together; each does with the tolerance that
/// the scene gives it, in the same ratio. What they hold only with, as a filter
/// on the damping, a delay or a D/A step, is written below them. A comment says what binds, which theorems the
/// verdict rests on, and with what nothing is shown.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity export scenes/re35.toml --for c --out wall.h
  passivity export scenes/phantom-premium.toml --for chai3d
  passivity export scenes/re35.toml --for json | jq .max_stiffness

Exit codes: 0 the scene's wall is passive; 1 it is not, and the constants say up to where it would
be; 2 bad input.")]
pub(crate) struct Args {
    /// Scene file; `-` is standard input.
    scene: PathBuf,
    /// For which program.
    #[arg(long = "for", value_enum, value_name = "PROGRAM")]
    target: Program,
    /// Write to this file, which must not be there yet, in place of standard output.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Program {
    /// A C header with `#define`s, in SI units.
    C,
    /// CHAI3D: fields of `cHapticDeviceInfo`.
    Chai3d,
    /// OpenHaptics: scheduler rate and material properties.
    Openhaptics,
    /// One JSON document, in SI units.
    Json,
}

/// Prints the constants.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let target = match args.target {
        Program::C | Program::Json => Target::C,
        Program::Chai3d => Target::Chai3d,
        Program::Openhaptics => Target::OpenHaptics,
    };
    let Some(constants) = constants(&scene, target) else {
        return Err(Failure::input(
            "a dimensionless scene has no units that a program could take: describe the device in units",
        ));
    };
    match (args.target, &args.out) {
        (Program::Json, None) => emit_json(&constants)?,
        (Program::Json, Some(path)) => write_new(path, &json_text(&constants)?)?,
        (_, None) => emit(&constants.to_source())?,
        (_, Some(path)) => write_new(path, &constants.to_source())?,
    }
    if !constants.is_passive {
        tell(&format!(
            "warning: the wall of the scene is not shown to be passive: {}",
            constants.headline
        ));
        return Ok(Exit::Fails);
    }
    Ok(Exit::Holds)
}
