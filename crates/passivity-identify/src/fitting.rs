//! A best estimate that its own logs do not refute.
//!
//! Parts of the parameters are left where they are not refuted, and so may still hold refuted places: the estimate
//! is held to what refutes parts, as a part of one place.

use crate::estimate;
use crate::log::Log;
use crate::region::Ends;
use crate::search::Judge;

/// How often the way from what fits towards what does not is halved.
const HALVINGS: u32 = 6;

/// Parameters in a box that the logs do not refute: these, or others near them; `None` where none are found.
///
/// They lie between these and where the largest residual is the smallest, or some that are `known` to fit, about as far
/// from there as they fit.
pub(crate) fn fitting(
    logs: &[Log],
    hull: &[Ends; 3],
    at: [f64; 3],
    known: Option<[f64; 3]>,
) -> Option<[f64; 3]> {
    let mut judge = Judge::new(logs);
    if judge.lets(at) {
        return Some(at);
    }
    let mut evener = estimate::evener(logs, hull, at);
    let (mut inside, mut outside) = (evener.find(|at| judge.lets(*at)).or(known)?, at);
    for _ in 0..HALVINGS {
        let mut ends = inside.into_iter().zip(outside);
        let middle = [0; 3].map(|_| ends.next().map_or(f64::NAN, |(a, b)| 0.5 * a + 0.5 * b));
        match judge.lets(middle) {
            true => inside = middle,
            false => outside = middle,
        }
    }
    Some(inside)
}
