//! Exact fractions that are never reduced: signs by cross-multiplication, no gcd.
//!
//! A verdict needs the sign of a polynomial, not its lowest terms, and a greatest common divisor
//! costs more than the polynomial. [`Fixed`] is the fast instance, over checked 128-bit integers;
//! [`Wide`] is the same text over big integers and never overflows. What they compute is exact, or
//! undefined (NUM-EXACT).

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};

use crate::scalar::{Ordered, Scalar};
use crate::whole;

/// An integer type that fractions can be made of: every operation that may overflow is checked.
pub trait Integer: Clone + PartialEq {
    /// The integer `n`.
    fn from_i32(n: i32) -> Self;
    /// The sum, or `None` on overflow.
    fn add(&self, other: &Self) -> Option<Self>;
    /// The difference, or `None` on overflow.
    fn sub(&self, other: &Self) -> Option<Self>;
    /// The product, or `None` on overflow.
    fn mul(&self, other: &Self) -> Option<Self>;
    /// The quotient rounded down, or `None` unless `divisor` is above zero.
    fn div_floor(&self, divisor: &Self) -> Option<Self>;
    /// How the value compares with zero, or `None` where that cannot be told.
    fn signum(&self) -> Option<Ordering>;
    /// Half of the value when it is even.
    fn halved(&self) -> Option<Self>;
    /// How the value compares with `other`, or `None` where that cannot be told.
    fn compare(&self, other: &Self) -> Option<Ordering> {
        self.sub(other)?.signum()
    }
    /// A numerator and a denominator of the same quotient, without their common factors where these are
    /// worth looking for. The sign of the denominator stays.
    fn shortened(numerator: Self, denominator: Self) -> (Self, Self) {
        (numerator, denominator)
    }
}

macro_rules! machine_integer {
    ($($int:ty),*) => {$(
        impl Integer for $int {
            fn from_i32(n: i32) -> Self {
                Self::from(n)
            }
            fn add(&self, other: &Self) -> Option<Self> {
                self.checked_add(*other)
            }
            fn sub(&self, other: &Self) -> Option<Self> {
                self.checked_sub(*other)
            }
            fn mul(&self, other: &Self) -> Option<Self> {
                self.checked_mul(*other)
            }
            #[cfg_attr(prusti, prusti_contracts::ensures(*divisor <= 0 ==> result.is_none()))]
            fn div_floor(&self, divisor: &Self) -> Option<Self> {
                // With a positive divisor the Euclidean quotient is the floor.
                if *divisor > 0 { self.checked_div_euclid(*divisor) } else { None }
            }
            fn signum(&self) -> Option<Ordering> {
                Some(self.cmp(&0))
            }
            fn compare(&self, other: &Self) -> Option<Ordering> {
                Some(self.cmp(other))
            }
            #[cfg_attr(prusti, prusti_contracts::ensures(*self % 2 != 0 ==> result.is_none()))]
            fn halved(&self) -> Option<Self> {
                if self & 1 == 0 { self.checked_div_euclid(2) } else { None }
            }
        }
    )*};
}
machine_integer!(i32, i64, i128);

impl Integer for BigInt {
    fn from_i32(n: i32) -> Self {
        Self::from(n)
    }
    fn add(&self, other: &Self) -> Option<Self> {
        Some(self + other)
    }
    fn sub(&self, other: &Self) -> Option<Self> {
        Some(self - other)
    }
    fn mul(&self, other: &Self) -> Option<Self> {
        Some(self * other)
    }
    fn div_floor(&self, divisor: &Self) -> Option<Self> {
        divisor
            .is_positive()
            .then(|| num_integer::Integer::div_floor(self, divisor))
    }
    fn signum(&self) -> Option<Ordering> {
        Some(self.cmp(&Self::zero()))
    }
    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
    fn halved(&self) -> Option<Self> {
        self.is_even()
            .then(|| num_integer::Integer::div_floor(self, &Self::from(2)))
    }
    fn shortened(numerator: Self, denominator: Self) -> (Self, Self) {
        let divisor = whole::gcd(&numerator, &denominator);
        if divisor.is_zero() || divisor.is_one() {
            return (numerator, denominator);
        }
        (numerator / &divisor, denominator / divisor)
    }
}

/// An exact fraction that is not kept in lowest terms.
///
/// The denominator is above zero; a fraction whose computation overflowed, or divided by zero, is
/// *undefined* and stays so.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar};
///
/// let third = Fixed::new(1, 3);
/// assert_eq!(third + third + third, Fixed::integer(1));
/// assert_eq!(Fixed::new(-7, 2).floor(), Fixed::integer(-4));
/// assert!(!Fixed::new(1, 0).is_defined());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Fraction<I> {
    /// `None` is the undefined value.
    value: Option<(I, I)>,
}

/// Exact fractions of checked 128-bit integers: fast, and undefined on overflow.
///
/// How large the numbers may be is said where it matters: see [`ledger::row`](crate::ledger::row).
pub type Fixed = Fraction<i128>;

/// Exact fractions of big integers: never undefined but for a division by zero.
pub type Wide = Fraction<BigInt>;

impl<I: Integer> Fraction<I> {
    /// The fraction `numerator / denominator`; undefined when the denominator is zero, or when
    /// moving its sign to the numerator overflows.
    #[must_use]
    pub fn new(numerator: I, denominator: I) -> Self {
        let zero = I::from_i32(0);
        let value = match denominator.signum() {
            Some(Ordering::Greater) => Some((numerator, denominator)),
            Some(Ordering::Equal) | None => None,
            Some(Ordering::Less) => zero.sub(&numerator).zip(zero.sub(&denominator)),
        };
        Self { value }
    }

    /// Whether the value is defined: nothing overflowed and nothing was divided by zero.
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::pure)]
    pub const fn is_defined(&self) -> bool {
        self.value.is_some()
    }

    /// Numerator and denominator as they are, not reduced; `None` when undefined.
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::ensures(result.is_some() == self.is_defined()))]
    pub const fn parts(&self) -> Option<(&I, &I)> {
        match &self.value {
            Some((n, d)) => Some((n, d)),
            None => None,
        }
    }

    const UNDEFINED: Self = Self { value: None };

    fn from_parts(value: Option<(I, I)>) -> Self {
        Self { value }
    }

    /// Applies `f` to the numerators over the common denominator.
    fn over_common(self, other: Self, f: impl Fn(&I, &I) -> Option<I>) -> Option<(I, I)> {
        let ((n, d), (m, e)) = self.value.zip(other.value)?;
        if d == e {
            return f(&n, &m).map(|n| (n, d));
        }
        // Adding nothing makes no number longer.
        let zero = I::from_i32(0);
        if m == zero {
            return Some((n, d));
        }
        if n == zero {
            return f(&zero, &m).map(|m| (m, e));
        }
        let numerator = f(&n.mul(&e)?, &m.mul(&d)?)?;
        Some((numerator, d.mul(&e)?))
    }
}

impl<I: Integer> Add for Fraction<I> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::from_parts(self.over_common(other, |a, b| a.add(b)))
    }
}

impl<I: Integer> Sub for Fraction<I> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::from_parts(self.over_common(other, |a, b| a.sub(b)))
    }
}

impl<I: Integer> Mul for Fraction<I> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = |((n, d), (m, e)): ((I, I), (I, I))| n.mul(&m).zip(d.mul(&e));
        Self::from_parts(self.value.zip(other.value).and_then(product))
    }
}

impl<I: Integer> Neg for Fraction<I> {
    type Output = Self;
    fn neg(self) -> Self {
        let zero = I::from_i32(0);
        Self::from_parts(self.value.and_then(|(n, d)| Some((zero.sub(&n)?, d))))
    }
}

impl<I: Integer> Scalar for Fraction<I> {
    fn integer(n: i32) -> Self {
        Self::from_parts(Some((I::from_i32(n), I::from_i32(1))))
    }

    fn half(self) -> Self {
        // Halving an even numerator keeps the denominator small at no cost.
        let halve = |(n, d): (I, I)| match n.halved() {
            Some(h) => Some((h, d)),
            None => d.mul(&I::from_i32(2)).map(|d| (n, d)),
        };
        Self::from_parts(self.value.and_then(halve))
    }

    fn shortened(self) -> Self {
        Self::from_parts(self.value.map(|(n, d)| I::shortened(n, d)))
    }

    fn floor(&self) -> Self {
        let floor = |(n, d): &(I, I)| Some((n.div_floor(d)?, I::from_i32(1)));
        Self::from_parts(self.value.as_ref().and_then(floor))
    }

    fn abs(&self) -> Self {
        match self.sign() {
            Some(Ordering::Less) => -self.clone(),
            Some(_) => self.clone(),
            None => Self::UNDEFINED,
        }
    }

    fn max(self, other: Self) -> Self {
        match self.compare(&other) {
            Some(Ordering::Less) => other,
            Some(_) => self,
            None => Self::UNDEFINED,
        }
    }

    fn min(self, other: Self) -> Self {
        match self.compare(&other) {
            Some(Ordering::Greater) => other,
            Some(_) => self,
            None => Self::UNDEFINED,
        }
    }

    fn over(self, divisor: Self) -> Self {
        let quotient = |((n, d), (m, e)): ((I, I), (I, I))| n.mul(&e).zip(d.mul(&m));
        match self.value.zip(divisor.value).and_then(quotient) {
            Some((n, d)) => Self::new(n, d),
            None => Self::UNDEFINED,
        }
    }
}

impl<I: Integer> Ordered for Fraction<I> {
    #[cfg_attr(prusti, prusti_contracts::ensures(result.is_some() ==> self.is_defined()))]
    fn sign(&self) -> Option<Ordering> {
        self.value.as_ref().and_then(|(n, _)| n.signum())
    }

    fn compare(&self, other: &Self) -> Option<Ordering> {
        let ((n, d), (m, e)) = self.value.as_ref().zip(other.value.as_ref())?;
        if d == e {
            return n.compare(m);
        }
        n.mul(e)?.compare(&m.mul(d)?)
    }
}

/// Equal as numbers, not as pairs; an undefined value equals nothing.
impl<I: Integer> PartialEq for Fraction<I> {
    fn eq(&self, other: &Self) -> bool {
        self.compare(other) == Some(Ordering::Equal)
    }
}

impl<I: Integer> PartialOrd for Fraction<I> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.compare(other)
    }
}

impl Wide {
    /// The fraction in lowest terms with big integers, as the pair (numerator, denominator);
    /// `None` when undefined.
    #[must_use]
    pub fn reduced(&self) -> Option<(BigInt, BigInt)> {
        let (n, d) = self.parts()?;
        let divisor = whole::gcd(n, d);
        if divisor.is_one() {
            return Some((n.clone(), d.clone()));
        }
        Integer::div_floor(n, &divisor).zip(Integer::div_floor(d, &divisor))
    }
}
