//! A motion that draws energy from a device of several joints (TH-NDOF, the converse).
//!
//! There and back, each way at constant speed within one sampling period. Where diag(b) − (T/2)𝐊 is not
//! positive semidefinite, long ways in a direction that shows it draw. Where a joint has too little
//! Coulomb friction, it moves over one edge of its encoder and back while every other joint crosses one
//! edge of its own, on the side that helps: a crossing costs as little as one likes.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::decision::Enclosed;
use crate::definite::{self, Form};
use crate::dissipation::Friction;
use crate::interval::Interval;
use crate::joints::{Joint, Joints, Shape, dot};
use crate::pi::Exact;
use crate::scalar::{Ordered, Scalar};
use crate::verdict::End;
use crate::witness;

/// A cycle `from` → `from` + `step` → `from` of the joints, in ticks, or in the unit of length of a joint
/// without an encoder; start and turning point are sampling instants.
#[derive(Clone, Debug, PartialEq)]
pub struct JointCycle<S> {
    /// Where it starts and ends, a joint each.
    pub from: Vec<BigRational>,
    /// The displacement of each joint on the way there; back it is the opposite.
    pub step: Vec<BigRational>,
    /// Energy that the operator gains at least each time round; above zero.
    pub gain: S,
}

/// The smallest fraction of a tick that is tried, as a power of two.
const FINEST: u32 = 4096;

/// How often a long way is doubled.
const DOUBLINGS: u32 = 256;

/// Bits of a way that has π in it.
const CLOSE: u32 = 512;

fn dyadic(power: u32) -> BigRational {
    BigRational::new(BigInt::from(1), BigInt::from(1) << power)
}

fn number<S: Enclosed>(x: &BigRational) -> Option<S> {
    S::of(&Exact::of(x))
}

fn numbers<S: Enclosed>(list: &[BigRational]) -> Option<Vec<S>> {
    list.iter().map(number).collect()
}

impl<S: Enclosed> Joints<Interval<S>, S> {
    /// A cycle that draws energy from every device of the box, within the bounds on the joints' speeds.
    ///
    /// For a single device, without bounds, it finds one whenever the criterion fails at every speed.
    #[must_use]
    pub fn find_cycle(&self) -> Option<JointCycle<S>> {
        let easiest = self.at(End::Easiest);
        let joints = || 0..self.joints.len();
        let by_coulomb = || joints().find_map(|joint| self.at_an_edge(&easiest, joint));
        let by_one_joint = || joints().find_map(|joint| self.of_one_joint(&easiest, joint));
        by_coulomb()
            .or_else(by_one_joint)
            .or_else(|| self.along_ray(&easiest))
    }

    /// The cycle, where every device of the box surely gains on it and it keeps the bounds.
    fn judged(&self, from: Vec<BigRational>, step: Vec<BigRational>) -> Option<JointCycle<S>> {
        let from = self.inside_wall(from, &step)?;
        let gain = self.gain_at_least(&from, &step)?;
        let draws = gain.is_positive()? && self.keeps_bounds(&step)?;
        draws.then_some(JointCycle { from, step, gain })
    }

    /// What an operator gains at least on `from` → `from` + `step` → `from`, in ticks or in the unit of
    /// length without an encoder, whatever the parameters within their tolerances; inside the wall.
    ///
    /// With the unit of length ℓ of each joint, and M what the measured position changes on the way, it
    /// is Σᵢ ℓᵢ|dᵢ|·(sgn dᵢ·Σⱼ Kᵢⱼℓⱼ Mⱼ − 2bᵢℓᵢ|dᵢ|/T − 2cᵢ), from the held torques alone.
    #[must_use]
    pub fn gain_at_least(&self, from: &[BigRational], step: &[BigRational]) -> Option<S> {
        let (from, step) = (numbers::<S>(from)?, numbers::<S>(step)?);
        let one = || Interval::point(S::one());
        let lengths = || {
            let joints = self.joints.iter();
            joints.map(|joint| joint.resolution.clone().unwrap_or_else(one))
        };
        let least = self.at(End::Easiest);
        let moved = least.joints.iter().zip(from.iter().zip(&step));
        let moved = moved
            .map(|(joint, (x, d))| joint.measured(&(x.clone() + d.clone())) - joint.measured(x));
        let moved: Vec<S> = moved.collect();
        let rows = self.shape.rows();
        let mut sum = S::zero();
        for (i, ((row, joint), (d, length))) in rows
            .iter()
            .zip(&least.joints)
            .zip(step.iter().zip(lengths()))
            .enumerate()
        {
            let forwards = match d.sign()? {
                Ordering::Equal => continue,
                Ordering::Greater => S::one(),
                Ordering::Less => -S::one(),
            };
            let viscous = joint.viscous_friction().double() * d.abs();
            let viscous = viscous.over(least.period.clone());
            let mut per_way = -joint.coulomb_friction().double();
            for (j, ((entry, change), of)) in row.iter().zip(&moved).zip(lengths()).enumerate() {
                let mut slope = lower(
                    &(forwards.clone() * entry.clone() * change.clone()),
                    &self.stiffness,
                )?;
                if i == j {
                    slope = slope - viscous.clone();
                }
                per_way = (per_way + lower(&slope, &of)?).shortened();
            }
            sum = (sum + lower(&(per_way * d.abs()), &length)?).shortened();
        }
        Some(sum)
    }

    /// Whether each joint stays strictly below its bound: a hand that turns round is faster in between.
    fn keeps_bounds(&self, step: &[BigRational]) -> Option<bool> {
        for (joint, d) in self.joints.iter().zip(step) {
            let Some(bound) = &joint.max_speed else {
                continue;
            };
            let mut way = number::<S>(d)?.abs();
            if let Some(resolution) = &joint.resolution {
                way = way * resolution.hi().clone();
            }
            let most = bound.lo().clone() * self.period.lo().clone();
            let moves = way.is_positive()?;
            if moves && !(most - way).is_positive()? {
                return Some(false);
            }
        }
        Some(true)
    }

    /// The start shifted by whole ticks so that a one-sided wall is touched at both ends of the cycle,
    /// by each joint for itself.
    fn inside_wall(
        &self,
        from: Vec<BigRational>,
        step: &[BigRational],
    ) -> Option<Vec<BigRational>> {
        let (Shape::Direction(direction), true) = (&self.shape, self.unilateral) else {
            return Some(from);
        };
        let one = BigRational::one();
        let shifted = |((x, d), a): ((BigRational, &BigRational), &S)| {
            let ends = [x.floor(), (&x + d).floor()];
            let [a_floor, b_floor] = ends;
            let (least, most) = if a_floor < b_floor {
                (a_floor, b_floor)
            } else {
                (b_floor, a_floor)
            };
            Some(match a.sign()? {
                Ordering::Greater => x - Scalar::min(least, BigRational::zero()),
                Ordering::Less => x - Scalar::max(most + one.clone(), BigRational::zero()),
                Ordering::Equal => x,
            })
        };
        let joints = from.into_iter().zip(step).zip(direction);
        joints.map(shifted).collect()
    }

    /// Joint `joint` over one edge and back, with each other joint over one of its own.
    fn at_an_edge(&self, easiest: &Joints<S, S>, joint: usize) -> Option<JointCycle<S>> {
        let short = easiest.spare_coulomb().get(joint)?.clone();
        if short.is_nonnegative()? {
            return None;
        }
        // Half of what is short may go into viscous friction.
        let own = easiest.joints.get(joint)?;
        let viscous = (own.viscous_friction() * own.length()).over(easiest.period.clone());
        let fits =
            |way: &S| (-short.clone() - (viscous.clone() * way.clone()).double()).is_positive();
        let fitting = |power: &u32| {
            let way = number::<S>(&dyadic(*power)).as_ref().and_then(fits) == Some(true);
            let bound = self.single(joint, dyadic(*power));
            way && self.keeps_bounds(&bound) == Some(true)
        };
        let way = (0..FINEST).find(fitting)?;
        let signs = easiest.shape.rows().get(joint)?.clone();
        (way..FINEST).find_map(|crossing| {
            let mut from = Vec::new();
            let mut step = Vec::new();
            for (j, (sign, of)) in signs.iter().zip(&easiest.joints).enumerate() {
                let size = dyadic(if j == joint { way } else { crossing });
                let up = j == joint || sign.is_positive()?;
                let still =
                    j != joint && (of.resolution.is_none() || sign.sign()? == Ordering::Equal);
                let (x, d) = match (still, up) {
                    (true, _) => (BigRational::zero(), BigRational::zero()),
                    // From just below an edge onto it, or from the edge to just below.
                    (_, true) => (BigRational::one() - size.clone(), size),
                    (_, false) => (BigRational::one(), -size),
                };
                from.push(x);
                step.push(d);
            }
            self.judged(from, step)
        })
    }

    fn single(&self, joint: usize, step: BigRational) -> Vec<BigRational> {
        let at = |j: usize| {
            if j == joint {
                step.clone()
            } else {
                BigRational::zero()
            }
        };
        (0..self.joints.len()).map(at).collect()
    }

    /// Joint `joint` alone, as a device of one joint (TH-ACTIVE).
    fn of_one_joint(&self, easiest: &Joints<S, S>, joint: usize) -> Option<JointCycle<S>> {
        let own = easiest.joints.get(joint)?;
        let stiffness = easiest.stiffness_matrix().get(joint)?.get(joint)?.clone();
        if !stiffness.is_positive()? {
            return None;
        }
        let unit = stiffness.clone() * easiest.period.clone();
        let beta = own.viscous_friction().over(unit);
        let sigma = own.coulomb_friction().over(stiffness * own.length());
        let bounds = self.joints.get(joint)?;
        let bound = bounds.max_speed.as_ref().map(|bound| {
            let way = bound.lo().clone() * self.period.lo().clone();
            let one = S::one();
            way.over(bounds.resolution.as_ref().map_or(one, |x| x.hi().clone()))
        });
        [64, 256, 1024, 4096].into_iter().find_map(|bits| {
            let most = |x: &S| Some(x.enclosed(bits)?.hi().clone());
            let friction = Friction::new(most(&beta)?, most(&sigma)?);
            let bound = match &bound {
                Some(bound) => Some(bound.enclosed(bits)?.lo().clone()),
                None => None,
            };
            let cycle = match own.resolution {
                Some(_) => witness::quantized(&friction, bound.as_ref()),
                None => witness::smooth(&friction, bound.as_ref()),
            }?;
            let step = self.single(joint, cycle.to - cycle.from.clone());
            self.judged(self.single(joint, cycle.from), step)
        })
    }

    /// A way along a direction in which diag(b) − (T/2)𝐊 is negative.
    fn along_ray(&self, easiest: &Joints<S, S>) -> Option<JointCycle<S>> {
        let Form::Negative(direction) = easiest.viscous_definite()? else {
            return None;
        };
        let magnitudes: Vec<S> = direction.iter().map(Scalar::abs).collect();
        let friction = easiest.joints.iter().map(Joint::coulomb_friction);
        let friction: Vec<S> = friction.collect();
        // The gain is (2/T)·(−dᵀ(diag(b) − (T/2)𝐊)d)·s² − 2Σcᵢ|dᵢ|·s, but for what encoders add.
        let value = -definite::quadratic(&easiest.viscous_form(), &direction);
        let least = (dot(&magnitudes, &friction) * easiest.period.clone()).over(value);
        // The way that the slowest bound leaves, in multiples of the direction, and one tick.
        let mut room: Option<S> = None;
        let mut tick = S::zero();
        for ((joint, of), d) in self.joints.iter().zip(&easiest.joints).zip(&magnitudes) {
            if !d.is_positive()? {
                continue;
            }
            tick = tick.max(d.clone().over(of.length()));
            if let Some(bound) = &joint.max_speed {
                let most = (bound.lo().clone() * self.period.lo().clone()).over(d.clone());
                room = Some(match room {
                    Some(before) => before.min(most),
                    None => most,
                });
            }
        }
        let Some(room) = room else {
            let mut scale = least.double().max(S::one().over(tick));
            for _ in 0..DOUBLINGS {
                if let Some(found) = self.on_ray(easiest, &direction, &scale, 0) {
                    return Some(found);
                }
                scale = scale.double();
            }
            return None;
        };
        let shares = [(63, 64), (3, 4), (1, 2), (1, 4), (1, 16), (1, 256)];
        let shares = shares.map(|(n, d)| room.clone() * S::integer(n).over(S::integer(d)));
        let between = (least + room).half();
        let mut scales = [between].into_iter().chain(shares);
        scales.find_map(|scale| {
            let mut finenesses = [0, 4, 16, 64].into_iter();
            finenesses.find_map(|power| self.on_ray(easiest, &direction, &scale, power))
        })
    }

    /// The cycle of `scale` times a direction, in steps of 2^−`power` ticks, started where the encoders
    /// add to its gain.
    fn on_ray(
        &self,
        easiest: &Joints<S, S>,
        direction: &[S],
        scale: &S,
        power: u32,
    ) -> Option<JointCycle<S>> {
        let rows = easiest.stiffness_matrix();
        let (mut from, mut step) = (Vec::new(), Vec::new());
        for ((d, row), joint) in direction.iter().zip(&rows).zip(&easiest.joints) {
            let fine = number::<S>(&BigRational::from_integer(BigInt::from(1) << power))?;
            let way = (scale.clone() * d.clone()).over(joint.length());
            // A joint without an encoder has no ticks to count in.
            let way = match joint.resolution {
                Some(_) => (way * fine.clone() + S::one().half()).floor().over(fine),
                None => way,
            };
            let rational = way.enclosed(CLOSE)?.middle();
            let part = &rational - rational.floor();
            let helps = (d.clone() * dot(row, direction)).is_nonnegative()?;
            let upwards = Scalar::max(rational.clone(), BigRational::zero()) == rational;
            let is_whole = part == BigRational::zero();
            // ⌈|d|⌉ edges are crossed on the way where that helps, and ⌊|d|⌋ where it does not.
            from.push(match (helps, upwards) {
                (true, true) if !is_whole => BigRational::one() - part,
                (false, false) if !is_whole => BigRational::one() - part,
                (_, _) => BigRational::zero(),
            });
            step.push(rational);
        }
        self.judged(from, step)
    }
}

/// The least value of `slope`·x for an x ≥ 0 of a range.
fn lower<S: Ordered>(slope: &S, range: &Interval<S>) -> Option<S> {
    let end = if slope.is_nonnegative()? {
        range.lo()
    } else {
        range.hi()
    };
    Some(slope.clone() * end.clone())
}
