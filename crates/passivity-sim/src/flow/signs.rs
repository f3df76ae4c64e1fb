//! Where the velocity keeps its sign, as far as signs and slopes at nodes of the table tell.

use super::fast::{Attempt, Fast};
use super::short::{Inner, dot};

impl Fast {
    /// Whether the velocity has the sign of `direction` from the start to the end of an interval, or
    /// is 0 there.
    ///
    /// With v̇ = 0 at most once, v comes to 0 between ends of one sign only where it slows down at first
    /// and speeds up at the end; and if v̈ is positive at both ends, v is above both tangents there,
    /// which meet at (v₀v̇₁ + v̇₀(v̇₁ − v₁))/(v̇₁ − v̇₀).
    #[inline(always)]
    pub(super) fn keeps(&self, attempt: &Attempt, direction: f64) -> bool {
        let sign = 1.0_f64.copysign(direction);
        let velocity = attempt.velocity;
        let at_end = velocity * sign >= 0.0; // Not for what is no number.
        if !at_end {
            return false;
        }
        let [first, last] = attempt.slopes.map(|slope| slope * sign);
        if self.single && (first >= 0.0 || last <= 0.0) {
            return true;
        }
        self.stays_above(*attempt, sign)
    }

    /// The same for a velocity that may have been less in between.
    #[inline(never)]
    fn stays_above(&self, attempt: Attempt, sign: f64) -> bool {
        let Attempt {
            inner,
            velocity,
            slopes,
            ..
        } = &attempt;
        let ([v, _, e], velocity) = (*inner, *velocity);
        let excess = self.whole.excess * e;
        if self.most_sag(inner) < (v * sign).min(velocity * sign) {
            return true;
        }
        let r = &self.rates;
        let [first, last] = slopes.map(|slope| slope * r.inverse_mass);
        let bends = |v: f64, e: f64, slope: f64| {
            (r.rate * e - r.stiffness * v - r.damping * slope) * sign > 0.0
        };
        self.single
            && bends(v, e, first)
            && bends(velocity, excess, last)
            && v * last + first * (last - velocity) > 0.0
    }

    /// How far v can be below the lesser of its ends within an interval: between points at a distance
    /// t it is at most ⅛t²·|v̈| below the line from one to the other.
    fn most_sag(&self, inner: &Inner) -> f64 {
        dot(&self.sag, &inner.map(f64::abs))
    }

    /// The cell of the table in which the velocity first comes to 0, or that it does not; `None` when
    /// that is not decided.
    #[inline(never)]
    pub(super) fn crossed(&self, inner: Inner, cells: usize) -> Option<Option<usize>> {
        let [v, ..] = inner;
        let sign = 1.0_f64.copysign(v);
        let velocity = |cell: usize| dot(&self.table.map(cell).velocity, &inner) * sign;
        let at = self.first_doubt(&inner, sign, 0, cells);
        if at == cells {
            return Some(None);
        }
        (velocity(at + 1) < 0.0).then_some(Some(at))
    }

    /// The first cell from `at` on, where the velocity has this sign, in which it may come to 0;
    /// `cells` when there is none before it.
    #[inline(never)]
    fn first_doubt(&self, inner: &Inner, sign: f64, mut at: usize, cells: usize) -> usize {
        let velocity = |cell: usize| dot(&self.table.map(cell).velocity, inner) * sign;
        let sag = self.most_sag(inner);
        let mut before = velocity(at);
        let mut step = cells - at;
        while at < cells {
            let part = step as f64 * self.table.cell;
            let next = velocity(at + step);
            if before.min(next) > sag * part * part {
                (at, before) = (at + step, next);
                // The longest step that begins here, in halves of halves.
                step = (1 << at.trailing_zeros()).min(cells - at);
            } else if step > 1 {
                step /= 2;
            } else {
                return at;
            }
        }
        cells
    }

    /// Whether a motion from rest may come to 0 again: from `inner` it goes to `then` within a cell, and
    /// from there in so many cells to a velocity at the end of the interval.
    #[inline(always)]
    pub(super) fn stops_again(
        &self,
        inner: &Inner,
        then: &Inner,
        direction: f64,
        cells: usize,
        velocity: f64,
    ) -> bool {
        let sign = 1.0_f64.copysign(direction);
        if self.single {
            return velocity * sign < 0.0 || velocity.is_nan();
        }
        let width = self.table.cell;
        // v ≥ v̇₀t − ½t²·|v̈|, with |v̈| ≤ 8·sag, in the first part of a cell.
        let [_, p, _] = *inner;
        let first = p * sign * self.rates.inverse_mass > 4.0 * self.most_sag(inner) * width;
        !first || self.first_doubt(then, sign, 0, cells) < cells
    }
}
