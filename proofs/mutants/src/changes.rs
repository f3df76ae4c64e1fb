//! Every change that is tried: those of cargo-mutants, and the swaps that it does not know.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use passivity_standin::mutate::{Place, body_of};
use serde::Deserialize;

use crate::operators;

/// A change of a file.
#[derive(Clone, Debug)]
pub(crate) struct Change {
    /// Its switch.
    pub(crate) number: u32,
    /// The file, from the root of the workspace.
    pub(crate) file: String,
    /// Where in its text.
    pub(crate) at: usize,
    /// What stands there.
    pub(crate) old: String,
    /// What comes in its place.
    pub(crate) new: String,
    /// Line and column, what is changed, and in which function.
    pub(crate) name: String,
}

impl Change {
    pub(crate) fn place(&self) -> Place<'_> {
        Place {
            number: self.number,
            at: self.at,
            old: &self.old,
            new: &self.new,
        }
    }

    /// Its name without line and column, which change with every edit above it.
    pub(crate) fn lasting_name(&self) -> String {
        let what = self.name.splitn(4, ':').nth(3).unwrap_or_default();
        format!("{}:{what}", self.file)
    }
}

/// A change as `cargo mutants --list --json` says it.
#[derive(Deserialize)]
struct Listed {
    file: String,
    name: String,
    genre: String,
    replacement: String,
    function: Option<Function>,
    span: Span,
}

#[derive(Deserialize)]
struct Function {
    return_type: String,
}

#[derive(Deserialize)]
struct Span {
    start: Point,
    end: Point,
}

/// Both from 1 on; columns count characters.
#[derive(Deserialize)]
struct Point {
    line: usize,
    column: usize,
}

/// The list of files, which cargo-mutants reads too.
#[derive(Deserialize)]
struct Configuration {
    examine_globs: Vec<String>,
}

/// Every change that can have a switch, and the names of those that cannot.
pub(crate) fn all(root: &Path) -> Result<(Vec<Change>, Vec<String>), String> {
    let mut listed: BTreeMap<String, Vec<Listed>> = BTreeMap::new();
    for change in list(root)? {
        listed.entry(change.file.clone()).or_default().push(change);
    }
    let path = root.join(".cargo/mutants.toml");
    let text = fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    let files: Configuration =
        toml::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
    let (mut changes, mut left_out) = (Vec::new(), Vec::new());
    for file in files.examine_globs {
        let text = fs::read_to_string(root.join(&file)).map_err(|e| format!("{file}: {e}"))?;
        let mut found = Vec::new();
        for change in listed.remove(&file).unwrap_or_default() {
            match woven(&text, &change) {
                Some(change) => found.push(change),
                None => left_out.push(format!("{} ({})", change.name, change.genre)),
            }
        }
        let known: BTreeSet<(usize, String)> = found
            .iter()
            .map(|change| (change.at, change.new.clone()))
            .collect();
        let swaps = operators::changes(&file, &text).into_iter();
        found.extend(swaps.filter(|swap| {
            let spaces = swap.old.len() - swap.old.trim_start().len();
            !known.contains(&(swap.at + spaces, swap.new.trim().to_owned()))
        }));
        found.sort_by_key(|change| change.at);
        changes.extend(found);
    }
    if let Some(file) = listed.keys().next() {
        return Err(format!("{file} is not on the list by its name"));
    }
    for (number, change) in (1..).zip(&mut changes) {
        change.number = number;
    }
    tell_apart(&mut changes);
    Ok((changes, left_out))
}

fn list(root: &Path) -> Result<Vec<Listed>, String> {
    let output = Command::new("cargo")
        .args(["mutants", "--list", "--json"])
        .current_dir(root)
        .output()
        .map_err(|e| format!("cargo mutants: {e}"))?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr);
        return Err(format!("cargo mutants --list: {said}"));
    }
    serde_json::from_slice(&output.stdout).map_err(|e| format!("cargo mutants --list: {e}"))
}

/// A listed change with its place, unless it cannot have a switch: what stands outside of functions
/// or in a constructor of constants is computed while compiling, and the branches of a function
/// that returns `impl` of something have different types.
fn woven(text: &str, listed: &Listed) -> Option<Change> {
    let function = listed.function.as_ref()?;
    let (start, end) = (
        offset(text, &listed.span.start)?,
        offset(text, &listed.span.end)?,
    );
    let change = Change {
        number: 0,
        file: listed.file.clone(),
        at: start,
        old: text.get(start..end)?.to_owned(),
        new: listed.replacement.clone(),
        name: listed.name.clone(),
    };
    (!function.return_type.contains("impl ") && has_switch(text, &change.place())).then_some(change)
}

/// Whether a change stands in a body that is not that of a constructor of constants.
pub(crate) fn has_switch(text: &str, place: &Place) -> bool {
    let Some(body) = body_of(text, place) else {
        return false;
    };
    let signature = text[..body.start].rfind("fn ").unwrap_or_default();
    let line = text[..signature]
        .rfind('\n')
        .map_or(0, |newline| newline + 1);
    !text[line..].trim_start().starts_with("pub const fn new(")
        && !text[line..].trim_start().starts_with("const fn new(")
        && !text[signature..body.start].contains("-> impl ")
}

fn offset(text: &str, point: &Point) -> Option<usize> {
    let line = text.split_inclusive('\n').nth(point.line - 1)?;
    let start = line.as_ptr() as usize - text.as_ptr() as usize;
    let mut places = line.char_indices().map(|(at, _)| at).chain([line.len()]);
    Some(start + places.nth(point.column - 1)?)
}

/// Numbers changes of the same name in a function, so that a reason speaks of one of them.
fn tell_apart(changes: &mut [Change]) {
    let mut names: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (i, change) in changes.iter().enumerate() {
        names.entry(change.lasting_name()).or_default().push(i);
    }
    for same in names.values().filter(|same| same.len() > 1) {
        for (which, &i) in (1..).zip(same) {
            let of = same.len();
            changes[i].name.push_str(&format!(" ({which} of {of})"));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_listed_change_is_found_by_its_characters() {
        let text = "fn of(x: S) -> bool {\n    \"½\" < x\n}\n\nfn all() -> impl Iterator {\n    0..1 - 1\n}\n";
        let listed = |line, column, returns: &str| Listed {
            file: "f.rs".to_owned(),
            name: format!("f.rs:{line}:{column}: replace"),
            genre: "BinaryOperator".to_owned(),
            replacement: "==".to_owned(),
            function: Some(Function {
                return_type: returns.to_owned(),
            }),
            span: Span {
                start: Point { line, column },
                end: Point {
                    line,
                    column: column + 1,
                },
            },
        };
        let change = woven(text, &listed(2, 9, "-> bool")).unwrap();
        assert_eq!((change.old.as_str(), &text[change.at..][..1]), ("<", "<"));
        assert!(woven(text, &listed(6, 10, "-> impl Iterator")).is_none());
    }

    #[test]
    fn changes_of_one_name_are_numbered() {
        let change = |line: u32| Change {
            number: line,
            file: "f.rs".to_owned(),
            at: 0,
            old: String::new(),
            new: String::new(),
            name: format!("f.rs:{line}:1: replace + with - in of"),
        };
        let mut changes = [change(1), change(2)];
        tell_apart(&mut changes);
        assert_eq!(changes[1].name, "f.rs:2:1: replace + with - in of (2 of 2)");
        assert_eq!(
            changes[0].lasting_name(),
            "f.rs: replace + with - in of (1 of 2)"
        );
    }
}
