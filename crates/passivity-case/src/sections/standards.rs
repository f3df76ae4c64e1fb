//! Which parts of the document help with which clauses of the standards.

use crate::document::{Document, Line, Row};

/// A part of the document: its id and its title.
type Place = (&'static str, &'static str);

const SUMMARY: Place = ("summary", "Summary and verdict");
const HAZARDS: Place = ("hazards", "Hazards");
const ASSUMPTIONS: Place = ("assumptions", "Assumptions");
const LIMITS: Place = ("limits", "Limits");
const CLAIMS: Place = ("claims", "Claims and evidence");
const TRACEABILITY: Place = ("traceability", "Traceability");
const HISTORY: Place = ("history", "History");
const REPRODUCE: Place = ("reproduce", "How to reproduce");

/// A standard, one of its clauses, and where this document may help with it.
const CLAUSES: [(&str, &str, &[Place]); 11] = [
    (
        "ISO 14971",
        "5.4 identification of hazards and hazardous situations",
        &[HAZARDS],
    ),
    (
        "ISO 14971",
        "5.2 intended use; 5.3 characteristics related to safety",
        &[ASSUMPTIONS, LIMITS],
    ),
    (
        "ISO 14971",
        "7.1 risk control option analysis (a bound on speed, stiffness or rate)",
        &[SUMMARY],
    ),
    (
        "ISO 14971",
        "7.2 implementation and verification of risk controls",
        &[CLAIMS],
    ),
    (
        "IEC 62304",
        "5.2 software requirements analysis; 7.3.3 traceability",
        &[TRACEABILITY],
    ),
    (
        "IEC 62304",
        "5.5 to 5.7 unit, integration and system verification records",
        &[CLAIMS],
    ),
    (
        "IEC 62304",
        "8 configuration management; 7.4 changes to software",
        &[HISTORY, REPRODUCE],
    ),
    (
        "IEC 61508-3",
        "7.4.4 support tools; Annex A, Table A.9 (formal proof)",
        &[LIMITS, CLAIMS],
    ),
    (
        "IEC 61508-3",
        "7.9 software verification; 7.8 modification",
        &[TRACEABILITY, HISTORY],
    ),
    (
        "ISO 26262",
        "Part 6, 9.4 unit verification; Part 8, 11 confidence in software tools",
        &[CLAIMS, LIMITS],
    ),
    (
        "ISO 26262",
        "Part 2, 6.4.8 safety case; Part 8, 6 safety requirements",
        &[SUMMARY],
    ),
];

/// Help for readers of standards: where in this document they find what a clause asks about.
pub(super) fn write(document: &mut Document) {
    document.heading(2, "standards", "Cross-reference for readers of standards");
    document.say(
        "To help a reader find their way, the table names clauses for which a part of this document \
         may be of use as input. It is not a claim of compliance, conformity or qualification. \
         Whether a part is enough for a clause is for the manufacturer and the assessor to decide, \
         with the text of the edition that applies to them.",
    );
    let rows = CLAUSES.map(|(standard, clause, places)| -> Row {
        let places = places.iter().map(|(id, title)| Line::link(*id, *title));
        [standard.into(), clause.into(), Line::joined(places, ", ")].into()
    });
    let columns = [
        ("Standard", 16),
        ("Clause that a part may help with", 50),
        ("Where in this document", 34),
    ];
    document.table(
        "Where to look, by standard; no claim of compliance",
        &columns,
        rows.to_vec(),
    );
}
