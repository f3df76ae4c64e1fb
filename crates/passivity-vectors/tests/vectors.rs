//! The committed vectors are the generated ones and have the form of their schema; a second
//! implementation passes them, and broken copies of it do not.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_vectors::{Group, Outcome, PATIENCE, SCHEMA, Test, against, all};
use serde_json::Value;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn committed_vectors_are_the_generated_ones() {
    let folder = root().join("tests/vectors");
    let groups = all();
    let mut files = vec!["schema.json".to_owned()];
    let read = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    assert_eq!(read("schema.json"), SCHEMA);
    for group in &groups {
        let name = format!("{}.json", group.name);
        assert!(
            read(&name) == group.to_json(),
            "{name} is not what `passivity vectors` writes"
        );
        files.push(name);
    }
    let mut found: Vec<String> = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".json"))
        .collect();
    files.sort();
    found.sort();
    assert_eq!(found, files);
    assert!(groups.iter().map(|group| group.tests.len()).sum::<usize>() >= 2000);
}

#[test]
fn vectors_have_the_form_of_their_schema_and_flags_have_notes() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let mut id = 0;
    for group in all() {
        let file: Value = serde_json::from_str(&group.to_json()).unwrap();
        check(&file, &schema, &schema).unwrap_or_else(|error| panic!("{}: {error}", group.name));
        for test in file["tests"].as_array().unwrap() {
            id += 1;
            assert_eq!(test["id"], id);
            for flag in test["flags"].as_array().unwrap() {
                assert!(
                    file["notes"].get(flag.as_str().unwrap()).is_some(),
                    "{flag}"
                );
            }
        }
    }
    // The check can fail: a field too many, one too few, one of the wrong form.
    let file: Value = serde_json::from_str(&all()[0].to_json()).unwrap();
    for change in [
        |file: &mut Value| file["more"] = Value::Null,
        |file: &mut Value| drop(file.as_object_mut().unwrap().remove("claims")),
        |file: &mut Value| file["tests"][3]["result"]["bound_22"] = "1.5".into(),
        |file: &mut Value| file["tests"][3]["result"]["extra"] = "1".into(),
        |file: &mut Value| file["tests"][3]["formula"]["says"] = "perhaps".into(),
    ] {
        let mut broken = file.clone();
        change(&mut broken);
        assert!(check(&broken, &schema, &schema).is_err());
    }
}

/// What of JSON Schema the schema uses.
fn check(value: &Value, schema: &Value, root: &Value) -> Result<(), String> {
    let at = |what: &str| {
        format!(
            "{what}: {}",
            value.to_string().chars().take(80).collect::<String>()
        )
    };
    if let Some(reference) = schema["$ref"].as_str() {
        return check(value, root.pointer(&reference[1..]).unwrap(), root);
    }
    if let Some(options) = schema["oneOf"].as_array() {
        let fit = options
            .iter()
            .filter(|option| check(value, option, root).is_ok())
            .count();
        if fit != 1 {
            return Err(at(&format!("fits {fit} of the forms")));
        }
    }
    let types: Vec<&str> = match &schema["type"] {
        Value::String(name) => vec![name],
        Value::Array(names) => names.iter().filter_map(Value::as_str).collect(),
        _ => Vec::new(),
    };
    let is = |name: &str| match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        other => panic!("{other}"),
    };
    if !types.is_empty() && !types.iter().any(|name| is(name)) {
        return Err(at("wrong type"));
    }
    if schema
        .get("const")
        .is_some_and(|constant| constant != value)
    {
        return Err(at("not the constant"));
    }
    if schema["enum"]
        .as_array()
        .is_some_and(|options| !options.contains(value))
    {
        return Err(at("none of the values"));
    }
    if let (Some(_), Some(text)) = (schema.get("pattern"), value.as_str()) {
        let parts: Vec<&str> = text
            .strip_prefix('-')
            .unwrap_or(text)
            .splitn(2, '/')
            .collect();
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
        if !parts.iter().all(|part| digits(part))
            || parts.get(1).is_some_and(|d| d.starts_with('0'))
        {
            return Err(at("no fraction"));
        }
    }
    if let Some(least) = schema["minimum"].as_i64()
        && value.as_i64().is_some_and(|n| n < least)
    {
        return Err(at("too small"));
    }
    for item in value.as_array().into_iter().flatten() {
        if let Some(schema) = schema.get("items") {
            check(item, schema, root)?;
        }
    }
    if let Some(fields) = value.as_object() {
        for name in schema["required"].as_array().into_iter().flatten() {
            if !fields.contains_key(name.as_str().unwrap()) {
                return Err(at(&format!("no {name}")));
            }
        }
        for (name, field) in fields {
            match (
                schema["properties"].get(name),
                schema.get("additionalProperties"),
            ) {
                (Some(schema), _) => check(field, schema, root)?,
                (None, Some(Value::Bool(false))) => return Err(at(&format!("`{name}` too many"))),
                (None, Some(schema)) => check(field, schema, root)?,
                (None, None) => {}
            }
        }
    }
    Ok(())
}

fn python(program: &str, groups: &[Group]) -> Outcome {
    against(&format!("python3 '{program}'"), groups, PATIENCE).unwrap()
}

/// A copy of the second implementation in a folder of its own.
fn copied(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("passivity-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    for file in ["passivity_ref.py", "costs.py", "drawn.py"] {
        fs::copy(
            root().join("tests/conformance").join(file),
            folder.join(file),
        )
        .unwrap();
    }
    folder
}

/// A group in parts of `most` tests: what is slow to answer is asked a little at a time.
fn parts(group: &Group, most: usize) -> Vec<Group> {
    let part = |tests: &[Test]| Group {
        tests: tests.to_vec(),
        ..group.clone()
    };
    group.tests.chunks(most).map(part).collect()
}

/// Whether the second implementation, with one file changed, differs in these groups.
fn notices(folder: &Path, file: &str, [sound, mistake]: [&str; 2], groups: &[Group]) -> bool {
    let path = folder.join(file);
    let text = fs::read_to_string(&path).unwrap();
    assert_eq!(text.matches(sound).count(), 1, "{sound}");
    fs::write(&path, text.replace(sound, mistake)).unwrap();
    let program = folder.join("passivity_ref.py");
    let differs = |group: &Group| {
        let outcome = python(program.to_str().unwrap(), std::slice::from_ref(group));
        !outcome.differences.is_empty()
    };
    let noticed = groups.iter().any(differs);
    fs::write(&path, text).unwrap();
    noticed
}

#[test]
fn second_implementation_passes_and_broken_copies_do_not() {
    let path = root().join("tests/conformance/passivity_ref.py");
    let groups = all();
    let outcome = python(path.to_str().unwrap(), &groups);
    let first = &outcome.differences[..outcome.differences.len().min(5)];
    assert!(outcome.differences.is_empty(), "{first:#?}");
    assert!(outcome.tests >= 2000);
    let folder = copied("broken");
    // Each mistake, and a group in which it is noticed.
    for (group, sound, mistake) in [
        (
            "intervals",
            "HALF * d * d + HALF * abs(d)",
            "HALF * d * d + HALF * d",
        ),
        ("jitter", "beta * d * d / dtau", "beta * d * d"),
        (
            "intervals",
            "return xi - floor(xi)",
            "return abs(xi) - floor(abs(xi))",
        ),
        (
            "intervals",
            "margin is None or truth(margin[0] >= 0",
            "margin is None or truth(margin[0] > 0",
        ),
        ("intervals", "net_linear < 0", "net_linear <= 0"),
        ("regions", "v >= 0 and c >= 0", "v > 0 and c >= 0"),
        ("regions", "c**2 >= f**2 * square", "c**2 > f**2 * square"),
        ("counts", "holds is False and least == 0", "False"),
        ("effects", "self.step or F(0)", "F(0)"),
        // The costs of delay and damping added up, as behind a one-sided wall.
        (
            "effects",
            "self.delay, not self.clamped()",
            "self.delay, False",
        ),
        ("effects", "F(k - j + 1)", "F(1)"),
        (
            "motion",
            "+ (v - limit) * (1 - decay)",
            "- (v - limit) * (1 - decay)",
        ),
        ("refusals", "if int(d) == 0:", "if False:"),
    ] {
        let group = groups.iter().find(|known| known.name == group);
        let group = parts(group.expect("a group of that name"), 30);
        let noticed = notices(&folder, "passivity_ref.py", [sound, mistake], &group);
        assert!(noticed, "nobody notices {mistake}");
    }
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn broken_rules_for_loops_with_memory_are_noticed() {
    let groups = all();
    let linear = groups.iter().find(|group| group.name == "linear").unwrap();
    let folder = copied("broken-rules");
    for (flag, file, sound, mistake) in [
        // A border of the criterion that does not hold, and one that is not sharp.
        (
            "Border",
            "costs.py",
            "if at(p, lo) < 0 or at(p, hi) < 0:",
            "if False:",
        ),
        (
            "Border",
            "costs.py",
            "- changes(chain, b) <= 1",
            "- changes(chain, b) <= 9",
        ),
        (
            "Border",
            "costs.py",
            "n = [F(0)] * delay + n",
            "n = n + [F(0)] * delay",
        ),
        (
            "Edge",
            "costs.py",
            "sum(map(abs, c)) + abs(c[-1])",
            "sum(map(abs, c)) - abs(c[-1])",
        ),
        (
            "Edge",
            "drawn.py",
            "rest = drawn - loop.sigma * moves",
            "rest = drawn - loop.sigma",
        ),
        ("Actuator", "costs.py", "own = f * (1 - f)", "own = f"),
        ("Actuator", "costs.py", "- theta**2  #", "+ theta**2  #"),
        (
            "Actuator",
            "costs.py",
            "+ 2 * shared(part[0]",
            "+ shared(part[0]",
        ),
        (
            "Wall",
            "costs.py",
            "kappa = (HALF + delay,) * 2",
            "kappa = (HALF,) * 2",
        ),
        (
            "Random",
            "costs.py",
            "real_part(d, d)",
            "real_part(d, [F(1)])",
        ),
        ("NoLoop", "costs.py", "if abs(k) >= 1:", "if abs(k) > 1:"),
    ] {
        let is_meant = |test: &&Test| test.flags == [flag];
        let tests: Vec<Test> = linear.tests.iter().filter(is_meant).cloned().collect();
        let group = Group {
            tests,
            ..linear.clone()
        };
        let noticed = notices(&folder, file, [sound, mistake], &parts(&group, 4));
        assert!(noticed, "nobody notices {mistake}");
    }
    fs::remove_dir_all(folder).unwrap();
}

/// The second implementation, made to answer by each formula that circulates.
#[test]
fn an_implementation_that_answers_by_a_wrong_formula_fails_every_test_of_it() {
    let groups = all();
    let wrong = groups.iter().find(|group| group.name == "wrong_formulas");
    let folder = copied("formulas");
    let path = folder.join("passivity_ref.py");
    let text = fs::read_to_string(&path).unwrap();
    let sound = "    witness = None if holds else draw(loop, bound)";
    assert_eq!(text.matches(sound).count(), 1);
    let mut tests = 0;
    for (flag, formula, answer) in [
        ("DampingOverPeriod", "K ≤ b/T", "beta >= 1"),
        (
            "InertiaCorrection",
            "K ≤ 2b/T − b²T/(2m)",
            "2 * beta - beta**2 / (2 * mu) >= 1",
        ),
        ("InertiaOverPeriod", "K ≤ 2m/T²", "mu >= HALF"),
        ("HalfSample", "b ≥ K·T/2", "beta >= HALF"),
    ] {
        let mut group = wrong.unwrap().clone();
        group.tests.retain(|test| test.flags == [flag]);
        for comment in ["lets a wall pass", "refuses a wall"] {
            let is_there = |test: &Test| test.comment.starts_with(comment);
            assert!(
                group.tests.iter().any(is_there),
                "{flag}: nothing {comment}"
            );
        }
        tests += group.tests.len();
        let mu = "mu = number(scene[\"dimensionless\"][\"mu\"])";
        // Where it refuses a passive wall it would look for a witness for long, and find none.
        let invented = "    witness = \"a motion\" if passive and not holds else witness";
        let broken = format!(
            "    {mu}\n    passive, holds = holds, {answer}\n    witness = None\n    if not passive:\n    {sound}\n{invented}"
        );
        fs::write(&path, text.replace(sound, &broken)).unwrap();
        let outcome = python(path.to_str().unwrap(), std::slice::from_ref(&group));
        let message = format!(", as the wrong formula {formula} says");
        for test in &group.tests {
            let blamed = outcome.differences.iter().any(|difference| {
                let mut fields = difference.fields.iter();
                difference.id == test.id && fields.any(|(_, said)| said.ends_with(&message))
            });
            assert!(blamed, "nobody notices {formula} in test {}", test.id);
        }
    }
    assert_eq!(tests, wrong.unwrap().tests.len());
    fs::remove_dir_all(folder).unwrap();
}

/// Lets the second implementation compute the witnesses of a file of vectors again.
fn witnesses(file: &Path) -> (Option<i32>, String) {
    let output = Command::new("python3")
        .arg(root().join("tests/conformance/passivity_ref.py"))
        .arg("check-witnesses")
        .arg(file)
        .output()
        .unwrap();
    let said = String::from_utf8(output.stdout).unwrap();
    (output.status.code(), said)
}

#[test]
fn second_implementation_computes_every_witness_again() {
    for name in ["linear.json", "regions.json", "wrong_formulas.json"] {
        let (code, said) = witnesses(&root().join("tests/vectors").join(name));
        assert_eq!(code, Some(0), "{said}");
        assert!(said.ends_with(" witnesses, 0 wrong\n"), "{said}");
    }
    // A gain that is too large, and a motion that gains less than nothing.
    let text = fs::read_to_string(root().join("tests/vectors/linear.json")).unwrap();
    let file: Value = serde_json::from_str(&text).unwrap();
    for change in [
        |witness: &mut Value| witness["gain_per_cycle"] = "1e99".into(),
        |witness: &mut Value| {
            witness["wave"] = Value::Null;
            witness["positions"] = vec!["1/3", "1/2"].into();
        },
    ] {
        let mut changed = file.clone();
        let tests = changed["tests"].as_array_mut().unwrap();
        tests.retain(|test| test["result"]["verdict"] == "not_passive");
        tests.truncate(12);
        let count = tests.len();
        for test in tests {
            change(&mut test["result"]["witness"]);
        }
        let path = std::env::temp_dir().join(format!("passivity-claims-{}", std::process::id()));
        fs::write(&path, changed.to_string()).unwrap();
        let (code, said) = witnesses(&path);
        assert_eq!(code, Some(1));
        let all_wrong = format!("{count} witnesses, {count} wrong\n");
        assert!(said.ends_with(&all_wrong), "{said}");
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn an_implementation_that_says_nothing_fails_every_test() {
    let outcome = against("true", &all(), PATIENCE).unwrap();
    assert_eq!(outcome.differences.len(), outcome.tests);
}
