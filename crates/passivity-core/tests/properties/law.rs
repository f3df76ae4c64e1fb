//! TH-LAW and TH-UNI: any force law that is nowhere stiffer than the wall.

use passivity_core::generation::bound_22;
use passivity_core::{BigRational, Law};
use proptest::prelude::*;

use crate::common::{half, magnitude, nonnegative, position, q, sampled, squared, unit, zero};
use crate::spring::staircase_integral;

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
pub(crate) fn potential_by_cases(law: &Law<BigRational>, xi: &BigRational) -> BigRational {
    let f = force_by_cases(law, xi);
    half() * squared(&f) + &f * (xi - &f)
}

/// ∫₀^ξ f(⌊x⌋ + ½)dx by cases: whole ticks up to the limit, whole ticks at it, and the last one.
pub(crate) fn quantized_integral(law: &Law<BigRational>, xi: &BigRational) -> BigRational {
    // Below zero the law is that of the other side, seen in a mirror.
    let (limit, xi) = if *xi < zero() {
        (law.lower.as_ref().map(|lower| -lower), -xi)
    } else {
        (law.upper.clone(), xi.clone())
    };
    let (ticks, rest) = (xi.floor(), &xi - xi.floor());
    let Some(limit) = limit else {
        return half() * squared(&ticks) + (&ticks + half()) * rest;
    };
    // The ticks whose middle is not beyond the limit.
    let free = (&limit + half()).floor();
    if free > ticks {
        half() * squared(&ticks) + (ticks + half()) * rest
    } else {
        half() * squared(&free) + (ticks - free + rest) * limit
    }
}

sampled! {
    fn th_law_force_and_potential(law in law(), xi in position()) {
        prop_assert_eq!(law.force(&xi), force_by_cases(&law, &xi));
        prop_assert_eq!(law.potential(&xi), potential_by_cases(&law, &xi));
        prop_assert_eq!(law.held_force(&xi), -force_by_cases(&law, &(xi.floor() + half())));
    }

    /// The staircase of the law summed tick by tick, from 0 to ξ.
    fn th_law_quantized_potential_is_the_sum_of_its_ticks(
        law in law(), ticks in -40i64..40, rest in unit()
    ) {
        let at_tick = |n: i64| force_by_cases(&law, &(q(n, 1) + half()));
        let whole = if ticks < 0 {
            -(ticks..0).fold(zero(), |sum, n| sum + at_tick(n))
        } else {
            (0..ticks).fold(zero(), |sum, n| sum + at_tick(n))
        };
        // Up to the next tick, where the staircases on either side meet.
        let xi = q(ticks, 1) + &rest;
        let sum = whole + at_tick(ticks) * rest;
        prop_assert_eq!(law.quantized_potential(&xi), sum.clone());
        prop_assert_eq!(quantized_integral(&law, &xi), sum);
    }

    /// However far from zero, it starts at nothing and rises by f(n + ½) a tick.
    fn th_law_quantized_potential_rises_by_the_force(law in law(), xi in position(), rest in unit()) {
        let n = xi.floor();
        let rise = law.quantized_potential(&(&n + &rest)) - law.quantized_potential(&n);
        prop_assert_eq!(rise, force_by_cases(&law, &(n + half())) * rest);
        prop_assert_eq!(law.quantized_potential(&zero()), zero());
        prop_assert_eq!(law.quantized_potential(&xi), quantized_integral(&law, &xi));
    }

    fn th_law_quantized_potential_of_the_spring(xi in position()) {
        let wall: Law<BigRational> = Law::bilateral();
        prop_assert_eq!(wall.quantized_potential(&xi), staircase_integral(&xi));
        prop_assert!(wall.is_linear());
        prop_assert!(!Law::<BigRational>::unilateral().is_linear());
        prop_assert!(!wall.saturated(magnitude(&xi)).is_linear());
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
