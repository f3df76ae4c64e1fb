//! The rules of `gsn2x`, by its numbers, on the YAML as a YAML reader sees it: on the arguments of
//! the shipped scenes, and on one broken argument a rule.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use passivity_case::argument::argue;
use passivity_case::{Recorded, Recording, Recordings, Records, Study};
use passivity_evidence::{Assessed, Assumption, Claim, Claims, Engine, Freshness};
use saphyr::{LoadableYamlNode as _, Yaml};

struct Element {
    kind: String,
    supported_by: Vec<String>,
    in_context_of: Vec<String>,
    challenges: Vec<String>,
    undeveloped: bool,
    defeated: bool,
    has_text: bool,
}

fn list(value: Option<&Yaml<'_>>) -> Vec<String> {
    match value {
        None => Vec::new(),
        Some(value) => match value.as_vec() {
            Some(items) => items
                .iter()
                .map(|i| i.as_str().expect("an id").to_owned())
                .collect(),
            None => vec![value.as_str().expect("an id").to_owned()],
        },
    }
}

/// The type of an element: what it says, else what its id starts with.
fn kind(id: &str, given: Option<&str>) -> Option<String> {
    let prefixes = [
        ("CSn", "CounterSolution"),
        ("CG", "CounterGoal"),
        ("Sn", "Solution"),
        ("G", "Goal"),
        ("S", "Strategy"),
        ("C", "Context"),
        ("A", "Assumption"),
        ("J", "Justification"),
    ];
    let by_id = prefixes
        .into_iter()
        .find(|(prefix, _)| id.starts_with(prefix));
    given.or(by_id.map(|(_, kind)| kind)).map(str::to_owned)
}

/// Every rule that the text breaks.
fn broken(yaml: &str) -> BTreeSet<&'static str> {
    let mut broken = BTreeSet::new();
    // The reader refuses a key that comes twice: C07.
    let Ok(documents) = Yaml::load_from_str(yaml) else {
        return BTreeSet::from(["YAML"]);
    };
    let top = documents[0].as_mapping().expect("a mapping");
    let mut elements: BTreeMap<String, Element> = BTreeMap::new();
    for (key, value) in top {
        let id = key.as_str().expect("an id").to_owned();
        if id == "module" {
            continue;
        }
        let get = |name: &str| value.as_mapping_get(name);
        let Some(kind) = kind(&id, get("nodeType").and_then(Yaml::as_str)) else {
            broken.insert("V01");
            continue;
        };
        let flag = |name: &str| get(name).and_then(Yaml::as_bool).unwrap_or(false);
        elements.insert(
            id,
            Element {
                kind,
                supported_by: list(get("supportedBy")),
                in_context_of: list(get("inContextOf")),
                challenges: list(get("challenges")),
                undeveloped: flag("undeveloped"),
                defeated: flag("defeated"),
                has_text: get("text")
                    .and_then(Yaml::as_str)
                    .is_some_and(|t| !t.trim().is_empty()),
            },
        );
    }
    let challenged: BTreeSet<&String> = elements.values().flat_map(|e| &e.challenges).collect();
    for (id, element) in &elements {
        let of = |wanted: &[&str]| wanted.contains(&element.kind.as_str());
        if !element.has_text {
            broken.insert("text");
        }
        if of(&["Goal", "Strategy"]) {
            if element.supported_by.is_empty() && !element.undeveloped {
                broken.insert("V02");
            }
            if !element.supported_by.is_empty() && element.undeveloped {
                broken.insert("V03");
            }
        }
        let supports: &[&str] = match element.kind.as_str() {
            "Goal" | "Strategy" => &["Goal", "Strategy", "Solution"],
            "CounterGoal" => &["CounterGoal", "CounterSolution", "Strategy"],
            _ => &[],
        };
        let contexts: &[&str] = match element.kind.as_str() {
            "Goal" | "Strategy" | "CounterGoal" => &["Context", "Assumption", "Justification"],
            _ => &[],
        };
        for (ids, allowed) in [
            (&element.supported_by, supports),
            (&element.in_context_of, contexts),
        ] {
            if ids.iter().collect::<BTreeSet<_>>().len() != ids.len() {
                broken.insert("V05");
            }
            for other in ids {
                if other == id {
                    broken.insert("V06");
                }
                let rule = match elements.get(other) {
                    None => Some("C03"),
                    Some(other) => (!allowed.contains(&other.kind.as_str())).then_some("V04"),
                };
                broken.extend(rule);
            }
        }
        if element.defeated && !challenged.contains(id) {
            broken.insert("V10");
        }
        if !element.challenges.is_empty() && !of(&["CounterGoal", "CounterSolution"]) {
            broken.insert("V12");
        }
        for target in &element.challenges {
            if target == id {
                broken.insert("C13");
            }
            if !elements.contains_key(target) {
                broken.insert("C14");
            }
        }
    }
    let referenced: BTreeSet<&String> = elements
        .values()
        .flat_map(|e| e.supported_by.iter().chain(&e.in_context_of))
        .collect();
    let tops: Vec<&String> = elements
        .iter()
        .filter(|(id, e)| !e.kind.starts_with("Counter") && !referenced.contains(id))
        .map(|(id, _)| id)
        .collect();
    let rule = match tops[..] {
        [top] => (elements[top].kind != "Goal").then_some("C02"),
        _ => Some("C01"),
    };
    broken.extend(rule);
    // Everything hangs under a top element or a challenge, and nothing supports itself.
    let roots = tops.into_iter().chain(
        elements
            .iter()
            .filter(|(_, e)| !e.challenges.is_empty())
            .map(|(id, _)| id),
    );
    let mut reached = BTreeSet::new();
    for root in roots {
        walk(root, &elements, &mut Vec::new(), &mut reached, &mut broken);
    }
    if reached.len() < elements.len() {
        broken.insert("C08");
    }
    broken
}

fn walk(
    id: &str,
    elements: &BTreeMap<String, Element>,
    above: &mut Vec<String>,
    reached: &mut BTreeSet<String>,
    broken: &mut BTreeSet<&'static str>,
) {
    if above.iter().any(|a| a == id) {
        broken.insert("C04");
        return;
    }
    let Some(element) = elements.get(id) else {
        return;
    };
    reached.insert(id.to_owned());
    reached.extend(element.in_context_of.iter().cloned());
    above.push(id.to_owned());
    for next in &element.supported_by {
        walk(next, elements, above, reached, broken);
    }
    above.pop();
}

#[test]
fn a_broken_argument_is_found_for_every_rule() {
    let good = "G1:\n  text: a\n  supportedBy: [Sn1]\nSn1:\n  text: b\n";
    assert_eq!(broken(good), BTreeSet::new());
    let cases = [
        (
            "V01",
            "G1:\n  text: a\n  undeveloped: true\nX1:\n  text: b\n",
        ),
        ("V02", "G1:\n  text: a\n"),
        (
            "V03",
            "G1:\n  text: a\n  undeveloped: true\n  supportedBy: [Sn1]\nSn1:\n  text: b\n",
        ),
        (
            "V04",
            "G1:\n  text: a\n  supportedBy: [C1]\nC1:\n  text: b\n",
        ),
        (
            "V05",
            "G1:\n  text: a\n  supportedBy: [Sn1, Sn1]\nSn1:\n  text: b\n",
        ),
        (
            "V06",
            "G1:\n  text: a\n  supportedBy: [Sn1, G1]\nSn1:\n  text: b\n",
        ),
        (
            "V10",
            "G1:\n  text: a\n  undeveloped: true\n  defeated: true\n",
        ),
        (
            "V12",
            "G1:\n  text: a\n  supportedBy: [G2]\nG2:\n  text: b\n  undeveloped: true\n  challenges: G1\n",
        ),
        (
            "C01",
            "G1:\n  text: a\n  undeveloped: true\nG2:\n  text: b\n  undeveloped: true\n",
        ),
        ("C02", "S1:\n  text: a\n  undeveloped: true\n"),
        ("C03", "G1:\n  text: a\n  supportedBy: [Sn9]\n"),
        (
            "C04",
            "G1:\n  text: a\n  supportedBy: [G2]\nG2:\n  text: b\n  supportedBy: [G3]\nG3:\n  text: c\n  supportedBy: [G2]\n",
        ),
        (
            "C08",
            "G1:\n  text: a\n  undeveloped: true\nG2:\n  text: b\n  supportedBy: [G3]\nG3:\n  text: c\n  supportedBy: [G2]\n",
        ),
        (
            "C13",
            "G1:\n  text: a\n  undeveloped: true\nCG1:\n  text: b\n  challenges: CG1\n",
        ),
        (
            "C14",
            "G1:\n  text: a\n  undeveloped: true\nCG1:\n  text: b\n  challenges: G7\n",
        ),
        ("YAML", "G1:\n  text: a\n undeveloped: true\nG1: [\n"),
        ("text", "G1:\n  text: \"\"\n  undeveloped: true\n"),
    ];
    for (rule, yaml) in cases {
        assert!(broken(yaml).contains(rule), "{rule}: {:?}", broken(yaml));
    }
}

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
            effort: Some(1_000_000),
        };
        let mut study = Study::read(&scene).expect("a scene");
        let recorded = Recorded::read(given, &study.scene, &study.text, |_, _| {});
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
