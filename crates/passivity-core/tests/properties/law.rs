//! TH-LAW and TH-UNI: any force law that is nowhere stiffer than the wall.

use passivity_core::generation::bound_22;
use passivity_core::{BigRational, Law};
use proptest::prelude::*;

use crate::common::{half, magnitude, nonnegative, position, q, sampled, squared, zero};

pub(crate) fn law() -> impl Strategy<Value = Law<BigRational>> {
    let limit = || prop::option::of(nonnegative());
    (limit(), limit()).prop_map(|(below, upper)| Law {
        lower: below.map(|x| -x),
        upper,
    })
}

/// The force by cases: the nearer end where ξ is outside [lower, upper].
fn force_by_cases(law: &Law<BigRational>, xi: &BigRational) -> BigRational {
    match (&law.lower, &law.upper) {
        (Some(lower), _) if xi < lower => lower.clone(),
        (_, Some(upper)) if xi > upper => upper.clone(),
        _ => xi.clone(),
    }
}

/// ∫₀^ξ f: a parabola up to where the force stops growing, a straight line from there on.
fn potential_by_cases(law: &Law<BigRational>, xi: &BigRational) -> BigRational {
    let f = force_by_cases(law, xi);
    half() * squared(&f) + &f * (xi - &f)
}

sampled! {
    fn th_law_force_and_potential(law in law(), xi in position()) {
        prop_assert_eq!(law.force(&xi), force_by_cases(&law, &xi));
        prop_assert_eq!(law.potential(&xi), potential_by_cases(&law, &xi));
        prop_assert_eq!(law.held_force(&xi), -force_by_cases(&law, &(xi.floor() + half())));
    }

    fn th_law_is_never_stiffer_than_the_wall(law in law(), a in position(), b in position()) {
        let (rise, run) = (law.force(&b) - law.force(&a), &b - &a);
        prop_assert!(magnitude(&rise) <= magnitude(&run));
        prop_assert!(rise * run >= zero());
    }

    fn th_law_potential_is_the_integral(law in law(), a in position(), b in position()) {
        // For a force that only grows, the integral lies between the two end forces times d.
        let (d, gain) = (&b - &a, law.potential(&b) - law.potential(&a));
        prop_assert!(law.force(&a) * &d <= gain && gain <= law.force(&b) * &d);
    }

    fn th_law_bound_for_any_measurement_error(
        law in law(), xi in position(), d in position(), n in -64i64..=64
    ) {
        let error = q(n, 128);
        let held = -law.force(&(&xi + error));
        let generated = held * &d + law.potential(&(&xi + &d)) - law.potential(&xi);
        prop_assert!(generated <= half() * squared(&d) + half() * magnitude(&d));
    }

    fn th_law_bound_for_the_encoder(law in law(), a in position(), b in position()) {
        let d = &b - &a;
        let generated = law.held_force(&a) * &d + law.potential(&b) - law.potential(&a);
        prop_assert!(generated <= bound_22(&d));
    }

    fn th_law_saturation_of_any_law(law in law(), limit in nonnegative(), xi in position()) {
        let clamped = |x: BigRational| {
            if x > limit { limit.clone() } else if x < -&limit { -&limit } else { x }
        };
        let saturated = law.clone().saturated(limit.clone());
        prop_assert_eq!(saturated.force(&xi), clamped(force_by_cases(&law, &xi)));
    }

    fn th_uni_wall_pushes_only_inside(xi in position()) {
        let wall = Law::unilateral();
        let inside = if xi > zero() { xi.clone() } else { zero() };
        prop_assert_eq!(wall.force(&xi), inside.clone());
        prop_assert_eq!(wall.potential(&xi), half() * squared(&inside));
        let held = wall.held_force(&xi);
        prop_assert_eq!(held.clone(), if xi < zero() { zero() } else { -(xi.floor() + half()) });
        prop_assert_eq!(held == zero(), xi < zero());
    }

    fn th_uni_bound(a in position(), b in position()) {
        let (wall, d) = (Law::unilateral(), &b - &a);
        let generated = wall.held_force(&a) * &d + wall.potential(&b) - wall.potential(&a);
        prop_assert!(generated <= half() * squared(&d) + half() * magnitude(&d));
    }

    fn th_law_bilateral_wall_is_the_spring(xi in position()) {
        let wall: Law<BigRational> = Law::bilateral();
        prop_assert_eq!(wall.force(&xi), xi.clone());
        prop_assert_eq!(wall.potential(&xi), half() * squared(&xi));
    }
}
