//! (23) to (26): what friction surely dissipates.

use passivity_core::dissipation::mean_speed;
use proptest::prelude::*;

use crate::common::{friction, magnitude, number, positive, sampled, squared, zero};

sampled! {
    fn eq_23_26_power(friction in friction(), v in number()) {
        let expected = &friction.beta * squared(&v) + &friction.sigma * magnitude(&v);
        prop_assert_eq!(friction.power(&v), expected);
    }

    fn eq_23_26_lower_bound_formula(friction in friction(), d in number(), dtau in positive()) {
        let speed = mean_speed(&d, &dtau);
        prop_assert_eq!(speed.clone(), magnitude(&d) / &dtau);
        let expected = &friction.beta * squared(&d) / &dtau + &friction.sigma * magnitude(&d);
        prop_assert_eq!(friction.dissipated_lower(&d, &speed), expected);
    }

    fn eq_23_26_reached_at_constant_velocity(friction in friction(), v in number(), t in positive()) {
        let d = &v * &t;
        let dissipated = friction.dissipated_at_constant_velocity(&v, &t);
        let power = &friction.beta * squared(&v) + &friction.sigma * magnitude(&v);
        prop_assert_eq!(dissipated.clone(), power * &t);
        prop_assert_eq!(dissipated, friction.dissipated_lower(&d, &mean_speed(&d, &t)));
    }

    /// Any motion made of pieces at constant velocity spends at least the bound of the whole.
    fn eq_23_26_any_motion_dissipates_the_bound(
        friction in friction(),
        pieces in prop::collection::vec((number(), positive()), 1..7),
    ) {
        let (mut spent, mut d, mut t) = (zero(), zero(), zero());
        for (velocity, duration) in &pieces {
            spent += friction.dissipated_at_constant_velocity(velocity, duration);
            d += velocity * duration;
            t += duration;
        }
        prop_assert!(spent >= friction.dissipated_lower(&d, &mean_speed(&d, &t)));
    }
}
