//! The functions of the motion ([`crate::phi`]) for any [`Real`]: by their series, to the last bit asked for, with
//! what the series leaves out added to an interval. Only +, −, × and ÷ are relied on.

use crate::number::Real;

/// e^(−λ), φ₁(−λ), φ₂(−λ), φ₁(−2λ) and χ(−λ).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Functions<R> {
    /// e^(−λ).
    pub decay: R,
    /// φ₁(−λ).
    pub phi1: R,
    /// φ₂(−λ).
    pub phi2: R,
    /// φ₁(−2λ).
    pub double: R,
    /// χ(−λ).
    pub chi: R,
}

/// Halvings after which a number that is still above 1 has no end: an interval out to infinity.
const MOST_HALVINGS: i32 = 100_000;

/// The functions of a whole interval, for λ ≥ 0.
pub(crate) fn functions<R: Real>(lambda: &R) -> Functions<R> {
    let (phi1, phi2) = phi(lambda);
    let (double, _) = phi(&lambda.double());
    let chi = chi(lambda, &phi1, &double);
    // 1 − λφ₁ cancels for large λ: there the square of e^(−λ/2) does not.
    let decay = if lambda.approximate() > 1.0 {
        decaying(lambda)
    } else {
        R::one() - lambda.clone() * phi1.clone()
    };
    Functions {
        decay,
        phi1,
        phi2,
        double,
        chi,
    }
}

/// e^(−x) for x ≥ 0, by halving the argument and squaring.
fn decaying<R: Real>(x: &R) -> R {
    let mut halvings = 0;
    let mut small = x.clone();
    while small.approximate() > 1.0 && halvings < MOST_HALVINGS {
        small = small.half();
        halvings += 1;
    }
    let (phi1, _) = phi_series(&small);
    let mut e = R::one() - small * phi1;
    for _ in 0..halvings {
        e = e.square();
    }
    e
}

/// φ₁(−x) and φ₂(−x) for x ≥ 0.
pub(crate) fn phi<R: Real>(x: &R) -> (R, R) {
    if x.approximate() <= 1.0 {
        return phi_series(x);
    }
    let phi1 = (R::one() - decaying(x)).over(x.clone());
    let phi2 = (R::one() - phi1.clone()).over(x.clone());
    (phi1, phi2)
}

fn phi_series<R: Real>(x: &R) -> (R, R) {
    // Σ (−x)ⁿ/(n + 2)!, terms at most halving for x ≤ 1.
    let phi2 = sum(&x.ratio(1, 2), |n, term| {
        -(term.clone() * x.clone()) * x.ratio(1, n + 2)
    });
    (R::one() - x.clone() * phi2.clone(), phi2)
}

fn chi<R: Real>(x: &R, phi1: &R, double: &R) -> R {
    if x.approximate() > 1.0 {
        return (R::one() - phi1.double() + double.clone()).over(x.square());
    }
    // Σ (2ⁿ⁺² − 2)/(n + 3)!·(−x)ⁿ = 4·Σ (−2x)ⁿ/(n + 3)! − 2·Σ (−x)ⁿ/(n + 3)!.
    let part = |x: &R| {
        sum(&x.ratio(1, 6), |n, term| {
            -(term.clone() * x.clone()) * x.ratio(1, n + 3)
        })
    };
    R::integer(4) * part(&x.double()) - R::integer(2) * part(x)
}

/// Σ of terms, each made of the one before it, until they no longer count; they must at least halve
/// from the point on at which they fall below 2^−bits.
fn sum<R: Real>(first: &R, next: impl Fn(i32, &R) -> R) -> R {
    let least = first.approximate().abs() * (-f64::from(first.bits())).exp2() * 0.125;
    let mut term = first.clone();
    let mut total = first.clone();
    let mut n = 1;
    loop {
        term = next(n, &term);
        total = total + term.clone();
        n += 1;
        let size = term.approximate().abs();
        let endless = !size.is_finite(); // No series of such a number ends; its interval says so.
        if size <= least || size == 0.0 || endless {
            // What follows is at most as much as the last term again.
            return total.widened(&term).widened(&smallest(&term));
        }
    }
}

/// A bound of a term that a double shows as 0.
fn smallest<R: Real>(like: &R) -> R {
    // 2⁻¹⁰⁷⁴ and below; 2⁻¹⁰²⁰ is far below every 2^−bits of a double's interval.
    let tiny = like.ratio(1, 1 << 30);
    let mut power = R::one();
    if like.approximate() == 0.0 {
        for _ in 0..34 {
            power = power * tiny.clone();
        }
        return power;
    }
    R::zero()
}

/// Σ xⁿ/(n + `first`) for |x| ≤ ½: H with `first` = 2, K with `first` = 3.
fn tail<R: Real>(x: &R, first: i32) -> R {
    let size = x.approximate().abs().max(1e-300);
    // 2·sizeᴺ/(N + first) < 2^−bits/8.
    let count = (f64::from(x.bits()) + 5.0) / -size.log2();
    let count = count.ceil().clamp(1.0, 1e6) as i32;
    let mut total = R::zero();
    let mut power = R::one();
    for n in (0..count).rev() {
        total = total * x.clone() + x.ratio(1, n + first);
        power = power * x.clone();
    }
    let rest = power * x.ratio(2, count + first);
    total.widened(&rest)
}

/// H(x) = Σ xⁿ/(n + 2) for x ≤ ½, where −x may be large.
pub(crate) fn h<R: Real>(x: &R) -> R {
    if x.approximate().abs() <= 0.5 {
        return tail(x, 2);
    }
    (-(ln_1p(&-x.clone()) + x.clone())).over(x.square())
}

/// K(x) = Σ xⁿ/(n + 3) for x ≤ ½, where −x may be large.
pub(crate) fn k<R: Real>(x: &R) -> R {
    if x.approximate().abs() <= 0.5 {
        return tail(x, 3);
    }
    (h(x) - R::one().half()).over(x.clone())
}

/// ln(1 + w) for w ≥ 0.
pub(crate) fn ln_1p<R: Real>(w: &R) -> R {
    if w.approximate() <= 0.5 {
        // Σ (−w)ⁿ/(n + 1)·w.
        return w.clone() * tail(&-w.clone(), 1);
    }
    let mut y = R::one() + w.clone();
    let mut doublings = 0;
    while y.approximate() > 1.5 && doublings < MOST_HALVINGS {
        y = y.half();
        doublings += 1;
    }
    let ln2 = two_artanh(&w.ratio(1, 3));
    let s = (y.clone() - R::one()).over(y + R::one());
    two_artanh(&s) + ln2 * R::integer(doublings)
}

/// 2·artanh(s) for |s| ≤ ½.
fn two_artanh<R: Real>(s: &R) -> R {
    let square = s.square();
    let size = square.approximate().max(1e-300);
    let count = ((f64::from(s.bits()) + 5.0) / -size.log2())
        .ceil()
        .clamp(1.0, 1e6) as i32;
    let mut total = R::zero();
    let mut power = R::one();
    for n in (0..count).rev() {
        total = total * square.clone() + s.ratio(1, 2 * n + 1);
        power = power * square.clone();
    }
    let rest = power.double();
    s.double() * total.widened(&rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::Double;
    use crate::phi;

    #[test]
    fn in_doubles_they_are_the_fast_ones() {
        for lambda in [0.0, 1e-300, 1e-9, 0.01, 0.0625, 0.3, 1.0, 2.5, 30.0, 1e9] {
            let got = functions(&Double(lambda));
            let close = |a: f64, b: f64, ulps: f64| (a - b).abs() <= ulps * f64::EPSILON * b.abs();
            // e^(−30) by 5 squarings loses up to 2⁵ ulp.
            assert!(
                close(got.decay.0, (-lambda).exp(), 64.0) || lambda > 100.0,
                "{lambda}"
            );
            assert!(close(got.phi1.0, phi::phi1(-lambda), 4.0), "{lambda}");
            assert!(close(got.phi2.0, phi::phi2(-lambda), 8.0), "{lambda}");
            assert!(
                close(got.chi.0, phi::chi(-lambda), 32.0),
                "{lambda} {} {}",
                got.chi.0,
                phi::chi(-lambda)
            );
        }
        for x in [-20.0, -2.0, -0.4, -1e-3, -1e-200, 0.0, 1e-5, 0.06, 0.3, 0.5] {
            let scale = 8.0 * f64::EPSILON;
            assert!(
                (h(&Double(x)).0 - phi::h(x)).abs() <= scale * phi::h(x),
                "H({x})"
            );
            assert!(
                (k(&Double(x)).0 - phi::k(x)).abs() <= 8.0 * scale * phi::k(x),
                "K({x})"
            );
            assert!(
                (ln_1p(&Double(-x.min(0.0))).0 - (-x.min(0.0)).ln_1p()).abs() <= scale * x.abs()
            );
        }
    }
}
