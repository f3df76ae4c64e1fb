//! The rows of a tile: the kernel's text on balls.

use multiversion::multiversion;
use passivity_core::ledger;
use passivity_core::{Criterion, Friction, Law, Scalar as _, Step, dissipation, quantizer};

use super::{Intervals, TILE, Tile};
use crate::ball::Ball;
use crate::ledger::Ledger;
use crate::log::chunk::{Chunk, Samples};
use crate::number::Written as _;

/// A loop whose force is that of its linear wall, quantized and nothing else.
#[derive(Clone, Debug)]
pub(super) struct Wall {
    /// The least friction and the most.
    frictions: [Friction<Ball>; 2],
    criteria: [Criterion<Ball>; 2],
    pub(super) friction_is_exact: bool,
}

impl Wall {
    /// `None` for other loops.
    pub(super) fn of(ledger: &Ledger) -> Option<Self> {
        let ends = ledger.near();
        let controller = &ends.controller;
        let is_plain = controller.encoder
            && controller.memory() == 0
            && controller.filter.ends()
            && controller.filter.sum == Ball::one()
            && !controller.unilateral
            && controller.force_step.is_none()
            && controller.max_force.is_none();
        let friction = |of: &passivity_core::Loop<Ball>| {
            Friction::new(of.viscous_friction(), of.coulomb_friction())
        };
        (is_plain && ends.least.has_encoder() && ends.least.law().is_linear()).then(|| Self {
            frictions: [friction(&ends.least), friction(&ends.most)],
            criteria: ends.criteria,
            friction_is_exact: ends.friction_is_exact(),
        })
    }
}

#[inline(always)]
fn bit(is: bool, place: usize) -> u64 {
    u64::from(is) << place
}

/// Whether a number is surely not negative, and whether it surely is.
#[inline(always)]
fn is_nonnegative(ball: Ball) -> [bool; 2] {
    let (middle, radius) = ball.parts();
    [middle >= radius, -middle > radius]
}

/// Whether what is taken is surely at least as much as two parts that are generated, and whether it is surely
/// less: on the grid too, to which each is rounded outward.
#[inline(always)]
fn covers(taken: Ball, own: Ball, more: Ball) -> [bool; 2] {
    const UNIT: f64 = 1.0 / (1_u64 << 60) as f64;
    const ROUNDING: f64 = 1.0 / (1_u64 << 48) as f64;
    let ((a, r), (b, s), (c, t)) = (taken.parts(), own.parts(), more.parts());
    let rest = a - (b + c);
    let radius = r + s + t;
    let reach = radius + ((a.abs() + b.abs() + c.abs() + radius) * ROUNDING + UNIT);
    let nothing = taken.is_zero() & own.is_zero() & more.is_zero();
    [(rest > reach) | nothing, -rest > reach]
}

/// Whether what both accounts answer is left open, and what they answer, as bits, where a force does so much more
/// work.
#[inline(always)]
fn answers<const EXACT: bool>(
    ([taken, most], [linear, quantized]): ([Ball; 2], [Ball; 2]),
    more: Ball,
) -> (bool, u64) {
    let [linear_yes, linear_no] = covers(taken, linear, more);
    let [quantized_yes, quantized_no] = covers(taken, quantized, more);
    let mut open = !more.fits() | !(linear_yes | linear_no) | !(quantized_yes | quantized_no);
    let (mut linear_most, mut quantized_most) = (linear_yes, quantized_yes);
    if !EXACT {
        let [yes, no] = covers(most, linear, more);
        (linear_most, open) = (yes, open | !(yes | no));
        let [yes, no] = covers(most, quantized, more);
        (quantized_most, open) = (yes, open | !(yes | no));
    }
    let linear = bit(linear_yes, 2) | bit(linear_most, 3);
    (
        open,
        linear | bit(quantized_yes, 4) | bit(quantized_most, 5),
    )
}

impl Tile {
    #[inline(always)]
    fn compute<const EXACT: bool, const APPLIED: bool>(&mut self, wall: &Wall, of: &Intervals) {
        for i in 0..TILE {
            let (start, end, lasts) = (of.start.get(i), of.end.get(i), of.lasts.get(i));
            // Of what stands still, any position that it may have stands for all.
            let step = match of.still[i] != 0 {
                true => Step::new(start.one_of(), start.one_of()),
                false => Step::new(start, end),
            };
            let d = step.displacement();
            let speed = dissipation::mean_speed(&d, &lasts);
            let commanded = quantizer::held_force(&start);
            let taken = wall.frictions[0].dissipated_lower(&d, &speed);
            let most = match EXACT {
                true => taken,
                false => wall.frictions[1].dissipated_lower(&d, &speed),
            };
            let [linear, quantized] = ledger::generated_by_spring(&step, &commanded, true);
            let observed = -(commanded * d);
            let potential = Law::bilateral().potential(&end);
            let [rests, moves] = is_nonnegative(-speed);
            let mut open = !(rests | moves);
            for ball in [linear, quantized, taken, most, observed, potential] {
                open |= !ball.fits();
            }
            let mut criterion = 0;
            for place in 0..2 {
                let [yes, no] = is_nonnegative(wall.criteria[place].margin(&speed));
                open |= moves & !(yes | no);
                criterion |= bit(rests | yes, place);
            }
            let accounts = ([taken, most], [linear, quantized]);
            let (left, truths) = answers::<EXACT>(accounts, Ball::zero());
            self.open[0][i] = u64::from(open | left);
            self.truths[0][i] = criterion | truths;
            if APPLIED {
                let more = (of.force.get(i) - commanded) * d;
                let (left, truths) = answers::<EXACT>(accounts, more);
                self.open[1][i] = u64::from(open | left);
                self.truths[1][i] = criterion | truths;
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

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
pub(super) fn compute(tile: &mut Tile, wall: &Wall, of: &Intervals, applied: bool) {
    match (wall.friction_is_exact, applied) {
        (true, true) => tile.compute::<true, true>(wall, of),
        (true, false) => tile.compute::<true, false>(wall, of),
        (false, true) => tile.compute::<false, true>(wall, of),
        (false, false) => tile.compute::<false, false>(wall, of),
    }
}

/// The force of the law from each sample of a chunk, near by, as far as that is known; nothing of loops that
/// are no plain walls.
pub(crate) fn commanded(ledger: &Ledger, chunk: &Chunk) -> Vec<f64> {
    match (Wall::of(ledger), &chunk.samples) {
        (Some(_), Samples::Any(samples)) => {
            let mut forces = vec![f64::NAN; samples.len()];
            held(&samples.near.middles, &samples.near.radii, &mut forces);
            forces
        }
        _ => Vec::new(),
    }
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl+avx512bw", "x86_64+avx2"))]
fn held(middles: &[f64], radii: &[f64], forces: &mut [f64]) {
    for ((middle, radius), force) in middles.iter().zip(radii).zip(forces) {
        let (held, radius) = quantizer::held_force(&Ball::from_parts(*middle, *radius)).parts();
        *force = if radius == 0.0 { held } else { f64::NAN };
    }
}
