//! A table of the rows of counts that were computed before.

use std::collections::HashMap;

use passivity_core::course::{Course, Least};

use crate::log::account::Account;
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

/// How many parts of a wall there are.
const PARTS: i64 = Part::COUNT as i64;

/// A row that was computed before.
struct Known {
    computed: Computed,
    /// Its net energy and what the observer adds, over the denominators of the running sums, which are kept beside them.
    scaled: Option<([i128; 2], Over)>,
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

    /// Brings its numbers to the denominators of the running sums; whether these are others than before.
    fn rescale(&mut self, account: &mut Account) -> bool {
        let (Reduced::Small(n, d), Reduced::Small(m, e)) =
            (&self.computed.net, &self.computed.observed)
        else {
            return false;
        };
        if self
            .scaled
            .is_some_and(|(_, over)| over_of(account) == Some(over))
        {
            return false;
        }
        let scaled = account
            .net
            .scaled(*n, *d)
            .zip(account.observer.scaled(*m, *e));
        self.scaled = scaled.and_then(|(net, observed)| Some(([net, observed], over_of(account)?)));
        true
    }

    /// Its numbers over these denominators, where they are known and small.
    fn numbers(&self, over: Over) -> Option<[i64; 2]> {
        let ([net, observed], of) = self.scaled?;
        let small = |n: i128| {
            let is_small = of == over && (-LARGEST..LARGEST).contains(&n);
            is_small.then(|| i64::try_from(n).ok()).flatten()
        };
        Some([small(net)?, small(observed)?])
    }
}

/// The denominators of the running sums of net energy and of what the observer adds.
type Over = [i128; 2];

/// As long as machine integers hold both.
fn over_of(account: &Account) -> Option<Over> {
    Some([account.net.denominator()?, account.observer.denominator()?])
}

/// The numbers of a row of a small step, and which row it is.
type Small = ([i64; 2], usize);

/// What some consecutive intervals with rows of small steps come to.
#[derive(Default)]
struct Stretch {
    intervals: u64,
    /// Net energy and what the observer adds, each over its denominator.
    net: Course<i64>,
    observer: Course<i64>,
    /// Twice the least of net energy plus the potential over the tick, over the denominator of net energy.
    lowest: Least<i128>,
}

/// The rows that were computed before, by what they depend on.
#[derive(Default)]
pub(crate) struct Table {
    known: Vec<Known>,
    index: HashMap<Box<[i64]>, usize>,
    /// Rows of counts in one part of a wall, one period apart, by that part and the ticks they cross.
    small: [Vec<Option<usize>>; Part::COUNT],
    /// Their numbers over [`over`](Self::over), where they are known and small.
    numbers: [Vec<Option<Small>>; Part::COUNT],
    /// The denominators of these; none where rows were rescaled since.
    over: Option<Over>,
}

impl Table {
    /// What the row of an interval in one part of a wall depends on, but for how long it lasts.
    pub(crate) fn key(part: Part, [now, next]: [i64; 2]) -> Option<i64> {
        let steps = next.checked_sub(now)?.checked_mul(PARTS)?;
        steps.checked_add(part as i64)
    }

    /// Of which part such a row is, and how many ticks it crosses.
    const fn in_part(key: i64) -> (usize, i64) {
        (key.rem_euclid(PARTS) as usize, key.div_euclid(PARTS))
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
        if let [1, 1, key] = key {
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
        // Half a square is over two.
        let _ = account.observer.scaled(0, 2);
        let Some(over) = over_of(account).filter(|[_, observed]| observed % 2 == 0) else {
            return i;
        };
        if self.small.iter().all(Vec::is_empty) {
            return i;
        }
        self.bring_to(over);
        let [denominator, _] = over;
        let known = twice_lowest(account, denominator);
        let mut lowest = Least::default();
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
            let least = lowest.0.map_or(known, |(least, _)| least) - twice_now;
            let found = self.stretch((counts, i), parts, over, least);
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
                account.plot();
            }
        }
        if let Least(Some((twice, h))) = lowest {
            let value = BigRational::new(twice.into(), (2 * denominator).into());
            Lowest::keep(&mut account.stored, Lowest::new(value, h));
        }
        i
    }

    /// The same where [sums](crate::log::task::Task::sums_alone) are all that is told: no more is kept than how often each row
    /// was had.
    pub(crate) fn tally(
        &mut self,
        (counts, parts): (&[i64], &Parts),
        from: usize,
        account: &mut Account,
    ) -> usize {
        let mut at = from;
        for pair in counts.get(from..).unwrap_or_default().windows(2) {
            let [now, next] = pair else { break };
            let part = parts.of(*now, *next);
            let id = part.and_then(|part| self.small(part, next.wrapping_sub(*now)));
            let Some(known) = id.and_then(|id| self.known.get_mut(id)) else {
                break;
            };
            known.hit(at);
            at += 1;
        }
        account.intervals += (at - from) as u64;
        at
    }

    /// Brings the numbers of small steps to these denominators.
    fn bring_to(&mut self, over: Over) {
        if self.over == Some(over) {
            return;
        }
        let known = &self.known;
        let numbers = |id: &Option<usize>| {
            let id = (*id)?;
            Some((known.get(id)?.numbers(over)?, id))
        };
        self.numbers = self
            .small
            .each_ref()
            .map(|small| small.iter().map(numbers).collect());
        self.over = Some(over);
    }

    /// Goes through counts, the first of which is that at `at`, as long as their steps are known and they are near, and it
    /// is known what is lowest. That is told where it is below `least`.
    fn stretch(
        &mut self,
        (counts, at): (&[i64], usize),
        parts: &Parts,
        [denominator, observed_over]: Over,
        mut least: i128,
    ) -> Stretch {
        // Positions below this keep the potential over the denominator within 125 bits, and the observer's steps
        // within 50.
        let near = ((1_i128 << 125) / denominator).isqrt();
        let near = near.min((1 << 41) / observed_over) - 2;
        let near = near.max(0) as u64;
        let half = (observed_over / 2) as i64;
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
            let Some(Some(([net, observed], id))) = part.of(&self.numbers).get(place) else {
                break;
            };
            let Some(known) = self.known.get_mut(*id) else {
                break;
            };
            // The potential is never below zero.
            let twice = 2 * i128::from(found.net.sum + net);
            let mut lower = None;
            if twice < least {
                // Of a force that is not zero it is not told exactly.
                let potential = match part {
                    Part::Linear => {
                        let nearest = i128::from(if *next < 0 { next + 1 } else { *next });
                        Some(nearest * nearest)
                    }
                    part if parts.is_free(part) => Some(0),
                    part => {
                        let bound = parts.twice_potential(part, *next);
                        if twice + bound * denominator < least {
                            break;
                        }
                        None
                    }
                };
                let sum = potential.map(|potential| twice + potential * denominator);
                lower = sum.filter(|sum| *sum < least);
            }
            known.hit(at);
            let h = found.intervals + 1;
            found.intervals = h;
            found.net.step(*net, h);
            let observed = match part {
                Part::Linear => (2 * now + 1) * step * half,
                _ => *observed,
            };
            found.observer.step(observed, h);
            if let Some(twice) = lower {
                least = twice;
                found.lowest = Least(Some((twice, h)));
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

/// What twice the lowest that net energy plus potential was is not above, over a denominator: near by, for what is lower
/// than that is compared exactly once it is found.
fn twice_lowest(account: &Account, denominator: i128) -> i128 {
    /// There is room for differences with it.
    const MOST: f64 = (1_u128 << 126) as f64;
    let above = account.stored.as_ref().map_or(f64::INFINITY, Lowest::above);
    // Each number and their product are rounded once; 2^-50 of it is more.
    let twice = 2.0 * above * denominator as f64;
    let above = twice + (twice.abs() / (1_u64 << 50) as f64 + 1.0);
    // Not a number where the lowest is not known near by.
    if above < MOST {
        above.max(-MOST) as i128
    } else {
        MOST as i128
    }
}
