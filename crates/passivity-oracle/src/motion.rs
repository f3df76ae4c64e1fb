//! Motion within an interval at a constant force, in closed form, enclosed between decimals.
//!
//! With λ = β/μ and a = (u − σ·sgn v)/μ, v(t) = v₀e^(−λt) + a·t·φ₁(−λt) and
//! ξ(t) = ξ₀ + v₀·t·φ₁(−λt) + a·t²·φ₂(−λt), where φ₁(z) = (eᶻ − 1)/z and φ₂(z) = (eᶻ − 1 − z)/z².

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One, Signed, Zero};
use passivity_core::{BigRational, Friction, Interval};
use serde::Serialize;

use passivity_audit::Figure;

/// Decimal places of the enclosures.
pub const DIGITS: u32 = 40;

/// A piece of motion in one direction, at a constant force.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// μ > 0.
    pub mu: BigRational,
    /// β and σ.
    pub friction: Friction<BigRational>,
    /// ξ₀, in ticks.
    pub xi: BigRational,
    /// v₀, in ticks per sampling period; not zero.
    pub velocity: BigRational,
    /// u, the held force plus the operator's, in KΔ.
    pub force: BigRational,
    /// τ ≥ 0, in sampling periods, with βτ/μ ≤ 1.
    pub duration: BigRational,
}

/// Where a piece of motion leads.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Arrival {
    /// ξ(τ) between two decimals of [`DIGITS`] places, or exactly.
    pub xi: Figure<BigRational>,
    /// v(τ), likewise.
    pub velocity: Figure<BigRational>,
}

impl Piece {
    /// Where the motion is after its duration; `None` when the velocity changes sign before (that
    /// is not one piece), or when βτ/μ > 1.
    ///
    /// # Example
    ///
    /// Without viscous friction it is a parabola, exactly.
    ///
    /// ```
    /// use passivity_core::{BigRational, Friction, Scalar};
    /// use passivity_audit::Figure;
    /// use passivity_oracle::motion::Piece;
    ///
    /// let n = |n: i32| BigRational::integer(n);
    /// let piece = Piece {
    ///     mu: n(2),
    ///     friction: Friction::new(n(0), n(1)),
    ///     xi: n(0),
    ///     velocity: n(5),
    ///     force: n(-1),
    ///     duration: n(1),
    /// };
    /// let arrival = piece.arrival().unwrap();
    /// assert_eq!(arrival.velocity, Figure::Exact(n(4))); // a = (−1 − 1)/2
    /// assert_eq!(arrival.xi, Figure::Exact(n(9).half()));
    /// ```
    #[must_use]
    pub fn arrival(&self) -> Option<Arrival> {
        if self.velocity.is_zero() || !self.mu.is_positive() || self.duration.is_negative() {
            return None;
        }
        let [mu, t, xi, v] = [&self.mu, &self.duration, &self.xi, &self.velocity].map(Fraction::of);
        let z = &self.friction.beta * &self.duration / &self.mu;
        if z > BigRational::one() {
            return None;
        }
        let against = &self.friction.sigma * self.velocity.signum();
        let pushed = Fraction::of(&(&self.force - against)).times(&t);
        let (gained, moved) = (pushed.over(&mu), v.times(&t));
        let [phi_1, phi_2] = phi(&z);
        let z = Fraction::of(&z);
        // Both are linear in φ, so extreme at its ends.
        let velocity = phi_1.map_ends(&gained.plus(&v.times(&z).negated()), &v);
        let drift = phi_1.map_ends(&moved, &xi);
        let xi = drift.plus(&phi_2.map_ends(&gained.times(&t), &Fraction::zero()));
        // Velocity is monotone within a piece, so its signs at the ends are those in between.
        let turned = match self.velocity.is_positive() {
            true => velocity.lo.numerator.is_negative(),
            false => velocity.hi.numerator.is_positive(),
        };
        (!turned).then(|| Arrival {
            xi: xi.outward(),
            velocity: velocity.outward(),
        })
    }
}

/// φ₁(−z) and φ₂(−z) for 0 ≤ z ≤ 1, each between two consecutive partial sums of Σ (−z)ʲ/(j + k)!, which
/// alternates and falls.
///
/// As φ₁(−z) = 1 − z·φ₂(−z), term by term, one sum gives both.
fn phi(z: &BigRational) -> [Range; 2] {
    /// The last power of z, an odd one: 1/38! is below 10⁻⁴⁴.
    const LAST: u32 = 37;
    let (n, d) = (z.numer(), z.denom());
    // Σ (−z)ʲ/(j + 2)! for j below `LAST` in units of 1/((LAST + 1)!·dʲ), from the last term on.
    let (mut sum, mut power, mut factor) = (BigInt::one(), BigInt::one(), BigInt::one());
    for j in (0..LAST - 1).rev() {
        factor *= j + 3;
        power *= d;
        sum = &factor * &power - sum * n;
    }
    let (sum, last) = (sum * (LAST + 2), n.pow(LAST));
    let unit: BigInt = factor * 2 * (LAST + 2) * power * d;
    let between = |lo: BigInt, more: BigInt| Range {
        hi: Fraction::new(&lo + more, unit.clone()),
        lo: Fraction::new(lo, unit.clone()),
    };
    let one_less = &unit - n * &sum;
    [
        between(one_less, &last * (LAST + 2)),
        between(sum * d - &last, last),
    ]
}

/// A fraction that is not reduced: the sums of [`phi`] are long, and nothing is asked of them but where they
/// lie between decimals, which one division says. Reducing each on the way took a thousand times as long.
#[derive(Clone)]
struct Fraction {
    numerator: BigInt,
    /// Above zero.
    denominator: BigInt,
}

impl Fraction {
    const fn new(numerator: BigInt, denominator: BigInt) -> Self {
        Self {
            numerator,
            denominator,
        }
    }

    fn of(x: &BigRational) -> Self {
        Self::new(x.numer().clone(), x.denom().clone())
    }

    fn zero() -> Self {
        Self::new(BigInt::zero(), BigInt::one())
    }

    fn negated(self) -> Self {
        Self::new(-self.numerator, self.denominator)
    }

    fn plus(&self, other: &Self) -> Self {
        if self.denominator == other.denominator {
            let sum = &self.numerator + &other.numerator;
            return Self::new(sum, self.denominator.clone());
        }
        let numerator = &self.numerator * &other.denominator + &other.numerator * &self.denominator;
        Self::new(numerator, &self.denominator * &other.denominator)
    }

    fn times(&self, other: &Self) -> Self {
        let numerator = &self.numerator * &other.numerator;
        Self::new(numerator, &self.denominator * &other.denominator)
    }

    /// The quotient by what is above zero.
    fn over(&self, divisor: &Self) -> Self {
        let numerator = &self.numerator * &divisor.denominator;
        Self::new(numerator, &self.denominator * &divisor.numerator)
    }
}

/// All numbers between two that have the same denominator.
struct Range {
    lo: Fraction,
    hi: Fraction,
}

impl Range {
    /// Of slope·x + start.
    fn map_ends(&self, slope: &Fraction, start: &Fraction) -> Self {
        let at = |end: &Fraction| slope.times(end).plus(start);
        let (lo, hi) = match slope.numerator.is_negative() {
            true => (&self.hi, &self.lo),
            false => (&self.lo, &self.hi),
        };
        Self {
            lo: at(lo),
            hi: at(hi),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            lo: self.lo.plus(&other.lo),
            hi: self.hi.plus(&other.hi),
        }
    }

    /// Rounded outward to [`DIGITS`] decimal places; exact numbers stay.
    fn outward(self) -> Figure<BigRational> {
        let (lo, hi) = (&self.lo, &self.hi);
        if lo.numerator == hi.numerator {
            return Figure::Exact(BigRational::new(self.lo.numerator, self.lo.denominator));
        }
        let scale = BigInt::from(10).pow(DIGITS);
        let below = (&lo.numerator * &scale).div_floor(&lo.denominator);
        let above = (&hi.numerator * &scale).div_ceil(&hi.denominator);
        let ends = [below, above].map(|end| BigRational::new(end, scale.clone()));
        let [lo, hi] = ends;
        Figure::Enclosed(Interval::hull(lo, hi))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ratio(n: i64, d: i64) -> BigRational {
        BigRational::new(n.into(), d.into())
    }

    #[test]
    fn encloses_the_exponential() {
        // μ = β = t = 1, no force: v = v₀/e, and 1/e to 50 digits from tables.
        let piece = Piece {
            mu: ratio(1, 1),
            friction: Friction::new(ratio(1, 1), ratio(0, 1)),
            xi: ratio(0, 1),
            velocity: ratio(1, 1),
            force: ratio(0, 1),
            duration: ratio(1, 1),
        };
        let arrival = piece.arrival().unwrap();
        let digits: BigInt = "36787944117144232159552377016146086744581113103176"
            .parse()
            .unwrap();
        let inverse_e = BigRational::new(digits, BigInt::from(10).pow(50_u32));
        let (lo, hi) = (arrival.velocity.lo(), arrival.velocity.hi());
        assert!(*lo < inverse_e && inverse_e < *hi);
        assert!(
            hi - lo < ratio(1, 1_000_000_000_000_000_000) * ratio(1, 1_000_000_000_000_000_000)
        );
        // ξ = 1 − 1/e.
        let xi = ratio(1, 1) - inverse_e;
        assert!(*arrival.xi.lo() < xi && xi < *arrival.xi.hi());
    }

    #[test]
    fn both_sums_are_those_of_their_terms() {
        for z in [ratio(0, 1), ratio(1, 1), ratio(3, 7), ratio(1, 1_000_003)] {
            for (k, range) in (1..).zip(phi(&z)) {
                let mut term = (1..=k).fold(BigRational::one(), |x, n| x / BigInt::from(n));
                let mut sums = vec![term.clone()];
                for j in 1..38 {
                    term = -term * &z / BigInt::from(j + k);
                    sums.push(sums.last().unwrap() + &term);
                }
                let ends = [range.hi, range.lo];
                let ends = ends.map(|end| BigRational::new(end.numerator, end.denominator));
                assert_eq!(ends, [sums[36].clone(), sums[37].clone()], "{z} {k}");
            }
        }
    }

    #[test]
    fn a_reversal_is_no_piece() {
        let piece = Piece {
            mu: ratio(1, 1),
            friction: Friction::new(ratio(0, 1), ratio(1, 1)),
            xi: ratio(0, 1),
            velocity: ratio(1, 1),
            force: ratio(-1, 1),
            duration: ratio(1, 1),
        };
        assert_eq!(piece.arrival(), None);
    }
}
