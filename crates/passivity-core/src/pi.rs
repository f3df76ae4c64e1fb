//! Exact numbers with π in them: quotients of polynomials in π with whole coefficients.
//!
//! An encoder of N counts a revolution has Δ = 2π/N, and a stiffness in N·m/deg has 180/π. Kept as
//! polynomials, a π that cancels is gone exactly: because π is transcendental, a polynomial in it
//! is zero only when all its coefficients are. Every other sign is found by enclosing π as tightly
//! as it takes.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::{BigInt, Sign};
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::fraction::{Fraction, Integer, Wide};
use crate::interval::Interval;
use crate::whole;

/// An exact number that may have π in it: a quotient of two polynomials in π.
///
/// # Example
///
/// ```
/// use passivity_core::{Exact, Ordered, Scalar, pi};
///
/// let half_turn = pi::pi();
/// let degree = half_turn.clone().over(Exact::integer(180));
/// assert_eq!(half_turn.clone().over(degree), Exact::integer(180)); // π cancels
/// let below = Exact::integer(355).over(Exact::integer(113)) - half_turn;
/// assert_eq!(below.sign(), Some(core::cmp::Ordering::Greater));
/// ```
pub type Exact = Fraction<Polynomial>;

/// A polynomial in π with whole coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Polynomial {
    /// Of π⁰, π¹, …; the last one is not zero.
    coefficients: Vec<BigInt>,
}

impl Polynomial {
    /// A whole number.
    #[must_use]
    pub fn whole(n: BigInt) -> Self {
        Self::trimmed(vec![n])
    }

    /// π^`power`.
    #[must_use]
    pub fn power(power: u32) -> Self {
        let zeros = (0..power).map(|_| BigInt::ZERO);
        Self::trimmed(zeros.chain([BigInt::one()]).collect())
    }

    fn trimmed(mut coefficients: Vec<BigInt>) -> Self {
        while coefficients.last().is_some_and(|c| c.is_zero()) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// The number, when there is no π in it.
    #[must_use]
    pub fn as_whole(&self) -> Option<BigInt> {
        match self.coefficients.as_slice() {
            [] => Some(BigInt::ZERO),
            [n] => Some(n.clone()),
            _ => None,
        }
    }

    fn zip_with(&self, other: &Self, f: impl Fn(&BigInt, &BigInt) -> BigInt) -> Self {
        let (a, b) = (&self.coefficients, &other.coefficients);
        let zero = BigInt::ZERO;
        let at = |of: &'_ [BigInt], i: usize| of.get(i).unwrap_or(&zero).clone();
        Self::trimmed(
            (0..a.len().max(b.len()))
                .map(|i| f(&at(a, i), &at(b, i)))
                .collect(),
        )
    }

    /// Bounds of the value times 2^(`bits`·degree), from π enclosed to `bits` bits.
    fn bounds(&self, bits: u32) -> [BigInt; 2] {
        let [lo, hi] = scaled(bits);
        let mut bounds = [BigInt::ZERO, BigInt::ZERO];
        let degree = u32::try_from(self.degree()).unwrap_or(u32::MAX);
        for (power, c) in (0..).zip(&self.coefficients) {
            let to_common = bits * (degree - power);
            let term = |end: &BigInt| (c * end.pow(power)) << to_common;
            let [least, most] = if c.is_negative() {
                [term(&hi), term(&lo)]
            } else {
                [term(&lo), term(&hi)]
            };
            let [sum_least, sum_most] = &mut bounds;
            *sum_least += least;
            *sum_most += most;
        }
        bounds
    }

    fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Bounds of the value as numbers.
    fn enclosure(&self, bits: u32) -> Interval<BigRational> {
        if let Some(n) = self.as_whole() {
            return Interval::point(BigRational::from_integer(n));
        }
        let [least, most] = self.bounds(bits);
        let degree = u32::try_from(self.degree()).unwrap_or(u32::MAX);
        let bits = bits * degree;
        Interval::hull(whole::dyadic(least, bits), whole::dyadic(most, bits))
    }
}

/// Tries ever tighter enclosures of π, until `decide` is content; `None` past all [`WIDTHS`].
fn refine<T>(decide: impl Fn(u32) -> Option<T>) -> Option<T> {
    WIDTHS.into_iter().find_map(decide)
}

/// The enclosures of π that a sign is looked for with, in bits after the point: the last is far past
/// what the longest numbers of a scene can come near to without being equal.
const WIDTHS: [u32; 7] = [64, 256, 1024, 4096, 16_384, 65_536, 262_144];

impl Integer for Polynomial {
    fn from_i32(n: i32) -> Self {
        Self::whole(BigInt::from(n))
    }

    fn add(&self, other: &Self) -> Option<Self> {
        Some(self.zip_with(other, |a, b| a + b))
    }

    fn sub(&self, other: &Self) -> Option<Self> {
        Some(self.zip_with(other, |a, b| a - b))
    }

    fn mul(&self, other: &Self) -> Option<Self> {
        let terms = self.coefficients.len() + other.coefficients.len();
        let mut product = vec![BigInt::ZERO; terms];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (slot, b) in product.iter_mut().skip(i).zip(&other.coefficients) {
                *slot += a * b;
            }
        }
        Some(Self::trimmed(product))
    }

    fn div_floor(&self, divisor: &Self) -> Option<Self> {
        if divisor.signum()? != Ordering::Greater {
            return None;
        }
        let is_floor = |whole: &Self| {
            let rest = self.sub(&divisor.mul(whole)?)?;
            let next = divisor.sub(&rest)?;
            Some(rest.signum()? != Ordering::Less && next.signum()? == Ordering::Greater)
        };
        refine(|bits| {
            let (n, d) = (self.enclosure(bits), divisor.enclosure(bits));
            let near = (n.middle() / d.hi()).floor().to_integer();
            // Or the next: no enclosure shows a quotient that is a whole number exactly.
            let candidates = [near.clone(), near + 1].map(Self::whole);
            let is_it = |whole: &Self| is_floor(whole) == Some(true);
            candidates.into_iter().find(is_it)
        })
    }

    fn signum(&self) -> Option<Ordering> {
        if let Some(n) = self.as_whole() {
            return Some(n.cmp(&BigInt::ZERO));
        }
        refine(|bits| {
            let [least, most] = self.bounds(bits);
            match (least.sign(), most.sign()) {
                (Sign::Plus, _) => Some(Ordering::Greater),
                (_, Sign::Minus) => Some(Ordering::Less),
                _ => None,
            }
        })
    }

    fn shortened(numerator: Self, denominator: Self) -> (Self, Self) {
        let both = || {
            numerator
                .coefficients
                .iter()
                .chain(&denominator.coefficients)
        };
        let divisor = both().fold(BigInt::ZERO, |divisor, c| whole::gcd(&divisor, c));
        if divisor.is_zero() {
            return (numerator, denominator);
        }
        // Powers of π that both have.
        let powers = |of: &Self| of.coefficients.iter().take_while(|c| c.is_zero()).count();
        let common = match numerator.coefficients.is_empty() {
            true => powers(&denominator),
            false => powers(&numerator).min(powers(&denominator)),
        };
        let divided = |of: &Self| {
            let kept = of.coefficients.iter().skip(common);
            Self::trimmed(kept.map(|c| c / &divisor).collect())
        };
        (divided(&numerator), divided(&denominator))
    }

    fn halved(&self) -> Option<Self> {
        let halves = self.coefficients.iter().map(Integer::halved);
        Some(Self::trimmed(halves.collect::<Option<_>>()?))
    }
}

/// π.
#[must_use]
pub fn pi() -> Exact {
    Exact::new(Polynomial::power(1), Polynomial::power(0))
}

impl Exact {
    /// The exact number `x`.
    #[must_use]
    pub fn of(x: &BigRational) -> Self {
        Self::new(
            Polynomial::whole(x.numer().clone()),
            Polynomial::whole(x.denom().clone()),
        )
    }

    /// The number as a rational, when all π in it cancels; `None` when it does not, or when it is
    /// undefined.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Exact, Scalar, pi};
    ///
    /// let turns = (pi::pi() + pi::pi()).over(pi::pi());
    /// assert_eq!(turns.to_rational().unwrap().to_string(), "2");
    /// assert!(pi::pi().to_rational().is_none());
    /// ```
    #[must_use]
    pub fn to_rational(&self) -> Option<BigRational> {
        let (n, d) = self.parts()?;
        let pairs = n.coefficients.iter().zip(&d.coefficients);
        let lengths = (n.coefficients.len(), d.coefficients.len());
        let Some((numerator, denominator)) = pairs.clone().find(|(_, d)| !d.is_zero()) else {
            return (lengths.0 == 0).then(BigRational::zero);
        };
        if lengths.0 == 0 {
            return Some(BigRational::zero());
        }
        let proportional = pairs.clone().all(|(a, b)| a * denominator == b * numerator);
        (lengths.0 == lengths.1 && proportional)
            .then(|| BigRational::new(numerator.clone(), denominator.clone()))
    }

    /// The number as a quotient of two big integers, when there is no π in it as it is written.
    #[must_use]
    pub fn to_wide(&self) -> Option<Wide> {
        let (n, d) = self.parts()?;
        Some(Wide::new(n.as_whole()?, d.as_whole()?))
    }

    /// A rational enclosure of relative width about 2^−`digits`; a point when π cancels, and
    /// `None` for an undefined number, and where 262144 bits of π are not enough for it.
    #[must_use]
    pub fn enclosure(&self, digits: u32) -> Option<Interval<BigRational>> {
        if let Some(x) = self.to_rational() {
            return Some(Interval::point(x));
        }
        let (n, d) = self.parts()?;
        // An enclosure is refined until numerator and denominator are known to that many bits.
        refine(|bits| {
            let (n, d) = (n.enclosure(bits), d.enclosure(bits));
            let tight = |x: &Interval<BigRational>| {
                let width = x.hi() - x.lo();
                let scaled = width * BigRational::from_integer(BigInt::one() << digits);
                // By a difference: the order of the type could exhaust the stack.
                let is_wider = |end: &BigRational| (end.abs() - &scaled).is_negative();
                ![x.lo(), x.hi()].into_iter().any(is_wider)
            };
            if !d.lo().is_positive() || !tight(&n) || !tight(&d) {
                return None;
            }
            let [by_least, by_most] = if n.lo().is_negative() {
                [d.lo(), d.hi()]
            } else {
                [d.hi(), d.lo()]
            };
            Some(Interval::hull(n.lo() / by_least, n.hi() / by_most))
        })
    }
}

/// Whole numbers around π·2^`bits`, by Machin's π = 16·arctan(1/5) − 4·arctan(1/239).
pub(crate) fn scaled(bits: u32) -> [BigInt; 2] {
    // Each series has fewer terms than bits, each off by less than 1 unit in the last place, and
    // the first term left out is below 1 as well: 24 spare bits cover (16 + 4)·(bits + 25) units
    // for every width up to 2¹⁸ bits.
    const SPARE: u32 = 24;
    let one = BigInt::one() << (bits + SPARE);
    let pi = arctan_inverse(&one, 5) * 16 - arctan_inverse(&one, 239) * 4;
    let slack = BigInt::from(20_u64 * (u64::from(bits) + u64::from(SPARE) + 1));
    let lo = (&pi - &slack) >> SPARE;
    let hi = ((pi + slack) >> SPARE) + 1;
    [lo, hi]
}

/// arctan(1/n) in units of 1/`one`, by its alternating series.
fn arctan_inverse(one: &BigInt, n: u32) -> BigInt {
    let square = n * n;
    let mut power = one / n;
    let mut sum = BigInt::ZERO;
    let mut k = 1_u32;
    while power != BigInt::ZERO {
        let term = &power / k;
        if k % 4 == 1 {
            sum += term;
        } else {
            sum -= term;
        }
        power /= square;
        k += 2;
    }
    sum
}
