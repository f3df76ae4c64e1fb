//! What `passivity identify` answers: for programs, and for people.

use std::ops::RangeInclusive;

use passivity_core::Parameter;
use passivity_scene::check::unit_of;
use passivity_scene::display::{Rounding, figures, rounded, significant};
use passivity_scene::{Motion, Scene};
use schemars::JsonSchema;
use serde::Serialize;

use crate::identified::{Bounds, Identified, IdentifyError};
use crate::lacks::Lack;

/// What the logs say of the device. Figures are in SI units, or in K, T and Δ where the sketch is
/// dimensionless.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Report {
    /// The name of the sketch.
    pub scene: String,
    /// The logs, in order.
    pub logs: Vec<LogReport>,
    /// How many samples they have together.
    pub samples: usize,
    /// What is known of each parameter; `null` for all of them where nothing fits.
    pub parameters: Parameters,
    /// Where no parameters fit; `null` where some do.
    pub refuted_by: Option<RefutedBy>,
    /// Whether every best estimate is within 5 % of the true value, wherever within the bounds that is.
    pub informative: bool,
    /// What the logs lack, in words; first, where the bounds are wide, whether more work may narrow them. An informative
    /// answer may lack something too: motion the other way, without which a constant force cannot be told from friction.
    pub lacks: Vec<String>,
    /// Whether the work came to its bound before the box was as narrow as it could be.
    pub stopped_early: bool,
    /// Whether the logs refute the best estimate: no parameters were found, with a tenth of the effort, that they do
    /// not refute. `false` where there is no estimate.
    pub best_refuted: bool,
}

/// A log.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LogReport {
    /// Its file.
    pub file: String,
    /// The SHA-256 of the file, in hexadecimal.
    pub sha256: String,
}

impl LogReport {
    /// Refuses logs of which one is there twice, whatever it is called: a log is one experiment.
    ///
    /// # Errors
    ///
    /// [`IdentifyError`] with the names of both.
    pub fn once(logs: &[Self]) -> Result<(), IdentifyError> {
        for (number, log) in logs.iter().enumerate() {
            let mut before = logs.iter().take(number);
            if let Some(same) = before.find(|other| other.sha256 == log.sha256) {
                return Err(IdentifyError::new(format!(
                    "{}: this is the same log as {}: give it once",
                    log.file, same.file
                )));
            }
        }
        Ok(())
    }
}

/// What is known of each parameter.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Parameters {
    /// Viscous friction.
    pub viscous: Option<Known>,
    /// Coulomb friction.
    pub coulomb: Option<Known>,
    /// The inertia, where it was looked for.
    pub inertia: Option<Known>,
}

/// What is known of a parameter.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct Known {
    /// It is surely not below this.
    pub lo: f64,
    /// It is surely not above this; `null` where nothing bounds it.
    pub hi: Option<f64>,
    /// The best estimate; `null` where the device did not surely move.
    pub best: Option<f64>,
}

/// Where the logs show that no parameters fit.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RefutedBy {
    /// The file of the log.
    pub log: String,
    /// The row, from 1, the header not counted: no parameters fit the rows up to it.
    pub row: usize,
    /// When it was recorded, in seconds from the log's first row.
    pub time: f64,
    /// What it may be.
    pub suspicion: String,
}

impl Report {
    /// The report on logs, each with its file's name and its hash.
    #[must_use]
    pub fn new(scene: &Scene, identified: &Identified, logs: Vec<LogReport>) -> Self {
        let known = |parameter: Parameter| {
            let found = identified
                .parameters
                .iter()
                .find(|(which, _)| *which == parameter);
            found.map(|(_, Bounds { lo, hi, best })| Known {
                lo: *lo,
                hi: *hi,
                best: *best,
            })
        };
        let refuted_by = identified.refuted_by.as_ref().map(|refutation| RefutedBy {
            log: logs
                .get(refutation.log)
                .map_or_else(String::new, |log| log.file.clone()),
            row: refutation.row,
            time: refutation.time,
            suspicion: refutation.suspicion.clone(),
        });
        Self {
            scene: scene.name.clone(),
            samples: identified.samples,
            parameters: Parameters {
                viscous: known(Parameter::Viscous),
                coulomb: known(Parameter::Coulomb),
                inertia: known(Parameter::Inertia),
            },
            refuted_by,
            informative: identified.is_informative(),
            lacks: identified.lacks.iter().map(ToString::to_string).collect(),
            stopped_early: identified.stopped_early,
            best_refuted: identified.best_refuted,
            logs,
        }
    }

    /// The report for people.
    #[must_use]
    pub fn to_text(&self, motion: Motion) -> String {
        let count = match self.logs.len() {
            1 => "1 log".to_owned(),
            n => format!("{n} logs"),
        };
        let mut lines = vec![format!("{}: {count}, {} samples", self.scene, self.samples)];
        if let Some(refuted) = &self.refuted_by {
            let seconds = if motion == Motion::Dimensionless {
                "sampling periods"
            } else {
                "s"
            };
            lines.push(format!(
                "no viscous and Coulomb friction fit: {}, rows 1 to {} (until {} {seconds})",
                refuted.log,
                refuted.row,
                significant(refuted.time)
            ));
            lines.push(format!("it may be: {}", refuted.suspicion));
        }
        for (parameter, known) in [
            (Parameter::Viscous, &self.parameters.viscous),
            (Parameter::Coulomb, &self.parameters.coulomb),
            (Parameter::Inertia, &self.parameters.inertia),
        ] {
            let Some(known) = known else { continue };
            let range = range(known.lo, known.hi, unit_of(parameter, motion));
            let best = known.best.map_or_else(String::new, |best| {
                format!("; best estimate {}", nearest(best))
            });
            lines.push(format!("{:<17} {range}{best}", parameter.row().name));
        }
        if self.refuted_by.is_none() && self.informative {
            lines.push("surely within these bounds, if the device is one of this model".to_owned());
        }
        if self.best_refuted {
            lines.push(best_refuted(self.stopped_early));
        }
        lines.extend(
            self.lacks
                .iter()
                .map(|lack| format!("to know more: {lack}")),
        );
        // Of wide bounds this is said already, first of what they lack.
        if self.stopped_early && !self.lacks.contains(&Lack::Effort.to_string()) {
            lines.push(
                "the search came to its bound: with more --effort the box may be narrower"
                    .to_owned(),
            );
        }
        lines.join("\n")
    }
}

/// What is said where the logs refute the best estimate: of a search that came to its bound, or of one that is done.
pub(crate) fn best_refuted(stopped_early: bool) -> String {
    let then = match stopped_early {
        true => "with more --effort some may be, or it may show that none fit",
        false => {
            "more --effort finds none, as the bounds are as narrow as they get; the device may be none of the model, or \
             the errors that were given may be too small"
        }
    };
    format!(
        "the logs refute the best estimate, and no parameters were found that they do not refute: {then}"
    )
}

/// How many digits of a bound are written, and how many an estimate may need.
pub(crate) const DIGITS: RangeInclusive<u8> = 6..=17;

/// Bounds, rounded outwards, as a scene is given them; in words where nothing bounds above.
pub(crate) fn range(lo: f64, hi: Option<f64>, unit: &str) -> String {
    match hi {
        Some(hi) => with_unit(&format!("{} … {}", below(lo), above(hi)), unit),
        None => format!(
            "at least {}; nothing bounds it above",
            with_unit(&below(lo), unit)
        ),
    }
}

/// A number before its unit, of which a dimensionless scene has none.
pub(crate) fn with_unit(number: &str, unit: &str) -> String {
    match unit {
        "" => number.to_owned(),
        unit => format!("{number} {unit}"),
    }
}

/// Six digits that are not above a bound.
fn below(x: f64) -> String {
    digits(x, Rounding::Down)
}

/// Six digits that are not below a bound.
fn above(x: f64) -> String {
    digits(x, Rounding::Up)
}

/// The digits of an estimate: six, as its bounds have, or as many more as were left to it.
#[must_use]
pub fn nearest(x: f64) -> String {
    let mut all = DIGITS.map(|digits| figures(x, digits));
    let exact = all.find(|text| text.parse() == Ok(x));
    exact.unwrap_or_else(|| x.to_string())
}

fn digits(x: f64, to: Rounding) -> String {
    match passivity_core::BigRational::from_float(x) {
        Some(exact) => rounded(&exact, (*DIGITS.start()).into(), to),
        None => x.to_string(),
    }
}
