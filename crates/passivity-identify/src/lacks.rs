//! What a log lacks for its parameters to be known well.

use std::fmt;

use crate::estimate;
use crate::identified::Identified;
use crate::kept::Propagators;
use crate::log::Log;
use crate::motion::simulated;
use crate::region::{COULOMB, INERTIA, VISCOUS};

/// What a log lacks.
#[derive(Clone, Debug, PartialEq)]
pub enum Lack {
    /// The search was stopped by its effort, before the bounds were as narrow as they could be.
    Effort,
    /// There is no force in it.
    Force,
    /// The force moves the device by no more than the counts leave open.
    Motion,
    /// The device moves by few ticks.
    Way {
        /// How many it surely moves.
        ticks: f64,
    },
    /// The device is never left to coast.
    Coasting,
    /// The device moves at one speed: viscous and Coulomb friction are not told apart.
    Speeds,
    /// Viscous friction is small beside Coulomb friction at the speeds of the log.
    Fast,
    /// Coulomb friction is small beside viscous friction at the speeds of the log.
    Slow,
    /// The device neither speeds up nor slows down enough for its inertia to show.
    Acceleration,
    /// The inertia was looked for as well, and the search for it did not come to its end.
    Inertia,
    /// The force may be off by much beside friction.
    ForceError,
    /// All motion, or nearly all, is in one direction.
    OtherWay,
    /// The logs fit with forces that act a row later or earlier too, with other friction.
    Row,
    /// The logs may fit with forces that are off by a factor too, with other friction.
    Scale,
    /// None of these: there is too little of it.
    Length,
}

impl Lack {
    /// Whether the bounds may be wrong, however narrow they are, and not only wide: the logs do not show that the
    /// device is one of the model.
    #[must_use]
    pub const fn is_doubt(&self) -> bool {
        match self {
            Self::OtherWay | Self::Row | Self::Scale => true,
            // Such bounds are wide, or there are none, and what they leave out is refuted.
            Self::Effort
            | Self::Force
            | Self::Motion
            | Self::Way { .. }
            | Self::Coasting
            | Self::Speeds
            | Self::Fast
            | Self::Slow
            | Self::Acceleration
            | Self::Inertia
            | Self::ForceError
            | Self::Length => false,
        }
    }
}

/// So many ticks at least make a log that says something.
const FEW: f64 = 100.0;

impl fmt::Display for Lack {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Effort => f.write_str(
                "a larger --effort may narrow the bounds, as the search came to the bound of its work: try it before you \
                 record more",
            ),
            Self::Force => f.write_str("there is no force in the log: record the commanded force, and push"),
            Self::Motion => f.write_str(
                "the force never surely exceeds friction: the device moves by no more than the counts leave \
                 open, so push harder or longer",
            ),
            Self::Way { ticks } => write!(
                f,
                "the device surely moves by {ticks:.0} ticks only: push it over a few hundred at least"
            ),
            Self::Coasting => f.write_str(
                "there is no coasting phase: let the device come to rest with the force at zero",
            ),
            Self::Speeds => f.write_str(
                "the device moves at about one speed only, so viscous and Coulomb friction cannot be told \
                 apart: let it coast to rest, or add a log at another force",
            ),
            Self::Fast => f.write_str(
                "viscous friction is small beside Coulomb friction at these speeds: add a faster log",
            ),
            Self::Slow => f.write_str(
                "Coulomb friction is small beside viscous friction at these speeds: add a slower log, or one \
                 in which the device coasts to rest",
            ),
            Self::Acceleration => f.write_str(
                "the inertia hardly shows: add a log with a short push and a fast one, or give the inertia",
            ),
            Self::Inertia => f.write_str(
                "the inertia was looked for over decades, and the search was not finished: take it from a \
                 sketch, with a generous tolerance",
            ),
            Self::ForceError => f.write_str(
                "the error of the force is not small beside friction, which makes the bounds wide: know the \
                 force better, and give a smaller error of it",
            ),
            Self::OtherWay => f.write_str(
                "all motion, or nearly all, is in one direction, so that a constant force, as of gravity or a \
                 biased amplifier, cannot be told from friction: record one log each way",
            ),
            Self::Row => f.write_str(
                "with a force that acts a row later or earlier than its own the logs fit too, with a friction beyond \
                 these bounds, which are wrong if it does: log each force in the row from which it acts, and add a log \
                 with a sudden push each way, hard enough for many ticks a row",
            ),
            Self::Scale => f.write_str(
                "with a force that is off by a factor, as by a torque constant, the logs fit too, as the inertia does not tell \
                 the factor, and friction is off by as much, beyond these bounds: say by what share of itself the force may be \
                 off, as with --scale-error 0.05",
            ),
            Self::Length => f.write_str("there is too little motion: add a longer log, or a second one"),
        }
    }
}

/// What the logs lack. A box that is narrow may still be that of another device: one with a constant force of its
/// own, which only motion in both directions shows.
pub(crate) fn lacks(identified: &Identified) -> Vec<Lack> {
    let mut all = match identified.is_informative() {
        true => Vec::new(),
        false => of_wide(identified),
    };
    if goes_one_way(&identified.logs) {
        all.push(Lack::OtherWay);
    }
    if fits_another_row(identified) {
        all.push(Lack::Row);
    }
    if !identified.is_scale_said && identified.is_bounded() && fits_another_scale(identified) {
        all.push(Lack::Scale);
    }
    all
}

/// Whether the logs fit with forces a row later or earlier as well, with friction beyond the box.
///
/// A spring force of a swing that acts late by a time t is, nearly, one in time with a viscous friction that is less
/// by t times its stiffness.
fn fits_another_row(identified: &Identified) -> bool {
    // Before the first row there may have been no force, or its own.
    let shifts: [fn(&mut Log); 3] = [
        |log| log.shift(1),
        |log| log.shift(-1),
        |log| {
            let before = log.forces.first().copied();
            log.shift(-1);
            log.forces
                .iter_mut()
                .zip(before)
                .for_each(|(first, own)| *first = own);
        },
    ];
    shifts.iter().any(|shift| fits_beyond(identified, shift))
}

/// Whether the logs may fit with forces that are all off by a factor, with friction beyond the box: where the inertia has a
/// tolerance that is worth a factor, or does not show in the logs.
fn fits_another_scale(identified: &Identified) -> bool {
    /// A tolerance below this hides no factor that matters.
    const KNOWN: f64 = 1.001;
    /// How far off a torque constant may well be.
    const FACTORS: [f64; 2] = [1.05, 0.95];
    let [least, most] = identified.inertia;
    let scaled = |factor: f64| fits_beyond(identified, |log| log.scale(factor));
    most > KNOWN * least || FACTORS.into_iter().any(scaled)
}

/// Whether logs that are changed fit, by least squares, about as well as counts tell, with friction beyond the box.
fn fits_beyond(identified: &Identified, change: impl Fn(&mut Log)) -> bool {
    /// Of the width of a count: least squares do not make the largest residual the smallest.
    const SHARE: f64 = 1.5;
    let (Some(hull), Some(best)) = (identified.found.hull, identified.best) else {
        return false;
    };
    let widths = identified.logs.iter().flat_map(|log| log.positions.first());
    let width = widths.map(|[lo, hi]| hi - lo).fold(0.0, f64::max);
    let mut logs = identified.logs.clone();
    logs.iter_mut().for_each(change);
    let (at, apart) = estimate::near(&logs, best, identified.inertia);
    let mut frictions = at.iter().zip(hull).take(INERTIA);
    let is_beyond = frictions.any(|(x, [lo, hi])| !(lo..=hi).contains(x));
    is_beyond && apart <= SHARE * width
}

/// Whether the device surely moves, and nowhere the other way by a tenth of that or more.
fn goes_one_way(logs: &[Log]) -> bool {
    /// So much of a way is nothing beside it: as where the device springs back.
    const LITTLE: f64 = 0.1;
    let ways = logs.iter().map(Log::sure_ways);
    let [up, down] = ways.fold([0.0_f64; 2], |most, way| {
        [most[0].max(way[0]), most[1].max(way[1])]
    });
    up.min(down) < LITTLE * up.max(down)
}

/// What the logs of a wide box lack.
fn of_wide(identified: &Identified) -> Vec<Lack> {
    let logs = &identified.logs;
    if logs.iter().all(|log| largest_logged(log) == 0.0) {
        return vec![Lack::Force];
    }
    let ticks = logs.iter().map(Log::sure_way).fold(0.0, f64::max);
    let Some(best) = identified.best.filter(|_| ticks > 0.0) else {
        return vec![Lack::Motion];
    };
    let mut all = Vec::new();
    if ticks < FEW {
        all.push(Lack::Way { ticks });
    }
    let motions: Vec<Vec<[f64; 2]>> = logs.iter().map(|log| steps(log, best)).collect();
    if !logs
        .iter()
        .zip(&motions)
        .any(|(log, steps)| coasts(log, steps))
    {
        all.push(Lack::Coasting);
    }
    let speeds = Speeds::of(&motions);
    if speeds.fast < 2.0 * speeds.slow {
        all.push(Lack::Speeds);
    }
    let [viscous, coulomb, _] = best;
    let wide = |dimension: usize| {
        let found = identified.parameters.get(dimension);
        found.is_some_and(|(_, bounds)| !bounds.is_narrow())
    };
    if wide(VISCOUS) && viscous * speeds.fast < 0.2 * coulomb {
        all.push(Lack::Fast);
    }
    if wide(COULOMB) && coulomb < 0.2 * viscous * speeds.slow {
        all.push(Lack::Slow);
    }
    // About at this share of a friction the error alone makes its range, or that of the other, a tenth wide.
    let error = identified.force_error;
    let is_much = |friction: f64| error > 0.005 * friction;
    if wide(COULOMB) && is_much(coulomb) || wide(VISCOUS) && is_much(viscous * speeds.fast) {
        all.push(Lack::ForceError);
    }
    if wide(INERTIA) && !wide(VISCOUS) && !wide(COULOMB) {
        all.push(Lack::Acceleration);
    }
    if identified.parameters.len() == 3 && identified.stopped_early {
        return vec![Lack::Inertia];
    }
    if identified.stopped_early {
        all.insert(0, Lack::Effort);
    }
    if all.is_empty() {
        all.push(Lack::Length);
    }
    all
}

/// The way over each interval, and its duration, as they are at the best estimate.
fn steps(log: &Log, best: [f64; 3]) -> Vec<[f64; 2]> {
    let ways = simulated(log, best, &mut Propagators::default());
    let pairs = ways.iter().zip(ways.iter().skip(1));
    let durations = log.durations.iter();
    pairs
        .zip(durations)
        .map(|((from, to), duration)| [to - from, duration.hi])
        .collect()
}

/// The force that was logged, whatever its error may be.
fn logged([lo, hi]: &[f64; 2]) -> f64 {
    0.5 * lo + 0.5 * hi
}

/// The largest magnitude of the force that was logged.
fn largest_logged(log: &Log) -> f64 {
    let forces = log.intervals().map(|(force, _)| logged(force).abs());
    forces.fold(0.0, f64::max)
}

/// Whether the device moves by some ticks while the logged force is next to nothing.
fn coasts(log: &Log, steps: &[[f64; 2]]) -> bool {
    /// Ticks.
    const SOME: f64 = 10.0;
    let little = 0.005 * largest_logged(log);
    let free = log.intervals().zip(steps);
    let free = free.filter(|((force, _), _)| logged(force).abs() <= little);
    free.map(|(_, [way, _])| way.abs()).sum::<f64>() >= SOME
}

/// The speeds of the motion: a tenth of the time that it moves it is slower than the one, a tenth faster
/// than the other.
struct Speeds {
    slow: f64,
    fast: f64,
}

impl Speeds {
    fn of(motions: &[Vec<[f64; 2]>]) -> Self {
        let all = motions.iter().flatten();
        let mut speeds: Vec<f64> = all.map(|[way, time]| way.abs() / time).collect();
        let most = speeds.iter().copied().fold(0.0, f64::max);
        speeds.retain(|speed| *speed > 1e-3 * most);
        speeds.sort_by(f64::total_cmp);
        let at = |tenths: usize| {
            let index = speeds.len().saturating_sub(1) * tenths / 10;
            speeds.get(index).copied().unwrap_or(0.0)
        };
        Self {
            slow: at(1),
            fast: at(9),
        }
    }
}
