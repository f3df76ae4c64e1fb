//! The work of one core: the account of the intervals inside a chunk.
//!
//! A row of counts depends on nothing but a few small integers, and a trace has few different
//! rows: each is computed once and looked up from then on. Everything else is computed row by row.

use crate::ledger::{Ledger, Logged, Row};
use crate::log::account::{Account, Place};
use crate::log::chunk::{Chunk, Samples};
use crate::log::error::TraceError;
use crate::log::layout::Layout;
use crate::log::running::Lowest;
use crate::log::step::{duration, interval, jump, undefined};
use crate::log::supply::{Contribution, observed, potential};
use crate::log::table::Table;
use crate::number::{Number, Reduced};
use crate::rows;

/// About how many points of a chunk are plotted.
const POINTS: usize = 512;

/// What is asked of every chunk.
#[derive(Clone, Debug)]
pub(crate) struct Task<'a> {
    pub(crate) ledger: &'a Ledger,
    pub(crate) layout: &'a Layout,
    /// Whether rows are written, and how.
    pub(crate) rows: Option<rows::Form>,
    pub(crate) points: bool,
    /// Whether the account is of the forces in the trace.
    pub(crate) applied: bool,
    /// Whether the verdict is about what the operator has drawn so far.
    pub(crate) running: bool,
    /// Whether the forces and velocities of the trace are compared with what they should be.
    pub(crate) compares: bool,
    /// The names of the files, where there are several.
    pub(crate) files: &'a [String],
    /// Whether the columns are read as they were told to be.
    pub(crate) told: bool,
}

impl<'a> Task<'a> {
    /// The account of the forces in the trace where it has any, and of the scene's law else or where
    /// that is asked for.
    pub(crate) fn new(ledger: &'a Ledger, layout: &'a Layout, law: bool) -> Self {
        let applied = layout.force.is_some() && !law;
        Self {
            ledger,
            layout,
            rows: None,
            points: false,
            applied,
            running: applied || ledger.has_memory(),
            compares: true,
            files: &[],
            told: false,
        }
    }

    /// Beside the account of the forces in the trace, that of the wall's own law.
    pub(crate) fn by_law(&self) -> Self {
        Task {
            rows: None,
            points: false,
            applied: false,
            running: self.ledger.has_memory(),
            compares: false,
            ..self.clone()
        }
    }

    /// How many samples before an interval's own a chunk must have for it to be accounted for.
    pub(crate) fn lead(&self) -> usize {
        self.ledger.window() - 1 + usize::from(self.running)
    }

    /// The interval that starts at sample `i` of a chunk.
    pub(crate) fn logged(&self, chunk: &Chunk, i: usize) -> Result<Logged, TraceError> {
        let dtau = duration(self.layout, chunk, i)?.unwrap_or(Number::whole(1));
        let found = interval(chunk, i, self.ledger.window(), self.applied, dtau);
        found.ok_or_else(undefined)
    }
}

/// A row, and what is kept of it.
pub(crate) struct Computed {
    pub(crate) row: Row,
    /// Net energy at the least.
    pub(crate) net: Reduced,
    /// What the observer adds.
    pub(crate) observed: Reduced,
    pub(crate) contribution: Option<Contribution>,
    /// The row as CSV from `dtau` on.
    pub(crate) text: Vec<u8>,
}

impl Computed {
    /// The row of an interval.
    pub(crate) fn of(task: &Task<'_>, interval: &Logged) -> Result<Self, TraceError> {
        Self::defined(task, interval).ok_or_else(undefined)
    }

    fn defined(task: &Task<'_>, interval: &Logged) -> Option<Self> {
        let row = task.ledger.row(interval)?;
        let mut text = Vec::new();
        if let Some(form) = task.rows {
            form.write_account(&row, &mut text)?;
        }
        let contribution = match task.running {
            true => Some(Contribution::of(task.ledger, interval, &row)?),
            false => None,
        };
        Some(Self {
            net: row.least_net()?,
            observed: observed(&row)?,
            contribution,
            text,
            row,
        })
    }

    /// Adds the row of one interval to the account, all but its sums and tallies.
    fn enter(&self, observed: &Reduced, account: &mut Account) -> Result<(), TraceError> {
        account.net.add(&self.net);
        account.observer.add(observed);
        account.intervals += 1;
        if let Some(contribution) = &self.contribution {
            let added = account.supply.add(contribution, account.intervals);
            added.ok_or_else(undefined)?;
        }
        Ok(())
    }

    /// Adds the row of one interval to the account.
    pub(crate) fn account(
        &self,
        task: &Task<'_>,
        interval: &Logged,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        if let Some(form) = task.rows {
            let written = form.write_positions(&self.row, &mut account.rows);
            written.ok_or_else(undefined)?;
            account.rows.extend_from_slice(&self.text);
        }
        let h = account.intervals;
        let place = || {
            Some(Place {
                h,
                interval: interval.clone(),
            })
        };
        let noted = account.note(&self.row, &self.net, h, 1, place);
        noted.ok_or_else(undefined)?;
        self.enter(&self.observed, account)?;
        note_stored(task, &interval.end, account)
    }
}

/// Takes note of net energy plus potential after the latest interval, which ends at `sample`.
fn note_stored(
    task: &Task<'_>,
    sample: &crate::Reading,
    account: &mut Account,
) -> Result<(), TraceError> {
    if task.running {
        return Ok(());
    }
    let [least, _] = potential(task.ledger, sample).ok_or_else(undefined)?;
    Lowest::keep_sum(&mut account.stored, &account.net, &least, account.intervals);
    Ok(())
}

/// What a core keeps from chunk to chunk.
#[derive(Default)]
pub(crate) struct Worker {
    table: Table,
    /// That of net energy, to which the rows of the last chunk led.
    denominator: Option<i128>,
}

impl Worker {
    /// The account of the intervals that start at sample `from` or later and end in the chunk.
    ///
    /// On a mistake the chunk is cut before it.
    pub(crate) fn account(&mut self, task: &Task<'_>, chunk: &mut Chunk, from: usize) -> Account {
        let mut account = Account::default();
        if let Some(denominator) = self.denominator {
            // A course that has the denominator from the start need not change it. That of another
            // course always fits in an empty one.
            let _ = account.net.scaled(0, denominator);
        }
        let mut walk = Walk {
            task,
            from,
            stride: (chunk.samples.len() / POINTS).max(1),
            timed: !chunk.times.is_empty() || !chunk.dtaus.is_empty(),
            even: from,
            at: from,
            key: Vec::new(),
        };
        if let Err(error) = walk.run(&mut self.table, chunk, &mut account) {
            chunk.cut(walk.at, error);
        }
        if let Err(error) = walk.settle(&mut self.table, chunk, &mut account) {
            chunk.cut(walk.at, error);
        }
        self.denominator = account.net.denominator();
        account
    }
}

/// The way through a chunk.
struct Walk<'a> {
    task: &'a Task<'a>,
    from: usize,
    /// How many intervals there are from one point of the plot to the next.
    stride: usize,
    timed: bool,
    /// Up to which sample they are known to come one period apart.
    even: usize,
    /// The sample at the start of the next interval.
    at: usize,
    key: Vec<i64>,
}

impl Walk<'_> {
    fn run(
        &mut self,
        table: &mut Table,
        chunk: &Chunk,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        let last = chunk.samples.len().saturating_sub(1);
        if account.supply.excess.is_none() && self.task.running && self.from > 0 && self.from < last
        {
            account.supply.excess = Some(self.excess_before(chunk)?);
        }
        let unit = Number::whole(1);
        while self.at < last {
            if self.quick(table, chunk, account) {
                if self.timed {
                    account.timing.add(&unit, account.intervals);
                }
                continue;
            }
            let dtau = duration(self.task.layout, chunk, self.at)?;
            jump(&chunk.samples, self.at)?;
            if let (true, Some(dtau)) = (self.timed, &dtau) {
                account.timing.add(dtau, account.intervals);
            }
            self.one(table, chunk, dtau.unwrap_or(unit.clone()), account)?;
            self.at += 1;
            if self.task.points && (self.at - self.from).is_multiple_of(self.stride) {
                account.plot();
            }
        }
        Ok(())
    }

    /// The excess force of the interval before the first one.
    fn excess_before(&self, chunk: &Chunk) -> Result<crate::log::supply::Bounds, TraceError> {
        let before = self.task.logged(chunk, self.from - 1)?;
        let computed = Computed::of(self.task, &before)?;
        match computed.contribution {
            Some(contribution) => Ok(contribution.excess().clone()),
            None => Err(undefined()),
        }
    }

    /// Most traces: counts, one period apart, and nothing but the encoder. Goes as far as it can;
    /// whether that is any further.
    fn quick(&mut self, table: &mut Table, chunk: &Chunk, account: &mut Account) -> bool {
        let task = self.task;
        let Samples::Counts(counts) = &chunk.samples else {
            return false;
        };
        if !task.ledger.is_plain() || task.rows.is_some() || task.running {
            return false;
        }
        if !self.timed {
            self.even = counts.len();
        } else if self.even <= self.at {
            let times = chunk.times.get(self.at..).unwrap_or_default();
            self.even = self.at + task.layout.even(times);
        }
        let counts = counts.get(..=self.even).unwrap_or(counts);
        let stride = task.points.then_some((self.stride, self.from));
        let came = table.quick(counts, self.at, stride, account);
        let any = came > self.at;
        self.at = came;
        any
    }

    /// One interval, by looking its row up or computing it.
    fn one(
        &mut self,
        table: &mut Table,
        chunk: &Chunk,
        dtau: Number,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        let task = self.task;
        let keyed = self.make_key(chunk, &dtau);
        if let (true, Samples::Counts(counts)) = (keyed, &chunk.samples)
            && let Some(known) = table.find(&self.key, self.at, account)
        {
            return known_row(task, known, counts, self.at, account);
        }
        let window = task.ledger.window();
        let interval = interval(chunk, self.at, window, task.applied, dtau);
        let interval = interval.ok_or_else(undefined)?;
        let computed = Computed::of(task, &interval)?;
        if !keyed || table.is_full() {
            return computed.account(task, &interval, account);
        }
        let plain = task.ledger.is_plain() && !task.applied;
        let known = table.insert(&self.key, plain, self.at, computed, account);
        match (known, &chunk.samples) {
            (Some(known), Samples::Counts(counts)) => {
                known_row(task, known, counts, self.at, account)
            }
            _ => Err(undefined()),
        }
    }

    /// The key of an interval of counts: Δτ and what its row depends on. False when it has none.
    fn make_key(&mut self, chunk: &Chunk, dtau: &Number) -> bool {
        self.key.clear();
        let (Samples::Counts(counts), Number::Small(n, d)) = (&chunk.samples, dtau) else {
            return false;
        };
        self.key.extend([*n, *d]);
        let task = self.task;
        if task.ledger.is_plain() && !task.applied {
            let ends = counts.get(self.at).zip(counts.get(self.at + 1));
            self.key
                .extend(ends.map(|(now, next)| next.wrapping_sub(*now)));
            return true;
        }
        if task.applied {
            let force = chunk.forces.get(self.at).map(|force| &force.value);
            let Some(crate::Reading::Exact(Number::Small(n, d))) = force else {
                return false;
            };
            self.key.extend([*n, *d]);
        }
        let from = (self.at + 1).saturating_sub(task.ledger.window());
        let Some(window) = counts.get(from..self.at + 2) else {
            return false;
        };
        self.key.extend(window);
        true
    }

    /// Adds what was looked up to the sums.
    fn settle(
        &self,
        table: &mut Table,
        chunk: &Chunk,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        let task = self.task;
        table.take_hits(|row, net, first, times| {
            let h = (first - self.from) as u64;
            let place = || {
                let interval = task.logged(chunk, first).ok()?;
                Some(Place { h, interval })
            };
            let noted = account.note(row, net, h, times, place);
            noted.ok_or_else(undefined)
        })?;
        if account.intervals > 0 {
            account.last = Some(task.logged(chunk, self.at - 1)?);
        }
        Ok(())
    }
}

/// Adds an interval of counts whose row is known to the account, all but its sums and tallies.
fn known_row(
    task: &Task<'_>,
    known: &Computed,
    counts: &[i64],
    i: usize,
    account: &mut Account,
) -> Result<(), TraceError> {
    let ends = counts.get(i).zip(counts.get(i + 1));
    let (now, next) = ends.ok_or_else(undefined)?;
    if task.rows.is_some() {
        let (now, next) = (i128::from(*now), i128::from(*next));
        let ends = format!(",{now},{},{next},{}", now + 1, next + 1);
        account.rows.extend_from_slice(ends.as_bytes());
        account.rows.extend_from_slice(&known.text);
    }
    if task.ledger.is_plain() && !task.applied {
        // The row is that of every interval as long; what the observer adds is not.
        let (now, next) = (i128::from(*now), i128::from(*next));
        let twice = (2 * now + 1) * (next - now);
        let half = match twice % 2 {
            0 => Reduced::Small(twice / 2, 1),
            _ => Reduced::Small(twice, 2),
        };
        known.enter(&half, account)?;
    } else {
        known.enter(&known.observed, account)?;
    }
    note_stored(task, &crate::Reading::Count(*next), account)
}
