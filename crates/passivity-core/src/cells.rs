//! Boxes of loops of which the corners do not tell: cut into cells, over each of which costs are enclosed.
//!
//! Of damping behind a filter the numbers u = τ/T and B tell what it costs, with w = 1 − e^(−iθ): at each angle
//! Re[e^(−ikθ)w²φ]/|w|² of B, where φ = 1/(1 + uw) (TH-LTI). Its second derivative by u is at most
//!
//! ```text
//! |φ″| = 2y/(1 + u(1 + u)y)^(3/2),    y = |w|² from 0 to 4
//! ```
//!
//! which is largest where u(1 + u)y = 2, 4/(3√3·u(1 + u)), and never above 2y ≤ 8. So what a loop between two values of u
//! costs is at no angle more than |φ″|(Δu)²/8 of B above what the harder one of both costs there. What the filter costs of
//! Coulomb friction, B/(1 + u), and without a delay of viscous friction, B/(1 + 2u), is less in between than the chord. With
//! u as it is, the margin is a concave function of K, of T and of B each, as without a filter. So a cell holds where its
//! corners in K, T, B and u do with that much to spare.

use alloc::vec::Vec;

use num_rational::BigRational;

use crate::decision::{Enclosed, SHAPING};
use crate::fraction::Wide;
use crate::interval::{Interval, Truth};
use crate::linear_part::{Command, bend};
use crate::parameter::{Loop, Parameter};
use crate::rational::{self, SHORT, to_wide};
use crate::scalar::{Ordered as _, Scalar};
use crate::verdict::{End, Speeds};

/// Bits of the costs over a cell.
const CELL_BITS: u32 = 40;

/// How many cells a box is cut into at most.
const MOST_CELLS: usize = 64;

/// An interval of short numbers around one.
fn short<S: Enclosed>(range: &Interval<S>) -> Option<Interval<Wide>> {
    let [lo, hi] = [range.lo(), range.hi()].map(|end| end.enclosed(SHORT));
    Some(lo?.joined(&hi?).shortened(SHORT).map(to_wide))
}

/// Whether a range is one of its own, not just a number that was rounded.
fn is_wide(range: &Interval<Wide>) -> bool {
    let width = range.hi().clone() - range.lo().clone();
    let much = width * rational::to_wide(&BigRational::from_integer((1 << 20).into()));
    much.compare(range.hi())
        .is_some_and(core::cmp::Ordering::is_gt)
}

/// `wanted` where it is so over every cell that a box is cut into, else that it depends.
pub(crate) fn over_cells<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    speeds: &Speeds<Interval<S>>,
    wanted: Truth,
) -> Option<Truth> {
    let speeds = speeds.try_map(short)?;
    let mut cells = alloc::vec![bounds.try_map(|_, range| short(range))?];
    let is_squared = matches!(speeds, Speeds::UpToSquared(_));
    let filtered = bounds.damping_time_constant.is_some() && !bounds.has_actuator();
    // Behind a filter only what u is made of is cut: the corners tell of the rest.
    let behind_filter = wanted == Truth::Holds && filtered && bounds.is_linear() && !is_squared;
    let cut: &[Parameter] = match behind_filter {
        true => &[Parameter::DampingTimeConstant, Parameter::Period],
        false => &SHAPING,
    };
    let mut seen = 1;
    while let Some(cell) = cells.pop() {
        let surely = match (behind_filter, is_squared) {
            (true, _) => cell.holds_behind_filter(&speeds)?,
            (_, true) => cell.with_costs(CELL_BITS)?.decide(&speeds)? == wanted,
            _ => cell.is_surely(wanted, &speeds, &BigRational::zero())?,
        };
        if surely {
            continue;
        }
        seen += 2;
        let halves = cell.halves(cut)?;
        if seen > MOST_CELLS || halves.is_empty() {
            return Some(Truth::Depends);
        }
        cells.extend(halves);
    }
    Some(wanted)
}

impl Loop<Interval<Wide>> {
    /// Whether the criterion holds for all loops of a cell with filtered damping.
    fn holds_behind_filter(&self, speeds: &Speeds<Interval<Wide>>) -> Option<bool> {
        let tau = self.damping_time_constant.as_ref()?;
        let period = &self.period;
        let ends = [
            tau.lo().clone().over(period.hi().clone()),
            tau.hi().clone().over(period.lo().clone()),
        ];
        let bend = self.bend(&ends)?;
        let split = [Parameter::Stiffness, Parameter::Period, Parameter::Damping];
        let split = split
            .into_iter()
            .filter(|p| self.get(*p).is_some_and(is_wide));
        for corner in self.at_both_ends(split) {
            for u in &ends {
                let tau = corner.period.map(|period| u.clone() * period.clone());
                let corner = corner.clone().with(Parameter::DampingTimeConstant, tau);
                if !corner.is_surely(Truth::Holds, speeds, &bend)? {
                    return Some(false);
                }
            }
        }
        Some(true)
    }

    /// How far the cost between two values of u is at most above what the harder one costs, in KT: |φ″|(Δu)²/8 of B, and
    /// nothing where a closed form says the cost.
    fn bend(&self, [from, to]: &[Wide; 2]) -> Option<BigRational> {
        let part = self.linear_part(CELL_BITS)?;
        let Command::Spring { damping, .. } = &part.command else {
            return None;
        };
        if part.delay == 0 {
            return Some(BigRational::zero());
        }
        let ends = [rational::from_wide(from)?, rational::from_wide(to)?];
        Some(bend(damping.hi(), &ends))
    }

    /// Whether the criterion holds, or fails, for all loops of a cell, by what its costs are at most, or
    /// at least, with so much of β to spare.
    fn is_surely(
        &self,
        wanted: Truth,
        speeds: &Speeds<Interval<Wide>>,
        spare: &BigRational,
    ) -> Option<bool> {
        let (end, period) = match wanted {
            Truth::Holds => (End::Hardest, self.period.lo()),
            _ => (End::Easiest, self.period.hi()),
        };
        let width = BigRational::new(1.into(), num_bigint::BigInt::from(1) << CELL_BITS);
        let part = self.linear_part(CELL_BITS)?;
        let coulomb = part.coulomb_cost(&width)?;
        let cost = match wanted {
            Truth::Holds => coulomb.hi(),
            _ => coulomb.lo(),
        };
        // What Coulomb friction has to spare is least at the shortest period.
        let corner = self.at(end);
        let other = corner.clone().with(Parameter::Period, period.clone());
        let left = corner.left_by(cost, &other, &speeds.at(end))?;
        let Some(beta) = left else {
            return Some(wanted == Truth::Fails);
        };
        let beta = beta.enclosed(CELL_BITS)?.map(|beta| beta - spare);
        let decided = part.decide(&beta, &width);
        Some(decided == Some(wanted == Truth::Holds))
    }

    /// The box cut in two along that one of these parameters with the largest relative width; none for a point.
    fn halves(&self, cut: &[Parameter]) -> Option<Vec<Self>> {
        let mut widest: Option<(Parameter, Wide)> = None;
        for &parameter in cut {
            let Some(range) = self.get(parameter).filter(|range| !range.is_point()) else {
                continue;
            };
            let relative = (range.hi().clone() - range.lo().clone()).over(range.hi().clone());
            let wider = match &widest {
                Some((_, width)) => relative.compare(width)?.is_gt(),
                None => true,
            };
            if wider {
                widest = Some((parameter, relative));
            }
        }
        let Some((parameter, _)) = widest else {
            return Some(Vec::new());
        };
        let range = self.get(parameter)?;
        let middle = short(&Interval::point(
            (range.lo().clone() + range.hi().clone()).half(),
        ))?;
        let halves = [(range.lo(), middle.hi()), (middle.lo(), range.hi())].map(|(lo, hi)| {
            self.clone()
                .with(parameter, Interval::hull(lo.clone(), hi.clone()))
        });
        Some(halves.into())
    }
}
