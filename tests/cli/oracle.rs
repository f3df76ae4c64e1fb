//! `passivity oracle`: the line protocol, through pipes.

use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Command, Stdio};

/// What the interface promises, to the character; the rest of the row is in its order.
const ROW: &str = r#"{"h": 0, "xi0": "1", "xi1": "1/2", "dtau": "1", "generated_linear": "3/8", "generated_quantized": "1/2", "bound_22": "3/8", "bound_quantized": "1/2", "dissipated_lower": "9/20", "net_linear": "3/40", "net_quantized": "-1/20", "margin": "3/10", "criterion_holds": true, "violates_linear": false, "violates_quantized": true}"#;

#[test]
fn each_line_is_answered_before_the_next_is_asked() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_passivity"))
        .arg("oracle")
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut input = child.stdin.take().expect("a pipe");
    let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
    let mut ask = |line: &str| {
        writeln!(input, "{line}").expect("it listens");
        let mut answer = String::new();
        output.read_line(&mut answer).expect("it answers");
        answer
    };
    let interval = r#"{"id": 1, "op": "interval", "xi0": "1", "xi1": "1/2", "beta": "3/5", "sigma": "3/5", "dtau": "1"}"#;
    assert_eq!(ask(interval), format!("{{\"id\": 1, \"result\": {ROW}}}\n"));
    let answer = ask(r#"{"id": "b", "op": "interval", "xi0": "1/0"}"#);
    assert!(
        answer.starts_with(r#"{"id": "b", "error": {"kind": ""#),
        "{answer}"
    );
    let answer = ask("no JSON");
    assert!(
        answer.starts_with(r#"{"id": null, "error": {"kind": "bad_json""#),
        "{answer}"
    );
    let answer = ask(r#"{"id": 4, "op": "run", "xi": [1, "1/2"], "beta": "3/5", "sigma": "3/5"}"#);
    assert!(
        answer.starts_with(&format!("{{\"id\": 4, \"result\": {{\"rows\": [{ROW}], ")),
        "{answer}"
    );
    let answer = ask(
        r#"{"id": 5, "op": "check", "scene": {"dimensionless": {"beta": "3/5", "sigma": "3/5"}}}"#,
    );
    assert!(answer.contains(r#""verdict":"passive""#), "{answer}");
    let answer = ask(r#"{"id": 6, "op": "version"}"#);
    assert!(answer.contains(r#""protocol": 1"#), "{answer}");
    drop(input);
    assert!(child.wait().expect("it ends").success());
}
