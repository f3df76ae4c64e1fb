//! The stiffest wall up to a speed, also where that speed grows with the stiffness (TH-START).

use passivity_core::verdict::{RigBox, decide};
use passivity_core::{BigRational, Interval, Ordered, Rig, Scalar, Wide, rational, stiffness};

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
    // The factor is kept in lowest terms, because halving sums of unreduced fractions would double
    // their length every time.
    let at = |factor: &BigRational| near.clone() * rational::to_wide(factor);
    let holds = |factor: &BigRational| holds(&at(factor));
    let one = BigRational::one();
    let (mut lo, mut hi) = (one.clone(), one);
    let upward = holds(&lo);
    for _ in 0..FAR {
        if upward {
            (lo, hi) = (hi.clone(), hi.double());
        } else {
            (lo, hi) = (lo.clone().half(), lo);
        }
        if holds(if upward { &hi } else { &lo }) != upward {
            return bisected(lo, hi, holds, at);
        }
    }
    if upward {
        (at(&hi), at(&hi))
    } else {
        (Wide::zero(), Wide::zero())
    }
}

/// Halves the bracket 48 times.
fn bisected(
    mut lo: BigRational,
    mut hi: BigRational,
    holds: impl Fn(&BigRational) -> bool,
    at: impl Fn(&BigRational) -> Wide,
) -> (Wide, Wide) {
    for _ in 0..48 {
        let middle = (&lo + &hi).half();
        if holds(&middle) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    (at(&lo), at(&hi))
}
