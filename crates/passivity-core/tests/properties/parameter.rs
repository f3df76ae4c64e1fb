//! The table of parameters: what each may be, and that every list of them is the table.

use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::BTreeSet;

use passivity_core::parameter::{Unit, Values};
use passivity_core::{Loop, Parameter, Scalar as _};

use crate::common::{q, zero};

/// Parameter, key, name, symbol, powers of K, T and Δ, values, direction and default.
const TABLE: &str = "\
Stiffness|wall.stiffness|stiffness|K|1 0 0|Positive|More|None
Period|sampling.period|sampling period|T|0 1 0|Positive|More|None
Inertia|device.inertia|inertia|m|1 2 0|Positive|Neither|None
Viscous|device.viscous|viscous friction|b|1 1 0|NonNegative|Less|Some(0)
Coulomb|device.coulomb|Coulomb friction|c|1 0 1|NonNegative|Less|Some(0)
Resolution|encoder.resolution|encoder resolution|Δ|0 0 1|Positive|More|None
Damping|wall.damping|virtual damping|B|1 1 0|NonNegative|More|None
DampingTimeConstant|wall.damping_time_constant|time constant of the damping's filter|τ|0 1 0|NonNegative|Less|None
MaxForce|wall.max_force|largest force|F_max|1 0 1|Positive|Neither|None
ForceStep|wall.force_step|force step|F|1 0 1|Positive|More|None
Latency|sampling.latency|latency|L|0 1 0|NonNegative|More|None
TimeConstant|amplifier.time_constant|amplifier time constant|T_a|0 1 0|Positive|More|None
ViscousCost||viscous cost|λ|0 0 0|Positive|More|None
CoulombCost||Coulomb cost|½‖c‖₁|0 0 0|NonNegative|More|None
MaxSpeed|operator.max_speed|speed bound|V|0 -1 1|Positive|More|None
OperatorForce|operator.force|force of the operator|F_H|1 0 1|Any|Neither|None
ArmMass|operator.arm.mass|mass of the arm|m_a|1 2 0|NonNegative|Neither|Some(0)
ArmDamping|operator.arm.damping|damping of the arm|b_a|1 1 0|NonNegative|Neither|Some(0)
ArmStiffness|operator.arm.stiffness|stiffness of the arm|K_a|1 0 0|NonNegative|Neither|Some(0)
StartPosition|start.position|position at the start|x(0)|0 0 1|Any|Neither|Some(0)
StartVelocity|start.velocity|velocity at the start|v(0)|0 -1 1|Any|Neither|Some(0)";

#[test]
fn num_exact_parameters_have_the_rows_of_the_table() {
    assert_eq!(TABLE.lines().count(), Parameter::ALL.len());
    for (line, parameter) in TABLE.lines().zip(Parameter::ALL) {
        let row = parameter.row();
        let Unit {
            stiffness,
            period,
            length,
        } = row.unit;
        let found = format!(
            "{parameter:?}|{}|{}|{}|{stiffness} {period} {length}|{:?}|{:?}|{:?}",
            row.key, row.name, row.symbol, row.values, row.hurts, row.default
        );
        assert_eq!(found, line);
    }
}

#[test]
fn num_exact_parameters_are_told_apart_by_key_name_and_symbol() {
    let rows = || Parameter::ALL.iter().map(|parameter| parameter.row());
    let keys = rows().flat_map(|row| {
        let others = row.other_keys.iter().copied();
        [row.key]
            .into_iter()
            .chain(others)
            .chain(row.dimensionless_key)
    });
    let symbols = rows().flat_map(|row| [Some(row.symbol), row.dimensionless_symbol]);
    let all_differ = |words: Vec<&str>| {
        let count = words.len();
        assert_eq!(words.into_iter().collect::<BTreeSet<_>>().len(), count);
    };
    // What is computed has no key.
    all_differ(keys.filter(|key| !key.is_empty()).collect());
    all_differ(symbols.flatten().collect());
    all_differ(rows().map(|row| row.name).collect());
    for row in rows() {
        let both = row.dimensionless_key.is_some() == row.dimensionless_symbol.is_some();
        assert!(both, "{}", row.key);
    }
}

#[test]
fn num_exact_values_that_a_parameter_may_take() {
    let table = [
        (Values::Positive, [false, false, true], "a value above zero"),
        (
            Values::NonNegative,
            [false, true, true],
            "zero or a value above it",
        ),
        (Values::Any, [true, true, true], "a value of either sign"),
    ];
    for (values, allowed, expected) in table {
        assert_eq!(
            [Less, Equal, Greater].map(|sign| values.allow(sign)),
            allowed
        );
        assert_eq!(values.expected(), expected);
    }
}

/// A loop with every parameter at its own number: 1, 2, … in the order of the table.
fn numbered() -> Loop<i64> {
    let all = Parameter::ALL.iter().copied();
    let start = Loop {
        delay: 3,
        unilateral: true,
        ..Loop::new(-1, -1)
    };
    (1..).zip(all).fold(start, |the_loop, (n, parameter)| {
        the_loop.with(parameter, n)
    })
}

#[test]
fn num_exact_every_list_of_parameters_is_the_table() {
    let the_loop = numbered();
    for (n, parameter) in (1..).zip(Parameter::ALL) {
        assert_eq!(the_loop.get(*parameter), Some(&n), "{parameter:?}");
        let changed = the_loop.clone().with(*parameter, -n);
        for other in Parameter::ALL {
            let expected = the_loop
                .get(*other)
                .map(|x| if other == parameter { -x } else { *x });
            assert_eq!(
                changed.get(*other),
                expected.as_ref(),
                "{parameter:?} {other:?}"
            );
        }
    }
    // The fields by name are the parameters by name.
    let Loop {
        stiffness,
        period,
        inertia,
        viscous,
        coulomb,
        resolution,
        ..
    } = the_loop;
    assert_eq!((stiffness, period, inertia), (1, 2, Some(3)));
    assert_eq!((viscous, coulomb, resolution), (Some(4), Some(5), Some(6)));
    let Loop {
        damping,
        damping_time_constant,
        max_force,
        force_step,
        latency,
        time_constant,
        viscous_cost,
        coulomb_cost,
        max_speed,
        ..
    } = the_loop;
    assert_eq!(
        (damping, damping_time_constant, max_force, force_step),
        (Some(7), Some(8), Some(9), Some(10))
    );
    assert_eq!((latency, time_constant), (Some(11), Some(12)));
    assert_eq!((viscous_cost, coulomb_cost), (Some(13), Some(14)));
    assert_eq!(max_speed, Some(15));
    let Loop {
        operator_force,
        arm_mass,
        arm_damping,
        arm_stiffness,
        ..
    } = the_loop;
    assert_eq!((operator_force, arm_mass), (Some(16), Some(17)));
    assert_eq!((arm_damping, arm_stiffness), (Some(18), Some(19)));
    assert_eq!(
        (the_loop.start_position, the_loop.start_velocity),
        (Some(20), Some(21))
    );
}

#[test]
fn num_exact_a_map_takes_every_parameter_once_and_knows_which() {
    let the_loop = numbered();
    let mapped = the_loop.map(|parameter, n| (parameter, n * 2));
    let tried = the_loop.try_map(|parameter, n| Some((parameter, n * 2)));
    assert_eq!(tried.as_ref(), Some(&mapped));
    assert_eq!((mapped.delay, mapped.unilateral), (3, true));
    let given: Vec<_> = mapped
        .given()
        .map(|(parameter, x)| (parameter, *x))
        .collect();
    let expected: Vec<_> = (1..)
        .zip(Parameter::ALL)
        .map(|(n, parameter)| (*parameter, (*parameter, n * 2)))
        .collect();
    assert_eq!(given, expected);
    // One that cannot be converted is enough to give up.
    for hopeless in Parameter::ALL {
        let tried = the_loop.try_map(|parameter, n| (parameter != *hopeless).then_some(*n));
        assert_eq!(tried, None, "{hopeless:?}");
    }
}

#[test]
fn num_exact_absent_parameters_have_the_default_of_the_table() {
    let bare = Loop::new(q(7, 1), q(8, 1));
    assert_eq!(bare.given().count(), 2);
    assert_eq!((bare.delay, bare.unilateral), (0, false));
    assert_eq!(bare.value(Parameter::Stiffness), Some(q(7, 1)));
    assert_eq!(bare.value(Parameter::Period), Some(q(8, 1)));
    for parameter in Parameter::ALL.iter().skip(2) {
        assert_eq!(bare.get(*parameter), None);
        let default = parameter.row().default.map(|_| zero());
        assert_eq!(bare.value(*parameter), default, "{parameter:?}");
        let given = bare.clone().with(*parameter, q(5, 3));
        assert_eq!(given.value(*parameter), Some(q(5, 3)));
    }
    assert_eq!(bare.map(|_, x| x.clone().double()).period, q(16, 1));
}

/// A torque at the motor is n times one at the device, and friction and inertia n² times: every energy stays.
#[test]
fn num_exact_units_across_a_transmission() {
    use passivity_core::parameter::Unit;
    for (unit, power) in [
        (Unit::INERTIA, 2),
        (Unit::VISCOUS, 2),
        (Unit::STIFFNESS, 2),
        (Unit::FORCE, 1),
        (Unit::POSITION, -1),
        (Unit::SPEED, -1),
        (Unit::TIME, 0),
        (Unit::NONE, 0),
    ] {
        assert_eq!(unit.transmission_power(), power, "{unit:?}");
    }
}

/// Effects are told apart by their names, words and keys, and each has its theorem.
#[test]
fn num_exact_effects_have_names() {
    use passivity_core::Effect;
    let late = Effect::Delay;
    assert_eq!((late.name(), late.key()), ("delay", "sampling.delay"));
    assert_eq!(late.words(), "delay of whole samples");
    assert_eq!(late.theorem(), Some("TH-DELAY"));
    for of in [Effect::name, Effect::words, Effect::key] {
        let mut all: Vec<&str> = Effect::ALL.into_iter().map(of).collect();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), Effect::ALL.len());
        assert!(all.iter().all(|text| text.len() > 2));
    }
}
