//! A motion: position, velocity, the held force, and what each interval generated and dissipated, with
//! the encoder's edges dashed as in Fig. 6.

mod draw;
mod within;

use crate::ledger::Entry;
use crate::plan::Plan;
use within::{Acting, Follower};

pub use draw::draw;

/// The start of an interval.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Sample {
    /// Time in sampling periods.
    time: f64,
    /// ξ in ticks.
    xi: f64,
    /// ξ̇ in ticks per sample.
    velocity: f64,
    acting: Acting,
}

/// What some intervals in a row generated, against the linear spring, and dissipated, in KΔ².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Bar {
    generated: f64,
    dissipated: f64,
}

/// What a picture needs of a motion: all of a short one, the extremes of stretches of a long one, in
/// bounded memory.
#[derive(Clone, Debug)]
pub struct Motion {
    follower: Follower,
    /// The intervals that are drawn.
    from: u64,
    until: u64,
    samples: Vec<Sample>,
    /// Where the last interval ended.
    end: Sample,
    stretch: u64,
    pending: Vec<Sample>,
    bars: Vec<Bar>,
    /// How many intervals a bar is of, and how many the last one has.
    per_bar: u64,
    in_last: u64,
}

/// The most samples that are kept.
const MOST: usize = 16_384;

/// The most bars that are drawn.
const MOST_BARS: usize = 240;

impl Motion {
    /// A motion of a plan, to be seen even if it has no interval.
    #[must_use]
    pub fn new(plan: &Plan) -> Self {
        let [xi, velocity] = plan.start();
        Self {
            follower: Follower::new(plan),
            from: 0,
            until: u64::MAX,
            samples: Vec::new(),
            end: Sample {
                xi,
                velocity,
                ..Sample::default()
            },
            stretch: 1,
            pending: Vec::new(),
            bars: Vec::new(),
            per_bar: 1,
            in_last: 0,
        }
    }

    /// The same, of which the intervals from the first up to, but without, the last are drawn.
    #[must_use]
    pub const fn between(mut self, from: u64, until: u64) -> Self {
        self.from = from;
        self.until = until;
        self
    }

    /// Takes the next interval.
    pub fn add(&mut self, entry: &Entry) {
        let acting = self.follower.next(entry.h, entry.xi0);
        if entry.h < self.from || entry.h >= self.until {
            return;
        }
        self.pending.push(Sample {
            time: entry.h as f64,
            xi: entry.xi0,
            velocity: entry.v0,
            acting,
        });
        self.end = Sample {
            time: (entry.h + 1) as f64,
            xi: entry.xi1,
            velocity: entry.v1,
            acting,
        };
        self.add_bar(entry);
        if self.pending.len() as u64 >= self.stretch * 4 {
            self.settle();
        }
    }

    /// A device that rests where it starts, in so many intervals.
    pub fn rest(&mut self, intervals: u64) {
        let xi = self.end.xi;
        for h in self.from..intervals.min(self.until) {
            self.add(&Entry {
                h,
                xi0: xi,
                xi1: xi,
                ..Entry::default()
            });
        }
    }

    fn add_bar(&mut self, entry: &Entry) {
        if self.in_last == 0 || self.in_last == self.per_bar {
            if self.bars.len() == 2 * MOST_BARS {
                let sum = |pair: &[Bar]| pair.iter().fold(Bar::default(), |sum, bar| sum.plus(bar));
                self.bars = self.bars.chunks(2).map(sum).collect();
                self.per_bar *= 2;
            }
            self.bars.push(Bar::default());
            self.in_last = 0;
        }
        let this = Bar {
            generated: entry.generated_linear,
            dissipated: entry.dissipated,
        };
        if let Some(last) = self.bars.last_mut() {
            *last = last.plus(&this);
        }
        self.in_last += 1;
    }

    /// Keeps the extremes of what is pending, and half of everything when there is too much.
    fn settle(&mut self) {
        thin(&self.pending, self.stretch, &mut self.samples);
        self.pending.clear();
        if self.samples.len() > MOST {
            let mut fewer = Vec::with_capacity(MOST);
            for group in self.samples.chunks(8) {
                thin(group, 2, &mut fewer);
            }
            self.samples = fewer;
            self.stretch *= 2;
        }
    }

    /// Whether every interval is kept, not the extremes of stretches.
    const fn is_whole(&self) -> bool {
        self.stretch == 1
    }
}

impl Bar {
    fn plus(&self, other: &Self) -> Self {
        Self {
            generated: self.generated + other.generated,
            dissipated: self.dissipated + other.dissipated,
        }
    }
}

/// Of a group, the samples with extreme position, velocity or force, unless `stretch` is 1.
fn thin(group: &[Sample], stretch: u64, kept: &mut Vec<Sample>) {
    if stretch == 1 {
        kept.extend_from_slice(group);
        return;
    }
    let by = |key: fn(&Sample) -> f64| {
        let order = move |a: &&Sample, b: &&Sample| key(a).total_cmp(&key(b));
        [group.iter().min_by(order), group.iter().max_by(order)]
    };
    let keys: [fn(&Sample) -> f64; 3] = [|s| s.xi, |s| s.velocity, |s| s.acting.held];
    let mut extremes: Vec<Sample> = keys.into_iter().flat_map(by).flatten().copied().collect();
    extremes.sort_by(|a, b| a.time.total_cmp(&b.time));
    extremes.dedup_by(|a, b| a.time == b.time);
    kept.extend(extremes);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Plain;

    #[test]
    fn bars_add_up_to_what_was_generated_and_dissipated() {
        let plain = Plain {
            mu: 50.0,
            beta: 0.6,
            sigma: 0.4,
            xi: 0.0,
            velocity: 5.0,
        };
        for intervals in [100, 480, 481, 5000] {
            let plan = Plan::plain(&plain, intervals);
            let mut motion = Motion::new(&plan);
            let (_, totals) = crate::run::ledger(&plan, |entry| {
                motion.add(entry);
                true
            });
            let sum = motion
                .bars
                .iter()
                .fold(Bar::default(), |sum, bar| sum.plus(bar));
            assert!((sum.generated - totals.generated_linear).abs() < 1e-9);
            assert!((sum.dissipated - totals.dissipated).abs() < 1e-9);
            assert!(motion.bars.len() <= 2 * MOST_BARS);
            let bars = intervals.div_ceil(motion.per_bar);
            assert_eq!(motion.bars.len() as u64, bars, "{intervals}");
        }
    }
}
