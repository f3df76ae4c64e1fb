//! `passivity audit`: the exact ledger of a recorded trace.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::PathBuf;

use passivity_oracle::audit::{Options, Verdict, audit};
#[cfg(feature = "plot")]
use passivity_plot::energy::{Point, draw};
#[cfg(feature = "plot")]
use passivity_plot::save;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};

/// Account for a recorded or simulated trace, exactly, interval by interval.
///
/// The trace is CSV with a header, or Parquet, with one of the columns `xi` (ticks), `x [unit]` or
/// `count` (encoder counts), and perhaps `t [s]` (or `tau`) and `f [unit]`, the force that was
/// commanded at each sample and held until the next. Where there are forces the account is of them,
/// and beside it stands how they differ from the wall's law; `--law` accounts for the law's own
/// force instead. The rows that `simulate --out` writes are a trace as well. Of counts, every figure
/// is an exact enclosure and every answer has three values.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity audit trace.csv --scene scenes/re35.toml
  passivity audit log.parquet --scene scene.toml --format json --out rows.csv --plot energy.svg

What is judged: under the wall's own force without delay or damping, each interval, by what it
generated and what friction surely dissipated; else the whole, by what the operator has drawn so far
and what was stored at the start.

Exit codes: 0 it holds; 1 it fails, or it depends; 2 the trace or the scene is bad (what came before
the mistake is accounted for) or nothing was recorded; 3 the scene has an effect that no theorem
covers.")]
pub(crate) struct Args {
    /// The trace; `-` reads CSV from standard input.
    #[arg(value_name = "TRACE")]
    trace: PathBuf,
    /// The scene it was recorded in.
    #[arg(long, value_name = "FILE")]
    scene: PathBuf,
    /// Write the rows of the ledger to a CSV file.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Draw energy against time, as SVG or PNG.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// Account for the force of the scene's own law, also where the trace has forces.
    #[arg(long)]
    law: bool,
    /// How many cores to use; 0 for all.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=1024))]
    threads: u16,
    /// For people or for programs.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Audits and reports.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let place = |what: &std::path::Path| what.display().to_string();
    keep_the_trace(args)?;
    let mut rows = match &args.out {
        Some(path) => Some(BufWriter::new(
            File::create(path).map_err(|error| Failure::io(place(path), &error))?,
        )),
        None => None,
    };
    let options = Options {
        rows: rows.as_mut().map(|rows| rows as &mut dyn Write),
        points: args.plot.is_some(),
        law: args.law,
        threads: usize::from(args.threads),
        block: 0,
    };
    let report = audit(&args.trace, &scene, options)
        .map_err(|error| Failure::input(format!("{}: {error}", place(&args.trace))))?;
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let course: Vec<Point> = report.points().iter().map(point).collect();
        let title = format!("{} in {}", place(&args.trace), scene.name);
        let picture = draw(&title, &course).map_err(Failure::input)?;
        save(&picture, path).map_err(Failure::input)?;
    }
    match args.format {
        Format::Text => emit(&report.to_text())?,
        Format::Json => emit_json(&report.to_json())?,
    }
    if let Some(error) = report.error() {
        eprintln!("error: {}: {error}", place(&args.trace));
    }
    Ok(match report.verdict() {
        Verdict::Holds => Exit::Holds,
        Verdict::Fails | Verdict::Depends => Exit::Fails,
        Verdict::NotCovered => Exit::NotCovered,
        Verdict::Broken => Exit::BadInput,
    })
}

/// Refuses to write over what is to be read.
fn keep_the_trace(args: &Args) -> Result<(), Failure> {
    let outputs = [&args.out, &args.plot];
    for output in outputs.into_iter().flatten() {
        for input in [&args.trace, &args.scene] {
            // What does not exist yet is no input.
            let same = match (output.canonicalize(), input.canonicalize()) {
                (Ok(output), Ok(input)) => output == input,
                _ => false,
            };
            if same {
                let message = "is read by this audit, and cannot be written by it";
                return Err(Failure::input(format!("{}: {message}", output.display())));
            }
        }
    }
    Ok(())
}

/// A point of the audit as the picture has it.
#[cfg(feature = "plot")]
#[allow(clippy::cast_precision_loss)] // for a picture
fn point(point: &passivity_oracle::audit::Point) -> Point {
    Point {
        interval: point.h as f64,
        net: point.net,
        observer: point.observer,
    }
}
