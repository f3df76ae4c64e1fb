//! The parser and the judge on output in Kani's own format.

use passivity_standin::list::{Entry, List};

use crate::judge::wrong;
use crate::report::read;

const TERSE: &str = include_str!("../samples/terse-two-threads.txt");
const REGULAR: &str = include_str!("../samples/regular.txt");
const REAL: &str = include_str!("../samples/kani-0.67.0-5cb3f4e.txt");
const COPIED: &str = include_str!("../samples/copied-cover.txt");

fn entry(name: &str, covers: &[&str], must_fail: Option<&str>) -> Entry {
    Entry {
        name: name.into(),
        claims: vec!["TH-LIN".into()],
        domain: "a domain".into(),
        covers: covers.iter().map(|cover| (*cover).into()).collect(),
        must_fail: must_fail.map(Into::into),
        mutation: None,
    }
}

fn list() -> List {
    List {
        harness: vec![
            entry(
                "generation::th_lin_bound",
                &["the wall is left", "the wall is entered"],
                None,
            ),
            entry(
                "errata::err_22",
                &["half a tick down"],
                Some("ERR-22: E_g is within the printed bound (22)"),
            ),
            entry("generation::th_quant_bound", &["a crossing"], None),
        ],
    }
}

fn faults(list: &List, output: &str) -> Vec<String> {
    wrong(list, &read(output).expect("it is in Kani's format"))
}

#[test]
fn a_report_in_which_all_is_well() {
    assert_eq!(faults(&list(), TERSE), Vec::<String>::new());
    let run = read(TERSE).unwrap();
    assert_eq!(run.kani.as_deref(), Some("0.68.0"));
    let report = &run.harnesses["generation::th_quant_bound"];
    assert_eq!(report.seconds, Some(12.61));
    let report = &run.harnesses["generation::th_lin_bound"];
    assert_eq!(report.covers.counted, (2, 2));
}

#[test]
fn the_versions_are_those_that_the_report_says() {
    let run = read(REGULAR).unwrap();
    assert_eq!(run.cbmc.into_iter().collect::<Vec<_>>(), ["6.11.0"]);
    assert_eq!(
        run.solvers.into_iter().collect::<Vec<_>>(),
        ["CaDiCaL 2.0.0"]
    );
    assert!(read(TERSE).unwrap().cbmc.is_empty());
}

#[test]
fn a_cover_that_is_not_satisfied_another_failure_and_a_time_out() {
    let faults = faults(&list(), REGULAR);
    assert_eq!(
        faults[0],
        "generation::th_lin_bound: no copy of its cover \"the wall is entered\" is satisfied"
    );
    assert!(
        faults[1].contains("attempt to multiply with overflow"),
        "{faults:?}"
    );
    assert!(
        faults[2].contains("`FAILED` and not `SUCCESSFUL`"),
        "{faults:?}"
    );
    assert!(faults[3].contains("0 of 0 covers"), "{faults:?}");
    assert_eq!(faults.len(), 4, "{faults:?}");
}

#[test]
fn a_harness_that_is_missing_and_one_that_is_not_listed() {
    let mut list = list();
    list.harness[0].name = "generation::th_other".into();
    assert_eq!(
        faults(&list, TERSE),
        [
            "generation::th_other: it is not in the report",
            "generation::th_lin_bound: it is not in harnesses.toml"
        ]
    );
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
        .filter(|f| f.ends_with("there is no verdict on it"))
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

/// The harness whose cover the compiler copied, as Kani 0.67.0 reports it when that is optimised.
fn copied() -> List {
    let cover = ["it holds thanks to the bound"];
    List {
        harness: vec![entry(
            "region::th_region_verdict_up_to_a_speed",
            &cover,
            None,
        )],
    }
}

#[test]
fn a_cover_is_satisfied_when_one_of_its_copies_is() {
    assert_eq!(faults(&copied(), COPIED), Vec::<String>::new());
    let none = COPIED.replace("Status: SATISFIED", "Status: UNSATISFIABLE");
    assert_eq!(
        faults(&copied(), &none),
        ["region::th_region_verdict_up_to_a_speed: \
             no copy of its cover \"it holds thanks to the bound\" is satisfied"]
    );
}

#[test]
fn a_cover_that_is_satisfied_does_not_stand_for_another() {
    let mut list = copied();
    list.harness[0].covers.push("it does not hold".into());
    assert_eq!(
        faults(&list, COPIED),
        ["region::th_region_verdict_up_to_a_speed: \
             its cover \"it does not hold\" is not in the report"]
    );
    // Two copies of one cover, both satisfied, are not two covers.
    let both = COPIED
        .replace("UNREACHABLE", "SATISFIED")
        .replace("1 of 2", "2 of 2");
    assert_eq!(faults(&list, &both).len(), 1);
    list.harness[0].covers = vec!["it does not hold".into()];
    assert_eq!(faults(&list, &both).len(), 2);
}

#[test]
fn counts_alone_decide_where_all_copies_are_of_one_cover_or_all_are_satisfied() {
    let counted = |text: &str| {
        let summary = text.find("SUMMARY").unwrap();
        let checks = text.find("RESULTS").unwrap();
        format!("{}{}", &text[..checks], &text[summary..])
    };
    let mut list = copied();
    assert_eq!(faults(&list, &counted(COPIED)), Vec::<String>::new());
    let none = COPIED.replace("1 of 2", "0 of 2");
    assert_eq!(faults(&list, &counted(&none)).len(), 1);
    list.harness[0].covers.push("it does not hold".into());
    let faults = faults(&list, &counted(COPIED));
    assert!(faults[0].contains("nobody knows which"), "{faults:?}");
}

#[test]
fn a_report_of_a_real_run() {
    let run = read(REAL).unwrap();
    assert_eq!(run.kani.as_deref(), Some("0.67.0"));
    assert_eq!(run.harnesses.len(), 85);
    for (name, report) in &run.harnesses {
        let verdict = report.verdict.as_deref().unwrap();
        let must_fail = name.starts_with("errata::");
        assert_eq!(verdict == "SUCCESSFUL", !must_fail, "{name}");
        assert_eq!(report.failed.len(), usize::from(must_fail), "{name}");
        assert!(report.seconds.unwrap() > 0.0, "{name}");
        let (satisfied, copies) = report.covers.counted;
        assert!(satisfied == copies && copies > 0, "{name}");
    }
    let harness = vec![
        entry(
            "generation::th_lin_bound",
            &["the wall is left", "the wall is entered"],
            None,
        ),
        entry(
            "errata::err_27_criterion_against_the_quantized_spring",
            &["the criterion holds and something moves"],
            Some("ERR-27: the criterion makes E_g at most E_d for the paper's own E_g"),
        ),
    ];
    let faults = faults(&List { harness }, REAL);
    let unlisted = |fault: &String| fault.ends_with("it is not in harnesses.toml");
    assert_eq!(faults.len(), 83);
    assert!(faults.iter().all(unlisted), "{faults:?}");
}
