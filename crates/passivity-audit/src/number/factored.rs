//! Fractions over denominators of which the prime factors are known: brought to lowest terms without looking for a
//! common divisor, as an audit may write millions of them.

use ethnum::{I256, U256};
use num_bigint::BigInt;
use num_traits::ToPrimitive as _;

use super::Line;
use super::terms::{Size, Total};

/// As many odd primes are kept.
const MOST: usize = 16;

/// An odd prime, with what tells its multiples: multiplying by the inverse divides these, and takes others past `most`.
#[derive(Clone, Copy, Debug, Default)]
struct Prime {
    of: u64,
    inverse: u128,
    most: u128,
    /// What 2¹²⁸ leaves.
    rest_of_half: u128,
}

impl Prime {
    fn new(of: u64) -> Self {
        Self {
            of,
            inverse: inverse(of),
            most: u128::MAX / u128::from(of),
            rest_of_half: (u128::MAX % u128::from(of) + 1) % u128::from(of),
        }
    }

    /// n divided by the prime, where it is a multiple.
    #[inline(always)]
    const fn divided(&self, n: u128) -> Option<u128> {
        let quotient = n.wrapping_mul(self.inverse);
        if quotient <= self.most {
            Some(quotient)
        } else {
            None
        }
    }

    /// The same, faster where 64 bits are enough.
    #[inline(always)]
    fn divided_of_any_length(&self, n: u128) -> Option<u128> {
        match u64::try_from(n) {
            Ok(n) => self.divided_short(n).map(u128::from),
            Err(_) => self.divided(n),
        }
    }

    /// The same of a number of 256 bits.
    fn divided_wide(&self, n: U256) -> Option<U256> {
        let (high, low) = n.into_words();
        if high == 0 {
            return self.divided(low).map(U256::from);
        }
        // What is left of the upper half and, beside it, the lower one.
        let of = u128::from(self.of);
        let rest = high % of * self.rest_of_half + low % of;
        rest.is_multiple_of(of).then(|| n / U256::from(of))
    }

    /// The same of a number of 64 bits.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation)] // The lower half of an inverse is the inverse of the lower half.
    const fn divided_short(&self, n: u64) -> Option<u64> {
        let quotient = n.wrapping_mul(self.inverse as u64);
        if quotient <= (self.most >> u64::BITS) as u64 {
            Some(quotient)
        } else {
            None
        }
    }
}

/// What an odd number is multiplied with to be one, in 128 bits: multiples of it are divided by it so.
#[inline]
fn inverse(of: u64) -> u128 {
    let wide = u128::from(of);
    // Each step doubles the bits that are right, of which the number itself has three.
    let step = |x: u64| x.wrapping_mul(2_u64.wrapping_sub(of.wrapping_mul(x)));
    let half = u128::from(step(step(step(step(step(of))))));
    half.wrapping_mul(2_u128.wrapping_sub(wide.wrapping_mul(half)))
}

/// The greatest common divisor of an odd number and another: without branches that depend on their bits, of which
/// processors guess half wrongly.
#[inline]
fn divisor_of_odd(odd: u64, n: u64) -> u64 {
    if n == 0 {
        return odd;
    }
    let mut less = n >> n.trailing_zeros();
    let mut more = odd % less;
    while more != 0 {
        more >>= more.trailing_zeros();
        (less, more) = (less.min(more), less.abs_diff(more));
    }
    less
}

/// The odd primes that some denominators are made of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Primes(Vec<Prime>);

/// A number above zero that is made of known primes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factored {
    of: u128,
    twos: u32,
    powers: [u8; MOST],
}

/// A number above zero as one of known primes times the rest, which has none of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Split {
    known: Factored,
    rest: u64,
}

/// Whether a number is below zero. As wide as a word: what is narrower is copied together with bytes beside it that no one
/// has written, for which processors wait.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
enum Sign {
    Positive = 1,
    Negative = 2,
}

impl Sign {
    #[inline(always)]
    const fn of(is_negative: bool) -> Self {
        if is_negative {
            Self::Negative
        } else {
            Self::Positive
        }
    }
}

/// A fraction in lowest terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quotient<S = u128> {
    numerator: S,
    denominator: S,
    sign: Sign,
}

impl Primes {
    /// The odd primes in some numbers above zero; `None` where these are too many, or too large to be found.
    pub(crate) fn of(numbers: &[BigInt]) -> Option<Self> {
        /// A number without divisors below is a prime where it is below the square of this.
        const TRIED: u64 = 1 << 16;
        let mut found: Vec<u64> = Vec::new();
        for n in numbers {
            let twos = n.trailing_zeros()?;
            let mut rest = (n >> twos).to_u64()?;
            for p in &found {
                while rest % p == 0 {
                    rest /= p;
                }
            }
            for p in (3..TRIED).step_by(2) {
                if p * p > rest {
                    break;
                }
                if rest % p == 0 {
                    found.push(p);
                }
                while rest % p == 0 {
                    rest /= p;
                }
            }
            if rest >= TRIED * TRIED {
                return None;
            }
            if rest > 1 {
                found.push(rest);
            }
        }
        found.sort_unstable();
        (found.len() <= MOST).then(|| Self(found.into_iter().map(Prime::new).collect()))
    }

    /// A number above zero by its primes; `None` where it has others, or more than 126 bits.
    pub(crate) fn factored(&self, n: &BigInt) -> Option<Factored> {
        let of = n.to_u128().filter(|n| (1..1 << 126).contains(n))?;
        let twos = of.trailing_zeros();
        let (mut rest, mut powers) = (of >> twos, [0; MOST]);
        for (prime, power) in self.0.iter().zip(&mut powers) {
            while let Some(quotient) = prime.divided(rest) {
                (rest, *power) = (quotient, *power + 1);
            }
        }
        (rest == 1).then_some(Factored { of, twos, powers })
    }

    /// A number above zero, split; zero as one.
    #[inline]
    pub(crate) fn split(&self, n: u64) -> Split {
        let n = n.max(1);
        let twos = n.trailing_zeros();
        let (mut rest, mut powers) = (n >> twos, [0; MOST]);
        for (prime, power) in self.0.iter().zip(&mut powers) {
            while let Some(quotient) = prime.divided_short(rest) {
                (rest, *power) = (quotient, *power + 1);
            }
        }
        // What is left is above zero.
        let of = n.checked_div(rest).unwrap_or(1).into();
        Split {
            known: Factored { of, twos, powers },
            rest,
        }
    }

    /// n over a number of known primes, and perhaps over one that has nothing in common with n.
    #[inline]
    pub(crate) fn quotient(&self, n: i128, over: &Factored, rest: u64) -> Option<Quotient> {
        let (sign, n) = (Sign::of(n < 0), n.unsigned_abs());
        if n == 0 {
            return Some(Quotient {
                sign,
                numerator: 0,
                denominator: 1,
            });
        }
        let denominator = match rest {
            1 => over.of,
            rest => over.of.checked_mul(rest.into())?,
        };
        let twos = n.trailing_zeros().min(over.twos);
        let both = (n >> twos, denominator >> twos);
        let (numerator, denominator) = self.reduced(both, over, Prime::divided_of_any_length);
        Some(Quotient {
            sign,
            numerator,
            denominator,
        })
    }

    /// A numerator and a denominator without the odd primes of this number that they have in common, given how a numerator is
    /// divided by a prime.
    #[inline(always)]
    fn reduced<N: Copy>(
        &self,
        (mut n, mut d): (N, u128),
        over: &Factored,
        divided: impl Fn(&Prime, N) -> Option<N>,
    ) -> (N, u128) {
        for (prime, power) in self.0.iter().zip(over.powers) {
            for _ in 0..power {
                let Some(quotient) = divided(prime, n) else {
                    break;
                };
                (n, d) = (quotient, d.wrapping_mul(prime.inverse));
            }
        }
        (n, d)
    }

    /// The same of n over a power of two, in 256 bits.
    pub(crate) fn wide_quotient(
        &self,
        (n, more): (I256, u32),
        over: &Factored,
        rest: u64,
    ) -> Option<Quotient<U256>> {
        let (sign, n) = (Sign::of(n.is_negative()), n.unsigned_abs());
        if n == U256::ZERO {
            return Some(Quotient {
                sign,
                numerator: n,
                denominator: U256::ONE,
            });
        }
        let twos = over.twos + more;
        let common = twos.min(n.trailing_zeros());
        let d = over.of >> over.twos;
        // What 128 bits hold is computed with faster.
        let (numerator, d) = match n.into_words() {
            (0, n) => {
                let (n, d) = self.reduced((n >> common, d), over, Prime::divided_of_any_length);
                (n.into(), d)
            }
            _ => self.reduced((n >> common, d), over, Prime::divided_wide),
        };
        let twos = twos - common;
        let denominator = match rest {
            1 if d.leading_zeros() > twos => (d << twos).into(),
            rest => {
                let d = U256::from(d) * U256::from(rest);
                (d.leading_zeros() > twos).then(|| d << twos)?
            }
        };
        Some(Quotient {
            sign,
            numerator,
            denominator,
        })
    }
}

impl Factored {
    pub(crate) const ONE: Self = Self {
        of: 1,
        twos: 0,
        powers: [0; MOST],
    };

    pub(crate) const TWO: Self = Self {
        of: 2,
        twos: 1,
        ..Self::ONE
    };

    /// The number, below 2¹²⁷.
    pub(crate) fn to_i128(self) -> Option<i128> {
        self.of.try_into().ok()
    }

    /// The product; `None` past 128 bits.
    #[inline]
    pub(crate) fn times(&self, other: &Self) -> Option<Self> {
        let mut powers = self.powers;
        for (power, more) in powers.iter_mut().zip(other.powers) {
            *power = power.wrapping_add(more);
        }
        Some(Self {
            of: self.of.checked_mul(other.of)?,
            twos: self.twos + other.twos,
            powers,
        })
    }
}

/// What is left of a denominator beside what it has in common with the numerator.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside {
    /// What is made of known primes, and the rest.
    pub(crate) known: Factored,
    pub(crate) rest: u64,
    /// What was in common, and what its multiples are divided by it with.
    common: u64,
    inverse: u128,
}

impl Beside {
    pub(crate) const ONE: Self = Self {
        known: Factored::ONE,
        rest: 1,
        common: 1,
        inverse: 1,
    };

    /// A multiple of what was in common over that.
    #[inline(always)]
    pub(crate) fn divided<T: Total>(&self, n: T) -> T {
        n.divided(self.common, self.inverse)
    }
}

impl Split {
    /// What is left where the rest and the numerator have as much in common as the rest has with a product.
    #[inline]
    pub(crate) fn beside(&self, product: [u128; 3]) -> Beside {
        if self.rest == 1 {
            return self.without(1);
        }
        let remainder = |n: u128| match u64::try_from(n) {
            Ok(n) => n % self.rest,
            // It is below the rest.
            Err(_) => (n % u128::from(self.rest)) as u64,
        };
        let product = product.into_iter().fold(1_u64, |all, n| {
            remainder(u128::from(all) * u128::from(remainder(n)))
        });
        self.without(product)
    }

    /// What is left beside a numerator.
    pub(crate) fn beside_sum<T: Total>(&self, n: T) -> Beside {
        self.without(n.remainder(self.rest))
    }

    /// What is left without what the rest has in common with a number.
    #[inline(always)]
    fn without(&self, n: u64) -> Beside {
        let common = match self.rest {
            1 => 1,
            rest => divisor_of_odd(rest, n),
        };
        match common {
            1 => Beside {
                known: self.known,
                rest: self.rest,
                ..Beside::ONE
            },
            common => Beside {
                known: self.known,
                rest: self.rest / common,
                common,
                inverse: inverse(common),
            },
        }
    }
}

impl Quotient {
    /// The same in numbers of another kind.
    #[inline(always)]
    pub(crate) fn widened<S: Size>(self) -> Quotient<S> {
        let Self {
            sign,
            numerator,
            denominator,
        } = self;
        Quotient {
            sign,
            numerator: numerator.into(),
            denominator: denominator.into(),
        }
    }
}

impl<S: Size> Quotient<S> {
    /// Whether it is below zero.
    #[inline(always)]
    pub(crate) fn is_negative(&self) -> bool {
        self.sign == Sign::Negative
    }

    /// Appends it after a comma; `None` where there is no room.
    #[inline]
    pub(crate) fn write(&self, line: &mut Line<'_>) -> Option<()> {
        line.append_some(*b",-", self.sign as u32)?;
        self.numerator.write(line)?;
        if let Some(logarithm) = self.denominator.as_power() {
            return line.append_over_power(logarithm.into());
        }
        line.append_some(*b"/", 1)?;
        self.denominator.write(line)
    }
}

#[cfg(test)]
mod tests;
