//! The samples of a log as they are, for whoever makes something else of them than an account.

use std::path::{Path, PathBuf};

use passivity_scene::{Motion, Scene};

use crate::log::chunk::Chunk;
use crate::log::error::TraceError;
use crate::log::guess::Otherwise;
use crate::log::layout::Layout;
use crate::log::layout::refused::LAW;
use crate::log::lines::BLOCK;
use crate::log::parsed;
use crate::log::source::{Dialect, Source};
use crate::log::step::{between, check_jump};
use crate::log::wraps::{Periods, Wraps};
use crate::number::Number;
use crate::reading::Reading;
use crate::shell::{shell_word, with_options};

/// The most samples of a log that are held in memory.
pub const MAX_SAMPLES: usize = 1_000_000;

/// The samples of a log, with the force that was held after each.
#[derive(Clone, Debug, Default)]
pub struct Sampled {
    /// The positions, in ticks.
    pub positions: Vec<Reading>,
    /// The forces, in KΔ; as many as positions.
    pub forces: Vec<Reading>,
    /// How long each interval was, in sampling periods: one fewer than positions.
    pub durations: Vec<Number>,
}

/// Reads the samples of one log, whose forces are given and whose times may be.
///
/// # Errors
///
/// [`TraceError`] for what an audit refuses, for a log without forces or with a counter that wraps around, and for one of more than
/// [`MAX_SAMPLES`] samples.
pub fn samples(path: &Path, scene: &Scene, dialect: &Dialect) -> Result<Sampled, TraceError> {
    let paths: [PathBuf; 1] = [path.to_owned()];
    let opened = Source::open(&paths, scene, dialect, BLOCK);
    let (mut source, layout) = opened.map_err(|error| with_force(error, scene))?;
    if let Some(finding) = &layout.beside.finding {
        let message = format!(
            "{}: what held the device until then is not known; cut the file so that it starts there (`mcap filter`)",
            finding.says
        );
        return Err(TraceError::new("not_yet", message));
    }
    if layout.force.is_none() {
        let found = match dialect.columns {
            Some(_) => "and `--columns` names none",
            None => "and no column looks like one",
        };
        return Err(TraceError::new(
            "header",
            wanted(found, layout.typed(false), scene),
        ));
    }
    if layout.form == crate::Form::Ledger {
        let message = "expected samples, found the rows of a ledger";
        return Err(TraceError::new("header", message));
    }
    let mut all = Sampled::default();
    let mut time = None;
    let periods = Periods::of(scene, &layout);
    let mut wraps = Wraps::new(&periods);
    while let Some(work) = source.next(&layout) {
        let chunk = parsed(work, &layout);
        if let Some(wraps) = &mut wraps {
            wraps.feed(&layout, &chunk, chunk.samples.len());
        }
        append(&mut all, &mut time, &chunk, &layout)?;
    }
    let wrapped = wraps.map(|wraps| wraps.finish(&layout, true));
    if let Some(finding) = wrapped.and_then(|it| it.finding(&layout, &periods, "")) {
        // No device moves so.
        let message = format!("{}; {}", finding.says, finding.fix);
        return Err(TraceError::new("wrap", message));
    }
    match all.positions.len() {
        0 | 1 => Err(TraceError::new(
            "empty",
            "a log of at least two samples is needed",
        )),
        _ => Ok(all),
    }
}

/// Columns, and a force without its name.
fn with_name(columns: Option<String>, scene: &Scene) -> String {
    let force = match scene.motion {
        Motion::Dimensionless => "f=NAME",
        Motion::Linear => "f=NAME [N]",
        Motion::Rotary => "f=NAME [N m]",
    };
    columns.map_or_else(|| force.to_owned(), |columns| format!("{columns}, {force}"))
}

/// That a force is needed, with the columns to which it is to be added.
fn wanted(found: &str, columns: Option<String>, scene: &Scene) -> String {
    let all = shell_word(&with_name(columns, scene));
    format!(
        "the force that was commanded is needed, {found}: name its column, as in `--columns {all}`"
    )
}

/// The error of a header; what it may mean is no proposal where that leaves out the force, which is needed.
fn with_force(mut error: TraceError, scene: &Scene) -> TraceError {
    error.message = error.message.replace(LAW, "");
    if let Some(proposal) = error.proposal.take_if(|proposal| !proposal.has_force) {
        let mut wanted = wanted(
            "and no column looks like one",
            Some(proposal.columns),
            scene,
        );
        for Otherwise { condition, columns } in proposal.otherwise {
            let columns = shell_word(&with_name(Some(columns), scene));
            wanted.push_str(&format!(", or `--columns {columns}` where {condition}"));
        }
        let apart = with_options(proposal.delimiter, proposal.decimal_comma);
        error.message = format!("{}; {wanted}{apart}", error.message);
    }
    error
}

/// Adds the samples of a chunk; `time` is that of the last sample before it.
fn append(
    all: &mut Sampled,
    time: &mut Option<Number>,
    chunk: &Chunk,
    layout: &Layout,
) -> Result<(), TraceError> {
    let before = all.positions.len();
    let number = |row: usize| (before + row + 1) as u64;
    for row in 0..chunk.samples.len() {
        let at = |error: TraceError| error.row(number(row));
        if all.positions.len() == MAX_SAMPLES {
            let message = format!("a log may have {MAX_SAMPLES} samples here");
            return Err(at(TraceError::new("too_long", message)));
        }
        let (Some(position), Some(force)) = (chunk.samples.get(row), chunk.forces.get(row)) else {
            return Err(at(TraceError::new(
                "fields",
                "a position or a force is missing",
            )));
        };
        let now = chunk.times.get(row);
        if let Some(last) = all.positions.last() {
            if let (Reading::Count(from), Reading::Count(to)) = (last, &position) {
                check_jump(*from, *to).map_err(at)?;
            }
            let duration = match (&time, &now) {
                (Some(from), Some(to)) => between(layout, from, to).map_err(at)?,
                _ => Number::whole(1),
            };
            all.durations.push(duration);
        }
        *time = now;
        all.positions.push(position);
        all.forces.push(force);
    }
    match &chunk.error {
        Some(error) => {
            let row = error.row.map_or(before as u64, |row| before as u64 + row);
            Err(error.clone().row(row + 1))
        }
        None => Ok(()),
    }
}
