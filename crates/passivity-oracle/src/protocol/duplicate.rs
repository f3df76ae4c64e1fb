//! Keys that are given twice in one object of a request, which makes the request ambiguous.

use std::collections::HashSet;
use std::hash::Hash;

use passivity_audit::json::has_key_twice;
use serde_json::Value;

/// A key that the reader of JSON keeps for itself: an object with it alone is read as a number.
pub(super) const RESERVED: &str = "$serde_json::private::Number";

/// A key that was there before in the same object, and the byte, from 1, at which it stands again.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Duplicate {
    pub(super) key: String,
    pub(super) at: usize,
}

/// The first duplicate key of a JSON text, from which `value` was read.
pub(super) fn find(text: &[u8], value: &Value) -> Option<Duplicate> {
    if !has_key_twice(text, value) {
        return None;
    }
    let of_literal = |literal: &[u8]| serde_json::from_slice::<String>(literal).ok();
    if let Some((key, at)) = first_again(text, of_literal) {
        return Some(Duplicate { key, at });
    }
    let mut places = text.windows(RESERVED.len());
    let place = places.position(|bytes| bytes == RESERVED.as_bytes());
    // Its characters may be escaped.
    let at = place.unwrap_or(0).max(1);
    let key = RESERVED.to_owned();
    Some(Duplicate { key, at })
}

/// The first key that was there before in the same object, and its byte, with each key read by `read`.
fn first_again<K: Eq + Hash>(text: &[u8], read: impl Fn(&[u8]) -> Option<K>) -> Option<(K, usize)> {
    let mut open: Vec<HashSet<K>> = Vec::new();
    let mut at = 0;
    while let Some(byte) = text.get(at) {
        let mut next = at + 1;
        match byte {
            b'{' => open.push(HashSet::new()),
            b'}' => drop(open.pop()),
            b'"' => {
                next = end_of_string(text, at);
                let rest = text.get(next..).unwrap_or_default().trim_ascii_start();
                let literal = text.get(at..next).unwrap_or_default();
                if let (Some(keys), true) = (open.last_mut(), rest.starts_with(b":"))
                    && let Some(key) = read(literal)
                {
                    if keys.contains(&key) {
                        return Some((key, at + 1));
                    }
                    keys.insert(key);
                }
            }
            _ => {}
        }
        at = next;
    }
    None
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

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::hash::Hasher;

    use super::*;

    /// A key that counts how often it is compared.
    struct Counted<'a>(Vec<u8>, &'a Cell<usize>);

    impl PartialEq for Counted<'_> {
        fn eq(&self, other: &Self) -> bool {
            self.1.set(self.1.get() + 1);
            self.0 == other.0
        }
    }

    impl Eq for Counted<'_> {}

    impl Hash for Counted<'_> {
        fn hash<H: Hasher>(&self, state: &mut H) {
            self.0.hash(state);
        }
    }

    #[test]
    fn many_keys_are_each_compared_with_few() {
        const KEYS: usize = 2000;
        let entries = (0..KEYS).map(|i| format!("\"{i}\":1,"));
        let text = format!("{{{}\"0\":1}}", entries.collect::<String>());
        let compared = Cell::new(0);
        let read = |literal: &[u8]| Some(Counted(literal.to_vec(), &compared));
        let found = first_again(text.as_bytes(), read);
        assert_eq!(found.map(|(_, at)| at), Some(text.len() - 5));
        assert!(compared.get() < KEYS, "{} comparisons", compared.get());
    }

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
