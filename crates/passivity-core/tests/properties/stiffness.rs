//! TH-STIFF: border values agree with the verdict, on the border and just beside it.

use passivity_core::effects::Effects;
use passivity_core::{BigRational, Fixed, Rig, Scalar as _, stiffness};
use proptest::prelude::*;

use crate::common::{half, positive, q, rig, sampled, zero};
use crate::rig::criterion_written_out;

/// A little more than 1.
fn above_one() -> BigRational {
    q(1_000_000_001, 1_000_000_000)
}

fn at_all_speeds(rig: &Rig<BigRational>) -> bool {
    let criterion = criterion_written_out(rig);
    criterion.viscous >= zero() && criterion.coulomb >= zero()
}

fn at_speed(rig: &Rig<BigRational>, v: &BigRational) -> bool {
    let criterion = criterion_written_out(rig);
    criterion.viscous * v + criterion.coulomb >= zero()
}

/// At every speed in (0, v]: near rest, and at v.
fn up_to_speed(rig: &Rig<BigRational>, v: &BigRational) -> bool {
    criterion_written_out(rig).coulomb >= zero() && at_speed(rig, v)
}

fn with_stiffness(rig: &Rig<BigRational>, k: &BigRational) -> Rig<BigRational> {
    Rig {
        stiffness: k.clone(),
        ..rig.clone()
    }
}

sampled! {
    fn th_stiff_without_effects(rig in rig(), v in positive()) {
        let rig = Rig { effects: Effects::encoder(), ..rig };
        let Rig { viscous: b, coulomb: c, stiffness: k, period: t, length: delta, .. } = &rig;
        let (by_viscous, by_coulomb) = (q(2, 1) * b / t, q(2, 1) * c / delta);
        prop_assert_eq!(stiffness::viscous_limit(&rig), by_viscous.clone());
        prop_assert_eq!(stiffness::coulomb_limit(&rig), Some(by_coulomb.clone()));
        let least = if by_viscous < by_coulomb { by_viscous } else { by_coulomb.clone() };
        prop_assert_eq!(stiffness::limit_at_all_speeds(&rig), least);
        let at_speed = q(2, 1) * (b * &v + c) / (t * &v + delta);
        prop_assert_eq!(stiffness::limit_at_speed(&rig, &v), at_speed.clone());
        let least = if at_speed < by_coulomb { at_speed } else { by_coulomb };
        prop_assert_eq!(stiffness::limit_up_to_speed(&rig, &v), least);
        prop_assert_eq!(stiffness::viscous_needed(&rig), k * t * half());
        prop_assert_eq!(stiffness::coulomb_needed(&rig), k * delta * half());
        prop_assert_eq!(stiffness::longest_period(&rig), q(2, 1) * b / k);
        prop_assert_eq!(stiffness::coarsest_resolution(&rig), Some(q(2, 1) * c / k));
    }

    fn th_stiff_single_limits(rig in rig()) {
        let late = half() + q(i64::from(rig.effects.delay), 1);
        let damping = rig.effects.damping.clone().unwrap_or_else(zero);
        let force_step = rig.effects.force_step.clone().unwrap_or_else(zero);
        let by_viscous = (&rig.viscous - &damping) / (&rig.period * &late);
        prop_assert_eq!(stiffness::viscous_limit(&rig), by_viscous.clone());
        let spare = &rig.coulomb - &damping * &rig.length / &rig.period - &force_step * half();
        let by_coulomb = rig.effects.encoder.then(|| q(2, 1) * spare / &rig.length);
        prop_assert_eq!(stiffness::coulomb_limit(&rig), by_coulomb);
        let needed = &rig.stiffness * &rig.period * &late + &damping;
        prop_assert_eq!(stiffness::viscous_needed(&rig), needed);
        let longest = (&rig.viscous - &damping) / (&rig.stiffness * late);
        prop_assert_eq!(stiffness::longest_period(&rig), longest);
    }

    fn th_stiff_limit_at_all_speeds(rig in rig()) {
        let limit = stiffness::limit_at_all_speeds(&rig);
        if limit > zero() {
            prop_assert!(at_all_speeds(&with_stiffness(&rig, &limit)));
            prop_assert!(!at_all_speeds(&with_stiffness(&rig, &(&limit * above_one()))));
        }
        prop_assert_eq!(at_all_speeds(&rig), rig.stiffness <= limit);
    }

    fn th_stiff_limit_at_a_speed(rig in rig(), v in positive()) {
        let limit = stiffness::limit_at_speed(&rig, &v);
        prop_assert_eq!(at_speed(&rig, &v), rig.stiffness <= limit);
        prop_assert!(at_speed(&with_stiffness(&rig, &limit), &v));
        let above = limit + q(1, 1_000_000_000);
        prop_assert!(!at_speed(&with_stiffness(&rig, &above), &v));
    }

    fn th_stiff_limit_up_to_a_speed(rig in rig(), v in positive()) {
        let limit = stiffness::limit_up_to_speed(&rig, &v);
        prop_assert_eq!(up_to_speed(&rig, &v), rig.stiffness <= limit);
        if limit > zero() {
            prop_assert!(up_to_speed(&with_stiffness(&rig, &limit), &v));
            let above = limit + q(1, 1_000_000_000);
            prop_assert!(!up_to_speed(&with_stiffness(&rig, &above), &v));
        }
    }

    /// D/A steps that cost more Coulomb friction than there is leave no stiffness at all.
    fn th_stiff_no_limit_without_coulomb_friction_to_spare(rig in rig(), v in positive()) {
        let force_step = q(2, 1) * &rig.coulomb + v.clone();
        let effects = Effects { encoder: false, force_step: Some(force_step), ..rig.effects.clone() };
        let rig = Rig { effects, ..rig };
        prop_assert!(stiffness::limit_at_all_speeds(&rig) <= zero());
        prop_assert!(stiffness::limit_up_to_speed(&rig, &v) <= zero());
    }

    fn th_stiff_viscous_friction_needed(rig in rig(), v in positive()) {
        let with = |viscous: BigRational| Rig { viscous, ..rig.clone() };
        let needed = stiffness::viscous_needed(&rig);
        prop_assert_eq!(criterion_written_out(&with(needed)).viscous, zero());
        let needed = stiffness::viscous_needed_at_speed(&rig, &v);
        let criterion = criterion_written_out(&with(needed));
        prop_assert_eq!(criterion.viscous * &v + criterion.coulomb, zero());
    }

    fn th_stiff_coulomb_friction_needed(rig in rig(), v in positive()) {
        let with = |coulomb: BigRational| Rig { coulomb, ..rig.clone() };
        let needed = stiffness::coulomb_needed(&rig);
        prop_assert_eq!(criterion_written_out(&with(needed)).coulomb, zero());
        let needed = stiffness::coulomb_needed_up_to_speed(&rig, &v);
        prop_assert!(up_to_speed(&with(needed.clone()), &v));
        prop_assert!(!up_to_speed(&with(needed - q(1, 1_000_000_000)), &v));
    }

    fn th_stiff_longest_period(rig in rig(), v in positive()) {
        let with = |period: BigRational| Rig { period, ..rig.clone() };
        let longest = stiffness::longest_period(&rig);
        if longest > zero() {
            prop_assert_eq!(criterion_written_out(&with(longest)).viscous, zero());
        }
        // With the term BΔ/T kept as it is, the margin at the speed is zero at the period found.
        let longest = stiffness::longest_period_at_speed(&rig, &v);
        let late = half() + q(i64::from(rig.effects.delay), 1);
        let criterion = criterion_written_out(&rig);
        let change = (&longest - &rig.period) * &rig.stiffness * late;
        prop_assert_eq!((criterion.viscous - change) * &v + criterion.coulomb, zero());
    }

    fn th_stiff_coarsest_resolution(rig in rig(), v in positive()) {
        let with = |length: BigRational| Rig { length, ..rig.clone() };
        let (Some(coarsest), Some(up_to)) = (
            stiffness::coarsest_resolution(&rig),
            stiffness::coarsest_resolution_up_to_speed(&rig, &v),
        ) else {
            prop_assert!(!rig.effects.encoder);
            return Ok(());
        };
        prop_assert!(rig.effects.encoder);
        prop_assert_eq!(criterion_written_out(&with(coarsest)).coulomb, zero());
        prop_assert!(up_to_speed(&with(up_to.clone()), &v));
        prop_assert!(!up_to_speed(&with(up_to + q(1, 1_000_000_000)), &v));
    }
}

#[test]
fn th_stiff_of_an_undefined_rig_is_undefined() {
    let one = || Fixed::integer(1);
    let effects = Effects {
        encoder: false,
        force_step: Some(Fixed::new(1, 0)),
        ..Effects::encoder()
    };
    let rig = Rig {
        viscous: one(),
        coulomb: one(),
        stiffness: one(),
        period: one(),
        length: one(),
        effects,
    };
    assert!(!stiffness::limit_at_all_speeds(&rig).is_defined());
    let defined = Rig {
        effects: Effects::smooth(),
        ..rig
    };
    assert_eq!(stiffness::limit_at_all_speeds(&defined), Fixed::integer(2));
    assert_eq!(
        stiffness::limit_up_to_speed(&defined, &one()),
        Fixed::integer(4)
    );
}
