//! `passivity case` into a folder that has a case: what somebody changed there is not lost.

use std::fs;

use super::{BAD, GOOD, files, one_error, read};
use crate::harness::Dir;

/// A folder `case` in which a bad verdict was followed by a good one.
fn written(dir: &Dir) -> String {
    for text in [BAD, GOOD] {
        let scene = dir.write("scene.toml", text);
        let run = dir.run(&["case", &scene, "--out", "case"]);
        assert_eq!(run.code, i32::from(text == BAD), "{}", run.stderr);
    }
    "scene.toml".to_owned()
}

/// The history is that of the document: a manifest from which a verdict was taken out is not continued.
#[test]
fn a_case_whose_history_may_be_another_than_it_was_is_not_written_again() {
    let dir = Dir::new();
    let scene = written(&dir);
    let whole = files(&dir.path("case"));
    let restore = "restore the folder, or write the case into another one";
    let shorter = |dir: &Dir| {
        let mut manifest: serde_json::Value =
            serde_json::from_str(&read(dir, "case/manifest.json")).expect("JSON");
        let history = manifest["history"].as_array_mut().expect("a list");
        assert_eq!(history.remove(0)["verdict"], "not_passive");
        dir.write("case/manifest.json", manifest.to_string());
    };
    let edited = |dir: &Dir| {
        let page = read(dir, "case/case.html").replace("NOT PASSIVE", "PASSIVE");
        dir.write("case/case.html", page);
    };
    let without = |name: &str| fs::remove_file(dir.path("case").join(name)).expect("a file");
    let edits: [(&dyn Fn(), &str); 4] = [
        (
            &|| shorter(&dir),
            "`case.html` and `manifest.json` are not of one case",
        ),
        (
            &|| edited(&dir),
            "`case.html` was changed after it was written",
        ),
        (&|| without("manifest.json"), "`manifest.json` is missing"),
        (&|| without("case.html"), "`case.html` is missing"),
    ];
    for (edit, says) in edits {
        edit();
        let before = files(&dir.path("case"));
        let again = dir.run(&["case", &scene, "--out", "case"]);
        one_error(&again, says);
        assert!(again.stderr.contains(restore), "{}", again.stderr);
        assert_eq!(files(&dir.path("case")), before, "{says}");
        for (name, bytes) in &whole {
            dir.write(&format!("case/{name}"), bytes);
        }
    }
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
}

#[test]
fn files_of_the_case_that_were_edited_are_named_and_kept() {
    let dir = Dir::new();
    let scene = written(&dir);
    let own = ["case/scene.gsn.svg", "case/scene.toml"].map(|name| {
        dir.write(name, read(&dir, name) + "\n");
        name
    });
    let before = files(&dir.path("case"));
    let again = dir.run(&["case", &scene, "--out", "case"]);
    one_error(
        &again,
        "and writing the case again would lose it: move it elsewhere",
    );
    for name in own {
        let says = format!("`{name}`: changed since the case was written");
        assert!(again.stderr.contains(&says), "{}", again.stderr);
    }
    assert_eq!(files(&dir.path("case")), before);
    for name in own {
        fs::rename(dir.path(name), dir.path("mine")).expect("the file");
    }
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
}

/// Nobody loses what is written there anyway.
#[test]
fn a_file_that_is_as_it_would_be_written_is_no_obstacle() {
    let dir = Dir::new();
    let scene = written(&dir);
    let next = GOOD.replace("[wall]", "[wall] # of today");
    dir.write(&scene, &next);
    dir.write("case/scene.toml", &next);
    let again = dir.run(&["case", &scene, "--out", "case"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    assert_eq!(read(&dir, "case/scene.toml"), next);
}

/// Of processes that write one case at once, each adds its verdict or says that it does not.
#[test]
fn no_verdict_of_cases_that_are_written_at_once_is_lost() {
    let dir = Dir::new();
    let scenes: Vec<String> = (0..6)
        .map(|i| dir.write(&format!("scene-{i}.toml"), GOOD))
        .collect();
    let first = dir.write("first.toml", GOOD);
    assert_eq!(dir.run(&["case", &first, "--out", "case"]).code, 0);
    let runs: Vec<_> = std::thread::scope(|scope| {
        let run = |scene| dir.run(&["case", scene, "--out", "case"]);
        let runs: Vec<_> = scenes
            .iter()
            .map(|scene| scope.spawn(move || run(scene)))
            .collect();
        let joined = runs.into_iter().map(|run| run.join().expect("a run"));
        joined.collect()
    });
    let manifest: serde_json::Value =
        serde_json::from_str(&read(&dir, "case/manifest.json")).expect("JSON");
    let history = manifest["history"].as_array().expect("a list");
    let has = |name: &str| history.iter().any(|entry| entry["scene"] == name);
    assert!(has("first"), "{manifest}");
    for (i, run) in runs.iter().enumerate() {
        let added = has(&format!("scene-{i}"));
        assert_eq!(run.code, if added { 0 } else { 2 }, "{}", run.stderr);
        assert_eq!(run.stderr.is_empty(), added, "{}", run.stderr);
    }
}

/// What a link leads to is written, and the link is kept.
#[cfg(unix)]
#[test]
fn a_case_behind_a_link_is_written_where_the_link_leads() {
    let dir = Dir::new();
    let scene = dir.write("scene.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    std::os::unix::fs::symlink("case", dir.path("link")).expect("a link");
    dir.write("scene.toml", BAD);
    assert_eq!(dir.run(&["case", &scene, "--out", "link"]).code, 1);
    assert!(dir.path("link").is_symlink());
    assert_eq!(files(&dir.path("link")), files(&dir.path("case")));
    let manifest: serde_json::Value =
        serde_json::from_str(&read(&dir, "case/manifest.json")).expect("JSON");
    assert_eq!(manifest["history"].as_array().expect("a list").len(), 2);
}
