//! `passivity check --certificate`, and what a second implementation says of it.

use crate::harness::{Dir, Run};

/// Checks a scene, with a certificate.
fn certified(dir: &Dir, scene: &str) -> Run {
    dir.write("scene.toml", scene);
    let options = ["--format", "json", "--certificate", "certificate.json"];
    dir.run(&[&["check", "scene.toml"][..], &options].concat())
}

fn scene(beta: &str, rest: &str) -> String {
    format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"2\"\n{rest}")
}

#[test]
fn the_certificate_of_a_scene_is_written_and_confirmed() {
    let dir = Dir::new();
    let late = "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2\"\n";
    for (beta, code, says) in [("5/4", 0, "is enough"), ("1.2499", 1, "is not enough")] {
        let run = certified(&dir, &scene(beta, late));
        assert_eq!((run.code, run.stderr.as_str()), (code, ""));
        let found = dir.check_certificates(&["certificate.json"]);
        assert_eq!(found.code, 0, "{}", found.stderr);
        assert!(found.stdout.contains(says), "{}", found.stdout);
    }
}

#[test]
fn where_no_polynomial_decides_there_is_no_certificate() {
    let lag = "[amplifier]\ntime_constant = \"1/2\"\n";
    let clipped = "[sampling]\ndelay = 1\n[wall]\nunilateral = true\n";
    let tolerant = "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2 ± 10 %\"\n";
    let deep = "[sampling]\ndelay = 40\n[wall]\ndamping = \"1/2\"\n";
    for (rest, says) in [
        (lag, "behind a latency or an amplifier"),
        (clipped, "behind a one-sided or saturated wall"),
        (tolerant, "a certificate is of one loop"),
        (deep, "of a degree above 24"),
    ] {
        let dir = Dir::new();
        let run = certified(&dir, &scene("50", rest));
        assert!(run.code <= 1, "{}", run.stderr);
        let starts = run.stderr.starts_with("no certificate is written: ");
        assert!(starts && run.stderr.contains(says), "{rest}{}", run.stderr);
        assert!(!dir.path("certificate.json").exists());
    }
    let dir = Dir::new();
    dir.write("scene.toml", scene("1", ""));
    for (arguments, says) in [
        (
            &["scene.toml", "scene.toml", "--certificate", "c.json"][..],
            "a certificate is of one scene",
        ),
        (
            &["scene.toml", "--certificate", "scene.toml"][..],
            "is read by this check",
        ),
    ] {
        let run = dir.run(&[&["check"][..], arguments].concat());
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(says), "{}", run.stderr);
    }
}
