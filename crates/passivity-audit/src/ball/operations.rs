//! What the kernel's formulas do with balls.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use passivity_core::{Ordered, Scalar};

use super::bits::{is_more, off_product, rest_of_product, rest_of_sum, split, unless};
use super::{Ball, OUTWARD, ROUNDING, TINY, WHOLE};
use crate::number::{Reduced, Written};
use crate::span::ONE;

impl<const BRANCHES: bool> Add for Ball<BRANCHES> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let middle = self.middle + other.middle;
        let radius = self.radius + other.radius;
        let rest = || rest_of_sum(self.middle, other.middle).abs();
        let is_exact = match BRANCHES {
            true => !is_more(radius) && radius == 0.0 && rest() == 0.0,
            false => radius + rest() == 0.0,
        };
        if is_exact {
            return Self::exactly(middle);
        }
        Self {
            middle,
            radius: (radius + ROUNDING * middle.abs()) * OUTWARD,
        }
    }
}

impl<const BRANCHES: bool> Neg for Ball<BRANCHES> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            middle: -self.middle,
            ..self
        }
    }
}

impl<const BRANCHES: bool> Sub for Ball<BRANCHES> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const BRANCHES: bool> Mul for Ball<BRANCHES> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        // Zero has one form.
        let middle = self.middle * other.middle + 0.0;
        let radius = self.radius + other.radius;
        let off = || {
            let (a, b) = (self.middle, other.middle);
            // Processors that compute several at a time round a product and a sum at once. One by one, where that may be
            // a call, it takes longer than in halves.
            let rest = match BRANCHES {
                true => rest_of_product(a, b),
                false => a.mul_add(b, -(a * b)),
            };
            radius + off_product(a, b, rest)
        };
        // What stands still generates nothing, not even a rounding: the smaller one is zero. Where one of them is
        // undefined this is no number.
        let still = || {
            let (own, others) = (self.size(), other.size());
            (if own < others { own } else { others }) + radius * 0.0
        };
        let is_exact = match BRANCHES {
            true => !is_more(radius) && off() == 0.0 || !is_more(middle.abs()) && still() == 0.0,
            false => {
                let (off, still) = (off(), still());
                (if off < still { off } else { still }) == 0.0
            }
        };
        if is_exact {
            return Self::exactly(middle);
        }
        let radius = self.middle.abs() * other.radius
            + self.radius * (other.middle.abs() + other.radius)
            + (ROUNDING * middle.abs() + TINY);
        Self {
            middle,
            radius: radius * OUTWARD,
        }
    }
}

impl<const BRANCHES: bool> Scalar for Ball<BRANCHES> {
    #[inline(always)]
    fn integer(n: i32) -> Self {
        Self::exactly(n.into())
    }

    #[inline(always)]
    fn half(self) -> Self {
        // Half of the smallest double is none.
        let size = self.middle.abs();
        let small = if size > 2.0 * TINY { 0.0 } else { size };
        let is_exact = self.radius + small == 0.0;
        Self {
            middle: 0.5 * self.middle,
            radius: 0.5 * self.radius + if is_exact { 0.0 } else { TINY },
        }
    }

    #[inline(always)]
    fn floor(&self) -> Self {
        let nearest = self.middle - split(self.middle).1;
        let below = match nearest > self.middle {
            true => nearest - 1.0,
            false => nearest,
        };
        // Exact: a double has no digits behind those of a larger one.
        let rest = self.middle - below;
        let open = unless(self.middle.abs() < WHOLE / 4.0)
            + unless(rest >= self.radius)
            + unless((1.0 - rest) > self.radius * OUTWARD);
        match open == 0.0 {
            true => Self::exactly(below),
            false => Self::UNDEFINED,
        }
    }

    #[inline(always)]
    fn abs(&self) -> Self {
        Self {
            middle: self.middle.abs(),
            ..*self
        }
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        let apart = self.middle - other.middle;
        let reach = (self.radius + other.radius) * OUTWARD;
        if apart >= reach {
            self
        } else if -apart >= reach {
            other
        } else {
            Self {
                middle: f64::max(self.middle, other.middle),
                radius: reach,
            }
        }
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        -Scalar::max(-self, -other)
    }

    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        if divisor == Self::exactly(1.0) {
            return self;
        }
        let away = divisor.middle.abs() - divisor.radius * OUTWARD;
        if !(away > 0.0 && self.is_defined()) {
            return Self::UNDEFINED;
        }
        if self.is_zero() {
            return Self::exactly(0.0);
        }
        let middle = self.middle / divisor.middle;
        // |A/B − a/b| ≤ (|A − a| + |a/b|·|B − b|)/|B|.
        let spread = (self.radius + (middle.abs() + TINY) * divisor.radius * OUTWARD) / away;
        Self {
            middle,
            radius: (spread + (ROUNDING * middle.abs() + TINY)) * OUTWARD,
        }
    }
}

impl<const BRANCHES: bool> Ordered for Ball<BRANCHES> {
    #[inline(always)]
    fn sign(&self) -> Option<Ordering> {
        let Self { middle, radius } = *self;
        if middle > radius {
            Some(Ordering::Greater)
        } else if -middle > radius {
            Some(Ordering::Less)
        } else {
            self.is_zero().then_some(Ordering::Equal)
        }
    }

    #[inline(always)]
    fn is_nonnegative(&self) -> Option<bool> {
        if self.middle >= self.radius {
            Some(true)
        } else {
            (-self.middle > self.radius).then_some(false)
        }
    }

    #[inline(always)]
    fn is_positive(&self) -> Option<bool> {
        (-*self).is_nonnegative().map(|is| !is)
    }
}

impl Written for Ball {
    const EXACT: bool = false;

    fn to_reduced(&self) -> Option<Reduced> {
        match self.units()? {
            (n, 0) => Some(Reduced::Small(n, ONE)),
            _ => None,
        }
    }

    fn from_reduced(x: &Reduced) -> Option<Self> {
        let ball = match x {
            Reduced::Small(n, ONE) => Self::of_units(*n),
            x => Self::of_rational(&x.to_rational()),
        };
        ball.is_defined().then_some(ball)
    }

    #[inline(always)]
    fn below(&self) -> Option<Reduced> {
        self.on_grid().map(|[lo, _]| Reduced::Small(lo, ONE))
    }

    #[inline(always)]
    fn above(&self) -> Option<Reduced> {
        self.on_grid().map(|[_, hi]| Reduced::Small(hi, ONE))
    }

    fn is_number(&self) -> bool {
        self.is_defined()
    }

    #[inline(always)]
    fn one_of(&self) -> Self {
        (*self).one_of()
    }

    fn in_lowest_terms(&self) -> Option<Self> {
        self.is_defined().then_some(*self)
    }
}
