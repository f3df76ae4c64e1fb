//! Instructions a sample, counted by callgrind, for the ways through the account.
//!
//! `cargo bench -p passivity-monitor` runs itself under valgrind, for 1000 and for 3000 samples of each
//! way; the difference over 2000 is what a sample costs, the call included. Ends with an error where
//! one costs more than its limit.

#[path = "../../passivity-sim/benches/callgrind/mod.rs"]
mod callgrind;

use passivity_monitor::{Answer, Config, Monitor};

/// The most instructions that a sample may take, with sums of 64 and of 128 bits.
const LIMITS: [f64; 2] = [100.0, 100.0];

/// The same of a sample that is too much for 64 bits, with sums of 128.
const FAR_LIMIT: f64 = 320.0;

/// A run: its name, KΔ, bΔ/T and c, the two counts between which it goes, and its force at each.
type Way = (&'static str, [i64; 3], [i64; 2], [i64; 2]);

/// The wall's own force is passive at the first, open or active at the others.
const WAYS: [Way; 8] = [
    (
        "at rest in the wall",
        [1000, 600, 700],
        [5, 5],
        [-5500, -5500],
    ),
    (
        "a few ticks a sample",
        [1000, 600, 700],
        [0, 7],
        [-500, -7500],
    ),
    (
        "many ticks a sample",
        [1000, 600, 700],
        [0, 40],
        [-500, -40500],
    ),
    (
        "outside of the wall, no force",
        [1000, 600, 700],
        [-40, -80],
        [0, 0],
    ),
    (
        "little friction: open",
        [1000, 0, 0],
        [0, 40],
        [-500, -40500],
    ),
    (
        "driven: surely active",
        [1000, 600, 700],
        [0, 40],
        [900_000, -900_000],
    ),
    (TURNING[0].0, [1000, 600, 700], [0, 40], [40_100, 0]),
    (TURNING[1].0, [1000, 600, 700], [0, -40], [-39_900, 0]),
];

/// What only sums of 128 bits have: sums beyond 64 bits, in which nothing costs more, and samples that are too much for
/// 64 bits.
const WIDE: [Way; 3] = [
    (
        "sums beyond 64 bits",
        [1000, 600, 700],
        [1_000_000_000, 1_000_000_040],
        [0, 0],
    ),
    (
        "forces beyond 2⁴⁴",
        [1000, 600, 700],
        [0, 40],
        [1 << 46, -(1 << 46)],
    ),
    (
        "steps beyond 2¹⁵ ticks",
        [1000, 600, 700],
        [0, 40_000],
        [-500, -40_000_500],
    ),
];

/// The longest ways: many ticks, and the answer changes as the most is above zero somewhere within the tick alone.
/// Each sample of them is the first one after a start, with so much stored that the most is just below zero at the lower
/// end of the tick.
const TURNING: [(&str, i64); 2] = [
    ("as the answer changes", 1_328_050),
    ("as the answer changes, downward", 1_311_850),
];

#[inline(never)]
fn sample(monitor: &mut Monitor<i64>, count: i32, force: i32) -> Answer {
    monitor.sample(count, force)
}

#[inline(never)]
fn sample_wide(monitor: &mut Monitor<i128>, count: i64, force: i64) -> Answer {
    monitor.sample(count, force)
}

/// So many samples of a way.
fn run(way: &Way, wide: bool, samples: u32) {
    let (name, [stiffness, viscous, coulomb], counts, forces) = *way;
    let mut config = Config::new(stiffness, viscous, coulomb).expect("in range");
    let turning = TURNING.iter().find(|(turning, _)| *turning == name);
    if let Some((_, stored)) = turning {
        config = config.with_stored_at_start(*stored).expect("in range");
    }
    let [here, there] = [0, 1].map(|i| (counts[i], forces[i]));
    let next = |i: u32| match turning.is_some() || i % 2 == 0 {
        true => there,
        false => here,
    };
    let check = |answer| {
        assert!(
            turning.is_none() || answer == Answer::Open,
            "it is {answer:?}"
        )
    };
    if wide {
        let start = Monitor::<i128>::start(config, here.0, here.1);
        let mut monitor = start;
        for i in 0..samples {
            let (count, force) = next(i);
            check(sample_wide(&mut monitor, count, force));
            if turning.is_some() {
                monitor = start;
            }
        }
        return;
    }
    let small = |n: i64| i32::try_from(n).expect("32 bits");
    let start = Monitor::<i64>::start(config, small(here.0), small(here.1));
    let mut monitor = start;
    for i in 0..samples {
        let (count, force) = next(i);
        check(sample(&mut monitor, small(count), small(force)));
        if turning.is_some() {
            monitor = start;
        }
    }
}

/// Instructions of so many samples of a way.
fn counted(way: usize, wide: bool, samples: u32) -> f64 {
    let arguments = [way.to_string(), wide.to_string(), samples.to_string()];
    let [way, wide, samples] = arguments.each_ref().map(String::as_str);
    let flags = ["--toggle-collect=*instructions*sample*"];
    let run = callgrind::counted(&flags, &["--run", way, wide, samples]);
    let (instructions, _) = run.expect("valgrind is installed");
    instructions
}

#[expect(clippy::print_stdout, reason = "a bench prints its table")]
fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    if let [_, first, way, wide, samples] = arguments.as_slice()
        && first == "--run"
    {
        let way: usize = way.parse().expect("a number");
        let wide = wide.parse().expect("true or false");
        let way = WAYS.iter().chain(&WIDE).nth(way).expect("a way");
        run(way, wide, samples.parse().expect("a number"));
        return;
    }
    println!("| way | 64 bits | 128 bits |\n| --- | --- | --- |");
    let each = |way, wide| (counted(way, wide, 3000) - counted(way, wide, 1000)) / 2000.0;
    let mut most = [0_f64; 2];
    for (i, (name, ..)) in WAYS.iter().enumerate() {
        let [narrow, wide] = [false, true].map(|wide| each(i, wide));
        println!("| {name} | {narrow:.1} | {wide:.1} |");
        most = [most[0].max(narrow), most[1].max(wide)];
    }
    let [beyond, far @ ..] = [0, 1, 2].map(|i| each(WAYS.len() + i, true));
    most[1] = most[1].max(beyond);
    println!("| {} | | {beyond:.1} |", WIDE[0].0);
    println!("| at most | {} | {} |", LIMITS[0], LIMITS[1]);
    for (count, (name, ..)) in far.iter().zip(&WIDE[1..]) {
        println!("| {name} | | {count:.1} |");
    }
    println!("| at most | | {FAR_LIMIT} |");
    assert!(
        most[0] <= LIMITS[0] && most[1] <= LIMITS[1] && far.iter().all(|far| *far <= FAR_LIMIT),
        "a sample takes {most:?} instructions, or {far:?}"
    );
}
