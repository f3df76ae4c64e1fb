//! The position quantizer (15) and the force that a sample commands (5).

use crate::scalar::Scalar;

/// A position split into whole encoder ticks and the quantization error (15).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Quantized, Scalar};
///
/// let q = Quantized::of(&Fixed::new(-1, 4));
/// assert_eq!(q.tick, Fixed::integer(-1));
/// assert_eq!(q.residue, Fixed::new(3, 4));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantized<S> {
    /// n = ⌊ξ⌋, what the encoder counts.
    pub tick: S,
    /// ρ = ξ − ⌊ξ⌋, in [0, 1): what the encoder does not see.
    pub residue: S,
}

impl<S: Scalar> Quantized<S> {
    /// Splits the position ξ (ticks) into ⌊ξ⌋ and ρ (15).
    #[inline(always)]
    #[must_use]
    pub fn of(xi: &S) -> Self {
        let tick = xi.floor();
        let residue = xi.clone() - tick.clone();
        Self { tick, residue }
    }

    /// The position the force law is given: the middle of the tick, ⌊ξ⌋ + ½.
    ///
    /// The ½ centres the quantization error, |⌊ξ⌋ + ½ − ξ| ≤ ½, and makes the force symmetric.
    #[inline(always)]
    #[must_use]
    pub fn measured(&self) -> S {
        self.tick.clone() + S::one().half()
    }
}

/// The force that the zero-order hold commands from a sample at ξ, φ_V = −(⌊ξ⌋ + ½) (5), in KΔ.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, quantizer::held_force};
///
/// assert_eq!(held_force(&Fixed::new(5, 4)), Fixed::new(-3, 2));
/// ```
#[inline(always)]
#[must_use]
pub fn held_force<S: Scalar>(xi: &S) -> S {
    -Quantized::of(xi).measured()
}
