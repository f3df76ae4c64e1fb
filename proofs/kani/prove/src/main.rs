//! `prove-kani`: runs the pinned Kani on the harnesses of `proofs/kani` and judges its report, or
//! takes a report that was made elsewhere, of the sources of a commit.
//!
//! The exit code of Kani does not decide. Each harness of `harnesses.toml` must be in the report
//! with the verdict that it should have, each of its covers satisfied, and, where it must fail,
//! with the one named check failed. Exit code: 0 all proved, 1 something is wrong, 2 not run here.
#![allow(clippy::print_stdout)]

mod import;
mod judge;
mod report;
mod run;
mod sources;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use passivity_evidence::EvidenceError;

const USAGE: &str =
    "usage: prove-kani [--report FILE --commit HASH [--cbmc VERSION] [--solver NAME]]";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let outcome = if words.is_empty() {
        run::here(&folder())
    } else {
        import::Arguments::read(&words).and_then(|arguments| import::take(&root(), &arguments))
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(stop) => {
            eprintln!("prove-kani: {}", stop.message);
            ExitCode::from(stop.code)
        }
    }
}

/// Why there is nothing proved, and the exit code that says so.
#[derive(Debug, PartialEq)]
struct Stop {
    message: String,
    code: u8,
}

impl From<String> for Stop {
    fn from(message: String) -> Self {
        Self { message, code: 1 }
    }
}

impl From<EvidenceError> for Stop {
    fn from(error: EvidenceError) -> Self {
        error.to_string().into()
    }
}

/// The folder of the harnesses.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The folder of the workspace.
fn root() -> PathBuf {
    folder().join("../..")
}
