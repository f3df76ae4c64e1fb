//! What `explain` says of several joints, and the keys in the JSON of `check`.

use passivity_core::Effect;
use passivity_scene::joints::{JointExplanation, explain};

use super::{MATRIX, report, scene};

/// k = 5 N m/rad along (1, ½) with Δ = 0.1 rad, where joint 1 needs 0.375 N m and joint 2 half of it.
fn explained(first: &str, second: &str) -> JointExplanation {
    let joint = |coulomb: &str, encoder: &str| {
        format!(
            "[[joint]]\nviscous = \"5 N m s/rad\"\ncoulomb = \"{coulomb} N m\"\nencoder = {{ {encoder} }}\n"
        )
    };
    let joints = ["resolution = \"0.1 rad\"", "resolution = \"100 mrad\""];
    let joints = joint(first, joints[0]) + &joint(second, joints[1]);
    explain(&scene(&format!(
        "{joints}[sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"5 N m/rad\"\ndirection = [\"1\", \"0.5\"]\n"
    )))
}

#[test]
fn what_coulomb_friction_is_compared_with_is_true() {
    let depends = "against 0.1875: it depends on the tolerances";
    for (first, second, expected) in [
        ("0.375", "0.2", ["0.375 ≥ 0.375", "0.2 ≥ 0.1875"]),
        ("0.1", "0.15", ["0.1 < 0.375", "0.15 < 0.1875"]),
        (
            "0.1 … 0.3",
            "0.3 ± 50%",
            ["0.1 … 0.3 < 0.375", &format!("0.15 … 0.45 {depends}")],
        ),
    ] {
        let explained = explained(first, second);
        let of_joints = explained
            .lines
            .iter()
            .filter(|line| line.formula.starts_with("c ≥"));
        let numbers: Vec<&str> = of_joints.map(|line| line.numbers.as_str()).collect();
        assert_eq!(numbers, expected);
        let text = explained.to_text();
        let shown = expected
            .iter()
            .all(|numbers| text.contains(&format!(" {numbers}\n")));
        assert!(shown, "{text}");
    }
}

/// As of one joint, what is not in the scene is listed.
#[test]
fn effects_left_out_are_named() {
    let explained = explained("1", "1");
    let json = serde_json::to_value(&explained).unwrap();
    let names = |key: &str| {
        let names = json[key].as_array().unwrap().iter();
        names.map(|name| name.as_str().unwrap()).collect::<Vec<_>>()
    };
    let (effects, absent) = (names("effects"), names("absent"));
    let present = ["zero_order_hold", "viscous", "coulomb", "encoder"];
    assert_eq!(effects, present);
    let mut all = Effect::ALL.map(Effect::name).to_vec();
    all.retain(|name| !effects.contains(name));
    assert_eq!(absent, all);
    let text = explained.to_text();
    let (_, left_out) = text
        .split_once("Not in this scene, and not computed\n")
        .unwrap();
    let (left_out, _) = left_out.split_once("\nVerdict\n").unwrap();
    for word in ["a wall on one side only", "delay of whole samples"] {
        assert!(left_out.contains(word), "{left_out}");
    }
    assert!(!left_out.contains("friction"), "{left_out}");
}

/// A key is two spaces before its value, however long it is.
#[test]
fn keys_end_before_values() {
    let short = explained("1", "1").to_text();
    assert!(
        short.contains("  joint[1].coulomb                1 N m\n"),
        "{short}"
    );
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/joints/planar-arm.toml"
    );
    let text = explain(&scene(&std::fs::read_to_string(path).unwrap())).to_text();
    let key = "joint[1].encoder.counts_per_revolution";
    assert!(text.contains(&format!("  {key}  40000\n")), "{text}");
    let column = key.len() + 2;
    assert!(
        text.contains(&format!("  {:<column$}1 kHz\n", "sampling.rate")),
        "{text}"
    );
}

/// Figures in SI are of the period and the resolution, however the file writes them, and of a matrix factors.
#[test]
fn keys_of_limits_in_json_are_of_values_in_si() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/joints/planar-arm-slow.toml"
    );
    let arm = std::fs::read_to_string(path).unwrap();
    let keys = |text: &str| {
        let json = report(text).to_json();
        let limits = json["limits"].as_array().unwrap().iter();
        limits
            .map(|limit| limit["parameter"].as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    let found = keys(&arm);
    for key in [
        "sampling.period",
        "joint[1].encoder.resolution",
        "wall.stiffness",
    ] {
        assert!(found.iter().any(|other| other == key), "{key}: {found:?}");
    }
    let is_other = |key: &String| key.ends_with("rate") || key.ends_with("counts_per_revolution");
    assert!(!found.iter().any(is_other), "{found:?}");
    assert!(keys(MATRIX).contains(&"wall.stiffness_matrix".to_owned()));
}
