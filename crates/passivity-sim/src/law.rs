//! The held force in doubles: the kernel's controller, compiled to one function of 64, each with its
//! effects and no others; or to one of 64 more, with any digital filter in place of virtual damping.
//!
//! What is computed is [`Controller::sample`](passivity_core::Controller::sample) of the kernel, in
//! the same order: sample, delay, filter, one-sided wall, D/A converter, actuator. A test holds all
//! of them against it.

mod jumps;

use std::cmp::Ordering;

use num_bigint::BigInt;
use passivity_core::controller::Filter;
use passivity_core::{BigRational, Controller, Loop, Ordered, Scalar};

use crate::error::SimError;
use crate::latency;
use crate::number::{Double, floor};
use crate::plan::LARGEST;

/// The controller of a dimensionless loop in the numbers that `of` makes, late by the whole periods of
/// the loop's latency too.
///
/// The step δ of a D/A converter goes in as two whole numbers, its numerator and denominator, so that
/// a force half-way between two steps is seen as such by every kind of number.
pub(crate) fn controller<R>(
    dimensionless: &Loop<BigRational>,
    of: impl Fn(&BigRational) -> R,
) -> Result<Controller<R>, SimError> {
    let whole = |n: &BigInt| BigRational::from_integer(n.clone());
    let step = dimensionless.force_step.as_ref();
    let own = Controller::of(dimensionless);
    let exact = Controller {
        delay: own.delay + latency::whole_periods(dimensionless)?,
        force_step: step.map(|delta| [whole(delta.numer()), whole(delta.denom())]),
        ..own
    };
    Ok(exact.map(of))
}

/// Up to it doubles are all the whole numbers.
const LARGEST_WHOLE: f64 = 9_007_199_254_740_992.0;

/// The controller of a dimensionless loop in doubles; δ is over 1 where a double has not enough digits
/// for its numerator or denominator.
pub(crate) fn controller_in_doubles(
    dimensionless: &Loop<BigRational>,
) -> Result<Controller<Double>, SimError> {
    let mut controller = controller(dimensionless, |x| Double::from(x))?;
    if let (Some(parts), Some(delta)) = (&mut controller.force_step, &dimensionless.force_step)
        && parts.iter().any(|x| x.0 > LARGEST_WHOLE)
    {
        *parts = [Double::from(delta), Double(1.0)];
    }
    Ok(controller)
}

/// Past how many samples at rest, with friction taking the force of now and the settled one, it takes
/// every force to come; `None` where that is never certain.
///
/// A response that ends is settled after as many samples as the controller remembers. Behind a filter
/// with one pole a, 0 ≤ a < 1, what it remembers of the motion then decays without changing its sign,
/// so that every later force lies between the present one and the settled one: rounding and limits
/// keep that order. Any other filter may swing past both.
pub(crate) fn forgets_after<R: Ordered>(controller: &Controller<R>) -> Option<u64> {
    let decays = match controller.filter.poles.as_slice() {
        [] => true,
        [r] => {
            let below_one = (R::one() + r.clone()).is_positive() == Some(true);
            below_one && matches!(r.sign(), Some(Ordering::Less | Ordering::Equal))
        }
        _ => false,
    };
    decays.then_some(controller.memory() as u64)
}

/// The encoder, as a bit of a law's set of effects.
pub(crate) const ENCODER: u8 = 1;
/// The delay.
pub(crate) const DELAY: u8 = 2;
/// Virtual damping.
pub(crate) const DAMPING: u8 = 4;
/// The one-sided wall.
pub(crate) const UNILATERAL: u8 = 8;
/// The D/A converter.
pub(crate) const FORCE_STEP: u8 = 16;
/// Saturation.
pub(crate) const SATURATION: u8 = 32;
/// Any digital filter, in place of virtual damping.
pub(crate) const FILTER: u8 = 64;

/// The least magnitude of a force held at rest, in KΔ: what must not be above σ for rest.
///
/// With an encoder it is that of the tick at the origin, ½ unless a D/A converter or saturation
/// or a controller changes it; 0 for a one-sided wall, without an encoder, and where nothing is
/// claimed.
pub(crate) fn least_holding_force(controller: &Controller<BigRational>) -> BigRational {
    // Rounded from one side for ever, a force that lingers need not round like its limit.
    let may_round = !controller.filter.ends() && controller.force_step.is_some();
    if !controller.encoder || may_round {
        return BigRational::zero();
    }
    let half = BigRational::one().half();
    // Sampled in the tick [0, 1) and in [−1, 0); the law is monotone, so no other is less.
    let [above, below] = [half.clone(), -half].map(|q| controller.settled(&q).abs());
    Ord::min(above, below)
}

/// A controller in doubles; parameters of an effect that is not in `effects` are of no meaning.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HeldForce {
    /// The set of effects: [`ENCODER`] | [`DELAY`] | …
    pub(crate) effects: u8,
    /// k, in samples.
    pub(crate) delay: usize,
    /// B, in KT.
    pub(crate) damping: f64,
    /// The digital filter, where it is neither a wall nor virtual damping.
    pub(crate) filter: Filter<f64>,
    /// See [`passed_on`].
    passed_on: f64,
    /// See [`forgets_after`].
    forgets_after: Option<u64>,
    /// δ as numerator and denominator, so that a force half-way between two steps is seen as such.
    pub(crate) force_step: [f64; 2],
    /// The largest force, in KΔ.
    pub(crate) max_force: f64,
    /// δ over q and over the damping's displacement, see [`HeldForce::with_whole_steps`].
    pub(crate) whole: [f64; 3],
    /// How many times an error of all samples that of the force may be.
    amplified: f64,
    /// See [`HeldForce::rounding`].
    rounding: f64,
}

/// What a controller remembers from sample to sample.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Memory {
    /// How near to a jump of the law a sample has come, see [`HeldForce::off_jump`].
    nearest: f64,
    /// The greatest |q| of its samples.
    reach: f64,
    /// The last k samples, a ring.
    line: Vec<f64>,
    next: usize,
    /// The sample before, for virtual damping.
    previous: f64,
    /// The samples before that the filter remembers, the latest first.
    samples: Vec<f64>,
    /// What the filter made of displacements at the samples before, the latest first.
    past: Vec<f64>,
}

impl Memory {
    /// The samples that are remembered, the latest first.
    pub(crate) fn latest_first(&self) -> impl Iterator<Item = f64> + '_ {
        let older = self.line.iter().skip(self.next);
        let newer = self.line.iter().take(self.next);
        newer
            .rev()
            .chain(older.rev())
            .chain(&self.samples)
            .copied()
            .chain([self.previous])
    }

    /// How near to a jump of the law its samples have come since this was asked before.
    pub(crate) const fn take_nearest(&mut self) -> f64 {
        std::mem::replace(&mut self.nearest, f64::INFINITY)
    }
}

/// A law: the held force of a sample at ξ, in KΔ.
pub(crate) type Law = fn(&HeldForce, &mut Memory, f64) -> f64;

impl HeldForce {
    /// The paper's controller: an encoder and nothing else.
    pub(crate) const fn encoder() -> Self {
        Self {
            effects: ENCODER,
            delay: 0,
            damping: 0.0,
            filter: Filter {
                sum: 1.0,
                tails: Vec::new(),
                poles: Vec::new(),
            },
            passed_on: 1.0,
            forgets_after: Some(0),
            force_step: [0.0, 1.0],
            max_force: 0.0,
            whole: [1.0, 0.0, 1.0],
            amplified: 1.0,
            rounding: 0.0,
        }
    }

    /// Compiles a controller.
    ///
    /// # Errors
    ///
    /// A digital filter with a coefficient out of range.
    pub(crate) fn compile(controller: &Controller<Double>) -> Result<Self, SimError> {
        let filter = controller.filter.map(|x| x.0);
        let in_range = |c: &f64| c.abs() <= LARGEST;
        let others = filter.tails.iter().chain(&filter.poles);
        if !others.chain([&filter.sum]).all(in_range) {
            return Err(SimError::Filter);
        }
        let (damping, other) = match (filter.sum, filter.tails.as_slice(), filter.poles.as_slice())
        {
            (1.0, [], []) => (None, None),
            (1.0, [tail], []) => (Some(-tail), None),
            _ => (None, Some(filter)),
        };
        let effects = [
            (controller.encoder, ENCODER),
            (controller.delay > 0, DELAY),
            (damping.is_some(), DAMPING),
            (controller.unilateral, UNILATERAL),
            (controller.force_step.is_some(), FORCE_STEP),
            (controller.max_force.is_some(), SATURATION),
            (other.is_some(), FILTER),
        ];
        let present = effects.iter().filter(|(there, _)| *there);
        let without = Self::encoder();
        let law = Self {
            effects: present.fold(0, |set, (_, bit)| set | bit),
            delay: controller.delay,
            damping: damping.unwrap_or(without.damping),
            passed_on: other
                .as_ref()
                .map_or(without.passed_on, |filter| passed_on(&filter.poles)),
            filter: other.unwrap_or(without.filter),
            forgets_after: forgets_after(controller),
            force_step: controller
                .force_step
                .map_or(without.force_step, |step| step.map(|x| x.0)),
            max_force: controller.max_force.map_or(without.max_force, |x| x.0),
            ..without
        };
        let [numerator, denominator] = law.force_step;
        Ok(Self {
            amplified: 1.0 + 2.0 * law.gain(),
            rounding: law.rounding(),
            whole: [denominator, law.damping * denominator, numerator],
            ..law
        })
    }

    /// Whether an effect is in the set, or one of several.
    pub(crate) const fn has(&self, effect: u8) -> bool {
        self.effects & effect != 0
    }

    /// What the controller remembers when the device has been at ξ for ever.
    pub(crate) fn memory(&self, xi: f64) -> Memory {
        let sample = self.sample(xi);
        Memory {
            nearest: f64::INFINITY,
            reach: xi.abs(),
            line: vec![sample; if self.has(DELAY) { self.delay } else { 0 }],
            next: 0,
            previous: sample,
            samples: vec![sample; self.filter.tails.len()],
            past: vec![0.0; self.filter.poles.len()],
        }
    }

    /// The position that the controller is given for ξ: the middle of its tick (5), or ξ itself.
    pub(crate) fn sample(&self, xi: f64) -> f64 {
        if self.has(ENCODER) {
            floor(xi) + 0.5
        } else {
            xi
        }
    }

    /// The force that is held once the device has stayed at ξ, in KΔ.
    pub(crate) fn settled(&self, xi: f64) -> f64 {
        self.law()(self, &mut self.memory(xi), xi)
    }

    /// The function that computes the law.
    #[expect(clippy::indexing_slicing, reason = "six bits are below 64")]
    pub(crate) fn law(&self) -> Law {
        let [plain, filtered] = &TABLES;
        let table = if self.has(FILTER) { filtered } else { plain };
        table[usize::from(self.effects & 63)]
    }

    /// Past how many samples at rest friction takes every force to come, see [`forgets_after`]; more
    /// than any run has where that is never certain.
    pub(crate) fn forgets_after(&self) -> u64 {
        self.forgets_after.unwrap_or(u64::MAX)
    }

    /// What the roundings of the held force amount to, over those of a force that is a sample: at most
    /// 16ε times this, times the greatest |ξ| so far and one more.
    ///
    /// A sum of products is rounded as often as it has terms, twice for the rounding of coefficients, and
    /// what is left in a filter's output is passed on by its poles.
    pub(crate) fn rounding(&self) -> f64 {
        let Filter { sum, tails, poles } = &self.filter;
        let size = |of: &[f64]| of.iter().map(|c| c.abs()).sum::<f64>();
        if self.has(FILTER) {
            let output = 2.0 * size(tails) * self.passed_on;
            let terms = (tails.len() + poles.len() + 2) as f64;
            sum.abs() + 2.0 * terms * self.passed_on * (2.0 * size(tails) + size(poles) * output)
        } else if self.has(DAMPING) {
            1.0 + 2.0 * self.damping.abs()
        } else {
            0.0
        }
    }

    /// What virtual damping or a filter may make of |ξ| + 1 beside it.
    pub(crate) fn gain(&self) -> f64 {
        if self.has(FILTER) {
            let size = |of: &[f64]| of.iter().map(|c| c.abs()).sum::<f64>();
            self.filter.sum.abs() + 2.0 * size(&self.filter.tails) * self.passed_on
        } else {
            self.damping.abs()
        }
    }

    /// How many times an error of all samples that of the force may be.
    #[cfg(feature = "multiprecision")]
    pub(crate) const fn amplified(&self) -> f64 {
        self.amplified
    }

    /// Whether the force goes on changing at rest, on and on nearer to the settled one.
    pub(crate) fn lingers(&self) -> bool {
        !self.filter.poles.is_empty()
    }
}

/// Σ|h_j| of the impulse response of the poles, a little more than it: what a filter makes of roundings.
fn passed_on(poles: &[f64]) -> f64 {
    // Far longer than any response of a filter with digits left; without an end, nothing is bounded.
    const LONGEST: u32 = 1 << 20;
    let mut past = vec![0.0; poles.len()];
    let (mut next, mut sum, mut quiet) = (1.0_f64, 0.0, 0);
    for _ in 0..LONGEST {
        sum += next.abs();
        if next.abs() > f64::EPSILON * sum {
            quiet = 0;
        } else if quiet > poles.len() {
            return 2.0 * sum;
        } else {
            quiet += 1;
        }
        past.insert(0, next);
        past.truncate(poles.len());
        next = -poles.iter().zip(&past).map(|(r, y)| r * y).sum::<f64>();
    }
    f64::INFINITY
}

/// What a filter remembers vanishes below it: a response that dies away would end in numbers below the least
/// normal one, with which processors are slow. It is far below what rounding leaves of a force.
pub(crate) const VANISHING: f64 = 1e-250;

/// The filter's output at a sample.
fn filtered(filter: &Filter<f64>, memory: &mut Memory, q: f64) -> f64 {
    let mut y = 0.0;
    for (r, before) in filter.poles.iter().zip(&memory.past) {
        y -= r * before;
    }
    let mut later = q;
    for (tail, earlier) in filter.tails.iter().zip(&memory.samples) {
        y += tail * (earlier - later);
        later = *earlier;
    }
    let y = (y + VANISHING) - VANISHING;
    for (line, newest) in [(&mut memory.samples, q), (&mut memory.past, y)] {
        if let [_, .., _] = line.as_slice() {
            line.rotate_right(1);
        }
        if let Some(first) = line.first_mut() {
            *first = newest;
        }
    }
    filter.sum * q + y
}

/// The held force with the effects `E`: what is not in `E` is not in the code.
fn held<const E: u8>(law: &HeldForce, memory: &mut Memory, xi: f64) -> f64 {
    let mut q = if E & ENCODER != 0 {
        floor(xi) + 0.5
    } else {
        xi
    };
    if E & DELAY != 0 {
        // The line is never empty when there is a delay.
        if let Some(slot) = memory.line.get_mut(memory.next) {
            std::mem::swap(slot, &mut q);
        }
        memory.next += 1;
        if memory.next == memory.line.len() {
            memory.next = 0;
        }
    }
    let mut force = q;
    // As numerator and denominator, of the step.
    let [numerator, denominator] = law.force_step;
    let mut steps = [0.0, numerator];
    if E & FILTER != 0 {
        force = filtered(&law.filter, memory, q);
        steps[0] = force * denominator;
    } else if E & DAMPING != 0 {
        let d = q - memory.previous;
        force += law.damping * d;
        memory.previous = q;
        let [of_q, of_d, whole] = law.whole;
        steps = [q * of_q + d * of_d, whole];
    } else {
        steps[0] = force * denominator;
    }
    let jumps = E & FORCE_STEP != 0 || (E & UNILATERAL != 0 && E & (DAMPING | FILTER) != 0);
    if E & ENCODER == 0 && jumps {
        memory.reach = memory.reach.max(q.abs());
        let off = law.off_jump(q, force, memory.reach);
        memory.nearest = memory.nearest.min(off);
    }
    if E & UNILATERAL != 0 && q < 0.0 {
        (force, steps[0]) = (0.0, 0.0);
    }
    let mut held = -force;
    if E & FORCE_STEP != 0 {
        let [parts, whole] = steps;
        held = floor(-parts / whole + 0.5) * numerator / denominator;
    }
    if E & SATURATION != 0 {
        held = held.clamp(-law.max_force, law.max_force);
    }
    held
}

macro_rules! laws {
    ($($e:literal)*) => { [[$(held::<$e>),*], [$(held::<{ $e | FILTER }>),*]] };
}

/// The laws by their first six bits, without and with a filter.
static TABLES: [[Law; 64]; 2] = laws![
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31
    32 33 34 35 36 37 38 39 40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63
];
