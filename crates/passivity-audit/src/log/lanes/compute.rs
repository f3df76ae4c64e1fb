//! The rows of a tile: the kernel's text on balls.

use multiversion::multiversion;
use passivity_core::{Scalar as _, dissipation, quantizer};

use super::{Intervals, TILE, Tile};
use crate::ball::{Ball, Lane, split, unless};
use crate::log::chunk::{Chunk, Samples};
use crate::log::wall::{Held, Reach, Wall};

/// Zero where a number is surely not negative, else one; and the same of whether it surely is.
#[inline(always)]
pub(super) fn is_nonnegative(ball: Lane) -> [f64; 2] {
    let (middle, radius) = ball.parts();
    [unless(middle >= radius), unless(-middle > radius)]
}

/// Zero where what is taken is surely at least as much as two parts that are generated, else one; and the same of
/// whether it is surely less: on the grid too, to which each is rounded outward.
#[inline(always)]
fn covers(taken: Lane, own: Lane, more: Lane) -> [f64; 2] {
    const UNIT: f64 = 1.0 / (1_u64 << 60) as f64;
    const ROUNDING: f64 = 1.0 / (1_u64 << 48) as f64;
    let ((a, r), (b, s), (c, t)) = (taken.parts(), own.parts(), more.parts());
    let rest = a - (b + c);
    let radius = r + s + t;
    let size = a.abs() + b.abs() + c.abs() + radius;
    let reach = radius + (size * ROUNDING + UNIT);
    // Nothing covers nothing.
    let least = if size > 0.0 { rest } else { f64::INFINITY };
    [unless(least > reach), unless(-rest > reach)]
}

/// Zero where what both accounts answer is decided, else above that, and what they answer, as bits of a whole number,
/// where a force does so much more work.
#[inline(always)]
fn answers<const EXACT: bool>(
    ([taken, most], [linear, quantized]): ([Lane; 2], [Lane; 2]),
    more: Lane,
) -> [f64; 2] {
    let [linear_yes, linear_no] = covers(taken, linear, more);
    let [quantized_yes, quantized_no] = covers(taken, quantized, more);
    let mut open = more.excess() + (linear_yes * linear_no + quantized_yes * quantized_no);
    let (mut linear_most, mut quantized_most) = (linear_yes, quantized_yes);
    if !EXACT {
        let [yes, no] = covers(most, linear, more);
        (linear_most, open) = (yes, open + yes * no);
        let [yes, no] = covers(most, quantized, more);
        (quantized_most, open) = (yes, open + yes * no);
    }
    let linear = 4.0 * linear_yes + 8.0 * linear_most;
    let quantized = 16.0 * quantized_yes + 32.0 * quantized_most;
    [open, 60.0 - (linear + quantized)]
}

impl Tile {
    #[inline(always)]
    fn compute<const EXACT: bool, const APPLIED: bool>(
        &mut self,
        wall: &Wall<false>,
        of: &Intervals,
        reach: Option<Reach>,
    ) {
        let [least_criterion, most_criterion] = &wall.criteria;
        for i in 0..TILE {
            let ([start, end, lasts], step) = of.lanes(i);
            let d = step.displacement();
            let speed = dissipation::mean_speed(&d, &lasts);
            let taken = wall.frictions[0].dissipated_lower(&d, &speed);
            let most = match EXACT {
                true => taken,
                false => wall.frictions[1].dissipated_lower(&d, &speed),
            };
            let held = Held::of(reach.as_ref(), [start, end], &step);
            let Held {
                commanded,
                generated: [linear, quantized],
                potential,
                open: left,
            } = held;
            let observed = -(commanded * d);
            let [rests, moves] = is_nonnegative(-speed);
            let mut open = rests * moves + left;
            for ball in [linear, quantized, taken, most, observed, potential] {
                open += ball.excess();
            }
            // The criterion is asked of what moves.
            let [yes, no] = is_nonnegative(least_criterion.margin(&speed));
            open += (1.0 - moves) * (yes * no);
            let least = rests * yes;
            // Friction that is known has one end.
            let mut criterion = 3.0 - 3.0 * least;
            if !EXACT {
                let [yes, no] = is_nonnegative(most_criterion.margin(&speed));
                open += (1.0 - moves) * (yes * no);
                criterion = 3.0 - (least + 2.0 * (rests * yes));
            }
            let accounts = ([taken, most], [linear, quantized]);
            let [left, truths] = answers::<EXACT>(accounts, Lane::zero());
            self.open[0][i] = whole(open + left);
            self.truths[0][i] = whole(criterion + truths);
            if APPLIED {
                let more = (of.force.get(i).lane() - commanded) * d;
                let [left, truths] = answers::<EXACT>(accounts, more);
                self.open[1][i] = whole(open + left);
                self.truths[1][i] = whole(criterion + truths);
                self.more.set(i, more);
            }
            self.linear.set(i, linear);
            self.quantized.set(i, quantized);
            self.taken[0].set(i, taken);
            self.taken[1].set(i, most);
            self.observed.set(i, observed);
            self.potential.set(i, potential);
        }
    }
}

/// A whole number of at least zero, and a small one, as such.
#[inline(always)]
pub(super) fn whole(x: f64) -> u64 {
    split(x).0.cast_unsigned()
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
pub(super) fn compute(tile: &mut Tile, wall: &Wall<false>, of: &Intervals, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => tile.compute::<true, true>(wall, of, None),
        (true, false) => tile.compute::<true, false>(wall, of, None),
        // A force that is not asked for is computed too: one text less.
        (false, _) => tile.compute::<false, true>(wall, of, None),
    }
}

/// The same of walls that are not linear everywhere. Those of other widths would be long, and little faster.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
pub(super) fn compute_in_parts(tile: &mut Tile, wall: &Wall<false>, of: &Intervals) {
    tile.compute::<false, true>(wall, of, wall.reach);
}

/// The force of the law from each sample of a chunk, near by, as far as that is known; nothing of loops that
/// are no plain walls.
pub(crate) fn commanded(wall: Option<&Wall>, chunk: &Chunk) -> Vec<f64> {
    let Some(wall) = wall else {
        return Vec::new();
    };
    let mut forces = vec![f64::NAN; chunk.samples.len()];
    match &chunk.samples {
        Samples::Any(samples) => {
            held(&samples.near.middles, &samples.near.radii, &mut forces);
        }
        Samples::Counts(counts) => held_at(counts, &mut forces),
    }
    if let Some(reach) = &wall.reach {
        for (i, force) in forces.iter_mut().enumerate() {
            let sample = match &chunk.samples {
                Samples::Any(samples) => samples.ball(i),
                Samples::Counts(counts) => counts.get(i).map(|n| Ball::whole(*n)),
            };
            let lane = sample.map_or(Lane::UNDEFINED, Ball::lane);
            let place = reach.place(lane, lane);
            if place.is_flat || place.open > 0.0 {
                let (level, _) = place.force.parts();
                *force = if place.is_flat { -level } else { f64::NAN };
            }
        }
    }
    forces
}

/// The same of counts.
#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn held_at(counts: &[i64], forces: &mut [f64]) {
    for (count, force) in counts.iter().zip(forces) {
        let (held, radius) = quantizer::held_force(&Ball::whole(*count).lane()).parts();
        *force = if radius == 0.0 { held } else { f64::NAN };
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2+fma"))]
fn held(middles: &[f64], radii: &[f64], forces: &mut [f64]) {
    for ((middle, radius), force) in middles.iter().zip(radii).zip(forces) {
        let (held, radius) =
            quantizer::held_force(&Ball::from_parts(*middle, *radius).lane()).parts();
        *force = if radius == 0.0 { held } else { f64::NAN };
    }
}
