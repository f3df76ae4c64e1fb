//! Units and tolerances as they become exact values of a scene.

use passivity_core::{BigRational, Effect, Exact, Interval, Parameter, Scalar as _, pi};
use passivity_scene::number::parse;
use passivity_scene::{Given, Motion, Scene, SceneError};

fn number(text: &str) -> BigRational {
    parse(text).unwrap()
}

fn interval(lo: &str, hi: &str) -> Interval<BigRational> {
    Interval::new(number(lo), number(hi)).unwrap()
}

/// The rational values of an interval, over a power of π.
fn over_pi(range: &Interval<Exact>, power: i8) -> Interval<BigRational> {
    let pi_to = |n: i8| (0..n).fold(Exact::one(), |x, _| x * pi::pi());
    let rational = |x: &Exact| {
        let x = x.clone().over(pi_to(power)) * pi_to(-power);
        x.to_rational().expect("no π is left")
    };
    range.map(rational)
}

/// The rational values of an interval in which there is no π.
fn rational(range: &Interval<Exact>) -> Interval<BigRational> {
    over_pi(range, 0)
}

/// A rotary scene with one more line in one section.
fn rotary(section: &str, line: &str) -> Result<Scene, SceneError> {
    let sections = [
        "device",
        "sampling",
        "encoder",
        "wall",
        "operator",
        "start",
        "amplifier",
    ];
    let given = |name: &str| match name {
        "sampling" if !line.starts_with("rate") && !line.starts_with("period") => {
            "period = \"1 ms\"\n"
        }
        "wall" if !line.starts_with("stiffness") => "stiffness = \"1 N m/rad\"\n",
        _ => "",
    };
    let text: String = sections
        .into_iter()
        .filter(|name| *name == section || !given(name).is_empty())
        .map(|name| {
            let more = if name == section { line } else { "" };
            format!("[{name}]\n{}{more}\n", given(name))
        })
        .collect();
    Scene::from_toml("test", &text)
}

fn viscous(text: &str) -> Given {
    let scene = rotary("device", &format!("viscous = \"{text}\""));
    scene
        .unwrap_or_else(|e| panic!("{e}"))
        .given
        .viscous
        .unwrap()
}

#[test]
fn a_tolerance_is_a_closed_interval() {
    let cases = [
        ("9e-6 N m s/rad", "9e-6", "9e-6"),
        ("9e-6 N m s/rad ± 10%", "8.1e-6", "9.9e-6"),
        ("9e-6 N m s/rad ± 10 %", "8.1e-6", "9.9e-6"),
        ("9e-6 N m s/rad±10%", "8.1e-6", "9.9e-6"),
        ("9e-6 N m s/rad +/- 10%", "8.1e-6", "9.9e-6"),
        ("9e-6 N m s/rad +- 1/3%", "8.97e-6", "9.03e-6"),
        ("9e-6 N m s/rad ± 1e-6", "8e-6", "10e-6"),
        ("9e-6 N m s/rad ± 1e-6 N m s/rad", "8e-6", "10e-6"),
        ("9e-6 N m s/rad ± 1 µN m s/rad", "8e-6", "10e-6"),
        ("9e-6 ± 1e-6 N m s/rad", "8e-6", "10e-6"),
        ("9e-6 ± 10% N m s/rad", "8.1e-6", "9.9e-6"),
        ("9 µN m s/rad ± 1", "8e-6", "10e-6"),
        ("9e-6 N m s/rad ± 100%", "0", "18e-6"),
        ("9e-6 N m s/rad ± 0", "9e-6", "9e-6"),
        ("0 N m s/rad", "0", "0"),
        ("  9e-6N m s/rad  ", "9e-6", "9e-6"),
        ("9/1000000 N m s", "9e-6", "9e-6"),
    ];
    for (text, lo, hi) in cases {
        let given = viscous(text);
        assert_eq!(rational(&given.value), interval(lo, hi), "{text}");
        assert_eq!(given.has_tolerance(), lo != hi, "{text}");
        assert_eq!(given.text, text);
    }
    assert_eq!(
        viscous("9e-6 N m s/rad ± 10%").nominal.to_rational(),
        Some(number("9e-6"))
    );
}

#[test]
fn a_negative_value_keeps_its_tolerance_the_right_way_round() {
    let scene = rotary("start", "velocity = \"-10 rad/s ± 10%\"").unwrap();
    let velocity = scene.given.start_velocity.unwrap();
    assert_eq!(rational(&velocity.value), interval("-11", "-9"));
}

#[test]
fn turns_and_degrees_carry_their_power_of_pi() {
    let cases = [
        ("start", "position = \"90 deg\"", "1/2", 1),
        ("start", "position = \"1/4 rev\"", "1/2", 1),
        ("start", "velocity = \"60 rpm\"", "2", 1),
        ("encoder", "resolution = \"3.6 arcsec\"", "1/180000", 1),
        ("wall", "damping = \"1 N m/rpm\"", "30", -1),
        ("wall", "stiffness = \"1 N m/deg\"", "180", -1),
    ];
    for (section, line, value, pi) in cases {
        let scene = rotary(section, line).unwrap_or_else(|e| panic!("{e}"));
        let key = line.split(' ').next().unwrap();
        let all = scene.parameters();
        let (_, given) = all.iter().find(|(_, g)| g.key.ends_with(key)).unwrap();
        assert_eq!(over_pi(&given.value, pi), interval(value, value), "{line}");
    }
}

#[test]
fn a_rate_is_the_reciprocal_of_a_period() {
    let cases = [
        ("rate = \"1 kHz\"", "1e-3", "1e-3"),
        ("rate = \"1 kHz ± 20%\"", "1/1200", "1/800"),
        ("rate = \"500 /s\"", "2e-3", "2e-3"),
        ("period = \"1 ms ± 20%\"", "8e-4", "12e-4"),
    ];
    for (line, lo, hi) in cases {
        let period = rotary("sampling", line).unwrap().given.period;
        assert_eq!(rational(&period.value), interval(lo, hi), "{line}");
    }
    let nominal = rotary("sampling", "rate = \"1 kHz ± 20%\"")
        .unwrap()
        .given
        .period
        .nominal;
    assert_eq!(nominal.to_rational(), Some(number("1e-3")));
}

#[test]
fn counts_give_the_resolution_with_pi() {
    let scene = rotary("encoder", "counts_per_revolution = 8_192").unwrap();
    let resolution = scene.given.resolution.unwrap();
    assert_eq!(resolution.key, "encoder.counts_per_revolution");
    assert_eq!(over_pi(&resolution.value, 1), interval("1/4096", "1/4096"));
}

#[test]
fn the_usual_lenience_about_radians_is_granted() {
    for (section, line) in [
        ("device", "viscous = \"1 N m s\""),
        ("device", "viscous = \"1 N m s/rad\""),
        ("device", "inertia = \"1 kg m^2\""),
        ("device", "inertia = \"1 N m s^2/rad\""),
        ("device", "inertia = \"1 kg m^2/rad^2\""),
        ("wall", "damping = \"1 N m s\""),
    ] {
        let scene = rotary(section, line).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(scene.motion, Motion::Rotary);
    }
    // But a torque is no stiffness, and a rate no angular speed.
    for (section, line) in [
        ("wall", "stiffness = \"1 N m\""),
        ("device", "coulomb = \"1 N m/rad\""),
        ("operator", "max_speed = \"1 Hz\""),
    ] {
        let error = rotary(section, line).unwrap_err();
        assert_eq!(error.diagnostics()[0].kind().name(), "wrong_unit", "{line}");
    }
}

#[test]
fn an_arm_has_zero_for_what_it_does_not_say() {
    let line = "arm = { mass = \"1 g cm^2\", stiffness = \"2 N m/rad\" }";
    let scene = rotary("operator", line).unwrap();
    assert!(scene.has(Effect::Arm) && scene.given.arm_damping.is_none());
    let loop_of_scene = scene.given.map(|_, given| given.nominal.clone());
    let value = |parameter| {
        loop_of_scene
            .value(parameter)
            .unwrap()
            .to_rational()
            .unwrap()
    };
    assert_eq!(value(Parameter::ArmMass), number("1e-7"));
    assert_eq!(value(Parameter::ArmDamping), number("0"));
    assert_eq!(value(Parameter::ArmStiffness), number("2"));
}

#[test]
fn dimensionless_scenes_take_plain_numbers_and_ticks() {
    let text = r#"
        [dimensionless]
        mu = 50
        beta = 0.6
        sigma = "3/5 ± 10%"
        [sampling]
        delay = 2
        [wall]
        unilateral = true
        damping = "1/10"
        max_force = 1e3
        force_step = "0.25"
        [amplifier]
        time_constant = "1/5"
        [operator]
        max_speed = "2 ticks/sample"
        force = -0.5
        arm = { mass = 1, damping = "2", stiffness = "1/3" }
        [start]
        position = "-3 ticks"
        velocity = "10 ticks per sample"
        [run]
        intervals = 7
    "#;
    let scene = Scene::from_toml("point", text).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(scene.motion, Motion::Dimensionless);
    let point = scene.point();
    assert_eq!(point.at.inertia, Some(number("50")));
    // 0.6 is three fifths, not the double next to it.
    assert_eq!(point.at.viscous, Some(number("3/5")));
    assert_eq!(
        rational(&scene.given.coulomb.unwrap().value),
        interval("27/50", "33/50")
    );
    assert!(point.at.has_encoder() && point.at.unilateral);
    assert_eq!((point.at.delay, point.intervals), (2, 7));
    assert_eq!(point.at.damping, Some(number("1/10")));
    assert_eq!(point.at.max_force, Some(number("1000")));
    assert_eq!(point.at.force_step, Some(number("1/4")));
    assert_eq!(point.at.time_constant, Some(number("1/5")));
    assert_eq!(point.forces, Some(vec![number("-1/2")]));
    let arm = [
        &point.at.arm_mass,
        &point.at.arm_damping,
        &point.at.arm_stiffness,
    ];
    assert_eq!(arm, ["1", "2", "1/3"].map(|x| Some(number(x))).each_ref());
    assert_eq!(point.start(), [number("-3"), number("10")]);
    let bound = scene.given.max_speed.unwrap();
    assert_eq!(rational(&bound.value), interval("2", "2"));
}

#[test]
fn an_absent_key_is_an_absent_effect() {
    let scene = Scene::from_toml("bare", "[dimensionless]\nbeta = 1\n").unwrap();
    let expected = [Effect::Hold, Effect::Viscous, Effect::Encoder];
    assert_eq!(scene.effects(), expected);
    assert!(scene.given.inertia.is_none() && scene.forces.is_none() && !scene.has_start());
    let scene = rotary("wall", "unilateral = false").unwrap();
    assert_eq!(scene.effects(), [Effect::Hold]);
    assert_eq!(scene.name, "test");
}

#[test]
fn a_text_written_with_escapes_means_the_same() {
    let plain = viscous("9e-6 N·m s/rad");
    let escaped = viscous("9e-6 N\\u00b7m s\\u002frad");
    assert_eq!(plain.value, escaped.value);
    let scene = rotary("device", "viscous = '9e-6 N·m s/rad'").unwrap();
    assert_eq!(scene.given.viscous.unwrap().value, plain.value);
}

#[test]
fn byte_order_marks_and_carriage_returns_change_nothing() {
    let plain = "[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N/mm\"\n";
    let marked = format!("\u{feff}{}", plain.replace('\n', "\r\n"));
    let [plain, marked] = [plain, &marked].map(|text| Scene::from_toml("s", text).unwrap());
    assert_eq!(plain.point(), marked.point());
    let error = Scene::from_toml("s", "\u{feff}[wall]\r\nstiffness = 1\r\n").unwrap_err();
    let bare = error
        .diagnostics()
        .iter()
        .find(|d| d.line() == Some(2))
        .unwrap();
    assert_eq!(
        (bare.column(), bare.kind().name()),
        (Some(13), "missing_unit")
    );
    assert!(!error.render(false).contains(['\r', '?']));
}
