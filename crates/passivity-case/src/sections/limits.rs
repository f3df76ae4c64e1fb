//! What this case does not say, and where its parts are of use to readers of standards.

use std::collections::BTreeSet;

use crate::case::Case;
use crate::document::{Document, Line, Row};

pub(super) fn write(document: &mut Document, case: &Case) {
    document.heading(2, "limits", "Limits");
    let mut items: Vec<Line> = Vec::new();
    let uncovered: BTreeSet<&str> = case
        .studies
        .iter()
        .flat_map(|study| &study.report().not_covered)
        .map(|effect| effect.words())
        .collect();
    if !uncovered.is_empty() {
        let list: Vec<&str> = uncovered.into_iter().collect();
        items.push(
            Line::strong("Effects in these scenes that no theorem covers: ")
                .and(format!("{}.", list.join("; ")).into()),
        );
    }
    let fixed = [
        (
            "Effects that no theorem covers: ",
            "lag of the amplifier and the drive's bandwidth, friction that changes with speed or \
             position (Stribeck, stiction above Coulomb's level), saturation together with virtual \
             damping, flexible structure between motor and hand, backlash, and force ripple.",
        ),
        (
            "One degree of freedom: ",
            "the statement is about one axis. For several axes with one wall each, coupled by nothing \
             but the device, it holds axis by axis; a wall at an angle to the axes is not covered.",
        ),
        (
            "One contact: ",
            "a wall that moves, or a scene with several objects, is not covered.",
        ),
        (
            "Passivity is not safety: ",
            "a passive display can still hurt, by force, heat or a pinch. And a display that is not \
             passive need not hurt: the criterion is about every operator.",
        ),
        (
            "The operator is passive: ",
            "stability of hand and display together follows when the hand is passive too.",
        ),
        (
            "Trust in tools: ",
            "the proofs are as good as the tools that checked them (solvers, model checker, proof \
             assistant), the compiler, and the reading of the paper. Claims are therefore checked by \
             more than one tool where the table of evidence says so. None of these tools is qualified \
             under any standard.",
        ),
        (
            "The parameters: ",
            "the verdict is about the numbers in the scene file. Whether the device has them is shown \
             on the bench, not here; friction falls with wear and rises with cold.",
        ),
        (
            "The software that renders the wall ",
            "is not examined: the scene describes what it should do. Recorded traces of it can be \
             audited with passivity audit.",
        ),
    ];
    items.extend(fixed.map(|(head, rest)| Line::strong(head).and(rest.into())));
    document.list(items);
    standards(document);
}

/// Help for readers of standards: where in this document they find what a clause asks about.
fn standards(document: &mut Document) {
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
