//! Columns that count samples or ticks of a clock, beside those of a position.

use super::{audited, proposed, refused};

/// A log of a device that rests and then jumps, with a column that counts by a step.
fn log(header: &str, step: u64) -> String {
    let rows = [0, 0, 0, 12, 0];
    let rows = (0..).zip(rows).map(|(i, n)| format!("{},{n}\n", i * step));
    format!("{header}\n{}", rows.collect::<String>())
}

#[test]
fn what_only_counts_up_beside_a_position_is_a_clock() {
    for name in [
        "tick",
        "Ticks",
        "systick",
        "HAL_GetTick",
        "xTaskGetTickCount",
        "tick_count",
    ] {
        for (position, read) in [
            ("pos_cnt", "count=pos_cnt"),
            ("count", "count=count"),
            ("enc", "count=enc"),
            ("pos", "count=pos"),
            ("x [mm]", "x=x [mm]"),
        ] {
            let error = refused(&log(&format!("{name},{position}"), 1), None);
            let is_said = ["count", "x [mm]"].contains(&position);
            let named = |column: &str| error.message.contains(&format!("`{column}`"));
            assert!(named(name) && (is_said || named(position)), "{error}");
            let columns = error.proposal.map(|proposal| proposal.columns);
            assert_eq!(columns, Some(format!("t={name} [ms], {read}")));
            // Of ticks that are no sampling periods in any unit, and of some that do not tell rows apart, no time is known.
            for text in [
                log(&format!("{name},{position}"), 5000),
                format!("{name},{position}\n0,0\n0,0\n1,12\n1,0\n2,0\n"),
            ] {
                let error = refused(&text, None);
                assert_eq!(error.proposal, None, "{error}");
                let says = format!("`{name}` cannot be read (nothing says how long");
                assert!(error.message.contains(&says), "{error}");
            }
        }
    }
    for name in ["sample", "seq", "sample_count", "header.seq", "iteration"] {
        let expected = format!("tau={name}, count=pos_cnt");
        assert_eq!(
            proposed(&log(&format!("{name},pos_cnt"), 1), None),
            expected
        );
        // Those that are missing are seen.
        let gap = format!("{name},count\n0,0\n1,0\n4,1\n");
        let found = audited(&gap, Some(&proposed(&gap, None))).unwrap();
        assert_eq!(super::missed(&found), Some(2));
    }
}

#[test]
fn a_counter_stands_in_for_no_clock_and_for_no_position() {
    let five = |header: &str, last: [&str; 5]| {
        let rows = (0..).zip(last).map(|(i, last)| format!("{i},{i},{last}\n"));
        format!("{header}\n{}", rows.collect::<String>())
    };
    let jump = ["0", "0", "0", "12", "0"];
    for (header, columns) in [
        ("t [ms],tick,pos_cnt", "t=t [ms], count=pos_cnt"),
        ("seq,time,pos_cnt", "t=time [ms], count=pos_cnt"),
        ("seq,tick,enc", "t=tick [ms], count=enc"),
        ("seq,t [ms],ticks", "t=t [ms], count=ticks"),
    ] {
        assert_eq!(proposed(&five(header, jump), None), columns, "{header}");
    }
    let error = refused(&five("t [ms],tick,pos_cnt", jump), None);
    assert_eq!(error.proposal.unwrap().others, ["tick"]);
    // A time in sampling periods is one beside a counter.
    assert!(audited(&five("tau,seq,count", jump), None).is_ok());
    let dated = five("seq,count,Uhrzeit", ["12.3", "a", "b", "c", "d"]);
    assert_eq!(refused(&dated, None).proposal, None);
    // With nothing that is known to be a position.
    for header in ["tick,raw", "tick,pos_ref"] {
        let error = refused(&log(header, 1), None);
        assert_eq!(error.proposal, None, "{error}");
        assert!(
            error
                .message
                .contains("no column is known to be the position"),
            "{error}"
        );
    }
    // What goes both ways, or is the only one, is where the device was.
    assert_eq!(proposed("tick\n0\n1\n2\n", None), "count=tick");
    assert_eq!(
        proposed("seq,tick\n0,0\n1,3\n2,1\n", None),
        "tau=seq, count=tick"
    );
    assert_eq!(
        proposed("t [ms],tick\n0,0\n1,1\n2,2\n", None),
        "t=t [ms], count=tick"
    );
    assert_eq!(
        proposed("t [ms],encoder_ticks\n0,0\n1,1\n2,2\n", None),
        "t=t [ms], count=encoder_ticks"
    );
}
