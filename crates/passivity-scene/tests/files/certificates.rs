//! The certificate of the decision about viscous friction, checked by the second implementation.

use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_core::BigRational;
use passivity_scene::Scene;
use passivity_scene::check::{Certificate, check};
use passivity_scene::number::parse;
use serde_json::Value;

/// A folder of its own, removed when dropped.
struct Dir(PathBuf);

impl Dir {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("passivity-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// What the second implementation says of certificates: what is right, and why others are refused.
    fn check<'a>(&self, certificates: impl IntoIterator<Item = &'a Value>) -> [Vec<String>; 2] {
        let write = |(index, certificate): (usize, &Value)| {
            let file = self.0.join(format!("{index}.json"));
            std::fs::write(&file, certificate.to_string()).unwrap();
            file
        };
        let program =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/conformance/passivity_ref.py");
        let output = Command::new("python3")
            .arg(program)
            .arg("check-certificate")
            .args(certificates.into_iter().enumerate().map(write))
            .output()
            .expect("Python");
        let lines = |bytes: Vec<u8>| -> Vec<String> {
            let text = String::from_utf8(bytes).unwrap();
            text.lines().map(str::to_owned).collect()
        };
        let [right, refused] = [lines(output.stdout), lines(output.stderr)];
        let code = i32::from(!refused.is_empty());
        assert_eq!(output.status.code(), Some(code), "{refused:?}");
        [right, refused]
    }
}

impl Drop for Dir {
    fn drop(&mut self) {
        // A folder that stays behind in the temporary folder does no harm.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn scene(beta: &str, rest: &str) -> String {
    format!("[dimensionless]\nbeta = \"{beta}\"\nsigma = \"2\"\n{rest}")
}

/// The certificate of a scene, and whether β has nothing to wish for.
fn certificate(text: &str) -> (Value, bool) {
    let scene = Scene::from_toml("test", text).unwrap();
    let report = check(&scene);
    let certificate = Certificate::new(&scene, &report).unwrap();
    let enough = *report.spare.viscous.lo() >= rational(&Value::from("0"));
    assert_eq!(certificate.is_enough(), enough, "{text}");
    (serde_json::to_value(&certificate).unwrap(), enough)
}

fn rational(text: &Value) -> BigRational {
    parse(text.as_str().unwrap()).unwrap()
}

const LATE_DAMPED: &str = "[sampling]\ndelay = 1\n[wall]\ndamping = \"1/2\"\n";
const FILTERED: &str =
    "[sampling]\ndelay = 2\n[wall]\ndamping = \"3/4\"\ndamping_time_constant = \"3\"\n";
const RECURSIVE: &str = "[controller]\nnumerator = [\"1\", \"-1.2\", \"0.6\"]\n\
                         denominator = [\"1\", \"-0.5\", \"0.25\"]\n";

#[test]
fn th_lti_certificates_are_confirmed_by_the_second_implementation() {
    let dir = Dir::new("confirmed");
    let tolerant = "[wall]\ndamping = \"1\"\ndamping_time_constant = \"1\"\n";
    let twice = LATE_DAMPED.replace("1/2", "2");
    let just_short = "1.249999999999999999999999999999";
    for (beta, rest, least) in [
        // The border of delay 1 with damping ½ is 5/4, with damping 2 41/16, of filtered damping 5/6.
        ("5/4", LATE_DAMPED, Some("5/4")),
        (just_short, LATE_DAMPED, Some("5/4")),
        ("1 ± 1/2", LATE_DAMPED, Some("5/4")),
        ("41/16", &twice, Some("41/16")),
        ("5/6", tolerant, Some("5/6")),
        ("1/2", "", Some("1/2")),
        ("1/4", "", Some("1/2")),
        ("3", FILTERED, None),
        ("1", FILTERED, None),
        ("2", RECURSIVE, None),
        ("0", RECURSIVE, None),
    ] {
        let text = scene(beta, rest);
        let (certificate, enough) = certificate(&text);
        let [right, refused] = dir.check([&certificate]);
        assert_eq!((right.len(), refused.len()), (1, 0), "{text}{refused:?}");
        assert_eq!(right[0].contains(" is enough;"), enough, "{text}{right:?}");
        if let Some(least) = least {
            let says = format!(" and at most {least}.");
            assert!(right[0].ends_with(&says), "{text}{right:?}");
        }
    }
}

#[test]
fn th_lti_changed_certificates_are_refused() {
    let dir = Dir::new("changed");
    for (beta, rest) in [
        ("5/4", LATE_DAMPED),
        ("1 ± 1/2", LATE_DAMPED),
        ("3", FILTERED),
        ("0", RECURSIVE),
    ] {
        let changed = changes(&certificate(&scene(beta, rest)).0);
        let [right, refused] = dir.check(changed.iter().map(|(_, changed)| changed));
        assert_eq!(right, Vec::<String>::new(), "of {}", changed.len());
        assert_eq!(refused.len(), changed.len());
        for (line, (what, _)) in refused.iter().zip(&changed) {
            assert!(line.starts_with("refused: "), "{what}: {line}");
        }
    }
}

/// Changes the loop and one fact of every decision after the other: a coefficient, a sign, a count,
/// the answer itself.
fn changes(whole: &Value) -> Vec<(String, Value)> {
    let mut all = Vec::new();
    let mut places = vec!["/loop/delay".to_owned(), "/cost/above".to_owned()];
    for (index, decision) in whole["decisions"].as_array().unwrap().iter().enumerate() {
        leaves(decision, &format!("/decisions/{index}"), &mut places);
    }
    for place in places {
        let mut changed = whole.clone();
        let value = changed.pointer_mut(&place).unwrap();
        *value = match &*value {
            Value::Bool(yes) => Value::Bool(!*yes),
            Value::Number(count) => Value::from(count.as_u64().unwrap() + 1),
            // The other sign too: members of the sequence may be multiplied by what is above zero.
            number => {
                let thousandth = BigRational::new(1.into(), 1000.into());
                Value::from((-rational(number) - thousandth).to_string())
            }
        };
        all.push((place, changed));
    }
    for (index, decision) in whole["decisions"].as_array().unwrap().iter().enumerate() {
        let Some(members) = decision["sequence"].as_array() else {
            continue;
        };
        // Every sign of one member the other way round, as if a remainder had not been negated.
        for (at, member) in members.iter().enumerate() {
            let negated = member
                .as_array()
                .unwrap()
                .iter()
                .map(|c| (-rational(c)).to_string());
            let mut changed = whole.clone();
            changed["decisions"][index]["sequence"][at] = negated.collect();
            all.push((format!("a negated member {at}"), changed));
        }
        let mut changed = whole.clone();
        let shorter = changed["decisions"][index]["sequence"]
            .as_array_mut()
            .unwrap();
        if shorter.pop().is_some() {
            all.push(("a sequence without its last member".to_owned(), changed));
        }
    }
    let mut changed = whole.clone();
    changed["decisions"].as_array_mut().unwrap().pop();
    all.push(("a decision left out".to_owned(), changed));
    all
}

/// The places of all numbers and truths.
fn leaves(value: &Value, place: &str, found: &mut Vec<String>) {
    match value {
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                leaves(item, &format!("{place}/{index}"), found);
            }
        }
        Value::Object(fields) => {
            for (name, field) in fields {
                leaves(field, &format!("{place}/{name}"), found);
            }
        }
        _ => found.push(place.to_owned()),
    }
}
