//! A scene under study: its file, what was checked, and where each parameter comes from.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use passivity_audit::{is_placeholder, legible};
use passivity_core::Parameter;
use passivity_evidence::Sha256;
use passivity_scene::check::{Report, Verdict};
use passivity_scene::explain::{Explanation, explain};
use passivity_scene::parse::MAX_SAMPLE_BYTES;
use passivity_scene::{Given, Scene};

use crate::criterion::Criterion;
use crate::document::slug;
use crate::error::CaseError;
use crate::files::read_bytes;
use crate::gsn::{Anchor, Argument};
use crate::recorded::{Observed, Outcome, Recorded};

/// A scene with its check and the text of its file.
#[derive(Clone, Debug)]
pub struct Study {
    /// The scene.
    pub scene: Scene,
    /// The derivation and the check that it ends in.
    pub explanation: Explanation,
    /// The text of the file.
    pub text: String,
    /// Where it was read.
    pub path: PathBuf,
    /// SHA-256 of the file.
    pub sha256: Sha256,
    /// The name in ids and file names, of its own among the scenes of a case.
    pub slug: String,
    /// The file of the operator's forces, where the scene names one: its name and what is in it.
    pub forces: Option<(String, Vec<u8>)>,
    /// What was recorded of the device, where the case has it as evidence.
    pub recorded: Option<Recorded>,
}

/// Where a parameter's value comes from, as far as the scene file says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Source {
    /// A comment at the parameter.
    Comment(String),
    /// The logs from which it was identified.
    Identified,
    /// The comment at the head of the file, which speaks of all parameters.
    Head,
    /// The file does not say.
    None,
}

impl Study {
    /// Reads and checks a scene.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, or is no scene: with the scene's own diagnostics.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let read = Scene::read_with_text(path);
        let (scene, text) = read.map_err(|error| CaseError::new(error.to_string()))?;
        let mut study = Self::new(scene, text, path);
        if let Some(forces) = &study.scene.forces {
            let name = forces.path.clone();
            // A copy of the scene finds it by the same name.
            if Path::new(&name).file_name() != Some(OsStr::new(&name)) {
                let what = format!(
                    "`operator.force`: `{}` is not in the folder of the scene, and a case keeps a copy of both side by \
                     side: put it there",
                    legible(&name)
                );
                return Err(CaseError::within(path, what));
            }
            let bytes = read_bytes(&path.with_file_name(&name), MAX_SAMPLE_BYTES)?;
            study.forces = Some((name, bytes));
        }
        Ok(study)
    }

    /// Checks a scene that was read from `text`.
    #[must_use]
    pub fn new(scene: Scene, text: String, path: &Path) -> Self {
        Self {
            explanation: explain(&scene),
            sha256: Sha256::of(text.as_bytes()),
            slug: match path.file_stem() {
                Some(name) => slug(&name.to_string_lossy()),
                None => slug(&scene.name),
            },
            path: path.to_owned(),
            forces: None,
            recorded: None,
            text,
            scene,
        }
    }

    /// The name of the file, without its folder.
    #[must_use]
    pub fn file_name(&self) -> String {
        let name = self.path.file_name().unwrap_or(self.path.as_os_str());
        name.to_string_lossy().into_owned()
    }

    /// The check.
    #[must_use]
    pub fn report(&self) -> &Report {
        &self.explanation.report
    }

    /// What the scene is called.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.scene.name
    }

    /// Whether the wall was shown to be passive.
    #[must_use]
    pub fn is_passive(&self) -> bool {
        self.report().verdict == Verdict::Passive
    }

    /// Whether the verdict is about some speeds only.
    #[must_use]
    pub fn has_speed_limit(&self) -> bool {
        let report = self.report();
        report.speed_bound.is_some() && !report.at_every_speed
    }

    /// At which speeds the verdict was asked: `at every speed`, or up to a bound.
    #[must_use]
    pub fn speeds(&self) -> String {
        self.report().speeds_text()
    }

    /// The criterion with the numbers of the scene, over the tolerances.
    #[must_use]
    pub fn criterion(&self) -> Criterion {
        Criterion::of(&self.scene)
    }

    /// The id of one of this scene's elements in the document.
    #[must_use]
    pub fn anchor(&self, element: &str) -> String {
        format!("{}-{element}", self.slug)
    }

    /// One of this scene's sections in the document.
    #[must_use]
    pub fn section(&self, element: &str, title: &'static str) -> Anchor {
        Anchor::Section(self.anchor(element), title)
    }

    /// What the scene file says at its head.
    #[must_use]
    pub fn head(&self) -> String {
        let lines = self
            .text
            .lines()
            .map_while(|line| line.trim().strip_prefix('#'))
            .filter(|line| !is_no_source(line));
        let paragraphs: Vec<String> = lines
            .collect::<Vec<_>>()
            .split(|line| line.trim().is_empty())
            .map(|lines| lines.iter().map(|l| l.trim()).collect::<Vec<_>>().join(" "))
            .filter(|paragraph| !paragraph.is_empty())
            .collect();
        paragraphs.join("\n")
    }

    /// What the recordings of the device come to as evidence, each by itself.
    #[must_use]
    pub fn outcomes(&self) -> Vec<Outcome> {
        let recorded = self.recorded.as_ref();
        recorded.map_or_else(Vec::new, |recorded| recorded.outcomes(&self.scene))
    }

    /// Whether a recording of the device contradicts the scene or its verdict.
    #[must_use]
    pub fn is_contradicted(&self) -> bool {
        let mut outcomes = self.outcomes().into_iter();
        outcomes.any(|outcome| matches!(outcome, Outcome::Contradicts(_)))
    }

    /// What the recordings say of the assumptions of the proofs.
    #[must_use]
    pub fn observed(&self) -> Vec<Observed> {
        let recorded = self.recorded.as_ref();
        recorded.map_or_else(Vec::new, |recorded| recorded.observed(&self.scene))
    }

    /// The assumptions of the argument that a recording shows not to be met.
    #[must_use]
    pub fn unmet(&self, argument: &Argument) -> Vec<Observed> {
        let mut observed = self.observed();
        observed
            .retain(|seen| seen.is_met == Some(false) && argument.node(seen.assumption).is_some());
        observed
    }

    /// Whether a parameter was identified from logs, and the scene and its verdict agree with that.
    fn is_identified(&self, parameter: Parameter) -> bool {
        let recorded = self.recorded.as_ref();
        let identification = recorded.and_then(|recorded| recorded.identification.as_ref());
        identification.is_some_and(|found| {
            let mut compared = found.compared.iter();
            found.outcome() == Outcome::Supports && compared.any(|c| c.parameter == parameter)
        })
    }

    /// Where the value of a parameter comes from: a comment on its line, or on the lines just
    /// above it, or logs from which it was identified, or the head of the file.
    #[must_use]
    pub fn source(&self, parameter: Parameter, given: &Given) -> Source {
        match self.source_at(given.span.start) {
            Source::Comment(comment) => Source::Comment(comment),
            _ if self.is_identified(parameter) => Source::Identified,
            other => other,
        }
    }

    /// Where what the file says at a place comes from, but for logs.
    pub(crate) fn source_at(&self, at: usize) -> Source {
        match self.comment_at(at) {
            Some(lines) if is_open(&lines) => Source::None,
            Some(lines) => Source::Comment(lines.join(" ")),
            None if is_placeholder(&self.head()) => Source::None,
            None => Source::Head,
        }
    }

    /// The lines of the comment at a place of the file, or just above it: of what `identify` wrote above a number, which
    /// says where that is from, all of it, before what stands behind the number and may be older.
    fn comment_at(&self, at: usize) -> Option<Vec<&str>> {
        let start = self.text.get(..at)?.rfind('\n').map_or(0, |i| i + 1);
        let line = self.text.get(start..)?.lines().next()?;
        let behind = trailing_comment(line).filter(|comment| !comment.is_empty());
        let mut lines = self.comment_above(start);
        let is_identified = passivity_identify::remarks(lines.iter().copied()).len() < lines.len();
        if behind.is_some() && !is_identified {
            lines.clear();
        }
        lines.extend(behind);
        (!lines.is_empty()).then_some(lines)
    }

    /// The lines of the comment just above a line, but for the head of the file, which speaks of all of it: that ends with
    /// the first line that is no comment.
    fn comment_above(&self, start: usize) -> Vec<&str> {
        let above = self.text.get(..start).unwrap_or_default();
        if above.lines().all(|line| line.trim().starts_with('#')) {
            return Vec::new();
        }
        let mut lines: Vec<&str> = above
            .lines()
            .rev()
            .map_while(|line| line.trim().strip_prefix('#'))
            .filter(|line| !line.starts_with(':'))
            .map(str::trim)
            .collect();
        lines.reverse();
        lines
    }
}

/// Whether somebody wrote in a comment that it is still to be done, and so that there is no source. What `identify` wrote
/// is one, whatever the device is called.
fn is_open(comment: &[&str]) -> bool {
    let said = passivity_identify::remarks(comment.iter().copied());
    let is_identified = said.len() < comment.len();
    !(is_identified && said.is_empty()) && is_placeholder(&said.join(" "))
}

/// Whether a line of a scene's head surely says nothing of where numbers are from: it speaks to editors, as
/// `#:schema scene.schema.json` does, or of who owns the file and on what terms others may use it.
fn is_no_source(line: &str) -> bool {
    const RIGHTS: [&str; 10] = [
        "copyright",
        "©",
        "(c) 1",
        "(c) 2",
        "spdx-",
        "all rights reserved",
        "licen",
        "permission is hereby granted",
        "use of this source code",
        "warrant",
    ];
    let lower = line.to_lowercase();
    line.starts_with(':') || RIGHTS.iter().any(|words| lower.contains(words))
}

/// The comment at the end of a line of TOML: after the first `#` outside quotes.
fn trailing_comment(line: &str) -> Option<&str> {
    let mut quote = None;
    for (index, letter) in line.char_indices() {
        match (quote, letter) {
            (None, '#') => return Some(line.get(index + 1..)?.trim()),
            (None, '"' | '\'') => quote = Some(letter),
            (Some(open), close) if open == close => quote = None,
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# Measured on our bench.\n\n[dimensionless]\n\
        mu = \"50\" # m, \"scales\"\n# From the data sheet,\n# page 3.\nbeta = \"3/5\"\nsigma = \"3/5\"\n";

    fn study(text: &str) -> Study {
        let scene = Scene::from_toml("a # scene", text).expect("a scene");
        Study::new(scene, text.to_owned(), Path::new("dir/a b.toml"))
    }

    #[test]
    fn sources_are_the_comments_of_the_file() {
        let study = study(TEXT);
        let source = |key: &str| {
            let parameters = study.scene.parameters();
            let given = parameters.into_iter().find(|(_, g)| g.key == key);
            let (parameter, given) = given.expect(key);
            study.source(parameter, given)
        };
        assert_eq!(
            source("dimensionless.mu"),
            Source::Comment("m, \"scales\"".to_owned())
        );
        let sheet = "From the data sheet, page 3.".to_owned();
        assert_eq!(source("dimensionless.beta"), Source::Comment(sheet));
        assert_eq!(source("dimensionless.sigma"), Source::Head);
        assert_eq!(study.head(), "Measured on our bench.");
        assert_eq!(study.slug, "a-b");
        assert!(study.unsourced().is_empty());
    }

    #[test]
    fn a_file_without_comments_has_no_sources() {
        let study = study("[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n");
        assert!(
            study.unsourced().contains(&"dimensionless.beta".to_owned()),
            "{:?}",
            study.unsourced()
        );
    }

    #[test]
    fn a_comment_that_is_still_to_be_written_is_no_source() {
        for (text, open) in [
            (
                "# TODO\n[dimensionless]\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n",
                3,
            ),
            (
                "# Measured.\n[dimensionless]\nmu = \"50\" # TODO: weigh it\nbeta = \"3/5\"\nsigma = \"3/5\" # ?\n",
                2,
            ),
        ] {
            assert_eq!(study(text).unsourced().len(), open, "{text}");
        }
    }

    #[test]
    fn what_speaks_to_editors_or_of_rights_is_no_source() {
        let numbers = "[dimensionless]\n#:schema s\nmu = \"50\"\nbeta = \"3/5\"\nsigma = \"3/5\"\n";
        let silent = study(&format!("#:schema scene.schema.json\n{numbers}"));
        assert_eq!((silent.head().as_str(), silent.unsourced().len()), ("", 3));
        let sourced = study(&format!(
            "#:schema scene.schema.json\n# Measured.\n{numbers}"
        ));
        assert_eq!(sourced.head(), "Measured.");
        assert!(sourced.unsourced().is_empty());
        for rights in [
            "Copyright 2026 ACME. All rights reserved.",
            "© ACME",
            "SPDX-License-Identifier: MIT",
            "Licensed under the Apache License, Version 2.0",
            "(c) 2026 ACME",
            "Licence: MIT",
            "you may not use this file except in compliance with the License.",
            "Use of this source code is governed by a BSD-style",
            "WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.",
        ] {
            let owned = study(&format!("# {rights}\n#\n{numbers}"));
            assert_eq!((owned.head().as_str(), owned.unsourced().len()), ("", 3));
            let sourced = study(&format!("# {rights}\n# Measured.\n{numbers}"));
            assert_eq!(sourced.head(), "Measured.");
            assert!(sourced.unsourced().is_empty());
        }
    }

    #[test]
    fn no_sketch_has_a_source() {
        use passivity_scene::parse::Sketch;
        for sketch in [Sketch::Rotary, Sketch::Linear, Sketch::Dimensionless] {
            let study = study(sketch.text());
            let given = study.scene.parameters().len();
            assert_eq!(study.unsourced().len(), given, "{:?}", study.unsourced());
        }
    }

    #[test]
    fn a_hash_within_quotes_is_no_comment() {
        assert_eq!(trailing_comment(r#"name = "a # b" # c"#), Some("c"));
        assert_eq!(trailing_comment(r#"name = "a # b""#), None);
    }
}
