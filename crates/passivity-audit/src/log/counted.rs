//! What an interval between two counts comes to, in doubles, where a linear wall on both sides is all there is.

use passivity_core::counted::{Crossing, Resistance};
use passivity_core::{Criterion, Ordered as _, Scalar as _, Truth, dissipation, quantizer};

use crate::ball::Ball;
use crate::ends::Ends;
use crate::figure::not;
use crate::ledger::{Ledger, Logged, Truths};
use crate::log::motion::{Addend, between};
use crate::log::supply::Contribution;
use crate::number::Reduced;
use crate::reading::Reading;

/// What an interval between two counts comes to under any force.
pub(crate) struct Counted {
    /// The force of the wall at the middle of the first tick.
    own: Ball,
    /// The ticks from one count to the other,
    crossed: i64,
    ticks: Ball,
    /// and the count where it ends.
    end: Ball,
    /// With the least friction and with the most.
    frictions: [Resistance<Ball>; 2],
    /// The least that friction takes (26), at the least and at the most.
    taken: [i128; 2],
    /// Whether the criterion holds at the mean speed.
    criterion_holds: Truth,
}

impl Counted {
    /// Of an interval of its own; `None` of others than those between counts.
    pub(crate) fn of_interval(ledger: &Ledger, interval: &Logged) -> Option<Self> {
        match (interval.samples.as_slice(), &interval.end) {
            ([Reading::Count(from)], Reading::Count(to)) => {
                Self::of(ledger, [*from, *to], &Ball::of(&interval.dtau))
            }
            _ => None,
        }
    }

    /// Of an interval from one count to another that lasts so many periods; `None` where doubles leave something
    /// open, and of loops that have more than an encoder.
    pub(crate) fn of(ledger: &Ledger, [from, to]: [i64; 2], lasts: &Ball) -> Option<Self> {
        if !ledger.is_plain() {
            return None;
        }
        let ends = ledger.near();
        let crossed = to.checked_sub(from)?;
        let ticks = Ball::whole(crossed);
        let least = Resistance::new(&ends.least.friction(), lasts);
        let most = match ends.friction_is_exact() {
            true => least.clone(),
            false => Resistance::new(&ends.most.friction(), lasts),
        };
        let [near, far] = Crossing::own(ticks).distances();
        let takes = |of: &Resistance<Ball>, d: &Ball| of.taken(d);
        Some(Self {
            own: quantizer::held_force(&Ball::whole(from)),
            crossed,
            ticks,
            end: Ball::whole(to),
            taken: between(takes(&least, &near), takes(&most, &far))?,
            frictions: [least, most],
            criterion_holds: criterion(ends, [near, far], lasts)?,
        })
    }

    /// What it is under this force, or under that of the wall.
    fn crossing(&self, force: Option<Ball>) -> Crossing<Ball> {
        match force {
            None => Crossing::own(self.ticks),
            Some(force) => Crossing {
                ticks: self.ticks,
                excess: force - self.own,
            },
        }
    }

    /// What the interval adds to an account, under the force that the log has or, without one, under that of the
    /// wall; `None` where doubles leave something open.
    pub(crate) fn addend(&self, force: Option<Ball>) -> Option<Addend> {
        let crossing = self.crossing(force);
        let [linear, quantized] = crossing.generated();
        let [least, most] = &self.frictions;
        let ([a, b], [c, d]) = (crossing.net_at_least(least), crossing.net_at_most(most));
        let grid = |[lo, hi]: [Ball; 2]| between(lo, hi);
        let violates = |[lo, hi]: [Ball; 2]| {
            let covered = Truth::over(lo.is_nonnegative()?, hi.is_nonnegative()?);
            Some(not(covered))
        };
        let work = force.unwrap_or(self.own) * self.ticks;
        let addend = Addend {
            sums: [
                grid(linear)?,
                grid(quantized)?,
                self.taken,
                grid([a, c])?,
                grid([b, d])?,
            ],
            observed: (-work).on_grid()?[0],
            potential: grid(Crossing::own(self.ticks).stored(&self.end))?,
            truths: Truths {
                criterion_holds: self.criterion_holds,
                violates_linear: violates([a, c])?,
                violates_quantized: violates([b, d])?,
            },
        };
        addend.fits().then_some(addend)
    }

    /// What it adds to T under this force.
    pub(crate) fn contribution(&self, force: Option<Ball>) -> Option<Contribution> {
        let [least, most] = &self.frictions;
        let own = Crossing::own(self.ticks);
        let ([lo, _], [hi, _]) = (own.net_at_least(least), own.net_at_most(most));
        let crossing = self.crossing(force);
        let [first, last] = crossing.stored(&self.end);
        Some(Contribution::counted(
            between(lo, hi)?,
            crossing.excess.on_grid()?,
            Reduced::Small(self.crossed.into(), 1),
            between(first, last)?,
        ))
    }
}

/// Whether the criterion holds at the speeds between those of two distances.
fn criterion(ends: &Ends<Ball>, distances: [Ball; 2], lasts: &Ball) -> Option<Truth> {
    let speeds = distances.map(|d| dissipation::mean_speed(&d, lasts));
    let margins = |of: &Criterion<Ball>| speeds.map(|v| of.margin(&v));
    let [least, most] = &ends.criteria;
    let ([a, b], [c, d]) = (margins(least), margins(most));
    let holds = Truth::over(a.min(b).is_nonnegative()?, c.max(d).is_nonnegative()?);
    let [near, _] = distances;
    // Had nothing moved, it would hold.
    Some(match holds {
        Truth::Fails if near.is_zero() => Truth::Depends,
        holds => holds,
    })
}
