//! `passivity sweep`: the outcome of every point of a grid, as in Fig. 5.

use std::path::PathBuf;
use std::time::Instant;

use passivity_scene::Point;
use passivity_sim::report::{Outcomes, Sweep};
use passivity_sim::sweep::{
    Asked, Grid, Row, Shard, check_points, merge, open, open_shard, run_range, side_files,
};
use passivity_sim::{Plan, SimError};

use crate::exit::{Exit, Failure};
use crate::files::{may_be_written, sources};
use crate::output::{Format, emit, emit_json, read_scene};
use crate::progress::Progress;
use crate::verbs::simulate::{deciding, intervals};

/// Simulate every point of a grid, on all cores: of (β, σ, speed at the start), Fig. 5 of the paper, or
/// of any two or three parameters of the scene.
///
/// All other parameters are those of the scene. A range is start:stop:count with both ends included, or
/// a list such as 1,2,5; for a parameter of the scene its unit follows. An interrupted sweep is continued
/// with --resume.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 --speed 1/2,1,2,5 \\
      --out fig5.csv --plot fig5.png
  passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 --speed 1/2,1,2,5 \\
      --out fig5.csv --resume
  for i in 1 2 3 4; do passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 \\
      --shard $i/4 --out part-$i.parquet; done     # each on another machine, if you like
  passivity sweep scenes/re35.toml --beta 0:1:41 --sigma 0:1.5:61 \\
      --merge part-*.parquet --out fig5.parquet
  passivity sweep scenes/re35-limit-cycles.toml --vary 'stiffness=0.05:0.5:31 N m/rad' \\
      --vary 'viscous=0:2e-5:31 N m s/rad' --vary 'velocity=1,5 rad/s' \\
      --out grid.csv --plot grid.png

Exit codes: 0 all points are simulated, whatever they show; 2 bad input, or a file that cannot be
written: `--resume` goes on from there.")]
pub(crate) struct Args {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Values of β.
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        required_unless_present = "vary"
    )]
    beta: Option<String>,
    /// Values of σ.
    #[arg(
        long,
        value_name = "RANGE",
        allow_hyphen_values = true,
        required_unless_present = "vary"
    )]
    sigma: Option<String>,
    /// Speeds at the start, in ticks per sample; by default the scene's.
    #[arg(long, value_name = "RANGE", allow_hyphen_values = true)]
    speed: Option<String>,
    /// A parameter of the scene by its key, with a range and a unit; two or three of them, the first on x. Behind
    /// a transmission it is at the side where the scene gives it, unless `at the motor` or `at the device` follows.
    #[arg(long, value_name = "KEY=RANGE UNIT", conflicts_with_all = ["beta", "sigma", "speed"])]
    vary: Vec<String>,
    /// The number of sampling intervals to simulate, in place of the scene's.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = intervals)]
    intervals: Option<u64>,
    /// Write the outcomes to this file, one row per point: CSV, or Parquet if its name ends in .parquet.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Continue the interrupted sweep whose results are in the file of --out.
    #[arg(long, requires = "out")]
    resume: bool,
    /// Simulate one piece of the grid only: `3/8` is the third of eight, as even as they can be, and
    /// `3-5/8` the third to the fifth.
    #[arg(long, value_name = "I[-J]/N", requires = "out", conflicts_with = "plot", value_parser = Shard::parse)]
    shard: Option<Shard>,
    /// Simulate nothing: write the files of all shards of this sweep as one, the same as that of one run.
    #[arg(long, value_name = "PART", num_args = 1.., requires = "out", conflicts_with_all = ["shard", "resume"])]
    merge: Vec<PathBuf>,
    /// Draw the outcomes into this file, as SVG or PNG according to its extension.
    #[arg(long, value_name = "FILE", value_parser = crate::picture::path)]
    plot: Option<PathBuf>,
    /// How to write the result.
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

/// Sweeps the grid.
pub(crate) fn run(args: &Args) -> Result<Exit, Failure> {
    let scene = read_scene(&args.scene)?;
    let mut inputs = sources(&scene, &args.scene);
    for part in &args.merge {
        inputs.push(part.clone());
        inputs.extend(side_files(part));
    }
    let beside = args
        .out
        .iter()
        .flat_map(|out| side_files(out))
        .collect::<Vec<_>>();
    let mut outputs = vec![("--out", args.out.as_ref()), ("--plot", args.plot.as_ref())];
    outputs.extend(
        beside
            .iter()
            .map(|path| ("the files beside that of --out", Some(path))),
    );
    may_be_written(&outputs, &inputs, "sweep")?;
    crate::picture::check(args.plot.as_deref())?;
    let mut point = scene.point();
    if let Some(intervals) = args.intervals {
        point.intervals = intervals;
    }
    let asked = Asked {
        beta: args.beta.as_deref(),
        sigma: args.sigma.as_deref(),
        speed: args.speed.as_deref(),
        vary: &args.vary,
    };
    let grid = asked.grid(&scene, &point).map_err(Failure::input)?;
    let begin = Instant::now();
    let swept = match args.merge.is_empty() {
        true => simulated(args, &point, &grid)?,
        false => merged(args, &point, &grid)?,
    };
    let seconds = begin.elapsed().as_secs_f64();
    #[cfg(feature = "plot")]
    if let Some(path) = &args.plot {
        let picture = picture::draw(&scene, &point, &grid, &swept.seen.rows);
        passivity_plot::save(&picture, path).map_err(Failure::input)?;
    }
    let report = Sweep::new(
        &scene.name,
        swept.points,
        swept.seen.outcomes,
        swept.simulated,
        point.intervals,
        seconds,
    );
    match args.format {
        Format::Text => {
            let ends = [0, grid.len().saturating_sub(1)];
            emit(&text(&report, &ends.map(|index| grid.point(&point, index))))?;
        }
        Format::Json => emit_json(&report)?,
    }
    Ok(Exit::Holds)
}

/// What a sweep gave.
struct Swept {
    seen: Seen,
    points: usize,
    /// How many of them were simulated now.
    simulated: usize,
}

/// What is kept of rows: how many there are of each kind, and all of them only where they are to be drawn.
struct Seen {
    outcomes: Outcomes,
    start: usize,
    rows: Vec<Option<Row>>,
}

impl Seen {
    fn new(args: &Args, range: std::ops::Range<usize>) -> Self {
        let drawn = args.plot.as_ref().map_or(0, |_| range.len());
        Self {
            outcomes: Outcomes::default(),
            start: range.start,
            rows: vec![None; drawn],
        }
    }

    fn see(&mut self, index: usize, row: &Row) {
        self.outcomes.count(row);
        if let Some(slot) = self.rows.get_mut(index - self.start) {
            *slot = Some(*row);
        }
    }
}

/// Simulates the points that are asked for and not in the file yet.
fn simulated(args: &Args, point: &Point, grid: &Grid) -> Result<Swept, Failure> {
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    let range = grid.points(shard).map_err(Failure::input)?;
    let mut seen = Seen::new(args, range.clone());
    let mut file = None;
    let mut done = Vec::new();
    let of_scene = |error: SimError| match error {
        SimError::File(message) => Failure::input(message),
        error => Failure::input(format!("`{}`: {error}", args.scene.display())),
    };
    if let Some(path) = &args.out {
        // All of them where rows are there that would be lost; one tells of what they have in common.
        let most = match path.exists() && !args.resume {
            true => range.len(),
            false => 1,
        };
        check_points(point, grid, range.clone().take(most)).map_err(of_scene)?;
        let opened = match args.shard {
            Some(shard) => open_shard(path, point, grid, shard, args.resume, |i, row| {
                seen.see(i, row)
            }),
            None => open(path, point, grid, args.resume, |i, row| seen.see(i, row)),
        };
        let opened = opened.map_err(Failure::input)?;
        done = opened.done;
        file = Some(opened.rows);
    }
    let before = done.iter().filter(|done| **done).count();
    let mut bar = Progress::new(range.len() as u64, "points");
    bar.start_at(before as u64);
    let swept = run_range(point, grid, range.clone(), &done, 0, |index, row| {
        seen.see(index, &row);
        bar.advance(1);
        match &mut file {
            Some(file) => file.add(grid, index, &row),
            None => Ok(()),
        }
    });
    drop(bar);
    let written = match (swept, file) {
        (Ok(()), Some(file)) => file.finish(grid),
        (result, _) => result,
    };
    written.map_err(of_scene)?;
    Ok(Swept {
        seen,
        points: range.len(),
        simulated: range.len() - before,
    })
}

/// Writes all shards as one file.
fn merged(args: &Args, point: &Point, grid: &Grid) -> Result<Swept, Failure> {
    let Some(out) = &args.out else {
        return Err(Failure::input("--merge needs --out"));
    };
    let range = match args.plot {
        Some(_) => grid.points(Shard::WHOLE).map_err(Failure::input)?,
        None => 0..0,
    };
    let mut seen = Seen::new(args, range);
    let done = merge(&args.merge, out, point, grid, |index, row| {
        seen.see(index, row)
    });
    done.map_err(Failure::input)?;
    Ok(Swept {
        seen,
        points: grid.len(),
        simulated: 0,
    })
}

/// The picture of a sweep.
#[cfg(feature = "plot")]
mod picture {
    use passivity_core::Interval;
    use passivity_plot::critical::Borders;
    use passivity_scene::plane::{Extent, Line, Plane, Region, Speeds};
    use passivity_scene::{Given, Point, Scene};
    use passivity_sim::plot::sweep::{MapBorders, draw as draw_fig5, draw_maps, shown};
    use passivity_sim::sweep::{Grid, Range, Row};

    pub(super) fn draw(scene: &Scene, point: &Point, grid: &Grid, rows: &[Option<Row>]) -> String {
        if grid.parameters().is_empty() {
            return draw_fig5(grid, rows, Borders::of(&point.at));
        }
        let [_, _, third] = &grid.values;
        let few = if shown(grid).len() < third.len() {
            format!(", at {} of {} values", shown(grid).len(), third.len())
        } else {
            String::new()
        };
        let title = format!("{}: what becomes of the motion{few}", scene.name);
        draw_maps(&title, grid, rows, &borders(scene, grid))
    }

    /// Where the criterion holds in each map: nothing where one of its axes is no part of the criterion.
    fn borders(scene: &Scene, grid: &Grid) -> MapBorders {
        let in_map = |third: usize| borders_of(scene, grid, third).unwrap_or_default();
        shown(grid).into_iter().map(in_map).collect()
    }

    fn borders_of(scene: &Scene, grid: &Grid, third: usize) -> Option<[Vec<Line>; 2]> {
        let [x, y, rest @ ..] = grid.parameters() else {
            return None;
        };
        let [xs, ys, thirds] = &grid.values;
        let mut scene = scene.clone();
        if let Some(axis) = rest.first() {
            let si = axis.si(&thirds.value(third))?;
            let given = Given {
                value: Interval::point(si.clone()),
                nominal: si,
                ..Given::unit(axis.parameter())
            };
            scene.given = scene.given.with(axis.parameter(), given);
        }
        let plane = Plane::new(&scene, [x.clone(), y.clone()]).ok()?;
        let extent = |values: &Range| {
            let [from, to] = [
                values.doubles().reduce(f64::min)?,
                values.doubles().reduce(f64::max)?,
            ];
            (from < to).then_some(Extent {
                from,
                to,
                log: false,
            })
        };
        let window = [extent(xs)?, extent(ys)?];
        let mut borders = [Vec::new(), Vec::new()];
        for speeds in plane.speeds() {
            let [every, bound] = &mut borders;
            let slot = match speeds {
                Speeds::Every => every,
                Speeds::UpToBound => bound,
            };
            *slot = Region::of(&plane, &window, speeds).borders;
        }
        Some(borders)
    }
}

/// The report in words, of points between these.
fn text(report: &Sweep, points: &[Point]) -> String {
    let (exact, paper) = (&report.exact, &report.paper);
    let near = match report.within_rounding_of_edge {
        0 => String::new(),
        n => format!(
            "\n  of those simulated now, {n} had a sample within rounding of {}, from which on the motion may be \
             another one: in `simulate`, {}",
            points
                .first()
                .and_then(|point| Plan::compile(point).ok())
                .map_or_else(String::new, |plan| plan.edge_words()),
            deciding(points)
        ),
    };
    format!(
        "{}: {} {}, of which {} {} simulated now, in {:.3} s\n  \
         exactly       {} at rest, {} never at rest, {} growing, {} undecided\n  \
         by the paper  {} converged, {} limit cycles, {} unstable{near}",
        report.scene,
        report.points,
        if report.points == 1 {
            "point"
        } else {
            "points"
        },
        report.simulated,
        if report.simulated == 1 { "was" } else { "were" },
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
