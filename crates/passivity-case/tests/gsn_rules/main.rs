//! The arguments of the shipped scenes, and those with recordings, keep the rules of `gsn2x`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_case::argument::argue;
use passivity_case::{Recorded, Recording, Recordings, Records, Study};
use passivity_evidence::{Assessed, Assumption, Claim, Claims, Engine, Freshness};

use rules::broken;

mod rules;

/// Records for every id that an argument can rest on, so that no part stays without support.
fn records() -> Records {
    let ids = [
        "TH-LIN",
        "TH-SMOOTH",
        "TH-UNI",
        "TH-LAW",
        "TH-DAC",
        "TH-DELAY",
        "TH-DAMP",
        "TH-LTI",
        "TH-LATENCY",
        "TH-LAG",
        "EQ-23..26",
        "TH-INTERVAL",
        "TH-RUN",
        "TH-START",
        "TH-REGION",
        "TH-ACTIVE",
        "EQ-27",
        "TH-STIFF",
    ];
    let entry = |id: &str, engine, freshness| Assessed {
        claim: id.to_owned(),
        engine,
        required: true,
        record: None,
        freshness,
    };
    let claim = |id: &str| Claim {
        id: id.to_owned(),
        sentence: format!("What {id} says: \"quoted\", with a colon: and # a hash."),
        formula: String::new(),
        equation: String::new(),
        refutes: false,
        code: Vec::new(),
        evidence: vec![Engine::Smt, Engine::Kani],
        scope: BTreeMap::new(),
        assumptions: vec!["A-OPERATOR".to_owned(), format!("A-{id}")],
        caveats: Vec::new(),
    };
    let assumption = |id: String| Assumption {
        id,
        sentence: "It is so.".to_owned(),
        check: "Look.".to_owned(),
    };
    let names = ids.iter().map(|id| format!("A-{id}"));
    let mut records = without_claims();
    records.claims = Claims {
        claims: ids.iter().map(|id| claim(id)).collect(),
        assumptions: names
            .chain(["A-OPERATOR".to_owned()])
            .map(assumption)
            .collect(),
        caveats: Vec::new(),
    };
    let not_run = || Freshness::NotRun("no checker".to_owned());
    let entries = ids.iter().flat_map(|id| {
        [
            entry(id, Engine::Smt, Freshness::Fresh),
            entry(id, Engine::Kani, not_run()),
        ]
    });
    records.assessed = entries.collect();
    records
}

/// Records of nothing.
fn without_claims() -> Records {
    let mut records = Records::read(None, None).expect("the records of this build");
    records.claims = Claims::default();
    records.assessed.clear();
    records
}

fn shipped() -> Vec<Study> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .expect("the shipped scenes")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    paths.sort();
    assert!(paths.len() >= 8);
    paths
        .iter()
        .map(|path| Study::read(path).expect("a scene"))
        .collect()
}

#[test]
fn the_arguments_of_the_shipped_scenes_keep_every_rule() {
    let mut defeated = 0;
    let mut open = 0;
    for study in shipped() {
        for records in [records(), without_claims()] {
            let argument = argue(&study, &records);
            let yaml = argument.to_yaml();
            assert_eq!(broken(&yaml), BTreeSet::new(), "{}:\n{yaml}", study.name());
            defeated += usize::from(argument.top().is_defeated());
            open += argument.open().count();
        }
    }
    assert!(defeated >= 4, "some shipped scene is not passive");
    assert!(open > 0, "without records every part is open");
}

/// A delay may leave an interval with more than friction takes: from rest over one tick and then ten more, the second
/// interval of a passive loop of one sample generates 10 and dissipates 2 (TH-DELAY).
#[test]
fn only_of_a_wall_without_memory_is_it_said_that_no_interval_gains_energy() {
    let mut with_memory = 0;
    for study in shipped() {
        let remembers = study.scene.given.has_memory();
        let argument = argue(&study, &records()).to_yaml();
        for said in [
            "no interval gains energy",
            "TH-INTERVAL",
            "each sampling interval: what",
        ] {
            assert_eq!(
                argument.contains(said),
                !remembers,
                "{}: {said}",
                study.name()
            );
        }
        with_memory += usize::from(remembers);
    }
    assert!(with_memory >= 3, "some shipped scene has memory");
}

#[test]
fn a_passive_scene_with_all_records_is_shown_and_a_cycle_defeats_one_that_is_not() {
    for study in shipped() {
        let argument = argue(&study, &records());
        let witness = study.report().witness.is_some();
        assert_eq!(argument.top().is_defeated(), witness, "{}", study.name());
        assert_eq!(argument.node("CG-cycle").is_some(), witness);
    }
}

/// Recordings that support a case, that leave it open and that contradict it: every way in which they
/// come into an argument.
#[test]
fn arguments_with_recordings_keep_every_rule() {
    let folder = std::env::temp_dir().join(format!("passivity-gsn-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a temporary folder");
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/dimensionless.toml");
    let log = |name: &str, text: &str| {
        let path = folder.join(name);
        std::fs::write(&path, text).expect("a log");
        Recording {
            path: path.to_str().expect("UTF-8").to_owned(),
            date: "2026-11-20".to_owned(),
        }
    };
    let law = "tau,xi,f\n0,1/4,-0.5\n1,5/4,-1.5\n2,1/2,-0.5\n";
    let logs = [
        log("law.csv", law),
        log("flipped.csv", &law.replace('-', "")),
        log("open.csv", "count\n0\n1\n3\n3\n"),
    ];
    let records = Records::read(None, None).expect("the records of this build");
    let mut outcomes = BTreeSet::new();
    for chosen in 1..8 {
        let of = |bit: usize| logs.get(bit).filter(|_| chosen >> bit & 1 == 1).cloned();
        let given = Recordings {
            device: "a: \"device\" # 7".to_owned(),
            logs: (0..3).filter_map(of).collect(),
            identification: (0..1).filter_map(of).collect(),
            columns: None,
            delimiter: None,
            decimal_comma: false,
            count_error: 1.0,
            force_error: 0.0,
            scale_error: None,
            effort: Some(1_000_000),
        };
        let mut study = Study::read(&scene).expect("a scene");
        let recorded = Recorded::read(given, &study, |_, _| {});
        study.recorded = Some(recorded.expect("logs"));
        let argument = argue(&study, &records);
        let yaml = argument.to_yaml();
        assert_eq!(broken(&yaml), BTreeSet::new(), "{yaml}");
        outcomes.extend(study.outcomes().iter().map(|outcome| outcome.word()));
    }
    let _ = std::fs::remove_dir_all(&folder);
    assert_eq!(
        outcomes,
        BTreeSet::from(["contradicts", "open", "supports"])
    );
}
