//! Joins the chunks of a trace: the intervals between them, and one account for all.

use std::io::Write;

use crate::ledger::Logged;
use crate::log::account::Account;
use crate::log::chunk::Chunk;
use crate::log::comparison::Comparison;
use crate::log::computed::Computed;
use crate::log::error::TraceError;
use crate::log::found::{Findings, ROWS_IN_REPORT};
use crate::log::held::Held;
use crate::log::report::UnendedRow;
use crate::log::running::near_number;
use crate::log::step::{between, check_jump, duration, gap, undefined};
use crate::log::task::Task;
use crate::log::ticks::Ticks;
use crate::log::velocity::Velocities;
use crate::log::wraps::Wraps;
use crate::number::Number;
use crate::reading::Reading;

/// The most points that a plot is made of.
const MAX_POINTS: usize = 8192;

/// What a sample of the trace starts: how long it lasts and under which force, where that is said.
#[derive(Clone, Debug, Default)]
pub(crate) struct Onward {
    time: Option<Number>,
    dtau: Option<Number>,
    force: Option<Reading>,
}

/// The account so far, and what the next chunk needs of the chunks before it.
pub(crate) struct Merge<'a, 'w> {
    task: &'a Task<'a>,
    out: Option<&'w mut (dyn Write + 'w)>,
    written: u64,
    /// The room of the rows that were written last.
    room: Vec<u8>,
    account: Account,
    samples: u64,
    /// The latest samples, the latest first.
    recent: Vec<Reading>,
    /// What the latest of them starts.
    onward: Onward,
    /// In a ledger: where the latest row ends.
    closing: Option<Reading>,
    first: Option<Reading>,
    /// When the first sample was taken.
    began: Option<Number>,
    /// How long the rows of a ledger last so far, in periods, for the plot.
    lasted: f64,
    comparison: Option<Comparison>,
    velocities: Option<Velocities>,
    wraps: Option<Wraps>,
    ticks: Option<Ticks>,
    held: Held,
    /// The first intervals, for the rows in the report.
    head: Vec<Logged>,
    error: Option<TraceError>,
    unended: bool,
    /// The last rows of files before this one that lack their line break.
    unended_rows: Vec<UnendedRow>,
    /// Which file is being read, and how many samples came before it.
    file: usize,
    before_file: u64,
}

impl<'a, 'w> Merge<'a, 'w> {
    pub(crate) fn new(
        task: &'a Task<'a>,
        mut out: Option<&'w mut (dyn Write + 'w)>,
    ) -> Result<Self, TraceError> {
        if let (Some(out), Some(form)) = (&mut out, task.rows) {
            writeln!(out, "{}", form.header()).map_err(|error| TraceError::io(&error))?;
        }
        let compared = task.compares_forces();
        let moved = task.compares && task.layout.velocity.is_some();
        Ok(Self {
            task,
            out,
            written: 0,
            room: Vec::new(),
            account: Account::default(),
            samples: 0,
            recent: Vec::new(),
            onward: Onward::default(),
            closing: None,
            first: None,
            began: None,
            lasted: 0.0,
            comparison: compared.then(|| Comparison::new(task.ledger)),
            velocities: moved.then(Velocities::default),
            wraps: Wraps::new(&task.periods).filter(|_| task.compares),
            ticks: Ticks::new(task),
            held: Held::default(),
            head: Vec::new(),
            error: None,
            unended: false,
            unended_rows: Vec::new(),
            file: 0,
            before_file: 0,
        })
    }

    /// Takes the samples up to the first one that is accounted for: intervals after it look back to them.
    pub(crate) fn lead(&mut self, chunk: &Chunk) -> Result<(), TraceError> {
        let Some(last) = chunk.samples.len().checked_sub(1) else {
            return Ok(());
        };
        self.recent = chunk.samples.back_from(last, self.task.ledger.window());
        self.onward = onward(chunk, last);
        self.closing.clone_from(&chunk.closing);
        self.unended = chunk.unended;
        if let (true, Some(before)) = (self.task.running, last.checked_sub(1)) {
            let interval = self.task.logged(chunk, before)?;
            let computed = Computed::of(self.task, &interval)?;
            let contribution = computed.contribution.ok_or_else(undefined)?;
            self.account.supply.excess = Some(contribution.excess().clone());
        }
        self.compare(chunk, chunk.samples.len(), None)?;
        self.comparison.iter_mut().for_each(Comparison::forget);
        self.velocities.iter_mut().for_each(Velocities::forget);
        self.wraps.iter_mut().for_each(Wraps::forget);
        self.ticks.iter_mut().for_each(Ticks::forget);
        Ok(())
    }

    /// Compares the forces, velocities and steps of the first `rows` samples of a chunk, given what was found inside of it where
    /// that is all of them.
    fn compare(
        &mut self,
        chunk: &Chunk,
        rows: usize,
        inside: Option<Comparison>,
    ) -> Result<(), TraceError> {
        if let Some(comparison) = &mut self.comparison {
            match inside {
                Some(inside) => comparison.take(chunk, inside)?,
                None => comparison.feed(chunk, rows)?,
            }
        }
        if let Some(velocities) = &mut self.velocities {
            velocities.feed(self.task.layout, chunk, rows)?;
        }
        if let Some(wraps) = &mut self.wraps {
            wraps.feed(self.task.layout, chunk, rows);
        }
        if let Some(ticks) = &mut self.ticks {
            ticks.feed(chunk, rows);
        }
        self.held.feed(chunk, rows);
        Ok(())
    }

    /// Takes the next chunk with the account of the intervals inside it and the comparison of its forces, as far as that
    /// was made. False when the trace ends here, for a mistake.
    pub(crate) fn take(
        &mut self,
        chunk: &Chunk,
        (account, inside): (Account, Option<Comparison>),
    ) -> Result<bool, TraceError> {
        let whole = chunk.samples.len();
        // A file without rows is none.
        let has_any = whole > 0 || chunk.error.is_some();
        if has_any && chunk.file != self.file {
            if std::mem::take(&mut self.unended) {
                let (file, row) = (self.file_name(), self.samples - self.before_file);
                self.unended_rows.push(UnendedRow { file, row });
            }
            self.file = chunk.file;
            self.before_file = self.samples;
        }
        if self.began.is_none() {
            self.began = chunk.times.get(0);
        }
        let (lead, plotted) = (self.task.lead(), self.account.points.len());
        // Intervals that end at the first samples of the chunk reach back beyond it.
        for i in 0..whole.min(lead + 1) {
            if let Err(error) = self.single(chunk, i) {
                self.time_points(plotted, chunk);
                self.samples += i as u64;
                self.error = Some(self.placed(error, self.samples + 1));
                self.unended = false;
                self.compare(chunk, i, None)?;
                return self.flush().map(|()| false);
            }
        }
        if whole > lead + 1 {
            self.keep_head(chunk, lead)?;
            // The rows of a chunk are many: with none before them they are not copied.
            self.flush()?;
            self.account.append(account);
            let window = self.task.ledger.window();
            self.recent = chunk.samples.back_from(whole - 1, window);
            self.onward = onward(chunk, whole - 1);
        }
        self.compare(chunk, whole, inside)?;
        self.time_points(plotted, chunk);
        self.thin_points();
        if whole > 0 {
            self.closing.clone_from(&chunk.closing);
        }
        if has_any {
            self.unended = chunk.unended;
        }
        let before = self.samples;
        self.samples += whole as u64;
        self.flush()?;
        if let Some(error) = chunk.error.clone() {
            let row = before + error.row.unwrap_or(whole as u64) + 1;
            self.error = Some(self.placed(error, row));
            return Ok(false);
        }
        Ok(true)
    }

    /// The error at a row of the log, counted from 1, as the row of its file.
    fn placed(&self, mut error: TraceError, row: u64) -> TraceError {
        error.file = self.file_name();
        error.row(row - self.before_file)
    }

    /// The file that is being read, where there are several.
    fn file_name(&self) -> Option<String> {
        self.task.files.get(self.file).cloned()
    }

    /// The interval that ends at sample `i` of a chunk.
    fn single(&mut self, chunk: &Chunk, i: usize) -> Result<(), TraceError> {
        let Some(sample) = chunk.samples.get(i) else {
            return Ok(());
        };
        let dtau = match (i.checked_sub(1), &self.onward.time, chunk.times.get(0)) {
            (Some(before), _, _) => duration(self.task.layout, chunk, before)?,
            (None, Some(from), Some(to)) => Some(between(self.task.layout, from, &to)?),
            (None, _, _) => self.onward.dtau.clone(),
        };
        // In a ledger the last row before the chunk says itself where it ends.
        let end = self.closing.take().filter(|_| i == 0);
        let is_gap = end.as_ref().is_some_and(|end| *end != sample);
        self.interval(end.unwrap_or(sample), dtau)?;
        if is_gap {
            return Err(gap(self.task.layout));
        }
        self.onward = onward(chunk, i);
        Ok(())
    }

    /// The interval from the latest sample to the next.
    fn interval(&mut self, sample: Reading, dtau: Option<Number>) -> Result<(), TraceError> {
        if let Some(latest) = self.recent.first() {
            if let (Reading::Count(from), Reading::Count(to)) = (latest, &sample) {
                check_jump(*from, *to)?;
            }
            if let (true, Some(dtau)) = (self.task.compares, &dtau) {
                self.account.timing.add(dtau, self.account.intervals);
            }
            let force = self.onward.force.take().filter(|_| self.task.applied);
            let interval = Logged {
                samples: std::mem::take(&mut self.recent),
                end: sample.clone(),
                dtau: dtau.unwrap_or(Number::whole(1)),
                force,
            };
            let computed = Computed::of(self.task, &interval)?;
            computed.account(self.task, &interval, &mut self.account)?;
            if self.task.points {
                self.account.plot();
            }
            self.recent.clone_from(&interval.samples);
            self.account.last = Some(interval.clone());
            if self.head.len() < ROWS_IN_REPORT {
                self.head.push(interval);
            }
        }
        self.first.get_or_insert_with(|| sample.clone());
        self.recent.insert(0, sample);
        self.recent.truncate(self.task.ledger.window());
        Ok(())
    }

    /// Keeps the first intervals of the trace, from the one that starts at sample `from` of a chunk.
    fn keep_head(&mut self, chunk: &Chunk, from: usize) -> Result<(), TraceError> {
        for i in from..chunk.samples.len() - 1 {
            if self.head.len() >= ROWS_IN_REPORT {
                break;
            }
            self.head.push(self.task.logged(chunk, i)?);
        }
        Ok(())
    }

    /// Says when the samples of a chunk were taken to which the points from the first `plotted` on belong.
    fn time_points(&mut self, plotted: usize, chunk: &Chunk) {
        if !self.task.points {
            return;
        }
        let mut lasted = 0;
        let mut dtaus = chunk.dtaus.iter().map(near_number);
        let mut points = std::mem::take(&mut self.account.points);
        for point in points.iter_mut().skip(plotted) {
            // Interval h ends at sample h, counted from 0.
            let i = usize::try_from(point.h.saturating_sub(self.samples)).unwrap_or(usize::MAX);
            self.lasted += dtaus.by_ref().take(i.saturating_sub(lasted)).sum::<f64>();
            lasted = i;
            let times = self.began.as_ref().zip(chunk.times.get(i));
            let clock = times.and_then(|(from, to)| self.task.layout.duration(from, &to));
            point.time = match clock {
                Some(time) => near_number(&time),
                None => self.without_a_clock(point.h),
            };
        }
        self.account.points = points;
        self.lasted += dtaus.sum::<f64>();
    }

    /// When so many intervals are over by how long rows of a ledger last, or are taken to.
    #[allow(clippy::cast_precision_loss)] // for a picture
    fn without_a_clock(&self, h: u64) -> f64 {
        match self.task.layout.dtau {
            Some(_) => self.lasted,
            None => h as f64,
        }
    }

    /// Keeps the plot to a bounded number of points, evenly spread.
    fn thin_points(&mut self) {
        while self.account.points.len() > MAX_POINTS {
            let mut keep = false;
            self.account.points.retain(|_| {
                keep = !keep;
                keep
            });
        }
    }

    /// Writes the rows that are ready, with their numbers.
    fn flush(&mut self) -> Result<(), TraceError> {
        let mut rows = std::mem::take(&mut self.account.rows);
        let Some(out) = &mut self.out else {
            return Ok(());
        };
        let mut number = itoa::Buffer::new();
        let mut start = 0;
        for end in memchr::memchr_iter(b'\n', &rows) {
            let row = rows.get(start..=end).unwrap_or_default();
            out.write_all(number.format(self.written).as_bytes())
                .and_then(|()| out.write_all(row))
                .map_err(|error| TraceError::io(&error))?;
            self.written += 1;
            start = end + 1;
        }
        rows.clear();
        self.room = rows;
        Ok(())
    }

    /// Gives away the room of the rows that were written last.
    pub(crate) fn room(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.room)
    }

    /// How many samples were taken.
    pub(crate) const fn samples(&self) -> u64 {
        self.samples
    }

    /// What is said of a stretch that cannot be read, for what stands before it cannot.
    pub(crate) fn fail(mut self, error: TraceError) -> Findings {
        self.error = Some(error.row(0));
        self.findings(false)
    }

    /// All that was found. What the last row of a ledger says of its end is one more interval where the log
    /// `ends` there.
    pub(crate) fn finish(mut self, ends: bool) -> Result<Findings, TraceError> {
        if let Some(closing) = self.closing.take().filter(|_| ends || self.error.is_some()) {
            let dtau = self.onward.dtau.take();
            if let Err(error) = self.interval(closing, dtau) {
                self.error = Some(self.placed(error, self.samples));
            }
            let time = self.without_a_clock(self.account.intervals);
            if let Some(last) = self.account.points.last_mut() {
                last.time = time;
            }
            self.flush()?;
        }
        if let Some(out) = &mut self.out {
            out.flush().map_err(|error| TraceError::io(&error))?;
        }
        let ends = ends || self.error.is_some();
        Ok(self.findings(ends))
    }

    fn findings(mut self, ends: bool) -> Findings {
        if let Some(comparison) = &mut self.comparison {
            comparison.settle();
        }
        let times = self.began.as_ref().zip(self.onward.time.as_ref());
        let duration = times.and_then(|(from, to)| self.task.layout.duration(from, to));
        Findings {
            duration,
            file: self.file_name(),
            before_file: self.before_file,
            account: self.account,
            samples: self.samples,
            first: self.first,
            comparison: self.comparison,
            velocities: self.velocities,
            wrapped: self
                .wraps
                .map(|wraps| wraps.finish(self.task.layout, ends))
                .unwrap_or_default(),
            steps: self.ticks.map(|ticks| ticks.found).unwrap_or_default(),
            held: self.held,
            head: self.head,
            error: self.error,
            unended: self.unended,
            unended_rows: self.unended_rows,
        }
    }
}

/// What sample `i` of a chunk starts.
fn onward(chunk: &Chunk, i: usize) -> Onward {
    Onward {
        time: chunk.times.get(i),
        dtau: chunk.dtaus.get(i).cloned(),
        force: chunk.forces.get(i),
    }
}
