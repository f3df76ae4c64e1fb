//! The sections of the document, each written from the data of the case.

mod claims;
mod errata;
mod hazards;
mod levels;
mod limits;
mod reproduce;
mod scene;
mod summary;

use crate::case::Case;
use crate::document::{Document, Line};

/// The document of a case.
#[must_use]
pub fn document(case: &Case) -> Document {
    let names: Vec<&str> = case.studies.iter().map(|study| study.name()).collect();
    let title = match names[..] {
        [one] => format!("Safety case: {one}"),
        _ => format!("Safety case of {} scenes", names.len()),
    };
    let subtitle = format!(
        "Passivity of a virtual wall under sampling, quantization and friction. Written by \
         passivity {} from the scene, the claims and the recorded evidence.",
        crate::case::VERSION
    );
    let mut document = Document::new(title, subtitle);
    summary::write(&mut document, case);
    for (study, argument) in case.scenes() {
        scene::write(&mut document, case, study, argument);
    }
    hazards::write(&mut document, case);
    levels::write(&mut document, case);
    claims::write(&mut document, case);
    errata::write(&mut document, case);
    limits::write(&mut document, case);
    reproduce::write(&mut document, case);
    document
}

/// A reference to a claim; its mere id when the claims do not have it.
fn to_claim(case: &Case, id: &str) -> Line {
    match case.records.claim(id) {
        Some(_) => Line::link(format!("claim-{id}"), id),
        None => Line::text(id),
    }
}
