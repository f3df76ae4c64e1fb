//! Motions that repeat, and draw energy each time round: the converse of TH-LTI.
//!
//! Over a period that ends where it began storage has not changed, so what the operator gains is the
//! work of the held force less friction: computed from the controller and friction alone. A motion
//! that starts at rest comes as near to the repeating one as one likes, so where a period gains, so
//! does a motion that is long enough, without end.

use alloc::collections::VecDeque;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;

use crate::controller::{Controller, Filter};
use crate::dissipation::Friction;
use crate::frequency::ViscousCost;
use crate::pi;
use crate::scalar::{Ordered, Scalar};
use crate::transfer::TransferFunction;

/// The longest period that [`harmonic`] tries, in samples.
pub const LONGEST_PERIOD: u32 = 256;

/// A motion that repeats: its positions at the samples of a period, and what the operator gains.
///
/// Between two samples the device moves at constant speed, and after the last one back to the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<S> {
    /// The positions, in ticks, or in the unit of length without an encoder.
    pub positions: Vec<S>,
    /// Energy that the operator gains each time round, in KΔ².
    pub gain: S,
}

/// The forces held from each sample on, when the motion has repeated for ever.
///
/// With a controller of the kernel and all its effects; for one whose response does not end see
/// [`commands`].
#[must_use]
pub fn held_forces<S: Scalar>(controller: &Controller<S>, positions: &[S]) -> Vec<S> {
    let measured: Vec<S> = positions.iter().map(|xi| controller.measured(xi)).collect();
    let known = controller.memory() + 1;
    let at = |later: usize| {
        // The present sample, the one before it, and so on round the period.
        let samples = measured.iter().rev().cycle().skip(later).take(known);
        controller.held_force(&samples.cloned().collect::<Vec<S>>())
    };
    (0..positions.len()).rev().map(at).collect()
}

/// The commands of a linear controller from each sample on, when the motion has repeated for ever;
/// `measured` are the measured positions of a period.
///
/// Exact also where the response does not end: the state at the start of a period is the one that
/// the period leads back to, a linear equation of the denominator's order. `None` when a number is
/// undefined.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, periodic::commands, transfer::TransferFunction};
///
/// let lag = TransferFunction::new([Fixed::integer(1)], [Fixed::integer(1), Fixed::new(-1, 2)]);
/// // y = q + ½y′: with q = 1, −1, 1, … it is ±2/3. The force is −y.
/// let forces = commands(&lag.unwrap(), &[1, -1].map(Fixed::integer)).unwrap();
/// assert_eq!(forces, [Fixed::new(-2, 3), Fixed::new(2, 3)]);
/// ```
#[must_use]
pub fn commands<S: Ordered>(controller: &TransferFunction<S>, measured: &[S]) -> Option<Vec<S>> {
    let (leading, others) = controller.denominator().split_first()?;
    let round = |state: &[S], driven: bool| -> (Vec<S>, Vec<S>) {
        let mut state: VecDeque<S> = state.iter().cloned().collect();
        let mut outputs = Vec::with_capacity(measured.len());
        for earlier in (0..measured.len()).rev() {
            let samples = measured.iter().rev().cycle().skip(earlier);
            let taps = controller.numerator().iter().zip(samples);
            let input = taps.fold(S::zero(), |sum, (n, q)| sum + n.clone() * q.clone());
            let input = if driven { input } else { S::zero() };
            let past = others.iter().zip(&state);
            let output = past
                .fold(input, |rest, (d, y)| rest - d.clone() * y.clone())
                .over(leading.clone());
            outputs.push(output.clone());
            state.push_front(output);
            state.truncate(others.len());
        }
        (outputs, state.into_iter().collect())
    };
    let order = others.len();
    let nothing = vec![S::zero(); order];
    let (_, forced) = round(&nothing, true);
    // (1 − A)·s = forced, where A is what a period without input makes of a state.
    let columns: Vec<Vec<S>> = (0..order)
        .map(|k| {
            let unit: Vec<S> = (0..order)
                .map(|i| if i == k { S::one() } else { S::zero() })
                .collect();
            let (_, after) = round(&unit, false);
            unit.into_iter().zip(after).map(|(s, a)| s - a).collect()
        })
        .collect();
    let row = |i: usize| {
        columns
            .iter()
            .filter_map(move |column| column.get(i).cloned())
    };
    let rows = forced
        .into_iter()
        .enumerate()
        .map(|(i, f)| row(i).chain([f]).collect());
    let (outputs, _) = round(&solved(rows.collect())?, true);
    Some(outputs.into_iter().map(|y| -y).collect())
}

/// The solution of linear equations, each a row of coefficients and the right-hand side last;
/// `None` when there is not exactly one.
fn solved<S: Ordered>(mut rows: Vec<Vec<S>>) -> Option<Vec<S>> {
    let mut done: Vec<Vec<S>> = Vec::with_capacity(rows.len());
    for column in 0..rows.len() {
        let has_pivot = |row: &Vec<S>| {
            let sign = row.get(column).and_then(Ordered::sign);
            matches!(sign, Some(Ordering::Less | Ordering::Greater))
        };
        let pivot = rows.swap_remove(rows.iter().position(has_pivot)?);
        let leading = pivot.get(column)?.clone();
        let pivot: Vec<S> = pivot.into_iter().map(|x| x.over(leading.clone())).collect();
        for row in rows.iter_mut().chain(&mut done) {
            let factor = row.get(column)?.clone();
            for (x, p) in row.iter_mut().zip(&pivot) {
                *x = x.clone() - factor.clone() * p.clone();
            }
        }
        done.push(pivot);
    }
    done.into_iter().map(|mut row| row.pop()).collect()
}

/// What the operator gains each time round: work of the held forces less friction (23), in KΔ².
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction, Loop, Scalar, controller::Controller, periodic};
///
/// let friction = Friction::new(Fixed::integer(0), Fixed::integer(0));
/// let wall = Controller::of(&Loop::plain(friction));
/// let positions = [0, 1].map(Fixed::integer);
/// let forces = periodic::held_forces(&wall, &positions);
/// assert_eq!(periodic::gain(&forces, &positions, &friction), Fixed::integer(1));
/// ```
#[must_use]
pub fn gain<S: Scalar>(forces: &[S], positions: &[S], friction: &Friction<S>) -> S {
    let next = positions.iter().skip(1).chain(positions.first());
    let steps = forces.iter().zip(positions).zip(next);
    steps.fold(S::zero(), |sum, ((force, from), to)| {
        let d = to.clone() - from.clone();
        sum + force.clone() * d.clone() - friction.dissipated_lower(&d, &d.abs())
    })
}

/// A motion of one frequency, in whole ticks from 0 up, that gains energy where β < λ(θ) at an angle
/// θ = 2πq/p with a period p of at most [`LONGEST_PERIOD`] samples.
///
/// Among them the angle with the largest λ(θ) is taken, and the amplitude doubled until the gain is
/// above zero: by then neither Coulomb friction nor rounding to ticks makes up for it. `held` gives
/// the forces held over a period of positions. `None` where β is enough at all these angles, where
/// the speed reaches `speed_bound` (ticks per sample) first, or where the force is limited.
#[must_use]
pub fn harmonic(
    cost: &ViscousCost,
    held: impl Fn(&[BigRational]) -> Option<Vec<BigRational>>,
    friction: &Friction<BigRational>,
    speed_bound: Option<&BigRational>,
) -> Option<Motion<BigRational>> {
    let (turns, period, spare) = best_angle(cost, &friction.beta)?;
    // Past this amplitude it is something else that spends the energy.
    let scale = ((&friction.sigma + BigRational::one()) / spare)
        .ceil()
        .to_integer();
    let doublings = scale.bits() + 16;
    let circle = Circle::to(u32::try_from(doublings).ok()? + 64);
    // With steps Dₕ = cos θh the positions are sin θ(h − ½)/(2 sin(θ/2)).
    let half_steps = |h: u32| circle.sine(&fraction(turns * (2 * h + 2 * period - 1), 2 * period));
    let wave: Vec<BigInt> = (0..period).map(half_steps).collect();
    let largest = half_steps(1) * 2;
    for doubling in 1..=doublings {
        let scaled = wave.iter().map(|w| {
            let double = BigInt::from(2);
            let doubled: BigInt = (w << doubling) * &double + &largest;
            doubled.div_floor(&(&largest * &double))
        });
        let whole: Vec<BigInt> = scaled.collect();
        let least = whole.iter().min()?;
        let from_zero = whole.iter().map(|n| BigRational::from_integer(n - least));
        let positions: Vec<BigRational> = from_zero.collect();
        if let Some(bound) = speed_bound {
            let next = positions.iter().skip(1).chain(positions.first());
            let steps = positions
                .iter()
                .zip(next)
                .map(|(from, to)| Scalar::abs(&(to - from)));
            if steps
                .into_iter()
                .any(|d| d.compare(bound) != Some(Ordering::Less))
            {
                return None;
            }
        }
        let gain = gain(&held(&positions)?, &positions, friction);
        if gain.is_positive()? {
            return Some(Motion { positions, gain });
        }
    }
    None
}

/// Numerator q and denominator p of the fraction of a turn, and λ(2πq/p) − β > 0, as large as it
/// gets near the middles of the bands where β is short; of equals the shortest period.
fn best_angle(cost: &ViscousCost, beta: &BigRational) -> Option<(u32, u32, BigRational)> {
    let circle = Circle::to(64);
    let thousandth = fraction(1, 1000);
    let bands = cost.short_at(beta, &thousandth).into_iter();
    let targets: Vec<BigRational> = bands
        .map(|band| circle.turns_to(&(band.lo() + band.hi()).half()))
        .collect();
    let mut best: Option<(u32, u32, BigRational)> = None;
    for period in 2..=LONGEST_PERIOD {
        let nearest = targets.iter().filter_map(|target| {
            let turns = (target * fraction(period, 1)).to_integer();
            u32::try_from(turns).ok()
        });
        for turns in nearest.flat_map(|below| [below, below + 1]) {
            if turns == 0 || 2 * turns > period || turns.gcd(&period) > 1 {
                continue;
            }
            let spare = cost.at(&circle.cosine(turns, period)) - beta;
            let more = best.as_ref().is_none_or(|(_, _, most)| spare > *most);
            if more && spare.is_positive()? {
                best = Some((turns, period, spare));
            }
        }
    }
    best
}

fn fraction(n: u32, d: u32) -> BigRational {
    BigRational::new(BigInt::from(n), BigInt::from(d))
}

/// Sines to so many bits after the point, but for a few units of the last place.
///
/// Nothing is concluded from them: a motion made of them is a motion, and its gain is exact.
struct Circle {
    bits: u32,
    /// π in units of 2^−(`bits` + 32).
    pi: BigInt,
}

impl Circle {
    const SPARE: u32 = 32;

    fn to(bits: u32) -> Self {
        let working = bits + Self::SPARE;
        let unit = BigRational::from_integer(BigInt::from(1) << working);
        let pi = pi::pi().enclosure(working);
        let pi = pi.map_or_else(BigRational::zero, |pi| pi.lo() * unit);
        Self {
            bits,
            pi: pi.to_integer(),
        }
    }

    /// sin(2πx) in units of 2^−`bits`, for 0 ≤ x.
    fn sine(&self, turns: &BigRational) -> BigInt {
        let one = BigInt::from(1) << (self.bits + Self::SPARE);
        let within = turns - Scalar::floor(turns);
        let angle: BigInt = &self.pi * 2 * within.numer() / within.denom();
        let square = &angle * &angle / &one;
        let (mut term, mut sum) = (angle.clone(), angle);
        let mut i = 1_u32;
        while term != BigInt::ZERO {
            // Towards zero, so that it ends there.
            term = -(term * &square / &one / ((i + 1) * (i + 2)));
            sum += &term;
            i += 2;
        }
        sum >> Self::SPARE
    }

    /// cos(2πq/p), and exactly where it is a rational: no other than a multiple of ½ is.
    fn cosine(&self, turns: u32, period: u32) -> BigRational {
        let quarter_on = fraction(4 * turns + period, 4 * period);
        let one = BigInt::from(1) << self.bits;
        let close = BigRational::new(self.sine(&quarter_on), one);
        if [2, 3, 4, 6].contains(&period) {
            close.double().round().half()
        } else {
            close
        }
    }

    /// The x in [0, ½] with cos(2πx) = `cosine`, to 20 bits.
    fn turns_to(&self, cosine: &BigRational) -> BigRational {
        let one = BigRational::from_integer(BigInt::from(1) << self.bits);
        let wanted = (cosine * one).to_integer();
        let quarter = BigRational::one().half().half();
        let (mut x, mut step) = (quarter.clone(), quarter.clone());
        for _ in 0..20 {
            step = step.half();
            let above = self.sine(&(&x + &quarter)) > wanted;
            x = if above { x + &step } else { x - &step };
        }
        x
    }
}

/// Going N samples at a steady pace and as many back, again and again: what gains where β < λ(0).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction, Scalar, controller::Filter, periodic::Drift};
///
/// let friction = Friction::new(Fixed::new(49, 100), Fixed::integer(3));
/// let drift = Drift::of(&Filter::wall(), &friction).unwrap();
/// assert!(drift.gain > Fixed::integer(0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Drift<S> {
    /// Whole ticks per sample.
    pub step: S,
    /// N, samples each way.
    pub samples: S,
    /// Energy that the operator gains each time there and back, in KΔ².
    pub gain: S,
}

impl<S: Ordered> Drift<S> {
    /// The gain of steps of A whole ticks, N samples each way, N not below the filter's order:
    /// A²·[2N(λ(0) − β) − 4Σ j·gⱼ] − 2NσA, in KΔ².
    ///
    /// Because over a period Σ DₕDₕ₋ⱼ = A²(2N − 4j) for j ≤ N, and whole ticks are measured exactly
    /// but for a constant.
    #[must_use]
    pub fn gain(filter: &Filter<S>, friction: &Friction<S>, step: &S, samples: &S) -> S {
        let [per_step, at_turns] = Self::parts(filter, friction);
        let both_ways = samples.double();
        let drawn = both_ways.clone() * per_step - at_turns.double().double();
        step.square() * drawn - both_ways * friction.sigma.clone() * step.clone()
    }

    /// One that gains, whenever β < λ(0) = ½H(1) + Σ gⱼ; `None` otherwise, or when a number is
    /// undefined.
    #[must_use]
    pub fn of(filter: &Filter<S>, friction: &Friction<S>) -> Option<Self> {
        let [per_step, at_turns] = Self::parts(filter, friction);
        if !per_step.is_positive()? {
            return None;
        }
        let order = filter.tails.iter().fold(S::one(), |n, _| n + S::one());
        // Twice as long as it takes to make up for the turns, and at least as the filter's memory.
        let needed = at_turns.double().double().over(per_step.clone());
        let samples = order.max(needed.floor() + S::one());
        // The steps as large as it takes to make up for Coulomb friction.
        let both_ways = samples.double();
        let drawn = both_ways.clone() * per_step - at_turns.double().double();
        let step = (both_ways * friction.sigma.clone()).over(drawn).floor() + S::one();
        let gain = Self::gain(filter, friction, &step, &samples);
        gain.is_positive()?.then_some(Self {
            step,
            samples,
            gain,
        })
    }

    /// λ(0) − β and Σ j·gⱼ.
    fn parts(filter: &Filter<S>, friction: &Friction<S>) -> [S; 2] {
        let start = (filter.sum.clone().half() - friction.beta.clone(), S::zero());
        let mut j = S::zero();
        let (per_step, at_turns) = filter.tails.iter().fold(start, |(sum, weighted), g| {
            j = j.clone() + S::one();
            (sum + g.clone(), weighted + j.clone() * g.clone())
        });
        [per_step, at_turns]
    }
}
