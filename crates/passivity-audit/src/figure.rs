//! A figure of the account: a number that is known exactly, or that an exact enclosure is known of.

use passivity_core::{Interval, Ordered, Truth};

/// One number, or all numbers from a lower to an upper end.
///
/// Which of the two a figure is, is a matter of what the trace and the scene say, not of its value:
/// an enclosure may have equal ends.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar};
/// use passivity_audit::Figure;
///
/// let count = Figure::between(Fixed::integer(3), Fixed::integer(4)).unwrap(); // an encoder reads 3
/// assert_eq!(count.lo(), &Fixed::integer(3));
/// assert!(count.exact().is_none());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Figure<S> {
    /// Exactly this number.
    Exact(S),
    /// A number in this interval.
    Enclosed(Interval<S>),
}

impl<S> Figure<S> {
    /// The lower end.
    pub const fn lo(&self) -> &S {
        match self {
            Self::Exact(x) => x,
            Self::Enclosed(range) => range.lo(),
        }
    }

    /// The upper end.
    pub const fn hi(&self) -> &S {
        match self {
            Self::Exact(x) => x,
            Self::Enclosed(range) => range.hi(),
        }
    }

    /// The number, when it is known exactly.
    pub const fn exact(&self) -> Option<&S> {
        match self {
            Self::Exact(x) => Some(x),
            Self::Enclosed(_) => None,
        }
    }

    /// Whether the number is known exactly.
    pub const fn is_exact(&self) -> bool {
        matches!(self, Self::Exact(_))
    }

    /// Both ends through `f`, which must keep their order; `None` when `f` gives up on one.
    pub fn try_map<U>(&self, f: impl Fn(&S) -> Option<U>) -> Option<Figure<U>> {
        Some(match self {
            Self::Exact(x) => Figure::Exact(f(x)?),
            Self::Enclosed(range) => Figure::Enclosed(range.try_map(f)?),
        })
    }
}

impl<S: Ordered> Figure<S> {
    /// The enclosure from `lo` to `hi`; `None` when lo > hi or an end is undefined.
    #[must_use]
    pub fn between(lo: S, hi: S) -> Option<Self> {
        Interval::new(lo, hi).map(Self::Enclosed)
    }

    /// Whether every number is at least zero, none is, or it depends; `None` when undefined.
    #[must_use]
    pub fn is_nonnegative(&self) -> Option<Truth> {
        Some(Truth::over(
            self.lo().is_nonnegative()?,
            self.hi().is_nonnegative()?,
        ))
    }

    /// x + y; `None` when it is undefined.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Option<Self> {
        let lo = self.lo().clone() + other.lo().clone();
        match (self, other) {
            (Self::Exact(_), Self::Exact(_)) => Some(Self::Exact(lo)),
            _ => Self::between(lo, self.hi().clone() + other.hi().clone()),
        }
    }

    /// x − y, for x and y that vary on their own; `None` when it is undefined.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Option<Self> {
        let lo = self.lo().clone() - other.hi().clone();
        match (self, other) {
            (Self::Exact(_), Self::Exact(_)) => Some(Self::Exact(lo)),
            _ => Self::between(lo, self.hi().clone() - other.lo().clone()),
        }
    }

    /// |x|; `None` when it is undefined.
    #[must_use]
    pub fn magnitude(&self) -> Option<Self> {
        match self {
            Self::Exact(x) => Some(Self::Exact(x.abs())),
            Self::Enclosed(range) => {
                let (lo, hi) = (range.lo(), range.hi());
                // The distance of the interval from zero, without a branch on signs.
                let least = lo.clone().max(-hi.clone()).max(S::zero());
                Self::between(least, lo.abs().max(hi.abs()))
            }
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
