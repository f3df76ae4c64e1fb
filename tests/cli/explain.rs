//! `passivity explain`.

use crate::harness::{Dir, shipped};

#[test]
fn lists_just_the_effects_in_the_scene() {
    let dir = Dir::new();
    let scene = "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
    let name = dir.write("point.toml", scene);
    let run = dir.run(&["explain", &name]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stdout.contains("(3/5 − 1/2)·v + (3/5 − 1/2) ≥ 0"),
        "{}",
        run.stdout
    );
    let (derivation, rest) = run
        .stdout
        .split_once("Not in this scene")
        .expect("a list of absent effects");
    assert!(rest.contains("virtual damping"));
    for word in ["damping", "delay", "amplifier", "sat("] {
        assert!(!derivation.contains(word), "{word}: {derivation}");
    }
}

#[test]
fn explains_every_shipped_scene_in_both_formats() {
    let dir = Dir::new();
    for path in shipped() {
        let name = path.to_str().expect("a UTF-8 path");
        let text = dir.run(&["explain", name]);
        assert_eq!(text.code, 0, "{name}: {}", text.stderr);
        assert!(text.stdout.contains("Derivation") && text.stdout.contains("Verdict"));
        let document = dir.run(&["explain", "--format", "json", name]).json();
        assert!(
            !document["derivation"].as_array().expect("lines").is_empty(),
            "{name}"
        );
        assert!(document["check"]["verdict"].is_string(), "{name}");
    }
}
