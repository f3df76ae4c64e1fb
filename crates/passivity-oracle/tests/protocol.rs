//! The line protocol: the answers of the interface to the character, and an answer to every line.

use passivity_oracle::protocol::{MAX_LINE, answer, serve};
use proptest::prelude::*;
use serde_json::Value;

fn ask(line: &str) -> String {
    let mut out = Vec::new();
    answer(line.as_bytes(), &mut out);
    String::from_utf8(out).unwrap()
}

fn result(line: &str) -> Value {
    let answer: Value = serde_json::from_str(&ask(line)).unwrap();
    assert!(answer.get("error").is_none(), "{answer}");
    answer["result"].clone()
}

fn error(line: &str) -> (String, Value) {
    let answer: Value = serde_json::from_str(&ask(line)).unwrap();
    assert!(answer.get("result").is_none(), "{answer}");
    let error = &answer["error"];
    assert!(error["message"].as_str().is_some_and(|m| !m.is_empty()));
    (
        error["kind"].as_str().unwrap().to_owned(),
        error["at"].clone(),
    )
}

#[test]
fn example_of_the_interface_to_the_character() {
    let line = r#"{"id": 1, "op": "interval", "xi0": "1", "xi1": "1/2", "beta": "3/5", "sigma": "3/5", "dtau": "1"}"#;
    let expected = r#"{"id": 1, "result": {"h": 0, "xi0": "1", "xi1": "1/2", "dtau": "1", "generated_linear": "3/8", "generated_quantized": "1/2", "bound_22": "3/8", "bound_quantized": "1/2", "dissipated_lower": "9/20", "net_linear": "3/40", "net_quantized": "-1/20", "margin": "3/10", "criterion_holds": true, "violates_linear": false, "violates_quantized": true}}"#;
    assert_eq!(ask(line), expected);
}

#[test]
fn numbers_are_read_as_what_they_spell() {
    let spelled = [
        "\"0.1\"",
        "\"1/10\"",
        "0.1",
        "\"1e-1\"",
        "1e-1",
        "\"+10e-2\"",
    ];
    for x in spelled {
        let line = format!(r#"{{"op":"interval","xi0":{x},"xi1":1,"beta":1,"sigma":1}}"#);
        assert_eq!(result(&line)["xi0"], "1/10", "{x}");
    }
}

#[test]
fn whole_numbers_are_read_like_other_numbers() {
    let row = |delay: &str, h: &str| {
        let known = r#""xi0":0,"xi1":1,"beta":3,"sigma":1"#;
        result(&format!(
            r#"{{"op":"interval",{known},"delay":{delay},"h":{h}}}"#
        ))
    };
    let expected = row("2", "18446744073709551615");
    assert_eq!(expected["h"], u64::MAX);
    for two in ["\"2\"", "2.0", "\"4/2\"", "0.2e1"] {
        assert_eq!(row(two, "\"18446744073709551615\""), expected, "{two}");
    }
}

#[test]
fn an_interval_of_an_answer_is_read() {
    let known = r#""op":"interval","xi0":0,"xi1":1,"sigma":1"#;
    let row = result(&format!(
        r#"{{{known},"beta":{{"lo":"1","hi":"2","approx":1.5}}}}"#
    ));
    assert_eq!(row["dissipated_lower"]["hi"], "3");
}

#[test]
fn messages_of_long_requests_are_short() {
    let long = "x".repeat(1 << 20);
    for line in [
        format!(r#"{{"op":"{long}"}}"#),
        format!(r#"{{"op":"version","{long}":1}}"#),
        format!(r#"{{"op":"version","{long}":1,"{long}":1}}"#),
    ] {
        let answer = ask(&line);
        assert!(answer.len() < 300, "{} bytes", answer.len());
    }
}

#[test]
fn nothing_moved() {
    let row = result(r#"{"op":"interval","xi0":"7/2","xi1":3.5,"beta":0,"sigma":0}"#);
    assert_eq!(row["margin"], Value::Null);
    assert_eq!(row["criterion_holds"], true);
    assert_eq!(row["violates_linear"], false);
}

#[test]
fn counts_answer_in_three_values() {
    let row = result(r#"{"op":"interval","count0":4,"count1":4,"beta":"1/4","sigma":"3/5"}"#);
    // σ > ½: at ever smaller speeds (σ − ½)/v̄ is past every bound.
    assert_eq!(row["margin"]["hi"], Value::Null);
    assert_eq!(row["margin"]["lo"], "-3/20");
    assert_eq!(row["criterion_holds"], Value::Null);
    assert_eq!(row["xi0"]["lo"], "4");
}

#[test]
fn run_gives_rows_and_totals() {
    let run =
        result(r#"{"op":"run","xi":[0,"1","1/2"],"beta":"3/5","sigma":"3/5","dtau":["1","1/2"]}"#);
    assert_eq!(run["rows"].as_array().unwrap().len(), 2);
    assert_eq!(run["rows"][1]["h"], 1);
    assert_eq!(run["rows"][1]["dtau"], "1/2");
    // 3/5·¼/½ + 3/5·½ = 3/5.
    assert_eq!(run["totals"]["dissipated_lower"], "9/5");
    assert_eq!(run["totals"]["generated_linear"], "3/8");
    let counts = result(r#"{"op":"run","counts":[0,1,3,3],"beta":"3/5","sigma":"3/5"}"#);
    // Σ ½D² ± ½|D| over all intervals but the last, which has D = 0 and E in [−1/8, 1/8].
    assert_eq!(counts["totals"]["generated_linear"]["lo"], "7/8");
    assert_eq!(counts["totals"]["generated_linear"]["hi"], "33/8");
}

#[test]
fn th_lti_the_margin_takes_what_a_delay_with_damping_costs() {
    let row = |rest: &str| {
        let known = r#""xi0":0,"xi1":1,"beta":"3/2","sigma":1"#;
        result(&format!(r#"{{"op":"interval",{known},{rest}}}"#))
    };
    let fraction = row(r#""delay":1,"damping":"1/2""#);
    assert_eq!(fraction["margin"], "1/4");
    assert_eq!(fraction["criterion_holds"], true);
    // Behind a one-sided wall it is the sum of what either costs (TH-LAW).
    let one_sided = row(r#""delay":1,"damping":"1/2","unilateral":true"#);
    assert_eq!(one_sided["margin"], "-1/2");
    // Where it is no fraction the margin is enclosed, and nothing else.
    let enclosed = row(r#""delay":3,"damping":"14/9""#);
    let scene = r#"{"dimensionless":{"beta":"3/2","sigma":1},"sampling":{"delay":3},"wall":{"damping":"14/9"}}"#;
    let spare = result(&format!(r#"{{"op":"check","scene":{scene}}}"#))["spare"].clone();
    let at = |value: &Value| value["approx"].as_f64().unwrap();
    let expected = at(&spare["viscous"]) + at(&spare["coulomb"]);
    assert!(
        (at(&enclosed["margin"]) - expected).abs() < 1e-14,
        "{enclosed}"
    );
    assert_ne!(enclosed["margin"]["lo"], enclosed["margin"]["hi"]);
    assert_eq!(enclosed["criterion_holds"], false);
    assert_eq!(enclosed["dissipated_lower"], "5/2");
    assert!(enclosed["net_linear"].is_string(), "{enclosed}");
}

#[test]
fn check_is_that_of_the_scene() {
    let report = result(r#"{"op":"check","scene":{"dimensionless":{"beta":"3/5","sigma":"2/5"}}}"#);
    assert_eq!(report["verdict"], "not_passive");
    assert_eq!(report["witness"]["gain_per_cycle"], "1/120");
    let (_, at) = error(r#"{"op":"check","scene":{"dimensionless":{"beta":"x","sigma":1}}}"#);
    assert_eq!(at, "scene.dimensionless.beta");
    let joints = result(
        r#"{"op":"check","scene":{"joint":[{"viscous":"1 N s/m","coulomb":"1 N","encoder":{"resolution":"1 mm"}}],
            "sampling":{"period":"1 ms"},"wall":{"stiffness":"1 N/mm","direction":["1"]}}}"#
            .replace('\n', "")
            .as_str(),
    );
    assert_eq!(joints["viscous_definite"], true);
    assert_eq!(joints["joints"][0]["coulomb_needed"]["lo"], "1/2");
}

#[test]
fn what_is_not_json_is_told_what_a_request_is() {
    for (line, says) in [
        ("not json", "expected an object such as {\\\"id\\\": 1,"),
        ("", "expected an object such as"),
        ("{\"op\": no}", "expected `true`, `false` or `null`"),
    ] {
        let answer = ask(line);
        let says = format!("this is not JSON: {says}");
        assert!(answer.contains(&says), "{line}: {answer}");
    }
}

#[test]
fn every_mistake_has_a_kind_and_a_place() {
    let interval = |rest: &str| format!(r#"{{"id":9,"op":"interval",{rest}}}"#);
    for (line, kind, at) in [
        ("nonsense".to_owned(), "bad_json", Value::from(2)),
        // A library may be asked with line breaks.
        (
            "{\n\n \"op\": x}".to_owned(),
            "bad_json",
            Value::from(11),
        ),
        (String::new(), "bad_json", Value::from(1)),
        ("[1]".to_owned(), "bad_request", Value::Null),
        ("{}".to_owned(), "missing_field", Value::from("op")),
        (
            r#"{"op":"fly"}"#.to_owned(),
            "unknown_op",
            Value::from("op"),
        ),
        (
            r#"{"op":"version","x":1}"#.to_owned(),
            "unknown_field",
            Value::from("x"),
        ),
        (
            interval(r#""xi0":1,"beta":1,"sigma":1"#),
            "missing_field",
            Value::from("xi1"),
        ),
        (
            interval(r#""xi0":1,"xi1":2,"sigma":1"#),
            "missing_field",
            Value::from("beta"),
        ),
        (
            interval(r#""xi0":1,"xi1":2,"beta":-1,"sigma":1"#),
            "out_of_range",
            Value::from("beta"),
        ),
        (
            interval(r#""xi0":1,"xi1":2,"beta":1,"sigma":1,"dtau":0"#),
            "out_of_range",
            Value::from("dtau"),
        ),
        (
            interval(r#""count0":1,"count1":0,"beta":1,"sigma":1,"encoder":false"#),
            "bad_value",
            Value::from("encoder"),
        ),
        (
            r#"{"op":"run","counts":[1,0],"beta":1,"sigma":1,"encoder":false}"#.to_owned(),
            "bad_value",
            Value::from("encoder"),
        ),
        (
            interval(r#""xi0":1,"count0":1,"xi1":2,"count1":2,"beta":1,"sigma":1"#),
            "bad_value",
            Value::from("count0"),
        ),
        (
            interval(r#""xi0":1,"count1":2,"beta":1,"sigma":1"#),
            "bad_value",
            Value::from("count1"),
        ),
        (
            r#"{"op":"run","xi":[0,1],"positions":[0,5],"beta":1,"sigma":1}"#.to_owned(),
            "bad_value",
            Value::from("positions"),
        ),
        (
            r#"{"op":"run","count":[0,1],"counts":[0,1],"beta":1,"sigma":1}"#.to_owned(),
            "bad_value",
            Value::from("counts"),
        ),
        (
            interval(r#""xi0":1,"xi1":2,"beta":{"lo":1,"hi":2,"foo":3},"sigma":1"#),
            "unknown_field",
            Value::from("beta.foo"),
        ),
        (
            r#"{"op":"motion","mu":1,"beta":0,"sigma":{"lo":0,"hi":1},"xi":0,"velocity":1,"force":0,"tau":1}"#
                .to_owned(),
            "bad_value",
            Value::from("sigma"),
        ),
        (
            interval(r#""xi0":"1/0","xi1":2,"beta":1,"sigma":1"#),
            "zero_denominator",
            Value::from("xi0"),
        ),
        (
            interval(r#""xi0":"NaN","xi1":2,"beta":1,"sigma":1"#),
            "not_finite",
            Value::from("xi0"),
        ),
        (
            interval(r#""xi0":1e999999999,"xi1":2,"beta":1,"sigma":1"#),
            "exponent_too_large",
            Value::from("xi0"),
        ),
        (
            interval(&format!(
                r#""xi0":"{}","xi1":2,"beta":1,"sigma":1"#,
                "7".repeat(2000)
            )),
            "number_too_long",
            Value::from("xi0"),
        ),
        (
            interval(r#""xi0":0,"xi1":2,"beta":{"lo":"1e-2000","hi":1},"sigma":1"#),
            "number_too_long",
            Value::from("beta"),
        ),
        (
            interval(r#""count0":1,"count1":2.5,"beta":1,"sigma":1"#),
            "bad_value",
            Value::from("count1"),
        ),
        (
            r#"{"op":"run","xi":[1],"beta":1,"sigma":1}"#.to_owned(),
            "bad_value",
            Value::from("xi"),
        ),
        (
            r#"{"op":"run","xi":[1,"q"],"beta":1,"sigma":1}"#.to_owned(),
            "malformed_number",
            Value::from("xi[1]"),
        ),
        (
            r#"{"op":"run","xi":[1,2],"dtau":[1,2],"beta":1,"sigma":1}"#.to_owned(),
            "bad_value",
            Value::from("dtau"),
        ),
    ] {
        assert_eq!(error(&line), (kind.to_owned(), at), "{line}");
    }
    assert!(ask(&interval("\"xi0\":1")).starts_with(r#"{"id": 9, "error": "#));
    assert!(ask(&"[".repeat(100_000)).contains("bad_json"));
}

#[test]
fn a_line_past_the_bound_is_refused_and_the_next_served() {
    let mut input = vec![b'x'; MAX_LINE + 10];
    input.extend_from_slice(b"\n{\"id\": 2, \"op\": \"version\"}\r\n{\"id\": 3");
    let mut out = Vec::new();
    serve(std::io::BufReader::new(&input[..]), &mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 3);
    assert!(lines[0].contains("line_too_long"));
    assert!(lines[1].contains("\"protocol\": 1"));
    assert!(lines[2].contains("bad_json")); // torn
}

#[test]
fn answers_do_not_wait_for_further_requests() {
    // A reader that blocks after one request: its answer must be out by then.
    struct Once<'a>(&'a std::cell::RefCell<Vec<u8>>, bool);
    impl std::io::Read for Once<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            if std::mem::replace(&mut self.1, true) {
                assert!(
                    self.0.borrow().ends_with(b"}\n"),
                    "no answer before the next read"
                );
                return Ok(0);
            }
            let request = b"{\"id\": 1, \"op\": \"version\"}\n{\"id\"";
            buffer[..request.len()].copy_from_slice(request);
            Ok(request.len())
        }
    }
    struct Out<'a>(&'a std::cell::RefCell<Vec<u8>>);
    impl std::io::Write for Out<'_> {
        fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
            self.0.borrow_mut().extend_from_slice(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    let out = std::cell::RefCell::new(Vec::new());
    serve(std::io::BufReader::new(Once(&out, false)), Out(&out)).unwrap();
}

proptest! {
    #[test]
    fn no_line_stops_the_service(line in prop::collection::vec(any::<u8>(), 0..200)) {
        let mut out = Vec::new();
        answer(&line, &mut out);
        let text = String::from_utf8(out).unwrap();
        prop_assert!(serde_json::from_str::<Value>(&text).is_ok(), "{}", text);
    }

    #[test]
    fn no_field_stops_the_service(value in "[\"0-9eE+/.\\-NaInf\\[\\]{}:,]{0,40}", field in 0..5_usize) {
        let field = ["xi0", "beta", "dtau", "h", "delay"][field];
        let line = format!(r#"{{"op":"interval","xi1":1,"sigma":1,"{field}":{value}}}"#);
        prop_assert!(serde_json::from_str::<Value>(&ask(&line)).is_ok());
    }
}

#[test]
fn a_key_that_is_given_twice_is_an_error() {
    for (line, id) in [
        (r#"{"id": 1, "op": "version", "op": "version"}"#, "1"),
        (r#"{"id": 2, "id": 2, "op": "version"}"#, "2"),
        (
            r#"{"id": 3, "op": "interval", "xi0": 1, "xi1": 1, "beta": 1, "sigma": 1, "beta": 9}"#,
            "3",
        ),
        // The same key in other letters of the text.
        (r#"{"id": 4, "op": "version", "\u006fp": "version"}"#, "4"),
        (
            r#"{"id": 5, "op": "check", "scene": {"dimensionless": {"beta": "1", "sigma": "1", "beta": "0"}}}"#,
            "5",
        ),
    ] {
        let answer = ask(line);
        assert!(
            answer.contains(r#""kind": "duplicate_key""#),
            "{line}: {answer}"
        );
        assert!(answer.starts_with(&format!(r#"{{"id": {id}"#)), "{answer}");
    }
}

/// The reader of JSON takes an object with this key for a number.
#[test]
fn a_reserved_key_is_called_so() {
    let answer: Value = serde_json::from_str(&ask(
        r#"{"id": {"$serde_json::private::Number": "7"}, "op": "version"}"#,
    ))
    .unwrap();
    assert_eq!(answer["id"], Value::Null, "{answer}");
    assert_eq!(answer["error"]["kind"], "bad_request", "{answer}");
    assert_eq!(answer["error"]["at"], 9, "{answer}");
    let message = answer["error"]["message"].as_str().unwrap();
    assert!(
        message.contains("cannot be used") && !message.contains("twice"),
        "{message}"
    );
}
