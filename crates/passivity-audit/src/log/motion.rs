//! What an interval adds to the sums of an account, in doubles.

use crate::ball::Ball;
use crate::ends::Ends;
use crate::entry::Entry;
use crate::figure::Figure;
use crate::ledger::Truths;
use crate::log::supply;
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

/// The lower end of one number and the upper end of another, in units of the grid.
#[inline]
pub(crate) fn between(least: Ball, most: Ball) -> Option<[i128; 2]> {
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
    pub(crate) fn fits(&self) -> bool {
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
