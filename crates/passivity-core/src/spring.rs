//! Stored energy: the quantized spring (16), (17) and the linear one.

use crate::quantizer::Quantized;
use crate::scalar::Scalar;

/// Potential of the linear spring, ½ξ², in KΔ².
///
/// This is the storage that makes the criterion true in every sampling interval (TH-INTERVAL).
#[must_use]
pub fn linear_potential<S: Scalar>(xi: &S) -> S {
    xi.square().half()
}

/// The part of the potential that quantization adds, ½(ρ − ρ²), between 0 and 1/8 (16).
///
/// TH-TELESCOPE: the energies generated against the two springs differ by the change of this.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, spring::quantization_potential};
///
/// assert_eq!(quantization_potential(&Fixed::new(5, 2)), Fixed::new(1, 8));
/// ```
#[must_use]
#[inline(always)]
pub fn quantization_potential<S: Scalar>(xi: &S) -> S {
    let rho = Quantized::of(xi).residue;
    (rho.clone() * (S::one() - rho)).half()
}

/// Potential of the continuous-time quantized spring, H_e(ξ) = ½ξ² + ½(ρ − ρ²) (16), in KΔ².
///
/// It is the piecewise-linear interpolant of ½n² + ½n at whole ticks (EQ-16/17).
#[must_use]
pub fn quantized_potential<S: Scalar>(xi: &S) -> S {
    linear_potential(xi) + quantization_potential(xi)
}

/// Kinetic energy ½μξ̇² of the device, in KΔ²; `velocity` in ticks per sampling period (17).
#[must_use]
pub fn kinetic<S: Scalar>(mu: &S, velocity: &S) -> S {
    (mu.clone() * velocity.square()).half()
}

/// Storage against the linear spring, S = ½μξ̇² + ½ξ², in KΔ² (TH-RUN).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, spring::storage};
///
/// let s = storage(&Fixed::integer(50), &Fixed::integer(3), &Fixed::integer(1));
/// assert_eq!(s, Fixed::new(59, 2));
/// ```
#[must_use]
pub fn storage<S: Scalar>(mu: &S, xi: &S, velocity: &S) -> S {
    kinetic(mu, velocity) + linear_potential(xi)
}

/// Storage against the quantized spring, H_T = ½μξ̇² + H_e(ξ) (17), in KΔ².
#[must_use]
pub fn quantized_storage<S: Scalar>(mu: &S, xi: &S, velocity: &S) -> S {
    kinetic(mu, velocity) + quantized_potential(xi)
}
