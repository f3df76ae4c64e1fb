//! `passivity case --check`: the files that a case must have, and the names of its scenes.

use std::fs;

use super::{BAD, GOOD, read};
use crate::harness::Dir;

/// A file that is not in the manifest is not compared: so those that a case must have are asked for.
#[test]
fn a_check_misses_a_document_that_was_taken_out_of_the_manifest() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    let whole = read(&dir, "case/manifest.json");
    for name in ["case.html", "good.gsn.svg", "good.gsn.yaml"] {
        let mut manifest: serde_json::Value = serde_json::from_str(&whole).expect("JSON");
        let files = manifest["files"].as_object_mut().expect("files");
        assert!(files.remove(name).is_some());
        dir.write("case/manifest.json", manifest.to_string());
        let run = dir.run(&["case", "--check", "case"]);
        assert_eq!(run.code, 1, "{}", run.stdout);
        let says = format!("`{name}` is a part of the case");
        assert!(run.stdout.contains(&says), "{}", run.stdout);
    }
}

#[test]
fn scenes_of_one_name_are_told_apart() {
    let dir = Dir::new();
    for folder in ["a", "b"] {
        fs::create_dir(dir.path(folder)).expect("a folder");
    }
    let scenes = [
        dir.write("a/good.toml", GOOD),
        dir.write("b/good.toml", BAD),
    ];
    let run = dir.run(&["case", &scenes[0], &scenes[1], "--out", "case"]);
    let check = dir.run(&["case", "--check", "case"]);
    for text in [run.stdout, check.stdout] {
        assert!(text.contains("\n  good: PASSIVE"), "{text}");
        assert!(text.contains("\n  good-2: NOT PASSIVE"), "{text}");
    }
}
