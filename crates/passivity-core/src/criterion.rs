//! The passivity criterion: (8), (9), (11) and (27) in one text.

use crate::scalar::Scalar;

/// The two coefficients of the criterion `viscous·v + coulomb ≥ 0`.
///
/// Dimensionless (8): `viscous` = β − ½, `coulomb` = σ − ½, v in ticks per sampling period.
/// With units (11): `viscous` = b − KT/2, `coulomb` = c − KΔ/2, v in units of length per time.
/// The effects of a loop lower them; see [`Loop::criterion`](crate::Loop::criterion).
///
/// # Example
///
/// ```
/// use passivity_core::{Criterion, Fixed, Friction, Scalar};
///
/// let criterion = Criterion::of_friction(&Friction::new(Fixed::new(3, 5), Fixed::new(3, 5)));
/// assert_eq!(criterion.margin(&Fixed::new(1, 2)), Fixed::new(3, 20));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criterion<S> {
    /// What viscous friction has to spare; per unit of speed.
    pub viscous: S,
    /// What Coulomb friction has to spare.
    pub coulomb: S,
}

impl<S: Scalar> Criterion<S> {
    /// The criterion (8) of a sampled and quantized wall with no further effect.
    #[must_use]
    pub fn of_friction(friction: &crate::Friction<S>) -> Self {
        Self {
            viscous: friction.beta.clone() - S::one().half(),
            coulomb: friction.sigma.clone() - S::one().half(),
        }
    }

    /// Margin at a speed v ≥ 0: `viscous·v + coulomb`. The criterion holds when it is not negative.
    ///
    /// This is (8) multiplied by the speed, so that it also has a meaning at rest.
    #[inline(always)]
    #[must_use]
    pub fn margin(&self, speed: &S) -> S {
        self.viscous.clone() * speed.clone() + self.coulomb.clone()
    }

    /// Margin at every speed: the smaller coefficient.
    ///
    /// The criterion holds at every speed exactly when it is not negative (TH-REGION).
    #[must_use]
    pub fn margin_at_all_speeds(&self) -> S {
        self.viscous.clone().min(self.coulomb.clone())
    }

    /// Margin at every speed up to `bound`: the smaller of the margins at rest and at the bound.
    #[must_use]
    pub fn margin_up_to(&self, bound: &S) -> S {
        self.coulomb.clone().min(self.margin(bound))
    }

    /// The left-hand side of (27): `viscous·d²/Δτ + coulomb·|d|`, in KΔ².
    ///
    /// Equal to |d| times the margin at the mean speed v̄ = |d|/Δτ (EQ-27), which is how it is
    /// written here.
    #[must_use]
    pub fn surplus(&self, displacement: &S, mean_speed: &S) -> S {
        displacement.abs() * self.margin(mean_speed)
    }

    /// The σ on the critical line (9) at β and a speed: ½ − v(β − ½).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Criterion, Fixed, Scalar};
    ///
    /// let sigma = Criterion::critical_sigma(&Fixed::new(1, 4), &Fixed::integer(2));
    /// assert_eq!(sigma, Fixed::integer(1));
    /// ```
    #[must_use]
    pub fn critical_sigma(beta: &S, speed: &S) -> S {
        S::one().half() - speed.clone() * (beta.clone() - S::one().half())
    }
}
