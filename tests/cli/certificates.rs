//! `passivity audit --certificate`: a violation that the second implementation confirms.

use std::fs;

use passivity_core::BigRational;
use serde_json::Value;

use crate::audit::PLAIN;
use crate::harness::{Dir, Run, rational};

/// Audits a trace of a scene, with a certificate of the first violation, written as `format`.
fn certified(dir: &Dir, scene: &str, trace: &str, format: &str) -> Run {
    dir.write("scene.toml", scene);
    dir.write("trace.csv", trace);
    let audit = ["audit", "trace.csv", "--scene", "scene.toml"];
    let how = ["--certificate", "certificate.json", "--format", format];
    dir.run(&[audit, how].concat())
}

#[test]
fn the_second_implementation_confirms_violations_and_refuses_changed_figures() {
    let weak = "[dimensionless]\nbeta = \"1/10\"\nsigma = \"1/10\"\n";
    let tolerant = "[dimensionless]\nbeta = \"1/10 ± 1/20\"\nsigma = \"1/10 ± 50 %\"\n";
    let late = format!("{weak}[sampling]\ndelay = 1\n[wall]\ndamping = \"1/4\"\n");
    let bent = format!("{weak}[wall]\nunilateral = true\nmax_force = \"7/2\"\n");
    let stepped = format!("{weak}[wall]\nforce_step = \"1/3\"\n");
    let forced = "f,count\n0,0\n-1,0\n9,1\n9,4\n0,9\n";
    for (scene, trace) in [
        (weak, "xi\n0\n1/3\n5/2\n-1\n"),
        (weak, "count\n0\n0\n3\n7\n9\n"),
        (weak, "tau,count\n0,0\n1,1\n5/2,9\n"),
        (weak, forced),
        (weak, "f,xi\n0,0\n1,1\n4,2\n0,9/2\n"),
        (tolerant, "xi\n0\n1/3\n5/2\n-1\n"),
        (tolerant, "count\n0\n0\n3\n12\n"),
        (&late, "xi\n0\n1/3\n5/2\n17/3\n11/2\n-2\n-13\n"),
        (&late, "count\n0\n0\n20\n10\n-10\n-40\n"),
        (&late, forced),
        (&bent, "xi\n-1\n3/2\n3\n5/2\n-1\n"),
        (&bent, forced),
        (&stepped, "count\n0\n0\n4\n9\n"),
    ] {
        let dir = Dir::new();
        let run = certified(&dir, scene, trace, "json");
        let row = &run.json()["first_violation"]["row"];
        assert!(row.is_u64(), "{scene}{trace}: no row is violated");
        let found = dir.check_certificates(&["certificate.json"]);
        assert_eq!(found.code, 0, "{scene}{trace}{}", found.stderr);
        let says = format!("The violation is real: the net energy of row {row} is ");
        assert!(found.stdout.starts_with(&says), "{}", found.stdout);
        let stored = found
            .stdout
            .trim_end()
            .ends_with(" KΔ², less what delay and damping stored.");
        assert_eq!(stored, scene == late && trace != forced, "{}", found.stdout);
        refuses_changes(&dir);
    }
}

/// Changes one number of the certificate after the other, figures and inputs.
fn refuses_changes(dir: &Dir) {
    let text = fs::read_to_string(dir.path("certificate.json")).unwrap();
    let whole: Value = serde_json::from_str(&text).unwrap();
    let mut places: Vec<String> = Vec::new();
    for (name, figure) in whole["figures"].as_object().unwrap() {
        match figure.is_string() {
            true => places.push(format!("/figures/{name}")),
            false => places.extend(["lo", "hi"].map(|end| format!("/figures/{name}/{end}"))),
        }
    }
    assert!(places.len() >= 3, "{text}");
    places.push("/log/dtau".to_owned());
    for (i, place) in places.iter().enumerate() {
        let mut changed = whole.clone();
        let number = changed.pointer_mut(place).unwrap();
        let one = BigRational::from_integer(1.into());
        let thousandth = BigRational::new(1.into(), 1000.into());
        let sign = if place.ends_with("/lo") { -one } else { one };
        *number = Value::from((rational(number) + sign * thousandth).to_string());
        dir.write(&format!("changed{i}.json"), changed.to_string());
    }
    let files: Vec<String> = (0..places.len())
        .map(|i| format!("changed{i}.json"))
        .collect();
    let found = dir.check_certificates(&files);
    // Nothing is said of what is right, and one line of each that is refused.
    assert_eq!((found.code, found.stdout.as_str()), (1, ""), "{text}");
    assert_eq!(
        found.stderr.lines().count(),
        places.len(),
        "{}",
        found.stderr
    );
    for (place, line) in places.iter().zip(found.stderr.lines()) {
        let figure = match place.strip_prefix("/figures/") {
            Some(figure) => figure.split('/').next().unwrap(),
            None => "dissipated_lower",
        };
        let says = format!("refused: {figure} is ");
        assert!(line.starts_with(&says), "{place}: {line}");
    }
}

#[test]
fn without_a_violation_there_is_no_certificate() {
    let dir = Dir::new();
    let uncovered = "[amplifier]\ntime_constant = \"1/2\"\n";
    for (scene, trace, says) in [
        (
            PLAIN.to_owned(),
            "xi\n1\n1/2\n",
            "no interval surely generated more",
        ),
        (
            PLAIN.to_owned(),
            "count\n",
            "no interval surely generated more",
        ),
        (
            "[dimensionless]\nbeta = \"0\"\nsigma = \"0\"\n".to_owned() + uncovered,
            "xi\n0\n3\n",
            "the scene has an effect that the account of a log leaves out",
        ),
    ] {
        let run = certified(&dir, &scene, trace, "text");
        assert!(
            run.stderr.contains("no certificate is written: "),
            "{}",
            run.stderr
        );
        assert!(run.stderr.contains(says), "{}", run.stderr);
        assert!(!dir.path("certificate.json").exists());
    }
}
