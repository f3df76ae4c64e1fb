//! The sections of the document, each written from the data of the case.

mod argument;
mod assumptions;
mod claims;
mod errata;
mod glossary;
mod hazards;
mod levels;
mod limits;
mod recorded;
mod reproduce;
mod scene;
mod standards;
mod summary;
mod traceability;

use crate::case::Case;
use crate::document::{Block, Document, Line};
use crate::gsn::Anchor;

/// The document of a case: the argument and the device first, the evidence in an annex.
#[must_use]
pub fn document(case: &Case) -> Document {
    let names: Vec<&str> = case.studies.iter().map(|study| study.name()).collect();
    let given = case.info.as_ref().and_then(|info| info.title.clone());
    let title = given.unwrap_or_else(|| match names[..] {
        [one] => format!("Safety case: {one}"),
        _ => format!("Safety case of {} scenes", names.len()),
    });
    let subtitle = format!(
        "Passivity of a virtual wall under sampling, quantization and friction. Numbers in round \
         brackets, such as (8), are equations of {PAPER}. Written by passivity {} from the scene, the \
         claims and the recorded evidence.",
        crate::case::VERSION
    );
    let mut document = Document::new(title, subtitle);
    summary::write(&mut document, case);
    document.blocks.push(Block::Contents);
    for (study, argument) in case.scenes() {
        scene::write(&mut document, case, study);
        argument::draw_parts(&mut document, study, argument);
    }
    hazards::write(&mut document, case);
    assumptions::write(&mut document, case);
    limits::write(&mut document, case);
    glossary::write(&mut document);
    document.part("Annex: evidence and traceability");
    argument::elements(&mut document, case);
    claims::write(&mut document, case);
    assumptions::write_others(&mut document, case);
    levels::write(&mut document, case);
    traceability::write(&mut document, &case.records);
    errata::write(&mut document, case);
    standards::write(&mut document);
    reproduce::write(&mut document, case);
    document
}

/// Whose criterion it is.
const PAPER: &str =
    "Diolaiti, Niemeyer, Barbagli and Salisbury, A Criterion for the Passivity of Haptic Devices";

/// A reference to a claim; its mere id when the claims do not have it.
fn to_claim(case: &Case, id: &str) -> Line {
    match case.records.claims.find(id) {
        Some(_) => Line::link(Anchor::Claim(id.to_owned()).id(), id),
        None => Line::text(id),
    }
}
