//! How to reproduce the case, and the verdicts given so far.

use std::collections::BTreeMap;

use crate::case::{Case, VERSION};
use crate::document::{Block, Document, Line, Row};

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "reproduce", "How to reproduce");
    let scenes: Vec<String> = case
        .studies
        .iter()
        .map(|study| study.path.display().to_string())
        .collect();
    let scenes = scenes.join(" ");
    document.say("With the sources at the commit below, these commands make the evidence, the verdict and this case again, and compare this case with the sources:");
    document.blocks.push(Block::Listing(format!(
        "make prove\npassivity check {scenes}\npassivity explain {}\npassivity case {scenes} --out \
         case\npassivity case --check case",
        case.studies
            .first()
            .map(|s| s.path.display().to_string())
            .unwrap_or_default()
    )));
    let commit = match &case.records.commit {
        Some(commit) => Line::code(commit),
        None => "not known here".into(),
    };
    let mut rows: Vec<Row> = vec![
        ["passivity".into(), VERSION.into()].into(),
        ["Commit of the sources".into(), commit].into(),
        [
            "SHA-256 of the claims".into(),
            Line::code(&case.records.claims_sha256),
        ]
        .into(),
        [
            "SHA-256 of the recorded evidence".into(),
            Line::code(&case.records.evidence_sha256),
        ]
        .into(),
    ];
    for study in &case.studies {
        rows.push(
            [
                format!("SHA-256 of the scene {}", study.slug).into(),
                Line::code(&study.sha256),
            ]
            .into(),
        );
    }
    document.table("Versions and hashes", &[("What", 35), ("Value", 65)], rows);
    let mut sources: BTreeMap<&str, &str> = BTreeMap::new();
    for (_, evidence) in case.records.evidence() {
        sources.extend(
            evidence
                .sources
                .iter()
                .map(|(path, hash)| (path.as_str(), hash.as_str())),
        );
    }
    let rows = sources
        .into_iter()
        .map(|(path, hash)| [Line::code(path), Line::code(hash)].into());
    let columns = [("Source", 40), ("SHA-256 as recorded", 60)];
    document.table("Sources that the evidence covers", &columns, rows.collect());
    tools(document, case);
    history(document, case);
}

fn tools(document: &mut Document, case: &Case) {
    let mut tools: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (_, evidence) in case.records.evidence() {
        let engines = tools.entry(&evidence.tool).or_default();
        if !engines.contains(&evidence.engine.words()) {
            engines.push(evidence.engine.words());
        }
    }
    tools.remove("");
    let rows = tools
        .into_iter()
        .map(|(tool, engines)| [tool.into(), engines.join(", ").into()].into());
    document.table(
        "Tools that made the evidence",
        &[("Tool", 50), ("Engine", 50)],
        rows.collect(),
    );
}

fn history(document: &mut Document, case: &Case) {
    document.heading(2, "history", "History of the verdicts");
    document.say(
        "A line for each change of the scene, the claims, the version or the verdict since this \
         folder was first written.",
    );
    let rows = case.history.iter().enumerate().map(|(index, past)| {
        [
            (index + 1).to_string().into(),
            past.scene.as_str().into(),
            past.headline.as_str().into(),
            past.version.as_str().into(),
            Line::code(short(&past.scene_sha256)),
            Line::code(short(&past.claims_sha256)),
        ]
        .into()
    });
    let columns = [
        ("No.", 6),
        ("Scene", 22),
        ("Verdict", 32),
        ("Version", 10),
        ("Scene file", 15),
        ("Claims", 15),
    ];
    document.table(
        "Verdicts given in this folder, oldest first; hashes by their first twelve digits",
        &columns,
        rows.collect(),
    );
}

fn short(hash: &str) -> &str {
    hash.get(..12).unwrap_or(hash)
}
