//! `passivity design`: rates, encoders and the stiffness that they allow.

use std::path::PathBuf;

use passivity_core::BigRational;
use passivity_scene::check;
use passivity_scene::display::{Rounding, approx, rounded};
use passivity_scene::number;
use passivity_scene::parse::{MAX_COUNTS, MAX_NUMBER_EXPONENT};
use passivity_scene::scene::Given;
use passivity_scene::written::Form;

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
    let own_encoder = scene.given.resolution.as_ref();
    let rates = listed(&args.rates, Some(&scene.given.period));
    let encoders = listed(&args.encoders, own_encoder);
    let mut design = check::design(&scene, &rates, &encoders)
        .map_err(|error| Failure::Scene(error.render(look())))?;
    // No text that is typed says this: where the scene has its encoder does.
    if own_encoder.is_some_and(|own| own.written.unit().ends_with(AT_MOTOR)) {
        for encoder in &mut design.encoders {
            encoder.text.push_str(AT_MOTOR);
        }
    }
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

/// What the unit of a value ends with that the scene gives at the motor's side of a transmission.
const AT_MOTOR: &str = " at the motor";

/// The texts of a list that a person gave, or what the table is of without one.
fn listed(given: &[String], own: Option<&Given>) -> Vec<String> {
    match own {
        Some(own) if given.is_empty() => (-2..=3).filter_map(|power| doubled(own, power)).collect(),
        _ => given.to_vec(),
    }
}

/// The rate, or the fineness of the encoder, of a scene, doubled so many times, as the scene file would
/// write it: in few digits, of which the wall beside it is then computed. The scene's own value is as exact
/// as in the file. `None` for what the file cannot write.
fn doubled(own: &Given, power: i32) -> Option<String> {
    let form = own.written.form();
    let exponent = if form == Form::Value { -power } else { power };
    let factor = BigRational::from_integer(2.into()).pow(exponent);
    let written = own.written.of(&check::enclosure(&own.value)?)?;
    let (lo, hi) = (written.lo() * &factor, written.hi() * &factor);
    let text = match form {
        Form::Count => whole(&written.middle() * &factor)?,
        _ if own.has_tolerance() => format!(
            "{} … {}",
            rounded(&lo, 5, Rounding::Down),
            rounded(&hi, 5, Rounding::Up)
        ),
        _ => approx(&(written.middle() * &factor)),
    };
    // Of what has no text in the file, as the period of a scene without units, a few digits say all.
    let says_all = form == Form::Count
        || own.text.is_empty()
        || number::parse(&text).is_ok_and(|x| lo == x && hi == x);
    if power == 0 && !says_all {
        return Some(own.text.clone());
    }
    let is_in_bounds = |(_, exponent): (&str, &str)| {
        let exponent = exponent.parse::<i32>().map(i32::unsigned_abs);
        exponent.is_ok_and(|exponent| exponent <= MAX_NUMBER_EXPONENT)
    };
    let mut exponents = text.split(" … ").filter_map(|x| x.split_once('e'));
    let unit = own.written.unit();
    let unit = unit.strip_suffix(AT_MOTOR).unwrap_or(&unit);
    exponents.all(is_in_bounds).then(|| format!("{text}{unit}"))
}

/// Counts, which are whole: where the nearest whole number is not what is asked for, or is more than an
/// encoder has, there is no such encoder. What is known of it up to many digits of π is near enough.
fn whole(counts: BigRational) -> Option<String> {
    let nearest = counts.round();
    let error = &counts - &nearest;
    let small = BigRational::new(1.into(), (1u64 << 40).into());
    let is_near = -small.clone() < error && error < small;
    let most = BigRational::from_integer(MAX_COUNTS.into());
    (is_near && nearest <= most).then(|| nearest.to_string())
}
