//! A device, its control loop and a wall: the parameters of (1), (2), in whatever units.

use crate::criterion::Criterion;
use crate::dissipation::Friction;
use crate::effects::{Effects, delay_number};
use crate::scalar::Scalar;

/// What the criterion needs to know of a device and the wall it renders.
///
/// Units are the caller's, as long as they agree: b in force·time/length, c in force, K in
/// force/length, T in time, Δ in length. Inertia is not here: a mass neither generates nor
/// dissipates energy.
///
/// # Example
///
/// The paper's Maxon RE35 at K = 1 N·m/rad with Δ = 0.001 rad.
///
/// ```
/// use passivity_core::{effects::Effects, Fixed, Rig, Scalar};
///
/// let rig = Rig {
///     viscous: Fixed::new(9, 1_000_000),
///     coulomb: Fixed::new(2, 1000),
///     stiffness: Fixed::integer(1),
///     period: Fixed::new(1, 1000),
///     length: Fixed::new(1, 1000),
///     effects: Effects::encoder(),
/// };
/// assert_eq!(rig.friction().beta, Fixed::new(9, 1000));
/// assert_eq!(rig.friction().sigma, Fixed::integer(2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rig<S> {
    /// b ≥ 0, viscous friction.
    pub viscous: S,
    /// c ≥ 0, Coulomb friction.
    pub coulomb: S,
    /// K > 0, stiffness of the wall.
    pub stiffness: S,
    /// T > 0, sampling period.
    pub period: S,
    /// Δ > 0, encoder resolution; without an encoder any length, which then serves as the unit.
    pub length: S,
    /// The effects of the loop; `damping` in the units of b, `force_step` in the units of c.
    pub effects: Effects<S>,
}

impl<S: Scalar> Rig<S> {
    /// The rig in which K, T and Δ are the units: b is β, c is σ (7).
    #[must_use]
    pub fn dimensionless(friction: Friction<S>, effects: Effects<S>) -> Self {
        Self {
            viscous: friction.beta,
            coulomb: friction.sigma,
            stiffness: S::one(),
            period: S::one(),
            length: S::one(),
            effects,
        }
    }

    /// KT, the unit of viscous friction.
    #[must_use]
    pub fn viscous_unit(&self) -> S {
        self.stiffness.clone() * self.period.clone()
    }

    /// KΔ, the unit of force.
    #[must_use]
    pub fn force_unit(&self) -> S {
        self.stiffness.clone() * self.length.clone()
    }

    /// The effective friction coefficients β = b/(KT), σ = c/(KΔ) (7).
    #[must_use]
    pub fn friction(&self) -> Friction<S> {
        Friction {
            beta: self.viscous.clone().over(self.viscous_unit()),
            sigma: self.coulomb.clone().over(self.force_unit()),
        }
    }

    /// μ = m/(KT²) for an inertia m (7).
    #[must_use]
    pub fn mu(&self, inertia: &S) -> S {
        inertia
            .clone()
            .over(self.viscous_unit() * self.period.clone())
    }

    /// The criterion (11), with the terms that the effects add.
    ///
    /// `viscous` = b − KT/2 − kKT − B and `coulomb` = c − KΔ/2 − BΔ/T − F/2, where k is the delay
    /// (TH-DELAY), B the virtual damping (TH-DAMP) and F the force step (TH-DAC); without an
    /// encoder the terms in Δ go (TH-SMOOTH). A dimensionless rig gives (8).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{effects::Effects, Fixed, Friction, Rig, Scalar};
    ///
    /// let friction = Friction::new(Fixed::integer(2), Fixed::integer(1));
    /// let effects = Effects { delay: 1, ..Effects::encoder() };
    /// let criterion = Rig::dimensionless(friction, effects).criterion();
    /// assert_eq!(criterion.viscous, Fixed::new(1, 2));
    /// assert_eq!(criterion.coulomb, Fixed::new(1, 2));
    /// ```
    #[must_use]
    pub fn criterion(&self) -> Criterion<S> {
        let effects = &self.effects;
        let samples_late = S::one().half() + delay_number(effects.delay);
        let mut viscous = self.viscous.clone() - self.viscous_unit() * samples_late;
        let mut coulomb = self.coulomb.clone();
        if effects.encoder {
            coulomb = coulomb - self.force_unit().half();
        }
        if let Some(damping) = &effects.damping {
            viscous = viscous - damping.clone();
            if effects.encoder {
                // One tick between two samples is a speed of Δ/T.
                let tick_speed = self.length.clone().over(self.period.clone());
                coulomb = coulomb - damping.clone() * tick_speed;
            }
        }
        if let Some(step) = &effects.force_step {
            coulomb = coulomb - step.clone().half();
        }
        Criterion { viscous, coulomb }
    }

    /// The criterion divided by its units KT and KΔ: (8), with speeds in ticks per sample.
    #[must_use]
    pub fn dimensionless_criterion(&self) -> Criterion<S> {
        let with_units = self.criterion();
        Criterion {
            viscous: with_units.viscous.over(self.viscous_unit()),
            coulomb: with_units.coulomb.over(self.force_unit()),
        }
    }

    /// A speed in length per time as ticks per sampling period, v·T/Δ (4).
    #[must_use]
    pub fn dimensionless_speed(&self, speed: &S) -> S {
        (speed.clone() * self.period.clone()).over(self.length.clone())
    }

    /// The same rig with every number taken through `f`; `None` when `f` gives up on one.
    pub fn try_map<U: Scalar>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Rig<U>> {
        let optional = |x: &Option<S>| match x {
            Some(x) => f(x).map(Some),
            None => Some(None),
        };
        Some(Rig {
            viscous: f(&self.viscous)?,
            coulomb: f(&self.coulomb)?,
            stiffness: f(&self.stiffness)?,
            period: f(&self.period)?,
            length: f(&self.length)?,
            effects: Effects {
                encoder: self.effects.encoder,
                delay: self.effects.delay,
                damping: optional(&self.effects.damping)?,
                force_step: optional(&self.effects.force_step)?,
            },
        })
    }
}
