//! The verdict: the criterion over the box of a scene's tolerances.

use std::cmp::Ordering;

use passivity_core::drawn::{Drawn, Search};
use passivity_core::parameter::Hurts;
use passivity_core::periodic::Motion;
use passivity_core::verdict::End;
use passivity_core::{
    BigRational, Cycle, Enclosed, Friction, Interval, Loop, Parameter, Truth, quantizer, witness,
};
use schemars::JsonSchema;
use serde::Serialize;

use crate::scene::Scene;

/// What a scene's wall is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The criterion holds at every speed, or at every speed up to the scene's bound.
    Passive,
    /// An exact cycle draws energy from the display.
    NotPassive,
    /// The criterion fails, and no such cycle is known: effects or a speed bound make the criterion
    /// sufficient only.
    NotGuaranteed,
    /// It depends on where in its tolerance a parameter is.
    Depends,
    /// The scene has an effect that no theorem covers.
    NotCovered,
}

impl Verdict {
    /// The name used in machine-readable output.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Passive => "passive",
            Self::NotPassive => "not_passive",
            Self::NotGuaranteed => "not_guaranteed",
            Self::Depends => "depends",
            Self::NotCovered => "not_covered",
        }
    }
}

/// A motion that draws energy whatever the parameters within their tolerances: one for the most
/// friction, because less friction only raises the gain.
pub(super) fn find_witness<S: Enclosed>(
    scene: &Scene,
    bounds: &Loop<Interval<S>>,
) -> Option<Drawn> {
    let easiest = bounds.at(End::Easiest);
    let friction = easiest.friction();
    // The slowest that the bound may be, in ticks per sample.
    let bound = bounds.max_speed.as_ref().map(|v| {
        let ticks = v.lo().clone() * bounds.period.lo().clone();
        ticks.over(match &bounds.resolution {
            Some(resolution) => resolution.hi().clone(),
            None => S::one(),
        })
    });
    // Friction that is bounded by a rational, ever more tightly where π keeps it from being one. The search in a loop with
    // other effects takes the square of so many bits, and beside a tolerance more of them say nothing.
    let tries: &[u32] = match scene.given.is_plain() {
        true => &[64, 256, 1024, 4096, 16_384],
        false => &[64, 256],
    };
    let mut tried = None;
    let mut found = tries.iter().copied().filter_map(|bits| {
        // Where no π is in the way, more bits change nothing, and the search ends as before.
        let ends = bounds.try_map(|_, range| range.try_map(|x| x.enclosed(bits)))?;
        if tried.as_ref() == Some(&ends) {
            return None;
        }
        tried = Some(ends);
        let most = |x: &S| Some(x.enclosed(bits)?.hi().clone());
        let friction = Friction::new(most(&friction.beta)?, most(&friction.sigma)?);
        let bound = match &bound {
            Some(v) => Some(v.enclosed(bits)?.lo().clone()),
            None => None,
        };
        if scene.given.is_plain() {
            let cycle = if scene.given.has_encoder() {
                witness::quantized(&friction, bound.as_ref())
            } else {
                witness::smooth(&friction, bound.as_ref())
            }?;
            within_saturation(bounds, &cycle)?.then(|| Drawn::Motion(Motion::from(cycle)))
        } else {
            drawn(bounds, &friction, bound.as_ref(), bits)
        }
    });
    found.next()
}

/// A motion that draws energy from a loop with memory.
fn drawn<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    friction: &Friction<BigRational>,
    speed_bound: Option<&BigRational>,
    bits: u32,
) -> Option<Drawn> {
    let part = bounds.linear_part(bits)?;
    let in_forces = |force: &S, unit: S| force.clone().over(unit).enclosed(bits);
    let least = bounds.map(|_, x| x.lo().clone()).force_unit();
    let most = bounds.map(|_, x| x.hi().clone()).force_unit();
    let force_step = match &bounds.force_step {
        Some(step) => Some(Interval::hull(
            in_forces(step.lo(), most.clone())?.lo().clone(),
            in_forces(step.hi(), least)?.hi().clone(),
        )),
        None => None,
    };
    let max_force = match &bounds.max_force {
        Some(force) => Some(in_forces(force.lo(), most)?.lo().clone()),
        None => None,
    };
    Search {
        part: &part,
        friction,
        encoder: bounds.has_encoder(),
        force_step: force_step.as_ref(),
        max_force: max_force.as_ref(),
        speed_bound,
    }
    .find()
}

/// Whether the actuator can give the forces of the cycle, so that the law is the spring in it.
fn within_saturation<S: Enclosed>(
    bounds: &Loop<Interval<S>>,
    cycle: &Cycle<BigRational>,
) -> Option<bool> {
    let Some(limit) = &bounds.max_force else {
        return Some(true);
    };
    // The cycle lies in ξ ≥ 0 and its largest force is held from `to`.
    let largest = if bounds.has_encoder() {
        -quantizer::held_force(&cycle.to)
    } else {
        cycle.to.clone()
    };
    let unit = bounds.map(|_, x| x.hi().clone()).force_unit();
    let largest = S::of(&passivity_core::Exact::of(&largest))? * unit;
    Some(largest.compare(limit.lo())? != Ordering::Greater)
}

/// The keys of the parameters that decide a verdict that depends: those whose tolerance alone flips
/// it, with all others at their hardest, or all at their easiest; where none does alone, all that
/// have a tolerance and a part in the criterion.
pub(super) fn deciding<S: Enclosed>(
    scene: &Scene,
    bounds: &Loop<Interval<S>>,
) -> Vec<&'static str> {
    let part = |(parameter, given): (Parameter, &crate::scene::Given)| {
        // What is computed from other parameters has no key.
        let takes_part = parameter.row().hurts != Hurts::Neither && !given.key.is_empty();
        (takes_part && given.has_tolerance()).then_some((parameter, given.key))
    };
    let toleranced: Vec<_> = scene.given.given().filter_map(part).collect();
    let alone = |parameter: Parameter| {
        [End::Hardest, End::Easiest].into_iter().any(|end| {
            let pinned = bounds.map(|other, range| {
                if other == parameter {
                    range.clone()
                } else {
                    Interval::point(end.of(other, range).clone())
                }
            });
            pinned.truth(&pinned.speeds()) == Some(Truth::Depends)
        })
    };
    let decisive = toleranced.iter().filter(|(parameter, _)| alone(*parameter));
    let decisive: Vec<_> = decisive.map(|(_, key)| *key).collect();
    if decisive.is_empty() {
        return toleranced.into_iter().map(|(_, key)| key).collect();
    }
    decisive
}
