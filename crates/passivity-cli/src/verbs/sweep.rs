//! `passivity sweep`: the outcome of every point of a grid, as in Fig. 5.

use std::path::PathBuf;
use std::time::Instant;

#[cfg(feature = "plot")]
use passivity_plot::save;
#[cfg(feature = "plot")]
use passivity_sim::plot::sweep::{Borders, draw};
use passivity_sim::report::Sweep;
use passivity_sim::sweep::{Grid, Range, Row, open, run as sweep};

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, read_scene};
use crate::progress::Progress;

/// Simulate every point of a grid of (β, σ, speed at the start), on all cores (Fig. 5 of the paper).
///
/// Everything but β, σ and the speed is the scene's. Ranges are start:stop:count, both ends included,
/// or lists as in 1,2,5. A sweep that was killed is taken up again with --resume.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 --speed 1/2,1,2,5 \\
      --out fig5.csv --plot fig5.png
  passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 --speed 1/2,1,2,5 \\
      --out fig5.csv --resume")]
pub(crate) struct Args {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Values of β.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    beta: String,
    /// Values of σ.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    sigma: String,
    /// Speeds at the start, in ticks per sample; the scene's when not given.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    speed: Option<String>,
    /// How many intervals to run, instead of what the scene says.
    #[arg(long, value_name = "N")]
    intervals: Option<u64>,
    /// Where to write the outcomes, a row per point: CSV, or Parquet when the name ends in .parquet.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Go on with what a sweep that was stopped has left in --out.
    #[arg(long, requires = "out")]
    resume: bool,
    /// Where to draw Fig. 5: a name that ends in .svg or .png.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// For people or for programs.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Sweeps the grid.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let mut point = scene.point();
    if let Some(intervals) = args.intervals {
        point.intervals = intervals;
    }
    let range = |text: &str| Range::parse(text).map_err(Failure::input);
    let speed = match &args.speed {
        Some(text) => range(text)?,
        None => {
            let [_, velocity] = point.start();
            Range {
                values: vec![velocity],
            }
        }
    };
    let grid = Grid::new(range(&args.beta)?, range(&args.sigma)?, speed).map_err(Failure::input)?;
    let mut rows: Vec<Option<Row>> = vec![None; grid.len()];
    let mut file = None;
    let mut before = 0;
    if let Some(path) = &args.out {
        let opened = open(path, &point, &grid, args.resume).map_err(Failure::input)?;
        before = opened.found.len();
        for (index, row) in opened.found {
            rows[index] = Some(row);
        }
        file = Some(opened.rows);
    }
    let mut bar = Progress::new(grid.len() as u64, "points");
    bar.start_at(before as u64);
    let begin = Instant::now();
    let done: Vec<bool> = rows.iter().map(Option::is_some).collect();
    let swept = sweep(&point, &grid, &done, |index, row| {
        rows[index] = Some(row);
        bar.advance(1);
        match &mut file {
            Some(file) => file.add(&grid, index, &row),
            None => Ok(()),
        }
    });
    let seconds = begin.elapsed().as_secs_f64();
    drop(bar);
    let written = match (swept, file) {
        (Ok(()), Some(file)) => file.finish(&grid, &rows),
        (result, _) => result,
    };
    written.map_err(|error| Failure::input(format!("`{}`: {error}", args.scene.display())))?;
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let covered = scene.not_covered().is_empty();
        let borders = covered.then(|| Borders::of(&point.at));
        let picture = draw(&grid, &rows, borders).map_err(Failure::input)?;
        save(&picture, path).map_err(Failure::input)?;
    }
    let simulated = grid.len() - before;
    let report = Sweep::new(
        &scene.name,
        &grid,
        &rows,
        simulated,
        point.intervals,
        seconds,
    );
    match args.format {
        Format::Text => emit(&text(&report))?,
        Format::Json => emit_json(&report)?,
    }
    Ok(Exit::Holds)
}

fn text(report: &Sweep) -> String {
    let (exact, paper) = (&report.exact, &report.paper);
    format!(
        "{}: {} points, {} of them now in {:.3} s\n  \
         exactly       {} at rest, {} never at rest, {} growing, {} undecided\n  \
         by the paper  {} converged, {} limit cycles, {} unstable",
        report.scene,
        report.points,
        report.simulated,
        report.seconds,
        exact.at_rest,
        exact.never_at_rest,
        exact.growing,
        exact.undecided,
        paper.converged,
        paper.limit_cycle,
        paper.unstable,
    )
}
