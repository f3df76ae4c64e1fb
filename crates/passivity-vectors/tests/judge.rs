//! What the judge of other implementations takes for an answer.

use passivity_core::BigRational;
use passivity_vectors::{Group, Judge, Outcome, PATIENCE, Test, against, all, named};
use serde_json::{Value, json};

/// What is found of answers like the library's own, each made into some by `change`.
fn judged(groups: &[Group], change: impl Fn(&Value) -> Vec<Value>) -> Outcome {
    let mut judge = Judge::new(groups);
    for test in groups.iter().flat_map(|group| &group.tests) {
        let mut answer = Vec::new();
        passivity_oracle::protocol::answer(test.line().as_bytes(), &mut answer);
        for answer in change(&serde_json::from_slice(&answer).unwrap()) {
            judge.hear(answer.to_string().as_bytes());
        }
    }
    judge.finish()
}

#[test]
fn answers_of_another_form_than_the_protocols_differ() {
    let all = all();
    let some = |name: &str, is_meant: &dyn Fn(&Test) -> bool| {
        let mut group = all.iter().find(|group| group.name == name).unwrap().clone();
        group.tests.retain(is_meant);
        group.tests.truncate(20);
        group
    };
    let groups = ["counts", "regions", "refusals"].map(|name| some(name, &|_| true));
    let outcome = judged(&groups, |answer| vec![answer.clone()]);
    assert_eq!(outcome.differences, []);
    let differ = |groups: &[Group], change: &dyn Fn(&mut Value)| {
        let outcome = judged(groups, |answer| {
            let mut changed = answer.clone();
            change(&mut changed);
            vec![changed]
        });
        assert_eq!(outcome.differences.len(), outcome.tests);
    };
    let twice = judged(&groups, |answer| vec![answer.clone(); 3]);
    assert_eq!(twice.differences.len(), twice.tests);
    assert_eq!(twice.differences[0].fields.len(), 1);
    differ(&groups, &|answer| {
        for (key, value) in [
            ("error", json!({"kind": "x", "message": "y"})),
            ("result", json!({})),
        ] {
            let fields = answer.as_object_mut().unwrap();
            fields.entry(key).or_insert(value);
        }
    });
    let refusals = &groups[2..];
    differ(refusals, &|answer| answer["error"] = Value::Null);
    differ(refusals, &|answer| answer["error"] = json!({}));
    differ(refusals, &|answer| answer["error"]["message"] = "".into());
    // Every figure of a verdict, where it has one.
    let regions = [some("regions", &|test| {
        let has = |key: &str| {
            test.result
                .as_ref()
                .is_some_and(|result| !result[key].is_null())
        };
        has("speed_bound") && has("colgate")
    })];
    assert!(!regions[0].tests.is_empty());
    for key in [
        "speed_bound",
        "margin_at_speed_bound",
        "colgate",
        "abbott_okamura",
    ] {
        differ(&regions, &|answer| answer["result"][key] = Value::Null);
    }
}

/// `{"lo", "hi", "approx"}` is the contract's own form, and any enclosure as tight will do.
#[test]
fn wider_enclosures_are_right_with_and_without_a_number_near_by() {
    fn widen(value: &mut Value, approx: bool) -> usize {
        let ends =
            [&value["lo"], &value["hi"]].map(|end| end.as_str()?.parse::<BigRational>().ok());
        let wide = match ends {
            [Some(lo), Some(hi)] if lo < hi => {
                let more = BigRational::new(1.into(), 10_i64.pow(16).into());
                value["lo"] = (lo - &more).to_string().into();
                value["hi"] = (hi + &more).to_string().into();
                if approx {
                    value["approx"] = json!(0.5);
                } else if let Some(fields) = value.as_object_mut() {
                    fields.remove("approx");
                }
                1
            }
            _ => 0,
        };
        let inner: usize = match value {
            Value::Object(fields) => fields.values_mut().map(|x| widen(x, approx)).sum(),
            Value::Array(items) => items.iter_mut().map(|x| widen(x, approx)).sum(),
            _ => 0,
        };
        wide + inner
    }
    let mut groups = named(&["linear"]).unwrap();
    groups[0].tests.truncate(40);
    for approx in [false, true] {
        let widened = std::cell::Cell::new(0);
        let outcome = judged(&groups, |answer| {
            let mut answer = answer.clone();
            for field in ["spare", "critical_speed"] {
                if let Some(value) = answer.get_mut("result").and_then(|x| x.get_mut(field)) {
                    widened.set(widened.get() + widen(value, approx));
                }
            }
            vec![answer]
        });
        assert!(widened.get() > 5, "{}", widened.get());
        assert_eq!(outcome.differences, [], "{approx}");
    }
}

#[test]
fn the_last_answer_too_must_not_come_twice() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../tests/conformance/passivity_ref.py"
    );
    let mut groups = named(&["errata"]).unwrap();
    groups[0].tests.truncate(1);
    let python = format!("python3 '{path}'");
    let twice = format!("{python} | sed p");
    for (command, differences) in [(python, 0), (twice, 1)] {
        let outcome = against(&command, &groups, PATIENCE).unwrap();
        assert_eq!(outcome.differences.len(), differences, "{outcome:?}");
    }
}

#[test]
fn every_number_of_a_motion_is_near_and_every_line_an_answer() {
    let groups = named(&["motion"]).unwrap();
    let wide = judged(&groups, |answer| {
        let mut answer = answer.clone();
        for field in ["xi", "velocity"] {
            answer["result"][field] = json!({"lo": "-1e12", "hi": "1e12"});
        }
        vec![answer]
    });
    assert_eq!(wide.differences.len(), wide.tests);
    let talk = |line: &str| {
        let mut judge = Judge::new(&groups);
        for test in &groups[0].tests {
            let mut answer = Vec::new();
            passivity_oracle::protocol::answer(test.line().as_bytes(), &mut answer);
            judge.hear(line.as_bytes());
            judge.hear(&answer);
        }
        judge.finish()
    };
    assert_eq!(talk(" \r\n").differences, []);
    for line in ["thinking", "7", r#"{"id": 0, "result": {}}"#] {
        let outcome = talk(line);
        assert_eq!(outcome.differences.len(), outcome.tests);
        let message = format!("line 3 is no answer to a test: {line}");
        assert_eq!(outcome.differences[1].fields, [(String::new(), message)]);
    }
}

#[test]
fn a_witness_is_there_for_a_wall_that_is_not_passive_and_gains_what_it_says() {
    // One test in eight, and two whose witness is a formula.
    let mut groups = named(&["regions", "linear"]).unwrap();
    for group in &mut groups {
        let is_formula = |test: &Test| {
            let result = test.result.as_ref();
            result.is_some_and(|result| !result["witness"]["wave"].is_null())
        };
        let mut formulas = 0;
        group.tests.retain(|test| {
            formulas += usize::from(is_formula(test));
            if is_formula(test) {
                formulas <= 2
            } else {
                test.id % 8 == 0
            }
        });
    }
    let with = |change: &dyn Fn(&mut Value)| {
        let outcome = judged(&groups, |answer| {
            let mut answer = answer.clone();
            if let Some(result) = answer.get_mut("result") {
                change(result);
            }
            vec![answer]
        });
        for (field, message) in outcome.differences.iter().flat_map(|d| &d.fields) {
            assert_eq!(field, "witness", "{message}");
        }
        outcome.differences.len()
    };
    assert_eq!(with(&|_| {}), 0);
    let tests = || groups.iter().flat_map(|group| &group.tests);
    let count = |is_meant: &dyn Fn(&Value) -> bool| {
        let witnesses = tests().filter_map(|test| test.result.as_ref()?.get("witness"));
        witnesses.filter(|witness| is_meant(witness)).count()
    };
    let drawn = count(&|witness| !witness.is_null());
    for gain in [json!("1e99"), json!("0"), json!("-1"), Value::Null] {
        let found = with(&|result| {
            if let Some(witness) = result["witness"].as_object_mut() {
                witness.insert("gain_per_cycle".to_owned(), gain.clone());
            }
        });
        assert_eq!(found, drawn, "{gain}");
    }
    // Less than it gains is true, with however many digits.
    let tiny = format!("1{}/3{}", "7".repeat(3000), "1".repeat(3100));
    let less = with(&|result| {
        if let Some(witness) = result["witness"].as_object_mut() {
            witness.insert("gain_per_cycle".to_owned(), json!(tiny));
        }
    });
    assert_eq!(less, 0);
    let added = json!({"from": "0", "to": "1", "gain_per_cycle": "1"});
    let found = with(&|result| {
        if result["witness"].is_null() {
            result["witness"] = added.clone();
        }
    });
    assert_eq!(found, count(&Value::is_null));
}
