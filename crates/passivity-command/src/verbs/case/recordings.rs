//! The options that give recordings of the device as evidence, and what they come to.

use std::path::PathBuf;

use passivity_audit::Verdict;
use passivity_case::recorded::Outcome;
use passivity_case::{CaseError, Recorded, Recording, Recordings, Study};
use passivity_scene::Scene;

use crate::exit::{Exit, Failure};
use crate::progress::Progress;
use crate::typed::run;
use crate::verbs::audit::delimiter;

/// Logs of the device, how they are read, and what is said of them.
#[derive(Debug, clap::Args)]
#[group(skip)]
pub(super) struct Options {
    /// Take this log of the device in the scene as evidence; once for each log. It is audited as by
    /// `passivity audit`, and bound to the case by its hash.
    #[arg(long, value_name = "LOG", conflicts_with = "check", requires_all = ["device", "date"])]
    log: Vec<PathBuf>,
    /// Take this log of the device, on which nobody has a hand, as evidence for its friction; once for each log.
    #[arg(long, value_name = "LOG", conflicts_with = "check", requires_all = ["device", "date"])]
    identification: Vec<PathBuf>,
    /// Which device was recorded, such as its name and serial number: written down as given.
    #[arg(long, value_name = "TEXT", conflicts_with = "check")]
    device: Option<String>,
    /// The day of the recording, such as 2026-11-20, written down as given: once for all logs, or once for
    /// each, first those of --log and then those of --identification.
    #[arg(long, value_name = "DATE", conflicts_with = "check")]
    date: Vec<String>,
    /// Say which columns of the logs are read: `role=name`, as for `passivity audit`.
    #[arg(long, value_name = "COLUMNS", conflicts_with = "check")]
    columns: Option<String>,
    /// The character between the fields of CSV, or `tab`.
    #[arg(long, value_name = "CHARACTER", value_parser = delimiter, conflicts_with = "check")]
    delimiter: Option<u8>,
    /// Numbers in the logs are written with a comma, as in 0,25.
    #[arg(long, conflicts_with = "check")]
    decimal_comma: bool,
    /// By how many ticks a count may be off to either side, in the logs for identification.
    #[arg(
        long,
        value_name = "N",
        default_value_t = 1.0,
        value_parser = crate::args::number(crate::args::TICKS),
        allow_negative_numbers = true,
        conflicts_with = "check"
    )]
    count_error: f64,
    /// By how much the force may be off to either side, in N or N m, in the logs for identification.
    #[arg(
        long,
        value_name = "F",
        default_value_t = 0.0,
        value_parser = crate::args::number(crate::args::FORCE),
        allow_negative_numbers = true,
        conflicts_with = "check"
    )]
    force_error: f64,
    /// By what share of itself every force may be off, all alike, in the logs for identification: 0.05 for 5 %.
    #[arg(
        long,
        value_name = "SHARE",
        value_parser = crate::args::share,
        allow_negative_numbers = true,
        conflicts_with = "check"
    )]
    scale_error: Option<f64>,
    /// How much work the identification may be, in millions of intervals of motion, as for
    /// `passivity identify`.
    #[arg(long, value_name = "MILLIONS", allow_negative_numbers = true, value_parser = crate::args::whole(passivity_identify::Options::MILLIONS), conflicts_with = "check")]
    effort: Option<u64>,
}

impl Options {
    /// The recordings that were given, if any were.
    pub(super) fn given(&self) -> Result<Option<Recordings>, Failure> {
        let count = self.log.len() + self.identification.len();
        if count == 0 {
            return match self.is_plain() {
                true => Ok(None),
                false => Err(Failure::input(
                    "expected --log or --identification: the other options about recordings say how these \
                     are read, and what of",
                )),
            };
        }
        let dates = self.dates(count)?;
        let (of_logs, of_identification) = dates.split_at(self.log.len());
        Ok(Some(Recordings {
            // Its lack is refused where the options are read.
            device: self.device.clone().unwrap_or_default(),
            logs: recordings(&self.log, of_logs)?,
            identification: recordings(&self.identification, of_identification)?,
            columns: self.columns.clone(),
            delimiter: self.delimiter.map(char::from),
            decimal_comma: self.decimal_comma,
            count_error: self.count_error,
            force_error: self.force_error,
            scale_error: self.scale_error,
            effort: self.effort.map(|millions| millions * 1_000_000),
        }))
    }

    /// Whether nothing is said of recordings.
    #[allow(clippy::float_cmp)] // the default itself
    fn is_plain(&self) -> bool {
        let said = self.device.is_some()
            || self.columns.is_some()
            || self.delimiter.is_some()
            || self.effort.is_some()
            || self.scale_error.is_some()
            || self.decimal_comma;
        !said && self.date.is_empty() && self.count_error == 1.0 && self.force_error == 0.0
    }

    /// The date of each log.
    fn dates(&self, count: usize) -> Result<Vec<String>, Failure> {
        match self.date.as_slice() {
            [one] => Ok(vec![one.clone(); count]),
            dates if dates.len() == count => Ok(dates.to_vec()),
            dates => Err(Failure::input(format!(
                "--date: expected one for all logs or one for each of {count}, found {}",
                dates.len()
            ))),
        }
    }
}

fn recordings(paths: &[PathBuf], dates: &[String]) -> Result<Vec<Recording>, Failure> {
    let pairs = paths.iter().zip(dates);
    let each = pairs.map(|(path, date)| match path.to_str() {
        Some("-") => Err(Failure::input(
            "a log must be a file: its hash goes into the case",
        )),
        Some(path) => Ok(Recording {
            path: path.to_owned(),
            date: date.clone(),
        }),
        None => Err(Failure::input(format!(
            "{}: expected a name in UTF-8: it is written into the case",
            path.display()
        ))),
    });
    each.collect()
}

/// Reads the recordings of a study.
pub(super) fn read(given: Recordings, study: &Study) -> Result<Recorded, Failure> {
    let mut bar: Option<(Progress, u64)> = None;
    let progress = |done: u64, total: u64| {
        let (bar, before) =
            bar.get_or_insert_with(|| (Progress::new(total, "intervals at the most"), 0));
        bar.advance(done - *before);
        *before = done;
    };
    Recorded::read(given, study, progress).map_err(|error| refusal(&error))
}

/// Why a log is refused, with the command that reads it as it seems to be meant.
fn refusal(error: &CaseError) -> Failure {
    match error.proposal() {
        Some(proposal) => Failure::input(format!("{error} {}", run(proposal))),
        None => Failure::input(error),
    }
}

/// What the recordings come to, as an exit code.
pub(super) fn exit_of(recorded: &Recorded, scene: &Scene) -> Exit {
    let logs = recorded.logs.iter().map(|log| match log.outcome(scene) {
        Outcome::Supports => Exit::Holds,
        Outcome::Open(_) if log.report.verdict == Verdict::NotCovered => Exit::NotCovered,
        Outcome::Open(_) | Outcome::Contradicts(_) => Exit::Fails,
    });
    let identification = recorded.identification.iter();
    let identification = identification.map(|found| match found.outcome() {
        Outcome::Supports => Exit::Holds,
        Outcome::Open(_) | Outcome::Contradicts(_) => Exit::Fails,
    });
    logs.chain(identification).fold(Exit::Holds, Exit::and)
}

/// What the recordings come to, a line each.
pub(super) fn summary(study: &Study) -> String {
    let Some(recorded) = &study.recorded else {
        return String::new();
    };
    let logs = recorded.logs.iter().map(|log| {
        let name = format!("log {}", log.source.path);
        (name, log.headline(), log.outcome(&study.scene))
    });
    let identification = recorded.identification.iter().map(|found| {
        (
            "identification".to_owned(),
            found.headline(),
            found.outcome(),
        )
    });
    let mut text = String::new();
    for (name, says, outcome) in logs.chain(identification) {
        text.push_str(&format!("    {name}: {says}\n"));
        match &outcome {
            Outcome::Supports => text.push_str("      supports the case\n"),
            Outcome::Open(why) if *why == says => text.push_str("      leaves the case open\n"),
            Outcome::Open(why) => text.push_str(&format!("      leaves the case open: {why}\n")),
            Outcome::Contradicts(how) if *how == says => {
                text.push_str("      CONTRADICTS the case\n");
            }
            Outcome::Contradicts(how) => {
                text.push_str(&format!("      CONTRADICTS the case: {how}\n"));
            }
        }
    }
    text
}
