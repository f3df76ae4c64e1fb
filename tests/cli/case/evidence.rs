//! How the recorded evidence stands in a case: fresh, stale, missing or corrupt.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use passivity_evidence::{
    Claim, Claims, Engine, Evidence, Failure, Outcome, Record, Sha256, Shown, Tool,
};

use super::{GOOD, one_error, read};
use crate::harness::Dir;

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
        old: "fn find_witness<S: Enclosed>(",
        new: "fn find_witness<S: Enclosed> (",
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
fn a_run_that_was_left_behind_does_not_hide_what_was_committed() {
    let dir = Dir::new();
    let root = tree(&dir);
    let scene = dir.write("good.toml", GOOD);
    let full = recorded_now(&root);
    fs::create_dir_all(root.join("target")).expect("a folder");
    let write = |file: &str, evidence: &Evidence| {
        let text = evidence.to_text().expect("text");
        fs::write(root.join(file), text).expect("evidence");
        let run = dir.run(&["case", "--root", "tree", &scene, "--out", "case"]);
        assert_ne!(run.code, 2, "{}", run.stderr);
        let html = read(&dir, "case/case.html");
        let (_, from) = html.split_once("Recorded evidence: ").expect("the file");
        let (from, _) = from.split_once(';').expect("its end");
        (from.to_owned(), records(&dir))
    };
    let (from, committed) = write("proofs/evidence.json", &full);
    assert_eq!(from, "proofs/evidence.json");
    let mut few = full.clone();
    few.records.retain(|record| record.claim == "TH-LIN");
    let (from, taken) = write("target/evidence.json", &few);
    let both = "proofs/evidence.json, of which more is fresh than of target/evidence.json";
    assert_eq!((from.as_str(), &taken), (both, &committed));
    // What failed here is said.
    few.records[0].outcome = Outcome::Failed(vec![Failure {
        part: "a_part".into(),
        why: "wrong".into(),
    }]);
    let id = few.records[0].id();
    let (from, taken) = write("target/evidence.json", &few);
    assert_eq!(from, "target/evidence.json");
    assert!(taken[&id].starts_with("failed"), "{}", taken[&id]);
    // Of two that show as much it is the last run.
    let (from, taken) = write("target/evidence.json", &full);
    assert_eq!(
        (from.as_str(), &taken),
        ("target/evidence.json", &committed)
    );
}
