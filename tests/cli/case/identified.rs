//! `passivity case --identification`: friction that is identified from logs, as evidence.

use std::path::Path;

use super::read;
use super::recorded::{case, element, scene};
use crate::harness::{Dir, Run};

/// The knob that the shipped logs were simulated with, with a wall that is passive to 5 rad/s.
const KNOB: &str = "# A knob, from its drawing.\n[device]\ninertia = \"2e-5 kg m^2\"\n\
    viscous = \"4e-5 N m s/rad ± 5%\"\ncoulomb = \"1.5e-3 N m ± 5%\"\n[sampling]\nrate = \"1 kHz\"\n\
    [encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"0.5 N m/rad\"\n\
    [operator]\nmax_speed = \"5 rad/s\"\n";

pub(super) fn shipped(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/identify");
    folder.join(name).to_str().expect("UTF-8").to_owned()
}

/// Writes a case with the friction of a push each way as evidence.
fn case_of_pushes(dir: &Dir, path: &str) -> Run {
    let [there, back] = ["push.csv", "push-back.csv"].map(shipped);
    let logs = ["--identification", &there, "--identification", &back];
    case(dir, path, &[&logs[..], &["--effort", "1"]].concat())
}

#[test]
fn identified_friction_is_compared_with_the_scene_and_links_its_assumption() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", KNOB);
    let run = case_of_pushes(&dir, &path);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    let found = scene(&run)["recorded"]["identification"].clone();
    assert_eq!(found["evidence"]["outcome"], "supports");
    assert_eq!(found["sources"][0]["path"], shipped("push.csv"));
    assert_eq!(found["over_identified_ranges"]["verdict"], "passive");
    assert_eq!(found["compared"].as_array().unwrap().len(), 2);
    let goal = element(&dir, "G-friction");
    assert!(goal.contains("supportedBy: [Sn-identification]"), "{goal}");
    assert!(goal.contains("inContextOf: [A-FRICTION]"), "{goal}");
    let html = read(&dir, "case/case.html");
    assert!(html.contains("explain every one of 1002 samples of free motion ("));
    assert!(html.contains("met in the recording"));
    // A parameter of which the scene names no source has one now.
    let unsourced = KNOB.replace("# A knob, from its drawing.\n", "");
    dir.write("scene.toml", unsourced);
    let run = case_of_pushes(&dir, &path);
    let open = element(&dir, "G-sources");
    assert!(open.contains("device.inertia"), "{open}");
    assert!(
        !open.contains("viscous") && !open.contains("coulomb"),
        "{open}"
    );
    assert_eq!(run.code, 0);
    assert!(read(&dir, "case/case.html").contains("identified from logs"));
}

#[test]
fn friction_outside_of_what_was_identified_contradicts_the_case() {
    let dir = Dir::new();
    let push = shipped("push.csv");
    let evidence = ["--identification", push.as_str(), "--effort", "1"];
    for (old, new, why) in [
        (
            "1.5e-3 N m ± 5%",
            "1.7e-3 N m ± 5%",
            "Coulomb friction is 1.7e-3 N m ± 5% in the scene",
        ),
        (
            "4e-5 N m s/rad ± 5%",
            "5e-5 N m s/rad",
            "viscous friction is 5e-5 N m s/rad in the scene",
        ),
        (
            "viscous = \"4e-5 N m s/rad ± 5%\"\n",
            "",
            "viscous friction is none in the scene",
        ),
    ] {
        let text = KNOB.replace(old, new).replace("5 rad/s", "3 rad/s");
        let path = dir.write("scene.toml", text);
        let run = case(&dir, &path, &evidence);
        let answer = scene(&run);
        assert_eq!(answer["verdict"], "passive", "{new}");
        assert_eq!(
            (run.code, answer["standing"].as_str()),
            (1, Some("open")),
            "{new}"
        );
        let evidence = answer["recorded"]["identification"]["evidence"].clone();
        assert_eq!(evidence["outcome"], "contradicts");
        assert!(
            evidence["because"].as_str().unwrap().contains(why),
            "{evidence}"
        );
        assert!(element(&dir, "G-friction").contains("defeated: true"));
        assert!(element(&dir, "CSn-identification").contains("SHA-256"));
        let html = read(&dir, "case/case.html");
        assert!(html.contains("contradicts the case"), "{new}");
        assert!(
            html.contains("What the logs say, as a scene takes it"),
            "{new}"
        );
    }
    // A device that is none of the model.
    let path = dir.write("scene.toml", KNOB);
    let backlash = shipped("backlash.csv");
    let run = case(
        &dir,
        &path,
        &["--identification", &backlash, "--effort", "1"],
    );
    assert_eq!(
        (run.code, scene(&run)["standing"].as_str()),
        (1, Some("open"))
    );
    let html = read(&dir, "case/case.html");
    assert!(html.contains("no viscous and Coulomb friction fit"));
    let words = [
        "case",
        &path,
        "--out",
        "case",
        "--device",
        "knob 3",
        "--date",
        "2026-11-20",
        "--effort",
        "1",
    ];
    let said = dir.run(&[&words[..], &["--identification", &backlash]].concat());
    assert!(
        said.stdout.contains("identification: nothing fits\n"),
        "{}",
        said.stdout
    );
    let objections = run.json()["objections"].to_string();
    assert!(objections.contains("A-FRICTION is not met"), "{objections}");
}

/// What `identify` printed and somebody typed back is in the range that it printed, at either end.
#[test]
fn an_end_of_the_range_as_it_is_printed_agrees_with_it() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", KNOB);
    let found = scene(&case_of_pushes(&dir, &path))["recorded"]["identification"].clone();
    let ranges = [0, 1].map(|i| found["compared"][i]["identified"].to_string());
    let ends = ranges.map(|range| {
        let number = |text: &str| text.trim_matches('"').split(' ').next().map(str::to_owned);
        let (lo, hi) = range.split_once(" … ").expect("a range");
        [lo, hi].map(|end| number(end).expect("a number"))
    });
    let [viscous, coulomb] = &ends;
    for (b, c) in viscous.iter().zip(coulomb) {
        let text = KNOB
            .replace("4e-5 N m s/rad ± 5%", &format!("{b} N m s/rad"))
            .replace("1.5e-3 N m ± 5%", &format!("{c} N m"));
        let path = dir.write("scene.toml", text);
        let found = scene(&case_of_pushes(&dir, &path))["recorded"]["identification"].clone();
        assert_eq!(found["evidence"]["outcome"], "supports", "{found}");
    }
}

/// What is given at the motor is compared, and what the scene is to be given is said, at the device.
#[test]
fn friction_at_the_motor_is_told_from_that_at_the_device() {
    let dir = Dir::new();
    let knob = |device: &str, motor: &str| {
        let text = KNOB
            .replace("viscous = \"4e-5 N m s/rad ± 5%\"\n", device)
            .replace("coulomb = \"1.5e-3 N m ± 5%\"\n", "")
            .replace("5 rad/s", "2 rad/s");
        dir.write(
            "scene.toml",
            format!("{text}[transmission]\nratio = \"10:1\"\n{motor}"),
        )
    };
    let motor = |viscous: &str, coulomb: &str| {
        let motor = format!("[motor]\nviscous = \"{viscous}\"\ncoulomb = \"{coulomb}\"\n");
        let run = case_of_pushes(&dir, &knob("", &motor));
        scene(&run)["recorded"]["identification"].clone()
    };
    let found = motor("3e-7 N m s/rad", "0.1 mN m");
    assert_eq!(found["evidence"]["outcome"], "contradicts");
    let because = found["evidence"]["because"].as_str().expect("a reason");
    for says in [
        "viscous friction is 3e-7 N m s/rad at the motor (3e-5 N m s/rad at the device) in the scene",
        "Coulomb friction is 0.1 mN m at the motor (0.001 N m at the device) in the scene",
    ] {
        assert!(because.contains(says), "{because}");
    }
    // The lines that the page shows are those of the device, and a scene with them agrees.
    let html = read(&dir, "case/case.html").replace("<wbr>", "");
    let mut lines = String::new();
    for (compared, key) in found["compared"]
        .as_array()
        .unwrap()
        .iter()
        .zip(["viscous", "coulomb"])
    {
        assert_eq!(compared["parameter"], format!("device.{key}"));
        let range = compared["identified"].as_str().expect("a range");
        let line = format!(
            "<code>device.{key} = &quot;{range}&quot;</code> in place of <code>motor.{key}</code>"
        );
        assert!(html.contains(&line), "{line}");
        lines += &format!("{key} = \"{range}\"\n");
    }
    let run = case_of_pushes(&dir, &knob(&lines, ""));
    let pasted = scene(&run)["recorded"]["identification"].clone();
    assert_eq!(pasted["evidence"]["outcome"], "supports", "{pasted}");
    // At the motor these hold what was identified.
    let found = motor("3.9e-7 … 4.1e-7 N m s/rad", "0.14 … 0.16 mN m");
    assert_eq!(found["evidence"]["outcome"], "supports", "{found}");
    let found = motor("3.9e-7 … 4.1e-7 N m s/rad", "0.14 … 0.15 mN m");
    assert_eq!(found["evidence"]["outcome"], "open", "{found}");
    let because = found["evidence"]["because"].as_str().expect("a reason");
    for says in [
        "0.14 … 0.15 mN m at the motor (0.0014 … 0.0015 N m at the device) in the scene",
        "give the scene the identified range, as `device.coulomb`",
    ] {
        assert!(because.contains(says), "{because}");
    }
}

#[test]
fn a_verdict_that_part_of_the_identified_range_does_not_have_is_open() {
    let dir = Dir::new();
    // Passive for the scene's friction, which is at the upper end of what was identified; up to the
    // speed where a little less does not suffice.
    let text = KNOB
        .replace("4e-5 N m s/rad ± 5%", "4e-5 N m s/rad")
        .replace("1.5e-3 N m ± 5%", "1.501e-3 N m")
        .replace("5 rad/s", "6.23 rad/s");
    let path = dir.write("scene.toml", text);
    let run = case_of_pushes(&dir, &path);
    let answer = scene(&run);
    assert_eq!(answer["verdict"], "passive", "{}", run.stderr);
    let evidence = answer["recorded"]["identification"]["evidence"].clone();
    assert_eq!(evidence["outcome"], "open", "{evidence}");
    let because = evidence["because"].as_str().expect("a reason");
    assert!(because.starts_with("over the identified ranges the verdict"));
    assert_eq!((run.code, answer["standing"].as_str()), (1, Some("open")));
    assert!(element(&dir, "G-identification-open").contains("undeveloped: true"));
}

/// What the scene allows and what the device may have: one must be within the other.
#[test]
fn friction_that_is_partly_outside_of_what_was_identified_is_open() {
    let dir = Dir::new();
    for (coulomb, outcome) in [
        ("1.5 … 3 mN m", "open"),
        ("1.4 … 3 mN m", "supports"),
        ("1.5 mN m", "supports"),
    ] {
        let text = KNOB.replace("1.5e-3 N m ± 5%", coulomb);
        let path = dir.write("scene.toml", text.replace("5 rad/s", "3 rad/s"));
        let run = case_of_pushes(&dir, &path);
        let evidence = scene(&run)["recorded"]["identification"]["evidence"].clone();
        assert_eq!(evidence["outcome"], outcome, "{coulomb}: {evidence}");
    }
}

#[test]
fn an_inertia_that_may_be_as_small_as_zero_leaves_the_case_open() {
    let dir = Dir::new();
    let text = KNOB.replace("inertia = \"2e-5 kg m^2\"\n", "");
    let path = dir.write("scene.toml", text);
    let run = case_of_pushes(&dir, &path);
    let evidence = scene(&run)["recorded"]["identification"]["evidence"].clone();
    assert_eq!((run.code, evidence["outcome"].as_str()), (1, Some("open")));
    let why = evidence["because"].as_str().expect("a reason");
    assert!(why.contains("how small the inertia is"), "{why}");
}

/// A case refuses such, after the scene was written.
#[test]
fn what_is_said_of_a_recording_is_asked_for_at_once() {
    let dir = Dir::new();
    let day = "expected a day such as 2026-11-20";
    let device = "expected which device was recorded, such as its name and serial number";
    for (option, value, says) in [
        ("--date", "22.11.2026", day),
        ("--date", "2026-02-30", day),
        ("--device", "", device),
        ("--device", " - ", device),
        ("--device", "TODO", device),
        ("--device", "xxx", device),
        (
            "--count-error",
            "1/2",
            "expected a number of ticks, such as 0.5",
        ),
        (
            "--force-error",
            "0.1 mN m",
            "expected a number of N, or of N m where the device turns, without the unit, such as 0.0001",
        ),
    ] {
        let run =
            crate::identify::identify(&dir, "push.csv", &["--out", "knob.toml", option, value]);
        assert_eq!(run.code, 2, "{}", run.stderr);
        assert!(run.stderr.contains(says), "{}", run.stderr);
        assert!(!dir.path("knob.toml").exists());
    }
}
