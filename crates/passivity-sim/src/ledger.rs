//! The energy ledger of a simulated motion: E_g for both counterparts, E_d by its closed form, and
//! the residual of the balance (13), in doubles.
//!
//! Generated is what the held force gives beyond a spring of stiffness K (a one-sided or limited one
//! where the wall is). A controller with H(1) ≠ 1 is another spring at rest, H(1)·K: the difference is
//! counted as generated, positive and negative, and over a closed way it adds nothing.
//!
//! The potentials are those that the kernel's [`ledger`](passivity_core::ledger) accounts with, in
//! forms that lose few bits in doubles. A test holds them against the kernel for every set of effects.

use crate::law::{self, HeldForce};
use crate::number::floor;

/// The account of one interval; energies in KΔ².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Entry {
    /// The interval.
    pub h: u64,
    /// ξ at its start, in ticks.
    pub xi0: f64,
    /// ξ at its end.
    pub xi1: f64,
    /// ξ̇ at its start, in ticks per sample.
    pub v0: f64,
    /// ξ̇ at its end.
    pub v1: f64,
    /// E_gᴸ, against the linear counterpart of the wall.
    pub generated_linear: f64,
    /// E_g, against its quantized counterpart.
    pub generated_quantized: f64,
    /// E_d, dissipated by the device's friction.
    pub dissipated: f64,
    /// Left and right side of the balance (13), their difference: rounding alone.
    pub residual: f64,
}

/// Sums over a run; energies in KΔ².
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals {
    /// Σ E_gᴸ.
    pub generated_linear: f64,
    /// Σ E_g.
    pub generated_quantized: f64,
    /// Σ E_d.
    pub dissipated: f64,
    /// The largest |residual| of an interval.
    pub residual_max: f64,
    lost: [f64; 3],
}

impl Totals {
    /// Adds an interval, with Neumaier's compensation: the sums are good for 10⁸ intervals.
    pub(crate) fn add(&mut self, entry: &Entry) {
        let [linear, quantized, dissipated] = &mut self.lost;
        *linear += added(&mut self.generated_linear, entry.generated_linear);
        *quantized += added(&mut self.generated_quantized, entry.generated_quantized);
        *dissipated += added(&mut self.dissipated, entry.dissipated);
        let residual = entry.residual.abs();
        // The library's maximum passes over NaN, which here must stay.
        if residual.is_nan() || self.residual_max < residual {
            self.residual_max = residual;
        }
    }

    /// The sums with what rounding lost put back.
    pub(crate) fn settled(mut self) -> Self {
        let [linear, quantized, dissipated] = std::mem::take(&mut self.lost);
        self.generated_linear += linear;
        self.generated_quantized += quantized;
        self.dissipated += dissipated;
        self
    }

    /// Sums that were made elsewhere.
    pub(crate) fn of([linear, quantized, dissipated]: [f64; 3], residual_max: f64) -> Self {
        Self {
            generated_linear: linear,
            generated_quantized: quantized,
            dissipated,
            residual_max,
            lost: [0.0; 3],
        }
    }
}

/// Adds a term to a sum: what rounding lost of it.
#[inline]
fn added(sum: &mut f64, term: f64) -> f64 {
    let before = *sum;
    *sum += term;
    if before.abs() >= term.abs() {
        (before - *sum) + term
    } else {
        (term - *sum) + before
    }
}

/// The change of the potentials of a wall from ξ₀ to ξ₁: linear and quantized counterpart.
///
/// For the wall on both sides without saturation, the linear one is d·(ξ₀ + ½d). The wall is that of
/// stiffness K, whatever H(1) of the controller is.
pub(crate) fn potential_change(law: &HeldForce, xi0: f64, xi1: f64) -> [f64; 2] {
    let d = xi1 - xi0;
    let clamped = law.has(law::UNILATERAL) || law.has(law::SATURATION);
    let linear = if clamped {
        clamped_potential(law, xi1) - clamped_potential(law, xi0)
    } else {
        d * (xi0 + 0.5 * d)
    };
    if !law.has(law::ENCODER) {
        return [linear; 2];
    }
    let quantized = if clamped {
        clamped_steps(law, xi1) - clamped_steps(law, xi0)
    } else {
        let rho = |xi: f64| xi - floor(xi);
        let bump = |rho: f64| 0.5 * rho * (1.0 - rho);
        linear + bump(rho(xi1)) - bump(rho(xi0))
    };
    [linear, quantized]
}

/// The least and the largest force of the law before it is held.
fn limits(law: &HeldForce) -> [f64; 2] {
    let limit = if law.has(law::SATURATION) {
        law.max_force
    } else {
        f64::INFINITY
    };
    let least = if law.has(law::UNILATERAL) {
        0.0
    } else {
        -limit
    };
    [least, limit]
}

/// V(ξ) = ∫f of the clamped spring: ξy − ½y² with y = f(ξ).
fn clamped_potential(law: &HeldForce, xi: f64) -> f64 {
    let [least, most] = limits(law);
    let y = xi.clamp(least, most);
    y * (xi - 0.5 * y)
}

/// ∫f(⌊x⌋ + ½)dx from 0 to ξ for the clamped spring.
fn clamped_steps(law: &HeldForce, xi: f64) -> f64 {
    let [least, most] = limits(law);
    let one_side = |distance: f64, limit: f64| {
        // Whole ticks whose middle n + ½ is below the limit, then the limit.
        let whole = floor(distance);
        let free = (limit - 0.5).ceil().max(0.0);
        let ramp = whole.min(free);
        let beyond = if whole > free {
            (whole - free) * limit
        } else {
            0.0
        };
        let rest = distance - whole;
        let last = if rest > 0.0 {
            rest * (whole + 0.5).min(limit)
        } else {
            0.0
        };
        0.5 * ramp * ramp + beyond + last
    };
    if xi >= 0.0 {
        one_side(xi, most)
    } else {
        one_side(-xi, -least)
    }
}
