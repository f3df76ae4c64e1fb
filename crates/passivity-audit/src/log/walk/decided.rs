//! Intervals whose rows doubles decide.

use super::Walk;
use crate::ball::Ball;
use crate::ledger::Read;
use crate::log::account::Account;
use crate::log::batch::Batch;
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::is_exact;
use crate::log::counted::Figures;
use crate::log::known::Known;
use crate::log::lanes::{Length, TILE, Under};
use crate::log::motion::Addend;
use crate::log::step::check_jump;
use crate::log::supply;
use crate::number::Number;
use crate::reading::Reading;

impl Walk<'_> {
    /// Most other traces: positions, and counts that no table has. Adds intervals that were computed several at a
    /// time, as far as doubles decide and no point is plotted; whether there is any.
    pub(super) fn tiles(
        &mut self,
        batch: &mut Batch,
        chunk: &Chunk,
        account: &mut Account,
    ) -> bool {
        let (task, start) = (self.task, self.at);
        while self.at < self.until {
            let mut most = self.until - self.at;
            if task.points {
                most = most.min(self.stride - (self.at - self.from) % self.stride);
            }
            let h = account.intervals + batch.intervals;
            let noted = self.noted;
            let Some(lengths) = self.tile(batch, chunk, most).filter(|of| !of.is_empty()) else {
                break;
            };
            let added = lengths.len();
            if noted {
                account.timing.add_all(lengths, h);
            }
            self.at += added;
            if self.is_point() {
                break;
            }
        }
        self.at > start
    }

    /// Adds what is decided in the tile of the next interval, as many as are asked for: how long they are; `None` where
    /// there is no tile.
    fn tile(&mut self, batch: &mut Batch, chunk: &Chunk, most: usize) -> Option<&[Length]> {
        let (task, at) = (self.task, self.at);
        let applied = task.applied;
        match &chunk.samples {
            Samples::Any(_) => {
                let (tile, from) = (self.tiles.tiles.get(at / TILE)?, at % TILE);
                let rows = from..tile.decided(from, from + most, applied);
                let mut under = Under::new(tile, applied);
                let added = batch.add_tile((&mut under, rows), task.running);
                self.tiles.lengths.get(at..at + added)
            }
            Samples::Counts(counts) => {
                let mut most = most;
                if task.sums_alone() {
                    match self.by_law.from(at) {
                        Some((rows, answers)) if rows.at == at && rows.len <= most => {
                            let added = batch.add_by_law(rows, answers);
                            return self.tiles.lengths.get(at..at + added);
                        }
                        Some((rows, _)) if rows.at > at => most = most.min(rows.at - at),
                        _ => {}
                    }
                }
                self.compute_counts(chunk, counts)?;
                let rows = self.counted.decided(at, most);
                let from = rows.start;
                let added = batch.add_tile((&mut *self.counted, rows), task.running);
                Some(self.counted.lengths(from..from + added))
            }
        }
    }

    /// Computes the rows from here on, where that was not done yet; `None` of loops that are no plain walls.
    fn compute_counts(&mut self, chunk: &Chunk, counts: &[i64]) -> Option<()> {
        let (task, i) = (self.task, self.at);
        if !self.counted.has(i) {
            let known = self.tiles.lengths.get(i..).unwrap_or_default();
            let found: Vec<Length>;
            let lengths = match known {
                [] => {
                    let rows = i..counts.len().min(i + TILE);
                    found = rows.map(|i| Length::of(task.layout, chunk, i)).collect();
                    &found
                }
                known => known,
            };
            let forces = task.applied.then_some(&chunk.forces.values);
            let quick = self.tiles.quick.as_ref()?;
            let by_law = task.has_by_law().then_some(&mut *self.by_law);
            self.counted
                .fill(quick, (counts, forces), i, lengths, by_law);
        }
        Some(())
    }

    /// One of them, or one of counts: adds the next interval, which lasts so long; `None` where doubles leave
    /// something open, or its row is an exact one.
    pub(super) fn known(&mut self, batch: &mut Batch, chunk: &Chunk, dtau: &Number) -> Option<()> {
        let (task, i) = (self.task, self.at);
        let samples = match &chunk.samples {
            Samples::Any(samples) => samples,
            Samples::Counts(counts) => return self.counted(batch, (chunk, counts), dtau),
        };
        if task.ledger.has_memory() {
            return None;
        }
        let known = Known::of(
            (task.ledger.near(), task.reach()),
            &mut self.starts,
            [samples.ball(i)?, samples.ball(i + 1)?],
            samples.written.is_same(i, i + 1),
            &Ball::of(dtau),
        )?;
        let force = match task.applied {
            true => Some(chunk.forces.values.ball(i)?),
            false => None,
        };
        batch.add_known(&known.addend(force)?, task.running)
    }

    /// The same of counts, of which several are computed at a time.
    fn counted(
        &mut self,
        batch: &mut Batch,
        (chunk, counts): (&Chunk, &[i64]),
        dtau: &Number,
    ) -> Option<()> {
        let (task, i) = (self.task, self.at);
        let (from, to) = (*counts.get(i)?, *counts.get(i + 1)?);
        check_jump(from, to).ok()?;
        if is_exact(task, &Reading::Count(to), dtau) {
            return None;
        }
        self.compute_counts(chunk, counts)?;
        let bent = || {
            let wall = task.wall.as_ref()?;
            let force = match task.applied {
                true => Some(chunk.forces.values.ball(i)?),
                false => None,
            };
            Figures::bent(wall, [from, to], Ball::of(dtau), force)
        };
        let figures = self.counted.get(i).or_else(bent)?;
        let supply = match task.running {
            true => Some(figures.contribution().supplied(batch.excess())?),
            false => None,
        };
        if supply.as_ref().is_some_and(|supply| !supply.fits()) {
            return None;
        }
        batch.add(&figures.addend(), supply)
    }

    /// Adds the next interval; `None` where doubles leave something open, or its row is an exact one.
    pub(super) fn add_to(&self, batch: &mut Batch, chunk: &Chunk, dtau: &Number) -> Option<()> {
        let (task, i) = (self.task, self.at);
        let ledger = task.ledger;
        let before = task.running.then(|| batch.excess());
        let force = match task.applied {
            true => Some(chunk.forces.get(i)?),
            false => None,
        };
        let (start, end) = (chunk.samples.get(i)?, chunk.samples.get(i + 1)?);
        if is_exact(task, &end, dtau) {
            return None;
        }
        if let (Reading::Count(from), Reading::Count(to)) = (&start, &end) {
            check_jump(*from, *to).ok()?;
        }
        let earlier;
        let read = Read {
            samples: match ledger.window() {
                1 => std::slice::from_ref(&start).iter(),
                window => {
                    earlier = chunk.samples.back_from(i, window);
                    earlier.iter()
                }
            },
            end: &end,
            force: force.as_ref(),
        };
        let row = ledger.near_entry(read, dtau)?;
        let addend = Addend::of_entry(ledger.near(), &row)?;
        let supply = match before {
            Some(before) => {
                let contribution = supply::contribution(ledger.near(), &row)?;
                let supply = contribution.supplied(before)?;
                supply.fits().then_some(Some(supply))?
            }
            None => None,
        };
        batch.add(&addend, supply)
    }
}
