//! `passivity identify`: friction and inertia of a device from logs of its motion.

use std::path::{Path, PathBuf};

use passivity_audit::{Columns, Dialect, dialects};
use passivity_core::Effect;
use passivity_identify::{
    Identified, Inertia, LogReport, Options, Provenance, Report, Sampled, identify, read,
    read_sketch,
};
#[cfg(feature = "plot")]
use passivity_plot::save;
use passivity_scene::Scene;
use passivity_scene::parse::named_text;

use crate::exit::{Exit, Failure};
use crate::files::may_be_written;
use crate::output::{Format, emit, emit_json, look, tell};
use crate::progress::Progress;
use crate::typed::refusal;
use crate::verbs::audit::delimiter;

/// Find the friction of a device, and its inertia, from logs of its motion: bounds that surely hold them,
/// and a best estimate.
///
/// Each log is one experiment: the device starts at rest, nobody touches it, and the commanded force, in
/// the column `f [N]` or `f [N m]`, is held from each sample to the next: where the force is late, `f` is the one
/// in effect, whatever delay the sketch has. Give logs of motion in both directions: in one alone a constant force
/// cannot be told from friction. Positions are counts, or `x [unit]`,
/// as `passivity audit` reads them. The sketch is a scene that says what is known: sampling period, encoder
/// and, if known, the inertia; it may lack a wall. Friction in the sketch is not used, and is replaced in the scene that is
/// written. The model is m·dv/dt = u − b·v − c·sgn(v); every part of the parameters that is left out is refuted by
/// an enclosure of all its motions. Period and encoder are taken at their nominal values.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity identify push.csv --scene sketch.toml --out device.toml
  passivity identify push.csv ramp.csv swing.csv --scene sketch.toml --out device.toml \\
      --plot fit.svg
  passivity identify push.csv --scene sketch.toml --inertia free --format json

Exit codes: 0 some parameters fit, and every bound is finite; 1 none fit (the answer says where in
the log), or a bound is missing; 2 a log or the sketch is invalid; 3 the sketch has an effect that
is not covered: an amplifier's lag, a latency, or a hand.")]
pub(crate) struct Args {
    /// The logs, one experiment each.
    #[arg(value_name = "LOG", required = true)]
    logs: Vec<PathBuf>,
    /// What is known of the device: a scene, perhaps without a wall.
    #[arg(long, value_name = "SKETCH")]
    scene: PathBuf,
    /// Write the sketch with the ranges that were found to this file.
    #[arg(long, value_name = "SCENE")]
    out: Option<PathBuf>,
    /// By how many ticks a count may be off to either side: count n then says that the device is between n − N
    /// and n + 1 + N ticks. A position x of a log is taken as a count of x/Δ.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1.0,
        value_parser = crate::args::number(crate::args::TICKS),
        allow_negative_numbers = true
    )]
    count_error: f64,
    /// By how much the force may differ from the logged one to either side, in N or N m.
    #[arg(
        long,
        value_name = "F",
        default_value_t = 0.0,
        value_parser = crate::args::number(crate::args::FORCE),
        allow_negative_numbers = true
    )]
    force_error: f64,
    /// By what share of itself every force may be off, all alike, as by the torque constant of the motor: 0.05 for 5 %. Where
    /// the inertia has a tolerance, or is looked for, only this tells such a scale from another inertia.
    #[arg(
        long,
        value_name = "SHARE",
        value_parser = crate::args::share,
        allow_negative_numbers = true
    )]
    scale_error: Option<f64>,
    /// Take the inertia, with its tolerance, from the sketch, or look for it (over six decades); a sketch
    /// without an inertia has it looked for.
    #[arg(long, value_enum, default_value_t)]
    inertia: Mass,
    /// How much work the search for the bounds may be, in millions of sampling intervals of motion; when it
    /// is spent, the bounds are wider, and as sure. By default 20, or a thousandth of the number of rows if that is more.
    #[arg(long, value_name = "MILLIONS", allow_negative_numbers = true, value_parser = crate::args::whole(Options::MILLIONS))]
    effort: Option<u64>,
    /// Say which columns are read: `role=name`, as for `passivity audit`.
    #[arg(long, value_name = "COLUMNS")]
    columns: Option<Columns>,
    /// The character between the fields of CSV, or `tab`.
    #[arg(long, value_name = "CHARACTER", value_parser = delimiter)]
    delimiter: Option<u8>,
    /// Numbers are written with a comma, as in 0,25.
    #[arg(long)]
    decimal_comma: bool,
    /// The name of the device, for the scene that is written.
    #[arg(long, value_name = "NAME")]
    device: Option<String>,
    /// The day on which the logs were recorded, such as 2026-11-20, for the scene that is written.
    #[arg(long, value_name = "DATE")]
    date: Option<String>,
    /// Draw what was measured beside what is simulated, and the parameters that fit, as SVG or PNG.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Where the inertia comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
enum Mass {
    /// From the sketch, over its tolerance.
    #[default]
    Sketch,
    /// Looked for.
    Free,
}

/// Identifies and reports.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let said = Provenance::new(args.device.clone(), args.date.clone());
    let mut said = said.map_err(|error| Failure::input(format!("--{error}")))?;
    let inputs: Vec<PathBuf> = args.logs.iter().chain([&args.scene]).cloned().collect();
    let outputs = [("--out", args.out.as_ref()), ("--plot", args.plot.as_ref())];
    may_be_written(&outputs, &inputs, "identification")?;
    crate::picture::check(args.plot.as_deref())?;
    let (text, sketch) = sketch(&args.scene)?;
    if sketch.effects().contains(&Effect::Delay) {
        tell(&format!(
            "{}: the delay is that of the wall's law: the force of a row is taken to be in effect from that row on",
            args.scene.display()
        ));
    }
    let (logs, files) = logs(args, &sketch)?;
    said.logs = files;
    let rows = logs.iter().map(|log| log.positions.len()).sum();
    let options = Options {
        count_error: args.count_error,
        force_error: args.force_error,
        scale_error: args.scale_error,
        inertia: match args.inertia {
            Mass::Sketch => Inertia::Sketch,
            Mass::Free => Inertia::Free,
        },
        effort: match args.effort {
            Some(millions) => millions * 1_000_000,
            None => Options::effort_for(rows),
        },
    };
    let mut bar = Progress::new(options.effort, "intervals at the most");
    let mut done = 0;
    let found = identify(&logs, &sketch, &options, |steps| {
        bar.advance(steps - done);
        done = steps;
        true
    });
    drop(bar);
    let found = match found {
        Ok(found) => found,
        Err(error) if error.is_not_covered() => {
            tell(&format!("{}: {error}", args.scene.display()));
            return Ok(Exit::NotCovered);
        }
        Err(error) => {
            let log = error.log().and_then(|log| args.logs.get(log));
            return Err(Failure::input(match log {
                Some(path) => format!("{}: {error}", path.display()),
                None => error.to_string(),
            }));
        }
    };
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let title = format!(
            "{}: {}",
            sketch.name,
            crate::verbs::audit::names(&args.logs)
        );
        let picture = found.picture(&title).map_err(Failure::input)?;
        save(&picture, path).map_err(Failure::input)?;
    }
    let report = Report::new(&sketch, &found, said.logs.clone());
    match args.format {
        Format::Text => emit(&report.to_text(sketch.motion))?,
        Format::Json => emit_json(&report)?,
    }
    if let Some(out) = &args.out {
        write(out, &text, &found, &said)?;
    }
    Ok(match found.is_bounded() {
        true => Exit::Holds,
        false => Exit::Fails,
    })
}

/// Writes the scene, or says why there is none.
fn write(out: &Path, text: &str, found: &Identified, said: &Provenance) -> Result<(), Failure> {
    if let Some(why) = found.unwritten() {
        tell(&format!("{} is not written: {why}", out.display()));
        return Ok(());
    }
    let scene = found.scene(text, said).map_err(Failure::input)?;
    crate::files::write(out, &scene)?;
    if Scene::from_toml("scene", &scene).is_err() {
        tell(&format!(
            "{} has no wall yet: add a [wall] with its stiffness before you check it",
            out.display()
        ));
    }
    Ok(())
}

/// The text of the sketch, and what it says.
fn sketch(path: &Path) -> Result<(String, Scene), Failure> {
    let read = named_text(path);
    let (name, text) = read.map_err(|error| Failure::Scene(error.render(look())))?;
    let sketch = read_sketch(&name, &text);
    let sketch = sketch.map_err(|error| Failure::input(format!("{}: {error}", path.display())))?;
    Ok((text, sketch))
}

/// The logs, with the hash of each file.
fn logs(args: &Args, sketch: &Scene) -> Result<(Vec<Sampled>, Vec<LogReport>), Failure> {
    let dialect = Dialect {
        columns: args.columns.clone(),
        delimiter: args.delimiter,
        decimal_comma: args.decimal_comma,
    };
    let paths: Vec<&Path> = args.logs.iter().map(PathBuf::as_path).collect();
    let each = dialects(&paths, sketch, &dialect)
        .map_err(|refused| refusal(refused.0.display(), &refused.1))?;
    let (mut logs, mut files) = (Vec::new(), Vec::new());
    for (path, own) in args.logs.iter().zip(&each) {
        if path.as_os_str() == "-" {
            return Err(Failure::input(
                "a log must be a file: its hash goes into the scene",
            ));
        }
        if *own != dialect {
            tell(&format!(
                "{}: its header has other names than --columns, and says itself what its columns are",
                path.display()
            ));
        }
        let log = read(path, sketch, own).map_err(|error| refusal(path.display(), &error))?;
        logs.push(log);
        let sha256 = passivity_identify::sha256(path);
        files.push(LogReport {
            file: path.display().to_string(),
            sha256: sha256.map_err(|error| Failure::io(path.display(), &error))?,
        });
    }
    LogReport::once(&files).map_err(Failure::input)?;
    Ok((logs, files))
}
