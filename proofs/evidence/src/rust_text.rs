//! The text of a Rust file, as far as it names other files: its words, the paths in it, its `impl` blocks.

use std::collections::BTreeSet;

/// `impl Type { … }`, `impl Trait for Type { … }`.
pub(crate) struct Implementation {
    pub(crate) of: Option<String>,
    pub(crate) name: String,
    pub(crate) functions: BTreeSet<String>,
}

/// The words and signs of a text, `::` in one, without comments and texts in quotes.
pub(crate) fn tokens(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in text.lines() {
        let code = line.split("//").next().unwrap_or_default();
        for (index, unquoted) in code.split('"').enumerate() {
            if index % 2 == 1 {
                continue;
            }
            let mut rest = unquoted;
            while let Some(first) = rest.chars().next() {
                let word = |c: char| c.is_alphanumeric() || c == '_';
                let length = if word(first) {
                    rest.find(|c| !word(c)).unwrap_or(rest.len())
                } else if rest.starts_with("::") {
                    2
                } else {
                    first.len_utf8()
                };
                let (token, after) = rest.split_at(length);
                if !first.is_whitespace() {
                    found.push(token.to_owned());
                }
                rest = after;
            }
        }
    }
    found
}

/// The paths that `use` names, and whether it is a `pub use`.
pub(crate) fn uses(tokens: &[String]) -> Vec<(Vec<String>, bool)> {
    let mut found = Vec::new();
    let starts = tokens.iter().enumerate().filter(|(_, word)| *word == "use");
    for (start, _) in starts {
        let public = start > 0 && tokens.get(start - 1).is_some_and(|word| word == "pub");
        // What each open brace stands behind.
        let mut open: Vec<Vec<String>> = Vec::new();
        let mut path: Vec<String> = Vec::new();
        for word in tokens.iter().skip(start + 1) {
            match word.as_str() {
                "{" => open.push(path.clone()),
                "," | "}" | ";" => {
                    if path.len() > open.last().map_or(0, Vec::len) {
                        found.push((path.clone(), public));
                    }
                    if word == "}" {
                        open.pop();
                    }
                    path = open.last().cloned().unwrap_or_default();
                }
                "::" | "*" | "as" => {}
                name => path.push(name.to_owned()),
            }
            if word == ";" {
                break;
            }
        }
    }
    found
}

/// The paths that stand in the code, outside of `use`.
pub(crate) fn spelled(tokens: &[String]) -> Vec<Vec<String>> {
    let at = |index: usize| tokens.get(index).map_or("", String::as_str);
    let mut found = Vec::new();
    let mut in_use = false;
    for (index, word) in tokens.iter().enumerate() {
        in_use = word == "use" || in_use && word != ";";
        if in_use || at(index + 1) != "::" || index > 0 && at(index - 1) == "::" {
            continue;
        }
        let mut path = vec![word.clone()];
        let mut next = index + 1;
        while at(next) == "::" && !at(next + 1).starts_with(['<', '{', '*']) {
            path.push(at(next + 1).to_owned());
            next += 2;
        }
        found.push(path);
    }
    found
}

/// The `impl` blocks, with the names of their functions.
pub(crate) fn implementations(tokens: &[String]) -> Vec<Implementation> {
    let mut found = Vec::new();
    for (start, _) in tokens
        .iter()
        .enumerate()
        .filter(|(_, word)| *word == "impl")
    {
        // Up to the brace, what stands outside of `<…>`: names of a trait and of a type.
        let (mut depth, mut names, mut of) = (0_i32, Vec::new(), None);
        let mut rest = tokens.iter().enumerate().skip(start + 1);
        let begin = rest.find_map(|(index, word)| {
            match word.as_str() {
                "<" => depth += 1,
                ">" => depth -= 1,
                "for" if depth == 0 => of = names.last().cloned(),
                "where" if depth == 0 => depth = i32::MIN / 2,
                "{" => return Some(index),
                // `-> impl Trait`, an argument: no block.
                ";" | ")" | "=" if depth == 0 => return Some(usize::MAX),
                name if depth == 0 => names.push(name.to_owned()),
                _ => {}
            }
            None
        });
        let (Some(begin), Some(name)) = (begin, names.last()) else {
            continue;
        };
        let (mut open, mut functions) = (0, BTreeSet::new());
        for (index, word) in tokens.iter().enumerate().skip(begin) {
            match word.as_str() {
                "{" => open += 1,
                "}" => open -= 1,
                "fn" => functions.extend(tokens.get(index + 1).cloned()),
                _ => {}
            }
            if open == 0 {
                break;
            }
        }
        found.push(Implementation {
            of,
            name: name.clone(),
            functions,
        });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_of_every_form_are_read() {
        let text =
            "use a::{b::{C, d as e}, f}; // use g::h;\nlet x = \"crate::k\"; crate::i::j(1);";
        let found = tokens(text);
        let join = |paths: Vec<Vec<String>>| paths.iter().map(|p| p.join("::")).collect::<Vec<_>>();
        let used = uses(&found).into_iter().map(|(path, _)| path).collect();
        assert_eq!(join(used), ["a::b::C", "a::b::d::e", "a::f"]);
        assert!(join(spelled(&found)).contains(&"crate::i::j".to_owned()));
        let blocks = implementations(&tokens(
            "impl<S: Ordered> Loop<Interval<S>> { fn at(&self) {} }\n\
             impl Add<&A> for B where C: D<E> { fn add() { if x { } } fn more() {} }",
        ));
        let of = |i: usize| (blocks[i].of.as_deref(), blocks[i].name.as_str());
        assert_eq!((of(0), of(1)), ((None, "Loop"), (Some("Add"), "B")));
        assert_eq!(blocks[1].functions.len(), 2);
    }
}
