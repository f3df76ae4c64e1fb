//! `passivity identify`: what it answers, writes and refuses.

use std::path::{Path, PathBuf};

use crate::harness::{Dir, Run};

mod refused;

fn shipped(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/identify");
    let path: PathBuf = folder.join(name);
    path.to_str().expect("UTF-8").to_owned()
}

pub(crate) fn identify(dir: &Dir, log: &str, more: &[&str]) -> Run {
    let (log, sketch) = (shipped(log), shipped("sketch.toml"));
    let mut words = vec!["identify", &log, "--scene", &sketch, "--effort", "1"];
    words.extend(more);
    dir.run(&words)
}

/// What the shipped logs were simulated with.
const TRUTH: [(&str, f64); 2] = [("viscous", 4e-5), ("coulomb", 1.5e-3)];

#[test]
fn a_scene_is_written_that_holds_what_is_true_and_is_checked() {
    let dir = Dir::new();
    let said = [
        "--out",
        "knob.toml",
        "--device",
        "knob\n3",
        "--date",
        "2026-11-22",
    ];
    let run = identify(&dir, "push.csv", &said);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stdout.contains("surely within these bounds"),
        "{}",
        run.stdout
    );
    let scene = std::fs::read_to_string(dir.path("knob.toml")).unwrap();
    assert!(
        scene.contains("# Device: knob 3\n# Recorded: 2026-11-22\n# Log: "),
        "{scene}"
    );
    assert!(scene.contains("133c77d24f7fc6510f46a6604313b140ab401caacc401f771673f3221e32b97f"));
    assert!(
        scene.contains("# A knob whose friction is not known"),
        "the sketch stays: {scene}"
    );
    let checked = dir.check(&scene);
    for (field, truth) in [
        ("beta", 4e-5 / (0.5 * 1e-3)),
        ("sigma", 1.5e-3 / (0.5 * std::f64::consts::TAU / 8192.0)),
    ] {
        let near = checked.approx(field);
        assert!((near / truth - 1.0).abs() < 0.01, "{field}: {near} {truth}");
        let ends = &checked.scene[field];
        assert_ne!(ends["lo"], ends["hi"]);
    }
    // The scene is a sketch itself, and its friction is replaced.
    let log = shipped("ramp.csv");
    let again = dir.run(&[
        "identify",
        &log,
        "--scene",
        "knob.toml",
        "--effort",
        "1",
        "--out",
        "second.toml",
    ]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    let second = std::fs::read_to_string(dir.path("second.toml")).unwrap();
    assert_eq!(second.matches("viscous = ").count(), 1, "{second}");
}

#[test]
fn an_estimate_is_written_within_its_range() {
    let dir = Dir::new();
    let ramp = shipped("ramp.csv");
    let run = identify(&dir, "push.csv", &[&ramp, "--out", "knob.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let scene = std::fs::read_to_string(dir.path("knob.toml")).unwrap();
    let number = |text: &str| text.trim().parse::<f64>().unwrap();
    for name in ["viscous friction", "Coulomb friction"] {
        let line = run.stdout.lines().find(|line| line.starts_with(name));
        let (range, best) = line
            .and_then(|line| line.split_once("; best estimate "))
            .unwrap_or_else(|| panic!("{name}: {}", run.stdout));
        let (lo, rest) = range.split_once(" … ").unwrap();
        let lo = number(lo.rsplit(' ').next().unwrap());
        let hi = number(rest.split(' ').next().unwrap());
        assert!(lo <= number(best) && number(best) <= hi, "{}", run.stdout);
        let noted = format!("# Best estimate of {name}: {best} N m");
        assert!(scene.contains(&noted), "{noted}: {scene}");
    }
}

#[test]
fn the_json_answer_is_as_the_contract_and_its_schema_say() {
    let dir = Dir::new();
    let run = identify(&dir, "push.csv", &["--format", "json"]);
    let answer = run.json();
    assert_eq!(run.code, 0);
    assert_eq!(
        (answer["samples"].as_u64(), answer["refuted_by"].is_null()),
        (Some(501), true)
    );
    assert_eq!(
        (&answer["informative"], &answer["best_refuted"]),
        (&true.into(), &false.into())
    );
    assert!(answer["version"].is_string());
    for (name, truth) in TRUTH {
        let known = &answer["parameters"][name];
        let [lo, hi, best] = ["lo", "hi", "best"].map(|end| known[end].as_f64().expect(end));
        assert!(
            lo <= truth && truth <= hi && lo <= best && best <= hi,
            "{known}"
        );
        assert!((best / truth - 1.0).abs() < 0.05, "{known}");
    }
    assert!(answer["parameters"]["inertia"].is_null());
    let schema = dir.run(&["schema", "identify"]).json();
    let known = schema["properties"].as_object().expect("properties");
    for field in answer.as_object().expect("an object").keys() {
        assert!(known.contains_key(field), "{field}");
    }
}

#[test]
fn several_logs_narrow_and_a_tolerance_of_the_inertia_is_held() {
    let dir = Dir::new();
    let width = |run: &Run| {
        let known = run.json()["parameters"]["coulomb"].clone();
        let [lo, hi] = ["lo", "hi"].map(|end| known[end].as_f64().expect(end));
        assert!(lo <= 1.5e-3 && 1.5e-3 <= hi, "{known}");
        hi - lo
    };
    let ramp = shipped("ramp.csv");
    let alone = width(&identify(&dir, "push.csv", &["--format", "json"]));
    let both = width(&identify(&dir, "push.csv", &[&ramp, "--format", "json"]));
    assert!(both < alone, "{both} {alone}");
    let sketch = std::fs::read_to_string(shipped("sketch.toml")).unwrap();
    let loose = sketch.replace("2e-5 kg m^2", "2.1e-5 kg m^2 ± 10%");
    let loose = loose.replace("[wall]\nstiffness = \"0.5 N m/rad\"\n", "");
    dir.write("loose.toml", loose);
    let push = shipped("push.csv");
    let words = [
        "identify",
        &push,
        "--scene",
        "loose.toml",
        "--effort",
        "1",
        "--format",
        "json",
        "--out",
        "knob.toml",
    ];
    let run = dir.run(&words);
    assert!(width(&run) > alone);
    assert!(run.stderr.contains("has no wall yet"), "{}", run.stderr);
}

#[test]
fn a_device_that_is_none_of_the_model_is_refuted_at_its_place() {
    let dir = Dir::new();
    let run = identify(
        &dir,
        "backlash.csv",
        &["--format", "json", "--out", "none.toml"],
    );
    assert_eq!(run.code, 1, "{}", run.stderr);
    let answer = run.json();
    let refuted = &answer["refuted_by"];
    let row = refuted["row"].as_f64().expect("a row");
    assert!((2.0..=551.0).contains(&row), "{refuted}");
    assert!((refuted["time"].as_f64().unwrap() - (row - 1.0) * 1e-3).abs() < 1e-9);
    assert!(refuted["log"].as_str().unwrap().ends_with("backlash.csv"));
    assert!(answer["parameters"]["viscous"].is_null());
    assert!(!dir.path("none.toml").exists());
    let says = "none.toml is not written: no parameters fit the logs";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    let text = identify(&dir, "backlash.csv", &[]);
    assert!(text.stdout.contains("it may be: "), "{}", text.stdout);
}

#[test]
fn an_inertia_that_may_be_as_small_as_zero_is_in_no_scene() {
    let dir = Dir::new();
    let run = identify(&dir, "push.csv", &["--inertia", "free", "--out", "x.toml"]);
    assert!(
        run.stdout.contains("inertia           0 … "),
        "{}",
        run.stdout
    );
    assert_eq!(
        run.code, 0,
        "some parameters fit, and every bound is finite"
    );
    let says = "x.toml is not written: the logs leave open how small the inertia is";
    assert!(run.stderr.contains(says), "{}", run.stderr);
    assert!(!dir.path("x.toml").exists());
}

/// Rows at rest cost work: what the bounds lack is said to be work, before it is said to be another log.
#[test]
fn a_search_that_is_stopped_asks_for_more_effort_first() {
    let dir = Dir::new();
    let push = std::fs::read_to_string(shipped("push.csv")).unwrap();
    let rows: Vec<&str> = push
        .lines()
        .skip(1)
        .filter_map(|row| row.split_once(',').map(|(_, rest)| rest))
        .collect();
    let count = rows[0].split(',').next().unwrap();
    let at_rest = format!("{count},0\n").repeat(5000);
    let log = format!("count,f [N m]\n{at_rest}{}\n", rows.join("\n"));
    let log = dir.write("rest.csv", log);
    let sketch = shipped("sketch.toml");
    let words = ["identify", &log, "--scene", &sketch, "--effort", "1"];
    let json = dir
        .run(&[&words[..], &["--format", "json"]].concat())
        .json();
    assert_eq!(
        (&json["stopped_early"], &json["informative"]),
        (&true.into(), &false.into())
    );
    let says = "a larger --effort may narrow the bounds";
    let first = json["lacks"][0].as_str().unwrap();
    assert!(first.starts_with(says), "{first}");
    let text = dir.run(&words).stdout;
    let lacks: Vec<&str> = text
        .lines()
        .filter_map(|line| line.strip_prefix("to know more: "))
        .collect();
    assert!(lacks[0].starts_with(says), "{text}");
    assert_eq!(text.matches("--effort").count(), 1, "{text}");
}

#[test]
fn motion_in_one_direction_is_not_enough() {
    let dir = Dir::new();
    let one = identify(&dir, "push.csv", &["--format", "json"]).json();
    let says = one["lacks"][0].as_str().expect("a line");
    assert!(says.contains("record one log each way"), "{says}");
    assert_eq!(one["informative"], true, "the bounds are narrow");
    let text = std::fs::read_to_string(shipped("push.csv")).unwrap();
    let back = text.lines().map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        match fields[..] {
            [t, count, f] if count != "count" => {
                let count: i64 = count.parse().unwrap();
                format!("{t},{},-{f}\n", -count).replace("--", "")
            }
            _ => format!("{line}\n"),
        }
    });
    let back = dir.write("back.csv", back.collect::<String>());
    let both = identify(&dir, "push.csv", &[&back]);
    assert!(!both.stdout.contains("each way"), "{}", both.stdout);
    assert_eq!(both.code, 0, "{}{}", both.stdout, both.stderr);
}

#[test]
fn what_is_wrong_with_a_sketch_without_a_wall_is_said_of_what_is_in_it() {
    let dir = Dir::new();
    let sketch = std::fs::read_to_string(shipped("sketch.toml")).unwrap();
    let sketch = sketch.replace("[wall]\nstiffness = \"0.5 N m/rad\"\n", "");
    for (old, new, says) in [
        ("= 8192", "= 8192.5", "expected a whole number"),
        ("kg m^2\"", "kgm2\"", "unknown unit `kgm`"),
        ("kg m^2\"", "kg m^2 ± 100%\"", "as low as 0 kg m^2"),
        ("rate = \"1 kHz\"", "", "`period` or `rate`"),
        (
            "inertia = \"2e-5 kg m^2\"",
            "mass = \"1 kg\"",
            "`device.mass` is linear",
        ),
    ] {
        let path = dir.write("sketch.toml", sketch.replace(old, new));
        let run = dir.run(&["identify", &shipped("push.csv"), "--scene", &path]);
        assert_eq!(run.code, 2, "{new}");
        assert!(run.stderr.contains(says), "{new}: {}", run.stderr);
        assert!(!run.stderr.contains("wall"), "{new}: {}", run.stderr);
        assert_eq!(run.stderr.lines().count(), 1, "{new}: {}", run.stderr);
    }
}

/// A sketch that is no text of a scene is refused as `check` refuses such a scene.
#[test]
fn what_cannot_be_read_as_a_sketch_is_said_as_of_a_scene() {
    let dir = Dir::new();
    dir.write("bytes.toml", b"[device]\n# \xff\n");
    let large = usize::try_from(passivity_scene::parse::MAX_BYTES).unwrap() + 1;
    dir.write("large.toml", "#".repeat(large));
    for (sketch, says) in [
        ("bytes.toml", "this byte is not UTF-8"),
        ("large.toml", "the file is too large"),
        ("none.toml", "there is no such file"),
        (".", "this is a folder"),
        #[cfg(unix)]
        ("/dev/zero", "this is a pipe or a device"),
    ] {
        let run = dir.run(&["identify", &shipped("push.csv"), "--scene", sketch]);
        assert_eq!(run.code, 2, "{sketch}: {}", run.stderr);
        assert!(run.stderr.contains(says), "{sketch}: {}", run.stderr);
        let checked = dir.run(&["check", sketch]);
        assert_eq!(run.stderr, checked.stderr, "{sketch}");
    }
}

#[test]
fn the_delay_of_the_walls_law_is_not_that_of_the_log_and_said_so() {
    let dir = Dir::new();
    let sketch = std::fs::read_to_string(shipped("sketch.toml")).unwrap();
    let late = dir.write(
        "late.toml",
        sketch.replace("\"1 kHz\"", "\"1 kHz\"\ndelay = 1"),
    );
    let words = [
        "identify",
        &shipped("push.csv"),
        "--scene",
        &late,
        "--effort",
        "1",
    ];
    let run = dir.run(&words);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stderr.contains("in effect from that row on"),
        "{}",
        run.stderr
    );
}

#[test]
fn a_log_without_motion_bounds_nothing() {
    let dir = Dir::new();
    let log = dir.write("still.csv", "count,f [N m]\n5,0\n5,0\n6,0\n5,0\n");
    let sketch = shipped("sketch.toml");
    let run = dir.run(&[
        "identify",
        &log,
        "--scene",
        &sketch,
        "--format",
        "json",
        "--plot",
        "still.svg",
    ]);
    assert_eq!(run.code, 1);
    let answer = run.json();
    assert!(answer["parameters"]["viscous"]["hi"].is_null());
    assert!(answer["lacks"][0].as_str().unwrap().contains("no force"));
    assert!(dir.path("still.svg").exists());
}

#[test]
fn a_picture_is_drawn() {
    let dir = Dir::new();
    let run = identify(&dir, "push.csv", &["--plot", "fit.svg"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let picture = std::fs::read_to_string(dir.path("fit.svg")).unwrap();
    for words in [
        "residual in ticks",
        "best estimate",
        "viscous friction, % from",
    ] {
        assert!(picture.contains(words), "{words}");
    }
    // The devices with the least and the most friction start together, where the measured one did.
    let dashed = picture
        .lines()
        .filter(|line| line.contains("stroke-width=\"1\"") && line.contains("\"7 4\""));
    let starts = dashed.filter_map(|line| line.split("points=\"").nth(1)?.split(' ').next());
    let first = picture.split("<circle cx=\"").nth(1).expect("a sample");
    let mut numbers = first.split('"');
    let (x, y) = (numbers.next().expect("x"), numbers.nth(1).expect("y"));
    let starts: Vec<&str> = starts.take(2).collect();
    let first = format!("{x},{y}");
    assert_eq!(starts, [first.as_str(); 2]);
}
