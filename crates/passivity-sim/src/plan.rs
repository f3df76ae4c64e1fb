//! A scene compiled for simulation: its effects and no others, and the loop that runs them.

use passivity_core::controller::Filter;
use passivity_core::parameter::Values;
use passivity_core::{BigRational, Effect, Parameter};
use passivity_scene::Point;

use crate::error::SimError;
use crate::family::Family;
use crate::flow::{Fast, Flow};
use crate::growth::Growth;
use crate::law::{self, HeldForce};
use crate::motion::Constants;
use crate::number::{Double, to_double};
use crate::outcome::{End, ExactOutcome};

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
pub(crate) struct Forces {
    /// One per interval, in KΔ; the last one stays. At least one.
    samples: Vec<f64>,
    /// The least and the largest of each sample and all that follow it.
    from_here: Vec<[f64; 2]>,
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
/// assert_eq!(plan.effects().len(), 4);
/// ```
#[derive(Clone, Debug)]
pub struct Plan {
    /// The effects of the scene.
    pub(crate) effects: Vec<Effect>,
    /// Whether there is viscous friction.
    pub(crate) viscous: bool,
    /// Whether there is Coulomb friction.
    pub(crate) coulomb: bool,
    /// The constants of the motion.
    pub(crate) constants: Constants,
    /// The least magnitude of a force held at rest, see [`law::least_holding_force`].
    pub(crate) least_holding_force: f64,
    /// The largest force that friction takes: σ, on that side of the least force held at rest where it is
    /// exactly, though doubles may not tell them apart.
    pub(crate) holding: f64,
    /// The controller.
    pub(crate) law: HeldForce,
    /// The operator's force, when there is one.
    pub(crate) forces: Option<Forces>,
    /// The motion with an amplifier's lag or an arm, when there is one.
    pub(crate) flow: Option<Flow<Double>>,
    /// The same by propagators.
    pub(crate) fast: Option<Fast>,
    /// The parts of an interval, each with its time in periods and its plan in that time; none where the
    /// force changes at the sample.
    pub(crate) parts: Vec<(f64, Plan)>,
    /// ξ(0) and ξ̇(0).
    pub(crate) start: [f64; 2],
    /// How far ξ(0) may be from the scene's.
    pub(crate) start_error: f64,
    /// The unit of length: a tick, or without an encoder that of the scene's units.
    pub(crate) length_unit: &'static str,
    /// How many intervals are run.
    pub(crate) intervals: u64,
    /// When divergence is certain.
    pub(crate) growth: Growth,
}

/// How far a motion is simulated after its divergence became certain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// Not at all: its outcome is known.
    Nothing,
    /// Until its growing mode is ten times as large, for at most the intervals of the scene.
    Tenfold,
    /// For all intervals of the scene, or until numbers end.
    All,
}

/// The largest parameter: squares of it, times an inertia, stay doubles.
pub(crate) const LARGEST: f64 = 1e120;

/// A parameter as a double, or an error when it is out of the range that is simulated.
pub(crate) fn in_range(x: &BigRational, parameter: Parameter) -> Result<f64, SimError> {
    let row = parameter.row();
    let double = to_double(x);
    let fail = |expected| SimError::OutOfRange {
        parameter: row.name,
        expected,
    };
    if !double.is_finite() || double.abs() > LARGEST {
        Err(fail("a magnitude up to 1e120"))
    } else if row.values == Values::Positive && double < 1.0 / LARGEST {
        Err(fail("a value of at least 1e-120"))
    } else {
        Ok(double)
    }
}

impl Plan {
    /// The plan of the paper's own scene, of numbers that are taken as they are.
    ///
    /// Those of a scene are checked before they come here; here nothing is. μ is to be from 1e-120 to 1e120, β and σ
    /// from zero to 1e120, and ξ and ξ̇ up to 1e120 in magnitude: of other numbers, as of a μ of zero or of one that is
    /// none, there is no motion, and of what a run of them says nothing holds.
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
            least_holding_force: 0.5,
            holding: plain.sigma,
            law: HeldForce::encoder(),
            forces: None,
            flow: None,
            fast: None,
            parts: Vec::new(),
            start: [plain.xi, plain.velocity],
            start_error: 0.0,
            length_unit: "ticks",
            intervals,
            growth: Growth::plain(&constants, 0.5),
        }
    }

    /// Compiles a scene's dimensionless point.
    ///
    /// # Errors
    ///
    /// A scene without inertia, a parameter out of the range of doubles, or a motion within the
    /// interval that is too fast for the power series.
    pub fn compile(point: &Point) -> Result<Self, SimError> {
        Family::of(point)?.own()
    }

    /// The effects of the scene, in the order in which they are listed everywhere.
    #[must_use]
    pub fn effects(&self) -> &[Effect] {
        &self.effects
    }

    /// ξ(0) in ticks and ξ̇(0) in ticks per sample.
    #[must_use]
    pub const fn start(&self) -> [f64; 2] {
        self.start
    }

    /// The same plan, to be run on where divergence is certain, to the end of all numbers.
    #[must_use]
    pub fn past_growth(self) -> Self {
        Self {
            growth: Growth::never(self.mass()),
            ..self
        }
    }

    /// The same plan, to be run on so far where it ended in growth of a mode.
    pub(crate) fn beyond(&self, end: &End, beyond: Beyond) -> Option<Self> {
        let grows = end.outcome.exact == ExactOutcome::Growing;
        let factor = self.growth.factor.filter(|_| grows)?;
        let until = match beyond {
            Beyond::Nothing => return None,
            Beyond::Tenfold => {
                let more = (10.0_f64.ln() / factor.ln()).ceil();
                // What is above every count is the greatest one.
                self.intervals
                    .min(end.intervals.saturating_add(more as u64))
            }
            Beyond::All => self.intervals,
        };
        Some(self.with_intervals(until).past_growth())
    }

    /// The same plan for so many intervals.
    #[must_use]
    pub(crate) fn with_intervals(&self, intervals: u64) -> Self {
        Self {
            intervals,
            ..self.clone()
        }
    }

    /// How far into an interval the force of the sample before goes on, in periods.
    pub(crate) fn late(&self) -> f64 {
        match self.parts.as_slice() {
            [(time, _), ..] => *time,
            [] => 0.0,
        }
    }

    /// The mass that moves: μ, with the arm's.
    pub(crate) fn mass(&self) -> f64 {
        self.flow
            .as_ref()
            .map_or(self.constants.mu, |flow| flow.mass.0)
    }

    /// Whether this is the paper's own scene: encoder, hold, frictions, and nothing else.
    pub(crate) fn is_plain(&self) -> bool {
        let unforced = self.forces.is_none() && self.flow.is_none();
        self.law.effects == law::ENCODER && unforced && self.parts.is_empty()
    }

    /// Past what divergence is certain, in words.
    pub(crate) fn growth_words(&self) -> String {
        self.growth.words(self.length_unit)
    }

    /// Where the held force jumps, in words: what a sample may be within rounding of. Empty where it follows the position.
    #[must_use]
    pub fn edge_words(&self) -> String {
        self.law.edge_words()
    }

    /// Whether nothing but the wall acts on the device.
    pub(crate) fn is_unforced(&self) -> bool {
        self.forces.as_ref().is_none_or(Forces::is_zero)
            && !self.flow.as_ref().is_some_and(Flow::has_arm)
    }

    /// The inner loop that runs this plan: `plain`, `law`, `flow` or `latency`.
    #[must_use]
    pub fn loop_name(&self) -> &'static str {
        if !self.parts.is_empty() {
            "latency"
        } else if self.flow.is_some() {
            "flow"
        } else if self.is_plain() {
            "plain"
        } else {
            "law"
        }
    }

    /// What is computed in each interval, a line for each step: for `explain`.
    ///
    /// # Example
    ///
    /// ```
    /// use passivity_sim::{Plain, Plan};
    ///
    /// let plan = Plan::plain(&Plain { mu: 50.0, beta: 0.6, sigma: 0.4, xi: 0.0, velocity: 1.0 }, 9);
    /// assert_eq!(plan.describe()[0], "loop `plain`: controller and motion in one specialised loop");
    /// ```
    #[must_use]
    pub fn describe(&self) -> Vec<String> {
        let mut lines = vec![match self.loop_name() {
            "plain" => "loop `plain`: controller and motion in one specialised loop".to_owned(),
            "law" => format!(
                "loop `law`: controller {} of 64{}, with the motion specialised to the scene's friction",
                self.law.effects & 63,
                if self.law.has(law::FILTER) { " with a digital filter" } else { "" }
            ),
            "latency" => "loop `latency`: the motion of an interval in two parts".to_owned(),
            _ => "loop `flow`: propagator of the linear motion over an interval, power series about reversals"
                .to_owned(),
        }];
        lines.extend(self.describe_law());
        if !self.parts.is_empty() {
            lines.push(format!(
                "latency: u acts from {} periods after its sample on, the one before until then",
                self.late()
            ));
        }
        if self.forces.is_some() {
            lines.push("operator: F ← the force of this interval".to_owned());
        }
        lines.push(self.describe_motion());
        if self.growth.is_possible() {
            lines.push(format!("growing past {}", self.growth_words()));
        }
        lines
    }

    fn describe_law(&self) -> Vec<String> {
        let law = &self.law;
        let mut lines = vec![if law.has(law::ENCODER) {
            "sample: q ← ⌊ξ⌋ + ½".to_owned()
        } else {
            "sample: q ← ξ".to_owned()
        }];
        if law.has(law::DELAY) {
            lines.push(format!(
                "delay: q ← the sample taken {} interval{} earlier",
                law.delay,
                if law.delay == 1 { "" } else { "s" }
            ));
        }
        lines.push(if law.has(law::FILTER) {
            let Filter { sum, tails, poles } = &law.filter;
            format!(
                "filter: y ← Σ tⱼ·(qⱼ − qⱼ₋₁) − Σ rᵢ·yᵢ, with qⱼ and yᵢ those of j and i samples \
                 before, t = {tails:?}, r = {poles:?}; u ← −({sum}·q + y)"
            )
        } else if law.has(law::DAMPING) {
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
    /// The operator's forces; none at all is a force of zero.
    pub(crate) fn new(samples: &[BigRational]) -> Result<Self, SimError> {
        let force = |x| in_range(x, Parameter::OperatorForce);
        let mut samples: Vec<f64> = samples.iter().map(force).collect::<Result<_, _>>()?;
        if samples.is_empty() {
            samples.push(0.0);
        }
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        let mut from_here: Vec<[f64; 2]> = Vec::with_capacity(samples.len());
        for force in samples.iter().rev() {
            range = [range[0].min(*force), range[1].max(*force)];
            from_here.push(range);
        }
        from_here.reverse();
        Ok(Self { samples, from_here })
    }

    /// The force of interval h.
    #[inline(always)]
    pub(crate) fn at(&self, h: u64) -> f64 {
        of_interval(&self.samples, h)
    }

    /// The least and the largest force from interval h on.
    pub(crate) fn range_from(&self, h: u64) -> [f64; 2] {
        of_interval(&self.from_here, h)
    }

    /// The largest magnitude of any force.
    pub(crate) fn largest(&self) -> f64 {
        let [least, most] = self.range_from(0);
        least.abs().max(most.abs())
    }

    /// Whether no force acts at all.
    fn is_zero(&self) -> bool {
        self.samples.iter().all(|force| *force == 0.0)
    }
}

/// The item of interval h; the last one stays.
#[inline(always)]
#[expect(clippy::indexing_slicing, reason = "the index is below the length")]
fn of_interval<T: Copy>(items: &[T], h: u64) -> T {
    let last = items.len() - 1;
    items[usize::try_from(h).map_or(last, |h| h.min(last))]
}
