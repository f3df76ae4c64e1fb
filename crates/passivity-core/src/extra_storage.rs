//! Energy that effects with memory add, and the extra storage that pays for it later.
//!
//! A delay and virtual damping add to the energy that a step generates at most a multiple of d² and
//! of |d|, plus a change of *extra storage* that a sum over steps telescopes away. The multiples are
//! what the criterion must subtract: see [`Loop::cost`](crate::Loop::cost).

use crate::scalar::Scalar;

/// Energy that a delay of k samples adds over a step, d·Σ d_{h−j} for j = 1…k (TH-DELAY), in KΔ².
///
/// `past` holds the last k displacements, the latest first. At most k·d² plus the drop of
/// [`delay_storage`].
#[must_use]
pub fn generated_by_delay<S: Scalar>(past: &[S], displacement: &S) -> S {
    let travelled = past.iter().fold(S::zero(), |sum, d| sum + d.clone());
    displacement.clone() * travelled
}

/// Extra storage of a delay of k samples, Σ ½(k − j + 1)·d²_{h−j} for j = 1…k (TH-DELAY), in KΔ².
///
/// Each past step keeps ½d² for every later step that will still be charged with it.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, extra_storage::delay_storage};
///
/// let past = [Fixed::integer(1), Fixed::integer(2)]; // latest first, k = 2
/// assert_eq!(delay_storage(&past), Fixed::integer(3)); // ½·2·1 + ½·1·4
/// ```
#[must_use]
pub fn delay_storage<S: Scalar>(past: &[S]) -> S {
    // Summing the oldest first, each further step is counted once more than the one before it.
    let mut weight = S::zero();
    let mut storage = S::zero();
    for d in past.iter().rev() {
        weight = weight + S::one();
        storage = storage + (weight.clone() * d.square()).half();
    }
    storage
}

/// Energy that virtual damping adds over a step, −B·(q − q′)·d (TH-DAMP), in KΔ².
///
/// `ticks` is q − q′, the difference of the two latest samples that the controller knows, in
/// ticks; it differs by less than 1 from the displacement between them (not at all without an
/// encoder). At most B·d² + B·|d| plus the drop of [`damping_storage`].
#[must_use]
pub fn generated_by_damping<S: Scalar>(damping: &S, ticks: &S, displacement: &S) -> S {
    -(damping.clone() * ticks.clone() * displacement.clone())
}

/// Extra storage of virtual damping, ½B·Σ d² over the steps not yet acted on (TH-DAMP), in KΔ².
///
/// `past` holds the last 1 + k displacements, where k is the delay.
#[must_use]
pub fn damping_storage<S: Scalar>(damping: &S, past: &[S]) -> S {
    let squares = past.iter().fold(S::zero(), |sum, d| sum + d.square());
    (damping.clone() * squares).half()
}

/// Storage of a one-pole filter of displacements, S(w) = w²/(2(1 − a)) (TH-LTI), in KΔ² per unit of
/// damping; `pole` is a in [0, 1), `filtered` is w.
///
/// The filter's next value is w′ = aw + (1 − a)D. Damping by it generates D·(−w) for each unit.
#[must_use]
pub fn one_pole_storage<S: Scalar>(pole: &S, filtered: &S) -> S {
    filtered.square().over((S::one() - pole.clone()).double())
}

/// What a step keeps to spare when filtered damping is charged ρD², ρ = (1 − a)/(1 + a), instead of
/// D² (TH-LTI): D·w + ρD² − (S(w′) − S(w)), with w′ = aw + (1 − a)D; in KΔ² per unit of damping.
///
/// It is the square ((1 + a)w + (1 − a)D)²/(2(1 + a)), so it is never below zero.
///
/// # Example
///
/// ```
/// use passivity_core::{Fixed, Scalar, extra_storage::one_pole_spare};
///
/// // a = ½, w = 1, D = −3 is where nothing is left.
/// let spare = one_pole_spare(&Fixed::new(1, 2), &Fixed::integer(1), &Fixed::integer(-3));
/// assert_eq!(spare, Fixed::integer(0));
/// ```
#[must_use]
pub fn one_pole_spare<S: Scalar>(pole: &S, filtered: &S, displacement: &S) -> S {
    let (a, w, d) = (pole.clone(), filtered.clone(), displacement.clone());
    let share = (S::one() - a.clone()).over(S::one() + a.clone());
    let next = a.clone() * w.clone() + (S::one() - a) * d.clone();
    let gained = one_pole_storage(pole, &next) - one_pole_storage(pole, &w);
    d.clone() * w + share * d.square() - gained
}
