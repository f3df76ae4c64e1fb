//! What stands in parentheses may be a label, and what is after a limit was held: nothing of that is passed over.

use super::{proposed, refused};

/// Forty rows of one header.
fn log(header: &str, row: impl Fn(i32) -> String) -> String {
    let rows: String = (0..40).map(|i| row(i) + "\n").collect();
    format!("{header}\n{rows}")
}

#[test]
fn what_is_called_a_clock_or_a_force_is_not_passed_over_for_its_label() {
    let moving = |i: i32| format!("{},{i}", f64::from(i) * 0.02);
    let label = log("time [s] (A),x [mm]", moving);
    assert_eq!(proposed(&label, None), "t=time [s] (A) [s], x=x [mm]");
    for name in [
        "torque [N m] (C)",
        "force [N] (bar)",
        "force (bar)",
        "force_after_limit [N]",
        "force [N] after limit",
        "motor_force_ok [N]",
    ] {
        let row = |i: i32| format!("0.{i:03},{},0.5", i / 2);
        let error = refused(&log(&format!("t [s],count,{name}"), row), None);
        assert!(error.message.contains(name), "{name}: {error}");
    }
}

#[test]
fn a_clock_of_another_name_has_the_unit_of_its_usual_step() {
    let close = |i: i32| match i {
        3 => format!("3.99,{}", i * 2),
        _ => format!("{i},{}", i * 2),
    };
    let close = log("foo,x [mm]", close);
    assert_eq!(proposed(&close, None), "t=foo [ms], x=x [mm]");
    let micro = |i: i32| format!("{},{}", i * 1000 + if i == 3 { 999 } else { 0 }, i * 2);
    let micro = log("foo,x [mm]", micro);
    assert_eq!(proposed(&micro, None), "t=foo [us], x=x [mm]");
    // Nobody knows what it counts, unless its name says so.
    let tens = log("clk,x [mm]", |i| format!("{},{}", i * 10, i * 2));
    let error = refused(&tens, None);
    assert!(error.proposal.is_none(), "{error}");
    let says = "where it is no clock, name the others: `--columns 'x=x [mm]'`";
    assert!(error.message.contains(says), "{error}");
}

#[test]
fn whole_numbers_are_said_to_be_taken_for_counts() {
    let whole = log("t [s],angle", |i| format!("0.{i:03},{}", i % 7));
    let proposal = refused(&whole, None).proposal.unwrap();
    assert_eq!(proposal.columns, "t=t [s], count=angle");
    let says = ["the position in counts, as its numbers are whole"];
    assert_eq!(proposal.assumed, says);
}

/// What was typed is kept where only what stands between the fields was taken for granted: the force that it names was left
/// out, and the account would have been that of the wall's law.
#[test]
fn columns_that_were_named_are_offered_with_another_delimiter() {
    let log = log("zeit;pos;strom", |i| format!("0.{i:03};{};0.5", i % 7));
    let typed = "t=zeit [s], count=pos, f=strom [N]";
    let proposal = refused(&log, Some(typed)).proposal.unwrap();
    assert_eq!(
        (&proposal.columns[..], proposal.delimiter),
        (typed, Some(';'))
    );
}
