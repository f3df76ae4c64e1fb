//! The stiffest wall up to a speed, also where that speed grows with the stiffness (TH-START).

use passivity_core::verdict::{RigBox, decide};
use passivity_core::{Interval, Ordered, Rig, Scalar, Wide, stiffness};

use super::bounds::{PRINTED, SpeedBound};
use crate::scene::Scene;

/// The stiffest wall at every speed up to the bound, over the tolerances.
pub(super) fn stiffness_limit(
    scene: &Scene,
    rigs: &RigBox<Wide>,
    bound: &SpeedBound,
) -> Interval<Wide> {
    let limit = |rig: &Rig<Wide>, v: &Wide| {
        if v.is_positive() == Some(true) {
            stiffness::limit_up_to_speed(rig, v)
        } else {
            stiffness::limit_at_all_speeds(rig)
        }
    };
    let (worst, best, speed) = (rigs.worst(), rigs.best(), bound.speed());
    match scene.start.as_ref().filter(|_| bound.is_root()) {
        None => Interval::hull(limit(&worst, speed.hi()), limit(&best, speed.lo())),
        Some(start) => {
            let admissible = |rig: &Rig<Wide>, hardest: bool| {
                let rig = rig.clone();
                move |k: &Wide| {
                    let at = Interval::point(k.clone());
                    let bound = SpeedBound::of_start(scene, start, &at, PRINTED);
                    let rig = Rig {
                        stiffness: k.clone(),
                        ..rig.clone()
                    };
                    let speeds = bound.map(|b| if hardest { b.hardest() } else { b.easiest() });
                    let decision = speeds.and_then(|s| decide(&rig.criterion(), &s));
                    decision.is_some_and(|d| d.holds)
                }
            };
            let now = rigs.stiffness.lo();
            Interval::hull(
                border_near(now, admissible(&worst, true)).0,
                border_near(now, admissible(&best, false)).1,
            )
        }
    }
}

/// Brackets the border of a property that holds below it and not above, to 2⁻⁴⁸ of its size, by
/// doubling or halving from `near` and then bisecting.
///
/// A border beyond 2⁶⁴ times `near`, either way, is given as that, or as zero.
fn border_near(near: &Wide, holds: impl Fn(&Wide) -> bool) -> (Wide, Wide) {
    const FAR: usize = 64;
    let (mut lo, mut hi) = (near.clone(), near.clone());
    if holds(near) {
        let Some(above) = (0..FAR)
            .map(|_| {
                lo = hi.clone();
                hi = hi.double();
                hi.clone()
            })
            .find(|k| !holds(k))
        else {
            return (hi.clone(), hi);
        };
        hi = above;
    } else {
        let Some(below) = (0..FAR)
            .map(|_| {
                hi = lo.clone();
                lo = lo.clone().half();
                lo.clone()
            })
            .find(|k| holds(k))
        else {
            return (Wide::zero(), Wide::zero());
        };
        lo = below;
    }
    for _ in 0..48 {
        let middle = (lo.clone() + hi.clone()).half();
        if holds(&middle) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    (lo, hi)
}
