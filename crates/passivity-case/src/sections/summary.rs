//! The first page: what is claimed, what is shown, and what is not.

use passivity_evidence::Freshness;

use super::to_claim;
use crate::case::Case;
use crate::document::{Block, Document, Line, Row};
use crate::gsn::{Argument, Standing};
use crate::info::Info;
use crate::study::Study;
use passivity_scene::check::Verdict;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "summary", "Summary and verdict");
    people(document, case.info.as_ref());
    for (study, argument) in case.scenes() {
        let line = Line::strong(format!("{}: {}.", study.name(), study.report().headline()))
            .and(format!(" {}", sentence(study, argument)).into());
        document
            .blocks
            .push(Block::Verdict(study.is_passive(), line));
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

/// What the verdict and the argument come to.
fn sentence(study: &Study, argument: &Argument) -> &'static str {
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
    let records = &case.records;
    let fresh = records.assessed.iter();
    let fresh = fresh.filter(|a| a.freshness == Freshness::Fresh).count();
    let claims = &records.claims.claims;
    let shown = claims.iter();
    let shown = shown.filter(|c| records.standing(&c.id) == Standing::Shown);
    items.push(
        Line::text(format!(
            "{} of {} claims are shown, by {fresh} fresh records of evidence (",
            shown.count(),
            claims.len(),
        ))
        .and(Line::link("claims", "Claims and evidence"))
        .and(format!("). They were compared with {}.", records.origin.words()).into()),
    );
    if let Some(run) = &records.evidence.mutation {
        let (caught, mutants) = (run.caught, run.mutants);
        let since = if records.mutation_changes.is_empty() {
            ""
        } else {
            "; the sources have changed since"
        };
        items.push(Line::text(format!(
            "The tests noticed {caught} of {mutants} changes that were made to the kernel on trial \
             ({}){since}.",
            run.tool
        )));
    }
    items
}

fn shown_of(study: &Study, argument: &Argument) -> Option<Line> {
    let name = study.name();
    match (study.report().verdict, argument.standing()) {
        (Verdict::Passive, _) => Some(Line::text(format!(
            "«{name}»: {}, whatever the operator does, the hand draws no more energy than was stored \
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
                "«{name}»: anything about other motions than {}.",
                study.speeds()
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
    items.push(Line::text(
        "That the device has the parameters of the scene file, and that its software does what the \
         scene describes.",
    ));
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
