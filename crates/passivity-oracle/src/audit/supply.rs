//! What the operator has put in at the least: net energy and the wall's potential, at their lowest.

use passivity_core::{BigRational, Scalar, rational};

use super::account::{Account, Lowest};
use super::chunk::Samples;
use super::course::near;
use crate::ledger::{Ledger, Sample};
use crate::number::Written as _;

/// The least potential of the wall at a sample.
pub(super) fn potential(ledger: &Ledger, samples: &Samples, i: usize) -> Option<BigRational> {
    let [least, _] = potential_range(ledger, &samples.get(i)?);
    Some(least)
}

/// The least and the largest potential of the wall at a sample, in KΔ².
pub(crate) fn potential_range(ledger: &Ledger, sample: &Sample) -> [BigRational; 2] {
    let law = ledger.model().law();
    let ends = match sample {
        Sample::Exact(xi) => [xi.to_rational(), xi.to_rational()],
        Sample::Count(n) => {
            let n = BigRational::from_integer((*n).into());
            [n.clone(), n + BigRational::one()]
        }
        Sample::Within(ends) => [ends.0.clone(), ends.1.clone()],
    };
    // The potential is convex with its least value at 0, which no cell has inside it.
    let [a, b] = ends.map(|xi| law.potential(&xi));
    if a < b { [a, b] } else { [b, a] }
}

/// The least of net energy plus potential, compared in doubles first.
#[derive(Default)]
pub(crate) struct Supply {
    lowest: Option<(f64, Lowest)>,
}

impl Supply {
    pub(crate) fn lower(&mut self, account: &Account, potential: &Option<BigRational>) {
        let Some(potential) = potential else { return };
        let now = account.net.near() + near(potential);
        let slack = 1e-6 * (1.0 + now.abs() + account.net.near().abs());
        if self
            .lowest
            .as_ref()
            .is_some_and(|(lowest, _)| now > lowest + slack)
        {
            return;
        }
        let value = account.net.total() + potential;
        if self
            .lowest
            .as_ref()
            .is_none_or(|(_, lowest)| value < lowest.value)
        {
            let h = account.intervals;
            self.lowest = Some((near(&value), Lowest { value, h }));
        }
    }

    /// Twice the lowest value over a denominator, rounded up; and where.
    pub(super) fn twice_lowest(&self, denominator: i128) -> (i128, u64) {
        use num_traits::ToPrimitive as _;
        let twice = self.lowest.as_ref().and_then(|(_, lowest)| {
            let scale = BigRational::from_integer((2 * denominator).into());
            let twice = (&lowest.value * scale).ceil().to_integer().to_i128()?;
            Some((twice, lowest.h))
        });
        twice.unwrap_or((i128::MAX, 0))
    }

    pub(super) fn keep_twice(&mut self, (twice, h): (i128, u64), denominator: i128) {
        if twice == i128::MAX {
            return;
        }
        let value = BigRational::new(twice.into(), (2 * denominator).into());
        if self
            .lowest
            .as_ref()
            .is_none_or(|(_, lowest)| value < lowest.value)
        {
            self.lowest = Some((near(&value), Lowest { value, h }));
        }
    }

    pub(crate) fn settle(self, account: &mut Account) {
        if let Some((_, lowest)) = self.lowest {
            account.lower_supply(lowest.value, lowest.h);
        }
    }
}

/// −F·Δξ over an interval: what the observer adds. Of counts, Δξ is the difference in ticks.
pub(crate) fn observed(
    ledger: &Ledger,
    back: &[Sample],
    end: &Sample,
) -> Result<(i128, i128), BigRational> {
    let on_machine_integers = || {
        let cells: Option<Vec<_>> = back.iter().map(Sample::to_fixed).collect();
        let held = ledger.fixed()?.held_force(&cells?);
        let seen = |sample: &Sample| {
            let cell = sample.to_fixed()?;
            Some(match sample {
                Sample::Count(_) => cell.tick,
                _ => cell.tick + *cell.residue.lo(),
            })
        };
        let step = seen(end)? - seen(back.first()?)?;
        (-(held * step)).to_reduced()
    };
    if let Some(work) = on_machine_integers() {
        return Ok(work);
    }
    let cells: Vec<_> = back.iter().map(Sample::to_wide).collect();
    let held = ledger.wide().held_force(&cells);
    let seen = |sample: &Sample| {
        let cell = sample.to_wide();
        match sample {
            Sample::Count(_) => cell.tick,
            _ => cell.tick + cell.residue.lo().clone(),
        }
    };
    let start = back.first().map_or_else(Scalar::zero, seen);
    let work = -(held * (seen(end) - start));
    Err(rational::from_wide(&work).unwrap_or_else(|| BigRational::integer(0)))
}
