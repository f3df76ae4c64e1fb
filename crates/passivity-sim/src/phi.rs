//! The functions of the motion between samples, without cancellation and without a case β = 0.
//!
//! φ₁(z) = (eᶻ − 1)/z and φ₂(z) = (eᶻ − 1 − z)/z² carry a whole interval. What happens before and
//! after a reversal needs no exponential and no logarithm of its own: with
//! H(x) = Σ xⁿ/(n + 2) = (−ln(1 − x) − x)/x² and K(x) = Σ xⁿ/(n + 3), a device that starts with
//! speed v₀ against a force of deceleration −v₀/r travels v₀·r·H(−λr) until it stops, and one that
//! starts from rest travels a·f²·H(λf) while it reaches the speed a·f.

/// Largest |x| for which [`h`] and [`k`] are the series alone; x < 1/15.5 holds for λ ≤ 1/16.
///
/// The first term left out is x¹³/15, below 2⁻⁵⁵ of the sum.
pub(crate) const SERIES: f64 = 0.0645;

/// Largest λ for which every argument of [`h`] is within [`SERIES`]: e^(1/16) − 1 < 0.0645.
pub(crate) const SMALL_LAMBDA: f64 = 0.0625;

/// Largest λ for which [`h_medium`] takes over: s = tanh(λ/2) < ¼ then, see there.
pub(crate) const MEDIUM_LAMBDA: f64 = 0.5;

/// φ₁(z) = (eᶻ − 1)/z, 1 at z = 0; relative error a few ulp.
#[must_use]
pub(crate) fn phi1(z: f64) -> f64 {
    if z == 0.0 {
        return 1.0; // 0/0 otherwise; every other z, however small, takes the formula.
    }
    z.exp_m1() / z
}

/// φ₂(z) = (eᶻ − 1 − z)/z², ½ at z = 0; relative error a few ulp for z ≤ 1.
#[must_use]
pub(crate) fn phi2(z: f64) -> f64 {
    if z.abs() > 1.0 {
        // −z ≥ 1 dominates |eᶻ − 1| < 1: nothing cancels.
        return (z.exp_m1() - z) / z / z;
    }
    // Terms z^n/(n + 2)!, up to 1/20! < 2⁻⁶¹.
    series(z, 18, |n| 1.0 / f64::from(n + 2))
}

/// χ(z) = ∫₀¹ (sφ₁(zs))² ds = (1 − 2φ₁(z) + φ₁(2z))/z², ⅓ at z = 0.
#[must_use]
pub(crate) fn chi(z: f64) -> f64 {
    if z.abs() > 1.0 {
        return (1.0 - 2.0 * phi1(z) + phi1(2.0 * z)) / z / z;
    }
    // Σ (2ⁿ⁺² − 2)/(n + 3)!·zⁿ; the last term taken is 2³²/33! of the first.
    let mut sum = 0.0;
    let mut term = 1.0 / 6.0; // zⁿ/(n + 3)!
    let mut power = 4.0; // 2ⁿ⁺²
    for n in 0..30 {
        sum += (power - 2.0) * term;
        term *= z / f64::from(n + 4);
        power *= 2.0;
    }
    sum
}

/// Σ of `terms` terms, each the one before times z·`ratio`(n), starting from ½.
fn series(z: f64, terms: i32, ratio: impl Fn(i32) -> f64) -> f64 {
    let mut term = 0.5;
    let mut sum = term;
    for n in 1..terms {
        term *= z * ratio(n);
        sum += term;
    }
    sum
}

/// H(x) = Σ xⁿ/(n + 2) for |x| ≤ [`SERIES`]: the very text of the scalar loop and of every lane.
///
/// Estrin's scheme: 12 terms deep in four dependent steps. No fused multiply-add, so that every
/// processor gives the same bits.
#[inline(always)]
#[must_use]
pub(crate) fn h_series(x: f64) -> f64 {
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    let a = (1.0 / 2.0 + x * (1.0 / 3.0)) + x2 * (1.0 / 4.0 + x * (1.0 / 5.0));
    let b = (1.0 / 6.0 + x * (1.0 / 7.0)) + x2 * (1.0 / 8.0 + x * (1.0 / 9.0));
    let c = (1.0 / 10.0 + x * (1.0 / 11.0)) + x2 * (1.0 / 12.0 + x * (1.0 / 13.0));
    (a + x4 * b) + x8 * (c + x4 * (1.0 / 14.0))
}

/// H(x) for 1 − √e ≤ x ≤ 1 − 1/√e, which is where it is wanted for λ ≤ ½; the same text in every lane.
///
/// With s = −x/(2 − x) the logarithm is −ln(1 − x) = −2·artanh(−s), and what cancels in H cancels by
/// hand: H = ½(1 − s)(1 − s(1 − s)·A(s²)) with A(q) = Σ qⁿ/(2n + 3). For x at its ends |s| = tanh ¼
/// < ¼, so the first term left out is s²⁶/29 < 2⁻⁵⁶.
#[inline(always)]
#[must_use]
pub(crate) fn h_medium(x: f64) -> f64 {
    let s = -x / (2.0 - x);
    let q = s * s;
    let q2 = q * q;
    let q4 = q2 * q2;
    let q8 = q4 * q4;
    let a = (1.0 / 3.0 + q * (1.0 / 5.0)) + q2 * (1.0 / 7.0 + q * (1.0 / 9.0));
    let b = (1.0 / 11.0 + q * (1.0 / 13.0)) + q2 * (1.0 / 15.0 + q * (1.0 / 17.0));
    let c = (1.0 / 19.0 + q * (1.0 / 21.0)) + q2 * (1.0 / 23.0 + q * (1.0 / 25.0));
    let sum = (a + q4 * b) + q8 * (c + q4 * (1.0 / 27.0));
    let rest = 1.0 - s;
    0.5 * rest * (1.0 - s * rest * sum)
}

/// K(x) = Σ xⁿ/(n + 3) for |x| ≤ [`SERIES`].
#[inline(always)]
#[must_use]
pub(crate) fn k_series(x: f64) -> f64 {
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    let a = (1.0 / 3.0 + x * (1.0 / 4.0)) + x2 * (1.0 / 5.0 + x * (1.0 / 6.0));
    let b = (1.0 / 7.0 + x * (1.0 / 8.0)) + x2 * (1.0 / 9.0 + x * (1.0 / 10.0));
    let c = (1.0 / 11.0 + x * (1.0 / 12.0)) + x2 * (1.0 / 13.0 + x * (1.0 / 14.0));
    (a + x4 * b) + x8 * (c + x4 * (1.0 / 15.0))
}

/// H(x) for every x < 1.
#[must_use]
pub(crate) fn h(x: f64) -> f64 {
    if x.abs() <= SERIES {
        return h_series(x);
    }
    if x.abs() < 0.5 {
        return tail(x, 2.0);
    }
    (-(-x).ln_1p() - x) / x / x
}

/// K(x) for every x < 1.
#[must_use]
pub(crate) fn k(x: f64) -> f64 {
    if x.abs() <= SERIES {
        return k_series(x);
    }
    if x.abs() < 0.5 {
        return tail(x, 3.0);
    }
    (h(x) - 0.5) / x
}

/// Σ xⁿ/(n + first) for |x| < ½, to 2⁻⁵⁶.
fn tail(x: f64, first: f64) -> f64 {
    // Horner, from the smallest term: 0.5⁵⁶/58 is out of sight.
    (0..56)
        .rev()
        .fold(0.0, |sum, n| sum * x + 1.0 / (f64::from(n) + first))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// φ₂ by its continued halving φ₂(2z) = ((1 + ½·2zφ₁… )…): checked against long series instead.
    fn exact_series(x: f64, first: u32) -> f64 {
        // Sum from the smallest term with 400 terms: |x| ≤ 0.9 leaves 0.9⁴⁰⁰ < 1e-18.
        (0..400)
            .rev()
            .fold(0.0, |sum, n| sum * x + 1.0 / f64::from(n + first))
    }

    #[test]
    fn h_and_k_meet_their_series_on_every_piece() {
        for i in -900..=900 {
            let x = f64::from(i) / 1000.0;
            // Each formula loses at most about 1/x² ≤ 4 ulp of a logarithm below 2.3: 2e-15.
            let (h_error, k_error) = (h(x) - exact_series(x, 2), k(x) - exact_series(x, 3));
            assert!(h_error.abs() < 4e-15 * h(x), "H({x}) off by {h_error}");
            assert!(k_error.abs() < 2e-14 * k(x), "K({x}) off by {k_error}");
        }
    }

    #[test]
    fn h_for_medium_lambda_is_h() {
        // From λr to λf at their ends for λ = ½. A dozen roundings of numbers up to 1, each ½ε.
        let ends = [-0.5_f64.exp_m1(), -(-0.5_f64).exp_m1()];
        for i in 0..=1000 {
            let x = ends[0] + (ends[1] - ends[0]) * f64::from(i) / 1000.0;
            let error = h_medium(x) - exact_series(x, 2);
            assert!(error.abs() < 6.0 * f64::EPSILON, "H({x}) off by {error:e}");
        }
        assert_eq!(h_medium(0.0), 0.5);
    }

    #[test]
    fn phi_functions_have_no_seam() {
        assert_eq!([phi1(0.0), phi1(-1e-300), phi2(0.0)], [1.0, 1.0, 0.5]);
        assert_eq!(phi1(f64::NEG_INFINITY), 0.0);
        assert!((phi2(-2.0) - (1.0 + (-2.0_f64).exp()) / 4.0).abs() < 1e-16);
        for edge in [-1.0_f64, 1.0] {
            let (inside, outside) = (edge, edge * (1.0 + 2.0 * f64::EPSILON));
            assert!((phi2(inside) - phi2(outside)).abs() < 4e-16);
            assert!((chi(inside) - chi(outside)).abs() < 4e-15);
        }
        assert_eq!(chi(0.0), 2.0 / 6.0);
        assert_eq!(phi2(-1e-320), 0.5);
        // ∫₀¹ (1 − e⁻ˢ)² ds = 2/e − e⁻²/2 − ½.
        let e = (-1.0_f64).exp();
        assert!((chi(-1.0) - (2.0 * e - e * e / 2.0 - 0.5)).abs() < 4e-16);
    }
}
