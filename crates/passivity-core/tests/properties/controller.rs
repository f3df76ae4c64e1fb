//! The controller (5): every combination of its parts against the force written out.

use passivity_core::controller::{Controller, Filter};
use passivity_core::rational::{from_wide, to_wide};
use passivity_core::{BigRational, Fixed, Friction, Loop, Scalar as _, quantizer};
use proptest::prelude::*;

use crate::common::{coefficient, half, number, position, positive, q, sampled, zero};

/// The numbers that the parts of a controller may need.
#[derive(Clone, Debug)]
struct Parts {
    damping: BigRational,
    force_step: BigRational,
    max_force: BigRational,
    delay: u16,
}

fn parts() -> impl Strategy<Value = Parts> {
    (coefficient(), positive(), positive(), 1u16..4).prop_map(
        |(damping, force_step, max_force, delay)| Parts {
            damping,
            force_step,
            max_force,
            delay,
        },
    )
}

/// The loop with the parts that six bits name; all 64 sets of them are tried.
fn with_parts(parts: &Parts, set: u8) -> Loop<BigRational> {
    let has = |bit: u8| set >> bit & 1 == 1;
    Loop {
        resolution: has(0).then(|| q(1, 1)),
        unilateral: has(1),
        damping: has(2).then(|| parts.damping.clone()),
        force_step: has(3).then(|| parts.force_step.clone()),
        max_force: has(4).then(|| parts.max_force.clone()),
        delay: if has(5) { parts.delay } else { 0 },
        ..Loop::new(q(1, 1), q(1, 1))
    }
}

/// The force held after the last of the positions, before the first of which the device rested.
fn written_out(the_loop: &Loop<BigRational>, positions: &[BigRational]) -> BigRational {
    let before = |samples: u16| {
        let last = positions.len() - 1;
        let xi = &positions[last.saturating_sub(usize::from(samples))];
        if the_loop.resolution.is_some() {
            xi.floor() + half()
        } else {
            xi.clone()
        }
    };
    let (position, earlier) = (before(the_loop.delay), before(the_loop.delay + 1));
    // Outside of a one-sided wall there is no force, not even that of the damper.
    if the_loop.unilateral && position < zero() {
        return zero();
    }
    let damping = the_loop.damping.clone().unwrap_or_else(zero);
    let mut force = -&position - damping * (&position - earlier);
    if let Some(step) = &the_loop.force_step {
        // To the nearest whole step; half-way, upwards.
        let below = (&force / step).floor() * step;
        force = if &force - &below < half() * step {
            below
        } else {
            below + step
        };
    }
    match &the_loop.max_force {
        Some(limit) if force > *limit => limit.clone(),
        Some(limit) if force < -limit => -limit,
        _ => force,
    }
}

/// All forces that a controller holds along a walk.
fn forces(controller: &Controller<BigRational>, positions: &[BigRational]) -> Vec<BigRational> {
    let mut memory = controller.at_rest(&positions[0]);
    let force = |xi| controller.sample(&mut memory, xi);
    positions.iter().map(force).collect()
}

fn positions() -> impl Strategy<Value = Vec<BigRational>> {
    let near = (-48i64..48).prop_map(|n| q(n, 8));
    prop::collection::vec(prop_oneof![7 => near, 1 => position()], 1..7)
}

sampled! {
    /// The 64 controllers, sample by sample and from the list of samples.
    fn eq_16_17_controller_is_the_force_written_out(parts in parts(), positions in positions()) {
        for set in 0..64 {
            let the_loop = with_parts(&parts, set);
            let controller = Controller::of(&the_loop);
            let expected: Vec<_> = (1..=positions.len())
                .map(|count| written_out(&the_loop, &positions[..count]))
                .collect();
            prop_assert_eq!(&forces(&controller, &positions), &expected, "set {:b}", set);
            // From the samples as they were measured, the latest first.
            let samples: Vec<_> = positions.iter().rev().map(|xi| controller.measured(xi)).collect();
            prop_assert_eq!(&controller.held_force(&samples), expected.last().unwrap());
            // What is remembered is enough, and what is older than that is not used.
            let needed = controller.memory() + 1;
            prop_assert_eq!(needed, 1 + usize::from(the_loop.delay) + usize::from(the_loop.damping.is_some()));
            if samples.len() >= needed {
                prop_assert_eq!(&controller.held_force(&samples[..needed]), expected.last().unwrap());
            }
            // A device that stays where it is: nothing but the wall is left.
            let settled = written_out(&the_loop, &positions[..1]);
            prop_assert_eq!(controller.settled(&controller.measured(&positions[0])), settled);
        }
    }

    /// A memory of `at_rest` is that of a device which has been at its position for ever.
    fn eq_16_17_controller_at_rest(parts in parts(), xi in position()) {
        for set in 0..64 {
            let controller = Controller::of(&with_parts(&parts, set));
            let rested = controller.at_rest(&xi);
            prop_assert_eq!(rested.samples.len(), controller.memory());
            let mut memory = rested.clone();
            let once = controller.sample(&mut memory, &xi);
            prop_assert_eq!(&memory, &rested);
            prop_assert_eq!(once, controller.settled(&controller.measured(&xi)));
        }
    }

    /// The paper's loop holds (5), and the loop without memory holds the law of the wall.
    fn eq_16_17_controller_of_the_paper(xi in position(), limit in positive(), unilateral in any::<bool>()) {
        let friction = Friction::new(half(), half());
        let paper = Controller::of(&Loop::plain(friction.clone()));
        prop_assert_eq!(&forces(&paper, std::slice::from_ref(&xi)), &[quantizer::held_force(&xi)]);
        let wall = Loop { max_force: Some(limit), unilateral, ..Loop::plain(friction) };
        let held = forces(&Controller::of(&wall), std::slice::from_ref(&xi));
        prop_assert_eq!(held, [wall.law().held_force(&xi)]);
    }

    /// A filter is the sum of its coefficients times the samples, before which nothing moved.
    fn th_damp_filter_is_the_sum_of_its_coefficients(
        coefficients in prop::collection::vec(number(), 1..6), samples in prop::collection::vec(number(), 1..8)
    ) {
        let after = |j: usize| coefficients[j..].iter().fold(zero(), |sum, c| sum + c);
        let filter = Filter { sum: after(0), tails: (1..coefficients.len()).map(after).collect(), poles: vec![] };
        prop_assert_eq!(filter.order(), coefficients.len() - 1);
        let oldest = samples.last().unwrap();
        let sum = coefficients.iter().enumerate().fold(zero(), |sum, (j, c)| {
            sum + c * samples.get(j).unwrap_or(oldest)
        });
        prop_assert_eq!(filter.output(&samples), sum);
    }

    fn th_damp_filter_of_wall_and_damping(damping in coefficient(), now in number(), before in number()) {
        let samples = [now.clone(), before.clone()];
        prop_assert_eq!(Filter::wall().output(&samples), now.clone());
        let damped = &now + &damping * (&now - before);
        prop_assert_eq!(Filter::damped(&damping).output(&samples), damped);
        prop_assert_eq!((Filter::<BigRational>::wall().order(), Filter::damped(&damping).order()), (0, 1));
    }

    /// In other numbers it is the same controller.
    fn num_exact_controller_in_other_numbers(parts in parts(), positions in positions()) {
        for set in 0..64 {
            let controller = Controller::of(&with_parts(&parts, set));
            let wide = controller.map(to_wide);
            let mut memory = wide.at_rest(&to_wide(&positions[0]));
            let held: Vec<_> = positions
                .iter()
                .map(|xi| from_wide(&wide.sample(&mut memory, &to_wide(xi))).unwrap())
                .collect();
            prop_assert_eq!(held, forces(&controller, &positions));
        }
    }
}

#[test]
fn eq_16_17_controller_rounds_then_saturates() {
    let of = |force_step, max_force| {
        let parts = Parts {
            damping: q(1, 2),
            force_step,
            max_force,
            delay: 1,
        };
        Controller::of(&with_parts(&parts, 0b01_1111))
    };
    // q = 9/2 then 5/2: −(5/2 + ½·(−2)) = −3/2, half-way between −2 and −1: up.
    let samples = [q(5, 2), q(9, 2)];
    assert_eq!(of(q(1, 1), q(9, 1)).held_force(&samples), q(-1, 1));
    // The limit of the actuator need not be a whole number of steps.
    assert_eq!(of(q(1, 1), q(2, 3)).held_force(&samples), q(-2, 3));
    // Steps so large that the force is rounded away.
    assert_eq!(of(q(4, 1), q(9, 1)).held_force(&samples), zero());
    // Outside of the wall: no force, though the damper would push.
    assert_eq!(
        of(q(1, 1), q(9, 1)).held_force(&[q(-1, 2), q(9, 2)]),
        zero()
    );
    assert_eq!(of(q(1, 1), q(9, 1)).held_force(&[]), zero());
}

#[test]
fn num_exact_controller_of_an_undefined_number_is_undefined() {
    let nothing = Fixed::new(1, 0);
    let plain = Loop::plain(Friction::new(Fixed::one(), Fixed::one()));
    let controller = Controller::of(&plain);
    let mut memory = controller.at_rest(&Fixed::one());
    assert!(!controller.sample(&mut memory, &nothing).is_defined());
    let stepped = Controller::of(&Loop {
        force_step: Some(nothing),
        ..plain
    });
    assert!(!stepped.settled(&Fixed::one()).is_defined());
}
