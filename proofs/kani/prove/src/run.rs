//! Kani run here: the command, what it printed, and the records of what it proved.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use passivity_standin::list::{self, Entry, List};
use serde_json::{Value, json};

use crate::{Stop, judge, report, sources};

/// The only version that is run here.
const VERSION: &str = "0.68.0";

/// The longest that one harness may take; none should take half of it on an idle machine.
const TIME_LIMIT: &str = "120s";

/// Optimised, the compiler copies covers and leaves some copies out of reach.
const OPT_LEVEL: (&str, &str) = ("CARGO_PROFILE_DEV_OPT_LEVEL", "0");

/// The regular format names each cover; it is there with one harness at a time only.
const ARGUMENTS: [&str; 8] = [
    "kani",
    "-p",
    "passivity-kani",
    "--output-format=regular",
    "-Z",
    "unstable-options",
    "--harness-timeout",
    TIME_LIMIT,
];

/// Runs Kani on every harness, judges its report and writes the records.
pub(crate) fn here(folder: &Path) -> Result<(), Stop> {
    let list = list::read(folder)?;
    match installed_version() {
        Some(version) if version == VERSION => {}
        found => {
            let found = found.map_or("is not installed".into(), |v| format!("has version {v}"));
            let reason = format!("`cargo kani` {found}; the harnesses need {VERSION}");
            write("kani.jsonl", &lines(&not_run(&list, &reason)))?;
            return Err(Stop {
                message: format!(
                    "not run here: {reason}. To install it:\n    \
                     cargo install --locked kani-verifier --version {VERSION}\n    \
                     cargo kani setup"
                ),
                code: 2,
            });
        }
    }
    let command = format!(
        "{}={} cargo {}",
        OPT_LEVEL.0,
        OPT_LEVEL.1,
        ARGUMENTS.join(" ")
    );
    println!("{command}");
    let head = format!("Command: {command}\nCommit: {}\n", sources::here());
    let output = run(folder)?;
    write("kani-report.txt", &format!("{head}{output}"))?;
    let run = report::read(&output)
        .map_err(|why| format!("the report of `cargo kani` is not understood: {why}"))?;
    for (name, report) in &run.harnesses {
        let time = report
            .seconds
            .map_or_else(|| "no time".into(), |s| format!("{s:.1} s"));
        println!(
            "{name}: {} ({time})",
            report.verdict.as_deref().unwrap_or("no verdict")
        );
    }
    write("kani.jsonl", &lines(&records(&list, &run)))?;
    let wrong = judge::wrong(&list, &run);
    let count = list.harness.len();
    if wrong.is_empty() {
        println!("{count} harnesses proved by Kani {VERSION}");
        Ok(())
    } else {
        Err(format!(
            "not all of {count} harnesses are proved:\n{}",
            wrong.join("\n")
        )
        .into())
    }
}

/// `cargo`, free of what `cargo run` has put into the environment for this program alone.
fn cargo() -> Command {
    let mut command = Command::new("cargo");
    for name in ["CARGO", "RUSTUP_TOOLCHAIN", "LD_LIBRARY_PATH"] {
        command.env_remove(name);
    }
    command
}

/// The version of `cargo kani`, from a line such as `cargo-kani 0.68.0`.
fn installed_version() -> Option<String> {
    let output = cargo().args(["kani", "--version"]).output().ok()?;
    if !output.status.success() {
        return None;
    }
    let text = String::from_utf8_lossy(&output.stdout);
    let version = text
        .split_whitespace()
        .find(|word| word.starts_with(|c: char| c.is_ascii_digit()));
    version.map(str::to_string)
}

/// Runs Kani on every harness and returns what it printed.
fn run(folder: &Path) -> Result<String, String> {
    let output = cargo()
        .current_dir(folder)
        .env(OPT_LEVEL.0, OPT_LEVEL.1)
        .args(ARGUMENTS)
        .output()
        .map_err(|e| format!("`cargo kani` can't be run: {e}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if !text.contains("Checking harness ") {
        let errors = String::from_utf8_lossy(&output.stderr);
        return Err(format!("`cargo kani` checked nothing:\n{text}{errors}"));
    }
    Ok(text)
}

/// A record a harness: what is proved of it, or how it failed.
fn records(list: &List, run: &report::Run) -> Vec<Value> {
    let judged = judge::judge(list, run).into_iter();
    let records = judged.map(|(entry, faults)| {
        let result = match faults.as_slice() {
            [] => format!("proved for all inputs in {}", entry.domain),
            _ => format!("failed: {}", faults.join("; ")),
        };
        let seconds = run.harnesses.get(&entry.name).and_then(|r| r.seconds);
        record(entry, faults.is_empty(), &result, seconds)
    });
    records.collect()
}

fn record(entry: &Entry, passed: bool, result: &str, seconds: Option<f64>) -> Value {
    json!({
        "engine": "kani",
        "version": VERSION,
        "harness": entry.name,
        "claims": entry.claims,
        "domain": entry.domain,
        "must_fail": entry.must_fail,
        "passed": passed,
        "result": result,
        "seconds": seconds,
    })
}

fn not_run(list: &List, reason: &str) -> Vec<Value> {
    let records = list.harness.iter().map(|entry| {
        let mut record = record(entry, false, "not run here", None);
        record["reason"] = reason.into();
        record
    });
    records.collect()
}

fn lines(records: &[Value]) -> String {
    records.iter().fold(String::new(), |mut text, record| {
        let _ = writeln!(text, "{record}");
        text
    })
}

/// Writes a file into the folder of evidence.
fn write(name: &str, text: &str) -> Result<(), String> {
    let folder = std::env::var_os("PASSIVITY_EVIDENCE_DIR")
        .map_or_else(|| crate::root().join("target/evidence"), PathBuf::from);
    let path = folder.join(name);
    std::fs::create_dir_all(&folder)
        .and_then(|()| std::fs::write(&path, text))
        .map_err(|e| format!("{}: {e}", path.display()))
}
