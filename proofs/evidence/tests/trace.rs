//! Every claim has code and evidence, every id is known, and the table is the records'.

use std::collections::BTreeSet;
use std::path::Path;

use passivity_collect::{COMMITTED, code_rests_on, root, table, trace};
use passivity_evidence::{Claims, Engine, Evidence, Freshness, Outcome, assess, in_tree};

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
    let mut cited = trace::in_doc_comments(&root().join("crates/passivity-core/src")).unwrap();
    cited.extend(trace::in_doc_comments(&root().join("crates/passivity-scene/src/check")).unwrap());
    cited.extend(trace::in_doc_comments(&root().join("crates/passivity-monitor/src")).unwrap());
    cited.extend(trace::in_doc_comments(&root().join("crates/passivity-identify/src")).unwrap());
    for claim in &claims().claims {
        assert!(!claim.code.is_empty(), "{} has no code", claim.id);
        assert!(
            cited.contains_key(&claim.id),
            "no doc comment of the kernel, of `check`, of the monitor or of the identification cites {}",
            claim.id
        );
        for item in &claim.code {
            let source = text(&item.file());
            assert!(
                trace::declares(&source, &item.name),
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
    let mut tests = functions(&root().join("crates/passivity-core/tests/properties"));
    tests.extend(functions(&root().join("crates/passivity-scene/tests")));
    tests.extend(functions(&root().join("crates/passivity-identify/tests")));
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
                .any(|name| trace::named(&claims, name).contains(&claim.id))
        };
        for engine in &claim.evidence {
            let found = match engine {
                Engine::Tests => names(&tests),
                Engine::StandIn | Engine::Kani => names(&harnesses),
                Engine::Smt => queries
                    .iter()
                    .any(|query| query.starts_with(&format!("{}_", trace::in_names(claim)))),
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
    let mut all = functions(&root().join("crates/passivity-core/tests/properties"));
    all.extend(functions(&root().join("crates/passivity-scene/tests")));
    all.extend(functions(&root().join("crates/passivity-identify/tests")));
    let named = |name: &String| {
        ["check_", "eq_", "err_", "th_", "num_"]
            .iter()
            .any(|kind| name.starts_with(kind))
    };
    for name in all.iter().filter(|name| named(name)) {
        assert!(
            !trace::named(&claims, name).is_empty(),
            "{name} begins with no claim's id"
        );
    }
}

/// A record that was bound to less than its claim's code rests on would stay fresh when it is not.
#[test]
fn every_committed_record_is_bound_to_all_that_the_claims_code_rests_on() {
    let (claims, evidence) = (claims(), committed());
    let files = code_rests_on(&root(), &claims).unwrap();
    for (claim, files) in claims.claims.iter().zip(files) {
        assert!(files.is_superset(&claim.files()), "{}", claim.id);
        for record in evidence.records.iter().filter(|r| r.claim == claim.id) {
            let elsewhere = |run: &passivity_evidence::Run| run.commit.is_some();
            if !matches!(record.outcome, Outcome::Shown(_))
                || evidence.run(record.engine).is_some_and(elsewhere)
            {
                continue;
            }
            let bound: BTreeSet<String> = record.sources.iter().cloned().collect();
            let free: Vec<_> = files.difference(&bound).collect();
            assert!(
                free.is_empty(),
                "{} is not bound to {free:?}: run `proofs/prove --all --commit`",
                record.id()
            );
        }
    }
}

fn committed() -> Evidence {
    Evidence::parse(COMMITTED, &text(COMMITTED)).unwrap()
}

#[test]
fn the_table_is_that_of_the_committed_evidence() {
    let now = |path: &str| in_tree(&root(), path);
    let expected = table(&claims(), &committed(), now).unwrap();
    assert!(
        text("proofs/README.md") == expected,
        "proofs/README.md is out of date: `proofs/prove --commit`, or `cargo run -p \
         passivity-collect -- table` to have stale evidence called stale"
    );
}

#[test]
fn no_committed_record_of_an_engine_that_runs_here_is_stale() {
    let evidence = committed();
    let now = |path: &str| in_tree(&root(), path);
    let mut stale = Vec::new();
    for assessed in assess(&claims(), &evidence, now).unwrap() {
        let run = evidence.run(assessed.engine);
        // What ran elsewhere speaks of another commit; the table calls it stale.
        let elsewhere = run.is_some_and(|run| run.commit.is_some());
        if matches!(assessed.freshness, Freshness::Stale(_)) && !elsewhere {
            stale.push(format!("{}: {}", assessed.id(), assessed.freshness));
        }
    }
    assert!(
        stale.is_empty(),
        "the committed evidence does not speak of these sources: run `proofs/prove --commit`\n{}",
        stale.join("\n")
    );
}

#[test]
fn the_published_crate_carries_the_claims_and_the_committed_evidence() {
    assert_eq!(passivity_evidence::claimed().unwrap(), text(Claims::PATH));
    assert_eq!(passivity_evidence::recorded().unwrap(), text(COMMITTED));
}

#[test]
fn the_committed_evidence_has_a_record_for_every_claim_and_engine_and_no_failure() {
    let (claims, evidence) = (claims(), committed());
    for record in &evidence.records {
        let at = record.id();
        assert!(claims.find(&record.claim).is_some(), "{at}: unknown claim");
        let failed = matches!(record.outcome, Outcome::Failed(_));
        assert!(!failed, "{at}: {:?}", record.outcome);
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
