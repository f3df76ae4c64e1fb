//! The outcome of an audit: its report, made of what was found.

use passivity_core::{BigRational, Scalar as _};
use passivity_scene::Scene;

use crate::json::NumberedRow;
use crate::ledger::Ledger;
use crate::log::account::{Place, Point};
use crate::log::certificate::Certificate;
use crate::log::comparison::Comparison;
use crate::log::error::TraceError;
use crate::log::findings::{Finding, leave_open, of_clock, of_force, of_stored};
use crate::log::found::Findings;
use crate::log::layout::Form;
use crate::log::report::{
    Agreement, ByLaw, Drawn, Firsts, Force, Found, Judged, Least, Observer, Report, Running,
    Sampling, Shown, Supplied, UnendedRow, Verdict,
};
use crate::log::running::RunningSum;
use crate::log::step::undefined;
use crate::log::supply::potential;
use crate::log::task::Task;
use crate::log::velocity::Velocities;
use crate::number::Number;
use crate::reading::GRID_BITS;
use crate::run::{Tallies, Totals, tightened};
use crate::sum::FigureSum;

/// A report, with what it is not made of: the course of the energy and the tallies of the rows.
#[derive(Clone, Debug)]
pub struct Audit {
    report: Report,
    points: Vec<Point>,
    tallies: Tallies,
    certificate: Option<Certificate>,
    duration: Option<Number>,
}

impl Audit {
    pub(crate) fn new(
        task: &Task<'_>,
        scene: &Scene,
        findings: Findings,
        (law, rows): (Option<Self>, Option<Vec<NumberedRow>>),
    ) -> Result<Self, TraceError> {
        let account = findings.account;
        let mut figures = account.sums.each_ref().map(FigureSum::value);
        let law_of_counts =
            task.ledger.is_plain() && task.layout.form == Form::Count && !task.applied;
        if let (true, Some(last)) = (law_of_counts, &account.last) {
            let last = task.ledger.row(last).ok_or_else(undefined)?;
            figures = tightened(figures, &last).ok_or_else(undefined)?;
        }
        let totals = Totals::new(account.intervals, figures, &account.tallies);
        let (net, net_at) = account.net.least();
        let lowest = match task.running {
            true => account.supply.lowest(),
            false => [account.stored.as_ref(), None],
        };
        let mut lowest = lowest.map(|lowest| lowest.map(|lowest| (lowest.value(), lowest.h)));
        let mut open = BigRational::zero();
        let supply = match &findings.first {
            Some(first) => {
                let stored = potential(task.ledger, first).ok_or_else(undefined)?;
                let [least, most] = stored.map(|stored| stored.to_rational());
                open = left_open(task.layout.form, [&least, &most], account.intervals);
                // A spring that is so much stiffer than the wall's stores so much more.
                let more = stiffness_at_rest(scene) - BigRational::one();
                let mut beyond = [least, most.clone()].map(|stored| stored * &more);
                beyond.sort();
                for (lowest, beyond) in lowest.iter_mut().flatten().zip(&beyond) {
                    lowest.0 += beyond;
                }
                Some(Supplied::new(&lowest, &(most + &beyond[0]), task.running))
            }
            None => None,
        };
        let agreement = match &findings.comparison {
            Some(comparison) => Some(Agreement::new(comparison).ok_or_else(undefined)?),
            None => None,
        };
        let moved = findings.velocities.as_ref().map(Velocities::moved);
        let forced = agreement
            .iter()
            .flat_map(|a| of_force(a, task.layout, scene));
        let compared = findings.velocities.as_ref().zip(moved.as_ref());
        let moving = compared.and_then(|(of, moved)| of.finding(moved, task.layout.form));
        let found = task.layout.beside.finding.clone().into_iter().chain(forced);
        let clock = of_clock(&account.timing, account.intervals);
        // The energy of its spring is counted from there.
        let must = ", so that it is 0 where the wall begins";
        let wrapped = findings.wrapped.finding(task.layout, &task.periods, must);
        let counted = findings.steps.finding(task.layout);
        let force = task.layout.force.map(|column| task.layout.name(column));
        let held = findings.held.findings(&force.unwrap_or_default());
        let found = found
            .chain(clock)
            .chain(held)
            .chain(moving)
            .chain(wrapped)
            .chain(counted);
        let mut found: Vec<Finding> = found.collect();
        let is_its_law = !task.applied || agreement.as_ref().is_some_and(|a| a.agrees);
        let judged = match is_its_law && !task.ledger.has_memory() {
            true => Judged::Interval,
            false => Judged::Running,
        };
        let unaccounted = scene.unaccounted(task.applied);
        let accounted = unaccounted.is_empty();
        let shown = |place: Option<&Place>| {
            let shown = place.map(|p| Shown::new(task.ledger, p, accounted));
            shown.transpose()
        };
        // Of a force that is not the one that acted nothing is said.
        let of_force = |place: Option<&Place>| shown(place.filter(|_| accounted));
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
            Some(place) if accounted => {
                let found = Certificate::new(&scene.name, nominal.clone(), task.ledger, place);
                Some(found.ok_or_else(undefined)?)
            }
            _ => None,
        };
        let verdict = match (&findings.error, judged) {
            (Some(_), _) => Verdict::Broken,
            (None, _) if !accounted => Verdict::NotCovered,
            (None, Judged::Interval) => of_intervals(&totals),
            (None, Judged::Running) => of_supply(&lowest),
        };
        // Zero forces give nothing.
        let is_another = agreement.as_ref().is_some_and(|a| !a.agrees && !a.zero);
        if let (Verdict::Holds, true, Some(supply)) = (verdict, task.applied && is_another, &supply)
            && -&supply.least > open
        {
            found.push(of_stored(supply, task.layout.form, scene));
        }
        let [law_open, own_open] =
            [false, task.applied].map(|applied| leave_open(&found, agreement.as_ref(), applied));
        let opened = |verdict: Verdict, is_open: bool| match verdict {
            Verdict::Holds if is_open => Verdict::Depends,
            verdict => verdict,
        };
        let mut unended_rows = findings.unended_rows;
        if findings.unended {
            let row = findings.samples - findings.before_file;
            let file = findings.file;
            unended_rows.push(UnendedRow { file, row });
        }
        let report = Report {
            scene: scene.name.clone(),
            motion: scene.motion,
            positions: task.layout.form,
            verdict: opened(verdict, own_open),
            judged,
            account: match task.applied {
                true => Force::Applied,
                false => Force::Law,
            },
            effects: scene.effects(),
            not_covered: unaccounted,
            nominal,
            samples: findings.samples,
            intervals: account.intervals,
            running: Running {
                net_linear: accounted.then_some(Least {
                    least: net,
                    after: net_at,
                }),
                supply: supply.filter(|_| accounted),
            },
            worst: of_force(account.worst.as_ref().map(|(_, place)| place))?,
            first_violation: of_force(linear)?,
            first: Firsts {
                linear: of_force(linear)?,
                possible_linear: of_force(possible_linear)?,
                quantized: of_force(quantized)?,
                possible_quantized: of_force(possible_quantized)?,
                criterion: shown(criterion)?,
            },
            observer: accounted.then(|| Observer::new(&account.observer)),
            timing: account.timing.range.map(|[shortest, longest]| Sampling {
                uneven: account.timing.uneven,
                late: account.timing.late,
                missed_samples: account.timing.missed,
                first_missed_row: account.timing.first_missed.map(|h| h + 1),
                shortest: shortest.to_rational(),
                longest: longest.to_rational(),
            }),
            force: agreement,
            law: law.map(|law| ByLaw {
                verdict: opened(law.report.verdict, law_open),
                judged: law.report.judged,
                totals: law.report.totals,
            }),
            velocity: moved,
            findings: found,
            columns: task.layout.typed(false).filter(|_| task.told),
            not_read: task.layout.not_read(),
            rows,
            last_row_unended: findings.unended,
            unended_rows,
            error: findings.error,
            totals: match accounted {
                true => totals,
                false => totals.of_positions(),
            },
        };
        Ok(Self {
            duration: findings.duration,
            report,
            points: match accounted {
                true => account.points,
                false => Vec::new(),
            },
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

    /// How often the criterion held and the accounts were violated; those of a log that is not accounted for are of a force
    /// that is not the one that acted.
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

    /// How long the trace is, from the first sample's time to the last one's, in sampling periods; `None`
    /// of a trace without times, and of one that was audited in pieces.
    #[must_use]
    pub fn duration(&self) -> Option<BigRational> {
        self.duration.as_ref().map(Number::to_rational)
    }

    /// The course of the energy, for a plot; empty unless it was asked for, and of a log that is not accounted for.
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
        (Some(0), Some(0)) => Verdict::Holds,
        (Some(0), _) => Verdict::Depends,
        _ => Verdict::Fails,
    }
}

/// H(1), what the loop's spring is as stiff as once everything has come to rest (TH-LTI): that of the wall, where no
/// controller says otherwise.
fn stiffness_at_rest(scene: &Scene) -> BigRational {
    let controller = scene.point().at.controller;
    controller.map_or_else(BigRational::one, |controller| controller.at_one())
}

/// The lowest that was left of what was stored at the start, taken at the least and at the most, and after how many
/// intervals that was.
type Lowest = [Option<(BigRational, u64)>; 2];

/// The operator has surely never drawn more than was stored at the start; surely has; perhaps.
fn of_supply(lowest: &Lowest) -> Verdict {
    use num_traits::Signed as _;
    let is_below_zero = |(value, _): &(BigRational, u64)| value.is_negative();
    let [least, most] = lowest
        .each_ref()
        .map(|lowest| lowest.as_ref().is_some_and(is_below_zero));
    match (least, most) {
        (_, true) => Verdict::Fails,
        (true, false) => Verdict::Depends,
        (false, false) => Verdict::Holds,
    }
}

/// What rounding leaves open of what was drawn from nothing stored, where between these two was stored at the start.
///
/// The energy at the end of a device that rests is that of the same number as at its start, enclosed: so much is not held
/// against it. Counts leave open where in a tick it was. With them the change of a force counts (see
/// [`supply`](crate::log::supply)), of which each end is enclosed in an interval.
fn left_open(form: Form, [least, most]: [&BigRational; 2], intervals: u64) -> BigRational {
    /// Some thirty roundings of doubles, and some sixteen of the grid that sums are on.
    const SHARE: u32 = 48;
    const GRID: u32 = 60;
    let part = |bits: u32| BigRational::new(1.into(), (1_i64 << bits).into());
    let enclosed = match form {
        // And what a spring stores within a tick, half of KΔ²: so much is open of a device that starts where the wall begins.
        Form::Count => {
            part(1) + part(GRID_BITS - 1) * BigRational::from_integer((intervals + 1).into())
        }
        Form::Xi | Form::X | Form::Ledger => most - least,
    };
    enclosed + most * part(SHARE) + part(GRID)
}

impl Supplied {
    /// From the lowest that was left of what was stored at the start, of which the latter is known where it is asked for.
    fn new([least, most]: &Lowest, stored: &BigRational, most_is_known: bool) -> Self {
        use num_traits::Signed as _;
        // At the start it is zero.
        let supplied = least.as_ref().map(|(value, h)| (value - stored, *h));
        let below = supplied.filter(|(value, _)| value.is_negative());
        let (least, after) = below.unwrap_or_else(|| (BigRational::zero(), 0));
        let surely = most.as_ref().filter(|(value, _)| value.is_negative());
        Self {
            least,
            after,
            floor: -stored,
            drawn: most_is_known.then(|| Drawn {
                surely_drawn: surely.map(|(value, _)| -value),
                surely_drawn_after: surely.map(|(_, h)| *h),
            }),
        }
    }
}

impl Shown {
    fn new(ledger: &Ledger, place: &Place, accounted: bool) -> Result<Self, TraceError> {
        let row = ledger.row(&place.interval).ok_or_else(undefined)?;
        let h = place.h;
        Ok(Self {
            h,
            row: h + 1,
            ledger: NumberedRow { h, row, accounted },
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
    fn new(comparison: &Comparison) -> Option<Self> {
        let (own, best) = (comparison.as_scene_says()?, comparison.best()?);
        let compared = comparison.compared - comparison.left_out(comparison.delay);
        let has_none = compared > 0 && own.mismatches == 0;
        Some(Self {
            compared,
            agrees: has_none && !comparison.is_far(),
            rough: has_none && comparison.is_far(),
            zero: comparison.is_zero(),
            mismatches: own.mismatches,
            first_mismatch_row: own.first.map(|row| row + 1),
            delay: comparison.delay,
            found: Found {
                delay: best.lag,
                reversed: best.reversed,
                mismatches: best.mismatches,
            },
            fit: comparison.fit(),
            difference: comparison.difference(),
            edge: comparison.edge(),
            rounding: Some(comparison.rounding()).filter(|by| by.is_finite()),
        })
    }
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
