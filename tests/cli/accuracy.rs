//! `passivity accuracy`.

use serde_json::Value;

use crate::harness::{Dir, root};

#[test]
fn every_method_has_its_error_and_its_time() {
    let dir = Dir::new();
    let scene = dir.write(
        "scene.toml",
        "[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n",
    );
    let run = dir.run(&[
        "accuracy",
        &scene,
        "--speed",
        "1",
        "--intervals",
        "40",
        "--plot",
        "cost.svg",
        "--format",
        "json",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let document = run.json();
    assert_eq!(document["intervals"], 40);
    let rows = document["rows"].as_array().expect("a list");
    let error = |method: &str, field: &str| {
        let row = rows.iter().find(|row| row["method"] == method);
        row.unwrap_or_else(|| panic!("{method}"))[field]
            .as_f64()
            .expect("a number")
    };
    for row in rows {
        assert!(
            row["nanoseconds_per_interval"]
                .as_f64()
                .is_some_and(|ns| ns > 0.0),
            "{row}"
        );
        assert!(
            row["same_outcome"].is_boolean() && row["outcome"].is_string(),
            "{row}"
        );
    }
    // 40 intervals of some 30 roundings, relative to the reach.
    for field in ["position", "velocity", "energy"] {
        assert!(
            error("closed-form", field) < 40.0 * 30.0 * f64::EPSILON,
            "{field}"
        );
    }
    assert!(error("euler:1", "position") > error("euler:1000", "position"));
    assert!(error("euler:1000", "position") > error("closed-form", "position"));
    let left_out = document["left_out"].as_array().expect("a list");
    assert!(
        left_out.iter().any(|row| row["method"] == "exact"),
        "{left_out:?}"
    );
    let svg = std::fs::read_to_string(dir.path("cost.svg")).expect("a picture");
    for word in ["time per interval (ns)", "closed-form", "adaptive"] {
        assert!(svg.contains(word), "{word}");
    }
}

/// What docs/simulator.md says of the methods that rest at another interval than the reference.
#[test]
fn the_page_says_when_methods_of_fixed_steps_rest() {
    let scene = root().join("scenes/dimensionless.toml");
    let scene = scene.to_str().expect("a path");
    let run = Dir::new().run(&["accuracy", scene, "--intervals", "2000", "--format", "json"]);
    let document = run.json();
    assert_eq!(document["intervals"], 833);
    let rows = document["rows"].as_array().expect("a list");
    let (undecided, at_rest): (Vec<_>, Vec<_>) =
        rows.iter().partition(|row| row["outcome"] != "at_rest");
    assert_eq!(undecided.len(), 1);
    assert_eq!(undecided[0]["method"], "rk4:1000");
    let late = |row: &Value| row["intervals_late"].as_i64().expect("a number");
    let (on_time, other): (Vec<&Value>, Vec<&Value>) =
        at_rest.into_iter().partition(|row| late(row) == 0);
    let is_fixed = |row: &&&Value| {
        let method = row["method"].as_str().expect("a name");
        method.starts_with("euler") || method.starts_with("rk4")
    };
    assert_eq!(on_time.iter().filter(is_fixed).count(), 2);
    assert_eq!(other.iter().filter(is_fixed).count(), other.len());
    assert_eq!(other.len(), 9);
    let (earliest, latest) = (
        other.iter().map(|row| -late(row)).max(),
        other.iter().map(|row| late(row)).max(),
    );
    let says = format!(
        "nine from {} intervals earlier to {} later",
        earliest.expect("some"),
        latest.expect("some")
    );
    let page = std::fs::read_to_string(root().join("docs/simulator.md")).expect("the page");
    assert!(page.contains(&says), "{says}");
}

#[test]
fn a_method_that_stopped_undecided_is_compared_with_nothing() {
    // Without friction the first sample is on an edge, but for what no enclosure tells apart.
    let dir = Dir::new();
    let scene = dir.write(
        "edge.toml",
        "[dimensionless]\nmu = \"12553/10\"\nbeta = \"0\"\nsigma = \"0\"\n[start]\nvelocity = \"-1\"\n",
    );
    let run = dir.run(&["accuracy", &scene, "--intervals", "8"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let line = |start: &str| run.stdout.lines().find(|line| line.starts_with(start));
    let enclosure = line("enclosure").expect("a line");
    assert!(
        enclosure.contains("left out: it stopped undecided: in interval 1 "),
        "{enclosure}"
    );
    let errors = line("Errors").expect("a line");
    assert!(errors.contains("1 where that is 0"), "{errors}");
}

#[test]
fn a_motion_whose_growth_is_certain_at_the_start_is_measured() {
    let dir = Dir::new();
    let scene = dir.write(
        "free.toml",
        "[dimensionless]\nmu = \"50\"\nbeta = \"0\"\nsigma = \"0\"\n[start]\nposition = \"400\"\n",
    );
    let run = dir.run(&["accuracy", &scene, "--intervals", "20"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let expected = "free: 20 intervals; outcome of the reference: growing";
    assert!(run.stdout.starts_with(expected), "{}", run.stdout);
    assert!(!run.stdout.contains("does not move"), "{}", run.stdout);
    let mut rows = run.stdout.lines();
    let row = rows
        .find(|line| line.starts_with("euler:1 "))
        .expect("a row");
    assert!(row.ends_with("growing"), "{row}");
}
