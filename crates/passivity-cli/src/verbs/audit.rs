//! `passivity audit`: the exact ledger of a recorded trace.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use passivity_audit::{Audit, Options, Verdict, audit};
#[cfg(feature = "plot")]
use passivity_plot::energy::{Point, draw};
#[cfg(feature = "plot")]
use passivity_plot::save;

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};

/// Compute the exact energy account of a recorded or simulated trace, interval by interval.
///
/// The trace is CSV with a header, or Parquet, with one of the columns `xi` (ticks), `x [unit]` or
/// `count` (encoder counts), and perhaps `t [s]` (or `tau`) and `f [unit]`, the force that was
/// commanded at each sample and held until the next. If the trace has forces, the account is that of
/// these forces, and their differences from the wall's force law are reported beside it; `--law`
/// selects the force of the law instead. The file that `simulate --out` writes is a trace as well.
/// From encoder counts, every figure is an exact interval and every answer is yes, no or undecided.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity audit trace.csv --scene scenes/re35.toml
  passivity audit log.parquet --scene scene.toml --format json --out rows.csv --plot energy.svg

How the trace is judged: if the force is that of the wall's law without delay or damping, every
interval must generate no more energy than friction surely dissipated. Otherwise the operator must
never have drawn more energy than was stored at the start.

Exit codes: 0 it holds; 1 it fails or is undecided; 2 the trace or the scene is invalid (the rows
before the error are accounted for) or the trace is empty; 3 the scene has an effect that no theorem
covers.")]
pub(crate) struct Args {
    /// The trace; `-` reads CSV from standard input.
    #[arg(value_name = "TRACE")]
    trace: PathBuf,
    /// The scene in which it was recorded.
    #[arg(long, value_name = "FILE")]
    scene: PathBuf,
    /// Write the rows of the ledger to a CSV file.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Draw energy against time, as SVG or PNG.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// Write the first violated interval to a JSON file, with all that its figures follow from.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Use the force of the scene's law even if the trace has forces.
    #[arg(long)]
    law: bool,
    /// The number of processor cores to use; 0 for all.
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=1024))]
    threads: u16,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Audits and reports.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let place = |what: &Path| what.display().to_string();
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
    if let Some(path) = &args.certificate {
        certify(&report, path)?;
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

/// Writes the certificate of the first violated interval, or says why there is none.
fn certify(report: &Audit, path: &Path) -> Result<(), Failure> {
    let Some(certificate) = report.certificate() else {
        let because = match report.report().not_covered.is_empty() {
            true => "no interval surely generated more than friction surely dissipates",
            false => "the scene has an effect that the account of a log leaves out",
        };
        eprintln!("no certificate is written: {because}");
        return Ok(());
    };
    let text = serde_json::to_string_pretty(certificate);
    let text = text.map_err(|error| Failure::input(format!("no certificate: {error}")))?;
    std::fs::write(path, text + "\n").map_err(|error| Failure::io(path.display(), &error))
}

/// Refuses to write over what is to be read.
fn keep_the_trace(args: &Args) -> Result<(), Failure> {
    let outputs = [&args.out, &args.plot, &args.certificate];
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
fn point(point: &passivity_audit::Point) -> Point {
    Point {
        interval: point.h as f64,
        net: point.net,
        observer: point.observer,
    }
}
