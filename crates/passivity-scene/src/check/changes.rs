//! How far each parameter can go, or has to go: the border of the criterion in each alone.

use num_traits::Signed;
use passivity_core::verdict::{RigBox, decide};
use passivity_core::{BigRational, Interval, Rig, Scalar, stiffness};

use super::bounds::{PRINTED, SpeedBound};
use super::report::non_negative;
use crate::scene::{Motion, Scene};

/// Whether a parameter must stay above its border or below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Friction: at least the border.
    AtLeast,
    /// Stiffness, sampling period, encoder resolution, speed: at most the border.
    AtMost,
}

/// The border of one parameter, all others as they are: what to change, and by how much.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The key of the parameter.
    pub key: &'static str,
    /// Its name in words.
    pub name: &'static str,
    /// The SI unit of both figures; empty for a dimensionless one.
    pub unit: &'static str,
    /// What the parameter is now.
    pub now: Interval<BigRational>,
    /// Where the criterion is met with equality, for the speeds that the verdict asks for.
    pub border: Interval<BigRational>,
    /// On which side of the border the criterion holds.
    pub direction: Direction,
    /// Whether the parameter alone, moved to the worst end of `border`, makes the wall passive.
    pub suffices: bool,
}

/// The borders of every parameter that the criterion limits, with a speed bound or at all speeds.
pub(super) fn changes(scene: &Scene, bound: Option<&SpeedBound>) -> Vec<Change> {
    let rigs = scene.rig_box(PRINTED);
    let speed = bound.map(SpeedBound::speed);
    let corners = [
        (rigs.worst(), speed.as_ref().map(|v| v.hi().clone())),
        (rigs.best(), speed.as_ref().map(|v| v.lo().clone())),
    ];
    let names = names(scene.motion);
    let mut changes = Vec::new();
    for (parameter, (key, name, unit)) in Parameter::ALL.into_iter().zip(names) {
        let border = |(rig, v): &(Rig<BigRational>, Option<BigRational>)| {
            // A bound of zero asks nothing of speed; the border is that of every speed.
            let v = v.as_ref().filter(|v| v.is_positive());
            parameter
                .border(rig, v)
                .filter(|x| parameter.is_possible(x))
        };
        let [worst, best] = &corners;
        let Some((at_worst, at_best)) = border(worst).zip(border(best)) else {
            continue;
        };
        let (at_worst, at_best) = match (parameter, bound) {
            // V of TH-START grows with the stiffness, so this border is no quotient.
            (Parameter::Stiffness, Some(bound)) => {
                let limit = stiffness_limit(scene, &rigs, bound);
                (limit.lo().clone(), limit.hi().clone())
            }
            _ => (at_worst, at_best),
        };
        let moved = parameter.moved(&worst.0, &at_worst);
        let suffices = match worst.1.as_ref().filter(|v| v.is_positive()) {
            Some(v) => !moved.criterion().margin_up_to(v).is_negative(),
            None => !moved.criterion().margin_at_all_speeds().is_negative(),
        };
        let now = parameter.value(&worst.0).clone();
        let now = Interval::hull(now, parameter.value(&best.0).clone());
        changes.push(Change {
            key,
            name,
            unit,
            now,
            border: non_negative(at_worst, at_best),
            direction: parameter.direction(),
            suffices,
        });
    }
    changes
}

/// The stiffest wall at every speed up to the bound, over the tolerances; at least 0.
pub(super) fn stiffness_limit(
    scene: &Scene,
    rigs: &RigBox,
    bound: &SpeedBound,
) -> Interval<BigRational> {
    let limit = |rig: &Rig<BigRational>, v: &BigRational| {
        if v.is_positive() {
            stiffness::limit_up_to_speed(rig, v)
        } else {
            stiffness::limit_at_all_speeds(rig)
        }
    };
    let (worst, best, speed) = (rigs.worst(), rigs.best(), bound.speed());
    match scene.start.as_ref().filter(|_| bound.is_root()) {
        None => non_negative(limit(&worst, speed.hi()), limit(&best, speed.lo())),
        Some(start) => {
            let admissible = |rig: &Rig<BigRational>, hardest: bool| {
                let rig = rig.clone();
                move |k: &BigRational| {
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
fn border_near(
    near: &BigRational,
    holds: impl Fn(&BigRational) -> bool,
) -> (BigRational, BigRational) {
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
            return (BigRational::zero(), BigRational::zero());
        };
        lo = below;
    }
    for _ in 0..48 {
        let middle = (&lo + &hi).half();
        if holds(&middle) {
            lo = middle;
        } else {
            hi = middle;
        }
    }
    (lo, hi)
}

#[derive(Clone, Copy)]
enum Parameter {
    Viscous,
    Coulomb,
    Stiffness,
    Period,
    Resolution,
}

impl Parameter {
    const ALL: [Self; 5] = [
        Self::Viscous,
        Self::Coulomb,
        Self::Stiffness,
        Self::Period,
        Self::Resolution,
    ];

    const fn direction(self) -> Direction {
        match self {
            Self::Viscous | Self::Coulomb => Direction::AtLeast,
            Self::Stiffness | Self::Period | Self::Resolution => Direction::AtMost,
        }
    }

    /// Where the criterion is met with equality, at every speed or at every speed up to `v`.
    fn border(self, rig: &Rig<BigRational>, v: Option<&BigRational>) -> Option<BigRational> {
        match (self, v) {
            (Self::Viscous, None) => Some(stiffness::viscous_needed(rig)),
            (Self::Viscous, Some(v)) => Some(stiffness::viscous_needed_at_speed(rig, v)),
            (Self::Coulomb, None) => Some(stiffness::coulomb_needed(rig)),
            (Self::Coulomb, Some(v)) => Some(stiffness::coulomb_needed_up_to_speed(rig, v)),
            (Self::Stiffness, None) => Some(stiffness::limit_at_all_speeds(rig)),
            (Self::Stiffness, Some(v)) => Some(stiffness::limit_up_to_speed(rig, v)),
            (Self::Period, None) => Some(stiffness::longest_period(rig)),
            (Self::Period, Some(v)) => Some(stiffness::longest_period_at_speed(rig, v)),
            (Self::Resolution, None) => stiffness::coarsest_resolution(rig),
            (Self::Resolution, Some(v)) => stiffness::coarsest_resolution_up_to_speed(rig, v),
        }
    }

    /// Whether a device can have the value: friction may be zero, the others may not.
    fn is_possible(self, x: &BigRational) -> bool {
        match self.direction() {
            Direction::AtLeast => true,
            Direction::AtMost => x.is_positive(),
        }
    }

    const fn value(self, rig: &Rig<BigRational>) -> &BigRational {
        match self {
            Self::Viscous => &rig.viscous,
            Self::Coulomb => &rig.coulomb,
            Self::Stiffness => &rig.stiffness,
            Self::Period => &rig.period,
            Self::Resolution => &rig.length,
        }
    }

    /// The rig with this parameter at `x`.
    fn moved(self, rig: &Rig<BigRational>, x: &BigRational) -> Rig<BigRational> {
        let mut moved = rig.clone();
        let place = match self {
            Self::Viscous => &mut moved.viscous,
            Self::Coulomb => &mut moved.coulomb,
            Self::Stiffness => &mut moved.stiffness,
            Self::Period => &mut moved.period,
            Self::Resolution => &mut moved.length,
        };
        *place = if x.is_negative() {
            BigRational::zero()
        } else {
            x.clone()
        };
        moved
    }
}

/// Key, name and SI unit of each parameter, in the order of [`Parameter::ALL`].
const fn names(motion: Motion) -> [(&'static str, &'static str, &'static str); 5] {
    match motion {
        Motion::Linear => [
            ("device.viscous", "viscous friction b", "N s/m"),
            ("device.coulomb", "Coulomb friction c", "N"),
            ("wall.stiffness", "stiffness K", "N/m"),
            ("sampling.period", "sampling period T", "s"),
            ("encoder.resolution", "encoder resolution Δ", "m"),
        ],
        Motion::Rotary => [
            ("device.viscous", "viscous friction b", "N m s/rad"),
            ("device.coulomb", "Coulomb friction c", "N m"),
            ("wall.stiffness", "stiffness K", "N m/rad"),
            ("sampling.period", "sampling period T", "s"),
            ("encoder.resolution", "encoder resolution Δ", "rad"),
        ],
        Motion::Dimensionless => [
            ("dimensionless.beta", "effective viscous friction β", ""),
            ("dimensionless.sigma", "effective Coulomb friction σ", ""),
            ("wall.stiffness", "stiffness, as a factor of what it is", ""),
            (
                "sampling.period",
                "sampling period, as a factor of what it is",
                "",
            ),
            (
                "encoder.resolution",
                "encoder resolution, as a factor of what it is",
                "",
            ),
        ],
    }
}
