//! Columns whose numbers are whole multiples of one unit.

use passivity_core::{BigRational, Scalar as _};

use super::{Numbers, Readings};
use crate::log::scale::Scale;
use crate::number::{Bits, Dyadic, Exact as _, Term, power_of_ten};

/// What all numbers of a column are whole multiples of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unit {
    /// 10^−k.
    Tens(u8),
    /// 2^−k.
    Twos(u8),
}

impl Unit {
    /// One over it, where 64 bits hold that.
    pub(crate) fn denominator(self) -> Option<i64> {
        match self {
            Self::Tens(k) => power_of_ten(k.into()),
            Self::Twos(k) => 1_i64.checked_shl(k.into()).filter(|n| *n > 0),
        }
    }
}

impl Numbers {
    /// What all of them are multiples of, or of doubles that have nothing but a very small unit in common, one; `None` where
    /// it is not told by how they are written.
    pub(crate) fn unit(&self) -> Option<Unit> {
        /// Past that, products of numbers are too long.
        const MOST: u8 = 20;
        match self {
            Self::Decimals(_, powers) => powers.iter().max().map(|k| Unit::Tens(*k)),
            Self::Doubles(values) => {
                let is_multiple = |k: &u8| {
                    let size = f64::from(1_u32 << k);
                    values.iter().all(|x| (x * size).trunc() == x * size)
                };
                Some(Unit::Twos(
                    (0..=MOST).step_by(4).find(is_multiple).unwrap_or(0),
                ))
            }
            Self::Any(_) => None,
        }
    }

    /// How many units the number at `i` is.
    #[inline]
    pub(crate) fn whole_at(&self, i: usize, unit: Unit) -> Option<i64> {
        match (self, unit) {
            (Self::Decimals(numerators, powers), Unit::Tens(k)) => {
                let (n, less) = (*numerators.get(i)?, k.checked_sub(*powers.get(i)?)?);
                match less {
                    0 => Some(n),
                    less => n.checked_mul(power_of_ten(less.into())?),
                }
            }
            (Self::Doubles(values), Unit::Twos(k)) => {
                let x = values.get(i)? * f64::from(1_u32.checked_shl(k.into())?);
                let is_whole = x.trunc() == x && x.abs() < (1_u64 << f64::MANTISSA_DIGITS) as f64;
                is_whole.then_some(x as i64)
            }
            _ => None,
        }
    }
}

/// How the numbers of a column are computed with.
pub(crate) trait Read: Term {
    /// How many units the number at `i` is, where its kind holds that.
    fn read(column: &Numbers, i: usize, unit: Unit) -> Option<Self>;
}

impl Read for i64 {
    #[inline(always)]
    fn read(column: &Numbers, i: usize, unit: Unit) -> Option<Self> {
        column.whole_at(i, unit)
    }
}

impl<N: Bits> Read for Dyadic<N> {
    #[inline]
    fn read(column: &Numbers, i: usize, unit: Unit) -> Option<Self> {
        match (column, unit) {
            (Numbers::Doubles(values), Unit::Twos(k)) => {
                Self::of(*values.get(i)?)?.by_twos(k.into())
            }
            _ => column.whole_at(i, unit).map(Self::from),
        }
    }
}

impl Readings {
    /// What a number is multiplied with; `None` where that has π in it.
    pub(crate) fn factor(&self) -> Option<BigRational> {
        match &self.scale {
            Scale::One => Some(BigRational::one()),
            Scale::Factor(factor) => Some(factor.to_rational()),
            Scale::Irrational(_) => None,
        }
    }
}
