//! A loop in numbers: its units, its dimensionless form, its friction and the criterion (11).

use crate::criterion::Criterion;
use crate::dissipation::Friction;
use crate::effect::Effect;
use crate::law::Law;
use crate::parameter::{Loop, Parameter, Unit};
use crate::scalar::Scalar;

/// What a step may generate at most: `viscous`·d² + `coulomb`·|d|, beside changes of storage. Of a controller, of delay
/// and damping together and of an actuator it is a bound of the sum over a run; of an actuator with ∫ξ̇² and ∫|ξ̇| over
/// each interval in place of d² and |d|.
///
/// Dimensionless it is what the scene's effects ask of β and σ; with units, of b/T and c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost<S> {
    /// ½ + k + B.
    pub viscous: S,
    /// ½(1 + δ) + B with an encoder, ½δ without.
    pub coulomb: S,
}

impl<S: Scalar> Cost<S> {
    /// The bound `viscous`·d² + `coulomb`·|d| on what a step of displacement d generates, in KΔ², where the loop has no
    /// computed costs.
    #[must_use]
    pub fn bound(&self, displacement: &S) -> S {
        let d = displacement.abs();
        d.clone() * (self.viscous.clone() * d + self.coulomb.clone())
    }
}

impl<V> Loop<V> {
    /// Whether an encoder quantizes the position.
    pub const fn has_encoder(&self) -> bool {
        self.resolution.is_some()
    }

    /// Whether an effect is in the loop.
    pub const fn has(&self, effect: Effect) -> bool {
        match effect {
            Effect::Hold => true,
            Effect::Viscous => self.viscous.is_some(),
            Effect::Coulomb => self.coulomb.is_some(),
            Effect::Encoder => self.resolution.is_some(),
            Effect::Delay => self.delay > 0,
            Effect::Latency => self.latency.is_some(),
            Effect::Unilateral => self.unilateral,
            Effect::Damping => self.damping.is_some(),
            Effect::DampingFilter => self.damping_time_constant.is_some(),
            Effect::Controller => self.controller.is_some(),
            Effect::Saturation => self.max_force.is_some(),
            Effect::ForceStep => self.force_step.is_some(),
            Effect::Amplifier => self.time_constant.is_some(),
            Effect::Force => self.operator_force.is_some(),
            Effect::Arm => {
                self.arm_mass.is_some()
                    || self.arm_damping.is_some()
                    || self.arm_stiffness.is_some()
            }
        }
    }

    /// The effects in the loop, in the order in which they are listed everywhere.
    pub fn effects(&self) -> impl Iterator<Item = Effect> + '_ {
        Effect::ALL.into_iter().filter(|effect| self.has(*effect))
    }

    /// Whether sampling and (at most) an encoder are all there is beside friction, so that
    /// TH-ACTIVE applies.
    pub const fn is_plain(&self) -> bool {
        self.delay == 0
            && self.damping.is_none()
            && self.force_step.is_none()
            && !self.has_computed_costs()
    }

    /// Whether no closed form says what the loop costs, so that it has to be computed
    /// ([`with_costs`](Self::with_costs)).
    ///
    /// A delay and damping behind a one-sided or saturated wall cost the sum of what either does
    /// (TH-LAW); in a linear loop they partly cancel (TH-LTI).
    pub const fn has_computed_costs(&self) -> bool {
        let both = self.delay > 0 && self.damping.is_some() && self.is_linear();
        both || self.controller.is_some()
            || self.damping_time_constant.is_some()
            || self.has_actuator()
    }

    /// Whether the force over an interval depends on more than its first sample: delay, damping, a digital controller,
    /// a latency or an amplifier. What the loop remembers is stored beside the wall's spring, so that friction covers
    /// what is generated in a run, and in a single interval only with what that storage gives up.
    pub const fn has_memory(&self) -> bool {
        self.delay > 0 || self.damping.is_some() || self.has_computed_costs()
    }

    /// Whether the force follows its command within an interval: a latency or an amplifier. It is charged by the square
    /// of the velocity at every instant, as friction takes it, not by the distance from sample to sample.
    pub const fn has_actuator(&self) -> bool {
        self.latency.is_some() || self.time_constant.is_some()
    }

    /// Whether the force is linear in the measured positions: no one-sided wall and no saturation.
    pub const fn is_linear(&self) -> bool {
        !self.unilateral && self.max_force.is_none()
    }

    /// The loop after a change of what shapes its costs: those that were computed are of the loop before, and are dropped.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, Loop, Scalar};
    ///
    /// let friction = Friction::new(Fixed::integer(2), Fixed::integer(2));
    /// let late = Loop { delay: 1, viscous_cost: Some(Fixed::integer(1)), ..Loop::plain(friction) };
    /// assert_eq!(late.reshaped(|l| l.unilateral = true).viscous_cost, None);
    /// ```
    #[must_use]
    pub fn reshaped(mut self, change: impl FnOnce(&mut Self)) -> Self {
        change(&mut self);
        self.viscous_cost = None;
        self.coulomb_cost = None;
        self
    }

    /// The parameters that are given, in the order of the table.
    pub fn given(&self) -> impl Iterator<Item = (Parameter, &V)> + '_ {
        let all = Parameter::ALL.iter();
        all.filter_map(|parameter| Some((*parameter, self.get(*parameter)?)))
    }
}

impl<S: Scalar> Loop<S> {
    /// The paper's dimensionless loop: an encoder, a hold and friction; K, T and Δ are 1.
    #[must_use]
    pub fn plain(friction: Friction<S>) -> Self {
        Self {
            resolution: Some(S::one()),
            ..Self::smooth(friction)
        }
    }

    /// The dimensionless loop that knows its position exactly (TH-SMOOTH).
    #[must_use]
    pub fn smooth(friction: Friction<S>) -> Self {
        Self {
            viscous: Some(friction.beta),
            coulomb: Some(friction.sigma),
            ..Self::new(S::one(), S::one())
        }
    }

    /// A parameter's value, with the default of the table where it is absent; `None` where the
    /// table has no default.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> Option<S> {
        let default = || parameter.row().default.map(S::integer);
        self.get(parameter).cloned().or_else(default)
    }

    /// b, or zero.
    #[must_use]
    pub fn viscous_friction(&self) -> S {
        self.viscous.clone().unwrap_or_else(S::zero)
    }

    /// c, or zero.
    #[must_use]
    pub fn coulomb_friction(&self) -> S {
        self.coulomb.clone().unwrap_or_else(S::zero)
    }

    /// Δ, the unit of length: the encoder's resolution, or 1 without an encoder.
    #[must_use]
    pub fn length(&self) -> S {
        self.resolution.clone().unwrap_or_else(S::one)
    }

    /// KT, the unit of viscous friction.
    #[must_use]
    pub fn viscous_unit(&self) -> S {
        self.stiffness.clone() * self.period.clone()
    }

    /// KΔ, the unit of force.
    #[must_use]
    pub fn force_unit(&self) -> S {
        self.stiffness.clone() * self.length()
    }

    /// A parameter's unit K^a·T^b·Δ^c in the units of the loop.
    #[must_use]
    pub fn unit(&self, unit: Unit) -> S {
        let factors = [
            (self.stiffness.clone(), unit.stiffness),
            (self.period.clone(), unit.period),
            (self.length(), unit.length),
        ];
        let (mut above, mut below) = (S::one(), S::one());
        for (factor, power) in factors {
            let side = if power > 0 { &mut above } else { &mut below };
            for _ in 0..power.unsigned_abs() {
                *side = side.clone() * factor.clone();
            }
        }
        above.over(below)
    }

    /// The loop in dimensionless form (3), (4), (7): K, T and Δ are 1 (EQ-1..7).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Loop, Scalar};
    ///
    /// let half_metre = Loop {
    ///     start_position: Some(Fixed::new(1, 2)),
    ///     resolution: Some(Fixed::new(1, 1000)),
    ///     ..Loop::new(Fixed::integer(100), Fixed::new(1, 1000))
    /// };
    /// assert_eq!(half_metre.dimensionless().start_position, Some(Fixed::integer(500)));
    /// ```
    #[must_use]
    pub fn dimensionless(&self) -> Self {
        self.map(|parameter, x| x.clone().over(self.unit(parameter.row().unit)))
    }

    /// The effective friction coefficients β = b/(KT), σ = c/(KΔ) (7), 0 for an absent friction.
    #[must_use]
    pub fn friction(&self) -> Friction<S> {
        Friction {
            beta: self.viscous_friction().over(self.viscous_unit()),
            sigma: self.coulomb_friction().over(self.force_unit()),
        }
    }

    /// The force law of the wall without memory, in the units of the loop over KΔ (TH-LAW).
    ///
    /// Of a dimensionless loop.
    #[must_use]
    pub fn law(&self) -> Law<S> {
        let law = if self.unilateral {
            Law::unilateral()
        } else {
            Law::bilateral()
        };
        match &self.max_force {
            Some(limit) => law.saturated(limit.clone()),
            None => law,
        }
    }

    /// What the effects of the loop cost, in the units of the criterion: what the least friction
    /// that is enough at every speed has to be.
    ///
    /// KT(½ + k) + B of viscous friction (TH-DELAY, TH-DAMP), and KΔ/2 + BΔ/T + F/2 of Coulomb
    /// friction (TH-DAMP, TH-DAC); without an encoder the terms in Δ go (TH-SMOOTH). Where the loop
    /// has computed costs those take their place: KT·λ, and with a controller KΔ·½‖c‖₁ (TH-LTI).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, Loop, Scalar};
    ///
    /// let friction = Friction::new(Fixed::integer(0), Fixed::integer(0));
    /// let late = Loop { delay: 1, ..Loop::plain(friction) };
    /// assert_eq!(late.cost().viscous, Fixed::new(3, 2)); // ½ + 1
    /// ```
    #[must_use]
    pub fn cost(&self) -> Cost<S> {
        let [in_sum, of_damping] = self.cost_in_closed_form();
        // What was computed for another law is no cost of a loop that has a closed form.
        let computed = self.has_computed_costs();
        let viscous = match &self.viscous_cost {
            Some(cost) if computed => self.viscous_unit() * cost.clone(),
            _ => in_sum,
        };
        let mut coulomb = match &self.coulomb_cost {
            _ if !self.has_encoder() => S::zero(),
            Some(cost) if computed => self.force_unit() * cost.clone(),
            _ => of_damping,
        };
        if let Some(step) = &self.force_step {
            coulomb = coulomb + step.clone().half();
        }
        Cost { viscous, coulomb }
    }

    /// KT(½ + k) + B, and KΔ/2 + BΔ/T of an encoder; behind a filter of time constant τ the latter is
    /// KΔ/2 + BΔ/(T + τ) (TH-LTI).
    fn cost_in_closed_form(&self) -> [S; 2] {
        let samples_late = S::one().half() + S::integer(i32::from(self.delay));
        let viscous = self.viscous_unit() * samples_late;
        let coulomb = self.force_unit().half();
        match &self.damping {
            None => [viscous, coulomb],
            Some(damping) => {
                // One tick between two samples is a speed of Δ/T.
                let time = match &self.damping_time_constant {
                    Some(tau) => self.period.clone() + tau.clone(),
                    None => self.period.clone(),
                };
                let tick_speed = self.length().over(time);
                [
                    viscous + damping.clone(),
                    coulomb + damping.clone() * tick_speed,
                ]
            }
        }
    }

    /// The criterion (11), with the terms that the effects add: friction less the
    /// [`cost`](Self::cost).
    ///
    /// A dimensionless loop gives (8).
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_core::{Fixed, Friction, Loop, Scalar};
    ///
    /// let friction = Friction::new(Fixed::integer(2), Fixed::integer(1));
    /// let criterion = Loop { delay: 1, ..Loop::plain(friction) }.criterion();
    /// assert_eq!(criterion.viscous, Fixed::new(1, 2));
    /// assert_eq!(criterion.coulomb, Fixed::new(1, 2));
    /// ```
    #[must_use]
    pub fn criterion(&self) -> Criterion<S> {
        let cost = self.cost();
        Criterion {
            viscous: self.viscous_friction() - cost.viscous,
            coulomb: self.coulomb_friction() - cost.coulomb,
        }
    }

    /// The criterion divided by its units KT and KΔ: (8), with speeds in ticks per sample.
    #[must_use]
    pub fn dimensionless_criterion(&self) -> Criterion<S> {
        let with_units = self.criterion();
        Criterion {
            viscous: with_units.viscous.over(self.viscous_unit()),
            coulomb: with_units.coulomb.over(self.force_unit()),
        }
    }

    /// A speed in length per time as ticks per sampling period, v·T/Δ (4).
    #[must_use]
    pub fn dimensionless_speed(&self, speed: &S) -> S {
        (speed.clone() * self.period.clone()).over(self.length())
    }
}
