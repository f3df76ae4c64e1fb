//! Forces between two steps of a D/A converter behind an encoder, decided exactly.
//!
//! The samples of an encoder are whole ticks and a half, and so the force of a controller whose response ends is
//! a rational number that is known, whatever numbers the motion has. Whether it lies half-way between two steps is
//! no matter of rounding then.

use passivity_core::controller::Memory;
use passivity_core::{BigRational, Controller};

use crate::number::Real;

/// The controller in rational numbers, with what it remembers.
#[derive(Clone, Debug)]
pub(super) struct Steps {
    controller: Controller<BigRational>,
    /// None before the start, and from where a sample is no double any more.
    memory: Option<Memory<BigRational>>,
}

impl Steps {
    /// Those of a controller that has them, behind an encoder and a filter whose response ends.
    pub(super) fn of(controller: &Controller<BigRational>) -> Option<Self> {
        let known = controller.encoder && controller.filter.ends();
        (known && controller.force_step.is_some()).then(|| Self {
            controller: Controller {
                max_force: None,
                ..controller.clone()
            },
            memory: None,
        })
    }

    /// The force of a device that has been where it is measured for ever.
    pub(super) fn start<R: Real>(&mut self, measured: &R, of: &Controller<R>) -> Option<R> {
        let q = rational(measured)?;
        self.memory = Some(self.controller.at_rest(&q));
        self.in_numbers(&self.controller.settled(&q), of)
    }

    /// The force of the next sample; `None` where it is not known exactly.
    pub(super) fn sample<R: Real>(&mut self, measured: &R, of: &Controller<R>) -> Option<R> {
        let Some(q) = rational(measured) else {
            self.memory = None;
            return None;
        };
        let held = self.controller.sample(self.memory.as_mut()?, &q);
        self.in_numbers(&held, of)
    }

    /// A whole number of steps as the force of a controller in its numbers.
    fn in_numbers<R: Real>(&self, held: &BigRational, of: &Controller<R>) -> Option<R> {
        let [numerator, denominator] = self.controller.force_step.as_ref()?;
        let steps = (held * denominator / numerator).to_integer();
        let [one, parts] = of.force_step.as_ref()?;
        let force = one.whole(i32::try_from(steps).ok()?) * one.clone();
        let force = force.over(parts.clone());
        Some(match &of.max_force {
            Some(most) => force.min(most.clone()).max(-most.clone()),
            None => force,
        })
    }
}

/// A measured position, where doubles have its half.
fn rational<R: Real>(measured: &R) -> Option<BigRational> {
    const LARGEST: f64 = 4_503_599_627_370_496.0;
    let near = measured.approximate();
    let exact = (near.abs() < LARGEST).then(|| BigRational::from_float(near));
    exact.flatten()
}
