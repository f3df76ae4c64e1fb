//! Checking a written case against the tree: what has changed since.

use std::collections::{BTreeMap, BTreeSet};
use std::iter;
use std::path::Path;

use passivity_audit::legible;
use passivity_evidence::Sha256;
use serde_json::Value;

use crate::case::{Case, Objection, VERSION};
use crate::error::CaseError;
use crate::files::{MOST_BYTES, read_bytes, read_text};
use crate::folder::{HTML, INFO, PDF};
use crate::manifest::{FileEntry, MANIFEST, Manifest, RecordedEntry, SceneEntry, words};
use crate::recorded::{Recorded, Recordings, record_name, sum};
use crate::records::Records;
use crate::study::Study;
use crate::{html, sections};

/// The differences between a written case and the present scenes, claims and evidence.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    /// What makes the case out of date, a line each: files, scenes and verdicts that changed.
    pub changed: Vec<String>,
    /// Records that are stale or missing now and were not when the case was written.
    pub stale: Vec<String>,
    /// Records that stand as they did.
    pub unchanged: usize,
    /// What could not be compared, and why.
    pub not_at_hand: Vec<String>,
    /// How each top goal stands now.
    pub standing: Vec<Stands>,
    /// What a strict reader objects to, as when the case is written.
    pub objections: Vec<Objection>,
}

/// How the top goal of a scene stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stands {
    /// What the scene is called.
    pub scene: String,
    /// Its name in file names.
    pub name: String,
    /// The verdict, as machine-readable output names it.
    pub verdict: &'static str,
    /// The verdict in a line.
    pub headline: String,
    /// How the top goal stands, in words.
    pub standing: String,
}

impl Findings {
    /// Whether the case still says what is so.
    #[must_use]
    pub const fn is_current(&self) -> bool {
        self.changed.is_empty() && self.stale.is_empty()
    }
}

/// Compares the case in `folder` with its own hashes, with the scenes, and with `records`.
///
/// # Errors
///
/// A folder without a manifest that can be read.
pub fn check(folder: &Path, records: &Records) -> Result<Findings, CaseError> {
    let manifest = Manifest::read(folder)?;
    let mut findings = Findings::default();
    for (name, expected) in &manifest.files {
        // A name that leads out of the folder is no file of the case.
        if Path::new(name).components().count() != 1 || name.contains("..") {
            findings
                .changed
                .push(format!("`{name}`: no file name of a case"));
            continue;
        }
        match read_bytes(&folder.join(name), MOST_BYTES) {
            Ok(bytes) if Sha256::of(&bytes) == *expected => {}
            Ok(_) => findings
                .changed
                .push(format!("`{name}` was changed after it was written")),
            Err(error) => findings.changed.push(error.to_string()),
        }
    }
    for name in documents(&manifest) {
        if !manifest.files.contains_key(&name) {
            let says =
                format!("`{name}` is a part of the case, and `{MANIFEST}` has no hash of it");
            findings.changed.push(says);
        }
    }
    for name in [INFO, PDF] {
        if folder.join(name).exists() && !manifest.files.contains_key(name) {
            findings.changed.push(format!(
                "`{name}` is none of the case's files, as `{MANIFEST}` has no hash of it: move it out of the folder"
            ));
        }
    }
    past(folder, &manifest, &mut findings);
    for (name, entry) in &manifest.scenes {
        if manifest.files.get(&format!("{name}.toml")) != Some(&entry.sha256) {
            findings.changed.push(format!(
                "`{name}.toml` is another scene than the one that `{MANIFEST}` has a hash of"
            ));
        }
        differences(folder, name, entry, &mut findings);
    }
    let studies = scenes(folder, &manifest, &mut findings);
    let case = Case::new(studies, records.clone(), Vec::new());
    verdicts(&manifest, &case, &mut findings);
    evidence(&manifest, records, &mut findings);
    page(folder, &manifest, &case, &mut findings);
    Ok(findings)
}

/// The files that a case of these scenes must have, beside the scenes.
fn documents(manifest: &Manifest) -> Vec<String> {
    let of_scene = |(name, entry): (&String, &SceneEntry)| {
        let record = entry.recorded.as_ref().map(|_| record_name(name));
        let drawn = ["gsn.yaml", "gsn.svg"].map(|end| format!("{name}.{end}"));
        drawn.into_iter().chain(record)
    };
    let of_scenes = manifest.scenes.iter().flat_map(of_scene);
    iter::once(HTML.to_owned()).chain(of_scenes).collect()
}

/// Compares what the manifest says of the past with the hash that the document has of it.
fn past(folder: &Path, manifest: &Manifest, findings: &mut Findings) {
    // A document that cannot be read was told of already.
    let Ok(page) = read_text(&folder.join(HTML), MOST_BYTES) else {
        return;
    };
    let what = "the version, the commit, the scenes and the history of verdicts";
    match manifest.is_told_by(&page) {
        Some(true) => {}
        Some(false) => findings
            .changed
            .push(format!("{what}: `{MANIFEST}` says other than `{HTML}`")),
        None => findings.not_at_hand.push(format!(
            "{what}: `{HTML}` is from before it has a hash of them; write the case again"
        )),
    }
}

/// Compares what the manifest says of recordings with the record of them, of which it has the hash: what a
/// reader of the document sees was written from that record.
fn differences(folder: &Path, name: &str, entry: &SceneEntry, findings: &mut Findings) {
    let file = record_name(name);
    let path = folder.join(&file);
    let Some(told) = &entry.recorded else {
        if path.exists() {
            let says = format!("`{file}` is of recordings that `{MANIFEST}` does not have");
            findings.changed.push(says);
        }
        return;
    };
    let record = read_bytes(&path, MOST_BYTES).and_then(|bytes| {
        let read = serde_json::from_slice::<Value>(&bytes);
        read.map_err(|error| CaseError::within(&path, error))
    });
    let record = match record {
        Ok(record) => record,
        Err(error) => return findings.changed.push(error.to_string()),
    };
    let list = |value: Option<&Value>| value.and_then(Value::as_array).cloned().unwrap_or_default();
    let text = |value: &Value, pointer: &str| {
        let found = value.pointer(pointer).and_then(Value::as_str);
        found.unwrap_or_default().to_owned()
    };
    let logs = list(record.get("logs"));
    let identification = record
        .get("identification")
        .filter(|found| !found.is_null());
    let files: Vec<[String; 3]> = logs
        .iter()
        .filter_map(|log| log.get("source").cloned())
        .chain(list(record.pointer("/identification/sources")))
        .map(|source| ["/path", "/date", "/sha256"].map(|field| text(&source, field)))
        .collect();
    let given = told.given.logs.iter().chain(&told.given.identification);
    let told_files: Vec<[String; 3]> = given
        .zip(&told.files)
        .map(|(given, file)| {
            let [path, date] = [&given.path, &given.date].map(Clone::clone);
            // The path is there twice, and both must be that of the record.
            let path = if file.path == path {
                path
            } else {
                String::new()
            };
            [path, date, file.sha256.to_string()]
        })
        .collect();
    let outcomes: Vec<String> = logs
        .iter()
        .chain(identification)
        .map(|found| text(found, "/evidence/outcome"))
        .collect();
    let how = record.get("given");
    if how.is_none() {
        findings.not_at_hand.push(format!(
            "how the logs were read: `{file}` is from before it says so; write the case again"
        ));
    }
    let how = how.map(|how| serde_json::from_value::<Recordings>(how.clone()).ok());
    for (is_same, what) in [
        (
            text(&record, "/device_as_given") == told.given.device,
            "which device was recorded",
        ),
        (
            files == told_files && files.len() == told.files.len(),
            "the logs, their dates or their hashes",
        ),
        (outcomes == told.outcomes, "what the recordings come to"),
        (
            how.is_none_or(|how| how.as_ref() == Some(&told.given)),
            "what was given with the recordings",
        ),
    ] {
        if !is_same {
            let says = format!("{what}: `{MANIFEST}` says other than `{file}`");
            findings.changed.push(says);
        }
    }
}

/// The scenes as they are now, or as the case has them when they are no longer there.
fn scenes(folder: &Path, manifest: &Manifest, findings: &mut Findings) -> Vec<Study> {
    let mut studies = Vec::new();
    for (name, entry) in &manifest.scenes {
        let path = Path::new(&entry.path);
        let read = if path.is_file() {
            Study::read(path)
        } else {
            findings.not_at_hand.push(format!(
                "scene file `{}`: the copy in the case was used",
                entry.path
            ));
            Study::read(&folder.join(format!("{name}.toml")))
        };
        match read {
            Ok(mut study) => {
                if study.sha256 != entry.sha256 {
                    findings
                        .changed
                        .push(format!("scene `{}` has changed", entry.path));
                }
                if let Some((name, bytes)) = &study.forces
                    && manifest.files.get(name) != Some(&Sha256::of(bytes))
                {
                    findings.changed.push(format!(
                        "scene `{}`: its forces, `{}`, have changed, or the case has no copy of them",
                        entry.path,
                        legible(name)
                    ));
                }
                study.slug.clone_from(name);
                if let Some(recorded) = &entry.recorded {
                    read_again(&mut study, recorded, findings);
                }
                studies.push(study);
            }
            Err(error) => findings
                .changed
                .push(format!("scene `{}`: {error}", entry.path)),
        }
    }
    studies
}

/// Reads the recordings again, unless one is gone or is another now: then that is what is found.
fn read_again(study: &mut Study, entry: &RecordedEntry, findings: &mut Findings) {
    let mut is_as_it_was = true;
    for FileEntry { path, sha256 } in &entry.files {
        let shown = legible(path);
        if !Path::new(path).exists() {
            findings.not_at_hand.push(format!(
                "log `{shown}`: it is not here, and the case has no copy of it"
            ));
            is_as_it_was = false;
            continue;
        }
        match sum(Path::new(path)) {
            Ok(now) if now == *sha256 => continue,
            Ok(_) => findings.changed.push(format!("log `{shown}` has changed")),
            Err(error) => findings.changed.push(format!("log {error}")),
        }
        is_as_it_was = false;
    }
    if !is_as_it_was {
        return;
    }
    match Recorded::read(entry.given.clone(), study, |_, _| {}) {
        Ok(recorded) => study.recorded = Some(recorded),
        Err(error) => findings.changed.push(error.to_string()),
    }
    let now = words(study);
    if now != entry.outcomes {
        findings.changed.push(format!(
            "{}: the recordings come to: {}; in the case to: {}",
            study.slug,
            now.join(", "),
            entry.outcomes.join(", ")
        ));
    }
}

fn verdicts(manifest: &Manifest, case: &Case, findings: &mut Findings) {
    findings.objections = case.objections();
    for (study, argument) in case.scenes() {
        let Some(entry) = manifest.scenes.get(&study.slug) else {
            continue;
        };
        let verdict = study.report().verdict.name();
        // Without the recordings that it rests on, a goal is known to stand only as the case says.
        let is_whole = entry.recorded.is_none() || study.recorded.is_some();
        let standing = match is_whole {
            true => argument.standing().words(),
            false => &entry.standing,
        };
        findings.standing.push(Stands {
            scene: study.name().to_owned(),
            name: study.slug.clone(),
            verdict,
            headline: study.report().headline(),
            standing: standing.to_owned(),
        });
        if verdict != entry.verdict {
            findings.changed.push(format!(
                "{}: the verdict is {verdict}, in the case it is {}",
                study.slug, entry.verdict
            ));
        }
        if !is_whole {
            let what = "the top goal: a recording that it rests on could not be read again";
            findings.not_at_hand.push(format!("{}: {what}", study.slug));
            continue;
        }
        if standing != entry.standing {
            findings.changed.push(format!(
                "{}: the top goal is {standing}, in the case it is {}",
                study.slug, entry.standing
            ));
        }
    }
}

/// Compares what the document says of the scenes, and of what was recorded of the device, with what is written of them now,
/// where all that it is written of is as it was: its hash in the manifest may be that of a document that somebody changed.
fn page(folder: &Path, manifest: &Manifest, case: &Case, findings: &mut Findings) {
    let is_same = findings.is_current() && findings.not_at_hand.is_empty();
    // Other versions may say the same in other words.
    if !is_same || manifest.passivity != VERSION {
        return;
    }
    let Ok(then) = read_text(&folder.join(HTML), MOST_BYTES) else {
        return;
    };
    let now = html::write(&sections::document(case));
    let mut differ = |what: &str| {
        let says = format!(
            "{what}: `{HTML}` says other than what is written of it now: it was changed, or another build wrote it"
        );
        findings.changed.push(says);
    };
    if verdict_lines(&then) != verdict_lines(&now) {
        differ("the verdicts on page one");
    }
    for study in &case.studies {
        let anchor = study.anchor("scene");
        if words_of(&then, &anchor) != words_of(&now, &anchor) {
            differ(&format!("the scene {} and its recordings", study.slug));
        }
    }
}

/// The verdicts of a page, whatever the order of its scenes.
fn verdict_lines(page: &str) -> BTreeSet<&str> {
    let lines = page.lines();
    lines
        .filter(|line| line.starts_with("<p class=\"verdict "))
        .collect()
}

/// The lines of a section of a page without its pictures, in which times may be measured.
fn words_of(page: &str, anchor: &str) -> Option<Vec<String>> {
    let start = format!("<section aria-labelledby=\"{anchor}\">");
    let (_, section) = page.split_once(&start)?;
    let (section, _) = section.split_once("</section>")?;
    let mut pieces = section.split("<figure");
    let mut text = pieces.next()?.to_owned();
    // A picture has none within it.
    let behind = pieces.map(|piece| {
        piece
            .split_once("</figure>")
            .map_or(piece, |(_, behind)| behind)
    });
    text.extend(behind);
    let lines = text.lines().filter(|line| !line.is_empty());
    Some(lines.map(str::to_owned).collect())
}

fn evidence(manifest: &Manifest, records: &Records, findings: &mut Findings) {
    if records.claims_sha256 != manifest.claims_sha256 {
        findings.changed.push("the claims have changed".to_owned());
    }
    if records.evidence_sha256 != manifest.evidence_sha256 {
        findings
            .changed
            .push("the recorded evidence has changed".to_owned());
    }
    let mut now: BTreeMap<String, String> = records
        .assessed
        .iter()
        .map(|assessed| (assessed.id(), assessed.freshness.to_string()))
        .collect();
    for (id, then) in &manifest.records {
        match now.remove(id) {
            Some(words) if words == *then => findings.unchanged += 1,
            Some(words) => findings
                .stale
                .push(format!("{id}: {words} (in the case: {then})")),
            None => findings
                .stale
                .push(format!("{id}: no such record now (in the case: {then})")),
        }
    }
    for (id, words) in now {
        findings
            .changed
            .push(format!("{id}: {words} (not in the case)"));
    }
}
