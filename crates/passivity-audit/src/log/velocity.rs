//! The velocities of a log against its positions: are they those of the motion, and if not, are they late,
//! of the other sign, or to another scale?
//!
//! Nothing exact rests on a velocity, so the comparison is one of doubles: a finding beside the account.

use std::collections::VecDeque;

use passivity_scene::display::significant;

use crate::log::chunk::Chunk;
use crate::log::error::TraceError;
use crate::log::exact::ExactSum;
use crate::log::findings::Finding;
use crate::log::layout::{Form, Layout};
use crate::log::report::{Fitted, Moved};
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

    /// How they agree with the positions.
    pub(crate) fn moved(&self) -> Moved {
        let [[_, own], ..] = &self.products;
        // Around one place positions are as far apart over many samples as over one.
        let moves = own.value() > 0.0 && (!self.agree() || self.goes_on_by(4.0));
        Moved {
            compared: self.compared,
            zero: moves && self.squares.value() == 0.0,
            fit: self.fit(),
            long_fit: self.long_fit(),
        }
    }

    /// Whether, in squares, more than so many times as much is moved over [`LONG`] samples as over one.
    fn goes_on_by(&self, times: f64) -> bool {
        let [_, _, long] = &self.long;
        let [[_, own], ..] = &self.products;
        long.value() > times * own.value()
    }

    /// Whether the velocities are those of the motion as far as its samples tell.
    ///
    /// A velocity that rises or falls all the time is at a sample between the mean velocities before and after
    /// it, and so no farther from the one than the other is. Velocities that as a whole are no farther need no
    /// lag, sign or scale, whatever else they are near to.
    fn agree(&self) -> bool {
        self.spare.value() >= 0.0
    }

    /// The multiple of the mean velocities, at some lag where they do not [`agree`](Self::agree), that the
    /// velocities come nearest to; `None` when nothing moved.
    fn fit(&self) -> Option<Fitted> {
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

    /// The multiple over [`LONG`] samples; `None` of logs that are too short, or in which too little moved, for that to tell.
    fn long_fit(&self) -> Option<Fitted> {
        let [squares, mixed, own] = self.long.each_ref().map(ExactSum::value);
        #[expect(clippy::cast_precision_loss, reason = "there are not so many rows")]
        let rows = self.compared as f64;
        // Where they are less than a tick long, on average, the ticks at their ends are all that is seen.
        let is_enough = rows >= MANY * LONG as f64 && own >= rows;
        Fitted::nearest(0, [squares, mixed, own]).filter(|_| is_enough)
    }

    /// What stands out in the velocities of a log, which agree with the positions like this.
    pub(crate) fn finding(&self, moved: &Moved, form: Form) -> Option<Finding> {
        if moved.zero {
            return Some(Finding {
                kind: "zero_velocity",
                says: "the velocity is zero throughout, while the positions move: is it the right column, or was it rounded to zero?".to_owned(),
                fix: "check that the column is the velocity that was measured; `--columns` names another".to_owned(),
            });
        }
        let Some(told) = moved.told() else {
            let fit = moved.fit.filter(|_| !self.agree())?;
            return Some(Finding {
                kind: "velocity",
                says: format!(
                    "the velocity is not that of the positions: {} % of it is left beside the nearest multiple",
                    significant(100.0 * fit.residual)
                ),
                fix: "check which columns are the position and the velocity".to_owned(),
            });
        };
        if !is_off(&told) {
            return None;
        }
        let Fitted { delay, scale, .. } = told;
        let late = match delay {
            0 => String::new(),
            1 => ", 1 sample late".to_owned(),
            delay => format!(", {delay} samples late"),
        };
        let ticks = match form {
            Form::Count | Form::Xi => {
                ", and the counts per revolution, or the resolution, of its encoder"
            }
            Form::X | Form::Ledger => "",
        };
        // A filter takes as much off a vibration, and so do the rows themselves. Of a swing that is over many samples eight
        // times as far as over one there are less than thirty in a thousand.
        let is_vibration = (0.0..1.0).contains(&scale) && !self.goes_on_by(64.0);
        let (kind, or_else) = match is_vibration {
            true => ("velocity", ", or the device vibrates too fast for its rows"),
            false => ("velocity_scale", ""),
        };
        Some(Finding {
            kind,
            says: format!(
                "the velocity is {} times that of the positions{late}{or_else}",
                significant(scale)
            ),
            fix: format!(
                "check the units and signs of the position, the time and the velocity, and the sampling rate of the \
                 scene{ticks}"
            ),
        })
    }
}

/// Of less than so many times [`LONG`] rows few stretches are apart.
const MANY: f64 = 4.0;

/// Velocities from an encoder are noisy: a tenth of their size is usual, and a filter delays them.
const NOISY: f64 = 0.5;

/// Of what they are compared with at most a quarter is noise then, in squares, by which a scale of one is found as 3/4.
const OFF: f64 = 1.5;

fn is_told(fit: &Fitted) -> bool {
    fit.residual <= NOISY
}

/// Whether a multiple is so far from one that a unit, a sign or another number of the scene is wrong.
pub(crate) fn is_off(fit: &Fitted) -> bool {
    !(1.0 / OFF..=OFF).contains(&fit.scale)
}

impl Moved {
    /// The multiple that the velocities are: over a few rows or over many, whichever leaves less of them.
    fn told(&self) -> Option<Fitted> {
        let fits = [self.fit, self.long_fit].into_iter().flatten();
        fits.filter(is_told)
            .min_by(|a, b| a.residual.total_cmp(&b.residual))
    }

    /// What is said of the velocities where nothing stands out.
    pub(crate) fn to_text(&self) -> String {
        let compared = self.compared;
        if compared == 0 {
            "is not compared with the positions, of which there are too few".to_owned()
        } else if self.fit.is_none() {
            "is not compared with the positions, which stay where they are".to_owned()
        } else if self.told().is_some() {
            format!("agrees with the positions, compared in {compared} rows")
        } else {
            format!(
                "is not told from that of the positions in {compared} rows, whose steps are too coarse or too few"
            )
        }
    }
}
