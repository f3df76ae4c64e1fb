//! Scenes of several joints: read, checked, and with their limits typed back (TH-NDOF).

mod explanations;
mod mistakes;

use num_traits::{Signed as _, Zero as _};
use passivity_core::{BigRational, Interval};
use passivity_scene::any::AnyReport;
use passivity_scene::check::{Verdict, check};
use passivity_scene::joints::JointReport;
use passivity_scene::{AnyScene, JointScene, Scene, number};

const ARM: &str = r#"
[[joint]]
name = "shoulder"
viscous = "0.01 N m s/rad ± 10%"
coulomb = "20 mN m"
encoder = { counts_per_revolution = 4096 }
[[joint]]
name = "elbow"
viscous = "0.01 N m s/rad"
coulomb = "20 mN m ± 5%"
encoder = { resolution = "0.1 deg" }
[[joint]]
name = "slide"
viscous = "0.5 N s/m"
coulomb = "0.1 N"
encoder = { resolution = "0.05 mm" }
[sampling]
rate = "1 kHz"
[wall]
stiffness = "0.1 N/mm"
direction = ["0.2 m/rad", "-50 mm/rad", "0.3"]
unilateral = true
"#;

const MATRIX: &str = r#"
[[joint]]
viscous = "0.01 N m s/rad"
coulomb = "20 mN m"
encoder = { counts_per_revolution = 4096 }
[[joint]]
viscous = "1 N s/m"
coulomb = "0.1 N"
encoder = { resolution = "0.05 mm" }
[sampling]
rate = "1 kHz"
[wall]
stiffness_matrix = [["2 N m/rad", "3 N m/m"], ["3 N/rad", "100 N/m"]]
"#;

fn scene(text: &str) -> JointScene {
    match AnyScene::from_toml("arm", text) {
        Ok(AnyScene::Joints(scene)) => *scene,
        Ok(AnyScene::One(_)) => panic!("a scene of one joint:\n{text}"),
        Err(error) => panic!("{error}\n{text}"),
    }
}

fn report(text: &str) -> JointReport {
    passivity_scene::joints::check(&scene(text))
}

fn bounded() -> String {
    ARM.replace("\"shoulder\"", "\"shoulder\"\nmax_speed = \"10 rpm\"")
        .replace("\"elbow\"", "\"elbow\"\nmax_speed = \"1 rad/s\"")
        .replace("\"slide\"", "\"slide\"\nmax_speed = \"0.1 m/s\"")
        .replace("0.1 N/mm", "0.6 N/mm")
        .replace("\"20 mN m\"", "\"200 mN m\"")
}

#[test]
fn th_ndof_an_arm_is_passive() {
    let report = report(ARM);
    assert_eq!(report.verdict, Verdict::Passive);
    assert_eq!(report.headline(), "PASSIVE at every speed");
    assert_eq!(report.viscous_definite, Some(true));
    assert_eq!(report.because, ["TH-NDOF", "TH-UNI"]);
    let names: Vec<_> = report.joints.iter().map(|joint| joint.motion).collect();
    assert_eq!(names, ["rotary", "rotary", "linear"]);
}

/// By the theory's formula: k ≤ 2/(TΣa²/b) and k ≤ 2cᵢ/(|aᵢ|Σ|aⱼ|Δⱼ), here without π.
#[test]
fn th_ndof_the_stiffest_wall_along_a_direction() {
    let text = ARM
        .replace(
            "{ counts_per_revolution = 4096 }",
            "{ resolution = \"0.002 rad\" }",
        )
        .replace("0.1 deg", "0.001 rad");
    let report = report(&text);
    let q = |text: &str| number::parse(text).unwrap();
    let (b, c) = (
        ["0.009", "0.01", "0.5"].map(q),
        ["0.02", "0.019", "0.1"].map(q),
    );
    let (a, delta) = (
        ["0.2", "0.05", "0.3"].map(q),
        ["0.002", "0.001", "0.00005"].map(q),
    );
    let load: BigRational = (0..3).map(|i| &a[i] * &a[i] / &b[i]).sum();
    let unseen: BigRational = (0..3).map(|i| &a[i] * &delta[i]).sum();
    let mut least = q("2") / (q("0.001") * load);
    for i in 0..3 {
        let by_coulomb = q("2") * &c[i] / (&a[i] * &unseen);
        least = if by_coulomb < least {
            by_coulomb
        } else {
            least
        };
    }
    assert_eq!(*report.max_stiffness_all_speeds.unwrap().lo(), least);
}

/// A device of one joint, written either way.
fn one(device: &str, coulomb: &str, encoder: &str, rest: &str) -> [String; 2] {
    let (speed, wall) = rest.split_once('|').unwrap();
    let operator = match speed {
        "" => String::new(),
        v => format!("[operator]\nmax_speed = \"{v}\"\n"),
    };
    let bound = match speed {
        "" => String::new(),
        v => format!("max_speed = \"{v}\"\n"),
    };
    let section = match encoder {
        "" => String::new(),
        encoder => format!("[encoder]\n{encoder}\n"),
    };
    let inline = match encoder {
        "" => String::new(),
        encoder => format!("encoder = {{ {encoder} }}\n"),
    };
    let loop_of = "[sampling]\nrate = \"1 kHz\"\n";
    let friction = format!("{device}\ncoulomb = \"{coulomb}\"\n");
    [
        format!("[device]\n{friction}{section}{operator}{loop_of}[wall]\n{wall}\n"),
        format!(
            "[[joint]]\n{friction}{inline}{bound}{loop_of}[wall]\n{wall}\ndirection = [\"1\"]\n"
        ),
    ]
}

/// Whether two ranges are the same, but for how tightly π was enclosed.
fn same(a: &Option<Interval<BigRational>>, b: &Option<Interval<BigRational>>) -> bool {
    let close = |a: &BigRational, b: &BigRational| {
        (a - b).abs() <= a.abs() * number::parse("1e-50").unwrap()
    };
    match (a, b) {
        (Some(a), Some(b)) => close(a.lo(), b.lo()) && close(a.hi(), b.hi()),
        (a, b) => a == b,
    }
}

/// With one joint the verdict and the limits are those of the same device in `[device]`.
#[test]
fn th_ndof_one_joint_is_a_device() {
    let mut seen = Vec::new();
    for viscous in [
        "viscous = \"9e-4 N m s/rad\"",
        "viscous = \"4e-4 N m s/rad ± 10%\"",
        "",
    ] {
        for coulomb in ["2 mN m", "0.8 mN m", "0.3 … 0.9 mN m", "0.1 mN m"] {
            for encoder in [
                "counts_per_revolution = 4096",
                "resolution = \"0.05 deg ± 2%\"",
                "",
            ] {
                for rest in [
                    "|stiffness = \"1 N m/rad\"",
                    "|stiffness = \"1 N m/rad ± 20%\"\nunilateral = true",
                    "1 rad/s|stiffness = \"1 N m/rad\"",
                    "100 rpm|stiffness = \"1.5 N m/rad\"",
                    "40 rad/s|stiffness = \"0.02 N m/deg\"\nunilateral = true",
                ] {
                    let [device, joints] = one(viscous, coulomb, encoder, rest);
                    let device = Scene::from_toml("arm", &device).unwrap_or_else(|e| panic!("{e}"));
                    let expected = check(&device);
                    let found = report(&joints);
                    let told = format!("{joints}\n{}\n{}", expected.to_text(), found.to_text());
                    assert_eq!(found.verdict, expected.verdict, "{told}");
                    assert_eq!(found.at_every_speed, expected.at_every_speed, "{told}");
                    assert!(
                        same(
                            &found.max_stiffness_all_speeds,
                            &expected.max_stiffness_all_speeds
                        ),
                        "{told}"
                    );
                    assert!(
                        same(
                            &found.max_stiffness_at_speed_bound,
                            &expected.max_stiffness_at_speed_bound
                        ),
                        "{told}"
                    );
                    let of_device = expected
                        .limits
                        .iter()
                        .filter(|limit| limit.border.hi().is_positive());
                    let of_device: Vec<_> = of_device
                        .map(|l| (l.parameter, &l.border, &l.typed))
                        .collect();
                    let of_joint = found.limits.iter().filter(|limit| {
                        of_device
                            .iter()
                            .any(|(parameter, ..)| *parameter == limit.limit.parameter)
                    });
                    let mut of_joint: Vec<_> = of_joint
                        .map(|l| (l.limit.parameter, &l.limit.border, &l.limit.typed))
                        .collect();
                    let mut of_device = of_device;
                    of_device.sort_by_key(|(parameter, ..)| *parameter);
                    of_joint.sort_by_key(|(parameter, ..)| *parameter);
                    assert_eq!(of_joint.len(), of_device.len(), "{told}");
                    for ((p, border, typed), (q, other, same_typed)) in
                        of_joint.iter().zip(&of_device)
                    {
                        assert_eq!((p, typed), (q, same_typed), "{told}");
                        assert!(
                            same(&Some((*border).clone()), &Some((*other).clone())),
                            "{told}"
                        );
                    }
                    seen.push(found.verdict);
                }
            }
        }
    }
    for verdict in [Verdict::Passive, Verdict::NotPassive, Verdict::Depends] {
        assert!(seen.contains(&verdict), "{verdict:?}");
    }
}

/// Each limit that is printed, typed into the file in place of the value, passes.
#[test]
fn check_limits_of_joints_typed_back_pass() {
    for text in [
        ARM.to_owned(),
        ARM.replace("0.1 N/mm", "1 N/mm"),
        bounded(),
        MATRIX.to_owned(),
    ] {
        let report = report(&text);
        let mut typed = 0;
        for limit in &report.limits {
            let Some(value) = &limit.limit.typed else {
                continue;
            };
            let replaced = replaced(&text, &limit.key, value, &limit.limit.written.unit());
            let after = self::report(&replaced);
            assert_eq!(after.verdict, Verdict::Passive, "{}\n{replaced}", limit.key);
            typed += 1;
        }
        assert!(typed > 0, "{text}");
    }
}

/// The file with another value of a key.
fn replaced(text: &str, key: &str, value: &str, unit: &str) -> String {
    let (joint, short) = match key.strip_prefix("joint[") {
        Some(rest) => {
            let (number, key) = rest.split_once("].").unwrap();
            (number.parse::<usize>().unwrap(), key)
        }
        None => (0, key.split_once('.').unwrap().1),
    };
    if key == "wall.stiffness_matrix" {
        let factor = number::parse(value).unwrap();
        let scaled = |x: &str| (number::parse(x).unwrap() * &factor).to_string();
        return text
            .replace("\"2 N m", &format!("\"{} N m", scaled("2")))
            .replace("\"3 N", &format!("\"{} N", scaled("3")))
            .replace("\"100 N", &format!("\"{} N", scaled("100")));
    }
    let mut seen = 0;
    let mut out = String::new();
    for line in text.lines() {
        seen += usize::from(line == "[[joint]]");
        let own = match short.split_once('.') {
            Some((table, _)) => line.starts_with(table),
            None => line.starts_with(&format!("{short} =")),
        };
        if own && (joint == 0 || joint == seen) {
            let quoted = match unit {
                "" => value.to_owned(),
                unit => format!("\"{value}{unit}\""),
            };
            out += &match short.split_once('.') {
                Some((table, key)) => format!("{table} = {{ {key} = {quoted} }}\n"),
                None => format!("{short} = {quoted}\n"),
            };
        } else {
            out += line;
            out += "\n";
        }
    }
    out
}

/// The witness draws what it says, from floors and held torques alone.
#[test]
fn th_ndof_the_witness_draws() {
    let text = ARM
        .replace(
            "{ counts_per_revolution = 4096 }",
            "{ resolution = \"0.002 rad\" }",
        )
        .replace("0.1 deg", "0.001 rad");
    let q = |text: &str| number::parse(text).unwrap();
    for (changed, k, c, b) in [
        (text.replace("0.1 N/mm", "1 N/mm"), "1000", "0.02", "0.01"),
        (
            text.replace("\"20 mN m\"", "\"2 mN m\""),
            "100",
            "0.002",
            "0.01",
        ),
        (
            text.replace("0.01 N m s/rad ± 10%", "0 N m s/rad"),
            "100",
            "0.02",
            "0",
        ),
    ] {
        let report = report(&changed);
        assert_eq!(report.verdict, Verdict::NotPassive, "{}", report.to_text());
        let witness = report.witness.unwrap();
        let most = if b == "0" { q("0") } else { q("0.011") };
        let b = [most, q("0.01"), q("0.5")];
        let c = [q(c), q("0.021"), q("0.1")];
        let a = ["0.2", "-0.05", "0.3"].map(q);
        let delta = ["0.002", "0.001", "0.00005"].map(q);
        let half = q("1/2");
        let mut at = witness.from.clone();
        let mut gain = q("0");
        for step in &witness.moves {
            let measured = |i: usize| (at[i].floor() + &half) * &delta[i];
            let into: BigRational = (0..3).map(|i| &a[i] * measured(i)).sum();
            let force = if into.is_positive() {
                -into * q(k)
            } else {
                q("0")
            };
            for i in 0..3 {
                let d = &step[i] * &delta[i];
                gain += &force * &a[i] * &d - &b[i] * &d * &d / q("0.001") - &c[i] * d.abs();
            }
            at = (0..3).map(|i| &at[i] + &step[i]).collect();
        }
        assert_eq!(at, witness.from);
        assert!(gain.is_positive() && gain >= witness.gain_per_cycle);
        assert_eq!(gain, witness.gain_per_cycle);
    }
}

#[test]
fn bounds_of_the_joints_help() {
    let report = report(&bounded());
    assert_eq!(
        report.headline(),
        "PASSIVE at every speed up to the bounds of the joints"
    );
    assert_eq!(report.viscous_definite, Some(false));
    let without = bounded().replace("max_speed = \"1 rad/s\"", "");
    let report = self::report(&without);
    assert_eq!(
        report.headline(),
        "NOT GUARANTEED passive at every speed: the criterion fails"
    );
    let [remark] = &report.remarks[..] else {
        panic!("{:?}", report.remarks)
    };
    assert!(remark.starts_with("the criterion does not use `max_speed`: "));
}

#[test]
fn a_tolerance_may_decide() {
    let text = ARM.replace("20 mN m ± 5%", "1 … 1.1 mN m");
    let report = report(&text);
    assert_eq!(
        report.headline(),
        "DEPENDS on the tolerance of joint[2].coulomb"
    );
}

#[test]
fn json_says_the_same() {
    let value = serde_json::json!({
        "joint": [
            {"viscous": "0.01 N m s/rad", "coulomb": "20 mN m", "encoder": {"counts_per_revolution": 4096}},
            {"viscous": "1 N s/m", "coulomb": "0.1 N", "encoder": {"resolution": "0.05 mm"}},
        ],
        "sampling": {"rate": "1 kHz"},
        "wall": {"stiffness_matrix": [["2 N m/rad", "3 N m/m"], ["3 N/rad", "100 N/m"]]},
    });
    let AnyReport::Joints(report) = AnyScene::from_json(&value).unwrap().check() else {
        panic!("a scene of one joint");
    };
    let of_file = self::report(MATRIX);
    assert_eq!(report.limits, of_file.limits);
    let json = report.to_json();
    for null in [
        "cost",
        "beta",
        "sigma",
        "critical_speed",
        "max_stiffness_all_speeds",
        "direction",
        "witness",
    ] {
        assert!(json[null].is_null() && json.get(null).is_some(), "{null}");
    }
    assert_eq!(json["viscous_definite"], true);
    // ½(3·2π/4096 + 100·5e-5), to the last digits of a double.
    let needed = json["joints"][1]["coulomb_needed"]["approx"]
        .as_f64()
        .unwrap();
    assert!((needed - (3.0 * std::f64::consts::PI / 4096.0 + 0.0025)).abs() < 1e-17);
    assert!(!report.max_matrix_factor.unwrap().lo().is_zero());
}

/// The shipped scenes have the verdicts of their folder's table.
#[test]
fn shipped_scenes_of_joints() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/joints");
    let table = std::fs::read_to_string(folder.join("README.md")).unwrap();
    let rows = table.lines().filter_map(|line| {
        let (name, rest) = line.strip_prefix("| `")?.split_once(".toml` |")?;
        let verdict = rest.trim_end_matches('|').rsplit_once('|')?.1.trim();
        Some((format!("{name}.toml"), verdict.replace(' ', "_")))
    });
    let mut rows: Vec<(String, String)> = rows.collect();
    let files = std::fs::read_dir(&folder)
        .unwrap()
        .map(|file| file.unwrap().file_name());
    let files = files.map(|name| name.to_string_lossy().into_owned());
    let mut found: Vec<(String, String)> = files
        .filter(|name| name.ends_with(".toml"))
        .map(|name| {
            let scene = AnyScene::read(folder.join(&name)).unwrap_or_else(|e| panic!("{e}"));
            (name, scene.check().verdict().name().to_owned())
        })
        .collect();
    rows.sort();
    found.sort();
    assert_eq!(found, rows);
}
