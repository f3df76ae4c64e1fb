//! One scene: its parameters, the derivation with its numbers, its place in the plane, and its
//! argument.

use passivity_core::Scalar as _;
use passivity_plot::plane::{self, Mark};
use passivity_scene::check::Direction;
use passivity_scene::display::{approx, range};
use passivity_scene::number::nearest_f64;
use passivity_scene::pi::PRINT_LEVEL;

use crate::argument::{PARTS, TOP};
use crate::case::Case;
use crate::document::{Block, Document, Figure, Line, Row};
use crate::draw::draw;
use crate::figures;
use crate::gsn::{Argument, Node, Standing};
use crate::study::{Source, Study, speed_unit, with_unit};

pub(super) fn write(document: &mut Document, case: &Case, study: &Study, argument: &Argument) {
    document.heading(2, study.anchor("scene"), study.name());
    document.say(
        Line::text("Scene file ")
            .and(Line::code(study.path.display().to_string()))
            .and(Line::text(", SHA-256 "))
            .and(Line::code(&study.sha256))
            .and(Line::text(".")),
    );
    verdict(document, study);
    parameters(document, study);
    derivation(document, study);
    pictures(document, study);
    motion(document, case, study);
    show_argument(document, case, study, argument);
}

fn verdict(document: &mut Document, study: &Study) {
    let report = study.report();
    document.heading(3, study.anchor("summary"), "Verdict");
    let line = Line::strong(format!("{}.", report.headline()));
    document
        .blocks
        .push(Block::Verdict(study.is_passive(), line));
    let mut rows: Vec<Row> = Vec::new();
    let mut row = |name: &str, value: String| rows.push([Line::text(name), value.into()].into());
    row("β = b/(KT)", range(&report.beta));
    if let Some(sigma) = &report.sigma {
        row("σ = c/(KΔ)", range(sigma));
    }
    if let Some(mu) = &report.mu {
        row("μ = m/(KT²)", range(mu));
    }
    row("Margin at every speed", range(&report.margin_at_all_speeds));
    if let (Some(margin), Some(v)) = (&report.margin_at_speed_bound, &report.speed_bound) {
        row(
            &format!("Margin at {} ticks/sample", range(v)),
            range(margin),
        );
    }
    let unit = speed_unit(study.scene.motion);
    if let Some(v) = &report.critical_speed {
        let si = report.critical_speed_si.as_ref();
        let si = si.map_or(String::new(), |si| format!("{} = ", with_unit(si, unit)));
        row("Critical speed", format!("{si}{} ticks/sample", range(v)));
    }
    for change in &report.changes {
        let (relation, border) = match change.direction {
            Direction::AtLeast => ("at least", change.border.hi()),
            Direction::AtMost => ("at most", change.border.lo()),
        };
        let alone = if change.suffices {
            ""
        } else {
            ", and it is not enough alone"
        };
        let unit = change.unit;
        let text = format!("{relation} {} {unit}{alone}", approx(border));
        row(
            &format!("Border of {}, all else as it is", change.name),
            text,
        );
    }
    row(
        "Colgate's b ≥ KT/2, for comparison",
        report.colgate.name().to_owned(),
    );
    row(
        "Abbott and Okamura, for comparison",
        report.abbott_okamura.name().to_owned(),
    );
    let caption = format!(
        "Figures of «{}», exact or exactly enclosed, printed to five digits",
        study.name()
    );
    document.table(&caption, &[("Figure", 45), ("Value", 55)], rows);
    if let Some(witness) = &report.witness {
        let unit = if report.sigma.is_some() {
            "ticks"
        } else {
            "SI units of length"
        };
        document.say(format!(
            "Witness: moving from {} to {} {unit} and back, each way at constant speed within one \
             sampling interval, gains at least {} (≈ {}) in KΔ² every time round.",
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

fn parameters(document: &mut Document, study: &Study) {
    document.heading(3, study.anchor("parameters"), "Device and parameters");
    let head = study.head();
    for paragraph in head.lines() {
        document.say(Line::text("The scene file says: ").and(paragraph.into()));
    }
    let mut rows: Vec<Row> = Vec::new();
    for given in study.scene.parameters() {
        let si = range(&given.value.enclosure(PRINT_LEVEL));
        let source = match study.source(given) {
            _ if given.text.is_empty() => "not in the scene file: the default".to_owned(),
            Source::Comment(comment) => comment,
            Source::Head => "the head of the scene file".to_owned(),
            Source::None => "open: the scene file names no source".to_owned(),
        };
        let text = if given.text.is_empty() {
            "–".into()
        } else {
            Line::code(&given.text)
        };
        let tolerance = if given.has_tolerance() {
            "yes"
        } else {
            "none given"
        };
        rows.push(
            [
                Line::code(given.key),
                text,
                si.into(),
                tolerance.into(),
                source.into(),
            ]
            .into(),
        );
    }
    if let Some(delay) = study.scene.delay {
        let text = format!("{delay} whole samples");
        rows.push(
            [
                Line::code("sampling.delay"),
                text.into(),
                "–".into(),
                "–".into(),
                "the scene file".into(),
            ]
            .into(),
        );
    }
    let caption = format!(
        "Parameters of «{}», with tolerances and sources",
        study.name()
    );
    let columns = [
        ("Parameter", 20),
        ("As given", 22),
        ("In SI units", 18),
        ("Tolerance", 12),
        ("Source", 28),
    ];
    document.table(&caption, &columns, rows);
    let absent: Vec<&str> = study
        .explanation
        .absent
        .iter()
        .map(|effect| effect.words())
        .collect();
    if !absent.is_empty() {
        document.say(format!(
            "Not in this scene, and not computed: {}.",
            absent.join("; ")
        ));
    }
}

fn derivation(document: &mut Document, study: &Study) {
    document.heading(
        3,
        study.anchor("derivation"),
        "Derivation with the numbers of the scene",
    );
    let rows = study.explanation.lines.iter().map(|line| {
        [
            line.id.into(),
            line.formula.as_str().into(),
            line.numbers.as_str().into(),
        ]
        .into()
    });
    let caption = format!("From the units to the verdict of «{}»", study.name());
    let columns = [
        ("Equation or claim", 16),
        ("In letters", 44),
        ("In numbers", 40),
    ];
    document.table(&caption, &columns, rows.collect());
}

fn pictures(document: &mut Document, study: &Study) {
    let report = study.report();
    let middle = |x: &passivity_core::Interval<passivity_core::BigRational>| {
        nearest_f64(&(x.lo() + x.hi()).half())
    };
    let Some(sigma) = &report.sigma else {
        document.say("Without an encoder the scene has no place in the (β, σ) plane: σ needs a Δ.");
        return;
    };
    let speed = report
        .speed_bound
        .as_ref()
        .map(|v| (middle(v), format!("{} ticks/sample", range(v))));
    let mark = Mark {
        name: study.name().to_owned(),
        beta: middle(&report.beta),
        sigma: middle(sigma),
        speed: speed.filter(|(v, _)| *v > 0.0),
        verdict: report.verdict.name().replace('_', " "),
    };
    let alt = format!(
        "The plane of effective viscous friction β and effective Coulomb friction σ, with the lines \
         β = ½ and σ = ½ that part the regions. The scene is at β = {}, σ = {}: {}.",
        range(&report.beta),
        range(sigma),
        mark.verdict
    );
    match plane::draw(&[mark]) {
        Ok(svg) => document.blocks.push(Block::Figure(Figure {
            id: study.anchor("plane"),
            svg,
            caption: format!("«{}» in the (β, σ) plane, and where stiffness, sampling period and resolution move it", study.name()),
            alt,
            wide: false,
        })),
        Err(error) => document.say(format!("No picture of the plane: {error}.")),
    }
}

fn motion(document: &mut Document, case: &Case, study: &Study) {
    document.heading(3, study.anchor("motions"), "Motion and energy");
    document.blocks.extend(figures::of_motion(study));
    if case.measured {
        document.blocks.extend(figures::of_accuracy(study));
        return;
    }
    document.say(
        Line::text(
            "What accuracy costs in time is not run here, because it differs from run to run: ",
        )
        .and(Line::code("passivity case --accuracy"))
        .and(" measures it and puts the picture here, and so does ".into())
        .and(Line::code("passivity accuracy"))
        .and(" by itself.".into()),
    );
}

fn show_argument(document: &mut Document, case: &Case, study: &Study, argument: &Argument) {
    document.heading(3, study.anchor("argument"), "Argument");
    document.say(
        "In Goal Structuring Notation: goals are rectangles, strategies parallelograms, solutions \
         circles, contexts have round ends, assumptions and justifications are ovals. A diamond \
         under an element says that nothing supports it yet, three dots that its support is in a \
         drawing of its own, a cross that it is defeated. The words at the foot of an element say \
         how its evidence stands.",
    );
    let parts: Vec<String> = argument
        .nodes()
        .iter()
        .filter(|n| is_part(n))
        .map(|n| n.id.clone())
        .collect();
    let mut figure = |root: &str, folded: &[String], caption: String| {
        let id = study.anchor(&format!("argument-{root}"));
        let drawing = draw(argument, root, folded, &id);
        let alt = format!("{caption}. The table of elements says the same in words.");
        // Letters keep a readable size on paper up to this width upright.
        let wide = drawing.width > 900.0;
        document.blocks.push(Block::Figure(Figure {
            id,
            svg: drawing.svg,
            caption,
            alt,
            wide,
        }));
    };
    figure(
        TOP,
        &parts,
        format!("Argument of «{}»: the top goal and its parts", study.name()),
    );
    for part in &parts {
        let supported = argument
            .node(part)
            .is_some_and(|n| !n.supported_by.is_empty());
        if supported {
            figure(part, &[], format!("Argument of «{}»: {part}", study.name()));
        }
    }
    let rows = argument
        .nodes()
        .iter()
        .map(|node| element(study, node, case))
        .collect();
    let caption = format!("Elements of the argument of «{}»", study.name());
    let columns = [
        ("Element", 20),
        ("Type", 12),
        ("Text", 38),
        ("Relations", 20),
        ("Stands", 10),
    ];
    document.table(&caption, &columns, rows);
}

fn is_part(node: &Node) -> bool {
    PARTS.contains(&node.id.as_str())
}

fn element(study: &Study, node: &Node, case: &Case) -> Row {
    let to = |id: &String| Line::link(element_id(study, id), id.as_str());
    let mut relations = Vec::new();
    for (word, ids) in [
        ("supported by ", &node.supported_by[..]),
        ("in the context of ", &node.in_context_of[..]),
        ("challenges ", node.challenges.as_slice()),
    ] {
        if !ids.is_empty() {
            relations.push(Line::text(word).and(Line::joined(ids.iter().map(to), ", ")));
        }
    }
    let standing = match node.standing {
        None => "",
        Some(Standing::Open) if node.is_undeveloped() => "open, undeveloped",
        Some(standing) => standing.words(),
    };
    let mut text = Line::text(&node.text);
    // An id that the claims do not have has no row to lead to.
    let anchor = node
        .anchor
        .as_ref()
        .filter(|anchor| match anchor.strip_prefix("claim-") {
            Some(id) => case.records.claim(id).is_some(),
            None => true,
        });
    if let Some(anchor) = anchor {
        text = text
            .and(Line::text(" "))
            .and(Line::link(anchor.as_str(), "details"));
    }
    Row {
        id: Some(element_id(study, &node.id)),
        cells: vec![
            node.id.as_str().into(),
            node.kind.words().into(),
            text,
            Line::joined(relations, "; "),
            standing.into(),
        ],
    }
}

fn element_id(study: &Study, id: &str) -> String {
    study.anchor(&format!("element-{id}"))
}
