//! `passivity case --log`: logs of the device as evidence.

use std::fs;

use serde_json::Value;

use super::read;
use crate::harness::{Dir, Run};

pub(super) const SCENE: &str =
    "# Measured on the bench.\n[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";

/// Positions with the force of the wall's law: −(⌊ξ⌋ + ½).
const LAW: &str = "tau,xi,f\n0,1/4,-0.5\n1,5/4,-1.5\n2,1/2,-0.5\n3,1/2,-0.5\n";
/// The operator is given energy: the motor pulls along the motion.
const ACTIVE: &str = "tau,xi,f\n0,1/4,-0.5\n1,5/4,-1.5\n2,1/2,50\n3,40,-40.5\n4,39,-39.5\n";
const FLIPPED: &str = "tau,xi,f\n0,1/4,0.5\n1,5/4,1.5\n2,1/2,0.5\n3,1/2,0.5\n";
const TWICE: &str = "tau,xi,f\n0,1/4,-1\n1,5/4,-3\n2,1/2,-1\n3,1/2,-1\n";
/// Counts, and a wall with a damper beside its spring.
const DAMPED: &str = "tau,count,f\n0,0,-0.500\n1,9,-9.000\n2,6,-6.800\n3,0,-0.900\n4,0,-0.500\n";
const LATE: &str = "tau,xi,f\n0,1/4,-0.5\n1,5/4,-0.5\n2,9/4,-1.5\n3,1/2,-2.5\n4,1/2,-0.5\n";

/// Writes a case with what more is said, in answer for programs.
pub(super) fn case(dir: &Dir, scene: &str, more: &[&str]) -> Run {
    let words = [
        "case", scene, "--out", "case", "--format", "json", "--device", "knob 3",
    ];
    let date = match more.contains(&"--date") {
        true => &[][..],
        false => &["--date", "2026-11-20"],
    };
    dir.run(&[&words, date, more].concat())
}

/// The one scene of the answer.
pub(super) fn scene(run: &Run) -> Value {
    run.json()["scenes"][0].clone()
}

/// An element of the argument, with all its lines.
pub(super) fn element(dir: &Dir, id: &str) -> String {
    let yaml = read(dir, "case/scene.gsn.yaml");
    let start = format!("\n{id}:\n");
    let node = yaml.split(&start).nth(1);
    let node = node.unwrap_or_else(|| panic!("{id}\n{yaml}"));
    node.split("\n\n").next().expect("its lines").to_owned()
}

#[test]
fn a_log_that_holds_is_evidence_with_its_hash_length_and_figures() {
    let dir = Dir::new();
    let (path, log) = (dir.write("scene.toml", SCENE), dir.write("run.csv", LAW));
    let run = case(&dir, &path, &["--log", &log]);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    let recorded = &scene(&run)["recorded"];
    assert_eq!(recorded["device_as_given"], "knob 3");
    let found = &recorded["logs"][0];
    let sum = passivity_evidence::Sha256::of(LAW.as_bytes()).to_string();
    assert_eq!(found["source"]["sha256"], sum.as_str());
    assert_eq!(found["source"]["date"], "2026-11-20");
    assert_eq!(found["evidence"]["outcome"], "supports");
    assert_eq!(found["duration_periods"]["lo"], "3");
    assert_eq!(found["duration_is_recorded"], true);
    let audit = dir.run(&["audit", &log, "--scene", &path, "--format", "json"]);
    let audit = audit.json();
    for field in ["verdict", "judged", "account", "samples", "totals", "force"] {
        assert_eq!(found["audit"][field], audit[field], "{field}");
    }
    let stored: Value = serde_json::from_str(&read(&dir, "case/scene.recorded.json")).unwrap();
    assert_eq!(&stored, recorded);
    let html = read(&dir, "case/case.html");
    for says in [
        sum.as_str(),
        "«knob 3»",
        "was not verified",
        "HOLDS: no interval generated more than friction dissipates",
        "4 samples, 3 sampling periods, by the times in the log",
        "law in all 4 rows",
        "1.9875 KΔ²",
        "Assumptions in the recordings",
        "is examined in what was recorded of it",
        "--log ",
    ] {
        assert!(html.contains(says), "{says}");
    }
    let solution = element(&dir, "Sn-log-1");
    assert!(solution.contains(&sum[..12]), "{solution}");
    assert!(solution.contains("standing: \"shown\""), "{solution}");
    assert!(element(&dir, "S-energy").contains("G-recorded"));
}

/// A ledger has no times, and says how long its intervals are.
#[test]
fn a_log_whose_intervals_say_how_long_they_are_is_not_one_without_times() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", SCENE);
    let logs = [
        "xi0,xi1,dtau\n0,1/4,2\n1/4,0,1\n",
        "xi\n0\n1/4\n0\n",
        "xi0,xi1\n0,1\n1,0\n",
    ];
    let texts = logs.map(|text| {
        let log = dir.write("run.csv", text);
        case(&dir, &path, &["--log", &log]);
        let page = read(&dir, "case/case.html");
        page.split_whitespace().collect::<Vec<_>>().join(" ")
    });
    let says = [
        "2 … 4 sampling periods, by how long its shortest and its longest intervals last",
        "sampling period: the log has no times",
    ];
    for (text, says) in texts.iter().zip(says) {
        assert!(text.contains(says), "{says}");
    }
    // No device writes one: that is said of the log, and on page one where it supports the case.
    let is_ledger = texts.map(|text| {
        text.matches("as passivity simulate --out writes it")
            .count()
    });
    assert_eq!(is_ledger, [1, 0, 2]);
}

#[test]
fn a_log_that_contradicts_leaves_the_top_goal_unsupported() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", SCENE);
    for (text, why) in [
        (ACTIVE, "the operator surely drew more"),
        (FLIPPED, "the force has the opposite sign"),
        (TWICE, "the force is 2 times that of the wall's law"),
        (LATE, "with 1 sample of delay, and the scene has no delay"),
        (
            DAMPED,
            "differs from the wall's law in 3 of 5 rows by more than its digits are off",
        ),
    ] {
        let log = dir.write("run.csv", text);
        let good = dir.write("good.csv", LAW);
        let run = case(&dir, &path, &["--log", &good, "--log", &log]);
        assert_eq!(run.code, 1, "{why}: {}", run.stderr);
        let answer = scene(&run);
        assert_eq!(answer["verdict"], "passive");
        assert_eq!(answer["standing"], "open");
        let [first, second] = [0, 1].map(|i| answer["recorded"]["logs"][i]["evidence"].clone());
        assert_eq!(first["outcome"], "supports");
        assert_eq!(second["outcome"], "contradicts", "{why}");
        assert!(
            second["because"].as_str().unwrap().contains(why),
            "{second}"
        );
        let objections = run.json()["objections"].to_string();
        assert!(objections.contains("G-log-2 is defeated"), "{objections}");
        let strict = dir.run(&["case", "--check", "case", "--strict"]);
        assert_eq!(strict.code, 1, "{}", strict.stdout);
        assert!(strict.stdout.contains("top goal open"), "{}", strict.stdout);
        assert!(strict.stdout.contains("G-log-2 is defeated"));
        assert!(element(&dir, "G-log-2").contains("defeated: true"));
        assert!(element(&dir, "CG-log-2").contains("challenges: G-log-2"));
        let html = read(&dir, "case/case.html");
        let page_one = html.split("<nav").next().expect("a first page");
        assert!(page_one.contains("contradicts the case"), "{page_one}");
        assert!(page_one.contains("the argument is not supported"));
        assert!(!page_one.contains("verdict good"), "nothing green");
    }
}

#[test]
fn counts_that_leave_it_open_are_no_support() {
    let dir = Dir::new();
    let text = "# Measured.\n[dimensionless]\nmu = \"50\"\nbeta = \"2/5\"\nsigma = \"3/5\"\n\
                [operator]\nmax_speed = \"1\"\n";
    let path = dir.write("scene.toml", text);
    let log = dir.write("run.csv", "count\n0\n1\n3\n3\n");
    let run = case(&dir, &path, &["--log", &log]);
    let answer = scene(&run);
    let audit = dir.run(&["audit", &log, "--scene", &path, "--format", "json"]);
    assert_eq!(audit.json()["verdict"], "depends");
    assert_eq!((run.code, answer["standing"].as_str()), (1, Some("open")));
    assert_eq!(answer["recorded"]["logs"][0]["evidence"]["outcome"], "open");
    assert!(element(&dir, "G-log-1-open").contains("undeveloped: true"));
    let html = read(&dir, "case/case.html");
    assert!(html.contains("leaves the case open"));
}

#[test]
fn a_changed_log_is_noticed_and_a_missing_one_is_said() {
    let dir = Dir::new();
    let (path, log) = (dir.write("scene.toml", SCENE), dir.write("run.csv", LAW));
    assert_eq!(case(&dir, &path, &["--log", &log]).code, 0);
    let check = || dir.run(&["case", "--check", "case", "--format", "json"]);
    assert_eq!(check().code, 0, "{}", check().stdout);
    dir.write("run.csv", LAW.replace("1/4", "1/3"));
    let run = check();
    assert_eq!(run.code, 1);
    let changed = run.json()["changed"].to_string();
    assert!(changed.contains("log `run.csv` has changed"), "{changed}");
    fs::remove_file(dir.path("run.csv")).expect("the log");
    let run = check();
    assert_eq!(run.code, 0, "{}", run.stdout);
    let missing = run.json()["not_compared"].to_string();
    assert!(
        missing.contains("run.csv") && missing.contains("top goal"),
        "{missing}"
    );
    assert_eq!(dir.run(&["case", "--check", "case", "--strict"]).code, 1);
    // The log is the same, and the scene is another: what the log comes to is found anew.
    dir.write("run.csv", LAW);
    dir.write(
        "scene.toml",
        SCENE.replace("[dim", "[sampling]\ndelay = 1\n[dim"),
    );
    let changed = check().json()["changed"].to_string();
    let says = "the recordings come to: contradicts; in the case to: supports";
    assert!(changed.contains(says), "{changed}");
}

#[test]
fn a_manifest_that_says_other_than_the_record_is_noticed() {
    let dir = Dir::new();
    let (path, log) = (dir.write("scene.toml", SCENE), dir.write("run.csv", LAW));
    assert_eq!(case(&dir, &path, &["--log", &log]).code, 0);
    let manifest = read(&dir, "case/manifest.json");
    let check = || dir.run(&["case", "--check", "case"]);
    assert_eq!(check().code, 0, "{}", check().stdout);
    let [before, after] = [LAW, &LAW.replace("1/2", "1/3")]
        .map(|text| passivity_evidence::Sha256::of(text.as_bytes()).to_string());
    for (old, new, says) in [
        ("\"knob 3\"", "\"knob 4\"", "which device was recorded"),
        (
            "2026-11-20",
            "2026-11-21",
            "the logs, their dates or their hashes",
        ),
        (
            before.as_str(),
            after.as_str(),
            "the logs, their dates or their hashes",
        ),
        (
            "\"count_error\": 1.0",
            "\"count_error\": 2.0",
            "what was given",
        ),
        ("\"effort\": null", "\"effort\": 7", "what was given"),
        ("\"supports\"", "\"open\"", "what the recordings come to"),
    ] {
        assert!(manifest.contains(old), "{old}: {manifest}");
        dir.write("case/manifest.json", manifest.replace(old, new));
        // The log is replaced along with its hash.
        dir.write(
            "run.csv",
            LAW.replace("1/2", if new == after { "1/3" } else { "1/2" }),
        );
        let run = check();
        assert_eq!(run.code, 1, "{new}: {}", run.stdout);
        assert!(run.stdout.contains(says), "{new}: {}", run.stdout);
    }
    // So is a scene.
    dir.write("run.csv", LAW);
    let other = SCENE.replace("bench", "desk");
    let [before, after] =
        [SCENE, &other].map(|text| passivity_evidence::Sha256::of(text.as_bytes()).to_string());
    dir.write("scene.toml", &other);
    let entry = format!("\"path\": \"scene.toml\",\n      \"sha256\": \"{before}\"");
    assert!(manifest.contains(&entry), "{manifest}");
    dir.write(
        "case/manifest.json",
        manifest.replace(&entry, &entry.replace(&before, &after)),
    );
    let run = check();
    assert_eq!(run.code, 1, "{}", run.stdout);
    assert!(
        run.stdout.contains("is another scene than"),
        "{}",
        run.stdout
    );
}

#[test]
fn names_that_are_hostile_stay_text() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", SCENE);
    let name = "<script>\"&'\u{202e}.csv";
    let log = dir.write(name, LAW);
    let device = "<b>knob</b>\u{202e}\u{7}";
    let words = [
        "case",
        &path,
        "--out",
        "case",
        "--log",
        &log,
        "--device",
        device,
        "--date",
        "2026-11-20",
    ];
    let run = dir.run(&words);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(!run.stdout.contains('\u{202e}'), "{}", run.stdout);
    for file in ["case.html", "scene.gsn.svg", "scene.gsn.yaml"] {
        let text = read(&dir, &format!("case/{file}"));
        assert!(
            !text.contains('\u{202e}') && !text.contains('\u{7}'),
            "{file}"
        );
        if file != "scene.gsn.yaml" {
            assert!(!text.contains("<script") && !text.contains("<b>"), "{file}");
            assert!(text.contains("&lt;script&gt;"), "{file}");
        }
    }
    assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
}

#[test]
fn what_is_missing_or_wrong_is_one_error_with_its_place() {
    let dir = Dir::new();
    let (path, log) = (dir.write("scene.toml", SCENE), dir.write("run.csv", LAW));
    let broken = dir.write("broken.csv", "tau,xi\n0,0\n1,x\n");
    let empty = dir.write("empty.csv", "xi\n");
    let counts = dir.write("counts.csv", "count\n0\n1\n");
    let other = dir.write("other.csv", "time,pos\n0,0\n1,1\n");
    let same = dir.write("same.csv", LAW);
    fs::create_dir(dir.path("folder")).expect("a folder");
    let given = ["--device", "d", "--date", "2026-11-20"];
    let with = |more: &[&'static str]| [&given[..], more].concat();
    for (words, about) in [
        (vec!["--log", log.as_str()], "--device"),
        (vec!["--log", &log, "--device", "d"], "--date"),
        (with(&["--columns", "x=pos"]), "--log or --identification"),
        (
            vec!["--log", &log, "--device", "TODO", "--date", "2026-11-20"],
            "--device",
        ),
        (
            vec!["--log", &log, "--device", "xxx", "--date", "2026-11-20"],
            "--device",
        ),
        (
            vec!["--log", &log, "--device", "d", "--date", "2026-02-30"],
            "2026-02-30",
        ),
        (
            [&given[..], &["--log", &log, "--date", "2026-11-21"]].concat(),
            "found 2",
        ),
        (
            [&given[..], &["--log", &broken]].concat(),
            "`broken.csv`: row 2, column `xi`",
        ),
        ([&given[..], &["--log", &empty]].concat(), "`empty.csv`"),
        ([&given[..], &["--log", "none.csv"]].concat(), "`none.csv`"),
        (
            [&given[..], &["--log", "folder"]].concat(),
            "expected a plain file",
        ),
        (
            [&given[..], &["--log", "-"]].concat(),
            "a log must be a file",
        ),
        (
            [&given[..], &["--log", &log, "--columns", "x"]].concat(),
            "--columns",
        ),
        (
            [&given[..], &["--identification", &empty]].concat(),
            "`empty.csv`",
        ),
        (
            [&given[..], &["--identification", &counts]].concat(),
            "the force that was commanded is needed",
        ),
        (
            [&given[..], &["--log", &log, "--log", &same]].concat(),
            "`same.csv` is the same log as `run.csv`",
        ),
        (
            [&given[..], &["--log", &other]].concat(),
            "run: passivity case scene.toml --out new --device d --date 2026-11-20 --log other.csv \
             --columns 'tau=time, xi=pos'",
        ),
        (
            [&given[..], &["--log", &log, &path]].concat(),
            "a log is of a device in one scene",
        ),
    ] {
        let run = dir.run(&[&["case", &path, "--out", "new"], &words[..]].concat());
        assert_eq!(run.code, 2, "{words:?}: {}{}", run.stdout, run.stderr);
        assert_eq!(run.stderr.matches("error: ").count(), 1, "{}", run.stderr);
        assert!(run.stderr.contains(about), "{about}: {}", run.stderr);
        assert!(!dir.path("new").exists(), "{words:?}");
    }
    // Each log has the date of its own.
    let second = dir.write("second.csv", LAW.replace("1/4", "1/3"));
    let words = [
        "--log",
        &log,
        "--log",
        &second,
        "--date",
        "2026-11-20",
        "--date",
        "2026-11-21",
    ];
    let run = case(&dir, &path, &words);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let logs = scene(&run)["recorded"]["logs"].clone();
    assert_eq!(logs[1]["source"]["date"], "2026-11-21");
    // A device may have any word in its name, as for `passivity identify`.
    let words = ["case", &path, "--out", "named", "--log", &log];
    let said = ["--device", "rig XXX-7", "--date", "2026-11-20"];
    let run = dir.run(&[&words[..], &said].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
}

#[test]
fn a_log_that_is_not_accounted_for_says_nothing_of_its_energies() {
    let dir = Dir::new();
    let late = format!("{SCENE}[sampling]\nlatency = \"1/100\"\n");
    let (path, log) = (dir.write("scene.toml", late), dir.write("run.csv", LAW));
    let run = case(&dir, &path, &["--log", &log]);
    assert_eq!(run.code, 3, "{}", run.stderr);
    let found = &scene(&run)["recorded"]["logs"][0];
    assert_eq!(found["evidence"]["outcome"], "open");
    assert_eq!(found["audit"]["totals"]["violates_linear"], Value::Null);
    let html = read(&dir, "case/case.html");
    let table = html.rsplit("Audit of «run.csv»").next().expect("its table");
    let table = table.split("</table>").next().expect("its end");
    for name in [
        "Generated, linear spring",
        "Dissipated less generated",
        "Deficit in",
    ] {
        let value = table.split(name).nth(1).expect("its row");
        let value = value.split("</tr>").next().expect("its end");
        assert!(value.contains("not accounted for"), "{name}: {value}");
    }
    assert!(!table.contains("Least energy balance"), "{table}");
}
