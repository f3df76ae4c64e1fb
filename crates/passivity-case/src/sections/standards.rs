//! Where the parts of this document are of use to readers of standards.

use crate::document::{Document, Line, Row};

/// Help for readers of standards: where in this document they find what a clause asks about.
pub(super) fn write(document: &mut Document) {
    document.heading(2, "standards", "Cross-reference for readers of standards");
    document.say(
        "To help a reader find their way, the table names clauses for which a part of this document \
         may be of use as input. It is not a claim of compliance, conformity or qualification. \
         Whether a part is enough for a clause is for the manufacturer and the assessor to decide, \
         with the text of the edition that applies to them.",
    );
    let go = |id: &str, text: &str| Line::link(id, text);
    let row = |standard: &str, clause: &str, where_: Line| -> Row {
        [standard.into(), clause.into(), where_].into()
    };
    let rows = vec![
        row(
            "ISO 14971",
            "5.4 identification of hazards and hazardous situations",
            go("hazards", "Hazards"),
        ),
        row(
            "ISO 14971",
            "5.2 intended use; 5.3 characteristics related to safety",
            go("assumptions", "Assumptions")
                .and(", ".into())
                .and(go("limits", "Limits")),
        ),
        row(
            "ISO 14971",
            "7.1 risk control option analysis (a bound on speed, stiffness or rate)",
            go("summary", "Verdict and borders of each scene"),
        ),
        row(
            "ISO 14971",
            "7.2 implementation and verification of risk controls",
            go("claims", "Claims and evidence"),
        ),
        row(
            "IEC 62304",
            "5.2 software requirements analysis; 7.3.3 traceability",
            go("traceability", "Traceability"),
        ),
        row(
            "IEC 62304",
            "5.5 to 5.7 unit, integration and system verification records",
            go("claims", "Claims and evidence"),
        ),
        row(
            "IEC 62304",
            "8 configuration management; 7.4 changes to software",
            go("history", "History")
                .and(", ".into())
                .and(go("reproduce", "How to reproduce")),
        ),
        row(
            "IEC 61508-3",
            "7.4.4 support tools; Annex A, Table A.9 (formal proof)",
            go("limits", "Trust in tools")
                .and(", ".into())
                .and(go("claims", "Claims and evidence")),
        ),
        row(
            "IEC 61508-3",
            "7.9 software verification; 7.8 modification",
            go("traceability", "Traceability")
                .and(", ".into())
                .and(go("history", "History")),
        ),
        row(
            "ISO 26262",
            "Part 6, 9.4 unit verification; Part 8, 11 confidence in software tools",
            go("claims", "Claims and evidence")
                .and(", ".into())
                .and(go("limits", "Trust in tools")),
        ),
        row(
            "ISO 26262",
            "Part 2, 6.4.8 safety case; Part 8, 6 safety requirements",
            go("summary", "Summary and verdict"),
        ),
    ];
    let columns = [
        ("Standard", 16),
        ("Clause that a part may help with", 50),
        ("Where in this document", 34),
    ];
    document.table(
        "Where to look, by standard; no claim of compliance",
        &columns,
        rows,
    );
}
