//! Numbers of a log that are known to within a few multiples of 2⁻⁶⁴.

use std::ops::Neg;

use passivity_core::BigRational;

pub(crate) use grid::{below_on_grid, on_both_sides, on_grid, outward, units};

/// Bits behind the point.
pub(crate) const BITS: u32 = 64;

/// One, on the grid.
pub(crate) const ONE: i128 = 1 << BITS;

/// A number that is no further than a radius from a middle, both of them multiples of 2⁻⁶⁴.
///
/// What does not fit is undefined.
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

    /// Around all numbers from one to another; `None` where that does not fit, or is too wide.
    pub(crate) fn around(lo: &BigRational, hi: &BigRational) -> Option<Self> {
        let [lo, hi] = on_both_sides(lo, hi)?;
        let span = Self::between(lo, hi);
        span.is_defined().then_some(span)
    }

    /// The middle and the radius, in units of 2⁻⁶⁴, where the number is defined.
    #[inline]
    pub(crate) fn parts(self) -> Option<(i128, u64)> {
        self.is_defined().then_some((self.middle, self.radius))
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

    /// Whether all of it is within one tick.
    #[inline]
    pub(crate) const fn is_within_a_tick(self) -> bool {
        let [lo, hi] = self.ends();
        self.is_defined() && lo >> BITS == hi >> BITS
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

mod grid;
