//! Going to and fro at a steady pace: what draws energy where β < λ(0), with the gain as a formula
//! (the converse of TH-LTI at the lowest frequencies).

use crate::controller::Filter;
use crate::dissipation::Friction;
use crate::scalar::Ordered;

/// Going N samples at a steady pace and as many back, again and again: what gains where β < λ(0).
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Friction, Scalar, controller::Filter, drift::Drift};
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
    /// Of a filter whose response ends. Because over a period Σ DₕDₕ₋ⱼ = A²(2N − 4j) for j ≤ N, and whole ticks are measured exactly
    /// but for a constant.
    #[must_use]
    pub fn gain(filter: &Filter<S>, friction: &Friction<S>, step: &S, samples: &S) -> S {
        let [per_step, at_turns] = Self::parts(filter, friction);
        let both_ways = samples.double();
        let drawn = both_ways.clone() * per_step - at_turns.double().double();
        step.square() * drawn - both_ways * friction.sigma.clone() * step.clone()
    }

    /// One that gains, whenever β < λ(0) = ½H(1) + Σ gⱼ; `None` otherwise, when a number is
    /// undefined, or for a filter whose response does not end.
    #[must_use]
    pub fn of(filter: &Filter<S>, friction: &Friction<S>) -> Option<Self> {
        let [per_step, at_turns] = Self::parts(filter, friction);
        if !filter.ends() || !per_step.is_positive()? {
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
