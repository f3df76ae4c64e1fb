//! `prove-kani`: runs the pinned Kani on the harnesses of `proofs/kani` and judges its report.
//!
//! The exit code of Kani does not decide. Each harness of `harnesses.toml` must be in the report
//! with the verdict that it should have, all its covers satisfied, and, where it must fail, with
//! the one named check failed. Exit code: 0 all proved, 1 something is wrong, 2 not run here.
#![allow(clippy::print_stdout)]

mod judge;
mod report;
#[cfg(test)]
mod tests;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use passivity_standin::list::{self, List};
use serde_json::{Value, json};

/// The only version that the harnesses have been written for.
const VERSION: &str = "0.68.0";

/// Harnesses checked at a time.
const JOBS: u8 = 2;

/// The longest that one harness may take.
const TIME_LIMIT: &str = "120s";

fn main() -> ExitCode {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let list = match list::read(&folder) {
        Ok(list) => list,
        Err(message) => return stop(&message, 1),
    };
    match installed_version() {
        Some(version) if version == VERSION => {}
        found => {
            let found = found.map_or("is not installed".into(), |v| format!("has version {v}"));
            let reason = format!("`cargo kani` {found}; the harnesses need {VERSION}");
            write_records(&not_run(&list, &reason));
            return stop(
                &format!(
                    "not run here: {reason}. To install it:\n    \
                     cargo install --locked kani-verifier --version {VERSION}\n    \
                     cargo kani setup"
                ),
                2,
            );
        }
    }
    let output = match run(&folder) {
        Ok(output) => output,
        Err(message) => return stop(&message, 1),
    };
    match report::read(&output) {
        Ok(reports) => conclude(&list, &reports),
        Err(message) => stop(
            &format!("the report of `cargo kani` is not understood: {message}"),
            1,
        ),
    }
}

/// Prints and records what is proved and what is not.
fn conclude(list: &List, reports: &std::collections::BTreeMap<String, report::Report>) -> ExitCode {
    let mut wrong = 0;
    let mut records = Vec::new();
    for (entry, faults) in judge::judge(list, reports) {
        let seconds = reports.get(&entry.name).and_then(|r| r.seconds);
        let word = if faults.is_empty() {
            "proved"
        } else {
            "WRONG "
        };
        println!("{word} {} ({} s)", entry.name, seconds.unwrap_or_default());
        for fault in &faults {
            println!("       {fault}");
        }
        wrong += usize::from(!faults.is_empty());
        let result = match faults.as_slice() {
            [] => format!("proved for all inputs in {}", entry.domain),
            _ => format!("failed: {}", faults.join("; ")),
        };
        records.push(record(entry, faults.is_empty(), &result, seconds));
    }
    let unknown = judge::unknown(list, reports);
    for name in &unknown {
        println!("WRONG  {name}: it is not in harnesses.toml");
    }
    write_records(&records);
    println!(
        "{} of {} harnesses proved by Kani {VERSION}",
        list.harness.len() - wrong,
        list.harness.len()
    );
    if wrong + unknown.len() == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::from(1)
    }
}

fn stop(message: &str, code: u8) -> ExitCode {
    eprintln!("prove-kani: {message}");
    ExitCode::from(code)
}

/// `cargo kani`, free of what `cargo run` has put into the environment for this program alone.
fn cargo_kani() -> Command {
    let mut command = Command::new("cargo");
    command.arg("kani");
    for name in ["CARGO", "RUSTUP_TOOLCHAIN", "LD_LIBRARY_PATH"] {
        command.env_remove(name);
    }
    command
}

/// The version of `cargo kani`, from a line such as `cargo-kani 0.68.0`.
fn installed_version() -> Option<String> {
    let output = cargo_kani().arg("--version").output().ok()?;
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
    println!("cargo kani -p passivity-kani, {JOBS} harnesses at a time, each up to {TIME_LIMIT}");
    let output = cargo_kani()
        .current_dir(folder)
        .args(["-p", "passivity-kani", "--output-format=terse"])
        .arg(format!("--jobs={JOBS}"))
        .args(["-Z", "unstable-options", "--harness-timeout", TIME_LIMIT])
        .output()
        .map_err(|e| format!("`cargo kani` can't be run: {e}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    if !text.contains("Checking harness ") {
        let errors = String::from_utf8_lossy(&output.stderr);
        return Err(format!("`cargo kani` checked nothing:\n{text}{errors}"));
    }
    Ok(text)
}

fn record(entry: &list::Entry, passed: bool, result: &str, seconds: Option<f64>) -> Value {
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

/// Writes `kani.jsonl` into the folder of evidence, one line a harness.
fn write_records(records: &[Value]) {
    let folder = std::env::var_os("PASSIVITY_EVIDENCE_DIR").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../target/evidence"),
        PathBuf::from,
    );
    let mut lines = String::new();
    for record in records {
        let _ = writeln!(lines, "{record}");
    }
    let path = folder.join("kani.jsonl");
    let written = std::fs::create_dir_all(&folder).and_then(|()| std::fs::write(&path, lines));
    if let Err(e) = written {
        eprintln!("prove-kani: {}: {e}", path.display());
    }
}
