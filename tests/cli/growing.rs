//! `passivity simulate` of motions that grow, of a device that does not move, and after the last interval.

use crate::harness::Dir;
use crate::simulate::gliding;

/// No friction and no encoder: every motion grows.
fn frictionless(dir: &Dir, intervals: &str) -> String {
    let scene = format!(
        "[device]\nmass = \"120 g\"\n[sampling]\nperiod = \"1 ms\"\n[wall]\nstiffness = \"0.5 N/mm\"\n\
         [start]\nposition = \"-1 mm\"\n{intervals}"
    );
    dir.write("free.toml", scene)
}

#[test]
fn a_motion_whose_growth_is_certain_at_the_start_is_shown() {
    let dir = Dir::new();
    let scene = frictionless(&dir, "[run]\nintervals = 100\n");
    let run = dir.run(&["simulate", &scene, "--plot", "f.svg", "--out", "f.csv"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(run.stdout.starts_with("free: growing (interval 0)"));
    let rows = |name: &str| {
        let text = std::fs::read_to_string(dir.path(name)).expect("a trace");
        text.lines().count() - 1
    };
    assert_eq!(rows("f.csv"), 100, "the intervals of the scene");
    let more = ["--intervals", "7", "--format", "json"];
    let run = dir.run(&[&["simulate", &scene][..], &more].concat());
    let document = run.json();
    assert_eq!(document["intervals"], 7);
    assert_eq!(document["outcome"]["at_interval"], 0);
    assert!(document["totals"]["generated_linear"].as_f64() > Some(0.0));
    let run = dir.run(&["simulate", &scene]);
    assert!(run.stdout.contains("closed-form, 0 intervals"));
    assert!(run.stdout.contains("--intervals goes on"), "{}", run.stdout);

    // Where nobody says how far, it grows tenfold.
    let scene = frictionless(&dir, "");
    let run = dir.run(&["simulate", &scene, "--out", "f.csv", "--format", "json"]);
    assert!((1000..5000).contains(&rows("f.csv")), "{}", rows("f.csv"));
    let end = run.json()["final"]["xi"].as_f64().expect("a number");
    assert!((0.001..0.011).contains(&end.abs()), "{end}");
}

#[test]
fn a_motion_that_grows_ends_before_numbers_do_and_says_so() {
    let dir = Dir::new();
    let scene = frictionless(&dir, "");
    let more = ["--intervals", "400000", "--format", "json"];
    let run = dir.run(&[&["simulate", &scene][..], &more].concat());
    let document = run.json();
    let intervals = document["intervals"].as_u64().expect("a number");
    assert!(intervals > 100_000 && intervals < 400_000, "{intervals}");
    let because = document["outcome"]["because"].as_str().expect("a sentence");
    let expected = format!("the motion is known up to interval {intervals}: past 1e140 m");
    assert!(because.contains(&expected), "{because}");
    assert_eq!(document["outcome"]["at_interval"], 0);
}

#[test]
fn a_device_that_rests_where_it_starts_is_drawn_there() {
    let dir = Dir::new();
    let still = "[dimensionless]\nmu = \"50\"\nbeta = \"1\"\nsigma = \"5\"\n\
                 [start]\nposition = \"4\"\n[run]\nintervals = 30\n";
    let run = dir.run(&[
        "simulate",
        &dir.write("still.toml", still),
        "--plot",
        "s.svg",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let svg = std::fs::read_to_string(dir.path("s.svg")).expect("a picture");
    assert!(svg.contains(">30<"), "an axis of time over 30 intervals");
}

#[test]
fn positions_and_speeds_are_in_the_units_of_the_scene() {
    let dir = Dir::new();
    let scene = frictionless(&dir, "[operator]\nmax_speed = \"20 cm/s\"\n");
    let run = dir.run(&["simulate", &scene, "--intervals", "12"]);
    assert!(
        run.stdout.contains("x = -1 mm, v = 0 cm/s"),
        "{}",
        run.stdout
    );
    assert!(
        run.stdout.contains("x = -0.71252 mm, v = 4.5704 cm/s"),
        "{}",
        run.stdout
    );
}

#[test]
fn a_picture_of_none_of_the_intervals_says_how_many_were_run() {
    let dir = Dir::new();
    let scene = gliding(&dir);
    let run = dir.run(&["simulate", &scene, "--format", "json"]);
    let intervals = run.json()["intervals"].as_u64().expect("a number");
    assert!(intervals < 190, "{intervals}");
    for from in ["190", "1000000"] {
        let run = dir.run(&["simulate", &scene, "--plot", "m.svg", "--plot-from", from]);
        assert_eq!(run.code, 2);
        let expected = format!("the motion has {intervals} intervals");
        assert!(run.stderr.contains(&expected), "{}", run.stderr);
    }
}
