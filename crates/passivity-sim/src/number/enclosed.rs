//! Rigorous intervals: every operation rounded outwards, on doubles or on numbers of any precision.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use passivity_core::{BigRational, Interval, Ordered, Scalar};

use super::directed::Directed;
use super::double::Double;
use super::rational::to_double;
use super::real::Real;

/// A closed interval that holds the number meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed<T>(Interval<T>);

impl From<&BigRational> for Enclosed<Double> {
    /// The tightest interval of doubles around a rational number.
    fn from(x: &BigRational) -> Self {
        let near = to_double(x);
        let [lo, hi] = match BigRational::from_float(near) {
            // Past the doubles: the largest of them on one side, infinity on the other.
            None if near > 0.0 => [f64::MAX, f64::INFINITY],
            None => [f64::NEG_INFINITY, f64::MIN],
            Some(exact) => match exact.cmp(x) {
                Ordering::Equal => [near, near],
                Ordering::Less => [near, near.next_up()],
                Ordering::Greater => [near.next_down(), near],
            },
        };
        Self::new(Double(lo), Double(hi))
    }
}

impl Enclosed<Double> {
    /// The interval [`lo`, `hi`] of doubles, in which `lo` ≤ `hi` or both are undefined.
    #[must_use]
    pub const fn of_doubles(lo: f64, hi: f64) -> Self {
        Self::new(Double(lo), Double(hi))
    }
}

#[cfg(feature = "multiprecision")]
impl Enclosed<super::big::Big> {
    /// The tightest interval of numbers of `bits` bits around a rational number.
    pub(crate) fn wide(x: &BigRational, bits: usize) -> Self {
        let [lo, hi] = super::big::Big::around(x, bits);
        Self::new(lo, hi)
    }
}

impl<T: Directed> Enclosed<T> {
    /// The interval [lo, hi], in which lo ≤ hi or both are undefined.
    pub(crate) const fn new(lo: T, hi: T) -> Self {
        Self(Interval::new_unchecked(lo, hi))
    }

    /// The number `x` alone.
    pub(crate) fn thin(x: T) -> Self {
        Self::new(x.clone(), x)
    }

    fn undefined() -> Self {
        Self::thin(T::undefined())
    }

    /// The lower end.
    #[must_use]
    pub const fn lo(&self) -> &T {
        self.0.lo()
    }

    /// The upper end.
    #[must_use]
    pub const fn hi(&self) -> &T {
        self.0.hi()
    }

    /// Whether the interval is one number.
    pub(crate) fn is_thin(&self) -> bool {
        self.lo().compare(self.hi()) == Some(Ordering::Equal)
    }

    /// Doubles near the ends.
    pub(crate) fn near_ends(&self) -> [f64; 2] {
        [self.lo(), self.hi()].map(Real::approximate)
    }

    /// The ends as doubles, rounded outwards where they have more bits.
    #[must_use]
    pub fn bounds(&self) -> [f64; 2] {
        let [lo, hi] = self.near_ends();
        if self.lo().bits() <= f64::MANTISSA_DIGITS {
            [lo, hi]
        } else {
            [lo.next_down(), hi.next_up()]
        }
    }
}

impl<T: Directed> Add for Enclosed<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(
            self.lo().add_rounded(other.lo(), false),
            self.hi().add_rounded(other.hi(), true),
        )
    }
}

impl<T: Directed> Neg for Enclosed<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.hi().clone(), -self.lo().clone())
    }
}

impl<T: Directed> Sub for Enclosed<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Directed> Mul for Enclosed<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        // By signs: which ends meet for the least and the largest product.
        let ((a, b), (c, d)) = ((self.lo(), self.hi()), (other.lo(), other.hi()));
        let signs = (a.sign(), b.sign(), c.sign(), d.sign());
        let (Some(a_sign), Some(b_sign), Some(c_sign), Some(d_sign)) = signs else {
            return Self::undefined();
        };
        let below = [a_sign.is_lt(), c_sign.is_lt()];
        let above = [b_sign.is_gt(), d_sign.is_gt()];
        let ([p, q], [r, s]) = match (below, above) {
            ([false, false], _) => ([a, c], [b, d]),
            (_, [false, false]) => ([b, d], [a, c]),
            ([false, true], [_, false]) => ([b, c], [a, d]),
            ([true, false], [false, _]) => ([a, d], [b, c]),
            ([false, true], _) => ([b, c], [b, d]),
            ([true, false], _) => ([a, d], [b, d]),
            ([true, true], [true, false]) => ([b, c], [a, c]),
            ([true, true], [false, true]) => ([a, d], [a, c]),
            ([true, true], [true, true]) => {
                let least = a.mul_rounded(d, false).min(b.mul_rounded(c, false));
                let most = a.mul_rounded(c, true).max(b.mul_rounded(d, true));
                return Self::new(least, most);
            }
        };
        Self::new(p.mul_rounded(q, false), r.mul_rounded(s, true))
    }
}

impl<T: Directed> Scalar for Enclosed<T> {
    fn integer(n: i32) -> Self {
        Self::thin(T::integer(n))
    }

    fn half(self) -> Self {
        let half = T::one().half();
        Self::new(
            self.lo().mul_rounded(&half, false),
            self.hi().mul_rounded(&half, true),
        )
    }

    fn floor(&self) -> Self {
        let (lo, hi) = (self.lo().floor(), self.hi().floor());
        match lo.compare(&hi) {
            Some(Ordering::Equal) => Self::new(lo, hi),
            _ => Self::undefined(),
        }
    }

    fn abs(&self) -> Self {
        match [self.lo(), self.hi()].map(T::sign) {
            [Some(Ordering::Equal | Ordering::Greater), _] => self.clone(),
            [_, Some(Ordering::Equal | Ordering::Less)] => -self.clone(),
            _ => Self::new(T::zero(), self.hi().clone().max(-self.lo().clone())),
        }
    }

    fn max(self, other: Self) -> Self {
        Self::new(
            self.lo().clone().max(other.lo().clone()),
            self.hi().clone().max(other.hi().clone()),
        )
    }

    fn min(self, other: Self) -> Self {
        Self::new(
            self.lo().clone().min(other.lo().clone()),
            self.hi().clone().min(other.hi().clone()),
        )
    }

    fn over(self, divisor: Self) -> Self {
        match (divisor.lo().sign(), divisor.hi().sign()) {
            (Some(Ordering::Greater), Some(_)) => {}
            (Some(_), Some(Ordering::Less)) => return (-self).over(-divisor),
            _ => return Self::undefined(),
        }
        if self.is_thin() && divisor.is_thin() {
            // Tighter, and exact where the quotient is.
            return Self::new(
                self.lo().div_rounded(divisor.lo(), false),
                self.hi().div_rounded(divisor.hi(), true),
            );
        }
        let one = divisor.lo().whole(1);
        let inverse = Self::new(
            one.div_rounded(divisor.hi(), false),
            one.div_rounded(divisor.lo(), true),
        );
        self * inverse
    }
}

impl<T: Directed> Ordered for Enclosed<T> {
    fn sign(&self) -> Option<Ordering> {
        let (lo, hi) = (self.lo().sign()?, self.hi().sign()?);
        (lo == hi).then_some(lo)
    }

    fn is_nonnegative(&self) -> Option<bool> {
        match (self.lo().sign()?, self.hi().sign()?) {
            (Ordering::Equal | Ordering::Greater, _) => Some(true),
            (_, Ordering::Less) => Some(false),
            _ => None,
        }
    }

    fn is_positive(&self) -> Option<bool> {
        (-self.clone()).is_nonnegative().map(|below| !below)
    }
}

impl<T: Directed> Real for Enclosed<T> {
    const ENCLOSES: bool = true;

    fn approximate(&self) -> f64 {
        let [lo, hi] = self.near_ends();
        0.5 * lo + 0.5 * hi
    }

    fn is_defined(&self) -> bool {
        self.lo().is_defined() && self.hi().is_defined()
    }

    fn bits(&self) -> u32 {
        self.lo().bits()
    }

    fn whole(&self, n: i32) -> Self {
        Self::thin(self.lo().whole(n))
    }

    fn widened(self, bound: &Self) -> Self {
        let most = bound.lo().abs().max(bound.hi().abs());
        self + Self::new(-most.clone(), most)
    }

    fn join(self, other: Self) -> Self {
        Self(self.0.joined(&other.0))
    }

    fn one_of(&self) -> Self {
        Self::thin(self.lo().clone())
    }

    fn ends(&self) -> Option<[Self; 2]> {
        let ends = || [self.lo(), self.hi()].map(|end| Self::thin(end.clone()));
        (!self.is_thin()).then(ends)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn between(lo: f64, hi: f64) -> Enclosed<Double> {
        Enclosed::new(Double(lo), Double(hi))
    }

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).unwrap()
    }

    #[test]
    fn every_operation_holds_the_exact_result_and_is_tight() {
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let exponent = i32::try_from((seed >> 8) % 61).unwrap() - 30;
            ((seed >> 11) as f64 - 4.5e15) * f64::from(exponent - 50).exp2()
        };
        for i in 0..4000 {
            let (a, b) = (random(), if i % 5 == 0 { 0.5 } else { random() });
            let (x, y) = (between(a, a), between(b, b));
            let results = [
                (x.clone() + y.clone(), exact(a) + exact(b)),
                (x.clone() - y.clone(), exact(a) - exact(b)),
                (x.clone() * y.clone(), exact(a) * exact(b)),
                (x.over(y), exact(a) / exact(b)),
            ];
            for (got, want) in results {
                let [lo, hi] = got.bounds();
                assert!(exact(lo) <= want && want <= exact(hi), "{a:e} {b:e}");
                assert!(hi <= lo.next_up(), "{a:e} {b:e}: {got:?}");
                // A result that is a double stays a point.
                let near = to_double(&want);
                assert_eq!(exact(near) == want, lo == hi, "{a:e} {b:e}: {got:?}");
            }
        }
    }

    #[test]
    fn the_tightest_interval_around_a_rational() {
        let tenth =
            Enclosed::<Double>::from(&BigRational::integer(1).over(BigRational::integer(10)));
        let [lo, hi] = tenth.bounds();
        assert!(lo < hi && hi == 0.1);
        let half = Enclosed::<Double>::from(&BigRational::one().half());
        assert_eq!((half.clone() + half).bounds(), [1.0, 1.0]); // exact operations stay points
    }

    /// What has no result, and all that is made of it, is undefined; a sign is only told when it is known.
    fn undefined_stays_undefined<T: Real>(undefined: T, four: T) {
        let all = [
            undefined.clone() + four.clone(),
            four.clone() - undefined.clone(),
            undefined.clone() * T::zero(),
            T::zero() * undefined.clone(),
            -undefined.clone(),
            undefined.clone().over(four.clone()),
            T::zero().over(undefined.clone()),
            undefined.clone().half(),
            undefined.floor(),
            undefined.abs(),
            undefined.clone().max(four.clone()),
            four.clone().max(undefined.clone()),
            undefined.clone().min(four.clone()),
            four.clone().min(undefined.clone()),
            four.clone().over(T::zero()),
        ];
        for (index, x) in all.iter().enumerate() {
            assert!(!x.is_defined(), "operation {index}");
            assert_eq!(x.sign(), None);
            assert_eq!(x.compare(&four), None);
            assert_eq!((x.is_nonnegative(), x.is_positive()), (None, None));
            assert!(x.approximate().is_nan());
        }
        assert_eq!(
            four.over(T::integer(3)).floor().sign(),
            Some(Ordering::Greater)
        );
    }

    #[test]
    fn undefined_values_of_every_number_stay_undefined() {
        undefined_stays_undefined(Double(f64::NAN), Double(4.0));
        let edge = between(1.0_f64.next_down(), 1.0);
        assert!(edge.is_defined());
        undefined_stays_undefined(edge.floor(), between(4.0, 4.5));
        undefined_stays_undefined(
            between(1.0, 2.0).over(between(-1.0, 1.0)),
            between(4.0, 4.0),
        );
    }

    #[cfg(feature = "multiprecision")]
    #[test]
    fn undefined_values_of_any_precision_stay_undefined() {
        use crate::number::big::Big;
        let four = Big::new(&BigRational::integer(4), 128);
        undefined_stays_undefined(Big::one().over(Big::zero()), four.clone());
        let [lo, hi] = Big::around(&BigRational::integer(1).over(BigRational::integer(3)), 128);
        let third = Enclosed::new(lo, hi);
        let edge = (third.clone() + third.clone() + third).floor();
        undefined_stays_undefined(edge, Enclosed::thin(four));
    }

    #[test]
    fn a_sign_is_told_when_both_ends_have_it() {
        let x = between(0.0, 1.0);
        assert_eq!(
            (x.sign(), x.is_nonnegative(), x.is_positive()),
            (None, Some(true), None)
        );
        let x = between(-1.0, 0.0);
        assert_eq!(
            (x.sign(), x.is_nonnegative(), x.is_positive()),
            (None, None, Some(false))
        );
        assert_eq!(between(-1.0, 3.0).abs().bounds(), [0.0, 3.0]);
    }

    #[test]
    fn products_of_intervals_hold_all_products() {
        let ends = [-3.0, -1.0, 0.0, 0.5, 2.0];
        for a in ends {
            for b in ends.into_iter().filter(|b| *b >= a) {
                for c in ends {
                    for d in ends.into_iter().filter(|d| *d >= c) {
                        let got = between(a, b) * between(c, d);
                        let all = [a * c, a * d, b * c, b * d];
                        let least = all.into_iter().fold(f64::INFINITY, f64::min);
                        let most = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
                        assert_eq!(got.bounds(), [least, most], "[{a}, {b}]·[{c}, {d}]");
                    }
                }
            }
        }
    }
}
