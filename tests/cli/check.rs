//! `passivity check`: what must hold of the verdict.

use num_traits::{One, Signed, Zero};
use passivity_core::BigRational;

use crate::harness::{Checked, Dir, ratio, rational, shipped};

const RE35: &str = r#"
[device]
inertia = "6.28e-6 kg m^2"
viscous = "9e-6 N m s/rad"
coulomb = "2e-3 N m"
[sampling]
period = "1 ms"
[encoder]
counts_per_revolution = 8192
[wall]
stiffness = "1 N m/rad"
"#;

#[test]
fn th_stiff_re35_limits_and_critical_speed() {
    let checked = Dir::new().check(RE35);
    assert_eq!(checked.text("region"), "locally_stable");
    assert_eq!(checked.point("beta"), ratio(9, 1000));
    assert_eq!(checked.point("mu"), ratio(628, 100));
    // 2b/T, exactly: π has no part in it.
    assert_eq!(checked.point("max_stiffness_all_speeds"), ratio(18, 1000));
    // v_c = (c − KΔ/2)/(KT/2 − b) with Δ = 2π/8192: (2e-3 − π/8192)/(5e-4 − 9e-6).
    let (lo, hi) = checked.range("critical_speed_si");
    let speed = (2e-3 - std::f64::consts::PI / 8192.0) / (5e-4 - 9e-6);
    // A handful of double operations on numbers of one sign but for one subtraction that loses
    // less than two bits: 8 ulp cover them.
    assert!((checked.approx("critical_speed_si") - speed).abs() <= 8.0 * f64::EPSILON * speed);
    assert!(lo < hi && hi - lo < ratio(1, 1_000_000_000_000_000_000));
    assert!((checked.approx("critical_speed_si") - 3.2923).abs() < 5e-5);
}

#[test]
fn th_stiff_coulomb_limit_of_the_re35() {
    // With viscous friction out of the way, the Coulomb limit 2c/Δ ≈ 5.2152 is the stiffest wall.
    let text = RE35.replace("9e-6", "9e-3");
    let checked = Dir::new().check(&text);
    assert!((checked.approx("max_stiffness_all_speeds") - 5.2152).abs() < 5e-5);
}

/// What is left at every speed: the lesser of what β and σ have to spare, of a scene without
/// tolerances.
fn least_spare(checked: &Checked) -> BigRational {
    let of = |friction: &str| {
        let spare = &checked.scene["spare"][friction];
        assert_eq!(spare["lo"], spare["hi"]);
        rational(&spare["lo"])
    };
    of("viscous").min(of("coulomb"))
}

fn dimensionless(beta: &str, sigma: &str) -> String {
    format!("[dimensionless]\nmu = \"50\"\nbeta = \"{beta}\"\nsigma = \"{sigma}\"\n")
}

#[test]
fn th_region_equality_is_passive_and_the_least_step_below_is_not() {
    let dir = Dir::new();
    let corner = dir.check(&dimensionless("1/2", "0.5"));
    assert_eq!((corner.text("verdict"), corner.code), ("passive", 0));
    for friction in ["viscous", "coulomb"] {
        assert_eq!(corner.scene["spare"][friction]["lo"], "0");
        assert_eq!(corner.scene["spare"][friction]["hi"], "0");
    }
    let below = format!("0.4{}", "9".repeat(29));
    for (beta, sigma) in [(below.as_str(), "1/2"), ("1/2", below.as_str())] {
        let checked = dir.check(&dimensionless(beta, sigma));
        assert_eq!(
            (checked.text("verdict"), checked.code),
            ("not_passive", 1),
            "{beta} {sigma}"
        );
        assert_witness(&checked);
    }
}

/// ⌊x⌋ + ½, by the integers alone.
fn middle_of_tick(x: &BigRational) -> BigRational {
    let mut tick = x.numer() / x.denom();
    if (x.numer() % x.denom()).is_negative() {
        tick -= 1;
    }
    BigRational::from_integer(tick) + ratio(1, 2)
}

/// Recomputes the gain of a witness from the floor and the held force alone.
fn assert_witness(checked: &Checked) {
    let witness = &checked.scene["witness"];
    let (from, to) = (rational(&witness["from"]), rational(&witness["to"]));
    let (beta, sigma) = (checked.point("beta"), checked.point("sigma"));
    let held = |x: &BigRational| -middle_of_tick(x);
    let mut gain = BigRational::zero();
    for (a, b) in [(&from, &to), (&to, &from)] {
        let d = b - a;
        let friction = &beta * &d * &d + &sigma * d.abs();
        gain += held(a) * d - friction;
    }
    assert_eq!(gain, rational(&witness["gain_per_cycle"]));
    assert!(gain.is_positive());
    if let Some(bound) = checked.scene["speed_bound"].get("hi") {
        assert!((to - from).abs() <= rational(bound));
    }
}

#[test]
fn th_active_every_point_below_a_half_has_a_witness() {
    let dir = Dir::new();
    let values = [
        "0", "1/1000", "1/3", "0.499", "1/2", "0.501", "3/4", "2", "1000",
    ];
    let half = ratio(1, 2);
    for beta in values {
        for sigma in values {
            let checked = dir.check(&dimensionless(beta, sigma));
            let passive = checked.point("beta") >= half && checked.point("sigma") >= half;
            assert_eq!(
                checked.text("verdict"),
                if passive { "passive" } else { "not_passive" }
            );
            assert_eq!(
                checked.scene["witness"].is_null(),
                passive,
                "{beta} {sigma}"
            );
            if !passive {
                assert_witness(&checked);
            }
        }
    }
}

#[test]
fn th_active_within_a_speed_bound() {
    let dir = Dir::new();
    // v_c = (1/10)/(1/10) = 1: passive up to it, and with a bound above 2 a cycle of m = 2 fits.
    let scene = |v: &str| {
        format!(
            "{}[operator]\nmax_speed = \"{v}\"\n",
            dimensionless("2/5", "3/5")
        )
    };
    let at = dir.check(&scene("1"));
    assert_eq!(
        (at.text("verdict"), at.point("margin_at_speed_bound")),
        ("passive", ratio(0, 1))
    );
    let just_above = dir.check(&scene("1.001"));
    assert_eq!(
        (just_above.text("verdict"), just_above.code),
        ("not_guaranteed", 1)
    );
    assert!(just_above.scene["witness"].is_null());
    let above = dir.check(&scene("2.5"));
    assert_eq!(above.text("verdict"), "not_passive");
    assert_witness(&above);
}

#[test]
fn the_margin_at_the_speed_bound_is_that_of_8() {
    // (β − ½) + (σ − ½)/V = 1/10 + 2·1/10.
    let scene = dimensionless("3/5", "3/5") + "[operator]\nmax_speed = \"1/2\"\n";
    assert_eq!(
        Dir::new().check(&scene).point("margin_at_speed_bound"),
        ratio(3, 10)
    );
}

#[test]
fn th_start_compares_squares() {
    let dir = Dir::new();
    // v_c = 5; V² = 3² + 8²/4 = 25, so V = 5 exactly, by squares.
    let scene = |velocity: &str| {
        format!(
            "[dimensionless]\nmu = \"4\"\nbeta = \"2/5\"\nsigma = \"1\"\n[start]\nposition = \"8\"\n\
             velocity = \"{velocity}\"\n"
        )
    };
    let at = dir.check(&scene("-3"));
    assert_eq!(at.scene["unforced"]["holds"], true);
    assert_eq!(at.scene["unforced"]["speed"]["lo"], "5");
    assert_eq!(at.scene["unforced"]["speed"]["hi"], "5");
    let above = dir.check(&scene("3.000000000000000000000001"));
    assert_eq!(above.scene["unforced"]["holds"], false);
    // The verdict is about any operator, wherever the motion starts.
    for checked in [at, above] {
        assert_eq!((checked.text("verdict"), checked.code), ("not_passive", 1));
        assert!(checked.scene["speed_bound"].is_null());
    }
}

#[test]
fn a_tolerance_across_the_border_depends_and_names_the_parameter() {
    let text = RE35
        .replace("1 N m/rad", "0.018 N m/rad ± 1%")
        .replace("8192", "65536");
    let checked = Dir::new().check(&text);
    assert_eq!((checked.text("verdict"), checked.code), ("depends", 1));
    assert_eq!(
        checked.scene["decided_by"],
        serde_json::json!(["wall.stiffness"])
    );
    assert_eq!(checked.text("region"), "depends");
    // A tolerance of another parameter that cannot flip it is not named.
    let both = text.replace("2e-3 N m", "2e-3 N m ± 1%");
    let checked = Dir::new().check(&both);
    assert_eq!(
        checked.scene["decided_by"],
        serde_json::json!(["wall.stiffness"])
    );
}

#[test]
fn every_effect_is_covered() {
    let dir = Dir::new();
    let lag = format!("{RE35}[amplifier]\ntime_constant = \"0.2 ms\"\n");
    let checked = dir.check(&lag);
    assert_eq!((checked.text("verdict"), checked.code), ("not_passive", 1));
    assert_eq!(checked.scene["not_covered"], serde_json::json!([]));
    // Saturation and virtual damping are covered one by one and together.
    let wall = |keys: &str| dimensionless("3", "3") + "[wall]\n" + keys;
    assert_eq!(
        dir.check(&wall("max_force = \"2\"\n")).text("verdict"),
        "passive"
    );
    assert_eq!(
        dir.check(&wall("damping = \"1\"\n")).text("verdict"),
        "passive"
    );
    assert_eq!(
        dir.check(&wall("max_force = \"2\"\ndamping = \"1\"\n"))
            .text("verdict"),
        "passive"
    );
}

#[test]
fn effects_move_the_border_by_their_theorems() {
    let dir = Dir::new();
    let verdict = |beta: &str, sigma: &str, rest: &str| {
        let checked = dir.check(&(dimensionless(beta, sigma) + rest));
        (checked.text("verdict").to_owned(), least_spare(&checked))
    };
    let passive = |margin| ("passive".to_owned(), margin);
    let drawn = |margin| ("not_passive".to_owned(), margin);
    // TH-DELAY: β − ½ − k.
    assert_eq!(
        verdict("5/2", "1/2", "[sampling]\ndelay = 2\n"),
        passive(ratio(0, 1))
    );
    assert_eq!(
        verdict("2.4", "1/2", "[sampling]\ndelay = 2\n"),
        drawn(ratio(-1, 10))
    );
    // TH-DAC: σ − ½(1 + δ).
    assert_eq!(
        verdict("1/2", "0.6", "[wall]\nforce_step = \"1/5\"\n"),
        passive(ratio(0, 1))
    );
    assert_eq!(
        verdict("1/2", "0.5", "[wall]\nforce_step = \"1/5\"\n"),
        ("not_guaranteed".to_owned(), ratio(-1, 10))
    );
    // TH-DAMP: both less B.
    assert_eq!(
        verdict("3/4", "3/4", "[wall]\ndamping = \"1/4\"\n"),
        passive(ratio(0, 1))
    );
    assert_eq!(
        verdict("3/4", "0.7", "[wall]\ndamping = \"1/4\"\n"),
        drawn(ratio(-1, 20))
    );
    // TH-LTI: a delay and damping partly cancel, ½ + ¼ + 1/(8·¼) instead of 7/4; not on one side.
    let all = "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"\nforce_step = \"1/2\"\n";
    assert_eq!(verdict("5/4", "1", all), passive(ratio(0, 1)));
    let one_sided = format!("{all}unilateral = true\n");
    assert_eq!(verdict("7/4", "1", &one_sided), passive(ratio(0, 1)));
}

#[test]
fn th_smooth_without_an_encoder() {
    let dir = Dir::new();
    let text = RE35.replace("[encoder]\ncounts_per_revolution = 8192\n", "");
    let checked = dir.check(&text);
    assert!(checked.scene["sigma"].is_null());
    // b < KT/2, so a long enough move gains: 2(½d² − βd² − σd) with σ = c/K.
    assert_eq!(checked.text("verdict"), "not_passive");
    let witness = &checked.scene["witness"];
    let d = rational(&witness["to"]) - rational(&witness["from"]);
    let (beta, sigma) = (checked.point("beta"), ratio(2, 1000));
    let gain = (ratio(1, 2) * &d * &d - beta * &d * &d - sigma * d) * ratio(2, 1);
    assert_eq!(gain, rational(&witness["gain_per_cycle"]));
    assert!(gain.is_positive());
    let stiff_enough = text.replace("1 N m/rad", "0.018 N m/rad");
    assert_eq!(dir.check(&stiff_enough).text("verdict"), "passive");
}

#[test]
fn every_shipped_scene_has_every_field_and_its_exit_code() {
    let dir = Dir::new();
    let mut verdicts = Vec::new();
    for path in shipped() {
        let name = path.to_str().expect("a UTF-8 path");
        let run = dir.run(&["check", "--format", "json", name]);
        let document = run.json();
        let scene = &document["scenes"][0];
        for field in [
            "scene",
            "region",
            "verdict",
            "because",
            "not_covered",
            "mu",
            "beta",
            "sigma",
            "critical_speed",
            "critical_speed_si",
            "cost",
            "spare",
            "unforced",
            "speed_bound",
            "margin_at_speed_bound",
            "max_stiffness_all_speeds",
            "max_stiffness_at_speed_bound",
            "colgate",
            "abbott_okamura",
            "witness",
        ] {
            assert!(scene.get(field).is_some(), "{name}: {field}");
        }
        let expected = match scene["verdict"].as_str() {
            Some("passive") => 0,
            Some("not_passive" | "not_guaranteed" | "depends") => 1,
            other => panic!("{name}: {other:?}"),
        };
        assert_eq!(run.code, expected, "{name}");
        assert!(
            scene["verdict"] != "not_passive" || scene["witness"].is_object(),
            "{name}"
        );
        verdicts.push(scene["verdict"].as_str().unwrap_or_default().to_owned());
        let text = dir.run(&["check", name]);
        assert_eq!(text.code, expected, "{name}");
        assert!(text.stdout.contains("because"), "{}", text.stdout);
    }
    for verdict in ["passive", "not_passive", "depends"] {
        assert!(
            verdicts.iter().any(|v| v == verdict),
            "no shipped scene is {verdict}"
        );
    }
}

#[test]
fn a_bad_scene_does_not_keep_the_others_from_being_checked() {
    let dir = Dir::new();
    dir.write("good.toml", dimensionless("1", "1"));
    dir.write(
        "bad.toml",
        "[device]\nviscous = \"9e-6 N m s/rad\"\nviscosity = 3\n",
    );
    let run = dir.run(&[
        "check",
        "--format",
        "json",
        "bad.toml",
        "good.toml",
        "absent.toml",
    ]);
    assert_eq!(run.code, 2);
    let document = run.json();
    assert_eq!(document["scenes"].as_array().unwrap().len(), 1);
    assert_eq!(document["scenes"][0]["verdict"], "passive");
    assert_eq!(document["errors"].as_array().unwrap().len(), 2);
    assert!(run.stderr.contains("bad.toml:3"), "{}", run.stderr);
    assert!(run.stderr.contains("viscosity"), "{}", run.stderr);
    assert!(run.stderr.contains("absent.toml"), "{}", run.stderr);
}

#[test]
fn one_over_a_million_digits_is_not_needed_to_be_exact() {
    // A margin of 10⁻⁴⁰⁰, far below any double.
    let tiny = format!("0.5{}1", "0".repeat(399));
    let checked = Dir::new().check(&dimensionless(&tiny, "1"));
    assert_eq!(checked.text("verdict"), "passive");
    let margin = least_spare(&checked);
    assert!(margin.is_positive() && margin.recip() >= num_bigint::BigInt::from(10).pow(399).into());
    assert!(margin < BigRational::one());
}
