//! Rigorous intervals: every operation rounded outwards, on doubles or on numbers of any precision.

#[cfg(feature = "multiprecision")]
mod wide;

use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use passivity_core::BigRational;

use crate::real::{Real, Undecided};

#[cfg(feature = "multiprecision")]
pub use wide::Wide;

/// A number whose operations can be rounded down or up.
pub trait Directed: Clone {
    /// a + b, rounded.
    fn add(&self, other: &Self, up: bool) -> Self;
    /// a·b, rounded.
    fn mul(&self, other: &Self, up: bool) -> Self;
    /// a/b for b ≠ 0, rounded.
    fn div(&self, other: &Self, up: bool) -> Self;
    /// −a, exactly.
    #[must_use]
    fn negated(&self) -> Self;
    /// ⌊a⌋, exactly.
    #[must_use]
    fn floored(&self) -> Self;
    /// The sign; an error for NaN.
    ///
    /// # Errors
    ///
    /// [`Undecided`] for NaN.
    fn signum(&self) -> Result<Ordering, Undecided>;
    /// How `self` compares with `other`, `Equal` for NaN.
    fn order(&self, other: &Self) -> Ordering;
    /// n/m, as precise as `self`, rounded.
    #[must_use]
    fn fraction(&self, n: i32, m: i32, up: bool) -> Self;
    /// A double near it.
    fn near(&self) -> f64;
    /// How many bits it has.
    fn precision(&self) -> u32;
}

/// The rounding error of a double's operation decides which neighbour is the outward one.
fn outward(result: f64, error: f64, up: bool) -> f64 {
    if up && error > 0.0 {
        result.next_up()
    } else if !up && error < 0.0 {
        result.next_down()
    } else {
        result
    }
}

/// a·b − fl(a·b), exactly, when nothing under- or overflows (Veltkamp, Dekker).
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    a2 * b2 - (((product - a1 * b1) - a2 * b1) - a1 * b2)
}

/// Whether the magnitude is one at which [`product_error`] is exact.
fn ordinary(x: f64) -> bool {
    let x = x.abs();
    (1e-140..1e140).contains(&x)
}

impl Directed for f64 {
    fn add(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (*self, *other);
        let sum = a + b;
        // Knuth's exact error of a sum; it does not underflow.
        let from_b = sum - a;
        let error = (a - (sum - from_b)) + (b - from_b);
        outward(sum, error, up)
    }

    fn mul(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (*self, *other);
        let product = a * b;
        if a == 0.0 || b == 0.0 {
            return 0.0;
        }
        if ordinary(a) && ordinary(b) {
            return outward(product, product_error(a, b, product), up);
        }
        // Out of the range in which the error is exact: one ulp, whichever way it went.
        outward(product, if up { 1.0 } else { -1.0 }, up)
    }

    fn div(&self, other: &Self, up: bool) -> Self {
        let (a, b) = (*self, *other);
        let quotient = a / b;
        if a == 0.0 {
            return 0.0;
        }
        if ordinary(a) && ordinary(b) && ordinary(quotient) {
            // a − quotient·b, whose sign against b's is that of the error.
            let product = quotient * b;
            let rest = (a - product) - product_error(quotient, b, product);
            return outward(quotient, rest * b.signum(), up);
        }
        outward(quotient, if up { 1.0 } else { -1.0 }, up)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn floored(&self) -> Self {
        crate::law::floor(*self)
    }

    fn signum(&self) -> Result<Ordering, Undecided> {
        self.partial_cmp(&0.0).ok_or(Undecided)
    }

    fn order(&self, other: &Self) -> Ordering {
        self.partial_cmp(other).unwrap_or(Ordering::Equal)
    }

    fn fraction(&self, n: i32, m: i32, up: bool) -> Self {
        Directed::div(&Self::from(n), &Self::from(m), up)
    }

    fn near(&self) -> f64 {
        *self
    }

    fn precision(&self) -> u32 {
        53
    }
}

/// A closed interval that holds the number meant.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar};
/// use passivity_sim::enclosed::Enclosed;
///
/// let tenth = Enclosed::double(&BigRational::integer(1).over(BigRational::integer(10)));
/// assert!(tenth.lo < tenth.hi && tenth.hi == 0.1);
/// let half = Enclosed::double(&BigRational::integer(1).half());
/// assert_eq!((half.clone() + half).lo, 1.0); // exact operations stay points
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Enclosed<T> {
    /// The lower end.
    pub lo: T,
    /// The upper end.
    pub hi: T,
}

impl Enclosed<f64> {
    /// The tightest interval of doubles around a rational number.
    #[must_use]
    pub fn double(x: &BigRational) -> Self {
        let near = crate::plan::to_double(x);
        let Some(exact) = BigRational::from_float(near) else {
            // Past the doubles: the largest of them on one side, infinity on the other.
            let (lo, hi) = (f64::MAX, f64::INFINITY);
            return if near > 0.0 {
                Self { lo, hi }
            } else {
                Self { lo: -hi, hi: -lo }
            };
        };
        match exact.cmp(x) {
            Ordering::Equal => Self { lo: near, hi: near },
            Ordering::Less => Self {
                lo: near,
                hi: near.next_up(),
            },
            Ordering::Greater => Self {
                lo: near.next_down(),
                hi: near,
            },
        }
    }
}

impl<T: Directed> Enclosed<T> {
    /// The number `x` alone.
    #[must_use]
    pub fn thin(x: &T) -> Self {
        Self {
            lo: x.clone(),
            hi: x.clone(),
        }
    }

    /// Whether the interval is one number.
    #[must_use]
    pub fn is_thin(&self) -> bool {
        self.lo.order(&self.hi) == Ordering::Equal
    }

    /// The ends as doubles, for people; not rounded outwards when the ends have more bits.
    #[must_use]
    pub fn ends(&self) -> [f64; 2] {
        [self.lo.near(), self.hi.near()]
    }

    /// The least interval that holds both.
    #[must_use]
    pub fn hull(self, other: Self) -> Self {
        let lo = if other.lo.order(&self.lo) == Ordering::Less {
            other.lo
        } else {
            self.lo
        };
        let hi = if other.hi.order(&self.hi) == Ordering::Greater {
            other.hi
        } else {
            self.hi
        };
        Self { lo, hi }
    }
}

impl<T: Directed> Add for Enclosed<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            lo: self.lo.add(&other.lo, false),
            hi: self.hi.add(&other.hi, true),
        }
    }
}

impl<T: Directed> Neg for Enclosed<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            lo: self.hi.negated(),
            hi: self.lo.negated(),
        }
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
        let negative = |x: &T| x.signum() == Ok(Ordering::Less);
        let positive = |x: &T| x.signum() == Ok(Ordering::Greater);
        let (a, b) = (&self, &other);
        let below = [negative(&a.lo), negative(&b.lo)];
        let (least, most) = match (below, [positive(&a.hi), positive(&b.hi)]) {
            ([false, false], _) => ([&a.lo, &b.lo], [&a.hi, &b.hi]),
            (_, [false, false]) => ([&a.hi, &b.hi], [&a.lo, &b.lo]),
            ([false, true], [_, false]) => ([&a.hi, &b.lo], [&a.lo, &b.hi]),
            ([true, false], [false, _]) => ([&a.lo, &b.hi], [&a.hi, &b.lo]),
            ([false, true], _) => ([&a.hi, &b.lo], [&a.hi, &b.hi]),
            ([true, false], _) => ([&a.lo, &b.hi], [&a.hi, &b.hi]),
            ([true, true], [true, false]) => ([&a.hi, &b.lo], [&a.lo, &b.lo]),
            ([true, true], [false, true]) => ([&a.lo, &b.hi], [&a.lo, &b.lo]),
            ([true, true], [true, true]) => {
                let (x, y) = (a.lo.mul(&b.hi, false), a.hi.mul(&b.lo, false));
                let (z, w) = (a.lo.mul(&b.lo, true), a.hi.mul(&b.hi, true));
                let lo = if x.order(&y) == Ordering::Less { x } else { y };
                let hi = if z.order(&w) == Ordering::Greater {
                    z
                } else {
                    w
                };
                return Self { lo, hi };
            }
        };
        Self {
            lo: least[0].mul(least[1], false),
            hi: most[0].mul(most[1], true),
        }
    }
}

impl<T: Directed> Div for Enclosed<T> {
    type Output = Self;
    /// By an interval without 0: every divisor here is a mass, a rate or a count.
    fn div(self, other: Self) -> Self {
        let one = other.one();
        if other.hi.signum() == Ok(Ordering::Less) {
            return -self / -other;
        }
        let inverse = Self {
            lo: one.lo.div(&other.hi, false),
            hi: one.hi.div(&other.lo, true),
        };
        if self.is_thin() && other.is_thin() {
            // Tighter, and exact where the quotient is.
            return Self {
                lo: self.lo.div(&other.lo, false),
                hi: self.hi.div(&other.lo, true),
            };
        }
        self * inverse
    }
}

impl<T: Directed> Real for Enclosed<T> {
    fn ratio(&self, n: i32, m: i32) -> Self {
        Self {
            lo: self.lo.fraction(n, m, false),
            hi: self.hi.fraction(n, m, true),
        }
    }

    fn sign(&self) -> Result<Ordering, Undecided> {
        let (lo, hi) = (self.lo.signum()?, self.hi.signum()?);
        if lo == hi { Ok(lo) } else { Err(Undecided) }
    }

    fn floor(&self) -> Result<Self, Undecided> {
        let (lo, hi) = (self.lo.floored(), self.hi.floored());
        if lo.order(&hi) == Ordering::Equal && self.lo.signum().is_ok() {
            Ok(Self { lo, hi })
        } else {
            Err(Undecided)
        }
    }

    fn approximate(&self) -> f64 {
        let [lo, hi] = self.ends();
        0.5 * lo + 0.5 * hi
    }

    fn bits(&self) -> u32 {
        self.lo.precision()
    }

    fn widened(self, bound: &Self) -> Self {
        let size = |x: &T| match x.signum() {
            Ok(Ordering::Less) => x.negated(),
            _ => x.clone(),
        };
        let (a, b) = (size(&bound.lo), size(&bound.hi));
        let most = if a.order(&b) == Ordering::Greater {
            a
        } else {
            b
        };
        self + Self {
            lo: most.negated(),
            hi: most,
        }
    }

    fn join(self, other: Self) -> Self {
        self.hull(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let (x, y) = (Enclosed { lo: a, hi: a }, Enclosed { lo: b, hi: b });
            let results = [
                (x.clone() + y.clone(), exact(a) + exact(b)),
                (x.clone() - y.clone(), exact(a) - exact(b)),
                (x.clone() * y.clone(), exact(a) * exact(b)),
                (x / y, exact(a) / exact(b)),
            ];
            for (got, want) in results {
                assert!(
                    exact(got.lo) <= want && want <= exact(got.hi),
                    "{a:e} {b:e}"
                );
                assert!(got.hi <= got.lo.next_up(), "{a:e} {b:e}: {got:?}");
                // A result that is a double stays a point.
                let near = crate::plan::to_double(&want);
                assert_eq!(
                    exact(near) == want,
                    got.lo == got.hi,
                    "{a:e} {b:e}: {got:?}"
                );
            }
        }
    }

    #[test]
    fn products_of_intervals_hold_all_products() {
        let ends = [-3.0, -1.0, 0.0, 0.5, 2.0];
        for a in ends {
            for b in ends.into_iter().filter(|b| *b >= a) {
                for c in ends {
                    for d in ends.into_iter().filter(|d| *d >= c) {
                        let got = Enclosed { lo: a, hi: b } * Enclosed { lo: c, hi: d };
                        let all = [a * c, a * d, b * c, b * d];
                        let least = all.into_iter().fold(f64::INFINITY, f64::min);
                        let most = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
                        assert_eq!((got.lo, got.hi), (least, most), "[{a}, {b}]·[{c}, {d}]");
                    }
                }
            }
        }
    }
}
