//! The exact ledger of a recorded trace: CSV, Parquet or MCAP, streamed, on every core.

mod account;
mod arrays;
mod batch;
mod certificate;
mod chunk;
mod columns;
mod comparison;
mod computed;
mod cores;
mod counted;
mod csv;
mod dates;
mod digits;
mod error;
mod exact;
mod findings;
mod found;
#[cfg(any(feature = "mcap", feature = "parquet"))]
mod guarded;
mod guess;
mod header;
mod held;
mod irrational;
mod known;
mod lanes;
mod layout;
mod lines;
#[cfg(feature = "mcap")]
mod mcap;
mod merge;
mod motion;
mod names;
mod numbers;
mod outcome;
#[cfg(feature = "parquet")]
mod parquet;
mod partial;
mod piece;
mod preview;
mod quick;
mod report;
mod running;
mod samples;
mod saved;
mod saved_findings;
mod scale;
mod seek;
mod slots;
mod source;
mod step;
mod supply;
mod table;
mod task;
mod text;
mod ticks;
mod timing;
#[cfg(feature = "parquet")]
mod typed;
mod velocity;
mod walk;
mod wall;
mod worker;
mod wraps;

pub(crate) use running::near as near_rational;

pub use account::Point;
pub use arrays::{Positions, Values, audit_arrays, audit_columns};
pub use certificate::Certificate;
pub use columns::{Columns, Role};
pub use dates::is_day;
pub use error::{TraceError, legible};
pub use findings::Finding;
pub use guess::{Otherwise, Proposal};
pub use layout::Form;
pub use outcome::Audit;
pub use partial::{Partial, audit_part, merge_parts};
pub use piece::Stretch;
pub use report::{
    Agreement, ByLaw, Drawn, Firsts, Fitted, Force, Found, Judged, Least, Moved, Observer, Report,
    Running, Sampling, Shown, Supplied, UnendedRow, Verdict,
};
pub use samples::{MAX_SAMPLES, Sampled, samples};
pub use source::{Dialect, dialects};

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use passivity_scene::Scene;

use crate::ledger::Ledger;
use crate::log::account::Account;
use crate::log::chunk::Chunk;
use crate::log::comparison::Comparison;
use crate::log::found::Findings;
use crate::log::layout::Layout;
use crate::log::merge::Merge;
use crate::log::source::{Source, Work};
use crate::log::task::Task;
use crate::log::worker::Worker;

/// What an audit is to give besides its report.
#[derive(Default)]
pub struct Options<'a> {
    /// Where the rows of the ledger go, as CSV.
    pub rows: Option<&'a mut (dyn Write + 'a)>,
    /// Whether the report leaves out the [rows](Report::rows) that it carries of a short log, which take longer than all else
    /// where positions have π in them.
    pub without_rows: bool,
    /// Whether the course of the energy is wanted, for a plot.
    pub points: bool,
    /// Whether the account is of the scene's own law, also where the trace has forces.
    pub law: bool,
    /// How many cores to use; 0 for all.
    pub threads: usize,
    /// How many bytes of CSV a core is given at once; 0 for a size that suits most machines.
    pub block: usize,
    /// How the columns are called, and how numbers are written.
    pub dialect: Dialect,
    /// Is told from time to time how many samples were read, and ends the audit where it says `false`.
    pub watch: Option<&'a dyn Fn(u64) -> bool>,
}

/// Audits a log in a file, CSV, Parquet or MCAP; `-` is standard input, which must be CSV. CSV may be
/// compressed by gzip or zstd.
///
/// # Errors
///
/// [`TraceError`] when the file cannot be opened or its header cannot be read, or when rows cannot
/// be written. A mistake further on is part of the [`Audit`], with the account of what came before.
pub fn audit(path: &Path, scene: &Scene, options: Options<'_>) -> Result<Audit, TraceError> {
    audit_files(&[path.to_owned()], scene, options)
}

/// Audits a log in several files with the same header, one after the other.
///
/// # Errors
///
/// As [`audit`].
pub fn audit_files(
    paths: &[PathBuf],
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let block = block(&options);
    let (source, layout) = Source::open(paths, scene, &options.dialect, block)?;
    run(source, &layout, scene, options)
}

/// How many bytes of CSV a core is given at once.
const fn block(options: &Options<'_>) -> usize {
    piece::block(options.block)
}

/// Audits a trace in CSV.
///
/// # Errors
///
/// As [`audit`].
///
/// # Example
///
/// ```
/// use passivity_audit::{Options, Verdict, audit_csv};
/// use passivity_scene::Scene;
///
/// let scene = Scene::from_toml("s", "[dimensionless]\nbeta = \"3/5\"\nsigma = \"3/5\"").unwrap();
/// let trace = Box::new(&b"xi\n1\n1/2\n"[..]);
/// let audit = audit_csv(trace, &scene, Options::default()).unwrap();
/// assert_eq!(audit.verdict(), Verdict::Holds); // the linear account,
/// assert_eq!(audit.totals().violates_quantized, Some(1)); // not that of (22)
/// ```
pub fn audit_csv(
    input: Box<dyn Read>,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let opened = source::opened(input, block(&options), None)?;
    let (reader, layout) = opened.read(scene, &options.dialect)?;
    run(Source::of(reader), &layout, scene, options)
}

fn run(
    mut source: Source,
    layout: &Layout,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let ledger = Ledger::of_scene(scene);
    let files = source.names();
    let task = Task {
        files: &files,
        told: options.dialect.columns.is_some(),
        rows: options
            .rows
            .is_some()
            .then(|| form(&ledger, layout, scene, options.law)),
        points: options.points,
        reports_rows: !options.without_rows,
        ..Task::new(scene, &ledger, layout, options.law)
    };
    let by_law = task.by_law();
    let stretch = Reading {
        lead: 0,
        ends: true,
    };
    let (found, beside) = account(&mut source, &task, by_law.as_ref(), options, stretch)?;
    found.audit(&task, scene, beside)
}

/// How rows are written.
fn form(ledger: &Ledger, layout: &Layout, scene: &Scene, law: bool) -> crate::rows::Form {
    let applied = layout.force.is_some() && !law;
    let friction_is_exact = ledger.wide().friction_is_exact();
    crate::rows::Form {
        enclosures: layout.encloses(applied) || !friction_is_exact,
        force: applied,
        accounted: scene.unaccounted(applied).is_empty(),
    }
}

/// What of a source is accounted for.
#[derive(Clone, Copy, Debug)]
struct Reading {
    /// How many samples come before the first interval, its own first one included; none at the start of
    /// a log.
    lead: usize,
    /// Whether the log ends where the source does.
    ends: bool,
}

/// The account of a source, and that of the wall's own law beside it.
fn account<'a>(
    source: &mut Source,
    task: &'a Task<'a>,
    law: Option<&'a Task<'a>>,
    options: Options<'_>,
    reading: Reading,
) -> Result<(Findings, Option<Findings>), TraceError> {
    let layout = task.layout;
    let threads = threads(options.threads)?;
    let mut workers: Vec<[Worker; 2]> = (0..threads).map(|_| <[Worker; 2]>::default()).collect();
    let mut merge = Merge::new(task, options.rows)?;
    let mut beside = law.map(|law| Merge::new(law, None)).transpose()?;
    let mut first = None;
    if reading.lead > 0 {
        let led = leading(source, layout, reading.lead).and_then(|(before, rest)| {
            if let Some(beside) = &mut beside {
                beside.lead(&before)?;
            }
            merge.lead(&before)?;
            Ok(rest)
        });
        match led {
            Ok(rest) => first = Some(Work::Account(Box::new(rest))),
            Err(error) => {
                // It is for the stretch before this one to say where.
                let law = beside.map(|beside| beside.fail(error.clone()));
                return Ok((merge.fail(error), law));
            }
        }
    }
    let stopped = || TraceError::new("stopped", "the audit was stopped");
    let goes_on = |samples: u64| options.watch.is_none_or(|watch| watch(samples));
    if !goes_on(0) {
        return Err(stopped());
    }
    let rooms = Rooms::default();
    cores::in_order(
        &mut workers,
        || first.take().or_else(|| source.next(layout)),
        |work, [worker, other]| {
            worker.rows = rooms.take();
            Done::of(task, law, work, [worker, other])
        },
        |Done {
             chunk,
             account,
             beside: other,
             inside,
         }| {
            if let Some(beside) = &mut beside {
                beside.take(&chunk, (other, None))?;
            }
            let went_on = merge.take(&chunk, (account, inside))?;
            rooms.keep(merge.room());
            match goes_on(merge.samples()) {
                true => Ok(went_on),
                false => Err(stopped()),
            }
        },
    )?;
    let law = beside
        .map(|beside| beside.finish(reading.ends))
        .transpose()?;
    Ok((merge.finish(reading.ends)?, law))
}

/// The first `lead` samples of a source, and what else was read with them.
fn leading(
    source: &mut Source,
    layout: &Layout,
    lead: usize,
) -> Result<(Chunk, Chunk), TraceError> {
    let mut before = Chunk::default();
    loop {
        let Some(work) = source.next(layout) else {
            let message = "the log ends before this stretch of it: it was changed";
            return Err(TraceError::new("io", message));
        };
        let mut chunk = parsed(work, layout);
        let missing = lead - before.samples.len();
        let rest = chunk.split_off(missing);
        let whole = chunk.samples.len() == missing;
        before.append(chunk);
        if whole {
            return Ok((before, rest));
        }
        if let Some(error) = rest.error {
            return Err(error);
        }
    }
}

/// The samples of a piece of work.
fn parsed(work: Work, layout: &Layout) -> Chunk {
    match work {
        Work::Parse(mut block, notation, file) => Chunk {
            file,
            marks: std::mem::take(&mut block.marks),
            ..csv::parse(&block, layout, notation)
        },
        Work::Account(chunk) => *chunk,
    }
}

/// The most threads that are asked for at once.
pub const MAX_THREADS: usize = 1024;

/// How many threads work, of which 0 asks for as many as there are cores.
fn threads(asked: usize) -> Result<usize, TraceError> {
    match asked {
        // One, where the system does not say how many there are.
        0 => Ok(std::thread::available_parallelism().map_or(1, usize::from)),
        1..=MAX_THREADS => Ok(asked),
        _ => {
            let message = format!("at most {MAX_THREADS} threads can be asked for, not {asked}");
            Err(TraceError::new("threads", message))
        }
    }
}

/// The room of rows that were written, for others.
#[derive(Default)]
struct Rooms(Mutex<Vec<Vec<u8>>>);

impl Rooms {
    fn lock(&self) -> MutexGuard<'_, Vec<Vec<u8>>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn take(&self) -> Vec<u8> {
        self.lock().pop().unwrap_or_default()
    }

    fn keep(&self, room: Vec<u8>) {
        if room.capacity() > 0 {
            self.lock().push(room);
        }
    }
}

/// What was found of a chunk.
struct Done {
    chunk: Chunk,
    /// The account that is asked for, and that of the law beside it.
    account: Account,
    beside: Account,
    /// How the forces inside of it agree with the law's.
    inside: Option<Comparison>,
}

impl Done {
    fn of(
        task: &Task<'_>,
        law: Option<&Task<'_>>,
        work: Work,
        [worker, other]: [&mut Worker; 2],
    ) -> Self {
        let mut chunk = parsed(work, task.layout);
        let mut shared = worker.shared(task, &chunk);
        let account = worker.account(task, (&mut chunk, &mut shared), task.lead());
        let beside = match law {
            Some(law) => other.account(law, (&mut chunk, &mut shared), law.lead()),
            None => Account::default(),
        };
        worker.reuse(shared);
        let compares = task.compares_forces();
        let inside = compares.then(|| Comparison::inside(task, &chunk));
        Self {
            chunk,
            account,
            beside,
            inside: inside.flatten(),
        }
    }
}
