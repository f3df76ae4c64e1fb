//! Jumps of a position by which a counter, or an angle, wrapped around: the account takes them for motions, and counts
//! their friction.
//!
//! A jump of d in an interval of Δτ is one by the period W where, with s and Δτₛ of the intervals directly before and after,
//!
//! - each mean speed |s|/Δτₛ is at most 1/32 of |d|/Δτ, and |s| at most |d|/2. A motion from slow to slow with such a jump
//!   between has to reach more than its mean speed and to lose it again within one interval, for which its acceleration
//!   must be 4|d|/Δτ² at least: some 3·10⁶ rad/s² of 1024 ticks of 8192 in a millisecond. What starts and stops so is
//!   no device but the number that stands for it;
//! - |d| is W but for what the device moved meanwhile, which is about as fast as beside it: at most 2 Σ|s|/Δτₛ·Δτ, twice the
//!   sum for what it was accelerated, and 2 ticks, one for what each of two counts leaves open. By the first condition that
//!   is at most |d|/8 and 2, so that no |d| is near two powers of two;
//! - W is 2¹⁰ … 2³² ticks, as of counters of so many bits, or one revolution, of the device or of the motor behind a
//!   transmission. Angles may be written with few digits, such as two decimals of a radian: of a revolution of theirs 1/512
//!   is left open, more than the 0.01/2π of two of them.
//!
//! An interval beside it that jumps back by more than W/2 is taken less W: a device that rests where its counter wraps
//! around jumps to and fro. At the start and the end of a log one interval beside it is enough.

use multiversion::multiversion;
use passivity_scene::Scene;
use passivity_scene::display::figures;
use serde::{Deserialize, Serialize};

use crate::log::chunk::{Chunk, Samples};
use crate::log::findings::{Finding, position};
use crate::log::layout::{Form, Layout};
use crate::log::running::near_number;
use crate::log::scale::revolutions;
use crate::number::Number;

/// How many times as fast a jump is as the motion beside it, at the least.
const FASTER: f64 = 32.0;

/// What two counts leave open of a jump, in ticks.
const OPEN: f64 = 2.0;

/// What the digits of an angle leave open, of a revolution.
const ROUNDED: f64 = 1.0 / 512.0;

/// Of an encoder with fewer counts a revolution no jump is so much faster than one tick an interval, which a device
/// that moves slowly may seem to make.
const LEAST_COUNTS: f64 = 2.0 * FASTER;

/// The counters that may wrap around, in bits.
const BITS: [f64; 2] = [10.0, 32.0];

/// How many samples before one a jump that ends before it is judged by.
pub(crate) const HISTORY: usize = 3;

/// The periods by which the positions of a log may jump, in ticks.
#[derive(Clone, Debug, Default)]
pub(crate) struct Periods {
    /// A revolution of the device and one of the motor, and what is left open of each.
    turns: [Option<(f64, f64)>; 2],
    /// Whether there are ticks, of which a counter may have so many bits.
    pub(crate) counts: bool,
}

impl Periods {
    pub(crate) fn of(scene: &Scene, layout: &Layout) -> Self {
        let counts = layout.form != Form::X || scene.given.has_encoder();
        let open = match (layout.form, counts) {
            (Form::X, false) => |turn: f64| turn * ROUNDED,
            (Form::X, true) => |turn: f64| (turn * ROUNDED).max(OPEN),
            _ => |_| OPEN,
        };
        let is_told = |turn: &f64| !counts || *turn >= LEAST_COUNTS;
        let turns = revolutions(scene).map(|turn| turn.filter(is_told));
        Self {
            turns: turns.map(|turn| turn.map(|turn| (turn, open(turn)))),
            counts,
        }
    }

    /// The period nearest to a jump of this size, and what is left open of it.
    fn nearest(&self, size: f64) -> Option<(f64, f64)> {
        let [least, most] = BITS;
        let bits = size.log2().round();
        let counter = ((least..=most).contains(&bits) && self.counts).then(|| (bits.exp2(), OPEN));
        let off = |(period, _): &(f64, f64)| (size - period).abs();
        let all = self.turns.into_iter().flatten().chain(counter);
        all.min_by(|a, b| off(a).total_cmp(&off(b)))
    }

    /// Half of the shortest: no jump by less is one by a period. A power of two; `None` without any.
    fn least(&self) -> Option<f64> {
        let [least, _] = BITS;
        let counter = self.counts.then(|| least.exp2());
        let turns = self.turns.iter().flatten().map(|(turn, _)| *turn);
        let shortest = counter.into_iter().chain(turns).min_by(f64::total_cmp)?;
        Some((shortest / 2.0).log2().floor().exp2())
    }
}

/// A step from one sample to the next.
#[derive(Clone, Copy, Debug)]
struct Step {
    /// In ticks.
    by: f64,
    /// In sampling periods.
    lasts: f64,
}

/// The period by which a step jumps, if it does, given those before and after it.
fn period(periods: &Periods, step: Step, beside: [Option<Step>; 2]) -> Option<f64> {
    let size = step.by.abs();
    let (period, open) = periods.nearest(size)?;
    let mut moved = 0.0;
    for other in beside.iter().flatten() {
        let along = other.by * step.by.signum();
        let by = match along < -period / 2.0 {
            true => along + period,
            false => along,
        };
        let meanwhile = by.abs() / other.lasts * step.lasts;
        // What is no number is no wrap.
        if !(by.abs() <= size / 2.0 && meanwhile * FASTER <= size) {
            return None;
        }
        moved += meanwhile;
    }
    let is_near = (size - period).abs() <= 2.0 * moved + open;
    (is_near && beside.iter().any(Option::is_some)).then_some(period)
}

/// Where a position jumped first.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct First {
    /// How many samples of the stretch there are up to the one to which it jumped.
    row: u64,
    /// As the log has them: the bits of doubles.
    from: u64,
    to: u64,
    period: u64,
}

/// How often a position jumped by a period.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Wrapped {
    count: u64,
    first: Option<First>,
}

/// A sample as far as it matters here.
#[derive(Clone, Debug)]
struct Sample {
    /// In ticks, and as it is written.
    at: f64,
    written: f64,
    /// When it was taken, or how long the interval from it lasts.
    time: Option<Number>,
    dtau: Option<Number>,
}

impl Sample {
    fn of(chunk: &Chunk, i: usize) -> Option<Self> {
        let (at, written) = match &chunk.samples {
            Samples::Counts(counts) => {
                let at = ticks(*counts.get(i)?);
                (at, at)
            }
            Samples::Any(samples) => {
                let written = near_number(&samples.written.get(i)?);
                (*samples.near.middles.get(i)?, written)
            }
        };
        Some(Self {
            at,
            written,
            time: chunk.times.get(i),
            dtau: chunk.dtaus.get(i).cloned(),
        })
    }

    fn step_to(&self, next: &Self, layout: &Layout) -> Step {
        let between = self.time.as_ref().zip(next.time.as_ref());
        let lasts = between.and_then(|(from, to)| layout.duration(from, to));
        let lasts = lasts.as_ref().or(self.dtau.as_ref());
        Step {
            by: next.at - self.at,
            lasts: lasts.map_or(1.0, near_number),
        }
    }
}

/// A count as a double, where it is one: there are no counters of more bits.
#[expect(clippy::cast_precision_loss, reason = "of so few bits none is lost")]
fn ticks(count: i64) -> f64 {
    match count.unsigned_abs() < 1 << 53 {
        true => count as f64,
        false => f64::NAN,
    }
}

/// The jumps of a log by a period, as its chunks come.
#[derive(Clone, Debug)]
pub(crate) struct Wraps {
    periods: Periods,
    least: f64,
    /// The latest samples, the latest last.
    before: Vec<Sample>,
    /// How many samples of the stretch came.
    seen: u64,
    found: Wrapped,
}

impl Wraps {
    /// `None` where no jump is one by a period.
    pub(crate) fn new(periods: &Periods) -> Option<Self> {
        Some(Self {
            periods: periods.clone(),
            least: periods.least()?,
            before: Vec::new(),
            seen: 0,
            found: Wrapped::default(),
        })
    }

    /// Looks for jumps in the first `rows` samples of a chunk. One that ends at its last sample waits for the next chunk.
    pub(crate) fn feed(&mut self, layout: &Layout, chunk: &Chunk, rows: usize) {
        let mut known = std::mem::take(&mut self.before);
        let before = known.len();
        let end = before + rows;
        // The first and the last of a chunk are looked at with what came before and for what comes after.
        known.extend((0..rows.min(HISTORY)).filter_map(|i| Sample::of(chunk, i)));
        for at in before.saturating_sub(1).max(1)..(before + 2).min(end.saturating_sub(1)) {
            let row = self.seen + (at + 1 - before) as u64;
            self.judge(layout, &known, at, row);
        }
        if rows > HISTORY && self.is_large(chunk, rows) {
            for i in 2..rows - 1 {
                if self.may_be(chunk, i) {
                    let around = (i - 2..=i + 1).filter_map(|i| Sample::of(chunk, i));
                    let around: Vec<Sample> = around.collect();
                    self.judge(layout, &around, 2, self.seen + (i + 1) as u64);
                }
            }
        }
        if rows > HISTORY {
            known = (rows - HISTORY..rows)
                .filter_map(|i| Sample::of(chunk, i))
                .collect();
        }
        known.drain(..known.len().saturating_sub(HISTORY));
        self.before = known;
        self.seen += rows as u64;
    }

    /// Whether any step of the first samples of a chunk may be long enough.
    fn is_large(&self, chunk: &Chunk, rows: usize) -> bool {
        match &chunk.samples {
            #[expect(clippy::cast_possible_truncation, reason = "a power of two from 2⁵ on")]
            Samples::Counts(counts) => {
                has_step(counts.get(..rows).unwrap_or_default(), self.least as i64)
            }
            Samples::Any(samples) => has_jump(
                samples.near.middles.get(..rows).unwrap_or_default(),
                self.least,
            ),
        }
    }

    /// Whether the step that ends at sample `i` is long and the one before it in its direction is not: what nearly
    /// all steps of a fast device answer.
    #[inline]
    fn may_be(&self, chunk: &Chunk, i: usize) -> bool {
        let three = match &chunk.samples {
            Samples::Counts(counts) => match counts.get(i - 2..=i) {
                Some([a, b, c]) => [a, b, c].map(|n| ticks(*n)),
                _ => return false,
            },
            Samples::Any(samples) => match samples.near.middles.get(i - 2..=i) {
                Some([a, b, c]) => [*a, *b, *c],
                _ => return false,
            },
        };
        let [before, step] = [three[1] - three[0], three[2] - three[1]];
        step.abs() >= self.least && before * step.signum() <= step.abs() / 2.0
    }

    /// Takes the step that ends at one of these samples, which is in a row of the stretch counted from 1, for a jump, if
    /// it is one.
    fn judge(&mut self, layout: &Layout, samples: &[Sample], at: usize, row: u64) {
        let step = |to: usize| {
            let from = samples.get(to.checked_sub(1)?)?;
            Some(from.step_to(samples.get(to)?, layout))
        };
        let Some(own) = step(at).filter(|step| step.by.abs() >= self.least) else {
            return;
        };
        let beside = [step(at - 1), step(at + 1)];
        let Some(period) = period(&self.periods, own, beside) else {
            return;
        };
        self.found.count += 1;
        if let (None, Some([from, to])) = (self.found.first, samples.get(at - 1..=at)) {
            self.found.first = Some(First {
                row,
                from: from.written.to_bits(),
                to: to.written.to_bits(),
                period: period.to_bits(),
            });
        }
    }

    /// Forgets what was found, not what came before.
    pub(crate) fn forget(&mut self) {
        self.seen = 0;
        self.found = Wrapped::default();
    }

    /// What was found; where the log `ends` here its last step has none after it.
    pub(crate) fn finish(mut self, layout: &Layout, ends: bool) -> Wrapped {
        let before = std::mem::take(&mut self.before);
        if let (true, Some(at)) = (ends, before.len().checked_sub(1)) {
            self.judge(layout, &before, at, self.seen);
        }
        self.found
    }
}

/// Whether some step is as long as this power of two.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn has_step(counts: &[i64], least: i64) -> bool {
    let pairs = counts.iter().zip(counts.get(1..).unwrap_or_default());
    let steps = pairs.map(|(from, to)| to.wrapping_sub(*from).unsigned_abs());
    // The highest bit of all of them together is that of the longest.
    steps.fold(0, |all, step| all | step) >= least.unsigned_abs()
}

/// Whether some step is as long as this.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn has_jump(positions: &[f64], least: f64) -> bool {
    let pairs = positions.iter().zip(positions.get(1..).unwrap_or_default());
    let large = pairs.map(|(from, to)| u64::from((to - from).abs() >= least));
    large.fold(0, |any, large| any | large) > 0
}

impl Wrapped {
    /// What it counts.
    pub(crate) fn counts(&self) -> impl Iterator<Item = u64> {
        std::iter::once(self.count).chain(self.first.map(|first| first.row))
    }

    /// Goes on with what was found in the stretch that follows so many samples.
    pub(crate) fn append(&mut self, samples: u64, next: &Self) {
        self.count += next.count;
        let first = next.first.map(|first| First {
            row: samples + first.row,
            ..first
        });
        self.first = self.first.or(first);
    }

    /// What is said of it, and what unwrapped positions must be beside that.
    pub(crate) fn finding(
        &self,
        layout: &Layout,
        periods: &Periods,
        must: &str,
    ) -> Option<Finding> {
        let first = self.first?;
        let what = position(layout.form);
        let [from, to, period] = [first.from, first.to, first.period].map(f64::from_bits);
        let is_it = |turn: &Option<(f64, f64)>| {
            turn.is_some_and(|(turn, _)| turn.to_bits() == first.period)
        };
        let turn = ["one revolution", "one revolution of the motor"]
            .into_iter()
            .zip(&periods.turns)
            .find(|(_, turn)| is_it(turn));
        let by = match turn {
            Some((turn, _)) if layout.form == Form::X => turn.to_owned(),
            Some((turn, _)) => format!("{turn} ({period} ticks)"),
            None => format!("{period} ticks ({} bits)", period.log2()),
        };
        // A position in units is not in revolutions, nor in ticks.
        let amount = match layout.form {
            Form::X => format!(
                "{by} (about {} in `{}`)",
                figures(period / layout.scale().size(), 6),
                layout.name(layout.position)
            ),
            _ => by.clone(),
        };
        let more = match self.count {
            0 | 1 => String::new(),
            2 => ", and so once more".to_owned(),
            count => format!(", and so {} times more", count - 1),
        };
        let row = first.row;
        Some(Finding {
            kind: "wrap",
            says: format!(
                "the {what} jumps from {from} to {to} between rows {} and {row}, by about {by}, and moves slowly before and after{more}: has a counter wrapped around?",
                row.saturating_sub(1)
            ),
            fix: format!(
                "unwrap the {what} in the log{must}: {} {amount} from row {row} on, or {} as much up to \
                 row {}",
                if to < from { "add" } else { "take off" },
                if to < from { "take off" } else { "add" },
                row.saturating_sub(1)
            ),
        })
    }
}
