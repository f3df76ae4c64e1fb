//! The commanded force of a trace against the wall's law: is it the law's, and how late?
//!
//! Forces are measured and rounded, so this is a comparison in doubles, a diagnosis beside the
//! exact ledger.

use std::collections::VecDeque;

use passivity_core::BigRational;

use crate::audit::chunk::Chunk;
use crate::audit::course::near;
use crate::ledger::{Ledger, Sample};

/// The longest lag that is tried beyond the scene's, in samples.
const LAGS: usize = 8;

/// How far off a force may be, of its own size: single precision has 2⁻²⁴, and logs lose more.
const RELATIVE: f64 = 1e-6;

/// And in KΔ, when it is near zero.
const ABSOLUTE: f64 = 1e-9;

/// Forces compared with those of the law, at every lag and of either sign.
#[derive(Clone, Debug)]
pub(crate) struct ForceCheck {
    encoder: bool,
    damping: f64,
    step: Option<f64>,
    limit: Option<f64>,
    unilateral: bool,
    /// The delay of the scene.
    pub(crate) delay: usize,
    /// What the law gives without delay, the latest first.
    law: VecDeque<f64>,
    before: Option<f64>,
    pub(crate) compared: u64,
    /// Mismatches as −f(q) and as +f(q), by lag, and the first of each.
    tallies: [Vec<(u64, Option<u64>)>; 2],
    /// Σ f·Δξ with the trace's own forces.
    pub(crate) observed: f64,
    at: Option<(f64, f64)>,
}

/// What the comparison says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Finding {
    pub(crate) mismatches: u64,
    pub(crate) first: Option<u64>,
    pub(crate) lag: usize,
    /// Whether the trace gives the wall's force with the other sign.
    pub(crate) reversed: bool,
}

impl ForceCheck {
    pub(crate) fn new(ledger: &Ledger) -> Self {
        let model = ledger.model();
        let optional = |x: &Option<BigRational>| x.as_ref().map(near);
        let delay = usize::from(model.effects.delay);
        Self {
            encoder: model.effects.encoder,
            damping: optional(&model.effects.damping).unwrap_or(0.0),
            step: optional(&model.effects.force_step),
            limit: optional(&model.max_force),
            unilateral: model.unilateral,
            delay,
            law: VecDeque::new(),
            before: None,
            compared: 0,
            tallies: [
                vec![(0, None); delay + LAGS + 1],
                vec![(0, None); delay + LAGS + 1],
            ],
            observed: 0.0,
            at: None,
        }
    }

    /// The force that the law commands from a sample, without delay.
    fn commanded(&mut self, sample: &Sample) -> (f64, f64) {
        let cell = match sample {
            Sample::Exact(xi) => {
                let xi = xi.to_rational();
                if self.encoder {
                    (near(&xi.floor()) + 0.5, near(&xi))
                } else {
                    (near(&xi), near(&xi))
                }
            }
            #[allow(clippy::cast_precision_loss)]
            Sample::Count(n) => (*n as f64 + 0.5, *n as f64),
            Sample::Within(ends) => (near(&ends.0.floor()) + 0.5, near(&ends.0)),
        };
        let (q, position) = cell;
        let mut force = q + self.damping * (q - self.before.unwrap_or(q));
        self.before = Some(q);
        if self.unilateral && q < 0.0 {
            force = 0.0;
        }
        let mut held = -force;
        if let Some(step) = self.step {
            held = (held / step + 0.5).floor() * step;
        }
        if let Some(limit) = self.limit {
            held = held.clamp(-limit, limit);
        }
        (held, position)
    }

    /// Compares the forces of a chunk.
    pub(crate) fn feed(&mut self, chunk: &Chunk) {
        for (i, [force, rounding]) in chunk.forces.iter().enumerate() {
            let Some(sample) = chunk.samples.get(i) else {
                return;
            };
            let (law, position) = self.commanded(&sample);
            // Before the first sample the device stood where it finds it.
            while self.law.len() < self.delay + LAGS {
                self.law.push_back(law);
            }
            self.law.push_front(law);
            self.law.truncate(self.delay + LAGS + 1);
            if let Some((held, from)) = self.at {
                self.observed -= held * (position - from);
            }
            self.at = Some((*force, position));
            for (sign, tally) in [1.0, -1.0].into_iter().zip(&mut self.tallies) {
                for (expected, (mismatches, first)) in self.law.iter().zip(tally) {
                    let off = (force - sign * expected).abs();
                    if off > rounding + RELATIVE * expected.abs() + ABSOLUTE {
                        *mismatches += 1;
                        first.get_or_insert(self.compared);
                    }
                }
            }
            self.compared += 1;
        }
    }

    fn finding(&self, reversed: bool, lag: usize) -> Option<Finding> {
        let (mismatches, first) = *self.tallies.get(usize::from(reversed))?.get(lag)?;
        Some(Finding {
            mismatches,
            first,
            lag,
            reversed,
        })
    }

    /// How the forces agree with the law at the scene's delay.
    pub(crate) fn as_scene_says(&self) -> Option<Finding> {
        self.finding(false, self.delay)
    }

    /// The lag and sign at which they agree best: the scene's own, when nothing is better.
    pub(crate) fn best(&self) -> Option<Finding> {
        let lags = 0..=self.delay + LAGS;
        let all = [false, true].into_iter().flat_map(|reversed| {
            lags.clone()
                .filter_map(move |lag| self.finding(reversed, lag))
        });
        let own = self.as_scene_says()?;
        let best = all.min_by_key(|finding| finding.mismatches)?;
        Some(if best.mismatches < own.mismatches {
            best
        } else {
            own
        })
    }
}
