//! The first page: what is claimed, what is shown, and what is not.

use super::to_claim;
use crate::case::Case;
use crate::document::{Block, Document, Line, Row};
use crate::gsn::{Argument, Standing};
use crate::info::Info;
use crate::recorded::Outcome;
use crate::records::{Records, Strength};
use crate::study::Study;
use passivity_scene::check::Verdict;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "summary", "Summary and verdict");
    people(document, case.info.as_ref());
    for (study, argument) in case.scenes() {
        let line = Line::strong(format!("{}: {}.", study.name(), study.report().headline()))
            .and(format!(" {}", sentence(study, argument)).into());
        let is_good = study.is_passive() && !study.is_contradicted();
        document.blocks.push(Block::Verdict(is_good, line));
        for line in against(study) {
            document.blocks.push(Block::Verdict(false, line));
        }
    }
    document.blocks.push(Block::Beside([
        ("What is shown".to_owned(), shown(case)),
        ("What is not shown".to_owned(), not_shown(case)),
    ]));
    if case.studies.len() > 1 {
        scenes(document, case);
    }
}

/// Who wrote the case, for which use, and who approved it.
fn people(document: &mut Document, info: Option<&Info>) {
    let none = Info::default();
    let fields = info.unwrap_or(&none).fields();
    let label = |name: &str| match name {
        "author" => Some("Author"),
        "reviewer" => Some("Reviewer"),
        "approval" => Some("Approval"),
        "intended_use" => Some("Intended use"),
        "date" => Some("Date"),
        _ => None,
    };
    let fields: Vec<(&str, Option<String>)> = fields
        .into_iter()
        .filter_map(|(name, value)| Some((label(name)?, value)))
        .collect();
    if fields.iter().all(|(_, value)| value.is_none()) {
        document.say("Author, reviewer, approval, intended use and date were not given.");
        return;
    }
    let rows = fields.into_iter().map(|(label, value)| {
        let value = value.unwrap_or_else(|| "not given".to_owned());
        [label.into(), value.into()].into()
    });
    let columns = [("Field", 25), ("As given", 75)];
    document.table("This document", &columns, rows.collect());
}

/// What in the recordings of the device does not support the case.
fn against(study: &Study) -> Vec<Line> {
    let Some(recorded) = &study.recorded else {
        return Vec::new();
    };
    let logs = recorded.logs.iter().map(|log| {
        let name = format!("Log «{}»", log.source.name);
        (name, log.outcome(&study.scene))
    });
    let identification = recorded.identification.iter();
    let identification =
        identification.map(|found| ("Identified friction".to_owned(), found.outcome()));
    let all = logs.chain(identification);
    let not_supporting = all.filter_map(|(name, outcome)| {
        let word = match &outcome {
            Outcome::Supports => return None,
            Outcome::Open(_) => "leaves the case open",
            Outcome::Contradicts(_) => "contradicts the case",
        };
        let why = outcome.because().unwrap_or_default();
        let says = Line::strong(format!("{name} {word}: ")).and(format!("{why} (").into());
        let to = Line::link(study.anchor("recorded"), "Recordings of the device");
        Some(says.and(to).and(").".into()))
    });
    not_supporting.collect()
}

/// What the recordings of the device show where they support the case.
fn supporting(study: &Study) -> Vec<Line> {
    let Some(recorded) = &study.recorded else {
        return Vec::new();
    };
    let (name, device) = (study.name(), recorded.device());
    let mut items = Vec::new();
    for log in &recorded.logs {
        if log.outcome(&study.scene) == Outcome::Supports {
            let (file, date) = (&log.source.name, &log.source.date);
            let form = log.form_text().map(|form| format!(" The file is {form}."));
            items.push(Line::text(format!(
                "«{name}»: the log «{file}» of the device «{device}» ({date}; both as given), {} samples: {}.{}",
                log.report.samples,
                log.headline(),
                form.unwrap_or_default()
            )));
        }
    }
    let identification = recorded.identification.iter();
    for found in identification.filter(|found| found.outcome() == Outcome::Supports) {
        items.push(Line::text(format!(
            "«{name}»: the friction that was identified from {} samples of the device «{device}» (as given) \
             agrees with the scene, and all of its range has the same verdict.",
            found.report.samples
        )));
    }
    items
}

/// What the verdict and the argument come to.
fn sentence(study: &Study, argument: &Argument) -> &'static str {
    if study.is_passive() && study.is_contradicted() {
        return "That is the verdict for the scene as written; recordings of the device contradict it, and \
                the argument is not supported.";
    }
    match (study.is_passive(), argument.standing()) {
        (true, Standing::Shown) => "Every part of the argument is shown.",
        (true, Standing::Stale) => {
            "The argument is complete, but some evidence was recorded for other sources."
        }
        (true, _) => "Some part of the argument is open or was not run.",
        (false, Standing::Defeated) => "The top goal is defeated by an exact counterexample.",
        (false, _) => "The top goal is not shown.",
    }
}

fn shown(case: &Case) -> Vec<Line> {
    let mut items: Vec<Line> = case.scenes().filter_map(|(s, a)| shown_of(s, a)).collect();
    items.extend(case.studies.iter().flat_map(supporting));
    let records = &case.records;
    let fresh = records.fresh();
    items.push(
        Line::text(format!(
            "{}, by {fresh} fresh records of evidence (",
            counted(records)
        ))
        .and(Line::link("claims", "Claims and evidence"))
        .and(
            format!(
                "). Recorded evidence: {}; it was compared with {}.",
                records.evidence_from,
                records.origin.words()
            )
            .into(),
        ),
    );
    if let Some(run) = &records.evidence.mutation {
        let (caught, mutants) = (run.caught, run.mutants);
        let since = if records.mutation_changes.is_empty() {
            ""
        } else {
            "; the sources have changed since"
        };
        items.push(Line::text(format!(
            "To try the tests, the kernel was changed on purpose in {mutants} ways, one at a time: in \
             {caught} of them a test failed, as it should ({}){since}.",
            run.tool
        )));
    }
    items
}

/// How many claims are shown, by the kind of evidence: a proof is more than a test.
fn counted(records: &Records) -> String {
    let claims = &records.claims.claims;
    let strengths: Vec<_> = claims.iter().map(|c| records.strength(&c.id)).collect();
    let kinds = Strength::ALL.into_iter().map(Some).chain([None]);
    let counts = kinds.filter_map(|kind| {
        let count = strengths.iter().filter(|found| **found == kind).count();
        let words = kind.map_or("not shown", Strength::words);
        (count > 0).then(|| format!("{count} {words}"))
    });
    let counts: Vec<String> = counts.collect();
    format!("Of {} claims: {}", claims.len(), counts.join(", "))
}

fn shown_of(study: &Study, argument: &Argument) -> Option<Line> {
    let name = study.name();
    let as_written = match study.is_contradicted() {
        true => ", if the device were as the scene file says",
        false => "",
    };
    match (study.report().verdict, argument.standing()) {
        (Verdict::Passive, _) => Some(Line::text(format!(
            "«{name}»{as_written}: {}, whatever the operator does, the hand draws no more energy than was stored \
             at the start. This holds for every value of the parameters within their tolerances.",
            study.speeds()
        ))),
        (Verdict::NotPassive, _) => Some(Line::text(format!(
            "«{name}» is not passive: a cycle of motion draws energy from it, as often as it is \
             repeated."
        ))),
        _ => None,
    }
}

fn not_shown(case: &Case) -> Vec<Line> {
    let mut items = Vec::new();
    for objection in case.objections() {
        items.push(Line::text(objection.short()));
    }
    for study in &case.studies {
        let report = study.report();
        if study.is_passive() && study.has_speed_limit() {
            let name = study.name();
            items.push(Line::text(format!(
                "«{name}»: anything about motions faster than {}.",
                report.speed_bound_text()
            )));
        }
        let effects: Vec<&str> = report.not_covered.iter().map(|e| e.words()).collect();
        if !effects.is_empty() {
            let (name, effects) = (study.name(), effects.join("; "));
            items.push(Line::text(format!(
                "«{name}»: what these effects do, which no theorem covers: {effects}."
            )));
        }
    }
    items.push(
        Line::text("That the device meets the assumptions of the proofs: each has to be checked on the bench (")
            .and(Line::link("assumptions", "Assumptions"))
            .and(").".into()),
    );
    let beyond = match case.studies.iter().any(|study| study.recorded.is_some()) {
        true => ", beyond what was recorded of it",
        false => "",
    };
    items.push(Line::text(format!(
        "That the device has the parameters of the scene file, and that its software does what the \
         scene describes{beyond}.",
    )));
    items.push(
        Line::text("Safety from any other hazard than energy that the display injects (")
            .and(Line::link("hazards", "Hazards"))
            .and(", ".into())
            .and(Line::link("limits", "Limits"))
            .and(").".into()),
    );
    items
}

fn scenes(document: &mut Document, case: &Case) {
    let rows = case
        .scenes()
        .map(|(study, argument)| row(case, study, argument))
        .collect();
    let head = [
        ("Scene", 26),
        ("Verdict", 18),
        ("Region", 18),
        ("Argument", 14),
        ("Rests on", 24),
    ];
    document.table("The scenes of this case", &head, rows);
}

fn row(case: &Case, study: &Study, argument: &Argument) -> Row {
    let report = study.report();
    let because = report.because.iter().map(|id| to_claim(case, id));
    let region = report
        .region
        .map_or("depends", |region| region.name())
        .replace('_', " ");
    [
        Line::link(study.anchor("scene"), study.name()),
        report.verdict.name().replace('_', " ").into(),
        region.into(),
        argument.standing().words().into(),
        Line::joined(because, ", "),
    ]
    .into()
}
