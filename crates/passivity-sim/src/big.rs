//! Numbers of any precision, on `astro-float`'s correctly rounded +, −, × and ÷.

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use astro_float_num::{BigFloat, Consts, Radix, RoundingMode, Sign};
use num_bigint::BigInt;
use passivity_core::BigRational;

use crate::real::{Real, Undecided};

/// A binary floating-point number with `bits` bits, rounded to nearest.
#[derive(Clone, Debug)]
pub struct Big {
    x: BigFloat,
    bits: usize,
}

/// The integer, exactly.
fn integer(n: &BigInt, bits: usize) -> BigFloat {
    let (sign, words) = n.to_u64_digits();
    if words.is_empty() {
        return BigFloat::from_word(0, bits);
    }
    let sign = if sign == num_bigint::Sign::Minus {
        Sign::Neg
    } else {
        Sign::Pos
    };
    let exponent = i32::try_from(words.len() * 64).unwrap_or(i32::MAX);
    BigFloat::from_words(&words, sign, exponent)
}

/// A rational number rounded in the direction of `mode`.
#[must_use]
pub fn from_rational(x: &BigRational, bits: usize, mode: RoundingMode) -> BigFloat {
    let wide = |n: &BigInt| integer(n, bits);
    wide(x.numer()).div(&wide(x.denom()), bits, mode)
}

/// The nearest double, or close to it.
#[must_use]
pub fn to_double(x: &BigFloat) -> f64 {
    let Some((words, _, sign, exponent, _)) = x.as_raw_parts() else {
        return f64::NAN;
    };
    let Some(&top) = words.last() else { return 0.0 };
    if top == 0 {
        return 0.0;
    }
    let below = words
        .len()
        .checked_sub(2)
        .and_then(|i| words.get(i))
        .copied()
        .unwrap_or(0);
    // The mantissa is a fraction in [½, 1): top·2⁻⁶⁴ + below·2⁻¹²⁸.
    let mantissa = (u128::from(top) << 64 | u128::from(below)) as f64 * (-128.0_f64).exp2();
    let half = f64::from(exponent / 2).exp2();
    let rest = f64::from(exponent - exponent / 2).exp2();
    let magnitude = mantissa * half * rest;
    if sign == Sign::Neg {
        -magnitude
    } else {
        magnitude
    }
}

impl Big {
    /// The nearest number of `bits` bits.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar};
    /// use passivity_sim::{big::Big, real::Real};
    ///
    /// let third = Big::new(&BigRational::integer(1).over(BigRational::integer(3)), 200);
    /// assert_eq!(third.approximate(), 1.0 / 3.0);
    /// assert!((third.clone() + third.clone() + third).compare(&Big::new(&BigRational::integer(1), 200)).is_ok());
    /// ```
    #[must_use]
    pub fn new(x: &BigRational, bits: usize) -> Self {
        Self {
            x: from_rational(x, bits, RoundingMode::ToEven),
            bits,
        }
    }

    /// The number in decimal, to about `digits` digits.
    #[must_use]
    pub fn decimal(&self, digits: usize) -> String {
        let Ok(mut constants) = Consts::new() else {
            return format!("{:e}", self.approximate());
        };
        let mut x = self.x.clone();
        // log₂ 10 < 3.33.
        let bits = (digits as f64 * 3.33).ceil() as usize;
        if bits < self.bits && x.set_precision(bits, RoundingMode::ToEven).is_err() {
            return format!("{:e}", self.approximate());
        }
        x.format(Radix::Dec, RoundingMode::ToEven, &mut constants)
            .unwrap_or_else(|_| format!("{:e}", self.approximate()))
    }

    fn with(&self, x: BigFloat) -> Self {
        Self { x, bits: self.bits }
    }
}

macro_rules! operator {
    ($trait:ident, $name:ident) => {
        impl $trait for Big {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                let x = self.x.$name(&other.x, self.bits, RoundingMode::ToEven);
                self.with(x)
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        self.with(BigFloat::neg(&self.x))
    }
}

/// The sign of a number that may be NaN.
pub(crate) fn sign(x: &BigFloat) -> Result<Ordering, Undecided> {
    if x.is_nan() {
        Err(Undecided)
    } else if x.is_zero() {
        Ok(Ordering::Equal)
    } else if x.is_negative() {
        Ok(Ordering::Less)
    } else {
        Ok(Ordering::Greater)
    }
}

impl Real for Big {
    fn ratio(&self, n: i32, m: i32) -> Self {
        let (n, m) = (BigFloat::from_i32(n, 64), BigFloat::from_i32(m, 64));
        self.with(n.div(&m, self.bits, RoundingMode::ToEven))
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        sign(&self.x)
    }

    fn floor(&self) -> Result<Self, Undecided> {
        Ok(self.with(self.x.floor()))
    }

    fn approximate(&self) -> f64 {
        to_double(&self.x)
    }

    fn bits(&self) -> u32 {
        u32::try_from(self.bits).unwrap_or(u32::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::Scalar;

    /// What is relied on: the basic operations round correctly, in every direction.
    #[test]
    fn operations_are_within_half_an_ulp_of_the_exact_ones() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            i64::try_from(seed >> 20).unwrap() - (1 << 43)
        };
        let exact = |x: &BigFloat| -> BigRational {
            let (words, _, sign, exponent, _) = x.as_raw_parts().unwrap();
            let digits: Vec<u32> = words
                .iter()
                .flat_map(|w| [*w as u32, (*w >> 32) as u32])
                .collect();
            let sign = if sign == Sign::Neg {
                num_bigint::Sign::Minus
            } else {
                num_bigint::Sign::Plus
            };
            let mantissa = BigRational::from_integer(BigInt::from_slice(sign, &digits));
            let shift = exponent - 64 * i32::try_from(words.len()).unwrap();
            mantissa * BigRational::integer(2).pow(shift)
        };
        for _ in 0..400 {
            let [n, m, p, q] = [random(), random(), random(), random()];
            let ratio = |n: i64, m: i64| BigRational::new(n.into(), m.abs().max(1).into());
            let (a, b) = (ratio(n, m), ratio(p | 1, q));
            for bits in [64, 128, 192] {
                let round = |x: &BigRational, mode| from_rational(x, bits, mode);
                let (x, y) = (
                    round(&a, RoundingMode::ToEven),
                    round(&b, RoundingMode::ToEven),
                );
                let (a, b) = (exact(&x), exact(&y));
                type Operation = fn(&BigFloat, &BigFloat, usize, RoundingMode) -> BigFloat;
                let results: [(BigRational, Operation); 4] = [
                    (&a + &b, |x, y, p, m| x.add(y, p, m)),
                    (&a - &b, |x, y, p, m| x.sub(y, p, m)),
                    (&a * &b, |x, y, p, m| x.mul(y, p, m)),
                    (&a / &b, |x, y, p, m| x.div(y, p, m)),
                ];
                for (want, operation) in results {
                    let down = exact(&operation(&x, &y, bits, RoundingMode::Down));
                    let up = exact(&operation(&x, &y, bits, RoundingMode::Up));
                    let near = exact(&operation(&x, &y, bits, RoundingMode::ToEven));
                    assert!(down <= want && want <= up, "{a} {b}");
                    assert!(down <= near && near <= up);
                    let ulp = BigRational::integer(2).pow(1 - i32::try_from(bits).unwrap());
                    assert!(&up - &down <= Scalar::abs(&want) * ulp);
                }
            }
        }
    }

    #[test]
    fn doubles_are_the_nearest() {
        for x in [0.0, 1.0, -0.1, 1e300, 1e-300, 3.0e-320, -123_456.789] {
            let big = Big::new(&BigRational::from_float(x).unwrap(), 192);
            assert_eq!(big.approximate(), x);
        }
    }
}
