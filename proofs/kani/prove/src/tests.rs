//! The parser and the judge on output in Kani's own format.

use passivity_standin::list::{Entry, List};

use crate::judge::{judge, unknown};
use crate::report::read;

const TERSE: &str = include_str!("../samples/terse-two-threads.txt");
const REGULAR: &str = include_str!("../samples/regular.txt");

fn entry(name: &str, covers: usize, must_fail: Option<&str>) -> Entry {
    Entry {
        name: name.into(),
        claims: vec!["TH-LIN".into()],
        domain: "a domain".into(),
        covers: vec!["a cover".into(); covers],
        must_fail: must_fail.map(Into::into),
        mutation: None,
    }
}

fn list() -> List {
    List {
        harness: vec![
            entry("generation::th_lin_bound", 2, None),
            entry(
                "errata::err_22",
                1,
                Some("ERR-22: E_g is within the printed bound (22)"),
            ),
            entry("generation::th_quant_bound", 1, None),
        ],
    }
}

fn faults(list: &List, output: &str) -> Vec<String> {
    let reports = read(output).expect("it is in Kani's format");
    judge(list, &reports)
        .into_iter()
        .flat_map(|(_, faults)| faults)
        .collect()
}

#[test]
fn a_report_in_which_all_is_well() {
    assert_eq!(faults(&list(), TERSE), Vec::<String>::new());
    let reports = read(TERSE).unwrap();
    assert_eq!(reports["generation::th_quant_bound"].seconds, Some(12.61));
    assert_eq!(reports["generation::th_lin_bound"].covers, (2, 2));
    assert!(unknown(&list(), &reports).is_empty());
}

#[test]
fn a_cover_that_is_not_satisfied_another_failure_and_a_time_out() {
    let faults = faults(&list(), REGULAR);
    assert_eq!(faults.len(), 4, "{faults:?}");
    assert!(faults[0].starts_with("1 of 2 covers"), "{faults:?}");
    assert!(
        faults[1].contains("attempt to multiply with overflow"),
        "{faults:?}"
    );
    assert!(
        faults[2].contains("`FAILED` and not `SUCCESSFUL`"),
        "{faults:?}"
    );
    assert!(faults[3].starts_with("0 of 0 covers"), "{faults:?}");
}

#[test]
fn a_harness_that_is_missing_and_one_that_is_not_listed() {
    let mut list = list();
    list.harness[0].name = "generation::th_other".into();
    assert_eq!(faults(&list, TERSE), ["it is not in the report"]);
    let reports = read(TERSE).unwrap();
    assert_eq!(unknown(&list, &reports), ["generation::th_lin_bound"]);
}

#[test]
fn a_must_fail_that_holds_or_fails_for_another_reason() {
    let holds = TERSE
        .replace(
            "Failed Checks: ERR-22: E_g is within the printed bound (22)\n",
            "",
        )
        .replace(
            "SUCCESSFUL (encountered one or more panics as expected)",
            "FAILED (encountered no panics, but at least one was expected)",
        );
    assert_eq!(faults(&list(), &holds).len(), 2);
    let other = TERSE.replace("ERR-22: E_g is", "ERR-27: E_g is");
    assert_eq!(faults(&list(), &other).len(), 1);
    // A harness that should hold and "panics as expected" has the wrong attribute.
    let mut list = list();
    list.harness[1].must_fail = None;
    assert_eq!(faults(&list, TERSE).len(), 2);
}

#[test]
fn a_run_that_stopped_in_the_middle() {
    let (head, _) = TERSE.split_once("Thread 0: \n").unwrap();
    let faults = faults(&list(), head);
    let without_verdict = faults
        .iter()
        .filter(|f| *f == "there is no verdict on it")
        .count();
    assert_eq!(without_verdict, 2, "{faults:?}");
}

#[test]
fn colours_do_not_matter_and_two_verdicts_do() {
    let coloured = TERSE.replace("SUCCESSFUL\n", "\u{1b}[32mSUCCESSFUL\u{1b}[0m\n");
    assert_eq!(faults(&list(), &coloured), Vec::<String>::new());
    let twice = TERSE.replace("Verification Time: 8.57s", "VERIFICATION:- FAILED");
    assert!(read(&twice).is_err());
}
