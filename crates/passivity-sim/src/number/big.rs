//! Numbers of any precision, on `astro-float`'s correctly rounded +, −, × and ÷.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use astro_float_num::{BigFloat, Consts, Radix, RoundingMode, Sign};
use num_bigint::BigInt;
use passivity_core::{BigRational, Ordered, Scalar};

use super::directed::Directed;
use super::real::Real;

/// A binary floating-point number; operations round it to `bits` bits, to nearest unless a direction
/// is asked for.
///
/// The constants of the kernel's formulas have no precision of their own: their `bits` are 0, they
/// are exact, and an operation takes the precision of the other operand. What two of them make is
/// exact too, or undefined.
#[derive(Clone, Debug)]
pub struct Big {
    x: BigFloat,
    bits: usize,
}

/// An operation of the library, rounded to a precision.
type Operation = fn(&BigFloat, &BigFloat, usize, RoundingMode) -> BigFloat;

/// Bits in which constants are computed with each other: far more than the kernel's formulas ask for.
const CONSTANT_BITS: usize = 256;

/// The integer, exactly; NaN past the exponents of the format.
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
    match i32::try_from(words.len() * 64) {
        Ok(exponent) => BigFloat::from_words(&words, sign, exponent),
        Err(_) => BigFloat::nan(None),
    }
}

/// A rational number rounded in the direction of `mode`.
fn from_rational(x: &BigRational, bits: usize, mode: RoundingMode) -> BigFloat {
    let wide = |n: &BigInt| integer(n, bits);
    wide(x.numer()).div(&wide(x.denom()), bits, mode)
}

/// The nearest double, or close to it.
fn to_double(x: &BigFloat) -> f64 {
    let Some((words, _, sign, exponent, _)) = x.as_raw_parts() else {
        return if x.is_inf_pos() {
            f64::INFINITY
        } else if x.is_inf_neg() {
            f64::NEG_INFINITY
        } else {
            f64::NAN
        };
    };
    let mut from_the_top = words.iter().rev().copied();
    let Some(top) = from_the_top.next().filter(|top| *top != 0) else {
        return 0.0;
    };
    let below = from_the_top.next().map_or(0, u128::from);
    // The mantissa is a fraction in [½, 1): top·2⁻⁶⁴ + below·2⁻¹²⁸.
    let mantissa = (u128::from(top) << 64 | below) as f64 * (-128.0_f64).exp2();
    let half = f64::from(exponent / 2).exp2();
    let rest = f64::from(exponent - exponent / 2).exp2();
    let magnitude = mantissa * half * rest;
    if sign == Sign::Neg {
        -magnitude
    } else {
        magnitude
    }
}

const fn mode(up: bool) -> RoundingMode {
    if up {
        RoundingMode::Up
    } else {
        RoundingMode::Down
    }
}

impl Big {
    /// The nearest number of `bits` bits.
    pub(crate) fn new(x: &BigRational, bits: usize) -> Self {
        let x = from_rational(x, bits, RoundingMode::ToEven);
        Self { x, bits }
    }

    /// The nearest numbers of `bits` bits that are not above and not below `x`.
    pub(crate) fn around(x: &BigRational, bits: usize) -> [Self; 2] {
        [false, true].map(|up| Self {
            x: from_rational(x, bits, mode(up)),
            bits,
        })
    }

    /// The number in decimal, to about `digits` digits; `None` when it has no decimal form.
    pub(crate) fn decimal(&self, digits: usize) -> Option<String> {
        let mut constants = Consts::new().ok()?;
        let mut x = self.x.clone();
        // log₂ 10 < 3.33.
        let bits = (digits as f64 * 3.33).ceil() as usize;
        if bits < self.bits {
            x.set_precision(bits, RoundingMode::ToEven).ok()?;
        }
        x.format(Radix::Dec, RoundingMode::ToEven, &mut constants)
            .ok()
    }

    /// An operation of two numbers, rounded to the greater precision of the two; undefined for two
    /// constants whose result is not exact.
    fn operation(&self, other: &Self, operation: Operation, mode: RoundingMode) -> Self {
        let bits = self.bits.max(other.bits);
        let x = if bits > 0 {
            operation(&self.x, &other.x, bits, mode)
        } else {
            let x = operation(&self.x, &other.x, CONSTANT_BITS, mode);
            if x.inexact() { BigFloat::nan(None) } else { x }
        };
        Self { x, bits }
    }

    fn divided(&self, divisor: &Self, mode: RoundingMode) -> Self {
        if divisor.x.is_zero() {
            return Self {
                x: BigFloat::nan(None),
                bits: self.bits,
            };
        }
        self.operation(divisor, BigFloat::div, mode)
    }

    /// `self` or `other`, whichever compares as wanted, with the precision of both.
    fn choose(self, other: Self, unless: Ordering) -> Self {
        let bits = self.bits.max(other.bits);
        let x = match self.compare(&other) {
            Some(order) if order == unless => other.x,
            Some(_) => self.x,
            None => BigFloat::nan(None),
        };
        Self { x, bits }
    }
}

impl Add for Big {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.operation(&other, BigFloat::add, RoundingMode::ToEven)
    }
}

impl Sub for Big {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.operation(&other, BigFloat::sub, RoundingMode::ToEven)
    }
}

impl Mul for Big {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.operation(&other, BigFloat::mul, RoundingMode::ToEven)
    }
}

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            x: BigFloat::neg(&self.x),
            bits: self.bits,
        }
    }
}

impl Scalar for Big {
    fn integer(n: i32) -> Self {
        Self {
            x: BigFloat::from_i32(n, 64),
            bits: 0,
        }
    }

    fn half(self) -> Self {
        let mut half = BigFloat::from_i32(1, 64);
        half.set_exponent(0); // The mantissa of 1 is ½.
        self * Self { x: half, bits: 0 }
    }

    fn floor(&self) -> Self {
        Self {
            x: self.x.floor(),
            bits: self.bits,
        }
    }

    fn abs(&self) -> Self {
        Self {
            x: self.x.abs(),
            bits: self.bits,
        }
    }

    fn max(self, other: Self) -> Self {
        self.choose(other, Ordering::Less)
    }

    fn min(self, other: Self) -> Self {
        self.choose(other, Ordering::Greater)
    }

    fn over(self, divisor: Self) -> Self {
        self.divided(&divisor, RoundingMode::ToEven)
    }
}

impl Ordered for Big {
    fn sign(&self) -> Option<Ordering> {
        if self.x.is_nan() {
            None
        } else if self.x.is_zero() {
            Some(Ordering::Equal)
        } else if self.x.is_negative() {
            Some(Ordering::Less)
        } else {
            Some(Ordering::Greater)
        }
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(self.x.cmp(&other.x)?.cmp(&0))
    }
}

impl Real for Big {
    fn approximate(&self) -> f64 {
        to_double(&self.x)
    }

    fn is_defined(&self) -> bool {
        !self.x.is_nan()
    }

    fn bits(&self) -> u32 {
        // Precisions are of the methods' choice, none above 40 000 bits.
        u32::try_from(self.bits).unwrap_or(u32::MAX)
    }

    fn whole(&self, n: i32) -> Self {
        Self {
            bits: self.bits,
            ..Self::integer(n)
        }
    }
}

impl Directed for Big {
    fn add_rounded(&self, other: &Self, up: bool) -> Self {
        self.operation(other, BigFloat::add, mode(up))
    }

    fn mul_rounded(&self, other: &Self, up: bool) -> Self {
        self.operation(other, BigFloat::mul, mode(up))
    }

    fn div_rounded(&self, other: &Self, up: bool) -> Self {
        self.divided(other, mode(up))
    }

    fn undefined() -> Self {
        Self {
            x: BigFloat::nan(None),
            bits: 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn constants_are_exact_or_undefined_and_adopt_the_precision_of_the_other() {
        let [zero, one, three] = [0, 1, 3].map(Big::integer);
        let value = |x: &Big| (x.approximate(), x.bits);
        assert_eq!(value(&(one.clone() - zero.clone())), (1.0, 0));
        assert_eq!(value(&(three.clone() * one.clone().half())), (1.5, 0));
        assert_eq!(value(&three.clone().over(Big::integer(4))), (0.75, 0));
        assert!(!one.clone().over(three.clone()).is_defined());
        let two = Big::new(&BigRational::integer(2), 192);
        assert_eq!(value(&(zero.clone() * two.clone())), (0.0, 192));
        assert_eq!(value(&zero.max(two.clone())), (2.0, 192));
        let thirds = [two.ratio(1, 3), two.whole(1).over(three.clone())];
        let exact = BigRational::integer(1).over(BigRational::integer(3));
        for third in thirds {
            assert_eq!(third.compare(&Big::new(&exact, 192)), Some(Ordering::Equal));
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
