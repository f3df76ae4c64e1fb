//! What the ledger needs to know of a loop: its friction, the effects in it and the wall's law.

use passivity_core::effects::{Effects, rounded_force};
use passivity_core::{BigRational, Criterion, Fixed, Friction, Law, Rig, Scalar, Wide, rational};

use crate::cell::Cell;

/// A loop in dimensionless form, with friction that may lie in a box of tolerances.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction};
/// use passivity_oracle::Model;
///
/// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
/// assert!(Model::plain(friction).is_plain());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Model<S> {
    /// β and σ at the least that the tolerances allow.
    pub least: Friction<S>,
    /// β and σ at the most that they allow.
    pub most: Friction<S>,
    /// Encoder, delay, damping, force step.
    pub effects: Effects<S>,
    /// Whether the wall is ξ ≥ 0 only (TH-UNI).
    pub unilateral: bool,
    /// The largest force, in KΔ.
    pub max_force: Option<S>,
    /// Whether `least` and `most` are the same.
    pub exact: bool,
}

impl<S: Scalar> Model<S> {
    /// The loop of the paper with an exact friction: an encoder and a wall on both sides.
    #[must_use]
    pub fn plain(friction: Friction<S>) -> Self {
        Self {
            least: friction.clone(),
            most: friction,
            effects: Effects::encoder(),
            unilateral: false,
            max_force: None,
            exact: true,
        }
    }

    /// Whether friction is known exactly: figures are numbers then, not enclosures.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        self.exact
    }

    /// Whether an encoder, at most, is all there is beside the hold, so that a row depends on
    /// nothing but its own two positions and their difference in ticks.
    #[must_use]
    pub const fn is_plain(&self) -> bool {
        self.effects.encoder && self.effects.is_plain() && !self.is_clamped()
    }

    /// Whether the wall's law is not the linear spring everywhere.
    #[must_use]
    pub const fn is_clamped(&self) -> bool {
        self.unilateral || self.max_force.is_some()
    }

    /// The wall's force law, nowhere stiffer than the wall (TH-LAW).
    #[must_use]
    pub fn law(&self) -> Law<S> {
        let law = if self.unilateral {
            Law::unilateral()
        } else {
            Law::bilateral()
        };
        match &self.max_force {
            Some(limit) => law.saturated(limit.clone()),
            None => law,
        }
    }

    /// How many samples before the one at the start of an interval its force depends on.
    #[must_use]
    pub fn memory(&self) -> usize {
        usize::from(self.effects.delay) + usize::from(self.effects.damping.is_some())
    }

    /// The criterion with the terms of the effects, at the least and at the most friction.
    #[must_use]
    pub fn criteria(&self) -> (Criterion<S>, Criterion<S>) {
        let of = |friction: &Friction<S>| {
            Rig::dimensionless(friction.clone(), self.effects.clone()).criterion()
        };
        (of(&self.least), of(&self.most))
    }

    /// The force held over an interval, in KΔ, from the samples up to its start, the latest first.
    ///
    /// With k samples of delay the force of the sample q, k earlier, is −(q + B(q − q′)) (5),
    /// (TH-DELAY), (TH-DAMP); nothing when q is outside a wall on one side (TH-UNI); then rounded
    /// to force steps (TH-DAC) and limited by the actuator (TH-LAW), in this order. Before the
    /// first sample the device is taken to have stood where the first sample finds it.
    #[must_use]
    pub fn held_force(&self, samples: &[Cell<S>]) -> S {
        let at = |k: usize| {
            let cell = samples.get(k).or(samples.last());
            cell.map_or_else(S::zero, |cell| cell.measured(self.effects.encoder))
        };
        let late = usize::from(self.effects.delay);
        let q = at(late);
        let mut force = q.clone();
        if let Some(damping) = &self.effects.damping {
            force = force + damping.clone() * (q.clone() - at(late + 1));
        }
        if self.unilateral {
            // 1 inside the wall and 0 outside it, without a branch on the sign.
            let inside = (q.floor() + S::one()).max(S::zero()).min(S::one());
            force = force * inside;
        }
        let mut held = -force;
        if let Some(step) = &self.effects.force_step {
            held = rounded_force(&held, step);
        }
        if let Some(limit) = &self.max_force {
            held = held.min(limit.clone()).max(-limit.clone());
        }
        held
    }

    /// The same loop with every number taken through `f`; `None` when `f` gives up on one.
    pub fn try_map<U: Scalar>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Model<U>> {
        let optional = |x: &Option<S>| match x {
            Some(x) => f(x).map(Some),
            None => Some(None),
        };
        let friction = |x: &Friction<S>| Some(Friction::new(f(&x.beta)?, f(&x.sigma)?));
        Some(Model {
            least: friction(&self.least)?,
            most: friction(&self.most)?,
            effects: Effects {
                encoder: self.effects.encoder,
                delay: self.effects.delay,
                damping: optional(&self.effects.damping)?,
                force_step: optional(&self.effects.force_step)?,
            },
            unilateral: self.unilateral,
            max_force: optional(&self.max_force)?,
            exact: self.exact,
        })
    }
}

impl Model<BigRational> {
    /// The loop over checked 128-bit fractions, when its numbers fit.
    #[must_use]
    pub fn to_fixed(&self) -> Option<Model<Fixed>> {
        self.try_map(rational::to_fixed)
    }

    /// The loop over big integers.
    #[must_use]
    pub fn to_wide(&self) -> Option<Model<Wide>> {
        self.try_map(|x| Some(rational::to_wide(x)))
    }
}
