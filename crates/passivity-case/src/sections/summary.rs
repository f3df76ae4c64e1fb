//! What is claimed, and how it stands.

use super::to_claim;
use crate::case::Case;
use crate::document::{Block, Document, Line, Row};
use crate::gsn::{Argument, Standing};
use crate::records::Freshness;
use crate::study::Study;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "summary", "Summary and verdict");
    for (study, argument) in case.scenes() {
        let line = Line::strong(format!("{}: {}.", study.name(), study.report().headline()))
            .and(format!(" {}", sentence(study, argument)).into());
        document
            .blocks
            .push(Block::Verdict(study.is_passive(), line));
    }
    let rows = case
        .scenes()
        .map(|(study, argument)| row(case, study, argument))
        .collect();
    let head = [
        ("Scene", 24),
        ("Verdict", 22),
        ("Region", 18),
        ("Argument", 18),
        ("Rests on", 24),
    ];
    document.table("The scenes of this case", &head, rows);
    evidence(document, case);
    let open: Vec<Line> = case.objections().into_iter().map(Line::from).collect();
    if open.is_empty() {
        document.say("Nothing in this case is open, stale or missing.");
    } else {
        document.heading(3, "open", "What is not shown");
        document.say(
            "These points are open, stale, missing or defeated. With --strict, this case is refused \
             because of them.",
        );
        document.list(open);
    }
}

fn row(case: &Case, study: &Study, argument: &Argument) -> Row {
    let report = study.report();
    let because = report.because.iter().map(|id| to_claim(case, id));
    let region = report
        .region
        .map_or("depends", |region| region.name())
        .replace('_', " ");
    let standing = argument.top().standing.map_or("", Standing::words);
    Row {
        id: None,
        cells: vec![
            Line::link(study.anchor("scene"), study.name()),
            report.verdict.name().replace('_', " ").into(),
            region.into(),
            standing.into(),
            Line::joined(because, ", "),
        ],
    }
}

/// What the verdict and the argument come to.
fn sentence(study: &Study, argument: &Argument) -> &'static str {
    match (study.is_passive(), argument.top().standing) {
        (true, Some(Standing::Shown)) => "Every part of the argument is shown.",
        (true, Some(Standing::Stale)) => {
            "The argument is complete, but some evidence was recorded for other sources."
        }
        (true, _) => "Some part of the argument is open or was not run.",
        (false, Some(Standing::Defeated)) => "The top goal is defeated by an exact counterexample.",
        (false, _) => "The top goal is not shown.",
    }
}

fn evidence(document: &mut Document, case: &Case) {
    let mut counts = [0_usize; 4];
    for (_, evidence) in case.records.evidence() {
        let index = match evidence.freshness {
            Freshness::Fresh => 0,
            Freshness::Stale(_) => 1,
            Freshness::NotRun(_) => 2,
            Freshness::Failed(_) => 3,
        };
        counts[index] += 1;
    }
    let [fresh, stale, not_run, failed] = counts;
    let records = &case.records;
    document.say(format!(
        "{} claims, {} records of evidence: {fresh} fresh, {stale} stale, {not_run} not run here, \
         {failed} failed. They were compared with {}.",
        records.claims.len(),
        fresh + stale + not_run + failed,
        records.origin.words(),
    ));
    if let Some(mutation) = &records.mutation {
        document.say(mutation.as_str());
    }
}
