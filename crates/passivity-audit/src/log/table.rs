//! A table of the rows of counts that were computed before.

use std::collections::HashMap;

use crate::log::account::{Account, Point};
use crate::log::computed::{Accounted, Computed};
use crate::log::running::Lowest;
use crate::number::Reduced;
use passivity_core::BigRational;

/// How many different rows are kept at once.
const MAX_ROWS: usize = 1 << 15;

/// Steps of up to this many ticks are looked up without hashing.
const SMALL_STEP: i64 = 512;

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

    /// Brings its net energy to the denominator of the running sum.
    fn rescale(&mut self, account: &mut Account) {
        let (Reduced::Small(n, d), Some(denominator)) =
            (&self.computed.net, account.net.denominator())
        else {
            return;
        };
        if self.scaled.is_some_and(|(_, over)| over == denominator) {
            return;
        }
        let scaled = account.net.scaled(*n, *d);
        self.scaled = scaled.zip(account.net.denominator());
    }
}

/// The rows that were computed before, by what they depend on.
#[derive(Default)]
pub(crate) struct Table {
    known: Vec<Known>,
    index: HashMap<Box<[i64]>, usize>,
    /// Rows of plain counts one period apart, by the ticks they cross.
    small: Vec<Option<usize>>,
}

impl Table {
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
        known.rescale(account);
        known.hit(at);
        Some(&known.computed)
    }

    /// Keeps the row with this key, that of the interval `at`.
    pub(crate) fn insert(
        &mut self,
        key: &[i64],
        plain: bool,
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
        let id = self.known.len();
        self.known.push(known);
        self.index.insert(key.into(), id);
        if let (true, [1, 1, 0, step]) = (plain, key) {
            self.small
                .resize(usize::try_from(2 * SMALL_STEP + 1).ok()?, None);
            let place = usize::try_from(step.wrapping_add(SMALL_STEP)).ok();
            if let Some(slot) = place.and_then(|place| self.small.get_mut(place)) {
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

    /// Goes through plain counts from `i` on as long as their steps are known, machine integers
    /// hold the sums and nothing is out of the ordinary; gives how far it came.
    ///
    /// `plot` is after how many intervals, counted from which one, a point is plotted.
    pub(crate) fn quick(
        &mut self,
        counts: &[i64],
        mut i: usize,
        plot: Option<(usize, usize)>,
        account: &mut Account,
    ) -> usize {
        let halves = account.observer.scaled(0, 2);
        let halves = halves.and(account.observer.denominator());
        let (Some(denominator), Some(2)) = (account.net.denominator(), halves) else {
            return i;
        };
        if self.small.is_empty() {
            return i;
        }
        // Positions below this keep the potential over the denominator, and the observer's steps,
        // within 125 bits.
        let near = ((1_i128 << 125) / denominator).isqrt().min(1 << 40) - 2;
        let near = near.max(0).unsigned_abs();
        let mut lowest = twice_lowest(account, denominator);
        let start = i;
        let mut next_point = plot.map_or(usize::MAX, |(stride, from)| {
            i + stride - (i - from) % stride
        });
        while let Some([now, next]) = counts.get(i..i + 2) {
            let step = next.wrapping_sub(*now);
            let known = self.small(step).and_then(|id| self.known.get_mut(id));
            let Some(known) = known else { break };
            let Some((scaled, over)) = known.scaled else {
                break;
            };
            if over != denominator
                || u128::from(now.unsigned_abs()) > near
                || u128::from(next.unsigned_abs()) > near
                || account.net.now().unsigned_abs() > 1 << 124
                || !account.net.add_scaled(scaled)
            {
                break;
            }
            known.hit(i);
            account
                .observer
                .add_scaled(i128::from(2 * now + 1) * i128::from(step));
            // Twice the least of net energy plus ½ξ² over the tick, over the denominator.
            let nearest = i128::from(if *next < 0 { next + 1 } else { *next });
            let twice = 2 * account.net.now() + nearest * nearest * denominator;
            i += 1;
            if lowest.is_none_or(|(least, _)| twice < least) {
                lowest = Some((twice, account.intervals + (i - start) as u64));
            }
            if i == next_point {
                account.points.push(Point {
                    h: account.intervals + (i - start) as u64,
                    net: account.net.near(),
                    observer: account.observer.near(),
                });
                next_point = plot.map_or(usize::MAX, |(stride, _)| next_point + stride);
            }
        }
        account.intervals += (i - start) as u64;
        if let Some((twice, h)) = lowest {
            let value = BigRational::new(twice.into(), (2 * denominator).into());
            Lowest::keep(&mut account.stored, Lowest::new(value, h));
        }
        i
    }

    /// Where the row of a small step is, when it is known.
    #[inline]
    fn small(&self, step: i64) -> Option<usize> {
        let place = usize::try_from(step.wrapping_add(SMALL_STEP)).ok()?;
        *self.small.get(place)?
    }

    /// Writes the rows between counts whose steps are small and known.
    pub(crate) fn write(&self, counts: &[i64], rows: &mut Vec<u8>) {
        for pair in counts.windows(2) {
            if let [now, next] = pair
                && let Some(id) = self.small(next.wrapping_sub(*now))
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
fn twice_lowest(account: &Account, denominator: i128) -> Option<(i128, u64)> {
    use num_traits::ToPrimitive as _;
    let lowest = account.stored.as_ref()?;
    let scale = BigRational::from_integer((2 * denominator).into());
    let twice = (lowest.value() * scale).ceil().to_integer().to_i128()?;
    Some((twice, lowest.h))
}
