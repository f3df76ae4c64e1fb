//! What a motion between two samples comes to in doubles, and what a force makes of it.

use std::collections::HashMap;

use crate::ball::Ball;
use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::Figure;
use crate::ledger::{Ledger, Read, Truths};
use crate::log::chunk::{Chunk, Samples};
use crate::log::computed::UNIT;
use crate::log::layout::Layout;
use crate::log::step::{check_jump, duration};
use crate::log::supply;
use crate::number::Number;
use crate::reading::Reading;
use crate::span::units;

/// What an interval adds to the sums of an account, in units of the grid.
#[derive(Clone, Debug)]
pub(crate) struct Addend {
    /// The five figures that totals are kept of, at the least and at the most.
    pub(crate) sums: [[i128; 2]; 5],
    /// What the observer adds.
    pub(crate) observed: i128,
    /// The potential where the interval ends, at the least and at the most.
    pub(crate) potential: [i128; 2],
    pub(crate) truths: Truths,
}

/// The five figures, of what the loop's own force generates, what another one does more work, and what friction
/// takes.
#[inline(always)]
pub(crate) fn figures(
    generated: [[i128; 2]; 2],
    more: [i128; 2],
    taken: [i128; 2],
) -> [[i128; 2]; 5] {
    let [linear, quantized] = generated.map(|own| [own[0] + more[0], own[1] + more[1]]);
    let net = |generated: [i128; 2]| [taken[0] - generated[1], taken[1] - generated[0]];
    [linear, quantized, taken, net(linear), net(quantized)]
}

/// What of motions is kept from chunk to chunk.
#[derive(Debug, Default)]
pub(crate) struct Motions {
    /// What intervals between counts add, by the ticks they cross and by Δτ: of an interval from 0.
    counted: HashMap<[i64; 3], Addend>,
}

/// The most intervals between counts that are kept.
const MOST: usize = 1 << 14;

impl Motions {
    /// What all intervals between counts of a chunk for which `is_asked` add under the force of the wall, which is
    /// part of what they add under another force; empty where there is none of them, and of a loop whose force
    /// remembers earlier samples.
    pub(crate) fn all(
        &mut self,
        ledger: &Ledger,
        layout: &Layout,
        chunk: &Chunk,
        is_asked: impl Fn(usize, &Number) -> bool,
    ) -> Vec<Option<Addend>> {
        let Samples::Counts(counts) = &chunk.samples else {
            return Vec::new();
        };
        let lasts = |i: usize| {
            let dtau = duration(layout, chunk, i).ok()?.unwrap_or(UNIT);
            is_asked(i, &dtau).then_some(dtau)
        };
        let intervals = counts.len().saturating_sub(1);
        if ledger.has_memory() || !(0..intervals).any(|i| lasts(i).is_some()) {
            return Vec::new();
        }
        let mut motions = Vec::with_capacity(intervals);
        for (i, pair) in counts.windows(2).enumerate() {
            let [from, to] = pair else { continue };
            motions.push(lasts(i).and_then(|dtau| self.counted(ledger, [*from, *to], &dtau)));
        }
        motions
    }

    /// What an interval between counts adds under the force of the wall alone, which depends on where it
    /// starts only by what the observer adds and by the potential where it ends.
    fn counted(&mut self, ledger: &Ledger, [from, to]: [i64; 2], dtau: &Number) -> Option<Addend> {
        check_jump(from, to).ok()?;
        let Number::Small(n, d) = dtau else {
            return None;
        };
        if !ledger.is_plain() {
            return None;
        }
        let crossed = to - from;
        let key = [crossed, *n, *d];
        let addend = match self.counted.get(&key) {
            Some(addend) => addend.clone(),
            None => {
                let [start, end] = [0, crossed].map(Reading::Count);
                let read = Read {
                    samples: std::slice::from_ref(&start).iter(),
                    end: &end,
                    force: None,
                };
                let entry = ledger.near_entry(read, dtau)?;
                let addend = Addend::of_entry(ledger.near(), &entry)?;
                if self.counted.len() < MOST {
                    self.counted.insert(key, addend.clone());
                }
                addend
            }
        };
        let (start, end) = (Ball::whole(from), Reading::Count(to).to_near());
        let force = ledger.near().least.law().held_force(&start);
        let observed = -(force * (*end.lo() - start));
        let addend = Addend {
            observed: observed.on_grid()?[0],
            potential: potential(ledger.near(), &end)?,
            ..addend
        };
        addend.fits().then_some(addend)
    }
}

/// The lower end of one number and the upper end of another, in units of the grid.
#[inline]
fn between(least: Ball, most: Ball) -> Option<[i128; 2]> {
    match (least.on_grid(), most.on_grid()) {
        (Some([lo, _]), Some([_, hi])) => Some([lo, hi]),
        _ => None,
    }
}

impl Addend {
    /// What a row adds; `None` where something does not fit.
    pub(crate) fn of_entry(ends: &Ends<Ball>, entry: &Entry<Ball>) -> Option<Self> {
        let [a, b, c, d, e] = entry
            .summed()
            .map(|figure| between(*figure.lo(), *figure.hi()));
        let addend = Self {
            sums: [a?, b?, c?, d?, e?],
            observed: entry.observed().on_grid()?[0],
            potential: potential(ends, &entry.xi1)?,
            truths: entry.truths(),
        };
        addend.fits().then_some(addend)
    }

    /// Whether all of it is below 2³⁷ KΔ²: past that it is for exact numbers.
    fn fits(&self) -> bool {
        // The bits of all of them: together they are as wide as the widest.
        let ends = self.sums.iter().flatten().chain(&self.potential);
        let bits = ends.fold(self.observed.unsigned_abs(), |bits, n| {
            bits | n.unsigned_abs()
        });
        bits < WIDEST
    }
}

/// Past what any sum has room for as many of as a batch may have.
pub(crate) const WIDEST: u128 = 1 << 101;

/// The wall's potential at a sample, in units of the grid.
fn potential(ends: &Ends<Ball>, sample: &Figure<Ball>) -> Option<[i128; 2]> {
    let [least, most] = supply::potential_on(ends, sample)?;
    Some([units(&least)?, units(&most)?])
}
