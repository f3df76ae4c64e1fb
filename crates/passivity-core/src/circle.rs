//! Sines and cosines of fractions of a turn, in fixed point.

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;

use crate::interval::Interval;
use crate::pi;
use crate::scalar::Scalar;
use crate::whole::dyadic;

/// Sines to so many bits after the point, up to 4000, off by less than one unit of the last place.
///
/// Computed with 32 bits more: the angle, below 2π, is off by at most 10 of those smaller units, and
/// each of n terms of the series, none above 2⁷, by at most 2¹³·n; so the sum by 2¹³·n² + 10 < 2³²,
/// as n ≤ 700.
pub struct Circle {
    bits: u32,
    /// π in units of 2^−(`bits` + 32).
    pi: BigInt,
}

impl Circle {
    const SPARE: u32 = 32;

    /// Sines to so many bits.
    #[must_use]
    pub fn to(bits: u32) -> Self {
        let [pi, _] = pi::scaled(bits + Self::SPARE);
        Self { bits, pi }
    }

    /// sin(2πx) in units of 2^−`bits`, for 0 ≤ x.
    pub(crate) fn sine(&self, turns: &BigRational) -> BigInt {
        let one = BigInt::from(1) << (self.bits + Self::SPARE);
        let within = turns - Scalar::floor(turns);
        let angle: BigInt = &self.pi * 2 * within.numer() / within.denom();
        let square = &angle * &angle / &one;
        let (mut term, mut sum) = (angle.clone(), angle);
        let mut i = 1_u32;
        while term != BigInt::ZERO {
            // Towards zero, so that it ends there.
            term = -(term * &square / &one / ((i + 1) * (i + 2)));
            sum += &term;
            i += 2;
        }
        sum >> Self::SPARE
    }

    /// An enclosure of cos(2πx), for 0 ≤ x; a point where x is a multiple of a quarter or a sixth,
    /// and the cosine one of ½. An end may be outside of [−1, 1].
    #[must_use]
    pub fn cosine(&self, turns: &BigRational) -> Interval<BigRational> {
        let close = self.sine(&(turns + BigRational::one().half().half()));
        let is_rational = [BigInt::from(4), BigInt::from(6)]
            .iter()
            .any(|n| (n * turns.numer()).is_multiple_of(turns.denom()));
        let end = |n: BigInt| dyadic(n, self.bits);
        if is_rational {
            return Interval::point(end(close).double().round().half());
        }
        Interval::hull(end(&close - 1), end(&close + 1))
    }

    /// About the x in [0, ½] with cos(2πx) = `cosine`.
    pub(crate) fn turns_to(&self, cosine: &BigRational) -> BigRational {
        let one = BigRational::from_integer(BigInt::from(1) << self.bits);
        let wanted = (cosine * one).to_integer();
        let quarter = BigRational::one().half().half();
        let (mut x, mut step) = (quarter.clone(), quarter.clone());
        for _ in 0..self.bits {
            step = step.half();
            let above = self.sine(&(&x + &quarter)) > wanted;
            x = if above { x + &step } else { x - &step };
        }
        x
    }
}
