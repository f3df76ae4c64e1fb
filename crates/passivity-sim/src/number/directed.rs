//! Operations rounded down or up, as an end of an interval needs them.

use super::double::Double;
use super::real::Real;

/// A number whose operations can be rounded down or up.
pub trait Directed: Real {
    /// a + b, rounded.
    #[must_use]
    fn add_rounded(&self, other: &Self, up: bool) -> Self;
    /// a·b, rounded.
    #[must_use]
    fn mul_rounded(&self, other: &Self, up: bool) -> Self;
    /// a/b for b ≠ 0, rounded.
    #[must_use]
    fn div_rounded(&self, other: &Self, up: bool) -> Self;
    /// The undefined value.
    #[must_use]
    fn undefined() -> Self;
}

/// The rounding error of a double's operation decides which neighbour is the outward one.
fn outward(result: f64, error: f64, up: bool) -> f64 {
    if up && error > 0.0 {
        result.next_up()
    } else if !up && error < 0.0 {
        result.next_down()
    } else {
        result
    }
}

/// a·b − fl(a·b), exactly, when nothing under- or overflows (Veltkamp, Dekker).
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2)
}

/// Whether the magnitude is one at which [`product_error`] is exact.
fn ordinary(x: f64) -> bool {
    matches!(x.abs(), 1e-140..1e140)
}

impl Directed for Double {
    fn add_rounded(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (self.0, other.0);
        let sum = a + b;
        // Knuth's exact error of a sum; it does not underflow.
        let from_b = sum - a;
        let error = (a - (sum - from_b)) + (b - from_b);
        Self(outward(sum, error, up))
    }

    fn mul_rounded(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (self.0, other.0);
        let product = a * b;
        if (a == 0.0 && !b.is_nan()) || (b == 0.0 && !a.is_nan()) {
            return Self(0.0); // An end that is infinite stands for numbers without bound.
        }
        if ordinary(a) && ordinary(b) {
            return Self(outward(product, product_error(a, b, product), up));
        }
        // Out of the range in which the error is exact: one ulp, whichever way it went.
        Self(outward(product, if up { 1.0 } else { -1.0 }, up))
    }

    fn div_rounded(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (self.0, other.0);
        let quotient = a / b;
        if a == 0.0 && !b.is_nan() {
            return Self(0.0);
        }
        if ordinary(a) && ordinary(b) && ordinary(quotient) {
            // a − quotient·b, whose sign against b's is that of the error.
            let product = quotient * b;
            let rest = (a - product) - product_error(quotient, b, product);
            return Self(outward(quotient, rest * b.signum(), up));
        }
        Self(outward(quotient, if up { 1.0 } else { -1.0 }, up))
    }

    fn undefined() -> Self {
        Self(f64::NAN)
    }
}
