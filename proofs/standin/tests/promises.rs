//! A harness that does not keep what it promises fails its test, and says why.

use std::panic::catch_unwind;

use passivity_standin::{Harness, any, any_where, assert as claim, assume, check, cover, implies};

const FIXTURE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixture");

const HOLDS: Harness = Harness {
    manifest_dir: FIXTURE,
    path: "some_crate::file::th_lin_holds",
    must_fail: false,
    covers: &["x is 3"],
    assertions: &["TH-LIN: x is below 4"],
};

const FAILS: Harness = Harness {
    manifest_dir: FIXTURE,
    path: "some_crate::file::err_27_fails",
    must_fail: true,
    covers: &["x is 3"],
    assertions: &["ERR-27: x is below 3"],
};

/// A number below 4, with the cover that the list has.
fn small() -> u8 {
    let x = any_where(|x: &u8| *x < 4);
    cover!(x == 3, "x is 3");
    x
}

/// What `check` says of a harness, or nothing when it passes.
fn fault(harness: Harness, body: fn()) -> String {
    match catch_unwind(|| check(&harness, body)) {
        Ok(()) => String::new(),
        Err(why) => *why.downcast::<String>().expect("a text"),
    }
}

#[test]
fn what_holds_passes() {
    let said = fault(HOLDS, || claim(small() < 4, "TH-LIN: x is below 4"));
    assert_eq!(said, "");
}

#[test]
fn what_must_fail_and_does_passes() {
    let said = fault(FAILS, || claim(small() < 3, "ERR-27: x is below 3"));
    assert_eq!(said, "");
}

#[test]
fn an_assertion_that_fails_is_reported_with_its_input() {
    let said = fault(HOLDS, || claim(small() < 2, "TH-LIN: x is below 4"));
    assert!(
        said.contains("2 inputs fail \"TH-LIN: x is below 4\""),
        "{said}"
    );
    assert!(said.contains("drawn: 2 "), "{said}");
}

#[test]
fn a_harness_is_left_when_much_has_failed() {
    let said = fault(HOLDS, || {
        let x = any::<u16>();
        claim(x < 4, "TH-LIN: x is below 4");
        cover!(x == 3, "x is 3");
    });
    let found = "100 and more inputs fail \"TH-LIN: x is below 4\"";
    assert!(said.contains(found) && !said.contains("cover"), "{said}");
    // What is to fail is run to its end.
    let said = fault(FAILS, || {
        let x = any::<u16>();
        cover!(x == u16::MAX, "x is 3");
        claim(x < 3, "ERR-27: x is below 3");
    });
    assert_eq!(said, "");
}

#[test]
fn assumptions_that_nothing_meets_are_reported() {
    let vacuous = "no input meets its assumptions";
    let said = fault(HOLDS, || {
        assume(false);
        claim(small() < 4, "TH-LIN: x is below 4");
    });
    assert!(said.contains(vacuous), "{said}");
    let said = fault(HOLDS, || {
        let bound = any_where(|b: &u8| *b == 4);
        let x = any_where(|x: &u8| *x > 4 && *x < bound);
        claim(x < 4, "TH-LIN: x is below 4");
    });
    assert!(said.contains(vacuous), "{said}");
    // Too many inputs to run all of them: the same on samples.
    let said = fault(HOLDS, || {
        let x = any::<i64>();
        assume(x > 0);
        assume(x < 0);
        claim(x < 4, "TH-LIN: x is below 4");
    });
    assert!(said.contains(vacuous), "{said}");
}

#[test]
fn a_cover_that_is_never_hit_is_reported() {
    let said = fault(HOLDS, || {
        let x = small();
        assume(x < 3);
        cover!(x > 3, "x is 3");
        claim(x < 4, "TH-LIN: x is below 4");
    });
    // It was hit above, before the assumption: covers are where they stand, as in Kani.
    assert_eq!(said, "");
    let said = fault(HOLDS, || {
        let x = any_where(|x: &u8| *x < 3);
        cover!(x == 3, "x is 3");
        claim(x < 4, "TH-LIN: x is below 4");
    });
    assert!(
        said.contains("its cover is never hit: \"x is 3\""),
        "{said}"
    );
}

#[test]
fn a_must_fail_that_holds_or_fails_otherwise_is_reported() {
    let said = fault(FAILS, || claim(small() < 4, "ERR-27: x is below 3"));
    assert!(
        said.contains("it must fail with \"ERR-27: x is below 3\" and does not"),
        "{said}"
    );
    let said = fault(FAILS, || claim(small() < 3, "ERR-27: something else"));
    assert!(
        said.contains("1 inputs fail \"ERR-27: something else\""),
        "{said}"
    );
    let said = fault(FAILS, || {
        let x = small();
        let _ = 255 - x * 100;
        claim(x < 3, "ERR-27: x is below 3");
    });
    assert!(said.contains("overflow"), "{said}");
}

#[test]
fn a_panic_is_a_fault() {
    let said = fault(HOLDS, || {
        let x = small();
        assert!(x != 3, "three");
        claim(x < 4, "TH-LIN: x is below 4");
    });
    assert!(said.contains("panic: three"), "{said}");
}

#[test]
fn the_list_and_the_text_must_agree() {
    let body = || claim(small() < 4, "TH-LIN: x is below 4");
    let other = Harness {
        covers: &["x is 2"],
        ..HOLDS
    };
    assert!(fault(other, body).contains("harnesses.toml lists the covers"));
    let must_fail = Harness {
        must_fail: true,
        ..HOLDS
    };
    assert!(fault(must_fail, body).contains("disagree on whether it must fail"));
    let silent = Harness {
        assertions: &[],
        ..HOLDS
    };
    assert!(fault(silent, body).contains("it asserts nothing"));
    let unknown = Harness {
        path: "some_crate::file::th_lin_other",
        ..HOLDS
    };
    assert!(fault(unknown, body).contains("is not in harnesses.toml"));
    let two = Harness {
        assertions: &["ERR-27: x is below 3", "more"],
        ..FAILS
    };
    assert!(fault(two, body).contains("assert nothing else"));
}

#[test]
fn every_input_is_run_when_values_depend_on_each_other() {
    // 4 + 3 + 2 + 1 pairs; a wrong pair would fail, a missing one would miss the cover.
    let said = fault(HOLDS, || {
        let x = any_where(|x: &u8| *x < 4);
        let y = any_where(|y: &u8| *y >= x && *y < 4);
        cover!(x == 0 && y == 3, "x is 3");
        claim(implies!(x == 3 => y == 3), "TH-LIN: x is below 4");
    });
    assert_eq!(said, "");
}
