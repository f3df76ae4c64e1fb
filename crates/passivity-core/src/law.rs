//! Force laws that are nowhere stiffer than the wall: two-sided, one-sided, saturated (TH-LAW).
//!
//! A law f that is 1-Lipschitz (in units of K) generates no more energy than the spring it
//! softens: V(ξ + d) − V(ξ) − f(ξ + e)·d ≤ ½d² + ½|d| for |e| ≤ ½, where V = ∫f. That is one
//! theorem for the bilateral wall, the unilateral wall (TH-UNI), saturation and dead band.

use crate::quantizer::Quantized;
use crate::scalar::Scalar;

/// A clamped linear spring, f(ξ) = min(max(ξ, lower), upper), in KΔ.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Law, Scalar};
///
/// let wall = Law::unilateral();
/// assert_eq!(wall.force(&Fixed::integer(-3)), Fixed::integer(0));
/// assert_eq!(wall.potential(&Fixed::integer(3)), Fixed::new(9, 2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Law<S> {
    /// The least force, or none.
    pub lower: Option<S>,
    /// The largest force, or none.
    pub upper: Option<S>,
}

impl<S: Scalar> Law<S> {
    /// The wall on both sides, f(ξ) = ξ, as in (2).
    #[inline(always)]
    #[must_use]
    pub const fn bilateral() -> Self {
        Self {
            lower: None,
            upper: None,
        }
    }

    /// The wall ξ ≥ 0 only, f(ξ) = max(ξ, 0) (TH-UNI).
    #[must_use]
    pub fn unilateral() -> Self {
        Self {
            lower: Some(S::zero()),
            upper: None,
        }
    }

    /// The same law with its force limited to `limit` ≥ 0 in magnitude, in KΔ.
    #[must_use]
    pub fn saturated(self, limit: S) -> Self {
        let lower = match self.lower {
            Some(lower) => lower.max(-limit.clone()),
            None => -limit.clone(),
        };
        let upper = match self.upper {
            Some(upper) => upper.min(limit),
            None => limit,
        };
        Self {
            lower: Some(lower),
            upper: Some(upper),
        }
    }

    /// The magnitude f(ξ) of the restoring force at ξ ticks, in KΔ; the wall pushes with −f.
    #[inline(always)]
    #[must_use]
    pub fn force(&self, xi: &S) -> S {
        let mut force = xi.clone();
        if let Some(lower) = &self.lower {
            force = force.max(lower.clone());
        }
        if let Some(upper) = &self.upper {
            force = force.min(upper.clone());
        }
        force
    }

    /// The potential V(ξ) = ∫f from 0, in KΔ², for a law with `lower` ≤ 0 ≤ `upper`.
    ///
    /// With y = f(ξ) it is ξy − ½y²: on the linear part ½ξ², beyond it the tangent.
    #[inline(always)]
    #[must_use]
    pub fn potential(&self, xi: &S) -> S {
        let force = self.force(xi);
        xi.clone() * force.clone() - force.square().half()
    }

    /// The potential of the quantized law, ∫f(⌊x⌋ + ½)dx from 0 to ξ, in KΔ² (16).
    ///
    /// For a law with `lower` ≤ 0 ≤ `upper`. With y = ⌊x⌋ + ½ the law is
    /// f(y) = y − max(y − upper, 0) + max(lower − y, 0), and each part is summed over whole ticks.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Law, Scalar};
    ///
    /// let wall = Law::bilateral().saturated(Fixed::integer(1));
    /// // Ticks of force ½, then 1, then half a tick of 1.
    /// assert_eq!(wall.quantized_potential(&Fixed::new(5, 2)), Fixed::integer(2));
    /// ```
    #[must_use]
    pub fn quantized_potential(&self, xi: &S) -> S {
        let Quantized { tick, residue } = Quantized::of(xi);
        let mut potential = crate::spring::quantized_potential(xi);
        if let Some(upper) = &self.upper {
            potential = potential - beyond(upper, &tick, &residue);
        }
        if let Some(lower) = &self.lower {
            // Seen from the other side, tick n is tick −1 − n, and what is left of it is 1 − ρ.
            let mirrored = -(tick + S::one());
            potential = potential - beyond(&-lower.clone(), &mirrored, &(S::one() - residue));
        }
        potential
    }

    /// The energy that switching the wall at ξ ticks adds to what is stored, in KΔ² (ERR-IV-C).
    ///
    /// A wall that is switched off gives up V(ξ) and nobody gains it. One that is switched on at a
    /// depth has V(ξ) to give that nobody put in: ½ξ² for the linear spring.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Law, Scalar};
    ///
    /// let (wall, depth) = (Law::bilateral(), Fixed::integer(4));
    /// assert_eq!(wall.switching_energy(false, true, &depth), Fixed::integer(8));
    /// assert_eq!(wall.switching_energy(true, false, &depth), Fixed::integer(-8));
    /// ```
    #[must_use]
    pub fn switching_energy(&self, was_on: bool, is_on: bool, xi: &S) -> S {
        match (was_on, is_on) {
            (false, true) => self.potential(xi),
            (true, false) => -self.potential(xi),
            (false, false) | (true, true) => S::zero(),
        }
    }

    /// Whether the law is the linear spring everywhere.
    #[must_use]
    pub const fn is_linear(&self) -> bool {
        self.lower.is_none() && self.upper.is_none()
    }

    /// The force held from a sample at ξ, −f(⌊ξ⌋ + ½), in KΔ.
    ///
    /// For the unilateral wall it is zero exactly when the sample is outside.
    #[must_use]
    pub fn held_force(&self, xi: &S) -> S {
        -self.force(&Quantized::of(xi).measured())
    }
}

/// ∫max(⌊x⌋ + ½ − limit, 0)dx from 0 to n + ρ, for a limit of at least zero; zero for n < 0.
///
/// Tick j is beyond the limit when j ≥ m = max(⌈limit − ½⌉, 0). N = max(n − m, 0) whole ones make
/// Σ (j + ½ − limit) = N(m − limit + N/2), and the last one a share ρ of its own.
fn beyond<S: Scalar>(limit: &S, tick: &S, residue: &S) -> S {
    let first = (-(S::one().half() - limit.clone()).floor()).max(S::zero());
    let whole = (tick.clone() - first.clone()).max(S::zero());
    let last = (tick.clone() + S::one().half() - limit.clone()).max(S::zero());
    whole.clone() * (first - limit.clone() + whole.half()) + last * residue.clone()
}
