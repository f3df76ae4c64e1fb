//! The whole numbers that a row is made of, and sums of their products: in the machine's words where these hold them, else
//! with powers of two of their own.

use std::fmt::Debug;

use num_traits::{PrimInt, Signed, Zero};

use super::Line;
use super::factored::{Factored, Primes, Quotient};
use crate::ball::Ball;

/// A number that is computed with exactly. What is too long for its kind is `None`.
pub(crate) trait Exact: Copy + Debug {
    fn zero() -> Self;
    fn plus(self, other: Self) -> Option<Self>;
    fn minus(self, other: Self) -> Option<Self>;
    fn is_negative(self) -> bool;
    /// Itself times a power of two; `None` of whole numbers but for one.
    fn by_twos(self, twos: u32) -> Option<Self>;
}

/// A number of a row: a position or a force, in units of the log, or a product of few of them.
pub(crate) trait Term: Exact + From<i64> {
    /// What products with factors of a log are summed up in.
    type Sum: Total;

    fn times(self, other: Self) -> Option<Self>;
    /// The whole numbers next to it, below and above: itself, twice, where it is one.
    fn next_to(self) -> Option<[i64; 2]>;
    /// Its size, as a whole number over a power of two.
    fn size_over_twos(self) -> Option<(u64, u32)>;
    /// Around it over this number, which is above zero.
    fn near(self, over: i64) -> Ball;
    /// Itself times a factor.
    fn by(self, factor: i128) -> Option<Self::Sum>;
    fn square(self) -> Option<Self::Sum>;

    #[inline(always)]
    fn size(self) -> Option<Self> {
        match self.is_negative() {
            true => Self::zero().minus(self),
            false => Some(self),
        }
    }

    #[inline(always)]
    fn at_least_zero(self) -> Self {
        match self.is_negative() {
            true => Self::zero(),
            false => self,
        }
    }

    #[inline(always)]
    fn at_most_zero(self) -> Self {
        match self.is_negative() {
            true => self,
            false => Self::zero(),
        }
    }
}

/// A sum of products of terms with factors of a log.
pub(crate) trait Total: Exact + From<i128> {
    /// What holds its size.
    type Size: Size;

    fn by(self, n: i64) -> Option<Self>;
    fn square(self) -> Option<Self>;
    /// What it leaves of its size, or of that times a power of two, over an odd number.
    fn remainder(self, of: u64) -> u64;
    /// A multiple of a number over that, which has this inverse in 128 bits.
    fn divided(self, by: u64, inverse: u128) -> Self;
    /// Itself over a number of known primes, and perhaps over one that has nothing in common with it.
    fn quotient(self, primes: &Primes, over: &Factored, rest: u64) -> Option<Quotient<Self::Size>>;
}

/// A whole number above zero, or zero, that is written.
pub(crate) trait Size: Copy + Debug + From<u128> {
    /// Its logarithm, where it is a power of two below 2¹²⁸.
    fn as_power(self) -> Option<u32>;
    /// Appends its digits; `None` where there is no room.
    fn write(self, line: &mut Line<'_>) -> Option<()>;
}

/// A product of less than 126 bits.
#[inline(always)]
fn times(a: i128, b: i64) -> Option<i128> {
    let zeros = a.unsigned_abs().leading_zeros() + b.unsigned_abs().leading_zeros();
    (zeros > u64::BITS + 2).then(|| a.wrapping_mul(b.into()))
}

impl<T: PrimInt + Signed + Debug> Exact for T {
    #[inline(always)]
    fn zero() -> Self {
        <T as Zero>::zero()
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Option<Self> {
        self.checked_add(&other)
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Option<Self> {
        self.checked_sub(&other)
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        Signed::is_negative(&self)
    }

    #[inline(always)]
    fn by_twos(self, twos: u32) -> Option<Self> {
        (twos == 0).then_some(self)
    }
}

impl Term for i64 {
    type Sum = i128;

    #[inline(always)]
    fn times(self, other: Self) -> Option<Self> {
        self.checked_mul(other)
    }

    #[inline(always)]
    fn next_to(self) -> Option<[i64; 2]> {
        Some([self; 2])
    }

    #[inline(always)]
    fn size_over_twos(self) -> Option<(u64, u32)> {
        Some((self.unsigned_abs(), 0))
    }

    #[inline(always)]
    fn near(self, over: i64) -> Ball {
        Ball::ratio(self, over)
    }

    #[inline(always)]
    fn by(self, factor: i128) -> Option<i128> {
        times(factor, self)
    }

    #[inline(always)]
    fn square(self) -> Option<i128> {
        times(self.into(), self)
    }
}

impl Total for i128 {
    type Size = u128;

    #[inline(always)]
    fn by(self, n: i64) -> Option<Self> {
        times(self, n)
    }

    #[inline(always)]
    fn square(self) -> Option<Self> {
        self.checked_mul(self)
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation)] // it is below the number
    fn remainder(self, of: u64) -> u64 {
        (self.unsigned_abs() % u128::from(of)) as u64
    }

    #[inline(always)]
    fn divided(self, by: u64, inverse: u128) -> Self {
        match by {
            1 => self,
            _ => self.wrapping_mul(inverse.cast_signed()),
        }
    }

    #[inline(always)]
    fn quotient(self, primes: &Primes, over: &Factored, rest: u64) -> Option<Quotient<u128>> {
        primes.quotient(self, over, rest)
    }
}

impl Size for u128 {
    #[inline(always)]
    fn as_power(self) -> Option<u32> {
        self.is_power_of_two().then(|| self.trailing_zeros())
    }

    #[inline(always)]
    fn write(self, line: &mut Line<'_>) -> Option<()> {
        line.append_wide(self)
    }
}
