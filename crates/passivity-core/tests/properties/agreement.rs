//! The instances agree: big rationals, unreduced big fractions, and 128-bit fractions where defined.

use passivity_core::controller::{Controller, rounded};
use passivity_core::ledger::HeldInterval;
use passivity_core::rational::{from_fixed, from_wide, to_fixed, to_wide};
use passivity_core::verdict::{self, Speeds, decide};
use passivity_core::{
    BigRational, Criterion, Fixed, Friction, Interval, Law, Loop, Ordered, Region, Scalar, Step,
    Wide, dissipation, extra_storage, generation, ledger, quantizer, region, spring, start,
    stiffness, witness,
};
use proptest::prelude::*;

use crate::common::{a_loop, coefficient, number, position, positive, q, sampled, zero};

/// Every function of the kernel that gives a number, at the same inputs.
fn battery<S: Ordered>(
    a: &S,
    b: &S,
    friction: &Friction<S>,
    dtau: &S,
    the_loop: &Loop<S>,
) -> Vec<S> {
    let step = Step::new(a.clone(), b.clone());
    let d = step.displacement();
    let speed = dissipation::mean_speed(&d, dtau);
    let plain = HeldInterval::plain(step.clone(), dtau.clone());
    let row = ledger::row(&Loop::plain(friction.clone()), &plain);
    let foreign = HeldInterval {
        force: dtau.clone(),
        extra_storage: Some(b.clone()),
        ..plain
    };
    let other = ledger::row(&the_loop.dimensionless(), &foreign);
    let controller = Controller::of(&the_loop.dimensionless());
    let mut memory = controller.at_rest(a);
    let criterion = the_loop.criterion();
    let dimensionless = the_loop.dimensionless_criterion();
    let law = Law::unilateral().saturated(the_loop.period.clone());
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
        the_loop.dimensionless_speed(a),
        region::critical_speed(&criterion),
        start::speed_squared(dtau, a, b),
        start::margin_of_squares(&criterion, &speed),
        stiffness::limit_at_all_speeds(the_loop),
        stiffness::limit_up_to_speed(the_loop, dtau),
        stiffness::viscous_needed_at_speed(the_loop, dtau),
        stiffness::coulomb_needed_up_to_speed(the_loop, dtau),
        stiffness::longest_period(the_loop),
        stiffness::longest_period_at_speed(the_loop, dtau),
        stiffness::best_period_at_speed(the_loop, dtau),
        rounded(a, dtau, &S::integer(3)),
        controller.sample(&mut memory, b),
        controller.sample(&mut memory, dtau),
        extra_storage::generated_by_damping(a, b, dtau),
        extra_storage::delay_storage(&[a.clone(), b.clone(), dtau.clone()]),
        extra_storage::damping_storage(dtau, &[a.clone(), b.clone()]),
        extra_storage::generated_by_delay(&[a.clone(), b.clone()], dtau),
        the_loop.cost().bound(&d),
        law.force(a),
        law.potential(a),
        law.quantized_potential(a),
        other.net_linear,
        other.net_quantized,
        other.margin,
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
        stiffness::coulomb_limit(the_loop),
        stiffness::shortest_period(the_loop),
        stiffness::coarsest_resolution(the_loop),
        stiffness::coarsest_resolution_up_to_speed(the_loop, dtau),
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
    the_loop: &Loop<BigRational>,
) -> Option<Vec<Fixed>> {
    let friction = friction_of(friction, to_fixed)?;
    Some(battery(
        &to_fixed(a)?,
        &to_fixed(b)?,
        &friction,
        &to_fixed(dtau)?,
        &the_loop.try_map(|_, x| to_fixed(x))?,
    ))
}

/// Numbers that data sheets have.
fn small() -> impl Strategy<Value = BigRational> {
    (1i64..100, 1i64..20).prop_map(|(n, d)| q(n, d))
}

fn small_loop() -> impl Strategy<Value = Loop<BigRational>> {
    let numbers = (
        small(),
        small(),
        small(),
        small(),
        prop::option::of(small()),
    );
    (numbers, 0u16..3).prop_map(
        |((viscous, coulomb, stiffness, period, resolution), delay)| Loop {
            viscous: Some(viscous),
            coulomb: Some(coulomb),
            resolution,
            delay,
            ..Loop::new(stiffness, period)
        },
    )
}

sampled! {
    fn num_exact_instances_agree_on_numbers_of_any_size(
        a in position(), b in position(), beta in coefficient(), sigma in coefficient(),
        dtau in positive(), the_loop in a_loop()
    ) {
        let friction = Friction::new(beta, sigma);
        // The quotient by a viscous coefficient of zero is undefined in one type and zero in the other.
        prop_assume!(the_loop.criterion().viscous != zero());
        let exact = battery(&a, &b, &friction, &dtau, &the_loop);
        let wide_friction = friction_of(&friction, in_wide).unwrap();
        let wide = battery(
            &to_wide(&a), &to_wide(&b), &wide_friction, &to_wide(&dtau), &the_loop.map(|_, x| to_wide(x)),
        );
        let read: Option<Vec<_>> = wide.iter().map(from_wide).collect();
        prop_assert_eq!(read.as_ref(), Some(&exact));
        if let Some(fixed) = fixed_battery(&a, &b, &friction, &dtau, &the_loop) {
            if fixed.len() == exact.len() {
                for (fixed, exact) in fixed.iter().zip(&exact).filter(|(fixed, _)| fixed.is_defined()) {
                    prop_assert!(from_fixed(fixed).as_ref() == Some(exact));
                }
            }
        }
    }

    fn num_exact_instances_agree_on_numbers_of_data_sheets(
        a in small(), b in small(), beta in small(), sigma in small(), dtau in small(), the_loop in small_loop()
    ) {
        let friction = Friction::new(beta, sigma);
        prop_assume!(the_loop.criterion().viscous != zero());
        let exact = battery(&a, &b, &friction, &dtau, &the_loop);
        let fixed = fixed_battery(&a, &b, &friction, &dtau, &the_loop).unwrap();
        prop_assert_eq!(fixed.len(), exact.len());
        for (fixed, exact) in fixed.iter().zip(&exact) {
            prop_assert!(fixed.is_defined());
            prop_assert!(from_fixed(fixed).as_ref() == Some(exact));
        }
    }

    fn num_exact_instances_agree_on_verdicts(the_loop in a_loop(), v in positive(), squared in any::<bool>()) {
        let speeds = if squared { Speeds::UpToSquared(v) } else { Speeds::UpTo(v) };
        for speeds in [speeds, Speeds::All] {
            let expected = decide(&the_loop.criterion(), &speeds);
            prop_assert!(expected.is_some());
            prop_assert_eq!(verdict::of_loop(&the_loop, &speeds), expected);
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
