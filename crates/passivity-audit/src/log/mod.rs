//! The exact ledger of a recorded trace: CSV or Parquet, streamed, on every core.

mod account;
mod arrays;
mod certificate;
mod chunk;
mod comparison;
mod csv;
mod error;
mod layout;
mod merge;
mod outcome;
#[cfg(feature = "parquet")]
mod parquet;
mod report;
mod running;
mod step;
mod supply;
mod table;
mod text;
mod timing;
mod worker;

pub use account::Point;
pub use arrays::{Positions, audit_arrays};
pub use certificate::Certificate;
pub use error::TraceError;
pub use layout::Form;
pub use outcome::Audit;
pub use report::{
    Agreement, Firsts, Fitted, Force, Found, Judged, Least, Observer, Report, Running, Sampling,
    Shown, Supplied, Verdict,
};

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use passivity_scene::Scene;

use crate::ledger::Ledger;
use crate::log::chunk::Chunk;
use crate::log::csv::{Block, Lines};
use crate::log::layout::Layout;
use crate::log::merge::Merge;
use crate::log::worker::{Task, Worker};

/// What an audit is to give besides its report.
#[derive(Default)]
pub struct Options<'a> {
    /// Where the rows of the ledger go, as CSV.
    pub rows: Option<&'a mut (dyn Write + 'a)>,
    /// Whether the course of the energy is wanted, for a plot.
    pub points: bool,
    /// Whether the account is of the scene's own law, also where the trace has forces.
    pub law: bool,
    /// How many cores to use; 0 for all.
    pub threads: usize,
    /// How many bytes of CSV a core is given at once; 0 for a size that suits most machines.
    pub block: usize,
}

/// Where the samples come from.
enum Source {
    Csv(Lines<Box<dyn Read>>),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Table>),
    /// In memory, the last chunk first.
    Memory(Vec<Chunk>),
}

/// Audits a trace in a file; `-` is standard input, which must be CSV.
///
/// # Errors
///
/// [`TraceError`] when the file cannot be opened or its header cannot be read, or when rows cannot
/// be written. A mistake further on is part of the [`Audit`], with the account of what came before.
pub fn audit(path: &Path, scene: &Scene, options: Options<'_>) -> Result<Audit, TraceError> {
    if path.as_os_str() == "-" {
        return audit_csv(Box::new(std::io::stdin()), scene, options);
    }
    let mut file = File::open(path).map_err(|error| TraceError::io(&error))?;
    let mut start = Vec::new();
    let read = (&mut file).take(4).read_to_end(&mut start);
    read.map_err(|error| TraceError::io(&error))?;
    if start == b"PAR1" {
        return audit_parquet(path, scene, options);
    }
    // What was read of a pipe cannot be read again.
    let whole = std::io::Cursor::new(start).chain(file);
    audit_csv(Box::new(whole), scene, options)
}

#[cfg(feature = "parquet")]
fn audit_parquet(path: &Path, scene: &Scene, options: Options<'_>) -> Result<Audit, TraceError> {
    let table = parquet::Table::open(path)?;
    let layout = Layout::read(table.names(), scene)?;
    run(Source::Parquet(Box::new(table)), &layout, scene, options)
}

#[cfg(not(feature = "parquet"))]
fn audit_parquet(_: &Path, _: &Scene, _: Options<'_>) -> Result<Audit, TraceError> {
    let message = "Parquet is not in this build: build it with the feature `parquet`";
    Err(TraceError::new("parquet", message))
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
/// assert_eq!(audit.totals().violates_quantized, 1); // not that of (22)
/// ```
pub fn audit_csv(
    input: Box<dyn Read>,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let block = match options.block {
        0 => csv::BLOCK,
        block => block,
    };
    let mut lines = Lines::new(input, block);
    let names = csv::names(&lines.header()?)?;
    let layout = Layout::read(names, scene)?;
    run(Source::Csv(lines), &layout, scene, options)
}

/// What a core is given.
enum Work {
    Parse(Block),
    Account(Chunk),
}

impl Source {
    /// What the next core is to do; `None` at the end.
    fn next(&mut self, layout: &Layout) -> Option<Work> {
        #[cfg(not(feature = "parquet"))]
        let _ = layout;
        match self {
            Self::Csv(lines) => lines.next_block().map(Work::Parse),
            #[cfg(feature = "parquet")]
            Self::Parquet(table) => table.next_chunk(layout).map(Work::Account),
            Self::Memory(chunks) => chunks.pop().map(Work::Account),
        }
    }
}

fn run(
    mut source: Source,
    layout: &Layout,
    scene: &Scene,
    options: Options<'_>,
) -> Result<Audit, TraceError> {
    let ledger = Ledger::of_scene(scene);
    let applied = layout.force.is_some() && !options.law;
    let friction_is_exact = ledger.wide().friction_is_exact();
    let form = crate::rows::Form {
        enclosures: layout.encloses(applied) || !friction_is_exact,
        force: applied,
    };
    let task = Task {
        ledger: &ledger,
        layout,
        rows: options.rows.is_some().then_some(form),
        points: options.points,
        applied,
        running: applied || ledger.has_memory(),
    };
    let threads = match options.threads {
        // One, where the system does not say how many there are.
        0 => std::thread::available_parallelism().map_or(1, usize::from),
        threads => threads,
    };
    let mut workers: Vec<Worker> = (0..threads).map(|_| Worker::default()).collect();
    let mut merge = Merge::new(&task, options.rows)?;
    loop {
        let next = std::iter::from_fn(|| source.next(layout));
        let work: Vec<Work> = next.take(threads).collect();
        if work.is_empty() {
            return merge.finish(scene);
        }
        for (chunk, account) in at_once(&task, work, &mut workers) {
            if !merge.take(chunk, account)? {
                return merge.finish(scene);
            }
        }
    }
}

/// The accounts of some chunks, each on a core of its own.
fn at_once(
    task: &Task<'_>,
    work: Vec<Work>,
    workers: &mut [Worker],
) -> Vec<(Chunk, account::Account)> {
    std::thread::scope(|scope| {
        let mut running = Vec::new();
        for (work, worker) in work.into_iter().zip(workers) {
            running.push(scope.spawn(move || {
                let mut chunk = match work {
                    Work::Parse(block) => csv::parse(&block, task.layout),
                    Work::Account(chunk) => chunk,
                };
                let account = worker.account(task, &mut chunk, task.lead());
                (chunk, account)
            }));
        }
        let join = |handle: std::thread::ScopedJoinHandle<'_, _>| {
            handle
                .join()
                .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
        };
        running.into_iter().map(join).collect()
    })
}
