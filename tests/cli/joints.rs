//! Scenes of several joints, from the command line (TH-NDOF).

use crate::harness::{Dir, ratio, rational};

const ARM: &str = r#"
[[joint]]
name = "shoulder"
viscous = "1/500 N m s/rad"
coulomb = "1/200 N m"
encoder = { resolution = "1/5000 rad" }
[[joint]]
name = "slide"
viscous = "1/2 N s/m"
coulomb = "1/20 N"
encoder = { resolution = "1/20000 m" }
[sampling]
period = "1 ms"
[wall]
stiffness = "100 N/m"
direction = ["1/10 m/rad", "1/2"]
"#;

#[test]
fn th_ndof_an_arm_in_json() {
    let checked = Dir::new().check(ARM);
    assert_eq!((checked.text("verdict"), checked.code), ("passive", 0));
    for null in [
        "region",
        "cost",
        "beta",
        "sigma",
        "critical_speed",
        "witness",
    ] {
        assert!(checked.scene[null].is_null(), "{null}");
        assert!(checked.scene.get(null).is_some(), "{null}");
    }
    assert_eq!(checked.scene["viscous_definite"], true);
    // ½·K·|aᵢ|·Σ|aⱼ|Δⱼ, with Σ|aⱼ|Δⱼ = 1/10·1/5000 + 1/2·1/20000 = 9/200000.
    let joints = checked.scene["joints"].as_array().expect("a list");
    let needed = [ratio(9, 40_000), ratio(9, 8000)];
    for (joint, needed) in joints.iter().zip(needed) {
        assert_eq!(rational(&joint["coulomb_needed"]["lo"]), needed);
        let coulomb = rational(&joint["coulomb"]["lo"]);
        assert_eq!(rational(&joint["spare_coulomb"]["hi"]), coulomb - needed);
    }
    // 2/(T·Σa²/b) = 2000/(1/100·500 + 1/4·2) = 4000/11, below 2c/(|a|Σ|a|Δ).
    assert_eq!(checked.point("max_stiffness_all_speeds"), ratio(4000, 11));
    assert_eq!(rational(&checked.scene["direction"][1]["lo"]), ratio(1, 2));
}

/// The witness of a wall at 500 N/m, and of one with too little Coulomb friction, draws what it says.
#[test]
fn th_ndof_an_active_arm_draws() {
    for (from, to) in [("100 N/m", "500 N/m"), ("1/200 N m", "1/5000 N m")] {
        let checked = Dir::new().check(&ARM.replace(from, to));
        assert_eq!((checked.text("verdict"), checked.code), ("not_passive", 1));
        let witness = &checked.scene["witness"];
        let list = |value: &serde_json::Value| -> Vec<_> {
            value
                .as_array()
                .expect("a list")
                .iter()
                .map(rational)
                .collect()
        };
        let k = if to == "500 N/m" { 500 } else { 100 };
        let c = if from == "1/200 N m" {
            ratio(1, 5000)
        } else {
            ratio(1, 200)
        };
        let (b, c) = ([ratio(1, 500), ratio(1, 2)], [c, ratio(1, 20)]);
        let (a, delta) = (
            [ratio(1, 10), ratio(1, 2)],
            [ratio(1, 5000), ratio(1, 20_000)],
        );
        let mut at = list(&witness["from"]);
        let mut gain = ratio(0, 1);
        for step in witness["moves"].as_array().expect("a list") {
            let step = list(step);
            let measured = |i: usize| (at[i].floor() + ratio(1, 2)) * &delta[i];
            let force = -ratio(k, 1) * (&a[0] * measured(0) + &a[1] * measured(1));
            for i in 0..2 {
                let d = &step[i] * &delta[i];
                let way = if d < ratio(0, 1) {
                    -d.clone()
                } else {
                    d.clone()
                };
                gain += &force * &a[i] * &d - &b[i] * &d * &d * ratio(1000, 1) - &c[i] * way;
            }
            at = at.iter().zip(&step).map(|(x, d)| x + d).collect();
        }
        assert_eq!(at, list(&witness["from"]));
        assert_eq!(gain, rational(&witness["gain_per_cycle"]));
        assert!(gain > ratio(0, 1));
    }
}

#[test]
fn an_arm_is_explained_in_numbers() {
    let dir = Dir::new();
    let scene = dir.write("arm.toml", ARM);
    let text = dir.run(&["explain", &scene]).stdout;
    for part in [
        "100 · 0.001 · ((0.1)²/0.002 + (0.5)²/0.5) ≤ 2",
        "c ≥ ½·Σ_j |K_ij|·Δ_j of joint 2 (slide)\n              0.05 ≥ 0.001125",
        "PASSIVE at every speed",
        "none: several joints are not simulated",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let json = dir.run(&["explain", "--format", "json", &scene]).json();
    assert_eq!(json["check"]["verdict"], "passive");
    assert_eq!(json["given"]["joint[2].coulomb"], "1/20 N");
}

#[test]
fn other_commands_ask_for_one_joint() {
    let dir = Dir::new();
    let scene = dir.write("arm.toml", ARM);
    let trace = dir.write("trace.csv", "xi\n0\n");
    let asked: [&[&str]; 7] = [
        &["design", &scene],
        &["export", &scene, "--for", "c"],
        &["simulate", &scene],
        &[
            "sweep", &scene, "--beta", "0:1:2", "--sigma", "0:1:2", "--speed", "1", "--out",
            "g.csv",
        ],
        &["plane", &scene, "--plot", "p.svg"],
        &["audit", &trace, "--scene", &scene],
        &["case", &scene, "--out", "case"],
    ];
    for args in asked {
        let run = dir.run(args);
        assert_eq!(run.code, 2, "{args:?}\n{}", run.stdout);
        let part = "this scene has several joints: only `check` and `explain` answer for it";
        let said = run.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(part), "{args:?}\n{}", run.stderr);
    }
    let run = dir.run(&["explain", &scene, "--plot", "f.svg"]);
    assert_eq!(run.code, 2);
    assert!(
        run.stderr.contains("it needs a device of one joint"),
        "{}",
        run.stderr
    );
}
