//! A case: scenes, their arguments, the records they rest on, and the history of their verdicts.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use passivity_evidence::{Freshness, Sha256};
use serde::{Deserialize, Serialize};

use crate::argument::argue;
use crate::gsn::{Argument, Node};
use crate::info::Info;
use crate::records::Records;
use crate::study::Study;

/// Everything that a document is written from.
#[derive(Clone, Debug)]
pub struct Case {
    /// The scenes.
    pub studies: Vec<Study>,
    /// The argument of each.
    pub arguments: Vec<Argument>,
    /// The claims and their evidence.
    pub records: Records,
    /// The verdicts that were given so far, the newest of each scene last.
    pub history: Vec<HistoryEntry>,
    /// Who wrote the case, for what, and who approved it.
    pub info: Option<Info>,
    /// Whether to measure what accuracy costs in time, which differs from run to run.
    pub measured: bool,
    /// The options of the command that makes the case, beside scenes, folder and recordings, as they are typed.
    pub options: Vec<String>,
}

/// A verdict that was given.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct HistoryEntry {
    /// The scene's name in file names.
    pub scene: String,
    /// SHA-256 of the scene file.
    pub scene_sha256: Sha256,
    /// SHA-256 of the claims' text.
    pub claims_sha256: Sha256,
    /// The version of `passivity`.
    pub version: String,
    /// The verdict, as machine-readable output names it.
    pub verdict: String,
    /// The verdict in a line.
    pub headline: String,
}

/// The version of `passivity` that writes the case.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

impl Case {
    /// A case over scenes, with the verdicts that an earlier case recorded.
    #[must_use]
    pub fn new(mut studies: Vec<Study>, records: Records, earlier: Vec<HistoryEntry>) -> Self {
        name_apart(&mut studies);
        let arguments = studies.iter().map(|study| argue(study, &records)).collect();
        let mut history = earlier;
        for study in &studies {
            let now = HistoryEntry {
                scene: study.slug.clone(),
                scene_sha256: study.sha256,
                claims_sha256: records.claims_sha256,
                version: VERSION.to_owned(),
                verdict: study.report().verdict.name().to_owned(),
                headline: study.report().headline(),
            };
            // Only what changed makes history.
            if history.iter().rev().find(|past| past.scene == now.scene) != Some(&now) {
                history.push(now);
            }
        }
        Self {
            studies,
            arguments,
            records,
            history,
            info: None,
            measured: false,
            options: Vec::new(),
        }
    }

    /// Each scene with its argument.
    pub fn scenes(&self) -> impl Iterator<Item = (&Study, &Argument)> {
        self.studies.iter().zip(&self.arguments)
    }

    /// Whether every scene was shown to be passive.
    #[must_use]
    pub fn is_passive(&self) -> bool {
        self.studies.iter().all(Study::is_passive)
    }

    /// What a strict reader objects to: goals that are open or defeated, and evidence that is stale,
    /// that failed, or that a claim asks for and that was not run.
    #[must_use]
    pub fn objections(&self) -> Vec<Objection> {
        let mut all = Vec::new();
        let mut say = |what: String| {
            all.push(Objection {
                what,
                claims: Vec::new(),
            });
        };
        for (study, argument) in self.scenes() {
            let name = study.name();
            for node in argument.nodes().filter(|node| node.is_defeated()) {
                let against = argument.nodes();
                let against = against.filter(|other| other.challenges.as_ref() == Some(&node.id));
                let against: Vec<&str> = against.map(|other| other.text.as_str()).collect();
                say(format!(
                    "{name}: {} is defeated: {}",
                    node.id,
                    against.join(" ")
                ));
            }
            let open = |node: &&Node| node.is_undeveloped() && !node.is_defeated();
            for node in argument.nodes().filter(open) {
                let (id, text) = (&node.id, &node.text);
                say(format!(
                    "{name}: {id} is open: it is not shown that «{text}»"
                ));
            }
            for seen in study.unmet(argument) {
                say(format!(
                    "{name}: {} is not met: {}",
                    seen.assumption, seen.says
                ));
            }
        }
        for claim in &self.records.claims.claims {
            if self.records.of_claim(&claim.id).next().is_none() {
                say(format!("{}: no evidence is recorded", claim.id));
            }
        }
        // Many records stand the same way for the same reason: they are one point.
        let mut alike: BTreeMap<(&str, String), Vec<String>> = BTreeMap::new();
        for assessed in &self.records.assessed {
            let objects = match assessed.freshness {
                Freshness::Fresh => false,
                Freshness::NotRun(_) => assessed.required,
                Freshness::Stale(_) | Freshness::Failed(_) => true,
            };
            if objects {
                let key = (assessed.engine.words(), assessed.freshness.to_string());
                alike.entry(key).or_default().push(assessed.claim.clone());
            }
        }
        let alike = alike
            .into_iter()
            .map(|((engine, words), claims)| Objection {
                what: format!("{engine}: {words}"),
                claims,
            });
        all.extend(alike);
        all
    }
}

/// A point that is open, stale, missing or defeated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Objection {
    /// What it is.
    pub what: String,
    /// The claims that it concerns, where it is about evidence.
    pub claims: Vec<String>,
}

impl Objection {
    /// The point in a line that is short, whatever the number of claims.
    #[must_use]
    pub fn short(&self) -> String {
        match self.claims.len() {
            0..=3 => self.to_string(),
            count => format!("{} ({count} claims)", self.what),
        }
    }
}

impl fmt::Display for Objection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.what)?;
        match self.claims.as_slice() {
            [] => Ok(()),
            claims => write!(f, ": {}", claims.join(", ")),
        }
    }
}

/// Gives scenes of the same file name names of their own in files, by which all scenes are called where two of them are
/// called the same.
fn name_apart(studies: &mut [Study]) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let taken: Vec<String> = studies.iter().map(|study| study.slug.clone()).collect();
    for study in &mut *studies {
        let count = seen.entry(study.slug.clone()).or_default();
        *count += 1;
        let mut number = *count;
        while number > 1 && taken.contains(&format!("{}-{number}", study.slug)) {
            number += 1;
        }
        *count = number;
        if number > 1 {
            study.slug = format!("{}-{number}", study.slug);
        }
    }
    let names: BTreeSet<&str> = studies.iter().map(Study::name).collect();
    if names.len() < studies.len() {
        for study in studies {
            study.scene.name.clone_from(&study.slug);
        }
    }
}
