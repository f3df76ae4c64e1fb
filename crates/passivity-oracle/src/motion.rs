//! Motion within an interval at a constant force, in closed form, enclosed between decimals.
//!
//! With λ = β/μ and a = (u − σ·sgn v)/μ, v(t) = v₀e^(−λt) + a·t·φ₁(−λt) and
//! ξ(t) = ξ₀ + v₀·t·φ₁(−λt) + a·t²·φ₂(−λt), where φ₁(z) = (eᶻ − 1)/z and φ₂(z) = (eᶻ − 1 − z)/z².

use num_bigint::BigInt;
use num_traits::{One, Pow, Signed, Zero};
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
        let t = &self.duration;
        let z = &self.friction.beta * t / &self.mu;
        if z > BigRational::one() {
            return None;
        }
        let against = &self.friction.sigma * self.velocity.signum();
        let a = (&self.force - against) / &self.mu;
        let [phi_1, phi_2] = [phi(&z, 1), phi(&z, 2)];
        // Both are linear in φ, so extreme at its ends.
        let slope = &a * t - &self.velocity * &z;
        let velocity = along(&phi_1, |phi| &self.velocity + &slope * phi);
        let drift = along(&phi_1, |phi| &self.xi + &self.velocity * t * phi);
        let pull = along(&phi_2, |phi| &a * t * t * phi);
        let xi = Interval::hull(drift.lo() + pull.lo(), drift.hi() + pull.hi());
        // Velocity is monotone within a piece, so its signs at the ends are those in between.
        let turned = match self.velocity.is_positive() {
            true => velocity.lo().is_negative(),
            false => velocity.hi().is_positive(),
        };
        (!turned).then(|| Arrival {
            xi: outward(&xi),
            velocity: outward(&velocity),
        })
    }
}

/// The values of a linear function over an interval.
fn along(
    of: &Interval<BigRational>,
    f: impl Fn(&BigRational) -> BigRational,
) -> Interval<BigRational> {
    Interval::hull(f(of.lo()), f(of.hi()))
}

/// φ_k(−z) = Σ (−z)ʲ/(j + k)! for 0 ≤ z ≤ 1: alternating and falling, so that two consecutive
/// partial sums enclose it.
fn phi(z: &BigRational, k: u32) -> Interval<BigRational> {
    /// 1/38! is below 10⁻⁴⁴.
    const TERMS: u32 = 38;
    let mut term = (1..=k).fold(BigRational::one(), |x, n| x / BigInt::from(n));
    let (mut sum, mut before) = (term.clone(), BigRational::zero());
    if z.is_zero() {
        return Interval::point(sum);
    }
    for j in 1..TERMS {
        term = -term * z / BigInt::from(j + k);
        before = sum.clone();
        sum += &term;
    }
    Interval::hull(before, sum)
}

/// Rounded outward to [`DIGITS`] decimal places; exact numbers stay.
fn outward(range: &Interval<BigRational>) -> Figure<BigRational> {
    if range.is_point() {
        return Figure::Exact(range.lo().clone());
    }
    let scale = BigRational::from_integer(BigInt::from(10).pow(DIGITS));
    Figure::Enclosed(Interval::hull(
        (range.lo() * &scale).floor() / &scale,
        (range.hi() * &scale).ceil() / &scale,
    ))
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
