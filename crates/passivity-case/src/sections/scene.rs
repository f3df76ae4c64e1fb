//! One scene: its verdict and figures, its parameters, the derivation, and its pictures.

use passivity_scene::check::comparison;
use passivity_scene::display::range;
use passivity_scene::explain::{self, Step};

use super::recorded;
use crate::case::Case;
use crate::document::{Block, Document, Line, Row};
use crate::figures;
use crate::study::{Source, Study};

pub(super) fn write(document: &mut Document, case: &Case, study: &Study) {
    document.heading(2, study.anchor("scene"), study.name());
    document.say(
        Line::text("Scene file ")
            .and(Line::code(study.path.display().to_string()))
            .and(Line::text(", SHA-256 "))
            .and(Line::hash(&study.sha256))
            .and(Line::text(".")),
    );
    verdict(document, study);
    parameters(document, study);
    recorded::write(document, study);
    derivation(document, study);
    document.blocks.extend(figures::of_plane(study));
    document.heading(3, study.anchor("motions"), "Motion and energy");
    document.blocks.extend(figures::of_motion(study));
    if case.measured {
        document.blocks.extend(figures::of_accuracy(study));
    }
}

fn verdict(document: &mut Document, study: &Study) {
    let report = study.report();
    document.heading(3, study.anchor("verdict"), "Verdict");
    let line = Line::strong(format!("{}.", report.headline()));
    document
        .blocks
        .push(Block::Verdict(study.is_passive(), line));
    let mut rows: Vec<Row> = Vec::new();
    let mut row = |name: &str, value: String| rows.push([Line::text(name), value.into()].into());
    row(
        "β = b/(KT), effective viscous friction",
        range(&report.beta),
    );
    if let Some(sigma) = &report.sigma {
        row("σ = c/(KΔ), effective Coulomb friction", range(sigma));
    }
    if let Some(mu) = &report.mu {
        row("μ = m/(KT²), effective inertia", range(mu));
    }
    let pair = |viscous, coulomb| format!("{} of β, {} of σ", range(viscous), range(coulomb));
    row(
        "What the effects require of β and σ",
        pair(&report.cost.viscous, &report.cost.coulomb),
    );
    row(
        "Spare at every speed",
        pair(&report.spare.viscous, &report.spare.coulomb),
    );
    if let Some(margin) = &report.margin_at_speed_bound {
        let name = format!("Margin (8) at {}", report.speed_bound_text());
        row(&name, range(margin));
    }
    if let Some(speed) = report.critical_speed_text() {
        row("Critical speed", speed);
    }
    row(
        "Colgate's condition b ≥ KT/2, for comparison",
        comparison(report.colgate, &report.effects),
    );
    row(
        "The condition of Abbott and Okamura, for comparison",
        comparison(report.abbott_okamura, &report.effects),
    );
    let caption = format!(
        "Figures of «{}», exact or exactly enclosed over the tolerances, printed to five digits",
        study.name()
    );
    document.table(&caption, &[("Figure", 52), ("Value", 48)], rows);
    limits(document, study);
    if let Some(witness) = report.witness_text() {
        document.say(format!("Witness: {witness}"));
    }
    if !report.decided_by.is_empty() {
        let names = report.decided_by.join(", ");
        document.say(format!("The verdict depends on the tolerance of: {names}."));
    }
}

/// How far each parameter can go, all others as they are.
fn limits(document: &mut Document, study: &Study) {
    let motion = study.scene.motion;
    let rows = study.report().limits.iter().map(|limit| {
        let alone = if limit.printed.is_some() {
            ""
        } else {
            "; this alone does not suffice"
        };
        [
            limit.name(motion).into(),
            limit.now(motion).into(),
            format!("{}{alone}", limit.promise(motion)).into(),
        ]
        .into()
    });
    let caption = format!("Limits of «{}», one parameter at a time", study.name());
    let columns = [("Parameter", 40), ("Now", 27), ("Limit", 33)];
    document.table(&caption, &columns, rows.collect());
}

fn parameters(document: &mut Document, study: &Study) {
    document.heading(3, study.anchor("parameters"), "Device and parameters");
    let head = study.head();
    for paragraph in head.lines() {
        document.say(Line::text("The scene file says: ").and(paragraph.into()));
    }
    let stated = study.stated();
    if stated.iter().any(|stated| stated.source == Source::Head) {
        document.say(
            "That is the head of the scene file. It is taken as the source of each parameter that has no comment of its \
             own; whether it is one is for the reader to judge.",
        );
    }
    let mut rows: Vec<Row> = Vec::new();
    for stated in stated {
        let source = match stated.source {
            Source::Comment(comment) => comment.into(),
            Source::Identified => Line::link(study.anchor("identified"), "identified from logs"),
            Source::Head => "head of the scene file".into(),
            Source::None => "open: the scene file names no source".into(),
        };
        let si = stated.si.unwrap_or_else(|| "–".to_owned());
        let [key, text] = [&stated.key, &stated.text].map(Line::code);
        rows.push([key, text, si.into(), source].into());
    }
    let caption = format!("Parameters of «{}» and their sources", study.name());
    let columns = [
        ("Parameter", 24),
        ("As given, with its tolerance", 23),
        ("In SI units, as the criterion has it", 25),
        ("Source", 28),
    ];
    document.table(&caption, &columns, rows);
    for remark in &study.explanation.report.remarks {
        document.say(Line::text("How the file was read: ").and(remark.as_str().into()));
    }
    let absent = study.explanation.absent.iter();
    let absent: Vec<&str> = absent.map(|effect| effect.words()).collect();
    if !absent.is_empty() {
        document.say(format!(
            "Not in this scene, and not computed: {}.",
            absent.join("; ")
        ));
    }
}

fn derivation(document: &mut Document, study: &Study) {
    document.heading(3, study.anchor("derivation"), "Derivation");
    let rows = study.explanation.lines.iter().map(|line| {
        [
            line.id.into(),
            line.formula.as_str().into(),
            numbers(study, line).into(),
        ]
        .into()
    });
    let caption = format!(
        "From the units to the verdict of «{}», over the tolerances",
        study.name()
    );
    let columns = [
        ("Equation or claim", 16),
        ("In letters", 42),
        ("In numbers", 42),
    ];
    document.table(&caption, &columns, rows.collect());
}

/// The numbers of a line of the derivation, over the tolerances.
fn numbers(study: &Study, line: &explain::Line) -> String {
    let report = study.report();
    match line.step {
        Step::Beta => format!("β = {}", range(&report.beta)),
        Step::Sigma => report.sigma.as_ref().map_or_else(
            || line.numbers.clone(),
            |sigma| format!("σ = {}", range(sigma)),
        ),
        Step::Criterion => study.criterion().sentence(),
        _ => line.numbers.clone(),
    }
}
