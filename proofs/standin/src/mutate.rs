//! All mutations of a source in one text, each with a switch: one build then runs them all.
//!
//! The body of a function that mutations change becomes `match SWITCH { 1 => { changed } _ => { as it was } }`.
//! It is found by its indentation, as rustfmt leaves it.

use std::collections::BTreeMap;
use std::fmt::Write;
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
/// which one is on, and to which file the functions are written that are asked for theirs: each by
/// the first of its numbers, once.
pub const SWITCH: &str = "\
//! Which mutation is on.
extern crate std;

use std::collections::BTreeSet;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::sync::{LazyLock, Mutex};

pub(crate) fn on(first: u32) -> u32 {
    static ON: LazyLock<u32> = LazyLock::new(|| {
        std::env::var(\"PASSIVITY_MUTATION\").map_or(0, |number| number.parse().unwrap())
    });
    static REACHED: LazyLock<Option<Mutex<(BTreeSet<u32>, File)>>> = LazyLock::new(|| {
        let path = std::env::var_os(\"PASSIVITY_MUTATIONS_REACHED\")?;
        let file = OpenOptions::new().create(true).append(true).open(path).unwrap();
        Some(Mutex::new((BTreeSet::new(), file)))
    });
    if let Some(reached) = &*REACHED {
        let (known, file) = &mut *reached.lock().unwrap();
        if known.insert(first) {
            std::writeln!(file, \"{first}\").unwrap();
        }
    }
    *ON
}
";

/// The variable of the environment that [`SWITCH`] reads.
pub const VARIABLE: &str = "PASSIVITY_MUTATION";

/// The variable that says where [`SWITCH`] writes what is reached.
pub const REACHED: &str = "PASSIVITY_MUTATIONS_REACHED";

/// What stands above a changed body, before its number.
pub const MUTANT: &str = "// mutant ";

/// What stands above a body as it was.
pub const AS_IT_WAS: &str = "// as it was";

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

/// The body of the function in which a change stands, as it has to.
#[must_use]
pub fn body_of(text: &str, place: &Place) -> Option<Range<usize>> {
    body_around(text, place.at).filter(|body| place.at + place.old.len() <= body.end)
}

/// The text with every change in it, none of which is on until its switch is.
///
/// # Errors
///
/// A sentence, when a change does not stand in the body of a function.
pub fn with_places(text: &str, places: &[Place]) -> Result<String, String> {
    let mut bodies: BTreeMap<usize, (usize, Vec<&Place>)> = BTreeMap::new();
    for place in places {
        let body = body_of(text, place)
            .ok_or_else(|| format!("`{}` does not stand in the body of a function", place.old))?;
        // A function in another one is changed with that.
        let around = bodies.range_mut(..=body.start).next_back();
        match around.filter(|(_, (end, _))| body.end <= *end) {
            Some((_, (_, edits))) => edits.push(place),
            None => {
                let mut edits = vec![place];
                let inside: Vec<usize> = bodies.range(body.clone()).map(|(at, _)| *at).collect();
                for start in inside {
                    edits.extend(bodies.remove(&start).into_iter().flat_map(|(_, e)| e));
                }
                bodies.insert(body.start, (body.end, edits));
            }
        }
    }
    let mut out = String::new();
    let mut done = 0;
    for (start, (end, edits)) in bodies {
        let body = &text[start..end];
        out.push_str(&text[done..start]);
        let mut arms = String::new();
        for place in &edits {
            let Place { number, old, .. } = place;
            let (head, tail) = (&text[start..place.at], &text[place.at + old.len()..end]);
            let changed = format!("{head}{}{tail}", place.new);
            let _ = write!(arms, "{MUTANT}{number}\n{number} => {{\n{changed}\n}}\n");
        }
        let first = edits.iter().map(|place| place.number).min().unwrap_or(0);
        let _ = write!(
            out,
            "\nmatch crate::mutation::on({first}) {{\n{arms}{AS_IT_WAS}\n_ => {{\n{body}\n}}\n}}\n"
        );
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
        let mut word = line.trim_start();
        if word.starts_with("pub") {
            word = word.split_once(' ')?.1;
        }
        let word = word.trim_start_matches("const ");
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
            let (_, after) = out.split_once(&format!("\n{number} => {{")).unwrap();
            let (changed, _) = after.split_once("\n//").unwrap();
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
