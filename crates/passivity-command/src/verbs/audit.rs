//! `passivity audit`: the exact ledger of a recorded trace.

use std::io::Write;
use std::path::{Path, PathBuf};

use passivity_audit::{
    Audit, Columns, Dialect, Options, Partial, Stretch, Verdict, audit_files, audit_part,
    merge_parts,
};
#[cfg(feature = "plot")]
use passivity_plot::energy::{Point, draw};
#[cfg(feature = "plot")]
use passivity_plot::save;
use passivity_scene::Scene;
use passivity_scene::files::Output;

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources, write};
use crate::output::{Format, emit, emit_json, read_scene, tell};
use crate::typed::refusal;

/// Compute the exact energy account of a recorded or simulated trace, interval by interval.
///
/// The trace is CSV with a header, as it is or compressed by gzip or zstd, Parquet, or MCAP, where a column is a
/// number in the messages on a topic, such as `/joint_states.position.knee`. It has one of the columns `xi` (ticks), `x [unit]` or `count` (encoder counts), and perhaps `t [unit]` (or `tau`, in
/// sampling periods), `v [unit]` and `f [unit]`, the force that was held from each sample
/// to the next. Columns of other names are named by `--columns`; if a header is not understood, the
/// error shows the command that reads it. If the trace has forces, the account is that of
/// these forces, and their differences from the wall's force law are reported beside it; `--law`
/// selects the force of the law instead. The file that `simulate --out` writes is a trace as well, unless its
/// figures are bounds (`xi0_lo`, `xi0_hi`).
/// From encoder counts, every figure is an exact interval and every answer is yes, no or undecided.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity audit trace.csv --scene scenes/re35.toml
  passivity audit log.parquet --scene scene.toml --format json --out rows.csv --plot energy.svg
  passivity audit log.csv.gz --scene scene.toml --delimiter ';' --decimal-comma \\
      --columns 't=timestep [us], x=encoder_paddle_pos [deg], f=motor_torque [N.m]'
  passivity audit run.mcap --scene scene.toml --columns 't=/joint_states.header.stamp, \
      x=/joint_states.position.knee [rad], f=/joint_states.effort.knee [N m]'
  for i in 1 2 3 4; do passivity audit log.csv --scene scene.toml \\
      --shard $i/4 --partial part-$i.json; done     # each on another machine, if you like
  passivity audit --merge part-*.json --scene scene.toml

How the trace is judged: if the force is that of the wall's law without delay or damping, every
interval must generate no more energy than friction surely dissipated. Otherwise the operator must
never have drawn more energy than was stored at the start.

Exit codes: 0 it holds; 1 it fails or is undecided; 2 the trace or the scene is invalid (the rows
before the error are accounted for) or the trace is empty; 3 the log is not accounted for: the scene
has a latency or an amplifier, or it has filtered damping or a controller and the trace has no forces.")]
pub(crate) struct Args {
    /// The trace; several files with the same header are one trace, in this order. `-` reads CSV from
    /// standard input.
    #[arg(
        value_name = "TRACE",
        required_unless_present = "merge",
        conflicts_with = "merge"
    )]
    traces: Vec<PathBuf>,
    /// The scene in which it was recorded.
    #[arg(long, value_name = "FILE")]
    scene: PathBuf,
    /// Say which columns are read: `role=name`, separated by commas. The roles are t, tau, xi, x, count, v
    /// and f. A unit in brackets is for a header that gives none, and a minus sign before the name turns
    /// the sign. A time in two columns is `t=sec [s] + nanosec [ns]`.
    #[arg(long, value_name = "COLUMNS")]
    columns: Option<Columns>,
    /// The character between the fields of CSV, or `tab`; by default a comma, or a semicolon with
    /// --decimal-comma.
    #[arg(long, value_name = "CHARACTER", value_parser = delimiter)]
    delimiter: Option<u8>,
    /// Numbers are written with a comma, as in 0,25.
    #[arg(long)]
    decimal_comma: bool,
    /// Write the rows of the ledger to a CSV file.
    #[arg(long, value_name = "FILE", value_parser = crate::files::csv())]
    out: Option<PathBuf>,
    /// Draw energy against time in sampling periods, as SVG or PNG.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// Write the first violated interval to a JSON file, with all that its figures follow from.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Use the force of the scene's law even if the trace has forces.
    #[arg(long)]
    law: bool,
    /// The number of processor cores to use; 0 for all.
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true, value_parser = crate::args::whole(0..=1024_u16))]
    threads: u16,
    /// Write the exact account of a piece of the trace to this file, as JSON for --merge, and no report.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["out", "plot", "certificate"])]
    partial: Option<PathBuf>,
    /// With --partial: account only for the intervals from sample A to sample B, counted from 0; without B to the
    /// end. Pieces that follow each other share a sample: 0:1000, 1000:2000, 2000:.
    // What conflicts with the option that is required would make it one that need not be there.
    #[arg(
        long,
        value_name = "A:B",
        requires = "partial",
        conflicts_with_all = ["shard", "out", "plot", "certificate"]
    )]
    range: Option<Stretch>,
    /// With --partial: account only for one piece of the trace: `3/8` is the third of eight, as even as the file
    /// allows, and `3-5/8` the third to the fifth.
    #[arg(long, value_name = "I[-J]/N", requires = "partial", conflicts_with_all = ["out", "plot", "certificate"],
          value_parser = Stretch::parse_shard)]
    shard: Option<Stretch>,
    /// Report on the whole trace from the partial accounts of all its pieces: the same report as in one run.
    #[arg(long, value_name = "PART", num_args = 1.., conflicts_with_all = ["partial", "range", "shard", "columns", "delimiter", "decimal_comma", "out", "plot", "law", "threads"])]
    merge: Vec<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Reads the character between fields.
pub(crate) fn delimiter(text: &str) -> Result<u8, &'static str> {
    match (text, text.as_bytes()) {
        ("tab" | "\\t", _) => Ok(b'\t'),
        (_, [byte]) => Ok(*byte),
        _ => Err("expected one character, or `tab`"),
    }
}

/// Audits and reports.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let mut inputs = sources(&scene, &args.scene);
    inputs.extend(args.traces.iter().chain(&args.merge).cloned());
    let outputs = [
        ("--out", args.out.as_ref()),
        ("--plot", args.plot.as_ref()),
        ("--certificate", args.certificate.as_ref()),
        ("--partial", args.partial.as_ref()),
    ];
    may_be_written(&outputs, &inputs, "audit")?;
    crate::picture::check(args.plot.as_deref())?;
    if let Some(path) = &args.partial {
        return piece(args, &scene, path);
    }
    if !args.merge.is_empty() {
        return reported(args, &merged(args, &scene)?);
    }
    let mut rows = args.out.as_deref().map(Rows::create).transpose()?;
    let options = Options {
        rows: rows.as_mut().map(|rows| rows as &mut dyn Write),
        points: args.plot.is_some(),
        without_rows: args.format == Format::Text,
        ..options(args)
    };
    let traces = traces(args);
    let report =
        audit_files(&args.traces, &scene, options).map_err(|error| refusal(&traces, &error))?;
    let kept = rows.map_or(Ok(()), Rows::keep);
    #[cfg(feature = "plot")]
    let kept = kept.and(drawn(args, &scene, &report));
    // What cannot be written takes no verdict away.
    let exit = reported(args, &report)?;
    kept.map(|()| exit)
}

/// The rows of the ledger on their way to a file. What cannot be written ends them, and not the audit.
struct Rows<'a> {
    path: &'a Path,
    file: Output,
    failed: std::io::Result<()>,
}

impl<'a> Rows<'a> {
    fn create(path: &'a Path) -> Result<Self, Failure> {
        let file = Output::create(path);
        let file = file.map_err(|error| Failure::io(path.display(), &error))?;
        let failed = Ok(());
        Ok(Self { path, file, failed })
    }

    fn keep(self) -> Result<(), Failure> {
        let kept = self.failed.and_then(|()| self.file.keep());
        kept.map_err(|error| Failure::io(self.path.display(), &error))
    }
}

impl Write for Rows<'_> {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.failed.is_ok() {
            self.failed = self.file.write_all(bytes);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        // The file is whole when it is kept.
        Ok(())
    }
}

/// Draws the course of the energy, where that is asked for.
#[cfg(feature = "plot")]
fn drawn(args: &Args, scene: &Scene, report: &Audit) -> Result<(), Failure> {
    let Some(path) = &args.plot else {
        return Ok(());
    };
    if !report.report().not_covered.is_empty() {
        tell(&format!("no picture is drawn: {LEFT_OUT}"));
        return Ok(());
    }
    let course: Vec<Point> = report.points().iter().map(point).collect();
    let mut title = format!("{} in {}", traces(args), scene.name);
    if let Some(error) = &report.report().error {
        let file = error.file.iter().map(|file| format!(" of {file}"));
        let row = error.row.iter().map(|row| format!(" in row {row}"));
        let place: String = row.chain(file).collect();
        title.push_str(&format!(", up to the error{place}"));
    }
    let picture = draw(&title, report.report().energy_unit(), &course).map_err(Failure::input)?;
    save(&picture, path).map_err(Failure::input)
}

/// How the trace is read.
fn options<'a>(args: &Args) -> Options<'a> {
    Options {
        law: args.law,
        threads: usize::from(args.threads),
        dialect: Dialect {
            columns: args.columns.clone(),
            delimiter: args.delimiter,
            decimal_comma: args.decimal_comma,
        },
        ..Options::default()
    }
}

/// Writes the account of a piece.
fn piece(args: &Args, scene: &Scene, path: &Path) -> Result<Exit, Failure> {
    let [trace] = args.traces.as_slice() else {
        return Err(Failure::input("--partial is of a trace in one file"));
    };
    let whole = Stretch::Samples(0, None);
    let stretch = args.range.or(args.shard).unwrap_or(whole);
    let named = traces(args);
    let part = audit_part(trace, scene, stretch, options(args))
        .map_err(|error| refusal(&named, &error))?;
    let text = part.to_json().map_err(Failure::input)?;
    write(path, &(text + "\n"))?;
    match args.format {
        Format::Text => emit(&format!(
            "{}: {} intervals of {named}",
            path.display(),
            part.intervals()
        ))?,
        Format::Json => emit_json(
            &serde_json::json!({"partial": path.display().to_string(), "intervals": part.intervals()}),
        )?,
    }
    Ok(Exit::Holds)
}

/// The report of the whole trace.
fn merged(args: &Args, scene: &Scene) -> Result<Audit, Failure> {
    let mut parts = Vec::new();
    for path in &args.merge {
        let name = path.display().to_string();
        let part = Partial::read(path);
        let part = part.map_err(|error| Failure::input(format!("{name}: {error}")))?;
        parts.push((name, part));
    }
    merge_parts(&parts, scene).map_err(Failure::input)
}

/// Reports.
fn reported(args: &Args, report: &Audit) -> Result<Exit, Failure> {
    let traces = traces(args);
    let certified = match &args.certificate {
        Some(path) => certify(report, path),
        None => Ok(()),
    };
    match args.format {
        Format::Text => emit(&report.to_text())?,
        Format::Json => emit_json(&report.to_json())?,
    }
    if let Some(error) = report.error() {
        tell(&match error.file {
            None if !traces.is_empty() => format!("error: {traces}: {error}"),
            _ => format!("error: {error}"),
        });
    }
    certified?;
    Ok(match report.verdict() {
        Verdict::Holds => Exit::Holds,
        Verdict::Fails | Verdict::Depends => Exit::Fails,
        Verdict::NotCovered => Exit::NotCovered,
        Verdict::Broken => Exit::BadInput,
    })
}

/// The names of the traces, for people.
fn traces(args: &Args) -> String {
    names(&args.traces)
}

/// The names of files, for people.
pub(crate) fn names(paths: &[PathBuf]) -> String {
    let names: Vec<String> = paths
        .iter()
        .map(|path| path.display().to_string())
        .collect();
    names.join(", ")
}

/// Why there is nothing to show of a log that is not accounted for.
const LEFT_OUT: &str = "the scene has an effect that the account of a log leaves out";

/// Writes the certificate of the first violated interval, or says why there is none.
fn certify(report: &Audit, path: &Path) -> Result<(), Failure> {
    let Some(certificate) = report.certificate() else {
        let because = match report.report().not_covered.is_empty() {
            true => "no interval surely generated more than friction surely dissipates",
            false => LEFT_OUT,
        };
        tell(&format!("no certificate is written: {because}"));
        return Ok(());
    };
    let text = serde_json::to_string_pretty(certificate);
    let text = text.map_err(|error| Failure::input(format!("no certificate: {error}")))?;
    write(path, &(text + "\n"))
}

/// A point of the audit as the picture has it.
#[cfg(feature = "plot")]
fn point(point: &passivity_audit::Point) -> Point {
    Point {
        time: point.time,
        net: point.net,
        observer: point.observer,
    }
}
