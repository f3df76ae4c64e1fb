//! Requests of the line protocol.

use passivity_oracle::protocol::serve;
use serde_json::Value;

/// Every line has one answer, in order, which is JSON and a result or an error.
pub(crate) fn run(data: &[u8]) {
    let mut out = Vec::new();
    serve(data, &mut out).unwrap_or_else(|error| panic!("{error}"));
    let asked: Vec<&[u8]> = data.split_inclusive(|byte| *byte == b'\n').collect();
    let answers: Vec<&[u8]> = out.split_inclusive(|byte| *byte == b'\n').collect();
    assert_eq!(answers.len(), asked.len(), "an answer for each line");
    for (line, answer) in asked.iter().zip(answers) {
        let answer: Value = serde_json::from_slice(answer)
            .unwrap_or_else(|error| panic!("{error} in {}", String::from_utf8_lossy(answer)));
        let (result, error) = (answer.get("result"), answer.get("error"));
        assert!(result.is_some() != error.is_some(), "{answer}");
        if let Some(error) = error {
            assert!(
                error["kind"].is_string() && error["message"].is_string(),
                "{answer}"
            );
        }
        let request = serde_json::from_slice::<Value>(line).unwrap_or(Value::Null);
        assert_eq!(answer["id"], request["id"], "{answer}");
    }
}
