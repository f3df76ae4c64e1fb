//! `passivity-mutate [--jobs N] [--quick] FOLDER [PART...]`: changes what decides a verdict in one
//! place at a time, and runs the tests on each change.
//!
//! cargo-mutants says what is changed: values that functions return, operators, arms and guards of
//! `match`, fields. It does not know that `hi` and `lo`, `max` and `min`, `hardest` and `easiest` are
//! pairs, so these swaps are added. All go into one copy of a crate, each with a switch, so that
//! it is built once. What the tests said is left in FOLDER as it comes, so that a run that was
//! stopped goes on, and at its end in the form of cargo-mutants, for `passivity-collect mutants`.
//!
//! With PARTs only changes are tried in whose names one of them is; with `--quick` survivors are not
//! asked again with more inputs. Neither is a whole run, and neither leaves one.
#![allow(clippy::print_stdout)] // this is what the program prints

mod changes;
mod copy;
mod journal;
mod operators;
mod runs;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use changes::Change;
use journal::Journal;
use passivity_collect::mutants::Explained;
use runs::{CASES, Outcome};

/// A crate that is changed.
pub(crate) struct Subject {
    /// The package of its tests.
    pub(crate) tests_of: &'static str,
    /// From the root of the workspace.
    pub(crate) folder: &'static str,
    /// The folder of its tests, where they are a package of their own.
    pub(crate) tests_in: Option<&'static str>,
    /// Which of its tests must notice, whoever of both crates is changed.
    pub(crate) tests: &'static [&'static str],
}

pub(crate) const SUBJECTS: [Subject; 2] = [
    Subject {
        tests_of: "passivity-properties",
        folder: "crates/passivity-core",
        tests_in: Some("crates/passivity-core/tests"),
        tests: &["--test=properties"],
    },
    Subject {
        tests_of: "passivity-scene",
        folder: "crates/passivity-scene",
        tests_in: None,
        tests: &["--lib", "--test=decisions"],
    },
];

/// What was asked for on the command line.
struct Options {
    jobs: usize,
    quick: bool,
    folder: PathBuf,
    parts: Vec<String>,
}

fn main() -> ExitCode {
    let outcome = options(std::env::args().skip(1)).and_then(|options| run(&options));
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn options(mut arguments: impl Iterator<Item = String>) -> Result<Options, String> {
    let mut options = Options {
        jobs: std::thread::available_parallelism().map_or(1, usize::from),
        quick: false,
        folder: PathBuf::new(),
        parts: Vec::new(),
    };
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--jobs" => {
                let jobs = arguments.next().and_then(|n| n.parse().ok());
                options.jobs = jobs
                    .filter(|n| *n > 0)
                    .ok_or("--jobs needs a whole number above zero")?;
            }
            "--quick" => options.quick = true,
            _ if argument.starts_with('-') => return Err(format!("`{argument}` is no option")),
            _ if options.folder.as_os_str().is_empty() => {
                options.folder = std::path::absolute(&argument).map_err(|e| e.to_string())?;
            }
            _ => options.parts.push(argument),
        }
    }
    if options.folder.as_os_str().is_empty() {
        return Err("usage: passivity-mutate [--jobs N] [--quick] FOLDER [PART...]".to_owned());
    }
    Ok(options)
}

/// Of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn run(options: &Options) -> Result<(), String> {
    let root = root();
    fs::create_dir_all(&options.folder)
        .map_err(|e| format!("{}: {e}", options.folder.display()))?;
    let explained = Explained::read(&root).map_err(|e| e.to_string())?;
    let (mut changes, left_out) = changes::all(&root)?;
    for name in &left_out {
        println!("left out      {name}");
    }
    println!("{} changes, {} left out", changes.len(), left_out.len());
    let parts = &options.parts;
    changes.retain(|c| parts.is_empty() || parts.iter().any(|part| c.name.contains(part)));
    // What the sources are now: they may change while the copy is built.
    let journal = Journal::open(&root, &options.folder)?;
    let all = changes.clone();
    let compiles = |c: &Change| journal.outcome(&c.name) != Some(Outcome::Unviable);
    changes.retain(compiles);
    let built = copy::built(&root, &mut changes)?;
    for change in &built.unviable {
        journal.add(&change.name, (Outcome::Unviable, None), 0, 0.0)?;
    }
    println!("{} of {} changes compile", changes.len(), all.len());
    let tests = runs::known(&built, &journal, &options.folder)?;
    let seconds: f64 = tests.iter().map(|test| test.seconds).sum();
    println!("{} tests, {seconds:.0} s without a change", tests.len());
    let runs = runs::Runs::new(&built, &tests, &journal);
    runs.each(&changes, CASES[0], options.jobs)?;
    let again: Vec<Change> = changes
        .iter()
        .filter(|c| journal.outcome(&c.name) != Some(Outcome::Noticed))
        .filter(|c| !explained.has(&c.lasting_name()))
        .cloned()
        .collect();
    println!("{} survivors that nobody explained", again.len());
    if options.quick {
        return Ok(());
    }
    runs.each(&again, CASES[1], options.jobs)?;
    if !parts.is_empty() {
        return Ok(());
    }
    journal::write_whole(&options.folder, &journal, &all, &left_out)
}
