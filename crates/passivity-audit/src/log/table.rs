//! A table of the rows of counts that were computed before.

use std::collections::HashMap;

use passivity_core::course::{Course, Least};

use crate::log::account::{Account, Point};
use crate::log::computed::{Accounted, Computed};
use crate::log::running::Lowest;
use crate::log::wall::{Part, Parts};
use crate::number::Reduced;
use passivity_core::BigRational;

/// How many different rows are kept at once.
const MAX_ROWS: usize = 1 << 15;

/// Steps of up to this many ticks are looked up without hashing.
const SMALL_STEP: i64 = 512;

/// How many of their rows are summed up at a time, each below [`LARGEST`]: the sums have room in 64 bits.
const MOST: usize = 1 << 12;
const LARGEST: i128 = 1 << 48;

/// A row that was computed before.
struct Known {
    computed: Computed,
    /// Its net energy over a denominator of the running sum, which is kept beside it.
    scaled: Option<(i128, i128)>,
    /// How many intervals of the present chunk had it, and the first that did.
    hits: u64,
    first: usize,
}

impl Known {
    fn hit(&mut self, at: usize) {
        if self.hits == 0 {
            self.first = at;
        }
        self.hits += 1;
    }

    /// Brings its net energy to the denominator of the running sum; whether that is another than before.
    fn rescale(&mut self, account: &mut Account) -> bool {
        let (Reduced::Small(n, d), Some(denominator)) =
            (&self.computed.net, account.net.denominator())
        else {
            return false;
        };
        if self.scaled.is_some_and(|(_, over)| over == denominator) {
            return false;
        }
        let scaled = account.net.scaled(*n, *d);
        self.scaled = scaled.zip(account.net.denominator());
        true
    }

    /// Its net energy over a denominator, where that is known and small.
    fn net(&self, denominator: i128) -> Option<i64> {
        let (net, over) = self.scaled?;
        let is_small = over == denominator && (-LARGEST..LARGEST).contains(&net);
        is_small.then(|| i64::try_from(net).ok()).flatten()
    }
}

/// What some consecutive intervals with rows of small steps come to.
#[derive(Default)]
struct Stretch {
    intervals: u64,
    /// Net energy over the denominator, and twice what the observer adds.
    net: Course<i64>,
    observer: Course<i64>,
    /// Twice the least of net energy plus ½ξ² over the tick, over the denominator.
    lowest: Least<i128>,
}

/// The rows that were computed before, by what they depend on.
#[derive(Default)]
pub(crate) struct Table {
    known: Vec<Known>,
    index: HashMap<Box<[i64]>, usize>,
    /// Rows of counts in one part of a wall, one period apart, by that part and the ticks they cross.
    small: [Vec<Option<usize>>; 2],
    /// Their net energies over [`over`](Self::over), where they are known and small.
    nets: [Vec<Option<(i64, usize)>>; 2],
    /// The denominator of these; none where rows were rescaled since.
    over: Option<i128>,
}

impl Table {
    /// What the row of an interval in one part of a wall depends on, but for how long it lasts.
    pub(crate) fn key(part: Part, [now, next]: [i64; 2]) -> Option<i64> {
        let twice = next.checked_sub(now)?.checked_mul(2)?;
        Some(twice + part as i64)
    }

    /// Of which part such a row is, and how many ticks it crosses.
    const fn in_part(key: i64) -> (usize, i64) {
        ((key & 1) as usize, key >> 1)
    }

    pub(crate) fn is_full(&self) -> bool {
        self.known.len() >= MAX_ROWS
    }

    /// The row with this key, when it is known, for the interval `at`.
    pub(crate) fn find(
        &mut self,
        key: &[i64],
        at: usize,
        account: &mut Account,
    ) -> Option<&Computed> {
        let known = self.known.get_mut(*self.index.get(key)?)?;
        if known.rescale(account) {
            self.over = None;
        }
        known.hit(at);
        Some(&known.computed)
    }

    /// Keeps the row with this key, that of the interval `at`.
    pub(crate) fn insert(
        &mut self,
        key: &[i64],
        at: usize,
        computed: Computed,
        account: &mut Account,
    ) -> Option<&Computed> {
        let mut known = Known {
            computed,
            scaled: None,
            hits: 1,
            first: at,
        };
        known.rescale(account);
        self.over = None;
        let id = self.known.len();
        self.known.push(known);
        self.index.insert(key.into(), id);
        if let [1, 1, 0, key] = key {
            let (part, step) = Self::in_part(*key);
            let small = self.small.get_mut(part)?;
            small.resize(usize::try_from(2 * SMALL_STEP + 1).ok()?, None);
            let place = usize::try_from(step.wrapping_add(SMALL_STEP)).ok();
            if let Some(slot) = place.and_then(|place| small.get_mut(place)) {
                *slot = Some(id);
            }
        }
        self.known.last().map(|known| &known.computed)
    }

    /// Gives `each` the rows that intervals of the present chunk had: each with its net energy, the
    /// first such interval and how many there were. Makes room when too many rows are kept.
    pub(crate) fn take_hits<E>(
        &mut self,
        mut each: impl FnMut(&Accounted, &Reduced, usize, u64) -> Result<(), E>,
    ) -> Result<(), E> {
        for known in &mut self.known {
            let times = std::mem::take(&mut known.hits);
            if times > 0 {
                let computed = &known.computed;
                each(&computed.row, &computed.net, known.first, times)?;
            }
        }
        if self.is_full() {
            *self = Self::default();
        }
        Ok(())
    }

    /// Goes through counts in these parts of a wall from `i` on as long as their steps are known, machine integers
    /// hold the sums and nothing is out of the ordinary; gives how far it came.
    ///
    /// `plot` is after how many intervals, counted from which one, a point is plotted.
    pub(crate) fn quick(
        &mut self,
        (counts, parts): (&[i64], &Parts),
        mut i: usize,
        plot: Option<(usize, usize)>,
        account: &mut Account,
    ) -> usize {
        let halves = account.observer.scaled(0, 2);
        let halves = halves.and(account.observer.denominator());
        let (Some(denominator), Some(2)) = (account.net.denominator(), halves) else {
            return i;
        };
        if self.small.iter().all(Vec::is_empty) {
            return i;
        }
        self.bring_to(denominator);
        let mut lowest = twice_lowest(account, denominator);
        let before = account.intervals;
        loop {
            let until_point = plot.map_or(MOST, |(stride, from)| stride - (i - from) % stride);
            let has_room = [&account.net, &account.observer]
                .iter()
                .all(|sum| sum.now().unsigned_abs() < 1 << 124);
            let rows = i..counts.len().min(i + until_point.min(MOST) + 1);
            let Some(counts) = counts.get(rows).filter(|_| has_room) else {
                break;
            };
            let twice_now = 2 * account.net.now();
            // Nothing is lower that is not below this.
            let least = lowest.0.map_or(i128::MAX, |(least, _)| least - twice_now);
            let found = self.stretch((counts, i), parts, denominator, least);
            if found.intervals == 0 {
                break;
            }
            lowest.append(&found.lowest, &twice_now, account.intervals);
            account.net.append_scaled(&found.net, found.intervals);
            account
                .observer
                .append_scaled(&found.observer, found.intervals);
            account.intervals += found.intervals;
            // There are not as many intervals as to overflow.
            i += found.intervals as usize;
            if plot.is_some_and(|(stride, from)| (i - from).is_multiple_of(stride)) {
                account.points.push(Point {
                    h: account.intervals,
                    net: account.net.near(),
                    observer: account.observer.near(),
                });
            }
        }
        if let (Least(Some((twice, h))), true) = (lowest, account.intervals > before) {
            let value = BigRational::new(twice.into(), (2 * denominator).into());
            Lowest::keep(&mut account.stored, Lowest::new(value, h));
        }
        i
    }

    /// Brings the net energies of small steps to this denominator.
    fn bring_to(&mut self, denominator: i128) {
        if self.over == Some(denominator) {
            return;
        }
        let known = &self.known;
        let net = |id: &Option<usize>| {
            let id = (*id)?;
            Some((known.get(id)?.net(denominator)?, id))
        };
        self.nets = self
            .small
            .each_ref()
            .map(|small| small.iter().map(net).collect());
        self.over = Some(denominator);
    }

    /// Goes through counts, the first of which is that at `at`, as long as their steps are known and they are near. What
    /// is lowest is told where that is below `least`.
    fn stretch(
        &mut self,
        (counts, at): (&[i64], usize),
        parts: &Parts,
        denominator: i128,
        mut least: i128,
    ) -> Stretch {
        // Positions below this keep the potential over the denominator within 125 bits, and the observer's steps
        // within 50.
        let near = ((1_i128 << 125) / denominator).isqrt().min(1 << 40) - 2;
        let near = near.max(0) as u64;
        let mut found = Stretch::default();
        for (pair, at) in counts.windows(2).zip(at..) {
            let [now, next] = pair else { break };
            let step = next.wrapping_sub(*now);
            if now.unsigned_abs().max(next.unsigned_abs()) > near {
                break;
            }
            let Some(part) = parts.of(*now, *next) else {
                break;
            };
            let place = step.wrapping_add(SMALL_STEP) as usize;
            let Some(Some((net, id))) = part.of(&self.nets).get(place) else {
                break;
            };
            let is_free = part == Part::Free;
            let Some(known) = self.known.get_mut(*id) else {
                break;
            };
            known.hit(at);
            let h = found.intervals + 1;
            found.intervals = h;
            found.net.step(*net, h);
            let observed = if is_free { 0 } else { (2 * now + 1) * step };
            found.observer.step(observed, h);
            // The potential is never below zero.
            let twice = 2 * i128::from(found.net.sum);
            if twice < least {
                let nearest = match is_free {
                    true => 0,
                    false => i128::from(if *next < 0 { next + 1 } else { *next }),
                };
                let twice = twice + nearest * nearest * denominator;
                if twice < least {
                    least = twice;
                    found.lowest = Least(Some((twice, h)));
                }
            }
        }
        found
    }

    /// Where the row of a small step is, when it is known.
    #[inline]
    fn small(&self, part: Part, step: i64) -> Option<usize> {
        let place = usize::try_from(step.wrapping_add(SMALL_STEP)).ok()?;
        *part.of(&self.small).get(place)?
    }

    /// Writes the rows between counts whose steps are small and known.
    pub(crate) fn write(&self, (counts, parts): (&[i64], &Parts), rows: &mut Vec<u8>) {
        for pair in counts.windows(2) {
            if let [now, next] = pair
                && let Some(part) = parts.of(*now, *next)
                && let Some(id) = self.small(part, next.wrapping_sub(*now))
                && let Some(known) = self.known.get(id)
            {
                let written = &known.computed.written;
                written.append_between([*now, *next], rows);
            }
        }
    }
}

/// Twice the lowest that net energy plus potential was, over a denominator and rounded up, and
/// where; none where there is none yet, or machine integers do not hold it.
fn twice_lowest(account: &Account, denominator: i128) -> Least<i128> {
    use num_traits::ToPrimitive as _;
    let scale = || BigRational::from_integer((2 * denominator).into());
    Least(account.stored.as_ref().and_then(|lowest| {
        let twice = (lowest.value() * scale()).ceil().to_integer().to_i128()?;
        Some((twice, lowest.h))
    }))
}
