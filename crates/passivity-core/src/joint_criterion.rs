//! The criterion for a device of several joints, of one device and over tolerances (TH-NDOF).
//!
//! At every speed it holds exactly when diag(b) − (T/2)𝐊 is positive semidefinite and each cᵢ is at least
//! ½Σⱼ|Kᵢⱼ|Δⱼ. Where joints have bounds on their speed another condition suffices. Both get harder to
//! meet with more stiffness, period, resolution and speed, and easier with more friction, so over
//! tolerances the hardest and the easiest device decide.

use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::decision::Enclosed;
use crate::definite::{self, Form};
use crate::interval::{Interval, Truth};
use crate::joints::{Joint, Joints, Place, Shape};
use crate::parameter::{Hurts, Parameter};
use crate::pi::Exact;
use crate::scalar::{Ordered, Scalar};
use crate::verdict::End;

/// At which speeds of the joints the criterion is asked to hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asked {
    /// At every speed.
    EverySpeed,
    /// At every speed, or else at those up to the bounds that joints have.
    UpToBounds,
}

impl<V, S: Ordered> Joints<V, S> {
    /// Whether the bounds that joints have can help: some have one, and no joint without one is coupled
    /// to another. `None` when a number is undefined.
    pub fn is_bounded(&self) -> Option<bool> {
        if self.joints.iter().all(|joint| joint.max_speed.is_none()) {
            return Some(false);
        }
        for (i, row) in self.shape.rows().iter().enumerate() {
            for (j, (entry, other)) in row.iter().zip(&self.joints).enumerate() {
                let coupled = i != j && entry.sign()? != Ordering::Equal;
                if coupled && other.max_speed.is_none() {
                    return Some(false);
                }
            }
        }
        Some(true)
    }
}

impl<S: Ordered> Joints<S, S> {
    /// cᵢ − ½Σⱼ|Kᵢⱼ|Δⱼ for each joint: what Coulomb friction has to spare at every speed.
    #[must_use]
    pub fn spare_coulomb(&self) -> Vec<S> {
        let pairs = self.joints.iter().zip(self.coulomb_needed());
        let spare =
            |(joint, needed): (&Joint<S>, S)| (joint.coulomb_friction() - needed).shortened();
        pairs.map(spare).collect()
    }

    /// The margins that have to be at least zero up to the joints' bounds: of each joint at rest,
    /// cᵢ − ½Σⱼ|Kᵢⱼ|Δⱼ − ½Σ_{j≠i}|Kᵢⱼ|VⱼT, and the same with Vᵢ(bᵢ − KᵢᵢT/2) at its bound, with all
    /// others at theirs. A joint without a bound, to which none is coupled, needs bᵢ − KᵢᵢT/2 ≥ 0.
    ///
    /// Each margin is linear in each parameter.
    #[must_use]
    pub fn margins_up_to_bounds(&self) -> Vec<S> {
        let mut margins = Vec::new();
        let half_period = self.period.clone().half();
        let spare = self.spare_coulomb();
        for (i, ((row, joint), mut at_rest)) in self
            .stiffness_matrix()
            .iter()
            .zip(&self.joints)
            .zip(spare)
            .enumerate()
        {
            let mut slope = joint.viscous_friction();
            for (j, (entry, other)) in row.iter().zip(&self.joints).enumerate() {
                let taken = half_period.clone() * entry.abs();
                if i == j {
                    slope = slope - taken;
                } else if let Some(bound) = &other.max_speed {
                    at_rest = (at_rest - taken * bound.clone()).shortened();
                }
            }
            margins.push(match &joint.max_speed {
                Some(bound) => at_rest.clone() + slope * bound.clone(),
                None => slope,
            });
            margins.push(at_rest);
        }
        margins
    }

    /// Σ aᵢ²/bᵢ over the joints that the wall acts on; `Ok(i)` the first of them that has no viscous
    /// friction.
    fn load(&self, direction: &[S]) -> Option<Result<usize, S>> {
        let mut load = S::zero();
        for (i, (a, joint)) in direction.iter().zip(&self.joints).enumerate() {
            if a.sign()? == Ordering::Equal {
                continue;
            }
            let friction = joint.viscous_friction();
            if !friction.is_positive()? {
                return Some(Ok(i));
            }
            load = (load + a.square().over(friction)).shortened();
        }
        Some(Err(load))
    }
}

/// All margins at least zero; `None` when one is undefined.
fn all_hold<S: Ordered>(margins: &[S]) -> Option<bool> {
    let mut hold = true;
    for margin in margins {
        hold &= margin.is_nonnegative()?;
    }
    Some(hold)
}

impl<S: Enclosed> Joints<S, S> {
    /// Whether diag(b) − (T/2)𝐊 is positive semidefinite, and a direction where it is not. Of a wall with
    /// a direction that is K·(T/2)·Σaᵢ²/bᵢ ≤ 1; `None` also where it cannot be told, see
    /// [`definite::decide_enclosed`].
    #[must_use]
    pub fn viscous_definite(&self) -> Option<Form<S>> {
        let direction = match &self.shape {
            Shape::Matrix(_) => return definite::decide_enclosed(&self.viscous_form()),
            Shape::Direction(direction) => direction,
        };
        let numbered = |f: &dyn Fn(usize, &S, &Joint<S>) -> S| {
            let pairs = direction.iter().zip(&self.joints).enumerate();
            pairs.map(|(i, (a, joint))| f(i, a, joint)).collect()
        };
        let load = match self.load(direction)? {
            Ok(bare) => {
                let only = |i: usize, _: &S, _: &Joint<S>| {
                    if i == bare { S::one() } else { S::zero() }
                };
                return Some(Form::Negative(numbered(&only)));
            }
            Err(load) => load,
        };
        let taken = self.stiffness.clone() * self.period.clone() * load;
        if (S::integer(2) - taken).is_nonnegative()? {
            return Some(Form::Semidefinite);
        }
        // Where the form is least for a given way into the wall.
        let steepest = |_: usize, a: &S, joint: &Joint<S>| match a.sign() {
            Some(Ordering::Equal) => S::zero(),
            _ => a.clone().over(joint.viscous_friction()),
        };
        Some(Form::Negative(numbered(&steepest)))
    }

    /// Whether the criterion holds; `None` where that cannot be told.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Scalar, Wide, joints::{Joint, Joints, Shape}};
    /// use passivity_core::joint_criterion::Asked;
    ///
    /// let joint = |b| Joint {
    ///     viscous: Some(Wide::integer(b)), coulomb: Some(Wide::integer(1)),
    ///     resolution: Some(Wide::integer(1)), max_speed: None,
    /// };
    /// let with = |b| Joints {
    ///     stiffness: Wide::integer(1), period: Wide::integer(1), joints: vec![joint(b), joint(b)],
    ///     shape: Shape::Direction(vec![Wide::integer(1), -Wide::integer(1)]), unilateral: false,
    /// };
    /// assert_eq!(with(1).holds(Asked::EverySpeed), Some(true)); // equality: Σa²/b = 2 = 2/(KT)
    /// assert_eq!(with(0).holds(Asked::EverySpeed), Some(false));
    /// ```
    #[must_use]
    pub fn holds(&self, asked: Asked) -> Option<bool> {
        if asked == Asked::UpToBounds
            && self.is_bounded()?
            && all_hold(&self.margins_up_to_bounds())?
        {
            return Some(true);
        }
        if !all_hold(&self.spare_coulomb())? {
            return Some(false);
        }
        Some(self.viscous_definite()?.is_semidefinite())
    }

    /// Where the criterion at the speeds asked for is met with equality in one parameter, the others as
    /// they are; `None` where it does not limit the parameter, where no value of it is enough, or where
    /// no formula says it.
    fn border(&self, place: Place, asked: Asked) -> Option<S> {
        let at_every_speed = self.border_at_every_speed(place);
        if asked == Asked::EverySpeed || !self.is_bounded()? {
            return at_every_speed;
        }
        if at_every_speed.is_none() && self.holds(Asked::EverySpeed)? {
            return None;
        }
        let margins = |moved: Self| moved.margins_up_to_bounds();
        let up_to_bounds = self.linear_border(place, margins);
        // Either condition is enough, where the others allow it.
        let suffices = |border: &S| {
            let moved = self.clone().with(place, border.clone().max(S::zero()));
            moved.holds(asked) == Some(true)
        };
        let (a, b) = (
            at_every_speed.filter(suffices),
            up_to_bounds.clone().filter(suffices),
        );
        match (a, b) {
            (Some(a), Some(b)) if place.parameter.row().hurts == Hurts::More => Some(a.max(b)),
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b).or(up_to_bounds),
        }
    }

    fn border_at_every_speed(&self, place: Place) -> Option<S> {
        let of_coulomb = || self.linear_border(place, |moved| moved.spare_coulomb());
        match place.parameter {
            Parameter::Coulomb | Parameter::Resolution => of_coulomb(),
            Parameter::Stiffness => {
                let reach = self.reach()?;
                let by_viscous = reach.map(|reach| reach.double().over(self.period.clone()));
                match (by_viscous, of_coulomb()) {
                    (Some(a), Some(b)) => Some(a.min(b)),
                    (a, b) => a.or(b),
                }
            }
            Parameter::Period => Some(self.reach()??.double().over(self.stiffness.clone())),
            Parameter::Viscous => self.viscous_border(place),
            _ => None,
        }
    }

    /// The least bᵢ: for a wall with a direction KT/2·aᵢ²/(1 − KT/2·Σ_{j≠i}aⱼ²/bⱼ); for a matrix where it
    /// has no π in it.
    fn viscous_border(&self, place: Place) -> Option<S> {
        let Shape::Direction(direction) = &self.shape else {
            return self.viscous_border_of_matrix(place.joint?);
        };
        let own = direction.get(place.joint?)?.clone();
        let others = direction.iter().enumerate().map(|(j, a)| {
            if Some(j) == place.joint {
                S::zero()
            } else {
                a.clone()
            }
        });
        let others: Vec<S> = others.collect();
        let load = self.load(&others)?.err()?;
        let taken = (self.stiffness.clone() * self.period.clone()).half();
        let left = S::one() - taken.clone() * load;
        let is_limited = left.is_positive()? && own.sign()? != Ordering::Equal;
        is_limited.then(|| (taken * own.square()).over(left))
    }

    fn viscous_border_of_matrix(&self, joint: usize) -> Option<S> {
        let rational = |x: S| {
            let range = x.enclosed(64)?;
            range.is_point().then(|| range.lo().clone())
        };
        // The joint comes last.
        let last = |mut row: Vec<BigRational>| {
            (joint < row.len()).then(|| {
                let own = row.remove(joint);
                row.push(own);
                row
            })
        };
        let mut rows = Vec::new();
        for row in self.viscous_form() {
            rows.push(last(row.into_iter().map(rational).collect::<Option<_>>()?)?);
        }
        let own = rows.remove(joint);
        let taken = rational(self.joints.get(joint)?.viscous_friction())? - own.last()?;
        rows.push(own);
        let is_limited = taken != BigRational::zero();
        let least = definite::least_last(rows)? + taken;
        S::of(&Exact::of(&least)).filter(|_| is_limited)
    }

    /// The largest KT/2 for which diag(b) − (T/2)𝐊 is positive semidefinite; zero where none is, and
    /// `Some(None)` where every one is. Of a matrix it is a lower bound, within 2^−32 of the largest.
    #[allow(clippy::option_option)]
    fn reach(&self) -> Option<Option<S>> {
        if let Shape::Direction(direction) = &self.shape {
            return Some(match self.load(direction)? {
                Ok(_) => Some(S::zero()),
                Err(load) if load.is_positive()? => Some(S::one().over(load)),
                Err(_) => None,
            });
        }
        const DOUBLINGS: u32 = 60;
        const STEPS: u32 = 32;
        // From what it is now on, up and down by factors of two, then by halves.
        let now = (self.stiffness.clone() * self.period.clone()).half();
        let part = |above: BigInt, below: BigInt| {
            let share = Exact::of(&BigRational::new(above, below));
            Some(now.clone() * S::of(&share)?)
        };
        let passes = |reach: &S| {
            let mut moved = self.clone();
            moved.stiffness = reach.double().over(self.period.clone());
            moved
                .viscous_definite()
                .is_some_and(|form| form.is_semidefinite())
        };
        let power = |steps: u32| BigInt::from(1) << steps;
        let grows = passes(&now);
        for steps in 1..=DOUBLINGS {
            let (least, unit) = match grows {
                true if !passes(&part(power(steps), power(0))?) => (power(steps - 1), power(0)),
                false if passes(&part(power(0), power(steps))?) => (power(0), power(steps)),
                _ => continue,
            };
            // Between `least` and twice that, in units of 1/(`unit`·2^STEPS).
            let (least, unit) = (least << STEPS, unit << STEPS);
            let mut found = least.clone();
            for step in (0..STEPS).rev() {
                let further = &found + (&least >> (STEPS - step));
                if passes(&part(further.clone(), unit.clone())?) {
                    found = further;
                }
            }
            return part(found, unit).map(Some);
        }
        Some((!grows).then(S::zero))
    }

    /// Where margins that are linear in a parameter are all at least zero: the border nearest to where
    /// it is hard to meet.
    fn linear_border(&self, place: Place, margins: impl Fn(Self) -> Vec<S>) -> Option<S> {
        let at = |value: S| margins(self.clone().with(place, value));
        let mut border: Option<S> = None;
        for (at_zero, at_one) in at(S::zero()).into_iter().zip(at(S::one())) {
            let slope = at_one - at_zero.clone();
            let candidate = match (place.parameter.row().hurts, slope.sign()?) {
                (Hurts::More, Ordering::Less) | (Hurts::Less, Ordering::Greater) => {
                    -at_zero.over(slope)
                }
                _ => continue,
            };
            border = Some(match (border, place.parameter.row().hurts) {
                (None, _) => candidate,
                (Some(before), Hurts::Less) => before.max(candidate),
                (Some(before), _) => before.min(candidate),
            });
        }
        border
    }
}

impl<S: Enclosed> Joints<Interval<S>, S> {
    /// The device at one end of every tolerance.
    #[must_use]
    pub fn at(&self, end: End) -> Joints<S, S> {
        let corner = |place: Place, range: &Interval<S>| end.of(place.parameter, range).clone();
        let joint = |at: usize, joint: &Joint<Interval<S>>| {
            let of = |parameter: Parameter, range: &Option<Interval<S>>| {
                let joint = Some(at);
                range
                    .as_ref()
                    .map(|range| corner(Place { parameter, joint }, range))
            };
            Joint {
                viscous: of(Parameter::Viscous, &joint.viscous),
                coulomb: of(Parameter::Coulomb, &joint.coulomb),
                resolution: of(Parameter::Resolution, &joint.resolution),
                max_speed: of(Parameter::MaxSpeed, &joint.max_speed),
            }
        };
        Joints {
            stiffness: end.of(Parameter::Stiffness, &self.stiffness).clone(),
            period: end.of(Parameter::Period, &self.period).clone(),
            joints: self
                .joints
                .iter()
                .enumerate()
                .map(|(at, of)| joint(at, of))
                .collect(),
            shape: self.shape.clone(),
            unilateral: self.unilateral,
        }
    }

    /// Whether the criterion holds over the tolerances: for all devices, for none, or for some or
    /// undecidedly.
    #[must_use]
    pub fn decide(&self, asked: Asked) -> Truth {
        over(|end| self.at(end).holds(asked))
    }

    /// Whether diag(b) − (T/2)𝐊 is positive semidefinite over the tolerances.
    #[must_use]
    pub fn decide_viscous(&self) -> Truth {
        over(|end| Some(self.at(end).viscous_definite()?.is_semidefinite()))
    }

    /// Where the criterion is met with equality in one parameter: at the hardest and at the easiest end
    /// of the tolerances of all others; never below zero. `None` as for one device.
    #[must_use]
    pub fn border(&self, place: Place, asked: Asked) -> Option<[S; 2]> {
        let border = |end| Some(self.at(end).border(place, asked)?.max(S::zero()));
        let hardest = border(End::Hardest)?;
        let is_point = |place: Place| self.get(place).is_none_or(Interval::is_point);
        let easiest = match self.places().all(is_point) {
            true => hardest.clone(),
            false => border(End::Easiest)?,
        };
        Some([hardest, easiest])
    }
}

/// The truth over the tolerances from that at their ends.
fn over(holds: impl Fn(End) -> Option<bool>) -> Truth {
    match holds(End::Hardest) {
        Some(true) => Truth::Holds,
        _ if holds(End::Easiest) == Some(false) => Truth::Fails,
        _ => Truth::Depends,
    }
}
