//! `evidence.json`.

use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// Something that can show a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Engine {
    /// Property tests of the kernel on big rationals.
    Tests,
    /// The proof harnesses, run as tests.
    StandIn,
    /// The proof harnesses, decided by a model checker.
    Kani,
    /// The kernel's terms, decided by z3 and cvc5.
    Smt,
    /// The theorem in a proof assistant.
    Rocq,
    /// Contracts on the kernel's functions.
    Prusti,
}

impl Engine {
    /// Every engine, in the order of the table.
    pub const ALL: [Self; 6] = [
        Self::Smt,
        Self::Rocq,
        Self::Kani,
        Self::StandIn,
        Self::Tests,
        Self::Prusti,
    ];

    /// The name in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tests => "tests",
            Self::StandIn => "stand-in",
            Self::Kani => "kani",
            Self::Smt => "smt",
            Self::Rocq => "rocq",
            Self::Prusti => "prusti",
        }
    }

    /// What it is, for a reader of the table.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Tests => "big rationals",
            Self::StandIn => "harnesses as tests",
            Self::Kani => "Kani",
            Self::Smt => "z3 and cvc5",
            Self::Rocq => "Rocq",
            Self::Prusti => "Prusti",
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What machines have shown, all of one run of `make prove`.
#[derive(Clone, Debug, PartialEq, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Evidence {
    /// What each engine did.
    pub runs: Vec<Run>,
    /// One record a claim and engine.
    pub records: Vec<Record>,
    /// The last mutation run, when there was one.
    pub mutation: Option<Mutation>,
}

/// What an engine did.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The engine.
    pub engine: Engine,
    /// The tools.
    pub tool: String,
    /// Harnesses, queries, tests or theorems that it went through.
    pub parts: u64,
    /// The time it took.
    pub seconds: f64,
    /// Why it did not run here; `None` when it did.
    pub not_run: Option<String>,
}

/// What one engine says of one claim.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    /// The claim's id.
    pub claim: String,
    /// The engine.
    pub engine: Engine,
    /// The tools and their versions.
    pub tool: String,
    /// *proved for all reals*, *proved for all inputs in …*, *exhausted on …*, *sampled, N cases* or
    /// *not run here*; `None` when the engine ran and did not show it.
    pub result: Option<String>,
    /// What part of the claim that is said of; `None` for the whole.
    pub scope: Option<String>,
    /// The domains, in words.
    pub domain: Vec<String>,
    /// Inputs that were tried, where they can be counted.
    pub cases: Option<u64>,
    /// The time that its parts took.
    pub seconds: f64,
    /// The names of the harnesses, queries, tests or theorems.
    pub parts: Vec<String>,
    /// What failed.
    pub failures: Vec<String>,
    /// Why it was not run here.
    pub not_run: Option<String>,
    /// SHA-256 of the claim's text.
    pub claim_sha256: String,
    /// SHA-256 of each source file of the claim's code.
    pub sources: BTreeMap<String, String>,
}

/// The result of changing the kernel here and there.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Mutation {
    /// The tool and its version.
    pub tool: String,
    /// The files that were changed.
    pub files: Vec<String>,
    /// Mutants that compile.
    pub mutants: u64,
    /// Those that a test noticed, or that did not come to an end.
    pub caught: u64,
    /// Those that no test noticed, each with the reason why it cannot be.
    pub survivors: Vec<Survivor>,
    /// The time it took.
    pub seconds: f64,
    /// SHA-256 of each file that was changed.
    pub sources: BTreeMap<String, String>,
}

/// A mutant that no test noticed.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Survivor {
    /// What was changed, without its line: `src/region.rs: replace < with <= in …`.
    pub mutant: String,
    /// Why it makes no difference.
    pub reason: String,
}

impl Evidence {
    /// Reads recorded evidence.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be read or is no evidence.
    pub fn read(path: &Path) -> Result<Self, String> {
        serde_json::from_str(&crate::read(path)?).map_err(|e| format!("{}: {e}", path.display()))
    }

    /// The text of the file.
    ///
    /// # Errors
    ///
    /// A sentence, when a number has no text.
    pub fn text(&self) -> Result<String, String> {
        let text = serde_json::to_string_pretty(self).map_err(|e| e.to_string())?;
        Ok(format!("{text}\n"))
    }

    /// What an engine said of a claim.
    #[must_use]
    pub fn find(&self, claim: &str, engine: Engine) -> Option<&Record> {
        self.records
            .iter()
            .find(|record| record.claim == claim && record.engine == engine)
    }
}

impl Record {
    /// What has changed since: `claim text` and paths; nothing for fresh evidence.
    #[must_use]
    pub fn stale(&self, claim_sha256: &str, sources: &BTreeMap<String, String>) -> Vec<String> {
        let mut changed = Vec::new();
        if self.claim_sha256 != claim_sha256 {
            changed.push("claim text".to_owned());
        }
        let files = self.sources.keys().chain(sources.keys());
        let differ = |file: &&String| self.sources.get(*file) != sources.get(*file);
        let mut files: Vec<String> = files.filter(differ).cloned().collect();
        files.sort();
        files.dedup();
        changed.extend(files);
        changed
    }
}

impl Mutation {
    /// The files that have changed since the run; none for a fresh one.
    ///
    /// # Errors
    ///
    /// A sentence, when a file can't be read.
    pub fn stale(&self, root: &Path) -> Result<Vec<String>, String> {
        let mut changed = Vec::new();
        for (file, hash) in &self.sources {
            let path = root.join(file);
            if !path.exists() || sha256(crate::read(&path)?.as_bytes()) != *hash {
                changed.push(file.clone());
            }
        }
        Ok(changed)
    }
}

/// SHA-256 in hexadecimal.
///
/// # Example
///
/// ```
/// let hash = passivity_evidence::sha256(b"abc");
/// assert!(hash.starts_with("ba7816bf") && hash.len() == 64);
/// ```
#[must_use]
pub fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}
