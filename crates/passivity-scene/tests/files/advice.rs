//! What `check` tells to change, with its exact text; what it tells to type makes the wall passive.

use passivity_scene::Scene;
use passivity_scene::check::{Binds, Verdict, check};

const DEVICE: &str = r#"
    [device]
    viscous = "9e-6 N m s/rad"
    coulomb = "2e-3 N m"
    [sampling]
    rate = "1 kHz"
    [encoder]
    counts_per_revolution = 8192
    [wall]
    stiffness = "1 N m/rad"
"#;

fn scene(more: &str) -> Scene {
    Scene::from_toml("wall", &format!("{DEVICE}{more}")).unwrap_or_else(|e| panic!("{e}"))
}

/// The text of a report in one line each, so that a test does not see where it was wrapped.
fn text(scene: &Scene) -> String {
    let text = check(scene).to_text();
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn a_speed_bound_that_is_all_that_is_missing_is_said_and_holds() {
    let unbounded = scene("");
    assert_eq!(check(&unbounded).verdict, Verdict::NotPassive);
    let expected = "Passive at every speed up to 3.2922 rad/s (31.438 rpm): set operator.max_speed = \
                    \"3.2922 rad/s\" if the hand is never faster.";
    assert!(text(&unbounded).contains(expected), "{}", text(&unbounded));
    let typed = check(&unbounded).advice.max_speed.unwrap().typed;
    let bounded = scene(&format!("[operator]\nmax_speed = \"{typed}\"\n"));
    assert_eq!(check(&bounded).verdict, Verdict::Passive);
    assert!(check(&bounded).advice.max_speed.is_none());
}

#[test]
fn speeds_come_in_the_unit_of_the_scene() {
    let in_rpm = scene("[operator]\nmax_speed = \"60 rpm\"\n");
    let expected = "Passive at every speed up to 31.438 rpm: set operator.max_speed = \"31.438 rpm\" if \
                    the hand is never faster.";
    assert!(text(&in_rpm).contains(expected), "{}", text(&in_rpm));
    // Without a speed in the scene, the unit of the resolution tells.
    let pushed = r#"
        [device]
        coulomb = "0.04 N"
        [sampling]
        rate = "1 kHz"
        [encoder]
        resolution = "0.03 mm"
        [wall]
        stiffness = "1 N/mm"
    "#;
    let pushed = Scene::from_toml("pushed", pushed).unwrap();
    let expected = "set operator.max_speed = \"50 mm/s\" if the hand is never faster.";
    assert!(text(&pushed).contains(expected), "{}", text(&pushed));
}

#[test]
fn the_smallest_change_is_said_and_is_enough() {
    let too_stiff = scene("[operator]\nmax_speed = \"4 rad/s\"\n");
    let report = check(&too_stiff);
    let said = text(&too_stiff);
    let change = report.advice.smallest_change.expect("the scene fails");
    let limit = &report.limits[change.limit];
    // Whichever it is, no other that is enough is nearer.
    assert!(limit.suffices && limit.typed.is_some());
    // By hand: (c + b·V)/(V·T/2 + Δ/2) = 0.002036/(0.002 + π/8192) = 0.85420…
    assert!(said.contains("Smallest single change: "), "{said}");
    assert!(
        said.contains(
            "Smallest single change: stiffness K at most 0.8542 N m/rad (now 1 N m/rad), −14.6 %."
        ),
        "{said}"
    );
}

/// Where only b ≥ KT/2 fails, b up, K down and T down by the same factor are enough: the softer wall
/// is told, whatever the factor rounds to.
#[test]
fn of_changes_that_are_as_far_the_one_that_takes_away_is_said() {
    for viscous in ["1e-6", "3e-6", "7e-6", "1.1e-5", "1.3e-5", "1.257e-6"] {
        let text_of = DEVICE
            .replace("9e-6", viscous)
            .replace("2e-3 N m", "1 N m")
            .replace("1 N m/rad", "0.377 N m/rad");
        let scene = Scene::from_toml("wall", &text_of).unwrap();
        let said = text(&scene);
        assert!(
            said.contains("Smallest single change: stiffness K"),
            "{viscous}: {said}"
        );
    }
}

#[test]
fn what_binds_is_said_in_percent() {
    let bound = scene("[operator]\nmax_speed = \"3 rad/s\"\n");
    let expected = "what binds friction at 3 rad/s: 93 % of what the device has is asked for, by \
                    sampling 79.6 %, encoder 20.4 %";
    assert!(text(&bound).contains(expected), "{}", text(&bound));
    let report = check(&bound);
    assert_eq!(report.advice.binds, Binds::AtSpeedBound);
    // By hand: KT/2·V of K·(V·T/2 + Δ/2), with V = 3 rad/s, T = 1 ms, Δ = 2π/8192.
    let (fast, slow) = (3.0 * 1e-3 / 2.0, std::f64::consts::PI / 8192.0);
    let shares: Vec<f64> = report.advice.shares.iter().map(|s| s.share).collect();
    for (share, expected) in shares.iter().zip([fast, slow]) {
        // Two roundings of doubles each.
        assert!((share - expected / (fast + slow)).abs() < 4.0 * f64::EPSILON);
    }
    let late = scene("[amplifier]\ntime_constant = \"0.2 ms\"\n");
    let said = text(&late);
    assert!(
        said.contains("by sampling 69.3 %, amplifier 30.7 %"),
        "{said}"
    );
    // What takes off has a minus: a lead that makes up for part of a delay.
    let lead = "[controller]\nnumerator = [\"1.5\", \"-0.5\"]\n";
    let delayed = DEVICE.replace("rate = \"1 kHz\"", "rate = \"1 kHz\"\ndelay = 1");
    let led = Scene::from_toml("led", &format!("{delayed}{lead}")).unwrap();
    assert!(text(&led).contains("controller −"), "{}", text(&led));
}

#[test]
fn the_scenes_of_the_guide_have_their_verdicts() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/desk");
    let mut found = 0;
    for (name, verdict) in [
        ("arm", Verdict::Passive),
        ("knob", Verdict::NotPassive),
        ("master-joint", Verdict::Passive),
        ("paddle", Verdict::Passive),
        ("wheel", Verdict::Passive),
    ] {
        let scene =
            Scene::read(folder.join(format!("{name}.toml"))).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(check(&scene).verdict, verdict, "{name}");
        found += 1;
    }
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), found);
}
