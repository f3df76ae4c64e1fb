//! Sweeps: whole, in shards, and of chosen points.

use std::path::{Path, PathBuf};

use passivity_scene::Point;
use passivity_sim::SimError;
use passivity_sim::report::{Outcomes, Sweep};
use passivity_sim::sweep::{
    Asked, Grid, Row, Shard, check_points, merge, open, run_range, side_files, write_shard,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::output::may_be_written;
use crate::scene::{Source, of_simulation};
use crate::watch::{Watch, follow};

/// A grid as Python gives it.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Ranges {
    beta: Option<String>,
    sigma: Option<String>,
    speed: Option<String>,
    vary: Vec<String>,
    intervals: Option<u64>,
}

/// What is swept.
struct Task {
    name: String,
    point: Point,
    grid: Grid,
}

impl Task {
    fn new(py: Python<'_>, scene: &Source, ranges: &Ranges) -> PyResult<Self> {
        let scene = scene.read(py)?;
        let mut point = scene.point();
        if let Some(intervals) = ranges.intervals {
            point.intervals = intervals;
        }
        let asked = Asked {
            beta: ranges.beta.as_deref(),
            sigma: ranges.sigma.as_deref(),
            speed: ranges.speed.as_deref(),
            vary: &ranges.vary,
        };
        let grid = asked.grid(&scene, &point);
        Ok(Self {
            name: scene.name,
            point,
            grid: grid.map_err(|error| of_simulation(&error))?,
        })
    }
}

/// Refuses to write the rows of a sweep, and the files beside them, over what is read or no plain file.
fn may_be_swept(out: &Path, inputs: &[&Path]) -> PyResult<()> {
    may_be_written(out, inputs)?;
    let beside = side_files(out);
    beside
        .iter()
        .try_for_each(|path| may_be_written(path, inputs))
}

fn stopped() -> SimError {
    SimError::File("the sweep was stopped".to_owned())
}

fn json(report: &Sweep) -> PyResult<String> {
    serde_json::to_string(report).map_err(|error| PyValueError::new_err(error.to_string()))
}

/// How many points a grid has, the names of its axes, and their values.
#[pyfunction]
pub(crate) fn grid(
    py: Python<'_>,
    scene: Source,
    ranges: Ranges,
) -> PyResult<(usize, Vec<String>, Vec<Vec<f64>>)> {
    let task = Task::new(py, &scene, &ranges)?;
    let values = task.grid.values.iter();
    let values = values.map(|axis| axis.doubles().collect());
    Ok((task.grid.len(), task.grid.columns(), values.collect()))
}

/// Simulates a shard of a grid into a file: the pieces from one to another of so many. Gives the report as
/// JSON.
#[pyfunction]
#[pyo3(signature = (scene, ranges, out, shard=None, resume=false, threads=0, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named where they are given")]
pub(crate) fn sweep(
    py: Python<'_>,
    scene: Source,
    ranges: Ranges,
    out: PathBuf,
    shard: Option<(usize, usize, usize)>,
    resume: bool,
    threads: usize,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<String> {
    let inputs: Vec<&Path> = scene.path().into_iter().collect();
    may_be_swept(&out, &inputs)?;
    let task = Task::new(py, &scene, &ranges)?;
    let shard = shard.map(|(first, last, count)| Shard::run(first, last, count));
    let shard = shard.transpose().map_err(|error| of_simulation(&error))?;
    let report = follow(py, progress.as_ref(), move |watch| {
        swept(&task, &out, shard, resume, threads, watch)
    })?;
    json(&report.map_err(|error| of_simulation(&error))?)
}

fn swept(
    task: &Task,
    out: &Path,
    shard: Option<Shard>,
    resume: bool,
    threads: usize,
    watch: &Watch,
) -> Result<Sweep, SimError> {
    let Task { name, point, grid } = task;
    let range = grid.points(shard.unwrap_or(Shard::WHOLE))?;
    let begin = std::time::Instant::now();
    let mut outcomes = Outcomes::default();
    // A shard is done anew where it was interrupted: only a whole grid has a file of the rows on the way.
    let kept = shard.map_or(0, |_| range.len());
    let mut rows: Vec<Option<Row>> = vec![None; kept];
    let (mut file, done) = match shard {
        Some(_) => (None, Vec::new()),
        None => {
            if out.exists() && !resume {
                check_points(point, grid, range.clone())?; // No rows are lost to what cannot be simulated.
            }
            let opened = open(out, point, grid, resume, |_, row| outcomes.count(row))?;
            (Some(opened.rows), opened.done)
        }
    };
    let before = done.iter().filter(|done| **done).count();
    watch.set(before as u64);
    run_range(point, grid, range.clone(), &done, threads, |index, row| {
        outcomes.count(&row);
        if let Some(slot) = rows.get_mut(index - range.start) {
            *slot = Some(row);
        }
        if let Some(file) = &mut file {
            file.add(grid, index, &row)?;
        }
        watch.add(1).then_some(()).ok_or_else(stopped)
    })?;
    match (file, shard) {
        (Some(file), _) => file.finish(grid)?,
        (None, shard) => write_shard(out, point, grid, shard.unwrap_or(Shard::WHOLE), &rows)?,
    }
    let seconds = begin.elapsed().as_secs_f64();
    let simulated = range.len() - before;
    Ok(Sweep::new(
        name,
        range.len(),
        outcomes,
        simulated,
        point.intervals,
        seconds,
    ))
}

/// Writes all shards of a sweep as one file; gives the report as JSON.
#[pyfunction]
#[pyo3(signature = (scene, ranges, parts, out, progress=None))]
pub(crate) fn sweep_merge(
    py: Python<'_>,
    scene: Source,
    ranges: Ranges,
    parts: Vec<PathBuf>,
    out: PathBuf,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<String> {
    let beside: Vec<PathBuf> = parts.iter().flat_map(|part| side_files(part)).collect();
    let read = parts.iter().chain(&beside).map(PathBuf::as_path);
    let inputs: Vec<&Path> = read.chain(scene.path()).collect();
    may_be_swept(&out, &inputs)?;
    let task = Task::new(py, &scene, &ranges)?;
    let report = follow(py, progress.as_ref(), move |watch| {
        let mut outcomes = Outcomes::default();
        let begin = std::time::Instant::now();
        merge(&parts, &out, &task.point, &task.grid, |_, row| {
            outcomes.count(row);
            watch.add(1);
        })?;
        let seconds = begin.elapsed().as_secs_f64();
        let (points, intervals) = (task.grid.len(), task.point.intervals);
        Ok(Sweep::new(
            &task.name, points, outcomes, 0, intervals, seconds,
        ))
    })?;
    json(&report.map_err(|error: SimError| of_simulation(&error))?)
}

/// The outcome of a point: by the paper, exactly, at which interval, and the state at the end.
type Outcome = (&'static str, &'static str, Option<u64>, f64, f64);

/// Simulates the points of a grid that have these indices; their outcomes in the same order.
#[pyfunction]
#[pyo3(signature = (scene, ranges, indices, threads=0, progress=None))]
pub(crate) fn sweep_points(
    py: Python<'_>,
    scene: Source,
    ranges: Ranges,
    indices: Vec<usize>,
    threads: usize,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Vec<Outcome>> {
    let task = Task::new(py, &scene, &ranges)?;
    let rows = follow(py, progress.as_ref(), move |watch| {
        let [least, most] = [indices.iter().min(), indices.iter().max()];
        let (Some(&from), Some(&to)) = (least, most) else {
            return Ok(Vec::new());
        };
        if to >= task.grid.len() {
            return Err(SimError::Method(format!(
                "point {to}: the grid has {} points, counted from 0",
                task.grid.len()
            )));
        }
        let mut done = vec![true; to + 1 - from];
        for index in &indices {
            if let Some(slot) = done.get_mut(index - from) {
                *slot = false;
            }
        }
        let mut rows: std::collections::HashMap<usize, Row> = std::collections::HashMap::new();
        let range = from..to + 1;
        run_range(
            &task.point,
            &task.grid,
            range,
            &done,
            threads,
            |index, row| {
                rows.insert(index, row);
                watch.add(1).then_some(()).ok_or_else(stopped)
            },
        )?;
        let found = indices.iter().filter_map(|index| rows.get(index).copied());
        Ok(found.collect::<Vec<_>>())
    })?;
    let rows = rows.map_err(|error| of_simulation(&error))?;
    let outcome = |row: Row| {
        let (paper, exact) = (row.paper.name(), row.exact.name());
        (paper, exact, row.at_interval, row.xi, row.velocity)
    };
    Ok(rows.into_iter().map(outcome).collect())
}
