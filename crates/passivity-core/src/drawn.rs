//! A motion that draws energy from a loop of any linear controller, delay, latency and lag: the
//! converse of TH-LTI, TH-LATENCY and TH-LAG, its gain computed from the held force and friction.
//!
//! The device moves at constant speed within each interval, so what an actuator does with a command
//! counts only by its mean over the interval: a response κ₀, κ₁, … of its own, with sum 1 and the
//! mean delay Σ jκⱼ = m. A longer delay moves part of the response to later terms; for a command
//! that changes by at most M a sample the mean force then changes by at most M·dm.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::absolute_sum::Terms;
use crate::controller::rounded;
use crate::dissipation::Friction;
use crate::edge_cycle::{EdgeCycle, MOST_TAPS};
use crate::frequency::ViscousCost;
use crate::interval::Interval;
use crate::linear_part::{LinearPart, MOST_DEGREE};
use crate::periodic::{Motion, steps};
use crate::quantizer::Quantized;
use crate::scalar::{Ordered as _, Scalar};
use crate::smoothed::{Smoothed, unit};
use crate::transfer::TransferFunction;
use crate::wave::{Wave, harmonic};
use crate::whole::{fraction, over_common};

/// A loop in which such a motion is looked for; dimensionless.
#[derive(Clone, Debug)]
pub struct Search<'a> {
    /// Controller, delay and actuator, over all tolerances.
    pub part: &'a LinearPart,
    /// The most friction that the tolerances allow.
    pub friction: &'a Friction<BigRational>,
    /// Whether the position is measured through an encoder.
    pub encoder: bool,
    /// δ, the largest step of the D/A converter.
    pub force_step: Option<&'a Interval<BigRational>>,
    /// The least that the largest force of the actuator may be.
    pub max_force: Option<&'a BigRational>,
    /// The slowest that the bound on the speed may be, in ticks per sample.
    pub speed_bound: Option<&'a BigRational>,
}

/// A motion that draws energy each time round.
#[derive(Clone, Debug, PartialEq)]
pub enum Drawn {
    /// Position by position.
    Motion(Motion<BigRational>),
    /// As a formula: its period may be too long to write down.
    Wave(Wave),
}

/// A law in the form H(1)q + Σ gⱼ(qⱼ − qⱼ₋₁).
struct Response {
    /// H(1).
    sum: BigRational,
    /// g₀ = 0, g₁, ….
    tails: Terms,
    /// What Σ|gⱼ| may be off by, over the tolerances and by rounding.
    error: BigRational,
}

impl Response {
    /// The forces commanded from each sample on, when the measured positions have repeated for ever.
    fn commands(&self, measured: &[BigRational]) -> Vec<BigRational> {
        let period = measured.len();
        // The tails of the same place in the period act together.
        let mut folded: Vec<BigInt> = Vec::new();
        folded.resize(period, BigInt::ZERO);
        for (j, tail) in self.tails.terms.iter().enumerate() {
            if let Some(slot) = folded.get_mut(j % period.max(1)) {
                *slot += tail;
            }
        }
        // The fall of each sample from the one before: of sample h it stands at h − 1.
        let (whole, common) = over_common(measured);
        let falls: Vec<BigInt> = steps(&whole).map(|(q, next)| q - next).collect();
        let [sum, unit] = [&self.sum, &self.tails.unit];
        let [of_sum, of_tails] = [sum.numer() * unit.denom(), unit.numer() * sum.denom()];
        let common = common * sum.denom() * unit.denom();
        let at = |(h, q): (usize, &BigInt)| {
            // gⱼ goes with the fall from the sample j − 1 before to the one j before.
            let before = falls.iter().rev().cycle().skip(period - 1 - h);
            let terms = folded.iter().zip(before);
            let remembered = terms
                .filter(|(_, fall)| **fall != BigInt::ZERO)
                .fold(BigInt::ZERO, |sum, (tail, fall)| sum + fall * tail);
            fraction(-(&of_sum * q + &of_tails * remembered), common.clone())
        };
        whole.iter().enumerate().map(at).collect()
    }
}

impl Search<'_> {
    /// A motion that draws energy whatever the parameters within their tolerances; `None` where none
    /// is found.
    ///
    /// Across one edge where σ < s*, and one of a single frequency where β < λ(θ); see
    /// [`EdgeCycle`], [`harmonic`] and [`Wave`].
    #[must_use]
    pub fn find(&self) -> Option<Drawn> {
        let (law, wobble) = self.part.middle()?;
        let smoothed = match &self.part.actuator {
            Some(actuator) => Some(Smoothed::of(actuator)?),
            None => None,
        };
        let whole = match &smoothed {
            Some(smoothed) => product(&law, &smoothed.transfer)?,
            None => law.clone(),
        };
        let tails = Terms::of(&law.tails(), &unit())?;
        let response = Response {
            sum: law.at_one(),
            error: &tails.error + &wobble,
            tails,
        };
        let held =
            |positions: &[BigRational]| self.mean_forces(&response, smoothed.as_ref(), positions);
        let late = whole.clone().delayed(self.part.delay);
        if self.encoder {
            let taps = late.impulse_response(MOST_TAPS);
            let last = taps.iter().rposition(|c| *c != BigRational::zero())?;
            let best = EdgeCycle::of(taps.get(..=last)?);
            let found = best.and_then(|best| best.motion(held, self.friction, self.speed_bound));
            if let Some(found) = found {
                return Some(Drawn::Motion(found));
            }
        }
        let length = late.numerator().len().max(late.denominator().len());
        if length > MOST_DEGREE {
            return None;
        }
        let cost = ViscousCost::of(&late);
        if let Some(found) = harmonic(&cost, held, self.friction, self.speed_bound) {
            return Some(Drawn::Motion(found));
        }
        // A formula is of a force that is linear and known exactly.
        let exact = wobble == BigRational::zero()
            && smoothed.is_none_or(|smoothed| smoothed.error == BigRational::zero());
        if !exact || self.max_force.is_some() || self.speed_bound.is_some() {
            return None;
        }
        let rounding = match self.force_step {
            Some(step) => step.hi().clone().half(),
            None => BigRational::zero(),
        };
        let sigma = &self.friction.sigma + rounding;
        Wave::of(&late, &Friction::new(self.friction.beta.clone(), sigma)).map(Drawn::Wave)
    }

    /// The mean force over each interval of a period, lowered against the motion by what it may be
    /// off over the tolerances; `None` where the actuator cannot give it.
    fn mean_forces(
        &self,
        response: &Response,
        smoothed: Option<&Smoothed>,
        positions: &[BigRational],
    ) -> Option<Vec<BigRational>> {
        let measured: Vec<BigRational> = positions.iter().map(|xi| self.measured(xi)).collect();
        let mut forces = response.commands(&measured);
        let mut error = &response.error * largest_change(&measured);
        if let Some(step) = self.force_step {
            if step.is_point() && error == BigRational::zero() {
                let one = BigRational::one();
                forces = forces.iter().map(|u| rounded(u, step.lo(), &one)).collect();
            } else {
                error += step.hi().clone().half();
            }
        }
        if let Some(most) = self.max_force {
            for force in &forces {
                if (Scalar::abs(force) + &error).compare(most)? == Ordering::Greater {
                    return None;
                }
            }
        }
        if let Some(smoothed) = smoothed {
            // The command may change by so much more than it seems to.
            error += &smoothed.error * (largest_change(&forces) + error.clone().double());
            forces = filtered(&smoothed.response, &forces);
        }
        let late = usize::from(self.part.delay) % positions.len().max(1);
        forces.rotate_right(late);
        let moved = forces.into_iter().zip(steps(positions));
        let lowered = moved.map(|(force, (from, to))| match to.compare(from) {
            Some(Ordering::Greater) => force - &error,
            Some(Ordering::Less) => force + &error,
            _ => force,
        });
        Some(lowered.collect())
    }

    fn measured(&self, xi: &BigRational) -> BigRational {
        if self.encoder {
            Quantized::of(xi).measured()
        } else {
            xi.clone()
        }
    }
}

/// A response that ends, applied to a period of commands.
fn filtered(response: &[BigRational], commands: &[BigRational]) -> Vec<BigRational> {
    let [(response, of_response), (commands, of_commands)] = [response, commands].map(over_common);
    let common = of_response * of_commands;
    let at = |later: usize| {
        let before = commands.iter().rev().cycle().skip(later);
        let terms = response.iter().zip(before);
        let sum = terms.fold(BigInt::ZERO, |sum, (k, u)| sum + k * u);
        fraction(sum, common.clone())
    };
    (0..commands.len()).rev().map(at).collect()
}

/// The largest change from one to the next round a period.
fn largest_change(values: &[BigRational]) -> BigRational {
    let changes = steps(values).map(|(from, to)| Scalar::abs(&(to - from)));
    changes.fold(BigRational::zero(), Scalar::max)
}

/// One controller after the other.
fn product(
    first: &TransferFunction<BigRational>,
    second: &TransferFunction<BigRational>,
) -> Option<TransferFunction<BigRational>> {
    let convolved = |a: &[BigRational], b: &[BigRational]| {
        let [(a, of_a), (b, of_b)] = [a, b].map(over_common);
        let common = of_a * of_b;
        let mut out: Vec<BigInt> = Vec::new();
        out.resize((a.len() + b.len()).saturating_sub(1), BigInt::ZERO);
        for (i, x) in a.iter().enumerate() {
            for (slot, y) in out.iter_mut().skip(i).zip(&b) {
                *slot += x * y;
            }
        }
        let fractions = out.into_iter().map(|c| fraction(c, common.clone()));
        fractions.collect::<Vec<_>>()
    };
    TransferFunction::new(
        convolved(first.numerator(), second.numerator()),
        convolved(first.denominator(), second.denominator()),
    )
    .ok()
}
