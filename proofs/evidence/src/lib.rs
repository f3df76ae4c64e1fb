//! From what the engines of `make prove` left behind to recorded evidence, and to its table.
//!
//! [`collect()`] reads what the engines left and makes `evidence.json` of it, [`table()`] makes
//! `proofs/README.md`, [`mutants`] judges mutation runs, and [`trace`] finds the ids of claims in
//! sources. [`imported`] is what the model checker said elsewhere. Nothing here proves anything: it
//! gathers what engines have said, in the words that they are entitled to. The types are those of
//! `passivity-evidence`.

mod collect;
mod engines;
pub mod imported;
pub mod mutants;
mod reads;
mod sources;
mod table;
pub mod trace;

use std::path::{Path, PathBuf};

pub use collect::collect;
pub use table::{table, tools};

/// The last evidence that was committed, from the root of the workspace.
pub const COMMITTED: &str = "proofs/evidence.json";

/// The folder of the workspace that this crate was built in.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
