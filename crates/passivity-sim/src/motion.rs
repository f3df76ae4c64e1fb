//! Motion within an interval under a held force: closed form, with at most one reversal.
//!
//! μ·ξ̈ = u − β·ξ̇ − σ·sgn ξ̇ (6) with u constant. Between reversals, with λ = β/μ and
//! a = (u − σ·sgn v)/μ: v(t) = v₀e^(−λt) + a·tφ₁(−λt), ξ(t) = ξ₀ + v₀·tφ₁(−λt) + a·t²φ₂(−λt).
//! The velocity is monotone, so its sign at the end tells whether it was zero in between.
//!
//! When it was, let r = −v₀/a. The device stops at t*, where e^(−λt*) = 1/(1 + λr), having gone
//! v₀·r·H(−λr). The rest of the interval, t₂ = 1 − t*, has
//!
//! > f = t₂φ₁(−λt₂) = (1 − e^(−λ)(1 + λr))/λ = φ₁(−λ) − e^(−λ)·r,
//!
//! so the velocity at the end is a₂f and the way there a₂f²·H(λf), a₂ being the acceleration from
//! rest, 0 while |u| ≤ σ: the device sticks. No exponential, no logarithm, no division but one.
//! [`phi`] has H and its bounds.

use crate::phi;

/// The constants of a whole interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Constants {
    /// μ, with the arm's mass.
    pub mu: f64,
    /// 1/μ.
    pub inverse_mu: f64,
    /// β.
    pub beta: f64,
    /// σ.
    pub sigma: f64,
    /// λ = β/μ.
    pub lambda: f64,
    /// e^(−λ).
    pub decay: f64,
    /// φ₁(−λ).
    pub phi1: f64,
    /// φ₂(−λ).
    pub phi2: f64,
    /// φ₁(−2λ) and χ(−λ): ∫v² over the interval is v₀²·φ₁(−2λ) + v₀a·φ₁² + a²·χ.
    pub square: [f64; 2],
}

/// Where the device is at the end of an interval, and what friction saw of the way there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moved {
    /// ξ at the end.
    pub xi: f64,
    /// ξ̇ at the end.
    pub velocity: f64,
    /// ∫|ξ̇|dτ.
    pub path: f64,
    /// ∫ξ̇²dτ.
    pub square: f64,
}

impl Constants {
    /// The constants for μ > 0, β ≥ 0, σ ≥ 0.
    #[must_use]
    pub(crate) fn new(mu: f64, beta: f64, sigma: f64) -> Self {
        let lambda = beta / mu;
        Self {
            mu,
            inverse_mu: 1.0 / mu,
            beta,
            sigma,
            lambda,
            decay: (-lambda).exp(),
            phi1: phi::phi1(-lambda),
            phi2: phi::phi2(-lambda),
            square: [phi::phi1(-2.0 * lambda), phi::chi(-lambda)],
        }
    }

    /// The motion over a whole interval under the force `u`, from ξ = `xi` and ξ̇ = `v`.
    ///
    /// `VISCOUS` and `COULOMB` say which frictions there are, `LEDGER` whether `path` and `square`
    /// are wanted (else they are 0): what is not there is not computed.
    #[inline(always)]
    #[must_use]
    pub(crate) fn advance<const VISCOUS: bool, const COULOMB: bool, const LEDGER: bool>(
        &self,
        xi: f64,
        v: f64,
        u: f64,
    ) -> Moved {
        let resisted = if COULOMB {
            u - self.sigma.copysign(v)
        } else {
            u
        };
        let a = resisted * self.inverse_mu;
        let (velocity, d) = if VISCOUS {
            (
                self.decay * v + self.phi1 * a,
                self.phi1 * v + self.phi2 * a,
            )
        } else {
            (v + a, v + 0.5 * a)
        };
        // Without Coulomb friction nothing happens at a reversal: one formula for the interval.
        if COULOMB && !((v > 0.0 && velocity >= 0.0) || (v < 0.0 && velocity <= 0.0)) {
            return self.reverse::<VISCOUS, LEDGER>(xi, v, u, a);
        }
        let square = if !LEDGER {
            0.0
        } else if VISCOUS {
            self.square[0] * v * v + self.phi1 * self.phi1 * v * a + self.square[1] * a * a
        } else {
            v * v + v * a + a * a * (1.0 / 3.0)
        };
        Moved {
            xi: xi + d,
            velocity,
            path: if LEDGER { d.abs() } else { 0.0 },
            square,
        }
    }

    /// The motion over an interval in which the velocity comes to 0, from `v` with deceleration `a`.
    #[inline(always)]
    fn reverse<const VISCOUS: bool, const LEDGER: bool>(
        &self,
        xi: f64,
        v: f64,
        u: f64,
        a: f64,
    ) -> Moved {
        let r = if v == 0.0 { 0.0 } else { -v / a };
        // Exact by Sterbenz' lemma near |u| = σ; 0 while the device sticks.
        let onward = (u - u.clamp(-self.sigma, self.sigma)) * self.inverse_mu;
        if !VISCOUS {
            let rest = (1.0 - r).max(0.0);
            let (d, then) = (0.5 * v * r, 0.5 * onward * rest * rest);
            let square = if LEDGER {
                (v * v * r + onward * onward * rest * rest * rest) * (1.0 / 3.0)
            } else {
                0.0
            };
            return Moved {
                xi: xi + (d + then),
                velocity: onward * rest,
                path: if LEDGER { d.abs() + then.abs() } else { 0.0 },
                square,
            };
        }
        if self.lambda > phi::SMALL_LAMBDA {
            return self.reverse_larger::<LEDGER>(xi, v, u, r);
        }
        let w = self.lambda * r;
        let f = (self.phi1 - self.decay * r).max(0.0);
        let x = self.lambda * f;
        let d = v * r * phi::h_series(-w);
        let then = onward * f * f * phi::h_series(x);
        let square = if LEDGER {
            v * v * r * phi::k_series(-w) + onward * onward * f * f * f * phi::k_series(x)
        } else {
            0.0
        };
        Moved {
            xi: xi + (d + then),
            velocity: onward * f,
            path: if LEDGER { d.abs() + then.abs() } else { 0.0 },
            square,
        }
    }

    /// The same for λ > 1/16.
    #[inline(never)]
    fn reverse_larger<const LEDGER: bool>(&self, xi: f64, v: f64, u: f64, r: f64) -> Moved {
        if self.lambda > phi::MEDIUM_LAMBDA {
            // Past it the terms would be too many.
            return self.reverse_wide(xi, v, u, r);
        }
        let onward = (u - u.clamp(-self.sigma, self.sigma)) * self.inverse_mu;
        let w = self.lambda * r;
        let f = (self.phi1 - self.decay * r).max(0.0);
        let x = self.lambda * f;
        let d = v * r * phi::h_medium(-w);
        let then = onward * f * f * phi::h_medium(x);
        let square = if LEDGER {
            v * v * r * phi::k(-w) + onward * onward * f * f * f * phi::k(x)
        } else {
            0.0
        };
        Moved {
            xi: xi + (d + then),
            velocity: onward * f,
            path: d.abs() + then.abs(),
            square,
        }
    }

    /// The same for any λ, with logarithm and exponential.
    #[cold]
    #[inline(never)]
    fn reverse_wide(&self, xi: f64, v: f64, u: f64, r: f64) -> Moved {
        let lambda = self.lambda;
        let onward = (u - u.clamp(-self.sigma, self.sigma)) * self.inverse_mu;
        let w = (lambda * r).min(f64::MAX);
        let rest = (1.0 - w.ln_1p() / lambda).max(0.0);
        let f = rest * phi::phi1(-lambda * rest);
        // f²·H(λf) = t₂²·φ₂(−λt₂), which does not cancel as λf nears 1.
        let half_way = rest * rest * phi::phi2(-lambda * rest);
        let d = if w > 0.5 {
            v / lambda * (1.0 - w.ln_1p() / w)
        } else {
            v * r * phi::h(-w)
        };
        let then = onward * half_way;
        let stopping = if w > 0.5 {
            // v²·r·K(−w) = (½v² − |a|·d)/λ with |a| = v/r.
            v / lambda * (0.5 * v - d / r)
        } else {
            v * v * r * phi::k(-w)
        };
        let x = lambda * f;
        let cubed = if x > 0.5 {
            (half_way - 0.5 * f * f) / lambda
        } else {
            f * f * f * phi::k(x)
        };
        Moved {
            xi: xi + (d + then),
            velocity: onward * f,
            path: d.abs() + then.abs(),
            square: stopping + onward * onward * cubed,
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    /// The motion by many short steps of the midpoint rule, stopping at reversals: an independent,
    /// slow account with error about (1/n)² of the acceleration.
    fn by_steps(mu: f64, beta: f64, sigma: f64, start: [f64; 2], u: f64) -> Moved {
        let n = 400_000;
        let dt = 1.0 / f64::from(n);
        let [mut xi, mut v] = start;
        let (mut path, mut square) = (0.0, 0.0);
        for _ in 0..n {
            let acceleration = |v: f64| {
                if v == 0.0 {
                    (u - u.clamp(-sigma, sigma)) / mu
                } else {
                    (u - beta * v - sigma.copysign(v)) / mu
                }
            };
            let middle = v + 0.5 * dt * acceleration(v);
            let mut next = v + dt * acceleration(middle);
            if v * next < 0.0 && u.abs() <= sigma {
                next = 0.0;
            }
            let mean = 0.5 * (v + next);
            xi += dt * mean;
            path += dt * mean.abs();
            square += dt * mean * mean;
            v = next;
        }
        Moved {
            xi,
            velocity: v,
            path,
            square,
        }
    }

    #[test]
    fn closed_form_is_where_short_steps_lead() {
        for (mu, beta) in [(50.0, 0.6), (50.0, 3.5), (2.0, 1.0), (1.0, 30.0)] {
            for sigma in [0.3, 0.9] {
                for v in [-1.2, -0.01, -0.003, 0.0, 0.004, 0.3] {
                    for u in [-2.5, -0.5, 0.5, 1.5] {
                        let k = Constants::new(mu, beta, sigma);
                        let got = k.advance::<true, true, true>(0.25, v, u);
                        let want = by_steps(mu, beta, sigma, [0.25, v], u);
                        // One step that straddles a reversal is off by (|u| + σ)/μ·dt.
                        let tolerance = 2e-5 / mu.min(1.0);
                        let close = |a: f64, b: f64| (a - b).abs() < tolerance;
                        assert!(
                            close(got.xi, want.xi)
                                && close(got.velocity, want.velocity)
                                && close(got.path, want.path)
                                && close(got.square, want.square),
                            "μ {mu} β {beta} σ {sigma} v {v} u {u}: {got:?} against {want:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn the_two_texts_for_a_reversal_agree() {
        // λ = 1/16: the series is at its limit, and the logarithm has lost little.
        let k = Constants::new(16.0, 1.0, 0.25);
        for i in 1..40 {
            let v = f64::from(i) / 1024.0;
            for u in [-0.75, -1.5, -0.1] {
                let a = (u - 0.25) / 16.0;
                if k.decay * v + k.phi1 * a >= 0.0 {
                    continue;
                }
                let series = k.reverse::<true, true>(0.0, v, u, a);
                let wide = k.reverse_wide(0.0, v, u, -v / a);
                // 1 − ln(1 + w)/λ loses 16 ulp of 1: 4e-15 of a way below 1.
                assert_abs_diff_eq!(series.xi, wide.xi, epsilon = 1e-14);
                assert_abs_diff_eq!(series.velocity, wide.velocity, epsilon = 1e-14);
                assert_abs_diff_eq!(series.square, wide.square, epsilon = 1e-14);
            }
        }
    }

    #[test]
    fn without_friction_a_force_of_mu_leads_half_a_tick_on() {
        let moved = Constants::new(50.0, 0.0, 0.0).advance::<false, false, true>(0.0, 0.0, 50.0);
        assert_eq!((moved.xi, moved.velocity, moved.path), (0.5, 1.0, 0.5));
    }

    #[test]
    fn it_sticks_at_equality_and_not_an_ulp_past_it() {
        let k = Constants::new(50.0, 0.6, 0.5);
        let at = k.advance::<true, true, true>(0.0, 0.0, -0.5);
        assert_eq!((at.xi, at.velocity), (0.0, 0.0));
        let past = k.advance::<true, true, true>(0.0, 0.0, (-0.5_f64).next_down());
        assert!(past.velocity < 0.0 && past.xi < 0.0);
    }
}
