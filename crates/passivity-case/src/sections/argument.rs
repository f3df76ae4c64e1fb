//! The argument of a scene: drawn in parts, and as a table of its elements.

use crate::argument::PARTS;
use crate::case::Case;
use crate::document::{Block, Document, Figure, Line, Row};
use crate::draw::draw;
use crate::gsn::{Anchor, Argument, Node, Standing};
use crate::study::Study;

/// A drawing that is no wider than this leaves room for another beside it.
const SMALL: f64 = 420.0;

/// The drawings: the top goal with its parts, and each part.
pub(super) fn draw_parts(document: &mut Document, study: &Study, argument: &Argument) {
    document.heading(3, study.anchor("argument"), "Argument");
    document.say(
        "The argument is drawn in Goal Structuring Notation. Goals are rectangles, strategies \
         parallelograms, solutions circles; contexts have round ends; assumptions and justifications \
         are ovals. A diamond under an element says that nothing supports it yet, three dots that \
         its support is in a drawing of its own, a cross that it is defeated. The words at the foot \
         of an element say how its evidence stands. The annex has the same as a table.",
    );
    let parts: Vec<&Node> = argument
        .nodes()
        .filter(|node| PARTS.contains(&node.id.as_str()))
        .collect();
    let figure = |top: &Node, folded: &[String], caption: String| {
        let id = study.anchor(&format!("argument-{}", top.id));
        let drawing = draw(argument, top, folded, &id);
        let figure = Figure {
            id,
            svg: drawing.svg,
            alt: format!("{caption}. The table of elements says the same in words."),
            caption,
            small: drawing.width <= SMALL,
        };
        (drawing.width, figure)
    };
    let name = study.name();
    let folded: Vec<String> = parts.iter().map(|part| part.id.clone()).collect();
    let caption = format!("Argument of «{name}»: the top goal and its parts");
    let (_, top) = figure(argument.top(), &folded, caption);
    document.blocks.push(Block::Figure(top));
    let mut drawn: Vec<(f64, Figure)> = parts
        .into_iter()
        .filter(|part| !part.supported_by.is_empty())
        .map(|part| figure(part, &[], format!("Argument of «{name}»: {}", part.id)))
        .collect();
    // Small drawings stand side by side when they follow one another.
    drawn.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let drawn = drawn.into_iter().map(|(_, figure)| Block::Figure(figure));
    document.blocks.extend(drawn);
}

/// The elements of every argument, as tables.
pub(super) fn elements(document: &mut Document, case: &Case) {
    document.heading(2, "elements", "Elements of the argument");
    for (study, argument) in case.scenes() {
        let rows = argument
            .nodes()
            .map(|node| element(study, node, case))
            .collect();
        let caption = format!("Elements of the argument of «{}»", study.name());
        let columns = [
            ("Element", 19),
            ("Type", 14),
            ("Text", 36),
            ("Relations", 20),
            ("Stands", 11),
        ];
        document.table(&caption, &columns, rows);
    }
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
    let known = |anchor: &&Anchor| match anchor {
        Anchor::Claim(id) => case.records.claims.find(id).is_some(),
        Anchor::Assumption(_) | Anchor::Section(..) => true,
    };
    if let Some(anchor) = node.anchor.as_ref().filter(known) {
        text = text
            .and(Line::text(" See "))
            .and(Line::link(anchor.id(), anchor.title()))
            .and(Line::text("."));
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
