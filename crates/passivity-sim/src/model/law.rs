//! The controller: what it makes of a sample, and its energy against either spring.

use std::cmp::Ordering;

use super::Memory;
use crate::real::{Real, Undecided};

/// The controller.
#[derive(Clone, Debug)]
pub(super) struct Law<R> {
    pub(super) encoder: bool,
    pub(super) delay: usize,
    pub(super) unilateral: bool,
    pub(super) damping: Option<R>,
    /// Numerator and denominator of δ: whole numbers, so that a force half-way between two steps is
    /// seen as such by every kind of number.
    pub(super) step: Option<[R; 2]>,
    pub(super) limit: Option<R>,
}

impl<R: Real> Law<R> {
    pub(super) fn forgets_after(&self) -> u64 {
        self.delay as u64 + u64::from(self.damping.is_some())
    }

    pub(super) fn sample(&self, xi: &R) -> Result<R, Undecided> {
        if self.encoder {
            Ok(xi.floor()? + xi.ratio(1, 2))
        } else {
            Ok(xi.clone())
        }
    }

    /// The law without its history: a sample's force, before it is negated.
    fn clamped(&self, q: &R) -> Result<R, Undecided> {
        let mut force = q.clone();
        if self.unilateral && force.sign()? == Ordering::Less {
            force = force.zero();
        }
        match &self.limit {
            Some(limit) => clamp(&force, limit),
            None => Ok(force),
        }
    }

    pub(super) fn held(&self, xi: &R, memory: &mut Memory<R>) -> Result<R, Undecided> {
        memory.push_front(self.sample(xi)?);
        let late = |index: usize| memory.get(index).cloned().unwrap_or_else(|| xi.zero());
        let q = late(self.delay);
        let mut force = q.clone();
        if let Some(damping) = &self.damping {
            force = force + damping.clone() * (q.clone() - late(self.delay + 1));
        }
        memory.truncate(self.delay + usize::from(self.damping.is_some()));
        if self.unilateral && q.sign()? == Ordering::Less {
            force = q.zero();
        }
        let mut held = -force;
        if let Some([numerator, denominator]) = &self.step {
            let steps = held * denominator.clone() / numerator.clone() + q.ratio(1, 2);
            held = steps.floor()? * numerator.clone() / denominator.clone();
        }
        match &self.limit {
            Some(limit) => clamp(&held, limit),
            None => Ok(held),
        }
    }

    /// The change of the linear and of the quantized counterpart's potential.
    pub(super) fn potentials(&self, from: &R, to: &R) -> Result<[R; 2], Undecided> {
        let half = from.ratio(1, 2);
        let free = !self.unilateral && self.limit.is_none();
        let linear = if free {
            let d = to.clone() - from.clone();
            d.clone() * (from.clone() + d * half)
        } else {
            let potential = |xi: &R| -> Result<R, Undecided> {
                let y = self.clamped(xi)?;
                Ok(y.clone() * (xi.clone() - y * xi.ratio(1, 2)))
            };
            potential(to)? - potential(from)?
        };
        if !self.encoder {
            return Ok([linear.clone(), linear]);
        }
        let quantized = self.steps(to)? - self.steps(from)?;
        Ok([linear, quantized])
    }

    /// ∫f(⌊x⌋ + ½)dx from 0 to ξ.
    fn steps(&self, xi: &R) -> Result<R, Undecided> {
        let half = xi.ratio(1, 2);
        let n = xi.floor()?;
        let rest = xi.clone() - n.clone();
        let free = !self.unilateral && self.limit.is_none();
        if free {
            // ½n² + (n + ½)ρ.
            let whole = n.clone() * n.clone() * half.clone();
            return Ok(whole + (n + half) * rest);
        }
        let below = n.sign()? == Ordering::Less;
        if below && self.unilateral {
            return Ok(xi.zero());
        }
        // Ticks from 0 to n whose middle is within the limit make ½k², the others the limit each.
        let size = n.magnitude()?;
        let whole = match &self.limit {
            None => size.clone() * size.clone() * half.clone(),
            Some(limit) => {
                let within = -((half.clone() - limit.clone()).floor()?);
                let within = if within.sign()? == Ordering::Less {
                    xi.zero()
                } else {
                    within
                };
                let beyond = size.clone() - within.clone();
                if beyond.sign()? == Ordering::Greater {
                    within.clone() * within * half.clone() + beyond * limit.clone()
                } else {
                    size.clone() * size * half.clone()
                }
            }
        };
        Ok(whole + self.clamped(&(n + half))? * rest)
    }
}

fn clamp<R: Real>(x: &R, limit: &R) -> Result<R, Undecided> {
    Ok(match x.magnitude()?.compare(limit)? {
        Ordering::Greater if x.sign()? == Ordering::Less => -limit.clone(),
        Ordering::Greater => limit.clone(),
        _ => x.clone(),
    })
}
