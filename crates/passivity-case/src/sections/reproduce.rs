//! How to reproduce the case, and the verdicts given so far.

use std::collections::{BTreeMap, BTreeSet};

use passivity_audit::{delimiter_name, legible, shell_word};
use passivity_evidence::{Claim, Sha256};

use crate::case::{Case, VERSION};
use crate::document::{Block, Document, Line, Row};
use crate::manifest::{Manifest, PAST};
use crate::recorded::Recorded;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "reproduce", "How to reproduce");
    let typed: Vec<String> = case
        .studies
        .iter()
        .map(|study| shell_word(&study.path.display().to_string()))
        .collect();
    let scenes = typed.join(" ");
    document.say(
        "With the sources at the commit below, these commands make the evidence, the verdict and \
         this case again, and compare this case with the sources:",
    );
    let explain = typed
        .iter()
        .map(|scene| format!("passivity explain {scene}\n"));
    let recordings = case
        .studies
        .iter()
        .filter_map(|study| study.recorded.as_ref());
    let written: fn(String) -> String = |word| format!(" \\\n    {word}");
    let options: String = recordings
        .flat_map(words)
        .chain(case.options.iter().cloned())
        .map(written)
        .collect();
    // Where the sources are is asked when a case is compared, too.
    let is_of_sources =
        |word: &&String| word.starts_with("--root ") || word.starts_with("--evidence ");
    let of_check = case.options.iter().filter(is_of_sources).cloned();
    let of_check: String = of_check.map(written).collect();
    document.blocks.push(Block::Listing(format!(
        "make prove\npassivity check {scenes}\n{}passivity case {scenes} --out case{options}\n\
         passivity case --check case{of_check}",
        explain.collect::<String>(),
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
            Line::hash(&case.records.claims_sha256),
        ]
        .into(),
        [
            "Recorded evidence".into(),
            case.records.evidence_from.as_str().into(),
        ]
        .into(),
        [
            "SHA-256 of the recorded evidence".into(),
            Line::hash(&case.records.evidence_sha256),
        ]
        .into(),
        [
            PAST.into(),
            Line::hash(&Manifest::of(case, &BTreeMap::new()).past()),
        ]
        .into(),
    ];
    for study in &case.studies {
        rows.push(
            [
                format!("SHA-256 of the scene {}", study.slug).into(),
                Line::hash(&study.sha256),
            ]
            .into(),
        );
        if let Some((name, bytes)) = &study.forces {
            let what = format!("SHA-256 of the forces {}", legible(name));
            rows.push([what.into(), Line::hash(&Sha256::of(bytes))].into());
        }
        for source in study.recorded.iter().flat_map(Recorded::sources) {
            let what = format!("SHA-256 of the log {}", source.name);
            rows.push([what.into(), Line::hash(&source.sha256)].into());
        }
    }
    document.table("Versions and hashes", &[("What", 35), ("Value", 65)], rows);
    sources(document, case);
    history(document, case);
}

/// The words of the command that give the recordings.
fn words(recorded: &Recorded) -> Vec<String> {
    let given = &recorded.given;
    let mut options: Vec<(&str, String)> = Vec::new();
    options.extend(given.logs.iter().map(|log| ("--log", log.path.clone())));
    let identification = given.identification.iter();
    options.extend(identification.map(|log| ("--identification", log.path.clone())));
    options.push(("--device", given.device.clone()));
    let dates = given.logs.iter().chain(&given.identification);
    let mut dates: Vec<String> = dates.map(|log| log.date.clone()).collect();
    if dates.iter().all(|date| Some(date) == dates.first()) {
        dates.truncate(1);
    }
    options.extend(dates.into_iter().map(|date| ("--date", date)));
    options.extend(given.columns.iter().map(|text| ("--columns", text.clone())));
    let delimiter = given.delimiter.map(delimiter_name);
    options.extend(delimiter.map(|text| ("--delimiter", text)));
    if !given.identification.is_empty() {
        options.push(("--count-error", given.count_error.to_string()));
        options.push(("--force-error", given.force_error.to_string()));
        let share = given.scale_error.map(|share| share.to_string());
        options.extend(share.map(|share| ("--scale-error", share)));
        let millions = given.effort.map(|effort| (effort / 1_000_000).to_string());
        options.extend(millions.map(|effort| ("--effort", effort)));
    }
    let mut words: Vec<String> = options
        .into_iter()
        .map(|(name, value)| format!("{name} {}", shell_word(&legible(&value))))
        .collect();
    if given.decimal_comma {
        words.push("--decimal-comma".to_owned());
    }
    words
}

/// The files that the evidence covers, each with its sum; files that no claim implements are in the
/// recorded evidence.
fn sources(document: &mut Document, case: &Case) {
    let claims = &case.records.claims.claims;
    let code: BTreeSet<String> = claims.iter().flat_map(Claim::files).collect();
    let mut sums: BTreeMap<&str, BTreeSet<Sha256>> = BTreeMap::new();
    let runs = &case.records.evidence.runs;
    for (path, sum) in runs.iter().flat_map(|run| &run.files) {
        sums.entry(path).or_default().insert(*sum);
    }
    let others = sums.keys().filter(|path| !code.contains(**path)).count();
    let rows = sums
        .into_iter()
        .filter(|(path, _)| code.contains(*path))
        .map(|(path, sums)| {
            let sums = sums.iter().map(Line::hash);
            [Line::code(path), Line::joined(sums, ", ")].into()
        });
    let columns = [("Source", 40), ("SHA-256 as recorded", 60)];
    document.table("Code that the evidence covers", &columns, rows.collect());
    document.say(format!(
        "The sums of {others} harnesses, queries, tests and theorems are in the recorded evidence."
    ));
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
            Line::code(past.scene_sha256.short()),
            Line::code(past.claims_sha256.short()),
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
