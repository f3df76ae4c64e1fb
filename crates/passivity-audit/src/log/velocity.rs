//! The velocities of a log against its positions: are they those of the motion, and if not, are they late,
//! of the other sign, or to another scale?
//!
//! Nothing exact rests on a velocity, so the comparison is one of doubles: a finding beside the account.

use std::collections::VecDeque;

use crate::log::chunk::Chunk;
use crate::log::error::TraceError;
use crate::log::exact::ExactSum;
use crate::log::layout::Layout;
use crate::log::report::Fitted;
use crate::log::running::{near_number, near_reading};
use crate::log::step::undefined;
use crate::number::{Number, difference};

/// The longest lag that is tried, in samples.
const LAGS: usize = 8;

/// Over as many samples velocities are compared beside that, as groups of groups: ticks and noise are so much less of what a slow
/// device moves then.
const GROUP: usize = 8;
const LONG: usize = GROUP * GROUP;

/// The velocities of a log compared with the mean velocities between its samples.
#[derive(Clone, Debug, Default)]
pub(crate) struct Velocities {
    /// The latest sample, in ticks, with its velocity and its time.
    latest: Option<(f64, f64, Option<Number>)>,
    /// Mean velocities, the latest first, in ticks per period.
    means: VecDeque<f64>,
    /// What the velocities come to in each of the latest intervals, in ticks, and in groups of intervals, the latest first.
    ways: VecDeque<f64>,
    groups: VecDeque<f64>,
    /// The latest positions, the latest first, in ticks.
    positions: VecDeque<f64>,
    pub(crate) compared: u64,
    /// By lag, Σ v·w and Σ w², with w the mean velocity.
    pub(crate) products: [[ExactSum; 2]; LAGS + 1],
    /// Σ v².
    pub(crate) squares: ExactSum,
    /// Σ (w′ − w)² − (v − w)², with w and w′ the mean velocities before and after.
    pub(crate) spare: ExactSum,
    /// Over [`LONG`] samples, Σ s², Σ s·d and Σ d², with s what the velocities come to and d what was moved.
    pub(crate) long: [ExactSum; 3],
}

impl Velocities {
    /// Compares the velocities of the first `rows` samples of a chunk, whose first interval lasts as long as its times say.
    pub(crate) fn feed(
        &mut self,
        layout: &Layout,
        chunk: &Chunk,
        rows: usize,
    ) -> Result<(), TraceError> {
        for (i, velocity) in chunk.velocities.iter().enumerate().take(rows) {
            let sample = chunk.samples.get(i).ok_or_else(undefined)?;
            let position = near_reading(&sample);
            let time = chunk.times.get(i);
            let before = self.latest.replace((position, *velocity, time.clone()));
            let Some((from, left, since)) = before else {
                continue;
            };
            let lasts = match since.zip(time) {
                Some((since, time)) => {
                    let periods = layout.duration(&since, &time);
                    near_number(&periods.unwrap_or_else(|| difference(&time, &since)))
                }
                None => 1.0,
            };
            self.go_on(position, (left + velocity) / 2.0 * lasts);
            self.means.push_front((position - from) / lasts);
            self.means.truncate(LAGS + 1);
            if self.means.len() <= LAGS {
                continue;
            }
            for (mean, [mixed, own]) in self.means.iter().zip(&mut self.products) {
                mixed.add(velocity * mean);
                own.add(mean * mean);
            }
            self.squares.add(velocity * velocity);
            let mut means = self.means.iter();
            if let (Some(after), Some(mean)) = (means.next(), means.next()) {
                self.spare.add((after - mean) * (after - mean));
                self.spare.add(-(left - mean) * (left - mean));
            }
            self.compared += 1;
        }
        Ok(())
    }

    /// Goes on to a position, to which the velocities come by this way.
    fn go_on(&mut self, position: f64, way: f64) {
        self.ways.push_front(way);
        self.ways.truncate(GROUP);
        self.groups.push_front(self.ways.iter().sum());
        self.groups.truncate(LONG);
        self.positions.push_front(position);
        self.positions.truncate(LONG + 1);
        let Some(from) = self.positions.get(LONG) else {
            return;
        };
        let (moved, way) = (
            position - from,
            self.groups.iter().step_by(GROUP).sum::<f64>(),
        );
        let [squares, mixed, own] = &mut self.long;
        squares.add(way * way);
        mixed.add(way * moved);
        own.add(moved * moved);
    }

    /// How many samples before one its velocity is compared by.
    pub(crate) const HISTORY: usize = LONG + 2;

    /// Forgets what was found, not what came before the next velocity.
    pub(crate) fn forget(&mut self) {
        self.compared = 0;
        self.products = Default::default();
        self.squares = ExactSum::default();
        self.spare = ExactSum::default();
        self.long = Default::default();
    }

    /// Goes on with what was found of the velocities that follow.
    pub(crate) fn append(&mut self, other: &Self) {
        self.compared += other.compared;
        self.squares.add_sum(&other.squares);
        self.spare.add_sum(&other.spare);
        let products = self.products.iter_mut().flatten();
        let products = products.chain(&mut self.long);
        for (own, other) in products.zip(other.products.iter().flatten().chain(&other.long)) {
            own.add_sum(other);
        }
    }

    /// Whether the velocities are those of the motion as far as its samples tell.
    ///
    /// A velocity that rises or falls all the time is at a sample between the mean velocities before and after
    /// it, and so no farther from the one than the other is. Velocities that as a whole are no farther need no
    /// lag, sign or scale, whatever else they are near to.
    pub(crate) fn agree(&self) -> bool {
        self.spare.value() >= 0.0
    }

    /// The multiple of the mean velocities, at some lag where they do not [`agree`](Self::agree), that the
    /// velocities come nearest to; `None` when nothing moved.
    pub(crate) fn fit(&self) -> Option<Fitted> {
        let squares = self.squares.value();
        let fits = self
            .products
            .iter()
            .take(if self.agree() { 1 } else { LAGS + 1 })
            .enumerate()
            .filter_map(|(delay, sums)| {
                let [mixed, own] = sums.each_ref().map(ExactSum::value);
                Fitted::nearest(delay, [squares, mixed, own])
            });
        fits.min_by(|a, b| a.residual.total_cmp(&b.residual))
    }

    /// The multiple over [`LONG`] samples; `None` of a shorter log, and when nothing moved.
    pub(crate) fn long_fit(&self) -> Option<Fitted> {
        Fitted::nearest(0, self.long.each_ref().map(ExactSum::value))
    }
}
