//! Closed intervals of exact numbers, and truth that may depend on where in them one is.

use crate::scalar::Ordered;

/// A closed interval [lo, hi] of exact numbers; a point when both ends agree.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Interval, Scalar};
///
/// let tolerance = Interval::new(Fixed::new(9, 10), Fixed::new(11, 10)).unwrap();
/// assert!(!tolerance.is_point());
/// assert!(Interval::new(Fixed::integer(2), Fixed::integer(1)).is_none());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval<S> {
    lo: S,
    hi: S,
}

impl<S> Interval<S> {
    /// The interval [lo, hi], without a look at whether lo ≤ hi: that is the caller's word.
    #[must_use]
    pub const fn new_unchecked(lo: S, hi: S) -> Self {
        Self { lo, hi }
    }

    /// The interval with both ends taken through `f`, which must keep their order.
    pub fn map<U>(&self, f: impl Fn(&S) -> U) -> Interval<U> {
        Interval {
            lo: f(&self.lo),
            hi: f(&self.hi),
        }
    }

    /// The same, where `f` may give up: `None` then.
    pub fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Interval<U>> {
        Some(Interval {
            lo: f(&self.lo)?,
            hi: f(&self.hi)?,
        })
    }

    /// The lower end.
    #[must_use]
    pub const fn lo(&self) -> &S {
        &self.lo
    }

    /// The upper end.
    #[must_use]
    pub const fn hi(&self) -> &S {
        &self.hi
    }
}

impl<S: Ordered> Interval<S> {
    /// The interval [lo, hi]; `None` when lo > hi or an end is undefined.
    #[must_use]
    pub fn new(lo: S, hi: S) -> Option<Self> {
        (hi.clone() - lo.clone())
            .is_nonnegative()?
            .then_some(Self { lo, hi })
    }

    /// Half-way between the ends.
    #[must_use]
    pub fn middle(&self) -> S {
        (self.lo.clone() + self.hi.clone()).half()
    }

    /// Half of the width.
    #[must_use]
    pub fn radius(&self) -> S {
        (self.hi.clone() - self.lo.clone()).half()
    }

    /// The interval that holds one number only.
    #[must_use]
    pub fn point(x: S) -> Self {
        Self {
            lo: x.clone(),
            hi: x,
        }
    }

    /// The smallest interval that holds both numbers.
    #[must_use]
    pub fn hull(a: S, b: S) -> Self {
        Self {
            lo: a.clone().min(b.clone()),
            hi: a.max(b),
        }
    }

    /// The smallest interval that holds both intervals.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        Self {
            lo: self.lo.clone().min(other.lo.clone()),
            hi: self.hi.clone().max(other.hi.clone()),
        }
    }

    /// Whether the interval holds one number only.
    #[must_use]
    pub fn is_point(&self) -> bool {
        self.lo.compare(&self.hi) == Some(core::cmp::Ordering::Equal)
    }

    /// Whether every number of the interval is at least zero, none is, or it depends.
    #[must_use]
    pub fn is_nonnegative(&self) -> Option<Truth> {
        Some(Truth::over(
            self.lo.is_nonnegative()?,
            self.hi.is_nonnegative()?,
        ))
    }
}

/// Whether a statement about an interval of parameters is true of all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Truth {
    /// For every value in the interval.
    Holds,
    /// For no value in the interval.
    Fails,
    /// For some and not for others, or it could not be told apart.
    Depends,
}

impl Truth {
    /// From the answers at the least and at the most favourable values.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::Truth;
    ///
    /// assert_eq!(Truth::over(false, true), Truth::Depends);
    /// ```
    #[must_use]
    #[cfg_attr(prusti, prusti_contracts::ensures(at_worst == matches!(result, Truth::Holds)))]
    #[cfg_attr(prusti, prusti_contracts::ensures((!at_worst && !at_best) == matches!(result, Truth::Fails)))]
    pub const fn over(at_worst: bool, at_best: bool) -> Self {
        match (at_worst, at_best) {
            (true, _) => Self::Holds,
            (false, false) => Self::Fails,
            (false, true) => Self::Depends,
        }
    }

    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Fails => "fails",
            Self::Depends => "depends",
        }
    }
}
