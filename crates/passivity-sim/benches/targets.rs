//! The figures that the project promises for the simulator, measured in one run:
//! `cargo bench -p passivity-sim --bench targets`.
//!
//! Times are of the processor, not of the clock on the wall, where the system tells them.

use std::time::Instant;

use passivity_core::{BigRational, Scalar};
use passivity_scene::Point;
use passivity_scene::point::Units;
use passivity_sim::methods::{Detail, simulate};
use passivity_sim::sweep::{self, Grid, Range};
use passivity_sim::{Exactly, Method, Plain, Plan, lanes, run};

/// Seconds of processor time of this process so far, or of the wall clock.
fn clock(begin: Instant) -> f64 {
    let stat = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = stat.and_then(|s| s.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| begin.elapsed().as_secs_f64(), |ns| ns * 1e-9)
}

/// The paper's scene with μ = 50.
fn scene(intervals: u64) -> Point {
    let one = BigRational::integer(1);
    Point {
        mu: Some(BigRational::integer(50)),
        beta: Some(one.clone()),
        sigma: Some(one.clone()),
        encoder: true,
        delay: 0,
        unilateral: false,
        damping: None,
        max_force: None,
        force_step: None,
        amplifier: None,
        force: None,
        arm: None,
        start: [BigRational::integer(0), one.clone()],
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
        },
    }
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
fn moving() -> Vec<Plain> {
    let mut points = Vec::new();
    for i in 0..8 {
        for j in 0..8 {
            points.push(Plain {
                mu: 50.0,
                beta: 0.55 + 0.05 * f64::from(i),
                sigma: 0.05 + 0.05 * f64::from(j),
                xi: 0.0,
                velocity: 2.0,
            });
        }
    }
    points
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let begin = Instant::now();
    let intervals = 50_000;
    let points = moving();
    let start = clock(begin);
    let mut count = 0;
    for point in &points {
        count += run::outcome(&Plan::plain(point, intervals)).intervals;
    }
    let scalar = (clock(begin) - start) / count as f64 * 1e9;
    println!("closed form, scalar, moving points      {scalar:8.2} ns an interval (at most 30)");

    let start = clock(begin);
    let mut queue = points.iter().copied().enumerate();
    let mut count = 0;
    lanes::run(intervals, || queue.next(), |_, end| count += end.intervals);
    let lane = (clock(begin) - start) / count as f64 * 1e9;
    let has_512 = lanes::instructions() == "AVX-512";
    let most = if has_512 { 4.0 } else { 12.0 };
    println!(
        "sweep, moving points, {:<18}{lane:8.2} ns an interval and point (at most {most})",
        lanes::instructions()
    );

    let (point, grid) = (scene(intervals), grid());
    let wall = Instant::now();
    let mut rows = vec![None; grid.len()];
    sweep::run(&point, &grid, &[], |index, row| {
        rows[index] = Some(row);
        Ok(())
    })
    .unwrap_or_else(|error| panic!("{error}"));
    println!(
        "grid of {} points                     {:8.3} s of the wall clock (at most 0.4 on two cores)",
        grid.len(),
        wall.elapsed().as_secs_f64()
    );

    let (mut decided, mut same, mut worst) = (0, 0, 0.0_f64);
    let wall = Instant::now();
    for (index, row) in rows.iter().enumerate() {
        let Some(row) = row else { continue };
        let run = simulate(&grid.point(&point, index), &Method::Enclosure, None)
            .unwrap_or_else(|error| panic!("{error}"));
        let outcome = &run.end.outcome;
        if outcome.exact == Exactly::Undecided {
            continue;
        }
        decided += 1;
        if outcome.exact == row.exact && outcome.at_interval == row.at_interval {
            same += 1;
        }
        if let Detail::Enclosed { ends: [xi, v], .. } = run.detail {
            // The farthest that the true state can be, over its magnitude as an oscillator's.
            let far = |x: f64, [lo, hi]: [f64; 2]| (x - lo).abs().max((x - hi).abs());
            let off = far(row.xi, xi).hypot(50.0_f64.sqrt() * far(row.velocity, v));
            let size = row.xi.hypot(50.0_f64.sqrt() * row.velocity);
            if size > 0.0 {
                worst = worst.max(off / size);
            }
        }
    }
    println!(
        "enclosure decides                       {:8.2} % of {} points (at least 95), in {:.1} s",
        100.0 * f64::from(decided) / grid.len() as f64,
        grid.len(),
        wall.elapsed().as_secs_f64()
    );
    println!("outcome and interval as the enclosure's {same:8} of {decided} decided points (all)");
    println!(
        "final state within the enclosure to     {worst:8.1e} of its magnitude (at most 1e-8)"
    );
}
