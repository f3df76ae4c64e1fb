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

/// A denominator as 2^twos·5^fives, as those of decimals are: fractions with it are reduced without looking for a
/// common divisor.
#[derive(Default)]
pub(crate) struct Denominator {
    /// The denominator.
    pub(crate) of: i64,
    twos: u32,
    fives: u32,
    is_decimal: bool,
}

impl Denominator {
    pub(crate) fn new(of: i64) -> Self {
        let twos = of.trailing_zeros();
        let (mut rest, mut fives) = (of.checked_shr(twos).unwrap_or_default(), 0);
        while rest > 1 && rest % 5 == 0 {
            (rest, fives) = (rest / 5, fives + 1);
        }
        Self {
            of,
            twos,
            fives,
            is_decimal: rest == 1,
        }
    }

    /// A fraction with this denominator in lowest terms, n > 0; `None` where the prime factors are not known, or it is
    /// not above zero.
    #[inline(always)]
    pub(crate) fn reduced(&self, n: i64) -> Option<[u64; 2]> {
        if !self.is_decimal || n <= 0 {
            return None;
        }
        let twos = n.trailing_zeros().min(self.twos);
        let [mut n, mut d] = [n, self.of].map(|x| x.cast_unsigned() >> twos);
        for _ in 0..self.fives {
            if n % 5 != 0 {
                break;
            }
            (n, d) = (n / 5, d / 5);
        }
        Some([n, d])
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_fraction_is_in_lowest_terms_as_numbers_are(
            n in prop_oneof![1..i64::MAX, 1..5000_i64], twos in 0..40_u32, fives in 0..10_u32, more in 0..3_u32,
            of in prop_oneof![3 => Just(1_i64), 1 => 1..40_i64],
        ) {
            let d = (of * 5_i64.pow(fives)) << twos.min(30);
            for n in [n, n >> more << more, ((n % 5_000) * 5_i64.pow(fives)) << more, d, 1] {
                match (Denominator::new(d).reduced(n), Number::Small(n, d).reduced()) {
                    (Some([n, d]), Number::Small(m, e)) => {
                        prop_assert_eq!([n, d], [m.unsigned_abs(), e.unsigned_abs()]);
                    }
                    (found, _) => prop_assert!(found.is_none() && (of > 1 || n <= 0), "{} {}", n, d),
                }
            }
        }
    }
}
