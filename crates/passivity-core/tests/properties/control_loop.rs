//! (7), (11) and the terms that effects add: with units and without.

use passivity_core::parameter::Unit;
use passivity_core::{BigRational, Cost, Criterion, Effect, Friction, Law, Loop, Parameter};
use proptest::prelude::*;

use crate::common::{
    a_loop, dimensionless, friction, half, magnitude, nonnegative, number, positive, q, sampled,
    squared, zero,
};

/// The criterion (11) written out: b − KT(½ + k) − B and c − KΔ/2 − BΔ/T − F/2.
pub(crate) fn criterion_written_out(the_loop: &Loop<BigRational>) -> Criterion<BigRational> {
    let (k, t) = (&the_loop.stiffness, &the_loop.period);
    let absent_is_zero = |x: &Option<BigRational>| x.clone().unwrap_or_else(zero);
    let damping = absent_is_zero(&the_loop.damping);
    let force_step = absent_is_zero(&the_loop.force_step);
    let delay = q(i64::from(the_loop.delay), 1);
    // Without damping a period of zero, which a limit may be, costs no Coulomb friction.
    let per_tick = |delta: &BigRational| match &the_loop.damping {
        Some(damping) => damping * delta / t,
        None => zero(),
    };
    let quantization = match &the_loop.resolution {
        Some(delta) => k * delta * half() + per_tick(delta),
        None => zero(),
    };
    Criterion {
        viscous: absent_is_zero(&the_loop.viscous) - k * t * half() - delay * k * t - damping,
        coulomb: absent_is_zero(&the_loop.coulomb) - quantization - force_step * half(),
    }
}

/// Δ, or 1 without an encoder.
fn length(the_loop: &Loop<BigRational>) -> BigRational {
    the_loop.resolution.clone().unwrap_or_else(|| q(1, 1))
}

sampled! {
    fn eq_27_effective_friction(the_loop in a_loop(), speed in number()) {
        let (k, t, delta) = (&the_loop.stiffness, &the_loop.period, length(&the_loop));
        let b = the_loop.viscous.clone().unwrap_or_else(zero);
        let c = the_loop.coulomb.clone().unwrap_or_else(zero);
        prop_assert_eq!(the_loop.viscous_friction(), b.clone());
        prop_assert_eq!(the_loop.coulomb_friction(), c.clone());
        prop_assert_eq!(the_loop.length(), delta.clone());
        prop_assert_eq!(the_loop.viscous_unit(), k * t);
        prop_assert_eq!(the_loop.force_unit(), k * &delta);
        prop_assert_eq!(the_loop.friction(), Friction::new(b / (k * t), c / (k * &delta)));
        prop_assert_eq!(the_loop.dimensionless_speed(&speed), speed * t / delta);
    }

    fn eq_27_units_are_products_of_powers(the_loop in a_loop()) {
        let (k, t, delta) = (&the_loop.stiffness, &the_loop.period, &length(&the_loop));
        let table = [
            (Unit::INERTIA, k * t * t),
            (Unit::VISCOUS, k * t),
            (Unit::FORCE, k * delta),
            (Unit::STIFFNESS, k.clone()),
            (Unit::TIME, t.clone()),
            (Unit::POSITION, delta.clone()),
            (Unit::SPEED, delta / t),
        ];
        for (unit, expected) in table {
            prop_assert_eq!(the_loop.unit(unit), expected);
        }
    }

    /// (3), (4), (7): every parameter over its unit, and K, T and Δ are 1.
    fn eq_27_dimensionless_loop(the_loop in a_loop(), values in prop::collection::vec(number(), 8)) {
        let mut the_loop = the_loop;
        for (parameter, value) in Parameter::ALL.iter().skip(9).zip(values) {
            the_loop = the_loop.with(*parameter, value);
        }
        let without = the_loop.dimensionless();
        let (k, t, delta) = (&the_loop.stiffness, &the_loop.period, &length(&the_loop));
        prop_assert_eq!((&without.stiffness, &without.period), (&q(1, 1), &q(1, 1)));
        prop_assert_eq!(&without.resolution, &the_loop.resolution.as_ref().map(|_| q(1, 1)));
        prop_assert_eq!(&without.inertia, &the_loop.inertia.as_ref().map(|m| m / (k * t * t)));
        prop_assert_eq!(without.friction(), the_loop.friction());
        prop_assert_eq!(&without.damping, &the_loop.damping.as_ref().map(|b| b / (k * t)));
        for (here, there) in [
            (&without.force_step, &the_loop.force_step),
            (&without.max_force, &the_loop.max_force),
            (&without.operator_force, &the_loop.operator_force),
        ] {
            prop_assert_eq!(here, &there.as_ref().map(|f| f / (k * delta)));
        }
        prop_assert_eq!(&without.start_position, &the_loop.start_position.as_ref().map(|x| x / delta));
        for (here, there) in [
            (&without.start_velocity, &the_loop.start_velocity),
            (&without.max_speed, &the_loop.max_speed),
        ] {
            prop_assert_eq!(here, &there.as_ref().map(|v| v * t / delta));
        }
        prop_assert_eq!((without.delay, without.unilateral), (the_loop.delay, the_loop.unilateral));
    }

    fn eq_1_7_stored_energy(
        the_loop in a_loop(), mass in positive(), x in number(), v in number()
    ) {
        let with_start = Loop {
            inertia: Some(mass.clone()),
            start_position: Some(x.clone()),
            start_velocity: Some(v.clone()),
            ..the_loop
        };
        let without = with_start.dimensionless();
        let stored = half() * squared(without.start_velocity.as_ref().unwrap())
            * without.inertia.unwrap()
            + half() * squared(&without.start_position.unwrap());
        let in_si = half() * mass * squared(&v) + half() * &with_start.stiffness * squared(&x);
        let energy_unit = &with_start.stiffness * squared(&length(&with_start));
        prop_assert_eq!(energy_unit * stored, in_si);
    }

    fn eq_27_with_units_is_11(the_loop in a_loop()) {
        prop_assert_eq!(the_loop.criterion(), criterion_written_out(&the_loop));
    }

    fn eq_27_in_units_of_the_loop(the_loop in a_loop(), v in nonnegative()) {
        let dimensionless = the_loop.dimensionless_criterion();
        let written = criterion_written_out(&the_loop);
        prop_assert_eq!(&dimensionless.viscous, &(written.viscous / the_loop.viscous_unit()));
        prop_assert_eq!(&dimensionless.coulomb, &(written.coulomb / the_loop.force_unit()));
        // The margin (11) in units of force is KΔ times the margin (8) at the speed in ticks.
        let margin = the_loop.criterion().margin(&v) / the_loop.force_unit();
        prop_assert_eq!(dimensionless.margin(&the_loop.dimensionless_speed(&v)), margin);
        // It is the criterion of the dimensionless loop.
        prop_assert_eq!(the_loop.dimensionless().criterion(), dimensionless);
    }

    fn eq_27_a_loop_whose_units_are_one(the_loop in dimensionless(), friction in friction()) {
        prop_assert_eq!(the_loop.dimensionless(), the_loop.clone());
        prop_assert_eq!(the_loop.dimensionless_criterion(), the_loop.criterion());
        let plain = Loop::plain(friction.clone());
        prop_assert_eq!(plain.friction(), friction.clone());
        prop_assert_eq!(plain.criterion(), Criterion::of_friction(&friction));
        prop_assert_eq!(plain.effects().count(), 4);
    }

    fn th_dac_th_delay_th_damp_cost(the_loop in dimensionless(), d in number()) {
        let cost = the_loop.cost();
        let damping = the_loop.damping.clone().unwrap_or_else(zero);
        let step = the_loop.force_step.clone().unwrap_or_else(zero);
        let viscous = half() + q(i64::from(the_loop.delay), 1) + &damping;
        let quantization = if the_loop.has_encoder() { half() + damping } else { zero() };
        let coulomb = quantization + half() * step;
        prop_assert_eq!(&cost, &Cost { viscous: viscous.clone(), coulomb: coulomb.clone() });
        let bound = viscous * squared(&d) + coulomb * magnitude(&d);
        prop_assert_eq!(cost.bound(&d), bound);
    }

    /// Neither sides nor saturation cost anything (TH-UNI, TH-LAW).
    fn th_uni_th_law_cost_nothing(the_loop in a_loop(), limit in positive()) {
        for unilateral in [false, true] {
            for max_force in [None, Some(limit.clone())] {
                let other = Loop { unilateral, max_force, ..the_loop.clone() };
                prop_assert_eq!(other.cost(), the_loop.cost());
            }
        }
    }

    fn th_law_of_a_loop(the_loop in dimensionless()) {
        let limit = the_loop.max_force.clone();
        let lower = if the_loop.unilateral { Some(zero()) } else { limit.clone().map(|x| -x) };
        prop_assert_eq!(the_loop.law(), Law { lower, upper: limit });
    }

    /// More friction never hurts; a stiffer wall, a longer period, a coarser encoder, a later or
    /// coarser force never helps.
    fn eq_27_monotone_in_every_parameter(the_loop in a_loop(), more in nonnegative(), v in nonnegative()) {
        let margin = |the_loop: &Loop<BigRational>| the_loop.criterion().margin(&v);
        let before = margin(&the_loop);
        let with_more = |parameter: Parameter| {
            let value = the_loop.get(parameter).cloned().unwrap_or_else(zero) + &more;
            the_loop.clone().with(parameter, value)
        };
        for parameter in [Parameter::Viscous, Parameter::Coulomb] {
            prop_assert!(margin(&with_more(parameter)) >= before);
        }
        for parameter in [
            Parameter::Stiffness, Parameter::Resolution, Parameter::Damping, Parameter::ForceStep,
        ] {
            prop_assert!(margin(&with_more(parameter)) <= before);
        }
        let later = Loop { delay: the_loop.delay + 1, ..the_loop.clone() };
        prop_assert!(margin(&later) <= before);
        // A longer period pulls both ways when a tick is damped as a speed: BΔ/T.
        let slower = with_more(Parameter::Period);
        if the_loop.damping.is_none() || !the_loop.has_encoder() {
            prop_assert!(margin(&slower) <= before);
        }
        prop_assert!(slower.criterion().viscous <= the_loop.criterion().viscous);
        prop_assert!(slower.criterion().coulomb >= the_loop.criterion().coulomb);
    }

    fn th_smooth_plain_loops(the_loop in a_loop()) {
        let plain = the_loop.delay == 0 && the_loop.damping.is_none() && the_loop.force_step.is_none();
        prop_assert_eq!(the_loop.is_plain(), plain);
        prop_assert_eq!(the_loop.has_encoder(), the_loop.resolution.is_some());
        let expected = [
            (Effect::Hold, true),
            (Effect::Viscous, the_loop.viscous.is_some()),
            (Effect::Coulomb, the_loop.coulomb.is_some()),
            (Effect::Encoder, the_loop.resolution.is_some()),
            (Effect::Delay, the_loop.delay > 0),
            (Effect::Unilateral, the_loop.unilateral),
            (Effect::Damping, the_loop.damping.is_some()),
            (Effect::Saturation, the_loop.max_force.is_some()),
            (Effect::ForceStep, the_loop.force_step.is_some()),
            (Effect::Amplifier, false),
            (Effect::Force, false),
            (Effect::Arm, false),
        ];
        let there: Vec<Effect> = expected.iter().filter(|(_, has)| *has).map(|(e, _)| *e).collect();
        prop_assert_eq!(the_loop.effects().collect::<Vec<_>>(), there);
        let with = |parameter| the_loop.clone().with(parameter, q(1, 1));
        prop_assert!(with(Parameter::TimeConstant).has(Effect::Amplifier));
        prop_assert!(with(Parameter::OperatorForce).has(Effect::Force));
        for part in [Parameter::ArmMass, Parameter::ArmDamping, Parameter::ArmStiffness] {
            prop_assert!(with(part).has(Effect::Arm));
        }
    }
}

#[test]
fn eq_27_the_maxon_motor_of_the_paper() {
    let re35 = Loop {
        viscous: Some(q(9, 1_000_000)),
        coulomb: Some(q(2, 1000)),
        resolution: Some(q(1, 1000)),
        ..Loop::new(q(1, 1), q(1, 1000))
    };
    assert_eq!(re35.friction(), Friction::new(q(9, 1000), q(2, 1)));
    assert_eq!(re35.criterion().viscous, q(-491, 1_000_000));
    assert_eq!(re35.criterion().coulomb, q(3, 2000));
}

#[test]
fn th_smooth_loop_has_no_encoder() {
    let smooth = Loop::smooth(Friction::new(half(), q(1, 3)));
    assert!(!smooth.has_encoder() && smooth.is_plain());
    let plain = Loop::plain(Friction::new(half(), q(1, 3)));
    assert!(plain.has_encoder() && plain.is_plain());
    assert_eq!(
        Loop {
            resolution: None,
            ..plain
        },
        smooth
    );
}
