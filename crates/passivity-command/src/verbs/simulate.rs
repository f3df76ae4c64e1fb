//! `passivity simulate`: the motion of a scene, with its energy ledger.

mod text;

use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};
use std::time::Instant;

use passivity_core::{BigRational, Parameter};
#[cfg(feature = "plot")]
use passivity_plot::save;
use passivity_scene::files::Output;
use passivity_scene::number::parse;
use passivity_scene::parse::MAX_INTERVALS;
use passivity_scene::scene::DEFAULT_INTERVALS;
use passivity_scene::{Point, Scene};
#[cfg(feature = "plot")]
use passivity_sim::plot::motion::{Motion, draw};
use passivity_sim::report::Simulation;
#[cfg(feature = "plot")]
use passivity_sim::scales::Scales;
use passivity_sim::scales::has_ticks_or_unit;
use passivity_sim::trace::Table;
use passivity_sim::{
    Beyond, ExactOutcome, Line, Method, Plan, SimError, Simulated, simulate_beyond,
};

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources};
use crate::output::{Format, emit, emit_json, look, read_scene};
use crate::progress::Progress;
pub(crate) use text::deciding;
use text::text;

/// Simulate a scene: the motion between samples in closed form, with the energy ledger.
///
/// Exit codes: 0 the device comes to rest; 1 it does not, or the outcome is not certain; 2 bad input.
#[derive(Debug, clap::Args)]
#[command(after_help = "Methods:
  closed-form     closed form in double precision, without a step size (default)
  exact           rational numbers, for scenes without viscous friction
  reference:50    closed form with the given number of decimal digits
  enclosure       rigorous bounds, with more digits until they decide the outcome
  euler:10        semi-implicit Euler with the given number of steps in each interval
  rk4:10          Runge-Kutta of order 4 with the given number of steps in each interval
  adaptive:1e-9   Dormand-Prince with event detection and the given tolerance

Examples:
  passivity simulate scenes/re35.toml --speed 5 --out trace.csv --plot motion.svg
  passivity simulate scenes/re35.toml --speed 5 --method enclosure --out bounds.csv
  passivity simulate scenes/dimensionless.toml --method reference:60 --format json")]
pub(crate) struct Args {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// The simulation method, with its parameter after a colon; see the list below.
    #[arg(long, value_name = "METHOD", default_value = "closed-form")]
    method: String,
    /// The number of sampling intervals to simulate, in place of the scene's; a motion that grows for certain is
    /// simulated on to it.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = intervals)]
    intervals: Option<u64>,
    #[command(flatten)]
    start: Start,
    /// Write the energy ledger to this CSV file, one row per interval.
    #[arg(long, value_name = "FILE", value_parser = crate::files::csv())]
    out: Option<PathBuf>,
    /// Write the ledger in SI units: seconds, metres or radians, joules; its last row is the sample at the end.
    #[arg(long, requires = "out")]
    si: bool,
    /// Add to the JSON how many seconds the simulation took; without it the same input gives the same
    /// bytes.
    #[arg(long)]
    timing: bool,
    /// Draw the motion into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// The first interval to draw, counted from 0.
    #[arg(
        long,
        value_name = "N",
        requires = "plot",
        default_value_t = 0,
        allow_negative_numbers = true,
        value_parser = crate::args::whole(0..=MAX_INTERVALS)
    )]
    plot_from: u64,
    /// The interval before which the picture ends; by default all are drawn.
    #[arg(
        long,
        value_name = "N",
        requires = "plot",
        allow_negative_numbers = true,
        value_parser = crate::args::whole(0..=MAX_INTERVALS)
    )]
    plot_until: Option<u64>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

impl Args {
    /// How far a motion is simulated after its divergence became certain: as far as was asked for, or,
    /// where neither the scene nor the command says how far, far enough to see it grow.
    fn beyond(&self, scene: &Scene) -> Beyond {
        if self.intervals.is_some() {
            return Beyond::All;
        }
        match self.out.is_some() || self.plot.is_some() {
            true if scene.intervals != DEFAULT_INTERVALS => Beyond::All,
            true => Beyond::Tenfold,
            false => Beyond::Nothing,
        }
    }
}

/// Simulates the scene.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let inputs = sources(&scene, &args.scene);
    let outputs = [("--out", args.out.as_ref()), ("--plot", args.plot.as_ref())];
    may_be_written(&outputs, &inputs, "simulation")?;
    crate::picture::check(args.plot.as_deref())?;
    let mut point = scene.point();
    if let Some(intervals) = args.intervals {
        point.intervals = intervals;
    }
    begins_before_its_end(args)?;
    args.start.put(&scene, &mut point)?;
    let method = Method::parse(&args.method).map_err(Failure::input)?;
    let of_scene = |error| args.start.blamed(&args.scene, &error);
    let plan = Plan::compile(&point).map_err(of_scene)?;
    let mut watcher = Watcher::new(args, &scene, &point, &plan, &method)?;
    let begin = Instant::now();
    let beyond = args.beyond(&scene);
    let run = if watcher.wants_to_see(args) {
        simulate_beyond(&point, &method, beyond, Some(&mut |line| watcher.see(line)))
    } else {
        simulate_beyond(&point, &method, beyond, None)
    };
    let run = match run {
        Ok(run) => run,
        Err(error) => {
            watcher.abandon()?;
            return Err(of_scene(error));
        }
    };
    let seconds = begin.elapsed().as_secs_f64();
    watcher.finish(args, &scene, point.intervals, &run)?;
    let timed = (args.timing || args.format == Format::Text).then_some(seconds);
    let report = Simulation::new(&scene, &plan, &method, &run, timed).map_err(of_scene)?;
    match args.format {
        Format::Text => emit(&text(&report, &plan, &run, beyond, &scene))?,
        Format::Json => emit_json(&report)?,
    }
    Ok(match run.end.outcome.exact {
        ExactOutcome::AtRest => Exit::Holds,
        _ => Exit::Fails,
    })
}

/// Refuses a picture that ends before it begins.
fn begins_before_its_end(args: &Args) -> Result<(), Failure> {
    match args.plot_until {
        Some(until) if until <= args.plot_from => Err(Failure::input(format!(
            "--plot-until {until}: expected an interval after that of --plot-from, {}",
            args.plot_from
        ))),
        _ => Ok(()),
    }
}

/// Refuses a picture of none of the intervals that there are.
fn something_to_draw(args: &Args, intervals: u64) -> Result<(), Failure> {
    let from = args.plot_from;
    match args.plot.is_none() || from < intervals {
        true => Ok(()),
        false => Err(Failure::input(format!(
            "--plot-from {from}: there is nothing to draw, as the motion has {intervals} intervals, counted from 0"
        ))),
    }
}

/// What sees the intervals of a run: a trace, a picture and a progress bar.
struct Watcher {
    trace: Option<Trace>,
    #[cfg(feature = "plot")]
    motion: Option<Motion>,
    bar: Progress,
    terminal: bool,
    seen: u64,
}

impl Watcher {
    /// Intervals between two looks at the clock.
    const BETWEEN: u64 = 1 << 10;

    fn new(
        args: &Args,
        scene: &Scene,
        point: &Point,
        plan: &Plan,
        method: &Method,
    ) -> Result<Self, Failure> {
        #[cfg(not(feature = "plot"))]
        let _ = plan;
        Ok(Self {
            trace: match &args.out {
                Some(path) => Some(Trace::create(path, table(args, scene, point, method)?)?),
                None => None,
            },
            #[cfg(feature = "plot")]
            motion: args.plot.is_some().then(|| {
                let until = args.plot_until.unwrap_or(u64::MAX);
                Motion::new(plan).between(args.plot_from, until)
            }),
            bar: Progress::new(point.intervals, "intervals"),
            terminal: std::io::stderr().is_terminal(),
            seen: 0,
        })
    }

    fn wants_to_see(&self, args: &Args) -> bool {
        args.out.is_some() || args.plot.is_some() || self.terminal
    }

    /// Sees an interval; `false` ends the run.
    fn see(&mut self, line: &Line<'_>) -> bool {
        #[cfg(feature = "plot")]
        if let Some(motion) = &mut self.motion {
            motion.add(&line.entry());
        }
        self.seen += 1;
        if self.terminal && self.seen.is_multiple_of(Self::BETWEEN) {
            self.bar.advance(Self::BETWEEN);
        }
        self.trace.as_mut().is_none_or(|trace| trace.take(line))
    }

    /// Keeps the rows of a run that ended before its time, if there are any.
    fn abandon(self) -> Result<(), Failure> {
        match self.trace {
            Some(trace) if self.seen > 0 => trace.finish(),
            _ => Ok(()),
        }
    }

    /// Writes what is left to write.
    fn finish(
        self,
        args: &Args,
        scene: &Scene,
        intervals: u64,
        run: &Simulated,
    ) -> Result<(), Failure> {
        drop(self.bar);
        if let Some(trace) = self.trace {
            trace.finish()?;
        }
        let rests = run.end.intervals == 0 && run.end.outcome.exact == ExactOutcome::AtRest;
        let shown = if rests { intervals } else { run.end.intervals };
        something_to_draw(args, shown)?;
        #[cfg(feature = "plot")]
        if let (Some(path), Some(mut motion)) = (&args.plot, self.motion) {
            if rests {
                motion.rest(intervals);
            }
            let title = format!("{}: {}", scene.name, words(run.end.outcome.exact));
            let picture = draw(&title, motion, &Scales::of(scene));
            save(&picture, path).map_err(Failure::input)?;
        }
        #[cfg(not(feature = "plot"))]
        let _ = scene;
        Ok(())
    }
}

/// An outcome in words.
pub(crate) fn words(outcome: ExactOutcome) -> String {
    outcome.name().replace('_', " ")
}

/// How a simulation starts, where not as the scene says.
#[derive(Debug, clap::Args)]
pub(crate) struct Start {
    /// The speed at the start in place of the scene's: with a unit, or in ticks per sample where it has an encoder.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    speed: Option<String>,
}

impl Start {
    /// Puts what was typed in place of the scene's.
    pub(crate) fn put(&self, scene: &Scene, point: &mut Point) -> Result<(), Failure> {
        if let Some(text) = &self.speed {
            has_ticks_or_unit(scene, text)
                .map_err(|error| Failure::input(format!("--speed `{text}`: {error}")))?;
            let speed = scene.ticks_per_sample(text).map_err(|error| {
                let kinds = error.diagnostics().iter().map(|problem| problem.kind().name());
                // A number alone is in ticks per sample, and was read before.
                match kinds.into_iter().any(|kind| kind == "missing_unit") {
                    true => Failure::input(format!(
                        "--speed `{text}`: expected one number of ticks per sample, without a tolerance, or a \
                         speed with a unit"
                    )),
                    false => Failure::Scene(format!("--speed `{text}`: {}", error.render(look()))),
                }
            })?;
            point.at.start_velocity = Some(speed);
        }
        Ok(())
    }

    /// The failure of what was typed in place of the scene's, or of the scene.
    pub(crate) fn blamed(&self, scene: &Path, error: &SimError) -> Failure {
        let of_speed = Parameter::StartVelocity.row().name;
        match (&self.speed, error) {
            (Some(text), SimError::OutOfRange { parameter, .. }) if *parameter == of_speed => {
                Failure::input(format!("--speed `{text}`: {error}"))
            }
            _ => Failure::input(format!("`{}`: {error}", scene.display())),
        }
    }
}

/// Reads a number of sampling intervals.
pub(crate) fn intervals(text: &str) -> Result<u64, String> {
    let number = parse(text).ok().filter(BigRational::is_integer);
    let whole = number.and_then(|number| u64::try_from(number.numer()).ok());
    whole
        .filter(|intervals| (1..=MAX_INTERVALS).contains(intervals))
        .ok_or_else(|| format!("expected a whole number from 1 to {MAX_INTERVALS}"))
}

/// The table of the run, in the units that were asked for.
fn table(args: &Args, scene: &Scene, point: &Point, method: &Method) -> Result<Table, Failure> {
    let table = Table::new(scene, point, method);
    if !args.si {
        return Ok(table);
    }
    table.in_si(point).ok_or_else(|| {
        Failure::input("`--si` needs a scene in units and a method that gives numbers, not bounds")
    })
}

/// The file of a trace.
struct Trace {
    path: PathBuf,
    table: Table,
    file: Output,
    line: String,
    failed: Option<Failure>,
}

impl Trace {
    fn create(path: &Path, table: Table) -> Result<Self, Failure> {
        let failed = |error| unwritten(path, &error);
        let mut file = Output::create(path).map_err(failed)?;
        writeln!(file, "{}", table.header()).map_err(failed)?;
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
        let row = self.table.write(line, &mut self.line);
        let put = row.map_err(Failure::input).and_then(|()| {
            let put = self.file.write_all(self.line.as_bytes());
            put.map_err(|error| unwritten(&self.path, &error))
        });
        self.failed = put.err();
        self.failed.is_none()
    }

    fn finish(mut self) -> Result<(), Failure> {
        if let Some(failure) = self.failed {
            return Err(failure);
        }
        self.line.clear();
        self.table.end(&mut self.line);
        let put = self.file.write_all(self.line.as_bytes());
        put.and_then(|()| self.file.keep())
            .map_err(|error| unwritten(&self.path, &error))
    }
}

/// Why a trace's file cannot be written.
fn unwritten(path: &Path, error: &std::io::Error) -> Failure {
    Failure::io(format!("`{}`", path.display()), error)
}
