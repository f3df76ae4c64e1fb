//! A digital controller as a transfer function H(z), in units of the stiffness (TH-LTI).
//!
//! The command is u = −Σ cⱼqₕ₋ⱼ, where q is the measured position, H(z) = Σ cⱼz⁻ʲ, and the device
//! has rested for ever before the start. The wall alone is H = 1, a delay of k samples z⁻ᵏ, virtual
//! damping 1 + B(1 − z⁻¹), and with a one-pole filter on it 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹).

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use crate::controller::Filter;
use crate::scalar::{Ordered, Scalar};

/// A stable digital controller H(z) = (n₀ + n₁z⁻¹ + …)/(d₀ + d₁z⁻¹ + …), in units of the stiffness.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, transfer::{Refused, TransferFunction}};
///
/// // 1/(1 − z⁻¹/2) = 1 + z⁻¹/2 + z⁻²/4 + …
/// let halving = [Fixed::integer(1), Fixed::new(-1, 2)];
/// let lag = TransferFunction::new([Fixed::integer(1)], halving).unwrap();
/// assert_eq!(lag.at_one(), Fixed::integer(2));
/// assert_eq!(lag.impulse_response(3), [Fixed::integer(1), Fixed::new(1, 2), Fixed::new(1, 4)]);
///
/// // An integrator is not stable, and a factor that cancels it does not make it so.
/// let difference = [1, -1].map(Fixed::integer);
/// assert_eq!(TransferFunction::new(difference, difference), Err(Refused::Unstable));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TransferFunction<S> {
    /// Of z⁰, z⁻¹, …; the last one is not zero.
    numerator: Vec<S>,
    /// Of z⁰, z⁻¹, …; the first and the last are not zero, and all poles are inside the unit circle.
    denominator: Vec<S>,
}

/// Why a transfer function is not a controller that TH-LTI speaks of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refused {
    /// The denominator has no coefficient of z⁰: the output would depend on samples to come.
    Improper,
    /// A pole, a root of the denominator as it is written, is on or outside the unit circle.
    Unstable,
    /// H(1) < 0: the controller pushes away from the wall, and no friction makes that passive.
    NegativeStiffness,
    /// A coefficient is undefined, or too long for the kind of number.
    Undefined,
}

impl<S: Ordered> TransferFunction<S> {
    /// The transfer function with these coefficients of z⁰, z⁻¹, …
    ///
    /// # Errors
    ///
    /// See [`Refused`]. A pole that a zero of the numerator cancels counts as a pole: what is in the
    /// controller grows although it does not show at the output.
    pub fn new(
        numerator: impl Into<Vec<S>>,
        denominator: impl Into<Vec<S>>,
    ) -> Result<Self, Refused> {
        let numerator = trimmed(numerator.into()).ok_or(Refused::Undefined)?;
        let denominator = trimmed(denominator.into()).ok_or(Refused::Undefined)?;
        match denominator.first().map(Ordered::sign) {
            None | Some(Some(Ordering::Equal)) => return Err(Refused::Improper),
            Some(None) => return Err(Refused::Undefined),
            Some(Some(_)) => {}
        }
        if !is_stable(&denominator).ok_or(Refused::Undefined)? {
            return Err(Refused::Unstable);
        }
        let controller = Self {
            numerator,
            denominator,
        };
        match controller.at_one().is_nonnegative() {
            Some(true) => Ok(controller),
            Some(false) => Err(Refused::NegativeStiffness),
            None => Err(Refused::Undefined),
        }
    }

    /// The wall alone, H(z) = 1.
    #[must_use]
    pub fn wall() -> Self {
        Self {
            numerator: vec![S::one()],
            denominator: vec![S::one()],
        }
    }

    /// The wall with virtual damping by backward difference, 1 + B(1 − z⁻¹); B in KT.
    ///
    /// # Errors
    ///
    /// [`Refused::Undefined`] when B is.
    pub fn damped(damping: &S) -> Result<Self, Refused> {
        let numerator = [S::one() + damping.clone(), -damping.clone()];
        Self::new(numerator, [S::one()])
    }

    /// The wall with virtual damping behind a one-pole filter,
    /// 1 + B(1 − z⁻¹)(1 − a)/(1 − az⁻¹); B in KT, a = τ/(T + τ) for the filter's time constant τ.
    ///
    /// # Errors
    ///
    /// [`Refused::Unstable`] unless |a| < 1.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Scalar, transfer::TransferFunction};
    ///
    /// let half = Fixed::new(1, 2);
    /// let filtered = TransferFunction::filtered_damping(&Fixed::integer(1), &half).unwrap();
    /// // 1 + ½(1 − z⁻¹)(1 + z⁻¹/2 + …) = 3/2 − z⁻¹/4 − …
    /// assert_eq!(filtered.impulse_response(2), [Fixed::new(3, 2), Fixed::new(-1, 4)]);
    /// ```
    pub fn filtered_damping(damping: &S, pole: &S) -> Result<Self, Refused> {
        let kept = damping.clone() * (S::one() - pole.clone());
        let numerator = [S::one() + kept.clone(), -(pole.clone() + kept)];
        Self::new(numerator, [S::one(), -pole.clone()])
    }

    /// The same controller k samples late: times z⁻ᵏ.
    #[must_use]
    pub fn delayed(mut self, samples: u16) -> Self {
        if !self.numerator.is_empty() {
            let late = core::iter::repeat_n(S::zero(), usize::from(samples));
            self.numerator.splice(0..0, late);
        }
        self
    }
}

impl<S: Scalar> TransferFunction<S> {
    /// n₀, n₁, …, the last of which is not zero.
    #[must_use]
    pub fn numerator(&self) -> &[S] {
        &self.numerator
    }

    /// d₀, d₁, …, the first and the last of which are not zero.
    #[must_use]
    pub fn denominator(&self) -> &[S] {
        &self.denominator
    }

    /// H(1), the force per displacement once everything has come to rest.
    #[must_use]
    pub fn at_one(&self) -> S {
        sum(&self.numerator).over(sum(&self.denominator))
    }

    /// c₀, …, cⱼ, as many as asked for: the output after a single sample at 1.
    #[must_use]
    pub fn impulse_response(&self, count: usize) -> Vec<S> {
        let mut response: Vec<S> = Vec::with_capacity(count);
        let Some((leading, others)) = self.denominator.split_first() else {
            return response;
        };
        for j in 0..count {
            let driven = self.numerator.get(j).cloned().unwrap_or_else(S::zero);
            let past = others.iter().zip(response.iter().rev());
            let rest = past.fold(driven, |rest, (d, c)| rest - d.clone() * c.clone());
            response.push(rest.over(leading.clone()));
        }
        response
    }

    /// The tail sums g₁, g₂, …, as many as asked for: gⱼ = cⱼ + cⱼ₊₁ + ….
    #[must_use]
    pub fn tail_sums(&self, count: usize) -> Vec<S> {
        let response = self.impulse_response(count).into_iter();
        let less = |rest: &mut S, c: S| {
            *rest = rest.clone() - c;
            Some(rest.clone())
        };
        response.scan(self.at_one(), less).collect()
    }

    /// The tail sums as coefficients of a function of z, Σ gⱼz⁻ʲ for j ≥ 1, over the same
    /// denominator.
    ///
    /// It is z⁻¹(H(1) − H(z))/(1 − z⁻¹), where the division leaves no remainder. Its own value at
    /// z = 1 may have any sign.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Scalar, transfer::TransferFunction};
    ///
    /// let late = TransferFunction::<Fixed>::wall().delayed(2); // c₂ = 1, so that g₁ = g₂ = 1
    /// assert_eq!(late.tails().numerator(), [0, 1, 1].map(Fixed::integer));
    /// ```
    #[must_use]
    pub fn tails(&self) -> Self {
        let at_one = self.at_one();
        let length = self.numerator.len().max(self.denominator.len());
        let at = |of: &[S], i: usize| of.get(i).cloned().unwrap_or_else(S::zero);
        let missing = |i| at_one.clone() * at(&self.denominator, i) - at(&self.numerator, i);
        // Dividing by 1 − z⁻¹ is to sum up; the last sum is the remainder, zero.
        let sums = (0..length.saturating_sub(1)).scan(S::zero(), |sum, i| {
            *sum = sum.clone() + missing(i);
            Some(sum.clone())
        });
        Self {
            numerator: core::iter::once(S::zero()).chain(sums).collect(),
            denominator: self.denominator.clone(),
        }
    }

    /// The controller as the kernel's filter, when its response ends (no denominator but d₀).
    #[must_use]
    pub fn filter(&self) -> Option<Filter<S>> {
        Some(self.recursion()).filter(Filter::ends)
    }

    /// The controller as the kernel's filter, whether its response ends or not.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Scalar, transfer::TransferFunction};
    ///
    /// // 1/(1 − z⁻¹/2): H(1) = 2, and the tail sums are 1, ½, ¼, …
    /// let halving = [Fixed::integer(1), Fixed::new(-1, 2)];
    /// let filter = TransferFunction::new([Fixed::integer(1)], halving).unwrap().recursion();
    /// assert_eq!(filter.sum, Fixed::integer(2));
    /// assert_eq!((filter.tails, filter.poles), (vec![Fixed::integer(1)], vec![Fixed::new(-1, 2)]));
    /// ```
    #[must_use]
    pub fn recursion(&self) -> Filter<S> {
        let over_leading = |of: &[S]| -> Vec<S> {
            let leading = self.denominator.first();
            let later = of.iter().skip(1).zip(leading.into_iter().cycle());
            later.map(|(c, d)| c.clone().over(d.clone())).collect()
        };
        Filter {
            sum: self.at_one(),
            tails: over_leading(self.tails().numerator()),
            poles: over_leading(&self.denominator),
        }
    }
}

/// Whether all roots of d₀zⁿ + d₁zⁿ⁻¹ + … + dₙ are inside the unit circle, d₀ ≠ 0; `None` when a
/// number is undefined.
///
/// By the recursion of Schur, Cohn and Jury, exactly: |dₙ| < |d₀|, and the polynomial of one degree
/// less with the coefficients dᵢ − (dₙ/d₀)dₙ₋ᵢ has its roots there, too. A root on the circle is
/// not inside.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, transfer::is_stable};
///
/// assert_eq!(is_stable(&[Fixed::integer(1), Fixed::new(-9, 10)]), Some(true));
/// assert_eq!(is_stable(&[1, 0, 1].map(Fixed::integer)), Some(false)); // ±i
/// ```
#[must_use]
pub fn is_stable<S: Ordered>(denominator: &[S]) -> Option<bool> {
    let mut row = denominator.to_vec();
    while let [first, .., last] = row.as_slice() {
        if !(first.abs() - last.abs()).is_positive()? {
            return Some(false);
        }
        let reflection = last.clone().over(first.clone());
        let pairs = row.iter().zip(row.iter().rev());
        let mut next: Vec<S> = pairs
            .map(|(d, mirrored)| d.clone() - reflection.clone() * mirrored.clone())
            .collect();
        next.pop(); // Zero: dₙ − (dₙ/d₀)d₀.
        row = next;
    }
    Some(true)
}

fn sum<S: Scalar>(numbers: &[S]) -> S {
    numbers.iter().fold(S::zero(), |sum, x| sum + x.clone())
}

/// Without the zeros at the end; `None` when a number is undefined.
fn trimmed<S: Ordered>(mut coefficients: Vec<S>) -> Option<Vec<S>> {
    for c in &coefficients {
        c.sign()?;
    }
    while coefficients.last().and_then(Ordered::sign) == Some(Ordering::Equal) {
        coefficients.pop();
    }
    Some(coefficients)
}
