//! A figure that is known exactly, or that an exact enclosure is known of.

use std::cmp::Ordering;

use passivity_core::{Ordered, Truth};

/// One number, or all numbers from a lower to an upper end.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar};
/// use passivity_oracle::Span;
///
/// let count = Span::Between(Fixed::integer(3), Fixed::integer(4)); // an encoder that reads 3
/// assert_eq!(count.lo(), &Fixed::integer(3));
/// assert!(count.exact().is_none());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Span<S> {
    /// Exactly this number.
    At(S),
    /// From the first to the second, the first not above the second.
    Between(S, S),
}

impl<S> Span<S> {
    /// The lower end.
    pub const fn lo(&self) -> &S {
        match self {
            Self::At(x) | Self::Between(x, _) => x,
        }
    }

    /// The upper end.
    pub const fn hi(&self) -> &S {
        match self {
            Self::At(x) | Self::Between(_, x) => x,
        }
    }

    /// The number, when it is known exactly.
    pub const fn exact(&self) -> Option<&S> {
        match self {
            Self::At(x) => Some(x),
            Self::Between(..) => None,
        }
    }

    /// Both ends through `f`; `None` when `f` gives up on one.
    pub fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Span<U>> {
        Some(match self {
            Self::At(x) => Span::At(f(x)?),
            Self::Between(lo, hi) => Span::Between(f(lo)?, f(hi)?),
        })
    }
}

impl<S: Ordered> Span<S> {
    /// The span between two ends, a single number when they agree.
    #[must_use]
    pub fn of(lo: S, hi: S) -> Self {
        if lo.compare(&hi) == Some(Ordering::Equal) {
            Self::At(lo)
        } else {
            Self::Between(lo, hi)
        }
    }

    /// Whether both ends are defined numbers.
    #[must_use]
    pub fn is_defined(&self) -> bool {
        self.lo().sign().is_some() && self.hi().sign().is_some()
    }

    /// Whether every number is at least zero, none is, or it depends; `None` when undefined.
    #[must_use]
    pub fn is_nonnegative(&self) -> Option<Truth> {
        Some(Truth::over(
            self.lo().is_nonnegative()?,
            self.hi().is_nonnegative()?,
        ))
    }

    /// The span of x + y.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::At(x), Self::At(y)) => Self::At(x.clone() + y.clone()),
            _ => Self::Between(
                self.lo().clone() + other.lo().clone(),
                self.hi().clone() + other.hi().clone(),
            ),
        }
    }

    /// The span of x − y, for x and y that vary on their own.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        match (self, other) {
            (Self::At(x), Self::At(y)) => Self::At(x.clone() - y.clone()),
            _ => Self::Between(
                self.lo().clone() - other.hi().clone(),
                self.hi().clone() - other.lo().clone(),
            ),
        }
    }

    /// The span of |x|.
    #[must_use]
    pub fn magnitude(&self) -> Self {
        match self {
            Self::At(x) => Self::At(x.abs()),
            Self::Between(lo, hi) => Self::Between(
                // The distance of the span from zero, without a branch on signs.
                lo.clone().max(-hi.clone()).max(S::zero()),
                lo.abs().max(hi.abs()),
            ),
        }
    }

    /// The span of f(x) for an f that rises with x.
    #[must_use]
    pub fn rising(&self, f: impl Fn(&S) -> S) -> Self {
        match self {
            Self::At(x) => Self::At(f(x)),
            Self::Between(lo, hi) => Self::Between(f(lo), f(hi)),
        }
    }
}

/// The opposite of a truth.
#[must_use]
pub const fn not(truth: Truth) -> Truth {
    match truth {
        Truth::Holds => Truth::Fails,
        Truth::Fails => Truth::Holds,
        Truth::Depends => Truth::Depends,
    }
}

/// The extreme values of αd² + σ|d| + γd + κ for d from `from` to `to`.
///
/// The vertices of both branches are candidates, as are the ends and the kink at zero: so the
/// extremes are exact.
#[derive(Clone, Debug)]
pub(crate) struct Parabola<S> {
    pub(crate) square: S,
    pub(crate) magnitude: S,
    pub(crate) linear: S,
    pub(crate) constant: S,
}

impl<S: Ordered> Parabola<S> {
    fn at(&self, d: &S) -> S {
        d.clone() * (self.square.clone() * d.clone() + self.linear.clone())
            + self.magnitude.clone() * d.abs()
            + self.constant.clone()
    }

    /// The least and the largest value on [from, to]; `None` when a number is undefined.
    pub(crate) fn range(&self, from: &S, to: &S) -> Option<(S, S)> {
        let (first, last) = (self.at(from), self.at(to));
        let mut least = first.clone().min(last.clone());
        let mut most = first.max(last);
        let mut candidate = |value: S| {
            least = least.clone().min(value.clone());
            most = most.clone().max(value);
        };
        let (zero, curved) = (S::zero(), self.square.sign()? != Ordering::Equal);
        let inside = |d: &S, lo: &S, hi: &S| {
            Some(d.compare(lo)? != Ordering::Less && d.compare(hi)? != Ordering::Greater)
        };
        if inside(&zero, from, to)? {
            candidate(self.constant.clone());
        }
        if curved {
            for (slope, lo, hi) in [
                (
                    self.linear.clone() + self.magnitude.clone(),
                    from.clone().max(zero.clone()),
                    to.clone(),
                ),
                (
                    self.linear.clone() - self.magnitude.clone(),
                    from.clone(),
                    to.clone().min(zero.clone()),
                ),
            ] {
                let twice = self.square.double();
                let vertex = (-slope.clone()).over(twice.clone());
                if inside(&vertex, &lo, &hi)? {
                    candidate(self.constant.clone() - slope.square().over(twice).half());
                }
            }
        }
        Some((least, most))
    }
}
