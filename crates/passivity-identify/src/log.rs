//! A log as the search needs it: doubles that surely hold what was recorded.

use num_traits::ToPrimitive as _;
use passivity_audit::{Number, Reading, Sampled};
use passivity_core::BigRational;
use passivity_sim::{Double, Enclosed};

use crate::directed::{add, add_down, mul};
use crate::identified::IdentifyError;
use crate::kept::Duration;

/// One experiment: samples of a device that starts at rest, with the force held after each.
#[derive(Clone, Debug)]
pub(crate) struct Log {
    /// Where the device may be at each sample, in ticks.
    pub(crate) positions: Vec<[f64; 2]>,
    /// The force that is held from each sample to the next, in KΔ.
    pub(crate) forces: Vec<[f64; 2]>,
    /// How long each interval is, in sampling periods: one fewer than positions.
    pub(crate) durations: Vec<Duration>,
    /// What else moves the device than the model has: nothing, but in a guess.
    pub(crate) guess: Guess,
}

/// What may have happened beside what a log says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Guess {
    /// The velocity at the first row, in ticks per sampling period.
    pub(crate) velocity: f64,
    /// How far the device can go from its first row until the encoder follows, forwards and backwards, in ticks.
    pub(crate) play: [f64; 2],
}

impl Guess {
    /// What the encoder sees of ways.
    pub(crate) fn seen(&self, mut ways: Vec<f64>) -> Vec<f64> {
        let mut seen = 0.0_f64;
        for way in &mut ways {
            seen = seen.max(*way - self.play[0]).min(*way + self.play[1]);
            *way = seen;
        }
        ways
    }
}

/// By how much what is recorded may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Errors {
    /// Of a count, in ticks, to either side.
    pub(crate) count: f64,
    /// Of the force, in KΔ, to either side.
    pub(crate) force: f64,
}

impl Log {
    /// What is known of samples: a count n, or a position x of the log in ticks, says that the device is
    /// in [n − e, n + 1 + e], where e is the error of a count.
    ///
    /// Only how counts differ matters: they are taken from the first one on, as doubles have no room for a tick beside
    /// a large offset of all.
    pub(crate) fn of(sampled: &Sampled, errors: Errors) -> Self {
        let is_count = |reading: &Reading| matches!(reading, Reading::Count(_));
        let origin = match sampled.positions.first() {
            Some(Reading::Count(first)) if sampled.positions.iter().all(is_count) => *first,
            _ => 0,
        };
        let position = |reading: &Reading| {
            let [lo, hi] = match reading {
                Reading::Count(n) => around_way(origin, *n),
                reading => around(reading),
            };
            let hi = if is_count(reading) { hi } else { add(hi, 1.0) };
            [add_down(lo, -errors.count), add(hi, errors.count)]
        };
        let force = |reading: &Reading| {
            let [lo, hi] = around(reading);
            [add_down(lo, -errors.force), add(hi, errors.force)]
        };
        let mut different: Vec<[f64; 2]> = Vec::new();
        let mut last: Option<Duration> = None;
        let mut durations = Vec::with_capacity(sampled.durations.len());
        for duration in &sampled.durations {
            let [lo, hi] = around_number(duration);
            let is_same = |known: &Duration| known.lo == lo && known.hi == hi;
            let next = last.filter(is_same).unwrap_or_else(|| {
                let known = different.iter().position(|ends| *ends == [lo, hi]);
                // Those that no motion keeps need not be told apart.
                let index = known.unwrap_or(different.len());
                if known.is_none() && different.len() < crate::kept::KEPT {
                    different.push([lo, hi]);
                }
                Duration { lo, hi, index }
            });
            durations.push(next);
            last = Some(next);
        }
        Self {
            positions: sampled.positions.iter().map(position).collect(),
            forces: sampled.forces.iter().map(force).collect(),
            durations,
            guess: Guess::default(),
        }
    }

    /// How many samples there are.
    pub(crate) const fn len(&self) -> usize {
        self.positions.len()
    }

    /// When each sample was taken, in sampling periods from the first, nearly.
    pub(crate) fn times(&self) -> Vec<f64> {
        let mut now = 0.0;
        let after = self.durations.iter().map(|duration| {
            now += duration.lo;
            now
        });
        std::iter::once(0.0).chain(after).collect()
    }

    /// The middle of where the device may be at each sample.
    pub(crate) fn middles(&self) -> impl Iterator<Item = f64> + '_ {
        self.positions.iter().map(|[lo, hi]| 0.5 * lo + 0.5 * hi)
    }

    /// The intervals: the force over each and its duration.
    pub(crate) fn intervals(&self) -> impl Iterator<Item = (&[f64; 2], &Duration)> {
        self.forces.iter().zip(&self.durations)
    }

    /// How far apart two samples surely are, at the most over all pairs; below zero where none are.
    pub(crate) fn sure_way(&self) -> f64 {
        let most = |x: f64, [lo, _]: &[f64; 2]| x.max(*lo);
        let least = |x: f64, [_, hi]: &[f64; 2]| x.min(*hi);
        let highest = self.positions.iter().fold(f64::NEG_INFINITY, most);
        let lowest = self.positions.iter().fold(f64::INFINITY, least);
        add_down(highest, -lowest)
    }

    /// How far the device surely goes up, and how far down, at the most over all pairs of samples in their
    /// order.
    pub(crate) fn sure_ways(&self) -> [f64; 2] {
        let (mut highest, mut lowest) = (f64::NEG_INFINITY, f64::INFINITY);
        let [mut up, mut down] = [0.0_f64; 2];
        for [lo, hi] in &self.positions {
            (highest, lowest) = (highest.max(*lo), lowest.min(*hi));
            up = up.max(add_down(*lo, -lowest));
            down = down.max(add_down(highest, -*hi));
        }
        [up, down]
    }

    /// Refuses a log in which the device moves while there is surely no force. Where the force may be off there may
    /// be one in every row: the search tells whether it can have moved the device.
    pub(crate) fn starts_at_rest(&self) -> Result<(), IdentifyError> {
        let first = self.forces.iter().position(|force| *force != [0.0; 2]);
        let still = self
            .positions
            .iter()
            .take(first.map_or(self.len(), |first| first + 1));
        let mut known = [f64::NEG_INFINITY, f64::INFINITY];
        let moved = still.clone().enumerate().find(|(_, [lo, hi])| {
            known = [known[0].max(*lo), known[1].min(*hi)];
            known[0] > known[1]
        });
        let Some((to, [lo, hi])) = moved else {
            return Ok(());
        };
        // Of intervals that have nothing in common two are apart.
        let from = still
            .take(to)
            .position(|[least, most]| most < lo || hi < least);
        let (from, to) = (from.unwrap_or_default() + 1, to + 1);
        let acts = first.map_or_else(String::new, |first| {
            format!(", and no force acts before row {}", first + 1)
        });
        Err(IdentifyError::new(format!(
            "row {to}: the device moves before there is a force: it is elsewhere than in row {from}{acts}: is each force \
             logged a row after the one from which it acts, are counts off by more than --count-error, or was there a \
             hand on the device? A log must start at rest"
        )))
    }

    /// Takes every force so many times.
    pub(crate) fn scale(&mut self, factor: f64) {
        for ends in self.forces.iter_mut().flatten() {
            *ends *= factor;
        }
    }

    /// Lets each force act so many rows earlier.
    pub(crate) fn shift(&mut self, rows: isize) {
        let forces = &self.forces;
        let of = |row: usize| {
            let from = row.checked_add_signed(rows)?;
            forces.get(from).or(forces.last()).copied()
        };
        let shifted = (0..forces.len()).map(|row| of(row).unwrap_or_default());
        self.forces = shifted.collect();
    }

    /// Takes for the position at a sample the middle between those beside it.
    pub(crate) fn pass_over(&mut self, sample: usize) {
        let of = |at: Option<usize>| at.and_then(|at| self.positions.get(at)).copied();
        let (before, after) = (of(sample.checked_sub(1)), of(sample.checked_add(1)));
        let (Some([lo, hi]), Some([least, most])) = (before, after.or(before)) else {
            return;
        };
        if let Some(position) = self.positions.get_mut(sample) {
            *position = [0.5 * lo + 0.5 * least, 0.5 * hi + 0.5 * most];
        }
    }

    /// The largest magnitude of the force.
    pub(crate) fn largest_force(&self) -> f64 {
        let forces = self.intervals().flat_map(|(force, _)| *force);
        forces.fold(0.0, |most, force| most.max(force.abs()))
    }

    /// The largest mean speed over a fiftieth of the log, in ticks per sampling period.
    pub(crate) fn fastest(&self) -> f64 {
        let times = self.times();
        let middles: Vec<f64> = self.middles().collect();
        let stretch = (self.len() / 50).max(1);
        let pairs = middles.iter().zip(middles.iter().skip(stretch));
        let spans = times.iter().zip(times.iter().skip(stretch));
        let speeds = pairs.zip(spans).map(|((from, to), (start, end))| {
            (to - from).abs() / (end - start).max(f64::MIN_POSITIVE)
        });
        speeds.fold(0.0, f64::max)
    }

    /// ∫|u| and ∬|u| over the log, rounded up.
    pub(crate) fn impulses(&self) -> [f64; 2] {
        let (mut once, mut twice) = (0.0, 0.0);
        for ([lo, hi], duration) in self.intervals() {
            once = add(once, mul(lo.abs().max(hi.abs()), duration.hi));
            twice = add(twice, mul(once, duration.hi));
        }
        [once, twice]
    }
}

/// Doubles around the tick of a count, from another count on.
fn around_way(from: i64, to: i64) -> [f64; 2] {
    let way = i128::from(to) - i128::from(from);
    let ends = [way, way + 1].map(|end| BigRational::from_integer(end.into()));
    let [lo, hi] = ends.map(|end| Enclosed::<Double>::from(&end).bounds());
    [lo[0], hi[1]]
}

/// Doubles around what is known of a number.
fn around(reading: &Reading) -> [f64; 2] {
    match reading {
        Reading::Exact(x) => around_number(x),
        reading => {
            let known = reading.to_rational();
            let [lo, _] = Enclosed::<Double>::from(known.lo()).bounds();
            let [_, hi] = Enclosed::<Double>::from(known.hi()).bounds();
            [lo, hi]
        }
    }
}

/// The tightest doubles around a number, or the next ones.
fn around_number(x: &Number) -> [f64; 2] {
    /// Up to here whole numbers are doubles.
    const EXACT: u64 = 1 << 53;
    if let Number::Small(n, d) = x
        && n.unsigned_abs().max(d.unsigned_abs()) < EXACT
        && let (Some(numerator), Some(denominator)) = (n.to_f64(), d.to_f64())
    {
        let near = numerator / denominator;
        return match n % d == 0 {
            true => [near, near],
            false => [near.next_down(), near.next_up()],
        };
    }
    Enclosed::<Double>::from(&x.to_rational()).bounds()
}
