//! Exact sums over any number of rows, in bounded memory.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Zero as _};
use passivity_core::{BigRational, Fixed, Interval, Ordered as _, whole};

use crate::ball::Ball;
use crate::figure::Figure;
use crate::number::{Reduced, Written};
use crate::span::ONE;

/// The widest denominator that a sum keeps, in bits, unless it is that of a log. Past it (positions of ever
/// new denominators) the sum is rounded outward, so that memory stays flat: it becomes an enclosure.
pub const MAX_DENOMINATOR_BITS: u64 = 4096;

/// The same for the sums of a log, of which at most a thousand rows of different durations are exact: room for these.
pub(crate) const MAX_DENOMINATOR_BITS_OF_LOG: u64 = 1 << 16;

/// The grid of a sum that is rounded outward, 2^−`ROUNDED_BITS`.
const ROUNDED_BITS: u64 = 1024;

/// A sum of exact numbers.
///
/// # Example
///
/// ```
/// use passivity_core::Fixed;
/// use passivity_audit::sum::Sum;
///
/// let mut sum = Sum::default();
/// for n in 1..=3 {
///     sum.add(&Fixed::new(1, n)).unwrap();
/// }
/// assert_eq!(sum.value().exact().unwrap().to_string(), "11/6");
/// ```
#[derive(Clone, Debug)]
pub struct Sum {
    /// What machine integers hold, over a common denominator.
    small: (i128, i128),
    /// The rest, as numerator and denominator: not reduced, so that adding takes no big gcd.
    big: (BigInt, BigInt),
    /// Near the rest.
    near: Ball,
    /// How far above it the sum may lie.
    slack: BigRational,
    /// How many bits the denominator may have.
    most_bits: u64,
}

impl Default for Sum {
    fn default() -> Self {
        Self {
            small: (0, 1),
            big: (BigInt::ZERO, BigInt::one()),
            near: Ball::whole(0),
            slack: BigRational::zero(),
            most_bits: MAX_DENOMINATOR_BITS,
        }
    }
}

impl Sum {
    /// A sum over the rows of a log.
    pub(crate) fn of_log() -> Self {
        Self {
            most_bits: MAX_DENOMINATOR_BITS_OF_LOG,
            ..Self::default()
        }
    }

    /// A sum that is n/d so far, d > 0.
    pub(crate) fn of_ratio(n: i128, d: i128) -> Self {
        Self {
            small: (n, d),
            ..Self::of_log()
        }
    }

    /// Adds a number; `None`, and nothing added, when it is undefined.
    pub fn add<S: Written>(&mut self, x: &S) -> Option<()> {
        self.add_reduced(&x.to_reduced()?);
        Some(())
    }

    /// Adds a number in lowest terms.
    pub fn add_reduced(&mut self, x: &Reduced) {
        match x {
            Reduced::Small(n, d) => self.add_small(*n, *d),
            Reduced::Big(x) => self.add_rational(x),
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
                let x = BigRational::new_raw(n.into(), d.into());
                self.add_to_big(&x, Ball::wide_ratio(n, d));
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

    /// Around the lower end.
    pub(crate) fn near(&self) -> Ball {
        let (n, d) = self.small;
        self.near + Ball::wide_ratio(n, d)
    }

    /// How the lower end compares with that of another sum: told by doubles where they tell, for to reduce long
    /// fractions takes long.
    pub(crate) fn compare(&self, other: &Self) -> Ordering {
        let exactly = || match self.big == other.big {
            true => {
                // Over one denominator, of which there is no need to know the least.
                let ((n, d), (m, e)) = (self.small, other.small);
                (BigInt::from(n) * e).cmp(&(BigInt::from(m) * d))
            }
            false => self.value().lo().cmp(other.value().lo()),
        };
        (self.near() - other.near()).sign().unwrap_or_else(exactly)
    }

    fn spill(&mut self) {
        let (n, d) = std::mem::replace(&mut self.small, (0, 1));
        let x = match Fixed::new(n, d).to_reduced() {
            Some(x) => x.to_rational(),
            None => BigRational::new(n.into(), d.into()),
        };
        self.add_to_big(&x, Ball::wide_ratio(n, d));
    }

    /// Adds a big number.
    pub fn add_rational(&mut self, x: &BigRational) {
        self.add_to_big(x, Ball::of_rational(x));
    }

    /// Adds a number that is near by.
    fn add_to_big(&mut self, x: &BigRational, near: Ball) {
        self.near = self.near + near;
        let (n, d) = &mut self.big;
        // The least common denominator, by a gcd of numbers no longer than that of x.
        let divisor = whole::gcd(&(&*d % x.denom()), x.denom());
        let factor = x.denom() / &divisor;
        *n = &*n * &factor + x.numer() * (&*d / &divisor);
        *d *= factor;
        if d.bits() <= self.most_bits {
            return;
        }
        // Perhaps it only looks that wide.
        let reduced = whole::fraction(std::mem::take(n), std::mem::take(d));
        self.big = if reduced.denom().bits() <= self.most_bits / 2 {
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
        if !other.big.0.is_zero() {
            let (mut big, mut near) = (other.big.clone(), other.near);
            // The shorter one is reduced, and added to the longer one.
            if big.1.bits() > self.big.1.bits() {
                std::mem::swap(&mut self.big, &mut big);
                std::mem::swap(&mut self.near, &mut near);
            }
            self.add_rational(&whole::fraction(big.0, big.1));
        }
        if !other.slack.is_zero() {
            self.slack += &other.slack;
        }
    }

    /// Adds a number `times` over; `None`, and nothing added, when it is undefined.
    pub fn add_times<S: Written>(&mut self, x: &S, times: u64) -> Option<()> {
        self.add_reduced_times(&x.to_reduced()?, times);
        Some(())
    }

    fn add_reduced_times(&mut self, x: &Reduced, times: u64) {
        if times == 1 {
            return self.add_reduced(x);
        }
        let product = match x {
            Reduced::Small(n, d) => n.checked_mul(times.into()).zip(Some(*d)),
            Reduced::Big(_) => None,
        };
        match product {
            // A denominator shares no factor with n, but it may with `times`.
            Some((n, d)) => match i128::try_from(n.unsigned_abs().gcd(&d.unsigned_abs())) {
                Ok(divisor) => self.add_small(n / divisor, d / divisor),
                Err(_) => self.add_rational(&BigRational::new(n.into(), d.into())),
            },
            None => self.add_rational(&(x.to_rational() * BigInt::from(times))),
        }
    }

    /// The sum: exact, or enclosed once its denominator grew past [`MAX_DENOMINATOR_BITS`].
    #[must_use]
    pub fn value(&self) -> Figure<BigRational> {
        let ((n, d), (big_n, big_d)) = (self.small, &self.big);
        let lo = whole::fraction(big_n * d + big_d * n, big_d * d);
        if self.slack.is_zero() {
            return Figure::Exact(lo);
        }
        let hi = &lo + &self.slack;
        Figure::Enclosed(Interval::hull(lo, hi))
    }
}

/// A sum of figures that may be enclosures.
#[derive(Clone, Debug, Default)]
pub struct FigureSum {
    lo: Sum,
    /// Kept apart from the first enclosure on.
    hi: Option<Sum>,
}

impl FigureSum {
    /// A sum over the rows of a log.
    pub(crate) fn of_log() -> Self {
        Self {
            lo: Sum::of_log(),
            hi: None,
        }
    }

    /// A sum between two numbers in units of the grid.
    pub(crate) fn of_grid(ends: [i128; 2]) -> Self {
        let [lo, hi] = ends.map(|n| Sum::of_ratio(n, ONE));
        Self { lo, hi: Some(hi) }
    }

    /// Adds a figure; `None` when it is undefined.
    pub fn add<S: Written>(&mut self, figure: &Figure<S>) -> Option<()> {
        self.add_times(figure, 1)
    }

    /// Adds a figure `times` over; `None` when it is undefined.
    pub fn add_times<S: Written>(&mut self, figure: &Figure<S>, times: u64) -> Option<()> {
        if !(S::EXACT && figure.is_exact()) {
            self.hi.get_or_insert_with(|| self.lo.clone());
        }
        self.lo.add_reduced_times(&figure.lo().below()?, times);
        if let Some(hi) = &mut self.hi {
            hi.add_reduced_times(&figure.hi().above()?, times);
        }
        Some(())
    }

    /// Adds what is between two numbers in units of the grid, `times` over.
    pub(crate) fn add_on_grid(&mut self, [lo, hi]: [i128; 2], times: u64) {
        let highest = self.hi.get_or_insert_with(|| self.lo.clone());
        highest.add_reduced_times(&Reduced::Small(hi, ONE), times);
        self.lo.add_reduced_times(&Reduced::Small(lo, ONE), times);
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

    /// Both ends, exactly as long as nothing was rounded; one where all that was added is exact.
    pub(crate) fn ends(&self) -> (BigRational, Option<BigRational>) {
        let end = |sum: &Sum| sum.value().lo().clone();
        (end(&self.lo), self.hi.as_ref().map(end))
    }

    /// A sum with these [`ends`](Self::ends).
    pub(crate) fn from_ends(lo: &BigRational, hi: Option<&BigRational>) -> Self {
        let sum = |x: &BigRational| {
            let mut sum = Sum::of_log();
            sum.add_rational(x);
            sum
        };
        Self {
            lo: sum(lo),
            hi: hi.map(sum),
        }
    }

    /// How many bits the denominator has that machine integers do not hold.
    #[must_use]
    pub fn width(&self) -> u64 {
        let width = |sum: &Sum| sum.big.1.bits();
        self.hi.as_ref().map_or(0, width).max(width(&self.lo))
    }

    /// The sum.
    #[must_use]
    pub fn value(&self) -> Figure<BigRational> {
        match &self.hi {
            None => self.lo.value(),
            Some(hi) => {
                let (lo, hi) = (self.lo.value(), hi.value());
                Figure::Enclosed(Interval::hull(lo.lo().clone(), hi.hi().clone()))
            }
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
            sum.add(&x).unwrap();
            expected += x.to_rational().unwrap();
        }
        assert_eq!(sum.value(), Figure::Exact(expected));
    }

    #[test]
    fn memory_is_bounded_and_the_sum_enclosed() {
        let (mut sum, mut exact) = (Sum::default(), BigRational::integer(0));
        for k in 0..200_i128 {
            let x = Fixed::new(1, (1 << 40) + 2 * k + 1);
            sum.add(&x).unwrap();
            exact += x.to_rational().unwrap();
        }
        let value = sum.value();
        assert!(
            !value.is_exact(),
            "the denominator should have grown past the bound"
        );
        let (lo, hi) = (value.lo().clone(), value.hi().clone());
        assert!(lo <= exact && exact <= hi);
        assert!(lo.denom().bits() < MAX_DENOMINATOR_BITS + 200);
        assert!(hi - lo < BigRational::new(1.into(), BigInt::one() << 1000));
    }

    #[test]
    fn enclosures_add_end_by_end() {
        let mut sum = FigureSum::default();
        let between = |lo, hi| Figure::between(lo, hi).unwrap();
        sum.add(&Figure::Exact(Fixed::integer(2))).unwrap();
        sum.add_times(&between(Fixed::integer(-1), Fixed::new(1, 3)), 3)
            .unwrap();
        let mut twice = sum.clone();
        twice.add_sum(&sum);
        let at = |n: i32| BigRational::integer(n);
        assert_eq!(twice.value(), Figure::between(at(-2), at(6)).unwrap());
    }
}
