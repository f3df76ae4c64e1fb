//! Units and tolerances as they become exact values of a scene.

use passivity_core::{BigRational, Interval};
use passivity_scene::number::parse;
use passivity_scene::{Given, Motion, Scene, SceneError};

fn number(text: &str) -> BigRational {
    parse(text).unwrap()
}

fn interval(lo: &str, hi: &str) -> Interval<BigRational> {
    Interval::new(number(lo), number(hi)).unwrap()
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
    scene.unwrap_or_else(|e| panic!("{e}")).viscous.unwrap()
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
        assert_eq!(*given.value.range(), interval(lo, hi), "{text}");
        assert_eq!(given.value.pi_power(), 0);
        assert_eq!(given.has_tolerance(), lo != hi, "{text}");
        assert_eq!(given.text, text);
    }
    assert_eq!(
        *viscous("9e-6 N m s/rad ± 10%").nominal.range(),
        interval("9e-6", "9e-6")
    );
}

#[test]
fn a_negative_value_keeps_its_tolerance_the_right_way_round() {
    let scene = rotary("start", "velocity = \"-10 rad/s ± 10%\"").unwrap();
    let velocity = scene.start.unwrap().velocity;
    assert_eq!(*velocity.value.range(), interval("-11", "-9"));
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
        let given = all.iter().find(|g| g.key.ends_with(key)).unwrap();
        assert_eq!(*given.value.range(), interval(value, value), "{line}");
        assert_eq!(given.value.pi_power(), pi, "{line}");
        assert!(scene.involves_pi());
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
        let period = rotary("sampling", line).unwrap().period;
        assert_eq!(*period.value.range(), interval(lo, hi), "{line}");
    }
    let nominal = rotary("sampling", "rate = \"1 kHz ± 20%\"")
        .unwrap()
        .period
        .nominal;
    assert_eq!(*nominal.range(), interval("1e-3", "1e-3"));
}

#[test]
fn counts_give_the_resolution_with_pi() {
    let scene = rotary("encoder", "counts_per_revolution = 8_192").unwrap();
    let resolution = scene.resolution.unwrap();
    assert_eq!(resolution.key, "encoder.counts_per_revolution");
    assert_eq!(resolution.value.pi_power(), 1);
    assert_eq!(*resolution.value.range(), interval("1/4096", "1/4096"));
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
    let arm = rotary("operator", line).unwrap().arm.unwrap();
    assert_eq!(*arm.mass.value.range(), interval("1e-7", "1e-7"));
    assert_eq!(*arm.damping.value.range(), interval("0", "0"));
    assert_eq!(*arm.stiffness.value.range(), interval("2", "2"));
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
    assert_eq!(point.mu, Some(number("50")));
    // 0.6 is three fifths, not the double next to it.
    assert_eq!(point.beta, Some(number("3/5")));
    assert_eq!(
        *scene.coulomb.unwrap().value.range(),
        interval("27/50", "33/50")
    );
    assert!(point.encoder && point.unilateral);
    assert_eq!((point.delay, point.intervals), (2, 7));
    assert_eq!(point.damping, Some(number("1/10")));
    assert_eq!(point.max_force, Some(number("1000")));
    assert_eq!(point.force_step, Some(number("1/4")));
    assert_eq!(point.amplifier, Some(number("1/5")));
    assert_eq!(point.force, Some(vec![number("-1/2")]));
    assert_eq!(point.arm, Some([number("1"), number("2"), number("1/3")]));
    assert_eq!(point.start, [number("-3"), number("10")]);
    assert_eq!(*scene.max_speed.unwrap().value.range(), interval("2", "2"));
}

#[test]
fn an_absent_key_is_an_absent_effect() {
    let scene = Scene::from_toml("bare", "[dimensionless]\nbeta = 1\n").unwrap();
    assert!(scene.coulomb.is_none() && scene.inertia.is_none() && scene.force.is_none());
    assert!(scene.delay.is_none() && !scene.unilateral && scene.start.is_none());
    let scene = rotary("wall", "unilateral = false").unwrap();
    assert!(scene.resolution.is_none() && !scene.unilateral && scene.viscous.is_none());
    assert_eq!(scene.name, "test");
}

#[test]
fn a_text_written_with_escapes_means_the_same() {
    let plain = viscous("9e-6 N·m s/rad");
    let escaped = viscous("9e-6 N\\u00b7m s\\u002frad");
    assert_eq!(plain.value, escaped.value);
    let scene = rotary("device", "viscous = '9e-6 N·m s/rad'").unwrap();
    assert_eq!(scene.viscous.unwrap().value, plain.value);
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
