//! The claims of `passivity`, what machines have shown of them, and whether that is still so.
//!
//! [`Claims`] is `claims.toml`: what is claimed, by which code, under which assumptions. [`Evidence`]
//! is `evidence.json`: one [`Record`] for each claim and engine, bound by hashes to the claim's text
//! and to the files that the engine read. [`assess`] compares both with the sources as they are now.
//!
//! What it is **not**: it proves nothing and runs no engine. It says what engines have said, in the
//! words that they are entitled to. A file that does not fit its form is an error, never a default.
#![cfg_attr(
    not(test),
    deny(
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::panic,
        clippy::indexing_slicing
    )
)]

use std::io::Read as _;

mod claims;
mod engine;
mod error;
mod freshness;
mod mutation;
mod record;
mod sha256;

pub use claims::{Assumption, Caveat, Claim, Claims, Item};
pub use engine::Engine;
pub use error::EvidenceError;
pub use freshness::{Assessed, Change, Freshness, Now, assess, in_tree};
pub use mutation::{Mutation, Search, Survivor};
pub use record::{Evidence, FORMAT, Failure, Outcome, Record, Run, RunOutcome, Shown, Tool};
pub use sha256::Sha256;

/// The files of the kernel that this crate was built with: their paths from the root of the
/// workspace, in order, and their sums. A program that runs where the sources are not can so still
/// say which evidence speaks of the kernel that it was built from.
pub const KERNEL: &[(&str, Sha256)] = include!(concat!(env!("OUT_DIR"), "/kernel.rs"));

/// The claims that this crate was built with: the text of `claims.toml`.
///
/// # Errors
///
/// A build whose copy, which is kept compressed, was damaged.
pub fn claimed() -> Result<String, EvidenceError> {
    inflated(
        include_bytes!(concat!(env!("OUT_DIR"), "/claims")),
        "the claims of this build",
    )
}

/// The evidence that this crate was built with: the text of `evidence.json`.
///
/// # Errors
///
/// A build whose copy, which is kept compressed, was damaged.
pub fn recorded() -> Result<String, EvidenceError> {
    inflated(
        include_bytes!(concat!(env!("OUT_DIR"), "/evidence")),
        "the evidence of this build",
    )
}

fn inflated(compressed: &[u8], name: &str) -> Result<String, EvidenceError> {
    let mut text = String::new();
    let read = flate2::read::DeflateDecoder::new(compressed).read_to_string(&mut text);
    read.map_err(|error| EvidenceError::io(std::path::Path::new(name), &error))?;
    Ok(text)
}

/// Reads a text file.
///
/// # Errors
///
/// A file that cannot be read, named.
pub fn read(path: &std::path::Path) -> Result<String, EvidenceError> {
    std::fs::read_to_string(path).map_err(|error| EvidenceError::io(path, &error))
}
