//! The truth about a box of loops whose costs have to be computed (TH-LTI, TH-LATENCY, TH-LAG).
//!
//! Of a single loop it is exact: β is compared with λ by a Sturm sequence, with κ by squares. Of a box
//! the corners are decided in this way; if they disagree, it depends. If all corners hold, so does a
//! box of loops without filter and actuator, because the margin is a concave function of each of its
//! parameters: KT·λ is the largest of functions that are linear in KT and in B, and −BΔ/T is concave in
//! T; and so does one with a filter behind a law that is not linear. If none holds, neither does a box whose cost is the same multiple of KT everywhere. Any other box
//! is cut into cells, over each of which the costs are enclosed (`cells.rs`).

use num_rational::BigRational;

use crate::actuator::Actuator;
use crate::cells::over_cells;
use crate::fraction::Wide;
use crate::interval::{Interval, Truth};
use crate::linear_part::{Command, LinearPart};
use crate::parameter::{Loop, Parameter};
use crate::pi::Exact;
use crate::rational;
use crate::scalar::{Ordered, Scalar};
use crate::verdict::{End, Speeds, decide};

/// A number that a box is decided with: without π, or with it.
pub trait Enclosed: Ordered {
    /// An exact number; `None` where this kind of number cannot hold it.
    fn of(x: &Exact) -> Option<Self>;

    /// The number, or an enclosure of it to about so many bits; `None` for an undefined one.
    fn enclosed(&self, bits: u32) -> Option<Interval<BigRational>>;
}

impl Enclosed for Wide {
    fn of(x: &Exact) -> Option<Self> {
        x.to_wide()
    }

    fn enclosed(&self, _bits: u32) -> Option<Interval<BigRational>> {
        rational::from_wide(self).map(Interval::point)
    }
}

impl Enclosed for Exact {
    fn of(x: &Exact) -> Option<Self> {
        Some(x.clone())
    }

    fn enclosed(&self, bits: u32) -> Option<Interval<BigRational>> {
        self.enclosure(bits)
    }
}

/// The parameters that a computed cost depends on.
pub(crate) const SHAPING: [Parameter; 6] = [
    Parameter::Stiffness,
    Parameter::Period,
    Parameter::Damping,
    Parameter::DampingTimeConstant,
    Parameter::Latency,
    Parameter::TimeConstant,
];

/// The bits with which a single loop is decided, one after the other.
const BITS: [u32; 4] = [64, 256, 1024, 4096];

impl<S: Enclosed> Loop<Interval<S>> {
    /// The linear part of the loops of the box, where its costs have to be computed; `None` where a
    /// number is undefined.
    #[must_use]
    pub fn linear_part(&self, bits: u32) -> Option<LinearPart> {
        let quotient = |above: &Interval<S>, below: [S; 2]| {
            let [most, least] = below;
            let lo = above.lo().clone().over(most).enclosed(bits)?;
            let hi = above.hi().clone().over(least).enclosed(bits)?;
            Some(Interval::hull(lo.lo().clone(), hi.hi().clone()))
        };
        let zero = || Interval::point(BigRational::zero());
        let (stiffness, period) = (&self.stiffness, &self.period);
        let periods = || [period.hi().clone(), period.lo().clone()];
        let in_periods = |time: &Option<Interval<S>>| match time {
            Some(time) => quotient(time, periods()),
            None => Some(zero()),
        };
        let damping = match &self.damping {
            Some(damping) => {
                let unit = |k: &S, t: &S| k.clone() * t.clone();
                let units = [
                    unit(stiffness.hi(), period.hi()),
                    unit(stiffness.lo(), period.lo()),
                ];
                quotient(damping, units)?
            }
            None => zero(),
        };
        let pole = match &self.damping_time_constant {
            Some(tau) => {
                let pole = |tau: &S, period: &S| {
                    tau.clone()
                        .over(tau.clone() + period.clone())
                        .enclosed(bits)
                };
                let lo = pole(tau.lo(), period.hi())?;
                let hi = pole(tau.hi(), period.lo())?;
                Interval::hull(lo.lo().clone(), hi.hi().clone())
            }
            None => zero(),
        };
        Some(LinearPart {
            command: match &self.controller {
                Some(controller) => Command::Controller(controller.clone()),
                None => Command::Spring { damping, pole },
            },
            delay: self.delay,
            actuator: if self.has_actuator() {
                Some(Actuator {
                    latency: in_periods(&self.latency)?,
                    time_constant: in_periods(&self.time_constant)?,
                })
            } else {
                None
            },
            linear: self.is_linear(),
        })
    }

    /// The box with its computed costs, enclosed to so many bits; the box itself where a closed form
    /// says them.
    ///
    /// `None` where they are beyond what the kernel computes, see [`LinearPart::cost`].
    ///
    /// # Example
    ///
    /// A delay of one sample and virtual damping of ½KT cost 5/4, not 2 (TH-LTI).
    ///
    /// ```
    /// use passivity_core::{Fraction, Friction, Interval, Loop, Scalar, Wide};
    ///
    /// let friction = Friction::new(Wide::integer(1), Wide::integer(1));
    /// let damped = Loop { delay: 1, damping: Some(Wide::integer(1).half()), ..Loop::plain(friction) };
    /// let point = damped.map(|_, x| Interval::point(x.clone())).with_costs(64).unwrap();
    /// assert_eq!(point.map(|_, x| x.lo().clone()).cost().viscous, Wide::integer(5).half().half());
    /// ```
    #[must_use]
    pub fn with_costs(&self, bits: u32) -> Option<Self> {
        if !self.has_computed_costs() {
            return Some(self.clone());
        }
        let width = BigRational::new(1.into(), num_bigint::BigInt::from(1) << bits);
        let cost = self.linear_part(bits)?.cost(&width)?;
        let of = |x: &Interval<BigRational>| x.try_map(|end| S::of(&Exact::of(end)));
        Some(Self {
            viscous_cost: Some(of(&cost.viscous)?),
            // All but a controller has a closed form, in which tolerances cost nothing extra.
            coulomb_cost: match self.controller {
                Some(_) => Some(of(&cost.coulomb)?),
                None => None,
            },
            ..self.clone()
        })
    }

    /// Whether the criterion holds over the box at every speed asked for (TH-CHECK): what
    /// [`decide`](Self::decide) says, and for computed costs what the costs of each loop say.
    ///
    /// `None` when a number is undefined. [`Truth::Depends`] is also the answer where the cells of a
    /// box are too coarse to tell.
    #[must_use]
    pub fn truth(&self, speeds: &Speeds<Interval<S>>) -> Option<Truth> {
        if !self.has_computed_costs() {
            return self.decide(speeds);
        }
        let constant = !self.has_actuator();
        if constant && self.controller.is_some() && self.viscous_cost.is_some() {
            // The costs that are at hand are those of every loop of the box, and may be enough.
            let truth = self.decide(speeds)?;
            if truth != Truth::Depends {
                return Some(truth);
            }
        }
        let hardest = speeds.at(End::Hardest);
        let easiest = speeds.at(End::Easiest);
        let (mut all, mut any) = (true, false);
        for corner in self.corners() {
            if all {
                match corner.at(End::Hardest).met_at(&hardest)? {
                    Truth::Holds => any = true,
                    Truth::Fails => all = false,
                    Truth::Depends => return Some(Truth::Depends),
                }
            }
            if !all && !any {
                any = match corner.at(End::Easiest).met_at(&easiest)? {
                    Truth::Holds => true,
                    Truth::Fails => false,
                    Truth::Depends => return Some(Truth::Depends),
                };
            }
            if !all && any {
                return Some(Truth::Depends);
            }
        }
        match all {
            true if self.corners_are_hardest() => Some(Truth::Holds),
            true => over_cells(self, speeds, Truth::Holds),
            false if (constant && self.damping.is_none()) || self.has_one_shape() => {
                Some(Truth::Fails)
            }
            false => over_cells(self, speeds, Truth::Fails),
        }
    }

    /// Whether [`truth`](Self::truth) is that the criterion holds: the same in less time.
    #[must_use]
    pub fn surely_holds(&self, speeds: &Speeds<Interval<S>>) -> bool {
        if !self.has_computed_costs() {
            return self.decide(speeds) == Some(Truth::Holds);
        }
        let hardest = speeds.at(End::Hardest);
        let holds = |corner: Self| corner.at(End::Hardest).met_at(&hardest) == Some(Truth::Holds);
        let corners_hold = || self.corners().into_iter().all(holds);
        if self.corners_are_hardest() {
            return corners_hold();
        }
        // Of filtered damping a stretch of which a corner fails is cut no further.
        (!self.has_actuator() || corners_hold())
            && over_cells(self, speeds, Truth::Holds) == Some(Truth::Holds)
    }

    /// Whether no loop of the box is harder than its corners.
    ///
    /// So it is behind a law that is not linear too: there KT(½ + k) + B grows with each of them, whatever the filter, and the
    /// margin with −BΔ/(T + τ) is a concave function of T.
    fn corners_are_hardest(&self) -> bool {
        let behind_any_law = !self.is_linear() && !self.has_actuator();
        self.is_unfiltered() || behind_any_law || self.has_one_shape()
    }

    /// Whether there is neither a filter on the damping nor an actuator.
    const fn is_unfiltered(&self) -> bool {
        self.damping_time_constant.is_none() && !self.has_actuator()
    }

    /// Whether the costs of all loops of the box are the same multiples.
    fn has_one_shape(&self) -> bool {
        let mut given = SHAPING.iter().filter_map(|shaping| self.get(*shaping));
        given.all(Interval::is_point)
    }

    /// The box with each of the shaping parameters at either end.
    ///
    /// Without a filter and an actuator the stiffest wall is the hardest: where KT·w(θ) + B·r(θ) is
    /// largest, w(θ) is at least ½, because it is ½ where r is 1.
    fn corners(&self) -> alloc::vec::Vec<Self> {
        let split = |parameter: &Parameter| {
            let skipped = *parameter == Parameter::Stiffness && self.is_unfiltered();
            !skipped && self.get(*parameter).is_some_and(|range| !range.is_point())
        };
        self.at_both_ends(SHAPING.into_iter().filter(split))
    }

    /// The box with each of these parameters at either end.
    pub(crate) fn at_both_ends(
        &self,
        parameters: impl Iterator<Item = Parameter>,
    ) -> alloc::vec::Vec<Self> {
        let mut corners = alloc::vec![self.clone()];
        for parameter in parameters {
            let Some(range) = self.get(parameter) else {
                continue;
            };
            let ends = [range.lo(), range.hi()].map(|end| Interval::point(end.clone()));
            let both = |corner: Self| ends.clone().map(|end| corner.clone().with(parameter, end));
            corners = corners.into_iter().flat_map(both).collect();
        }
        corners
    }
}

impl<S: Enclosed> Loop<S> {
    /// Whether the criterion holds for one loop with computed costs, exactly;
    /// [`Truth::Depends`] where no enclosure within bounds tells.
    fn met_at(&self, speeds: &Speeds<S>) -> Option<Truth> {
        let point = self.map(|_, x| Interval::point(x.clone()));
        for bits in BITS {
            let width = BigRational::new(1.into(), num_bigint::BigInt::from(1) << bits);
            let part = point.linear_part(bits)?;
            if let Speeds::UpToSquared(_) = speeds {
                let costs = point.with_costs(bits)?;
                let [hard, easy] = [End::Hardest, End::Easiest].map(|end| costs.at(end));
                let holds = decide(&hard.criterion(), speeds)?.holds;
                if holds == decide(&easy.criterion(), speeds)?.holds {
                    return Some(Truth::over(holds, holds));
                }
                continue;
            }
            // Coulomb friction first, and what it leaves for viscous friction at the bound.
            let Some(coulomb) = part.coulomb_cost(&width) else {
                return Some(Truth::Depends);
            };
            let ends = [coulomb.hi(), coulomb.lo()].map(|cost| self.left_by(cost, self, speeds));
            let [Some(hard), Some(easy)] = ends else {
                return None;
            };
            match (hard, easy) {
                (None, None) => return Some(Truth::Fails),
                (Some(lo), Some(hi)) => {
                    let beta = Interval::hull(
                        lo.enclosed(bits)?.lo().clone(),
                        hi.enclosed(bits)?.hi().clone(),
                    );
                    if let Some(holds) = part.decide(&beta, &width) {
                        return Some(Truth::over(holds, holds));
                    }
                }
                _ => {}
            }
        }
        Some(Truth::Depends)
    }

    /// The β that viscous friction and what Coulomb friction has to spare amount to at the speed
    /// bound, where the encoder of a controller costs `coulomb`; what is spared is that of another loop.
    /// The inner `None` where Coulomb friction falls short.
    pub(crate) fn left_by(
        &self,
        coulomb: &BigRational,
        sparing: &Self,
        speeds: &Speeds<S>,
    ) -> Option<Option<S>> {
        let coulomb_cost = match self.controller {
            Some(_) => Some(S::of(&Exact::of(coulomb))?),
            None => None,
        };
        let spare = Self {
            coulomb_cost,
            ..sparing.clone()
        };
        let spare = spare.criterion().coulomb;
        if !spare.is_nonnegative()? {
            return Some(None);
        }
        let viscous = self.viscous_friction();
        let viscous = match speeds {
            Speeds::UpTo(v) => viscous + spare.over(v.clone()),
            Speeds::All | Speeds::UpToSquared(_) => viscous,
        };
        Some(Some(viscous.over(self.viscous_unit())))
    }
}
