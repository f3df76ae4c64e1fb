//! Polynomials in one variable with rational coefficients.
//!
//! What a controller costs at a frequency θ is a quotient of two polynomials in x = cos θ
//! (TH-LTI), so that a question about every frequency is one about a polynomial on [−1, 1].

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::whole;

/// A polynomial a₀ + a₁x + a₂x² + … with exact rational coefficients.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar, polynomial::Polynomial};
///
/// let [one, two] = [1, 2].map(BigRational::integer);
/// let line = Polynomial::new([one.clone(), two.clone()]); // 1 + 2x
/// assert_eq!((&line * &line).at(&one), BigRational::integer(9));
/// assert_eq!(line.degree(), Some(1));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    /// Of x⁰, x¹, …, times the denominator; the last one is not zero.
    numerators: Vec<BigInt>,
    /// Above zero, and without a divisor that all numerators have; one of the polynomial that is zero.
    denominator: BigInt,
}

impl Polynomial {
    /// The polynomial with these coefficients of x⁰, x¹, …
    #[must_use]
    pub fn new(coefficients: impl IntoIterator<Item = BigRational>) -> Self {
        let coefficients: Vec<_> = coefficients.into_iter().collect();
        let (numerators, denominator) = whole::over_common(&coefficients);
        Self::over(numerators, denominator)
    }

    /// The polynomial with these coefficients over a denominator, which must be above zero.
    fn over(mut numerators: Vec<BigInt>, mut denominator: BigInt) -> Self {
        while numerators.last().is_some_and(|c| c.is_zero()) {
            numerators.pop();
        }
        let divisor = common_factor(denominator.clone(), &numerators);
        if !divisor.is_one() {
            divide(&mut numerators, &divisor);
            denominator /= divisor;
        }
        Self {
            numerators,
            denominator,
        }
    }

    /// A number, as a polynomial.
    #[must_use]
    pub fn constant(number: BigRational) -> Self {
        Self::new([number])
    }

    /// Σ aₖ cos kθ as a polynomial in x = cos θ, from a₀, a₁, …
    ///
    /// By the Chebyshev polynomials Tₖ(cos θ) = cos kθ: T₀ = 1, T₁ = x, Tₖ₊₁ = 2xTₖ − Tₖ₋₁.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar, polynomial::Polynomial};
    ///
    /// let [zero, one] = [0, 1].map(BigRational::integer);
    /// // cos 2θ = 2cos²θ − 1.
    /// let doubled = Polynomial::of_cosines(&[zero.clone(), zero.clone(), one]);
    /// assert_eq!(doubled, Polynomial::new([-1, 0, 2].map(BigRational::integer)));
    /// ```
    #[must_use]
    pub fn of_cosines(series: &[BigRational]) -> Self {
        let one = BigRational::one();
        let twice_x = Self::new([BigRational::zero(), &one + &one]);
        let x = Self::new([BigRational::zero(), one.clone()]);
        // T₋₁ = T₁, so that the recurrence gives T₁ as well.
        let (mut before, mut now) = (x, Self::constant(one));
        let mut sum = Self::new([]);
        for a in series {
            sum = &sum + &now.scaled(a);
            let next = &(&twice_x * &now) - &before;
            before = core::mem::replace(&mut now, next);
        }
        sum
    }

    /// The coefficients of x⁰, x¹, …, the last of which is not zero.
    #[must_use]
    pub fn coefficients(&self) -> Vec<BigRational> {
        let numerators = self.numerators.iter().cloned();
        let coefficients = numerators.map(|a| whole::fraction(a, self.denominator.clone()));
        coefficients.collect()
    }

    /// The degree; `None` of the polynomial that is zero.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.numerators.len().checked_sub(1)
    }

    /// Whether the polynomial is zero everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerators.is_empty()
    }

    /// The value at x.
    #[must_use]
    pub fn at(&self, x: &BigRational) -> BigRational {
        let (numerator, denominator) = self.written_at(x).into_raw();
        whole::fraction(numerator, denominator)
    }

    /// How the value at x compares with zero, without the value in lowest terms.
    #[must_use]
    pub fn sign_at(&self, x: &BigRational) -> Ordering {
        self.written_at(x).numer().cmp(&BigInt::ZERO)
    }

    /// The value at x, not in lowest terms: Σ aₖnᵏdᵐ⁻ᵏ over dᵐ times the denominator, of the numerators aₖ and x = n/d.
    pub(crate) fn written_at(&self, x: &BigRational) -> BigRational {
        let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
        for (k, a) in self.numerators.iter().rev().enumerate() {
            if k > 0 {
                power *= x.denom();
            }
            sum = sum * x.numer() + a * &power;
        }
        BigRational::new_raw(sum, power * &self.denominator)
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let terms = self.numerators.iter().zip(0_u32..).skip(1);
        Self::over(
            terms.map(|(a, k)| a * k).collect(),
            self.denominator.clone(),
        )
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &BigRational) -> Self {
        Self::over(
            self.numerators.iter().map(|a| a * factor.numer()).collect(),
            &self.denominator * factor.denom(),
        )
    }

    /// Quotient and remainder of a division; `None` when the divisor is zero.
    #[must_use]
    pub fn divided_by(&self, divisor: &Self) -> Option<(Self, Self)> {
        let ([quotient, rest], scale) = pseudo_division(&self.numerators, &divisor.numerators)?;
        let denominator = scale * &self.denominator;
        let quotient = quotient.iter().map(|a| a * &divisor.denominator);
        Some((
            Self::over(quotient.collect(), denominator.clone()),
            Self::over(rest, denominator),
        ))
    }

    /// A positive multiple of the remainder of a division, with whole coprime coefficients; zero of
    /// a division by zero.
    #[must_use]
    pub fn remainder(&self, divisor: &Self) -> Self {
        match pseudo_division(&self.numerators, &divisor.numerators) {
            Some(([_, rest], _)) => Self::over(rest, BigInt::one()).primitive(),
            None => Self::new([]),
        }
    }

    /// The positive multiple whose coefficients are whole and have no common divisor.
    ///
    /// Two polynomials have the same one exactly when one is a positive multiple of the other.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let mut numerators = self.numerators.clone();
        let divisor = common_factor(BigInt::ZERO, &numerators);
        if !divisor.is_one() {
            divide(&mut numerators, &divisor);
        }
        Self {
            numerators,
            denominator: BigInt::one(),
        }
    }

    /// Whether the polynomial is above zero everywhere on [−1, 1], or below zero somewhere in it, where that is easily
    /// seen: for all but those that come very near to zero, and do not cross it.
    ///
    /// With x = −1 + 2t and t = 1/(1 + s), s ≥ 0, it is Σ aₖ(1 + s)ⁿ⁻ᵏ over (1 + s)ⁿ, from the value at the upper end to that
    /// at the lower one. It is above zero where all of its coefficients by s are; where only some are, each half of the
    /// interval is looked at.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar, polynomial::Polynomial};
    ///
    /// let of = |coefficients: [i32; 3]| Polynomial::new(coefficients.map(BigRational::integer));
    /// assert_eq!(of([2, 0, -1]).is_plainly_positive(), Some(true)); // 2 − x²
    /// assert_eq!(of([-1, 0, 5]).is_plainly_positive(), Some(false));
    /// assert_eq!(of([1, 0, -1]).is_plainly_positive(), None); // zero at both ends
    /// ```
    #[must_use]
    pub fn is_plainly_positive(&self) -> Option<bool> {
        let mut from_end = self.numerators.clone();
        shift(&mut from_end, |slot, next| *slot -= next);
        for (slot, k) in from_end.iter_mut().zip(0_u32..) {
            *slot <<= k;
        }
        let mut pieces = vec![from_end];
        let mut left = MOST_PIECES;
        while !pieces.is_empty() {
            left = left.checked_sub(pieces.len())?;
            let mut halves = Vec::new();
            for piece in pieces {
                let mut reversed: Vec<BigInt> = piece.iter().rev().cloned().collect();
                shift(&mut reversed, |slot, next| *slot += next);
                if reversed.first()?.is_negative() || reversed.last()?.is_negative() {
                    return Some(false);
                }
                if reversed.iter().all(|c| c.is_positive()) {
                    continue;
                }
                let mut half = piece;
                for (slot, k) in half.iter_mut().rev().zip(0_u32..) {
                    *slot <<= k;
                }
                let mut other = half.clone();
                shift(&mut other, |slot, next| *slot += next);
                halves.extend([half, other]);
            }
            pieces = halves;
        }
        Some(true)
    }

    /// The greatest common divisor of two polynomials, with whole coprime coefficients; its sign is
    /// not determined.
    #[must_use]
    pub fn common_divisor(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.primitive(), other.primitive());
        while !b.is_zero() {
            let rest = a.remainder(&b);
            a = core::mem::replace(&mut b, rest);
        }
        a
    }

    fn zip_with(&self, other: &Self, f: impl Fn(BigInt, BigInt) -> BigInt) -> Self {
        let common = whole::least_multiple(&self.denominator, &other.denominator);
        let length = self.numerators.len().max(other.numerators.len());
        let over = |of: &Self| {
            let factor = &common / &of.denominator;
            let mut numerators: Vec<_> = of.numerators.iter().map(|a| a * &factor).collect();
            numerators.resize(length, BigInt::ZERO);
            numerators
        };
        let terms = over(self).into_iter().zip(over(other));
        Self::over(terms.map(|(a, b)| f(a, b)).collect(), common)
    }
}

/// In how many pieces [−1, 1] is looked at, at most.
const MOST_PIECES: usize = 512;

/// The coefficients by y of a polynomial in x = y + 1, or in x = y − 1 where `step` takes the next one off.
fn shift(coefficients: &mut [BigInt], step: impl Fn(&mut BigInt, &BigInt)) {
    for from in 0..coefficients.len() {
        for i in (from + 1..coefficients.len()).rev() {
            if let [slot, next] = coefficients.get_mut(i - 1..=i).unwrap_or_default() {
                step(slot, next);
            }
        }
    }
}

/// Quotient and remainder of the division of one polynomial by another, both times the same positive number, and
/// that number: so that all coefficients are whole. `None` when the divisor is zero.
fn pseudo_division(dividend: &[BigInt], divisor: &[BigInt]) -> Option<([Vec<BigInt>; 2], BigInt)> {
    let (leading, others) = divisor.split_last()?;
    let mut rest = dividend.to_vec();
    let mut quotient: Vec<BigInt> = Vec::new();
    let mut scale = BigInt::one();
    let size = leading.abs();
    while let Some(from) = rest.len().checked_sub(divisor.len()) {
        let Some(mut factor) = rest.pop() else { break };
        if leading.is_negative() {
            factor = -factor;
        }
        for slot in rest.iter_mut().chain(&mut quotient) {
            *slot *= &size;
        }
        for (slot, a) in rest.iter_mut().skip(from).zip(others) {
            *slot -= &factor * a;
        }
        quotient.push(factor);
        scale *= &size;
    }
    quotient.reverse();
    Some(([quotient, rest], scale))
}

/// The greatest common divisor of a number and of the numbers of a list.
fn common_factor(number: BigInt, list: &[BigInt]) -> BigInt {
    let mut divisor = number;
    for a in list {
        if divisor.is_one() {
            break;
        }
        divisor = whole::gcd(&divisor, a);
    }
    divisor
}

/// Divides the numbers of a list by a common divisor.
fn divide(list: &mut [BigInt], divisor: &BigInt) {
    for a in list {
        *a /= divisor;
    }
}

impl Add for &Polynomial {
    type Output = Polynomial;
    fn add(self, other: Self) -> Polynomial {
        self.zip_with(other, |a, b| a + b)
    }
}

impl Sub for &Polynomial {
    type Output = Polynomial;
    fn sub(self, other: Self) -> Polynomial {
        self.zip_with(other, |a, b| a - b)
    }
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        let mut product = vec![BigInt::ZERO; self.numerators.len() + other.numerators.len()];
        for (i, a) in self.numerators.iter().enumerate() {
            for (slot, b) in product.iter_mut().skip(i).zip(&other.numerators) {
                *slot += a * b;
            }
        }
        Polynomial::over(product, &self.denominator * &other.denominator)
    }
}
