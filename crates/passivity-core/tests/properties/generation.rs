//! (18) to (22): what one step generates, against both springs.

use passivity_core::generation::{
    bound_21, bound_22, bound_quantized, generated, generated_as_in_19, generated_linear,
    generated_quantized, quantization_effect,
};
use passivity_core::{BigRational, Step, ledger};
use proptest::prelude::*;

use crate::common::{half, magnitude, position, q, sampled, squared, unit, zero};
use crate::spring::staircase_integral;

/// The work of the force held from `start`, −(⌊ξ₀⌋ + ½)·d.
fn held_work(start: &BigRational, end: &BigRational) -> BigRational {
    -(start.floor() + half()) * (end - start)
}

/// E_g by (18), with the integral of the staircase.
fn by_18(start: &BigRational, end: &BigRational) -> BigRational {
    held_work(start, end) + staircase_integral(end) - staircase_integral(start)
}

/// E_gᴸ by its definition.
fn linear_by_18(start: &BigRational, end: &BigRational) -> BigRational {
    held_work(start, end) + half() * (squared(end) - squared(start))
}

/// ½d² + ½|d|.
fn printed_bound(d: &BigRational) -> BigRational {
    half() * squared(d) + half() * magnitude(d)
}

fn step(start: &BigRational, end: &BigRational) -> Step<BigRational> {
    Step::new(start.clone(), end.clone())
}

sampled! {
    fn eq_19_20_step_measures(a in position(), b in position()) {
        let step = step(&a, &b);
        prop_assert_eq!(step.displacement(), &b - &a);
        prop_assert_eq!(step.ticks(), b.floor() - a.floor());
    }

    fn eq_19_20_all_forms_are_the_integral(a in position(), b in position()) {
        let (expected, step) = (by_18(&a, &b), step(&a, &b));
        prop_assert_eq!(generated_quantized(&step), expected.clone());
        prop_assert_eq!(generated_as_in_19(&step), expected.clone());
        let effect = expected - half() * squared(&(&b - &a));
        prop_assert_eq!(quantization_effect(&step), effect);
    }

    fn eq_19_20_definition_18_for_any_force_and_potentials(
        force in position(), a in position(), b in position(), h0 in position(), h1 in position()
    ) {
        let got = generated(&force, &step(&a, &b), &h0, &h1);
        prop_assert_eq!(got, &force * (&b - &a) + &h1 - &h0);
    }

    fn eq_21a_effect_within_half_the_ticks(a in position(), b in position()) {
        let step = step(&a, &b);
        let ticks = b.floor() - a.floor();
        prop_assert_eq!(bound_21(&ticks), half() * magnitude(&ticks));
        prop_assert!(quantization_effect(&step) <= bound_21(&ticks));
    }

    fn eq_21a_is_reached_from_a_tick_down_to_a_tick(n in -9i64..9, ticks in 0i64..9) {
        let step = Step::new(q(n, 1), q(n - ticks, 1));
        prop_assert_eq!(quantization_effect(&step), bound_21(&q(-ticks, 1)));
    }

    fn th_lin_is_the_definition_against_the_linear_spring(a in position(), b in position()) {
        let (d, rho) = (&b - &a, &a - a.floor());
        let formula = half() * squared(&d) + (rho - half()) * &d;
        prop_assert_eq!(generated_linear(&step(&a, &b)), formula.clone());
        prop_assert_eq!(formula, linear_by_18(&a, &b));
    }

    fn th_lin_bound_holds_with_known_slack(a in position(), b in position()) {
        let (d, rho) = (&b - &a, &a - a.floor());
        prop_assert_eq!(bound_22(&d), printed_bound(&d));
        let slack = bound_22(&d) - generated_linear(&step(&a, &b));
        // Nothing at ρ₀ = 0 downwards; nothing is approached as ρ₀ → 1 upwards.
        let expected = if d < zero() { rho * magnitude(&d) } else { (q(1, 1) - rho) * d };
        prop_assert!(expected >= zero());
        prop_assert_eq!(slack, expected);
    }

    fn th_quant_bound_holds(a in position(), b in position()) {
        let d = &b - &a;
        let f = magnitude(&d) - magnitude(&d).floor();
        let bound = printed_bound(&d) + half() * &f * (q(1, 1) - &f);
        prop_assert_eq!(bound_quantized(&d), bound.clone());
        prop_assert!(by_18(&a, &b) <= bound);
        prop_assert!(bound_quantized(&d) - bound_22(&d) <= q(1, 8));
    }

    fn th_quant_is_the_potential_of_the_distance_and_half_of_it(a in position(), b in position()) {
        let d = magnitude(&(b - a));
        prop_assert_eq!(bound_quantized(&d), staircase_integral(&d) + half() * &d);
        prop_assert_eq!(bound_quantized(&-&d), bound_quantized(&d));
    }

    fn th_quant_is_reached_downwards_from_a_tick(n in -9i64..9, end in position()) {
        let start = q(n, 1);
        let d = -magnitude(&(end - &start));
        let step = Step::new(start.clone(), &start + &d);
        prop_assert_eq!(generated_quantized(&step), bound_quantized(&d));
    }

    fn th_quant_interpolates_22_at_whole_ticks(n in 0i64..99, f in unit()) {
        let f = f * q(4095, 4096);
        let d = q(n, 1) + &f;
        let (low, high) = (printed_bound(&q(n, 1)), printed_bound(&q(n + 1, 1)));
        prop_assert_eq!(bound_quantized(&d), low * (q(1, 1) - &f) + high * f);
    }

    fn th_telescope_one_step(a in position(), b in position()) {
        let step = step(&a, &b);
        let difference = generated_quantized(&step) - generated_linear(&step);
        let term = |x: &BigRational| { let rho = x - x.floor(); half() * &rho * (q(1, 1) - &rho) };
        prop_assert_eq!(difference.clone(), term(&b) - term(&a));
        prop_assert_eq!(ledger::counterparts_differ_by(&a, &b), difference);
    }

    fn th_telescope_any_run_differs_by_an_eighth(
        path in prop::collection::vec(position(), 2..12)
    ) {
        let difference = path.windows(2).fold(zero(), |sum, pair| {
            sum + by_18(&pair[0], &pair[1]) - linear_by_18(&pair[0], &pair[1])
        });
        prop_assert!(magnitude(&difference) <= q(1, 8));
        let (first, last) = (&path[0], &path[path.len() - 1]);
        prop_assert_eq!(ledger::counterparts_differ_by(first, last), difference);
    }
}

#[test]
fn th_telescope_an_eighth_is_reached() {
    assert_eq!(ledger::counterparts_differ_by(&q(3, 1), &q(7, 2)), q(1, 8));
    assert_eq!(
        ledger::counterparts_differ_by(&q(7, 2), &q(-3, 1)),
        q(-1, 8)
    );
}

#[test]
fn th_lin_is_reached_downwards_from_a_tick() {
    let step = Step::new(q(1, 1), q(1, 2));
    assert_eq!(generated_linear(&step), q(3, 8));
    assert_eq!(bound_22(&q(-1, 2)), q(3, 8));
}
