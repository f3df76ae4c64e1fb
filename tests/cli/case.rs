//! `passivity case`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use passivity_evidence::{Claim, Claims, Engine, Evidence, Outcome, Record, Sha256, Shown, Tool};

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
        "What is shown",
        "What is not shown",
        "Glossary",
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
    assert!(!dir.path("case/case.pdf").exists(), "only --pdf prints");
}

#[test]
fn exit_codes_are_those_of_the_verdict() {
    let dir = Dir::new();
    let lag = format!("{GOOD}[amplifier]\ntime_constant = \"1/5\"\n");
    for (text, code) in [(GOOD, 0), (BAD, 1), (lag.as_str(), 1)] {
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

/// A tree of its own with the claims, the recorded evidence and every file that it rests on.
fn tree(dir: &Dir) -> std::path::PathBuf {
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let to = dir.path("tree");
    let text = fs::read_to_string(from.join("proofs/evidence.json")).expect("evidence");
    let recorded = Evidence::parse("evidence", &text).expect("evidence");
    let claims = Claims::read(&from).expect("claims");
    let mut files: BTreeSet<String> = claims.claims.iter().flat_map(Claim::files).collect();
    files.extend(
        recorded
            .runs
            .into_iter()
            .flat_map(|run| run.files.into_keys()),
    );
    files.extend([Claims::PATH, "proofs/evidence.json"].map(str::to_owned));
    // What was recorded of a file that is gone since is stale, whatever the tree.
    for file in files.into_iter().filter(|file| from.join(file).exists()) {
        let folder = to.join(&file);
        fs::create_dir_all(folder.parent().expect("a folder")).expect("a folder");
        fs::copy(from.join(&file), to.join(&file)).unwrap_or_else(|e| panic!("{file}: {e}"));
    }
    to
}

/// The recorded evidence, as if it had been recorded for the tree as it is.
fn recorded_now(root: &Path) -> Evidence {
    let text = fs::read_to_string(root.join("proofs/evidence.json")).expect("evidence");
    let mut recorded = Evidence::parse("evidence", &text).expect("evidence");
    let claims = Claims::read(root).expect("claims");
    for record in &mut recorded.records {
        let claim = claims.find(&record.claim).expect("a claim");
        record.statement = claims.statement(claim, record.engine).expect("a statement");
        record.sources.retain(|file| root.join(file).exists());
        record.sources.extend(claim.files());
        record.sources.sort();
        record.sources.dedup();
    }
    for run in &mut recorded.runs {
        run.files.retain(|file, _| root.join(file).exists());
        let sources = claims.claims.iter().flat_map(Claim::files);
        run.files
            .extend(sources.map(|file| (file, Sha256::of(b""))));
        for (file, sum) in &mut run.files {
            *sum = Sha256::of(&fs::read(root.join(file)).expect("a source"));
        }
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

/// A change of a file between scene and verdict, or of what proves it.
struct Edit {
    file: &'static str,
    old: &'static str,
    new: &'static str,
    /// The engines that read the file.
    engines: &'static [&'static str],
    /// Records that it must make stale, and some that it must not.
    stale: &'static [&'static str],
    fresh: &'static [&'static str],
}

const EDITS: [Edit; 11] = [
    Edit {
        file: "crates/passivity-core/src/region.rs",
        old: "(Less, Greater)",
        new: "(Greater, Less)",
        engines: &["smt", "rocq", "kani", "stand-in", "tests"],
        stale: &[
            "TH-REGION/smt",
            "TH-REGION/rocq",
            "TH-REGION/tests",
            "CHECK-VERDICT/tests",
        ],
        fresh: &["ERR-27/smt", "TH-LIN/tests", "TH-TELESCOPE/rocq"],
    },
    Edit {
        file: "crates/passivity-core/src/verdict.rs",
        old: "self.with_either_period(End::Hardest)",
        new: "self.with_either_period(End::Easiest)",
        engines: &["smt", "rocq", "kani", "stand-in", "tests"],
        stale: &["TH-REGION/stand-in", "TH-REGION/rocq", "CHECK-LIMITS/tests"],
        fresh: &["TH-LIN/stand-in", "TH-RUN/smt", "EQ-21a/rocq"],
    },
    Edit {
        file: "proofs/smt/queries/th_lin_bound.smt2",
        old: "(check-sat)",
        new: "(exit)",
        engines: &["smt"],
        stale: &["TH-LIN/smt"],
        fresh: &["TH-QUANT/smt"],
    },
    Edit {
        file: "proofs/smt/src/claims/generation.rs",
        old: "use ",
        new: "use  ",
        engines: &["smt"],
        stale: &["TH-LIN/smt", "TH-QUANT/smt"],
        fresh: &["TH-REGION/smt", "TH-STIFF/smt"],
    },
    Edit {
        file: "proofs/terms/src/term.rs",
        old: "fn ",
        new: "fn  ",
        engines: &["smt", "rocq"],
        stale: &["TH-LIN/smt", "TH-REGION/smt", "TH-LIN/rocq"],
        fresh: &["TH-LIN/tests"],
    },
    Edit {
        file: "proofs/rocq/Start.v",
        old: "Proof.",
        new: "Proof. ",
        engines: &["rocq"],
        stale: &["TH-START/rocq"],
        fresh: &["TH-QUANT/rocq", "EQ-21a/rocq"],
    },
    Edit {
        file: "proofs/kani/src/region.rs",
        old: "fn ",
        new: "fn  ",
        engines: &["kani", "stand-in"],
        stale: &["TH-REGION/stand-in"],
        fresh: &["TH-LIN/stand-in"],
    },
    Edit {
        file: "crates/passivity-core/tests/properties/law.rs",
        old: "fn ",
        new: "fn  ",
        engines: &["tests"],
        stale: &["TH-LAW/tests"],
        fresh: &["TH-LIN/tests", "CHECK-VERDICT/tests"],
    },
    Edit {
        file: "crates/passivity-scene/src/check/decide.rs",
        old: "Speeds::All,",
        new: "Speeds::All ,",
        engines: &["tests"],
        stale: &["CHECK-VERDICT/tests", "CHECK-LIMITS/tests"],
        fresh: &["TH-REGION/tests"],
    },
    Edit {
        file: "crates/passivity-scene/src/parse/measure.rs",
        old: "fn ",
        new: "fn  ",
        engines: &["tests"],
        stale: &["CHECK-VERDICT/tests"],
        fresh: &["TH-REGION/tests"],
    },
    Edit {
        file: "Cargo.lock",
        old: "version = 4",
        new: "version = 3",
        engines: &["smt", "kani", "stand-in", "tests"],
        stale: &[
            "TH-LIN/smt",
            "TH-LIN/stand-in",
            "TH-LIN/tests",
            "CHECK-VERDICT/tests",
        ],
        fresh: &["TH-LIN/rocq", "TH-REGION/rocq"],
    },
];

#[test]
fn a_changed_line_makes_the_evidence_that_covers_it_stale_and_no_other() {
    let dir = Dir::new();
    let root = tree(&dir);
    let scene = dir.write("good.toml", GOOD);
    let recorded = recorded_now(&root);
    let text = recorded.to_text().expect("text");
    fs::write(root.join("proofs/evidence.json"), text).expect("evidence");
    let write = |case: &[&str]| dir.run(&[&["case", "--root", "tree"], case].concat());
    assert_ne!(write(&[&scene, "--out", "case"]).code, 2);
    let before = records(&dir);
    assert!(before.len() > 50, "{}", before.len());
    for Edit {
        file,
        old,
        new,
        engines,
        stale: expected,
        fresh,
    } in EDITS
    {
        let path = root.join(file);
        let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{file}: {e}"));
        assert!(text.contains(old), "{file}");
        fs::write(&path, text.replace(old, new)).expect("an edit");
        let run = write(&["--check", "case", "--format", "json"]);
        assert_eq!(run.code, 1, "{file}: {}", run.stderr);
        let document = run.json();
        let stale: BTreeSet<String> = document["evidence"]
            .as_array()
            .expect("a list")
            .iter()
            .map(|line| {
                let line = line.as_str().expect("a line");
                assert!(line.contains(file), "{line}");
                line.split(": ").next().expect("an id").to_owned()
            })
            .collect();
        let covers = |record: &&Record| record.sources.iter().any(|source| source == file);
        let covering: BTreeSet<String> = recorded
            .records
            .iter()
            .filter(covers)
            .map(Record::id)
            .filter(|id| before[id] == "fresh")
            .collect();
        assert!(!covering.is_empty() && covering.len() < before.len());
        assert_eq!(stale, covering, "{file}");
        for id in expected {
            assert!(stale.contains(*id), "{file}: {id} is fresh");
        }
        for id in fresh {
            assert!(before.contains_key(*id), "{file}: there is no {id}");
            assert!(!stale.contains(*id), "{file}: {id} is stale");
        }
        for id in &stale {
            let (_, engine) = id.rsplit_once('/').expect("an engine");
            assert!(engines.contains(&engine), "{file}: {id} is stale");
        }
        assert_eq!(
            document["unchanged"].as_u64(),
            Some((before.len() - covering.len()) as u64)
        );
        if file.ends_with("region.rs") {
            // Written anew, the case shows it, and a strict one is refused.
            let strict = write(&[&scene, "--out", "strict", "--strict"]);
            assert_eq!(strict.code, 1);
            let says = format!("stale: changed since: {file}");
            assert!(strict.stdout.contains(&says), "{}", strict.stdout);
            assert!(read(&dir, "strict/case.html").contains(&says));
        }
        fs::write(&path, text).expect("the edit undone");
    }
}

/// Evidence in which everything that a claim asks for was run.
fn all_was_run(root: &Path) -> Evidence {
    let mut recorded = recorded_now(root);
    let kani = |engine: Engine| engine == Engine::Kani;
    let sources: BTreeMap<String, Vec<String>> = recorded
        .records
        .iter()
        .filter(|record| record.engine == Engine::StandIn)
        .map(|record| (record.claim.clone(), record.sources.clone()))
        .collect();
    let stand_in = recorded.run(Engine::StandIn).expect("a run").clone();
    for run in recorded.runs.iter_mut().filter(|run| kani(run.engine)) {
        run.outcome = stand_in.outcome.clone();
        run.files = stand_in.files.clone();
        run.commit = Some("a1".repeat(20));
        run.tools = vec![Tool {
            name: "Kani".into(),
            version: Some("0.67.0".into()),
        }];
    }
    for record in recorded.records.iter_mut().filter(|r| kani(r.engine)) {
        record.outcome = Outcome::Shown(vec![Shown::AllInputs { domains: 1 }]);
        record.parts = vec!["a_harness".into()];
        record.sources = sources[&record.claim].clone();
    }
    recorded
}

#[test]
fn a_strict_case_passes_when_all_that_is_required_was_run() {
    let dir = Dir::new();
    let root = tree(&dir);
    let scene = dir.write("good.toml", GOOD);
    let complete = all_was_run(&root);
    let strict = |evidence: &Evidence| {
        let text = evidence.to_text().expect("text");
        fs::write(root.join("proofs/evidence.json"), text).expect("evidence");
        dir.run(&[
            "case", "--root", "tree", &scene, "--out", "case", "--strict",
        ])
    };
    let run = strict(&complete);
    assert_eq!(run.code, 0, "{}{}", run.stdout, run.stderr);
    assert!(run.stdout.contains("Nothing is open, stale or missing."));
    let html = read(&dir, "case/case.html");
    let at = format!("Kani 0.67.0, at commit {}", "a1".repeat(20));
    assert!(html.contains(&at), "where the record was made is said");
    // One record that was not run is enough to refuse it.
    let mut one_missing = complete;
    let record = &mut one_missing.records[0];
    let id = record.id();
    record.outcome = Outcome::NotRun("left out".into());
    let run = strict(&one_missing);
    assert_eq!(run.code, 1, "{id}");
    assert!(
        run.stdout.contains("not run here: left out"),
        "{}",
        run.stdout
    );
    // And so is a parameter whose source is still to be written.
    dir.write(
        "good.toml",
        GOOD.replace("# Measured on the bench.", "# TODO"),
    );
    let run = strict(&all_was_run(&root));
    assert_eq!(run.code, 1);
    assert!(run.stdout.contains("G-sources is open"), "{}", run.stdout);
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
    let mut recorded = Evidence::parse("evidence", &text).expect("evidence");
    recorded.records.retain(|record| record.claim != "TH-LIN");
    fs::write(&evidence, recorded.to_text().expect("text")).expect("evidence");
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

#[test]
fn figures_are_in_the_units_of_the_scene() {
    let dir = Dir::new();
    let scene = dir.write(
        "tip.toml",
        "# From the data sheet.\n[device]\ncoulomb = \"0.04 N\"\n[sampling]\nrate = \"1 kHz\"\n\
         [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"1 N/mm\"\n\
         [operator]\nmax_speed = \"40 mm/s\"\n",
    );
    let run = dir.run(&["case", &scene, "--out", "case"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stdout.contains("at every speed up to 40 mm/s"),
        "{}",
        run.stdout
    );
    let html = read(&dir, "case/case.html");
    for says in [
        "Margin (8) at 40 mm/s",
        "50 mm/s (1.6666 ticks/sample)",
        "at most 1.1428 N/mm",
        "at least 0.8 kHz",
        "at most 0.04 mm",
    ] {
        assert!(html.contains(says), "{says}");
    }
}

#[test]
fn the_people_and_the_date_are_those_that_were_given() {
    let dir = Dir::new();
    let scene = dir.write("good.toml", GOOD);
    let info = dir.write(
        "device.toml",
        "title = \"The wall of the trainer\"\nauthor = \"A. Person\"\ndate = 2026-03-31\n",
    );
    let run = dir.run(&["case", &scene, "--out", "case", "--info", &info]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let html = read(&dir, "case/case.html");
    for says in [
        "<h1>The wall of the trainer</h1>",
        "A. Person",
        "2026-03-31",
        "not given",
    ] {
        assert!(html.contains(says), "{says}");
    }
    assert!(read(&dir, "case/case.info.toml").contains("A. Person"));
    for (text, about) in [
        ("author = \"TODO\"\n", "`author` still has to be filled in"),
        ("approval = \" \"\n", "`approval` still has to be filled in"),
        ("date = \"today\"\n", "`date` must be a day"),
        ("athor = \"A. Person\"\n", "athor"),
    ] {
        let info = dir.write("device.toml", text);
        let run = dir.run(&["case", &scene, "--out", "other", "--info", &info]);
        one_error(&run, about);
        assert!(run.stderr.contains("device.toml"), "{}", run.stderr);
        assert!(!dir.path("other").exists());
    }
}

#[cfg(unix)]
mod pdf {
    use std::os::unix::fs::PermissionsExt as _;
    use std::process::Command;

    use super::*;

    /// Runs the command with what it finds on the PATH and in `PASSIVITY_BROWSER`.
    fn run(dir: &Dir, args: &[&str], path: &Path, browser: Option<&Path>) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_passivity"));
        command
            .args(args)
            .current_dir(dir.path("."))
            .env("PATH", path);
        match browser {
            Some(browser) => command.env("PASSIVITY_BROWSER", browser),
            None => command.env_remove("PASSIVITY_BROWSER"),
        };
        command.output().expect("the command starts").into()
    }

    /// A script in the place of a browser.
    fn script(dir: &Dir, name: &str, text: &str) -> std::path::PathBuf {
        fs::create_dir_all(dir.path("bin")).expect("a folder");
        dir.write(&format!("bin/{name}"), format!("#!/bin/sh\n{text}\n"));
        let path = dir.path(&format!("bin/{name}"));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("a script");
        path
    }

    const PRINTS: &str = "for a in \"$@\"; do case $a in --print-to-pdf=*) out=${a#*=};; esac; done\n\
                          echo '%PDF-1.4 printed' >\"$out\"";

    #[test]
    fn a_browser_prints_the_document_and_the_manifest_has_its_hash() {
        let dir = Dir::new();
        let scene = dir.write("good.toml", GOOD);
        script(&dir, "chromium", PRINTS);
        let args = ["case", &scene, "--out", "case", "--pdf", "--format", "json"];
        let run = run(&dir, &args, &dir.path("bin"), None);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert_eq!(run.json()["pdf"], "case.pdf");
        assert_eq!(read(&dir, "case/case.pdf"), "%PDF-1.4 printed\n");
        assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
        dir.write("case/case.pdf", "%PDF-1.4 changed");
        let check = dir.run(&["case", "--check", "case"]);
        assert_eq!(check.code, 1);
        assert!(
            check.stdout.contains("`case.pdf` was changed"),
            "{}",
            check.stdout
        );
        // A case that is written again without --pdf does not keep the old print.
        assert_eq!(dir.run(&["case", &scene, "--out", "case"]).code, 0);
        assert!(!dir.path("case/case.pdf").exists());
    }

    #[test]
    fn without_a_browser_the_case_is_written_and_the_error_says_how_to_print_by_hand() {
        let dir = Dir::new();
        let scene = dir.write("good.toml", GOOD);
        let failing = script(&dir, "failing", "echo no display >&2; exit 7");
        let nowhere = dir.path("nowhere");
        for (browser, about) in [
            (None, "PASSIVITY_BROWSER"),
            (Some(failing.as_path()), "no display"),
            (Some(nowhere.as_path()), "nowhere"),
        ] {
            let args = ["case", &scene, "--out", "case", "--pdf"];
            let run = run(&dir, &args, &nowhere, browser);
            one_error(&run, about);
            assert!(
                run.stderr
                    .contains("to print it by hand, open `case/case.html`")
            );
            assert!(dir.path("case/case.html").is_file());
            assert!(!dir.path("case/case.pdf").exists());
            assert_eq!(dir.run(&["case", "--check", "case"]).code, 0);
        }
    }

    /// The pages of a PDF as browsers write it, each an object of its own.
    fn pages(pdf: &[u8]) -> usize {
        let text = String::from_utf8_lossy(pdf);
        let all = text.matches("/Type /Page").count();
        all - text.matches("/Type /Pages").count()
    }

    #[test]
    #[ignore = "needs chromium: cargo test -p passivity-cli --test cli -- --ignored real_browser"]
    fn a_real_browser_prints_every_case() {
        let dir = Dir::new();
        let path = std::env::var_os("PATH").expect("a PATH");
        for scene in shipped() {
            let scene = scene.to_str().expect("UTF-8");
            let args = ["case", scene, "--out", "case", "--pdf"];
            let run = run(&dir, &args, Path::new(&path), None);
            assert_ne!(run.code, 2, "{scene}: {}", run.stderr);
            let pdf = fs::read(dir.path("case/case.pdf")).expect("a PDF");
            let pages = pages(&pdf);
            assert!((10..=40).contains(&pages), "{scene}: {pages} pages");
        }
    }
}
