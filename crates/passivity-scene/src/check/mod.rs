//! The verdict on a scene: passive or not, the margins, and what to change.
//!
//! [`check`] asks the kernel whether the criterion holds over the box of the scene's tolerances
//! (CHECK-VERDICT) and collects every figure of the [`Report`], which is what programs get as JSON and people as text.

mod decide;
mod figures;
mod limits;
mod report;
mod text;
mod unforced;

pub use decide::Verdict;
pub use limits::{Limit, Side};
pub use report::{Costs, Report, Spare, Witness, check};
pub use unforced::Unforced;

use passivity_core::{BigRational, Exact, Interval, Ordered, Wide, rational};

/// Bits of the figures of a report whose π does not cancel.
const BITS: u32 = 200;

/// A number that a report is computed with: without π, or with it.
pub(crate) trait Number: Ordered {
    /// An exact number; `None` where this kind of number cannot hold it.
    fn of(x: &Exact) -> Option<Self>;

    /// The number, or a close enclosure of it; `None` for an undefined one.
    fn enclosed(&self, bits: u32) -> Option<Interval<BigRational>>;
}

impl Number for Wide {
    fn of(x: &Exact) -> Option<Self> {
        x.to_wide()
    }

    fn enclosed(&self, _bits: u32) -> Option<Interval<BigRational>> {
        rational::from_wide(self).map(Interval::point)
    }
}

impl Number for Exact {
    fn of(x: &Exact) -> Option<Self> {
        Some(x.clone())
    }

    fn enclosed(&self, bits: u32) -> Option<Interval<BigRational>> {
        self.enclosure(bits)
    }
}

/// An exact range as a close enclosure in rationals; `None` for an undefined number.
#[must_use]
pub fn enclosure(range: &Interval<Exact>) -> Option<Interval<BigRational>> {
    figure(range)
}

/// A figure as it is reported: from the lower bound of one end to the upper bound of the other.
fn figure<S: Number>(range: &Interval<S>) -> Option<Interval<BigRational>> {
    let (lo, hi) = (range.lo().enclosed(BITS)?, range.hi().enclosed(BITS)?);
    Some(Interval::hull(lo.lo().clone(), hi.hi().clone()))
}
