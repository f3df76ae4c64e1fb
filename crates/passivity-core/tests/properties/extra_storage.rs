//! What effects with memory add to a step, and what they store; rounding to whole force steps.

use passivity_core::BigRational;
use passivity_core::controller::rounded;
use passivity_core::extra_storage::{
    damping_storage, delay_storage, generated_by_damping, generated_by_delay,
};
use proptest::prelude::*;

use crate::common::{
    coefficient, half, magnitude, number, position, positive, q, sampled, squared, zero,
};

fn past() -> impl Strategy<Value = Vec<BigRational>> {
    prop::collection::vec(number(), 0..5)
}

/// The history after a step: the new displacement first, the oldest forgotten.
fn after(past: &[BigRational], d: &BigRational) -> Vec<BigRational> {
    let mut after = vec![d.clone()];
    after.extend_from_slice(past);
    after.truncate(past.len());
    after
}

sampled! {
    fn th_delay_generated_and_stored(past in past(), d in number()) {
        let sum = past.iter().fold(zero(), |sum, x| sum + x);
        let generated = generated_by_delay(&past, &d);
        prop_assert_eq!(generated.clone(), &d * sum);
        let k = past.len();
        let stored = |past: &[BigRational]| {
            past.iter().enumerate().fold(zero(), |sum, (i, x)| {
                sum + q(i64::try_from(k - i).unwrap(), 2) * squared(x)
            })
        };
        let next = after(&past, &d);
        prop_assert_eq!(delay_storage(&past), stored(&past));
        let drop = delay_storage(&past) - delay_storage(&next);
        let paid = q(i64::try_from(k).unwrap(), 1) * squared(&d);
        prop_assert!(generated <= paid + drop);
    }

    fn th_delay_is_the_change_of_the_late_force(positions in prop::collection::vec(position(), 2..6)) {
        // Positions ξ_{h−k}, …, ξ_h, ξ_{h+1}: the force held is −ξ_{h−k} instead of −ξ_h.
        let last = positions.len() - 1;
        let d = &positions[last] - &positions[last - 1];
        let past: Vec<_> = (1..last).rev().map(|i| &positions[i] - &positions[i - 1]).collect();
        let late = (&positions[last - 1] - &positions[0]) * &d;
        prop_assert_eq!(generated_by_delay(&past, &d), late);
    }

    fn th_delay_is_tight_at_constant_speed(d in number(), k in 0usize..5) {
        let past = vec![d.clone(); k];
        let paid = q(i64::try_from(k).unwrap(), 1) * squared(&d);
        prop_assert_eq!(generated_by_delay(&past, &d), paid);
        prop_assert_eq!(delay_storage(&after(&past, &d)), delay_storage(&past));
    }

    fn th_damp_generated_and_stored(damping in coefficient(), past in past(), d in number(), n in -64i64..=64) {
        prop_assume!(!past.is_empty());
        // The encoder sees the oldest displacement up to an error below one tick.
        let ticks = &past[past.len() - 1] + q(n, 64);
        let generated = generated_by_damping(&damping, &ticks, &d);
        prop_assert_eq!(generated.clone(), -(&damping * &ticks * &d));
        let stored = past.iter().fold(zero(), |sum, x| sum + half() * &damping * squared(x));
        prop_assert_eq!(damping_storage(&damping, &past), stored.clone());
        let drop = stored - damping_storage(&damping, &after(&past, &d));
        let paid = &damping * squared(&d) + &damping * magnitude(&d);
        prop_assert!(generated <= paid + drop);
    }

    fn th_damp_is_tight_on_the_way_back(damping in coefficient(), d in number()) {
        // The last displacement was −d and its ticks a whole one more: all the cost is incurred.
        let sign = if d < zero() { q(-1, 1) } else { q(1, 1) };
        let ticks = -&d - sign;
        let paid = &damping * squared(&d) + &damping * magnitude(&d);
        prop_assert_eq!(generated_by_damping(&damping, &ticks, &d), paid);
        prop_assert_eq!(damping_storage(&damping, &[-&d]), damping_storage(&damping, &[d]));
    }

    fn th_dac_rounds_to_the_nearest_step(
        force in number(), step in positive(), scale in positive(), d in number()
    ) {
        // The step is a quotient, in lowest terms or not.
        let rounded = rounded(&force, &(&step * &scale), &scale);
        prop_assert!((&rounded / &step).is_integer());
        let error = &rounded - &force;
        // Ties go up: the error is in (−½δ, ½δ].
        prop_assert!(error > -half() * &step && error <= half() * &step);
        prop_assert!(error * &d <= half() * step * magnitude(&d));
    }
}

#[test]
fn th_dac_values() {
    let whole = |n: i64| q(n, 1);
    for (force, nearest) in [
        (q(7, 4), 2),
        (q(3, 2), 2),
        (q(-3, 2), -1),
        (q(-8, 5), -2),
        (q(1, 4), 0),
    ] {
        assert_eq!(rounded(&force, &whole(1), &whole(1)), whole(nearest));
    }
    assert_eq!(rounded(&q(7, 16), &whole(1), &whole(8)), q(1, 2));
}
