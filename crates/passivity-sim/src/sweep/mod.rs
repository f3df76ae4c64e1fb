//! Sweeps: the outcome of every point of a grid, on all cores, as in Fig. 5.

mod asked;
mod csv;
mod disk;
mod file;
mod form;
mod grid;
mod lock;
mod manifest;
mod merge;
mod order;
#[cfg(feature = "parquet")]
mod parquet;
mod range;
mod row;
mod shard;
mod taken;
mod whose;

use std::cell::RefCell;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

use passivity_scene::Point;

use crate::error::SimError;
use crate::family::Family;
use crate::lanes;
use crate::plan::Plan;
use crate::run;

pub use asked::Asked;
pub use disk::side_files;
pub use file::{Opened, Rows, open, open_shard, write_shard};
pub use grid::{Grid, MOST_POINTS};
pub use merge::merge;
pub use range::Range;
pub use row::Row;
pub use shard::Shard;

/// Runs the points of a grid that are not `done` yet; `sink` takes each in the order in which they
/// end, with its index, and its error stops the sweep.
///
/// A scene whose only effects are friction and the controller's goes through vector lanes, any other
/// through the loop of its plan, one point at a time; both use all cores.
///
/// # Errors
///
/// A scene that cannot be simulated, or what `sink` reports.
///
/// # Example
///
/// ```
/// use passivity_scene::Scene;
/// use passivity_sim::ExactOutcome;
/// use passivity_sim::sweep::{Grid, Range, run};
///
/// let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"1\"\n[run]\nintervals = 3000";
/// let point = Scene::from_toml("fig5", scene).unwrap().point();
/// let range = |text| Range::parse(text).unwrap();
/// let grid = Grid::new(range("0.6"), range("0.4,0.6"), range("1,2")).unwrap();
/// let mut rows = vec![None; grid.len()];
/// run(&point, &grid, &[], |index, row| {
///     rows[index] = Some(row);
///     Ok(())
/// })
/// .unwrap();
/// assert_eq!(rows[0].unwrap().exact, ExactOutcome::NeverAtRest);
/// assert_eq!(rows[2].unwrap().exact, ExactOutcome::AtRest);
/// ```
pub fn run(
    scene: &Point,
    grid: &Grid,
    done: &[bool],
    sink: impl FnMut(usize, Row) -> Result<(), SimError>,
) -> Result<(), SimError> {
    run_range(scene, grid, 0..grid.len(), done, 0, sink)
}

/// Runs the points of a grid whose indices are in `range`, as [`run()`] runs all of them; `done` speaks of
/// these, the first of the range first. `threads` is how many cores to use, 0 for all.
///
/// # Errors
///
/// As [`run()`].
pub fn run_range(
    scene: &Point,
    grid: &Grid,
    range: std::ops::Range<usize>,
    done: &[bool],
    threads: usize,
    mut sink: impl FnMut(usize, Row) -> Result<(), SimError>,
) -> Result<(), SimError> {
    if range.is_empty() {
        return Ok(());
    }
    let family = family(scene, grid)?;
    let next = AtomicUsize::new(range.start);
    let cancelled = AtomicBool::new(false);
    let take = || {
        if cancelled.load(Ordering::Relaxed) {
            return None;
        }
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= range.end {
                return None;
            }
            if done.get(index - range.start) != Some(&true) {
                return Some(index);
            }
        }
    };
    let worker = |deliver: &dyn Fn(Result<(usize, Row), SimError>)| {
        let Some(family) = &family else {
            while let Some(index) = take() {
                let plan = compiled(scene, grid, index);
                deliver(plan.map(|plan| (index, Row::of(&run::outcome(&plan)))));
            }
            return;
        };
        let next = || loop {
            let index = take()?;
            match family.with(grid.doubles(index)) {
                Ok(plan) => return Some((index, plan)),
                Err(error) => deliver(Err(error)),
            }
        };
        lanes::run_plans(lanes::Instructions::Best, next, |index, end| {
            deliver(Ok((index, Row::of(&end))));
        });
    };
    let workers = match threads {
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    if workers == 1 {
        // On this thread, which has nothing else to do.
        let ran = RefCell::new((sink, Ok(())));
        worker(&|message| {
            let (sink, result) = &mut *ran.borrow_mut();
            if result.is_ok() {
                *result = message.and_then(|(index, row)| sink(index, row));
                cancelled.store(result.is_err(), Ordering::Relaxed);
            }
        });
        return ran.into_inner().1;
    }
    let (send, receive) = mpsc::sync_channel(1024);
    std::thread::scope(|scope| {
        for _ in 0..workers.min(range.len()) {
            let send = send.clone();
            scope.spawn(|| {
                let send = send;
                worker(&|message| {
                    if send.send(message).is_err() {
                        cancelled.store(true, Ordering::Relaxed);
                    }
                });
            });
        }
        drop(send);
        let mut result = Ok(());
        for message in receive {
            if result.is_err() {
                continue; // Drain what the workers still had at hand.
            }
            result = message.and_then(|(index, row)| sink(index, row));
            if result.is_err() {
                cancelled.store(true, Ordering::Relaxed);
            }
        }
        result
    })
}

/// One point compiled stands for all where they differ in β, σ and speed alone.
fn family(scene: &Point, grid: &Grid) -> Result<Option<Family>, SimError> {
    if !grid.parameters().is_empty() {
        return Ok(None);
    }
    let family = Family::of(&grid.point(scene, 0))?;
    family.own()?;
    Ok(Some(family))
}

/// Says whether these points of a grid can be simulated, by their indices, before a file is replaced for their rows.
///
/// # Errors
///
/// A scene that cannot be simulated, at the first point of which that is so.
pub fn check_points(
    scene: &Point,
    grid: &Grid,
    points: impl IntoIterator<Item = usize>,
) -> Result<(), SimError> {
    let family = family(scene, grid)?;
    points.into_iter().try_for_each(|index| match &family {
        Some(family) => family.with(grid.doubles(index)).map(drop),
        None => compiled(scene, grid, index).map(drop),
    })
}

/// The plan of one point, or why there is none, with its values.
fn compiled(scene: &Point, grid: &Grid, index: usize) -> Result<Plan, SimError> {
    let plan = Plan::compile(&grid.point(scene, index));
    plan.map_err(|error| at_point(grid, index, &error))
}

/// An error with the values of the point at which it was met.
fn at_point(grid: &Grid, index: usize, error: &SimError) -> SimError {
    let columns = grid.columns();
    let values = columns.iter().zip(grid.values(index));
    let words: Vec<String> = values.map(|(name, x)| format!("{name} = {x}")).collect();
    SimError::Method(format!("{}: {error}", words.join(", ")))
}
