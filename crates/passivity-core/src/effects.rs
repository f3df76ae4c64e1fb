//! Effects of a real loop beyond sampling and encoder, and what each of them costs.
//!
//! Every effect adds to the energy that a step generates at most a multiple of d² and of |d|, plus
//! a change of *extra storage* that a sum over steps telescopes away. The multiples are what the
//! criterion must subtract: see [`Rig::criterion`](crate::Rig::criterion).

use crate::rig::Rig;
use crate::scalar::Scalar;

/// The effects of a loop, beside the zero-order hold.
///
/// Dimensionless: `damping` is B in KT, `force_step` is δ in KΔ. In a [`Rig`] with units, both
/// carry units. One-sided walls and saturation are no entries here, because they change no
/// term (TH-UNI, TH-LAW).
///
/// # Example
///
/// ```
/// use passivity_core::{effects::Effects, Fixed, Scalar};
///
/// let late = Effects { delay: 1, ..Effects::<Fixed>::encoder() };
/// assert_eq!(late.cost().viscous, Fixed::new(3, 2)); // ½ + 1
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effects<S> {
    /// Whether an encoder quantizes the position (else TH-SMOOTH).
    pub encoder: bool,
    /// k, whole samples by which the force is late (TH-DELAY).
    pub delay: u16,
    /// B, virtual damping by backward difference (TH-DAMP).
    pub damping: Option<S>,
    /// δ, step of the force quantizer (TH-DAC).
    pub force_step: Option<S>,
}

/// What a step may generate at most: `viscous`·d² + `coulomb`·|d|, beside changes of storage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost<S> {
    /// ½ + k + B.
    pub viscous: S,
    /// ½(1 + δ) + B with an encoder, ½δ without.
    pub coulomb: S,
}

impl<S: Scalar> Effects<S> {
    /// The loop of the paper: an encoder and nothing else.
    #[must_use]
    pub const fn encoder() -> Self {
        Self {
            encoder: true,
            delay: 0,
            damping: None,
            force_step: None,
        }
    }

    /// A loop that knows its position exactly (TH-SMOOTH).
    #[must_use]
    pub const fn smooth() -> Self {
        Self {
            encoder: false,
            delay: 0,
            damping: None,
            force_step: None,
        }
    }

    /// Whether sampling and (at most) an encoder are all there is, so that TH-ACTIVE applies.
    #[must_use]
    pub const fn is_plain(&self) -> bool {
        self.delay == 0 && self.damping.is_none() && self.force_step.is_none()
    }

    /// What a step may generate: the criterion at no friction, negated. Dimensionless.
    #[must_use]
    pub fn cost(&self) -> Cost<S> {
        let frictionless =
            Rig::dimensionless(crate::Friction::new(S::zero(), S::zero()), self.clone());
        let criterion = frictionless.criterion();
        Cost {
            viscous: -criterion.viscous,
            coulomb: -criterion.coulomb,
        }
    }
}

impl<S: Scalar> Cost<S> {
    /// The bound `viscous`·d² + `coulomb`·|d| on what a step of displacement d generates, in KΔ².
    #[must_use]
    pub fn bound(&self, displacement: &S) -> S {
        let d = displacement.abs();
        d.clone() * (self.viscous.clone() * d + self.coulomb.clone())
    }
}

/// k as a number.
pub(crate) fn delay_number<S: Scalar>(delay: u16) -> S {
    S::integer(i32::from(delay))
}

/// Energy that a delay of k samples adds over a step, d·Σ d_{h−j} for j = 1…k (TH-DELAY), in KΔ².
///
/// `past` holds the last k displacements, the latest first. At most k·d² plus the drop of
/// [`delay_storage`].
#[must_use]
pub fn generated_by_delay<S: Scalar>(past: &[S], displacement: &S) -> S {
    let travelled = past.iter().fold(S::zero(), |sum, d| sum + d.clone());
    displacement.clone() * travelled
}

/// Extra storage of a delay of k samples, Σ ½(k − j + 1)·d²_{h−j} for j = 1…k (TH-DELAY), in KΔ².
///
/// Each past step keeps ½d² for every later step that will still be charged with it.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, effects::delay_storage};
///
/// let past = [Fixed::integer(1), Fixed::integer(2)]; // latest first, k = 2
/// assert_eq!(delay_storage(&past), Fixed::integer(3)); // ½·2·1 + ½·1·4
/// ```
#[must_use]
pub fn delay_storage<S: Scalar>(past: &[S]) -> S {
    // Summing the oldest first, each further step is counted once more than the one before it.
    let mut weight = S::zero();
    let mut storage = S::zero();
    for d in past.iter().rev() {
        weight = weight + S::one();
        storage = storage + (weight.clone() * d.square()).half();
    }
    storage
}

/// Energy that virtual damping adds over a step, −B·(q − q′)·d (TH-DAMP), in KΔ².
///
/// `ticks` is q − q′, the difference of the two latest samples that the controller knows, in
/// ticks; it differs by less than 1 from the displacement between them (not at all without an
/// encoder). At most B·d² + B·|d| plus the drop of [`damping_storage`].
#[must_use]
pub fn generated_by_damping<S: Scalar>(damping: &S, ticks: &S, displacement: &S) -> S {
    -(damping.clone() * ticks.clone() * displacement.clone())
}

/// Extra storage of virtual damping, ½B·Σ d² over the steps not yet acted on (TH-DAMP), in KΔ².
///
/// `past` holds the last 1 + k displacements, where k is the delay.
#[must_use]
pub fn damping_storage<S: Scalar>(damping: &S, past: &[S]) -> S {
    let squares = past.iter().fold(S::zero(), |sum, d| sum + d.square());
    (damping.clone() * squares).half()
}

/// The force rounded to whole steps of a D/A converter, δ·⌊u/δ + ½⌋ (TH-DAC), in the units of both.
///
/// Off by at most ½δ, so it adds at most ½δ|d| to what a step generates. `step` > 0.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, effects::rounded_force};
///
/// assert_eq!(rounded_force(&Fixed::new(7, 4), &Fixed::new(1, 2)), Fixed::integer(2));
/// ```
#[must_use]
pub fn rounded_force<S: Scalar>(force: &S, step: &S) -> S {
    step.clone() * (force.clone().over(step.clone()) + S::one().half()).floor()
}
