//! The way through a chunk.
//!
//! A row of counts depends on nothing but a few small integers, and a trace has few different
//! rows: each is computed once and looked up from then on. Everything else is computed row by row, in
//! doubles and in batches as far as these decide.

mod decided;

use crate::log::account::{Account, Place};
use crate::log::batch::Batch;
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::{Computed, Text, UNIT, note_stored};
use crate::log::error::TraceError;
use crate::log::known::Starts;
use crate::log::lanes::{Counted, ManyByLaw, Tiles, write};
use crate::log::step::{duration, interval, jump, undefined};
use crate::log::table::Table;
use crate::log::task::Task;
use crate::log::wall::Part;
use crate::number::{Number, Reduced};
use crate::reading::Reading;

/// The way through a chunk.
pub(super) struct Walk<'a> {
    pub(super) task: &'a Task<'a>,
    pub(super) from: usize,
    /// The sample at which it ends.
    pub(super) until: usize,
    /// How many intervals there are from one point of the plot to the next.
    pub(super) stride: usize,
    pub(super) timed: bool,
    /// Whether the account says how long intervals were.
    pub(super) noted: bool,
    /// Up to which sample they are known to come one period apart.
    pub(super) even: usize,
    /// The sample at the start of the next interval.
    pub(super) at: usize,
    pub(super) key: Vec<i64>,
    pub(super) starts: Starts,
    /// The rows that were computed several at a time.
    pub(super) tiles: &'a Tiles,
    /// Those of counts.
    pub(super) counted: &'a mut Counted,
    /// What they come to under the force of the wall, beside that in the log.
    pub(super) by_law: &'a mut ManyByLaw,
}

impl Walk<'_> {
    pub(super) fn run(
        &mut self,
        table: &mut Table,
        chunk: &Chunk,
        account: &mut Account,
    ) -> Result<(), TraceError> {
        if account.supply.excess.is_none()
            && self.task.running
            && self.from > 0
            && self.from < self.until
        {
            account.supply.excess = Some(self.excess_before(chunk)?);
        }
        while self.at < self.until {
            if self.quick(table, chunk, account) {
                if self.noted {
                    account.timing.add(&UNIT, account.intervals);
                }
                continue;
            }
            let dtau = duration(self.task.layout, chunk, self.at)?;
            let lasts = dtau.clone().unwrap_or(UNIT);
            if !self.task.looks_up(chunk, self.at, &lasts) && self.batch(chunk, account)? {
                continue;
            }
            jump(&chunk.samples, self.at)?;
            if let (true, Some(dtau)) = (self.noted, &dtau) {
                account.timing.add(dtau, account.intervals);
            }
            self.one(table, chunk, lasts.reduced(), account)?;
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
        let Some(parts) = task.parts.as_ref().filter(|_| !task.running) else {
            return false;
        };
        if !self.timed {
            self.even = counts.len();
        } else if self.even <= self.at {
            self.even = self.at + task.layout.even(&chunk.times, self.at);
        }
        let counts = counts.get(..=self.even.min(self.until)).unwrap_or(counts);
        let stride = task.points.then_some((self.stride, self.from));
        let came = match task.sums_alone() {
            true => table.tally((counts, parts), self.at, account),
            false => table.quick((counts, parts), self.at, stride, account),
        };
        if task.rows.is_some() {
            let rows = counts.get(self.at..=came).unwrap_or_default();
            table.write((rows, parts), &mut account.rows);
        }
        let any = came > self.at;
        self.at = came;
        any
    }

    /// Intervals whose rows doubles decide, as far as they do; whether there is any.
    fn batch(&mut self, chunk: &Chunk, account: &mut Account) -> Result<bool, TraceError> {
        let task = self.task;
        let start = self.at;
        let mut batch = Batch::after(account.supply.excess.clone(), task.sums_alone());
        let mut came = Ok(());
        while self.at < self.until {
            if !self.tiles(&mut batch, chunk, account) {
                let dtau = match duration(task.layout, chunk, self.at) {
                    Ok(dtau) => dtau,
                    Err(error) => {
                        came = Err(error);
                        break;
                    }
                };
                let unit = UNIT;
                let lasts = dtau.as_ref().unwrap_or(&unit);
                if task.looks_up(chunk, self.at, lasts) {
                    break;
                }
                let known = self.known(&mut batch, chunk, lasts);
                if known
                    .or_else(|| self.add_to(&mut batch, chunk, lasts))
                    .is_none()
                {
                    break;
                }
                if let (true, Some(dtau)) = (self.noted, &dtau) {
                    account
                        .timing
                        .add(dtau, account.intervals + batch.intervals - 1);
                }
                self.at += 1;
            }
            if self.is_point() {
                break;
            }
        }
        if batch.intervals > 0 {
            let place = |h: u64| {
                let i = start + usize::try_from(h).map_err(|_| undefined())?;
                let interval = task.logged(chunk, i)?;
                Ok(Place { h, interval })
            };
            account.append(batch.account(task.running, place)?);
            if let Some(form) = task.rows {
                let mut text = Text::default();
                let alone = |i: usize, rows: &mut Vec<u8>| {
                    let filled = text.fill(task, &task.logged(chunk, i)?, form);
                    filled.ok_or_else(undefined)?;
                    text.append_to(rows);
                    Ok(())
                };
                let rows = start..self.at;
                write((self.tiles, chunk), rows, form, &mut account.rows, alone)?;
            }
            if self.is_point() {
                account.plot();
            }
        }
        came.map(|()| self.at > start)
    }

    /// Whether the sample that has been come to is one at which a point is plotted.
    const fn is_point(&self) -> bool {
        let came = self.at - self.from;
        self.task.points && came > 0 && came.is_multiple_of(self.stride)
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
        let known = table.insert(&self.key, self.at, computed, account);
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
        let ends = counts.get(self.at).zip(counts.get(self.at + 1));
        if let Some((now, next)) = ends
            && let Some(part) = task.part(*now, *next)
            && let Some(key) = Table::key(part, [*now, *next])
        {
            // Others have one more at least.
            self.key.push(key);
            return true;
        }
        if task.applied {
            let force = chunk.forces.get(self.at);
            let Some(crate::Reading::Exact(Number::Small(n, d))) = force else {
                return false;
            };
            self.key.extend([n, d]);
        }
        let from = (self.at + 1).saturating_sub(task.ledger.window());
        let Some(window) = counts.get(from..self.at + 2) else {
            return false;
        };
        self.key.extend(window);
        true
    }

    /// Adds what was looked up to the sums.
    pub(super) fn settle(
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
        known
            .written
            .append_between([*now, *next], &mut account.rows);
    }
    if task.part(*now, *next) == Some(Part::Linear) {
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
    note_stored(task, &known.row, &Reading::Count(*next), account)
}
