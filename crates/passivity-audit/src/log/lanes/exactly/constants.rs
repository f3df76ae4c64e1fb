//! The numbers of a scene and of a log that all rows are made with.

use num_bigint::BigInt;
use num_traits::{Signed as _, ToPrimitive as _};
use passivity_core::{BigRational, Loop, Scalar as _};

use crate::log::numbers::{Readings, Unit};
use crate::log::task::Task;
use crate::number::{Ample, Written as _};

/// What does not depend on where the device is.
pub(super) struct Constants {
    /// KΔ per unit of a force, where the account is of that in the log.
    pub(super) force: Option<BigRational>,
    /// What lengths of intervals are over.
    pub(super) lasts: BigRational,
    /// The least and the largest force of the wall.
    pub(super) limits: [Option<BigRational>; 2],
    /// Viscous and Coulomb friction, and what is left of them in the criterion, at the least and at the most.
    pub(super) frictions: [[BigRational; 2]; 2],
    pub(super) criteria: [[BigRational; 2]; 2],
    pub(super) friction_is_exact: bool,
}

impl Constants {
    pub(super) fn of(
        task: &Task<'_>,
        (forces, unit): (Option<&Readings>, Option<Unit>),
        lasts: i64,
    ) -> Option<Self> {
        let ends = task.ledger.ample();
        let number = Ample::to_rational;
        let force = match (forces, unit) {
            (Some(forces), Some(unit)) => {
                Some(forces.factor()? / BigRational::from_integer(unit.denominator()?.into()))
            }
            _ => None,
        };
        let law = ends.least.law();
        let limit = |of: &Option<Ample>| match of {
            Some(x) => x.to_rational().map(Some),
            None => Some(None),
        };
        let [least, most] = [&ends.least, &ends.most].map(|of: &Loop<Ample>| {
            Some([
                number(&of.viscous_friction())?,
                number(&of.coulomb_friction())?,
            ])
        });
        let criteria = ends.criteria.each_ref();
        let [at_least, at_most] =
            criteria.map(|of| Some([number(&of.viscous)?, number(&of.coulomb)?]));
        Some(Self {
            force,
            lasts: BigRational::from_integer(Some(lasts).filter(|n| *n > 0)?.into()),
            limits: [limit(&law.lower)?, limit(&law.upper)?],
            frictions: [least?, most?],
            criteria: [at_least?, at_most?],
            friction_is_exact: ends.friction_is_exact(),
        })
    }

    /// What the denominators of rows are made of.
    pub(super) fn denominators(&self) -> Vec<BigInt> {
        let constants = self.frictions.iter().chain(&self.criteria).flatten();
        let limits = self.limits.iter().flatten();
        let all = constants.chain(limits).chain(&self.force);
        let all = all.map(|x| x.denom().clone());
        all.chain([self.lasts.to_integer()]).collect()
    }
}

/// A part of a wall on which all figures are sums of the same products.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// Between these positions, as numerators, and these ticks.
    positions: [i64; 2],
    ticks: [i64; 2],
}

impl Part {
    /// Whether motions between positions stay on it, of which the whole numbers below and above are given, and the tick.
    pub(super) fn has(&self, ends: [([i64; 2], i64); 2]) -> bool {
        let ([from, to], [first, last]) = (self.positions, self.ticks);
        let mut ends = ends.into_iter();
        ends.all(|([below, above], tick)| {
            from <= below && above <= to && (first..=last).contains(&tick)
        })
    }
}

/// A whole number of 64 bits next to a fraction, or the last one there is.
fn clamped(x: &BigRational) -> i64 {
    let n = x.to_integer();
    n.to_i64()
        .unwrap_or(if n.is_negative() { i64::MIN } else { i64::MAX })
}

/// Where a wall of these limits is linear, and where its force is the least and the largest: both the force and the quantized
/// one, which is that of the middle of a tick. Positions are over q.
pub(super) fn parts(limits: &[Option<BigRational>; 2], q: &BigInt) -> [Option<Part>; 3] {
    let q = BigRational::from_integer(q.clone());
    let half = BigRational::one().half();
    let from = |limit: &BigRational| [&(limit * &q).ceil(), &(limit - &half).ceil()].map(clamped);
    let up_to =
        |limit: &BigRational| [&(limit * &q).floor(), &(limit - &half).floor()].map(clamped);
    let part = |[a, b]: [i64; 2], [c, d]: [i64; 2]| Part {
        positions: [a, c],
        ticks: [b, d],
    };
    let (all_from, all_to) = ([i64::MIN; 2], [i64::MAX; 2]);
    let [lower, upper] = limits;
    let linear = part(
        lower.as_ref().map_or(all_from, from),
        upper.as_ref().map_or(all_to, up_to),
    );
    [
        Some(linear),
        lower.as_ref().map(|limit| part(all_from, up_to(limit))),
        upper.as_ref().map(|limit| part(from(limit), all_to)),
    ]
}
