//! One core's work: the account of the intervals inside a chunk.
//!
//! A row of counts depends on nothing but a few small integers, and a trace has few different
//! rows: each is computed once and looked up from then on. Everything else is computed row by row.

use std::collections::HashMap;

use passivity_core::{BigRational, Truth};

use crate::audit::account::{Account, Point, Spot, kinds};
use crate::audit::chunk::{Chunk, Samples};
use crate::audit::error::TraceError;
use crate::audit::layout::Layout;
use crate::audit::step::{duration, jump};
use crate::audit::supply::{Supply, observed, potential};
use crate::ledger::{Ledger, Row, Sample};
use crate::number::Number;

/// How many different rows are kept at once.
const MAX_ROWS: usize = 1 << 15;

/// Steps of up to this many ticks are looked up without hashing.
const SMALL_STEP: i64 = 512;

/// About how many points of a chunk are plotted.
const POINTS: usize = 512;

/// What is asked of every chunk.
#[derive(Clone, Debug)]
pub(crate) struct Task<'a> {
    pub(crate) ledger: &'a Ledger,
    pub(crate) layout: &'a Layout,
    /// Whether rows are written, and whether with both ends of every figure.
    pub(crate) rows: Option<bool>,
    pub(crate) points: bool,
}

/// A row that was computed before.
struct Known {
    row: Row,
    truths: [Truth; 3],
    net: Result<(i128, i128), BigRational>,
    /// `net` over the course's denominator, which is kept beside it.
    scaled: (i128, i128),
    /// Work on the observer over the interval, when it depends on nothing but the key.
    observed: Option<Result<(i128, i128), BigRational>>,
    hits: u64,
    first: usize,
    /// The row as CSV from `dtau` on.
    text: Vec<u8>,
}

/// What a core keeps from chunk to chunk.
#[derive(Default)]
pub(crate) struct Worker {
    known: Vec<Known>,
    small: Vec<u32>,
    index: HashMap<Box<[i64]>, u32>,
    denominator: i128,
}

/// How an interval is found again.
enum Found {
    Known(usize),
    /// Too many different rows, or a Δτ too long to be a key.
    Fresh(Box<Row>),
}

impl Worker {
    /// The account of the intervals that start at sample `from` or later and end in the chunk.
    ///
    /// On a mistake the chunk is cut before it.
    pub(crate) fn account(&mut self, task: &Task<'_>, chunk: &mut Chunk, from: usize) -> Account {
        let mut account = Account::default();
        // The denominator that the rows of the last chunk led to.
        let _ = account.net.scaled(0, self.denominator.max(1));
        let last = chunk.samples.len().saturating_sub(1);
        let stride = (chunk.samples.len() / POINTS).max(1);
        let plain = task.ledger.model().is_plain();
        let unit = Number::whole(1);
        let timed = !chunk.times.is_empty() || !chunk.dtaus.is_empty();
        let mut supply = Supply::default();
        let mut key = Vec::new();
        let mut i = from;
        // Up to which sample they are known to come one period apart.
        let mut even = if timed { i } else { last };
        while i < last {
            // Most traces: counts, one period apart, and nothing but the encoder.
            let quick = match &chunk.samples {
                Samples::Counts(counts) if plain && task.rows.is_none() => {
                    if even <= i {
                        even = i + task.layout.even(chunk.times.get(i..).unwrap_or_default());
                    }
                    self.quick(
                        counts.get(..=even).unwrap_or(counts),
                        i,
                        from,
                        task.points.then_some(stride),
                        &mut account,
                        &mut supply,
                    )
                }
                _ => i,
            };
            if quick > i {
                if timed {
                    account.timing.add(&unit, account.intervals);
                }
                i = quick;
                continue;
            }
            let dtau = match duration(task.layout, chunk, i) {
                Ok(Some(dtau)) => dtau,
                Ok(None) => unit.clone(),
                Err(error) => {
                    cut(chunk, i, error);
                    break;
                }
            };
            if let Err(error) = jump(&chunk.samples, i) {
                cut(chunk, i, error);
                break;
            }
            if timed {
                account.timing.add(&dtau, account.intervals);
            }
            self.slow(task, chunk, i, &dtau, &mut account, &mut key);
            let potential = potential(task.ledger, &chunk.samples, i + 1);
            supply.lower(&account, &potential);
            if task.points && (i + 1 - from).is_multiple_of(stride) {
                plot(&mut account);
            }
            i += 1;
        }
        self.settle(task, chunk, from, &mut account);
        supply.settle(&mut account);
        self.denominator = account.net.denominator().unwrap_or(1);
        account
    }

    /// Goes through plain counts from `i` on as long as their steps are known, machine integers
    /// hold the courses and nothing is out of the ordinary; gives how far it came.
    fn quick(
        &mut self,
        counts: &[i64],
        mut i: usize,
        from: usize,
        stride: Option<usize>,
        account: &mut Account,
        supply: &mut Supply,
    ) -> usize {
        let (Some(denominator), Some(2)) = (
            account.net.denominator(),
            account
                .observer
                .scaled(0, 2)
                .and(account.observer.denominator()),
        ) else {
            return i;
        };
        if self.small.is_empty() {
            return i;
        }
        // Positions below this keep the potential over the denominator, and the observer's steps,
        // within 125 bits.
        let near = ((1_i128 << 125) / denominator).isqrt().min(1 << 40);
        let near = u64::try_from(near).unwrap_or(0).saturating_sub(2);
        let mut lowest = supply.twice_lowest(denominator);
        let start = i;
        let mut next_point = stride.map_or(usize::MAX, |stride| i + stride - (i - from) % stride);
        while let Some([now, next]) = counts.get(i..i + 2) {
            let step = next.wrapping_sub(*now);
            let place = step.wrapping_add(SMALL_STEP);
            let slot = usize::try_from(place)
                .ok()
                .and_then(|place| self.small.get(place));
            let known = slot.and_then(|id| self.known.get_mut(*id as usize));
            let Some(known) = known else { break };
            if known.scaled.1 != denominator
                || now.unsigned_abs() > near
                || next.unsigned_abs() > near
                || account.net.now().unsigned_abs() > 1 << 124
                || !account.net.add_scaled(known.scaled.0)
            {
                break;
            }
            if known.hits == 0 {
                known.first = i;
            }
            known.hits += 1;
            account
                .observer
                .add_scaled(i128::from(2 * now + 1) * i128::from(step));
            // Twice the least of net energy plus ½ξ² over the cell, over the denominator.
            let nearest = i128::from(if *next < 0 { next + 1 } else { *next });
            let twice = 2 * account.net.now() + nearest * nearest * denominator;
            i += 1;
            if twice < lowest.0 {
                lowest = (twice, account.intervals + (i - start) as u64);
            }
            if i == next_point {
                account.points.push(Point {
                    h: account.intervals + (i - start) as u64,
                    net: account.net.near(),
                    observer: account.observer.near(),
                });
                next_point += stride.unwrap_or(usize::MAX);
            }
        }
        account.intervals += (i - start) as u64;
        supply.keep_twice(lowest, denominator);
        i
    }

    /// One interval, by looking its row up or computing it.
    #[allow(clippy::too_many_arguments)]
    fn slow(
        &mut self,
        task: &Task<'_>,
        chunk: &Chunk,
        i: usize,
        dtau: &Number,
        account: &mut Account,
        key: &mut Vec<i64>,
    ) {
        let samples = &chunk.samples;
        // Samples are there and Δτ is above zero: rows are always defined.
        let Some(found) = self.find(task, samples, i, dtau, key, account) else {
            return;
        };
        match found {
            Found::Fresh(row) => {
                let back = samples.back_from(i, task.ledger.window());
                if let Some(end) = samples.get(i + 1) {
                    enter(task, &row, &back, &end, dtau, account);
                }
            }
            Found::Known(id) => {
                let Some(known) = self.known.get_mut(id) else {
                    return;
                };
                if known.hits == 0 {
                    known.first = i;
                }
                known.hits += 1;
                account.net.add(&known.net);
                match &known.observed {
                    Some(work) => account.observer.add(work),
                    None => {
                        let back = samples.back_from(i, 1);
                        if let Some(end) = samples.get(i + 1) {
                            account.observer.add(&observed(task.ledger, &back, &end));
                        }
                    }
                }
                if let (Some(_), Some(ends)) = (task.rows, ends(samples, i)) {
                    account.rows.extend_from_slice(ends.as_bytes());
                    account.rows.extend_from_slice(&known.text);
                }
                account.intervals += 1;
            }
        }
    }

    /// The row of an interval, known or computed.
    fn find(
        &mut self,
        task: &Task<'_>,
        samples: &Samples,
        i: usize,
        dtau: &Number,
        key: &mut Vec<i64>,
        account: &mut Account,
    ) -> Option<Found> {
        let keyed = make_key(task.ledger, samples, i, dtau, key);
        if let Some(id) = self.index.get(key.as_slice()).filter(|_| keyed) {
            let id = *id as usize;
            if let Some(known) = self.known.get_mut(id) {
                rescale(known, account);
            }
            return Some(Found::Known(id));
        }
        let end = samples.get(i + 1).unwrap_or(Sample::Count(0));
        let back = samples.back_from(i, task.ledger.window());
        let row = task.ledger.row(&back, &end, dtau)?;
        if !keyed || self.known.len() >= MAX_ROWS {
            return Some(Found::Fresh(Box::new(row)));
        }
        let mut text = Vec::new();
        if let Some(enclosures) = task.rows {
            row.write_csv(0, enclosures, &mut text);
            // From Δτ on: what stands before it differs from interval to interval.
            let skip = text.iter().enumerate().filter(|(_, b)| **b == b',');
            let skip = skip.map(|(at, _)| at).nth(if enclosures { 4 } else { 2 });
            text.drain(..skip.unwrap_or(0));
        }
        let plain = task.ledger.model().is_plain();
        let mut known = Known {
            truths: row.truths(),
            net: row.net_floor(),
            scaled: (0, 0),
            observed: (!plain).then(|| observed(task.ledger, &back, &end)),
            row,
            hits: 0,
            first: i,
            text,
        };
        rescale(&mut known, account);
        let id = self.known.len();
        self.known.push(known);
        let short = u32::try_from(id).unwrap_or(u32::MAX);
        self.index.insert(key.as_slice().into(), short);
        if let (true, [1, 1, step]) = (plain, key.as_slice()) {
            if self.small.is_empty() {
                self.small = vec![u32::MAX; usize::try_from(2 * SMALL_STEP + 1).unwrap_or(0)];
            }
            let place = usize::try_from(step + SMALL_STEP).ok();
            if let Some(slot) = place.and_then(|place| self.small.get_mut(place)) {
                *slot = short;
            }
        }
        Some(Found::Known(id))
    }

    /// Adds what was looked up to the sums, and makes room when too many rows are kept.
    fn settle(&mut self, task: &Task<'_>, chunk: &Chunk, from: usize, account: &mut Account) {
        let samples = &chunk.samples;
        for known in &mut self.known {
            let hits = std::mem::take(&mut known.hits);
            if hits == 0 {
                continue;
            }
            known.row.add_to(&mut account.sums, hits);
            let h = (known.first - from) as u64;
            account.criterion.add_times(known.truths[0], h, hits);
            account.linear.add_times(known.truths[1], h, hits);
            account.quantized.add_times(known.truths[2], h, hits);
            let dtau = duration(task.layout, chunk, known.first);
            let dtau = dtau.ok().flatten().unwrap_or(Number::whole(1));
            let spot = || spot(task.ledger, samples, known.first, h, &dtau);
            for (first, is) in account.firsts.iter_mut().zip(kinds(known.truths)) {
                if is && first.as_ref().is_none_or(|first| h < first.h) {
                    *first = spot();
                }
            }
            let net = value(&known.net);
            let lower = account
                .worst
                .as_ref()
                .is_none_or(|(worst, spot)| net < *worst || (net == *worst && h < spot.h));
            if lower {
                account.worst = spot().map(|spot| (net, spot));
            }
        }
        if let Some(last) = account.intervals.checked_sub(1) {
            let i = from + usize::try_from(last).unwrap_or(usize::MAX - from);
            let dtau = duration(task.layout, chunk, i).ok().flatten();
            let dtau = dtau.unwrap_or(Number::whole(1));
            account.last =
                spot(task.ledger, samples, i, last, &dtau).and_then(|spot| spot.row(task.ledger));
        }
        if self.known.len() >= MAX_ROWS {
            self.known.clear();
            self.small.clear();
            self.index.clear();
        }
    }
}

fn value(net: &Result<(i128, i128), BigRational>) -> BigRational {
    match net {
        Ok((n, d)) => BigRational::new_raw((*n).into(), (*d).into()),
        Err(net) => net.clone(),
    }
}

/// Enters the row of one interval into the account.
pub(crate) fn enter(
    task: &Task<'_>,
    row: &Row,
    back: &[Sample],
    end: &Sample,
    dtau: &Number,
    account: &mut Account,
) {
    let (h, truths, net) = (account.intervals, row.truths(), row.net_floor());
    account.net.add(&net);
    account.observer.add(&observed(task.ledger, back, end));
    if let Some(enclosures) = task.rows {
        let mut text = Vec::new();
        row.write_csv(0, enclosures, &mut text);
        // Without the number of the row, which is not known yet.
        account
            .rows
            .extend_from_slice(text.get(2..).unwrap_or_default());
    }
    row.add_to(&mut account.sums, 1);
    account.criterion.add(truths[0], h);
    account.linear.add(truths[1], h);
    account.quantized.add(truths[2], h);
    let spot = || Spot {
        h,
        samples: back.to_vec(),
        end: end.clone(),
        dtau: dtau.clone(),
    };
    for (first, is) in account.firsts.iter_mut().zip(kinds(truths)) {
        if is && first.is_none() {
            *first = Some(spot());
        }
    }
    let net = value(&net);
    if account.worst.as_ref().is_none_or(|(worst, _)| net < *worst) {
        account.worst = Some((net, spot()));
    }
    account.intervals += 1;
}

/// Brings a known row's net energy to the course's denominator.
fn rescale(known: &mut Known, account: &mut Account) {
    let (Ok((n, d)), Some(denominator)) = (&known.net, account.net.denominator()) else {
        return;
    };
    if known.scaled.1 == denominator {
        return;
    }
    if let Some(scaled) = account.net.scaled(*n, *d) {
        known.scaled = (scaled, account.net.denominator().unwrap_or(0));
    }
}

/// The key of an interval of counts: Δτ and what its row depends on. False when it has none.
fn make_key(
    ledger: &Ledger,
    samples: &Samples,
    i: usize,
    dtau: &Number,
    key: &mut Vec<i64>,
) -> bool {
    key.clear();
    let (Samples::Counts(counts), Number::Small(n, d)) = (samples, dtau) else {
        return false;
    };
    key.extend([*n, *d]);
    if ledger.model().is_plain() {
        let ends = counts.get(i).zip(counts.get(i + 1));
        key.extend(ends.map(|(now, next)| next.wrapping_sub(*now)));
    } else {
        let from = (i + 1).saturating_sub(ledger.window());
        key.extend(counts.get(from..i + 2).unwrap_or_default());
    }
    true
}

/// The interval `i` of a chunk.
fn spot(ledger: &Ledger, samples: &Samples, i: usize, h: u64, dtau: &Number) -> Option<Spot> {
    Some(Spot {
        h,
        samples: samples.back_from(i, ledger.window()),
        end: samples.get(i + 1)?,
        dtau: dtau.clone(),
    })
}

/// Ends the chunk with the sample at `i`, for the row after it is wrong.
fn cut(chunk: &mut Chunk, i: usize, error: TraceError) {
    let len = i + 1;
    chunk.samples.truncate(len);
    chunk.times.truncate(len);
    chunk.dtaus.truncate(len);
    chunk.forces.truncate(len);
    chunk.closing = None;
    chunk.error = Some(error.row(len as u64));
}

/// Adds a point to the plot.
pub(crate) fn plot(account: &mut Account) {
    account.points.push(Point {
        h: account.intervals,
        net: account.net.near(),
        observer: account.observer.near(),
    });
}

/// The two ends of an interval of counts as CSV, with the comma before Δτ left out.
fn ends(samples: &Samples, i: usize) -> Option<String> {
    let Samples::Counts(counts) = samples else {
        return None;
    };
    let (from, to) = (i128::from(*counts.get(i)?), i128::from(*counts.get(i + 1)?));
    Some(format!("{from},{},{to},{}", from + 1, to + 1))
}
