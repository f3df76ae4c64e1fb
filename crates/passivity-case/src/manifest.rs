//! The manifest of a written case: what it was written from, by hash.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Map, Value, json};

use crate::case::{Case, Past, VERSION};
use crate::error::CaseError;
use passivity_evidence::sha256;

/// The manifest's file name.
pub const MANIFEST: &str = "manifest.json";

/// The form of the manifest, raised when it changes.
const FORMAT: u64 = 1;

/// A manifest is small; a file beyond this is none.
const MOST_BYTES: u64 = 64 << 20;

/// What a case was written from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    /// SHA-256 of the claims' text.
    pub claims: String,
    /// SHA-256 of the recorded evidence.
    pub evidence: String,
    /// The commit of the sources, when known.
    pub commit: Option<String>,
    /// The scenes: where each was read, its hash and its verdict, by their names in file names.
    pub scenes: BTreeMap<String, SceneEntry>,
    /// How each record of evidence stood.
    pub records: BTreeMap<String, String>,
    /// SHA-256 of every file of the case.
    pub files: BTreeMap<String, String>,
    /// The verdicts given so far.
    pub history: Vec<Past>,
}

/// A scene of a case.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SceneEntry {
    /// Where it was read.
    pub path: String,
    /// SHA-256 of the file.
    pub sha256: String,
    /// The verdict.
    pub verdict: String,
    /// How the top goal stood.
    pub standing: String,
}

impl Manifest {
    /// The manifest of a case with these files.
    #[must_use]
    pub fn of(case: &Case, files: &BTreeMap<String, Vec<u8>>) -> Self {
        let scene = |(study, argument): (&crate::Study, &crate::gsn::Argument)| {
            let entry = SceneEntry {
                path: study.path.to_string_lossy().into_owned(),
                sha256: study.sha256.clone(),
                verdict: study.report().verdict.name().to_owned(),
                standing: argument.top().standing.map_or("", |s| s.words()).to_owned(),
            };
            (study.slug.clone(), entry)
        };
        Self {
            claims: case.records.claims_sha256.clone(),
            evidence: case.records.evidence_sha256.clone(),
            commit: case.records.commit.clone(),
            scenes: case.scenes().map(scene).collect(),
            records: case
                .records
                .evidence()
                .map(|(_, e)| (e.id.clone(), e.words()))
                .collect(),
            files: files
                .iter()
                .map(|(name, bytes)| (name.clone(), sha256(bytes)))
                .collect(),
            history: case.history.clone(),
        }
    }

    /// The manifest as JSON text.
    #[must_use]
    pub fn to_text(&self) -> String {
        let scenes: Map<String, Value> = self
            .scenes
            .iter()
            .map(|(name, scene)| {
                let value = json!({ "path": scene.path, "sha256": scene.sha256,
                    "verdict": scene.verdict, "standing": scene.standing });
                (name.clone(), value)
            })
            .collect();
        let history: Vec<Value> = self
            .history
            .iter()
            .map(|past| {
                json!({ "scene": past.scene, "scene_sha256": past.scene_sha256,
                    "claims_sha256": past.claims_sha256, "version": past.version,
                    "verdict": past.verdict, "headline": past.headline })
            })
            .collect();
        let manifest = json!({ "format": FORMAT, "passivity": VERSION, "commit": self.commit,
            "claims_sha256": self.claims, "evidence_sha256": self.evidence, "scenes": scenes,
            "records": self.records, "files": self.files, "history": history });
        format!("{manifest:#}\n")
    }

    /// Reads the manifest of the case in `folder`.
    ///
    /// # Errors
    ///
    /// A file that is not there, is too large, or is no manifest: with the place.
    pub fn read(folder: &Path) -> Result<Self, CaseError> {
        let path = folder.join(MANIFEST);
        let text = read_text(&path, MOST_BYTES)?;
        let value: Value = serde_json::from_str(&text)
            .map_err(|error| CaseError::new(format!("`{}`: {error}", path.display())))?;
        Self::from_value(&value).map_err(|expected| {
            CaseError::new(format!("`{}`: expected {expected}", path.display()))
        })
    }

    fn from_value(value: &Value) -> Result<Self, String> {
        if value["format"].as_u64() != Some(FORMAT) {
            return Err(format!("a manifest of format {FORMAT}"));
        }
        let object = |key: &str| {
            value[key]
                .as_object()
                .ok_or_else(|| format!("an object `{key}`"))
        };
        let mut scenes = BTreeMap::new();
        for (name, scene) in object("scenes")? {
            let entry = SceneEntry {
                path: string(scene, "path")?,
                sha256: string(scene, "sha256")?,
                verdict: string(scene, "verdict")?,
                standing: string(scene, "standing")?,
            };
            scenes.insert(name.clone(), entry);
        }
        let strings = |key: &str| -> Result<BTreeMap<String, String>, String> {
            let object = object(key)?;
            object
                .keys()
                .map(|name| Ok((name.clone(), string(&value[key], name)?)))
                .collect()
        };
        let history = value["history"].as_array().ok_or("a list `history`")?;
        let past = |past: &Value| -> Result<Past, String> {
            Ok(Past {
                scene: string(past, "scene")?,
                scene_sha256: string(past, "scene_sha256")?,
                claims_sha256: string(past, "claims_sha256")?,
                version: string(past, "version")?,
                verdict: string(past, "verdict")?,
                headline: string(past, "headline")?,
            })
        };
        Ok(Self {
            claims: string(value, "claims_sha256")?,
            evidence: string(value, "evidence_sha256")?,
            commit: value["commit"].as_str().map(str::to_owned),
            scenes,
            records: strings("records")?,
            files: strings("files")?,
            history: history.iter().map(past).collect::<Result<_, _>>()?,
        })
    }
}

fn string(value: &Value, key: &str) -> Result<String, String> {
    value[key]
        .as_str()
        .map(str::to_owned)
        .ok_or_else(|| format!("a string `{key}`"))
}

/// The text of a file of at most `most` bytes.
pub(crate) fn read_text(path: &Path, most: u64) -> Result<String, CaseError> {
    let bytes = read_bytes(path, most)?;
    String::from_utf8(bytes)
        .map_err(|error| CaseError::new(format!("`{}`: not UTF-8: {error}", path.display())))
}

/// The bytes of a file of at most `most` bytes.
pub(crate) fn read_bytes(path: &Path, most: u64) -> Result<Vec<u8>, CaseError> {
    use std::io::Read as _;
    let file = std::fs::File::open(path).map_err(|error| CaseError::io(path, &error))?;
    let mut bytes = Vec::new();
    let read = file.take(most + 1).read_to_end(&mut bytes);
    read.map_err(|error| CaseError::io(path, &error))?;
    if bytes.len() as u64 > most {
        let message = format!("`{}`: expected at most {most} bytes", path.display());
        return Err(CaseError::new(message));
    }
    Ok(bytes)
}
