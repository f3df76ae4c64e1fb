//! The figures that the project promises for the simulator, measured in one run:
//! `cargo bench -p passivity-sim --bench targets`.
//!
//! Times are of the processor, not of the clock on the wall, where the system tells them.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use passivity_core::{BigRational, Friction, Loop, Scalar};
use passivity_scene::Point;
use passivity_scene::point::Units;
use passivity_sim::sweep::{self, Grid, Range};
use passivity_sim::{Detail, ExactOutcome, Method, Plain, Plan, lanes, run, simulate};

/// Seconds of processor time of this process so far, or of the wall clock.
fn clock(begin: Instant) -> f64 {
    let stat = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = stat.and_then(|s| s.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

/// The paper's scene with μ = 50.
fn scene(intervals: u64) -> Point {
    let one = BigRational::one();
    Point {
        at: Loop {
            inertia: Some(BigRational::integer(50)),
            start_velocity: Some(one.clone()),
            ..Loop::plain(Friction::new(one.clone(), one.clone()))
        },
        forces: None,
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
            length_unit: None,
        },
    }
}

/// The same with an amplifier.
fn amplified(intervals: u64) -> Point {
    let mut point = scene(intervals);
    point.at.time_constant = Some(BigRational::new(1.into(), 5.into()));
    point
}

/// β = (i + ½)/20, σ = 1.5(j + ½)/20, speeds ½, 1, 2, 5.
fn grid() -> Grid {
    let range = |text| Range::parse(text).unwrap_or_else(|error| panic!("{error}"));
    Grid::new(
        range("1/40:39/40:20"),
        range("3/80:117/80:20"),
        range("1/2,1,2,5"),
    )
    .unwrap_or_else(|error| panic!("{error}"))
}

/// Points that keep moving: σ < ½ < β.
fn moving(mu: f64) -> Vec<Plain> {
    let mut points = Vec::new();
    for i in 0..8 {
        for j in 0..8 {
            points.push(Plain {
                mu,
                beta: 0.55 + 0.05 * f64::from(i),
                sigma: 0.05 + 0.05 * f64::from(j),
                xi: 0.0,
                velocity: 2.0,
            });
        }
    }
    points
}

/// The target in words, where there is one.
fn limit(most: f64) -> String {
    if most.is_finite() {
        format!("at most {most}")
    } else {
        "to compare".to_owned()
    }
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let begin = Instant::now();
    let intervals = 50_000;
    let points = moving(50.0);
    let start = clock(begin);
    let mut count = 0;
    for point in &points {
        count += run::outcome(&Plan::plain(point, intervals)).intervals;
    }
    let scalar = (clock(begin) - start) / count as f64 * 1e9;
    println!("closed form, scalar, moving points      {scalar:8.2} ns an interval (at most 30)");

    // λ from 0.09 to 0.15, where reversals take the longer series.
    let light = moving(6.0);
    let start = clock(begin);
    let mut count = 0;
    for point in &light {
        count += run::outcome(&Plan::plain(point, intervals)).intervals;
    }
    let scalar = (clock(begin) - start) / count as f64 * 1e9;
    println!("closed form, scalar, moving, μ = 6      {scalar:8.2} ns an interval (at most 30)");

    let widest = lanes::instructions();
    let sets = [
        (
            lanes::Instructions::Best,
            widest,
            if widest == "AVX-512" { 4.0 } else { 12.0 },
        ),
        (lanes::Instructions::Avx2, "AVX2 at most", 12.0),
        (lanes::Instructions::Baseline, "baseline", f64::INFINITY),
    ];
    for (set, name, most) in sets {
        let start = clock(begin);
        let mut queue = points.iter().copied().enumerate();
        let mut count = 0;
        lanes::run_on(
            set,
            intervals,
            || queue.next(),
            |_, end| count += end.intervals,
        );
        let lane = (clock(begin) - start) / count as f64 * 1e9;
        println!(
            "sweep, moving points, {name:<18}{lane:8.2} ns an interval and point ({})",
            limit(most)
        );
    }

    let start = clock(begin);
    let mut queue = light.iter().copied().enumerate();
    let mut count = 0;
    lanes::run(intervals, || queue.next(), |_, end| count += end.intervals);
    let lane = (clock(begin) - start) / count as f64 * 1e9;
    let most = if widest == "AVX-512" { 4.0 } else { 12.0 };
    println!(
        "sweep, moving, μ = 6, {widest:<18}{lane:8.2} ns an interval and point (at most {most})"
    );

    let (point, grid) = (scene(intervals), grid());
    let wall = Instant::now();
    let rows = swept(&point, &grid);
    println!(
        "grid of {} points                     {:8.3} s of the wall clock (at most 0.4 on two cores)",
        grid.len(),
        wall.elapsed().as_secs_f64()
    );

    rigorous(&point, &grid, &rows);
    if std::env::args().any(|arg| arg == "--reference") {
        println!("with an amplifier, whose time constant is a fifth of a period, 200 intervals:");
        let lagging = amplified(200);
        let lagging_rows = swept(&lagging, &grid);
        rigorous(&lagging, &grid, &lagging_rows);
        precise(&lagging, &grid, &lagging_rows);
        println!("without one, all its intervals:");
        precise(&point, &grid, &rows);
    } else {
        println!("state at the end against the reference: not run here (-- --reference, minutes)");
    }
}

/// The outcome of every point.
fn swept(point: &Point, grid: &Grid) -> Vec<Option<sweep::Row>> {
    let mut rows = vec![None; grid.len()];
    sweep::run(point, grid, &[], |index, row| {
        rows[index] = Some(row);
        Ok(())
    })
    .unwrap_or_else(|error| panic!("{error}"));
    rows
}

/// Every point by enclosures: how many they decide, and whether the outcomes agree.
#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn rigorous(point: &Point, grid: &Grid, rows: &[Option<sweep::Row>]) {
    let wall = Instant::now();
    let checks = every(rows, |index, row| {
        let run = simulate(&grid.point(point, index), &Method::Enclosure, None)
            .unwrap_or_else(|error| panic!("{error}"));
        let outcome = &run.end.outcome;
        let Detail::Enclosed { ends: [xi, v], .. } = run.detail else {
            return None;
        };
        let holds = |x: f64, [lo, hi]: [f64; 2]| (x - lo).abs().max((x - hi).abs());
        let off = holds(row.xi, xi).hypot(50.0_f64.sqrt() * holds(row.velocity, v));
        let same = outcome.exact == row.exact && outcome.at_interval == row.at_interval;
        // Undecided before its last interval: the enclosure, not the motion.
        let open = outcome.exact == ExactOutcome::Undecided && run.end.intervals < point.intervals;
        (!open).then_some((same, off))
    });
    let decided = checks.iter().flatten().count();
    let same = checks.iter().flatten().filter(|(same, _)| *same).count();
    let worst = checks
        .iter()
        .flatten()
        .fold(0.0_f64, |m, (_, off)| m.max(*off));
    println!(
        "enclosure decides                       {:8.2} % of {} points (at least 95), in {:.1} s",
        100.0 * decided as f64 / rows.len() as f64,
        rows.len(),
        wall.elapsed().as_secs_f64()
    );
    println!("outcome and interval as the enclosure's {same:8} of {decided} decided points (all)");
    println!("state at the end, proved to be within   {worst:8.1e} ticks of the true one");
}

/// Every point by the reference: the error of the state at the end over its magnitude.
#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn precise(point: &Point, grid: &Grid, rows: &[Option<sweep::Row>]) {
    let wall = Instant::now();
    let errors = every(rows, |index, row| {
        let end = simulate(
            &grid.point(point, index),
            &Method::Reference { digits: 20 },
            None,
        )
        .unwrap_or_else(|error| panic!("{error}"))
        .end;
        let size = |xi: f64, v: f64| xi.hypot(50.0_f64.sqrt() * v);
        let off = size(row.xi - end.xi, row.velocity - end.velocity);
        let error = if off == 0.0 {
            0.0
        } else {
            off / size(end.xi, end.velocity)
        };
        let outcome = (row.exact, row.paper, row.at_interval);
        let same = outcome
            == (
                end.outcome.exact,
                end.outcome.paper,
                end.outcome.at_interval,
            );
        Some((same, error))
    });
    let worst = errors.iter().flatten().fold(0.0_f64, |m, (_, e)| m.max(*e));
    let same = errors.iter().flatten().filter(|(same, _)| *same).count();
    println!(
        "outcomes and interval as the reference's{same:8} of {} points (all)",
        rows.len()
    );
    println!(
        "state at the end against the reference  {worst:8.1e} of its magnitude (at most 1e-8), in {:.1} s",
        wall.elapsed().as_secs_f64()
    );
}

/// Does something with every row, on all cores.
fn every<T: Send>(
    rows: &[Option<sweep::Row>],
    task: impl Fn(usize, &sweep::Row) -> Option<T> + Sync,
) -> Vec<Option<T>> {
    let next = AtomicUsize::new(0);
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let (next, task) = (&next, &task);
    std::thread::scope(|scope| {
        let spawn = |_| {
            scope.spawn(move || {
                let mut results = Vec::new();
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(row) = rows.get(index) else {
                        return results;
                    };
                    results.push(row.as_ref().and_then(|row| task(index, row)));
                }
            })
        };
        let workers: Vec<_> = (0..workers).map(spawn).collect();
        let results = workers.into_iter().map(|worker| worker.join());
        results
            .flat_map(|result| result.unwrap_or_else(|_| panic!("a worker failed")))
            .collect()
    })
}
