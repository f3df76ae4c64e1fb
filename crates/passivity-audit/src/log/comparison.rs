//! The forces of a trace against those of the wall's law: are they the law's, and if not, are they
//! late, of the other sign, or to another scale?
//!
//! The law's force is the kernel's controller, exactly; forces are measured and rounded, so the
//! comparison is one of doubles: a finding beside the exact account, which is of the force applied.

mod fit;
mod unlike;

use std::borrow::Cow;
use std::collections::VecDeque;
use std::ops::Range;

use multiversion::multiversion;
use passivity_core::{Controller, Wide};

use crate::ball::Ball;
use crate::ledger::Ledger;
use crate::log::chunk::Chunk;
use crate::log::error::TraceError;
use crate::log::exact::ExactSum;
use crate::log::lanes::commanded;
use crate::log::numbers::all;
use crate::log::running::near_reading;
use crate::log::step::undefined;
use crate::log::task::Task;
use crate::number::Written;
use crate::reading::Reading;
pub(crate) use unlike::Unlike;

/// The longest lag that is tried beyond the scene's, in samples.
pub(crate) const LAGS: usize = 8;

/// How far off a force may be, of its own size: single precision has 2⁻²⁴, and logs lose more.
const RELATIVE: f64 = 1e-6;

/// And in KΔ, when it is near zero.
const ABSOLUTE: f64 = 1e-9;

/// How many rows are compared at once.
const SOME: usize = 2048;

/// The forces of a trace compared with those of the law, at every lag.
#[derive(Clone, Debug)]
pub(crate) struct Comparison {
    /// The controller without delay.
    near: Controller<Ball>,
    wide: Controller<Wide>,
    /// The delay of the scene.
    pub(crate) delay: usize,
    /// As many samples as the force depends on beside its delay, the latest first.
    samples: VecDeque<Reading>,
    /// How many samples there were, as far as it matters.
    seen: usize,
    /// What the law gives without delay, the latest first; zero where that depends on samples before the log.
    law: Vec<f64>,
    /// What it was before the first force that is compared.
    before: Vec<f64>,
    /// Σ p² without lag.
    law_squares: ExactSum,
    pub(crate) compared: u64,
    /// How the forces agree, by lag.
    pub(crate) lags: Vec<Agreement>,
    /// The rows whose force is not that of the law at the scene's delay.
    pub(crate) unlike: Unlike,
    /// Σ f².
    pub(crate) squares: ExactSum,
    /// Σ of the squares of how far off the digits of each force may be.
    pub(crate) roundings: ExactSum,
}

/// How the forces agree with the law at a lag.
#[derive(Clone, Debug, Default)]
pub(crate) struct Agreement {
    /// As −f(q) and as +f(q): how often they do not, and where first.
    pub(crate) mismatches: [(u64, Option<u64>); 2],
    /// Σ f·p and Σ p², with p the force of the law; the latter once the comparison is [settled](Comparison::settle).
    pub(crate) products: [ExactSum; 2],
    /// Of the rows that are left out, as their law's force depends on samples before the log: how many, and Σ f², Σ f·p and
    /// Σ p², with p the force of the law at the scene's delay, as far as that does not.
    pub(crate) left_out: (u64, [ExactSum; 3]),
}

/// At which lag and sign the forces agree with the law, and how well.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Finding {
    pub(crate) mismatches: u64,
    pub(crate) first: Option<u64>,
    pub(crate) lag: usize,
    /// Whether the trace gives the wall's force with the other sign.
    pub(crate) reversed: bool,
}

fn prompt<S: Clone>(controller: &Controller<S>) -> Controller<S> {
    Controller {
        delay: 0,
        ..controller.clone()
    }
}

impl Comparison {
    pub(crate) fn new(ledger: &Ledger) -> Self {
        let delay = ledger.wide().controller.delay;
        Self {
            delay,
            near: prompt(&ledger.near().controller),
            wide: prompt(&ledger.wide().controller),
            samples: VecDeque::new(),
            seen: 0,
            law: Vec::new(),
            before: Vec::new(),
            law_squares: ExactSum::default(),
            compared: 0,
            lags: vec![Agreement::default(); delay + LAGS + 1],
            unlike: Unlike::default(),
            squares: ExactSum::default(),
            roundings: ExactSum::default(),
        }
    }

    /// The force that the law commands from this sample, the latest one, without delay; `None` when it is
    /// undefined.
    fn commanded(&mut self, sample: Reading) -> Option<f64> {
        let order = self.wide.filter.order();
        self.samples.truncate(order);
        // Most loops have no memory.
        let measured = |sample: &Reading| self.near.measured(sample.to_near().lo());
        let near = match order {
            0 => self.near.held_force(&[measured(&sample)]),
            _ => {
                let samples = std::iter::once(&sample).chain(&self.samples);
                self.near
                    .held_force(&samples.map(measured).collect::<Vec<_>>())
            }
        };
        self.samples.push_front(sample);
        if let Some(near) = near.near() {
            return Some(near);
        }
        let measured: Vec<Wide> = self
            .samples
            .iter()
            .map(|sample| self.wide.measured(sample.to_wide().lo()))
            .collect();
        Some(self.wide.held_force(&measured).below()?.near())
    }

    /// How many rows at the start of a chunk are compared by samples before it.
    fn lead(&self) -> usize {
        self.lags.len().max(self.wide.filter.order() + 1)
    }

    /// Compares the forces of a chunk that need no sample before it; `None` where there are none, or one of them is
    /// undefined.
    pub(crate) fn inside(task: &Task<'_>, chunk: &Chunk) -> Option<Self> {
        let mut inside = Self::new(task.ledger);
        let (lead, rows) = (inside.lead(), chunk.samples.len());
        if rows <= lead {
            return None;
        }
        let known = commanded(task.wall.as_ref(), chunk);
        inside.feed_known(chunk, 0..lead, &known).ok()?;
        inside.forget();
        // What is compared at every lag does not leave the nearest cache on the way.
        for from in (lead..rows).step_by(SOME) {
            let some = from..rows.min(from + SOME);
            inside.feed_known(chunk, some, &known).ok()?;
        }
        Some(inside)
    }

    /// Compares the forces of a chunk, given what was found [inside](Self::inside) of it.
    pub(crate) fn take(&mut self, chunk: &Chunk, inside: Self) -> Result<(), TraceError> {
        self.feed(chunk, self.lead())?;
        self.append(&inside);
        self.law_squares.add_sum(&inside.law_squares);
        (self.law, self.samples) = (inside.law, inside.samples);
        self.seen += inside.seen;
        Ok(())
    }

    /// Compares the forces of the first `rows` samples of a chunk.
    pub(crate) fn feed(&mut self, chunk: &Chunk, rows: usize) -> Result<(), TraceError> {
        self.feed_known(chunk, 0..rows, &[])
    }

    /// Compares the forces of some samples of a chunk, given those of the law from all of its samples as far as they are
    /// known near by.
    fn feed_known(
        &mut self,
        chunk: &Chunk,
        rows: Range<usize>,
        known: &[f64],
    ) -> Result<(), TraceError> {
        let end = rows.end.min(chunk.forces.values.len());
        let rows = rows.start.min(end)..end;
        // The latest last, and as many before the first as the longest lag looks back.
        let lags = self.lags.len();
        let mut forces_of_law = vec![f64::NAN; lags];
        match known.get(rows.clone()) {
            Some(known) => forces_of_law.extend_from_slice(known),
            None => forces_of_law.resize(lags + rows.len(), f64::NAN),
        }
        let (before, law) = forces_of_law.split_at_mut(lags);
        let order = self.wide.filter.order();
        // What is not known near by is computed one by one.
        if !all(law, |force| !force.is_nan()) {
            for (i, force) in rows.clone().zip(&mut *law) {
                if force.is_nan() {
                    let sample = chunk.samples.get(i).ok_or_else(undefined)?;
                    *force = self.commanded(sample).ok_or_else(undefined)?;
                }
            }
        }
        if law.is_empty() {
            return Ok(());
        }
        // What it was before the log is not in it.
        for force in law.iter_mut().take(order.saturating_sub(self.seen)) {
            *force = 0.0;
        }
        self.law.resize(lags, 0.0);
        if self.before.is_empty() {
            self.before.clone_from(&self.law);
        }
        for (before, law) in before.iter_mut().zip(self.law.iter().rev()) {
            *before = *law;
        }
        let near = &chunk.forces.values.near;
        let mut forces = Cow::Borrowed(near.middles.get(rows.clone()).ok_or_else(undefined)?);
        let radii = near.radii.get(rows.clone()).unwrap_or_default();
        if !all(radii, |radius| radius.is_finite()) {
            for (i, radius) in rows.clone().zip(radii) {
                if !radius.is_finite() {
                    let force = near_reading(&chunk.forces.get(i).ok_or_else(undefined)?);
                    let slot = forces.to_mut().get_mut(i - rows.start);
                    *slot.ok_or_else(undefined)? = force;
                }
            }
        }
        let rounding = chunk.forces.roundings.get(rows).unwrap_or_default();
        self.squares.add_products(&forces, &forces);
        let off = may_be_off(&forces, rounding);
        self.roundings.add_products(&off, &off);
        self.law_squares.add_products(law, law);
        let own = forces_of_law.get(lags - self.delay..).unwrap_or_default();
        for (lag, agreement) in self.lags.iter_mut().enumerate() {
            let known = (lag + order).saturating_sub(self.seen).min(forces.len());
            let (out, forces) = forces.split_at(known);
            agreement.left_out.0 += out.len() as u64;
            let own = own.get(..out.len()).unwrap_or_default();
            let products = [(out, out), (out, own), (own, own)];
            for (sum, (a, b)) in agreement.left_out.1.iter_mut().zip(products) {
                sum.add_products(a, b);
            }
            let late = forces_of_law.get(lags - lag + known..).unwrap_or_default();
            let rounding = rounding.get(known..).unwrap_or_default();
            agreement.compare(forces, late, rounding, self.compared + known as u64);
            if lag == self.delay {
                self.unlike.take(forces, late, rounding);
            }
        }
        self.seen += forces.len();
        self.law.clear();
        self.law
            .extend(forces_of_law.iter().rev().take(self.lags.len()));
        self.compared += forces.len() as u64;
        Ok(())
    }

    /// How many samples before one its force is compared by, at the most.
    pub(crate) fn history(ledger: &Ledger) -> usize {
        let controller = &ledger.wide().controller;
        controller.delay + LAGS + controller.filter.order() + 1
    }

    /// Forgets what was found, not what came before the next force.
    pub(crate) fn forget(&mut self) {
        self.compared = 0;
        self.squares = ExactSum::default();
        self.roundings = ExactSum::default();
        self.law_squares = ExactSum::default();
        self.before.clone_from(&self.law);
        self.lags.fill(Agreement::default());
        self.unlike = Unlike::default();
    }

    /// Sums up the squares of the law at every lag: those without it, and what came before them instead of as
    /// many at the end.
    pub(crate) fn settle(&mut self) {
        let mut sum = std::mem::take(&mut self.law_squares);
        let shifts = self.before.iter().zip(&self.law);
        for (lag, (before, last)) in self.lags.iter_mut().zip(shifts) {
            let [_, squares] = &mut lag.products;
            squares.add_sum(&sum);
            sum.add(before * before);
            sum.add(-(last * last));
        }
        self.before.clone_from(&self.law);
    }

    /// Goes on with what was found of the forces that follow.
    pub(crate) fn append(&mut self, other: &Self) {
        self.squares.add_sum(&other.squares);
        self.roundings.add_sum(&other.roundings);
        self.unlike.append(other.unlike);
        for (own, other) in self.lags.iter_mut().zip(&other.lags) {
            for (own, other) in own.products.iter_mut().zip(&other.products) {
                own.add_sum(other);
            }
            own.left_out.0 += other.left_out.0;
            for (own, other) in own.left_out.1.iter_mut().zip(&other.left_out.1) {
                own.add_sum(other);
            }
            for (own, other) in own.mismatches.iter_mut().zip(&other.mismatches) {
                let first = other.1.map(|row| self.compared + row);
                *own = (own.0 + other.0, own.1.or(first));
            }
        }
        self.compared += other.compared;
    }

    fn finding(&self, reversed: bool, lag: usize) -> Option<Finding> {
        let agreement = self.lags.get(lag)?;
        let (mismatches, first) = *agreement.mismatches.get(usize::from(reversed))?;
        Some(Finding {
            mismatches,
            first,
            lag,
            reversed,
        })
    }

    /// How many rows are left out at a lag.
    pub(crate) fn left_out(&self, lag: usize) -> u64 {
        self.lags.get(lag).map_or(0, |lag| lag.left_out.0)
    }

    /// How the forces agree with the law at the scene's delay.
    pub(crate) fn as_scene_says(&self) -> Option<Finding> {
        self.finding(false, self.delay)
    }

    /// The lag and sign at which they agree best: the scene's own, when nothing is better.
    pub(crate) fn best(&self) -> Option<Finding> {
        let lags = 0..self.lags.len();
        let all = [false, true].into_iter().flat_map(|reversed| {
            lags.clone()
                .filter_map(move |lag| self.finding(reversed, lag))
        });
        let own = self.as_scene_says()?;
        // A row that is left out beside those at the scene's delay is not one that agrees.
        let left_out = self.left_out(self.delay);
        let untold = |finding: &Finding| {
            finding.mismatches + self.left_out(finding.lag).saturating_sub(left_out)
        };
        let best = all.min_by_key(untold)?;
        Some(if untold(&best) < own.mismatches {
            best
        } else {
            own
        })
    }
}

impl Agreement {
    /// Compares forces with those of the law, after so many that were compared before.
    fn compare(&mut self, forces: &[f64], law: &[f64], rounding: &[f64], before: u64) {
        let rows = || forces.iter().zip(law).zip(rounding);
        let found = differing(forces, law, rounding);
        let signs = [1.0, -1.0].into_iter().zip(&mut self.mismatches);
        for ((sign, (mismatches, first)), found) in signs.zip(found) {
            if found > 0 && first.is_none() {
                *first = (before..)
                    .zip(rows())
                    .find(|(_, ((force, law), rounding))| {
                        differs(**force, sign * **law, **rounding)
                    })
                    .map(|(row, _)| row);
            }
            *mismatches += found;
        }
        let [mixed, _] = &mut self.products;
        mixed.add_products(forces, law);
    }
}

/// Whether a force that was rounded by so much is another than that of the law.
#[inline(always)]
fn differs(force: f64, law: f64, rounding: f64) -> bool {
    (force - law).abs() > rounding + RELATIVE * law.abs() + ABSOLUTE
}

/// How far forces that were rounded by so much are from those they were, at the most.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn may_be_off(forces: &[f64], rounding: &[f64]) -> Vec<f64> {
    let mut off = rounding.to_vec();
    for (off, force) in off.iter_mut().zip(forces) {
        *off = *off + RELATIVE * (force.abs() + *off) + ABSOLUTE;
    }
    off
}

/// How many forces differ from those of the law, and from these with the other sign.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn differing(forces: &[f64], law: &[f64], rounding: &[f64]) -> [u64; 2] {
    let mut found = [0_u64; 2];
    for ((force, law), rounding) in forces.iter().zip(law).zip(rounding) {
        // There are not as many rows as to overflow.
        found[0] = found[0].wrapping_add(u64::from(differs(*force, *law, *rounding)));
        found[1] = found[1].wrapping_add(u64::from(differs(*force, -*law, *rounding)));
    }
    found
}
