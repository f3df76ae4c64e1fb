//! Instructions per interval for scenes with no effect, one, … all, counted by callgrind.
//!
//! `cargo bench -p passivity-sim --bench instructions` runs itself under valgrind, for 1000 and for
//! 3000 intervals of each scene; the difference over 2000 is what an interval costs.

use std::process::Command;

use passivity_core::{BigRational, Scalar};
use passivity_scene::Point;
use passivity_scene::point::Units;
use passivity_sim::growth::Growth;
use passivity_sim::{Plan, run};

/// A heavy device that keeps moving through every scene: nothing rests, nothing grows.
fn base(intervals: u64) -> Point {
    let one = BigRational::integer(1);
    Point {
        mu: Some(BigRational::integer(1_000_000)),
        beta: None,
        sigma: None,
        encoder: false,
        delay: 0,
        unilateral: false,
        damping: None,
        max_force: None,
        force_step: None,
        amplifier: None,
        force: None,
        arm: None,
        start: [BigRational::integer(0), BigRational::integer(2)],
        intervals,
        units: Units {
            period: one.clone(),
            length: one.clone(),
            stiffness: one,
        },
    }
}

type Change = fn(&mut Point);

/// The effects in the order in which they are added.
fn effects() -> Vec<(&'static str, Change)> {
    fn tenth() -> BigRational {
        BigRational::integer(1).over(BigRational::integer(10))
    }
    vec![
        ("encoder", |p| p.encoder = true),
        ("viscous friction", |p| p.beta = Some(tenth())),
        ("Coulomb friction", |p| p.sigma = Some(tenth())),
        ("delay", |p| p.delay = 1),
        ("one-sided wall", |p| p.unilateral = true),
        ("virtual damping", |p| p.damping = Some(tenth())),
        ("D/A converter", |p| p.force_step = Some(tenth())),
        ("saturation", |p| {
            p.max_force = Some(BigRational::integer(10_000))
        }),
        ("operator's force", |p| p.force = Some(vec![tenth()])),
        ("amplifier", |p| {
            p.amplifier = Some(tenth() * BigRational::integer(5))
        }),
        ("arm", |p| p.arm = Some([tenth(), tenth(), tenth()])),
    ]
}

/// The scenes: each effect by itself, then one more at a time.
fn scenes(intervals: u64) -> Vec<(String, Point)> {
    let mut scenes = vec![("hold only".to_owned(), base(intervals))];
    for (name, change) in effects() {
        let mut point = base(intervals);
        change(&mut point);
        scenes.push((format!("{name} alone"), point));
    }
    let mut point = base(intervals);
    for (count, (name, change)) in effects().into_iter().enumerate() {
        change(&mut point);
        scenes.push((format!("{} effects: … + {name}", count + 1), point.clone()));
    }
    scenes
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let args: Vec<String> = std::env::args().collect();
    if let [_, word, scene, intervals] = args.as_slice()
        && word == "run"
    {
        let intervals: u64 = intervals.parse().unwrap_or(0);
        let index: usize = scene.parse().unwrap_or(0);
        let scenes = scenes(intervals);
        let Some((name, point)) = scenes.get(index) else {
            return;
        };
        let mut plan = Plan::compile(point).unwrap_or_else(|error| panic!("{name}: {error}"));
        // A frictionless loop grows from the start: let it, the interval costs the same.
        plan.growth = Growth::never();
        let end = run::outcome(&plan);
        assert_eq!(end.intervals, intervals, "{name}: {end:?}");
        return;
    }
    let Ok(program) = std::env::current_exe() else {
        return;
    };
    println!("| scene | loop | instructions an interval |\n| --- | --- | --- |");
    for (index, (name, point)) in scenes(1).into_iter().enumerate() {
        let count = |intervals: u64| -> Option<u64> {
            let output = Command::new("valgrind")
                .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
                .arg(&program)
                .args(["run", &index.to_string(), &intervals.to_string()])
                .output()
                .ok()?;
            let text = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.success(), "{name}: {text}");
            let line = text.lines().find(|line| line.contains("Collected"))?;
            line.rsplit(' ').next()?.parse().ok()
        };
        let Some((few, many)) = count(1000).zip(count(3000)) else {
            println!("not run here: valgrind is not installed");
            return;
        };
        let each = (many - few) as f64 / 2000.0;
        let plan = Plan::compile(&point).map_or("-", |plan| plan.loop_name());
        println!("| {name} | `{plan}` | {each:.0} |");
    }
}
