//! `passivity case --log`: what logs say of the assumptions of the proofs.

use super::read;
use super::recorded::{case, scene};
use crate::harness::Dir;

/// A wall up to one tick in a sampling period; with that period it holds up to five of them.
const LIMITED: &str = "# Measured.\n[dimensionless]\nmu = \"50\"\nbeta = \"46/100\"\nsigma = \"7/10\"\n\
                       [operator]\nmax_speed = \"1\"\n";
/// Virtual damping divides by the period that it was made for, however late a sample is.
const DAMPED: &str = "# Measured.\n[dimensionless]\nmu = \"50\"\nbeta = \"3\"\nsigma = \"2\"\n[wall]\ndamping = \"1/5\"\n";
const KNOB: &str = "# Measured.\n[device]\nviscous = \"4e-5 N m s/rad\"\ncoulomb = \"1.5e-3 N m\"\n[sampling]\n\
                    rate = \"3 kHz\"\n[encoder]\ncounts_per_revolution = 8192\n[wall]\nstiffness = \"0.5 N m/rad\"\n\
                    [operator]\nmax_speed = \"5 rad/s\"\n";

/// An assumption that is not met is an open point: the case is left open by the log, on all that tells of it.
#[test]
fn an_interval_that_is_late_or_fast_is_an_assumption_that_is_not_met() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", LIMITED);
    for (text, unmet, how) in [
        // The criterion fails there.
        (
            "tau,xi\n0,0\n1,8\n2,8\n",
            &["A-SPEED"][..],
            "the criterion fails at the speed of 1 of 2 intervals",
        ),
        (
            "tau,xi\n0,0\n1,1\n2,0\n3,1\n8,2\n",
            &["A-SAMPLING"],
            "1 of 4 intervals last longer than the sampling period, the longest 5 periods",
        ),
        (
            "tau,xi\n0,0\n1,8\n2,8\n3,8\n8,8\n",
            &["A-SPEED", "A-SAMPLING"],
            "the criterion fails",
        ),
        ("tau,xi\n0,0\n1,1\n2,0\n", &[], ""),
    ] {
        let log = dir.write("run.csv", text);
        let run = case(&dir, &path, &["--log", &log]);
        let answer = scene(&run);
        let evidence = &answer["recorded"]["logs"][0]["evidence"];
        let because: Vec<String> = unmet
            .iter()
            .map(|assumption| format!("the assumption {assumption} is not met"))
            .collect();
        let said = evidence["because"].as_str().unwrap_or_default();
        assert_eq!(said, because.join("; "), "{evidence}");
        let objections = run.json()["objections"].to_string();
        for assumption in unmet {
            let says = format!("{assumption} is not met: «run.csv»: ");
            assert!(objections.contains(&says), "{objections}");
        }
        assert!(objections.contains(how), "{objections}");
        let html = read(&dir, "case/case.html");
        let is_met = unmet.is_empty();
        assert_eq!(html.contains("NOT met in the recording"), !is_met);
        assert_eq!(html.contains("Every part of the argument is shown"), is_met);
        assert_eq!(answer["standing"] == "shown", is_met);
        assert_eq!(run.code, i32::from(!is_met), "{text}");
    }
}

#[test]
fn an_interval_that_is_late_leaves_open_what_depends_on_the_period() {
    let dir = Dir::new();
    let log = dir.write("run.csv", "tau,xi\n0,0\n1,1\n2,0\n3,1\n8,2\n");
    let undamped = DAMPED.replace("1/5", "0");
    for (text, is_met) in [(DAMPED, false), (undamped.as_str(), true)] {
        let path = dir.write("scene.toml", text);
        let run = case(&dir, &path, &["--log", &log]);
        assert_eq!(scene(&run)["standing"] == "shown", is_met, "{text}");
        assert_eq!(run.code, i32::from(!is_met), "{text}");
    }
}

/// Times are written with some digits: an interval that is longer by one of them is no lack where the wall is passive
/// with it.
#[test]
fn intervals_that_are_later_than_matters_leave_nothing_open() {
    let dir = Dir::new();
    let path = dir.write("scene.toml", KNOB);
    for (last, is_met) in [("0.001000", true), ("0.002000", false)] {
        let log = format!("t [s],count\n0,0\n0.000333,1\n0.000667,3\n{last},2\n");
        let log = dir.write("run.csv", log);
        let run = case(&dir, &path, &["--log", &log]);
        assert_eq!(run.code, i32::from(!is_met), "{}", run.stdout);
        let html = read(&dir, "case/case.html");
        let says = "the verdict is the same with a tolerance of the period that allows them";
        assert_eq!(html.contains(says), is_met);
        assert_eq!(html.contains("NOT met in the recording"), !is_met);
    }
}
