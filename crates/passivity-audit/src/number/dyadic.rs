//! Whole numbers of 128 or 256 bits over powers of two: what doubles are, and sums of their products.

use std::fmt::Debug;

use ethnum::{I256, U256};

use super::factored::{Factored, Primes, Quotient};
use super::terms::{Exact, Size, Term, Total};
use super::{Line, Number};
use crate::ball::Ball;

/// n/2^k.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dyadic<N> {
    n: N,
    twos: u32,
}

/// A whole number of so many bits. What these do not hold is `None`.
pub(crate) trait Bits: Copy + Debug + PartialEq {
    const ZERO: Self;

    fn of(n: i128) -> Self;
    fn wide(self) -> I256;
    fn plus(self, other: Self) -> Option<Self>;
    fn minus(self, other: Self) -> Option<Self>;
    fn times(self, other: Self) -> Option<Self>;
    /// Itself times a factor, in 256 bits.
    fn by(self, factor: i128) -> Option<I256>;
    /// Itself times 2^k.
    fn shifted(self, k: u32) -> Option<Self>;
    /// Itself over 2^k, rounded down.
    fn floor(self, k: u32) -> Self;
    /// How often two divides it; of zero as often as it has bits.
    fn twos(self) -> u32;
}

macro_rules! bits {
    ($kind:ty, $zero:expr, $as_wide:expr, $by:expr, $product:meta) => {
        impl Bits for $kind {
            const ZERO: Self = $zero;

            #[inline(always)]
            fn of(n: i128) -> Self {
                n.into()
            }

            #[inline(always)]
            fn wide(self) -> I256 {
                $as_wide(self)
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Option<Self> {
                self.checked_add(other)
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Option<Self> {
                self.checked_sub(other)
            }

            #[inline(always)]
            fn by(self, factor: i128) -> Option<I256> {
                $by(self, factor)
            }

            #[$product]
            fn times(self, other: Self) -> Option<Self> {
                let zeros =
                    self.unsigned_abs().leading_zeros() + other.unsigned_abs().leading_zeros();
                (zeros > Self::BITS + 2).then(|| self.wrapping_mul(other))
            }

            #[inline(always)]
            fn shifted(self, k: u32) -> Option<Self> {
                if k == 0 || self == Self::ZERO {
                    return Some(self);
                }
                (self.unsigned_abs().leading_zeros() > k.saturating_add(1)).then(|| self << k)
            }

            #[inline(always)]
            fn floor(self, k: u32) -> Self {
                // Shifting rounds down, to minus one or zero at last.
                self >> k.min(Self::BITS - 1)
            }

            #[inline(always)]
            fn twos(self) -> u32 {
                self.trailing_zeros()
            }
        }
    };
}

bits!(i128, 0, I256::from, wide_product, inline(always));
bits!(
    I256,
    I256::ZERO,
    std::convert::identity,
    |n: I256, factor: i128| n.times(factor.into()),
    inline(never)
);

/// A product of two numbers of 128 bits: 256 bits hold it.
#[inline(always)]
#[allow(clippy::unnecessary_wraps)] // other products may not be held
fn wide_product(n: i128, factor: i128) -> Option<I256> {
    let [a, b] = [n, factor].map(|n| U256::from(n.unsigned_abs()));
    let size = a.wrapping_mul(b).as_i256();
    Some(match (n < 0) == (factor < 0) {
        true => size,
        false => size.wrapping_neg(),
    })
}

impl<N: Bits> Dyadic<N> {
    /// What a double is.
    #[inline]
    pub(crate) fn of(x: f64) -> Option<Self> {
        let (n, twos) = match Number::from_f64(x)? {
            Number::Small(n, d) => (n, d.trailing_zeros()),
            Number::Tiny(n, twos) => (n, twos),
            Number::Big(_) => return None,
        };
        Some(Self {
            n: N::of(n.into()),
            twos,
        })
    }

    /// Two numbers over the same power of two, and which.
    #[inline(always)]
    fn over_one(self, other: Self) -> Option<([N; 2], u32)> {
        let twos = self.twos.max(other.twos);
        let a = self.n.shifted(twos - self.twos)?;
        let b = other.n.shifted(twos - other.twos)?;
        Some(([a, b], twos))
    }

    /// The same over the least power of two.
    #[inline]
    fn reduced(self) -> Self {
        if self.n == N::ZERO {
            return Self::zero();
        }
        let twos = self.twos.min(self.n.twos());
        Self {
            n: self.n.floor(twos),
            twos: self.twos - twos,
        }
    }

    #[inline(always)]
    fn wide(self) -> Dyadic<I256> {
        Dyadic {
            n: self.n.wide(),
            twos: self.twos,
        }
    }
}

impl<N: Bits> From<i128> for Dyadic<N> {
    #[inline(always)]
    fn from(n: i128) -> Self {
        Self {
            n: N::of(n),
            twos: 0,
        }
    }
}

impl<N: Bits> From<i64> for Dyadic<N> {
    #[inline(always)]
    fn from(n: i64) -> Self {
        i128::from(n).into()
    }
}

impl<N: Bits> Exact for Dyadic<N> {
    #[inline(always)]
    fn zero() -> Self {
        0_i64.into()
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Option<Self> {
        if self.n == N::ZERO {
            return Some(other);
        }
        let ([a, b], twos) = self.over_one(other)?;
        let n = a.plus(b)?;
        Some(Self { n, twos })
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Option<Self> {
        let ([a, b], twos) = self.over_one(other)?;
        let n = a.minus(b)?;
        Some(Self { n, twos })
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        self.n.wide().is_negative()
    }

    #[inline(always)]
    fn by_twos(self, twos: u32) -> Option<Self> {
        Some(Self {
            n: self.n.shifted(twos.saturating_sub(self.twos))?,
            twos: self.twos.saturating_sub(twos),
        })
    }
}

impl<N: Bits> Term for Dyadic<N> {
    type Sum = Dyadic<I256>;

    #[inline(always)]
    fn times(self, other: Self) -> Option<Self> {
        Some(Self {
            n: self.n.times(other.n)?,
            twos: self.twos + other.twos,
        })
    }

    #[inline(always)]
    fn next_to(self) -> Option<[i64; 2]> {
        let whole = i64::try_from(self.n.floor(self.twos).wide()).ok()?;
        match self.n == N::ZERO || self.n.twos() >= self.twos {
            true => Some([whole; 2]),
            false => Some([whole, whole.checked_add(1)?]),
        }
    }

    #[inline]
    fn size_over_twos(self) -> Option<(u64, u32)> {
        let Self { n, twos } = self.reduced();
        Some((u64::try_from(n.wide().unsigned_abs()).ok()?, twos))
    }

    #[inline]
    fn near(self, over: i64) -> Ball {
        let unit = Ball::of(&Number::Tiny(1, self.twos));
        match i128::try_from(self.n.wide()) {
            Ok(n) => Ball::wide_ratio(n, over.into()) * unit,
            Err(_) => Ball::UNDEFINED,
        }
    }

    #[inline(always)]
    fn by(self, factor: i128) -> Option<Self::Sum> {
        Some(Dyadic {
            n: self.n.by(factor)?,
            twos: self.twos,
        })
    }

    #[inline]
    fn square(self) -> Option<Self::Sum> {
        let x = self.wide().reduced();
        x.times(x)
    }
}

impl Total for Dyadic<I256> {
    type Size = U256;

    #[inline(always)]
    fn by(self, n: i64) -> Option<Self> {
        Term::by(self, n.into())
    }

    #[inline]
    fn square(self) -> Option<Self> {
        Term::square(self)
    }

    #[inline(never)]
    fn remainder(self, of: u64) -> u64 {
        (self.n.unsigned_abs() % U256::from(of)).as_u64()
    }

    #[inline(always)]
    fn divided(self, by: u64, _: u128) -> Self {
        match by {
            1 => self,
            _ => Self {
                n: self.n / I256::from(by),
                ..self
            },
        }
    }

    #[inline(never)]
    fn quotient(self, primes: &Primes, over: &Factored, rest: u64) -> Option<Quotient<U256>> {
        primes.wide_quotient((self.n, self.twos), over, rest)
    }
}

impl Size for U256 {
    #[inline]
    fn as_power(self) -> Option<u32> {
        u128::try_from(self).ok()?.as_power()
    }

    fn write(self, line: &mut Line<'_>) -> Option<()> {
        line.append_widest(self)
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use num_traits::Signed as _;
    use passivity_core::BigRational;
    use proptest::prelude::*;

    use super::*;

    fn power(k: u32) -> BigRational {
        BigRational::from_integer(BigInt::from(1) << k)
    }

    fn rational(x: Dyadic<impl Bits>) -> BigRational {
        let n: BigInt = x.n.wide().to_string().parse().unwrap();
        BigRational::from_integer(n) / power(x.twos)
    }

    /// Doubles of many sizes, some of them whole numbers or close to another.
    fn doubles() -> impl Strategy<Value = [f64; 2]> {
        let double = || {
            prop_oneof![
                any::<i32>().prop_map(f64::from),
                (any::<i64>(), -90..20_i32).prop_map(|(n, k)| n as f64 * 2_f64.powi(k)),
                (-9_999..9_999_i32, 0..6_i32).prop_map(|(n, k)| f64::from(n) / 10_f64.powi(k)),
                prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL,
                Just(0.0),
            ]
        };
        prop_oneof![
            [double(), double()],
            double().prop_map(|x| [x, x * (1.0 + 2.0 * f64::EPSILON)])
        ]
    }

    /// Holds numbers of one kind against exact arithmetic; whether what is of some size is never left open is asked of wide
    /// ones.
    fn check<N: Bits>(
        numbers: [f64; 4],
        (factor, shift, odd): (i128, u32, u64),
        never_open: bool,
    ) -> Result<(), TestCaseError> {
        let known = numbers.map(|x| BigRational::from_float(x).unwrap());
        let is_of_some_size = |x: &f64| *x == 0.0 || (1e-28..1e25).contains(&x.abs());
        let are_of_some_size = numbers[..3].iter().all(is_of_some_size);
        let [Some(a), Some(b), Some(c), Some(d)] = numbers.map(Dyadic::<N>::of) else {
            return Ok(());
        };
        let [e, f, g, h] = &known;
        prop_assert_eq!(&rational(a), e);
        let times = BigRational::from_integer(factor.into());
        let of_terms = [
            (a.plus(b), e + f),
            (a.minus(b), e - f),
            (a.times(c), e * g),
            (a.size(), e.abs()),
            (a.by_twos(shift), e * power(shift)),
            (a.times(c).and_then(|x| x.minus(b.times(d)?)), e * g - f * h),
        ];
        for (found, expected) in of_terms {
            prop_assert!(found.is_none_or(|x| rational(x) == expected));
        }
        let of_sums = [
            (Term::by(a, factor), e * &times),
            (Term::square(b), f * f),
            // Of a number and itself nothing is left, over whatever power of two.
            (
                a.minus(a).and_then(Term::square),
                BigRational::from_integer(0.into()),
            ),
            (
                Term::by(a, factor).and_then(|x| x.plus(Term::by(b, 3)?)),
                e * &times + f * BigRational::from_integer(3.into()),
            ),
        ];
        for (found, expected) in of_sums {
            prop_assert!(found.is_none_or(|x| rational(x) == expected));
        }
        prop_assert_eq!(b.is_negative(), f.is_negative());
        if let Some(next_to) = a.next_to() {
            let whole = [e.floor(), e.ceil()].map(|x| x.to_integer());
            prop_assert_eq!(next_to.map(BigInt::from), whole);
        }
        if let Some((n, twos)) = a.size_over_twos() {
            prop_assert_eq!(BigRational::from_integer(n.into()) / power(twos), e.abs());
        }
        let (left, over) = (BigInt::from(a.wide().remainder(odd)), BigInt::from(odd));
        prop_assert_eq!(left, (e.abs() * power(a.twos)).to_integer() % over);
        // What has fewer bits than there is room for is never left open.
        let is_found = a.plus(b).is_some() && a.times(c).is_some();
        prop_assert!(!(never_open && are_of_some_size) || is_found);
        Ok(())
    }

    proptest! {
        #[test]
        fn numbers_are_those_of_exact_arithmetic(
            [a, b] in doubles(), [c, d] in doubles(), factor in any::<i128>(), shift in 0..127_u32, odd: u64,
        ) {
            let more = (factor >> shift, shift, odd | 1);
            check::<i128>([a, b, c, d], more, false)?;
            check::<I256>([a, b, c, d], more, true)?;
        }
    }
}
