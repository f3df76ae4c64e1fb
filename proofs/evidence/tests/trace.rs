//! Every claim has code and evidence, every id is known, and the table is the records'.

use std::collections::BTreeSet;
use std::path::Path;

use passivity_evidence::{Claims, Engine, Evidence, root, table, trace};

fn claims() -> Claims {
    Claims::read(&root()).unwrap()
}

fn text(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

#[test]
fn ids_are_unique_and_refer_to_what_there_is() {
    let claims = claims();
    let mut ids = BTreeSet::new();
    let all = claims
        .claims
        .iter()
        .map(|c| &c.id)
        .chain(claims.assumptions.iter().map(|a| &a.id));
    for id in all.chain(claims.caveats.iter().map(|c| &c.id)) {
        assert!(ids.insert(id.clone()), "{id} is there twice");
    }
    let mut used = BTreeSet::new();
    for claim in &claims.claims {
        assert_eq!(
            trace::ids(&claim.id),
            [claim.id.as_str()],
            "{} is no id",
            claim.id
        );
        assert!(claim.sentence.ends_with('.'), "{}: no sentence", claim.id);
        for id in claim.assumptions.iter().chain(&claim.caveats) {
            assert!(ids.contains(id), "{}: unknown {id}", claim.id);
            used.insert(id.clone());
        }
    }
    for id in claims
        .assumptions
        .iter()
        .map(|a| &a.id)
        .chain(claims.caveats.iter().map(|c| &c.id))
    {
        assert!(used.contains(id), "no claim uses {id}");
    }
}

#[test]
fn every_id_in_a_doc_comment_is_a_claim() {
    let claims = claims();
    for folder in [
        "crates",
        "proofs/kani/src",
        "proofs/smt/src",
        "proofs/terms/src",
        "proofs/evidence/src",
    ] {
        for (id, files) in trace::in_doc_comments(&root().join(folder)).unwrap() {
            assert!(
                claims.find(&id).is_some(),
                "{folder}: unknown id {id} in {files:?}"
            );
        }
    }
}

#[test]
fn every_claim_has_code_that_cites_it() {
    let cited = trace::in_doc_comments(&root().join("crates/passivity-core/src")).unwrap();
    for claim in &claims().claims {
        assert!(!claim.code.is_empty(), "{} has no code", claim.id);
        assert!(
            cited.contains_key(&claim.id),
            "no doc comment of the kernel cites {}",
            claim.id
        );
        for item in &claim.code {
            let (module, name) = item
                .split_once("::")
                .unwrap_or_else(|| panic!("{item} is no item"));
            let source = text(&format!("crates/passivity-core/src/{module}.rs"));
            assert!(
                trace::declares(&source, name),
                "{}: there is no {item}",
                claim.id
            );
        }
    }
}

/// The names of functions after `fn ` in the Rust files under a folder.
fn functions(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for file in trace::rust_files(folder).unwrap() {
        let source = std::fs::read_to_string(file).unwrap();
        for (at, _) in source.match_indices("fn ") {
            let name: String = source[at + 3..]
                .chars()
                .take_while(|c| c.is_alphanumeric() || *c == '_')
                .collect();
            names.push(name);
        }
    }
    names
}

#[test]
fn every_claim_has_the_evidence_that_is_expected() {
    let claims = claims();
    let tests = functions(&root().join("crates/passivity-core/tests/properties"));
    let harnesses = functions(&root().join("proofs/kani/src"));
    let queries: Vec<String> = std::fs::read_dir(root().join("proofs/smt/queries"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    let theorems: toml::Table = text("proofs/rocq/theorems.toml").parse().unwrap();
    let theorems: Vec<&str> = theorems["claim"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(|claim| claim["id"].as_str())
        .collect();
    for claim in &claims.claims {
        assert!(!claim.evidence.is_empty(), "{} has no evidence", claim.id);
        let names = |names: &[String]| {
            names
                .iter()
                .any(|name| claims.named(name).contains(&claim.id.as_str()))
        };
        for engine in &claim.evidence {
            let found = match engine {
                Engine::Tests => names(&tests),
                Engine::StandIn | Engine::Kani => names(&harnesses),
                Engine::Smt => queries
                    .iter()
                    .any(|query| query.starts_with(&format!("{}_", claim.name()))),
                Engine::Rocq => theorems.contains(&claim.id.as_str()),
                Engine::Prusti => {
                    panic!("{}: contracts that nothing runs are no evidence", claim.id)
                }
            };
            assert!(found, "{} has no evidence by {engine}", claim.id);
        }
    }
    for id in theorems {
        assert!(
            claims.find(id).is_some(),
            "proofs/rocq/theorems.toml: unknown claim {id}"
        );
    }
}

#[test]
fn every_property_test_names_a_claim() {
    let claims = claims();
    let folder = root().join("crates/passivity-core/tests/properties");
    let named = |name: &String| {
        ["eq_", "err_", "th_", "num_"]
            .iter()
            .any(|kind| name.starts_with(kind))
    };
    for name in functions(&folder).iter().filter(|name| named(name)) {
        assert!(
            !claims.named(name).is_empty(),
            "{name} begins with no claim's id"
        );
    }
}

#[test]
fn the_table_is_that_of_the_committed_evidence() {
    let evidence = Evidence::read(&root().join("proofs/evidence.json")).unwrap();
    let expected = table(&claims(), &evidence);
    assert_eq!(
        text("proofs/README.md"),
        expected,
        "cargo run -p passivity-evidence -- table"
    );
}

#[test]
fn the_committed_evidence_uses_the_words_and_no_others() {
    let claims = claims();
    let evidence = Evidence::read(&root().join("proofs/evidence.json")).unwrap();
    for record in &evidence.records {
        let at = format!("{} ({})", record.claim, record.engine);
        assert!(claims.find(&record.claim).is_some(), "{at}: unknown claim");
        assert!(record.failures.is_empty(), "{at}: {:?}", record.failures);
        let result = record
            .result
            .as_deref()
            .unwrap_or_else(|| panic!("{at}: no result"));
        for part in result.split("; ") {
            let allowed: &[&str] = match record.engine {
                Engine::Smt | Engine::Rocq => &["proved for all reals"],
                Engine::Kani => &["proved for all inputs in "],
                Engine::StandIn => &["exhausted on ", "sampled, "],
                Engine::Tests => &["sampled, "],
                Engine::Prusti => &[],
            };
            let fits =
                part == "not run here" || allowed.iter().any(|words| part.starts_with(words));
            assert!(fits, "{at}: `{result}`");
        }
        let not_run = result == "not run here";
        assert_eq!(not_run, record.not_run.is_some(), "{at}: not run, and why");
        assert_eq!(
            not_run,
            record.parts.is_empty() || record.not_run.is_some(),
            "{at}: nothing ran"
        );
        assert!(
            !record.sources.is_empty() && record.claim_sha256.len() == 64,
            "{at}: not bound"
        );
    }
    for claim in &claims.claims {
        for engine in &claim.evidence {
            assert!(
                evidence.find(&claim.id, *engine).is_some(),
                "{}: no record of {engine}",
                claim.id
            );
        }
    }
}
