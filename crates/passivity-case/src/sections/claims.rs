//! The claims with their evidence.

use passivity_evidence::{Assessed, Engine, Freshness, Record};

use super::to_claim;
use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::gsn::Anchor;
use crate::records::Records;

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "claims", "Claims and evidence");
    claims(document, &case.records);
    open_points(document, case);
    evidence(document, case);
    caveats(document, &case.records);
}

fn claims(document: &mut Document, records: &Records) {
    let rows = records.claims.claims.iter().map(|claim| {
        let mut sentence = Line::default();
        if claim.refutes {
            sentence = sentence.and(Line::strong("Refuted as printed. "));
        }
        sentence = sentence.and(Line::text(&claim.sentence));
        if !claim.formula.is_empty() {
            sentence = sentence
                .and(Line::text(" "))
                .and(Line::strong(&claim.formula));
        }
        let caveats = claim.caveats.iter().map(|id| to_caveat(records, id));
        Row {
            id: Some(Anchor::Claim(claim.id.clone()).id()),
            cells: vec![
                claim.id.as_str().into(),
                sentence,
                Line::joined(caveats, ", "),
                records.standing(&claim.id).words().into(),
            ],
        }
    });
    let columns = [
        ("Claim", 15),
        ("What it says", 57),
        ("Caveats", 17),
        ("Stands", 11),
    ];
    document.table("What is claimed", &columns, rows.collect());
}

/// Every open point with all claims that it concerns; page one has them in short.
fn open_points(document: &mut Document, case: &Case) {
    let points: Vec<Line> = case
        .objections()
        .iter()
        .map(|objection| Line::text(objection.to_string()))
        .collect();
    document.heading(3, "open", "Open points");
    if points.is_empty() {
        document.say("Nothing in this case is open, stale, missing or defeated.");
        return;
    }
    document.say(
        "These points are open, stale, missing or defeated. With --strict, this case is refused \
         because of them.",
    );
    document.list(points);
}

fn evidence(document: &mut Document, case: &Case) {
    let records = &case.records;
    document.heading(3, "records", "Records of evidence");
    document.say(
        "A record is fresh when the text of the claim and all sources that it covers are as they \
         were when it was made, stale when one of them has changed, and not run here when there is \
         no result.",
    );
    let rows = Engine::ALL.into_iter().filter_map(|engine| {
        let tools = records.tools(engine);
        (!tools.is_empty()).then(|| -> Row { [engine.words().into(), tools.into()].into() })
    });
    let columns = [("Engine", 30), ("Tools that made the evidence", 70)];
    document.table("The engines", &columns, rows.collect());
    let rows = records.assessed.iter().map(|assessed| {
        let (result, state) = found(records, assessed);
        [
            to_claim(case, &assessed.claim),
            assessed.engine.words().into(),
            result.into(),
            state.into(),
        ]
        .into()
    });
    let columns = [
        ("Claim", 15),
        ("Shown by", 17),
        ("Result, and on which domain", 57),
        ("Record", 11),
    ];
    document.table("What shows it", &columns, rows.collect());
}

/// The result of a record with its domain, and how the record stands.
fn found(records: &Records, assessed: &Assessed) -> (String, &'static str) {
    let refutes = records
        .claims
        .find(&assessed.claim)
        .is_some_and(|claim| claim.refutes);
    let result = assessed.record.as_ref().map_or_else(String::new, |record| {
        result(record, assessed.engine, refutes)
    });
    match &assessed.freshness {
        Freshness::NotRun(why) => (format!("because {why}"), "not run"),
        Freshness::Fresh => (result, "fresh"),
        Freshness::Stale(_) => (format!("{result}; {}", assessed.freshness), "stale"),
        Freshness::Failed(_) => (assessed.freshness.to_string(), "failed"),
    }
}

fn result(record: &Record, engine: Engine, refutes: bool) -> String {
    let mut text = record.outcome.words();
    if let Some(part) = &record.scope {
        text.push_str(&format!(" for {part}"));
    }
    if !record.domains.is_empty() {
        let domains = record.domains.join("; ");
        // What the solvers are asked of a false statement is that statement, and they answer with a
        // model.
        let refuted = if engine == Engine::Smt && refutes {
            "refuted: "
        } else {
            ""
        };
        text.push_str(&format!(" ({refuted}{domains})"));
    }
    text
}

/// A reference to a caveat; its mere id when the claims do not have it.
fn to_caveat(records: &Records, id: &str) -> Line {
    if records.claims.caveat(id).is_some() {
        Line::link(format!("caveat-{id}"), id)
    } else {
        Line::text(id)
    }
}

fn caveats(document: &mut Document, records: &Records) {
    let rows = records.claims.caveats.iter().map(|caveat| Row {
        id: Some(format!("caveat-{}", caveat.id)),
        cells: vec![caveat.id.as_str().into(), caveat.text.as_str().into()],
    });
    let columns = [("Caveat", 17), ("What the evidence does not say", 83)];
    document.table("Caveats of the evidence", &columns, rows.collect());
}
