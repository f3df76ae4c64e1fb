//! What is swapped for what, and where in a text.

use passivity_standin::mutate::Place;

use crate::changes::{Change, has_switch};

/// Words and what comes in their place: comparisons, ends of intervals, arithmetic.
///
/// Where the changed text does not compile, the change is none.
const SWAPS: [(&str, &str); 48] = [
    (" < ", " <= "),
    (" <= ", " < "),
    (" > ", " >= "),
    (" >= ", " > "),
    (" == ", " != "),
    (" != ", " == "),
    (" && ", " || "),
    (" || ", " && "),
    (" &= ", " |= "),
    (" |= ", " &= "),
    (" + ", " - "),
    (" - ", " + "),
    (" * ", " + "),
    (" / ", " * "),
    (".half()", ""),
    (".double()", ""),
    (".square()", ".clone()"),
    (".abs()", ".clone()"),
    (".max(", ".min("),
    (".min(", ".max("),
    (".over(", ".max("),
    (".hi()", ".lo()"),
    (".lo()", ".hi()"),
    (".is_ge()", ".is_gt()"),
    (".is_le()", ".is_lt()"),
    (".is_gt()", ".is_ge()"),
    (".is_lt()", ".is_le()"),
    (".is_nonnegative()", ".is_positive()"),
    (".is_positive()", ".is_nonnegative()"),
    (".hardest()", ".easiest()"),
    (".easiest()", ".hardest()"),
    ("End::Hardest", "End::Easiest"),
    ("End::Easiest", "End::Hardest"),
    ("Hurts::Less", "Hurts::More"),
    ("Hurts::More", "Hurts::Less"),
    ("Ordering::Less", "Ordering::Greater"),
    ("Ordering::Greater", "Ordering::Less"),
    ("Truth::Holds", "Truth::Fails"),
    ("Truth::Fails", "Truth::Holds"),
    ("Truth::Depends", "Truth::Fails"),
    ("Side::AtLeast", "Side::AtMost"),
    ("Side::AtMost", "Side::AtLeast"),
    ("Rounding::Up", "Rounding::Down"),
    ("Rounding::Down", "Rounding::Up"),
    ("true", "false"),
    ("false", "true"),
    (".all(", ".any("),
    (".any(", ".all("),
];

/// Every swap in a file, outside of comments, attributes and tests. They have no numbers yet.
pub(crate) fn changes(file: &str, text: &str) -> Vec<Change> {
    let mut found = Vec::new();
    let (mut start, mut function) = (0, "");
    for (line, written) in text.split_inclusive('\n').enumerate() {
        let trimmed = written.trim_start();
        if trimmed.starts_with("#[cfg(test)]") {
            break;
        }
        if let Some((_, rest)) = written.split_once("fn ") {
            function = rest.split(['(', '<']).next().unwrap_or_default();
        }
        let code = written.split("//").next().unwrap_or_default();
        let is_code = !trimmed.starts_with("#[") && !trimmed.starts_with("use ");
        for (old, new) in SWAPS.iter().filter(|_| is_code) {
            for (at, _) in code.match_indices(old) {
                let word = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
                let before = code.get(..at).and_then(|text| text.chars().next_back());
                let after = code
                    .get(at + old.len()..)
                    .and_then(|text| text.chars().next());
                let inside = |c: char| c.is_alphabetic();
                if old.starts_with(inside) && word(before) || old.ends_with(inside) && word(after) {
                    continue;
                }
                let (old_word, new_word) = (old.trim(), new.trim());
                let place = Place {
                    number: 0,
                    at: start + at,
                    old,
                    new,
                };
                if !has_switch(text, &place) {
                    continue;
                }
                found.push(Change {
                    number: 0,
                    file: file.to_owned(),
                    at: place.at,
                    old: (*old).to_owned(),
                    new: (*new).to_owned(),
                    name: format!(
                        "{file}:{}:{}: replace {old_word} with {new_word} in {function}",
                        line + 1,
                        at + 1
                    ),
                });
            }
        }
        start += written.len();
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_swapped_is_found_with_its_place() {
        let text = "//! a < b\nfn of(x: S) -> bool {\n    is_true(x.half()) && x.lo() <= x // a + b\n}\n\
                    #[cfg(test)]\nfn test() { 1 + 1 }\n";
        let found = changes("f.rs", text);
        let names: Vec<&str> = found.iter().map(|change| change.name.as_str()).collect();
        assert_eq!(
            names,
            [
                "f.rs:3:32: replace <= with < in of",
                "f.rs:3:22: replace && with || in of",
                "f.rs:3:14: replace .half() with  in of",
                "f.rs:3:27: replace .lo() with .hi() in of",
            ]
        );
        for change in &found {
            assert!(text[change.at..].starts_with(&change.old));
        }
    }
}
