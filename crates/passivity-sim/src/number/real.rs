//! The operations that a motion needs of a number, beyond those of the kernel's formulas.

use passivity_core::Ordered;

/// A sign or a floor that the number at hand cannot tell: an interval that straddles an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Undecided;

/// A number of the kernel that a motion can be computed with.
///
/// As in the kernel an operation that has no result gives an undefined value that stays undefined:
/// the floor of an interval that straddles an edge, for one. A sign is `None` where it cannot be
/// told, of an undefined value or of an interval that holds both signs.
pub trait Real: Ordered {
    /// Whether it is an interval that holds the number meant.
    const ENCLOSES: bool = false;

    /// A double near the number; NaN for an undefined one.
    fn approximate(&self) -> f64;

    /// Whether the number is not undefined.
    fn is_defined(&self) -> bool;

    /// The number, unless it is undefined.
    ///
    /// # Errors
    ///
    /// [`Undecided`] for an undefined number: a floor of an interval that straddles an edge is where
    /// they come from.
    fn decided(self) -> Result<Self, Undecided> {
        if self.is_defined() {
            Ok(self)
        } else {
            Err(Undecided)
        }
    }

    /// How many bits the number is good for: where a series may stop.
    fn bits(&self) -> u32;

    /// The integer `n`, as precise as `self` is.
    #[must_use]
    fn whole(&self, n: i32) -> Self {
        let _ = self;
        Self::integer(n)
    }

    /// The number n/m, as precise as `self` is.
    #[must_use]
    fn ratio(&self, n: i32, m: i32) -> Self {
        self.whole(n).over(Self::integer(m))
    }

    /// The number, where its error may be up to |`bound`|: intervals grow by it, others do not.
    #[must_use]
    fn widened(self, bound: &Self) -> Self {
        let _ = bound;
        self
    }

    /// What holds both numbers, when a comparison could not tell which of them is right.
    #[must_use]
    fn join(self, other: Self) -> Self {
        let _ = other;
        self
    }

    /// One of the numbers that it may be.
    #[must_use]
    fn one_of(&self) -> Self {
        self.clone()
    }

    /// The ends of what is known of the number, where they differ.
    fn ends(&self) -> Option<[Self; 2]> {
        None
    }

    /// How many bits it takes to write the number down, if that can grow.
    fn length(&self) -> u64 {
        0
    }
}
