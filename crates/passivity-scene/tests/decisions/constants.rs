//! Constants for control programs: doubles on the safe side, and the source text around them.

use passivity_core::BigRational;
use passivity_random::draws;
use passivity_scene::Scene;
use passivity_scene::check::{Amount, Condition, Constants, Target, Verdict, check, constants};
use proptest::prelude::*;

use crate::wall::{q, scene};

fn of(values: &str) -> Constants {
    constants(&scene(values), Target::C).expect("a scene with units")
}

#[test]
fn constants_are_the_limits_of_the_scene() {
    // 2b/T and 2c/Δ; b − KT/2 and (c − KΔ/2)T/Δ.
    let plain = of("viscous 3/4, coulomb 5/4");
    assert_eq!((plain.stiffness, plain.max_stiffness), (1.0, Some(1.5)));
    assert_eq!((plain.damping, plain.max_damping), (0.0, Some(0.25)));
    assert_eq!((plain.rate, plain.max_speed), (1.0, None));
    assert_eq!((plain.max_force, plain.is_passive), (None, true));
    // With damping of its own: 2(b − B)/T.
    let damped = of("viscous 3/4, coulomb 5/4, damping 1/8, period 1/2, max_force 3/2");
    assert_eq!((damped.max_stiffness, damped.damping), (Some(2.0), 0.125));
    assert_eq!(damped.max_damping, Some(0.375));
    assert_eq!((damped.rate, damped.max_force), (2.0, Some(1.5)));
    // Up to V = 2, where every speed is too much: (b − B − ½)V + c − ½ − B.
    let bounded = of("viscous 1/4, coulomb 5/4, max_speed 2");
    assert_eq!(bounded.max_speed, Some(2.0));
    assert_eq!(bounded.max_damping, Some(0.083333));
    let vague = of("viscous 1/4, coulomb 5/4, max_speed 1 … 2");
    assert_eq!(vague.max_speed, Some(1.0));
    // A bound that is not needed is not passed on.
    assert_eq!(of("viscous 3/4, coulomb 5/4, max_speed 2").max_speed, None);
    // Nothing is enough: the criterion fails near rest; a controller has its own damping.
    let none = of("viscous 1, coulomb 1/4, force_step 1");
    assert_eq!(
        (none.max_stiffness, none.max_damping, none.is_passive),
        (None, None, false)
    );
    let led = of("viscous 5/4, coulomb 3/2, numerator [\"1.5\",\"-0.5\"]");
    assert_eq!((led.max_stiffness, led.max_damping), (Some(1.25), None));
    let dimensionless = "[dimensionless]\nbeta = \"1\"\nsigma = \"1\"\n";
    assert_eq!(
        constants(&Scene::from_toml("x", dimensionless).unwrap(), Target::C),
        None
    );
}

/// What is not a double is rounded down, from the hardest end of the tolerances: 2b/T with T of at most 3.
#[test]
fn constants_are_on_the_safe_side() {
    for (values, max_stiffness) in [
        ("viscous 1, coulomb 9, period 3", "2/3"),
        ("viscous 1, coulomb 9, period 2.5 … 3", "2/3"),
        ("viscous 7, coulomb 90, period 3", "14/3"),
        // Short already: five digits are a double at or below, or the next ones are.
        ("viscous 0.05, coulomb 9", "0.1"),
        ("viscous 0.15, coulomb 9", "0.3"),
        ("viscous 0.35, coulomb 9", "0.7"),
    ] {
        let found = of(values).max_stiffness.unwrap();
        assert!(exact(found) <= q(max_stiffness), "{values}: {found}");
        // Five digits, or all that a double has.
        assert!(
            q(max_stiffness) - exact(found) < q(max_stiffness) * q("1e-4"),
            "{values}: {found}"
        );
    }
    assert_eq!(
        of("viscous 1, coulomb 9, period 3").max_stiffness,
        Some(0.66666)
    );
    // The scene's own numbers: the double below 1/10 is not 0.1, and the one below 1/3 is the nearest.
    let tenth = of("viscous 3/4, coulomb 5/4, stiffness 1/10").stiffness;
    assert_eq!(tenth, 0.1_f64.next_down());
    let third = of("viscous 3/4, coulomb 5/4, stiffness 1/3").stiffness;
    assert_eq!(third, 1.0 / 3.0);
    assert!(exact(third) < q("1/3") && q("1/3") < exact(third.next_up()));
    assert_eq!(
        of("viscous 3/4, coulomb 5/4, max_speed 1/10, damping 1/10, max_force 1/10, stiffness 9")
            .max_speed,
        Some(0.1_f64.next_down())
    );
}

/// The numbers that stand together, typed into the scene together with the conditions; once more with
/// the filter's pole a in place of its time constant aT/(1 − a).
fn typed_back(
    values: &str,
    conditions: &[Condition],
    [stiffness, damping]: [BigRational; 2],
    rate: f64,
) -> Vec<Verdict> {
    let period = exact(rate).recip();
    let mut numbers = vec![("stiffness", stiffness), ("period", period.clone())];
    if damping != q("0") {
        numbers.push(("damping", damping));
    }
    let mut pole = None;
    for condition in conditions {
        let value = match condition.value {
            Amount::Double(value) => exact(value),
            _ => continue,
        };
        match condition.name {
            "encoder_resolution" if condition.unit == "mm" => {
                numbers.push(("resolution", value / q("1000")));
            }
            "encoder_resolution" => numbers.push(("resolution", value)),
            "amplifier_time_constant" => numbers.push(("time_constant", value)),
            "damping_pole" => pole = Some(&period * &value / (q("1") - &value)),
            name => numbers.push((name, value)),
        }
    }
    let filtered = pole.map(|tau| {
        let others = numbers
            .iter()
            .filter(|(key, _)| *key != "damping_time_constant");
        let others = others.cloned();
        others.chain([("damping_time_constant", tau)]).collect()
    });
    let with = |numbers: Vec<(&str, BigRational)>| {
        let is_ours = |value: &&str| {
            let key = value.split(' ').next();
            numbers.iter().any(|(ours, _)| key == Some(ours)) || key == Some("damping")
        };
        let others = values.split(", ").filter(|value| !is_ours(value));
        let ours = numbers.iter().map(|(key, value)| format!("{key} {value}"));
        let all: Vec<String> = others.map(str::to_owned).chain(ours).collect();
        check(&scene(&all.join(", "))).verdict
    };
    [Some(numbers), filtered]
        .into_iter()
        .flatten()
        .map(with)
        .collect()
}

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// Whatever of the numbers stands together passes, in a scene that passes; in others the largest do.
fn pass_together(values: &str) {
    for target in [Target::C, Target::OpenHaptics] {
        let found = constants(&scene(values), target).unwrap();
        numbers_pass_together(values, &found);
    }
}

fn numbers_pass_together(values: &str, found: &Constants) {
    // Newtons a millimetre.
    let in_metres = match found.target {
        Target::OpenHaptics => q("1000"),
        _ => q("1"),
    };
    let si = |x: f64| exact(x) * &in_metres;
    let own = found.is_passive.then_some(found.stiffness);
    let pairs = [
        (own, Some(found.damping)),
        (found.max_stiffness, Some(found.damping)),
        (Some(found.stiffness), found.max_damping),
        (Some(found.stiffness), found.min_damping),
    ];
    for rate in [Some(found.rate), found.whole_rate].into_iter().flatten() {
        for (stiffness, damping) in pairs {
            let (Some(stiffness), Some(damping)) = (stiffness, damping) else {
                continue;
            };
            let numbers = [si(stiffness), si(damping)];
            for verdict in typed_back(values, &found.conditions, numbers, rate) {
                let numbers = format!("{values}: {stiffness}, {damping}, {rate}");
                assert_eq!(verdict, Verdict::Passive, "{numbers}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(draws(24)))]

    #[test]
    fn numbers_of_random_scenes_pass_together(
        numbers in prop::array::uniform5((1..60_u32, 1..30_u32)),
        damping in prop::option::of((1..20_u32, 20..60_u32)),
        effects in prop::sample::subsequence(
            vec!["delay 1", "force_step 1/3", "damping_time_constant 2/7", "latency 1/9",
                 "time_constant 1/5", "max_speed 3/7", "max_force 5"],
            0..=3,
        ),
    ) {
        let keys = ["viscous", "coulomb", "period", "stiffness", "resolution"];
        let mut values: Vec<String> = (keys.into_iter().zip(numbers))
            .map(|(key, (n, d))| format!("{key} {n}/{d}"))
            .collect();
        let has_filter = |effect: &str| effect.starts_with("damping_time");
        let kept = effects.into_iter().filter(|e| damping.is_some() || !has_filter(e));
        values.extend(kept.map(str::to_owned));
        values.extend(damping.map(|(n, d)| format!("damping {n}/{d}")));
        pass_together(&values.join(", "));
    }
}

#[test]
fn numbers_that_are_written_together_pass_together() {
    for values in [
        "viscous 3/4, coulomb 5/4",
        // Equality: b = KT/2 with T = 3 ms.
        "viscous 0.15, coulomb 5, period 3e-3, stiffness 100, resolution 1/8192",
        // c = ½KΔ + BΔ/T: more samples cost Coulomb friction.
        "viscous 9, coulomb 5/8, period 3, damping 3/8",
        "viscous 9, coulomb 11/20, period 2, damping 1/10",
        // b = 3/2 − B: where the force is late, less damping costs viscous friction.
        "viscous 1.4, coulomb 9, delay 1, damping 0.1",
        // The same in newtons a millimetre, of which the double below is short.
        "viscous 1.28, coulomb 9, delay 1, damping 0.22, period 1e-3, stiffness 1000, resolution 1e-6",
        "viscous 1.37, coulomb 9, delay 1, damping 0.13, period 1e-3, stiffness 1000, resolution 1e-6",
        "viscous 1, coulomb 3, damping 1/7, stiffness 1/3, period 0.7, max_speed 1/3",
        "viscous 1, coulomb 3, damping 1/7, damping_time_constant 1/3, stiffness 1/3, period 0.7",
    ] {
        assert!(of(values).is_passive, "{values}");
        pass_together(values);
    }
    let late = of("viscous 0.15, coulomb 5, period 3e-3, stiffness 100, resolution 1/8192");
    assert_eq!(
        (late.rate, late.whole_rate),
        (1.0 / 3e-3_f64.next_down(), Some(334.0))
    );
    assert_eq!(
        of("viscous 9, coulomb 5/8, period 3, damping 3/8").whole_rate,
        None
    );
    assert_eq!(
        of("viscous 1.4, coulomb 9, delay 1, damping 0.1").damping,
        0.1
    );
}

const WALL: &str = r#"
    [device]
    viscous = "1 N s/m"
    [sampling]
    rate = "1 kHz"
    [wall]
    stiffness = "1 N/mm"
"#;

fn source(name: &str, text: &str, target: Target) -> String {
    let scene = Scene::from_toml(name, text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let source = constants(&scene, target).unwrap().to_source();
    let comment = source.strip_prefix("/*\n").unwrap();
    let (comment, code) = comment.split_once(" */\n").unwrap();
    assert!(comment.starts_with(&format!(
        " * Constants of the virtual wall «{}»",
        name.replace("*/", "* /").replace("/*", "/ *")
    )));
    assert!(
        comment.contains("\n * PASSIVE") || comment.contains("\n * NOT PASSIVE"),
        "{comment}"
    );
    assert!(comment.contains("\n * Rests on TH-"), "{comment}");
    assert!(comment.contains("\n * What binds: "), "{comment}");
    for line in comment.lines() {
        assert!(!line.contains("*/") && !line.contains("/*"), "{line}");
        assert!(line.chars().count() < 110, "{line}");
    }
    code.to_owned()
}

#[test]
fn a_header_in_c() {
    let expected = "\
#ifndef _1_WALL_WALL_H
#define _1_WALL_WALL_H

#define _1_WALL_STIFFNESS 1000.0 /* N/m */
#define _1_WALL_MAX_STIFFNESS 2000.0 /* N/m, with _1_WALL_DAMPING */
#define _1_WALL_DAMPING 0.0 /* N s/m */
#define _1_WALL_MAX_DAMPING 0.5 /* N s/m, with _1_WALL_STIFFNESS */
#define _1_WALL_SAMPLING_RATE 1000.0 /* Hz */
/* _1_WALL_MAX_SPEED: not bounded, the verdict holds at every speed or at none */
/* _1_WALL_MAX_FORCE: not in the scene */

#endif
";
    assert_eq!(source("*1/wall", WALL, Target::C), expected);
    // A name can neither end the comment nor begin another, and a macro cannot begin with a digit.
    let code = source("2 walls*/", WALL, Target::C);
    assert!(
        code.starts_with("#ifndef WALL_2_WALLS___WALL_H\n"),
        "{code}"
    );
    source("a/*b/*/c*/*/", WALL, Target::C);
    // Names of other letters have guards of their own.
    let guard = |name| {
        source(name, WALL, Target::C)
            .lines()
            .next()
            .map(str::to_owned)
    };
    assert_ne!(guard("стена"), guard("пружи"));
    let none = WALL.replace("\"1 N s/m\"", "\"0 N s/m\"");
    let code = source("none", &none, Target::C);
    let own = "\n#define NONE_STIFFNESS 1000.0 /* N/m, the scene's: with NONE_DAMPING it is not shown to be passive */\n";
    assert!(code.contains(own), "{code}");
    assert!(
        code.contains("\n/* NONE_MAX_STIFFNESS: no wall is passive */\n"),
        "{code}"
    );
    assert!(
        code.contains("\n/* NONE_MAX_DAMPING: none is passive */\n"),
        "{code}"
    );
}

#[test]
fn a_controller_is_in_the_place_of_damping() {
    let led = format!("{WALL}[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n")
        .replace("\"1 N s/m\"", "\"2 N s/m\"");
    let why = "the scene's controller is in the place of virtual damping";
    let code = source("led", &led, Target::C);
    assert!(
        code.contains(&format!("\n/* LED_MAX_DAMPING: {why} */\n")),
        "{code}"
    );
    let code = source("led", &led, Target::OpenHaptics);
    assert!(
        code.contains(&format!("\n/* kMaxDamping: {why}. */\n")),
        "{code}"
    );
}

fn rotary() -> String {
    WALL.replace("N s/m", "N m s/rad")
        .replace("N/mm", "N m/rad")
}

#[test]
fn fields_of_chai3d() {
    let more = format!("{WALL}max_force = \"20 N\"\n");
    let expected = "\
/* Fields of chai3d::cHapticDeviceInfo, in its SI units. */
info.m_maxLinearStiffness = 2000.0;
info.m_maxLinearDamping = 0.0; /* the scene's */
info.m_maxLinearForce = 20.0;
/* The haptic thread must run at 1000.0 Hz. */
";
    assert_eq!(source("wall", &more, Target::Chai3d), expected);
    let knob = source("knob", &rotary(), Target::Chai3d);
    assert!(
        knob.contains(
            "info.m_maxAngularStiffness = 2000.0;\ninfo.m_maxAngularDamping = 0.0; /* the scene's */\n"
        ),
        "{knob}"
    );
    assert!(!knob.contains("Torque"), "{knob}");
    let knob = source(
        "knob",
        &format!("{}max_force = \"2 N m\"\n", rotary()),
        Target::Chai3d,
    );
    assert!(knob.contains("info.m_maxAngularTorque = 2.0;"), "{knob}");
    let none = WALL.replace("\"1 N s/m\"", "\"0 N s/m\"");
    let none = source("none", &none, Target::Chai3d);
    assert!(
        none.contains("info.m_maxLinearStiffness = 0.0; /* none is passive with"),
        "{none}"
    );
}

#[test]
fn settings_of_open_haptics() {
    // Newtons and millimetres; the double 0.0005 is above 1/2000.
    let expected = "\
hdSetSchedulerRate(1000); /* Hz; the scene has 1000.0 Hz */
static const HDdouble kStiffness = 1.0; /* N/mm */
static const HDdouble kDamping = 0.0; /* N s/mm */
static const HDdouble kMaxStiffness = 2.0; /* N/mm, with kDamping */
static const HDdouble kMaxDamping = 0.0004999999999999999; /* N s/mm, with kStiffness */
/* HL_STIFFNESS takes a part of the device's nominal largest stiffness, as a float (math.h): */
HDdouble nominal;
hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &nominal); /* N/mm */
hlMaterialf(HL_FRONT_AND_BACK, HL_STIFFNESS, kMaxStiffness < nominal ? nextafterf(kMaxStiffness / nominal, 0) : 1);
";
    assert_eq!(source("wall", WALL, Target::OpenHaptics), expected);
    let knob = source("knob", &rotary(), Target::OpenHaptics);
    assert!(
        knob.contains("kMaxStiffness = 2000.0; /* N m/rad, with kDamping */"),
        "{knob}"
    );
    assert!(
        knob.contains("kMaxDamping = 0.9994999999999999; /* N m s/rad, with kStiffness */"),
        "{knob}"
    );
    // Newton metres are not compared with newtons.
    assert!(
        !knob.contains("hdGetDoublev") && !knob.contains("hlMaterialf"),
        "{knob}"
    );
    assert!(knob.contains("this wall turns"), "{knob}");
    let none = WALL.replace("\"1 N s/m\"", "\"0 N s/m\"");
    let none = source("none", &none, Target::OpenHaptics);
    assert!(
        none.contains(
            "\n/* kMaxStiffness: no wall is passive. */\n/* kMaxDamping: none is passive. */\n"
        ),
        "{none}"
    );
    // Passive up to a bound only.
    let bounded = format!(
        "{}[encoder]\nresolution = \"1 mm\"\n[operator]\nmax_speed = \"1/2 m/s\"\n",
        WALL.replace("viscous = \"1 N s/m\"", "coulomb = \"2 N\"")
    );
    let bounded = source("bounded", &bounded, Target::OpenHaptics);
    assert!(
        bounded
            .contains("\n/* Only while the hand is never faster than 0.5 m/s. */\n/* Conditions: "),
        "{bounded}"
    );
}
