//! Energy that friction dissipates: (23) to (26).

use crate::scalar::Scalar;

/// The dimensionless friction of a rendered wall (7).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction};
///
/// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
/// assert_eq!(friction.power(&Fixed::new(-1, 2)), Fixed::new(9, 20));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Friction<S> {
    /// β = b/(KT) ≥ 0, effective viscous friction.
    pub beta: S,
    /// σ = c/(KΔ) ≥ 0, effective Coulomb friction.
    pub sigma: S,
}

impl<S: Scalar> Friction<S> {
    /// Friction with the coefficients β and σ (7).
    #[must_use]
    pub const fn new(beta: S, sigma: S) -> Self {
        Self { beta, sigma }
    }

    /// Power dissipated at a velocity, βξ̇² + σ|ξ̇|: the integrand of (23), in KΔ²/T.
    #[must_use]
    pub fn power(&self, velocity: &S) -> S {
        let speed = velocity.abs();
        speed.clone() * (self.beta.clone() * speed + self.sigma.clone())
    }

    /// Least energy that a step can dissipate, βd²/Δτ + σ|d| (26), in KΔ².
    ///
    /// Written |d|·(β·v̄ + σ) with `mean_speed` v̄ = |d|/Δτ. Reached at constant speed (EQ-23..26).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, dissipation::mean_speed, Scalar};
    ///
    /// let d = Fixed::new(-1, 2);
    /// let friction = Friction::new(Fixed::new(3, 5), Fixed::new(3, 5));
    /// let least = friction.dissipated_lower(&d, &mean_speed(&d, &Fixed::integer(1)));
    /// assert_eq!(least, Fixed::new(9, 20));
    /// ```
    #[inline(always)]
    #[must_use]
    pub fn dissipated_lower(&self, displacement: &S, mean_speed: &S) -> S {
        displacement.abs() * (self.beta.clone() * mean_speed.clone() + self.sigma.clone())
    }

    /// Energy dissipated over a piece of motion at constant velocity that lasts `duration` (23).
    ///
    /// A motion is as many such pieces as one likes; (24) and (25) say that the sum over the
    /// pieces is at least [`dissipated_lower`](Self::dissipated_lower) of the whole.
    #[must_use]
    pub fn dissipated_at_constant_velocity(&self, velocity: &S, duration: &S) -> S {
        self.power(velocity) * duration.clone()
    }
}

/// v̄ = |d|/Δτ, mean speed in ticks per sampling period; `dtau` > 0 in sampling periods.
///
/// It is the speed of the device at some instant of the step (28) (EQ-28).
#[inline(always)]
#[must_use]
pub fn mean_speed<S: Scalar>(displacement: &S, dtau: &S) -> S {
    displacement.abs().over(dtau.clone())
}
