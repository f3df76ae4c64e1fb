//! `passivity accuracy`: error and computing time of the simulation methods.

use std::path::PathBuf;

#[cfg(feature = "plot")]
use passivity_plot::save;
use passivity_sim::ExactOutcome;
use passivity_sim::accuracy::{Table, measure, methods};
#[cfg(feature = "plot")]
use passivity_sim::plot::accuracy::draw;
use passivity_sim::report::Accuracy;

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources};
use crate::output::{Format, emit, emit_json, read_scene};
use crate::progress::Progress;
use crate::verbs::simulate::{Start, intervals, words};

/// Compare the simulation methods on a scene: error against the reference, and time per interval.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity accuracy scenes/re35.toml --speed 5
  passivity accuracy scenes/dimensionless.toml --plot accuracy.svg --format json

Exit codes: 0 it is measured, whatever the errors are; 2 bad input.")]
pub(crate) struct Args {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The largest number of intervals to simulate; the reference method takes microseconds for each.
    #[arg(long, value_name = "N", default_value_t = 2000, allow_negative_numbers = true, value_parser = intervals)]
    intervals: u64,
    #[command(flatten)]
    start: Start,
    /// Draw error against computing time into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Measures every method.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let inputs = sources(&scene, &args.scene);
    may_be_written(&[("--plot", args.plot.as_ref())], &inputs, "measurement")?;
    crate::picture::check(args.plot.as_deref())?;
    let mut point = scene.point();
    args.start.put(&scene, &mut point)?;
    let mut bar = Progress::new(methods().len() as u64 + 1, "methods");
    let measured = measure(&point, args.intervals, |method| {
        bar.say(method.to_string());
        bar.advance(1);
    });
    drop(bar);
    let of_scene = |error| args.start.blamed(&args.scene, &error);
    let table = measured.map_err(of_scene)?;
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let title = format!(
            "{}: error and time, {} intervals",
            scene.name, table.intervals
        );
        let picture = draw(&title, &table).map_err(Failure::input)?;
        save(&picture, path).map_err(Failure::input)?;
    }
    match args.format {
        Format::Text => emit(&text(&scene.name, &table))?,
        Format::Json => emit_json(&Accuracy::new(&scene.name, &table).map_err(of_scene)?)?,
    }
    Ok(Exit::Holds)
}

fn text(name: &str, table: &Table) -> String {
    let mut lines = vec![
        format!(
            "{name}: {} intervals; outcome of the reference: {}",
            table.intervals,
            words(table.reference)
        ),
        format!(
            "{:<16}{:>12}{:>12}{:>12}{:>14}  outcome",
            "method", "position", "velocity", "energy", "ns/interval"
        ),
    ];
    for row in &table.rows {
        let mut note = String::new();
        if !row.same_outcome {
            note += " (differs from the reference)";
        } else if row.late != 0 {
            note += &format!(" ({:+} intervals)", row.late);
        }
        lines.push(format!(
            "{:<16}{:>12.1e}{:>12.1e}{:>12.1e}{:>14.1}  {}{note}",
            row.method.to_string(),
            row.position,
            row.velocity,
            row.energy,
            row.nanoseconds,
            words(row.exact)
        ));
    }
    for (method, reason) in &table.left_out {
        lines.push(format!("{:<16}left out: {reason}", method.to_string()));
    }
    if table.intervals == 0 && table.reference == ExactOutcome::AtRest {
        lines.push(
            "The device starts at rest and does not move; --speed sets a speed at the start."
                .to_owned(),
        );
    }
    lines.push(
        "Errors are relative to the largest displacement, the largest speed and the energy dissipated, to 1 where that is 0."
            .to_owned(),
    );
    lines.join("\n")
}
