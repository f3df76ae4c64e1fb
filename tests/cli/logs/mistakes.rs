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
            "did you mean t=t [s], x=x [rad], or t=t [s], x=x [deg] where positions are in deg? (units that the header does \
             not give are assumed: x in rad)",
        ),
        (
            "t [s],x [rad],torque [N m]",
            "0,0,",
            "the column `torque [N m]` cannot be read (row 1 has no number there): write a number in each row",
        ),
        (
            "t [s],x [rad],torque [parsec]",
            "0,0,1",
            "`--columns` leaves it out, the account is of the force of the wall's law, not of the one that was held",
        ),
        (
            "t [s],x [rad],torque [rad]",
            "0,0,1",
            "(`rad` is no unit of a force like `N m`)",
        ),
        (
            "time,x [rad]",
            "2026-11-27,0",
            "the column `time` cannot be read (row 1 has no number there but `2026-11-27`): write its times as numbers",
        ),
        (
            "t [s],x [rad],f",
            "0,0,nan",
            "did you mean t=t [s], x=x [rad], f=f [N m]?",
        ),
        ("time,a,b", "0,1,2", "no column is known to be the position"),
        (
            "xi0_lo,xi0_hi,xi1_lo,xi1_hi",
            "0,1,0,1",
            "a ledger of bounds, with columns like `xi0_lo` and `xi0_hi`, is no trace",
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
            "there is no column `pos`",
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
fn the_command_that_is_shown_keeps_what_was_typed() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let columns = "--columns 't=t [us], count=count, f=torque [N m]'";
    let text = "t [us];count;torque [N m]\n0;0;0,05\n350;2;0,0498\n700;5;0,049\n";
    // Some of it may be what the log asks for.
    for (text, typed, shown) in [
        (text, "--delimiter ;", "--delimiter ';' --decimal-comma"),
        (text, "--decimal-comma", "--delimiter ';' --decimal-comma"),
        (text, "", "--delimiter ';' --decimal-comma"),
        (
            &text.replace(',', ".").replace(';', ","),
            "--partial part.json --shard 1/2",
            "--partial part.json --shard 1/2",
        ),
        (
            &text.replace(',', ".").replace(';', ","),
            "--partial part.json --range 1:",
            "--partial part.json --range 1:",
        ),
    ] {
        dir.write("log.csv", text);
        let mut args = vec!["audit", "log.csv", "--scene", "scene.toml"];
        args.extend(typed.split_whitespace());
        let run = dir.run(&args);
        let command = super::shown(&run);
        assert!(command.contains(columns), "{typed}: {command}");
        assert!(command.contains(shown), "{typed}: {command}");
        let (run, _) = super::follow(&dir, &command);
        assert!(run.code < 2, "{command}: {}", run.stderr);
    }
    // A file is no option, though its name may look like one.
    dir.write("-l.csv", "time,position\n0,0\n0.00035,0\n");
    let run = dir.run(&["audit", "./-l.csv", "--scene", "scene.toml"]);
    assert!(
        super::shown(&run).starts_with("audit ./-l.csv "),
        "{}",
        run.stderr
    );
}

#[test]
fn a_field_in_quotes_may_hold_what_stands_between_fields() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    dir.write(
        "log.csv",
        "time,name,position,effort\n0,\"a,b\",0.1,0\n0.00035,\"a \"\"b\"\", c\",0.1,0\n0.0007,plain,0.1,0\n",
    );
    let (run, json) = told(&dir, "log.csv");
    assert_eq!(
        (run.code, &json["samples"]),
        (0, &3.into()),
        "{}",
        run.stderr
    );
    // Quotes that are not closed enclose nothing.
    dir.write("log.csv", "x [rad],note\n0,5\"\n0.1,\"5\n0.1,\"5,6\n");
    let run = dir.run(&[
        "audit",
        "log.csv",
        "--scene",
        "scene.toml",
        "--format",
        "json",
    ]);
    assert_eq!((run.code, &run.json()["samples"]), (2, &2.into()));
    assert!(
        run.stderr.contains("row 3: expected 2 fields, found 3"),
        "{}",
        run.stderr
    );
}

#[test]
fn what_was_read_of_a_file_that_was_cut_short_is_accounted_for() {
    use std::io::Write as _;
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    let rows: Vec<String> = (0..300).map(|i| (i * i % 7).to_string()).collect();
    let mut file = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    let text = format!("count\n{}\n", rows.join("\n"));
    file.write_all(text.as_bytes()).unwrap();
    let whole = file.finish().unwrap();
    dir.write("log.csv.gz", &whole[..whole.len() * 2 / 3]);
    let run = dir.run(&[
        "audit",
        "log.csv.gz",
        "--scene",
        "scene.toml",
        "--format",
        "json",
    ]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    let read = run.json()["samples"].as_u64().unwrap();
    assert!((2..300).contains(&read), "{read}");
    assert!(
        run.stderr.contains(&format!("row {}", read + 1)),
        "{}",
        run.stderr
    );
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

#[test]
fn counts_are_read_as_no_angles() {
    let dir = Dir::new();
    let smooth = "[device]\ninertia = \"2e-5 kg m^2\"\nviscous = \"1e-3 N m s/rad\"\ncoulomb = \"1.5e-3 N m\"\n\
        [sampling]\nrate = \"1 kHz\"\n[wall]\nstiffness = \"3 N m/rad\"\n";
    dir.write("smooth.toml", smooth);
    dir.write(
        "counted.toml",
        format!("{smooth}[encoder]\ncounts_per_revolution = 8192\n"),
    );
    let rows: String = (0..40)
        .map(|i| format!("0.{i:03},{},-0.01\n", i / 3))
        .collect();
    for name in ["count", "position"] {
        dir.write("log.csv", format!("t [s],{name},f [N m]\n{rows}"));
        for command in [
            "audit log.csv --scene smooth.toml",
            "identify log.csv --scene smooth.toml",
            "case smooth.toml --out case --log log.csv --device knob --date 2026-11-20",
        ] {
            let run = dir.run(&command.split(' ').collect::<Vec<_>>());
            assert_eq!(run.code, 2, "{command}: {}", run.stdout);
            assert!(!run.stderr.contains(" run: "), "{command}: {}", run.stderr);
            let says = "the lines `[encoder]` and `counts_per_revolution = …`";
            assert!(run.stderr.contains(says), "{command}: {}", run.stderr);
        }
    }
    let run = dir.run(&["audit", "log.csv", "--scene", "counted.toml"]);
    let says = "--columns 't=t [s], count=position, f=f [N m]'";
    assert!(run.stderr.contains(says), "{}", run.stderr);
}

#[test]
fn a_clock_without_a_name_is_offered_with_and_without_it() {
    let dir = Dir::new();
    dir.write("scene.toml", SCENE);
    // As pandas writes a table whose index is the time, every row two periods late.
    let rows =
        (0_i32..20).map(|i| format!("{:.4},{}\n", f64::from(i) * 7e-4, 20 * (i % 20 - 10).abs()));
    dir.write("log.csv", format!(",count\n{}", rows.collect::<String>()));
    let refused = dir.run(&["audit", "log.csv", "--scene", "scene.toml"]);
    let says = "the column number 1, which has no name, rises from row to row as a clock does";
    assert!(refused.stderr.contains(says), "{}", refused.stderr);
    let command =
        |columns: &str| format!("passivity audit log.csv --scene scene.toml --columns {columns}");
    let both = format!(
        "run: {} (or, where it is no clock: {})",
        command("'t=\"\" [s], count=count'"),
        command("'count=count'")
    );
    assert!(refused.stderr.contains(&both), "{}", refused.stderr);
    let with = "t=\"\" [s], count=count";
    for (columns, missed) in [(with, "19 samples missed"), ("count=count", "")] {
        let run = dir.run(&[
            "audit",
            "log.csv",
            "--scene",
            "scene.toml",
            "--columns",
            columns,
        ]);
        assert!(run.stdout.contains(missed), "{}", run.stdout);
        assert_eq!(run.stdout.contains("  sampling"), !missed.is_empty());
    }
}
