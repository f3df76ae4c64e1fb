//! The instances agree: big rationals, unreduced big fractions, and 128-bit fractions where defined.

use passivity_core::effects::{self, Effects};
use passivity_core::rational::{from_fixed, from_wide, to_fixed, to_wide};
use passivity_core::verdict::{self, Speeds, decide};
use passivity_core::{
    BigRational, Criterion, Fixed, Friction, Interval, Law, Ordered, Region, Rig, Scalar, Step,
    Wide, dissipation, generation, ledger, quantizer, region, spring, start, stiffness, witness,
};
use proptest::prelude::*;

use crate::common::{coefficient, number, position, positive, q, rig, sampled, zero};

/// Every function of the kernel that gives a number, at the same inputs.
fn battery<S: Ordered>(a: &S, b: &S, friction: &Friction<S>, dtau: &S, rig: &Rig<S>) -> Vec<S> {
    let step = Step::new(a.clone(), b.clone());
    let d = step.displacement();
    let speed = dissipation::mean_speed(&d, dtau);
    let row = ledger::row(&step, friction, dtau);
    let criterion = rig.criterion();
    let dimensionless = rig.dimensionless_criterion();
    let law = Law::unilateral().saturated(rig.coulomb.clone());
    let mut all = vec![
        quantizer::held_force(a),
        spring::quantized_potential(a),
        spring::quantized_storage(dtau, a, b),
        spring::storage(dtau, a, b),
        generation::generated(b, &step, a, dtau),
        generation::generated_as_in_19(&step),
        generation::generated_linear(&step),
        generation::bound_21(&step.ticks()),
        friction.dissipated_at_constant_velocity(a, dtau),
        ledger::jitter_bound(friction, &d, &speed),
        ledger::operator_work(a, b, dtau, &speed),
        ledger::counterparts_differ_by(a, b),
        Criterion::of_friction(friction).surplus(&d, &speed),
        Criterion::critical_sigma(&friction.beta, &speed),
        criterion.margin(&speed),
        criterion.margin_at_all_speeds(),
        criterion.margin_up_to(&speed),
        dimensionless.viscous,
        dimensionless.coulomb,
        rig.mu(dtau),
        rig.dimensionless_speed(a),
        region::critical_speed(&criterion),
        start::speed_squared(dtau, a, b),
        start::margin_of_squares(&criterion, &speed),
        stiffness::limit_at_all_speeds(rig),
        stiffness::limit_up_to_speed(rig, dtau),
        stiffness::viscous_needed_at_speed(rig, dtau),
        stiffness::coulomb_needed_up_to_speed(rig, dtau),
        stiffness::longest_period(rig),
        stiffness::longest_period_at_speed(rig, dtau),
        effects::rounded_force(a, dtau),
        effects::generated_by_damping(a, b, dtau),
        effects::delay_storage(&[a.clone(), b.clone(), dtau.clone()]),
        effects::damping_storage(dtau, &[a.clone(), b.clone()]),
        effects::generated_by_delay(&[a.clone(), b.clone()], dtau),
        rig.effects.cost().bound(&d),
        law.force(a),
        law.potential(a),
        law.held_force(b),
        witness::gain(a, b, friction),
        witness::gain_formula(a, dtau, friction),
        row.net_linear,
        row.net_quantized,
        row.margin,
        row.bound_22,
        row.bound_quantized,
        row.dissipated_lower,
    ];
    let optional = [
        stiffness::coulomb_limit(rig),
        stiffness::coarsest_resolution(rig),
        stiffness::coarsest_resolution_up_to_speed(rig, dtau),
    ];
    all.extend(optional.into_iter().flatten());
    for cycle in [
        witness::quantized(friction, None),
        witness::smooth(friction, Some(dtau)),
    ] {
        all.extend(
            cycle
                .into_iter()
                .flat_map(|cycle| [cycle.from, cycle.to, cycle.gain]),
        );
    }
    all
}

fn friction_of<S: Scalar>(
    friction: &Friction<BigRational>,
    f: impl Fn(&BigRational) -> Option<S>,
) -> Option<Friction<S>> {
    Some(Friction::new(f(&friction.beta)?, f(&friction.sigma)?))
}

fn in_wide(x: &BigRational) -> Option<Wide> {
    Some(to_wide(x))
}

/// The battery on 128-bit fractions, or `None` where an input does not fit.
fn fixed_battery(
    a: &BigRational,
    b: &BigRational,
    friction: &Friction<BigRational>,
    dtau: &BigRational,
    rig: &Rig<BigRational>,
) -> Option<Vec<Fixed>> {
    let friction = friction_of(friction, to_fixed)?;
    Some(battery(
        &to_fixed(a)?,
        &to_fixed(b)?,
        &friction,
        &to_fixed(dtau)?,
        &rig.try_map(to_fixed)?,
    ))
}

/// Numbers that data sheets have.
fn small() -> impl Strategy<Value = BigRational> {
    (1i64..100, 1i64..20).prop_map(|(n, d)| q(n, d))
}

fn small_rig() -> impl Strategy<Value = Rig<BigRational>> {
    (
        small(),
        small(),
        small(),
        small(),
        small(),
        any::<bool>(),
        0u16..3,
    )
        .prop_map(
            |(viscous, coulomb, stiffness, period, length, encoder, delay)| Rig {
                viscous,
                coulomb,
                stiffness,
                period,
                length,
                effects: Effects {
                    delay,
                    encoder,
                    ..Effects::encoder()
                },
            },
        )
}

sampled! {
    fn num_exact_instances_agree_on_numbers_of_any_size(
        a in position(), b in position(), beta in coefficient(), sigma in coefficient(),
        dtau in positive(), rig in rig()
    ) {
        let friction = Friction::new(beta, sigma);
        // The quotient by a viscous coefficient of zero is undefined in one type and zero in the other.
        prop_assume!(rig.criterion().viscous != zero());
        let exact = battery(&a, &b, &friction, &dtau, &rig);
        let wide_friction = friction_of(&friction, in_wide).unwrap();
        let wide = battery(
            &to_wide(&a), &to_wide(&b), &wide_friction, &to_wide(&dtau), &rig.try_map(in_wide).unwrap(),
        );
        let read: Option<Vec<_>> = wide.iter().map(from_wide).collect();
        prop_assert_eq!(read.as_ref(), Some(&exact));
        if let Some(fixed) = fixed_battery(&a, &b, &friction, &dtau, &rig) {
            if fixed.len() == exact.len() {
                for (fixed, exact) in fixed.iter().zip(&exact).filter(|(fixed, _)| fixed.is_defined()) {
                    prop_assert!(from_fixed(fixed).as_ref() == Some(exact));
                }
            }
        }
    }

    fn num_exact_instances_agree_on_numbers_of_data_sheets(
        a in small(), b in small(), beta in small(), sigma in small(), dtau in small(), rig in small_rig()
    ) {
        let friction = Friction::new(beta, sigma);
        prop_assume!(rig.criterion().viscous != zero());
        let exact = battery(&a, &b, &friction, &dtau, &rig);
        let fixed = fixed_battery(&a, &b, &friction, &dtau, &rig).unwrap();
        prop_assert_eq!(fixed.len(), exact.len());
        for (fixed, exact) in fixed.iter().zip(&exact) {
            prop_assert!(fixed.is_defined());
            prop_assert!(from_fixed(fixed).as_ref() == Some(exact));
        }
    }

    fn num_exact_instances_agree_on_verdicts(rig in rig(), v in positive(), squared in any::<bool>()) {
        let speeds = if squared { Speeds::UpToSquared(v) } else { Speeds::UpTo(v) };
        for speeds in [speeds, Speeds::All] {
            let expected = decide(&rig.criterion(), &speeds);
            prop_assert!(expected.is_some());
            prop_assert_eq!(verdict::of_rig(&rig, &speeds), expected);
        }
    }

    fn num_exact_instances_compare_alike(a in number(), b in number()) {
        let expected = Some(a.cmp(&b));
        prop_assert_eq!(a.compare(&b), expected);
        let (wide_a, wide_b) = (to_wide(&a), to_wide(&b));
        prop_assert_eq!(wide_a.compare(&wide_b), expected);
        prop_assert_eq!(wide_a.partial_cmp(&wide_b), expected);
        prop_assert_eq!(wide_a == wide_b, a == b);
        let signs = (a.sign(), a.is_nonnegative(), a.is_positive());
        prop_assert_eq!(signs, (Some(a.cmp(&zero())), Some(a >= zero()), Some(a > zero())));
        prop_assert_eq!((wide_a.sign(), wide_a.is_nonnegative(), wide_a.is_positive()), signs);
        let hull = Interval::hull(wide_a.clone(), wide_b.clone());
        prop_assert_eq!(from_wide(hull.lo()), Some(if a < b { a.clone() } else { b.clone() }));
        prop_assert_eq!(from_wide(&wide_a.max(wide_b)), Some(if a < b { b } else { a }));
    }

    fn num_exact_instances_agree_on_regions(viscous in number(), coulomb in number()) {
        let wide = Criterion { viscous: to_wide(&viscous), coulomb: to_wide(&coulomb) };
        prop_assert_eq!(Region::of(&wide), Region::of(&Criterion { viscous, coulomb }));
    }
}
