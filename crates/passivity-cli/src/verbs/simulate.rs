//! `passivity simulate`: the motion of a scene, with its energy ledger.

use std::fs::File;
use std::io::{BufWriter, IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;

use passivity_core::BigRational;
#[cfg(feature = "plot")]
use passivity_plot::save;
use passivity_scene::number;
use passivity_sim::methods::{Detail, Line, NAMES, Simulated, simulate};
#[cfg(feature = "plot")]
use passivity_sim::plot::motion::{Motion, draw};
use passivity_sim::trace::Table;
use passivity_sim::{Exactly, Method, Plan};
use serde_json::{Value, json};

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};
use crate::progress::Progress;

/// Simulate a scene: the motion between samples in closed form, with the energy ledger.
///
/// Exit code 0 when the device comes to rest, 1 when it does not or nothing is certain.
#[derive(Debug, clap::Args)]
#[command(after_help = "Methods:
  closed-form     doubles, no step size (default)
  exact           rational numbers, for scenes without viscous friction
  reference:50    this many decimal digits
  enclosure       rigorous intervals, refined until they decide
  euler:10        semi-implicit Euler, this many steps an interval
  rk4:10          Runge-Kutta of order 4, this many steps an interval
  adaptive:1e-9   Dormand-Prince with events, this tolerance

Examples:
  passivity simulate scenes/re35.toml --speed 5 --plot motion.svg
  passivity simulate scenes/re35.toml --speed 5 --method enclosure --out trace.csv
  passivity simulate scenes/dimensionless.toml --method reference:60 --format json")]
pub(crate) struct Args {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The method, with its parameter after a colon.
    #[arg(long, value_name = "METHOD", default_value = "closed-form")]
    method: String,
    /// How many intervals to run, instead of what the scene says.
    #[arg(long, value_name = "N")]
    intervals: Option<u64>,
    /// Speed at the start in ticks per sample, instead of the scene's.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
    /// Where to write the ledger, a CSV row per interval.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Where to draw the motion: a name that ends in .svg or .png.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How many intervals to draw; all of them when not given.
    #[arg(long, value_name = "N", requires = "plot")]
    plot_until: Option<u64>,
    /// For people or for programs.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Simulates the scene.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let mut point = scene.point();
    if let Some(intervals) = args.intervals {
        point.intervals = intervals;
    }
    if let Some(text) = &args.speed {
        point.start[1] = speed_at_start(text)?;
    }
    let method = Method::parse(&args.method).map_err(Failure::input)?;
    debug_assert!(NAMES.contains(&method.name()));
    let of_scene = |error| Failure::input(format!("`{}`: {error}", args.scene.display()));
    let plan = Plan::compile(&point).map_err(of_scene)?;
    let mut trace = match &args.out {
        Some(path) => Some(Trace::create(path, Table::new(&point, &plan, &method))?),
        None => None,
    };
    #[cfg(feature = "plot")]
    let mut motion = Motion::new(plan.start);
    #[cfg(feature = "plot")]
    let until = args.plot_until.unwrap_or(u64::MAX);
    // Intervals between two looks at the clock.
    const BETWEEN: u64 = 1 << 10;
    let mut seen = 0_u64;
    let begin = Instant::now();
    let mut bar = Progress::new(point.intervals, "intervals");
    let terminal = std::io::stderr().is_terminal();
    let watched = args.out.is_some() || args.plot.is_some() || terminal;
    let run = if watched {
        let mut see = |line: &Line<'_>| {
            #[cfg(feature = "plot")]
            if args.plot.is_some() {
                add_to(&mut motion, line, until);
            }
            seen += 1;
            if terminal && seen.is_multiple_of(BETWEEN) {
                bar.advance(BETWEEN);
            }
            trace.as_mut().is_none_or(|trace| trace.take(line))
        };
        simulate(&point, &method, Some(&mut see))
    } else {
        simulate(&point, &method, None)
    }
    .map_err(of_scene)?;
    let seconds = begin.elapsed().as_secs_f64();
    drop(bar);
    if let Some(trace) = trace {
        trace.finish()?;
    }
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let title = format!(
            "{}: {}",
            scene.name,
            run.end.outcome.exact.name().replace('_', " ")
        );
        let picture = draw(&title, motion).map_err(Failure::input)?;
        save(&picture, path).map_err(Failure::input)?;
    }
    match args.format {
        Format::Text => emit(&text(&scene.name, &plan, &method, &run, seconds))?,
        Format::Json => emit_json(&document(&scene.name, &plan, &method, &run, seconds))?,
    }
    Ok(match run.end.outcome.exact {
        Exactly::AtRest => Exit::Holds,
        _ => Exit::Fails,
    })
}

/// A speed as it was typed, in ticks per sample.
pub(crate) fn speed_at_start(text: &str) -> Result<BigRational, Failure> {
    number::parse(text.trim()).map_err(|error| Failure::input(format!("--speed `{text}`: {error}")))
}

/// Adds an interval to a picture.
#[cfg(feature = "plot")]
fn add_to(motion: &mut Motion, line: &Line<'_>, until: u64) {
    use passivity_sim::Entry;
    use passivity_sim::real::Real;
    fn near<R: Real>(row: &passivity_sim::model::Row<R>) -> Entry {
        Entry {
            h: row.h,
            xi0: row.xi[0].approximate(),
            xi1: row.xi[1].approximate(),
            v0: row.velocity[0].approximate(),
            v1: row.velocity[1].approximate(),
            generated_linear: row.generated_linear.approximate(),
            generated_quantized: row.generated_quantized.approximate(),
            dissipated: row.dissipated.approximate(),
            ..Entry::default()
        }
    }
    let entry = match line {
        Line::Double(entry) => **entry,
        Line::Exact(row) => near(row),
        Line::Enclosed(row) => near(row),
    };
    if entry.h < until {
        motion.add(&entry);
    }
}

/// The file of a trace.
struct Trace {
    path: PathBuf,
    table: Table,
    file: BufWriter<File>,
    line: String,
    failed: Option<std::io::Error>,
}

impl Trace {
    fn create(path: &Path, table: Table) -> Result<Self, Failure> {
        let name = format!("`{}`", path.display());
        let file = File::create(path).map_err(|error| Failure::io(&name, &error))?;
        let mut file = BufWriter::new(file);
        writeln!(file, "{}", table.header()).map_err(|error| Failure::io(&name, &error))?;
        Ok(Self {
            path: path.to_owned(),
            table,
            file,
            line: String::new(),
            failed: None,
        })
    }

    /// Writes a row; `false` when it could not be written, which ends the run.
    fn take(&mut self, line: &Line<'_>) -> bool {
        self.line.clear();
        self.table.write(line, &mut self.line);
        match self.file.write_all(self.line.as_bytes()) {
            Ok(()) => true,
            Err(error) => {
                self.failed = Some(error);
                false
            }
        }
    }

    fn finish(mut self) -> Result<(), Failure> {
        let result = match self.failed.take() {
            Some(error) => Err(error),
            None => self.file.flush(),
        };
        result.map_err(|error| Failure::io(format!("`{}`", self.path.display()), &error))
    }
}

fn text(name: &str, plan: &Plan, method: &Method, run: &Simulated, seconds: f64) -> String {
    let (end, totals) = (&run.end, &run.totals);
    let effects: Vec<&str> = plan.effects.iter().map(|effect| effect.words()).collect();
    let at = end
        .outcome
        .at_interval
        .map_or_else(String::new, |h| format!(" (interval {h})"));
    let mut lines = vec![
        format!("{name}: {}{at}", end.outcome.exact.name().replace('_', " ")),
        format!("  {}", end.outcome.because),
        format!(
            "  the start   ξ = {} ticks, ξ̇ = {} ticks/sample",
            plan.start[0], plan.start[1]
        ),
        format!(
            "  by the paper's detector (|ξ̇| < 0.01 at the end): {}",
            end.outcome.paper.name().replace('_', " ")
        ),
        format!(
            "  method      {method}, {} intervals in {seconds:.3} s",
            end.intervals
        ),
        format!("  effects     {}", effects.join(", ")),
        format!(
            "  at the end  ξ = {} ticks, ξ̇ = {} ticks/sample",
            end.xi, end.velocity
        ),
    ];
    match &run.detail {
        Detail::None => {}
        Detail::Exact([xi, v]) | Detail::Digits([xi, v]) => {
            lines.push(format!("              ξ = {xi}"));
            lines.push(format!("              ξ̇ = {v}"));
        }
        Detail::Enclosed {
            ends: [xi, v],
            bits,
        } => {
            lines.push(format!("              ξ in [{:?}, {:?}]", xi[0], xi[1]));
            lines.push(format!(
                "              ξ̇ in [{:?}, {:?}], by numbers of {bits} bits",
                v[0], v[1]
            ));
        }
    }
    lines.push(format!(
        "  energy      generated {:.6} (linear spring), {:.6} (quantized spring), dissipated {:.6} KΔ²",
        totals.generated_linear, totals.generated_quantized, totals.dissipated
    ));
    if end.intervals == 0 && end.outcome.exact == Exactly::AtRest {
        lines.push("  nothing moves: the start is at rest (give another with --speed)".to_owned());
    }
    lines.push(format!(
        "  balance     (13) holds in every interval to {:.1e} KΔ²",
        totals.residual_max
    ));
    lines.join("\n")
}

fn document(name: &str, plan: &Plan, method: &Method, run: &Simulated, seconds: f64) -> Value {
    let (end, totals) = (&run.end, &run.totals);
    let effects: Vec<&str> = plan.effects.iter().map(|effect| effect.name()).collect();
    let mut last = json!({"xi": end.xi, "velocity": end.velocity});
    match &run.detail {
        Detail::None => {}
        Detail::Exact([xi, v]) => last["exact"] = json!({"xi": xi, "velocity": v}),
        Detail::Digits([xi, v]) => last["digits"] = json!({"xi": xi, "velocity": v}),
        Detail::Enclosed {
            ends: [xi, v],
            bits,
        } => {
            last["enclosure"] = json!({
                "xi": {"lo": xi[0], "hi": xi[1]},
                "velocity": {"lo": v[0], "hi": v[1]},
                "bits": bits,
            });
        }
    }
    json!({
        "scene": name,
        "method": method.name(),
        "method_parameter": method.to_string(),
        "effects": effects,
        "plan": plan.describe(),
        "intervals": end.intervals,
        "final": last,
        "outcome": {
            "paper": end.outcome.paper.name(),
            "exact": end.outcome.exact.name(),
            "at_interval": end.outcome.at_interval,
            "because": end.outcome.because,
        },
        "totals": {
            "generated_linear": totals.generated_linear,
            "generated_quantized": totals.generated_quantized,
            "dissipated": totals.dissipated,
            "residual_max": totals.residual_max,
        },
        "seconds": seconds,
    })
}
