//! Exact sums over any number of rows, in bounded memory.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, ToPrimitive as _, Zero as _};
use passivity_core::BigRational;

use crate::number::Written;
use crate::span::Span;

/// The widest denominator that a sum keeps, in bits. Past it (a trace of ever new denominators)
/// the sum is rounded outward, so that memory stays flat: it becomes an enclosure.
pub const MAX_DENOMINATOR_BITS: u64 = 4096;

/// The grid of a sum that is rounded outward, 2^−`ROUNDED_BITS`.
const ROUNDED_BITS: u64 = 1024;

/// A sum of exact numbers.
///
/// # Example
///
/// ```
/// use passivity_core::Fixed;
/// use passivity_oracle::{Span, sum::Sum};
///
/// let mut sum = Sum::default();
/// for n in 1..=3 {
///     sum.add(&Fixed::new(1, n));
/// }
/// assert_eq!(sum.value().exact().unwrap().to_string(), "11/6");
/// ```
#[derive(Clone, Debug)]
pub struct Sum {
    /// What machine integers hold, over a common denominator.
    small: (i128, i128),
    /// The rest, as numerator and denominator: not reduced, so that adding takes no big gcd.
    big: (BigInt, BigInt),
    /// How far above it the sum may lie.
    slack: BigRational,
}

impl Default for Sum {
    fn default() -> Self {
        Self {
            small: (0, 1),
            big: (BigInt::ZERO, BigInt::one()),
            slack: BigRational::zero(),
        }
    }
}

impl Sum {
    /// Adds a number.
    pub fn add<S: Written>(&mut self, x: &S) {
        match x.to_reduced() {
            Some((n, d)) => self.add_small(n, d),
            None => {
                if let Some(x) = x.to_rational() {
                    self.add_rational(&x);
                }
            }
        }
    }

    /// Adds n/d, d > 0 in lowest terms.
    pub fn add_small(&mut self, n: i128, d: i128) {
        if n == 0 {
            return;
        }
        if self.add_to_small(n, d).is_none() {
            self.spill();
            if self.add_to_small(n, d).is_none() {
                self.add_rational(&BigRational::new_raw(n.into(), d.into()));
            }
        }
    }

    fn add_to_small(&mut self, n: i128, d: i128) -> Option<()> {
        let (sum, common) = self.small;
        self.small = if common % d == 0 {
            (sum.checked_add(n.checked_mul(common / d)?)?, common)
        } else {
            let divisor = i128::try_from(common.unsigned_abs().gcd(&d.unsigned_abs())).ok()?;
            let larger = common.checked_mul(d / divisor)?;
            let sum = sum.checked_mul(d / divisor)?;
            let term = n.checked_mul(common / divisor)?;
            (sum.checked_add(term)?, larger)
        };
        Some(())
    }

    fn spill(&mut self) {
        let (n, d) = std::mem::replace(&mut self.small, (0, 1));
        self.add_rational(&BigRational::new(n.into(), d.into()));
    }

    /// Adds a big number.
    pub fn add_rational(&mut self, x: &BigRational) {
        let (n, d) = &mut self.big;
        // The least common denominator, by a gcd of numbers no longer than that of x.
        let divisor = (&*d % x.denom()).gcd(x.denom());
        let factor = x.denom() / &divisor;
        *n = &*n * &factor + x.numer() * (&*d / &divisor);
        *d *= factor;
        if d.bits() <= MAX_DENOMINATOR_BITS {
            return;
        }
        // Perhaps it only looks that wide.
        let reduced = BigRational::new(std::mem::take(n), std::mem::take(d));
        self.big = if reduced.denom().bits() <= MAX_DENOMINATOR_BITS / 2 {
            reduced.into_raw()
        } else {
            let scale = BigInt::one() << ROUNDED_BITS;
            self.slack += BigRational::new(BigInt::one(), scale.clone());
            ((reduced * &scale).floor().to_integer(), scale)
        };
    }

    /// Adds another sum.
    pub fn add_sum(&mut self, other: &Self) {
        self.add_small(other.small.0, other.small.1);
        let (n, d) = &other.big;
        if !n.is_zero() {
            self.add_rational(&BigRational::new(n.clone(), d.clone()));
        }
        if !other.slack.is_zero() {
            self.slack += &other.slack;
        }
    }

    /// Adds a number `times` over.
    pub fn add_times<S: Written>(&mut self, x: &S, times: u64) {
        let small = x
            .to_reduced()
            .and_then(|(n, d)| Some((n.checked_mul(times.into())?, d)));
        match small {
            Some((n, d)) => {
                let divisor = n.unsigned_abs().gcd(&d.unsigned_abs());
                let divisor = divisor.to_i128().unwrap_or(1).max(1);
                self.add_small(n / divisor, d / divisor);
            }
            None => {
                if let Some(x) = x.to_rational() {
                    self.add_rational(&(x * BigInt::from(times)));
                }
            }
        }
    }

    /// The sum: exact, or enclosed once its denominator grew past [`MAX_DENOMINATOR_BITS`].
    #[must_use]
    pub fn value(&self) -> Span<BigRational> {
        let (n, d) = self.small;
        let (big_n, big_d) = self.big.clone();
        let lo = BigRational::new(big_n, big_d) + BigRational::new(n.into(), d.into());
        if self.slack.is_zero() {
            return Span::At(lo);
        }
        let hi = &lo + &self.slack;
        Span::Between(lo, hi)
    }
}

/// A sum of figures that may be enclosures.
#[derive(Clone, Debug, Default)]
pub struct SpanSum {
    lo: Sum,
    /// Kept apart from the first enclosure on.
    hi: Option<Sum>,
}

impl SpanSum {
    /// Adds a figure.
    pub fn add<S: Written>(&mut self, figure: &Span<S>) {
        self.add_times(figure, 1);
    }

    /// Adds a figure `times` over.
    pub fn add_times<S: Written>(&mut self, figure: &Span<S>, times: u64) {
        if let Span::Between(..) = figure {
            self.hi.get_or_insert_with(|| self.lo.clone());
        }
        self.lo.add_times(figure.lo(), times);
        if let Some(hi) = &mut self.hi {
            hi.add_times(figure.hi(), times);
        }
    }

    /// Adds another sum.
    pub fn add_sum(&mut self, other: &Self) {
        if other.hi.is_some() {
            self.hi.get_or_insert_with(|| self.lo.clone());
        }
        self.lo.add_sum(&other.lo);
        if let Some(hi) = &mut self.hi {
            hi.add_sum(other.hi.as_ref().unwrap_or(&other.lo));
        }
    }

    /// The sum.
    #[must_use]
    pub fn value(&self) -> Span<BigRational> {
        match &self.hi {
            None => self.lo.value(),
            Some(hi) => Span::Between(self.lo.value().lo().clone(), hi.value().hi().clone()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::{Fixed, Scalar};

    #[test]
    fn agrees_with_big_rationals() {
        let (mut sum, mut expected) = (Sum::default(), BigRational::integer(0));
        for k in 1..400_i128 {
            // Denominators with more and more primes: machine integers overflow.
            let x = Fixed::new(k * k - 700, k);
            sum.add(&x);
            expected += x.to_rational().unwrap();
        }
        assert_eq!(sum.value(), Span::At(expected));
    }

    #[test]
    fn memory_is_bounded_and_the_sum_enclosed() {
        let (mut sum, mut exact) = (Sum::default(), BigRational::integer(0));
        for k in 0..200_i128 {
            let x = Fixed::new(1, (1 << 40) + 2 * k + 1);
            sum.add(&x);
            exact += x.to_rational().unwrap();
        }
        let Span::Between(lo, hi) = sum.value() else {
            panic!("the denominator should have grown past the bound");
        };
        assert!(lo <= exact && exact <= hi);
        assert!(lo.denom().bits() < MAX_DENOMINATOR_BITS + 200);
        assert!(hi - lo < BigRational::new(1.into(), BigInt::one() << 1000));
    }

    #[test]
    fn spans_add_end_by_end() {
        let mut sum = SpanSum::default();
        sum.add(&Span::At(Fixed::integer(2)));
        sum.add_times(&Span::Between(Fixed::integer(-1), Fixed::new(1, 3)), 3);
        let mut twice = sum.clone();
        twice.add_sum(&sum);
        let at = |n: i32| BigRational::integer(n);
        assert_eq!(twice.value(), Span::Between(at(-2), at(6)));
    }
}
