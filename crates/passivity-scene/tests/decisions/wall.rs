//! Scenes of a wall in a line each.

use passivity_core::BigRational;
use passivity_scene::Scene;
use passivity_scene::check::{Report, check};
use passivity_scene::number::parse;

/// Keys with their section and unit.
const KEYS: [(&str, &str, &str); 19] = [
    ("inertia", "device", "kg"),
    ("viscous", "device", "N s/m"),
    ("coulomb", "device", "N"),
    ("period", "sampling", "s"),
    ("delay", "sampling", ""),
    ("latency", "sampling", "s"),
    ("resolution", "encoder", "m"),
    ("stiffness", "wall", "N/m"),
    ("damping", "wall", "N s/m"),
    ("damping_time_constant", "wall", "s"),
    ("force_step", "wall", "N"),
    ("max_force", "wall", "N"),
    ("time_constant", "amplifier", "s"),
    ("max_speed", "operator", "m/s"),
    ("unilateral", "wall", ""),
    ("position", "start", "m"),
    ("velocity", "start", "m/s"),
    ("numerator", "controller", ""),
    ("denominator", "controller", ""),
];

/// A scene with these values, as in `viscous 3/4, delay 1`; `smooth` is one without an encoder.
pub(crate) fn scene(values: &str) -> Scene {
    let mut text = String::new();
    let ones = ["period 1", "resolution 1", "stiffness 1"];
    let mut given: Vec<&str> = values.split(", ").collect();
    let is_smooth = given.contains(&"smooth");
    given.retain(|value| *value != "smooth");
    let is_given = |one: &str| {
        given
            .iter()
            .any(|value| value.split(' ').next() == one.split(' ').next())
    };
    let ones = ones.into_iter().filter(|one| !is_given(one));
    let ones = ones.filter(|one| !(is_smooth && one.starts_with("resolution")));
    for value in given.iter().copied().chain(ones) {
        let (key, value) = value.split_once(' ').unwrap();
        let (_, section, unit) = KEYS.iter().find(|(k, ..)| *k == key).unwrap();
        text += &match *unit {
            "" => format!("{section}.{key} = {value}\n"),
            unit => format!("{section}.{key} = \"{value} {unit}\"\n"),
        };
    }
    Scene::from_toml("test", &text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// What is said of such a scene.
pub(crate) fn report(values: &str) -> Report {
    check(&scene(values))
}

pub(crate) fn q(text: &str) -> BigRational {
    parse(text).unwrap()
}
