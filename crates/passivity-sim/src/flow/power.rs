//! The power series of a motion on a short piece, and where it stops.

use std::cmp::Ordering;

use super::Flow;
use super::table::{Start, Table};
use crate::number::{Real, Undecided};

/// The coefficients of the way in the fraction s of a piece, over its length.
pub(super) struct Series<R>(pub(super) Vec<R>);

/// How many terms leave less than 2^−bits when each is at most the one before, halved so often, over n.
pub(super) fn terms(bits: u32, halvings: u32) -> i32 {
    let mut n = 3_u32;
    let mut gained = 0;
    while gained < bits + 4 {
        gained += halvings + n.ilog2();
        n += 1;
    }
    i32::try_from(n + 1).unwrap_or(i32::MAX)
}

/// The index of a term as a factor; a series has some hundred terms.
fn factor(n: usize) -> i32 {
    i32::try_from(n).unwrap_or(i32::MAX)
}

impl<R: Real> Flow<R> {
    /// At which fraction of a piece the velocity, of sign `direction` at first, becomes 0.
    pub(super) fn stop(
        &self,
        table: &Table<R>,
        start: &Start<R>,
        direction: Ordering,
    ) -> Result<Option<R>, Undecided> {
        let one = table.length.whole(1);
        let end = table.end(start);
        let sign = end.velocity.sign().ok_or(Undecided)?;
        if sign == direction.reverse() {
            let series = table.series(start);
            return series.crossing(1, direction, &one).map(Some);
        }
        // It may have been to 0 and back: only if it slowed down first and sped up later.
        let slows = self.accelerates(start, &start.velocity, &start.excess, &R::zero())?;
        if slows != direction.reverse()
            || self.accelerates(start, &end.velocity, &end.excess, &end.way)? != direction
        {
            return Ok(None);
        }
        let series = table.series(start);
        let slowest = series.crossing(2, direction.reverse(), &one)?;
        if series.derivative(&slowest, 1).sign().ok_or(Undecided)? == direction {
            return Ok(None);
        }
        series.crossing(1, direction, &slowest).map(Some)
    }

    /// The sign of the acceleration at a speed, an excess of the output and a way from the start.
    fn accelerates(
        &self,
        start: &Start<R>,
        velocity: &R,
        excess: &R,
        way: &R,
    ) -> Result<Ordering, Undecided> {
        let mut net = excess.clone() + start.pull.clone() - self.beta.clone() * velocity.clone();
        if let Some([damping, stiffness]) = &self.arm {
            net = net - damping.clone() * velocity.clone() - stiffness.clone() * way.clone();
        }
        net.sign().ok_or(Undecided)
    }
}

/// A derivative at s of the polynomial with these coefficients.
pub(super) fn derivative<R: Real>(coefficients: &[R], s: &R, order: usize) -> R {
    let mut sum = R::zero();
    for (n, c) in coefficients.iter().enumerate().skip(order).rev() {
        // n(n − 1)…, a factor for each order.
        let falling = (0..order).map(|i| factor(n - i)).product();
        sum = sum * s.clone() + c.clone() * R::integer(falling);
    }
    sum
}

impl<R: Real> Series<R> {
    fn derivative(&self, s: &R, order: usize) -> R {
        derivative(&self.0, s, order)
    }

    /// Where a derivative of sign `before` at 0 ceases to have it, between 0 and `top`: Newton's
    /// iteration, with bisection whenever it leaves the bracket or shrinks it too little.
    fn crossing(&self, order: usize, before: Ordering, top: &R) -> Result<R, Undecided> {
        let (mut low, mut high) = (R::zero(), top.one_of());
        let mut at = (low.clone() + high.clone()).half().one_of();
        for _ in 0..2 * high.bits() {
            let value = self.derivative(&at, order);
            match value.sign() {
                Some(Ordering::Equal) => return Ok(at),
                Some(sign) if sign == before => low = at.clone(),
                Some(_) => high = at.clone(),
                // As near as an interval of this precision can tell.
                None if R::ENCLOSES && value.is_defined() => break,
                None => return Err(Undecided),
            }
            let width = high.clone() - low.clone();
            if width.approximate() <= at.approximate() * (-f64::from(at.bits())).exp2() {
                break;
            }
            let slope = self.derivative(&at, order + 1);
            let mut next = (low.clone() + high.clone()).half();
            if slope.sign().is_some_and(Ordering::is_ne) {
                let newton = (at.clone() - value.over(slope)).one_of();
                let step = (newton.clone() - at.clone()).approximate().abs();
                let inside = newton.compare(&low).ok_or(Undecided)?.is_gt()
                    && newton.compare(&high).ok_or(Undecided)?.is_lt();
                if inside {
                    if step <= at.approximate() * (-f64::from(at.bits())).exp2() {
                        at = newton;
                        break;
                    }
                    next = newton;
                }
            }
            at = next.one_of();
        }
        if R::ENCLOSES {
            return self.around(order, before, &at, top);
        }
        Ok(at)
    }

    /// An interval about `at` at whose lower end a derivative has the sign `before`, and at whose
    /// upper end the other, as it has at `top`.
    fn around(&self, order: usize, before: Ordering, at: &R, top: &R) -> Result<R, Undecided> {
        let sign = |s: &R| self.derivative(s, order).sign();
        let mut off = at.clone();
        for _ in 4..at.bits() {
            off = off.half();
        }
        for _ in 4..at.bits() {
            let below = (at.clone() - off.clone()).one_of();
            let above = (at.clone() + off.clone()).one_of();
            let is_within = above.compare(top).is_some_and(Ordering::is_lt);
            let above = if is_within { above } else { top.clone() };
            if sign(&below) == Some(before)
                && (!is_within || sign(&above) == Some(before.reverse()))
            {
                return Ok(below.join(above));
            }
            off = off.double();
        }
        Err(Undecided)
    }
}
