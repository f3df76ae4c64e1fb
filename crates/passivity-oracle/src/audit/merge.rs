//! Puts the chunks of a trace together: the intervals between them, and one account of all.

use std::io::Write;

use passivity_core::BigRational;
use passivity_scene::Scene;

use crate::audit::account::Account;
use crate::audit::chunk::Chunk;
use crate::audit::error::TraceError;
use crate::audit::force::ForceCheck;
use crate::audit::report::Audit;
use crate::audit::step::{between, check_jump, duration};
use crate::audit::supply::{Supply, potential_range};
use crate::audit::worker::{Task, enter, plot};
use crate::ledger::Sample;
use crate::number::Number;

/// The most intervals whose rows a report carries itself.
pub(crate) const ROWS_IN_REPORT: usize = 1000;

/// The most points that a plot is made of.
const MAX_POINTS: usize = 8192;

/// The account so far, and what the next chunk needs of the chunks before it.
pub(crate) struct Merge<'a, 'w> {
    task: &'a Task<'a>,
    out: Option<&'w mut (dyn Write + 'w)>,
    written: u64,
    account: Account,
    samples: u64,
    /// The latest samples, the latest first.
    recent: Vec<Sample>,
    time: Option<Number>,
    /// In a ledger: Δτ of the row that the latest sample starts, and where it ends.
    dtau: Option<Number>,
    closing: Option<Sample>,
    first: Option<Sample>,
    force: Option<ForceCheck>,
    /// The first samples, for the rows in the report.
    pub(crate) head: Vec<(Sample, Number)>,
    error: Option<TraceError>,
    unended: bool,
    stride: u64,
}

impl<'a, 'w> Merge<'a, 'w> {
    pub(crate) fn new(
        task: &'a Task<'a>,
        mut out: Option<&'w mut (dyn Write + 'w)>,
    ) -> Result<Self, TraceError> {
        if let (Some(out), Some(enclosures)) = (&mut out, task.rows) {
            writeln!(out, "{}", crate::row::csv_header(enclosures))
                .map_err(|error| TraceError::io(&error))?;
        }
        Ok(Self {
            task,
            out,
            written: 0,
            account: Account::default(),
            samples: 0,
            recent: Vec::new(),
            time: None,
            dtau: None,
            closing: None,
            first: None,
            force: task.layout.force.map(|_| ForceCheck::new(task.ledger)),
            head: Vec::new(),
            error: None,
            unended: false,
            stride: 1,
        })
    }

    /// Takes the next chunk with the account of the intervals inside it. False when the trace ends
    /// here, for a mistake.
    pub(crate) fn take(&mut self, mut chunk: Chunk, account: Account) -> Result<bool, TraceError> {
        let lead = self.task.ledger.window() - 1;
        let whole = chunk.samples.len();
        // Intervals that end at the first samples of the chunk reach back beyond it.
        for i in 0..whole.min(lead + 1) {
            if let Err(error) = self.single(&chunk, i) {
                self.fail(error, i);
                return self.flush().map(|()| false);
            }
        }
        if whole > lead + 1 {
            self.keep_head(&chunk, lead + 1);
            self.account.append(account);
            self.recent = chunk
                .samples
                .back_from(whole - 1, self.task.ledger.window());
        }
        if let Some(force) = &mut self.force {
            force.feed(&chunk);
        }
        self.thin_points();
        self.time = chunk.times.pop().or(self.time.take());
        self.dtau = chunk.dtaus.pop().or(self.dtau.take());
        self.closing = chunk.closing.take();
        self.unended = chunk.unended;
        let before = self.samples;
        self.samples += whole as u64;
        self.flush()?;
        if let Some(mut error) = chunk.error.take() {
            error.row = Some(before + error.row.unwrap_or(whole as u64) + 1);
            self.error = Some(error);
            return Ok(false);
        }
        Ok(true)
    }

    fn fail(&mut self, error: TraceError, at: usize) {
        self.samples += at as u64;
        self.error = Some(error.row(self.samples + 1));
        self.closing = None;
    }

    /// The interval that ends at sample `i` of a chunk.
    fn single(&mut self, chunk: &Chunk, i: usize) -> Result<(), TraceError> {
        let Some(sample) = chunk.samples.get(i) else {
            return Ok(());
        };
        let before = i.checked_sub(1);
        let dtau = match before {
            Some(before) => duration(self.task.layout, chunk, before)?,
            None => match (&self.time, chunk.times.first()) {
                (Some(from), Some(to)) => Some(between(self.task.layout, from, to)?),
                _ => self.dtau.clone(),
            },
        };
        if let (None, Some(closing)) = (before, &self.closing)
            && *closing != sample
        {
            let message = "a row of a ledger starts where the row before it ends";
            return Err(TraceError::new("gap", message));
        }
        self.interval(sample, dtau)
    }

    /// The interval from the latest sample to the next.
    fn interval(&mut self, sample: Sample, dtau: Option<Number>) -> Result<(), TraceError> {
        let timed = dtau.is_some();
        let dtau = dtau.unwrap_or(Number::whole(1));
        if let Some(latest) = self.recent.first() {
            if let (Sample::Count(from), Sample::Count(to)) = (latest, &sample) {
                check_jump(*from, *to)?;
            }
            if !crate::number::is_positive(&dtau) {
                let message = "expected a duration above zero";
                return Err(TraceError::new("time", message).column("dtau"));
            }
            if timed {
                self.account.timing.add(&dtau, self.account.intervals);
            }
            if let Some(row) = self.task.ledger.row(&self.recent, &sample, &dtau) {
                enter(
                    self.task,
                    &row,
                    &self.recent,
                    &sample,
                    &dtau,
                    &mut self.account,
                );
                self.account.last = Some(row);
            }
            let mut supply = Supply::default();
            let [least, _] = potential_range(self.task.ledger, &sample);
            supply.lower(&self.account, &Some(least));
            supply.settle(&mut self.account);
            if self.task.points {
                plot(&mut self.account);
            }
        }
        if self.head.len() <= ROWS_IN_REPORT {
            self.head.push((sample.clone(), dtau));
        }
        self.first.get_or_insert_with(|| sample.clone());
        self.recent.insert(0, sample);
        self.recent.truncate(self.task.ledger.window());
        Ok(())
    }

    /// Keeps the first samples of the trace, from sample `from` of a chunk on.
    fn keep_head(&mut self, chunk: &Chunk, from: usize) {
        for i in from..chunk.samples.len() {
            if self.head.len() > ROWS_IN_REPORT {
                return;
            }
            let dtau = i
                .checked_sub(1)
                .map(|i| duration(self.task.layout, chunk, i));
            let dtau = dtau
                .and_then(Result::ok)
                .flatten()
                .unwrap_or(Number::whole(1));
            if let Some(sample) = chunk.samples.get(i) {
                self.head.push((sample, dtau));
            }
        }
    }

    /// Keeps the plot to a bounded number of points, evenly spread.
    fn thin_points(&mut self) {
        while self.account.points.len() > MAX_POINTS {
            self.stride *= 2;
            let mut keep = false;
            self.account.points.retain(|_| {
                keep = !keep;
                keep
            });
        }
    }

    /// Writes the rows that are ready, with their numbers.
    fn flush(&mut self) -> Result<(), TraceError> {
        let rows = std::mem::take(&mut self.account.rows);
        let Some(out) = &mut self.out else {
            return Ok(());
        };
        for line in rows.split_inclusive(|byte| *byte == b'\n') {
            write!(out, "{},", self.written)
                .and_then(|()| out.write_all(line))
                .map_err(|error| TraceError::io(&error))?;
            self.written += 1;
        }
        Ok(())
    }

    /// The report.
    pub(crate) fn finish(mut self, scene: &Scene) -> Result<Audit, TraceError> {
        if let Some(closing) = self.closing.take() {
            let dtau = self.dtau.take();
            if let Err(error) = self.interval(closing, dtau) {
                self.error = Some(error.row(self.samples));
            }
            self.flush()?;
        }
        if let Some(out) = &mut self.out {
            out.flush().map_err(|error| TraceError::io(&error))?;
        }
        // The lowest supply was taken as if the potential at the start were nothing.
        let start: Option<[BigRational; 2]> = self
            .first
            .as_ref()
            .map(|first| potential_range(self.task.ledger, first));
        Ok(Audit::new(
            self.task,
            scene,
            self.account,
            self.samples,
            start,
            self.force,
            self.head,
            self.error,
            self.unended,
        ))
    }
}
