//! Friction that is identified from logs, and the scene beside it.

use passivity_audit::{Dialect, Sampled};
use passivity_core::{BigRational, Interval, Parameter, Scalar as _};
use passivity_identify::{
    Bounds, Identified, IdentifyError, LogReport, Options, Provenance, Report, identify,
};
use passivity_scene::check::{Verdict, check, enclosure};
use passivity_scene::{Given, Scene, display, number};
use serde_json::{Value, json};

use super::{Observed, Outcome, Recordings, Source};
use crate::criterion::Criterion;
use crate::error::CaseError;

/// What logs of the free device say of its friction.
#[derive(Clone, Debug)]
pub struct Identification {
    /// The files.
    pub sources: Vec<Source>,
    /// What was identified.
    pub report: Report,
    /// Each parameter beside what the scene says of it.
    pub compared: Vec<Compared>,
    /// The verdict for a scene with the identified ranges in place of its own; `None` where there can be no such
    /// scene.
    pub over: Option<Over>,
    /// Why there can be no such scene.
    pub unwritten: Option<String>,
    /// Why the identified ranges may be wrong.
    pub doubts: Vec<String>,
    /// The verdict of the scene itself.
    own: Over,
}

/// A verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Over {
    /// The verdict.
    pub verdict: Verdict,
    /// Whether it is about every speed.
    pub at_every_speed: bool,
    /// The verdict in a line.
    pub headline: String,
}

/// A parameter as it is identified, beside the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// The parameter.
    pub parameter: Parameter,
    /// The key under which a scene is given what was identified, which is of the device.
    pub key: &'static str,
    /// Another key under which the scene has it, which the identified range takes the place of.
    pub in_place_of: Option<&'static str>,
    /// What the scene file says of it, and what that is at the device where it is said of the motor.
    pub in_scene: String,
    /// What the scene says of it, with its tolerance, at the device and in SI units.
    pub scene: Interval<BigRational>,
    /// The least that it can be, as `range` has it.
    pub lo: BigRational,
    /// The most that it can be, as `range` has it; `None` where nothing bounds it.
    pub hi: Option<BigRational>,
    /// The best estimate.
    pub best: Option<f64>,
    /// The identified range, rounded outwards, as a scene takes it.
    pub range: String,
}

impl Compared {
    /// Whether some value is both in the scene and in the identified range.
    #[must_use]
    pub fn agrees(&self) -> bool {
        let above = self.hi.as_ref().is_some_and(|hi| self.scene.lo() > hi);
        !above && *self.scene.hi() >= self.lo
    }

    /// Whether what the scene says is in the identified range, or the range in that: else the device may have less
    /// friction than any that the scene allows, or more, and the scene some that the device has not.
    fn is_within(&self) -> bool {
        let (lo, hi) = (self.scene.lo(), self.scene.hi());
        let scene_is_inside = *lo >= self.lo && self.hi.as_ref().is_none_or(|most| hi <= most);
        let range_is_inside = *lo <= self.lo && self.hi.as_ref().is_some_and(|most| most <= hi);
        scene_is_inside || range_is_inside
    }

    /// The line of a scene that gives it the identified range.
    #[must_use]
    pub fn line(&self) -> String {
        format!("{} = \"{}\"", self.key, self.range)
    }

    fn of(
        found: &Identified,
        (parameter, known): (Parameter, &Bounds),
        given: Option<&Given>,
        unit: &'static str,
    ) -> Result<Self, CaseError> {
        let undefined = || {
            let name = parameter.row().name;
            CaseError::new(format!(
                "the {name} of the scene, or the identified one, is no number"
            ))
        };
        let range = found.range(parameter, known);
        // As they are printed, and may be typed back into the scene: rounded outwards.
        let words = range
            .split_whitespace()
            .map(|word| word.trim_end_matches(';'));
        let mut ends = words.filter_map(|word| number::parse(word).ok());
        let (lo, hi) = (ends.next().ok_or_else(undefined)?, ends.next());
        let scene = match given {
            // A friction that the scene does not have is zero there.
            None => Interval::point(BigRational::zero()),
            Some(given) => enclosure(&given.value).ok_or_else(undefined)?,
        };
        let key = found.key(parameter);
        let in_scene = match given {
            None => "none".to_owned(),
            Some(given) if given.key.starts_with("motor.") => {
                let at_device = display::range(&scene);
                format!(
                    "{} at the motor ({at_device}{unit} at the device)",
                    given.text
                )
            }
            Some(given) => given.text.clone(),
        };
        Ok(Self {
            parameter,
            key,
            in_place_of: given.map(|given| given.key).filter(|own| *own != key),
            in_scene,
            scene,
            lo,
            hi,
            best: known.best,
            range,
        })
    }
}

impl Over {
    fn of(scene: &Scene) -> Self {
        let report = check(scene);
        Self {
            verdict: report.verdict,
            at_every_speed: report.at_every_speed,
            headline: report.headline(),
        }
    }
}

impl Identification {
    pub(super) fn read(
        given: &Recordings,
        scene: &Scene,
        text: &str,
        dialects: &[Dialect],
        mut progress: impl FnMut(u64, u64),
    ) -> Result<Self, CaseError> {
        let mut sources = Vec::new();
        let mut logs: Vec<Sampled> = Vec::new();
        for (recording, dialect) in given.identification.iter().zip(dialects) {
            let (source, log) = Source::bound(recording, |path| {
                let read = passivity_identify::read(path, scene, dialect);
                read.map_err(|error| CaseError::of_log(path, error))
            })?;
            sources.push(source);
            logs.push(log);
        }
        let rows = logs.iter().map(|log| log.positions.len()).sum();
        let options = Options {
            count_error: given.count_error,
            force_error: given.force_error,
            scale_error: given.scale_error,
            effort: given.effort.unwrap_or_else(|| Options::effort_for(rows)),
            ..Options::default()
        };
        let effort = options.effort;
        let names: Vec<&str> = sources.iter().map(|source| source.name.as_str()).collect();
        let refuse = |error: IdentifyError| {
            let log = error.log().and_then(|log| names.get(log));
            let of = log.map_or_else(|| names.join(", "), ToString::to_string);
            CaseError::new(format!("--identification {of}: {error}"))
        };
        let found = identify(&logs, scene, &options, |done| {
            progress(done, effort);
            true
        })
        .map_err(refuse)?;
        let unwritten = found.unwritten();
        let over = match unwritten {
            Some(_) => None,
            None => {
                let text = found.scene(text, &Provenance::default()).map_err(refuse)?;
                let scene = Scene::from_toml(&scene.name, &text);
                let scene = scene.map_err(|error| CaseError::new(error.to_string()))?;
                Some(Over::of(&scene))
            }
        };
        let files = sources.iter().map(|source| LogReport {
            file: source.path.clone(),
            sha256: source.sha256.to_string(),
        });
        let report = Report::new(scene, &found, files.collect());
        let (viscous_unit, coulomb_unit) = Criterion::of(scene).units();
        let [own_viscous, own_coulomb] = [&scene.given.viscous, &scene.given.coulomb];
        let compared = found.parameters.iter().filter_map(|(parameter, known)| {
            let (own, unit) = match parameter {
                Parameter::Viscous => (own_viscous, viscous_unit),
                Parameter::Coulomb => (own_coulomb, coulomb_unit),
                _ => return None,
            };
            let known = (*parameter, known);
            Some(Compared::of(&found, known, own.as_ref(), unit))
        });
        Ok(Self {
            compared: compared.collect::<Result<_, _>>()?,
            sources,
            report,
            over,
            unwritten,
            doubts: found.doubts(),
            own: Over::of(scene),
        })
    }

    /// The parameters of which no value is both in the scene and in the identified range.
    pub fn outside(&self) -> impl Iterator<Item = &Compared> {
        self.compared.iter().filter(|compared| !compared.agrees())
    }

    /// What the identification comes to as evidence.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        if let Some(refuted) = &self.report.refuted_by {
            return Outcome::Contradicts(format!(
                "no viscous and Coulomb friction fit «{}», rows 1 to {}; it may be: {}",
                self.name_of(&refuted.log),
                refuted.row,
                refuted.suspicion
            ));
        }
        let surely = if self.doubts.is_empty() {
            "surely "
        } else {
            ""
        };
        let outside = self.outside().map(|compared| {
            format!(
                "{} is {} in the scene, and {surely}{} on the device",
                compared.parameter.row().name,
                compared.in_scene,
                compared.range
            )
        });
        let mut why: Vec<String> = outside.collect();
        let is_outside = !why.is_empty();
        if !is_outside {
            why.extend(self.open());
        }
        why.extend(self.doubts.iter().cloned());
        match (is_outside, why.is_empty()) {
            (true, _) => Outcome::Contradicts(why.join("; ")),
            (false, true) => Outcome::Supports,
            (false, false) => Outcome::Open(why.join("; ")),
        }
    }

    /// What the ranges leave open, be they right: the verdict, or whether the device has the scene's friction.
    fn open(&self) -> Vec<String> {
        match &self.over {
            None => {
                let lacks = self.report.lacks.iter();
                let lacks = lacks.filter(|lack| !self.doubts.contains(lack));
                self.unwritten.iter().chain(lacks).cloned().collect()
            }
            Some(over) if self.is_as_own(over) => self.beyond().into_iter().collect(),
            Some(over) => vec![format!(
                "over the identified ranges the verdict is another than for the scene's values: {}",
                over.headline
            )],
        }
    }

    /// The friction of the device that may be another than any in the scene.
    fn beyond(&self) -> Option<String> {
        let beyond = self.compared.iter().find(|one| !one.is_within())?;
        Some(format!(
            "{} is {} in the scene, and {} on the device, which is only partly within that: give the scene the \
             identified range, as `{}`",
            beyond.parameter.row().name,
            beyond.in_scene,
            beyond.range,
            beyond.key
        ))
    }

    /// What was found, in a line.
    #[must_use]
    pub fn headline(&self) -> String {
        if self.compared.is_empty() {
            return "nothing fits".to_owned();
        }
        let ranges = self.compared.iter();
        let ranges = ranges.map(|one| format!("{} {}", one.parameter.row().name, one.range));
        let ranges: Vec<String> = ranges.collect();
        ranges.join(", ")
    }

    /// Whether the identified ranges have the scene's verdict.
    fn is_as_own(&self, over: &Over) -> bool {
        (over.verdict, over.at_every_speed) == (self.own.verdict, self.own.at_every_speed)
    }

    /// The name of a log that the report names by its path.
    fn name_of(&self, path: &str) -> String {
        let source = self.sources.iter().find(|source| source.path == path);
        source.map_or_else(
            || passivity_audit::legible(path),
            |source| source.name.clone(),
        )
    }

    /// What the logs say of assumptions.
    pub(super) fn observed(&self) -> Vec<Observed> {
        let samples = self.report.samples;
        let mut all = Vec::new();
        let mut see = |assumption, is_met: Option<bool>, says: String| {
            all.push(Observed {
                assumption,
                is_met,
                says: format!("Identification: {says}"),
            });
        };
        let why = self.doubts.join("; ");
        let but = match why.is_empty() {
            true => String::new(),
            false => format!("; but {why}"),
        };
        match &self.report.refuted_by {
            None if self.report.best_refuted => see(
                "A-FRICTION",
                None,
                format!(
                    "whether constant b and c explain every one of {samples} samples of free motion: {why}"
                ),
            ),
            None => see(
                "A-FRICTION",
                Some(true),
                format!(
                    "constant b and c explain every one of {samples} samples of free motion{but}"
                ),
            ),
            Some(refuted) => see(
                "A-FRICTION",
                Some(false),
                format!(
                    "no constant b and c explain rows 1 to {} of «{}»",
                    refuted.row,
                    self.name_of(&refuted.log)
                ),
            ),
        }
        let is_at_most = |compared: &Compared| {
            let hi = compared.hi.as_ref();
            hi.is_some_and(|hi| hi <= compared.scene.hi())
        };
        if !self.compared.is_empty() && self.compared.iter().all(is_at_most) {
            let surely = if self.doubts.is_empty() {
                " surely"
            } else {
                ""
            };
            let is_met = self.doubts.is_empty().then_some(true);
            let says = format!("b and c are{surely} no more than the scene says{but}");
            see("A-FRICTION-AT-MOST", is_met, says);
        }
        all
    }

    /// The identification for programs.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let compared = self.compared.iter().map(|compared| {
            json!({ "parameter": compared.key, "in_scene": compared.in_scene,
                "identified": compared.range, "agrees": compared.agrees() })
        });
        let compared: Vec<Value> = compared.collect();
        let over = self
            .over
            .as_ref()
            .map(|over| json!({ "verdict": over.verdict.name(), "headline": over.headline }));
        json!({ "sources": self.sources, "evidence": self.outcome().to_json(),
            "compared": compared, "over_identified_ranges": over, "report": self.report })
    }
}

impl Outcome {
    /// The word for it.
    #[must_use]
    pub const fn word(&self) -> &'static str {
        match self {
            Self::Supports => "supports",
            Self::Open(_) => "open",
            Self::Contradicts(_) => "contradicts",
        }
    }

    /// Why it does not support the case.
    #[must_use]
    pub fn because(&self) -> Option<&str> {
        match self {
            Self::Supports => None,
            Self::Open(why) | Self::Contradicts(why) => Some(why),
        }
    }

    pub(super) fn to_json(&self) -> Value {
        json!({ "outcome": self.word(), "because": self.because() })
    }
}
