//! (16), (17): what the two springs store.

use passivity_core::quantizer::held_force;
use passivity_core::{BigRational, spring};
use proptest::prelude::*;

use crate::common::{half, number, position, positive, q, sampled, squared, unit, zero};

/// ∫₀^ξ (⌊x⌋ + ½)dx: n²/2 over the whole ticks, then n + ½ over what is left.
pub(crate) fn staircase_integral(xi: &BigRational) -> BigRational {
    let n = xi.floor();
    squared(&n) * half() + (&n + half()) * (xi - n)
}

sampled! {
    fn eq_16_17_potential_is_the_integral_of_the_staircase(xi in position()) {
        prop_assert_eq!(spring::quantized_potential(&xi), staircase_integral(&xi));
    }

    fn eq_16_17_potential_by_the_printed_formula(xi in position()) {
        let rho = &xi - xi.floor();
        let added = half() * (&rho - squared(&rho));
        prop_assert_eq!(spring::quantization_potential(&xi), added.clone());
        prop_assert!(added >= zero() && added <= q(1, 8));
        prop_assert_eq!(spring::linear_potential(&xi), half() * squared(&xi));
        prop_assert_eq!(spring::quantized_potential(&xi), half() * squared(&xi) + added);
    }

    fn eq_16_17_slope_is_the_held_force(n in -9i64..9, a in unit(), b in unit()) {
        // Within one tick the potential is a straight line; its slope is minus the force (5).
        let (a, b) = (q(n, 1) + a * half(), q(n, 1) + b * half());
        let rise = spring::quantized_potential(&b) - spring::quantized_potential(&a);
        prop_assert_eq!(rise, -held_force(&a) * (b - a));
    }

    fn eq_16_17_storages_add_the_kinetic_energy(mu in positive(), xi in position(), v in number()) {
        let kinetic = half() * &mu * squared(&v);
        prop_assert_eq!(spring::kinetic(&mu, &v), kinetic.clone());
        prop_assert_eq!(spring::storage(&mu, &xi, &v), &kinetic + half() * squared(&xi));
        prop_assert_eq!(spring::quantized_storage(&mu, &xi, &v), kinetic + staircase_integral(&xi));
    }
}

#[test]
fn eq_16_17_potential_interpolates_at_whole_ticks() {
    // ½n² + ½n would be the sum 1 + … + n; the staircase with the centred force gives ½n².
    for n in -5..6 {
        assert_eq!(spring::quantized_potential(&q(n, 1)), q(n * n, 2));
    }
    assert_eq!(spring::quantization_potential(&q(5, 2)), q(1, 8));
    assert_eq!(spring::quantization_potential(&q(-1, 4)), q(3, 32));
}
