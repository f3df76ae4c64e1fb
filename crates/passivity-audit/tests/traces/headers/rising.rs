//! Columns under names that nobody knows, or under none, which rise from row to row as a clock does.

use super::{audited, audited_on, missed, proposed, refused, rotary};

/// Twenty rows of a device that goes to and fro, with what stands in them before its position.
fn log(header: &str, before: impl Fn(i64) -> String) -> String {
    let row = |i: i64| format!("{},{}\n", before(i), 20 * (i % 20 - 10).abs());
    let rows: String = (0..20).map(row).collect();
    format!("{header}\n{rows}")
}

#[test]
fn a_clock_of_any_name_is_not_passed_over() {
    for name in [
        "",
        "Unnamed: 0",
        "X_Value",
        "Sekunden",
        "Dauer",
        "created",
        "__index_level_0__",
        "index",
        "a,b",
    ] {
        let typed = if ["", "a,b"].contains(&name) {
            format!("\"{name}\"")
        } else {
            name.to_owned()
        };
        for (unit, step) in [("s", 0.0012), ("ms", 1.2), ("us", 1200.0), ("ns", 1.2e6)] {
            let header = format!("\"{name}\",count");
            #[expect(clippy::cast_precision_loss, reason = "twenty rows")]
            let log = log(&header, |i| format!("{:.4}", i as f64 * step));
            let error = refused(&log, None);
            let says = "rises from row to row as a clock does, and is not read";
            assert!(error.message.contains(says), "{error}");
            let shown = if name.is_empty() { "number 1" } else { name };
            assert!(error.message.contains(shown), "{error}");
            let proposal = error.proposal.unwrap();
            assert_eq!(proposal.columns, format!("t={typed} [{unit}], count=count"));
            assert_eq!(proposal.assumed, [format!("t in {unit}")]);
            let [other] = &proposal.otherwise[..] else {
                panic!("{log}");
            };
            assert_eq!(
                (&*other.columns, &*other.condition),
                ("count=count", "it is no clock")
            );
            assert!(missed(&audited(&log, Some(&proposal.columns)).unwrap()).is_some());
            // Who leaves it out has said so.
            assert_eq!(missed(&audited(&log, Some("count=count")).unwrap()), None);
        }
    }
    // Beside other columns that are proposed, and with what was typed.
    let log = log("Sekunden,pos", |i| format!("0.{:03}", i));
    assert_eq!(proposed(&log, None), "t=Sekunden [s], count=pos");
    assert_eq!(
        proposed(&log, Some("x=posi [mm]")),
        "t=Sekunden [s], x=pos [mm]"
    );
    let told = refused(&log, Some("t=Sekunden [s], x=posi [mm]"));
    assert_eq!(told.proposal.unwrap().otherwise, []);
    let error = refused(&log, None).to_string();
    assert!(
        error
            .contains("did you mean t=Sekunden [s], count=pos, or count=pos where it is no clock?"),
        "{error}"
    );
}

#[test]
fn a_counter_of_any_name_is_not_passed_over() {
    for name in ["cycle", "k", "frame", "packet_id", "row", "Nr", "counter"] {
        let columns = format!("tau={name}, count=count");
        let header = format!("{name},count");
        assert_eq!(proposed(&log(&header, |i| i.to_string()), None), columns);
        // Those that are missing are seen.
        let gap = log(&header, |i| (i + 7 * (i / 10)).to_string());
        assert_eq!(proposed(&gap, None), columns);
        assert_eq!(missed(&audited(&gap, Some(&columns)).unwrap()), Some(7));
        // What goes on by other steps may be a clock in no unit.
        let error = refused(&log(&header, |i| (70 * i).to_string()), None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(error.message.contains("nothing says how long"), "{error}");
    }
    // What counts the rows is not where the device was.
    let log = log("cycle_count,torque_Nm,enc_count", |i| format!("{i},0"));
    let error = audited_on(&rotary(), &log, None).unwrap_err();
    let columns = error.proposal.unwrap().columns;
    assert_eq!(columns, "tau=cycle_count, count=enc_count, f=torque_Nm");
}

#[test]
fn numbers_of_rows_and_what_cannot_be_a_clock_are_left_alone() {
    for name in ["", "Unnamed: 0", "index", "__index_level_0__"] {
        let header = format!("{name},count");
        for from in [0, 1] {
            let log = log(&header, |i| (i + from).to_string());
            audited(&log, None).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
        for steps in [
            (|i| (i + 5).to_string()) as fn(i64) -> String,
            |i| (2 * i).to_string(),
            |i| (i + i / 9).to_string(),
        ] {
            refused(&log(&header, steps), None);
        }
    }
    // What stands still once, falls, has the unit of something else, or stands beside a clock.
    for (header, before) in [
        ("raw,count", (|i| (i / 2).to_string()) as fn(i64) -> String),
        ("raw,count", |i| (-i).to_string()),
        ("raw [rad],count", |i| (3 * i).to_string()),
        ("raw,t [ms],count", |i| format!("{},{i}", 3 * i)),
    ] {
        audited(&log(header, before), None).unwrap_or_else(|error| panic!("{header}: {error}"));
    }
    // Of fewer rows nobody knows.
    audited("raw,count\n0,0\n3,1\n6,2\n", None).unwrap();
}

#[test]
fn durations_and_times_of_day_are_clocks_that_cannot_be_read() {
    for before in ["0 days 00:00:00.", "0:00:00.", "23:59.", "1 day 1:02:03."] {
        let log = log("Dauer,count", |i| format!("{before}{:03}", i));
        let error = refused(&log, None);
        assert_eq!(error.proposal, None, "{error}");
        let says = "cannot be read as one (durations and times of day are not read)";
        assert!(error.message.contains(says), "{error}");
        audited(&log, Some("count=count")).unwrap();
    }
    audited(&log("Dauer,count", |i| format!("0:0{}", i % 7)), None).unwrap();
}
