//! The manifest of a written case: what it was written from, by hash.

use std::collections::BTreeMap;
use std::path::Path;

use passivity_evidence::Sha256;
use serde::{Deserialize, Serialize};

use crate::case::{Case, HistoryEntry, VERSION};
use crate::error::CaseError;
use crate::files::read_text;
use crate::gsn::Argument;
use crate::recorded::{Recorded, Recordings, Source};
use crate::study::Study;

/// The manifest's file name.
pub const MANIFEST: &str = "manifest.json";

/// The form of the manifest, raised when it changes.
const FORMAT: u64 = 1;

/// A manifest is small; a file beyond this is none.
const MOST_BYTES: u64 = 64 << 20;

/// What a case was written from.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Manifest {
    /// The form of the file.
    format: u64,
    /// The version of `passivity` that wrote the case.
    pub passivity: String,
    /// The commit of the sources, when known.
    pub commit: Option<String>,
    /// SHA-256 of the claims' text.
    pub claims_sha256: Sha256,
    /// SHA-256 of the recorded evidence.
    pub evidence_sha256: Sha256,
    /// The scenes: where each was read, its hash and its verdict, by their names in file names.
    pub scenes: BTreeMap<String, SceneEntry>,
    /// How each record of evidence stood.
    pub records: BTreeMap<String, String>,
    /// SHA-256 of every file of the case.
    pub files: BTreeMap<String, Sha256>,
    /// The verdicts given so far.
    pub history: Vec<HistoryEntry>,
}

/// A scene of a case.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct SceneEntry {
    /// Where it was read.
    pub path: String,
    /// SHA-256 of the file.
    pub sha256: Sha256,
    /// The verdict.
    pub verdict: String,
    /// How the top goal stood.
    pub standing: String,
    /// What was recorded of the device, where the case has it as evidence.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recorded: Option<RecordedEntry>,
}

/// Recordings of a device, as a case has them.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct RecordedEntry {
    /// What a person gave: which files, how they are read, which device, and when.
    pub given: Recordings,
    /// Each file, with its hash when it was read.
    pub files: Vec<FileEntry>,
    /// What each log, and the identification, came to.
    pub outcomes: Vec<String>,
}

/// A file outside of the case that it rests on.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct FileEntry {
    /// Where it was read.
    pub path: String,
    /// Its SHA-256.
    pub sha256: Sha256,
}

impl RecordedEntry {
    fn of(study: &Study, recorded: &Recorded) -> Self {
        let file = |source: &Source| FileEntry {
            path: source.path.clone(),
            sha256: source.sha256,
        };
        Self {
            given: recorded.given.clone(),
            files: recorded.sources().map(file).collect(),
            outcomes: words(study),
        }
    }
}

/// What each recording of a study comes to, in a word.
pub(crate) fn words(study: &Study) -> Vec<String> {
    let outcomes = study.outcomes();
    outcomes.iter().map(|o| o.word().to_owned()).collect()
}

/// What the document calls the SHA-256 of version, commit, scenes and history.
pub(crate) const PAST: &str = "SHA-256 of version, commit, scenes and history";

impl Manifest {
    /// The manifest of a case with these files.
    #[must_use]
    pub fn of(case: &Case, files: &BTreeMap<String, Vec<u8>>) -> Self {
        let records = &case.records;
        let scene = |(study, argument): (&Study, &Argument)| {
            let entry = SceneEntry {
                path: study.path.to_string_lossy().into_owned(),
                sha256: study.sha256,
                verdict: study.report().verdict.name().to_owned(),
                standing: argument.standing().words().to_owned(),
                recorded: study
                    .recorded
                    .as_ref()
                    .map(|recorded| RecordedEntry::of(study, recorded)),
            };
            (study.slug.clone(), entry)
        };
        Self {
            format: FORMAT,
            passivity: VERSION.to_owned(),
            commit: records.commit.clone(),
            claims_sha256: records.claims_sha256,
            evidence_sha256: records.evidence_sha256,
            scenes: case.scenes().map(scene).collect(),
            records: records
                .assessed
                .iter()
                .map(|assessed| (assessed.id(), assessed.freshness.to_string()))
                .collect(),
            files: files
                .iter()
                .map(|(name, bytes)| (name.clone(), Sha256::of(bytes)))
                .collect(),
            history: case.history.clone(),
        }
    }

    /// The SHA-256 that the document has of what nothing else can be compared with.
    pub(crate) fn past(&self) -> Sha256 {
        let scenes = self.scenes.iter().map(|(name, entry)| {
            let SceneEntry {
                path,
                sha256,
                verdict,
                standing,
                // That is compared with the record of the recordings.
                recorded: _,
            } = entry;
            (name, path, sha256, verdict, standing)
        });
        let scenes: Vec<_> = scenes.collect();
        // As JSON no two of them are the same text; all of it is text, of which JSON can write any.
        let all = (&self.passivity, &self.commit, scenes, &self.history);
        let text = serde_json::to_string(&all).unwrap_or_else(|error| error.to_string());
        Sha256::of(text.as_bytes())
    }

    /// Whether a document has the SHA-256 of the same past; `None` for one from before documents have it.
    pub(crate) fn is_told_by(&self, page: &str) -> Option<bool> {
        page.contains(PAST)
            .then(|| page.contains(&self.past().to_string()))
    }

    /// The manifest as JSON text.
    ///
    /// # Errors
    ///
    /// A manifest that JSON cannot write.
    pub fn to_text(&self) -> Result<String, CaseError> {
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| CaseError::within(Path::new(MANIFEST), error))?;
        Ok(format!("{text}\n"))
    }

    /// Reads the manifest of the case in `folder`.
    ///
    /// # Errors
    ///
    /// A file that is not there, is too large, or is no manifest: with the place.
    pub fn read(folder: &Path) -> Result<Self, CaseError> {
        let path = folder.join(MANIFEST);
        let missing = match (path.exists(), folder.is_dir()) {
            (true, _) => None,
            (false, true) => Some(format!(
                "this folder holds no safety case: it has no file {MANIFEST}"
            )),
            (false, false) => Some("there is no such folder".to_owned()),
        };
        if let Some(what) = missing {
            return Err(CaseError::within(folder, what));
        }
        let text = read_text(&path, MOST_BYTES)?;
        let manifest: Self = serde_json::from_str(&text).map_err(|error| {
            let what = format!("this is no manifest of a safety case: {error}");
            CaseError::within(&path, what)
        })?;
        if manifest.format == FORMAT {
            Ok(manifest)
        } else {
            let what = format!("expected a manifest of format {FORMAT}");
            Err(CaseError::within(&path, what))
        }
    }
}
