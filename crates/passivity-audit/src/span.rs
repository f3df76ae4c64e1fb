//! Numbers known to within 2⁻⁶⁴: fast enclosures that the kernel's formulas compute with.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use passivity_core::{BigRational, Ordered, Scalar};

use crate::number::{Number, Reduced, Written};

use grid::on_both_sides;
pub(crate) use grid::{below_on_grid, figure_around, on_grid, outward, units};

/// Bits behind the point.
pub(crate) const BITS: u32 = 64;

/// One, on the grid.
pub(crate) const ONE: i128 = 1 << BITS;

/// A number that is no further than a radius from a middle, both of them multiples of 2⁻⁶⁴.
///
/// Every operation rounds outward, so that whatever the numbers are that the operands stand for, the
/// result of the exact operation is in the result. Comparisons are answered only where they come out
/// the same for all of them. What does not fit, or cannot be told, is undefined and stays so: the
/// caller then computes with exact numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    /// In units of 2⁻⁶⁴, below [`LARGEST`] in magnitude.
    middle: i128,
    /// In the same units; [`UNKNOWN`] where the number is undefined.
    radius: u64,
}

/// Leaves room for the radius, and for a sum.
const LARGEST: i128 = 1 << 126;

/// The radius of what is undefined: sums of it saturate, so that it stays.
const UNKNOWN: u64 = u64::MAX;

impl Span {
    const UNDEFINED: Self = Self {
        middle: 0,
        radius: UNKNOWN,
    };

    #[inline]
    const fn checked(middle: i128, radius: u64) -> Self {
        // −LARGEST < middle < LARGEST, in one comparison.
        let shifted = middle.wrapping_add(LARGEST).cast_unsigned();
        if shifted.wrapping_sub(1) < (2 * LARGEST.cast_unsigned()) - 1 {
            Self { middle, radius }
        } else {
            Self::UNDEFINED
        }
    }

    /// Between two multiples of 2⁻⁶⁴, or one unit further down where they are an odd number of units apart.
    #[inline]
    pub(crate) const fn between(lo: i128, hi: i128) -> Self {
        let (Some(sum), Some(width)) = (lo.checked_add(hi), hi.checked_sub(lo)) else {
            return Self::UNDEFINED;
        };
        if width < 0 || width >> BITS != 0 {
            return Self::UNDEFINED;
        }
        // Half of less than 2⁶⁴, rounded up.
        Self::checked(sum >> 1, ((width + 1) >> 1) as u64)
    }

    /// No further than a radius from a middle, in units of 2⁻⁶⁴.
    #[inline]
    pub(crate) const fn centred(middle: i128, radius: u64) -> Self {
        Self::checked(middle, radius)
    }

    #[inline]
    const fn is_defined(self) -> bool {
        self.radius != UNKNOWN
    }

    /// A whole number.
    #[must_use]
    #[inline]
    pub(crate) const fn whole(n: i64) -> Self {
        Self::checked((n as i128) << BITS, 0)
    }

    /// Around n/d.
    #[inline]
    pub(crate) fn of(x: &Number) -> Self {
        match x {
            Number::Small(n, d) => Self::ratio(*n, *d),
            Number::Big(x) => Self::of_rational(x),
        }
    }

    /// Around n/d, d > 0.
    #[inline]
    fn ratio(n: i64, d: i64) -> Self {
        if d == 1 {
            return Self::whole(n);
        }
        let (n, d) = ((n as i128) << BITS, i128::from(d));
        let below = n.div_euclid(d);
        Self::checked(below, u64::from(below * d != n))
    }

    /// Around a big number.
    pub(crate) fn of_rational(x: &BigRational) -> Self {
        match on_both_sides(x, x) {
            Some([lo, hi]) => Self::between(lo, hi),
            None => Self::UNDEFINED,
        }
    }

    /// Around all numbers from one to another; `None` where that does not fit, or is too wide.
    pub(crate) fn around(lo: &BigRational, hi: &BigRational) -> Option<Self> {
        let [lo, hi] = on_both_sides(lo, hi)?;
        let span = Self::between(lo, hi);
        span.is_defined().then_some(span)
    }

    /// Around both numbers.
    pub(crate) fn joined(self, other: Self) -> Self {
        match (self.defined(), other.defined()) {
            (Some([a, b]), Some([c, d])) => Self::between(Ord::min(a, c), Ord::max(b, d)),
            _ => Self::UNDEFINED,
        }
    }

    /// How far its ends are apart, where it is defined.
    pub(crate) fn width(self) -> Option<i128> {
        self.is_defined().then(|| 2 * i128::from(self.radius))
    }

    /// The middle and the radius, in units of 2⁻⁶⁴, where the number is defined.
    #[inline]
    pub(crate) fn parts(self) -> Option<(i128, u64)> {
        self.is_defined().then_some((self.middle, self.radius))
    }

    /// A double near the number, where it is defined.
    #[allow(clippy::cast_precision_loss)] // that is what near means
    pub(crate) fn near(self) -> f64 {
        self.middle as f64 / ONE as f64
    }

    /// The ends, in units of 2⁻⁶⁴, of a number that is defined.
    #[inline]
    pub(crate) const fn ends(self) -> [i128; 2] {
        let radius = self.radius as i128;
        // 2¹²⁶ and 2⁶⁴ at most.
        [
            self.middle.wrapping_sub(radius),
            self.middle.wrapping_add(radius),
        ]
    }

    /// The ends, where the number is defined.
    #[inline]
    pub(crate) fn defined(self) -> Option<[i128; 2]> {
        self.is_defined().then_some(self.ends())
    }

    /// Whether the exact number is in it: for tests.
    #[cfg(test)]
    fn holds(self, x: &BigRational) -> bool {
        let [lo, hi] = self.ends().map(on_grid);
        self.is_defined() && lo <= *x && *x <= hi
    }
}

/// The upper and the lower half of a number on the grid: what is whole, and the rest.
#[inline]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // halves
const fn halves(x: i128) -> (i64, u64) {
    ((x >> BITS) as i64, x as u64)
}

/// a·b for a with a sign and b without.
#[inline]
const fn signed_by_unsigned(a: i64, b: u64) -> i128 {
    let product = (a.cast_unsigned() as u128) * (b as u128);
    // As an unsigned number, a below zero is 2⁶⁴ too much.
    let excess = if a < 0 { b } else { 0 };
    product.wrapping_sub((excess as u128) << BITS).cast_signed()
}

/// What a radius grows to by a factor of this magnitude, rounded up.
#[inline]
const fn radius_times(radius: u64, factor: u128) -> u128 {
    let upper = (factor >> BITS) * radius as u128;
    let lower = (factor & u64::MAX as u128) * radius as u128;
    let more = (lower >> BITS).wrapping_add((lower & u64::MAX as u128 != 0) as u128);
    // A factor is below 2¹²⁶, so that this is below 2⁶²·2⁶⁴ and a little more.
    upper.wrapping_add(more)
}

impl Add for Span {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        // Both are below 2¹²⁶.
        Self::checked(
            self.middle.wrapping_add(other.middle),
            self.radius.saturating_add(other.radius),
        )
    }
}

impl Neg for Span {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            middle: self.middle.wrapping_neg(),
            ..self
        }
    }
}

impl Sub for Span {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Span {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        // Past it a product may be LARGEST.
        const ROOM: i128 = 1 << 60;
        let ((a, a_rest), (b, b_rest)) = (halves(self.middle), halves(other.middle));
        let whole = i128::from(a) * i128::from(b);
        let fits = (-ROOM..ROOM).contains(&whole);
        if !(fits && self.is_defined() && other.is_defined()) {
            return Self::UNDEFINED;
        }
        let rest = u128::from(a_rest) * u128::from(b_rest);
        // |a·b| < 2⁶⁰ and |a|, |b| < 2⁶²: each term is below 2¹²⁶, and only one of the two in the middle can
        // be past 2¹²⁵. So nothing wraps around, and what is past LARGEST is seen.
        let middle = (whole << BITS)
            .wrapping_add(signed_by_unsigned(a, b_rest))
            .wrapping_add(signed_by_unsigned(b, a_rest))
            .wrapping_add((rest >> BITS).cast_signed());
        let mut radius = u128::from(rest & u128::from(u64::MAX) != 0);
        if self.radius | other.radius != 0 {
            // Below 2¹²⁶ and a little more each.
            radius = radius
                .wrapping_add(radius_times(other.radius, self.middle.unsigned_abs()))
                .wrapping_add(radius_times(self.radius, other.middle.unsigned_abs()))
                .wrapping_add(radius_times(self.radius, other.radius.into()));
        }
        match u64::try_from(radius) {
            Ok(radius) => Self::checked(middle, radius),
            Err(_) => Self::UNDEFINED,
        }
    }
}

impl Scalar for Span {
    #[inline]
    fn integer(n: i32) -> Self {
        Self::whole(n.into())
    }

    #[inline]
    fn half(self) -> Self {
        if !self.is_defined() {
            return self;
        }
        // Half of the radius, of what an odd middle loses by rounding down, and what rounds up.
        let odd = u64::from(self.middle & 1 != 0);
        Self {
            middle: self.middle >> 1,
            radius: self.radius.div_ceil(2) + (odd & !self.radius),
        }
    }

    #[inline]
    fn floor(&self) -> Self {
        let [lo, hi] = self.ends().map(|end| end >> BITS);
        match self.is_defined() && lo == hi {
            true => Self {
                middle: lo << BITS,
                radius: 0,
            },
            false => Self::UNDEFINED,
        }
    }

    #[inline]
    fn abs(&self) -> Self {
        let radius = i128::from(self.radius);
        let size = self.middle.abs();
        if size >= radius || !self.is_defined() {
            return Self {
                middle: size,
                ..*self
            };
        }
        Self::between(0, size + radius)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        match (self.defined(), other.defined()) {
            (Some([a, b]), Some([c, d])) => {
                if a >= d {
                    self
                } else if c >= b {
                    other
                } else {
                    Self::between(Ord::max(a, c), Ord::max(b, d))
                }
            }
            _ => Self::UNDEFINED,
        }
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        -Scalar::max(-self, -other)
    }

    #[inline]
    fn over(self, divisor: Self) -> Self {
        if divisor == Self::whole(1) {
            return self;
        }
        match divisor.middle < 0 {
            true => -self * (-divisor).inverse(),
            false => self * divisor.inverse(),
        }
    }
}

impl Span {
    /// 1/x for x above zero.
    ///
    /// With y near 1/x and e = 1 − xy, 1/x = y/(1 − e), which is y + ye + ye²/(1 − e).
    #[allow(clippy::cast_possible_truncation, clippy::cast_precision_loss)] // y need only be near
    fn inverse(self) -> Self {
        /// Below it, e²/(1 − e) ≤ 2e².
        const HALF: u128 = 1 << (BITS - 1);
        /// Past it 1/x is wider than 126 bits.
        const LEAST: i128 = 1 << 4;
        if !self.is_defined() || self.middle < LEAST {
            return Self::UNDEFINED;
        }
        let near = (ONE as f64 / self.middle as f64 * ONE as f64) as i128;
        let near = Self::checked(near, 0);
        let error = Self::whole(1) - self * near;
        let size = error.middle.unsigned_abs() + u128::from(error.radius);
        if !error.is_defined() || size > HALF {
            return Self::UNDEFINED;
        }
        // 2e² is at most 2⁶³ units, as is what is left.
        let square = (size * size).div_ceil(1 << (BITS - 1));
        let left = match u64::try_from(square) {
            Ok(square) => radius_times(square, near.middle.unsigned_abs()),
            Err(_) => return Self::UNDEFINED,
        };
        let inverse = near + near * error;
        match u64::try_from(left) {
            Ok(left) => Self {
                radius: inverse.radius.saturating_add(left),
                ..inverse
            },
            Err(_) => Self::UNDEFINED,
        }
    }
}

impl Ordered for Span {
    #[inline]
    fn sign(&self) -> Option<Ordering> {
        let radius = i128::from(self.radius);
        match (self.middle, self.radius) {
            (_, UNKNOWN) => None,
            (0, 0) => Some(Ordering::Equal),
            (middle, _) if middle > radius => Some(Ordering::Greater),
            (middle, _) if -middle > radius => Some(Ordering::Less),
            _ => None,
        }
    }

    #[inline]
    fn is_nonnegative(&self) -> Option<bool> {
        let [lo, hi] = self.defined()?;
        match (lo >= 0, hi < 0) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        }
    }

    #[inline]
    fn is_positive(&self) -> Option<bool> {
        (-*self).is_nonnegative().map(|is| !is)
    }
}

impl Written for Span {
    const EXACT: bool = false;

    fn to_reduced(&self) -> Option<Reduced> {
        (self.radius == 0).then_some(Reduced::Small(self.middle, ONE))
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        let span = match x {
            Reduced::Small(n, ONE) => Self::between(*n, *n),
            x => Self::of_rational(&x.to_rational()),
        };
        span.is_defined().then_some(span)
    }

    fn below(&self) -> Option<Reduced> {
        self.defined().map(|[lo, _]| Reduced::Small(lo, ONE))
    }

    fn above(&self) -> Option<Reduced> {
        self.defined().map(|[_, hi]| Reduced::Small(hi, ONE))
    }

    fn is_number(&self) -> bool {
        self.is_defined()
    }

    fn one_of(&self) -> Self {
        match self.is_defined() {
            true => Self { radius: 0, ..*self },
            false => *self,
        }
    }

    fn in_lowest_terms(&self) -> Option<Self> {
        self.is_defined().then_some(*self)
    }
}

mod grid;
#[cfg(test)]
mod tests;
