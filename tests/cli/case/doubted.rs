//! `passivity case --identification`: ranges that may be wrong, however narrow they are, are no evidence.

use super::identified::shipped;
use super::read;
use super::recorded::{case, element, scene};
use crate::harness::Dir;

/// What is known of a knob whose logs are simulated here, with a wall that is passive for this friction.
fn of(viscous: &str, coulomb: &str, counts: u32) -> String {
    format!(
        "# From its drawing.\n[device]\ninertia = \"2e-5 kg m^2\"\nviscous = \"{viscous} N m s/rad\"\n\
         coulomb = \"{coulomb} N m\"\n[sampling]\nrate = \"1 kHz\"\n[encoder]\ncounts_per_revolution = {counts}\n\
         [wall]\nstiffness = \"0.05 N m/rad\"\n"
    )
}

/// Where the knob is, and how fast, a millisecond later: exactly, for this viscous and Coulomb friction.
fn later([mut x, mut v]: [f64; 2], force: f64, [b, c]: [f64; 2]) -> [f64; 2] {
    let (rate, mut left) = (b / 2e-5, 1e-3);
    while left > 0.0 && (v != 0.0 || force.abs() > c) {
        let sign = if v == 0.0 { force } else { v }.signum();
        let (end, is_braked) = ((force - c * sign) / b, (force - c * sign) * v < 0.0);
        let stop = (-v / end).ln_1p() / rate;
        let time = if is_braked && stop < left { stop } else { left };
        let lost = -(-rate * time).exp_m1();
        x += end * time + (v - end) * lost / rate;
        v = if time == stop {
            0.0
        } else {
            v + (end - v) * lost
        };
        left -= time;
    }
    [x, v]
}

/// Let go away from zero, under a spring that the program computes; each force is logged a row late.
fn swing(ticks: f64) -> String {
    let tick = std::f64::consts::TAU / 8192.0;
    let (mut at, mut before) = ([ticks * tick, 0.0], None);
    let mut text = "t [s],count,f [N m]\n".to_owned();
    for row in 0..600 {
        let count = (at[0] / tick).floor();
        let force = -0.03 * count * tick;
        let logged = before.replace(force).unwrap_or(force);
        text += &format!("{},{count},{logged:e}\n", f64::from(row) / 1e3);
        at = later(at, force, [1e-5, 2e-4]);
    }
    text
}

/// A push, beside a constant force of a part in ten millions of the friction.
fn push(force: f64) -> String {
    let tick = std::f64::consts::TAU / 2e8;
    let mut at = [0.3 * tick, 0.0];
    let mut text = "t [s],count,f [N m]\n".to_owned();
    for row in 0..60 {
        let pushed = if row < 12 { force } else { 0.0 };
        let count = (at[0] / tick).floor();
        text += &format!("{},{count},{pushed}\n", f64::from(row) / 1e3);
        at = later(at, pushed + 1.5e-10, [4e-5, 1.5e-3]);
    }
    text
}

/// What a case says of two logs, which must be open for `why`.
fn open(dir: &Dir, scene_text: &str, logs: [&str; 2], more: &[&str], why: &[&str]) {
    let path = dir.write("scene.toml", scene_text);
    let evidence = ["--identification", logs[0], "--identification", logs[1]];
    let run = case(dir, &path, &[&evidence, more, &["--effort", "1"]].concat());
    let answer = scene(&run);
    assert_eq!(answer["verdict"], "passive", "{}", run.stderr);
    assert_eq!((run.code, answer["standing"].as_str()), (1, Some("open")));
    let evidence = &answer["recorded"]["identification"]["evidence"];
    assert_eq!(evidence["outcome"], "open", "{evidence}");
    let because = evidence["because"].as_str().expect("a reason");
    let node = element(dir, "G-identification-open");
    let html = read(dir, "case/case.html");
    for says in why {
        assert!(because.contains(says), "{says}: {because}");
        assert!(node.contains(says), "{says}: {node}");
        // As why it is open, and beside the assumption.
        assert!(html.matches(says).count() >= 3, "{says}");
    }
    assert!(!node.contains('…'), "the whole reason: {node}");
    let words = ["case", &path, "--out", "case", "--device", "k", "--date"];
    let words = [&words[..], &["2026-11-20", "--effort", "1"], more].concat();
    let evidence = ["--identification", logs[0], "--identification", logs[1]];
    let said = dir.run(&[&words[..], &evidence].concat());
    assert!(!said.stdout.contains("supports"), "{}", said.stdout);
    assert!(said.stdout.contains(why[0]), "{}", said.stdout);
}

/// The knob has a quarter of the friction that the swings seem to show, and its wall is active.
#[test]
fn a_force_that_may_be_in_the_wrong_row_leaves_the_case_open() {
    let dir = Dir::new();
    dir.write("there.csv", swing(300.4));
    dir.write("back.csv", swing(-409.6));
    let (seems, is) = (of("4e-5", "2e-4", 8192), of("1e-5", "2e-4", 8192));
    assert_ne!(dir.check(&is).code, 0);
    let why = [
        "with a force that acts a row later or earlier",
        "log each force in the row from which it acts",
    ];
    open(&dir, &seems, ["there.csv", "back.csv"], &[], &why);
    let html = read(&dir, "case/case.html");
    assert!(html.contains("explain every one of 1200 samples of free motion; but with a force"));
    // Nor do they show that the knob has no more friction than a scene says.
    let active = of("4.5e-5", "2.3e-4", 8192).replace("0.05 N m/rad", "0.5 N m/rad");
    let path = dir.write("scene.toml", active);
    let logs = "--identification there.csv --identification back.csv --effort 1";
    let logs: Vec<&str> = logs.split(' ').collect();
    case(&dir, &path, &logs);
    let says = "<strong>left open by the recording</strong></td><td>Identification: b and c are no more than";
    assert!(read(&dir, "case/case.html").contains(says));
    // What the knob really is contradicts such ranges, which are then not called sure.
    let path = dir.write("scene.toml", &is);
    let found = scene(&case(&dir, &path, &logs))["recorded"]["identification"].clone();
    assert_eq!(found["evidence"]["outcome"], "contradicts");
    let because = found["evidence"]["because"].as_str().expect("a reason");
    assert!(
        because.contains(why[0]) && !because.contains("surely"),
        "{because}"
    );
}

#[test]
fn motion_in_one_direction_leaves_the_case_open() {
    let dir = Dir::new();
    let [push, ramp] = ["push.csv", "ramp.csv"].map(shipped);
    let why = [
        "all motion, or nearly all, is in one direction",
        "record one log each way",
    ];
    open(&dir, &of("4e-5", "1.5e-3", 8192), [&push, &ramp], &[], &why);
}

#[test]
fn an_estimate_that_the_logs_refute_leaves_the_case_open_and_has_the_digits_of_identify() {
    let dir = Dir::new();
    dir.write("there.csv", push(0.012));
    dir.write("back.csv", push(-0.012));
    let why =
        ["the logs refute the best estimate, and no parameters were found that they do not refute"];
    let exact = ["--count-error", "0"];
    let logs = ["there.csv", "back.csv"];
    open(&dir, &of("4e-5", "1.5e-3", 200_000_000), logs, &exact, &why);
    let html = read(&dir, "case/case.html");
    assert!(html.contains("left open by the recording"));
    assert!(html.contains("whether constant b and c explain every one of 120 samples"));
    let identify = "identify there.csv back.csv --scene scene.toml --effort 1 --count-error 0";
    let words: Vec<&str> = identify.split(' ').collect();
    let said = dir.run(&words).stdout;
    let best = said
        .lines()
        .filter_map(|line| line.split_once("; best estimate "));
    let best: Vec<&str> = best.map(|(_, best)| best).collect();
    assert!(best.iter().any(|best| best.len() > 8), "{best:?}");
    for best in best {
        assert!(html.contains(&format!("<td>{best}</td>")), "{best}: {said}");
    }
}
