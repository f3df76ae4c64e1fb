//! Values as data sheets print them, and quantities at the motor's side of a transmission.

use passivity_core::{Parameter, Scalar as _};
use passivity_scene::check::{Verdict, check};
use passivity_scene::number::parse;
use passivity_scene::{Motion, Scene, SceneError};

/// A device on a wall; `device` and `encoder` are what stands in these sections.
fn scene(device: &str, encoder: &str, stiffness: &str) -> Result<Scene, SceneError> {
    let text = format!(
        "[device]\n{device}\n[sampling]\nrate = \"1 kHz\"\n{encoder}\n[wall]\n{stiffness}\n"
    );
    Scene::from_toml("sheet", &text)
}

fn rotary(device: &str) -> Result<Scene, SceneError> {
    scene(device, "", "stiffness = \"1 N m/rad\"")
}

fn first_error(result: Result<Scene, SceneError>) -> String {
    let error = result.expect_err("the scene has a mistake");
    let first = &error.diagnostics()[0];
    format!("{}: {}", first.kind().name(), first.message())
}

/// The ends of a parameter as rationals; it must have no π.
fn ends(scene: &Scene, parameter: Parameter) -> [String; 2] {
    let value = &scene.given.get(parameter).expect("it is given").value;
    [value.lo(), value.hi()].map(|x| x.to_rational().expect("no π").to_string())
}

#[test]
fn torques_are_read_in_every_spelling_of_a_data_sheet() {
    // 1 oz·in of weight: 28.349523125 g · 9.80665 m/s² · 25.4 mm, exactly.
    let ounce_inch =
        parse("0.028349523125").unwrap() * parse("9.80665").unwrap() * parse("0.0254").unwrap();
    let ounce_inch = ounce_inch.to_string();
    for (text, expected) in [
        ("2 N.m", "2"),
        ("2 N-m", "2"),
        ("2 N·m", "2"),
        ("2 Nm", "2"),
        ("2 mNm", "1/500"),
        ("2 mN m", "1/500"),
        ("2 Ncm", "1/50"),
        ("1 oz in", &ounce_inch),
        ("1 oz-in", &ounce_inch),
        ("1 oz·in", &ounce_inch),
        ("1 ozf in", &ounce_inch),
        ("1 kg-cm", "1961330000000000000/20000000000000000000"),
        ("1 gf cm", "980665/10000000000"),
    ] {
        let scene = rotary(&format!("coulomb = \"{text}\"")).unwrap_or_else(|e| panic!("{e}"));
        let expected = parse(expected).unwrap().to_string();
        assert_eq!(
            ends(&scene, Parameter::Coulomb),
            [expected.clone(), expected],
            "{text}"
        );
    }
}

#[test]
fn masses_taken_as_weights_are_said() {
    let in_ounces = rotary("coulomb = \"28 oz-in\"").unwrap();
    let remark = "device.coulomb: the mass in `oz-in` is taken as its weight at standard gravity";
    assert_eq!(in_ounces.remarks(), [remark]);
    assert!(check(&in_ounces).to_text().contains("taken as its weight"));
    // A bare mass may be a slip of the key.
    let error = first_error(pushed("coulomb = \"25 g\""));
    assert_eq!(
        error,
        "wrong_unit: `device.coulomb` has the unit `g` of a mass"
    );
    // A stiffness in pounds per inch and an inertia in oz·in·s² are weights as well.
    let springs = scene("", "", "stiffness = \"1 lb/in\"").unwrap();
    let expected =
        parse("0.45359237").unwrap() * parse("9.80665").unwrap() / parse("0.0254").unwrap();
    assert_eq!(springs.motion, Motion::Linear);
    assert_eq!(
        ends(&springs, Parameter::Stiffness)[0],
        expected.to_string()
    );
    let rotor = rotary("inertia = \"1 oz-in-s^2\"").unwrap();
    assert_eq!(rotor.motion, Motion::Rotary);
}

fn pushed(device: &str) -> Result<Scene, SceneError> {
    scene(device, "", "stiffness = \"1 N/mm\"")
}

#[test]
fn a_tolerance_may_stand_in_parentheses() {
    for text in [
        "0.5 N (±10 %)",
        "0.5 N (± 10%)",
        "0.5 N ± 10%",
        "0.5 (±10%) N",
    ] {
        let scene = pushed(&format!("coulomb = \"{text}\""));
        match scene {
            Ok(scene) => assert_eq!(
                ends(&scene, Parameter::Coulomb),
                ["9/20", "11/20"],
                "{text}"
            ),
            Err(_) => assert_eq!(text, "0.5 (±10%) N"),
        }
    }
    let error = first_error(pushed("coulomb = \"0.5 N (±10 %\""));
    assert_eq!(
        error,
        "malformed_tolerance: the parenthesis before the tolerance is not closed"
    );
}

#[test]
fn a_range_is_its_ends() {
    for text in [
        "4 … 6 mN m",
        "4...6 mN m",
        "4 .. 6 mN m",
        "4 – 6 mN m",
        "4-6 mN m",
        "4 - 6 mN m",
        "4 to 6 mN m",
        "4 mN m … 6 mN m",
        "0.4 cN m to 6 mN m",
    ] {
        let scene = rotary(&format!("coulomb = \"{text}\"")).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(
            ends(&scene, Parameter::Coulomb),
            ["1/250", "3/500"],
            "{text}"
        );
        let nominal = scene.given.coulomb.unwrap().nominal;
        assert_eq!(nominal.to_rational().unwrap().to_string(), "1/200");
    }
    let error = first_error(rotary("coulomb = \"6 … 4 mN m\""));
    assert_eq!(
        error,
        "malformed_tolerance: the range ends below its beginning"
    );
    let error = rotary("coulomb = \"6 … 4 mN m\"").unwrap_err().to_string();
    assert!(
        error.contains("or a range with the smaller number first, such as `2 … 5`"),
        "{error}"
    );
    let error = first_error(rotary("coulomb = \"4 mN m … 6 N\""));
    assert!(
        error.starts_with("malformed_tolerance: the two ends"),
        "{error}"
    );
    // A power is no range.
    assert!(rotary("viscous = \"1e-4 N m s rad^-1\"").is_ok());
}

#[test]
fn a_bound_is_used_where_it_is_safe() {
    // At most: the friction may be anything down to none.
    let scene = pushed("coulomb = \"<0.05 N\"").unwrap();
    assert_eq!(ends(&scene, Parameter::Coulomb), ["0", "1/20"]);
    let remark = "device.coulomb: given as at most 0.05 N, taken as anything from there to 0 N";
    assert_eq!(scene.remarks(), [remark]);
    // At least: the verdict rests on the bound, and *not passive* is not said.
    let with = |viscous: &str, coulomb: &str| {
        let device = format!("viscous = \"{viscous}\"\ncoulomb = \"{coulomb}\"");
        let encoder = "[encoder]\nresolution = \"0.1 mm\"";
        check(&linear(&device, encoder))
    };
    assert_eq!(with("> 0.5 N s/m", "min. 0.05 N").verdict, Verdict::Passive);
    assert_eq!(with("0.5 N s/m", "≥ 0.04 N").verdict, Verdict::Depends);
    assert_eq!(with("0.5 N s/m", "0.04 N").verdict, Verdict::NotPassive);
    // A bound of an inertia is safe on no side.
    let error = first_error(pushed("mass = \"<75 g\""));
    assert_eq!(
        error,
        "out_of_bounds: `device.mass` is given as a bound on one side"
    );
    let error = first_error(pushed("coulomb = \"<0.05 N ± 10%\""));
    assert_eq!(
        error,
        "malformed_tolerance: a value that is a bound has no tolerance and no other end"
    );
    // The bound on the speed is a bound already.
    let text = "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N/m\"\n[operator]\n\
                max_speed = \"≤ 0.2 m/s\"\n";
    let scene = Scene::from_toml("bound", text).unwrap();
    assert_eq!(ends(&scene, Parameter::MaxSpeed), ["1/5", "1/5"]);
}

fn linear(device: &str, encoder: &str) -> Scene {
    scene(device, encoder, "stiffness = \"1 N/mm\"").unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn counts_are_read_in_words() {
    let resolution = |text: &str| {
        let encoder = format!("[encoder]\ncounts_per_revolution = {text}");
        scene("", &encoder, "stiffness = \"1 N m/rad\"")
    };
    for text in [
        "\"8192 cpr\"",
        "\"8192 CPR\"",
        "\"13 bit\"",
        "\"13-bit\"",
        "\"8192 counts/rev\"",
        "8192",
    ] {
        let value = resolution(text).unwrap_or_else(|e| panic!("{e}"));
        let plain = resolution("8192").unwrap();
        assert_eq!(
            value.given.resolution.unwrap().value,
            plain.given.resolution.unwrap().value,
            "{text}"
        );
    }
    let error = resolution("\"500 ppr\"").unwrap_err();
    assert_eq!(
        error.diagnostics()[0].message(),
        "lines or pulses of a disc are not the counts that a decoder makes"
    );
    assert!(
        error
            .render(false)
            .contains("with quadrature decoding 500 ppr is `2000`")
    );
}

/// A paddle by its motor, and the same by hand at the paddle.
const BY_MOTOR: &str = r#"
    [device]
    inertia = "1e-3 kg m^2"
    [transmission]
    ratio = "15:1"
    [motor]
    inertia = "1e-6 kg m^2"
    viscous = "4e-5 N m s/rad ± 10%"
    coulomb = "0.0010 … 0.0012 N m"
    max_torque = "0.1 N m"
    torque_step = "0.1 mN m"
    [sampling]
    period = "350 us"
    [encoder]
    counts_per_revolution = 400
    side = "motor"
    [wall]
    stiffness = "20 N m/rad"
"#;

const BY_HAND: &str = r#"
    [device]
    inertia = "0.001225 kg m^2"
    viscous = "0.009 N m s/rad ± 10%"
    coulomb = "0.0150 … 0.0180 N m"
    [sampling]
    period = "350 us"
    [encoder]
    counts_per_revolution = 6000
    [wall]
    stiffness = "20 N m/rad"
    max_force = "1.5 N m"
    force_step = "1.5 mN m"
"#;

#[test]
fn values_at_the_motor_are_those_at_the_device() {
    let [motor, hand] = [BY_MOTOR, BY_HAND].map(|text| Scene::from_toml("paddle", text).unwrap());
    assert_eq!(motor.bounds(), hand.bounds());
    let [of_motor, of_hand] = [&motor, &hand].map(check);
    assert_eq!(of_motor.verdict, of_hand.verdict);
    assert_eq!(of_motor.spare, of_hand.spare);
    assert_eq!(of_motor.mu, of_hand.mu);
    for (of_motor, of_hand) in of_motor.limits.iter().zip(&of_hand.limits) {
        assert_eq!(of_motor.border, of_hand.border);
    }
    let remark = "transmission: torques at the motor × 15, inertia and viscous friction × 225, \
                  positions ÷ 15; it is taken to be rigid and without backlash";
    assert_eq!(of_motor.remarks, [remark]);
    assert!(
        of_motor.to_text().contains(" N m at the motor (now "),
        "{}",
        of_motor.to_text()
    );
}

#[test]
fn a_limit_at_the_motor_typed_back_is_passive() {
    let scene = Scene::from_toml("paddle", BY_MOTOR).unwrap();
    let limits = check(&scene).limits;
    let mut tried = 0;
    for (parameter, line) in [
        (Parameter::Viscous, "viscous = \"4e-5 N m s/rad ± 10%\""),
        (Parameter::Coulomb, "coulomb = \"0.0010 … 0.0012 N m\""),
    ] {
        let limit = limits.iter().find(|limit| limit.parameter == parameter);
        let typed = limit.and_then(|limit| limit.typed.clone());
        let Some(typed) = typed else { continue };
        let key = line.split(' ').next().unwrap();
        let unit = ["N m s/rad", "N m"][usize::from(parameter == Parameter::Coulomb)];
        let text = BY_MOTOR.replace(line, &format!("{key} = \"{typed} {unit}\""));
        let moved = Scene::from_toml("moved", &text).unwrap();
        let fixed = check(&moved).limits;
        let same = fixed
            .iter()
            .find(|limit| limit.parameter == parameter)
            .unwrap();
        assert!(same.suffices, "{line}");
        // The value itself meets its own limit.
        let value = &moved.given.get(parameter).unwrap().value;
        let value = value.lo().to_rational().unwrap();
        assert!(value >= *same.border.hi(), "{line}");
        tried += 1;
    }
    assert_eq!(tried, 2);
}

#[test]
fn pulleys_and_handles_make_the_ratio() {
    let ratio = |keys: &str| {
        let text = format!(
            "[transmission]\n{keys}\n[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 {}\"\n",
            if keys.contains("handle") || keys.contains("/") || !keys.contains("output") {
                "N/mm"
            } else {
                "N m/rad"
            }
        );
        Scene::from_toml("pulleys", &text)
    };
    let value = |keys: &str| {
        let scene = ratio(keys).unwrap_or_else(|e| panic!("{e}"));
        scene.transmission.expect("it is given").ratio
    };
    let plain = |keys: &str| value(keys).to_rational().unwrap().to_string();
    assert_eq!(
        plain("motor_pulley = \"5 mm\"\noutput_pulley = \"75 mm\""),
        "15"
    );
    assert_eq!(plain("motor_pulley = \"10 mm\""), "100");
    assert_eq!(
        plain("motor_pulley = \"5 mm\"\noutput_pulley = \"75 mm\"\nhandle_radius = \"50 mm\""),
        "300"
    );
    assert_eq!(plain("ratio = \"90 rad/m\""), "90");
    // 10 mm of a cable a turn is 2π/0.01 rad/m.
    let screw = value("ratio = \"10 mm/rev\"");
    assert_eq!(
        screw
            .over(passivity_core::pi::pi())
            .to_rational()
            .unwrap()
            .to_string(),
        "200"
    );
    for (keys, expected) in [
        (
            "ratio = \"15 ± 1\"",
            "out_of_bounds: a transmission is exact: it has no tolerance",
        ),
        (
            "ratio = \"-15\"",
            "out_of_bounds: `transmission.ratio` cannot be `-15`",
        ),
        (
            "ratio = \"15 N\"",
            "out_of_bounds: `transmission.ratio` is neither a plain ratio nor an angle per length",
        ),
        (
            "output_pulley = \"75 mm\"",
            "missing_key: [transmission] has no `ratio`, or `motor_pulley` with `output_pulley`",
        ),
        (
            "ratio = 3\nmotor_pulley = \"5 mm\"",
            "conflicting_keys: `ratio` and the radii of pulleys cannot both be given",
        ),
    ] {
        assert_eq!(first_error(ratio(keys)), expected);
    }
}

#[test]
fn a_motor_needs_its_transmission_and_friction_one_side() {
    let wall = "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N m/rad\"\n";
    let error = |text: &str| first_error(Scene::from_toml("bad", &format!("{text}{wall}")));
    assert_eq!(
        error("[motor]\nviscous = \"1e-5 N m s/rad\"\n"),
        "missing_key: [motor] needs a [transmission] that says how the motor drives the device"
    );
    assert_eq!(
        error("[encoder]\nresolution = \"0.1 deg\"\nside = \"motor\"\n"),
        "missing_key: an encoder on the motor needs a [transmission]"
    );
    assert_eq!(
        error(
            "[device]\ncoulomb = \"1 mN m\"\n[transmission]\nratio = 3\n[motor]\ncoulomb = \"1 mN m\"\n"
        ),
        "conflicting_keys: `motor.coulomb` and `device.coulomb` cannot both be given"
    );
    assert_eq!(
        error("[transmission]\nratio = 3\n[motor]\ncoulomb = \"1 N\"\n"),
        "wrong_unit: `motor.coulomb` has the unit `N` of a force"
    );
}
