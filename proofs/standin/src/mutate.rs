//! All mutations of a source in one text, each with a switch: one build then runs them all.
//!
//! The body of a function that mutations change becomes `if SWITCH { changed } else { as it was }`.
//! It is found by its indentation, as rustfmt leaves it.

use std::collections::BTreeMap;
use std::ops::Range;

/// A change of a text: the number of its switch, what stands there, and what comes in its place.
pub type Edit<'a> = (u32, &'a str, &'a str);

/// A change at a place of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place<'a> {
    /// The number of its switch.
    pub number: u32,
    /// Where in the text it begins.
    pub at: usize,
    /// What stands there.
    pub old: &'a str,
    /// What comes in its place.
    pub new: &'a str,
}

/// The text of a module `mutation` for the crate whose sources have switches. The environment says
/// which one is on.
pub const SWITCH: &str = "\
//! Which mutation is on.
extern crate std;

pub(crate) fn is(number: u32) -> bool {
    static ON: std::sync::LazyLock<Option<u32>> =
        std::sync::LazyLock::new(|| std::env::var(\"PASSIVITY_MUTATION\").ok()?.parse().ok());
    *ON == Some(number)
}
";

/// The variable of the environment that [`SWITCH`] reads.
pub const VARIABLE: &str = "PASSIVITY_MUTATION";

/// The text with every edit in it, none of which is on until its switch is.
///
/// # Errors
///
/// A sentence, when what an edit replaces is not there exactly once, or not in the body of a
/// function whose closing brace stands below its beginning.
pub fn with_switches(text: &str, edits: &[Edit]) -> Result<String, String> {
    let mut places = Vec::new();
    for &(number, old, new) in edits {
        let mut found = text.match_indices(old);
        let (Some((at, _)), None) = (found.next(), found.next()) else {
            return Err(format!("`{old}` is not there exactly once"));
        };
        places.push(Place {
            number,
            at,
            old,
            new,
        });
    }
    with_places(text, &places)
}

/// Whether a change stands in the body of a function, as it has to.
#[must_use]
pub fn is_in_a_body(text: &str, place: &Place) -> bool {
    body_of(text, place).is_some()
}

fn body_of(text: &str, place: &Place) -> Option<Range<usize>> {
    body_around(text, place.at).filter(|body| place.at + place.old.len() <= body.end)
}

/// The text with every change in it, none of which is on until its switch is.
///
/// # Errors
///
/// A sentence, when a change does not stand in the body of a function.
pub fn with_places(text: &str, places: &[Place]) -> Result<String, String> {
    let mut bodies: BTreeMap<(usize, usize), Vec<&Place>> = BTreeMap::new();
    for place in places {
        let body = body_of(text, place)
            .ok_or_else(|| format!("`{}` does not stand in the body of a function", place.old))?;
        bodies
            .entry((body.start, body.end))
            .or_default()
            .push(place);
    }
    let mut out = String::new();
    let mut done = 0;
    for ((start, end), edits) in bodies {
        let before = text
            .get(done..start)
            .ok_or("a function with a mutation stands in another with a mutation")?;
        let body = &text[start..end];
        out.push_str(before);
        out.push('\n');
        for Place {
            number,
            at,
            old,
            new,
        } in edits
        {
            let (head, tail) = (&text[start..*at], &text[at + old.len()..end]);
            let changed = format!("{head}{new}{tail}");
            out.push_str(&format!(
                "if crate::mutation::is({number}) {{\n{changed}\n}} else "
            ));
        }
        out.push_str(&format!("{{\n{body}\n}}\n"));
        done = end;
    }
    out.push_str(&text[done..]);
    Ok(out)
}

/// What stands between the braces of the innermost function around a place.
fn body_around(text: &str, at: usize) -> Option<Range<usize>> {
    let indent = |line: &str| line.len() - line.trim_start().len();
    let first = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    let here = indent(text[first..].lines().next()?);
    let mut begins = first;
    // Upwards to a function that stands further left.
    let opening = loop {
        begins = text[..begins.checked_sub(1)?]
            .rfind('\n')
            .map_or(0, |newline| newline + 1);
        let line = text[begins..].lines().next()?;
        let word = line
            .trim_start()
            .trim_start_matches("pub(crate) ")
            .trim_start_matches("pub ")
            .trim_start_matches("const ");
        if word.starts_with("fn ") && indent(line) < here {
            break line;
        }
        if begins == 0 {
            return None;
        }
    };
    // Its signature may take several lines; the brace ends the last of them.
    let start = begins + text[begins..].find("{\n")? + 1;
    let close = format!("\n{}}}\n", &opening[..indent(opening)]);
    let end = start + text[start..].find(&close)? + 1;
    (start..end).contains(&at).then_some(start..end)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
struct S;

impl S {
    fn one(&self) -> i32 {
        1 + 2
    }

    pub fn two(
        &self,
        x: i32,
    ) -> i32
    where
        Self: Sized,
    {
        if x > 0 {
            return x - 1;
        }
        x + 1
    }
}
";

    #[test]
    fn each_change_has_its_switch_and_the_rest_stays() {
        let edits = [
            (1, "1 + 2", "1 - 2"),
            (2, "x - 1", "x"),
            (3, "x > 0", "x < 0"),
        ];
        let out = with_switches(TEXT, &edits).unwrap();
        for (number, _, new) in edits {
            let (_, after) = out
                .split_once(&format!("crate::mutation::is({number})"))
                .unwrap();
            let (changed, _) = after.split_once("} else").unwrap();
            assert!(changed.contains(new), "{out}");
        }
        // As it was: once where there is one change, in every branch but one where there are two.
        assert_eq!(out.matches("1 + 2").count(), 1);
        assert_eq!(out.matches("return x - 1;").count(), 2);
        assert_eq!(out.matches("fn ").count(), 2);
        assert_eq!(with_switches(TEXT, &[]).unwrap(), TEXT);
    }

    #[test]
    fn what_is_not_in_a_body_or_not_there_once_is_an_error() {
        let outside = with_switches(TEXT, &[(1, "struct S;", "")]);
        assert!(outside.unwrap_err().contains("the body of a function"));
        let signature = with_switches(TEXT, &[(1, "x: i32", "x: i64")]);
        assert!(signature.unwrap_err().contains("the body of a function"));
        assert!(with_switches(TEXT, &[(1, "y", "z")]).is_err());
        assert!(with_switches(TEXT, &[(1, "i32", "i64")]).is_err());
    }
}
