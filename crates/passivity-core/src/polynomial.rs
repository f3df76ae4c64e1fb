//! Polynomials in one variable with rational coefficients.
//!
//! What a controller costs at a frequency θ is a quotient of two polynomials in x = cos θ
//! (TH-LTI), so that a question about every frequency is one about a polynomial on [−1, 1].

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::ops::{Add, Mul, Sub};

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

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
    /// Of x⁰, x¹, …; the last one is not zero.
    coefficients: Vec<BigRational>,
}

impl Polynomial {
    /// The polynomial with these coefficients of x⁰, x¹, …
    #[must_use]
    pub fn new(coefficients: impl IntoIterator<Item = BigRational>) -> Self {
        let mut coefficients: Vec<_> = coefficients.into_iter().collect();
        while coefficients.last().is_some_and(|c| c.is_zero()) {
            coefficients.pop();
        }
        Self { coefficients }
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
    pub fn coefficients(&self) -> &[BigRational] {
        &self.coefficients
    }

    /// The degree; `None` of the polynomial that is zero.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// Whether the polynomial is zero everywhere.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// The value at x.
    #[must_use]
    pub fn at(&self, x: &BigRational) -> BigRational {
        let [numerator, denominator] = self.fraction_at(x);
        BigRational::new(numerator, denominator)
    }

    /// How the value at x compares with zero, without the value in lowest terms.
    #[must_use]
    pub fn sign_at(&self, x: &BigRational) -> Ordering {
        let [numerator, _] = self.fraction_at(x);
        numerator.cmp(&BigInt::ZERO)
    }

    /// Numerator and denominator of the value at x; the denominator is above zero.
    fn fraction_at(&self, x: &BigRational) -> [BigInt; 2] {
        // Whole numbers only, over the common denominator: Σ aₖnᵏdᵐ⁻ᵏ / dᵐ at x = n/d.
        let common = self.common_denominator();
        let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
        for (k, a) in self.coefficients.iter().rev().enumerate() {
            if k > 0 {
                power *= x.denom();
            }
            let whole = a.numer() * (&common / a.denom());
            sum = sum * x.numer() + whole * &power;
        }
        [sum, common * power]
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let powers = (0_u32..).map(|k| BigRational::from_integer(BigInt::from(k)));
        Self::new(
            self.coefficients
                .iter()
                .zip(powers)
                .map(|(a, k)| a * k)
                .skip(1),
        )
    }

    /// The polynomial times a number.
    #[must_use]
    pub fn scaled(&self, factor: &BigRational) -> Self {
        Self::new(self.coefficients.iter().map(|a| a * factor))
    }

    /// Quotient and remainder of a division; `None` when the divisor is zero.
    #[must_use]
    pub fn divided_by(&self, divisor: &Self) -> Option<(Self, Self)> {
        let (leading, others) = divisor.coefficients.split_last()?;
        let mut rest = self.coefficients.clone();
        let mut quotient = Vec::new();
        while rest.len() > others.len() {
            let factor = rest.pop()? / leading;
            let from = rest.len().saturating_sub(others.len());
            for (slot, a) in rest.iter_mut().skip(from).zip(others) {
                *slot -= &factor * a;
            }
            quotient.push(factor);
        }
        quotient.reverse();
        Some((Self::new(quotient), Self::new(rest)))
    }

    /// A positive multiple of the remainder of a division, with whole coprime coefficients; zero of
    /// a division by zero.
    ///
    /// Computed in whole numbers, which a quotient is not made of.
    #[must_use]
    pub fn remainder(&self, divisor: &Self) -> Self {
        let [mut rest, divisor] = [self, divisor].map(Self::whole);
        let Some((leading, others)) = divisor.split_last() else {
            return Self::new([]);
        };
        let scale = leading.abs();
        while let Some(from) = rest.len().checked_sub(divisor.len()) {
            let Some(mut factor) = rest.pop() else { break };
            if leading.is_negative() {
                factor = -factor;
            }
            for slot in &mut rest {
                *slot *= &scale;
            }
            for (slot, a) in rest.iter_mut().skip(from).zip(others) {
                *slot -= &factor * a;
            }
        }
        Self::new(rest.into_iter().map(BigRational::from_integer)).primitive()
    }

    /// The coefficients of the primitive multiple.
    fn whole(&self) -> Vec<BigInt> {
        let primitive = self.primitive();
        primitive
            .coefficients
            .iter()
            .map(BigRational::to_integer)
            .collect()
    }

    /// The positive multiple whose coefficients are whole and have no common divisor.
    ///
    /// Two polynomials have the same one exactly when one is a positive multiple of the other.
    #[must_use]
    pub fn primitive(&self) -> Self {
        let common = self.common_denominator();
        let divisor = self
            .coefficients
            .iter()
            .fold(BigInt::zero(), |divisor, a| divisor.gcd(a.numer()));
        if divisor.is_zero() {
            return self.clone();
        }
        // The numerators are divided, then the common denominator is put on: one product each.
        let whole = |a: &BigRational| a.numer() / &divisor * (&common / a.denom());
        Self {
            coefficients: self
                .coefficients
                .iter()
                .map(|a| BigRational::from_integer(whole(a)))
                .collect(),
        }
    }

    /// Whether the polynomial is above zero on [−1, 1], where that is easily seen; `false` says nothing.
    ///
    /// With x = (1 − s)/(1 + s) and s ≥ 0 it is Σ aᵢ(1 − s)ⁱ(1 + s)ⁿ⁻ⁱ over (1 + s)ⁿ, which is above zero
    /// everywhere, and at x = −1 in the limit, where all coefficients are.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{BigRational, Scalar, polynomial::Polynomial};
    ///
    /// let of = |coefficients: [i32; 3]| Polynomial::new(coefficients.map(BigRational::integer));
    /// assert!(of([2, 0, -1]).is_plainly_positive()); // 2 − x²
    /// assert!(!of([1, 0, -1]).is_plainly_positive()); // zero at both ends
    /// ```
    #[must_use]
    pub fn is_plainly_positive(&self) -> bool {
        let whole = self.whole();
        let mut power = vec![BigInt::one()]; // (1 + s)^(n − i)
        let mut sum: Vec<BigInt> = Vec::new();
        for a in whole.iter().rev() {
            // sum·(1 − s) + a·power
            let mut next: Vec<BigInt> = power.iter().map(|p| a * p).collect();
            for (i, c) in sum.iter().enumerate() {
                for (slot, term) in next.iter_mut().skip(i).zip([c.clone(), -c]) {
                    *slot += term;
                }
            }
            sum = next;
            power.push(BigInt::ZERO);
            for i in (1..power.len()).rev() {
                if let [before, at] = power.get_mut(i - 1..=i).unwrap_or_default() {
                    *at += &*before;
                }
            }
        }
        !sum.is_empty() && sum.iter().all(|c| c.is_positive())
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

    fn common_denominator(&self) -> BigInt {
        let one = BigInt::one();
        let denominators = self.coefficients.iter().map(BigRational::denom);
        denominators.fold(one, |common, d| common.lcm(d)).abs()
    }

    fn zip_with(
        &self,
        other: &Self,
        f: impl Fn(&BigRational, &BigRational) -> BigRational,
    ) -> Self {
        let zero = BigRational::zero();
        let length = self.coefficients.len().max(other.coefficients.len());
        let at = |of: &Self, k: usize| of.coefficients.get(k).unwrap_or(&zero).clone();
        Self::new((0..length).map(|k| f(&at(self, k), &at(other, k))))
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
        let mut product =
            vec![BigRational::zero(); self.coefficients.len() + other.coefficients.len()];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (slot, b) in product.iter_mut().skip(i).zip(&other.coefficients) {
                *slot += a * b;
            }
        }
        Polynomial::new(product)
    }
}
