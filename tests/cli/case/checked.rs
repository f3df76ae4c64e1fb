//! `passivity case --check`: the files that a case must have, and the names of its scenes.

use std::fs;

use super::recorded::case;
use super::{BAD, GOOD, one_error, read};
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

/// Nothing that is at hand says what the verdicts were: the document has a hash of them.
#[test]
fn a_check_finds_a_manifest_in_which_the_past_was_rewritten() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    dir.write("good.toml", BAD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 1);
    assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
    let whole = read(&dir, "case/manifest.json");
    let edits: [fn(&mut serde_json::Value); 9] = [
        |past| past["history"][1]["verdict"] = "passive".into(),
        |past| past["history"][0]["headline"] = "PASSIVE at every speed, as ever".into(),
        |past| {
            past["history"].as_array_mut().expect("a list").remove(0);
        },
        |past| past["passivity"] = "9.9.9".into(),
        |past| past["commit"] = "0123".into(),
        |past| {
            let commit = past["commit"].as_str().unwrap_or_default().to_owned();
            past["commit"] = match commit.is_empty() {
                true => "".into(),
                false => serde_json::Value::Null,
            };
        },
        // An entry that another one swallows, as lines of its last field.
        |past| {
            let history = past["history"].as_array_mut().expect("a list");
            let last = history.pop().expect("an entry");
            let fields = [
                "scene",
                "scene_sha256",
                "claims_sha256",
                "version",
                "verdict",
                "headline",
            ];
            let lines = fields.map(|field| last[field].as_str().expect("a text").to_owned());
            let line = history[0]["headline"].as_str().expect("a text").to_owned();
            history[0]["headline"] = format!("{line}\n{}", lines.join("\n")).into();
        },
        |past| past["scenes"] = serde_json::json!({}),
        |past| {
            let scenes = past["scenes"].as_object_mut().expect("scenes");
            let scene = scenes.remove("good").expect("a scene");
            scenes.insert("better".to_owned(), scene);
        },
    ];
    let says = "changed: the version, the commit, the scenes and the history of verdicts: `manifest.json` says other";
    for (number, edit) in edits.iter().enumerate() {
        let mut manifest: serde_json::Value = serde_json::from_str(&whole).expect("JSON");
        edit(&mut manifest);
        dir.write("case/manifest.json", manifest.to_string());
        let run = dir.run(&["case", "--check", "case"]);
        assert_eq!(run.code, 1, "{number}: {}", run.stdout);
        assert!(run.stdout.contains(says), "{number}: {}", run.stdout);
    }
}

/// The hash of a document may be that of one that somebody changed: what it says of the scene is written once more.
#[test]
fn a_check_finds_a_document_that_was_changed_together_with_its_hash() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", GOOD);
    let log = dir.write("run.csv", "tau,xi\n0,1/4\n1,5/4\n2,1/2\n");
    assert_eq!(case(&dir, &path, &["--log", &log]).code, 0);
    let page = read(&dir, "case/case.html");
    let manifest = read(&dir, "case/manifest.json");
    let sum = |page: &str| passivity_evidence::Sha256::of(page.as_bytes()).to_string();
    for (old, new, what) in [
        ("", "", None),
        (
            "PASSIVE at every speed",
            "PASSIVE for ever",
            Some("the verdicts on page one"),
        ),
        (
            "knob 3",
            "knob 4",
            Some("the scene scene and its recordings"),
        ),
        (
            "Measured on the bench.",
            "Weighed.",
            Some("the scene scene and its recordings"),
        ),
    ] {
        let changed = page.replace(old, new);
        dir.write(
            "case/manifest.json",
            manifest.replace(&sum(&page), &sum(&changed)),
        );
        dir.write("case/case.html", changed);
        let run = dir.run(&["case", "--check", "case"]);
        assert_eq!(run.code, i32::from(what.is_some()), "{}", run.stdout);
        let says = what.map(|what| format!("changed: {what}: `case.html` says other"));
        assert!(
            run.stdout.contains(&says.unwrap_or_default()),
            "{}",
            run.stdout
        );
    }
}

/// A case that was written before its document had that hash says that it is not compared.
#[test]
fn a_check_says_that_it_has_nothing_to_compare_the_past_with() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    let html = read(&dir, "case/case.html");
    let html = html.replace(
        "SHA-256 of version, commit, scenes and history",
        "Something else",
    );
    let mut manifest: serde_json::Value =
        serde_json::from_str(&read(&dir, "case/manifest.json")).expect("JSON");
    let sum = passivity_evidence::Sha256::of(html.as_bytes());
    manifest["files"]["case.html"] = sum.to_string().into();
    dir.write("case/case.html", html);
    dir.write("case/manifest.json", manifest.to_string());
    let run = dir.run(&["case", "--check", "case"]);
    assert_eq!(run.code, 0, "{}", run.stdout);
    let says = "not compared: the version, the commit, the scenes and the history of verdicts: `case.html` is from before";
    assert!(run.stdout.contains(says), "{}", run.stdout);
    assert_eq!(dir.run(&["case", "--check", "case", "--strict"]).code, 1);
}

/// A scene that is active is not taken out of the case by leaving it out of the manifest's scenes.
#[test]
fn a_check_misses_a_scene_that_was_taken_out_of_the_manifest() {
    let dir = Dir::new();
    let scenes = [dir.write("good.toml", GOOD), dir.write("bad.toml", BAD)];
    let run = dir.run(&["case", &scenes[0], &scenes[1], "--out", "case"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let mut manifest: serde_json::Value =
        serde_json::from_str(&read(&dir, "case/manifest.json")).expect("JSON");
    let of_scenes = manifest["scenes"].as_object_mut().expect("scenes");
    assert!(of_scenes.remove("bad").is_some());
    dir.write("case/manifest.json", manifest.to_string());
    let run = dir.run(&["case", "--check", "case"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    let says =
        "the scenes and the history of verdicts: `manifest.json` says other than `case.html`";
    assert!(run.stdout.contains(says), "{}", run.stdout);
}

/// What is called like a file of the case, and is none, is told of, and not lost.
#[test]
fn a_pdf_that_somebody_put_beside_the_case_is_no_part_of_it() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    for name in ["case.pdf", "case.info.toml"] {
        let own = dir.write(&format!("case/{name}"), "of somebody");
        let check = dir.run(&["case", "--check", "case"]);
        let says = format!("changed: `{name}` is none of the case's files");
        assert!(
            check.code == 1 && check.stdout.contains(&says),
            "{}",
            check.stdout
        );
        let again = dir.run(&["case", &scene, "--out", "case"]);
        one_error(
            &again,
            "no part of the case, and writing the case again would lose it",
        );
        assert_eq!(read(&dir, &own), "of somebody");
        fs::remove_file(dir.path(&own)).expect("the file");
    }
    assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
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
    let words = ["case", &scenes[0], &scenes[1], "--out", "case"];
    let run = dir.run(&words);
    let check = dir.run(&["case", "--check", "case"]);
    for text in [run.stdout, check.stdout] {
        assert!(text.contains("\n  good: PASSIVE"), "{text}");
        assert!(text.contains("\n  good-2: NOT PASSIVE"), "{text}");
        assert!(
            text.contains("\n    good-2: G-passive is defeated"),
            "{text}"
        );
    }
    let json = dir
        .run(&[&words[..], &["--format", "json"]].concat())
        .json();
    let check = dir.run(&["case", "--check", "case", "--format", "json"]);
    for json in [json, check.json()] {
        let names = [0, 1].map(|i| json["scenes"][i]["scene"].clone());
        assert_eq!(names, ["good", "good-2"]);
    }
    let html = read(&dir, "case/case.html");
    for says in [
        "good: PASSIVE",
        "good-2: NOT PASSIVE",
        "«good-2» is not passive",
    ] {
        assert!(html.contains(says), "{says}");
    }
}
