//! The reports of a simulation, a sweep and a measurement of accuracy for programs: the types that
//! `--format json` writes.
//!
//! JSON has no infinities: a figure without a finite value is an error.

use std::collections::BTreeMap;

use passivity_core::{Exact, Interval, Parameter};
use passivity_scene::check::{enclosure, key_of};
use passivity_scene::display::{Rounding, outward};
use passivity_scene::number::nearest_f64;
use passivity_scene::{Given, Scene};
use schemars::JsonSchema;
use serde::ser::Error as _;
use serde::{Serialize, Serializer};

use crate::accuracy::{Measured, Table};
use crate::error::SimError;
use crate::method::Method;
use crate::outcome::{ExactOutcome, Outcome, PaperOutcome};
use crate::plan::Plan;
use crate::simulated::{Detail, Simulated};
use crate::sweep::Row;

/// `simulate --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Simulation {
    /// The scene's name.
    pub scene: String,
    /// The method's name.
    pub method: &'static str,
    /// The method with its parameter.
    pub method_parameter: String,
    /// The effects in the scene.
    pub effects: Vec<&'static str>,
    /// The keys of the parameters with a tolerance that were taken at their nominal value: that before a `±`, the middle of a
    /// range, or the bound where one is given.
    pub nominal: Vec<&'static str>,
    /// These values as the motion has them, by the keys of what they are: a period for a rate, and what is given at the motor
    /// at the device. In SI units, or in K, T and Δ where the scene has no units.
    pub nominal_values: BTreeMap<&'static str, f64>,
    /// What is computed in each interval.
    pub plan: Vec<String>,
    /// How many intervals were run.
    pub intervals: u64,
    /// The state at the end.
    #[serde(rename = "final")]
    pub last: State,
    /// What became of it.
    pub outcome: Outcome,
    /// The first sample that rounding may have put on the wrong side of an edge: of an encoder's, or without one of
    /// where the force jumps, at the surface of a wall with damping or between two steps of a D/A converter. The motion
    /// from there on, and with it the outcome, may be another one. Null where no sample was so near to an edge, and for
    /// the methods that decide every sample.
    pub within_rounding_of_edge: Option<u64>,
    /// Sums over the run.
    pub totals: Sums,
    /// How long it took, where that was asked for: without it the same input gives the same bytes.
    pub seconds: Option<f64>,
}

/// The state at the end of a simulation, in ticks and ticks per sample.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct State {
    /// ξ.
    pub xi: f64,
    /// ξ̇.
    pub velocity: f64,
    /// In lowest terms, by the exact method.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exact: Option<Text>,
    /// In decimal, by the reference.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub digits: Option<Text>,
    /// By rigorous intervals.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub enclosure: Option<Enclosure>,
}

/// ξ and ξ̇ as texts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Text {
    /// ξ.
    pub xi: String,
    /// ξ̇.
    pub velocity: String,
}

/// Enclosures of ξ and ξ̇.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Enclosure {
    /// Of ξ.
    pub xi: Ends,
    /// Of ξ̇.
    pub velocity: Ends,
    /// The bits of the numbers that decided.
    pub bits: u32,
}

/// The ends of an enclosure, written as decimals that are not within it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Ends {
    /// The lower end.
    #[serde(serialize_with = "below")]
    pub lo: f64,
    /// The upper end.
    #[serde(serialize_with = "above")]
    pub hi: f64,
}

fn below<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    decimal(&outward(*x, Rounding::Down), serializer)
}

fn above<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    decimal(&outward(*x, Rounding::Up), serializer)
}

/// A number of these digits.
fn decimal<S: Serializer>(digits: &str, serializer: S) -> Result<S::Ok, S::Error> {
    let number: serde_json::Number = digits.parse().map_err(S::Error::custom)?;
    number.serialize(serializer)
}

/// Energies over a run, in KΔ².
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sums {
    /// Σ E_gᴸ.
    pub generated_linear: f64,
    /// Σ E_g.
    pub generated_quantized: f64,
    /// Σ E_d.
    pub dissipated: f64,
    /// What the balance (13) of an interval is off by at most.
    pub residual_max: f64,
}

/// A figure, unless it is none.
fn finite(x: f64, figure: &'static str, interval: u64) -> Result<f64, SimError> {
    if x.is_finite() {
        Ok(x)
    } else {
        Err(SimError::NotFinite { interval, figure })
    }
}

/// The parameters that a plan of a scene takes at their nominal values; none in whose place a speed was typed.
pub fn taken<'s>(scene: &'s Scene, plan: &Plan) -> impl Iterator<Item = (Parameter, &'s Given)> {
    let [_, velocity] = scene.point().start();
    let [_, started] = plan.start();
    let is_typed = nearest_f64(&velocity) != started;
    let all = scene.nominal();
    all.filter(move |(parameter, _)| !(is_typed && *parameter == Parameter::StartVelocity))
}

/// A number of a scene, nearly.
fn near(x: &Exact) -> Option<f64> {
    let known = enclosure(&Interval::point(x.clone()))?;
    Some(nearest_f64(&known.middle()))
}

impl Simulation {
    /// The report on a simulation of a scene, with how many seconds it took where that is asked for.
    ///
    /// # Errors
    ///
    /// A figure without a finite value.
    pub fn new(
        scene: &Scene,
        plan: &Plan,
        method: &Method,
        run: &Simulated,
        seconds: Option<f64>,
    ) -> Result<Self, SimError> {
        let (end, totals) = (&run.end, &run.totals);
        let finite = |x, figure| finite(x, figure, end.intervals);
        let value = |(parameter, given): (Parameter, &Given)| {
            Some((key_of(parameter, scene.motion), near(&given.nominal)?))
        };
        let mut keys: Vec<_> = taken(scene, plan).map(|(_, given)| given.key).collect();
        keys.sort_unstable();
        Ok(Self {
            scene: scene.name.clone(),
            method: method.name(),
            method_parameter: method.to_string(),
            effects: plan.effects().iter().map(|effect| effect.name()).collect(),
            nominal: keys,
            nominal_values: taken(scene, plan).filter_map(value).collect(),
            plan: plan.describe(),
            intervals: end.intervals,
            last: State::new(run)?,
            outcome: end.outcome.clone(),
            within_rounding_of_edge: end.within_rounding_of_edge,
            totals: Sums {
                generated_linear: finite(totals.generated_linear, "totals.generated_linear")?,
                generated_quantized: finite(
                    totals.generated_quantized,
                    "totals.generated_quantized",
                )?,
                dissipated: finite(totals.dissipated, "totals.dissipated")?,
                residual_max: finite(totals.residual_max, "totals.residual_max")?,
            },
            seconds,
        })
    }
}

impl State {
    fn new(run: &Simulated) -> Result<Self, SimError> {
        let finite = |x, figure| finite(x, figure, run.end.intervals);
        let mut state = Self {
            xi: finite(run.end.xi, "final.xi")?,
            velocity: finite(run.end.velocity, "final.velocity")?,
            exact: None,
            digits: None,
            enclosure: None,
        };
        let text = |[xi, velocity]: &[String; 2]| Text {
            xi: xi.clone(),
            velocity: velocity.clone(),
        };
        let ends = |[lo, hi]: [f64; 2], figure| -> Result<Ends, SimError> {
            Ok(Ends {
                lo: finite(lo, figure)?,
                hi: finite(hi, figure)?,
            })
        };
        match &run.detail {
            Detail::None => {}
            Detail::Exact(texts) => state.exact = Some(text(texts)),
            Detail::Digits(texts) => state.digits = Some(text(texts)),
            Detail::Enclosed {
                ends: [xi, velocity],
                bits,
            } => {
                state.enclosure = Some(Enclosure {
                    xi: ends(*xi, "final.enclosure.xi")?,
                    velocity: ends(*velocity, "final.enclosure.velocity")?,
                    bits: *bits,
                });
            }
        }
        Ok(state)
    }
}

/// `sweep --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Sweep {
    /// The scene's name.
    pub scene: String,
    /// How many points the grid has.
    pub points: usize,
    /// How many of them were simulated now.
    pub simulated: usize,
    /// How many intervals each was run.
    pub intervals: u64,
    /// How many points had each outcome, as far as it is certain.
    pub exact: ExactCounts,
    /// How many points had each outcome by the paper's detector.
    pub paper: PaperCounts,
    /// How many of the points that were simulated now have a sample within rounding of an edge, see [`Simulation`],
    /// from which on their motion may be another one.
    pub within_rounding_of_edge: usize,
    /// How long it took.
    pub seconds: f64,
}

/// Points by their outcomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Outcomes {
    exact: ExactCounts,
    paper: PaperCounts,
    within_rounding_of_edge: usize,
}

impl Outcomes {
    /// Counts a point.
    pub const fn count(&mut self, row: &Row) {
        *match row.exact {
            ExactOutcome::AtRest => &mut self.exact.at_rest,
            ExactOutcome::NeverAtRest => &mut self.exact.never_at_rest,
            ExactOutcome::Growing => &mut self.exact.growing,
            ExactOutcome::Undecided => &mut self.exact.undecided,
        } += 1;
        *match row.paper {
            PaperOutcome::Converged => &mut self.paper.converged,
            PaperOutcome::LimitCycle => &mut self.paper.limit_cycle,
            PaperOutcome::Unstable => &mut self.paper.unstable,
        } += 1;
        self.within_rounding_of_edge += row.within_rounding_of_edge.is_some() as usize;
    }

    /// Those of some points.
    pub fn of<'r>(rows: impl IntoIterator<Item = &'r Row>) -> Self {
        let mut outcomes = Self::default();
        for row in rows {
            outcomes.count(row);
        }
        outcomes
    }
}

/// Points by their outcome, as far as it is certain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ExactCounts {
    /// At rest for ever.
    pub at_rest: usize,
    /// Never at rest.
    pub never_at_rest: usize,
    /// Growing without end.
    pub growing: usize,
    /// None of these.
    pub undecided: usize,
}

/// Points by their outcome by the paper's detector.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PaperCounts {
    /// |ξ̇| < 0.01 at the end.
    pub converged: usize,
    /// Neither converged nor unstable.
    pub limit_cycle: usize,
    /// Unstable.
    pub unstable: usize,
}

impl Sweep {
    /// The report on a sweep of `points` points; `simulated` of them were simulated now and took so many
    /// seconds.
    #[must_use]
    pub fn new(
        scene: &str,
        points: usize,
        outcomes: Outcomes,
        simulated: usize,
        intervals: u64,
        seconds: f64,
    ) -> Self {
        Self {
            scene: scene.to_owned(),
            points,
            simulated,
            intervals,
            exact: outcomes.exact,
            paper: outcomes.paper,
            within_rounding_of_edge: outcomes.within_rounding_of_edge,
            seconds,
        }
    }
}

/// `accuracy --format json`.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Accuracy {
    /// The scene's name.
    pub scene: String,
    /// Intervals that were compared.
    pub intervals: u64,
    /// The reference's outcome.
    pub reference: ExactOutcome,
    /// A row for each method that can do the scene.
    pub rows: Vec<AccuracyRow>,
    /// The methods that cannot, or that stopped undecided.
    pub left_out: Vec<LeftOut>,
}

/// How wrong a method is, and how long an interval takes.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct AccuracyRow {
    /// The method with its parameter.
    pub method: String,
    /// The error of the position at the end over the reach of the motion.
    pub position: f64,
    /// The error of the velocity at the end over the greatest speed.
    pub velocity: f64,
    /// The largest error of the energies over the energy dissipated; each error is over 1 where what it is
    /// compared with is 0.
    pub energy: f64,
    /// The outcome.
    pub outcome: ExactOutcome,
    /// Whether it is the reference's.
    pub same_outcome: bool,
    /// How many intervals too late it was found.
    pub intervals_late: i64,
    /// Time per interval.
    pub nanoseconds_per_interval: f64,
}

/// A method that cannot do a scene, or that stopped undecided.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct LeftOut {
    /// The method with its parameter.
    pub method: String,
    /// Why not.
    pub because: String,
}

impl Accuracy {
    /// The report on the table of a scene with this name.
    ///
    /// # Errors
    ///
    /// A figure without a finite value.
    pub fn new(scene: &str, table: &Table) -> Result<Self, SimError> {
        let row = |row: &Measured| -> Result<AccuracyRow, SimError> {
            let finite = |x, figure| finite(x, figure, table.intervals);
            Ok(AccuracyRow {
                method: row.method.to_string(),
                position: finite(row.position, "position")?,
                velocity: finite(row.velocity, "velocity")?,
                energy: finite(row.energy, "energy")?,
                outcome: row.exact,
                same_outcome: row.same_outcome,
                intervals_late: row.late,
                nanoseconds_per_interval: finite(row.nanoseconds, "nanoseconds_per_interval")?,
            })
        };
        Ok(Self {
            scene: scene.to_owned(),
            intervals: table.intervals,
            reference: table.reference,
            rows: table.rows.iter().map(row).collect::<Result<_, _>>()?,
            left_out: table
                .left_out
                .iter()
                .map(|(method, because)| LeftOut {
                    method: method.to_string(),
                    because: because.clone(),
                })
                .collect(),
        })
    }
}

impl Serialize for PaperOutcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl Serialize for ExactOutcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
