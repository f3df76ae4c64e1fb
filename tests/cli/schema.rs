//! `passivity schema`: scenes and answers are as their schemas say.

use serde_json::Value;

use crate::harness::Dir;

#[test]
fn the_schema_describes_every_key_that_the_shipped_scenes_use() {
    let dir = Dir::new();
    let schema = dir.run(&["schema"]).json();
    let scenes = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut keys = 0;
    for file in std::fs::read_dir(scenes).expect("the shipped scenes") {
        let path = file.expect("a file").path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a scene");
        let mut section = String::new();
        for line in text.lines() {
            if let Some(name) = line
                .strip_prefix('[')
                .and_then(|rest| rest.split(']').next())
            {
                section = name.to_owned();
            } else if let Some((key, _)) = line.split_once('=')
                && !line.starts_with('#')
                && !section.is_empty()
            {
                let described = &schema["properties"][&section]["properties"][key.trim()];
                assert!(
                    described["description"].is_string(),
                    "{}: {line}",
                    path.display()
                );
                keys += 1;
            }
        }
    }
    assert!(keys > 50, "{keys}");
}

#[test]
fn the_conditions_for_comparison_are_said_where_the_vectors_are() {
    let schema = Dir::new().run(&["schema", "check"]).stdout;
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for page in ["docs/oracle.md", "crates/passivity-vectors/README.md"] {
        let page = std::fs::read_to_string(root.join(page)).expect("a page");
        for said in ["b ≥ KT/2 + B", "K ≤ min(2b/T, 2c/Δ)"] {
            assert!(schema.contains(said) && page.contains(said), "{said}");
        }
        assert!(page.contains("`colgate`") && page.contains("`abbott_okamura`"));
    }
}

/// Whether a document has every key that its schema asks for and none that it does not know; pushes
/// where it has not.
fn differs(schema: &Value, root: &Value, document: &Value, place: &str, found: &mut Vec<String>) {
    if let Some(name) = schema["$ref"].as_str() {
        let name = name.trim_start_matches("#/$defs/");
        return differs(&root["$defs"][name], root, document, place, found);
    }
    if let Some(choices) = schema["anyOf"].as_array() {
        // The choice that fits best, with what the schema says beside the choices.
        let of_choice = |choice: &Value| {
            let name = choice["$ref"]
                .as_str()
                .map(|name| name.trim_start_matches("#/$defs/"));
            let mut choice = name.map_or(choice, |name| &root["$defs"][name]).clone();
            if let Some(beside) = schema["properties"].as_object() {
                for (key, value) in beside {
                    choice["properties"][key] = value.clone();
                }
            }
            let mut of_choice = Vec::new();
            differs(&choice, root, document, place, &mut of_choice);
            of_choice
        };
        let choices = choices.iter().filter(|choice| choice["type"] != "null");
        if !document.is_null() {
            let best = choices.map(of_choice).min_by_key(Vec::len);
            found.extend(best.expect("a type"));
        }
        return;
    }
    match document {
        Value::Object(fields) => {
            let properties = schema["properties"].as_object();
            let Some(properties) = properties else { return };
            for key in fields.keys().filter(|key| !properties.contains_key(*key)) {
                found.push(format!("{place}.{key} is not in the schema"));
            }
            for key in schema["required"].as_array().into_iter().flatten() {
                if !fields.contains_key(key.as_str().expect("a key")) {
                    found.push(format!("{place}.{key} is missing"));
                }
            }
            for (key, value) in fields {
                if let Some(schema) = properties.get(key) {
                    differs(schema, root, value, &format!("{place}.{key}"), found);
                }
            }
        }
        Value::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                differs(
                    &schema["items"],
                    root,
                    item,
                    &format!("{place}[{i}]"),
                    found,
                );
            }
        }
        Value::String(text) => {
            let known = schema["oneOf"].as_array();
            let known = known.map(|k| k.iter().map(|one| &one["const"]).collect::<Vec<_>>());
            if known.is_some_and(|known| !known.contains(&document)) {
                found.push(format!("{place}: `{text}` is not one of the schema's"));
            }
        }
        _ => {}
    }
}

#[test]
fn answers_are_as_their_schemas_say() {
    let dir = Dir::new();
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let path = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    let re35 = path("re35.toml");
    let unstable = path("re35-unstable.toml");
    let straddling = path("tolerance-straddling.toml");
    let arm = path("joints/planar-arm.toml");
    let text = std::fs::read_to_string(&arm).expect("a scene");
    let stiff_arm = dir.write("stiff-arm.toml", text.replace("0.2 N/mm", "0.4 N/mm"));
    let json = ["--format", "json"];
    for (name, args) in [
        (
            "check",
            vec!["check", &re35, &unstable, &straddling, json[0], json[1]],
        ),
        ("check", vec!["check", &arm, &stiff_arm, json[0], json[1]]),
        ("explain", vec!["explain", &stiff_arm, json[0], json[1]]),
        ("explain", vec!["explain", &unstable, json[0], json[1]]),
        ("design", vec!["design", &re35, json[0], json[1]]),
        ("export", vec!["export", &re35, "--for", "json"]),
        (
            "simulate",
            vec!["simulate", &re35, "--speed", "2", json[0], json[1]],
        ),
        (
            "simulate",
            vec![
                "simulate",
                &re35,
                "--speed",
                "2",
                "--method",
                "enclosure",
                json[0],
                json[1],
            ],
        ),
        (
            "sweep",
            vec![
                "sweep", &re35, "--beta", "0:1:2", "--sigma", "0:1:2", "--speed", "1", "--out",
                "grid.csv", json[0], json[1],
            ],
        ),
    ] {
        let schema = dir.run(&["schema", name]).json();
        let run = dir.run(&args);
        let mut found = Vec::new();
        differs(&schema, &schema, &run.json(), name, &mut found);
        assert!(found.is_empty(), "{found:#?}");
    }
}
