//! The extreme values of a parabola with a kink, which net energy is along a line of positions.

use std::cmp::Ordering;

use passivity_core::Ordered;

/// αd² + σ|d| + γd + κ, as a function of the displacement d.
#[derive(Clone, Debug)]
pub(crate) struct Parabola<S> {
    /// α.
    pub(crate) square: S,
    /// σ.
    pub(crate) magnitude: S,
    /// γ.
    pub(crate) linear: S,
    /// κ.
    pub(crate) constant: S,
}

impl<S: Ordered> Parabola<S> {
    fn at(&self, d: &S) -> S {
        d.clone() * (self.square.clone() * d.clone() + self.linear.clone())
            + self.magnitude.clone() * d.abs()
            + self.constant.clone()
    }

    /// The least and the largest value on [from, to]; `None` when a number is undefined.
    ///
    /// The vertices of both branches are candidates, as are the ends and the kink at zero: so the
    /// extremes are exact. A vertex is inside where the slope changes its sign. Where an enclosure leaves that
    /// open the vertex is so close to an end that its value is not told from that of the end, and it may
    /// stand for it.
    pub(crate) fn range(&self, from: &S, to: &S) -> Option<[S; 2]> {
        let (first, last) = (self.at(from), self.at(to));
        let mut least = first.clone().min(last.clone());
        let mut most = first.max(last);
        let mut candidate = |value: S| {
            least = least.clone().min(value.clone());
            most = most.clone().max(value);
        };
        let zero = S::zero();
        let (left, right) = (from.sign()?, to.sign()?);
        if left != Ordering::Greater && right != Ordering::Less {
            candidate(self.constant.clone());
        }
        if self.square.sign()? != Ordering::Equal {
            let twice = self.square.double();
            let branches = [
                (
                    right == Ordering::Greater,
                    self.linear.clone() + self.magnitude.clone(),
                    (from.clone().max(zero.clone()), to.clone()),
                ),
                (
                    left == Ordering::Less,
                    self.linear.clone() - self.magnitude.clone(),
                    (from.clone(), to.clone().min(zero)),
                ),
            ];
            for (_, at_zero, (lo, hi)) in branches.into_iter().filter(|(is, ..)| *is) {
                let slope = |d: S| (twice.clone() * d + at_zero.clone()).sign();
                let turns = match (slope(lo), slope(hi)) {
                    (Some(Ordering::Equal), _) | (_, Some(Ordering::Equal)) => false,
                    (Some(first), Some(last)) => first != last,
                    _ => true,
                };
                if turns {
                    let height = at_zero.square().over(twice.double());
                    candidate(self.constant.clone() - height);
                }
            }
        }
        Some([least, most])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use passivity_core::{Fixed, Scalar as _};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn nothing_on_the_interval_is_beyond_the_extremes_and_they_are_reached(
            [a, s, g, k] in prop::array::uniform4(-12..13_i128),
            from in -40..41_i128,
            width in 0..60_i128,
        ) {
            let n = |n: i128| Fixed::new(n, 8);
            let parabola = Parabola { square: n(a), magnitude: n(s.abs()), linear: n(g), constant: n(k) };
            let [least, most] = parabola.range(&n(from), &n(from + width)).unwrap();
            let values: Vec<Fixed> =
                (0..=16 * width).map(|i| parabola.at(&Fixed::new(16 * from + i, 128))).collect();
            for value in &values {
                prop_assert!(least <= *value && *value <= most);
            }
            // A vertex is at most half a step of 1/128 from the grid: α(1/256)² ≤ 13/8/65536.
            let slack = Fixed::new(13, 8 * 65536);
            let near = |end: Fixed| values.iter().any(|value| (*value - end).abs() <= slack);
            prop_assert!(near(least) && near(most));
        }
    }
}
