//! TH-LTI: the kernel's controller with a response that does not end.

use std::collections::VecDeque;
use std::sync::Arc;

use passivity_core::controller::{Controller, Memory};
use passivity_core::drift::Drift;
use passivity_core::periodic::commands;
use passivity_core::rational::{from_wide, to_scalar, to_wide};
use passivity_core::{BigRational, Friction, Loop, Wide};
use proptest::prelude::*;

use crate::common::{coefficient, half, nonnegative, number, positive, q, sampled, zero};
use crate::transfer::{Controller as Law, controller as any_law, response, small};

/// A loop of a law with its delay, an encoder or none.
fn with(law: &Law, delay: u16, encoder: bool) -> Loop<BigRational> {
    Loop {
        controller: Some(Arc::new(law.clone())),
        delay,
        resolution: encoder.then(|| q(1, 1)),
        ..Loop::new(q(1, 1), q(1, 1))
    }
}

/// All forces that a controller holds along a walk.
fn forces(controller: &Controller<BigRational>, positions: &[BigRational]) -> Vec<BigRational> {
    let mut memory = controller.at_rest(&positions[0]);
    let force = |xi| controller.sample(&mut memory, xi);
    positions.iter().map(force).collect()
}

sampled! {
    /// Σ cⱼqₕ₋ⱼ with the coefficients of the response, before which the device rested.
    fn th_lti_controller_is_its_response(
        law in any_law(), delay in 0u16..3, encoder in any::<bool>(), unilateral in any::<bool>(),
        positions in prop::collection::vec(small(), 1..14),
    ) {
        let the_loop = Loop { unilateral, ..with(&law, delay, encoder) };
        let controller = Controller::of(&the_loop);
        prop_assert_eq!(controller.filter.ends(), law.denominator().len() == 1);
        let measured: Vec<_> = positions.iter().map(|xi| controller.measured(xi)).collect();
        let late = |h: usize| &measured[h.saturating_sub(usize::from(delay))];
        let c = response(&law, positions.len());
        prop_assert_eq!(&c, &law.impulse_response(positions.len()));
        let by_hand = |h: usize| {
            if unilateral && *late(h) < zero() {
                return zero();
            }
            let moved = (0..=h).map(|j| &c[j] * (late(h - j) - &measured[0]));
            -moved.fold(law.at_one() * &measured[0], |sum, term| sum + term)
        };
        let expected: Vec<_> = (0..positions.len()).map(by_hand).collect();
        prop_assert_eq!(&forces(&controller, &positions), &expected);
        // From the list of all samples, and when it has rested there for ever.
        let samples: Vec<_> = measured.iter().rev().cloned().collect();
        prop_assert_eq!(&controller.held_force(&samples), expected.last().unwrap());
        prop_assert_eq!(&controller.settled(&measured[0]), &expected[0]);
        // Rest changes nothing that is remembered.
        let mut memory = controller.at_rest(&positions[0]);
        prop_assert_eq!(&controller.sample(&mut memory, &positions[0]), &expected[0]);
        prop_assert_eq!(memory, controller.at_rest(&positions[0]));
    }

    /// A motion that has repeated for ever leads the memory round to itself, under the commands
    /// that solve the equation of the period.
    fn th_lti_controller_of_a_period(
        law in any_law(), delay in 0u16..3, positions in prop::collection::vec(small(), 1..9),
    ) {
        let controller = Controller::of(&with(&law, delay, true));
        let measured: Vec<_> = positions.iter().map(|xi| controller.measured(xi)).collect();
        let expected = commands(&law.clone().delayed(delay), &measured).unwrap();
        let latest_first = measured.iter().rev().cycle();
        // y is what the command has beside H(1) times the sample that had reached the filter.
        let reached = latest_first.clone().skip(usize::from(delay));
        let past = expected.iter().rev().cycle().zip(reached);
        let past = past.map(|(force, q)| -(force + law.at_one() * q));
        let start = Memory {
            samples: latest_first.take(controller.memory()).cloned().collect(),
            past: past.take(controller.filter.poles.len()).collect::<VecDeque<_>>(),
        };
        let mut memory = start.clone();
        let held: Vec<_> = positions.iter().map(|xi| controller.sample(&mut memory, xi)).collect();
        prop_assert_eq!(held, expected);
        prop_assert_eq!(memory, start);
    }

    /// Filtered damping by its difference equation, w = aw′ + (1 − a)(q − q′).
    fn th_lti_controller_of_filtered_damping(
        damping in coefficient(), tau in nonnegative(), delay in 0u16..3,
        positions in prop::collection::vec(small(), 1..9), limit in positive(),
    ) {
        let the_loop = Loop {
            damping: Some(damping.clone()),
            damping_time_constant: Some(tau.clone()),
            delay,
            max_force: Some(limit.clone()),
            resolution: Some(q(1, 1)),
            ..Loop::new(q(1, 1), q(1, 1))
        };
        let a = &tau / (q(1, 1) + &tau);
        let mut line: VecDeque<_> =
            std::iter::repeat_n(positions[0].floor() + half(), usize::from(delay) + 1).collect();
        let (mut before, mut w) = (line[0].clone(), zero());
        let mut expected = Vec::new();
        for xi in &positions {
            line.push_front(xi.floor() + half());
            line.truncate(usize::from(delay) + 1);
            let now = line.back().unwrap().clone();
            w = &a * w + (q(1, 1) - &a) * (&now - before);
            let force = -(&now + &damping * &w);
            expected.push(force.min(limit.clone()).max(-&limit));
            before = now;
        }
        prop_assert_eq!(&forces(&Controller::of(&the_loop), &positions), &expected);
    }

    /// In other numbers it is the same controller, its coefficients made of their digits.
    fn num_exact_recursion_in_other_numbers(
        law in any_law(), delay in 0u16..3, positions in prop::collection::vec(small(), 1..6),
    ) {
        let the_loop = with(&law, delay, true);
        let wide = Controller::of(&the_loop.map(|_, x| to_wide(x)));
        let mut memory = wide.at_rest(&to_wide(&positions[0]));
        let held = positions.iter().map(|xi| from_wide(&wide.sample(&mut memory, &to_wide(xi))));
        let held: Option<Vec<_>> = held.collect();
        prop_assert_eq!(held, Some(forces(&Controller::of(&the_loop), &positions)));
    }

    fn num_exact_digits(x in number(), power in 0i32..90) {
        let x = x * q(3, 7).pow(power);
        prop_assert_eq!(from_wide(&to_scalar::<Wide>(&x)), Some(x.clone()));
        prop_assert_eq!(to_scalar::<BigRational>(&x), x);
    }
}

#[test]
fn th_lti_no_formula_for_a_drift_without_end() {
    let half_pole = [q(1, 1), q(-1, 2)];
    let lag = Law::new([q(1, 1)], half_pole).unwrap().recursion();
    assert_eq!(
        Drift::of(&lag, &Friction::new(zero(), zero())),
        None,
        "the formula is of a response that ends"
    );
}
