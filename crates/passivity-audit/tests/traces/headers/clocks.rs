//! Clocks: dates, clocks that cannot be read, and the units in which they tick.

use passivity_audit::{Options, Partial, Stretch, audit_files, audit_part, merge_parts};

use super::{as_proposed, audited, dialect, missed, proposed, refused, scene};
use crate::scratch::Scratch;

/// Three samples, the second four periods after the first and the third five after it, with these times.
fn counts(clock: &str, times: [&str; 3]) -> String {
    let [first, second, third] = times;
    format!("{clock},count\n{first},0\n{second},20\n{third},0\n")
}

#[test]
fn dates_are_a_clock() {
    let nanoseconds = counts(
        "t [ns]",
        [
            "1700000000000000000",
            "1700000000004000000",
            "1700000000009000000",
        ],
    );
    let expected = audited(&nanoseconds, None).unwrap().to_json();
    for times in [
        [
            "2023-11-14T22:13:20.000000000Z",
            "2023-11-14T22:13:20.004000000Z",
            "2023-11-14T22:13:20.009000000Z",
        ],
        [
            "2023-11-14 22:13:20+00:00",
            "2023-11-14 22:13:20.004+00:00",
            "2023-11-14 22:13:20.009+00:00",
        ],
        [
            "2023-11-14T23:59:59.996",
            "2023-11-15T00:00:00",
            "2023-11-15T00:00:00.005",
        ],
        [
            "\"2023-11-14T22:13:20.0000000000000000000Z\"",
            "2023-11-14T23:13:20.004+01:00",
            "2023-11-14 22:13:20.009 UTC",
        ],
    ] {
        let (columns, audit) = as_proposed(&counts("timestamp", times));
        assert_eq!(columns, "t=timestamp, count=count");
        assert_eq!(missed(&audit), Some(7), "{times:?}");
        let mut json = audit.to_json();
        json.as_object_mut().unwrap().remove("columns");
        assert_eq!(json, expected, "{times:?}");
        let by_name = audited(&counts("t", times), None).unwrap();
        assert_eq!(by_name.to_json(), expected, "{times:?}");
    }
}

#[test]
fn dates_are_not_mixed_with_numbers_and_are_nothing_but_times() {
    let dates = ["2023-11-14T22:13:20Z", "2023-11-14T22:13:21Z", "5"];
    let mixed = counts("t", dates);
    let audit = audited(&mixed, None).unwrap();
    let error = audit.error().unwrap();
    assert_eq!((error.kind, error.row), ("date", Some(3)), "{error}");
    let late = mixed.replace("\n5,0\n", "\n");
    let later: String = (22..60)
        .map(|s| format!("2023-11-14T22:13:{s}Z,0\n"))
        .collect();
    let audit = audited(&format!("{late}{later}5,0\n"), None).unwrap();
    let error = audit.error().unwrap();
    assert_eq!((error.kind, error.row), ("date", Some(41)), "{error}");
    let dated = counts(
        "when",
        ["2023-11-14T22:13:20Z", dates[1], "2023-11-14T22:13:22Z"],
    );
    let says = |columns: &str| refused(&dated, Some(columns)).to_string();
    assert!(says("count=count, f=when [N]").contains("is a time, and `f` is none"));
    assert!(says("count=count, t=when [ms]").contains("it is in `s`, not in `ms`"));
    audited(&dated, Some("count=count, t=when [s]")).unwrap();
}

#[test]
fn a_date_that_cannot_be_read_is_an_error_of_its_row() {
    let good = ["2023-11-14T22:13:20Z", "2023-11-14T22:13:20.001Z"];
    for (log, row, intervals) in [
        (counts("t", [good[0], good[1], "2023-11-14T22:13:2"]), 3, 1),
        (
            counts("t", [good[0], good[1], "2023-11-14T22:13:60.001Z"]),
            3,
            1,
        ),
        (counts("t", [good[0], "", good[1]]), 2, 0),
        (
            counts("t", [good[0], "2023-11-14T22:13.001Z", good[1]]),
            2,
            0,
        ),
        (
            counts("t", ["2023-11-14T22:13:60Z", good[0], good[1]]),
            1,
            0,
        ),
    ] {
        let audit = audited(&log, None).unwrap();
        let error = audit.error().unwrap();
        assert_eq!((error.kind, error.row), ("date", Some(row)), "{error}");
        assert_eq!(audit.totals().intervals, intervals, "{log}");
    }
    // Of two rows one is enough.
    let torn = format!("t,count\n{},0\n2023-11-14T22:13:2,1", good[0]);
    let audit = audited(&torn, None).unwrap();
    let error = audit.error().unwrap().to_string();
    let says = "row 2, column `t`: expected a date and a time of day, as in `2023-11-14T22:13:20.5Z`, found `2023-11-14T22:13:2`";
    assert!(error.contains(says), "{error}");
}

#[test]
fn the_files_of_a_log_go_on_with_dates() {
    let first = counts(
        "t",
        [
            "2023-11-14T22:13:20Z",
            "2023-11-14T22:13:20.001Z",
            "2023-11-14T22:13:20.002Z",
        ],
    );
    let good = "t,count\n2023-11-14T22:13:20.003Z,1\n";
    let bad = "t,count\n1700000000.003,1\n";
    let files = |next: &str| {
        let files = [first.as_str(), next].map(|text| Scratch::new("csv", text.as_bytes()));
        let paths = [files[0].to_path_buf(), files[1].to_path_buf()];
        audit_files(
            &paths,
            &scene(),
            Options {
                dialect: dialect(None),
                ..Options::default()
            },
        )
        .unwrap()
    };
    let audit = files(good);
    assert_eq!((audit.error(), missed(&audit)), (None, Some(0)));
    assert_eq!(files(bad).error().unwrap().kind, "date");
    assert_eq!(files("t,count\n").error(), None);
}

#[test]
fn no_command_leaves_out_a_clock_that_cannot_be_read() {
    for (header, time) in [
        ("Time,Position,Force", "0.001 sec"),
        ("timestamp,x [m],f [N]", "14.11.2023 22:13"),
    ] {
        let log = format!("{header}\n{time},0.1,1\n{time},0.2,1\n");
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        let error = error.to_string();
        assert!(error.contains("write its times as numbers"), "{error}");
        assert!(error.contains("one sampling period apart"), "{error}");
        // Nor where something else was told wrongly.
        assert_eq!(proposed(&log, Some("x=posture [m]")), "");
    }
    // Who says so leaves it out.
    let log = "Time,Position\n0 sec,0.1\n1 sec,0.2\n";
    audited(log, Some("x=Position [m]")).unwrap();
}

#[test]
fn the_unit_of_a_clock_is_the_one_that_its_name_says() {
    for (name, times, columns) in [
        ("millis", ["0", "40", "80"], "t=millis [ms]"),
        ("millis()", ["0", "40", "80"], "t=millis() [ms]"),
        ("seconds", ["0.00", "0.04", "0.08"], "t=seconds [s]"),
        (
            "seconds_since_start",
            ["0", "4", "8"],
            "t=seconds_since_start [s]",
        ),
        ("timeMicros", ["0", "4", "8"], "t=timeMicros [us]"),
        ("time.nanos", ["0", "4", "8"], "t=time.nanos [ns]"),
        (
            "timestamp_ns_utc",
            ["0", "4", "8"],
            "t=timestamp_ns_utc [ns]",
        ),
        // Names that say nothing, or of something else.
        ("time", ["0", "400", "800"], "t=time [us]"),
        ("second_time", ["0", "1000", "2000"], "t=second_time [us]"),
        (
            "time_since_s_curve",
            ["0", "1000", "2000"],
            "t=time_since_s_curve [us]",
        ),
    ] {
        let log = counts(name, times);
        assert_eq!(
            proposed(&log, None),
            format!("{columns}, count=count"),
            "{name}"
        );
    }
    // A header that is understood but for the unit.
    let log = "x [m],t,enc.micros\n0,0.001,0\n0.1,0.002,4\n";
    assert_eq!(proposed(log, None), "t=t [s], x=x [m]");
}

#[test]
fn clocks_that_are_called_by_their_unit_are_not_passed_over() {
    for name in [
        "us",
        "ms",
        "ns",
        "msec",
        "usec",
        "nsec",
        "nanosec",
        "uptime",
        "datetime",
        "unix",
        "Zeit",
        "perf_counter",
        "monotonic_ns",
        "ms_since_boot",
    ] {
        let proposed = proposed(&counts(name, ["0", "4", "8"]), None);
        assert!(
            proposed.starts_with(&format!("t={name}")),
            "{name}: {proposed}"
        );
    }
}

/// A sample a millisecond, with a second that begins after the second of them, its time in two columns, and in one.
fn stamps(names: [&str; 2], samples: i64) -> [String; 2] {
    let [seconds, beyond] = names;
    let mut split = format!("{beyond},count,{seconds}\n");
    let mut whole = "t [ns],count\n".to_owned();
    let scale = if beyond.contains("us") { 1_000 } else { 1 };
    for i in 0..samples {
        let time = 1_699_999_999_998_000_000 + i * 1_000_000;
        let (seconds, beyond) = (time / 1_000_000_000, time % 1_000_000_000 / scale);
        split += &format!("{beyond},{},{seconds}\n", i % 3);
        whole += &format!("{time},{}\n", i % 3);
    }
    [split, whole]
}

#[test]
fn a_stamp_in_two_columns_is_one_clock() {
    for (names, proposed) in [
        (
            ["header.stamp.sec", "header.stamp.nanosec"],
            "t=header.stamp.sec [s] + header.stamp.nanosec [ns], count=count",
        ),
        (
            ["stampSecs", "stampNsecs"],
            "t=stampSecs [s] + stampNsecs [ns], count=count",
        ),
        (["tv_sec", "tv_usec"], "t=tv_sec + tv_usec, count=count"),
        (
            ["a + b, sec", "a + b, nanosec"],
            "t=\"a + b, sec\" + \"a + b, nanosec\" [ns], count=count",
        ),
    ] {
        // Also where the first rows are of one second.
        for samples in [2, 40] {
            let [split, whole] = stamps(
                names.map(|n| if n.contains(',') { "\"quoted\"" } else { n }),
                samples,
            );
            let split = match names[0].contains(',') {
                true => split
                    .replacen("\"quoted\"", &format!("\"{}\"", names[1]), 1)
                    .replacen("\"quoted\"", &format!("\"{}\"", names[0]), 1),
                false => split,
            };
            let (columns, audit) = as_proposed(&split);
            assert_eq!(columns, proposed);
            let mut json = audit.to_json();
            assert_eq!(
                json.as_object_mut().unwrap().remove("columns").unwrap(),
                proposed
            );
            assert_eq!(json, audited(&whole, None).unwrap().to_json(), "{proposed}");
        }
    }
}

#[test]
fn two_clocks_are_no_stamp_and_a_stamp_is_checked() {
    // Each is a clock of its own.
    let log = "sec,nanosec,count\n0,0,0\n1,1000000000,1\n2,2000000000,2\n";
    assert_eq!(proposed(log, None), "t=sec [s], count=count");
    let told = |columns: &str| audited(log, Some(columns));
    let error = told("t=sec [s] + nanosec [ns], count=count").unwrap();
    let error = error.error().unwrap();
    assert_eq!((error.kind, error.row), ("split_time", Some(2)), "{error}");
    let error = told("t=nanosec [ns] + sec [s], count=count").unwrap_err();
    assert!(
        error.to_string().contains("is in a smaller unit"),
        "{error}"
    );
    assert!("t=a + b + c".parse::<passivity_audit::Columns>().is_err());
    let fractions = "sec,nanosec,count\n0.5,0,0\n1.5,1,1\n";
    let audit = audited(fractions, Some("t=sec [s] + nanosec [ns], count=count")).unwrap();
    assert!(
        audit
            .error()
            .unwrap()
            .message
            .contains("a whole number, found 1/2")
    );
}

#[test]
fn dates_and_stamps_in_pieces_are_those_of_the_whole() {
    let dates: String = (10..60)
        .map(|s| format!("2023-11-14T22:13:{s}Z,{}\n", s % 3))
        .collect();
    let [split, _] = stamps(["sec", "nanosec"], 50);
    for (log, columns) in [
        (format!("t,count\n{dates}"), None),
        (split, Some("t=sec [s] + nanosec [ns], count=count")),
    ] {
        let file = Scratch::new("csv", log.as_bytes());
        let options = || Options {
            dialect: dialect(columns),
            ..Options::default()
        };
        let part = |i| {
            let part = audit_part(&file, &scene(), Stretch::Shard(i, 2), options()).unwrap();
            let part = Partial::from_json(&part.to_json().unwrap()).unwrap();
            (i.to_string(), part)
        };
        let merged = merge_parts(&[part(1), part(2)], &scene()).unwrap();
        let whole = audit_files(&[file.to_path_buf()], &scene(), options()).unwrap();
        assert_eq!(merged.to_json(), whole.to_json());
    }
}

#[test]
fn no_unit_is_proposed_for_times_that_are_no_numbers() {
    for clock in ["t", "tau", "time"] {
        for times in [
            ["14.11.2023 22:13", "14.11.2023 22:14", "14.11.2023 22:15"],
            ["a", "b", "c"],
        ] {
            let error = refused(&counts(clock, times), None);
            assert_eq!(error.proposal, None, "{error}");
            let says = format!(
                "the column `{clock}` cannot be read (row 1 has no number there but `{}`)",
                times[0]
            );
            assert!(error.to_string().contains(&says), "{error}");
        }
    }
    // One among numbers is an error of its row.
    let error = refused(&counts("t", ["0", "?", "0.009"]), None);
    assert!(error.to_string().contains("unit"), "{error}");
}

#[test]
fn clocks_of_other_names_are_not_passed_over() {
    for name in [
        "wall_time",
        "wall clock",
        "command_time",
        "cmd_stamp",
        "target_time",
        "time_ref",
        "walltime",
        "rostime",
        "runtime",
        "sampletime",
        "tstamp",
        "tsec",
        "utc",
        "Uhrzeit",
        "Datum",
        "temps",
        "tempo",
        "tijd",
        "czas",
        "время",
        "時間",
        "时刻",
        "时间",
        "hora",
    ] {
        let log = counts(name, ["0", "0.004", "0.009"]);
        assert_eq!(proposed(&log, None), format!("t={name} [s], count=count"));
        // The plain one is meant where there are both.
        let log = format!("time,{name},count\n0,0,0\n0.004,1,20\n0.009,2,0\n");
        assert_eq!(proposed(&log, None), "t=time [s], count=count", "{name}");
    }
}

#[test]
fn no_command_leaves_out_a_part_of_a_clock() {
    for (names, times) in [
        ("min,sec", ["0,10.000", "0,10.004", "1,10.009"]),
        ("minute,second", ["0,59.996", "1,0.000", "1,0.005"]),
        ("hour,min,sec", ["1,0,10.000", "1,0,10.004", "1,1,10.009"]),
        ("s,ms,us", ["0,0,0", "0,4,0", "0,9,999"]),
    ] {
        let error = refused(&counts(names, times), None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(
            error
                .to_string()
                .contains("it is one of several columns that say together when a sample was"),
            "{error}"
        );
    }
    let log = counts("ms,us", ["0,999", "5,000", "9,999"]);
    assert_eq!(proposed(&log, None), "t=ms [ms] + us [us], count=count");
    // A least value is no minute.
    let log = counts("min,sec", ["-3,10.000", "0,10.004", "1,10.009"]);
    assert_eq!(proposed(&log, None), "t=sec [s], count=count");
    let error = refused(&counts("time_100us", ["0", "40", "90"]), None);
    assert_eq!(error.proposal, None, "{error}");
}

/// `%time` is when the recorder got a message, and not even.
#[test]
fn the_stamp_of_a_message_goes_before_the_time_at_which_rostopic_got_it() {
    let rows = (0..24_i64).map(|i| {
        let got = 1_763_735_621_136_580_739 + 1_000_000 * i + i % 3 * 170_000;
        let stamp = 1_763_735_621_136_472_035 + 1_000_000 * i;
        format!("{got},{i},{stamp},,knob,{}.5,0,0\n", i % 7)
    });
    let rows: String = rows.collect();
    let fields = "field.header.seq,field.header.stamp,field.header.frame_id,field.name0,field.position0,field.velocity0,field.effort0";
    let error = refused(&format!("%time,{fields}\n{rows}"), None);
    let proposal = error.proposal.unwrap();
    assert_eq!(
        proposal.columns,
        "t=field.header.stamp [ns], x=field.position0 [m], v=field.velocity0 [m/s], f=field.effort0 [N]"
    );
    assert_eq!(proposal.others, ["time"]);
    // Where a message has no stamp of its own, that of the recorder is all there is.
    let (fields, rows) = (
        "field.position0,field.effort0",
        "1000000,0.5,0\n2000000,0.6,0\n",
    );
    assert_eq!(
        proposed(&format!("%time,{fields}\n{rows}"), None),
        "t=time [ns], x=field.position0 [m], f=field.effort0 [N]"
    );
}
