//! `passivity case`.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::harness::{Dir, Run, shipped};

const GOOD: &str =
    "# Measured on the bench.\n[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
const BAD: &str =
    "# Measured on the bench.\n[dimensionless]\nmu = \"50\"\nbeta = \"2/5\"\nsigma = \"2/5\"\n";

fn read(dir: &Dir, name: &str) -> String {
    fs::read_to_string(dir.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fs::read_dir(folder)
        .expect("a case")
        .map(|entry| {
            let entry = entry.expect("an entry");
            let name = entry.file_name().into_string().expect("UTF-8");
            (name, fs::read(entry.path()).expect("a file"))
        })
        .collect()
}

fn one_error(run: &Run, about: &str) {
    assert_eq!(run.code, 2, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
    assert_eq!(run.stderr.matches("error: ").count(), 1, "{}", run.stderr);
    assert!(run.stderr.contains(about), "{}", run.stderr);
    assert_eq!(run.stdout, "");
}

/// Everything that refers to an element of the page, and the ids that it has.
fn references(html: &str) -> (Vec<&str>, Vec<&str>) {
    let all = |mark: &'static str| {
        html.match_indices(mark)
            .map(|(at, _)| html[at + mark.len()..].split('"').next().expect("a quote"))
            .collect::<Vec<_>>()
    };
    (all("href=\"#"), all(" id=\""))
}

#[test]
fn writes_a_case_that_refers_to_nothing_that_is_not_there() {
    let dir = Dir::new();
    let (good, bad) = (dir.write("good.toml", GOOD), dir.write("bad.toml", BAD));
    let run = dir.run(&["case", &good, &bad, "--out", "case"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let html = read(&dir, "case/case.html");
    let (to, ids) = references(&html);
    assert!(to.len() > 50 && ids.len() > 50);
    for reference in &to {
        assert!(ids.contains(reference), "dangling: {reference}");
    }
    let mut unique = ids.clone();
    unique.sort_unstable();
    unique.dedup();
    assert_eq!(unique.len(), ids.len(), "every id once");
    for outside in ["http://", "https://", "<script", "<link", "<img", "@import"] {
        let found = html
            .replace("http://www.w3.org/2000/svg", "")
            .contains(outside);
        assert!(!found, "{outside}: the page needs nothing from outside");
    }
    for section in [
        "Summary and verdict",
        "Device and parameters",
        "Hazards",
        "Derivation",
        "Claims and evidence",
        "Traceability",
        "Assumptions",
        "What the paper got wrong",
        "Limits",
        "How to reproduce",
        "History of the verdicts",
        "no claim of compliance",
    ] {
        assert!(html.contains(section), "{section}");
    }
    assert_eq!(
        html.matches("<th scope=\"col\">").count(),
        html.matches("<th scope=\"col\"").count()
    );
    assert!(html.contains("<html lang=\"en\">"));
    let pictures = html.matches("<svg").count();
    assert_eq!(html.matches("role=\"img\"").count(), pictures);
    assert!(read(&dir, "case/bad.gsn.yaml").contains("defeated: true"));
    assert!(read(&dir, "case/bad.gsn.yaml").contains("challenges: G-passive"));
    assert!(!read(&dir, "case/good.gsn.yaml").contains("defeated: true"));
    let pdf = fs::read(dir.path("case/case.pdf")).expect("a PDF");
    assert!(pdf.starts_with(b"%PDF-") && pdf.len() > 20_000);
}

#[test]
fn exit_codes_are_those_of_the_verdict() {
    let dir = Dir::new();
    let lag = format!("{GOOD}[amplifier]\ntime_constant = \"1/5\"\n");
    for (text, code) in [(GOOD, 0), (BAD, 1), (lag.as_str(), 3)] {
        let scene = dir.write("scene.toml", text);
        let run = dir.run(&["case", &scene, "--out", "case", "--format", "json"]);
        assert_eq!(run.code, code, "{}", run.stderr);
        let strict = dir.run(&[
            "case", &scene, "--out", "case", "--strict", "--format", "json",
        ]);
        let objections = strict.json()["objections"]
            .as_array()
            .expect("a list")
            .len();
        let expected = if objections > 0 { 1 } else { code };
        assert_eq!(strict.code, expected, "{}", strict.stdout);
    }
}

#[test]
fn the_same_inputs_give_the_same_bytes() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    for out in ["one", "two", "one"] {
        assert_eq!(dir.run(&["case", &scene, "--out", out]).code, 0);
    }
    assert_eq!(files(&dir.path("one")), files(&dir.path("two")));
}

#[test]
fn a_check_finds_what_has_changed() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
    let check = || dir.run(&["case", "--check", "case", "--format", "json"]);
    let run = check();
    assert_eq!(
        (run.code, run.json()["current"].as_bool()),
        (0, Some(true)),
        "{}",
        run.stdout
    );
    dir.write("good.toml", BAD);
    let run = check();
    assert_eq!(run.code, 1);
    let changed = run.json()["changed"].to_string();
    assert!(changed.contains("good.toml` has changed"), "{changed}");
    assert!(
        changed.contains("the verdict is not_passive, in the case it is passive"),
        "{changed}"
    );
    // A scene that is gone is no change: the case has a copy of it.
    fs::remove_file(dir.path("good.toml")).expect("the scene");
    let run = check();
    assert_eq!(run.code, 0, "{}", run.stdout);
    assert!(run.json()["not_compared"].to_string().contains("good.toml"));
    let html = read(&dir, "case/case.html").replace("PASSIVE", "passive");
    dir.write("case/case.html", html);
    let run = check();
    assert_eq!(run.code, 1);
    assert!(
        run.json()["changed"]
            .to_string()
            .contains("`case.html` was changed"),
        "{}",
        run.stdout
    );
}

#[test]
fn history_grows_with_every_change_of_a_verdict() {
    let dir = Dir::new();
    for text in [GOOD, BAD, BAD, GOOD] {
        let scene = dir.write("scene.toml", text);
        dir.run(&["case", &scene, "--out", "case"]);
    }
    let manifest: serde_json::Value =
        serde_json::from_str(&read(&dir, "case/manifest.json")).expect("JSON");
    let verdicts: Vec<&str> = manifest["history"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|past| past["verdict"].as_str().expect("a verdict"))
        .collect();
    assert_eq!(verdicts, ["passive", "not_passive", "passive"]);
}

#[test]
fn an_error_leaves_no_half_written_case() {
    let dir = Dir::new();
    let good = dir.write("good.toml", GOOD);
    let broken = dir.write("broken.toml", "[dimensionless]\nbeta = \"x\"\n");
    one_error(
        &dir.run(&["case", &good, &broken, "--out", "case"]),
        "broken.toml",
    );
    assert!(!dir.path("case").exists());
    one_error(
        &dir.run(&["case", "none.toml", "--out", "case"]),
        "none.toml",
    );
    dir.write("file", "");
    one_error(&dir.run(&["case", &good, "--out", "file/case"]), "file");
    one_error(&dir.run(&["case", &good, "--out", "file"]), "file");
    // A folder with something else in it is left as it is.
    fs::create_dir(dir.path("mine")).expect("a folder");
    dir.write("mine/notes.txt", "mine");
    one_error(&dir.run(&["case", &good, "--out", "mine"]), "mine");
    assert_eq!(read(&dir, "mine/notes.txt"), "mine");
    // A case to which somebody added a file is not thrown away.
    assert_eq!(dir.run(&["case", &good, "--out", "case"]).code, 0);
    dir.write("case/notes.txt", "mine");
    one_error(&dir.run(&["case", &good, "--out", "case"]), "notes.txt");
    assert_eq!(read(&dir, "case/notes.txt"), "mine");
    one_error(&dir.run(&["case", "--check", "mine"]), "manifest.json");
    dir.write("case/manifest.json", "{\"format\": 1, \"files\": 7");
    one_error(&dir.run(&["case", "--check", "case"]), "manifest.json");
    one_error(
        &dir.run(&["case", &good, "--out", "new", "--root", "mine"]),
        "proofs/claims.toml",
    );
    let left: Vec<String> = fs::read_dir(dir.path("."))
        .expect("the folder")
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .into_string()
                .expect("UTF-8")
        })
        .filter(|name| name.starts_with('.') || name == "new")
        .collect();
    assert_eq!(left, Vec::<String>::new());
}

#[test]
fn every_shipped_scene_has_a_case() {
    let dir = Dir::new();
    let scenes = shipped();
    let mut args: Vec<&str> = vec!["case", "--format", "json", "--out", "case"];
    args.extend(scenes.iter().map(|path| path.to_str().expect("UTF-8")));
    let run = dir.run(&args);
    let document = run.json();
    let written = document["scenes"].as_array().expect("a list");
    assert_eq!(written.len(), scenes.len());
    for scene in written {
        let name = scene["name"].as_str().expect("a name");
        assert!(
            dir.path(&format!("case/{name}.gsn.svg")).is_file(),
            "{name}"
        );
        assert_eq!(
            scene["standing"] == "defeated",
            scene["verdict"] == "not_passive",
            "{name}"
        );
    }
    let html = read(&dir, "case/case.html");
    let (to, ids) = references(&html);
    assert!(to.iter().all(|reference| ids.contains(reference)));
}

/// A tree of its own with the claims, the recorded evidence and the kernel's sources.
fn tree(dir: &Dir) -> std::path::PathBuf {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let to = dir.path("tree");
    for folder in ["proofs", "crates/passivity-core/src"] {
        fs::create_dir_all(to.join(folder)).expect("a folder");
    }
    let kernel = fs::read_dir(from.join("crates/passivity-core/src")).expect("the kernel");
    let kernel = kernel.map(|entry| entry.expect("an entry").file_name());
    let kernel = kernel.map(|name| Path::new("crates/passivity-core/src").join(name));
    let files = ["proofs/claims.toml", "proofs/evidence.json"]
        .map(Path::new)
        .map(Path::to_owned);
    for file in kernel.chain(files) {
        fs::copy(from.join(&file), to.join(&file))
            .unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    }
    to
}

/// The recorded evidence, as if it had been recorded for the tree as it is.
fn recorded_now(root: &Path) -> serde_json::Value {
    let text = fs::read_to_string(root.join("proofs/evidence.json")).expect("evidence");
    let mut recorded: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let claims = passivity_evidence::Claims::read(root).expect("claims");
    for record in recorded["records"].as_array_mut().expect("records") {
        let claim = claims
            .find(record["claim"].as_str().expect("an id"))
            .expect("a claim");
        record["claim_sha256"] = claim.sha256().into();
        let sources = claim.sources(root).expect("sources");
        record["sources"] = serde_json::to_value(sources).expect("JSON");
    }
    recorded
}

/// How each record of the written case stands.
fn records(dir: &Dir) -> BTreeMap<String, String> {
    let manifest: serde_json::Value =
        serde_json::from_str(&read(dir, "case/manifest.json")).expect("JSON");
    let records = manifest["records"].as_object().expect("records").clone();
    records
        .into_iter()
        .map(|(id, words)| (id, words.as_str().expect("words").to_owned()))
        .collect()
}

#[test]
fn a_changed_line_makes_the_evidence_that_covers_it_stale_and_no_other() {
    let dir = Dir::new();
    let root = tree(&dir);
    let scene = dir.write("good.toml", GOOD);
    let evidence = root.join("proofs/evidence.json");
    let recorded = recorded_now(&root);
    fs::write(&evidence, recorded.to_string()).expect("evidence");
    let write = |case: &[&str]| {
        let mut args = vec!["case", "--root", "tree"];
        args.extend(case);
        dir.run(&args)
    };
    assert_ne!(write(&[&scene, "--out", "case"]).code, 2);
    let before = records(&dir);
    assert!(before.len() > 50, "{}", before.len());
    let file = "crates/passivity-core/src/region.rs";
    let text = fs::read_to_string(root.join(file)).expect("a source");
    fs::write(
        root.join(file),
        text.replace("(Less, Greater)", "(Greater, Less)"),
    )
    .expect("an edit");
    let run = write(&["--check", "case", "--format", "json"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let document = run.json();
    let stale: Vec<&str> = document["evidence"]
        .as_array()
        .expect("a list")
        .iter()
        .filter_map(|line| line.as_str())
        .collect();
    let covers = |record: &serde_json::Value| record["sources"].get(file).is_some();
    let ran = |record: &serde_json::Value| record["not_run"].is_null();
    let list = recorded["records"].as_array().expect("records");
    let covering: Vec<String> = list
        .iter()
        .filter(|record| covers(record) && ran(record))
        .map(|r| {
            format!(
                "{}/{}",
                r["claim"].as_str().expect("an id"),
                r["engine"].as_str().expect("an engine")
            )
        })
        .filter(|id| before[id] == "fresh")
        .collect();
    assert!(!covering.is_empty() && covering.len() < list.len());
    for line in &stale {
        let id = line.split(": ").next().expect("an id");
        assert!(covering.iter().any(|covering| covering == id), "{line}");
        assert!(line.contains(file), "{line}");
    }
    assert_eq!(stale.len(), covering.len());
    assert_eq!(
        document["unchanged"].as_u64(),
        Some((before.len() - covering.len()) as u64)
    );
    // Written anew, the case shows it, and a strict one is refused.
    let strict = write(&[&scene, "--out", "case", "--strict"]);
    assert_eq!(strict.code, 1);
    assert!(
        strict
            .stdout
            .contains("stale: changed since: crates/passivity-core/src/region.rs")
    );
    assert!(read(&dir, "case/case.html").contains("stale: changed since"));
}

#[test]
fn missing_and_corrupt_evidence_is_said_and_writes_nothing() {
    let dir = Dir::new();
    let root = tree(&dir);
    let scene = dir.write("good.toml", GOOD);
    let evidence = root.join("proofs/evidence.json");
    let text = fs::read_to_string(&evidence).expect("evidence");
    let run = |args: &[&str]| {
        dir.run(&[&["case", "--root", "tree", &scene, "--out", "case"], args].concat())
    };
    // A record that is missing was not run.
    let mut recorded: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let list = recorded["records"].as_array_mut().expect("records");
    list.retain(|record| record["claim"] != "TH-LIN");
    fs::write(&evidence, recorded.to_string()).expect("evidence");
    let written = run(&["--strict"]);
    assert_eq!(written.code, 1, "{}", written.stderr);
    let yaml = read(&dir, "case/good.gsn.yaml");
    let node = yaml.split("\nSn-TH-LIN:").nth(1).expect("the solution");
    let node = node.split("\n\n").next().expect("its lines");
    assert!(node.contains("standing: \"not run here\""), "{node}");
    fs::remove_dir_all(dir.path("case")).expect("the case");
    fs::write(&evidence, &text[..text.len() / 2]).expect("evidence");
    one_error(&run(&[]), "evidence.json");
    fs::remove_file(&evidence).expect("evidence");
    one_error(
        &run(&[]),
        "no evidence is recorded: `make prove` records it",
    );
    one_error(&run(&["--evidence", "none.json"]), "none.json");
    fs::write(&evidence, &text).expect("evidence");
    fs::write(root.join("proofs/claims.toml"), "[[claim]]\nid = 1\n").expect("claims");
    one_error(&run(&[]), "claims.toml");
    assert!(!dir.path("case").exists());
}
