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
mod rust_text;
mod sources;
mod table;
pub mod trace;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use passivity_evidence::{Claims, EvidenceError};

pub use collect::collect;
pub use table::{table, tools};

/// The last evidence that was committed, from the root of the workspace.
pub const COMMITTED: &str = "proofs/evidence.json";

/// The folder of the workspace that this crate was built in.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The files that the code of each claim rests on, in the order of the claims: those that name its
/// items, and all that these name and call.
///
/// # Errors
///
/// A source that cannot be read.
pub fn code_rests_on(root: &Path, claims: &Claims) -> Result<Vec<BTreeSet<String>>, EvidenceError> {
    let sources = sources::Sources::new(root, None);
    let reads = reads::Reads::new(&sources)?;
    let of = |claim: &passivity_evidence::Claim| reads.of(&sources, claim.files());
    claims.claims.iter().map(of).collect()
}
