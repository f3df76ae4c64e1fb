//! Sums, products and quotients of the numbers of a log, on machine integers where these hold them.

use passivity_core::Scalar as _;

use super::{Number, divisor};

/// a − b.
pub(crate) fn difference(a: &Number, b: &Number) -> Number {
    if let (Number::Small(n, d), Number::Small(m, e)) = (a, b) {
        let (n, d, m, e) = (
            i128::from(*n),
            i128::from(*d),
            i128::from(*m),
            i128::from(*e),
        );
        // Decimals and doubles have denominators of which one divides the other.
        let (numerator, denominator) = if d == e {
            (n - m, d)
        } else if e % d == 0 {
            (n * (e / d) - m, e)
        } else if d % e == 0 {
            (n - m * (d / e), d)
        } else {
            (n * e - m * d, d * e)
        };
        if let (Ok(n), Ok(d)) = (i64::try_from(numerator), i64::try_from(denominator)) {
            return Number::Small(n, d);
        }
    }
    Number::from(a.to_rational() - b.to_rational())
}

/// a·b.
pub(crate) fn product(a: &Number, b: &Number) -> Number {
    if let (Number::Small(n, d), Number::Small(m, e)) = (a, b) {
        let [n, d, m, e] = [*n, *d, *m, *e].map(i128::from);
        if let Some(product) = small(n * m, d * e) {
            return product;
        }
    }
    Number::from(a.to_rational() * b.to_rational())
}

/// n/d in lowest terms, d > 0, when 64 bits hold it.
pub(super) fn small(n: i128, d: i128) -> Option<Number> {
    let divisor = i128::try_from(divisor(n.unsigned_abs(), d.unsigned_abs())).ok()?;
    let n = i64::try_from(n / divisor).ok()?;
    Some(Number::Small(n, i64::try_from(d / divisor).ok()?))
}

/// a/b for b that is not zero, not in lowest terms.
pub(crate) fn quotient(a: &Number, b: &Number) -> Number {
    if let (Number::Small(n, d), Number::Small(m, e)) = (a, b) {
        let [n, d, m, e] = [*n, *d, *m, *e].map(i128::from);
        let (numerator, denominator) = (n * e * m.signum(), (d * m).abs());
        if let (Ok(n), Ok(d)) = (i64::try_from(numerator), i64::try_from(denominator)) {
            return Number::Small(n, d);
        }
        if let Some(quotient) = small(numerator, denominator) {
            return quotient;
        }
    }
    Number::from(a.to_rational().over(b.to_rational()))
}

/// Whether a < b.
#[inline]
pub(crate) fn is_less(a: &Number, b: &Number) -> bool {
    match (a, b) {
        (Number::Small(n, d), Number::Small(m, e)) => {
            i128::from(*n) * i128::from(*e) < i128::from(*m) * i128::from(*d)
        }
        _ => is_positive(&difference(b, a)),
    }
}

/// Whether a number is above zero.
#[must_use]
pub fn is_positive(x: &Number) -> bool {
    match x {
        Number::Small(n, _) | Number::Tiny(n, _) => *n > 0,
        Number::Big(x) => num_traits::Signed::is_positive(&**x),
    }
}
