//! Accuracy: the error of every method on one scene against the reference, and its computing time.

use std::time::Instant;

use passivity_scene::Point;

use crate::error::SimError;
use crate::method::Method;
use crate::methods::{planned, simulate_beyond};
use crate::outcome::{End, ExactOutcome};
use crate::plan::{Beyond, Plan};
use crate::simulated::{Line, Simulated};

/// The reference that errors are measured against.
pub const REFERENCE: Method = Method::Reference { digits: 50 };

/// A method on a scene: how wrong, and how long an interval takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The method.
    pub method: Method,
    /// |ξ − ξ_ref| at the end over the reach of the motion.
    pub position: f64,
    /// |ξ̇ − ξ̇_ref| at the end over the greatest speed of the motion.
    pub velocity: f64,
    /// The largest difference in the sums of E_gᴸ, E_g and E_d, over the energy dissipated.
    ///
    /// Each error is over 1 where what it is compared with is 0.
    pub energy: f64,
    /// The outcome.
    pub exact: ExactOutcome,
    /// Whether it is the reference's, by the paper's detector too.
    pub same_outcome: bool,
    /// How many intervals too late (or, below 0, too early) rest or growth was found.
    pub late: i64,
    /// Nanoseconds an interval.
    pub nanoseconds: f64,
}

/// The table of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Intervals that were compared: until rest, or until a mode whose growth is certain is ten times as
    /// large, and at most the caller's bound.
    pub intervals: u64,
    /// The reference's outcome.
    pub reference: ExactOutcome,
    /// A row for each method that can do the scene.
    pub rows: Vec<Measured>,
    /// The methods that cannot, or that stopped before they knew, with the reason.
    pub left_out: Vec<(Method, String)>,
}

/// Every method and step that is compared.
#[must_use]
pub fn methods() -> Vec<Method> {
    let substeps = [1, 4, 10, 40, 100, 1000];
    let tolerances = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
    [
        Method::ClosedForm,
        Method::Exact,
        Method::Enclosure,
        REFERENCE,
    ]
    .into_iter()
    .chain(substeps.map(|substeps| Method::Euler { substeps }))
    .chain(substeps.map(|substeps| Method::Rk4 { substeps }))
    .chain(tolerances.map(|tolerance| Method::Adaptive { tolerance }))
    .collect()
}

/// Runs every method on a scene for at most `most` intervals; `progress` hears of each before it runs.
///
/// # Errors
///
/// A scene that the reference cannot do.
pub fn measure(
    point: &Point,
    most: u64,
    mut progress: impl FnMut(&Method),
) -> Result<Table, SimError> {
    let mut point = point.clone();
    point.intervals = point.intervals.min(most);
    let mut reach = 0.0_f64;
    let mut fastest = 0.0_f64;
    progress(&REFERENCE);
    let mut watch = |line: &Line<'_>| {
        if let Line::Double(entry) = line {
            reach = reach.max(entry.xi0.abs()).max(entry.xi1.abs());
            fastest = fastest.max(entry.v0.abs()).max(entry.v1.abs());
        }
        true
    };
    let truth = simulate_beyond(&point, &REFERENCE, Beyond::Tenfold, Some(&mut watch))?;
    // A motion that never was anywhere has no scale: one tick, one tick a sample, and KΔ² without friction.
    let scale = |x: f64| if x > 0.0 { x } else { 1.0 };
    let scales = [scale(reach), scale(fastest), scale(truth.totals.dissipated)];
    let plan = Plan::compile(&point)?;
    // What grows is compared where the reference's motion ends, however late its growth was certain.
    let onward = (truth.end.outcome.exact == ExactOutcome::Growing).then(|| {
        let plan = plan.with_intervals(truth.end.intervals);
        plan.past_growth()
    });
    let mut table = Table {
        intervals: truth.end.intervals,
        reference: truth.end.outcome.exact,
        rows: Vec::new(),
        left_out: Vec::new(),
    };
    for method in methods() {
        progress(&method);
        match timed(&point, &plan, onward.as_ref(), &method) {
            Ok((run, _)) if run.is_cut_short() => {
                let because = format!("it stopped undecided: {}", run.end.outcome.because);
                table.left_out.push((method, because));
            }
            Ok((run, nanoseconds)) => {
                table
                    .rows
                    .push(compare(method, &run, &truth, scales, nanoseconds))
            }
            Err(error) => table.left_out.push((method, error.to_string())),
        }
    }
    Ok(table)
}

/// A run and its time per interval, without that of setting it up: each the least of several runs, as
/// long as they take little time. What is timed goes `onward` where the outcome is certain before its end.
fn timed(
    point: &Point,
    plan: &Plan,
    onward: Option<&Plan>,
    method: &Method,
) -> Result<(Simulated, f64), SimError> {
    let (_, setup) = least(point, &plan.with_intervals(0), method, 0.05)?;
    let (mut run, seconds) = least(point, onward.unwrap_or(plan), method, 0.3)?;
    let nanoseconds = (seconds - setup).max(0.0) * 1e9 / run.end.intervals.max(1) as f64;
    if onward.is_some() && !run.is_cut_short() {
        run.end.outcome = planned(point, plan, method, None)?.end.outcome;
    }
    Ok((run, nanoseconds))
}

/// How many runs are enough to know the least time of one, where they are short.
const RUNS: u32 = 50;

/// A run and the least time that it took, repeated for some seconds; where many fit into them, for a sixth of
/// that.
fn least(
    point: &Point,
    plan: &Plan,
    method: &Method,
    enough: f64,
) -> Result<(Simulated, f64), SimError> {
    let begin = Instant::now();
    let (mut least, mut runs) = (f64::INFINITY, 0);
    loop {
        runs += 1;
        let start = Instant::now();
        let run = planned(point, plan, method, None)?;
        least = least.min(start.elapsed().as_secs_f64());
        let spent = begin.elapsed().as_secs_f64();
        if spent > enough || (runs >= RUNS && spent > enough / 6.0) {
            return Ok((run, least));
        }
    }
}

fn compare(
    method: Method,
    run: &Simulated,
    truth: &Simulated,
    [reach, fastest, energy]: [f64; 3],
    nanoseconds: f64,
) -> Measured {
    let (a, b) = (&run.totals, &truth.totals);
    let energies = [
        a.generated_linear - b.generated_linear,
        a.generated_quantized - b.generated_quantized,
        a.dissipated - b.dissipated,
    ];
    let (got, want) = (&run.end.outcome, &truth.end.outcome);
    let when = |end: &End| {
        let certain = end.outcome.at_interval.unwrap_or(end.intervals);
        certain.cast_signed()
    };
    Measured {
        method,
        position: (run.end.xi - truth.end.xi).abs() / reach,
        velocity: (run.end.velocity - truth.end.velocity).abs() / fastest,
        energy: energies.into_iter().fold(0.0, |m: f64, e| m.max(e.abs())) / energy,
        exact: got.exact,
        same_outcome: got.exact == want.exact && got.paper == want.paper,
        late: when(&run.end) - when(&truth.end),
        nanoseconds,
    }
}
