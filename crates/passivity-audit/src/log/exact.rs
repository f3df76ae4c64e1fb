//! Sums of doubles without rounding: the same however the terms are grouped.

use num_bigint::BigInt;
use passivity_core::BigRational;

use crate::log::running::near;

/// The exponent of the smallest double above zero: every double is a whole number of 2^−1074.
const LEAST: u32 = 1074;

/// How many bits apart the digits of the sum are.
const STRIDE: u32 = 32;

/// Enough digits for the largest double.
const DIGITS: usize = 67;

/// A sum of doubles, exactly. A term that is no finite number makes all of it none.
#[derive(Clone, Debug)]
pub(crate) struct ExactSum {
    /// The digit `k` counts 2^(32k − 1074). A term adds less than 2^85 to one of them: there is room for
    /// 2^42 terms.
    digits: Box<[i128; DIGITS]>,
    /// What came from other sums.
    other: BigInt,
    finite: bool,
}

impl Default for ExactSum {
    fn default() -> Self {
        Self {
            digits: Box::new([0; DIGITS]),
            other: BigInt::ZERO,
            finite: true,
        }
    }
}

impl ExactSum {
    /// Adds a term.
    pub(crate) fn add(&mut self, x: f64) {
        if !x.is_finite() {
            self.finite = false;
            return;
        }
        let bits = x.to_bits();
        let exponent = (bits >> 52) & 0x7ff;
        let fraction = bits & ((1 << 52) - 1);
        // Below the normal numbers the exponent is that of the least of them, without the leading one.
        let (mantissa, place) = match exponent {
            0 => (fraction, 0),
            e => (fraction | 1 << 52, e - 1),
        };
        let (digit, shift) = (place / u64::from(STRIDE), place % u64::from(STRIDE));
        let term = i128::from(mantissa) << shift;
        // A double's exponent leads to one of the digits.
        if let Some(slot) = usize::try_from(digit)
            .ok()
            .and_then(|digit| self.digits.get_mut(digit))
        {
            *slot += if x.is_sign_negative() { -term } else { term };
        }
    }

    /// Adds another sum.
    pub(crate) fn add_sum(&mut self, other: &Self) {
        self.other += other.whole();
        self.finite &= other.finite;
    }

    /// The sum, in 2^−1074.
    fn whole(&self) -> BigInt {
        let digits = self.digits.iter().rev();
        let own = digits.fold(BigInt::ZERO, |sum, digit| (sum << STRIDE) + digit);
        own + &self.other
    }

    /// The double nearest to the sum; NaN where a term was no finite number.
    pub(crate) fn value(&self) -> f64 {
        match self.finite {
            true => near(&BigRational::new(self.whole(), BigInt::from(1) << LEAST)),
            false => f64::NAN,
        }
    }

    /// The sum in 2^−1074 as digits; `None` where a term was no finite number.
    pub(crate) fn to_text(&self) -> Option<String> {
        self.finite.then(|| self.whole().to_string())
    }

    /// From what [`to_text`](Self::to_text) gives; `None` when it is no whole number.
    pub(crate) fn from_text(text: Option<&str>) -> Option<Self> {
        let other = match text {
            Some(text) => text.parse().ok()?,
            None => BigInt::ZERO,
        };
        Some(Self {
            other,
            finite: text.is_some(),
            ..Self::default()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_sum_is_exact_and_does_not_depend_on_its_order(
            terms in prop::collection::vec(prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL, 0..40),
            cut in 0..40_usize,
        ) {
            let terms: Vec<f64> = terms.into_iter().map(|x| x / 256.0).collect();
            let exact = |x: &f64| BigRational::from_float(*x).unwrap();
            let expected: BigRational = terms.iter().map(exact).sum();
            let mut whole = ExactSum::default();
            terms.iter().for_each(|x| whole.add(*x));
            let (mut first, mut second) = (ExactSum::default(), ExactSum::default());
            for (i, x) in terms.iter().enumerate().rev() {
                if i < cut { first.add(*x) } else { second.add(*x) }
            }
            let saved = second.to_text();
            first.add_sum(&ExactSum::from_text(saved.as_deref()).unwrap());
            prop_assert_eq!(whole.value().to_bits(), near(&expected).to_bits());
            prop_assert_eq!(first.to_text(), whole.to_text());
        }
    }

    #[test]
    fn what_is_no_number_spoils_the_sum() {
        let mut sum = ExactSum::default();
        sum.add(1.0);
        sum.add(f64::INFINITY);
        assert!(sum.value().is_nan());
        assert!(
            ExactSum::from_text(sum.to_text().as_deref())
                .unwrap()
                .value()
                .is_nan()
        );
    }
}
