//! The copy of the crates with every change in it, built.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_standin::copy::{copy, workspace, write};
use passivity_standin::mutate::{AS_IT_WAS, MUTANT, Place, SWITCH, with_places};

use crate::SUBJECTS;
use crate::changes::Change;

/// Where it is, from the root of the workspace.
const FOLDER: &str = "target/mutants-copy";

/// A copy with its programs.
pub(crate) struct Built {
    /// Changes with which it does not compile.
    pub(crate) unviable: Vec<Change>,
    /// The tests, each with the number of its crate.
    pub(crate) programs: Vec<(usize, PathBuf)>,
    /// The number by which the function of each change asks for its switch.
    pub(crate) functions: BTreeMap<u32, u32>,
}

/// Makes the copy, leaves out the changes with which it does not compile, and builds the tests.
pub(crate) fn built(root: &Path, changes: &mut Vec<Change>) -> Result<Built, String> {
    let to = root.join(FOLDER);
    let mut unviable = Vec::new();
    let texts = loop {
        let texts = written(root, &to, changes)?;
        let said = cargo(&to, &["check", "--keep-going", "--message-format", "short"])?;
        let refused: Vec<u32> = said
            .lines()
            .filter_map(|line| at_fault(line, &texts))
            .collect();
        if refused.is_empty() {
            if said.contains(": error") {
                return Err(format!("the copy does not compile:\n{said}"));
            }
            break texts;
        }
        let (refused, rest): (Vec<Change>, Vec<Change>) = std::mem::take(changes)
            .into_iter()
            .partition(|change| refused.contains(&change.number));
        println!("{} changes do not compile", refused.len());
        unviable.extend(refused);
        *changes = rest;
    };
    let mut programs = Vec::new();
    for (number, subject) in SUBJECTS.iter().enumerate() {
        let mut arguments = vec!["test", "--no-run", "-p", subject.tests_of];
        arguments.extend(subject.tests);
        let said = cargo(&to, &arguments)?;
        let lines = said.lines();
        let lines = lines.filter_map(|line| line.trim().strip_prefix("Executable "));
        let before = programs.len();
        for line in lines {
            let program = line.rsplit('(').next().unwrap_or_default();
            let program = to.join(program.trim_end_matches(')'));
            programs.push((number, program));
        }
        if programs.len() < before + subject.tests.len() {
            return Err(format!("the tests of the copy do not compile:\n{said}"));
        }
    }
    Ok(Built {
        unviable,
        programs,
        functions: functions(&texts),
    })
}

/// By which number the function of each change asks for its switch.
fn functions(texts: &BTreeMap<String, String>) -> BTreeMap<u32, u32> {
    let mut functions = BTreeMap::new();
    for text in texts.values() {
        let mut function = None;
        for line in text.lines() {
            let number = |text: &str| text.split(')').next()?.parse::<u32>().ok();
            if let Some((_, rest)) = line.split_once("match crate::mutation::on(") {
                function = number(rest);
            }
            let change = line.strip_prefix(MUTANT).and_then(number);
            functions.extend(change.zip(function));
        }
    }
    functions
}

/// Writes the copy; gives the texts of the changed files.
fn written(root: &Path, to: &Path, changes: &[Change]) -> Result<BTreeMap<String, String>, String> {
    let mut places: BTreeMap<&str, Vec<Place>> = BTreeMap::new();
    for change in changes {
        places.entry(&change.file).or_default().push(change.place());
    }
    let mut texts = BTreeMap::new();
    for folder in SUBJECTS.map(|subject| subject.folder) {
        let sources = root.join(folder).join("src");
        let mut fault = None;
        copy(
            &root.join(folder),
            &to.join(folder),
            &["mutation.rs"],
            &mut |path, mut text| {
                let Ok(within) = path.strip_prefix(&sources) else {
                    return text;
                };
                let name = format!("{folder}/src/{}", within.display());
                let places = places.get(name.as_str());
                if let Some(places) = places {
                    match with_places(&text, places) {
                        Ok(changed) => text = changed,
                        Err(why) => fault = Some(format!("{name}: {why}")),
                    }
                }
                if within == Path::new("lib.rs") {
                    text.push_str("\nmod mutation;\n");
                }
                text = computed_later(&text, places.is_some());
                texts.insert(name, text.clone());
                text
            },
        );
        if let Some(fault) = fault {
            return Err(fault);
        }
        let switch = to.join(folder).join("src/mutation.rs");
        write(&switch, SWITCH.as_bytes());
    }
    // What tests read beside their crate.
    for folder in ["scenes", "docs"] {
        copy(&root.join(folder), &to.join(folder), &[], &mut |_, text| {
            text
        });
    }
    let mut members = SUBJECTS.map(|subject| subject.folder).to_vec();
    members.extend(SUBJECTS.iter().filter_map(|subject| subject.tests_in));
    workspace(root, to, &members);
    Ok(texts)
}

/// A switch cannot be looked at while compiling. Constants need their constructors there, and those
/// of files without a change any function that does not look at something.
fn computed_later(text: &str, changed: bool) -> String {
    let lines = text.split_inclusive('\n').map(|line| {
        let looks = line.contains("&self") || line.contains(": &Interval");
        if line.contains("fn new(") || !changed && !looks {
            line.to_owned()
        } else {
            line.replace("const fn ", "fn ")
        }
    });
    lines.collect()
}

/// Runs cargo in the copy. Whether a test fails is asked, not where: nothing is kept for debuggers.
fn cargo(copy_of: &Path, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new("cargo")
        .args(arguments)
        .arg("--offline")
        .args(["--config", "profile.dev.debug=false"])
        .args(["--config", "profile.dev.package.passivity-core.opt-level=0"])
        .args([
            "--config",
            "profile.dev.package.passivity-scene.opt-level=0",
        ])
        .current_dir(copy_of)
        .env("CARGO_TARGET_DIR", "target")
        .env("CARGO_INCREMENTAL", "0")
        .env("RUSTFLAGS", "--cap-lints=allow")
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
    let mark = |line: &&&str| line.starts_with(MUTANT) || **line == AS_IT_WAS;
    let above = before.iter().rev().find(mark)?;
    above.strip_prefix(MUTANT)?.parse().ok()
}
