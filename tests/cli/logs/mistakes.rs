//! Logs that cannot be read as they are, or hold nothing: the command says what it lacks.

use super::{SCENE, told};
use crate::harness::Dir;

#[test]
fn columns_that_cannot_be_read_are_said_and_no_column_is_silently_left_out() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    for (header, row, says) in [
        (
            "time [s],x [rad]",
            "0,0",
            "the column `time [s]` is not read under this name; did you mean t=time [s], x=x [rad]?",
        ),
        (
            "x [rad,t [s]",
            "0,0",
            "column `x [rad`: the bracket is not closed",
        ),
        (
            "x [rad],velocity",
            "0,0",
            "the column `velocity` is not read",
        ),
        ("x [rad],effort", "0,0", "the column `effort` is not read"),
        (
            "t [s],x [rad],tau [N m]",
            "0,0,0",
            "did you mean t=t [s], x=x [rad], f=tau [N m]?",
        ),
        (
            "t [s],x",
            "0,0",
            "did you mean t=t [s], x=x [rad]? (units that the header does not give are assumed: x in rad)",
        ),
        ("0.5,1.5", "1,2", "the first line holds numbers"),
        (
            "a,b",
            "1,2",
            "expected a column `xi`, `x [unit]` or `count`, found `a`, `b`",
        ),
    ] {
        dir.write("log.csv", format!("{header}\n{row}\n"));
        let run = dir.run(&["audit", "log.csv", "--scene", "scene.toml"]);
        assert_eq!(
            (run.code, run.stderr.lines().count()),
            (2, 1),
            "{header}: {}",
            run.stderr
        );
        assert!(run.stderr.contains(says), "{header}: {}", run.stderr);
    }
    dir.write("log.csv", "pos [deg];t (s)\n0,5;0,001\n0,25;0,002\n");
    for (columns, more, says) in [
        (
            "x=pos [deg]",
            &["--delimiter", ","][..],
            "there is no column `pos [deg]`",
        ),
        (
            "x=pos [deg], t=t",
            &["--delimiter", ";"],
            "is the comma a decimal sign? then add --decimal-comma",
        ),
        (
            "x=pos [rad], t=t",
            &["--decimal-comma"],
            "the header says that `pos [deg]` is in `deg`, not in `rad`",
        ),
        ("y=pos [deg]", &[], "`y` is nothing that a column can say"),
        ("x=pos, x=t", &[], "`x` is given twice"),
        ("x=pos [deg", &[], "a bracket is not closed"),
        (
            "x=pos, t=pos",
            &["--decimal-comma"],
            "is named for `x` and for `t`",
        ),
        (
            "x=pos",
            &["--delimiter", "0"],
            "one character that is in no number",
        ),
        (
            "x=pos",
            &["--delimiter", ",", "--decimal-comma"],
            "cannot stand both",
        ),
    ] {
        let args = [
            "audit",
            "log.csv",
            "--scene",
            "scene.toml",
            "--columns",
            columns,
        ];
        let run = dir.run(&[&args[..], more].concat());
        assert_eq!(run.code, 2, "{columns}: {}", run.stdout);
        assert!(run.stderr.contains(says), "{columns}: {}", run.stderr);
    }
    // A name with a comma, and one that is to be typed with its unit.
    dir.write(
        "log.csv",
        "\"angle, left\";\"clock\"\n0,5;0,001\n0,25;0,00135\n",
    );
    let (run, json) = told(&dir, "log.csv");
    assert_eq!(json["samples"], 2, "{}", run.stderr);
    assert_eq!(json["columns"], "t=clock [s], x=\"angle, left\" [rad]");
}

#[test]
fn a_log_without_a_sample_holds_nothing() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    for text in [
        "count\n",
        "count\n5\n",
        "t [s],x [rad],f [N m]\n",
        "t [s],x [rad],f [N m]\n0,0,0\n",
    ] {
        dir.write("log.csv", text);
        let run = dir.run(&["audit", "log.csv", "--scene", "scene.toml"]);
        assert_eq!(run.code, 2, "{text:?}: {}", run.stdout);
        assert!(
            run.stderr.contains("a trace needs two samples"),
            "{}",
            run.stderr
        );
    }
}
