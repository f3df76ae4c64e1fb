//! Motions.

use passivity_sim::report::Simulation as Report;
use passivity_sim::scales::has_ticks_or_unit;
use passivity_sim::{Line, Method, Plan};
use pyo3::prelude::*;

use crate::scene::{Source, of_simulation};
use crate::watch::follow;

/// The columns of a simulated trace.
const COLUMNS: [&str; 7] = [
    "xi0",
    "xi1",
    "v0",
    "v1",
    "generated_linear",
    "generated_quantized",
    "dissipated",
];

/// What a simulation gives: its report as JSON, and its columns as doubles in bytes.
type Simulation = (String, Vec<(&'static str, Vec<u8>)>);

/// The motion of a scene.
#[pyfunction]
#[pyo3(signature = (scene, method, intervals=None, speed=None, trace=true, progress=None))]
pub(crate) fn simulate(
    py: Python<'_>,
    scene: Source,
    method: &str,
    intervals: Option<u64>,
    speed: Option<&str>,
    trace: bool,
    progress: Option<Bound<'_, PyAny>>,
) -> PyResult<Simulation> {
    /// How many intervals are simulated between two looks at the watch.
    const BETWEEN: u64 = 1 << 10;
    let scene = scene.read(py)?;
    let mut point = scene.point();
    if let Some(intervals) = intervals {
        point.intervals = intervals;
    }
    if let Some(text) = speed {
        has_ticks_or_unit(&scene, text).map_err(|error| of_simulation(&error))?;
        let speed = scene.ticks_per_sample(text);
        point.at.start_velocity = Some(speed.map_err(|error| of_simulation(&error))?);
    }
    let method = Method::parse(method).map_err(|error| of_simulation(&error))?;
    let plan = Plan::compile(&point).map_err(|error| of_simulation(&error))?;
    let begin = std::time::Instant::now();
    let (run, columns) = follow(py, progress.as_ref(), move |watch| {
        let mut columns: Vec<Vec<u8>> = vec![Vec::new(); if trace { COLUMNS.len() } else { 0 }];
        let mut seen = 0_u64;
        let mut see = |line: &Line<'_>| {
            let entry = line.entry();
            let values = [
                entry.xi0,
                entry.xi1,
                entry.v0,
                entry.v1,
                entry.generated_linear,
                entry.generated_quantized,
                entry.dissipated,
            ];
            for (column, value) in columns.iter_mut().zip(values) {
                column.extend_from_slice(&value.to_ne_bytes());
            }
            seen += 1;
            !seen.is_multiple_of(BETWEEN) || watch.set(seen)
        };
        let run = passivity_sim::simulate(&point, &method, Some(&mut see));
        (run, columns)
    })?;
    let run = run.map_err(|error| of_simulation(&error))?;
    let seconds = begin.elapsed().as_secs_f64();
    let report = Report::new(&scene, &plan, &method, &run, Some(seconds));
    let report = report.map_err(|error| of_simulation(&error))?;
    let report = serde_json::to_string(&report).map_err(|error| of_simulation(&error))?;
    Ok((report, COLUMNS.into_iter().zip(columns).collect()))
}
