//! `passivity design`: rates, encoders and the stiffness that they allow.

use std::path::PathBuf;

use passivity_scene::check;

use crate::exit::{Exit, Failure};
use crate::output::{emit, emit_json, look, read_scene};

/// Say which sampling rates and encoders allow how stiff a wall.
///
/// Prints a table: the stiffest passive wall for each rate and each encoder, all else as in the scene,
/// at the speeds that `check` speaks of. Each figure is a limit like those of `check`: typed into the
/// scene, with its rate and encoder as they are printed, the wall is passive.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity design scenes/re35.toml
  passivity design scenes/re35.toml --rates '1 kHz, 4 kHz' --encoders '8192, 14 bit, 20 bit'
  passivity design scenes/phantom-premium.toml --encoders '0.03 mm, 0.01 mm' --format csv

Exit codes: 0 a wall as stiff as the scene's is among them; 1 none is; 2 bad input.")]
pub(crate) struct Args {
    /// Scene file; `-` is standard input.
    scene: PathBuf,
    /// Sampling rates or periods, with units, separated by commas; by default from a quarter to eight
    /// times the scene's.
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    rates: Vec<String>,
    /// Encoders, as counts per revolution or as resolutions with units, separated by commas; by default
    /// from a quarter to eight times the scene's counts.
    #[arg(
        long,
        value_name = "LIST",
        value_delimiter = ',',
        allow_hyphen_values = true
    )]
    encoders: Vec<String>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: TableFormat,
}

/// For whom a table is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum TableFormat {
    /// Text for people.
    #[default]
    Text,
    /// One JSON document for programs.
    Json,
    /// Comma-separated values, a line a cell.
    Csv,
}

/// Prints the table.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    if scene.given.resolution.is_none() && !args.encoders.is_empty() {
        return Err(Failure::input(
            "the scene has no encoder that another could stand for: give it an [encoder]",
        ));
    }
    let design = check::design(&scene, &args.rates, &args.encoders).map_err(|error| {
        let of_rates = check::design(&scene, &args.rates, &[]).is_err();
        let option = if of_rates { "--rates" } else { "--encoders" };
        Failure::Scene(format!("{option}: {}", error.render(look())))
    })?;
    match args.format {
        TableFormat::Text => emit(&design.to_text())?,
        TableFormat::Json => emit_json(&design)?,
        TableFormat::Csv => emit(&design.to_csv())?,
    }
    let mut cells = design.stiffest.iter().flatten().flatten();
    Ok(if cells.any(|cell| cell.is_enough) {
        Exit::Holds
    } else {
        Exit::Fails
    })
}
