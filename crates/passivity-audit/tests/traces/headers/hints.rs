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
fn a_position_of_another_name_is_shown_as_it_is_typed() {
    for (log, example) in [
        (
            "Zeit [s],Foo\n0,1\n0.001,2\n",
            "`--columns 't=Zeit [s], count=Foo'`",
        ),
        (
            "Zeit [s],Foo\n0,1\n0.001,2.5\n",
            "`--columns 't=Zeit [s], x=Foo [m]'`",
        ),
    ] {
        let error = refused(log, None);
        assert!(error.message.ends_with(example), "{error}");
        let error = refused(&log.replace(',', ";").replace('.', ","), None);
        let options = "(`--delimiter ';' --decimal-comma` says so)";
        assert!(
            error.message.contains(options) && error.message.ends_with(example),
            "{error}"
        );
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
