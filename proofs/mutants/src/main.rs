//! `passivity-mutate FOLDER [PART...]`: swaps comparisons, ends of intervals and arithmetic in the
//! files that decide a verdict, one at a time, and runs the tests on each change.
//!
//! cargo-mutants changes operators and what functions return; it does not know that `hi` and `lo`,
//! `max` and `min`, `hardest` and `easiest` are such pairs. All changes go into one copy of the
//! crates, each with a switch, so that they are built once. What the tests said is left in FOLDER
//! in the form of cargo-mutants, for `passivity-collect mutants`. With PARTs only changes are tried
//! in whose names one of them is.
#![allow(clippy::print_stdout)] // this is what the program prints

mod copy;
mod operators;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use passivity_standin::mutate::VARIABLE;
use serde_json::json;

use operators::Change;

/// Inputs of each property test, at first and for what survives those.
const CASES: [&str; 2] = ["24", "256"];

/// How long tests may take on a change, in seconds. What takes longer was not noticed.
const LIMIT: u64 = 240;

/// A crate with the files that are changed, and the tests that must notice.
pub(crate) struct Subject {
    pub(crate) package: &'static str,
    pub(crate) folder: &'static str,
    files: &'static [&'static str],
    tests: &'static [&'static str],
}

/// All that decides between a scene file and its verdict.
pub(crate) const SUBJECTS: [Subject; 2] = [
    Subject {
        package: "passivity-core",
        folder: "crates/passivity-core",
        files: &[
            "control_loop.rs",
            "criterion.rs",
            "fraction.rs",
            "interval.rs",
            "parameter.rs",
            "pi.rs",
            "rational.rs",
            "region.rs",
            "start.rs",
            "stiffness.rs",
            "verdict.rs",
            "witness.rs",
        ],
        tests: &["--test", "properties"],
    },
    Subject {
        package: "passivity-scene",
        folder: "crates/passivity-scene",
        files: &[
            "check/decide.rs",
            "check/figures.rs",
            "check/limits.rs",
            "check/report.rs",
            "check/unforced.rs",
        ],
        tests: &["--lib", "--test", "verdicts"],
    },
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let outcome = match arguments.split_first() {
        Some((folder, parts)) => run(Path::new(folder), parts),
        None => Err("usage: passivity-mutate FOLDER [PART...]".to_owned()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// What became of a change.
#[derive(Clone, Copy, PartialEq)]
enum Outcome {
    Noticed,
    Survived,
    TimedOut,
}

fn run(folder: &Path, parts: &[String]) -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut changes = Vec::new();
    for subject in &SUBJECTS {
        for file in subject.files {
            let path = format!("{}/src/{file}", subject.folder);
            let text = fs::read_to_string(root.join(&path)).map_err(|e| format!("{path}: {e}"))?;
            let first = u32::try_from(changes.len()).map_err(|e| e.to_string())? + 1;
            changes.extend(operators::changes(&path, &text, first));
        }
    }
    let asked = |c: &Change| parts.is_empty() || parts.iter().any(|part| c.name.contains(part));
    changes.retain(asked);
    let programs = copy::built(&root, &mut changes)?;
    println!("{} changes compile", changes.len());
    for (subject, program) in &programs {
        let started = Instant::now();
        if tested(&root, subject, program, 0, CASES[0])? != Outcome::Noticed {
            println!(
                "{}: {:.0} s without a change",
                program.display(),
                started.elapsed().as_secs_f64()
            );
        } else {
            return Err(format!("{} fails without a change", program.display()));
        }
    }
    let mut outcomes = Vec::new();
    for change in &changes {
        let started = Instant::now();
        let mut outcome = Outcome::Survived;
        for cases in CASES {
            let of_file = programs
                .iter()
                .filter(|(s, _)| change.file.starts_with(s.folder));
            for (subject, program) in of_file {
                if outcome == Outcome::Survived {
                    outcome = tested(&root, subject, program, change.number, cases)?;
                }
            }
        }
        let summary = match outcome {
            Outcome::Noticed => "CaughtMutant",
            Outcome::Survived => "MissedMutant",
            Outcome::TimedOut => "Timeout",
        };
        println!("{summary:<12} {}", change.name);
        outcomes.push(json!({
            "scenario": {"Mutant": {"name": change.name, "file": change.file}},
            "summary": summary,
            "phase_results": [{"duration": started.elapsed().as_secs_f64()}],
        }));
    }
    fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let path = folder.join("outcomes.json");
    let run = json!({"cargo_mutants_version": null, "end_time": "done", "outcomes": outcomes});
    fs::write(&path, run.to_string()).map_err(|e| format!("{}: {e}", path.display()))
}

/// Runs a test program with a change on, in the folder of its crate.
fn tested(
    root: &Path,
    subject: &Subject,
    program: &PathBuf,
    change: u32,
    cases: &str,
) -> Result<Outcome, String> {
    let failed = |e: std::io::Error| format!("{}: {e}", program.display());
    let mut child = Command::new(program)
        .env(VARIABLE, change.to_string())
        .env("PROPTEST_CASES", cases)
        .env("PROPTEST_MAX_SHRINK_ITERS", "0")
        .env("RUST_BACKTRACE", "0")
        .env_remove("PASSIVITY_EVIDENCE_DIR")
        .current_dir(root.join(subject.folder))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .map_err(failed)?;
    let started = Instant::now();
    loop {
        match child.try_wait().map_err(failed)? {
            Some(status) if status.success() => return Ok(Outcome::Survived),
            Some(_) => return Ok(Outcome::Noticed),
            None if started.elapsed().as_secs() > LIMIT => {
                child.kill().map_err(failed)?;
                child.wait().map_err(failed)?;
                return Ok(Outcome::TimedOut);
            }
            None => sleep(Duration::from_millis(20)),
        }
    }
}
