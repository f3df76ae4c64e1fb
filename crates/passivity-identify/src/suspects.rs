//! What it may be that no parameters fit: what else, where it is let in, makes the logs fit.
//!
//! Nothing here is sure. For each way in which a device or a log may differ from the model, the parameters are fitted
//! once more with it, and those that leave no more than the counts' errors are named.

use crate::estimate::{self, spread};
use crate::log::Log;
use crate::region::{Ends, parts};
use crate::search::{Place, Task, first_bounds};

/// Rows of logs that are fitted: of more, everything is named.
const ROWS: usize = 10_000;

/// So many decades to either side of the sketch's another inertia is looked for.
const DECADES: f64 = 2.0;

/// Constant forces from which a fit starts, of the largest force.
const BIASES: [f64; 7] = [0.0, 0.01, -0.01, 0.04, -0.04, 0.15, -0.15];

/// Backlash from which a fit starts, and the most of it, in ticks.
const PLAYS: [f64; 4] = [6.0, 20.0, 60.0, 200.0];
const MOST_PLAY: f64 = 400.0;

/// What no fit is tried for.
const OTHERS: &str = "friction that depends on the position, cogging, static friction above the sliding one, a hand on \
                      the device";

/// What is named of the log itself, whatever fits.
///
/// No larger `--count-error` is tried: it lets in nearly every other cause too, with narrow bounds that are wrong.
const OF_THE_LOG: &str = "an error of the log: rows that are lost where there is no column of times (all that follows is then \
                          shifted), a wrong count in this row or in one before, wrong times, a force that was limited \
                          (saturated) after it was logged, or counts that are off by more than `--count-error` (raise it \
                          to what your counts can be off by, and no further: with more a device or a log with another \
                          error may fit, with bounds that are wrong)";

/// All for which one is, where none fits alone.
const KNOWN: &str = "backlash, a constant force of its own, a friction that is not the same in both directions, a force \
                     of the other sign or one that acts late, motion before the first row, another inertia or another \
                     scale of the force";

/// Turns a log into what it would be, by the numbers that are fitted beside the parameters; it may be the last one.
type Turn = fn(&mut Log, bool, &[f64]);

/// One way to differ from the model.
struct Suspect {
    name: &'static str,
    turn: Turn,
    /// The ends of these numbers.
    ends: Vec<Ends>,
    /// Where they start: the best of these.
    starts: Vec<Vec<f64>>,
    inertia: Ends,
}

/// What it may be that no parameters fit the logs up to a place, with an inertia between ends, which a search cuts into so
/// many parts.
pub(crate) fn suspicion(logs: &[Log], place: Place, (inertia, slabs): (Ends, u32)) -> String {
    let logs = logs.get(..=place.log).unwrap_or_default();
    let Some(log) = logs.last() else {
        return OTHERS.to_owned();
    };
    let mut forces = log.forces.iter().take(place.sample);
    if forces.all(|[lo, hi]| lo + hi == 0.0) {
        return "the device moves before there is a force in the log: a log must start at rest, with no hand on \
                the device"
            .to_owned();
    }
    let mut found = Vec::new();
    if logs.iter().map(Log::len).sum::<usize>() <= ROWS {
        if fit_without(logs, place, (inertia, slabs)) {
            let row = place.sample + 1;
            found.push(format!(
                "a wrong count in row {row}: without it the log fits (write a count between those of the rows beside it, \
                 and keep the row)"
            ));
        }
        let width = width(logs);
        let names: Vec<&str> = suspects(log, place.sample, inertia)
            .iter()
            .filter(|suspect| suspect.fits(logs, width))
            .map(|suspect| suspect.name)
            .collect();
        if !names.is_empty() {
            found.push(format!("{}: with this the log fits", names.join(", or ")));
        }
    }
    match found.is_empty() {
        true => format!("{OF_THE_LOG}; or {OTHERS}, or several things at once, such as {KNOWN}"),
        false => format!("{}; or else {OTHERS}, or {OF_THE_LOG}", found.join("; or ")),
    }
}

/// The width of a count with its error, in ticks.
fn width(logs: &[Log]) -> f64 {
    let widths = logs.iter().filter_map(|log| log.positions.first());
    widths.map(|[lo, hi]| hi - lo).fold(0.0, f64::max)
}

/// Whether some parameters fit the logs where the count at the place of the last one is not known.
fn fit_without(logs: &[Log], place: Place, inertia: (Ends, u32)) -> bool {
    let mut near = logs.to_vec();
    let mut open = logs.to_vec();
    let (Some(guessed), Some(log)) = (near.get_mut(place.log), open.get_mut(place.log)) else {
        return false;
    };
    guessed.pass_over(place.sample);
    if let Some(position) = log.positions.get_mut(place.sample) {
        *position = [f64::NEG_INFINITY, f64::INFINITY];
    }
    some_fit(&open, &near, inertia)
}

/// Whether a short search comes across parameters that fit logs, from the least squares of logs that are `near` them on.
fn some_fit(logs: &[Log], near: &[Log], (inertia, slabs): (Ends, u32)) -> bool {
    /// In intervals of motion.
    const EFFORT: u64 = 3_000_000;
    let [Some(viscous), Some(coulomb), Some(_)] = first_bounds(logs) else {
        return false;
    };
    let most = [viscous, coulomb];
    let first = estimate::first(near, most, inertia);
    let (shear, weights) = estimate::coordinates(near, first);
    let task = Task {
        logs,
        shear,
        weights,
        most,
        near: first,
        effort: EFFORT,
    };
    let found = task.search(parts(&shear, most, inertia, slabs), |_| true);
    found.fits.is_some()
}

impl Suspect {
    /// Whether what is left at the least squares is about as little as the width of a count with its error.
    fn fits(&self, logs: &[Log], width: f64) -> bool {
        /// Least squares do not make the largest residual the smallest.
        const SHARE: f64 = 1.5;
        let turned = |numbers: &[f64]| {
            let mut turned = logs.to_vec();
            let last = turned.len().saturating_sub(1);
            for (log, number) in turned.iter_mut().zip(0..) {
                (self.turn)(log, number == last, numbers);
            }
            turned
        };
        spread(&turned, (&self.ends, &self.starts), self.inertia) <= SHARE * width
    }
}

/// The mean velocity of a log up to a sample.
fn speed(log: &Log, sample: usize) -> f64 {
    let way = log.middles().nth(sample).zip(log.middles().next());
    let time = log.times().get(sample).copied();
    way.zip(time)
        .map_or(0.0, |((to, from), time)| (to - from) / time)
}

/// All ways to differ that are tried, of logs of which the last one is refuted at a sample.
fn suspects(last: &Log, sample: usize, inertia: Ends) -> Vec<Suspect> {
    let simple = |name: &'static str, turn: Turn| Suspect {
        name,
        turn,
        ends: Vec::new(),
        starts: vec![Vec::new()],
        inertia,
    };
    let (speed, force) = (speed(last, sample), last.largest_force());
    let plays = PLAYS
        .iter()
        .flat_map(|play| [0.0, 0.5, 1.0].map(|share| vec![share * play, (1.0 - share) * play]));
    let factor = 10_f64.powf(DECADES);
    vec![
        simple(
            "a force of the other sign, which `--columns` turns, as in f=-NAME",
            |log, _, _| log.forces = log.forces.iter().map(|[lo, hi]| [-hi, -lo]).collect(),
        ),
        Suspect {
            ends: vec![[-3.0 * speed.abs(), 3.0 * speed.abs()]],
            starts: vec![vec![speed]],
            ..simple(
                "a device that moves already in the first row, while a log must start at rest, with no hand on the device",
                |log, is_last, numbers| {
                    if let ([velocity], true) = (numbers, is_last) {
                        log.guess.velocity = *velocity;
                    }
                },
            )
        },
        simple("a force that acts a row later than its own", |log, _, _| {
            log.shift(-1)
        }),
        simple(
            "a force that acts two rows later than its own",
            |log, _, _| log.shift(-2),
        ),
        simple(
            "a force that acts three rows later than its own",
            |log, _, _| log.shift(-3),
        ),
        simple(
            "a force that acts a row earlier than its own",
            |log, _, _| log.shift(1),
        ),
        simple(
            "a force that acts two rows earlier than its own",
            |log, _, _| log.shift(2),
        ),
        Suspect {
            ends: vec![[-force, force]],
            starts: BIASES.iter().map(|bias| vec![bias * force]).collect(),
            ..simple(
                "a constant force that the log does not have, as of gravity or a biased amplifier, or, which shows in \
                 the same way, a friction that is not the same in both directions",
                |log, _, numbers| {
                    if let [bias] = numbers {
                        log.forces
                            .iter_mut()
                            .flatten()
                            .for_each(|force| *force += bias);
                    }
                },
            )
        },
        Suspect {
            ends: vec![[0.0, MOST_PLAY]; 2],
            starts: plays.collect(),
            ..simple(
                "backlash between the device and its encoder",
                |log, _, numbers| {
                    if let [forwards, backwards] = numbers {
                        log.guess.play = [*forwards, *backwards];
                    }
                },
            )
        },
        Suspect {
            inertia: [inertia[0] / factor, inertia[1] * factor],
            ..simple(
                "another inertia, or another scale of the force",
                |_, _, _| {},
            )
        },
    ]
}
