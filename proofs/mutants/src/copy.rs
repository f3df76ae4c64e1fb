//! The copy of the crates with every change in it, built.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_standin::copy::{copy, workspace};
use passivity_standin::mutate::{Place, SWITCH, with_places};

use crate::operators::Change;
use crate::{SUBJECTS, Subject};

/// Where it is, from the root of the workspace.
const FOLDER: &str = "target/mutants-copy";

/// Makes the copy, leaves out the changes with which it does not compile, and builds the tests.
pub(crate) fn built(
    root: &Path,
    changes: &mut Vec<Change>,
) -> Result<Vec<(&'static Subject, PathBuf)>, String> {
    let to = root.join(FOLDER);
    loop {
        let texts = written(root, &to, changes)?;
        let said = cargo(&to, &["check", "--message-format", "short"], &SUBJECTS[1])?;
        let refused: Vec<u32> = said
            .lines()
            .filter_map(|line| at_fault(line, &texts))
            .collect();
        if refused.is_empty() {
            if said.contains(": error") {
                return Err(format!("the copy does not compile:\n{said}"));
            }
            break;
        }
        println!("{} changes do not compile", refused.len());
        changes.retain(|change| !refused.contains(&change.number));
    }
    let mut programs = Vec::new();
    for subject in &SUBJECTS {
        let mut arguments = vec!["test", "--no-run"];
        arguments.extend(subject.tests);
        let said = cargo(&to, &arguments, subject)?;
        let lines = said
            .lines()
            .filter_map(|l| l.trim().strip_prefix("Executable "));
        let before = programs.len();
        for line in lines {
            let path = line.rsplit('(').next().unwrap_or_default();
            programs.push((subject, to.join(path.trim_end_matches(')'))));
        }
        if programs.len() == before {
            return Err(format!("the tests of the copy do not compile:\n{said}"));
        }
    }
    Ok(programs)
}

/// Writes the copy; gives the texts of the changed files.
fn written(root: &Path, to: &Path, changes: &[Change]) -> Result<BTreeMap<String, String>, String> {
    let mut places: BTreeMap<&str, Vec<Place>> = BTreeMap::new();
    for change in changes {
        places
            .entry(&change.file)
            .or_default()
            .push(change.place.clone());
    }
    let mut texts = BTreeMap::new();
    for subject in &SUBJECTS {
        let sources = root.join(subject.folder).join("src");
        let mut fault = None;
        copy(
            &root.join(subject.folder),
            &to.join(subject.folder),
            &mut |path, text| {
                let Ok(within) = path.strip_prefix(&sources) else {
                    return text;
                };
                let name = format!("{}/src/{}", subject.folder, within.display());
                let mut text = match places.get(name.as_str()) {
                    Some(places) => with_places(&text, places).unwrap_or_else(|why| {
                        fault = Some(format!("{name}: {why}"));
                        text.clone()
                    }),
                    None => text,
                };
                if within == Path::new("lib.rs") {
                    text.push_str("\nmod mutation;\n");
                }
                // A switch cannot be looked at while compiling; constants need their constructors there.
                let changed = places.contains_key(name.as_str());
                let lines = text.split_inclusive('\n').map(|line| {
                    if changed && !line.contains("fn new(") {
                        line.replace("const fn ", "fn ")
                    } else {
                        line.to_owned()
                    }
                });
                let text: String = lines.collect();
                texts.insert(name, text.clone());
                text
            },
        );
        if let Some(fault) = fault {
            return Err(fault);
        }
        let switch = to.join(subject.folder).join("src/mutation.rs");
        fs::write(&switch, SWITCH).map_err(|e| format!("{}: {e}", switch.display()))?;
    }
    // What tests read beside their crate.
    for folder in ["scenes", "docs"] {
        copy(&root.join(folder), &to.join(folder), &mut |_, text| text);
    }
    workspace(root, to, &SUBJECTS.map(|subject| subject.folder));
    Ok(texts)
}

fn cargo(copy_of: &Path, arguments: &[&str], subject: &Subject) -> Result<String, String> {
    let output = Command::new("cargo")
        .args(arguments)
        .args(["--offline", "-p", subject.package])
        .current_dir(copy_of)
        .env("CARGO_TARGET_DIR", "target")
        .output()
        .map_err(|e| format!("cargo: {e}"))?;
    Ok(String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The change in whose text an error stands: `crates/x/src/y.rs:12:3: error[E0308]: …`.
fn at_fault(line: &str, texts: &BTreeMap<String, String>) -> Option<u32> {
    let mut parts = line.splitn(4, ':');
    let (file, row) = (parts.next()?, parts.next()?.parse::<usize>().ok()?);
    if !parts.nth(1)?.trim_start().starts_with("error") {
        return None;
    }
    let before: Vec<&str> = texts.get(file)?.lines().take(row).collect();
    let switch = before
        .iter()
        .rev()
        .find_map(|line| line.split_once("mutation::is("))?;
    switch.1.split(')').next()?.parse().ok()
}
