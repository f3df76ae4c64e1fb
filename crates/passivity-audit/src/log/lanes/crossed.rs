//! Rows between counts that are written: all of their figures, several rows at a time.
//!
//! Each is what [`Rectangle`](crate::enclosure::Rectangle) makes of the same numbers and
//! [`entry`](crate::entry::entry) of that, to the last bit; a row of which not all is decided here is left to these.

use std::cmp::Ordering;

use multiversion::multiversion;
use passivity_core::counted::{Crossing, Resistance};
use passivity_core::{Ordered as _, Scalar as _, dissipation, generation, quantizer};

use super::compute::{is_nonnegative, whole};
use super::written::Rows;
use super::{Column, Intervals, TILE};
use crate::ball::{Lane, unless};
use crate::entry::margin_of;
use crate::log::wall::Wall;

/// Where in a row its figures are.
const GENERATED: [usize; 2] = [0, 1];
const BOUNDS: [usize; 2] = [2, 3];
const TAKEN: usize = 4;
const NET: [usize; 2] = [5, 6];
const MARGIN: usize = 7;

/// Sets both ends of a figure: zero where they are surely in order, else one.
#[inline(always)]
fn set(figure: &mut [Column; 2], i: usize, ends: [Lane; 2]) -> f64 {
    for (column, end) in figure.iter_mut().zip(ends) {
        column.set(i, end);
    }
    surely_in_order(ends)
}

/// Zero where two numbers are surely in order, else one.
#[inline(always)]
fn surely_in_order([lo, hi]: [Lane; 2]) -> f64 {
    let [is, _] = is_nonnegative(hi - lo);
    is
}

/// Whether both ends are not negative, as two bits; and zero where that is decided, else above that.
#[inline(always)]
fn covers(ends: [Lane; 2]) -> [f64; 2] {
    let [[lo, not_lo], [hi, not_hi]] = ends.map(is_nonnegative);
    [3.0 - (lo + 2.0 * hi), lo * not_lo + hi * not_hi]
}

impl Intervals {
    /// Interval `i` as one between two counts, and how long it lasts.
    #[inline(always)]
    fn crossing(&self, i: usize) -> (Crossing<Lane>, Lane) {
        let [start, end, force, lasts] =
            [&self.start, &self.end, &self.force, &self.lasts].map(|column| column.get(i).lane());
        let crossing = Crossing {
            ticks: end - start,
            excess: force - quantizer::held_force(&start),
        };
        (crossing, lasts)
    }
}

impl Rows {
    /// Computes rows of a wall whose margins are without bound at rest, at the least and at the most.
    ///
    /// One part of them after the other, for processors have not as many registers as all of them need.
    #[inline(always)]
    fn compute_counts(&mut self, wall: &Wall<false>, of: &Intervals, grows: [bool; 2]) {
        for i in 0..TILE {
            let (crossing, lasts) = of.crossing(i);
            let (length, off) = lasts.parts();
            let mut open = unless(length > off);
            for (at, ends) in GENERATED.into_iter().zip(crossing.generated()) {
                open += set(&mut self.balls[at], i, ends);
            }
            let (start, end) = (of.start.get(i).lane(), of.end.get(i).lane());
            for tick in [start, end] {
                open += tick.excess() + (tick + Lane::one()).excess();
            }
            self.open[i] = open;
        }
        for i in 0..TILE {
            let (crossing, lasts) = of.crossing(i);
            let friction = Resistance::new(&wall.frictions[0], &lasts);
            for (at, least) in NET.into_iter().zip(crossing.net_at_least(&friction)) {
                self.balls[at][0].set(i, least);
            }
        }
        for i in 0..TILE {
            let (crossing, lasts) = of.crossing(i);
            let friction = Resistance::new(&wall.frictions[1], &lasts);
            for (at, most) in NET.into_iter().zip(crossing.net_at_most(&friction)) {
                self.balls[at][1].set(i, most);
            }
        }
        for i in 0..TILE {
            let (crossing, lasts) = of.crossing(i);
            let [near, far] = crossing.distances();
            let slow = dissipation::mean_speed(&near, &lasts);
            let fast = dissipation::mean_speed(&far, &lasts);
            let ([least, most], [low, high]) = (&wall.frictions, &wall.criteria);
            let mut open = 0.0;
            let bounds = [
                [generation::bound_22(&near), generation::bound_22(&far)],
                [
                    generation::bound_quantized(&near),
                    generation::bound_quantized(&far),
                ],
            ];
            for (at, ends) in BOUNDS.into_iter().zip(bounds) {
                open += set(&mut self.balls[at], i, ends);
            }
            let taken = [
                least.dissipated_lower(&near, &slow),
                most.dissipated_lower(&far, &fast),
            ];
            open += set(&mut self.balls[TAKEN], i, taken);
            // The margin times the speed, which is linear in it.
            let times_speed = [
                low.margin(&slow).min(low.margin(&fast)),
                high.margin(&slow).max(high.margin(&fast)),
            ];
            open += surely_in_order(times_speed);
            let [criterion, left] = covers(times_speed);
            let mut truths = criterion;
            open += left;
            // What may have rested may have held the criterion.
            let [_, moves] = is_nonnegative(-slow);
            let may_rest = unless(slow.size() > 0.0);
            let [_, is_fast] = is_nonnegative(-fast);
            open += moves * (1.0 - may_rest) + is_fast;
            if criterion == 0.0 {
                truths += 2.0 * may_rest;
            }
            for (at, place) in NET.into_iter().zip([4.0, 16.0]) {
                let ends = self.balls[at].each_ref().map(|column| column.get(i).lane());
                let [bits, left] = covers(ends);
                open += surely_in_order(ends) + left;
                truths += place * bits;
            }
            let mut margins = 3.0;
            for (end, bit) in [1.0, 2.0].into_iter().enumerate() {
                let speed = if grows[end] { slow } else { fast };
                let mut margin = margin_of(&wall.criteria[end], &speed);
                if grows[end] && may_rest > 0.0 {
                    margin = Lane::zero();
                    margins -= bit;
                }
                self.balls[MARGIN][end].set(i, margin);
            }
            self.margins[i] = whole(margins);
            self.truths[i] = whole(truths);
            self.open[i] += open;
        }
        self.take(of, 1, true);
    }
}

/// Computes rows under the forces in the log.
pub(super) fn compute(rows: &mut Rows, wall: &Wall<false>, of: &Intervals) {
    let [least, most] = &wall.criteria;
    match (least.coulomb.sign(), most.coulomb.sign()) {
        (Some(least), Some(most)) => {
            let grows = [least == Ordering::Less, most == Ordering::Greater];
            compute_counts(rows, wall, of, grows);
        }
        _ => rows.open.fill(1.0),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn compute_counts(rows: &mut Rows, wall: &Wall<false>, of: &Intervals, grows: [bool; 2]) {
    rows.compute_counts(wall, of, grows);
}

#[cfg(test)]
mod tests {
    use passivity_random::draws;
    use proptest::prelude::*;

    use super::*;
    use crate::ball::Ball;
    use crate::entry::{Recorded, entry};
    use crate::figure::Figure;
    use crate::ledger::Ledger;
    use crate::log::lanes::Length;
    use crate::log::lanes::tests::{BETWEEN, EXACT, ball, ledger};
    use crate::log::lanes::written::Before;
    use crate::log::numbers::{Kind, Readings};
    use crate::log::scale::Scale;
    use crate::number::Number;
    use crate::rows::Form;

    const FORM: Form = Form {
        enclosures: true,
        force: true,
        accounted: true,
    };

    /// Coulomb friction of just half a tick and of less, so that margins at rest have another end, or both.
    const CORNER: &str = "[dimensionless]\nbeta = \"1/5\"\nsigma = \"1/2\"";
    const LITTLE: &str = "[dimensionless]\nbeta = \"3/5\"\nsigma = \"1/7\"";
    const AROUND: &str = "[dimensionless]\nbeta = \"3/5 ± 20%\"\nsigma = \"1/2 ± 20%\"";

    /// The row as it is written on its own.
    fn alone(
        ledger: &Ledger,
        counts: [i64; 2],
        Length(n, d): Length,
        force: Ball,
    ) -> Option<Vec<u8>> {
        let [start, end] = counts.map(|n| crate::Reading::Count(n).to_near());
        let dtau = Number::Small(n, d);
        let recorded = Recorded {
            samples: &[start],
            end: &end,
            dtau: &Ball::of(&dtau),
            force: Some(&Figure::Exact(force)),
        };
        let entry = entry(ledger.near(), &recorded)?.with_margin(ledger.near())?;
        let (mut text, mut rest) = (Vec::new(), Vec::new());
        FORM.write_near(&entry, &dtau, [&mut text, &mut rest])?;
        text.append(&mut rest);
        Some(text)
    }

    /// How many rows are written several at a time: as they are on their own.
    fn written(
        ledger: &Ledger,
        counts: &[i64],
        lengths: &[Length],
        forces: &[Ball],
    ) -> Result<usize, TestCaseError> {
        let mut readings = Readings::new(Kind::Force, &Scale::One);
        forces.iter().for_each(|force| readings.near.push(*force));
        let (mut of, mut found) = (Intervals::new(), Rows::new());
        of.read_counts(counts, Some(&readings), 0, lengths);
        compute(&mut found, &Wall::of(ledger).unwrap().lanes(), &of);
        let mut before = Before::new();
        let mut several = 0;
        let rows = counts.windows(2).zip(lengths).zip(forces).take(of.len);
        for (i, ((pair, length), force)) in rows.enumerate() {
            let (counts, mut out) = ([pair[0], pair[1]], Vec::new());
            let row = (counts, *length);
            if found
                .write_counts(i, row, &mut before, FORM, &mut out)
                .is_none()
            {
                before.forget();
                continue;
            }
            several += 1;
            let expected = alone(ledger, counts, *length, *force);
            prop_assert_eq!(Some(out), expected, "{:?} {:?} {:?}", counts, length, force);
        }
        Ok(several)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(draws(150)))]

        #[test]
        fn rows_of_counts_are_written_as_they_are_alone(
            start in prop_oneof![
                6 => -40..40_i64,
                1 => -(1_i64 << 36)..1_i64 << 36,
                1 => (1_i64 << 35) - 3..(1_i64 << 35) + 3,
                1 => any::<i64>(),
            ],
            steps in prop::collection::vec(prop_oneof![6 => -3..4_i64, 1 => -3000..3000_i64, 1 => any::<i32>().prop_map(i64::from)], TILE),
            lengths in prop::collection::vec(prop_oneof![1 => Just((1, 1)), 3 => (1..5000_i64, 1..5000_i64)], TILE),
            forces in prop::collection::vec((ball(), any::<bool>(), -20..20_i32), TILE),
            text in prop::sample::select(vec![EXACT, BETWEEN, CORNER, LITTLE, AROUND]),
        ) {
            let mut counts = vec![start];
            counts.extend(steps.iter().scan(start, |at, step| {
                *at = at.wrapping_add(*step);
                Some(*at)
            }));
            let lengths: Vec<_> = lengths.into_iter().map(|(n, d)| Length(n, d)).collect();
            let near = |(count, (force, is_near, more)): (&i64, (Ball, bool, i32))| match is_near {
                true => quantizer::held_force(&Ball::whole(*count)) + Ball::from_parts(f64::from(more) / 16.0, 1e-15),
                false => force,
            };
            let forces: Vec<_> = counts.iter().zip(forces).map(near).collect();
            written(&ledger(text), &counts, &lengths, &forces)?;
        }
    }

    #[test]
    fn most_rows_of_a_log_of_counts_are_written_several_at_a_time() {
        for text in [EXACT, BETWEEN, CORNER, LITTLE] {
            let counts: Vec<i64> = (0..=TILE as i64).map(|i| (i * 7 % 23) / 3 - 4).collect();
            let lengths: Vec<_> = (0..TILE as i64)
                .map(|i| Length(900 + i * 3, 1000))
                .collect();
            let held = counts
                .iter()
                .map(|n| quantizer::held_force(&Ball::whole(*n)));
            let forces: Vec<_> = held
                .map(|force| force + Ball::from_parts(0.013, f64::EPSILON))
                .collect();
            assert_eq!(
                written(&ledger(text), &counts, &lengths, &forces).unwrap(),
                TILE,
                "{text}"
            );
        }
    }
}
