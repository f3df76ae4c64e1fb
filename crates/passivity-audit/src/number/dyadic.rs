//! Numbers of 256 bits over powers of two: what doubles are, and sums of their products.

use ethnum::{I256, U256};

use super::factored::{Factored, Primes, Quotient};
use super::terms::{Exact, Size, Term, Total};
use super::{Line, Number};
use crate::ball::Ball;

/// n/2^k.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dyadic {
    n: I256,
    twos: u32,
}

/// The same number in 128 bits, in which most are: it is computed with faster.
#[inline(always)]
fn narrow(n: I256) -> Option<i128> {
    let (upper, lower) = n.into_words();
    (upper == lower >> (i128::BITS - 1)).then_some(lower)
}

/// n·2^k, where 255 bits hold it.
#[inline(always)]
fn shifted(n: I256, k: u32) -> Option<I256> {
    if k == 0 || n == I256::ZERO {
        return Some(n);
    }
    match narrow(n).filter(|n| n.unsigned_abs().leading_zeros() > k.saturating_add(1)) {
        Some(n) => Some((n << k).into()),
        None => (n.unsigned_abs().leading_zeros() > k.saturating_add(1)).then(|| n << k),
    }
}

/// A product, where 254 bits hold it.
#[inline(always)]
fn times(a: I256, b: I256) -> Option<I256> {
    if let (Some(a), Some(b)) = (narrow(a), narrow(b)) {
        let zeros = a.unsigned_abs().leading_zeros() + b.unsigned_abs().leading_zeros();
        if zeros > u128::BITS + 2 {
            return Some(a.wrapping_mul(b).into());
        }
    }
    let zeros = a.unsigned_abs().leading_zeros() + b.unsigned_abs().leading_zeros();
    (zeros > U256::BITS + 2).then(|| a.wrapping_mul(b))
}

impl Dyadic {
    /// What a double is.
    pub(crate) fn of(x: f64) -> Option<Self> {
        let (n, twos) = match Number::from_f64(x)? {
            Number::Small(n, d) => (n, d.trailing_zeros()),
            Number::Tiny(n, twos) => (n, twos),
            Number::Big(_) => return None,
        };
        Some(Self { n: n.into(), twos })
    }

    /// Two numbers over the same power of two, and which.
    #[inline]
    fn over_one(self, other: Self) -> Option<([I256; 2], u32)> {
        let twos = self.twos.max(other.twos);
        let [a, b] = [self, other].map(|x| shifted(x.n, twos - x.twos));
        Some(([a?, b?], twos))
    }

    /// The same over the least power of two.
    #[inline]
    fn reduced(self) -> Self {
        if self.n == I256::ZERO {
            return Self::zero();
        }
        let twos = self.twos.min(self.n.trailing_zeros());
        Self {
            n: self.n >> twos,
            twos: self.twos - twos,
        }
    }
}

impl From<i128> for Dyadic {
    #[inline]
    fn from(n: i128) -> Self {
        Self {
            n: n.into(),
            twos: 0,
        }
    }
}

impl From<i64> for Dyadic {
    #[inline]
    fn from(n: i64) -> Self {
        i128::from(n).into()
    }
}

impl Exact for Dyadic {
    #[inline]
    fn zero() -> Self {
        0_i64.into()
    }

    #[inline(never)]
    fn plus(self, other: Self) -> Option<Self> {
        if self.n == I256::ZERO {
            return Some(other);
        }
        let ([a, b], twos) = self.over_one(other)?;
        let n = a.checked_add(b)?;
        Some(Self { n, twos })
    }

    #[inline(never)]
    fn minus(self, other: Self) -> Option<Self> {
        let ([a, b], twos) = self.over_one(other)?;
        let n = a.checked_sub(b)?;
        Some(Self { n, twos })
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.n.is_negative()
    }

    #[inline(never)]
    fn by_twos(self, twos: u32) -> Option<Self> {
        Some(Self {
            n: shifted(self.n, twos.saturating_sub(self.twos))?,
            twos: self.twos.saturating_sub(twos),
        })
    }
}

impl Term for Dyadic {
    type Sum = Self;

    #[inline(never)]
    fn times(self, other: Self) -> Option<Self> {
        Some(Self {
            n: times(self.n, other.n)?,
            twos: self.twos + other.twos,
        })
    }

    #[inline(never)]
    fn next_to(self) -> Option<[i64; 2]> {
        // Shifting rounds down, to minus one or zero at last.
        let below = self.n >> self.twos.min(I256::BITS - 1);
        let whole = i64::try_from(below).ok()?;
        match self.n == I256::ZERO || self.n.trailing_zeros() >= self.twos {
            true => Some([whole; 2]),
            false => Some([whole, whole.checked_add(1)?]),
        }
    }

    #[inline(never)]
    fn size_over_twos(self) -> Option<(u64, u32)> {
        let Self { n, twos } = self.reduced();
        Some((u64::try_from(n.unsigned_abs()).ok()?, twos))
    }

    #[inline(never)]
    fn near(self, over: i64) -> Ball {
        let unit = Ball::of(&Number::Tiny(1, self.twos));
        match narrow(self.n) {
            Some(n) => Ball::wide_ratio(n, over.into()) * unit,
            None => Ball::UNDEFINED,
        }
    }

    #[inline(never)]
    fn by(self, factor: i128) -> Option<Self> {
        Some(Self {
            n: times(self.n, factor.into())?,
            ..self
        })
    }

    fn square(self) -> Option<Self> {
        let x = self.reduced();
        x.times(x)
    }
}

impl Total for Dyadic {
    type Size = U256;

    fn by(self, n: i64) -> Option<Self> {
        Term::by(self, n.into())
    }

    fn square(self) -> Option<Self> {
        Term::square(self)
    }

    #[inline(never)]
    fn remainder(self, of: u64) -> u64 {
        (self.n.unsigned_abs() % U256::from(of)).as_u64()
    }

    #[inline(never)]
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
    fn is_one(self) -> bool {
        self == Self::ONE
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

    fn rational(x: Dyadic) -> BigRational {
        let n: BigInt = x.n.to_string().parse().unwrap();
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

    proptest! {
        #[test]
        fn numbers_are_those_of_exact_arithmetic(
            [a, b] in doubles(), [c, d] in doubles(), factor in any::<i128>(), shift in 0..127_u32, odd: u64,
        ) {
            let known = [a, b, c, d].map(|x| BigRational::from_float(x).unwrap());
            let is_of_some_size = [a, b, c].iter().all(|x| *x == 0.0 || (1e-28..1e25).contains(&x.abs()));
            let [Some(a), Some(b), Some(c), Some(d)] = [a, b, c, d].map(Dyadic::of) else {
                return Ok(());
            };
            let [e, f, g, h] = &known;
            prop_assert_eq!(&rational(a), e);
            let (factor, odd) = (factor >> shift, odd | 1);
            let times = BigRational::from_integer(factor.into());
            let found = [
                (a.plus(b), e + f),
                (a.minus(b), e - f),
                (a.times(c), e * g),
                (Term::by(a, factor), e * &times),
                (Term::square(b), f * f),
                (a.size(), e.abs()),
                (a.by_twos(shift), e * power(shift)),
                // Of a number and itself nothing is left, over whatever power of two.
                (a.minus(a).and_then(Term::square), BigRational::from_integer(0.into())),
                (a.times(c).and_then(|x| x.minus(b.times(d)?)), e * g - f * h),
            ];
            for (found, expected) in found {
                prop_assert!(found.is_none_or(|x| rational(x) == expected));
            }
            prop_assert_eq!(b.is_negative(), f.is_negative());
            if let Some(next_to) = a.next_to() {
                prop_assert_eq!(next_to.map(BigInt::from), [e.floor(), e.ceil()].map(|x| x.to_integer()));
            }
            if let Some((n, twos)) = a.size_over_twos() {
                prop_assert_eq!(BigRational::from_integer(n.into()) / power(twos), e.abs());
            }
            let (left, over) = (BigInt::from(a.remainder(odd)), BigInt::from(odd));
            prop_assert_eq!(left, (e.abs() * power(a.twos)).to_integer() % over);
            // What has fewer bits than there is room for is never left open.
            prop_assert!(!is_of_some_size || (a.plus(b).is_some() && a.times(c).is_some()));
        }
    }
}
