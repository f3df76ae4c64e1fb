//! Motions of one frequency that draw energy: a witness wherever β < λ(θ) at some angle (the converse
//! of TH-LTI).
//!
//! Steps Dₕ = A·cos θh with θ = 2πq/p repeat after p samples and draw Σ (λ(θ) − β)Dₕ² each time round.
//! The positions are rounded to whole ticks, which an encoder measures exactly but for a constant.

use alloc::vec::Vec;

use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;

use crate::absolute_sum;
use crate::circle::Circle;
use crate::dissipation::Friction;
use crate::frequency::ViscousCost;
use crate::interval::Interval;
use crate::periodic::Motion;
use crate::scalar::{Ordered, Scalar};
use crate::transfer::TransferFunction;

/// The longest period that [`harmonic`] tries, in samples.
pub const LONGEST_PERIOD: u32 = 256;

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
    if cost.decide(&friction.beta).is_nonnegative() {
        return None;
    }
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
    for doubling in (scale.bits() / 2).max(1)..=doublings {
        let scaled = wave.iter().map(|w| {
            let double = BigInt::from(2);
            let doubled: BigInt = (w << doubling) * &double + &largest;
            doubled.div_floor(&(&largest * &double))
        });
        let whole: Vec<BigInt> = scaled.collect();
        let least = whole.iter().min()?;
        let from_zero = whole.iter().map(|n| BigRational::from_integer(n - least));
        let positions: Vec<BigRational> = from_zero.collect();
        let motion = Motion::below(speed_bound, positions, &held, friction)?;
        if let Some(found) = motion.that_draws() {
            return Some(found);
        }
    }
    None
}

/// Numerator q and denominator p of the fraction of a turn, and λ(2πq/p) − β > 0, as large as it
/// gets near the middles of the bands where β is short; of equals the shortest period.
fn best_angle(cost: &ViscousCost, beta: &BigRational) -> Option<(u32, u32, BigRational)> {
    let circle = Circle::to(64);
    let targets = targets(cost, beta, 32);
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
            let cost = cost.at(circle.cosine(&fraction(turns, period)).lo());
            if cost > *best.as_ref().map_or(beta, |(_, _, most)| most) {
                best = Some((turns, period, cost));
            }
        }
    }
    best.map(|(turns, period, cost)| (turns, period, cost - beta))
}

/// The angles, in turns, in the middle of each band where β is short, from bands enclosed to so many
/// bits.
fn targets(cost: &ViscousCost, beta: &BigRational, bits: u32) -> Vec<BigRational> {
    let circle = Circle::to(bits);
    let width = BigRational::new(BigInt::from(1), BigInt::from(1) << bits);
    let bands = cost.short_at(beta, &width).into_iter();
    bands.map(|band| circle.turns_to(&band.middle())).collect()
}

fn fraction(n: u32, d: u32) -> BigRational {
    BigRational::new(BigInt::from(n), BigInt::from(d))
}

/// A motion of one frequency as a formula: its period may be too long to write down.
///
/// The positions are whole ticks ξₕ with |ξₕ − A·sin θ(h − ½)/(2 sin(θ/2))| ≤ ½, θ = 2πq/p, or those
/// raised all by the same whole number; so the steps are Dₕ = A·cos θh + δₕ with |δₕ| ≤ 1.
///
/// # The gain
///
/// With s ≤ λ(θ) − β and F = ½H(1) + Σ|gⱼ| + β, which |λ − β| nowhere exceeds,
///
/// gain ≥ p·[s·(½A² − 2A) − F − σ(A + 1)] for A ≥ 4:
///
/// the steps A·cos θh alone draw at least s·½A²p; what δ does to the squared spectrum at θ is at most
/// a share 2·A·p of λ(θ) − β, at all frequencies together at most F·p; and Σ|Dₕ| ≤ (A + 1)p.
///
/// # Example
///
/// ```
/// use passivity_core::{BigRational, Friction, Scalar, transfer::TransferFunction, wave::Wave};
///
/// // A delay of one sample costs 3/2, at the lowest frequencies.
/// let late = TransferFunction::wall().delayed(1);
/// let ratio = |n: i64, d: i64| BigRational::new(n.into(), d.into());
/// let friction = Friction::new(ratio(1_499_999, 1_000_000), ratio(1, 1));
/// let wave = Wave::of(&late, &friction).unwrap();
/// assert!(wave.gain_at_least > ratio(0, 1) && wave.period > 1000.into());
/// assert_eq!(Wave::of(&late, &Friction::new(ratio(3, 2), ratio(0, 1))), None);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Wave {
    /// q, turns in a period, without a common divisor with p.
    pub turns: BigInt,
    /// p, in samples.
    pub period: BigInt,
    /// A, in whole ticks per sample.
    pub amplitude: BigInt,
    /// A lower bound of what the operator gains each time round, above zero, in KΔ².
    pub gain_at_least: BigRational,
}

/// The longest period that a [`Wave`] is looked for with, as a power of two.
const LONGEST_WAVE: u32 = 64;

impl Wave {
    /// A wave that gains, for any stable controller, where β < λ; `None` where β ≥ λ.
    ///
    /// With a D/A converter of step δ add ½δ to σ: that is how much a step may lose by its rounding.
    /// `None` as well where even a period of 2⁶⁴ samples meets no angle that is short, or where
    /// Σ|gⱼ| cannot be enclosed within bounds ([`absolute_sum::MOST_TERMS`]).
    #[must_use]
    pub fn of(
        controller: &TransferFunction<BigRational>,
        friction: &Friction<BigRational>,
    ) -> Option<Self> {
        let cost = ViscousCost::of(controller);
        if cost.decide(&friction.beta).is_nonnegative() {
            return None;
        }
        let one = BigRational::one();
        let most = absolute_sum::viscous_bound(controller, &one)?.hi() + &friction.beta;
        let (turns, period, spare) = (3..=LONGEST_WAVE)
            .step_by(3)
            .find_map(|power| angle(&cost, &friction.beta, power))?;
        let mut amplitude = BigRational::integer(4);
        loop {
            let drawn = &spare * (amplitude.square().half() - amplitude.double());
            let spent = &most + &friction.sigma * (&amplitude + &one);
            let gain = (drawn - spent) * BigRational::from_integer(period.clone());
            if gain.is_positive()? {
                return Some(Self {
                    turns,
                    period,
                    amplitude: amplitude.to_integer(),
                    gain_at_least: gain,
                });
            }
            amplitude = amplitude.double();
        }
    }
}

/// Turns and period of an angle near the middle of a band where β is short, of a period of about
/// 2^`power`, and s with 0 < s ≤ λ(θ) − β, decided exactly.
fn angle(
    cost: &ViscousCost,
    beta: &BigRational,
    power: u32,
) -> Option<(BigInt, BigInt, BigRational)> {
    let circle = Circle::to(32 + 2 * power);
    let period = BigInt::from(1) << power;
    for target in targets(cost, beta, 2 * power) {
        let below = (target * BigRational::from_integer(period.clone())).to_integer();
        for turns in [below.clone(), below + 1] {
            let turns = BigRational::new(turns, period.clone());
            if turns.is_positive() != Some(true) || turns.double() > BigRational::one() {
                continue;
            }
            let cosine = within_range(&circle.cosine(&turns));
            let half = (cost.at(cosine.lo()) - beta).half();
            if half.is_positive() != Some(true) {
                continue;
            }
            // A unit fraction: the decision is about as long as its numbers.
            let spare = half.recip().ceil().recip();
            if cost.is_at_least(&(beta + &spare), &cosine) {
                return Some((turns.numer().clone(), turns.denom().clone(), spare));
            }
        }
    }
    None
}

/// The part of an enclosure of a cosine that is in [−1, 1].
fn within_range(cosine: &Interval<BigRational>) -> Interval<BigRational> {
    let one = BigRational::one();
    cosine.map(|end| Scalar::max(Scalar::min(end.clone(), one.clone()), -one.clone()))
}
