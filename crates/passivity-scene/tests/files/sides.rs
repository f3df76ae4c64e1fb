//! Axes at the two sides of a transmission: a number on an axis is the scene with that number typed in under
//! the axis's own key.

use passivity_core::{BigRational, Parameter, Truth};
use passivity_scene::check::{Verdict, check};
use passivity_scene::plane::{Plane, Speeds};
use passivity_scene::{Axis, Scene};

/// The keys and values of a scene.
type Entries = Vec<(String, String)>;

/// A transmission, and what is given at which side of it.
const SCENES: [(&str, &str); 6] = [
    (
        "all at the motor",
        "transmission.ratio = 12:1\nmotor.inertia = 1e-6 kg m^2\nmotor.viscous = 4e-5 N m s/rad\n\
         motor.coulomb = 0.0010 … 0.0012 N.m\nmotor.torque_step = 0.1 mN m\nmotor.max_torque = 0.1 N m\n\
         encoder.counts_per_revolution = 4000\nencoder.side = motor\nwall.stiffness = 0.2 N m/deg\n",
    ),
    (
        "all at the device",
        "transmission.ratio = 12\ndevice.inertia = 1e-3 kg m^2\ndevice.viscous = 5e-3 N m s/rad ± 10%\n\
         device.coulomb = 12 mN m\nwall.force_step = 1 mN m\nencoder.counts_per_revolution = 48000\n\
         wall.stiffness = 20 N m/rad\n",
    ),
    (
        "some at each",
        "transmission.motor_pulley = 6 mm\ntransmission.output_pulley = 72 mm\ndevice.inertia = 1e-3 kg m^2\n\
         motor.inertia = 1e-6 kg m^2\ndevice.viscous = 5e-3 N m s/rad\nmotor.coulomb = 0.2 oz in\n\
         encoder.resolution = 0.09 deg\nencoder.side = motor\nwall.stiffness = 20 N m/rad\n",
    ),
    (
        "a capstan",
        "transmission.motor_pulley = 5 mm\ndevice.mass = 80 g\nmotor.inertia = 3 g cm^2\n\
         motor.viscous = 3e-6 N m s/rad\nmotor.coulomb = 2 mN m\nencoder.counts_per_revolution = 4096\n\
         encoder.side = motor\nwall.stiffness = 0.5 N/mm\n",
    ),
    (
        "a handle",
        "transmission.ratio = 10:1\ntransmission.handle_radius = 70 mm\nmotor.inertia = 1e-6 kg m^2\n\
         device.viscous = 0.5 N s/m\ndevice.coulomb = 0.04 N\nencoder.resolution = 0.03 mm\n\
         wall.stiffness = 0.2 N/mm\n",
    ),
    (
        "nothing given",
        "transmission.ratio = 12:1\nwall.stiffness = 1 N m/rad\n",
    ),
];

fn entries(text: &str) -> Entries {
    let always = "sampling.period = 350 us\noperator.max_speed = ";
    let speed = if text.contains("N/mm") {
        "40 mm/s"
    } else {
        "1 rad/s"
    };
    let text = format!("{text}{always}{speed}");
    let split = |line: &str| {
        let (key, value) = line.split_once(" = ").unwrap();
        (key.to_owned(), value.to_owned())
    };
    text.lines().map(split).collect()
}

fn scene(entries: &Entries) -> Scene {
    let line = |(key, value): &(String, String)| format!("{key} = \"{value}\"\n");
    let text: String = entries.iter().map(line).collect();
    Scene::from_toml("device", &text)
        .unwrap_or_else(|error| panic!("{}\n{text}", error.render(false)))
}

/// The scene with a number typed in under the key of an axis, in place of what has no place beside it.
fn typed(entries: &Entries, axis: &Axis, number: &str) -> Scene {
    let row = axis.parameter().row();
    let unit = axis.unit();
    let at_motor = unit.ends_with("at the motor");
    let unit = unit
        .trim_end_matches("at the motor")
        .trim_end_matches("at the device")
        .trim();
    let of_parameter = |key: &str| row.key == key || row.other_keys.contains(&key);
    // The inertia is the sum of both sides.
    let stays =
        |key: &str| axis.parameter() == Parameter::Inertia && key.starts_with("motor.") != at_motor;
    let mut entries = entries.clone();
    entries.retain(|(key, _)| !of_parameter(key) || stays(key));
    if axis.parameter() == Parameter::Resolution {
        let side = if at_motor { "motor" } else { "device" };
        entries.retain(|(key, _)| key != "encoder.side");
        entries.push(("encoder.side".to_owned(), side.to_owned()));
    }
    entries.push((
        axis.key().to_owned(),
        format!("{number} {unit}").trim().to_owned(),
    ));
    scene(&entries)
}

/// Names of axes with numbers; those that a scene cannot have are refused.
const AXES: [(&str, [&str; 3]); 24] = [
    ("coulomb", ["0", "0.001", "0.9"]),
    ("coulomb [mN m]", ["0", "1", "20"]),
    ("coulomb [oz in]", ["0", "1", "20"]),
    ("coulomb [N m at the motor]", ["0", "0.001", "0.9"]),
    ("coulomb [N.m at the device]", ["0", "0.015", "2"]),
    ("coulomb [N at the device]", ["0", "0.015", "2"]),
    ("motor.coulomb [mN m]", ["0", "1", "20"]),
    ("device.coulomb", ["0", "0.001", "3"]),
    ("viscous", ["0", "1e-5", "1e-2"]),
    ("viscous [N m s/deg]", ["0", "1e-6", "1e-3"]),
    ("viscous [N m s/rad at the device]", ["0", "1e-4", "1e-2"]),
    ("counts_per_revolution", ["64", "4000", "1000000"]),
    (
        "counts_per_revolution [at the motor]",
        ["64", "4000", "1000000"],
    ),
    (
        "counts_per_revolution [at the device]",
        ["64", "4000", "1000000"],
    ),
    ("resolution", ["0.00001", "0.001", "0.1"]),
    ("resolution [deg at the motor]", ["0.0001", "0.01", "1"]),
    ("resolution [um at the device]", ["0.1", "10", "1000"]),
    ("force_step", ["0.0001", "0.01", "1"]),
    ("torque_step [mN m]", ["0.01", "0.1", "10"]),
    ("max_force", ["0.0001", "0.01", "1"]),
    ("inertia", ["1e-6", "1e-3", "1"]),
    ("inertia [kg m^2 at the motor]", ["1e-6", "1e-3", "1"]),
    ("mass [g]", ["1", "10", "100"]),
    ("rate [kHz]", ["0.1", "1", "20"]),
];

#[test]
fn a_number_on_an_axis_is_the_scene_with_it_typed_in() {
    for (name, text) in SCENES {
        let entries = entries(text);
        let given = scene(&entries);
        let limits = check(&given).limits;
        let stiffness = Axis::parse("stiffness", &given).unwrap();
        let now = stiffness.of_scene(&given).unwrap();
        let mut read = 0;
        for (axis, numbers) in AXES {
            let Ok(axis) = Axis::parse(axis, &given) else {
                continue;
            };
            read += 1;
            let column = axis.column();
            let again =
                Axis::parse(&column, &given).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert_eq!(again.column(), column, "{name}");
            let plane = Plane::new(&given, [axis.clone(), stiffness.clone()]).ok();
            for text in numbers {
                let about = format!("{name}: {column} = {text}");
                let number = axis.number(text).unwrap();
                let typed = typed(&entries, &axis, text);
                let value = typed.given.get(axis.parameter()).unwrap();
                assert_eq!(axis.si(&number), Some(value.nominal.clone()), "{about}");
                assert_eq!(again.si(&number), axis.si(&number), "{about}");
                let place = axis.of_scene(&typed).unwrap();
                assert!(*place.lo() <= number && number <= *place.hi(), "{about}");
                let Some(plane) = &plane else { continue };
                let holds = |speeds| {
                    let at: [&BigRational; 2] = [&number, now.lo()];
                    plane.holds(at, speeds) == Some(Truth::Holds)
                };
                let report = check(&typed);
                assert_eq!(holds(Speeds::Every), report.at_every_speed, "{about}");
                let passive = report.verdict == Verdict::Passive;
                assert_eq!(holds(Speeds::UpToBound), passive, "{about}");
            }
            // A name alone is what `check` says its limits of.
            let limit = limits
                .iter()
                .find(|limit| limit.parameter == axis.parameter());
            let is_given = given.given.get(axis.parameter()).is_some();
            let alone = Axis::parse(axis.name(), &given);
            if let (Some(limit), Ok(alone), true) = (limit, alone, is_given) {
                let at_motor = |unit: String| unit.ends_with("at the motor");
                assert_eq!(
                    at_motor(alone.unit()),
                    at_motor(limit.written.unit()),
                    "{name}: {column}"
                );
            }
        }
        assert!(read >= 14, "{name}: {read}");
    }
}

#[test]
fn a_unit_without_a_side_is_at_the_side_of_the_scene() {
    let [motor, device, each, capstan, handle, none] =
        SCENES.map(|(_, text)| scene(&entries(text)));
    for (name, scene, column) in [
        ("coulomb", &motor, "coulomb [N.m at the motor]"),
        ("coulomb [mN m]", &motor, "coulomb [mN m at the motor]"),
        (
            "coulomb [mN m at the  device ]",
            &motor,
            "coulomb [mN m at the device]",
        ),
        ("device.coulomb", &motor, "coulomb [N m at the device]"),
        ("force_step [N m]", &motor, "torque_step [N m at the motor]"),
        (
            "counts_per_revolution",
            &motor,
            "counts_per_revolution [at the motor]",
        ),
        ("resolution", &motor, "resolution [rad at the motor]"),
        ("coulomb [mN m]", &device, "coulomb [mN m]"),
        ("counts_per_revolution", &device, "counts_per_revolution"),
        ("motor.coulomb", &device, "coulomb [N m at the motor]"),
        ("inertia", &each, "inertia [kg m^2 at the device]"),
        (
            "inertia [g cm^2 at the motor]",
            &each,
            "inertia [g cm^2 at the motor]",
        ),
        ("coulomb", &each, "coulomb [oz in at the motor]"),
        ("mass", &capstan, "mass [g at the device]"),
        (
            "counts_per_revolution",
            &capstan,
            "counts_per_revolution [at the motor]",
        ),
        ("coulomb", &handle, "coulomb [N]"),
        ("coulomb", &none, "coulomb [N m]"),
    ] {
        let axis = Axis::parse(name, scene).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(axis.column(), column, "{name}");
    }
    let error = |name, scene| Axis::parse(name, scene).unwrap_err().to_string();
    assert_eq!(
        error("coulomb [N]", &capstan),
        "`coulomb [N]`: the unit is that of a force, expected a torque such as `\"2e-3 N m\"` at the motor; for \
         a value at the other side write `N at the device`"
    );
    // The wall has no side.
    assert_eq!(
        error("stiffness [N m/rad]", &capstan),
        "`stiffness [N m/rad]`: the unit is that of a torsional stiffness, expected a linear stiffness such as \
         `\"1 N/mm\"`"
    );
    assert_eq!(
        error("coulomb [mN m at motor]", &motor),
        "`coulomb [mN m at motor]`: expected `at the motor` or `at the device` behind the unit, found `at motor`"
    );
    assert_eq!(
        error("motor.coulomb [mN m at the device]", &motor),
        "`motor.coulomb [mN m at the device]`: `motor.coulomb` is at the motor: expected no side, or `at the motor`"
    );
    assert_eq!(
        error("rate [kHz at the motor]", &motor),
        "`rate [kHz at the motor]`: no scene gives it at the motor: expected the unit alone"
    );
    assert_eq!(
        error("counts_per_revolution", &handle),
        "`counts_per_revolution`: `device` is linear: expected `resolution`, or `counts_per_revolution [at the motor]`"
    );
    let plain = "[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"1 N m/rad\"\n";
    assert_eq!(
        error(
            "coulomb [mN m at the motor]",
            &Scene::from_toml("plain", plain).unwrap()
        ),
        "`coulomb [mN m at the motor]`: `plain` has no [transmission], so no value of it is at the motor"
    );
}
