//! What the steps of a clock say of its unit, and columns that have steps in the place of times.

use passivity_audit::{Audit, Otherwise};

use super::{audited, proposed, refused};

/// Forty samples with these times.
fn log(clock: &str, time: impl Fn(u32) -> String) -> String {
    let rows = (0..40).map(|i| format!("{},{},{}\n", time(i), i % 2 * 60, i % 2));
    format!("{clock},count,f [N]\n{}", rows.collect::<String>())
}

/// A log of a sample every 50 ms may be one of twenty rows in a period of 1 ms.
#[test]
fn a_clock_that_may_tick_in_two_units_is_proposed_in_both() {
    for (name, step, units) in [
        ("time", 50.0, ["ms", "us"]),
        ("time", 10.0, ["ms", "us"]),
        ("clk_time", 0.05, ["s", "ms"]),
        ("t", 50_000.0, ["us", "ns"]),
    ] {
        let log = log(name, |i| (f64::from(i) * step).to_string());
        let [first, second] = units.map(|unit| format!("t={name} [{unit}], count=count, f=f [N]"));
        let proposal = refused(&log, None).proposal.unwrap();
        assert_eq!(proposal.columns, first);
        let condition = format!("times are in {}", units[1]);
        let other = Otherwise {
            condition,
            columns: second.clone(),
        };
        assert_eq!(proposal.otherwise, [other]);
        let verdict = |columns: &str| {
            audited(&log, Some(columns))
                .as_ref()
                .map(Audit::to_text)
                .unwrap()
        };
        assert_ne!(verdict(&first), verdict(&second));
    }
    // With positions that may be in two units as well.
    let two = "time,pos,f [N]\n0,0.5,0\n50,1,0\n100,0.7,0\n";
    let ways = refused(two, None).proposal.unwrap().otherwise;
    let conditions: Vec<&str> = ways.iter().map(|way| way.condition.as_str()).collect();
    assert_eq!(
        conditions,
        [
            "times are in us",
            "positions are in mm",
            "times are in us and positions are in mm"
        ]
    );
    // Where one is near, or the name says it, there is no other.
    for (name, step, unit) in [
        ("time", 1, "ms"),
        ("time", 2, "ms"),
        ("millis", 50, "ms"),
        ("time", 500, "us"),
        ("time", 5000, "us"),
    ] {
        let log = log(name, |i| (i * step).to_string());
        assert_eq!(
            proposed(&log, None),
            format!("t={name} [{unit}], count=count, f=f [N]")
        );
        assert_eq!(refused(&log, None).proposal.unwrap().otherwise, []);
    }
}

#[test]
fn lengths_of_intervals_are_not_passed_over_for_rows_one_period_apart() {
    for (name, unit) in [
        ("dt [us]", "us"),
        ("dt_us", "us"),
        ("dt (us)", "us"),
        ("loop_us", "us"),
        ("interval_us", "us"),
        ("period [us]", "us"),
        ("Δt", "UNIT"),
        ("∆t [us]", "us"),
        ("dt", "UNIT"),
        ("delta_t [us]", "us"),
        ("looptime_us", "us"),
        ("step_time_us", "us"),
        ("cycle time [usec]", "us"),
    ] {
        for length in ["5000", "1003"] {
            let rows: String = (0..12)
                .map(|i| format!("{},{length}\n", i % 2 * 60))
                .collect();
            let log = format!("count,{name}\n{rows}");
            let error = refused(&log, None);
            assert_eq!(error.proposal, None, "{error}");
            let text = error.to_string();
            for says in [
                &format!(
                    "the column `{name}` cannot be read as a clock: it seems to have the lengths"
                ),
                "all rows are taken to be one sampling period apart",
                "of a log of one line of names and rows of numbers below it",
                &format!(
                    "`awk -F',' -v OFS=',' 'NR == 1 {{print \"t_{unit}\", $0; next}} NR > 2 {{t += $2}} {{print sprintf(\"%.9f\", t), $0}}' \
                     log.csv > timed.csv` where each is the time since the row before"
                ),
            ] {
                assert!(text.contains(says), "{name}: {text}");
            }
            audited(&log, Some("count=count")).unwrap();
        }
        // Where all are one period, and beside a clock, they say nothing more.
        for log in [
            format!("count,{name}\n0,1000\n1,1000\n0,1000\n"),
            format!("t [ms],count,{name}\n0,0,5000\n5,1,5000\n10,0,5000\n"),
        ] {
            audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
    }
    // Before the first row there is no other.
    for first in ["0", "NaN", ""] {
        let log = format!("count,dt [us]\n0,{first}\n60,5000\n0,5003\n60,5000\n");
        let error = refused(&log, None).to_string();
        assert!(error.contains("the lengths of the intervals"), "{error}");
        let one = log.replace("500", "100").replace("1003", "1000");
        audited(&one, None).unwrap_or_else(|error| panic!("{first}: {error}"));
    }
    // As `awk` makes it.
    let timed = "t_us,count,dt [us]\n0.000000000,0,NaN\n5000.000000000,60,5000\n";
    let report = audited(timed, None).unwrap().to_json();
    let expected = audited("t [ms],count,dt [us]\n0,0,NaN\n5,60,5000\n", None).unwrap();
    assert_eq!(report, expected.to_json());
}

/// What a controller took for its work is no time from row to row, and what stands in each row is no clock.
#[test]
fn short_lengths_and_settings_are_passed_over() {
    for (name, values) in [
        ("loop_us", ["40", "40", "40", "40"]),
        ("loop_us", ["0", "40", "43", "39"]),
        ("cycle_time_us", ["40", "41", "900", "39"]),
        ("dt [us]", ["450", "450", "450", "450"]),
        ("loop_time", ["40", "40", "40", "40"]),
        ("start_time", ["5", "5", "5", "5"]),
        ("start_time [s]", ["5", "5", "5", "5"]),
        ("interval", ["5", "5", "5", "5"]),
        ("period", ["2", "2", "2", "2"]),
    ] {
        let rows = values.map(|value| format!("0,{value}\n")).concat();
        let audit = audited(&format!("count,{name}\n{rows}"), None);
        let audit = audit.unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(audit.report().not_read, [name]);
    }
    // The seconds of a clock in two columns stand, too.
    let parts = "stamp.sec,stamp.nanosec,count\n7,0,0\n7,1000000,1\n7,2000000,0\n";
    let columns = proposed(parts, None);
    assert!(columns.contains("stamp.nanosec"), "{columns}");
}

#[test]
fn no_clock_is_proposed_that_stands_still_between_the_first_rows() {
    for name in ["millis", "time", "timestamp [ms]"] {
        let log = format!("{name},pos,F\n0,0.5,0\n0,1,0\n1,0.5,0\n2,0.7,0\n");
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        let text = error.to_string();
        let says = format!(
            "the column `{name}` cannot be read as a clock: rows 1 and 2 have the same time: a clock that stands still between \
             two rows is too coarse"
        );
        assert!(text.contains(&says), "{text}");
        // A finer one is proposed in its place.
        let finer = log
            .replace(name, &format!("{name},micros"))
            .replace("\n0,0.5", "\n0,0,0.5");
        let finer = finer
            .replace("\n0,1", "\n0,500,1")
            .replace("\n1,", "\n1,1000,");
        let finer = finer.replace("\n2,", "\n2,2000,");
        assert_eq!(proposed(&finer, None), "t=micros [us], x=pos [m], f=F [N]");
    }
}
