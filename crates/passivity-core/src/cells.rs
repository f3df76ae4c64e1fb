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
//! costs is at no angle further than |φ″|(Δu)²/8 of B from the chord of what both cost there. What the filter costs of
//! Coulomb friction, B/(1 + u), and without a delay of viscous friction, B/(1 + 2u), is less in between than the chord. With
//! u as it is, the margin is a concave function of K, of T and of B each, as without a filter. So a stretch of u holds where
//! its corners in K, T, B and u do with that much to spare; and it fails where they do by as much at one angle, at which all
//! but what the encoder costs is linear in K, T and B.

use alloc::vec::Vec;

use num_rational::BigRational;

use crate::decision::{Enclosed, SHAPING};
use crate::fraction::Wide;
use crate::interval::{Interval, Truth};
use crate::linear_part::{Command, LinearPart, bend};
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
    let whole = bounds.try_map(|_, range| short(range))?;
    let is_squared = matches!(speeds, Speeds::UpToSquared(_));
    if let (Some(tau), false) = (&whole.damping_time_constant, is_squared) {
        if whole.linear_part(CELL_BITS)?.frequency_response().is_some() {
            return whole.over_stretches(tau, &speeds, wanted);
        }
    }
    let mut cells = alloc::vec![whole];
    let mut seen = 1;
    while let Some(cell) = cells.pop() {
        let surely = match is_squared {
            true => cell.with_costs(CELL_BITS)?.decide(&speeds)? == wanted,
            false => cell.is_surely(wanted, &speeds, &BigRational::zero())?,
        };
        if surely {
            continue;
        }
        seen += 2;
        let halves = cell.halves()?;
        if seen > MOST_CELLS || halves.is_empty() {
            return Some(Truth::Depends);
        }
        cells.extend(halves);
    }
    Some(wanted)
}

impl Loop<Interval<Wide>> {
    /// The same for filtered damping in a linear loop: cut along u, and along T where the encoder's BΔ/(T + τ) asks for it.
    fn over_stretches(
        &self,
        tau: &Interval<Wide>,
        speeds: &Speeds<Interval<Wide>>,
        wanted: Truth,
    ) -> Option<Truth> {
        let quotient = |above: &Wide, below: &Wide| above.clone().over(below.clone());
        let whole = &self.period;
        let u = Interval::hull(
            quotient(tau.lo(), whole.hi()),
            quotient(tau.hi(), whole.lo()),
        );
        let mut stretches = alloc::vec![(u, whole.clone())];
        let mut seen = 1;
        while let Some((u, periods)) = stretches.pop() {
            // The periods that have such a filter, u·T, within its tolerance.
            let (mut shortest, mut longest) = (periods.lo().clone(), periods.hi().clone());
            if u.hi().is_positive()? {
                shortest = shortest.max(quotient(tau.lo(), u.hi()));
            }
            if u.lo().is_positive()? {
                longest = longest.min(quotient(tau.hi(), u.lo()));
            }
            if shortest.compare(&longest)?.is_gt() {
                continue;
            }
            let periods = short(&Interval::hull(shortest, longest))?;
            let stretch = self.clone().with(Parameter::Period, periods.clone());
            let ends = [u.lo().clone(), u.hi().clone()];
            let surely = match wanted {
                Truth::Holds => stretch.holds_behind_filter(&ends, tau, speeds)?,
                _ => stretch.fails_behind_filter(&ends, speeds)?,
            };
            if surely == Truth::Holds {
                continue;
            }
            seen += 2;
            let share = |x: &Interval<Wide>| quotient(x.lo(), x.hi());
            let along_period = wanted == Truth::Fails
                && self.has_encoder()
                && share(&periods).compare(&share(&u))?.is_lt();
            let cut = if along_period { &periods } else { &u };
            if surely == Truth::Fails || seen > MOST_CELLS || !is_wide(cut) {
                return Some(Truth::Depends);
            }
            let middle = short(&Interval::point(cut.middle()))?.lo().clone();
            let halves = [
                Interval::hull(cut.lo().clone(), middle.clone()),
                Interval::hull(middle, cut.hi().clone()),
            ];
            stretches.extend(halves.map(|half| match along_period {
                true => (u.clone(), half),
                false => (half, periods.clone()),
            }));
        }
        Some(wanted)
    }

    /// The loops at both ends of K, T and B, where they have a tolerance, and of u.
    fn corners_behind_filter(&self, ends: &[Wide; 2]) -> Vec<Self> {
        let split = [Parameter::Stiffness, Parameter::Period, Parameter::Damping];
        let split = split
            .into_iter()
            .filter(|p| self.get(*p).is_some_and(is_wide));
        let corners = self.at_both_ends(split).into_iter();
        let corners = corners.flat_map(|corner| {
            ends.each_ref().map(|u| {
                let tau = corner.period.map(|period| u.clone() * period.clone());
                corner.clone().with(Parameter::DampingTimeConstant, tau)
            })
        });
        corners.collect()
    }

    /// Whether the criterion holds for all loops of a stretch of u; that it fails where it does for one that is within the
    /// tolerance of the filter, which no further cut mends.
    fn holds_behind_filter(
        &self,
        ends: &[Wide; 2],
        tau: &Interval<Wide>,
        speeds: &Speeds<Interval<Wide>>,
    ) -> Option<Truth> {
        // Without a delay a closed form says the cost.
        let bend = match self.delay {
            0 => BigRational::zero(),
            _ => self.bend(ends)?,
        };
        for corner in self.corners_behind_filter(ends) {
            if corner.is_surely(Truth::Holds, speeds, &bend)? {
                continue;
            }
            let at = corner.damping_time_constant.as_ref()?;
            let is_inside =
                at.lo().compare(tau.lo())?.is_ge() && at.hi().compare(tau.hi())?.is_le();
            let unbent = BigRational::zero();
            let mends =
                !is_inside || (bend > unbent && corner.is_surely(Truth::Holds, speeds, &unbent)?);
            return Some(if mends { Truth::Depends } else { Truth::Fails });
        }
        Some(Truth::Holds)
    }

    /// Whether the criterion fails for all loops of a stretch of u: by all of them at one angle, at which it is a linear
    /// function of K, of T and of B but for BΔ/(T + τ), and bends with u.
    fn fails_behind_filter(
        &self,
        ends: &[Wide; 2],
        speeds: &Speeds<Interval<Wide>>,
    ) -> Option<Truth> {
        let [_, slowest] = ends;
        let speeds = speeds.at(End::Easiest);
        // Damping costs the least of Coulomb friction at the longest period, behind the slowest filter.
        let longest = self.period.hi();
        let coulomb = |corner: &Loop<Wide>| {
            let slowest = slowest.clone() * longest.clone();
            let sparing = corner.clone().with(Parameter::Period, longest.clone());
            let sparing = sparing.with(Parameter::DampingTimeConstant, slowest);
            sparing.criterion().coulomb
        };
        if coulomb(&self.at(End::Easiest)).is_nonnegative() == Some(false) {
            return Some(Truth::Holds);
        }
        let cost = self.linear_part_between(ends)?.frequency_response()?;
        let near = BigRational::new(1.into(), (1 << 20).into());
        let x = cost.peak(&near);
        let bend = self.bend(ends)?;
        for corner in self.corners_behind_filter(ends) {
            let easiest = corner.at(End::Easiest);
            let friction = match &speeds {
                Speeds::UpTo(v) => easiest.viscous_friction() + coulomb(&easiest).over(v.clone()),
                _ => easiest.viscous_friction(),
            };
            let beta = friction.over(easiest.viscous_unit());
            let point = easiest.map(|_, x| Interval::point(x.clone()));
            let asked = point.linear_part(CELL_BITS)?.frequency_response()?.at(&x) - &bend;
            if asked <= *beta.enclosed(CELL_BITS)?.hi() {
                return Some(Truth::Depends);
            }
        }
        Some(Truth::Holds)
    }

    /// The linear part in the middle of a stretch of u.
    fn linear_part_between(&self, ends: &[Wide; 2]) -> Option<LinearPart> {
        let [from, to] = ends;
        let middle = self.map(|_, range| range.middle());
        let tau = (from.clone() + to.clone()).half() * middle.period.clone();
        let point = middle.with(Parameter::DampingTimeConstant, tau);
        point
            .map(|_, x| Interval::point(x.clone()))
            .linear_part(CELL_BITS)
    }

    /// How far the cost between two values of u is at most from the chord, in KT: |φ″|(Δu)²/8 of B.
    fn bend(&self, [from, to]: &[Wide; 2]) -> Option<BigRational> {
        let part = self.linear_part(CELL_BITS)?;
        let Command::Spring { damping, .. } = &part.command else {
            return None;
        };
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

    /// The box cut in two along its shaping parameter with the largest relative width; none for a point.
    fn halves(&self) -> Option<Vec<Self>> {
        let mut widest: Option<(Parameter, Wide)> = None;
        for parameter in SHAPING {
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
