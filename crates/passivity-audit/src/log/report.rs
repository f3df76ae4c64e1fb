//! The report of an audit, for programs and people.

use passivity_core::BigRational;
use passivity_scene::{Effect, Motion};
use serde::{Serialize, Serializer};

use crate::json::{NumberedRow, rational};
use crate::log::error::TraceError;
use crate::log::findings::Finding;
use crate::log::layout::Form;
use crate::run::Totals;

/// What an audit says of a trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Surely no more was generated, or drawn, than may be.
    Holds,
    /// More surely was.
    Fails,
    /// The counts, or the tolerances, leave it open.
    Depends,
    /// The scene has an effect that the account of a log leaves out.
    NotCovered,
    /// The trace is broken: the account ends there.
    Broken,
}

/// Whose force an account is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Force {
    /// That of the scene's controller.
    Law,
    /// That of the trace.
    Applied,
}

/// What a verdict is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Judged {
    /// Each interval: what was generated against what friction took. Of a loop without memory and
    /// under its own force, whose intervals the criterion speaks of.
    Interval,
    /// The trace so far: what the operator has drawn against what was stored at the start (TH-RUN).
    Running,
}

/// The exact account of a trace.
///
/// Serialised it is `audit --format json`.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// The scene's name.
    pub scene: String,
    /// How the device moves: it fixes the units of people's text.
    #[serde(skip)]
    pub motion: Motion,
    /// In what form the trace gives positions.
    #[serde(serialize_with = "form")]
    pub positions: Form,
    /// What the audit says.
    pub verdict: Verdict,
    /// What that is about.
    pub judged: Judged,
    /// Whose force the account is of.
    pub account: Force,
    /// The effects in the scene.
    #[serde(serialize_with = "effects")]
    pub effects: Vec<Effect>,
    /// The effects for which the log is not accounted for: what is of the force that acted is left out.
    #[serde(serialize_with = "effects")]
    pub not_covered: Vec<Effect>,
    /// The keys of the parameters with a tolerance that were taken at their nominal value.
    pub nominal: Vec<&'static str>,
    /// How many samples.
    pub samples: u64,
    /// How many intervals.
    pub intervals: u64,
    /// The sums over all intervals, and how many of them broke what.
    pub totals: Totals,
    /// How low energies ran.
    pub running: Running,
    /// The interval with the least net energy; `None` of a log that is not accounted for.
    pub worst: Option<Shown>,
    /// The first interval that violates the linear account.
    pub first_violation: Option<Shown>,
    /// The first interval of each kind.
    pub first: Firsts,
    /// The passivity observer; `None` of a log that is not accounted for.
    pub observer: Option<Observer>,
    /// How evenly the trace was sampled; `None` when it does not say.
    pub timing: Option<Sampling>,
    /// How the forces of the trace agree with the wall's law; `None` without forces.
    pub force: Option<Agreement>,
    /// The account of the wall's own law, where the account is of the forces in the trace.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law: Option<ByLaw>,
    /// How the velocities of the trace agree with its positions; `None` without velocities.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub velocity: Option<Moved>,
    /// What stands out, with what puts it right.
    pub findings: Vec<Finding>,
    /// What the columns were told to be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub columns: Option<String>,
    /// The columns that were not read.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_read: Vec<String>,
    /// The rows of a short trace; `None` of a longer one, whose rows go to a file.
    pub rows: Option<Vec<NumberedRow>>,
    /// Whether the last row lacks its line break.
    pub last_row_unended: bool,
    /// The last rows of files that lack their line break, with that of the log.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub unended_rows: Vec<UnendedRow>,
    /// What is wrong with the trace; the account is that of what came before.
    pub error: Option<TraceError>,
}

/// The last row of a file, without a line break: it may be incomplete.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct UnendedRow {
    /// The file, where the log is of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The row of the file, from 1.
    pub row: u64,
}

/// How low energies ran, in KΔ².
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Running {
    /// Σ of net energy, at the least; `None` of a log that is not accounted for.
    pub net_linear: Option<Least>,
    /// What the operator has put in; `None` of an empty trace, and of one that is not accounted for.
    pub supply: Option<Supplied>,
}

/// The least that a running sum was.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Least {
    /// The value.
    #[serde(serialize_with = "rational")]
    pub least: BigRational,
    /// After how many intervals.
    pub after: u64,
}

/// What the operator has put in, less what the device has gained of kinetic energy, in KΔ²: the
/// least that friction took, less the work of the held force.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Supplied {
    /// The least that it was, taken at the least that the trace allows.
    #[serde(serialize_with = "rational")]
    pub least: BigRational,
    /// After how many intervals.
    pub after: u64,
    /// What was stored in the wall at the start, below zero: where it surely is less, the operator
    /// has drawn more than was stored.
    #[serde(serialize_with = "rational")]
    pub floor: BigRational,
    /// What was surely drawn; `None` of the scene's own law without memory, for which no verdict asks for it.
    #[serde(flatten)]
    pub drawn: Option<Drawn>,
}

/// What the operator has surely drawn beyond what was stored at the start, in KΔ².
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Drawn {
    /// How far below the floor the supply surely was at the lowest, where it was.
    #[serde(serialize_with = "optional_rational")]
    pub surely_drawn: Option<BigRational>,
    /// After how many intervals that was.
    pub surely_drawn_after: Option<u64>,
}

/// An interval worth showing.
#[derive(Clone, Debug, Serialize)]
pub struct Shown {
    /// Which interval, from 0.
    pub h: u64,
    /// The row of the trace that it starts at, from 1.
    pub row: u64,
    /// Its ledger row.
    pub ledger: NumberedRow,
}

/// The first interval of each kind.
#[derive(Clone, Debug, Serialize)]
pub struct Firsts {
    /// That violates the linear account.
    pub linear: Option<Shown>,
    /// That may violate it.
    pub possible_linear: Option<Shown>,
    /// That violates the quantized account.
    pub quantized: Option<Shown>,
    /// That may violate it.
    pub possible_quantized: Option<Shown>,
    /// Where the criterion fails.
    pub criterion: Option<Shown>,
}

/// The passivity observer, Σ −F·Δξ.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Observer {
    /// At the end, in KΔ².
    #[serde(serialize_with = "rational")]
    pub energy: BigRational,
    /// The double nearest to it; `None` past the doubles.
    pub approx: Option<f64>,
    /// At the lowest.
    #[serde(serialize_with = "rational")]
    pub least: BigRational,
    /// After how many intervals.
    pub after: u64,
    /// `active` when it was below zero, else `passive`.
    pub says: &'static str,
}

/// How evenly a trace was sampled.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sampling {
    /// Intervals of another length than one period.
    pub uneven: u64,
    /// Intervals longer than one period.
    pub late: u64,
    /// Samples that are missing: whole periods beyond the first, to the nearest.
    pub missed_samples: u64,
    /// The row at which the first one is missing, from 1.
    pub first_missed_row: Option<u64>,
    /// The shortest interval, in periods.
    #[serde(serialize_with = "rational")]
    pub shortest: BigRational,
    /// The longest interval, in periods.
    #[serde(serialize_with = "rational")]
    pub longest: BigRational,
}

/// How the forces of a trace agree with the wall's law.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Agreement {
    /// How many forces were compared.
    pub compared: u64,
    /// Whether all of them are the law's.
    pub agrees: bool,
    /// Whether they are so only because they are written with too few digits to tell them from others.
    pub rough: bool,
    /// Whether they are zero in every row, and those of the law are not.
    pub zero: bool,
    /// How many are not.
    pub mismatches: u64,
    /// The row of the first that is not, from 1.
    pub first_mismatch_row: Option<u64>,
    /// The delay of the scene, in samples.
    pub delay: usize,
    /// The delay and sign at which they agree best.
    pub found: Found,
    /// The multiple of the law, at some delay, that they come nearest to; `None` when forces or law
    /// are zero throughout.
    pub fit: Option<Fitted>,
    /// How far they are from the law, of their own size, as a root of the mean square; `None` when they are zero
    /// throughout.
    pub difference: Option<f64>,
    /// How much of that their last digits can be.
    #[serde(skip)]
    pub rounding: Option<f64>,
    /// By how much all forces are off the law where that is half of their last digit, always to the same side, in KΔ.
    #[serde(skip)]
    pub edge: Option<f64>,
}

/// A delay and a sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Found {
    /// In samples.
    pub delay: usize,
    /// Whether the forces are the law's with the other sign.
    pub reversed: bool,
    /// How many are not.
    pub mismatches: u64,
}

/// What the account of the wall's own law says of a trace with forces.
#[derive(Clone, Debug, Serialize)]
pub struct ByLaw {
    /// What it says.
    pub verdict: Verdict,
    /// What that is about.
    pub judged: Judged,
    /// The sums over all intervals, and how many of them broke what.
    pub totals: Totals,
}

/// How the velocities of a trace agree with its positions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Moved {
    /// How many velocities were compared.
    pub compared: u64,
    /// Whether they are zero throughout, while the positions move.
    pub zero: bool,
    /// The multiple of the mean velocities between samples that they come nearest to; `None` when nothing
    /// moved.
    pub fit: Option<Fitted>,
    /// The multiple over 64 samples together, of which ticks and noise are a smaller part; `None` of fewer than 256 velocities, and
    /// where less than a tick was moved in that time, on average.
    pub long_fit: Option<Fitted>,
}

/// A delay, a scale and where the wall is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fitted {
    /// In samples.
    pub delay: usize,
    /// How many times what they should be the forces or velocities are, by least squares.
    pub scale: f64,
    /// By how many ticks the wall would have to be moved for that; zero for velocities, and where it need not be.
    #[serde(skip_serializing_if = "is_zero")]
    pub moved: f64,
    /// What is left, of their own size: 0 when they are that multiple exactly.
    pub residual: f64,
}

impl Fitted {
    /// The multiple of what they should be that forces or velocities x come nearest to, by Σ x², Σ x·y and Σ y².
    pub(crate) fn nearest(delay: usize, [squares, mixed, own]: [f64; 3]) -> Option<Self> {
        let scale = mixed / own;
        // What is left of Σ x²; rounding may leave it a little below zero.
        let left = (squares - scale * mixed).max(0.0);
        let residual = (left / squares).sqrt();
        (scale.is_finite() && residual.is_finite()).then_some(Self {
            delay,
            scale,
            moved: 0.0,
            residual,
        })
    }
}

fn form<S: Serializer>(form: &Form, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(form.name())
}

fn effects<S: Serializer>(effects: &[Effect], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(effects.iter().map(|effect| effect.name()))
}

fn optional_rational<S: Serializer>(
    x: &Option<BigRational>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    x.as_ref().map(BigRational::to_string).serialize(serializer)
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "as it is called")]
fn is_zero(x: &f64) -> bool {
    *x == 0.0
}
