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

use crate::controller::Controller;
use crate::dissipation::Friction;
use crate::scalar::{Ordered, Scalar};
use crate::transfer::TransferFunction;
use crate::witness::Cycle;

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

impl<S: Ordered> Motion<S> {
    /// The motion through these positions, with the gain of the forces that `held` gives for the period.
    ///
    /// `None` where a step is not strictly below `speed_bound` (ticks per sample), because a hand that
    /// turns round is faster in between, or where `held` has no answer.
    #[must_use]
    pub fn below(
        speed_bound: Option<&S>,
        positions: Vec<S>,
        held: impl Fn(&[S]) -> Option<Vec<S>>,
        friction: &Friction<S>,
    ) -> Option<Self> {
        if let Some(bound) = speed_bound {
            for (from, to) in steps(&positions) {
                if (to.clone() - from.clone()).abs().compare(bound)? != Ordering::Less {
                    return None;
                }
            }
        }
        let gain = gain(&held(&positions)?, &positions, friction);
        Some(Self { positions, gain })
    }

    /// The motion, where its gain is above zero.
    #[must_use]
    pub fn that_draws(self) -> Option<Self> {
        self.gain.is_positive()?.then_some(self)
    }
}

impl<S> From<Cycle<S>> for Motion<S> {
    fn from(cycle: Cycle<S>) -> Self {
        Self {
            positions: vec![cycle.from, cycle.to],
            gain: cycle.gain,
        }
    }
}

/// The forces held from each sample on, when the motion has repeated for ever.
///
/// With a controller of the kernel and all its effects, and a filter whose response ends; for one
/// whose response does not see [`commands`].
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

/// What the operator gains each time round, in KΔ²: work of the held forces less friction (23), which at constant
/// speed from sample to sample takes β·Σd² + σ·Σ|d|.
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
    let moved = steps(positions).map(|(from, to)| to.clone() - from.clone());
    let moved: Vec<S> = moved.take(forces.len()).collect();
    let way = moved.iter().fold(S::zero(), |sum, d| sum + d.abs());
    let viscous = friction.beta.clone() * S::sum_of_products(&moved, &moved);
    let spent = viscous + friction.sigma.clone() * way;
    S::sum_of_products(forces, &moved) - spent
}

/// Each position with the next, and the last with the first.
pub(crate) fn steps<S>(positions: &[S]) -> impl Iterator<Item = (&S, &S)> {
    let next = positions.iter().skip(1).chain(positions.first());
    positions.iter().zip(next)
}
