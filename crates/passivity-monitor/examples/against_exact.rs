//! Random samples against the exact account: `against_exact [MILLIONS]`.
//!
//! A random motion is followed exactly: positions in sixteenths of a tick, energies in whole numbers of
//! 256ths of a half unit of force times a tick, in 128 bits, written from the ledger's text (the work of the
//! held force less what friction takes at constant velocity, and ½Kx² at the start). At every
//! sample the exact energy has to lie within the bounds of the monitor, the bounds of both widths
//! have to be the same, and no answer may contradict it. Runs are of devices, walls and controllers of all
//! kinds; ends with an error at the first disagreement.

use std::process::ExitCode;
use std::time::Instant;

use passivity_monitor::{Answer, Config, Monitor};
use passivity_random::Random;

/// Samples of one run.
const RUN: u64 = 1000;

/// Positions are in parts of a tick.
const PARTS: i64 = 16;

/// A number from `low` to `high`.
fn between(random: &mut Random, low: i64, high: i64) -> i64 {
    let width = high.abs_diff(low) + 1;
    low + i64::try_from(random.below(width)).expect("the width is small")
}

/// The exact account.
struct Exact {
    /// In parts of a tick.
    position: i64,
    given: i128,
}

impl Exact {
    fn start(stiffness: i64, position: i64) -> Self {
        let x = i128::from(position);
        Self {
            position,
            given: -i128::from(stiffness) * x * x,
        }
    }

    fn go(&mut self, force: i64, viscous: i64, coulomb: i64, to: i64) {
        let d = i128::from(to - self.position);
        let parts = i128::from(PARTS);
        let work = 2 * i128::from(force) * d * parts;
        let taken = 2 * i128::from(viscous) * d * d + 2 * i128::from(coulomb) * d.abs() * parts;
        self.given += work - taken;
        self.position = to;
    }
}

/// How often each answer was given at the end of a run.
#[derive(Default)]
struct Answers {
    passive: u64,
    open: u64,
    active: u64,
}

/// How the force of a run is made.
enum Controller {
    /// The wall on both sides, some samples late.
    Wall { delay: usize },
    /// The wall on one side.
    OneSided,
    /// Any force.
    Random { limit: i64 },
}

/// One run; a sentence where something disagrees.
fn run(random: &mut Random, answers: &mut Answers) -> Result<(), String> {
    let scale = [4, 40, 1000, 1_000_000][between(random, 0, 3) as usize];
    let mut parameter = || between(random, 0, 2 * scale);
    let (stiffness, viscous, coulomb) = (parameter(), parameter(), parameter());
    let fast = [1, 3, 12, 40][between(random, 0, 3) as usize] * PARTS;
    let controller = match between(random, 0, 5) {
        0..=1 => Controller::Wall { delay: 0 },
        2 => Controller::Wall {
            delay: between(random, 1, 3) as usize,
        },
        3 => Controller::OneSided,
        _ => Controller::Random {
            limit: between(random, 0, 20 * scale),
        },
    };
    let config = Config::new(stiffness, viscous, coulomb).map_err(|error| error.to_string())?;
    let mut position = between(random, -20 * PARTS, 20 * PARTS);
    let mut counts = [position.div_euclid(PARTS); 4];
    let force_of = |random: &mut Random, counts: &[i64; 4]| match controller {
        Controller::Wall { delay } => -stiffness * counts[delay] - stiffness / 2,
        Controller::OneSided => (-stiffness * counts[0] - stiffness / 2).min(0),
        Controller::Random { limit } => between(random, -limit, limit),
    };
    let input = |n: i64| i32::try_from(n).expect("the numbers of a run are small");
    let mut force = force_of(random, &counts);
    let mut exact = Exact::start(stiffness, position);
    let mut monitor = Monitor::<i64>::start(config, input(counts[0]), input(force));
    let mut wide = Monitor::<i128>::start(config, counts[0], force);
    let (mut highest, mut speed) = (exact.given, 0);
    for h in 1..RUN {
        speed = (speed + between(random, -fast / 4 - 1, fast / 4 + 1)).clamp(-fast, fast);
        // Drawn back, so that a run stays where its numbers fit.
        position += if position.abs() > 1000 * PARTS && position.signum() == speed.signum() {
            -speed
        } else {
            speed
        };
        exact.go(force, viscous, coulomb, position);
        highest = highest.max(exact.given);
        counts.rotate_right(1);
        counts[0] = position.div_euclid(PARTS);
        force = force_of(random, &counts);
        let answer = monitor.sample(input(counts[0]), input(force));
        let wide_answer = wide.sample(counts[0], force);
        let (Some(bounds), Some(wide_bounds)) = (monitor.given(), wide.given()) else {
            return Err(format!(
                "sample {h}: {answer:?}, {:?}",
                monitor.saturation()
            ));
        };
        let unit = i128::from(PARTS * PARTS);
        let within = i128::from(bounds.least) * unit <= exact.given
            && exact.given <= i128::from(bounds.most) * unit;
        let agrees = match answer {
            Answer::SurelyPassive => highest <= 0,
            Answer::SurelyActive => highest > 0,
            Answer::Open => true,
            Answer::Unknown => false,
        };
        let same = answer == wide_answer
            && i128::from(bounds.least) == wide_bounds.least
            && i128::from(bounds.most) == wide_bounds.most;
        if !(within && agrees && same) {
            return Err(format!(
                "sample {h} of K {stiffness}, V {viscous}, C {coulomb}: {answer:?}, {bounds:?} and {}/{unit}",
                exact.given
            ));
        }
    }
    match monitor.answer() {
        Answer::SurelyPassive => answers.passive += 1,
        Answer::SurelyActive => answers.active += 1,
        Answer::Open | Answer::Unknown => answers.open += 1,
    }
    Ok(())
}

#[expect(clippy::print_stdout, reason = "it says what it found")]
fn main() -> ExitCode {
    let millions = match std::env::args().nth(1).map(|text| text.parse::<u64>()) {
        None => 1,
        Some(Ok(millions)) => millions,
        Some(Err(error)) => {
            eprintln!("expected a number of millions of samples: {error}");
            return ExitCode::from(2);
        }
    };
    let start = Instant::now();
    let (mut random, mut answers) = (Random::new(0), Answers::default());
    let runs = millions * 1_000_000 / RUN;
    for i in 0..runs {
        if let Err(found) = run(&mut random, &mut answers) {
            eprintln!("run {i}: {found}");
            return ExitCode::FAILURE;
        }
    }
    let Answers {
        passive,
        open,
        active,
    } = answers;
    println!(
        "{} samples in {runs} runs, no disagreement: {passive} surely passive, {active} surely active, {open} open; {:.1} s",
        runs * RUN,
        start.elapsed().as_secs_f64()
    );
    ExitCode::SUCCESS
}
