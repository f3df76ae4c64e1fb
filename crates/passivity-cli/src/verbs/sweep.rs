//! `passivity sweep`: the outcome of every point of a grid, as in Fig. 5.

use std::path::PathBuf;
use std::time::Instant;

#[cfg(feature = "plot")]
use passivity_plot::{critical::Borders, save};
#[cfg(feature = "plot")]
use passivity_sim::plot::sweep::draw;
use passivity_sim::report::Sweep;
use passivity_sim::sweep::{Grid, Range, Row, open, run as sweep};

use crate::exit::{Exit, Failure};
use crate::output::{Format, emit, emit_json, may_be_written, read_scene};
use crate::progress::Progress;

/// Simulate every point of a grid of (β, σ, speed at the start), on all cores (Fig. 5 of the paper).
///
/// All other parameters are those of the scene. A range is start:stop:count with both ends included, or
/// a list such as 1,2,5. An interrupted sweep is continued with --resume.
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
    /// Speeds at the start, in ticks per sample; by default the scene's.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    speed: Option<String>,
    /// The number of sampling intervals to simulate, in place of the scene's.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    intervals: Option<u64>,
    /// Write the outcomes to this file, one row per point: CSV, or Parquet if its name ends in .parquet.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Continue the interrupted sweep whose results are in the file of --out.
    #[arg(long, requires = "out")]
    resume: bool,
    /// Draw Fig. 5 into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Sweeps the grid.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    for output in [&args.out, &args.plot].into_iter().flatten() {
        may_be_written(output, &[&args.scene], "sweep")?;
    }
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
        let borders = Borders::of(&point.at);
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
        "{}: {} points, of which {} were simulated now, in {:.3} s\n  \
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
