//! What changing the kernel here and there has shown.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::error::EvidenceError;
use crate::freshness::{Change, Now};
use crate::record::Tool;
use crate::sha256::Sha256;

/// The result of changing the kernel here and there.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Mutation {
    /// The tool and its version.
    pub tool: Tool,
    /// Mutants that compile.
    pub mutants: u64,
    /// Those that a test noticed.
    pub caught: u64,
    /// Those that no test noticed, or with which the tests came to no end, each with the reason.
    pub survivors: Vec<Survivor>,
    /// Those that no test noticed in functions that only look for a candidate: what they find is checked
    /// by other functions, so that a change of them may lose an answer, and never give a wrong one.
    #[serde(default)]
    pub searches: Vec<Search>,
    /// Those of which nobody has said why no test notices them: the gate fails on them.
    #[serde(default)]
    pub open: Vec<String>,
    /// Mutants that do not compile.
    #[serde(default)]
    pub unviable: u64,
    /// Those that were not tried.
    #[serde(default)]
    pub left_out: Vec<String>,
    /// The time it took.
    pub seconds: f64,
    /// The files that were changed, as they were before.
    pub sources: BTreeMap<String, Sha256>,
}

/// A mutant that no test noticed.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Survivor {
    /// What was changed, without its line: `src/region.rs: replace < with <= in …`.
    pub mutant: String,
    /// Why it makes no difference.
    pub reason: String,
}

/// A function that only looks for a candidate, and the mutants of it that no test noticed.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Search {
    /// Its file and name: `src/wave.rs: best_angle`.
    pub function: String,
    /// What checks its finds.
    pub checked_by: String,
    /// The mutants, without their lines.
    pub survivors: Vec<String>,
}

impl Mutation {
    /// The files that have changed since the run; none for a fresh one.
    ///
    /// # Errors
    ///
    /// A file that cannot be looked up.
    pub fn changes(
        &self,
        now: impl Fn(&str) -> Result<Now, EvidenceError>,
    ) -> Result<Vec<Change>, EvidenceError> {
        let mut changes = Vec::new();
        for (path, recorded) in &self.sources {
            changes.extend(now(path)?.change_of(path, recorded));
        }
        Ok(changes)
    }
}
