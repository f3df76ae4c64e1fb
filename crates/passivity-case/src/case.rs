//! A case: scenes, their arguments, the records they rest on, and the history of their verdicts.

use std::collections::BTreeMap;

use crate::argument::argue;
use crate::gsn::{Argument, Standing};
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
    pub history: Vec<Past>,
    /// Whether to measure what accuracy costs in time, which differs from run to run.
    pub measured: bool,
}

/// A verdict that was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Past {
    /// The scene's name in file names.
    pub scene: String,
    /// SHA-256 of the scene file.
    pub scene_sha256: String,
    /// SHA-256 of the claims' text.
    pub claims_sha256: String,
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
    pub fn new(mut studies: Vec<Study>, records: Records, earlier: Vec<Past>) -> Self {
        name_apart(&mut studies);
        let arguments = studies.iter().map(|study| argue(study, &records)).collect();
        let mut history = earlier;
        for study in &studies {
            let now = Past {
                scene: study.slug.clone(),
                scene_sha256: study.sha256.clone(),
                claims_sha256: records.claims_sha256.clone(),
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
            measured: false,
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

    /// What a strict reader objects to: open points, and evidence that is stale, failed or was not
    /// run, a line each.
    #[must_use]
    pub fn objections(&self) -> Vec<String> {
        let mut all = Vec::new();
        for (study, argument) in self.scenes() {
            for node in argument.nodes().iter().filter(|node| node.is_defeated()) {
                all.push(format!("{}: {} is defeated", study.name(), node.id));
            }
            for node in argument.nodes().iter().filter(|node| node.is_undeveloped()) {
                all.push(format!(
                    "{}: {} is open: {}",
                    study.name(),
                    node.id,
                    node.text
                ));
            }
        }
        for claim in self
            .records
            .claims
            .iter()
            .filter(|claim| claim.evidence.is_empty())
        {
            all.push(format!("{}: no evidence is recorded", claim.id));
        }
        // Many records stand the same way for the same reason: they are one point.
        let mut alike: BTreeMap<(&str, String), Vec<&str>> = BTreeMap::new();
        for (claim, evidence) in self.records.evidence() {
            if evidence.standing() != Standing::Shown {
                let key = (evidence.engine.words(), evidence.words());
                alike.entry(key).or_default().push(&claim.id);
            }
        }
        for ((engine, words), claims) in alike {
            all.push(format!("{engine}: {words}: {}", claims.join(", ")));
        }
        all
    }
}

/// Gives scenes of the same file name names of their own.
fn name_apart(studies: &mut [Study]) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let taken: Vec<String> = studies.iter().map(|study| study.slug.clone()).collect();
    for study in studies {
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
}
