//! The figures of a box of loops: the least and the largest value of each over the tolerances.

use passivity_core::verdict::End;
use passivity_core::{
    Criterion, Effect, Enclosed, Interval, Loop, Parameter, Region, Truth, region,
};

use super::BITS;

/// The effects with which conditions of others, made for a wall that acts at once and has no damping but a plain one, do
/// not apply.
pub(super) const NOT_COMPARED: [Effect; 5] = [
    Effect::Delay,
    Effect::Latency,
    Effect::DampingFilter,
    Effect::Controller,
    Effect::Amplifier,
];

/// A box of loops whose figures are asked for.
///
/// Beside a tolerance of K, figures of damping with a computed cost are taken over walls that each have their own cost: as
/// multiples of KT it falls with K, so that of the whole box the stiffest wall would pay what only the softest does. KT·λ is
/// the largest of functions that are linear in K, and what an encoder costs is linear in K. So the wall that has the least to
/// spare, at a speed or in units of the wall, is at an end of the tolerance. Where KT·λ is such a function itself, as it is
/// without a delay, so is the wall that has the most.
pub(super) struct Figures<'a, S> {
    pub(super) bounds: &'a Loop<Interval<S>>,
    /// The box at both ends of the stiffness: one of its loops has the least to spare.
    ends: Vec<Loop<Interval<S>>>,
    /// The same, or the whole box in pieces where one in between may have more to spare.
    pieces: Vec<Loop<Interval<S>>>,
}

/// Which value of a figure is the worst for the wall.
#[derive(Clone, Copy, PartialEq)]
enum Worst {
    /// The least.
    Least,
    /// The largest.
    Most,
}

/// The box with the stiffness at its ends, and in stretches of it where the ends do not say all; each with its own costs.
fn pieces<S: Enclosed>(bounds: &Loop<Interval<S>>) -> Option<[Vec<Loop<Interval<S>>>; 2]> {
    /// So many pieces leave a sixteenth of what figures were too wide by.
    const PIECES: i32 = 16;
    let stiffness = &bounds.stiffness;
    if !bounds.has_computed_costs() || bounds.damping.is_none() || stiffness.is_point() {
        return None;
    }
    let with = |stiffness| {
        let piece = bounds.clone().with(Parameter::Stiffness, stiffness);
        piece.with_costs(BITS)
    };
    let ends = [stiffness.lo(), stiffness.hi()].map(|end| with(Interval::point(end.clone())));
    let ends = ends.into_iter().collect::<Option<Vec<_>>>()?;
    let is_sum = bounds.delay == 0 || bounds.has_actuator() || !bounds.is_linear();
    if is_sum {
        return Some([ends.clone(), ends]);
    }
    let width = stiffness.hi().clone() - stiffness.lo().clone();
    let at = |i| match i {
        PIECES => stiffness.hi().clone(),
        _ => stiffness.lo().clone() + (width.clone() * S::integer(i)).over(S::integer(PIECES)),
    };
    let all = (0..PIECES).map(|i| with(Interval::hull(at(i), at(i + 1))));
    Some([ends, all.collect::<Option<_>>()?])
}

/// A figure over all of some loops.
fn over<S, F>(
    loops: &[Loop<Interval<S>>],
    figure: impl Fn(&Loop<Interval<S>>) -> F,
    joined: impl Fn(F, F) -> F,
) -> F {
    let all = loops.iter().map(figure).reduce(joined);
    all.unwrap_or_else(|| unreachable!("a box has a piece"))
}

impl<'a, S: Enclosed> Figures<'a, S> {
    pub(super) fn of(bounds: &'a Loop<Interval<S>>) -> Self {
        let whole = || [(); 2].map(|()| vec![bounds.clone()]);
        let [ends, pieces] = pieces(bounds).unwrap_or_else(whole);
        Self {
            bounds,
            ends,
            pieces,
        }
    }

    /// The least and the largest value of a figure over the box, of which the worst is at an end of the stiffness.
    fn range(
        &self,
        worst: Worst,
        figure: impl Fn(&Loop<Interval<S>>) -> Interval<S>,
    ) -> Interval<S> {
        let [ends, all] =
            [&self.ends, &self.pieces].map(|loops| over(loops, &figure, |a, b| a.joined(&b)));
        match worst {
            Worst::Least => Interval::hull(ends.lo().clone(), all.hi().clone()),
            Worst::Most => Interval::hull(all.lo().clone(), ends.hi().clone()),
        }
    }

    /// The region of every loop of the box; `None` where it depends.
    pub(super) fn region(&self) -> Option<Region> {
        over(
            &self.pieces,
            Loop::region,
            |a, b| if a == b { a } else { None },
        )
    }

    /// The fastest that all loops of the box may surely go, where speed has a bound in some.
    pub(super) fn speed_to_set(&self) -> Option<S> {
        let of = |piece: &Loop<Interval<S>>| {
            let [hardest, _] = piece.criteria();
            let is_slow_only = hardest.coulomb.is_positive() == Some(true);
            match hardest.viscous.is_nonnegative() {
                Some(false) if is_slow_only => Some(Some(hardest.coulomb.over(-hardest.viscous))),
                Some(true) if is_slow_only => Some(None),
                _ => None,
            }
        };
        let slower = |a: Option<Option<S>>, b: Option<Option<S>>| match (a?, b?) {
            (Some(a), Some(b)) => Some(Some(a.min(b))),
            (a, b) => Some(a.or(b)),
        };
        over(&self.ends, of, slower)?
    }

    /// A figure that the hardest and the easiest end of the tolerances bound.
    pub(super) fn between(&self, figure: impl Fn(&Loop<S>) -> S) -> Interval<S> {
        let [a, b] = [End::Hardest, End::Easiest].map(|end| figure(&self.bounds.at(end)));
        Interval::hull(a, b)
    }

    /// μ = m/(KT²), when there is an inertia.
    pub(super) fn mu(&self) -> Option<Interval<S>> {
        let inertia = self.bounds.inertia.as_ref()?;
        let unit = |end: End| {
            let corner = self.bounds.at(end);
            corner.viscous_unit() * corner.period.clone()
        };
        Some(Interval::hull(
            inertia.lo().clone().over(unit(End::Hardest)),
            inertia.hi().clone().over(unit(End::Easiest)),
        ))
    }

    /// What the effects ask of β and σ: the cost of the dimensionless loop.
    pub(super) fn cost(&self) -> [Interval<S>; 2] {
        let frictionless = |corner: &Loop<S>| {
            let corner = corner.clone().with(Parameter::Viscous, S::zero());
            corner
                .with(Parameter::Coulomb, S::zero())
                .dimensionless_criterion()
        };
        [
            self.over_corners(Worst::Most, |corner| -frictionless(corner).viscous),
            self.over_corners(Worst::Most, |corner| -frictionless(corner).coulomb),
        ]
    }

    /// The coefficients of the dimensionless criterion: what β and σ have to spare at every speed.
    pub(super) fn spare(&self) -> [Interval<S>; 2] {
        [
            self.over_corners(Worst::Least, |corner| {
                corner.dimensionless_criterion().viscous
            }),
            self.over_corners(Worst::Least, |corner| {
                corner.dimensionless_criterion().coulomb
            }),
        ]
    }

    /// The critical speed in the units of the loop, where the region has one.
    pub(super) fn critical_speed(&self, region: Option<Region>) -> Option<Interval<S>> {
        let worst = match region? {
            Region::LocallyStable => Worst::Least,
            Region::LimitCycles => Worst::Most,
            Region::GloballyStable | Region::Unstable => return None,
        };
        Some(self.range(worst, |piece| {
            let [a, b] = piece
                .criteria()
                .map(|c: Criterion<S>| region::critical_speed(&c));
            Interval::hull(a, b)
        }))
    }

    /// A speed as ticks per sampling period (4).
    pub(super) fn in_ticks(&self, speed: &Interval<S>) -> Interval<S> {
        let bounds = self.bounds;
        let end = |v: &S, period: &S, length: Option<&S>| {
            let way = v.clone() * period.clone();
            way.over(length.cloned().unwrap_or_else(S::one))
        };
        let resolution = bounds.resolution.as_ref();
        Interval::hull(
            end(speed.lo(), bounds.period.lo(), resolution.map(Interval::hi)),
            end(speed.hi(), bounds.period.hi(), resolution.map(Interval::lo)),
        )
    }

    /// The margin of (8), (β − ½) + (σ − ½)/v with the terms of the effects, at a speed v > 0 in the
    /// units of the loop.
    pub(super) fn margin_at(&self, speed: &Interval<S>) -> Interval<S> {
        let [a, b] = [speed.lo(), speed.hi()].map(|v| {
            let margin = |corner: &Loop<S>| {
                // (11) over KTv is (8).
                let unit = corner.viscous_unit() * v.clone();
                corner.criterion().margin(v).over(unit)
            };
            let of = |piece: &Loop<Interval<S>>| {
                let range = over_corners(piece, margin);
                let Some(period) = best_period(piece, v) else {
                    return range;
                };
                let inner = piece.clone();
                let inner = inner.with(Parameter::Period, Interval::point(period));
                range.joined(&over_corners(&inner, margin))
            };
            self.range(Worst::Least, of)
        });
        a.joined(&b)
    }

    /// The least and the largest value of a figure over the corners of all pieces.
    fn over_corners(&self, worst: Worst, figure: impl Fn(&Loop<S>) -> S) -> Interval<S> {
        self.range(worst, |piece| over_corners(piece, &figure))
    }

    /// b ≥ KT/2 + B, for comparison; `None` where it does not apply ([`NOT_COMPARED`]).
    pub(super) fn colgate(&self) -> Option<Truth> {
        let margin = |corner: &Loop<S>| {
            let damping = corner.damping.clone().unwrap_or_else(S::zero);
            corner.viscous_friction() - corner.viscous_unit().half() - damping
        };
        self.is_compared()
            .then(|| self.between(margin))?
            .is_nonnegative()
    }

    /// Whether conditions for a wall that acts at once, with no damping but a plain one, apply.
    fn is_compared(&self) -> bool {
        !NOT_COMPARED.iter().any(|effect| self.bounds.has(*effect))
    }

    /// K ≤ min(2b/T, 2c/Δ), for comparison; without an encoder K ≤ 2b/T, and `None` where it does
    /// not apply ([`NOT_COMPARED`]).
    pub(super) fn abbott_okamura(&self) -> Option<Truth> {
        let margin = |corner: &Loop<S>| {
            let viscous = corner.viscous_friction() - corner.viscous_unit().half();
            let coulomb = corner.coulomb_friction() - corner.force_unit().half();
            // Both in one number: only its sign is used.
            if corner.has_encoder() {
                viscous.min(coulomb)
            } else {
                viscous
            }
        };
        self.is_compared()
            .then(|| self.between(margin))?
            .is_nonnegative()
    }
}

/// The sampling period inside its tolerance at which the margin at a speed is largest, where
/// one pulls both ways: the margin is then p/T − q/T² and a constant, largest at T = 2q/p.
fn best_period<S: Enclosed>(bounds: &Loop<Interval<S>>, v: &S) -> Option<S> {
    if !bounds.period_pulls_both_ways() {
        return None;
    }
    let easiest = bounds.at(End::Easiest);
    // With T = 1 and without damping, the margin is p − ½ − k in units of K and v.
    let damping = easiest.damping.clone()?;
    let undamped = Loop {
        damping: None,
        ..easiest.clone().with(Parameter::Period, S::one())
    };
    let p = easiest.viscous_friction() * v.clone() - damping.clone() * v.clone()
        + undamped.criterion().coulomb;
    let best = (damping * easiest.length()).double().over(p);
    let after = best.compare(bounds.period.lo())?.is_gt();
    let before = best.compare(bounds.period.hi())?.is_lt();
    (after && before).then_some(best)
}

/// The least and the largest value of a figure that is monotone in each of K, T and Δ while the
/// others stay, with friction and the other effects at either end.
fn over_corners<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    figure: impl Fn(&Loop<S>) -> S,
) -> Interval<S> {
    let mut corners: Vec<Loop<S>> = vec![bounds.at(End::Hardest), bounds.at(End::Easiest)];
    for parameter in [
        Parameter::Stiffness,
        Parameter::Period,
        Parameter::Resolution,
    ] {
        if let Some(range) = bounds.get(parameter).filter(|range| !range.is_point()) {
            let both = |corner: Loop<S>| {
                [range.lo(), range.hi()].map(|x| corner.clone().with(parameter, x.clone()))
            };
            corners = corners.into_iter().flat_map(both).collect();
        }
    }
    let values = corners.iter().map(|corner| Interval::point(figure(corner)));
    let all = values.reduce(|all, value| all.joined(&value));
    all.unwrap_or_else(|| unreachable!("a box has corners"))
}
