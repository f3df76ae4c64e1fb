//! The assumptions: what no proof shows, and how to check it on the bench.

use std::collections::BTreeSet;

use passivity_evidence::Assumption;

use super::to_claim;
use crate::case::Case;
use crate::document::{Document, Line, Row};
use crate::gsn::{Anchor, Kind};

/// The assumptions that the arguments of this case stand on.
pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(
        2,
        "assumptions",
        "Assumptions, and how to check them on the bench",
    );
    document.say(
        "The proofs hold under these assumptions, and no proof shows them. Each comes with a way to \
         check it on the device. What the check found belongs in the file of the device, with the \
         date and the name of the person.",
    );
    let used = used(case);
    let rows = case.records.claims.assumptions.iter();
    let rows = rows.filter(|assumption| used.contains(assumption.id.as_str()));
    let columns = [
        ("Assumption", 17),
        ("What is assumed", 40),
        ("How to check it", 43),
    ];
    document.table(
        "Assumptions that this case stands on",
        &columns,
        rows.map(row).collect(),
    );
    recorded(document, case, &used);
}

/// What the recordings say of these assumptions.
fn recorded(document: &mut Document, case: &Case, used: &BTreeSet<&str>) {
    let seen = case.studies.iter().flat_map(|study| {
        let seen = study.observed().into_iter();
        seen.filter(|seen| used.contains(seen.assumption))
            .map(move |seen| (study, seen))
    });
    let rows: Vec<Row> = seen
        .map(|(study, seen)| {
            let anchor = Anchor::Assumption(seen.assumption.to_owned());
            let met = match seen.is_met {
                Some(true) => Line::text("met in the recording"),
                Some(false) => Line::strong("NOT met in the recording"),
                None => Line::strong("left open by the recording"),
            };
            let says = Line::text(format!("{} (", seen.says))
                .and(Line::link(
                    study.anchor("recorded"),
                    "Recordings of the device",
                ))
                .and(Line::text(")"));
            [Line::link(anchor.id(), anchor.title()), met, says].into()
        })
        .collect();
    if rows.is_empty() {
        return;
    }
    document.say(
        "The recordings of the device say this of the assumptions. A recording shows what happened \
         while it was made, and no more.",
    );
    let columns = [
        ("Assumption", 17),
        ("Found", 20),
        ("In which recording", 63),
    ];
    document.table("Assumptions in the recordings", &columns, rows);
}

/// In the annex: the claims that each assumption is made for, and the assumptions of claims that
/// this case does not rest on.
pub(super) fn write_others(document: &mut Document, case: &Case) {
    let used = used(case);
    let all = &case.records.claims.assumptions;
    let others = all.iter().filter(|a| !used.contains(a.id.as_str()));
    let columns = [
        ("Assumption", 17),
        ("What is assumed", 40),
        ("How to check it", 43),
    ];
    document.table(
        "Assumptions that only other claims are made under",
        &columns,
        others.map(row).collect(),
    );
    let rows = all.iter().map(|assumption| {
        let claims = case.records.claims.claims.iter();
        let users = claims.filter(|claim| claim.assumptions.contains(&assumption.id));
        let users = users.map(|claim| to_claim(case, &claim.id));
        [assumption.id.as_str().into(), Line::joined(users, ", ")].into()
    });
    let columns = [("Assumption", 17), ("Claims that are made under it", 83)];
    document.table("From assumptions to claims", &columns, rows.collect());
}

fn used(case: &Case) -> BTreeSet<&str> {
    let nodes = case.arguments.iter().flat_map(|argument| argument.nodes());
    nodes
        .filter(|node| node.kind == Kind::Assumption)
        .map(|node| node.id.as_str())
        .collect()
}

fn row(assumption: &Assumption) -> Row {
    Row {
        id: Some(Anchor::Assumption(assumption.id.clone()).id()),
        cells: vec![
            assumption.id.as_str().into(),
            assumption.sentence.as_str().into(),
            assumption.check.as_str().into(),
        ],
    }
}
