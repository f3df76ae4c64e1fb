//! A scene compiled for simulation: exactly its effects, and the loop that runs them.

use num_traits::Zero;
use passivity_core::{BigRational, Rig, Scalar, effects::Effects};
use passivity_scene::{Effect, Point};

use crate::error::SimError;
use crate::flow::Flow;
use crate::growth::Growth;
use crate::law::{self, Controller};
use crate::motion::Constants;

/// The parameters of the paper's own scene: an encoder, a hold, and both frictions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain {
    /// μ.
    pub mu: f64,
    /// β.
    pub beta: f64,
    /// σ.
    pub sigma: f64,
    /// ξ(0) in ticks.
    pub xi: f64,
    /// ξ̇(0) in ticks per sample.
    pub velocity: f64,
}

/// The operator's force.
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    /// One per interval, in KΔ; the last one stays.
    pub samples: Vec<f64>,
    /// The least and the largest of each sample and all that follow it.
    pub from_here: Vec<[f64; 2]>,
}

/// A scene compiled for the `closed-form` method, in doubles.
///
/// # Example
///
/// ```
/// use passivity_sim::{Plain, Plan};
///
/// let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.6, sigma: 0.4, xi: 0.0, velocity: 1.0 }, 100);
/// assert_eq!(plan.loop_name(), "plain");
/// assert_eq!(plan.effects.len(), 4);
/// ```
#[derive(Clone, Debug)]
pub struct Plan {
    /// The effects of the scene, in the order in which they are listed everywhere.
    pub effects: Vec<Effect>,
    /// Whether there is viscous friction.
    pub viscous: bool,
    /// Whether there is Coulomb friction.
    pub coulomb: bool,
    /// The constants of the motion.
    pub constants: Constants,
    /// The controller.
    pub controller: Controller,
    /// The operator's force, when there is one.
    pub forces: Option<Forces>,
    /// The motion with an amplifier's lag or an arm, when there is one.
    pub flow: Option<Flow<f64>>,
    /// ξ(0) and ξ̇(0).
    pub start: [f64; 2],
    /// How many intervals are run.
    pub intervals: u64,
    /// When divergence is certain.
    pub growth: Growth,
    /// The criterion holds at speed v where `criterion[0]`·v + `criterion[1]` ≥ 0; over v this is the margin (8).
    pub criterion: [f64; 2],
}

/// The nearest double, infinite when out of range.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Scalar};
///
/// assert_eq!(passivity_sim::plan::to_double(&BigRational::integer(3).half()), 1.5);
/// ```
#[must_use]
pub fn to_double(x: &BigRational) -> f64 {
    passivity_scene::number::nearest_f64(x)
}

/// A parameter as a double, or an error when it is out of a double's range.
fn finite(x: &BigRational, parameter: &'static str) -> Result<f64, SimError> {
    let double = to_double(x);
    if double.is_finite() && double.abs() <= LARGEST {
        Ok(double)
    } else {
        Err(SimError::OutOfRange {
            parameter,
            expected: "a magnitude up to 1e120",
        })
    }
}

/// The largest parameter: squares of it, times an inertia, stay doubles.
const LARGEST: f64 = 1e120;

fn positive(x: &BigRational, parameter: &'static str) -> Result<f64, SimError> {
    let double = finite(x, parameter)?;
    if double >= 1.0 / LARGEST {
        Ok(double)
    } else {
        Err(SimError::OutOfRange {
            parameter,
            expected: "a value of at least 1e-120",
        })
    }
}

/// The effects of a point, in the order in which they are listed everywhere.
#[must_use]
pub fn effects_of(point: &Point) -> Vec<Effect> {
    let has = |effect: &Effect| match effect {
        Effect::Hold => true,
        Effect::Viscous => point.beta.is_some(),
        Effect::Coulomb => point.sigma.is_some(),
        Effect::Encoder => point.encoder,
        Effect::Delay => point.delay > 0,
        Effect::Unilateral => point.unilateral,
        Effect::Damping => point.damping.is_some(),
        Effect::Saturation => point.max_force.is_some(),
        Effect::ForceStep => point.force_step.is_some(),
        Effect::Amplifier => point.amplifier.is_some(),
        Effect::Force => point.force.is_some(),
        Effect::Arm => point.arm.is_some(),
    };
    Effect::ALL.into_iter().filter(has).collect()
}

/// Whether nothing but the wall acts on the device.
#[must_use]
pub fn is_unforced(point: &Point) -> bool {
    let no_force = point.force.iter().flatten().all(Zero::is_zero);
    no_force && point.arm.is_none()
}

impl Plan {
    /// The plan of the paper's own scene.
    #[must_use]
    pub fn plain(plain: &Plain, intervals: u64) -> Self {
        let constants = Constants::new(plain.mu, plain.beta, plain.sigma);
        Self {
            effects: vec![
                Effect::Hold,
                Effect::Viscous,
                Effect::Coulomb,
                Effect::Encoder,
            ],
            viscous: true,
            coulomb: true,
            constants,
            controller: Controller::encoder(),
            forces: None,
            flow: None,
            start: [plain.xi, plain.velocity],
            intervals,
            growth: Growth::plain(&constants, 0.5),
            criterion: [plain.beta - 0.5, plain.sigma - 0.5],
        }
    }

    /// Compiles a scene's dimensionless point.
    ///
    /// # Errors
    ///
    /// A scene without inertia, a parameter out of the range of doubles, or a motion within the
    /// interval that is too fast for the power series.
    pub fn compile(point: &Point) -> Result<Self, SimError> {
        let mass = positive(point.mu.as_ref().ok_or(SimError::NoInertia)?, "μ")?;
        let optional = |x: &Option<BigRational>, name| match x {
            Some(x) => finite(x, name),
            None => Ok(0.0),
        };
        let beta = optional(&point.beta, "β")?;
        let sigma = optional(&point.sigma, "σ")?;
        let controller = Self::controller(point)?;
        let forces = match &point.force {
            Some(samples) => Some(Forces::new(samples)?),
            None => None,
        };
        let flow = Flow::compile(point, mass, beta, sigma)?;
        let constants = Constants::new(mass, beta, sigma);
        let rig = Rig::dimensionless(
            point.friction(),
            Effects {
                encoder: point.encoder,
                delay: point.delay,
                damping: point.damping.clone(),
                force_step: point.force_step.clone(),
            },
        );
        let criterion = rig.dimensionless_criterion();
        let mut plan = Self {
            effects: effects_of(point),
            viscous: point.beta.is_some(),
            coulomb: point.sigma.is_some(),
            constants,
            controller,
            forces,
            flow,
            start: [
                finite(&point.start[0], "ξ(0)")?,
                finite(&point.start[1], "ξ̇(0)")?,
            ],
            intervals: point.intervals,
            growth: Growth::never(),
            criterion: [to_double(&criterion.viscous), to_double(&criterion.coulomb)],
        };
        plan.growth = Growth::of(&plan);
        Ok(plan)
    }

    fn controller(point: &Point) -> Result<Controller, SimError> {
        let bits = [
            (point.encoder, law::ENCODER),
            (point.delay > 0, law::DELAY),
            (point.damping.is_some(), law::DAMPING),
            (point.unilateral, law::UNILATERAL),
            (point.force_step.is_some(), law::FORCE_STEP),
            (point.max_force.is_some(), law::SATURATION),
        ];
        let present = bits.iter().filter(|(there, _)| *there);
        let zero = BigRational::integer(0);
        if let Some(step) = &point.force_step {
            positive(step, "the force step δ")?;
        }
        Ok(Controller {
            effects: present.fold(0, |set, (_, bit)| set | bit),
            delay: usize::from(point.delay),
            damping: finite(point.damping.as_ref().unwrap_or(&zero), "B")?,
            force_step: point
                .force_step
                .as_ref()
                .map_or([0.0, 1.0], Controller::step_of),
            max_force: finite(
                point.max_force.as_ref().unwrap_or(&zero),
                "the largest force",
            )?,
        })
    }

    /// Whether this is the paper's own scene: encoder, hold, frictions, and nothing else.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.controller.effects == law::ENCODER && self.forces.is_none() && self.flow.is_none()
    }

    /// Whether nothing but the wall acts on the device.
    #[must_use]
    pub fn is_unforced(&self) -> bool {
        let zero = |forces: &Forces| forces.samples.iter().all(|f| *f == 0.0);
        self.forces.as_ref().is_none_or(zero) && !self.flow.as_ref().is_some_and(Flow::has_arm)
    }

    /// The inner loop that runs this plan: `plain`, `law` or `flow`.
    #[must_use]
    pub fn loop_name(&self) -> &'static str {
        if self.flow.is_some() {
            "flow"
        } else if self.is_plain() {
            "plain"
        } else {
            "law"
        }
    }

    /// The least magnitude of a force held at rest, in KΔ: what must not be above σ for rest.
    ///
    /// With an encoder it is that of the tick at the origin, ½ unless a D/A converter or saturation
    /// changes it; 0 for a one-sided wall, and without an encoder.
    #[must_use]
    pub fn least_holding_force(&self) -> f64 {
        if !self.controller.has(law::ENCODER) {
            return 0.0;
        }
        let at = |sample: f64| self.controller.settled(sample).abs();
        // Sampled in the tick [0, 1) and in [−1, 0); the law is monotone, so no other is less.
        at(0.5).min(at(-0.5))
    }

    /// What is computed in each interval, a line for each step: for `explain`.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::{Plain, Plan};
    ///
    /// let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.6, sigma: 0.4, xi: 0.0, velocity: 1.0 }, 9);
    /// assert_eq!(plan.describe()[0], "loop `plain`: law and motion in one loop, specialised");
    /// ```
    #[must_use]
    pub fn describe(&self) -> Vec<String> {
        let mut lines = vec![match self.loop_name() {
            "plain" => "loop `plain`: law and motion in one loop, specialised".to_owned(),
            "law" => format!(
                "loop `law`: law {} of 64, motion specialised to the scene's frictions",
                self.controller.effects
            ),
            _ => "loop `flow`: power series of the linear motion between reversals".to_owned(),
        }];
        lines.extend(self.describe_law());
        if self.forces.is_some() {
            lines.push("operator: F ← the interval's force".to_owned());
        }
        lines.push(self.describe_motion());
        if self.growth.is_possible() {
            lines.push(format!("growing past {}", self.growth.words()));
        }
        lines
    }

    fn describe_law(&self) -> Vec<String> {
        let law = &self.controller;
        let mut lines = vec![if law.has(law::ENCODER) {
            "sample: q ← ⌊ξ⌋ + ½".to_owned()
        } else {
            "sample: q ← ξ".to_owned()
        }];
        if law.has(law::DELAY) {
            lines.push(format!("delay: q ← the sample of {} before", law.delay));
        }
        lines.push(if law.has(law::DAMPING) {
            format!("law: u ← −(q + {}·(q − q′))", law.damping)
        } else {
            "law: u ← −q".to_owned()
        });
        if law.has(law::UNILATERAL) {
            lines.push("one-sided wall: u ← 0 where q < 0".to_owned());
        }
        if law.has(law::FORCE_STEP) {
            let [n, d] = law.force_step;
            lines.push(format!("D/A converter: u ← δ·⌊u/δ + ½⌋, δ = {}", n / d));
        }
        if law.has(law::SATURATION) {
            lines.push(format!("actuator: u ← u within ±{}", law.max_force));
        }
        lines
    }

    fn describe_motion(&self) -> String {
        let k = &self.constants;
        let mut text = format!("motion: μ = {}", k.mu);
        if self.viscous {
            text += &format!(", β = {}, λ = {:.6e}", k.beta, k.lambda);
        }
        if self.coulomb {
            text += &format!(", σ = {}, reversal and rest in closed form", k.sigma);
        }
        if let Some(flow) = &self.flow {
            text += &flow.describe();
        }
        text
    }
}

impl Forces {
    fn new(samples: &[BigRational]) -> Result<Self, SimError> {
        let mut doubles = Vec::with_capacity(samples.len().max(1));
        for sample in samples {
            doubles.push(finite(sample, "the operator's force")?);
        }
        if doubles.is_empty() {
            doubles.push(0.0);
        }
        let mut from_here = vec![[0.0; 2]; doubles.len()];
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for (force, slot) in doubles.iter().zip(&mut from_here).rev() {
            range = [range[0].min(*force), range[1].max(*force)];
            *slot = range;
        }
        Ok(Self {
            samples: doubles,
            from_here,
        })
    }

    /// The force of interval h.
    #[inline(always)]
    #[must_use]
    pub fn at(&self, h: u64) -> f64 {
        let last = self.samples.len() - 1;
        self.samples[usize::try_from(h).map_or(last, |h| h.min(last))]
    }

    /// The least and the largest force from interval h on.
    #[must_use]
    pub fn range_from(&self, h: u64) -> [f64; 2] {
        let last = self.samples.len() - 1;
        self.from_here[usize::try_from(h).map_or(last, |h| h.min(last))]
    }

    /// The largest magnitude of any force.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let [least, most] = self.from_here[0];
        least.abs().max(most.abs())
    }
}
