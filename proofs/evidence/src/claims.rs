//! `claims.toml`.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::record::{Engine, sha256};

/// Every claim, with what claims refer to.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Claims {
    /// The assumptions.
    #[serde(rename = "assumption")]
    pub assumptions: Vec<Assumption>,
    /// What evidence does not say.
    #[serde(rename = "caveat")]
    pub caveats: Vec<Caveat>,
    /// The claims, in the order of the theory.
    #[serde(rename = "claim")]
    pub claims: Vec<Claim>,
}

/// An assumption that claims are made under.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Assumption {
    /// The id: `A-START`.
    pub id: String,
    /// What is assumed, in a sentence.
    pub sentence: String,
    /// How to check it on the bench.
    pub check: String,
}

/// What some evidence does not say.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Caveat {
    /// The id: `C-GRID`.
    pub id: String,
    /// The caveat in words.
    pub text: String,
}

/// A claim.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The id: `TH-LIN`.
    pub id: String,
    /// What is claimed, in one sentence.
    pub sentence: String,
    /// The same as a formula; empty when the sentence says it all.
    pub formula: String,
    /// The paper's equations, or where it is beyond the paper.
    pub equation: String,
    /// Whether the claim is that a statement of the paper is false as printed.
    #[serde(default)]
    pub refutes: bool,
    /// The kernel's items that implement it: `generation::bound_22`.
    pub code: Vec<String>,
    /// The engines that are expected to show it.
    pub evidence: Vec<Engine>,
    /// What part of the claim an engine speaks of, where it is not the whole.
    #[serde(default)]
    pub scope: BTreeMap<Engine, String>,
    /// Ids of the assumptions that it is made under.
    pub assumptions: Vec<String>,
    /// Ids of the caveats of its evidence.
    pub caveats: Vec<String>,
}

impl Claims {
    /// Reads `proofs/claims.toml` under a root folder.
    ///
    /// # Errors
    ///
    /// A sentence, when the file can't be read or is not such a list.
    pub fn read(root: &Path) -> Result<Self, String> {
        let path = root.join("proofs/claims.toml");
        toml::from_str(&crate::read(&path)?).map_err(|e| format!("{}: {e}", path.display()))
    }

    /// The claim of that id.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// The ids that the name of a test, a harness or a query begins with: one after the other.
    ///
    /// # Example
    ///
    /// ```
    /// let claims = passivity_evidence::Claims::read(&passivity_evidence::root()).unwrap();
    /// assert_eq!(claims.named("th_dac_th_delay_combined"), ["TH-DAC", "TH-DELAY"]);
    /// assert_eq!(claims.named("err_19_start_counterexample"), ["ERR-19-start"]);
    /// ```
    #[must_use]
    pub fn named(&self, name: &str) -> Vec<&str> {
        let mut found = Vec::new();
        let mut rest = name;
        while let Some((claim, after)) = self.claims.iter().find_map(|claim| {
            let after = rest.strip_prefix(&claim.name())?;
            (after.is_empty() || after.starts_with('_')).then_some((claim, after))
        }) {
            found.push(claim.id.as_str());
            rest = after.trim_start_matches('_');
        }
        found
    }
}

impl Claim {
    /// The id as names have it: `th_lin`, `eq_23_26`.
    #[must_use]
    pub fn name(&self) -> String {
        self.id
            .to_lowercase()
            .replace("..", "_")
            .replace(['-', '/'], "_")
    }

    /// SHA-256 of the claim's text: its id, sentence, formula, equation and assumptions.
    #[must_use]
    pub fn sha256(&self) -> String {
        let Self {
            id,
            sentence,
            formula,
            equation,
            refutes,
            assumptions,
            ..
        } = self;
        let text = format!(
            "{id}\n{sentence}\n{formula}\n{equation}\n{refutes}\n{}\n",
            assumptions.join(" ")
        );
        sha256(text.as_bytes())
    }

    /// The source files of its code, from the root of the workspace.
    #[must_use]
    pub fn files(&self) -> Vec<String> {
        let file = |item: &String| {
            let module = item.split("::").next().unwrap_or(item);
            format!("crates/passivity-core/src/{module}.rs")
        };
        let mut files: Vec<String> = self.code.iter().map(file).collect();
        files.sort();
        files.dedup();
        files
    }

    /// SHA-256 of each source file of its code, as it is now.
    ///
    /// # Errors
    ///
    /// A sentence, when one of them can't be read.
    pub fn sources(&self, root: &Path) -> Result<BTreeMap<String, String>, String> {
        let hash = |file: String| {
            let text = crate::read(&root.join(&file))?;
            Ok((file, sha256(text.as_bytes())))
        };
        self.files().into_iter().map(hash).collect()
    }
}
