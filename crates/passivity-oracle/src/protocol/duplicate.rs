//! Keys that are given twice in one object of a request, which makes the request ambiguous.

use serde_json::Value;

/// A key that was there before in the same object, and the byte, from 1, at which it stands again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Duplicate {
    pub(super) key: String,
    pub(super) at: usize,
}

/// The first duplicate key of a JSON text, from which `value` was read.
///
/// Most texts have none: they have as many colons outside of strings as the value has entries.
pub(super) fn find(text: &[u8], value: &Value) -> Option<Duplicate> {
    if colons(text) == entries(value) {
        return None;
    }
    let mut open: Vec<Vec<String>> = Vec::new();
    let mut at = 0;
    while let Some(byte) = text.get(at) {
        let mut next = at + 1;
        match byte {
            b'{' => open.push(Vec::new()),
            b'}' => drop(open.pop()),
            b'"' => {
                next = end_of_string(text, at);
                let rest = text.get(next..).unwrap_or_default().trim_ascii_start();
                let literal = text.get(at..next).unwrap_or_default();
                let key = serde_json::from_slice::<String>(literal);
                if let (Some(keys), Ok(key), true) = (open.last_mut(), key, rest.starts_with(b":"))
                {
                    if keys.contains(&key) {
                        return Some(Duplicate { key, at: at + 1 });
                    }
                    keys.push(key);
                }
            }
            _ => {}
        }
        at = next;
    }
    // A key that the reader of JSON keeps for itself stands for something else than an entry.
    Some(Duplicate {
        key: "$serde_json::private::Number".to_owned(),
        at: 1,
    })
}

/// The byte after the string that starts at `at`.
fn end_of_string(text: &[u8], at: usize) -> usize {
    let mut escaped = false;
    for (i, byte) in text.iter().enumerate().skip(at + 1) {
        match byte {
            _ if escaped => escaped = false,
            b'\\' => escaped = true,
            b'"' => return i + 1,
            _ => {}
        }
    }
    text.len()
}

fn colons(text: &[u8]) -> usize {
    let (mut count, mut inside, mut escaped) = (0, false, false);
    for byte in text {
        match byte {
            _ if escaped => escaped = false,
            b'\\' if inside => escaped = true,
            b'"' => inside = !inside,
            b':' if !inside => count += 1,
            _ => {}
        }
    }
    count
}

fn entries(value: &Value) -> usize {
    match value {
        Value::Object(fields) => fields.len() + fields.values().map(entries).sum::<usize>(),
        Value::Array(items) => items.iter().map(entries).sum(),
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_compared_within_one_object() {
        for (text, found) in [
            (
                r#"{"a": 1, "b": {"a": ":", "c": [{"a": 2}, {"a": "\":"}]}}"#,
                None,
            ),
            (r#"{"a": 1, "b": 2, "a": 1}"#, Some(("a", 18))),
            (r#"{"b": {"a\\": 1, "a\\" : 2}}"#, Some(("a\\", 18))),
            (r#"{"a": [{"x": 1, "\u0078": 1}]}"#, Some(("x", 17))),
        ] {
            let value: Value = serde_json::from_str(text).unwrap();
            let expected = found.map(|(key, at)| Duplicate {
                key: key.to_owned(),
                at,
            });
            assert_eq!(find(text.as_bytes(), &value), expected, "{text}");
        }
    }
}
