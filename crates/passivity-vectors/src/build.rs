//! Makes a test from a request and the library's own answer.

use passivity_core::BigRational;
use passivity_oracle::protocol;
use serde_json::{Map, Value, json};

use crate::Test;

/// A fraction as a request writes it.
pub(super) fn ratio(n: i64, d: i64) -> String {
    BigRational::new(n.into(), d.into()).to_string()
}

/// A test of a request that must be answered.
///
/// # Panics
///
/// When the library itself refuses the request: a mistake in a group.
pub(super) fn test(comment: impl Into<String>, flags: &[&'static str], request: Value) -> Test {
    let answer = ask(&request);
    let result = answer.get("result").cloned();
    let refusal = answer["error"]["kind"].as_str().map(str::to_owned);
    Test {
        id: 0,
        comment: comment.into(),
        flags: flags.to_vec(),
        result: result.map(|result| expected(&request, result)),
        refusal,
        request,
        formula: None,
    }
}

fn ask(request: &Value) -> Value {
    let mut answer = Vec::new();
    protocol::answer(request.to_string().as_bytes(), &mut answer);
    serde_json::from_slice(&answer).expect("an answer of the protocol is JSON")
}

/// What of an answer is expected of every implementation.
fn expected(request: &Value, mut result: Value) -> Value {
    /// The figures of a verdict that are defined by the claims alone.
    const VERDICT: [&str; 13] = [
        "region",
        "verdict",
        "beta",
        "sigma",
        "critical_speed",
        "spare",
        "speed_bound",
        "margin_at_speed_bound",
        "colgate",
        "abbott_okamura",
        "unforced",
        "not_covered",
        "witness",
    ];
    if request["op"] == "check"
        && let Value::Object(fields) = &mut result
    {
        fields.retain(|name, _| VERDICT.contains(&name.as_str()));
        // V is a root, so how tightly it is enclosed is each implementation's own.
        if let Some(Value::Object(unforced)) = fields.get_mut("unforced") {
            unforced.retain(|name, _| name == "holds");
        }
        if let Some(Value::Object(witness)) = fields.get_mut("witness") {
            witness.retain(|name, _| ["positions", "wave", "gain_per_cycle"].contains(&&**name));
        }
    }
    without_approximations(&mut result);
    result
}

/// An interval is its two ends: the double between them is for people.
fn without_approximations(value: &mut Value) {
    match value {
        Value::Object(fields) => {
            fields.retain(|name, _| name != "approx");
            fields.values_mut().for_each(without_approximations);
        }
        Value::Array(items) => items.iter_mut().for_each(without_approximations),
        _ => {}
    }
}

/// An `interval` request.
pub(super) fn interval(xi0: &str, xi1: &str, beta: &str, sigma: &str, dtau: &str) -> Value {
    json!({"op": "interval", "xi0": xi0, "xi1": xi1, "beta": beta, "sigma": sigma, "dtau": dtau})
}

/// An `interval` request about counts.
pub(super) fn counts(from: i64, to: i64, beta: &str, sigma: &str, dtau: &str) -> Value {
    json!({
        "op": "interval", "count0": from, "count1": to,
        "beta": beta, "sigma": sigma, "dtau": dtau,
    })
}

/// A `check` request about a dimensionless scene, with further sections.
pub(super) fn check(beta: &str, sigma: &str, sections: &Value) -> Value {
    let mut scene = Map::new();
    scene.insert(
        "dimensionless".to_owned(),
        json!({"mu": "50", "beta": beta, "sigma": sigma}),
    );
    if let Value::Object(sections) = sections {
        scene.extend(sections.clone());
    }
    json!({"op": "check", "scene": scene})
}

/// A fixed sequence of numbers that look random: the same on every machine (PCG-XSH-RR 64/32).
pub(super) struct Dice(u64);

impl Dice {
    pub(super) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u32 {
        let state = self.0;
        self.0 = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        // The generator is defined by the lower 32 bits of the one, turned by the upper 5 of the other.
        let mixed = (((state >> 18) ^ state) >> 27) as u32;
        mixed.rotate_right((state >> 59) as u32)
    }

    /// A whole number from `least` to `most`.
    pub(super) fn between(&mut self, least: i64, most: i64) -> i64 {
        let span = most - least + 1;
        least + i64::from(self.next()).rem_euclid(span)
    }

    /// A fraction in that range, with a denominator of at most `denominator`.
    pub(super) fn fraction(&mut self, least: i64, most: i64, denominator: i64) -> String {
        let d = self.between(1, denominator);
        ratio(self.between(least * d, most * d), d)
    }

    pub(super) fn pick<T: Clone>(&mut self, items: &[T]) -> T {
        items[self.next() as usize % items.len()].clone()
    }
}
