//! TH-STIFF: border values agree with the verdict, on the border and just beside it.

use passivity_core::{BigRational, Fixed, Loop, Parameter, Scalar as _, stiffness};
use proptest::prelude::*;

use crate::common::{a_loop, half, positive, q, sampled, zero};
use crate::control_loop::criterion_written_out;

/// A little more than 1.
fn above_one() -> BigRational {
    q(1_000_000_001, 1_000_000_000)
}

fn at_all_speeds(the_loop: &Loop<BigRational>) -> bool {
    let criterion = criterion_written_out(the_loop);
    criterion.viscous >= zero() && criterion.coulomb >= zero()
}

fn at_speed(the_loop: &Loop<BigRational>, v: &BigRational) -> bool {
    let criterion = criterion_written_out(the_loop);
    criterion.viscous * v + criterion.coulomb >= zero()
}

/// At every speed in (0, v]: near rest, and at v.
fn up_to_speed(the_loop: &Loop<BigRational>, v: &BigRational) -> bool {
    criterion_written_out(the_loop).coulomb >= zero() && at_speed(the_loop, v)
}

fn with_stiffness(the_loop: &Loop<BigRational>, k: &BigRational) -> Loop<BigRational> {
    the_loop.clone().with(Parameter::Stiffness, k.clone())
}

sampled! {
    fn th_stiff_without_effects(the_loop in a_loop(), b in positive(), c in positive(), delta in positive(), v in positive()) {
        let (k, t) = (&the_loop.stiffness, &the_loop.period);
        let plain = Loop {
            viscous: Some(b.clone()), coulomb: Some(c.clone()), resolution: Some(delta.clone()),
            ..Loop::new(k.clone(), t.clone())
        };
        let (by_viscous, by_coulomb) = (q(2, 1) * &b / t, q(2, 1) * &c / &delta);
        prop_assert_eq!(stiffness::viscous_limit(&plain), by_viscous.clone());
        prop_assert_eq!(stiffness::coulomb_limit(&plain), Some(by_coulomb.clone()));
        let least = if by_viscous < by_coulomb { by_viscous } else { by_coulomb.clone() };
        prop_assert_eq!(stiffness::limit_at_all_speeds(&plain), least);
        let at_speed = q(2, 1) * (&b * &v + &c) / (t * &v + &delta);
        prop_assert_eq!(stiffness::limit_at_speed(&plain, &v), at_speed.clone());
        let least = if at_speed < by_coulomb { at_speed } else { by_coulomb };
        prop_assert_eq!(stiffness::limit_up_to_speed(&plain, &v), least);
        prop_assert_eq!(stiffness::viscous_needed(&plain), k * t * half());
        prop_assert_eq!(stiffness::coulomb_needed(&plain), k * &delta * half());
        prop_assert_eq!(stiffness::longest_period(&plain), q(2, 1) * b / k);
        prop_assert_eq!(stiffness::coarsest_resolution(&plain), Some(q(2, 1) * c / k));
        prop_assert_eq!(stiffness::shortest_period(&plain), None);
    }

    fn th_stiff_single_limits(the_loop in a_loop()) {
        let (k, t) = (&the_loop.stiffness, &the_loop.period);
        let late = half() + q(i64::from(the_loop.delay), 1);
        let absent_is_zero = |x: &Option<BigRational>| x.clone().unwrap_or_else(zero);
        let damping = absent_is_zero(&the_loop.damping);
        let force_step = absent_is_zero(&the_loop.force_step);
        let (b, c) = (absent_is_zero(&the_loop.viscous), absent_is_zero(&the_loop.coulomb));
        let by_viscous = (&b - &damping) / (t * &late);
        prop_assert_eq!(stiffness::viscous_limit(&the_loop), by_viscous);
        let by_coulomb = the_loop.resolution.as_ref().map(|delta| {
            q(2, 1) * (&c - &damping * delta / t - &force_step * half()) / delta
        });
        prop_assert_eq!(stiffness::coulomb_limit(&the_loop), by_coulomb);
        let needed = k * t * &late + &damping;
        prop_assert_eq!(stiffness::viscous_needed(&the_loop), needed);
        let longest = (&b - &damping) / (k * late);
        prop_assert_eq!(stiffness::longest_period(&the_loop), longest);
    }

    fn th_stiff_limit_at_all_speeds(the_loop in a_loop()) {
        let limit = stiffness::limit_at_all_speeds(&the_loop);
        if limit > zero() {
            prop_assert!(at_all_speeds(&with_stiffness(&the_loop, &limit)));
            prop_assert!(!at_all_speeds(&with_stiffness(&the_loop, &(&limit * above_one()))));
        }
        prop_assert_eq!(at_all_speeds(&the_loop), the_loop.stiffness <= limit);
    }

    fn th_stiff_limit_at_a_speed(the_loop in a_loop(), v in positive()) {
        let limit = stiffness::limit_at_speed(&the_loop, &v);
        prop_assert_eq!(at_speed(&the_loop, &v), the_loop.stiffness <= limit);
        prop_assert!(at_speed(&with_stiffness(&the_loop, &limit), &v));
        let above = limit + q(1, 1_000_000_000);
        prop_assert!(!at_speed(&with_stiffness(&the_loop, &above), &v));
    }

    fn th_stiff_limit_up_to_a_speed(the_loop in a_loop(), v in positive()) {
        let limit = stiffness::limit_up_to_speed(&the_loop, &v);
        prop_assert_eq!(up_to_speed(&the_loop, &v), the_loop.stiffness <= limit);
        if limit > zero() {
            prop_assert!(up_to_speed(&with_stiffness(&the_loop, &limit), &v));
            let above = limit + q(1, 1_000_000_000);
            prop_assert!(!up_to_speed(&with_stiffness(&the_loop, &above), &v));
        }
    }

    /// D/A steps that cost more Coulomb friction than there is leave no stiffness at all.
    fn th_stiff_no_limit_without_coulomb_friction_to_spare(the_loop in a_loop(), v in positive()) {
        let force_step = q(2, 1) * the_loop.coulomb_friction() + v.clone();
        let the_loop = Loop { resolution: None, force_step: Some(force_step), ..the_loop };
        prop_assert!(stiffness::limit_at_all_speeds(&the_loop) <= zero());
        prop_assert!(stiffness::limit_up_to_speed(&the_loop, &v) <= zero());
    }

    fn th_stiff_viscous_friction_needed(the_loop in a_loop(), v in positive()) {
        let with = |viscous| the_loop.clone().with(Parameter::Viscous, viscous);
        let needed = stiffness::viscous_needed(&the_loop);
        prop_assert_eq!(criterion_written_out(&with(needed)).viscous, zero());
        let needed = stiffness::viscous_needed_at_speed(&the_loop, &v);
        let criterion = criterion_written_out(&with(needed));
        prop_assert_eq!(criterion.viscous * &v + criterion.coulomb, zero());
    }

    fn th_stiff_coulomb_friction_needed(the_loop in a_loop(), v in positive()) {
        let with = |coulomb| the_loop.clone().with(Parameter::Coulomb, coulomb);
        let needed = stiffness::coulomb_needed(&the_loop);
        prop_assert_eq!(criterion_written_out(&with(needed)).coulomb, zero());
        let needed = stiffness::coulomb_needed_up_to_speed(&the_loop, &v);
        prop_assert!(up_to_speed(&with(needed.clone()), &v));
        prop_assert!(!up_to_speed(&with(needed - q(1, 1_000_000_000)), &v));
    }

    fn th_stiff_longest_period(the_loop in a_loop(), v in positive()) {
        let with = |period| the_loop.clone().with(Parameter::Period, period);
        let longest = stiffness::longest_period(&the_loop);
        if longest > zero() {
            prop_assert_eq!(criterion_written_out(&with(longest)).viscous, zero());
        }
        // A bound on the speed allows a longer one, unless a tick is damped as a speed: BΔ/T.
        if the_loop.damping.is_none() || !the_loop.has_encoder() {
            let longest = stiffness::longest_period_at_speed(&the_loop, &v);
            let criterion = criterion_written_out(&with(longest));
            prop_assert_eq!(criterion.viscous * &v + criterion.coulomb, zero());
        }
    }

    /// With damping behind an encoder there is a shortest period: BΔ/T is a tick damped as a speed.
    fn th_stiff_shortest_period(the_loop in a_loop(), damping in positive(), delta in positive()) {
        let the_loop = Loop { damping: Some(damping), resolution: Some(delta), ..the_loop };
        let shortest = stiffness::shortest_period(&the_loop).unwrap();
        let with = |period| the_loop.clone().with(Parameter::Period, period);
        let coulomb = |period| criterion_written_out(&with(period)).coulomb;
        if shortest > zero() {
            prop_assert_eq!(coulomb(shortest.clone()), zero());
            prop_assert!(coulomb(&shortest * above_one()) > zero());
            prop_assert!(coulomb(&shortest / above_one()) < zero());
        } else {
            // No period is long enough: nothing is left for BΔ/T.
            prop_assert!(coulomb(q(1, 1) + q(1_000_000_000, 1) * the_loop.period.clone()) < zero());
        }
        for without in [
            Loop { damping: None, ..the_loop.clone() },
            Loop { resolution: None, ..the_loop },
        ] {
            prop_assert_eq!(stiffness::shortest_period(&without), None);
        }
    }

    /// The margin times the period is largest at the period that is best at a speed.
    fn th_stiff_best_period(the_loop in a_loop(), v in positive(), other in positive()) {
        let best = stiffness::best_period_at_speed(&the_loop, &v);
        let late = half() + q(i64::from(the_loop.delay), 1);
        let per_square = &the_loop.stiffness * late * &v;
        // A parabola is c − a(T − T*)²: whatever is lost beside the best period is a·(T − T*)².
        let times_period = |period: &BigRational| {
            let at = the_loop.clone().with(Parameter::Period, period.clone());
            let criterion = criterion_written_out(&at);
            (criterion.viscous * &v + criterion.coulomb) * period
        };
        if best > zero() {
            let lost = times_period(&best) - times_period(&other);
            prop_assert_eq!(lost, per_square * (&best - &other) * (best - other));
        }
    }

    fn th_stiff_coarsest_resolution(the_loop in a_loop(), v in positive()) {
        let with = |resolution| the_loop.clone().with(Parameter::Resolution, resolution);
        let (Some(coarsest), Some(up_to)) = (
            stiffness::coarsest_resolution(&the_loop),
            stiffness::coarsest_resolution_up_to_speed(&the_loop, &v),
        ) else {
            prop_assert!(!the_loop.has_encoder());
            return Ok(());
        };
        prop_assert!(the_loop.has_encoder());
        prop_assert_eq!(criterion_written_out(&with(coarsest)).coulomb, zero());
        prop_assert!(up_to_speed(&with(up_to.clone()), &v));
        prop_assert!(!up_to_speed(&with(up_to + q(1, 1_000_000_000)), &v));
    }
}

#[test]
fn th_stiff_of_an_undefined_loop_is_undefined() {
    let one = || Fixed::integer(1);
    let defined = Loop {
        viscous: Some(one()),
        coulomb: Some(one()),
        ..Loop::new(one(), one())
    };
    assert_eq!(stiffness::limit_at_all_speeds(&defined), Fixed::integer(2));
    assert_eq!(
        stiffness::limit_up_to_speed(&defined, &one()),
        Fixed::integer(4)
    );
    let undefined = defined.with(Parameter::ForceStep, Fixed::new(1, 0));
    assert!(!stiffness::limit_at_all_speeds(&undefined).is_defined());
}
