//! A log of the device in the scene, audited.

use num_traits::{ToPrimitive as _, Zero as _};
use passivity_audit::{Dialect, Finding, Force, Form, Observer, Options, Report, Verdict, audit};
use passivity_core::{BigRational, Effect, Exact, Interval};
use passivity_scene::check::{check, enclosure};
use passivity_scene::display::{approx, range};
use passivity_scene::{Motion, Scene};
use serde_json::{Value, json};

use super::{Observed, Outcome, Recording, Source};
use crate::error::CaseError;
use crate::study::Study;

/// A log with its audit.
#[derive(Clone, Debug)]
pub struct Log {
    /// Which one it is, from 1.
    pub number: usize,
    /// The file.
    pub source: Source,
    /// The audit, without rows.
    pub report: Report,
    /// How long the log is, from its first sample to its last, in sampling periods: at least, and at
    /// most.
    pub duration: [BigRational; 2],
    /// Whether the log says so itself; if not, every interval counts as one period.
    pub is_timed: bool,
    /// Whether the wall is passive at the same speeds with a sampling period as long as the longest interval.
    pub may_be_late: bool,
}

impl Log {
    pub(super) fn read(
        number: usize,
        recording: &Recording,
        study: &Study,
        dialect: &Dialect,
    ) -> Result<Self, CaseError> {
        let (source, audit) = Source::bound(recording, |path| {
            let options = Options {
                dialect: dialect.clone(),
                without_rows: true,
                ..Options::default()
            };
            let found = audit(path, &study.scene, options);
            found.map_err(|error| CaseError::of_log(path, error))
        })?;
        if let Some(error) = audit.error() {
            return Err(CaseError::within(recording.path.as_ref(), error));
        }
        let timed = audit.duration();
        let report = audit.report().clone();
        Ok(Self {
            number,
            source,
            is_timed: timed.is_some(),
            duration: match timed {
                Some(periods) => [periods.clone(), periods],
                None => untimed(&report),
            },
            may_be_late: match &report.timing {
                Some(timing) if timing.late > 0 => is_passive_with(&timing.longest, study),
                _ => true,
            },
            report,
        })
    }

    /// What the audit says, in a line.
    #[must_use]
    pub fn headline(&self) -> String {
        self.report.headline()
    }

    /// How long the log is, in words.
    #[must_use]
    pub fn duration_text(&self, scene: &Scene) -> String {
        let period = scene.given.period.nominal.to_rational();
        let (period, unit) = match (scene.motion, period) {
            (Motion::Linear | Motion::Rotary, Some(period)) => (period, "s"),
            _ => (BigRational::from_integer(1.into()), "sampling periods"),
        };
        let [lo, hi] = self.duration.each_ref().map(|end| end * &period);
        let text = format!("{} {unit}", range(&Interval::hull(lo, hi)));
        match (self.is_timed, &self.report.timing) {
            (true, _) => format!("{text}, by the times in the log"),
            (false, Some(_)) => {
                format!(
                    "{text}, by how long its shortest and its longest intervals last, of which the log tells"
                )
            }
            (false, None) => {
                format!("{text}, by the scene's sampling period: the log has no times")
            }
        }
    }

    /// What is to be known of the file beside its rows: a ledger is none that a device writes.
    #[must_use]
    pub fn form_text(&self) -> Option<&'static str> {
        (self.report.positions == Form::Ledger).then_some(
            "a ledger, as passivity simulate --out writes it of a simulation and passivity audit --out of a log: its \
             positions are in ticks of the loop that it was written for, which may be another, and it is no recording \
             unless a log of the device was audited for it",
        )
    }

    /// What the forces of the log say, in words.
    #[must_use]
    pub fn force_text(&self) -> String {
        let accounted = self.report.not_covered.is_empty();
        match &self.report.force {
            None if !accounted && self.report.account == Force::Law => {
                "none in the log, and the one that acted is not accounted for".to_owned()
            }
            _ if !accounted => {
                "in the log, and the one that acted is not accounted for".to_owned()
            }
            None => {
                "none in the log: the account is of the force that the wall's law commands at the \
                     recorded positions"
                    .to_owned()
            }
            Some(force) if force.compared == 0 => {
                "made of samples before the log in every row, and not compared with the wall's law; the account is of the \
                 force in the log"
                    .to_owned()
            }
            Some(force) if force.agrees => {
                format!(
                    "that of the wall's law in all {} rows, to within the digits that are written and a millionth of it",
                    force.compared
                )
            }
            Some(force) => format!(
                "not that of the wall's law in {} of {} rows; the account is of the force in the log",
                force.mismatches, force.compared
            ),
        }
    }

    /// The findings by which the loop that was recorded is another than the one in the scene.
    pub fn other_loop(&self, scene: &Scene) -> impl Iterator<Item = &Finding> {
        let scale_is_tolerated = self.scale_is_tolerated(scene);
        self.report
            .findings
            .iter()
            .filter(move |finding| match finding.kind {
                "delay" | "sign" | "offset" | "other_force" => true,
                "scale" => !scale_is_tolerated,
                // Forces that may be the law's, velocities, which may be wrong themselves, how the file was read.
                _ => false,
            })
    }

    /// Whether the forces are those of a wall as stiff as the scene's tolerance allows.
    fn scale_is_tolerated(&self, scene: &Scene) -> bool {
        let fit = self.report.force.as_ref().and_then(|force| force.fit);
        let stiffness = &scene.given.stiffness;
        let nominal = stiffness.nominal.enclosure(64);
        let ends = enclosure(&stiffness.value);
        let (Some(fit), Some(nominal), Some(ends)) = (fit, nominal, ends) else {
            return false;
        };
        let near = |x: &BigRational| x.to_f64();
        let (Some(nominal), Some(lo), Some(hi)) =
            (near(nominal.lo()), near(ends.lo()), near(ends.hi()))
        else {
            return false;
        };
        let scaled = fit.scale.abs() * nominal;
        stiffness.has_tolerance() && lo <= scaled && scaled <= hi
    }

    /// What the log comes to as evidence.
    #[must_use]
    pub fn outcome(&self, scene: &Scene) -> Outcome {
        if self.report.verdict == Verdict::Fails {
            return Outcome::Contradicts(self.headline());
        }
        let other: Vec<&str> = self.other_loop(scene).map(|f| f.says.as_str()).collect();
        if !other.is_empty() {
            return Outcome::Contradicts(other.join("; "));
        }
        if self.report.verdict != Verdict::Holds {
            return Outcome::Open(self.headline());
        }
        let unmet = self.observed(scene).into_iter();
        let unmet = unmet.filter(|seen| seen.is_met == Some(false));
        let unmet = unmet.map(|seen| format!("the assumption {} is not met", seen.assumption));
        let why: Vec<String> = self.untold().into_iter().chain(unmet).collect();
        match why.is_empty() {
            true => Outcome::Supports,
            false => Outcome::Open(why.join("; ")),
        }
    }

    /// Whether no work was done whatever the force is, as of a device that never touched the wall, or never moved.
    fn is_without_work(&self) -> bool {
        let is_zero = |of: &Observer| of.energy.is_zero() && of.least.is_zero();
        let totals = &self.report.totals;
        let generated = totals.generated_linear.as_ref();
        // What came in may also have gone out again, to the last digit.
        let has_generated = generated.is_none_or(|of| !of.lo().is_zero() || !of.hi().is_zero());
        let has_moved = !totals.dissipated_lower.lo().is_zero();
        self.report.observer.as_ref().is_some_and(is_zero) && !(has_generated && has_moved)
    }

    /// Why the log does not show that the wall is the scene's: there was no force, or no motion, or the forces are near its
    /// law and beyond their digits from it, or agree with it to within digits that say nothing.
    fn untold(&self) -> Option<String> {
        let mut findings = self.report.findings.iter();
        if let Some(near) = findings.find(|finding| finding.kind == "near_force") {
            return Some(near.says.clone());
        }
        let force = self.report.force.as_ref();
        if force.is_some_and(|force| force.compared == 0) {
            return Some(
                "every force is made of samples before the log: the log says nothing about the wall"
                    .to_owned(),
            );
        }
        let told = force.filter(|force| force.agrees || force.rough || force.zero);
        match told.map(|force| (force.fit, force.rough)) {
            Some((None, _)) => Some(
                "the force, or that of the wall's law, is zero in every row: the log says nothing about \
                 the wall"
                    .to_owned(),
            ),
            Some((Some(_), true)) => Some(
                "the force is written with too few digits to tell it from that of another wall".to_owned(),
            ),
            _ if self.is_without_work() => Some(
                "the force did no work: it is zero wherever the device moves, or the device does not move: the \
                 log says nothing about the wall"
                    .to_owned(),
            ),
            _ => None,
        }
    }

    /// What the log says of assumptions.
    pub(super) fn observed(&self, scene: &Scene) -> Vec<Observed> {
        let name = &self.source.name;
        let mut all = Vec::new();
        let mut see = |assumption, is_met, says: String| {
            all.push(Observed {
                assumption,
                is_met: Some(is_met),
                says: format!("«{name}»: {says}"),
            });
        };
        let totals = &self.report.totals;
        let all_of = self.report.intervals;
        match (totals.criterion_fails, totals.criterion_depends) {
            (0, 0) => see(
                "A-SPEED",
                true,
                format!("the criterion holds at the speed of each of the {all_of} intervals"),
            ),
            (0, _) => {}
            (fails, _) => see(
                "A-SPEED",
                false,
                format!("the criterion fails at the speed of {fails} of {all_of} intervals"),
            ),
        }
        if let Some(timing) = &self.report.timing {
            let longest = approx(&timing.longest);
            match (timing.late, is_within_period(&timing.longest, scene)) {
                (0, _) => see(
                    "A-SAMPLING",
                    true,
                    "no interval lasts longer than the sampling period".to_owned(),
                ),
                (_, true) => see(
                    "A-SAMPLING",
                    true,
                    format!(
                        "no interval lasts longer than the tolerance of the sampling period allows \
                         (the longest {longest} periods)"
                    ),
                ),
                (late, false) if self.may_be_late => see(
                    "A-SAMPLING",
                    true,
                    format!(
                        "{late} of {all_of} intervals last longer than the sampling period, the longest {longest} \
                         periods; the verdict is the same with a tolerance of the period that allows them"
                    ),
                ),
                (late, false) => see(
                    "A-SAMPLING",
                    false,
                    format!(
                        "{late} of {all_of} intervals last longer than the sampling period, the \
                         longest {longest} periods"
                    ),
                ),
            }
        }
        let agrees = self.report.force.as_ref().filter(|force| force.agrees);
        if let (Some(force), None) = (agrees, self.untold()) {
            let says = format!(
                "the recorded force is that of the wall's law in all {} rows",
                force.compared
            );
            see("A-LAW", true, says);
        }
        all
    }

    /// The log for programs.
    #[must_use]
    pub fn to_json(&self, scene: &Scene) -> Value {
        let [lo, hi] = &self.duration;
        json!({
            "source": self.source,
            "duration_periods": { "lo": lo.to_string(), "hi": hi.to_string(), "approx": lo.to_f64() },
            "duration_is_recorded": self.is_timed, "headline": self.headline(),
            "evidence": self.outcome(scene).to_json(), "audit": self.report,
        })
    }
}

/// Between how many periods a log without times lasts: a ledger says how long its intervals are.
fn untimed(report: &Report) -> [BigRational; 2] {
    let count = BigRational::from_integer(report.intervals.into());
    match &report.timing {
        Some(timing) => [&timing.shortest, &timing.longest].map(|end| end * &count),
        None => [count.clone(), count],
    }
}

/// Whether the wall is passive, at the same speeds, with a tolerance of the period that allows an interval of so many.
///
/// A tolerance is of a period that is the same throughout, by which virtual damping and filters divide; of a late sample they
/// divide by the period that they were made for. So nothing is said of what depends on the period.
fn is_passive_with(longest: &BigRational, study: &Study) -> bool {
    const FOLLOW_THE_PERIOD: [Effect; 6] = [
        Effect::Damping,
        Effect::DampingFilter,
        Effect::Controller,
        Effect::Latency,
        Effect::Amplifier,
        Effect::Arm,
    ];
    if FOLLOW_THE_PERIOD
        .iter()
        .any(|effect| study.scene.has(*effect))
    {
        return false;
    }
    let mut scene = study.scene.clone();
    let period = &mut scene.given.period;
    let longest = period.nominal.clone() * Exact::of(longest);
    period.value = Interval::hull(period.value.lo().clone(), longest);
    let (own, now) = (study.report(), check(&scene));
    now.verdict == passivity_scene::check::Verdict::Passive
        && study.is_passive()
        && (now.at_every_speed || !own.at_every_speed)
}

/// Whether an interval of so many periods is within the period's tolerance.
fn is_within_period(longest: &BigRational, scene: &Scene) -> bool {
    let period = &scene.given.period;
    let (Some(nominal), Some(ends)) = (period.nominal.to_rational(), enclosure(&period.value))
    else {
        return false;
    };
    longest * nominal <= *ends.hi()
}
