//! Whole numbers of any size, on the machine where 128 bits hold them: without room of their own in memory.

use std::borrow::Cow;
use std::cmp::Ordering;

use num_bigint::BigInt;
use num_traits::{One as _, ToPrimitive as _, Zero as _};
use passivity_core::fraction::{Fraction, Integer};
use passivity_core::{BigRational, Fixed, whole};

use super::{Reduced, Written, divisor};

/// A whole number, never undefined. What 128 bits hold is held by them, so that equal numbers look equal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Whole(Held);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Held {
    Small(i128),
    /// Past 128 bits.
    Big(Box<BigInt>),
}

/// Exact fractions of whole numbers of any size.
pub type Ample = Fraction<Whole>;

impl From<i128> for Whole {
    fn from(n: i128) -> Self {
        Self(Held::Small(n))
    }
}

impl From<BigInt> for Whole {
    fn from(n: BigInt) -> Self {
        Self(match n.to_i128() {
            Some(n) => Held::Small(n),
            None => Held::Big(Box::new(n)),
        })
    }
}

impl Whole {
    /// The number, where 128 bits hold it.
    const fn small(&self) -> Option<i128> {
        match &self.0 {
            Held::Small(n) => Some(*n),
            Held::Big(_) => None,
        }
    }

    fn big(&self) -> Cow<'_, BigInt> {
        match &self.0 {
            Held::Small(n) => Cow::Owned(BigInt::from(*n)),
            Held::Big(n) => Cow::Borrowed(n),
        }
    }

    /// What machine integers make of two numbers, or big ones where those do not hold it.
    #[inline]
    fn with(
        &self,
        other: &Self,
        small: impl Fn(i128, i128) -> Option<i128>,
        big: impl Fn(&BigInt, &BigInt) -> BigInt,
    ) -> Self {
        let found = self.small().zip(other.small());
        match found.and_then(|(a, b)| small(a, b)) {
            Some(n) => Self(Held::Small(n)),
            None => big(&self.big(), &other.big()).into(),
        }
    }
}

impl Integer for Whole {
    fn from_i32(n: i32) -> Self {
        i128::from(n).into()
    }
    fn add(&self, other: &Self) -> Option<Self> {
        Some(self.with(other, i128::checked_add, |a, b| a + b))
    }
    fn sub(&self, other: &Self) -> Option<Self> {
        Some(self.with(other, i128::checked_sub, |a, b| a - b))
    }
    fn mul(&self, other: &Self) -> Option<Self> {
        // The machine's word is multiplied faster.
        let product = |a: i128, b: i128| match (i64::try_from(a), i64::try_from(b)) {
            (Ok(a), Ok(b)) => Some(i128::from(a) * i128::from(b)),
            _ => a.checked_mul(b),
        };
        Some(self.with(other, product, |a, b| a * b))
    }
    fn div_floor(&self, divisor: &Self) -> Option<Self> {
        if divisor.signum() != Some(Ordering::Greater) {
            return None;
        }
        // With a divisor above zero the Euclidean quotient is the floor.
        let floor = |a: &BigInt, b: &BigInt| num_integer::Integer::div_floor(a, b);
        Some(self.with(divisor, i128::checked_div_euclid, floor))
    }
    fn signum(&self) -> Option<Ordering> {
        Some(match &self.0 {
            Held::Small(n) => n.cmp(&0),
            Held::Big(n) => (**n).cmp(&BigInt::ZERO),
        })
    }
    fn halved(&self) -> Option<Self> {
        match &self.0 {
            Held::Small(n) => (n & 1 == 0).then(|| Self(Held::Small(n / 2))),
            Held::Big(n) => Integer::halved(&**n).map(Self::from),
        }
    }
    fn compare(&self, other: &Self) -> Option<Ordering> {
        Some(match (&self.0, &other.0) {
            (Held::Small(a), Held::Small(b)) => a.cmp(b),
            _ => self.big().cmp(&other.big()),
        })
    }
    fn shortened(numerator: Self, denominator: Self) -> (Self, Self) {
        if let (Some(n), Some(d)) = (numerator.small(), denominator.small())
            && d > 0
            && let Ok(common) = i128::try_from(divisor(n.unsigned_abs(), d.unsigned_abs()))
        {
            return match common {
                1 => (numerator, denominator),
                _ => ((n / common).into(), (d / common).into()),
            };
        }
        let (n, d) = (numerator.big(), denominator.big());
        let common = whole::gcd(&n, &d);
        if common.is_zero() || common.is_one() {
            let same = (n.into_owned(), d.into_owned());
            return (same.0.into(), same.1.into());
        }
        let quotient = |x: &BigInt| Self::from(x / &common);
        (quotient(&n), quotient(&d))
    }
}

/// The number as a fraction of whole numbers of any size.
#[must_use]
pub fn to_ample(x: &BigRational) -> Ample {
    Ample::new(x.numer().clone().into(), x.denom().clone().into())
}

/// The fraction n/d.
pub(crate) fn ample(n: impl Into<i128>, d: impl Into<i128>) -> Ample {
    Ample::new(n.into().into(), d.into().into())
}

impl Written for Ample {
    fn to_reduced(&self) -> Option<Reduced> {
        let (n, d) = self.parts()?;
        match (n.small(), d.small()) {
            (Some(n), Some(d)) => Fixed::new(n, d).to_reduced(),
            _ => Some(whole::fraction(n.big().into_owned(), d.big().into_owned()).into()),
        }
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        Some(match x {
            Reduced::Small(n, d) => ample(*n, *d),
            Reduced::Big(x) => to_ample(x),
        })
    }
}

#[cfg(test)]
mod tests {
    use passivity_core::{Scalar as _, Wide, rational};
    use proptest::prelude::*;

    use super::*;

    fn number() -> impl Strategy<Value = BigInt> {
        let edge = prop_oneof![
            Just(BigInt::from(i64::MAX)),
            Just(BigInt::from(i64::MIN)),
            Just(BigInt::from(i128::MAX)),
            Just(BigInt::from(i128::MIN)),
            Just(BigInt::from(u64::MAX)),
            Just(BigInt::from(u128::MAX)),
        ];
        let near_an_edge = (edge, -2..3_i32).prop_map(|(n, more)| n + more);
        let long = (any::<i128>(), 0..300_u32, -3..4_i32)
            .prop_map(|(n, k, more)| (BigInt::from(n) << k) + more);
        prop_oneof![
            (-40..40_i32).prop_map(BigInt::from),
            any::<i64>().prop_map(BigInt::from),
            any::<i128>().prop_map(BigInt::from),
            near_an_edge,
            long,
        ]
    }

    fn big(n: Option<Whole>) -> Option<BigInt> {
        let n = n?;
        assert_eq!(
            n,
            Whole::from(n.big().into_owned()),
            "not in its smallest form"
        );
        Some(n.big().into_owned())
    }

    proptest! {
        #[test]
        fn whole_numbers_are_computed_with_as_big_integers_are(a in number(), b in number(), n in any::<i32>()) {
            let (x, y) = (Whole::from(a.clone()), Whole::from(b.clone()));
            prop_assert_eq!(big(Some(Whole::from_i32(n))), Some(BigInt::from(n)));
            prop_assert_eq!(big(x.add(&y)), Integer::add(&a, &b));
            prop_assert_eq!(big(x.sub(&y)), Integer::sub(&a, &b));
            prop_assert_eq!(big(x.sub(&x)), Some(BigInt::ZERO));
            prop_assert_eq!(big(x.mul(&y)), Integer::mul(&a, &b));
            prop_assert_eq!(big(x.div_floor(&y)), Integer::div_floor(&a, &b));
            prop_assert_eq!(x.signum(), Integer::signum(&a));
            prop_assert_eq!(big(x.halved()), Integer::halved(&a));
            prop_assert_eq!(x.compare(&y), Integer::compare(&a, &b));
            prop_assert_eq!(x == y, a == b);
            for (n, d) in [(&a, &b), (&(&a * &b), &b), (&a, &(&a * &b)), (&BigInt::ZERO, &b)] {
                let (p, q) = Whole::shortened(n.clone().into(), d.clone().into());
                let (r, s) = <BigInt as Integer>::shortened(n.clone(), d.clone());
                prop_assert_eq!((big(Some(p)), big(Some(q))), (Some(r), Some(s)));
            }
        }

        #[test]
        fn fractions_are_written_as_those_of_big_integers(a in number(), b in number()) {
            let (x, y) = (Ample::new(a.clone().into(), b.clone().into()), Wide::new(a, b));
            prop_assert_eq!(x.to_reduced(), y.to_reduced());
            prop_assert_eq!(x.in_lowest_terms().is_some(), y.is_defined());
            if let Some(reduced) = y.to_reduced() {
                let number = reduced.to_rational();
                prop_assert_eq!(Ample::from_reduced(&reduced), Some(x.clone()));
                prop_assert_eq!(to_ample(&number), x.clone());
                prop_assert_eq!(rational::from_wide(&y.half()), x.half().to_rational());
            }
        }
    }
}
