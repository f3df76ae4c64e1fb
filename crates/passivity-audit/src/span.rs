//! Numbers known to within 2⁻⁶⁴: fast enclosures that the kernel's formulas compute with.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use num_traits::ToPrimitive as _;
use passivity_core::{BigRational, Ordered, Scalar};

use crate::number::{Number, Reduced, Written};

/// Bits behind the point.
pub(crate) const BITS: u32 = 64;

/// One, on the grid.
pub(crate) const ONE: i128 = 1 << BITS;

/// A number between two multiples of 2⁻⁶⁴.
///
/// Every operation rounds outward, so that whatever the numbers are that the operands stand for, the
/// result of the exact operation is in the result. Comparisons are answered only where they come out
/// the same for all of them. What does not fit, or cannot be told, is undefined and stays so: the
/// caller then computes with exact numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    /// In units of 2⁻⁶⁴; above `hi` where the number is undefined.
    lo: i128,
    hi: i128,
}

impl Span {
    const UNDEFINED: Self = Self { lo: 1, hi: 0 };

    /// Between two multiples of 2⁻⁶⁴.
    pub(crate) const fn between(lo: i128, hi: i128) -> Self {
        Self { lo, hi }
    }

    const fn checked(lo: Option<i128>, hi: Option<i128>) -> Self {
        match (lo, hi) {
            (Some(lo), Some(hi)) => Self { lo, hi },
            _ => Self::UNDEFINED,
        }
    }

    const fn is_defined(self) -> bool {
        self.lo <= self.hi
    }

    /// A whole number.
    #[must_use]
    pub(crate) const fn whole(n: i64) -> Self {
        // 2⁶³·2⁶⁴ is what 128 bits hold.
        let n = (n as i128) << BITS;
        Self { lo: n, hi: n }
    }

    /// Around n/d.
    pub(crate) fn of(x: &Number) -> Self {
        match x {
            Number::Small(n, d) => Self::ratio(*n, *d),
            Number::Big(x) => Self::of_rational(x),
        }
    }

    /// Around n/d, d > 0.
    fn ratio(n: i64, d: i64) -> Self {
        let (n, d) = ((n as i128) << BITS, i128::from(d));
        let lo = n.div_euclid(d);
        let hi = lo + i128::from(lo * d != n);
        Self { lo, hi }
    }

    /// Around a big number.
    pub(crate) fn of_rational(x: &BigRational) -> Self {
        let scaled = x * BigRational::from_integer(ONE.into());
        let [lo, hi] = [scaled.floor(), scaled.ceil()];
        Self::checked(lo.to_integer().to_i128(), hi.to_integer().to_i128())
    }

    /// Around all numbers from one to another; `None` where that does not fit.
    pub(crate) fn around(lo: &BigRational, hi: &BigRational) -> Option<Self> {
        let span = Self::of_rational(lo).joined(Self::of_rational(hi));
        span.is_defined().then_some(span)
    }

    /// Around both numbers.
    pub(crate) const fn joined(self, other: Self) -> Self {
        if !(self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        Self {
            lo: if self.lo < other.lo {
                self.lo
            } else {
                other.lo
            },
            hi: if self.hi > other.hi {
                self.hi
            } else {
                other.hi
            },
        }
    }

    /// How far its ends are apart, where it is defined.
    pub(crate) fn width(self) -> Option<i128> {
        self.hi.checked_sub(self.lo).filter(|width| *width >= 0)
    }

    /// A double near the number, where it is defined.
    #[allow(clippy::cast_precision_loss)] // that is what near means
    pub(crate) fn near(self) -> f64 {
        self.lo as f64 / ONE as f64
    }

    /// The ends, in units of 2⁻⁶⁴, of a number that is defined.
    pub(crate) const fn ends(self) -> [i128; 2] {
        [self.lo, self.hi]
    }

    /// The ends, where the number is defined.
    pub(crate) fn defined(self) -> Option<[i128; 2]> {
        self.is_defined().then_some(self.ends())
    }

    /// Whether the exact number is in it: for tests.
    #[cfg(test)]
    fn holds(self, x: &BigRational) -> bool {
        let [lo, hi] = [self.lo, self.hi].map(on_grid);
        self.is_defined() && lo <= *x && *x <= hi
    }
}

/// The numbers rounded outward to the grid, where that fits.
pub(crate) fn outward([lo, hi]: [Reduced; 2]) -> [Reduced; 2] {
    let above = |x: Reduced| match Span::of_rational(&x.to_rational()).above() {
        Some(above) => above,
        None => x,
    };
    [below_on_grid(lo), above(hi)]
}

/// The number rounded down to the grid, where that fits.
pub(crate) fn below_on_grid(x: Reduced) -> Reduced {
    match Span::of_rational(&x.to_rational()).below() {
        Some(below) => below,
        None => x,
    }
}

/// How many units of the grid an end of a span is.
pub(crate) const fn units(end: &Reduced) -> Option<i128> {
    match end {
        Reduced::Small(n, ONE) => Some(*n),
        _ => None,
    }
}

/// A number of units of the grid.
pub(crate) fn on_grid(n: i128) -> BigRational {
    BigRational::new(n.into(), ONE.into())
}

/// ⌊a·b/2^shift⌋ for numbers that are not negative, and whether that is less than a·b/2^shift; `None` when
/// it is wider than 127 bits.
#[inline]
pub(crate) fn product_shifted(a: u128, b: u128, shift: u32) -> Option<(i128, bool)> {
    const LOW: u128 = u64::MAX as u128;
    let [a1, a0, b1, b0] = [a >> 64, a & LOW, b >> 64, b & LOW];
    let low = a0 * b0;
    let (middle, carry) = (a1 * b0).overflowing_add(a0 * b1);
    let (low, carry_low) = low.overflowing_add(middle << 64);
    let high = a1 * b1 + (middle >> 64) + (u128::from(carry) << 64) + u128::from(carry_low);
    let (value, rest) = match shift {
        0 => (if high == 0 { low } else { u128::MAX }, 0),
        1..=127 => {
            if high >> shift != 0 {
                return None;
            }
            (
                (high << (128 - shift)) | (low >> shift),
                low << (128 - shift),
            )
        }
        128 => (high, low),
        129..=255 => {
            let shift = shift - 128;
            (high >> shift, (high << (128 - shift)) | low)
        }
        _ => return None,
    };
    Some((i128::try_from(value).ok()?, rest != 0))
}

/// a·b on the grid, rounded down.
#[inline]
fn product_below(a: i128, b: i128) -> Option<i128> {
    let (value, inexact) = product_shifted(a.unsigned_abs(), b.unsigned_abs(), BITS)?;
    match (a < 0) == (b < 0) {
        true => Some(value),
        false => Some(-value - i128::from(inexact)),
    }
}

/// a·b on the grid, rounded up.
#[inline]
fn product_above(a: i128, b: i128) -> Option<i128> {
    product_below(a.checked_neg()?, b).map(|x| -x)
}

/// a/b on the grid, rounded down, b > 0; `None` where it does not fit.
fn quotient_below(a: i128, b: i128) -> Option<i128> {
    /// Past it the rest has no room for half of the bits at a time.
    const WIDEST: i128 = 1 << 94;
    const HALF: u32 = BITS / 2;
    if b >= WIDEST {
        return None;
    }
    let (whole, rest) = (a.div_euclid(b), a.rem_euclid(b));
    let (upper, rest) = ((rest << HALF) / b, (rest << HALF) % b);
    let lower = (rest << HALF) / b;
    whole.checked_mul(ONE)?.checked_add((upper << HALF) + lower)
}

/// a/b on the grid, rounded up, b > 0.
fn quotient_above(a: i128, b: i128) -> Option<i128> {
    quotient_below(a.checked_neg()?, b).map(|x| -x)
}

impl Add for Span {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        if !(self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        Self::checked(self.lo.checked_add(other.lo), self.hi.checked_add(other.hi))
    }
}

impl Neg for Span {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        if !self.is_defined() {
            return self;
        }
        Self::checked(self.hi.checked_neg(), self.lo.checked_neg())
    }
}

impl Sub for Span {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Span {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        if !(self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        if self.hi <= 0 && self.lo < 0 {
            return -(-self * other);
        }
        let ([a, b], [c, d]) = ([self.lo, self.hi], [other.lo, other.hi]);
        if a >= 0 {
            let (below, above) = (if c >= 0 { a } else { b }, if d >= 0 { b } else { a });
            return Self::checked(product_below(below, c), product_above(above, d));
        }
        let least = |x: Option<i128>, y: Option<i128>| Some(x?.min(y?));
        let most = |x: Option<i128>, y: Option<i128>| Some(x?.max(y?));
        Self::checked(
            least(product_below(a, d), product_below(b, c)),
            most(product_above(a, c), product_above(b, d)),
        )
    }
}

impl Scalar for Span {
    fn integer(n: i32) -> Self {
        Self::whole(n.into())
    }

    #[inline]
    fn half(self) -> Self {
        if !self.is_defined() {
            return self;
        }
        Self {
            lo: self.lo >> 1,
            hi: (self.hi >> 1) + (self.hi & 1),
        }
    }

    #[inline]
    fn floor(&self) -> Self {
        match self.is_defined() && self.lo >> BITS == self.hi >> BITS {
            true => {
                let floor = (self.lo >> BITS) << BITS;
                Self::between(floor, floor)
            }
            false => Self::UNDEFINED,
        }
    }

    #[inline]
    fn abs(&self) -> Self {
        if self.lo >= 0 {
            *self
        } else if self.hi <= 0 {
            -*self
        } else {
            Self::checked(Some(0), self.lo.checked_neg().map(|lo| lo.max(self.hi)))
        }
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        match self.is_defined() && other.is_defined() {
            true => Self::between(Ord::max(self.lo, other.lo), Ord::max(self.hi, other.hi)),
            false => Self::UNDEFINED,
        }
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        match self.is_defined() && other.is_defined() {
            true => Self::between(Ord::min(self.lo, other.lo), Ord::min(self.hi, other.hi)),
            false => Self::UNDEFINED,
        }
    }

    fn over(self, divisor: Self) -> Self {
        if !self.is_defined() || divisor.is_defined() && divisor.hi < 0 {
            return -self.over_positive(-divisor);
        }
        self.over_positive(divisor)
    }

    #[inline]
    fn square(&self) -> Self {
        let size = self.abs();
        size * size
    }
}

impl Span {
    fn over_positive(self, divisor: Self) -> Self {
        if !self.is_defined() || !divisor.is_defined() || divisor.lo <= 0 {
            return Self::UNDEFINED;
        }
        if divisor == Self::between(ONE, ONE) {
            return self;
        }
        let below = if self.lo >= 0 { divisor.hi } else { divisor.lo };
        let above = if self.hi >= 0 { divisor.lo } else { divisor.hi };
        Self::checked(
            quotient_below(self.lo, below),
            quotient_above(self.hi, above),
        )
    }
}

impl Ordered for Span {
    fn sign(&self) -> Option<Ordering> {
        match (self.is_defined(), self.lo, self.hi) {
            (false, ..) => None,
            (_, 0, 0) => Some(Ordering::Equal),
            (_, 1.., _) => Some(Ordering::Greater),
            (_, _, ..0) => Some(Ordering::Less),
            _ => None,
        }
    }

    fn is_nonnegative(&self) -> Option<bool> {
        match (self.is_defined(), self.lo, self.hi) {
            (true, 0.., _) => Some(true),
            (true, _, ..0) => Some(false),
            _ => None,
        }
    }

    fn is_positive(&self) -> Option<bool> {
        match (self.is_defined(), self.lo, self.hi) {
            (true, 1.., _) => Some(true),
            (true, _, ..=0) => Some(false),
            _ => None,
        }
    }
}

impl Written for Span {
    const EXACT: bool = false;

    fn to_reduced(&self) -> Option<Reduced> {
        (self.lo == self.hi).then_some(Reduced::Small(self.lo, ONE))
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        let span = match x {
            Reduced::Small(n, ONE) => Self::between(*n, *n),
            x => Self::of_rational(&x.to_rational()),
        };
        span.is_defined().then_some(span)
    }

    fn below(&self) -> Option<Reduced> {
        self.is_defined().then_some(Reduced::Small(self.lo, ONE))
    }

    fn above(&self) -> Option<Reduced> {
        self.is_defined().then_some(Reduced::Small(self.hi, ONE))
    }

    fn is_number(&self) -> bool {
        self.is_defined()
    }

    fn one_of(&self) -> Self {
        Self {
            hi: self.lo,
            ..*self
        }
    }

    fn in_lowest_terms(&self) -> Option<Self> {
        self.is_defined().then_some(*self)
    }
}

#[cfg(test)]
mod tests;
