//! One scene: its verdict and figures, its parameters, the derivation, and its pictures.

use passivity_core::Interval;
use passivity_scene::check::Direction;
use passivity_scene::display::{approx, range};
use passivity_scene::explain::{self, Step};
use passivity_scene::pi::PRINT_LEVEL;

use crate::case::Case;
use crate::document::{Block, Document, Line, Row};
use crate::figures;
use crate::study::{Source, Study, speed_unit, with_unit};

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
    row("Margin at every speed", range(&report.margin_at_all_speeds));
    let unit = speed_unit(study.scene.motion);
    if let (Some(margin), Some(v)) = (&report.margin_at_speed_bound, &report.speed_bound) {
        let si = report.speed_bound_si.as_ref();
        let v = si.map_or_else(
            || format!("{} ticks/sample", range(v)),
            |si| with_unit(si, unit),
        );
        row(&format!("Margin at {v}"), range(margin));
    }
    if let Some(v) = &report.critical_speed {
        let si = report.critical_speed_si.as_ref();
        let si = si.map_or(String::new(), |si| format!("{} = ", with_unit(si, unit)));
        row("Critical speed", format!("{si}{} ticks/sample", range(v)));
    }
    row(
        "Colgate's condition b ≥ KT/2, for comparison",
        report.colgate.name().to_owned(),
    );
    row(
        "The condition of Abbott and Okamura, for comparison",
        report.abbott_okamura.name().to_owned(),
    );
    let caption = format!(
        "Figures of «{}», exact or exactly enclosed over the tolerances, printed to five digits",
        study.name()
    );
    document.table(&caption, &[("Figure", 52), ("Value", 48)], rows);
    limits(document, study);
    if let Some(witness) = &report.witness {
        let unit = if report.sigma.is_some() {
            "ticks"
        } else {
            "SI units of length"
        };
        document.say(format!(
            "Witness: moving from {} to {} {unit} and back, each way at constant speed within one \
             sampling interval, gains at least {} (about {}) KΔ² in each round.",
            witness.from,
            witness.to,
            witness.gain_per_cycle,
            approx(&witness.gain_per_cycle)
        ));
    }
    if !report.decided_by.is_empty() {
        let names = report.decided_by.join(", ");
        document.say(format!("The verdict depends on the tolerance of: {names}."));
    }
}

/// How far each parameter can go, all others as they are.
fn limits(document: &mut Document, study: &Study) {
    let rows = study.report().changes.iter().map(|change| {
        let (relation, border) = match change.direction {
            Direction::AtLeast => ("at least", change.border.hi()),
            Direction::AtMost => ("at most", change.border.lo()),
        };
        let alone = if change.suffices {
            ""
        } else {
            ", which is not enough alone"
        };
        let border = with_unit(&Interval::point(border.clone()), change.unit);
        [
            change.name.into(),
            with_unit(&change.now, change.unit).into(),
            format!("{relation} {border}{alone}").into(),
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
    let mut rows: Vec<Row> = Vec::new();
    for given in study.scene.parameters() {
        let si = range(&given.value.enclosure(PRINT_LEVEL));
        let (text, source) = if given.text.is_empty() {
            let default = "not in the scene file: the default";
            ("–".into(), default.to_owned())
        } else {
            let source = match study.source(given) {
                Source::Comment(comment) => comment,
                Source::Head => "head of the scene file".to_owned(),
                Source::None => "open: the scene file names no source".to_owned(),
            };
            (Line::code(&given.text), source)
        };
        rows.push([Line::code(given.key), text, si.into(), source.into()].into());
    }
    if let Some(delay) = study.scene.delay {
        let text = format!("{delay} whole samples");
        let key = Line::code("sampling.delay");
        let none = Line::text("–");
        rows.push([key, text.into(), none, "the scene file".into()].into());
    }
    let caption = format!("Parameters of «{}» and their sources", study.name());
    let columns = [
        ("Parameter", 27),
        ("As given, with its tolerance", 25),
        ("In SI units", 18),
        ("Source", 30),
    ];
    document.table(&caption, &columns, rows);
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
