//! The claims of `passivity`, and what machines have shown of them.
//!
//! [`Claims`] is `proofs/claims.toml`: what is claimed, by which code, on which assumptions.
//! [`Evidence`] is `target/evidence.json`, made by `make prove`: one [`Record`] a claim and engine,
//! bound by hashes to the claim's text and to the sources that it speaks of. `proofs/evidence.json` is
//! the last one that was committed, and `proofs/README.md` the table made of both. Nothing here
//! proves anything: it gathers what engines have said, in the words that they are entitled to.

mod claims;
mod collect;
pub mod imported;
pub mod mutants;
mod record;
mod table;
pub mod trace;

use std::path::{Path, PathBuf};

pub use claims::{Assumption, Caveat, Claim, Claims};
pub use collect::collect;
pub use record::{Engine, Evidence, Mutation, Record, Run, Survivor, sha256};
pub use table::table;

/// The folder of the workspace that this crate was built in.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Reads a file, or says which one could not be read.
fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}
