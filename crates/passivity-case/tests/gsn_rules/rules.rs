//! The rules of `gsn2x`, by its numbers, on the YAML as a YAML reader sees it, with a broken argument for each.

use std::collections::{BTreeMap, BTreeSet};

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
pub(crate) fn broken(yaml: &str) -> BTreeSet<&'static str> {
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
