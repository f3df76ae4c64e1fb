//! Messages in JSON.

use std::borrow::Cow;

use crate::json::has_key_twice;
use crate::log::mcap::value::{MOST_ELEMENTS, Scalar, Value, are_time, nanoseconds};

/// Decodes a message in JSON.
pub(crate) fn decode(message: &[u8]) -> Result<Value<'static>, &'static str> {
    let json = serde_json::from_slice(message).map_err(|_| "it is not JSON")?;
    match has_key_twice(message, &json) {
        true => Err("it has a field twice"),
        false => Ok(value(json)),
    }
}

fn value(json: serde_json::Value) -> Value<'static> {
    match json {
        serde_json::Value::Number(number) => Value::Number(Scalar::Spelt(number.to_string())),
        serde_json::Value::Bool(yes) => Value::Truth(yes),
        serde_json::Value::String(text) => Value::Text(Cow::Owned(text)),
        serde_json::Value::Null => Value::Nothing,
        serde_json::Value::Array(list) => {
            Value::List(list.into_iter().take(MOST_ELEMENTS).map(value).collect())
        }
        serde_json::Value::Object(fields) => match time(&fields) {
            Some(time) => Value::Nanoseconds(time),
            None => {
                let field = |(name, json)| (Cow::Owned(name), value(json));
                Value::Struct(fields.into_iter().map(field).collect())
            }
        },
    }
}

/// The time that two fields are, in either order.
fn time(fields: &serde_json::Map<String, serde_json::Value>) -> Option<i128> {
    let mut two: Vec<_> = fields.iter().take(3).collect();
    two.sort_unstable_by_key(|(name, _)| !name.starts_with("sec"));
    let [(first, seconds), (second, rest)] = two.as_slice() else {
        return None;
    };
    let whole = |json: &serde_json::Value| json.as_number()?.as_i128();
    match are_time(first, second) {
        true => nanoseconds(whole(seconds)?, whole(rest)?),
        false => None,
    }
}
