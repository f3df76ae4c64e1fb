//! Traceability: from claims to equations, code and evidence, and back.

use std::collections::BTreeMap;

use crate::document::{Document, Line, Row};
use crate::gsn::Anchor;
use crate::records::Records;

pub(super) fn write(document: &mut Document, records: &Records) {
    document.heading(2, "traceability", "Traceability");
    forwards(document, records);
    let claims = &records.claims.claims;
    let columns = [("Source", 60), ("Claims whose code is in it", 40)];
    let files = claims.iter().flat_map(|claim| {
        let files = claim.files().into_iter();
        files.map(|file| (file, claim.id.as_str()))
    });
    document.table("Back from source files", &columns, backwards(files));
    let columns = [("Kernel item", 60), ("Claims that it implements", 40)];
    let items = claims.iter().flat_map(|claim| {
        let items = claim.code.iter();
        items.map(|item| (item.to_string(), claim.id.as_str()))
    });
    document.table("Back from code", &columns, backwards(items));
    let columns = [("Equation of the paper", 60), ("Claims", 40)];
    let equations = claims
        .iter()
        .map(|claim| (claim.equation.clone(), claim.id.as_str()));
    document.table("Back from the paper", &columns, backwards(equations));
    linkage(document, records);
}

fn to_claim(id: &str) -> Line {
    Line::link(Anchor::Claim(id.to_owned()).id(), id)
}

fn forwards(document: &mut Document, records: &Records) {
    let rows = records.claims.claims.iter().map(|claim| {
        let code = claim.code.iter().map(|item| Line::code(item.to_string()));
        let engines = records
            .of_claim(&claim.id)
            .map(|a| Line::code(a.engine.name()));
        [
            to_claim(&claim.id),
            claim.equation.as_str().into(),
            Line::joined(code, ", "),
            Line::joined(engines, ", "),
            records.standing(&claim.id).words().into(),
        ]
        .into()
    });
    let columns = [
        ("Claim", 15),
        ("Equation", 14),
        ("Code", 38),
        ("Proof or test", 21),
        ("Stands", 12),
    ];
    document.table(
        "From claim to equation, code, proof or test, and result",
        &columns,
        rows.collect(),
    );
}

/// A row for each thing that claims lead to, with the claims that lead there.
fn backwards<'a>(pairs: impl Iterator<Item = (String, &'a str)>) -> Vec<Row> {
    let mut back: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for (thing, claim) in pairs {
        let ids = back.entry(thing).or_default();
        if !ids.contains(&claim) {
            ids.push(claim);
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
