//! The energy ledger of a simulated motion: E_g for both counterparts, E_d by its closed form, and
//! the residual of the balance (13), in doubles.

use crate::law::{self, Controller, floor};

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
    /// The force held, in KΔ.
    pub held: f64,
    /// The operator's force, in KΔ.
    pub force: f64,
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
    pub fn add(&mut self, entry: &Entry) {
        let terms = [
            (&mut self.generated_linear, entry.generated_linear),
            (&mut self.generated_quantized, entry.generated_quantized),
            (&mut self.dissipated, entry.dissipated),
        ];
        for ((sum, term), lost) in terms.into_iter().zip(&mut self.lost) {
            let next = *sum + term;
            *lost += if sum.abs() >= term.abs() {
                (*sum - next) + term
            } else {
                (term - next) + *sum
            };
            *sum = next;
        }
        self.residual_max = self.residual_max.max(entry.residual.abs());
    }

    /// The sums with what rounding lost put back.
    #[must_use]
    pub fn settled(mut self) -> Self {
        self.generated_linear += self.lost[0];
        self.generated_quantized += self.lost[1];
        self.dissipated += self.lost[2];
        self.lost = [0.0; 3];
        self
    }
}

impl Entry {
    /// d, in ticks.
    #[must_use]
    pub fn displacement(&self) -> f64 {
        self.xi1 - self.xi0
    }

    /// ½d² + ½|d| (22).
    #[must_use]
    pub fn bound_22(&self) -> f64 {
        let d = self.displacement().abs();
        0.5 * d * (d + 1.0)
    }

    /// The tight bound of E_g for the plain wall (TH-QUANT).
    #[must_use]
    pub fn bound_quantized(&self) -> f64 {
        let d = self.displacement().abs();
        let rest = d - floor(d);
        self.bound_22() + 0.5 * rest * (1.0 - rest)
    }

    /// βd² + σ|d|, the least that friction dissipates (26).
    #[must_use]
    pub fn dissipated_lower(&self, beta: f64, sigma: f64) -> f64 {
        let d = self.displacement().abs();
        d * (beta * d + sigma)
    }
}

/// The change of the potentials of a wall from ξ₀ to ξ₁: linear and quantized counterpart.
///
/// For the wall on both sides without saturation, the linear one is d·(ξ₀ + ½d).
#[must_use]
pub fn potential_change(law: &Controller, xi0: f64, xi1: f64) -> [f64; 2] {
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
fn limits(law: &Controller) -> [f64; 2] {
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
fn clamped_potential(law: &Controller, xi: f64) -> f64 {
    let [least, most] = limits(law);
    let y = xi.clamp(least, most);
    y * (xi - 0.5 * y)
}

/// ∫f(⌊x⌋ + ½)dx from 0 to ξ for the clamped spring.
fn clamped_steps(law: &Controller, xi: f64) -> f64 {
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

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::{BigRational, Law, Scalar, Step, generation, spring};

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    #[test]
    fn bounds_and_potentials_are_the_kernels() {
        let law = Controller::encoder();
        // Eighths: every operation of the doubles is exact.
        for i in -40..=40 {
            for j in -40..=40 {
                let (xi0, xi1) = (f64::from(i) / 8.0, f64::from(j) / 8.0);
                let entry = Entry {
                    xi0,
                    xi1,
                    ..Entry::default()
                };
                let d = Step::new(exact(xi0), exact(xi1)).displacement();
                assert_eq!(exact(entry.bound_22()), generation::bound_22(&d));
                assert_eq!(
                    exact(entry.bound_quantized()),
                    generation::bound_quantized(&d)
                );
                let [linear, quantized] = potential_change(&law, xi0, xi1);
                let change = |f: fn(&BigRational) -> BigRational| f(&exact(xi1)) - f(&exact(xi0));
                assert_eq!(exact(linear), change(spring::linear_potential));
                assert_eq!(exact(quantized), change(spring::quantized_potential));
            }
        }
    }

    #[test]
    fn clamped_potentials_are_the_integrals_of_their_laws() {
        for (effects, max_force) in [
            (law::ENCODER | law::UNILATERAL, 0.0),
            (law::ENCODER | law::SATURATION, 2.25),
            (law::ENCODER | law::SATURATION | law::UNILATERAL, 0.25),
        ] {
            let law = Controller {
                effects,
                max_force,
                ..Controller::encoder()
            };
            let mut kernel = Law::bilateral();
            if law.has(law::UNILATERAL) {
                kernel = Law::unilateral();
            }
            if law.has(law::SATURATION) {
                kernel = kernel.saturated(exact(max_force));
            }
            let mut sum = exact(0.0);
            for i in -40..40 {
                let (xi0, xi1) = (f64::from(i) / 8.0, f64::from(i + 1) / 8.0);
                let [linear, quantized] = potential_change(&law, xi0, xi1);
                let expected = kernel.potential(&exact(xi1)) - kernel.potential(&exact(xi0));
                assert_eq!(exact(linear), expected);
                // Within one eighth the held force is constant.
                let step = -kernel.held_force(&exact(xi0)) * exact(0.125);
                assert_eq!(exact(quantized), step, "{effects} from {xi0}");
                sum += step;
            }
            assert!(sum >= Scalar::integer(0) || !law.has(law::UNILATERAL));
        }
    }
}
