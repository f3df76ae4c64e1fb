//! The verdict on a scene: passive or not, the margins, and what to change.
//!
//! [`check`] asks the kernel whether the criterion holds over the box of the scene's tolerances
//! (CHECK-VERDICT) and collects every figure of the [`Report`], which is what programs get as JSON and people as text.

mod advice;
mod certificate;
mod constants;
mod decide;
mod design;
mod figures;
mod limits;
mod lines;
mod report;
mod text;
mod unforced;
mod witness;

pub use advice::{Advice, Binds, Change, Share, SpeedToSet};
pub use certificate::{Certificate, NotCertified};
pub use constants::{Amount, Condition, Constants, Target, constants};
pub use decide::Verdict;
pub use design::{Design, Setting, Stiffest, design};
pub use limits::{Limit, Side};
pub(crate) use limits::{border, is_searched, typed_back};
pub(crate) use lines::{Lines, headline, limits_heading};
pub(crate) use report::LimitFigures;
pub use report::{Costs, Report, Spare, check};
pub use text::{comparison, key_of, unit_of};
pub(crate) use text::{short, words};
pub use unforced::Unforced;
pub(crate) use witness::rationals;
pub use witness::{WaveFormula, Witness};

use passivity_core::{BigRational, Enclosed, Exact, Interval};

/// Bits of the figures of a report whose π does not cancel.
pub(crate) const BITS: u32 = 200;

/// An exact range as a close enclosure in rationals; `None` for an undefined number.
#[must_use]
pub fn enclosure(range: &Interval<Exact>) -> Option<Interval<BigRational>> {
    figure(range)
}

/// A figure as it is reported: from the lower bound of one end to the upper bound of the other.
pub(crate) fn figure<S: Enclosed>(range: &Interval<S>) -> Option<Interval<BigRational>> {
    let (lo, hi) = (range.lo().enclosed(BITS)?, range.hi().enclosed(BITS)?);
    Some(Interval::hull(lo.lo().clone(), hi.hi().clone()))
}
