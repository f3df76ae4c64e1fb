//! The report of an audit, for programs and people.

use passivity_core::BigRational;
use passivity_scene::{Effect, Scene};
use serde::{Serialize, Serializer};

use crate::audit::account::{Place, Point};
use crate::audit::certificate::Certificate;
use crate::audit::comparison::Comparison;
use crate::audit::error::TraceError;
use crate::audit::layout::Form;
use crate::audit::merge::{Findings, ROWS_IN_REPORT};
use crate::audit::running::{Lowest, RunningSum};
use crate::audit::step::undefined;
use crate::audit::supply::{is_below_zero, potential};
use crate::audit::worker::Task;
use crate::json::{NumberedRow, rational};
use crate::ledger::Ledger;
use crate::run::{Tallies, Totals, tightened};
use crate::sum::FigureSum;

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
    /// The effects that no theorem covers.
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
    /// The interval with the least net energy.
    pub worst: Option<Shown>,
    /// The first interval that violates the linear account.
    pub first_violation: Option<Shown>,
    /// The first interval of each kind.
    pub first: Firsts,
    /// The passivity observer.
    pub observer: Observer,
    /// How evenly the trace was sampled; `None` when it does not say.
    pub timing: Option<Sampling>,
    /// How the forces of the trace agree with the wall's law; `None` without forces.
    pub force: Option<Agreement>,
    /// The rows of a short trace; `None` of a longer one, whose rows go to a file.
    pub rows: Option<Vec<NumberedRow>>,
    /// Whether the last row lacks its line break.
    pub last_row_unended: bool,
    /// What is wrong with the trace; the account is that of what came before.
    pub error: Option<TraceError>,
}

/// How low energies ran, in KΔ².
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Running {
    /// Σ of net energy, at the least.
    pub net_linear: Least,
    /// What the operator has put in; `None` of an empty trace.
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
    /// How far below the floor it surely was at the lowest, where it was.
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

/// A delay and a scale.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fitted {
    /// In samples.
    pub delay: usize,
    /// How many times the law's force the forces are, by least squares.
    pub scale: f64,
    /// What is left, of the size of the forces: 0 when they are that multiple exactly.
    pub residual: f64,
}

/// A report, with what it is not made of: the course of the energy and the tallies of the rows.
#[derive(Clone, Debug)]
pub struct Audit {
    report: Report,
    points: Vec<Point>,
    tallies: Tallies,
    certificate: Option<Certificate>,
}

impl Audit {
    pub(crate) fn new(
        task: &Task<'_>,
        scene: &Scene,
        findings: Findings<'_>,
    ) -> Result<Self, TraceError> {
        let account = findings.account;
        let mut figures = account.sums.each_ref().map(FigureSum::value);
        let law_of_counts =
            task.ledger.is_plain() && task.layout.form == Form::Count && !task.applied;
        if let (true, Some(last)) = (law_of_counts, &account.last) {
            figures = tightened(figures, last).ok_or_else(undefined)?;
        }
        let totals = Totals::new(account.intervals, figures, &account.tallies);
        let (net, net_at) = account.net.least();
        let lowest = match task.running {
            true => account.supply.lowest(),
            false => [account.stored.as_ref(), None],
        };
        let supply = match &findings.first {
            Some(first) => {
                let [_, stored] = potential(task.ledger, first).ok_or_else(undefined)?;
                Some(Supplied::new(lowest, &stored.to_rational()))
            }
            None => None,
        };
        let agreement = match &findings.comparison {
            Some(comparison) => Some(Agreement::new(comparison).ok_or_else(undefined)?),
            None => None,
        };
        let is_its_law = !task.applied || agreement.as_ref().is_some_and(|a| a.agrees);
        let judged = match is_its_law && !task.ledger.has_memory() {
            true => Judged::Interval,
            false => Judged::Running,
        };
        let shown = |place: Option<&Place>| place.map(|p| Shown::new(task.ledger, p)).transpose();
        let [
            linear,
            possible_linear,
            quantized,
            possible_quantized,
            criterion,
        ] = account.firsts.each_ref().map(Option::as_ref);
        let nominal = taken_as_nominal(scene, task);
        let certificate = match linear {
            // Of a scene with an effect that is left out, the account is not that of the loop.
            Some(place) if scene.unaccounted().is_empty() => {
                let found = Certificate::new(&scene.name, nominal.clone(), task.ledger, place);
                Some(found.ok_or_else(undefined)?)
            }
            _ => None,
        };
        let verdict = match (&findings.error, judged) {
            (Some(_), _) => Verdict::Broken,
            (None, _) if !scene.unaccounted().is_empty() => Verdict::NotCovered,
            (None, Judged::Interval) => of_intervals(&totals),
            (None, Judged::Running) => of_supply(lowest),
        };
        let report = Report {
            scene: scene.name.clone(),
            positions: task.layout.form,
            verdict,
            judged,
            account: match task.applied {
                true => Force::Applied,
                false => Force::Law,
            },
            effects: scene.effects(),
            not_covered: scene.unaccounted(),
            nominal,
            samples: findings.samples,
            intervals: account.intervals,
            running: Running {
                net_linear: Least {
                    least: net,
                    after: net_at,
                },
                supply,
            },
            worst: shown(account.worst.as_ref().map(|(_, place)| place))?,
            first_violation: shown(linear)?,
            first: Firsts {
                linear: shown(linear)?,
                possible_linear: shown(possible_linear)?,
                quantized: shown(quantized)?,
                possible_quantized: shown(possible_quantized)?,
                criterion: shown(criterion)?,
            },
            observer: Observer::new(&account.observer),
            timing: account.timing.range.map(|[shortest, longest]| Sampling {
                uneven: account.timing.uneven,
                late: account.timing.late,
                missed_samples: account.timing.missed,
                first_missed_row: account.timing.first_missed.map(|h| h + 1),
                shortest: shortest.to_rational(),
                longest: longest.to_rational(),
            }),
            force: agreement,
            rows: rows(task, &findings.head, totals.intervals)?,
            last_row_unended: findings.unended,
            error: findings.error,
            totals,
        };
        Ok(Self {
            report,
            points: account.points,
            tallies: account.tallies,
            certificate,
        })
    }

    /// What the audit says.
    #[must_use]
    pub const fn verdict(&self) -> Verdict {
        self.report.verdict
    }

    /// All that was found.
    #[must_use]
    pub const fn report(&self) -> &Report {
        &self.report
    }

    /// The sums over all intervals, and how many of them broke what.
    #[must_use]
    pub const fn totals(&self) -> &Totals {
        &self.report.totals
    }

    /// How often the criterion held and the accounts were violated.
    #[must_use]
    pub const fn tallies(&self) -> &Tallies {
        &self.tallies
    }

    /// What is wrong with the trace; the account is that of what came before.
    #[must_use]
    pub const fn error(&self) -> Option<&TraceError> {
        self.report.error.as_ref()
    }

    /// The first violated interval with all that its figures follow from; `None` when no interval
    /// is violated, or when the scene has an effect that the account leaves out.
    #[must_use]
    pub const fn certificate(&self) -> Option<&Certificate> {
        self.certificate.as_ref()
    }

    /// The course of the energy, for a plot; empty unless it was asked for.
    #[must_use]
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The report as a JSON object.
    #[must_use]
    pub fn to_json(&self) -> serde_json::Value {
        match serde_json::to_value(&self.report) {
            Ok(value) => value,
            Err(error) => unreachable!("a report has nothing that JSON cannot hold: {error}"),
        }
    }

    /// The report as text, for people.
    #[must_use]
    pub fn to_text(&self) -> String {
        self.report.to_text()
    }
}

/// In no interval more was generated than friction surely takes; in some; perhaps.
const fn of_intervals(totals: &Totals) -> Verdict {
    match (totals.violates_linear, totals.depends_linear) {
        (0, 0) => Verdict::Holds,
        (0, _) => Verdict::Depends,
        _ => Verdict::Fails,
    }
}

/// The operator has surely never drawn more than was stored at the start; surely has; perhaps.
fn of_supply([least, most]: [Option<&Lowest>; 2]) -> Verdict {
    match (is_below_zero(least), is_below_zero(most)) {
        (_, true) => Verdict::Fails,
        (true, false) => Verdict::Depends,
        (false, false) => Verdict::Holds,
    }
}

impl Supplied {
    /// From the lowest that was left of what was stored at the start, at the least and at the most.
    fn new([least, most]: [Option<&Lowest>; 2], stored: &BigRational) -> Self {
        use num_traits::{Signed as _, Zero as _};
        // At the start it is zero.
        let supplied = least.map(|lowest| (&lowest.value - stored, lowest.h));
        let below = supplied.filter(|(value, _)| value.is_negative());
        let (least, after) = below.unwrap_or_else(|| (BigRational::zero(), 0));
        let surely = most.filter(|most| most.value.is_negative());
        Self {
            least,
            after,
            floor: -stored,
            surely_drawn: surely.map(|most| -&most.value),
            surely_drawn_after: surely.map(|most| most.h),
        }
    }
}

impl Shown {
    fn new(ledger: &Ledger, place: &Place) -> Result<Self, TraceError> {
        let row = ledger.row(&place.interval).ok_or_else(undefined)?;
        let h = place.h;
        Ok(Self {
            h,
            row: h + 1,
            ledger: NumberedRow { h, row },
        })
    }
}

impl Observer {
    fn new(sum: &RunningSum) -> Self {
        use num_traits::Signed as _;
        let energy = sum.total();
        let (least, after) = sum.least();
        let approx = passivity_scene::number::nearest_f64(&energy);
        Self {
            energy,
            approx: Some(approx).filter(|x| x.is_finite()),
            after,
            says: match least.is_negative() {
                true => "active",
                false => "passive",
            },
            least,
        }
    }
}

impl Agreement {
    fn new(comparison: &Comparison<'_>) -> Option<Self> {
        let (own, best) = (comparison.as_scene_says()?, comparison.best()?);
        Some(Self {
            compared: comparison.compared,
            agrees: own.mismatches == 0,
            mismatches: own.mismatches,
            first_mismatch_row: own.first.map(|row| row + 1),
            delay: comparison.delay,
            found: Found {
                delay: best.lag,
                reversed: best.reversed,
                mismatches: best.mismatches,
            },
            fit: comparison.fit().map(|fit| Fitted {
                delay: fit.lag,
                scale: fit.scale,
                residual: fit.residual,
            }),
        })
    }
}

/// The rows of a short trace.
fn rows(
    task: &Task<'_>,
    head: &[crate::Logged],
    intervals: u64,
) -> Result<Option<Vec<NumberedRow>>, TraceError> {
    if intervals > ROWS_IN_REPORT as u64 {
        return Ok(None);
    }
    let numbered = (0..).zip(head).map(|(h, interval)| {
        let row = task.ledger.row(interval).ok_or_else(undefined)?;
        Ok(NumberedRow { h, row })
    });
    numbered.collect::<Result<_, _>>().map(Some)
}

/// The parameters with a tolerance that the audit takes at their nominal value: those that scale
/// the trace or shape the law. Friction is taken over its whole tolerance.
fn taken_as_nominal(scene: &Scene, task: &Task<'_>) -> Vec<&'static str> {
    let given = &scene.given;
    let of_force = [Some(&given.stiffness), given.resolution.as_ref()];
    let of_force = of_force.map(|given| given.filter(|_| task.applied));
    let law = [&given.damping, &given.max_force, &given.force_step].map(Option::as_ref);
    let used = law.into_iter().chain(of_force).flatten();
    used.filter(|given| given.has_tolerance())
        .map(|given| given.key)
        .collect()
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
