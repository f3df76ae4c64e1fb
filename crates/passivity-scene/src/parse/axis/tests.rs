//! Axes of a scene without a transmission; those with one are in `tests/files/sides.rs`.

use super::*;
use crate::plane::Plane;

fn scene() -> Scene {
    let text = "[device]\nviscous = \"9 mN m s/rad ± 10%\"\n[sampling]\nrate = \"2 kHz\"\n\
                [encoder]\ncounts_per_revolution = 512\n[wall]\nstiffness = \"2 N m/deg\"\n";
    Scene::from_toml("knob", text).unwrap()
}

#[test]
fn an_axis_has_the_unit_of_the_scene_or_the_one_that_is_typed() {
    let scene = scene();
    let column = |text| Axis::parse(text, &scene).unwrap().column();
    assert_eq!(column("stiffness"), "stiffness [N m/deg]");
    assert_eq!(column("wall.stiffness [N m/rad]"), "stiffness [N m/rad]");
    assert_eq!(column("rate"), "rate [kHz]");
    assert_eq!(column("period"), "period [ms]");
    assert_eq!(column("counts_per_revolution"), "counts_per_revolution");
    assert_eq!(column("coulomb"), "coulomb [N m]");
    assert_eq!(column("arm.damping"), "arm.damping [N m s/rad]");
    let label = |text| Axis::parse(text, &scene).unwrap().label();
    assert_eq!(label("period"), "sampling period T (ms)");
    assert_eq!(label("rate"), "sampling rate 1/T (kHz)");
}

#[test]
fn numbers_of_an_axis_go_to_si_and_back() {
    let scene = scene();
    let period = Axis::parse("period", &scene).unwrap();
    assert_eq!(period.of_scene(&scene).unwrap().lo().to_string(), "1/2");
    let rate = Axis::parse("rate", &scene).unwrap();
    let half = rate.si(&BigRational::new(1.into(), 2.into())).unwrap();
    assert_eq!(half.to_rational().unwrap().to_string(), "1/500");
    assert!(rate.si(&BigRational::zero()).is_none());
    let viscous = Axis::parse("viscous", &scene).unwrap();
    let box_of = viscous.of_scene(&scene).unwrap();
    assert_eq!(box_of.lo().to_string(), "81/10");
    let damping = Axis::parse("damping", &scene).unwrap();
    assert_eq!(damping.of_scene(&scene).unwrap().hi().to_string(), "0");
    // A scene without an arm has no place on an axis that begins above zero.
    assert!(
        Axis::parse("inertia", &scene)
            .unwrap()
            .of_scene(&scene)
            .is_none()
    );
}

#[test]
fn counts_are_the_same_whether_the_scene_gives_counts_or_a_resolution() {
    let counts = scene();
    let text = "[sampling]\nrate = \"2 kHz\"\n[encoder]\nresolution = \"0.1 deg\"\n[wall]\n\
                stiffness = \"2 N m/deg\"\n";
    let resolution = Scene::from_toml("knob", text).unwrap();
    let si = [&counts, &resolution].map(|scene| {
        let axis = Axis::parse("counts_per_revolution", scene).unwrap();
        axis.si(&axis.number("512").unwrap()).unwrap()
    });
    assert_eq!(si[0], si[1]);
    assert_eq!(si[0], counts.given.resolution.unwrap().nominal);
}

/// What an error lists, after `one of`.
fn listed(error: &AxisError) -> Vec<String> {
    let message = error.to_string();
    let (_, names) = message.split_once("one of ").expect("a list");
    names.split(", ").map(str::to_owned).collect()
}

#[test]
fn a_name_that_is_none_is_told_those_that_work_in_this_scene() {
    const LINEAR: &str = "[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"1 N/mm\"\n[controller]\n\
                          numerator = [\"1.5\", \"-0.5\"]\n";
    const PLAIN: &str = "[dimensionless]\nbeta = \"1/2\"\nsigma = \"1/2\"\n";
    let read = |text| Scene::from_toml("scene", text).unwrap();
    let no_speed: Refusal = |p| (p == Parameter::MaxSpeed).then_some("has no part in the motion");
    for scene in [scene(), read(LINEAR), read(PLAIN)] {
        for refusal in [no_speed, Plane::refusal] {
            let names = listed(&Axis::parse_for("foo", &scene, refusal).unwrap_err());
            assert!(names.len() > 5, "{names:?}");
            for name in &names {
                let axis = Axis::parse_for(name, &scene, refusal).unwrap();
                Axis::parse_for(&axis.column(), &scene, refusal).unwrap();
                assert_eq!(Axis::fit(std::slice::from_ref(&axis), &scene), Ok(()));
            }
        }
    }
    // On a plane beside another one, each is an axis.
    let scene = scene();
    let axis = |name: &str| Axis::parse(name, &scene).unwrap();
    for name in listed(&Axis::parse_for("foo", &scene, Plane::refusal).unwrap_err()) {
        let other = if name == "stiffness" {
            "viscous"
        } else {
            "stiffness"
        };
        let plane = Plane::new(&scene, [axis(&name), axis(other)]);
        assert!(plane.is_ok(), "{name}");
    }
    let error = Axis::parse_for("mu", &scene, Plane::refusal).unwrap_err();
    let names = listed(&error);
    assert!(
        error
            .to_string()
            .starts_with("`mu` has no part in the criterion")
    );
    assert!(
        !names
            .iter()
            .any(|name| name == "inertia" || name == "damping_cutoff")
    );
}

#[test]
fn what_is_no_axis_is_said() {
    let scene = scene();
    let error = |text| Axis::parse(text, &scene).unwrap_err().to_string();
    assert!(
        error("stifness")
            .starts_with("`stifness`: expected a parameter: one of stiffness, period, rate")
    );
    assert_eq!(
        error("stiffness [N m/rad"),
        "`stiffness [N m/rad`: the unit needs its closing `]`"
    );
    assert_eq!(
        error("stiffness [N foo]"),
        "`stiffness [N foo]`: unknown unit `foo`"
    );
    assert_eq!(
        error("stiffness [N/mm]"),
        "`stiffness [N/mm]`: the unit is that of a linear stiffness, expected a torsional \
         stiffness such as `\"2 N m/rad\"`"
    );
    assert_eq!(
        error("mass [kg]"),
        "`mass [kg]`: `knob` is rotary: expected `inertia`"
    );
    assert_eq!(
        error("beta"),
        "`beta`: `knob` has units: expected `viscous`"
    );
    assert_eq!(
        error("counts_per_revolution [rad]"),
        "`counts_per_revolution [rad]`: expected a plain number, found the unit `rad`"
    );
    let counts = Axis::parse("counts_per_revolution", &scene).unwrap();
    assert_eq!(
        counts.number("1.5").unwrap_err().to_string(),
        "`counts_per_revolution` = `1.5`: expected a whole number"
    );
    let period = Axis::parse("period", &scene).unwrap();
    assert_eq!(
        period.number("0").unwrap_err().to_string(),
        "`period` = `0`: expected a value above zero"
    );
    let plain = "[dimensionless]\nbeta = \"1/2\"\nsigma = \"1/2\"\n";
    let plain = Scene::from_toml("corner", plain).unwrap();
    assert_eq!(
        Axis::parse("beta", &plain).unwrap().label(),
        "viscous friction β"
    );
    assert_eq!(
        Axis::parse("stiffness", &plain).unwrap_err().to_string(),
        "`stiffness`: it is 1 in `corner`, a dimensionless scene"
    );
}
