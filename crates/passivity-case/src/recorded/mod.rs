//! What was recorded of a device and is taken as evidence: logs that are audited, and logs from which
//! friction is identified.
//!
//! Nothing is taken from a report that somebody made before: the logs are read, and audited and
//! identified, with the code of `passivity audit` and `passivity identify`. What only a person can
//! know, which device it was and when, is kept as given.

mod identification;
mod log;

use std::path::Path;

use passivity_audit::{Columns, Dialect, dialects, is_day, is_device, legible};
use passivity_evidence::Sha256;
use passivity_scene::Scene;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

pub use identification::{Compared, Identification, Over};
pub use log::Log;

use crate::error::CaseError;
use crate::study::Study;

/// Which recordings there are, how they are read, and what a person says of them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Recordings {
    /// Which device it was.
    pub device: String,
    /// Logs of the device in the scene, to be audited.
    pub logs: Vec<Recording>,
    /// Logs of the device that nobody touches, to identify its friction from.
    pub identification: Vec<Recording>,
    /// How the columns of the logs are called, as `passivity audit --columns` takes it.
    pub columns: Option<String>,
    /// The character between the fields of CSV.
    pub delimiter: Option<char>,
    /// Whether numbers are written with a comma.
    pub decimal_comma: bool,
    /// By how many ticks a count may be off, for the identification.
    pub count_error: f64,
    /// By how much the force may be off, for the identification, in SI units.
    pub force_error: f64,
    /// By what share of itself every force may be off, for the identification, where somebody says so.
    pub scale_error: Option<f64>,
    /// How much work the identification may be, in intervals of motion; by default as much as
    /// `passivity identify` takes.
    pub effort: Option<u64>,
}

/// A log in a file.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Recording {
    /// The file.
    pub path: String,
    /// The day on which it was recorded, as given.
    pub date: String,
}

/// A file that was read, bound by its hash.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Source {
    /// The file.
    pub path: String,
    /// Its name without the folder, with what hides in it escaped.
    pub name: String,
    /// The day on which it was recorded, as given.
    pub date: String,
    /// SHA-256 of the file.
    pub sha256: Sha256,
}

/// What recordings come to as evidence for a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// They agree with the scene and its verdict.
    Supports,
    /// They leave it open, for this reason.
    Open(String),
    /// They contradict it: this is how.
    Contradicts(String),
}

/// What a recording says of an assumption of the proofs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Observed {
    /// The assumption.
    pub assumption: &'static str,
    /// Whether the recording agrees with it; `None` where it leaves that open.
    pub is_met: Option<bool>,
    /// What was found.
    pub says: String,
}

/// What was recorded of a device in a scene.
#[derive(Clone, Debug)]
pub struct Recorded {
    /// What a person gave.
    pub given: Recordings,
    /// The logs, audited.
    pub logs: Vec<Log>,
    /// What was identified from logs, where there are any for that.
    pub identification: Option<Identification>,
}

impl Recorded {
    /// Reads, audits and identifies what was recorded of the device in a scene; `progress` is told how much of
    /// the identification's work is done, and how much it is at the most.
    ///
    /// # Errors
    ///
    /// A file that is no plain file, that cannot be read as a log, that has a mistake in a row, or that
    /// changed while it was read; a device or a date that is not given as it must be.
    pub fn read(
        given: Recordings,
        study: &Study,
        progress: impl FnMut(u64, u64),
    ) -> Result<Self, CaseError> {
        let scene = &study.scene;
        given.validate()?;
        let paths = given.logs.iter().chain(&given.identification);
        let paths: Vec<&Path> = paths.map(|log| log.path.as_ref()).collect();
        let dialects = dialects(&paths, scene, &given.dialect()?)
            .map_err(|refused| CaseError::of_log(refused.0, refused.1))?;
        let (of_logs, of_identification) = dialects.split_at(given.logs.len());
        let logs = given.logs.iter().zip(of_logs).enumerate();
        let logs = logs.map(|(index, (one, dialect))| Log::read(index + 1, one, study, dialect));
        let logs: Vec<Log> = logs.collect::<Result<_, _>>()?;
        once("--log", logs.iter().map(|log| &log.source))?;
        let identification = match given.identification.is_empty() {
            true => None,
            false => Some(Identification::read(
                &given,
                scene,
                &study.text,
                of_identification,
                progress,
            )?),
        };
        let sources = identification.iter().flat_map(|found| &found.sources);
        once("--identification", sources)?;
        Ok(Self {
            given,
            logs,
            identification,
        })
    }

    /// Every file that was read.
    pub fn sources(&self) -> impl Iterator<Item = &Source> {
        let identified = self.identification.iter().flat_map(|found| &found.sources);
        self.logs.iter().map(|log| &log.source).chain(identified)
    }

    /// What each log, and the identification, come to.
    #[must_use]
    pub fn outcomes(&self, scene: &Scene) -> Vec<Outcome> {
        let logs = self.logs.iter().map(|log| log.outcome(scene));
        let identified = self.identification.iter().map(Identification::outcome);
        logs.chain(identified).collect()
    }

    /// What the recordings say of assumptions.
    #[must_use]
    pub fn observed(&self, scene: &Scene) -> Vec<Observed> {
        let logs = self.logs.iter().flat_map(|log| log.observed(scene));
        let identified = self.identification.iter();
        logs.chain(identified.flat_map(Identification::observed))
            .collect()
    }

    /// The recordings for programs.
    #[must_use]
    pub fn to_json(&self, scene: &Scene) -> Value {
        let logs: Vec<Value> = self.logs.iter().map(|log| log.to_json(scene)).collect();
        let identification = self.identification.as_ref();
        json!({ "device_as_given": self.given.device, "given": self.given, "logs": logs,
            "identification": identification.map(Identification::to_json) })
    }

    /// The device as it was given, with what hides in it escaped.
    #[must_use]
    pub fn device(&self) -> String {
        legible(&self.given.device)
    }
}

impl Recordings {
    /// What a person has to say is said.
    fn validate(&self) -> Result<(), CaseError> {
        if !is_device(&self.device) {
            return Err(CaseError::new(
                "--device: expected which device was recorded, such as its name and serial number",
            ));
        }
        for Recording { path, date } in self.logs.iter().chain(&self.identification) {
            if !is_day(date) {
                let (path, date) = (legible(path), legible(date));
                return Err(CaseError::new(format!(
                    "--date: `{path}` was recorded on a day such as 2026-03-31, found `{date}`"
                )));
            }
        }
        Ok(())
    }

    /// How the logs are read.
    fn dialect(&self) -> Result<Dialect, CaseError> {
        let columns = self.columns.as_deref().map(str::parse::<Columns>);
        let columns = columns.transpose();
        let columns = columns.map_err(|error| CaseError::new(format!("--columns: {error}")))?;
        let delimiter = self.delimiter.map(u8::try_from).transpose();
        let delimiter = delimiter.map_err(|_| {
            CaseError::new("--delimiter: expected one character of ASCII, or `tab`")
        })?;
        Ok(Dialect {
            columns,
            delimiter,
            decimal_comma: self.decimal_comma,
        })
    }
}

impl Source {
    /// Reads a file with `read`, which goes over it in one way or another; its hash is that of what was
    /// read.
    fn bound<T>(
        recording: &Recording,
        read: impl FnOnce(&Path) -> Result<T, CaseError>,
    ) -> Result<(Self, T), CaseError> {
        let path = Path::new(&recording.path);
        let before = sum(path)?;
        let found = read(path)?;
        if sum(path)? != before {
            let what = "the file changed while it was read: record to the end first";
            return Err(CaseError::within(path, what));
        }
        let name = path.file_name().unwrap_or(path.as_os_str());
        let source = Self {
            path: recording.path.clone(),
            name: legible(&name.to_string_lossy()),
            date: recording.date.clone(),
            sha256: before,
        };
        Ok((source, found))
    }
}

/// A log is evidence once, whatever it is called.
fn once<'a>(option: &str, sources: impl Iterator<Item = &'a Source>) -> Result<(), CaseError> {
    let mut seen: Vec<&Source> = Vec::new();
    for source in sources {
        if let Some(same) = seen.iter().find(|other| other.sha256 == source.sha256) {
            let [path, same] = [&source.path, &same.path].map(|path| legible(path));
            return Err(CaseError::new(format!(
                "{option}: `{path}` is the same log as `{same}`: give it once"
            )));
        }
        seen.push(source);
    }
    Ok(())
}

/// The file of a case that has what was recorded of the device in a scene, by the scene's name in file names.
pub(crate) fn record_name(slug: &str) -> String {
    format!("{slug}.recorded.json")
}

/// The SHA-256 of a plain file, which may be of any size.
///
/// # Errors
///
/// A file that is not there, cannot be read, or is no plain file.
pub fn sum(path: &Path) -> Result<Sha256, CaseError> {
    let failed = |error: std::io::Error| CaseError::io(path, &error);
    if !path.metadata().map_err(failed)?.is_file() {
        let what = "expected a plain file: its hash goes into the case";
        return Err(CaseError::within(path, what));
    }
    let sum = passivity_identify::sha256(path).map_err(failed)?;
    Sha256::try_from(sum).map_err(|error| CaseError::within(path, error))
}
