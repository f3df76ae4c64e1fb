//! Constants for control programs: doubles on the safe side, and the source text around them.

use passivity_core::BigRational;
use passivity_scene::Scene;
use passivity_scene::check::{Constants, Target, constants};

use crate::wall::{q, scene};

fn of(values: &str) -> Constants {
    constants(&scene(values)).expect("a scene with units")
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
        constants(&Scene::from_toml("x", dimensionless).unwrap()),
        None
    );
}

/// What is not a double is rounded down, from the hardest end of the tolerances: 2b/T with T of at most 3.
#[test]
fn constants_are_on_the_safe_side() {
    let exact = |x: f64| BigRational::from_float(x).unwrap();
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
    let source = constants(&scene).unwrap().to_source(target);
    let (comment, code) = source.split_once(" */\n").unwrap();
    assert!(comment.starts_with(&format!(
        "/*\n * Constants of the virtual wall «{}»",
        name.replace("*/", "* /")
    )));
    assert!(
        comment.contains("\n * PASSIVE") || comment.contains("\n * NOT PASSIVE"),
        "{comment}"
    );
    assert!(comment.contains("\n * Rests on TH-"), "{comment}");
    assert!(comment.contains("\n * What binds: "), "{comment}");
    for line in comment.lines() {
        assert!(!line.contains("*/") && line.chars().count() < 110, "{line}");
    }
    code.to_owned()
}

#[test]
fn a_header_in_c() {
    let expected = "\
#ifndef _1_WALL_WALL_H
#define _1_WALL_WALL_H

#define _1_WALL_STIFFNESS 1000.0 /* N/m */
#define _1_WALL_MAX_STIFFNESS 2000.0 /* N/m */
#define _1_WALL_DAMPING 0.0 /* N s/m */
#define _1_WALL_MAX_DAMPING 0.5 /* N s/m */
#define _1_WALL_SAMPLING_RATE 1000.0 /* Hz */
/* _1_WALL_MAX_SPEED: not bounded, the verdict holds at every speed or at none */
/* _1_WALL_MAX_FORCE: not in the scene */

#endif
";
    assert_eq!(source("*1/wall", WALL, Target::C), expected);
    // A name cannot end the comment, and a macro cannot begin with a digit.
    let code = source("2 walls*/", WALL, Target::C);
    assert!(
        code.starts_with("#ifndef WALL_2_WALLS___WALL_H\n"),
        "{code}"
    );
    let none = WALL.replace("\"1 N s/m\"", "\"0 N s/m\"");
    let code = source("none", &none, Target::C);
    assert!(
        code.contains("\n/* NONE_MAX_STIFFNESS: no wall is passive */\n"),
        "{code}"
    );
    assert!(
        code.contains("\n/* NONE_MAX_DAMPING: none is passive */\n"),
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
info.m_maxLinearDamping = 0.5;
info.m_maxLinearForce = 20.0;
/* The haptic thread must run at 1000.0 Hz. */
";
    assert_eq!(source("wall", &more, Target::Chai3d), expected);
    let knob = source("knob", &rotary(), Target::Chai3d);
    assert!(
        knob.contains(
            "info.m_maxAngularStiffness = 2000.0;\ninfo.m_maxAngularDamping = 0.9994999999999999;\n"
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
        none.contains("info.m_maxLinearStiffness = 0.0; /* none is passive */"),
        "{none}"
    );
}

#[test]
fn settings_of_open_haptics() {
    // Newtons and millimetres, and a double less than the quotient, which may be rounded up.
    let expected = "\
hdSetSchedulerRate(1000); /* Hz; the proof is for 1000.0 Hz */
static const HDdouble kMaxStiffness = 1.9999999999999998; /* N/mm */
/* HL_STIFFNESS takes a part of the device's nominal largest stiffness: */
HDdouble nominal;
hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &nominal); /* N/mm */
hlMaterialf(HL_FRONT_AND_BACK, HL_STIFFNESS, kMaxStiffness < nominal ? kMaxStiffness / nominal : 1.0);
static const HDdouble kMaxDamping = 0.0004999999999999999; /* N s/mm */
";
    assert_eq!(source("wall", WALL, Target::OpenHaptics), expected);
    let knob = source("knob", &rotary(), Target::OpenHaptics);
    assert!(
        knob.contains("kMaxStiffness = 2000.0; /* N m/rad */"),
        "{knob}"
    );
    assert!(
        knob.contains("kMaxDamping = 0.9994999999999999; /* N m s/rad */"),
        "{knob}"
    );
    let none = WALL.replace("\"1 N s/m\"", "\"0 N s/m\"");
    let none = source("none", &none, Target::OpenHaptics);
    assert!(
        none.contains("\n/* No wall is passive. */\n/* No virtual damping is passive. */\n"),
        "{none}"
    );
    // Passive up to a bound only.
    let bounded = format!(
        "{}[encoder]\nresolution = \"1 mm\"\n[operator]\nmax_speed = \"1/2 m/s\"\n",
        WALL.replace("viscous = \"1 N s/m\"", "coulomb = \"2 N\"")
    );
    let bounded = source("bounded", &bounded, Target::OpenHaptics);
    assert!(
        bounded.ends_with("/* Only while the hand is never faster than 0.5 m/s. */\n"),
        "{bounded}"
    );
}
