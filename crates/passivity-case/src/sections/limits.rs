//! What this case does not show.

use std::collections::BTreeSet;

use crate::case::Case;
use crate::document::{Document, Line};
use crate::study::Study;

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
            "bandwidth of the drive beyond a first-order lag, friction that falls at some speed or \
             position below the viscous and Coulomb friction of the scene, flexible structure between \
             motor and hand, backlash, and force ripple. More friction than that, as of Stribeck or of \
             stiction, takes nothing from a verdict that the wall is passive (A-FRICTION).",
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
             on the bench, and here only as far as a recording says it, of the day on which it was made; \
             friction falls with wear and rises with cold.",
        ),
    ];
    items.extend(fixed.map(|(head, rest)| Line::strong(head).and(rest.into())));
    let has_logs = |study: &Study| study.recorded.as_ref().is_some_and(|r| !r.logs.is_empty());
    let software = match case.studies.iter().any(has_logs) {
        true => {
            "is examined in what was recorded of it, and nowhere else: the scene describes what it \
             should do."
        }
        false => {
            "is not examined: the scene describes what it should do. Recorded logs of it can be \
             audited with passivity audit, and be evidence of this case with --log."
        }
    };
    items.push(Line::strong("The software that renders the wall ").and(software.into()));
    document.list(items);
}
