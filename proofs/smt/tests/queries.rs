//! The committed queries are those of the code, and the models of the errata refute them.

use passivity_core::BigRational;
use passivity_smt::{Answer, Query, Script, claims, replay, run};

#[test]
fn committed_queries_are_those_of_the_code() {
    let mut committed = std::collections::BTreeMap::new();
    for entry in std::fs::read_dir(run::folder()).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        committed.insert(name, std::fs::read_to_string(&path).unwrap());
    }
    let expected = run::texts();
    for (name, text) in &expected {
        assert_eq!(
            committed.get(name),
            Some(text),
            "{name} is not what the code says: passivity-smt write"
        );
    }
    let stray: Vec<_> = committed
        .keys()
        .filter(|name| !expected.contains_key(*name))
        .collect();
    assert!(stray.is_empty(), "no query has these files: {stray:?}");
}

#[test]
fn every_question_has_its_twin_and_its_mutant() {
    let queries = claims::all();
    let mut names: Vec<_> = queries.iter().map(Query::name).collect();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), queries.len(), "two queries have one name");
    for query in &queries {
        let answers: Vec<_> = query
            .scripts()
            .iter()
            .map(|script| script.expected)
            .collect();
        let expected: &[Answer] = if query.refuted {
            &[Answer::Sat, Answer::Unsat]
        } else {
            &[Answer::Unsat, Answer::Sat, Answer::Sat]
        };
        assert_eq!(answers, expected, "{}", query.name());
    }
}

/// The paper's own numbers first, then what z3 5.4.0 and cvc5 1.4.2 answered.
const MODELS: [(&str, &[(&str, &str)]); 10] = [
    ("err_21_22_as_printed", &[("x0", "1"), ("x1", "(/ 1 2)")]),
    (
        "err_21_22_as_printed",
        &[("x0", "(/ 17 16)"), ("x1", "(/ 9 16)")],
    ),
    ("err_21_22_as_printed", &[("x0", "1"), ("x1", "(/ 1 8)")]),
    (
        "err_27_as_printed",
        &[
            ("x0", "1"),
            ("x1", "(/ 1 2)"),
            ("beta", "0.6"),
            ("sigma", "0.6"),
            ("dtau", "1"),
        ],
    ),
    (
        "err_27_as_printed",
        &[
            ("x0", "(/ 17 16)"),
            ("x1", "(/ 1 2)"),
            ("beta", "(/ 75 64)"),
            ("sigma", "0"),
            ("dtau", "(/ 3 4)"),
        ],
    ),
    (
        "err_27_as_printed",
        &[
            ("x0", "(/ 33 32)"),
            ("x1", "(/ 17 32)"),
            ("beta", "1"),
            ("sigma", "(/ 3 8)"),
            ("dtau", "1"),
        ],
    ),
    (
        "err_19_start_as_printed",
        &[("sample", "0.5"), ("x0", "1.1"), ("x1", "1.5")],
    ),
    (
        "err_19_start_as_printed",
        &[("sample", "(/ 7 8)"), ("x0", "(/ 3 2)"), ("x1", "(/ 7 4)")],
    ),
    (
        "err_19_start_as_printed",
        &[
            ("sample", "(/ 3 14)"),
            ("x0", "(/ 8 7)"),
            ("x1", "(/ 17 14)"),
        ],
    ),
    ("err_iv_c_as_printed", &[("x", "1")]),
];

/// The erratum's question as printed, which the solvers find a model of.
fn refuted(name: &str) -> Script {
    let queries = claims::all();
    let query = queries.iter().find(|query| query.name() == name).unwrap();
    let mut scripts = query.scripts().into_iter();
    scripts
        .find(|script| script.expected == Answer::Sat)
        .unwrap()
}

fn model(values: &[(&str, &str)]) -> Vec<(String, BigRational)> {
    let number = |text: &str| replay::number(text).unwrap();
    values
        .iter()
        .map(|(name, value)| ((*name).to_owned(), number(value)))
        .collect()
}

#[test]
fn models_of_the_errata_refute_them_on_the_kernel() {
    let refuted_claims = claims::all().iter().filter(|query| query.refuted).count();
    assert_eq!(refuted_claims, 4);
    for (name, values) in MODELS {
        assert_eq!(
            replay::confirms(&refuted(name), &model(values)),
            Ok(()),
            "{name}"
        );
    }
}

#[test]
fn a_number_that_refutes_nothing_is_found_out() {
    let nothing = model(&[("x0", "1.0"), ("x1", "(- 1.0)")]);
    assert!(replay::confirms(&refuted("err_21_22_as_printed"), &nothing).is_err());
    let premise_broken = model(&[
        ("x0", "1"),
        ("x1", "0.5"),
        ("beta", "(- 1)"),
        ("sigma", "0.6"),
        ("dtau", "1"),
    ]);
    assert!(replay::confirms(&refuted("err_27_as_printed"), &premise_broken).is_err());
}

#[test]
fn numbers_that_solvers_print() {
    let half = replay::number("0.5").unwrap();
    for text in [
        "(/ 1 2)",
        "(/ 1.0 2.0)",
        "(- (/ (- 1) 2))",
        "0.50",
        "(/ 2 4)",
    ] {
        assert_eq!(replay::number(text), Ok(half.clone()), "{text}");
    }
    for text in [
        "",
        "x",
        "(/ 1 0)",
        "(+ 1 2)",
        "(root-obj (+ (^ x 2) (- 2)) 2)",
        "1 2",
        "(- 1",
        "1.2.3",
    ] {
        assert!(replay::number(text).is_err(), "{text}");
    }
}
