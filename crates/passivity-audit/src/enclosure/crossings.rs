//! Both accounts of an interval between two counts, in closed form, where the law is not bent within the ticks or between
//! them.

use std::cmp::Ordering;

use passivity_core::counted::{Crossing, Resistance};
use passivity_core::{Loop, Ordered};

use super::{Accounts, Rectangle, join, net_along};
use crate::figure::Figure;
use crate::number::Written;

/// Motions between two counts, one under each end of the force: where the law is linear, or where it is the same force.
pub(super) enum Crossings<S> {
    Linear(Vec<Crossing<S>>),
    Flat(Vec<Crossing<S>>),
}

impl<S: Written> Rectangle<'_, S> {
    /// The interval as one between two counts, under each end of the force; `None` where a position is known
    /// otherwise, and where the law is bent within the ticks or between them.
    pub(super) fn crossings(&self) -> Option<Crossings<S>> {
        let law = self.ends.least.law();
        let is_tick = |of: &Figure<S>| {
            let end = of.lo().clone() + S::one();
            of.hi().compare(&end) == Some(Ordering::Equal)
        };
        let is_below = |a: &S, b: &S| (b.clone() - a.clone()).is_nonnegative() == Some(true);
        let positions = [self.start, self.end];
        let all_below = |end: &S| positions.iter().all(|of| is_below(of.hi(), end));
        let all_above = |end: &S| positions.iter().all(|of| is_below(end, of.lo()));
        let (lower, upper) = (law.lower.as_ref(), law.upper.as_ref());
        let is_flat = || lower.is_some_and(all_below) || upper.is_some_and(all_above);
        let is_counted = positions.into_iter().all(is_tick) && self.ends.least.has_encoder();
        let is_linear = is_counted && lower.is_none_or(all_above) && upper.is_none_or(all_below);
        // Doubles have closed forms of their own there.
        if !(is_linear || (is_counted && S::EXACT && is_flat())) {
            return None;
        }
        let own = law.held_force(self.start.lo());
        let crossing = |force: &S| Crossing {
            ticks: self.end.lo().clone() - self.start.lo().clone(),
            excess: force.clone() - own.clone(),
        };
        let of_kind = if is_linear {
            Crossings::Linear
        } else {
            Crossings::Flat
        };
        Some(of_kind(self.forces().map(crossing).collect()))
    }

    /// Generated energy at its extremes.
    pub(super) fn generated_by(&self, crossings: &Crossings<S>) -> Option<[Figure<S>; 2]> {
        match crossings {
            Crossings::Linear(found) => self.joined(found.iter().map(Crossing::generated)),
            // A multiple of the distance.
            Crossings::Flat(found) => self.joined(found.iter().map(|of| {
                let [a, b] = displacements(of).map(|d| of.excess.clone() * d);
                let range = [a.clone().min(b.clone()), a.max(b)];
                [range.clone(), range]
            })),
        }
    }

    /// `dissipated_lower` less generated energy, at its extremes.
    pub(super) fn net_by(&self, crossings: &Crossings<S>) -> Option<[Figure<S>; 2]> {
        match crossings {
            Crossings::Linear(found) => {
                let resistance = |of: &Loop<S>| Resistance::new(&of.friction(), self.dtau);
                let least = resistance(&self.ends.least);
                let most = match self.ends.friction_is_exact() {
                    true => least.clone(),
                    false => resistance(&self.ends.most),
                };
                self.joined(found.iter().map(|of| net_of(of, &least, &most)))
            }
            Crossings::Flat(found) => {
                let frictions = self.frictions();
                let mut both = None;
                for of in found {
                    let curve = [S::zero(), of.excess.clone(), S::zero()];
                    join(&mut both, net_along(&frictions, &curve, displacements(of))?);
                }
                self.figures([both.clone(), both])
            }
        }
    }
}

/// How far it goes between counts, at the least and at the most.
fn displacements<S: Ordered>(Crossing { ticks, .. }: &Crossing<S>) -> [S; 2] {
    [ticks.clone() - S::one(), ticks.clone() + S::one()]
}

/// Both accounts of net energy between two counts, at their extremes. The closed form is long: there is one of it for each
/// kind of number.
#[inline(never)]
fn net_of<S: Ordered>(
    crossing: &Crossing<S>,
    least: &Resistance<S>,
    most: &Resistance<S>,
) -> [Accounts<S>; 2] {
    let ([a, b], [c, d]) = (crossing.net_at_least(least), crossing.net_at_most(most));
    [[a, c], [b, d]]
}
