//! Sweeps with the controller's effects and an amplifier beside the plain sweep, in one run:
//! `cargo bench -p passivity-sim --bench effects`.
//!
//! Each scene has a grid of 1600 points: β up to twice its critical value, σ up to 1.5, speeds ½, 1, 2, 5
//! and μ = 50. *Moving* are those of its points that never rest, σ < ½ and β above the critical value.
//! `-- WORDS` measures the plain scene and those whose name has these words.
//! Times are the least of several runs, so that other work on the machine does not count. Instructions are
//! those of the whole grid, counted by callgrind where valgrind is installed: it runs this program for 200
//! and for 600 intervals, with AVX2, the widest that it knows. The last column says whether the time of the
//! whole grid is within so many times that of the plain one.

mod callgrind;

use std::sync::Arc;
use std::time::Instant;

use passivity_core::transfer::TransferFunction;
use passivity_core::{BigRational, Friction, Loop, Scalar};
use passivity_scene::Point;
use passivity_scene::point::Units;
use passivity_sim::sweep::{self, Grid, Range};
use passivity_sim::{Plan, lanes, run};

const INTERVALS: u64 = 50_000;
const RUNS: usize = 5;

/// A scene with effects, and the least β that damps it.
struct Scene {
    name: &'static str,
    point: Point,
    critical: BigRational,
    /// How many times as long as the plain grid this one may take, where that is promised.
    most: Option<f64>,
}

/// What a linear discrete loop may cost, over the plain one.
const DISCRETE: f64 = 3.0;
/// What an amplifier may cost, over the plain loop.
const AMPLIFIER: f64 = 8.0;

/// What a loop may cost over the plain one; nothing is promised of one-sided walls, D/A converters and
/// limited forces, with which it is not linear.
fn most(at: &Loop<BigRational>) -> Option<f64> {
    let linear = !at.unilateral && at.force_step.is_none() && at.max_force.is_none();
    let most = if at.time_constant.is_some() {
        AMPLIFIER
    } else {
        DISCRETE
    };
    linear.then_some(most)
}

fn ratio(n: i32, d: i32) -> BigRational {
    BigRational::integer(n).over(BigRational::integer(d))
}

fn scene(
    name: &'static str,
    critical: BigRational,
    change: impl Fn(&mut Loop<BigRational>),
) -> Scene {
    let one = BigRational::one();
    let mut at = Loop {
        inertia: Some(BigRational::integer(50)),
        start_velocity: Some(one.clone()),
        ..Loop::plain(Friction::new(one.clone(), one.clone()))
    };
    change(&mut at);
    let point = Point {
        at,
        forces: None,
        intervals: INTERVALS,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
            length_unit: None,
        },
    };
    Scene {
        name,
        most: most(&point.at),
        point,
        critical,
    }
}

/// H(z) = (5 − 5z⁻¹ + z⁻²)/(4 − 4z⁻¹ + z⁻²): a wall with damping behind two poles at ½.
fn of_order_2() -> TransferFunction<BigRational> {
    let of = |numbers: [i32; 3]| numbers.map(BigRational::integer).to_vec();
    TransferFunction::new(of([5, -5, 1]), of([4, -4, 1]))
        .unwrap_or_else(|error| panic!("{error:?}"))
}

/// The plain scene first: the others are compared with it.
fn scenes() -> Vec<Scene> {
    vec![
        scene("plain", ratio(1, 2), |_| {}),
        scene("delay of 1 sample", ratio(3, 2), |at| at.delay = 1),
        scene("delay of 4 samples", ratio(9, 2), |at| at.delay = 4),
        scene("virtual damping ½", ratio(3, 2), |at| {
            at.damping = Some(ratio(1, 2));
        }),
        scene(
            "delay of 1 sample and virtual damping ½",
            ratio(5, 4),
            |at| {
                (at.delay, at.damping) = (1, Some(ratio(1, 2)));
            },
        ),
        scene("damping 1 behind a filter of one pole", ratio(5, 6), |at| {
            at.damping = Some(BigRational::one());
            at.damping_time_constant = Some(BigRational::one());
        }),
        scene("controller of order 2", ratio(6737, 10_000), |at| {
            at.controller = Some(Arc::new(of_order_2()));
        }),
        scene("latency of 0.3 periods", ratio(861, 1000), |at| {
            at.latency = Some(ratio(3, 10));
        }),
        scene("one-sided wall", ratio(1, 2), |at| at.unilateral = true),
        scene("D/A converter of step ⅛", ratio(1, 2), |at| {
            at.force_step = Some(ratio(1, 8));
        }),
        scene("saturation at 10", ratio(1, 2), |at| {
            at.max_force = Some(BigRational::integer(10));
        }),
        scene("all of these", ratio(5, 4), |at| {
            (at.delay, at.damping) = (1, Some(ratio(1, 2)));
            (at.unilateral, at.force_step) = (true, Some(ratio(1, 8)));
            at.max_force = Some(BigRational::integer(10));
        }),
        scene("amplifier, ⅕ of a period", ratio(7, 10), |at| {
            at.time_constant = Some(ratio(1, 5));
        }),
    ]
}

impl Scene {
    fn grid(&self) -> Grid {
        let step = self.critical.clone() * ratio(1, 20);
        let betas = (0..20).map(|i| step.clone() * ratio(2 * i + 1, 1));
        let range = |text| Range::parse(text).unwrap_or_else(|error| panic!("{error}"));
        let beta = Range::from(betas.collect::<Vec<_>>());
        Grid::new(beta, range("3/80:117/80:20"), range("1/2,1,2,5"))
            .unwrap_or_else(|error| panic!("{error}"))
    }

    /// The plans of the grid, or of its moving points alone.
    fn plans(&self, moving: bool) -> Vec<Plan> {
        let grid = self.grid();
        let half = ratio(1, 2);
        let all = (0..grid.len()).filter(|index| {
            let [beta, sigma, _] = grid.values(*index);
            !moving || (beta > self.critical && sigma < half)
        });
        all.map(|index| {
            Plan::compile(&grid.point(&self.point, index)).unwrap_or_else(|error| panic!("{error}"))
        })
        .collect()
    }
}

/// The least time of several runs, in seconds, with what the last of them gave.
fn least<T>(mut task: impl FnMut() -> T) -> (f64, T) {
    let mut timed = || {
        let start = Instant::now();
        let result = task();
        (start.elapsed().as_secs_f64(), result)
    };
    let mut best = timed();
    for _ in 1..RUNS {
        let next = timed();
        best = (best.0.min(next.0), next.1);
    }
    best
}

/// Runs plans in lanes, and counts their intervals.
fn in_lanes(plans: &[Plan]) -> u64 {
    let mut queue = plans.iter().cloned().enumerate();
    let mut count = 0;
    let done = |_, end: passivity_sim::End| count += end.intervals;
    lanes::run_plans(lanes::Instructions::Best, || queue.next(), done);
    count
}

/// Nanoseconds for a point and interval on one core, in lanes and in the scalar loop.
fn each(plans: &[Plan]) -> [f64; 2] {
    let (in_lanes, count) = least(|| in_lanes(plans));
    let begin = Instant::now();
    let alone: u64 = plans.iter().map(|plan| run::outcome(plan).intervals).sum();
    assert_eq!(alone, count, "lanes and scalar loop run the same intervals");
    let scalar = begin.elapsed().as_secs_f64();
    [in_lanes, scalar].map(|seconds| seconds * 1e9 / count as f64)
}

/// Instructions for a point and interval of the whole grid; `None` where valgrind is not installed.
fn counted(index: usize) -> Option<f64> {
    let count = |intervals: u64| {
        let arguments = ["run", &index.to_string(), &intervals.to_string()];
        let (instructions, printed) = callgrind::counted(&[], &arguments)?;
        let intervals: f64 = printed.parse().expect("a number of intervals");
        Some([instructions, intervals])
    };
    let ([few, before], [many, after]) = count(200).zip(count(600))?;
    Some((many - few) / (after - before))
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let args: Vec<String> = std::env::args().collect();
    if let [_, word, index, intervals] = args.as_slice()
        && word == "run"
    {
        let [index, intervals] = [index, intervals].map(|text| {
            text.parse::<usize>()
                .unwrap_or_else(|error| panic!("`{text}`: {error}"))
        });
        let mut scene = scenes().swap_remove(index);
        scene.point.intervals = intervals as u64;
        println!("{}", in_lanes(&scene.plans(false)));
        return;
    }
    println!("vector instructions: {}", lanes::instructions());
    println!(
        "| scene | moving points, ns | of plain | scalar loop, ns | grid, ns | of plain | grid, s | \
         instructions | of plain | at most |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    // Cargo adds a flag of its own.
    let words = args.iter().skip(1).find(|word| !word.starts_with("--"));
    let mut plain: Option<([f64; 2], Option<f64>)> = None;
    for (index, scene) in scenes().into_iter().enumerate() {
        let named = words.is_none_or(|words| scene.name.contains(words));
        if plain.is_some() && !named {
            continue;
        }
        let [moving, scalar] = each(&scene.plans(true));
        let [whole, _] = each(&scene.plans(false));
        let grid = scene.grid();
        let (wall, ()) = least(|| {
            sweep::run(&scene.point, &grid, &[], |_, _| Ok(()))
                .unwrap_or_else(|error| panic!("{error}"));
        });
        let instructions = counted(index);
        let ([first, second], third) = *plain.get_or_insert(([moving, whole], instructions));
        let count = match instructions.zip(third) {
            Some((count, plain)) => format!("{count:.0} | {:.1}", count / plain),
            None => "not run here | ".to_owned(),
        };
        let times = whole / second;
        let verdict = match scene.most {
            None => "not promised".to_owned(),
            Some(most) if times <= most => format!("{most}: met"),
            Some(most) => format!("{most}: missed"),
        };
        println!(
            "| {} | {moving:.2} | {:.1} | {scalar:.1} | {whole:.2} | {times:.1} | {wall:.3} | {count} | {verdict} |",
            scene.name,
            moving / first
        );
    }
}
