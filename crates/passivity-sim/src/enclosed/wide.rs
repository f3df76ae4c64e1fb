//! Ends of intervals with any number of bits.

use std::cmp::Ordering;

use astro_float::{BigFloat, RoundingMode};
use passivity_core::BigRational;

use crate::big;
use crate::enclosed::{Directed, Enclosed};
use crate::real::Undecided;

/// A number of any precision, as an end of an interval.
#[derive(Clone, Debug)]
pub struct Wide {
    x: BigFloat,
    bits: usize,
}

fn mode(up: bool) -> RoundingMode {
    if up {
        RoundingMode::Up
    } else {
        RoundingMode::Down
    }
}

impl Wide {
    fn with(&self, x: BigFloat) -> Self {
        Self { x, bits: self.bits }
    }
}

impl Directed for Wide {
    fn add(&self, other: &Self, up: bool) -> Self {
        self.with(self.x.add(&other.x, self.bits, mode(up)))
    }

    fn mul(&self, other: &Self, up: bool) -> Self {
        self.with(self.x.mul(&other.x, self.bits, mode(up)))
    }

    fn div(&self, other: &Self, up: bool) -> Self {
        self.with(self.x.div(&other.x, self.bits, mode(up)))
    }

    fn negated(&self) -> Self {
        self.with(BigFloat::neg(&self.x))
    }

    fn floored(&self) -> Self {
        self.with(self.x.floor())
    }

    fn signum(&self) -> Result<Ordering, Undecided> {
        big::sign(&self.x)
    }

    fn order(&self, other: &Self) -> Ordering {
        self.x.cmp(&other.x).map_or(Ordering::Equal, |c| c.cmp(&0))
    }

    fn fraction(&self, n: i32, m: i32, up: bool) -> Self {
        let (n, m) = (BigFloat::from_i32(n, 64), BigFloat::from_i32(m, 64));
        self.with(n.div(&m, self.bits, mode(up)))
    }

    fn near(&self) -> f64 {
        big::to_double(&self.x)
    }

    fn precision(&self) -> u32 {
        u32::try_from(self.bits).unwrap_or(u32::MAX)
    }
}

impl Enclosed<Wide> {
    /// The tightest interval of numbers of `bits` bits around a rational number.
    #[must_use]
    pub fn wide(x: &BigRational, bits: usize) -> Self {
        let end = |up| Wide {
            x: big::from_rational(x, bits, mode(up)),
            bits,
        };
        Self {
            lo: end(false),
            hi: end(true),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::Scalar;

    #[test]
    fn a_wide_interval_holds_a_narrower_one() {
        let x = BigRational::integer(1).over(BigRational::integer(3));
        let wide = Enclosed::wide(&x, 128);
        let product = wide.clone() * wide.clone() / wide;
        let [lo, hi] = product.ends();
        assert!((lo - 1.0 / 3.0).abs() < 1e-16 && (hi - 1.0 / 3.0).abs() < 1e-16);
        assert!(!product.is_thin());
    }
}
