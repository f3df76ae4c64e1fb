//! Which verdict: the criterion over the box of a scene's tolerances.

use std::cmp::Ordering;

use num_traits::Signed;
use passivity_core::verdict::{RigBox, Speeds};
use passivity_core::{
    BigRational, Cycle, Friction, Interval, Ordered, Region, Scalar, Truth, Wide, rational, witness,
};

use super::bounds::SpeedBound;
use crate::pi;
use crate::scene::Scene;

/// What a scene's wall is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The criterion holds at every speed, or at every speed up to the scene's bound.
    Passive,
    /// An exact cycle draws energy from the display.
    NotPassive,
    /// The criterion fails, and no such cycle is at hand: effects or a speed bound make the
    /// criterion sufficient only.
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

/// What was decided, and with which enclosure of π.
pub(super) struct Decided {
    pub(super) truth: Truth,
    /// Whether the criterion holds without a speed bound.
    pub(super) at_all_speeds: bool,
    pub(super) region: Option<Region>,
    pub(super) witness: Option<Cycle<BigRational>>,
}

/// Decides at ever tighter enclosures of π, until π no longer matters or the tightest is reached.
pub(super) fn decide(scene: &Scene) -> Decided {
    let mut level = 0;
    loop {
        let decided = decide_at(scene, level);
        let open = decided.truth == Truth::Depends || decided.region.is_none();
        if !open || !scene.involves_pi() || level >= pi::MAX_LEVEL {
            return decided;
        }
        level += 1;
    }
}

fn decide_at(scene: &Scene, level: usize) -> Decided {
    let rigs = wide(&scene.rig_box(level));
    let bound = SpeedBound::of(scene, level);
    let at_every_speed = rigs.holds(&Speeds::All, &Speeds::All);
    let at_all_speeds = at_every_speed == Some(Truth::Holds);
    let truth = match &bound {
        Some(bound) if !at_all_speeds => rigs.holds(&bound.hardest(), &bound.easiest()),
        _ => at_every_speed,
    };
    // A zero stiffness or period is refused when a scene is read; should one get here, no claim
    // is made of it.
    let truth = truth.unwrap_or(Truth::Depends);
    let witness = match truth {
        Truth::Fails => find_witness(scene, bound.as_ref(), level),
        _ => None,
    };
    Decided {
        truth,
        at_all_speeds,
        region: rigs.region(),
        witness,
    }
}

/// The same box without lowest terms: signs need none, and a gcd costs more than the criterion.
pub(super) fn wide(rigs: &RigBox) -> RigBox<Wide> {
    rigs.map(rational::to_wide)
}

/// A cycle that draws energy whatever the parameters within their tolerances: one for the most
/// friction, because less friction only raises the gain.
fn find_witness(
    scene: &Scene,
    bound: Option<&SpeedBound>,
    level: usize,
) -> Option<Cycle<BigRational>> {
    let rigs = &scene.rig_box(level);
    let best = rigs.best();
    if !best.effects.is_plain() {
        return None;
    }
    let friction: Friction<BigRational> = best.friction();
    let speed = bound.map(|bound| bound.least_in_ticks(&wide(rigs)));
    let cycle = if rigs.encoder {
        witness::quantized(&friction, speed.as_ref())?
    } else {
        witness::smooth(&friction, speed.as_ref())?
    };
    within_saturation(scene, rigs, &cycle, level).then_some(cycle)
}

/// Whether the actuator can give the forces of the cycle, so that the law is the spring in it.
fn within_saturation(
    scene: &Scene,
    rigs: &RigBox,
    cycle: &Cycle<BigRational>,
    level: usize,
) -> bool {
    let Some(limit) = &scene.max_force else {
        return true;
    };
    let unit = rigs.stiffness.hi() * rigs.length.hi();
    // The cycle lies in ξ ≥ 0 and its largest force is held from `to`.
    let largest = if rigs.encoder {
        -passivity_core::quantizer::held_force(&cycle.to)
    } else {
        cycle.to.clone()
    };
    (largest * unit).compare(limit.value.enclosure(level).lo()) != Some(Ordering::Greater)
}

/// The parameters that decide a verdict that depends: those whose tolerance alone flips it, with
/// all others at their worst, or all others at their best.
pub(super) fn deciding(scene: &Scene) -> Vec<&'static str> {
    let toleranced: Vec<&'static str> = scene
        .parameters()
        .into_iter()
        .filter(|given| given.has_tolerance())
        .map(|given| given.key)
        .collect();
    let decides = |key: &&'static str| {
        [End::Worst, End::Best]
            .into_iter()
            .any(|end| decide(&pinned(scene, key, end)).truth == Truth::Depends)
    };
    toleranced.into_iter().filter(decides).collect()
}

#[derive(Clone, Copy, PartialEq)]
enum End {
    Worst,
    Best,
}

/// The scene with every tolerance but that of `free` narrowed to one end.
fn pinned(scene: &Scene, free: &str, end: End) -> Scene {
    let mut pinned = scene.clone();
    for given in pinned.parameters_mut() {
        if given.key == free {
            continue;
        }
        let range = given.value.range();
        let friction = matches!(
            given.key,
            "device.viscous"
                | "device.coulomb"
                | "device.inertia"
                | "dimensionless.beta"
                | "dimensionless.sigma"
                | "dimensionless.mu"
                | "device.mass"
        );
        let motion = matches!(given.key, "start.position" | "start.velocity");
        let x = if motion {
            extreme_magnitude(range, end)
        } else if friction == (end == End::Worst) {
            range.lo().clone()
        } else {
            range.hi().clone()
        };
        given.value = crate::Exact::new(Interval::point(x), given.value.pi_power());
    }
    pinned
}

/// The value of largest (worst) or least (best) magnitude in a range.
fn extreme_magnitude(range: &Interval<BigRational>, end: End) -> BigRational {
    let (lo, hi) = (range.lo(), range.hi());
    let (larger, smaller) = match Signed::abs(lo).compare(&Signed::abs(hi)) {
        Some(Ordering::Greater) => (lo, hi),
        _ => (hi, lo),
    };
    match end {
        End::Worst => larger.clone(),
        End::Best if lo.is_negative() && Signed::is_positive(hi) => BigRational::zero(),
        End::Best => smaller.clone(),
    }
}
