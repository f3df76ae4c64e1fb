//! The velocities of a log against its positions: are they those of the motion, and if not, are they late,
//! of the other sign, or to another scale?
//!
//! Nothing exact rests on a velocity, so the comparison is one of doubles: a finding beside the account.

use std::collections::VecDeque;

use crate::log::chunk::Chunk;
use crate::log::error::TraceError;
use crate::log::layout::Layout;
use crate::log::report::Fitted;
use crate::log::running::{near_number, near_reading};
use crate::log::step::undefined;
use crate::number::{Number, difference};

/// The longest lag that is tried, in samples.
const LAGS: usize = 8;

/// The velocities of a log compared with the mean velocities between its samples.
#[derive(Clone, Debug, Default)]
pub(crate) struct Velocities {
    /// The latest sample, in ticks, and its time.
    latest: Option<(f64, Option<Number>)>,
    /// Mean velocities, the latest first, in ticks per period.
    means: VecDeque<f64>,
    pub(crate) compared: u64,
    /// By lag, Σ v·w and Σ w², with w the mean velocity.
    products: [[f64; 2]; LAGS + 1],
    /// Σ v².
    squares: f64,
}

impl Velocities {
    /// Compares the velocities of a chunk, whose first interval lasts as long as its times say.
    pub(crate) fn feed(&mut self, layout: &Layout, chunk: &Chunk) -> Result<(), TraceError> {
        for (i, velocity) in chunk.velocities.iter().enumerate() {
            let sample = chunk.samples.get(i).ok_or_else(undefined)?;
            let position = near_reading(&sample);
            let time = chunk.times.get(i).cloned();
            let before = self.latest.replace((position, time.clone()));
            let Some((from, since)) = before else {
                continue;
            };
            let lasts = match since.zip(time) {
                Some((since, time)) => {
                    let periods = layout.duration(&since, &time);
                    near_number(&periods.unwrap_or_else(|| difference(&time, &since)))
                }
                None => 1.0,
            };
            self.means.push_front((position - from) / lasts);
            self.means.truncate(LAGS + 1);
            if self.means.len() <= LAGS {
                continue;
            }
            for (mean, [mixed, own]) in self.means.iter().zip(&mut self.products) {
                *mixed += velocity * mean;
                *own += mean * mean;
            }
            self.squares += velocity * velocity;
            self.compared += 1;
        }
        Ok(())
    }

    /// The multiple of the mean velocities, at some lag, that the velocities come nearest to; `None` when
    /// nothing moved.
    pub(crate) fn fit(&self) -> Option<Fitted> {
        let fits = self
            .products
            .iter()
            .enumerate()
            .filter_map(|(delay, [mixed, own])| {
                let scale = mixed / own;
                // What is left of Σ v²; rounding may leave it a little below zero.
                let left = (self.squares - scale * mixed).max(0.0);
                let residual = (left / self.squares).sqrt();
                (scale.is_finite() && residual.is_finite()).then_some(Fitted {
                    delay,
                    scale,
                    residual,
                })
            });
        fits.min_by(|a, b| a.residual.total_cmp(&b.residual))
    }
}
