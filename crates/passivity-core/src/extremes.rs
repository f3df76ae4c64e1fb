//! Where the row of an interval is extreme, of which only the ends of both positions are known
//! (TH-COUNTS).
//!
//! An encoder's count n leaves a position anywhere in [n, n + 1], so that an interval is a rectangle of
//! pairs (ξ₀, ξ₁). What depends on the distance alone is extreme where they are [`nearest`] and
//! [`farthest`]. Net energy is of one slope on every line of equal displacement d, so it is extreme on the
//! edge of the rectangle; there generated energy is αd² + γd + κ, known from three of its values
//! ([`through`]), and net energy a [`Parabola`] with a kink at d = 0.

use core::cmp::Ordering;

use crate::scalar::Ordered;

/// A pair of positions as near to each other as can be, each between two ends; `None` when an end is
/// undefined.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, extremes};
///
/// let [one, two, three, four] = [1, 2, 3, 4].map(Fixed::integer);
/// assert_eq!(extremes::nearest([&one, &two], [&three, &four]), Some([&two, &three]));
/// assert_eq!(extremes::farthest([&one, &two], [&three, &four]), Some([&one, &four]));
/// ```
#[must_use]
pub fn nearest<'a, S: Ordered>(start: [&'a S; 2], end: [&'a S; 2]) -> Option<[&'a S; 2]> {
    let ([from, to], [first, last]) = (start, end);
    Some(if to.compare(first)? == Ordering::Less {
        [to, first]
    } else if last.compare(from)? == Ordering::Less {
        [from, last]
    } else if from.compare(first)? == Ordering::Less {
        [first, first]
    } else {
        [from, from]
    })
}

/// A pair of positions as far from each other as can be, each between two ends; `None` when an end is
/// undefined.
#[must_use]
pub fn farthest<'a, S: Ordered>(start: [&'a S; 2], end: [&'a S; 2]) -> Option<[&'a S; 2]> {
    let ([from, to], [first, last]) = (start, end);
    let length = |[from, to]: [&S; 2]| (to.clone() - from.clone()).abs();
    let (outward, inward) = ([from, last], [to, first]);
    let longer = length(outward).compare(&length(inward))? != Ordering::Less;
    Some(if longer { outward } else { inward })
}

/// α, γ and κ of generated energy αd² + γd + κ on an edge of the rectangle, from its values at one end,
/// in the middle and at the other end, and the displacements at the two ends; `None` when one is
/// undefined.
#[must_use]
pub fn through<S: Ordered>([a, b, c]: [S; 3], [from, to]: [S; 2]) -> Option<[S; 3]> {
    let width = to.clone() - from.clone();
    let slope = (c.clone() - a.clone()).over(width.clone());
    // The second difference a − 2b + c is 2α(width/2)².
    let alpha = (a.clone() - b.double() + c).double().over(width.square());
    let gamma = slope - alpha.clone() * (from.double() + width);
    let one_way = from.is_positive()? == to.is_positive()?
        && from.is_nonnegative()? == to.is_nonnegative()?
        && from.sign()? != Ordering::Equal;
    let kappa = match one_way {
        true => a - from.clone() * (alpha.clone() * from + gamma.clone()),
        // Without a displacement nothing is generated.
        false => S::zero(),
    };
    Some([alpha, gamma, kappa])
}

/// αd² + σ|d| + γd + κ, as a function of the displacement d.
#[derive(Clone, Debug)]
pub struct Parabola<S> {
    /// α.
    pub square: S,
    /// σ.
    pub magnitude: S,
    /// γ.
    pub linear: S,
    /// κ.
    pub constant: S,
}

impl<S: Ordered> Parabola<S> {
    /// The value at a displacement.
    #[must_use]
    pub fn at(&self, d: &S) -> S {
        d.clone() * (self.square.clone() * d.clone() + self.linear.clone())
            + self.magnitude.clone() * d.abs()
            + self.constant.clone()
    }

    /// The least and the largest value on [from, to]; `None` when a number is undefined.
    ///
    /// Before and after the kink at zero the function is a parabola of its own: see
    /// [`range_one_way`](Self::range_one_way).
    #[must_use]
    pub fn range(&self, from: &S, to: &S) -> Option<[S; 2]> {
        let zero = S::zero();
        if from.sign()? != Ordering::Less || to.sign()? != Ordering::Greater {
            return self.range_one_way(from, to);
        }
        let [least, most] = self.range_one_way(from, &zero)?;
        let [other_least, other_most] = self.range_one_way(&zero, to)?;
        Some([least.min(other_least), most.max(other_most)])
    }

    /// The same where zero is not between the ends.
    ///
    /// The ends are candidates, and the vertex where it is inside: where the slope changes its sign. Where an
    /// enclosure leaves that open the vertex is so close to an end that its value is not told from that of the
    /// end, and it may stand for it.
    #[must_use]
    pub fn range_one_way(&self, from: &S, to: &S) -> Option<[S; 2]> {
        let (first, last) = (self.at(from), self.at(to));
        let least = first.clone().min(last.clone());
        let most = first.max(last);
        if self.square.sign()? == Ordering::Equal {
            return Some([least, most]);
        }
        let at_zero = match from.is_nonnegative()? {
            true => self.linear.clone() + self.magnitude.clone(),
            false => self.linear.clone() - self.magnitude.clone(),
        };
        let twice = self.square.double();
        let slope = |d: &S| (twice.clone() * d.clone() + at_zero.clone()).sign();
        let turns = match (slope(from), slope(to)) {
            (Some(Ordering::Equal), _) | (_, Some(Ordering::Equal)) => false,
            (Some(first), Some(last)) => first != last,
            _ => true,
        };
        if !turns {
            return Some([least, most]);
        }
        let vertex = self.constant.clone() - at_zero.square().over(twice.double());
        Some([least.min(vertex.clone()), most.max(vertex)])
    }
}
