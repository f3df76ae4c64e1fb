//! Instructions a sample, counted by callgrind, for the ways through the account.
//!
//! `cargo bench -p passivity-monitor` runs itself under valgrind, for 1000 and for 3000 samples of each
//! way; the difference over 2000 is what a sample costs, the call included. Ends with an error where
//! one costs more than the limit of its width.

#[path = "../../passivity-sim/benches/callgrind/mod.rs"]
mod callgrind;

use passivity_monitor::{Answer, Config, Monitor};

/// The most instructions that a sample may take, with sums of 64 and of 128 bits.
const LIMITS: [f64; 2] = [100.0, 200.0];

/// A run: its name, KΔ, bΔ/T and c, the two counts between which it goes, and its force at each.
type Way = (&'static str, [i64; 3], [i32; 2], [i32; 2]);

/// The wall's own force is passive at the first, open or active at the others.
const WAYS: [Way; 7] = [
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
    (TURNING, [1000, 600, 700], [0, 40], [40_100, 0]),
];

/// The longest way: many ticks, and the answer changes as the most is above zero somewhere within the tick alone.
/// Each sample of it is the first one after a start.
const TURNING: &str = "as the answer changes";

/// What is stored at the start of [`TURNING`], so that the most is just below zero at the lower end of the tick.
const STORED: i64 = 1_328_050;

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
    let turns = name == TURNING;
    if turns {
        config = config.with_stored_at_start(STORED).expect("in range");
    }
    let [here, there] = [0, 1].map(|i| (counts[i], forces[i]));
    let mut monitor = Monitor::<i64>::start(config, here.0, here.1);
    let mut other = Monitor::<i128>::start(config, here.0.into(), here.1.into());
    let starts = (monitor, other);
    for i in 0..samples {
        if turns {
            (monitor, other) = starts;
        }
        let (count, force) = if turns || i % 2 == 0 { there } else { here };
        let answer = match wide {
            true => sample_wide(&mut other, count.into(), force.into()),
            false => sample(&mut monitor, count, force),
        };
        assert!(!turns || answer == Answer::Open, "it stays {answer:?}");
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
        run(&WAYS[way], wide, samples.parse().expect("a number"));
        return;
    }
    println!("| way | 64 bits | 128 bits |\n| --- | --- | --- |");
    let mut most = [0_f64; 2];
    for (i, (name, ..)) in WAYS.iter().enumerate() {
        let [narrow, wide] =
            [false, true].map(|wide| (counted(i, wide, 3000) - counted(i, wide, 1000)) / 2000.0);
        println!("| {name} | {narrow:.1} | {wide:.1} |");
        most = [most[0].max(narrow), most[1].max(wide)];
    }
    println!("| at most | {} | {} |", LIMITS[0], LIMITS[1]);
    assert!(
        most[0] <= LIMITS[0] && most[1] <= LIMITS[1],
        "a sample takes {most:?} instructions"
    );
}
