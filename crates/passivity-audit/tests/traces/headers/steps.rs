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
