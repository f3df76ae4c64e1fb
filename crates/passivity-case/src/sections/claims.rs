//! The claims with their evidence, traceability both ways, and the assumptions.

use std::collections::BTreeMap;

use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::records::{Claim, Freshness, Records};

pub(super) fn write(document: &mut Document, case: &Case) {
    table(document, &case.records);
    caveats(document, &case.records);
    traceability(document, &case.records);
    assumptions(document, case);
}

fn to_claim(id: &str) -> Line {
    Line::link(format!("claim-{id}"), id)
}

fn table(document: &mut Document, records: &Records) {
    document.heading(2, "claims", "Claims and evidence");
    let rows = records.claims.iter().map(|claim| {
        let mut sentence = Line::default();
        if claim.refutes {
            sentence = sentence.and(Line::strong("Refuted as printed. "));
        }
        sentence = sentence.and(Line::text(&claim.sentence));
        if !claim.formula.is_empty() {
            sentence = sentence
                .and(Line::text(" "))
                .and(Line::code(&claim.formula));
        }
        let caveats = claim.caveats.iter().map(|id| to_caveat(records, id));
        Row {
            id: Some(format!("claim-{}", claim.id)),
            cells: vec![
                claim.id.as_str().into(),
                sentence,
                Line::joined(caveats, ", "),
                claim.standing().words().into(),
            ],
        }
    });
    let columns = [
        ("Claim", 14),
        ("What it says", 58),
        ("Caveats", 17),
        ("Stands", 11),
    ];
    document.table("What is claimed", &columns, rows.collect());
    document.say(
        "Below is every record of evidence. A record is fresh when the text of the claim and all \
         sources that it covers are as they were when it was made, stale when one of them has \
         changed, and not run here when there is no result.",
    );
    let rows = records.claims.iter().flat_map(|claim| {
        claim.evidence.iter().map(|evidence| {
            let tool = match evidence.tool.as_str() {
                "" => String::new(),
                tool => format!(", by {tool}"),
            };
            let found = format!("{}{tool}", evidence.result);
            let (result, state) = match &evidence.freshness {
                Freshness::NotRun(why) if why.is_empty() => (String::new(), "not run"),
                Freshness::NotRun(why) => (format!("because {why}"), "not run"),
                Freshness::Fresh => (found, "fresh"),
                Freshness::Stale(_) => (format!("{found}; {}", evidence.words()), "stale"),
                Freshness::Failed(_) => (format!("{found}; {}", evidence.words()), "failed"),
            };
            [
                to_claim(&claim.id),
                evidence.engine.words().into(),
                result.as_str().into(),
                state.into(),
            ]
            .into()
        })
    });
    let columns = [
        ("Claim", 14),
        ("Shown by", 17),
        ("Result, and on which domain", 58),
        ("Record", 11),
    ];
    document.table("What shows it", &columns, rows.collect());
}

/// A reference to a caveat; its mere id when the claims do not have it.
fn to_caveat(records: &Records, id: &str) -> Line {
    if records.caveats.contains_key(id) {
        Line::link(format!("caveat-{id}"), id)
    } else {
        Line::text(id)
    }
}

fn caveats(document: &mut Document, records: &Records) {
    let rows = records.caveats.iter().map(|(id, text)| Row {
        id: Some(format!("caveat-{id}")),
        cells: vec![id.as_str().into(), text.as_str().into()],
    });
    let columns = [("Caveat", 16), ("What the evidence does not say", 84)];
    document.table("Caveats of the evidence", &columns, rows.collect());
}

fn traceability(document: &mut Document, records: &Records) {
    document.heading(2, "traceability", "Traceability");
    let joined = |items: &[String]| Line::joined(items.iter().map(Line::code), ", ");
    let rows = records.claims.iter().map(|claim| {
        let engines = claim
            .evidence
            .iter()
            .map(|evidence| Line::code(&evidence.id));
        [
            to_claim(&claim.id),
            claim.equation.as_str().into(),
            joined(&claim.code),
            Line::joined(engines, ", "),
            claim.standing().words().into(),
        ]
        .into()
    });
    let columns = [
        ("Claim", 14),
        ("Equation", 14),
        ("Code", 34),
        ("Proof or test", 26),
        ("Stands", 12),
    ];
    document.table(
        "From claim to equation, code, proof or test, and result",
        &columns,
        rows.collect(),
    );
    let columns = [("Source", 60), ("Claims whose evidence covers it", 40)];
    let rows = backwards(records.claims.iter().flat_map(|claim| {
        let sources = claim
            .evidence
            .iter()
            .flat_map(|evidence| evidence.sources.keys());
        sources.map(move |source| (source, claim))
    }));
    document.table("Back from source files", &columns, rows);
    let columns = [("Kernel item", 60), ("Claims that it implements", 40)];
    let rows = backwards(
        records
            .claims
            .iter()
            .flat_map(|claim| claim.code.iter().map(move |code| (code, claim))),
    );
    document.table("Back from code", &columns, rows);
    let columns = [("Equation of the paper", 60), ("Claims", 40)];
    let rows = backwards(
        records
            .claims
            .iter()
            .filter(|c| !c.equation.is_empty())
            .map(|claim| (&claim.equation, claim)),
    );
    document.table("Back from the paper", &columns, rows);
    linkage(document, records);
}

/// A row for each thing that claims lead to, with the claims that lead there.
fn backwards<'a>(pairs: impl Iterator<Item = (&'a String, &'a Claim)>) -> Vec<Row> {
    let mut back: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (thing, claim) in pairs {
        let ids = back.entry(thing).or_default();
        if !ids.contains(&claim.id.as_str()) {
            ids.push(&claim.id);
        }
    }
    back.into_iter()
        .map(|(thing, ids)| {
            let claims = Line::joined(ids.into_iter().map(to_claim), ", ");
            [Line::code(thing), claims].into()
        })
        .collect()
}

fn linkage(document: &mut Document, records: &Records) {
    document.heading(
        3,
        "linkage",
        "Linked, partly linked, unlinked and unknown ids",
    );
    let linkage = records.linkage();
    let links = |ids: &[&str]| {
        if ids.is_empty() {
            Line::text("none")
        } else {
            Line::joined(ids.iter().map(|id| to_claim(id)), ", ")
        }
    };
    let unknown: Vec<&str> = linkage.unknown.iter().copied().collect();
    let unknown = if unknown.is_empty() {
        "none".to_owned()
    } else {
        unknown.join(", ")
    };
    let rows: Vec<Row> = vec![
        [
            "Linked".into(),
            "code and recorded evidence".into(),
            links(&linkage.linked),
        ]
        .into(),
        [
            "Partly linked".into(),
            "code or recorded evidence, not both".into(),
            links(&linkage.partly),
        ]
        .into(),
        [
            "Unlinked".into(),
            "neither".into(),
            links(&linkage.unlinked),
        ]
        .into(),
        [
            "Unknown".into(),
            "referred to, and no claim or assumption".into(),
            unknown.into(),
        ]
        .into(),
    ];
    let columns = [("Ids", 16), ("Have", 30), ("Which", 54)];
    document.table(
        "How claims hang together with code and evidence",
        &columns,
        rows,
    );
}

fn assumptions(document: &mut Document, case: &Case) {
    document.heading(
        2,
        "assumptions",
        "Assumptions, and how to check them on the bench",
    );
    document.say(
        "The proofs hold under these assumptions, and no proof shows them. Each comes with a way to \
         check it on the device; what the check found belongs into the file of the device, with the \
         date and the person.",
    );
    let records = &case.records;
    let rows = records.assumptions.iter().map(|assumption| {
        let users = records
            .claims
            .iter()
            .filter(|c| c.assumptions.contains(&assumption.id));
        let check = if assumption.check.is_empty() {
            "open: the claims name no check".to_owned()
        } else {
            assumption.check.clone()
        };
        Row {
            id: Some(format!("assumption-{}", assumption.id)),
            cells: vec![
                assumption.id.as_str().into(),
                assumption.sentence.as_str().into(),
                check.into(),
                Line::joined(users.map(|claim| to_claim(&claim.id)), ", "),
            ],
        }
    });
    let columns = [
        ("Assumption", 15),
        ("What is assumed", 30),
        ("How to check it", 33),
        ("Claims", 22),
    ];
    document.table("Assumptions", &columns, rows.collect());
}
