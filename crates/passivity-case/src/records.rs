//! Claims, assumptions and recorded evidence as a case uses them, and how fresh the evidence is.

use std::collections::{BTreeMap, BTreeSet};

use passivity_evidence::Engine;

use crate::gsn::Standing;

/// A claim with what was recorded about it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Claim {
    /// The id, as in `TH-LIN`.
    pub id: String,
    /// What is claimed, in a sentence.
    pub sentence: String,
    /// The same as a formula; empty when the sentence says it all.
    pub formula: String,
    /// The paper's equation or section; empty for a claim beyond the paper.
    pub equation: String,
    /// Whether the paper's statement is false as printed, and the claim is that it is.
    pub refutes: bool,
    /// The kernel items that implement it.
    pub code: Vec<String>,
    /// Ids of the assumptions that it is made under.
    pub assumptions: Vec<String>,
    /// Ids of the caveats: what the evidence does not say.
    pub caveats: Vec<String>,
    /// What was recorded or should have been.
    pub evidence: Vec<Evidence>,
}

/// An assumption of the claims.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Assumption {
    /// The id, as in `A-OPERATOR`.
    pub id: String,
    /// What is assumed, in a sentence.
    pub sentence: String,
    /// How to check it on the bench; empty when the claims do not say.
    pub check: String,
}

/// What one engine says of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Evidence {
    /// The claim's id and the engine, which name the record: `TH-LIN/smt`.
    pub id: String,
    /// The engine.
    pub engine: Engine,
    /// The result in the project's words, with the domain or the number of cases.
    pub result: String,
    /// The tool and its version.
    pub tool: String,
    /// Hashes of the sources that it covers, by path, as recorded.
    pub sources: BTreeMap<String, String>,
    /// How fresh it is.
    pub freshness: Freshness,
}

/// Whether a record still speaks of what is there now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Freshness {
    /// The claim's text and every source are as they were recorded.
    Fresh,
    /// These have changed: `claim text`, or paths.
    Stale(Vec<String>),
    /// It was never run here, for this reason.
    NotRun(String),
    /// It ran, and it did not show the claim.
    Failed(String),
}

impl Evidence {
    /// How it stands in the argument.
    #[must_use]
    pub const fn standing(&self) -> Standing {
        match self.freshness {
            Freshness::Fresh => Standing::Shown,
            Freshness::Stale(_) => Standing::Stale,
            Freshness::NotRun(_) => Standing::NotRun,
            Freshness::Failed(_) => Standing::Open,
        }
    }

    /// The standing in words, with what changed or why it was not run.
    #[must_use]
    pub fn words(&self) -> String {
        match &self.freshness {
            Freshness::Fresh => "fresh".to_owned(),
            Freshness::Stale(changed) => format!("stale: changed since: {}", changed.join(", ")),
            Freshness::NotRun(why) if why.is_empty() => "not run here".to_owned(),
            Freshness::NotRun(why) => format!("not run here: {why}"),
            Freshness::Failed(why) => format!("failed: {why}"),
        }
    }
}

impl Claim {
    /// How it stands: shown when some record shows it and none is stale or failed.
    ///
    /// A record that was not run does not speak against the claim while another one shows it, but
    /// it is listed, and a strict case refuses it.
    #[must_use]
    pub fn standing(&self) -> Standing {
        let of =
            |wanted: fn(&Freshness) -> bool| self.evidence.iter().any(|e| wanted(&e.freshness));
        if of(|f| matches!(f, Freshness::Failed(_))) {
            Standing::Open
        } else if of(|f| matches!(f, Freshness::Stale(_))) {
            Standing::Stale
        } else if of(|f| matches!(f, Freshness::Fresh)) {
            Standing::Shown
        } else {
            Standing::NotRun
        }
    }
}

/// The sources that evidence was compared with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Origin {
    /// Those that this `passivity` was built from.
    #[default]
    Build,
    /// Those of a source tree, as they are now.
    Tree,
}

impl Origin {
    /// The sources in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Build => {
                "the sources that this passivity was built from (the tree is not at hand)"
            }
            Self::Tree => "the sources of the tree, as they were when this case was written",
        }
    }
}

/// Everything that is known of the claims.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Records {
    /// The claims, in the order of the file.
    pub claims: Vec<Claim>,
    /// The assumptions.
    pub assumptions: Vec<Assumption>,
    /// The caveats, by their ids.
    pub caveats: BTreeMap<String, String>,
    /// Recorded evidence for ids that are no claim.
    pub unknown: Vec<String>,
    /// Which sources the evidence was compared with.
    pub origin: Origin,
    /// SHA-256 of the claims' text.
    pub claims_sha256: String,
    /// SHA-256 of the recorded evidence.
    pub evidence_sha256: String,
    /// The commit of the sources, when known.
    pub commit: Option<String>,
    /// What the last mutation run found, in a sentence.
    pub mutation: Option<String>,
}

impl Records {
    /// A claim by its id.
    #[must_use]
    pub fn claim(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// An assumption by its id.
    #[must_use]
    pub fn assumption(&self, id: &str) -> Option<&Assumption> {
        self.assumptions
            .iter()
            .find(|assumption| assumption.id == id)
    }

    /// Every record with the claim it belongs to.
    pub fn evidence(&self) -> impl Iterator<Item = (&Claim, &Evidence)> {
        self.claims
            .iter()
            .flat_map(|claim| claim.evidence.iter().map(move |e| (claim, e)))
    }

    /// How claims hang together with code and evidence.
    #[must_use]
    pub fn linkage(&self) -> Linkage<'_> {
        let mut linkage = Linkage::default();
        for claim in &self.claims {
            let code = !claim.code.is_empty();
            let evidence = claim
                .evidence
                .iter()
                .any(|e| !matches!(e.freshness, Freshness::NotRun(_)));
            match (code, evidence) {
                (true, true) => linkage.linked.push(&claim.id),
                (true, false) | (false, true) => linkage.partly.push(&claim.id),
                (false, false) => linkage.unlinked.push(&claim.id),
            }
            for id in &claim.assumptions {
                if self.assumption(id).is_none() {
                    linkage.unknown.insert(id);
                }
            }
            for id in &claim.caveats {
                if !self.caveats.contains_key(id) {
                    linkage.unknown.insert(id);
                }
            }
        }
        linkage
            .unknown
            .extend(self.unknown.iter().map(String::as_str));
        linkage
    }
}

/// Which claims have code and evidence, which only one of them, and ids that are no claim.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Linkage<'a> {
    /// Code and evidence.
    pub linked: Vec<&'a str>,
    /// Code or evidence.
    pub partly: Vec<&'a str>,
    /// Neither.
    pub unlinked: Vec<&'a str>,
    /// Ids that something refers to and that are not defined.
    pub unknown: BTreeSet<&'a str>,
}
