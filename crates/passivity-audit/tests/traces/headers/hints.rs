//! What errors say beside what is wrong: what is left out, and where a recording was interrupted.

use super::{audited, audited_on, proposed, refused, rotary};

#[test]
fn columns_that_leave_the_position_out_are_said_to_and_completed() {
    let log = "t [s],count,pwm\n0,0,0.5\n0.001,1,0.5\n";
    let error = audited_on(&rotary(), log, Some("f=pwm [N m]")).unwrap_err();
    let says = "`--columns` leaves the position out: name its column there, too";
    assert!(error.message.starts_with(says), "{error}");
    let columns = error.proposal.unwrap().columns;
    assert_eq!(columns, "t=t [s], count=count, f=pwm [N m]");
    assert!(audited_on(&rotary(), log, Some(&columns)).is_ok());
}

#[test]
fn where_no_column_is_known_to_be_the_position_none_is_filled_in() {
    // What is there may be the number of a row, a temperature, a state, or the position.
    for (header, row, others) in [
        (
            ",Zeit [us],Moment [N]",
            "0.5,ROW000,0.1",
            ["t=Zeit [us], ", ", f=Moment [N]"],
        ),
        (
            "Unnamed: 0,Zeit [us],Kraft [mN]",
            "ROW,ROW000,0.1",
            ["t=Zeit [us], ", ", f=Kraft [mN]"],
        ),
        ("temp_C,Zeit [us]", "25.ROW,ROW000", ["t=Zeit [us], ", ""]),
        (
            "state,Zeit [us],Kraft [N]",
            "1,ROW000,0.1",
            ["t=Zeit [us], ", ", f=Kraft [N]"],
        ),
        ("Zeit [us],Foo", "ROW000,ROW.5", ["t=Zeit [us], ", ""]),
    ] {
        let rows: String = (0..9)
            .map(|i| row.replace("ROW", &i.to_string()) + "\n")
            .collect();
        let log = format!("{header}\n{rows}");
        let columns = others.join("count=NAME");
        let says = format!(
            "`--columns` names it, as in `--columns '{columns}'` with the name of its column in place of `NAME`, or \
             `x=NAME [UNIT]` with its unit where it has no counts"
        );
        let error = refused(&log, None);
        assert!(error.message.ends_with(&says), "{error}");
        assert_eq!(error.proposal, None, "{error}");
        // Typed as it stands it is an error, and so it is with its unit.
        let there_is_none = refused(&log, Some(&columns));
        assert_eq!(there_is_none.kind, "no_column", "{there_is_none}");
        let there_is_none = refused(&log, Some(&others.join("x=NAME [UNIT]")));
        assert_eq!(there_is_none.kind, "no_column", "{there_is_none}");
        let swapped = log.replace(',', ";").replace('.', ",");
        let options = "(`--delimiter ';'";
        let error = refused(&swapped, None);
        assert!(
            error.message.contains(options) && error.message.ends_with(&says),
            "{error}"
        );
        // A column of that name would be read.
        let error = refused(
            &log.replacen(
                header,
                &header.replace("Foo", "NAME").replace("state", "NAME"),
                1,
            ),
            None,
        );
        assert!(
            error.message.ends_with(&says) != (header.contains("Foo") || header.contains("state")),
            "{error}"
        );
    }
}

#[test]
fn steps_are_counts_unless_they_may_number_the_rows() {
    for name in [
        "step",
        "steps",
        "Schritte",
        "motor_steps",
        "Motorschritte [step]",
    ] {
        let log = |counts: [i32; 3]| {
            let rows = (0..).zip(counts).map(|(i, n)| format!("{i},{n},0.1\n"));
            format!("t [ms],{name},f [N]\n{}", rows.collect::<String>())
        };
        let named = proposed(&log([4, 5, 3]), None);
        let known = named == format!("t=t [ms], count={name}, f=f [N]");
        assert!(known, "{name}: {named}");
        let rising = refused(&log([4, 5, 6]), None);
        let is_open = rising.proposal.is_none();
        assert_eq!(is_open, !name.contains('['), "{rising}");
    }
    // No row has a number below zero.
    let below = "t [ms],Schritte,f [N]\n0,-7,0\n1,-5,0\n2,-4,0\n";
    assert_eq!(proposed(below, None), "t=t [ms], count=Schritte, f=f [N]");
    let of_time = "t [ms],time_step,f [N]\n0,4,0\n1,3,0\n2,5,0\n";
    assert_eq!(proposed(of_time, None), "");
}

#[test]
fn positions_are_known_by_words_of_two() {
    for name in [
        "Motorwinkel",
        "motorposition",
        "Istposition",
        "Drehwinkel",
        "handleangle",
    ] {
        let log = format!("t [ms],{name},f [N]\n0,0.5,0.1\n1,0.25,0.1\n");
        assert_eq!(
            proposed(&log, None),
            format!("t=t [ms], x={name} [m], f=f [N]")
        );
    }
    for name in [
        "Sollwinkel",
        "triangle",
        "Wandposition",
        "setposition",
        "composition",
    ] {
        let log = format!("t [ms],{name},f [N]\n0,0.5,0.1\n1,0.25,0.1\n");
        let error = audited(&log, None)
            .err()
            .or_else(|| audited(&log, None).unwrap().error().cloned());
        assert_eq!(error.unwrap().proposal, None, "{name}");
    }
}

#[test]
fn counts_are_known_by_their_names_in_german() {
    for name in ["Inkremente", "Geber Inkremente", "encoder pulses"] {
        let log = format!("t [s],{name},f [N]\n0,1,0\n0.001,1,0\n");
        assert_eq!(
            proposed(&log, None),
            format!("t=t [s], count={name}, f=f [N]")
        );
    }
}

#[test]
fn an_interrupted_recording_is_said_to_be_one() {
    for (log, says) in [
        (
            "t [us],x [mm]\n4294966000,0\n4294967000,0\n704,0\n",
            "row 3, column `t [us]`: expected a time after 4294967000, found 704 (a clock of 32 bits goes on",
        ),
        (
            "t [s],x [mm]\n12.5,0\n12.501,0\n0.001,0\n",
            "found 1/1000 (if the recording starts again here, make what follows a log of its own)",
        ),
        (
            "t [s],x [mm]\n0,0\n0.001,0\nt [s],x [mm]\n0,0\n",
            "row 3: the names of the columns stand here again: if the recording starts again here, make what follows a log",
        ),
        (
            "t,x\ns,mm\n0,0\n0.001,0\nt,x\n0,0\n",
            "row 3: the names of the columns stand here again",
        ),
    ] {
        let audit = audited(log, None).unwrap();
        let error = audit.error().unwrap().to_string();
        assert!(error.contains(says), "{error}");
    }
    // A row out of order is none of both.
    let audit = audited("t [us],x [mm]\n4000,0\n5000,0\n4500,0\n", None).unwrap();
    let error = audit.error().unwrap().to_string();
    assert!(
        error.ends_with("expected a time after 5000, found 4500"),
        "{error}"
    );
}

/// A comma parts the number of the only column, too.
#[test]
fn a_column_alone_may_have_commas_before_its_decimals() {
    for decimals in ["0,05\n0,06\n", "-12,5\r\n3,0\r\n"] {
        let log = format!("x [mm]\n{decimals}");
        let audit = audited(&log, None).unwrap();
        let error = audit.error().unwrap().to_string();
        let says = "row 1: expected 1 fields, found 2 (if its numbers are written with a comma before the decimals, read the log with \
            `--delimiter ';' --decimal-comma`)";
        assert!(error.contains(says), "{error}");
    }
    // What is no number in that notation either.
    for row in ["0,05,1", "a,b", "0.5,1"] {
        let audit = audited(&format!("x [mm]\n{row}\n"), None).unwrap();
        let error = audit.error().unwrap().to_string();
        assert!(!error.contains("--decimal-comma"), "{error}");
    }
}
