//! Drawing an argument as SVG, in the shapes of GSN.

mod layout;
mod text;

use std::fmt::Write as _;

use crate::gsn::{Argument, Kind, Node, Standing};
use layout::{Edge, Layout, Relation, Shape};
use text::{FONT, LINE};

/// Room around the drawing.
const MARGIN: f64 = 12.0;

/// A drawing and its size in pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawing {
    /// The picture.
    pub svg: String,
    /// Its width.
    pub width: f64,
    /// Its height.
    pub height: f64,
}

/// Draws what is under the element `top`, down to the elements in `folded`, whose support is
/// drawn elsewhere; `name` must be unique among the drawings of a document.
///
/// # Example
///
/// ```
/// use passivity_case::{draw::draw, gsn::{Argument, Kind, Node}};
///
/// let argument = Argument::new("a wall", Node::new(Kind::Goal, "G1", "It is passive."));
/// let drawing = draw(&argument, argument.top(), &[], "wall");
/// assert!(drawing.svg.contains("undeveloped"));
/// ```
#[must_use]
pub fn draw(argument: &Argument, top: &Node, folded: &[String], name: &str) -> Drawing {
    let block = Layout::new(argument, folded).under(top);
    let (width, height) = (block.w + 2.0 * MARGIN, block.h + 2.0 * MARGIN);
    // Writing to a string cannot fail.
    let mut svg = String::new();
    let _ = write!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0} {height:.0}" width="{width:.0}" height="{height:.0}" role="img" aria-labelledby="{name}-title {name}-desc" font-family="DejaVu Sans, Verdana, sans-serif" font-size="{FONT}">"#
    );
    let _ = write!(
        svg,
        r#"<title id="{name}-title">{}</title><desc id="{name}-desc">{}</desc>"#,
        escape(&format!("Argument under {}: {}", top.id, argument.title)),
        escape(&description(&block.shapes)),
    );
    let _ = write!(
        svg,
        r##"<rect width="100%" height="100%" fill="#ffffff"/><g transform="translate({MARGIN} {MARGIN})">"##
    );
    for edge in &block.edges {
        draw_edge(&mut svg, edge);
    }
    for shape in &block.shapes {
        draw_shape(&mut svg, shape);
    }
    svg.push_str("</g></svg>\n");
    Drawing { svg, width, height }
}

/// The drawing in words, for those who do not see it.
fn description(shapes: &[Shape<'_>]) -> String {
    let of = |shape: &Shape<'_>| {
        let node = shape.node;
        let standing = node
            .standing
            .map_or(String::new(), |s| format!(" ({})", s.words()));
        let links = |word: &str, ids: &[String]| {
            if ids.is_empty() {
                String::new()
            } else {
                format!("; {word} {}", ids.join(", "))
            }
        };
        let supports = if shape.folded {
            &[][..]
        } else {
            &node.supported_by
        };
        format!(
            "{} {}{standing}{}{}{}.",
            node.kind.words(),
            node.id,
            links("supported by", supports),
            links("in the context of", &node.in_context_of),
            links("challenges", node.challenges.as_slice()),
        )
    };
    shapes.iter().map(of).collect::<Vec<_>>().join(" ")
}

/// Text as it may stand in SVG and HTML.
#[must_use]
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // What XML 1.0 cannot hold.
            c if c.is_control() && !matches!(c, '\n' | '\t' | '\r') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// Fill and border of an element: pale enough to read on in black and white print.
const fn colours(standing: Option<Standing>) -> (&'static str, &'static str) {
    match standing {
        None => ("#ffffff", "#444444"),
        Some(Standing::Shown) => ("#eaf5e6", "#2f6b2a"),
        Some(Standing::Stale) => ("#fdf3d3", "#8a6100"),
        Some(Standing::NotRun) => ("#eeeeee", "#555555"),
        Some(Standing::Open) => ("#ffffff", "#1f4e79"),
        Some(Standing::Defeated) => ("#fbe4e4", "#a11212"),
    }
}

fn draw_shape(svg: &mut String, shape: &Shape<'_>) {
    let Shape {
        node,
        x,
        y,
        w,
        body,
        folded,
        ..
    } = shape;
    let (fill, stroke) = colours(node.standing);
    // A border in dashes marks what speaks against the case, whatever its colour.
    let dashes = match node.kind {
        Kind::CounterGoal | Kind::CounterSolution => r#" stroke-dasharray="6 3""#,
        _ => "",
    };
    let paint = format!(r#"fill="{fill}" stroke="{stroke}" stroke-width="1.3"{dashes}"#);
    let (cx, cy) = (x + w / 2.0, y + body / 2.0);
    let _ = match node.kind {
        Kind::Goal | Kind::CounterGoal => {
            write!(
                svg,
                r#"<rect x="{x:.1}" y="{y:.1}" width="{w:.1}" height="{body:.1}" {paint}/>"#
            )
        }
        Kind::Strategy => {
            let (slant, right, bottom) = (16.0, x + w, y + body);
            write!(
                svg,
                r#"<polygon points="{:.1},{y:.1} {right:.1},{y:.1} {:.1},{bottom:.1} {x:.1},{bottom:.1}" {paint}/>"#,
                x + slant,
                right - slant,
            )
        }
        Kind::Context => {
            let round = (body / 2.0).min(18.0);
            write!(
                svg,
                r#"<rect x="{x:.1}" y="{y:.1}" width="{w:.1}" height="{body:.1}" rx="{round:.1}" {paint}/>"#
            )
        }
        Kind::Solution | Kind::CounterSolution => {
            write!(
                svg,
                r#"<circle cx="{cx:.1}" cy="{cy:.1}" r="{:.1}" {paint}/>"#,
                w / 2.0
            )
        }
        Kind::Assumption | Kind::Justification => {
            write!(
                svg,
                r#"<ellipse cx="{cx:.1}" cy="{cy:.1}" rx="{:.1}" ry="{:.1}" {paint}/><text x="{:.1}" y="{:.1}" font-weight="bold" text-anchor="middle">{}</text>"#,
                w / 2.0,
                body / 2.0,
                x + w - 10.0,
                y + body - 2.0,
                node.kind.prefix(),
            )
        }
    };
    if node.is_undeveloped() || *folded {
        draw_below(svg, shape, stroke);
    }
    if node.is_defeated() {
        let (right, bottom) = (x + w, y + body);
        let _ = write!(
            svg,
            r##"<path d="M {x:.1} {y:.1} L {right:.1} {bottom:.1} M {right:.1} {y:.1} L {x:.1} {bottom:.1}" stroke="#d88" stroke-width="1.6" fill="none"/>"##
        );
    }
    draw_text(svg, shape, (cx, cy), stroke);
}

/// The diamond under an element that nothing supports, or the dots under one whose support is in a
/// drawing of its own.
fn draw_below(svg: &mut String, shape: &Shape<'_>, stroke: &str) {
    let cx = shape.x + shape.w / 2.0;
    let (top, bottom) = (shape.y + shape.body, shape.y + shape.h - 4.0);
    let middle = f64::midpoint(top, bottom);
    let half = layout::DIAMOND / 2.0;
    if shape.folded {
        // Not a sign of GSN: three dots say that the support is in a drawing of its own.
        for dx in [-7.0, 0.0, 7.0] {
            let _ = write!(
                svg,
                r#"<circle cx="{:.1}" cy="{middle:.1}" r="2" fill="{stroke}"/>"#,
                cx + dx
            );
        }
    } else {
        let _ = write!(
            svg,
            r##"<polygon points="{cx:.1},{top:.1} {:.1},{middle:.1} {cx:.1},{bottom:.1} {:.1},{middle:.1}" fill="#ffffff" stroke="{stroke}" stroke-width="1.3"><title>undeveloped</title></polygon>"##,
            cx + half,
            cx - half,
        );
    }
}

fn draw_text(svg: &mut String, shape: &Shape<'_>, (cx, cy): (f64, f64), colour: &str) {
    let standing = shape.node.standing;
    let rows = shape.id.len() + shape.lines.len() + usize::from(standing.is_some());
    // Base lines: a letter reaches about 0.76 of its size above and 0.24 below.
    let mut y = cy - rows as f64 * LINE / 2.0 - LINE * 0.22;
    svg.push_str(r#"<g text-anchor="middle">"#);
    let mut row = |text: &str, style: &str| {
        y += LINE;
        let _ = write!(
            svg,
            r#"<text x="{cx:.1}" y="{y:.1}"{style}>{}</text>"#,
            escape(text)
        );
    };
    for line in &shape.id {
        row(line, r#" font-weight="bold""#);
    }
    for line in &shape.lines {
        row(line, "");
    }
    if let Some(standing) = standing {
        row(
            standing.words(),
            &format!(r#" font-style="italic" fill="{colour}""#),
        );
    }
    svg.push_str("</g>");
}

fn draw_edge(svg: &mut String, edge: &Edge) {
    let mut points = edge.points.clone();
    points.dedup();
    let [.., (x0, y0), (x1, y1)] = points[..] else {
        return;
    };
    let (colour, dashes) = match edge.relation {
        Relation::Challenges => ("#a11212", r#" stroke-dasharray="6 4""#),
        Relation::SupportedBy | Relation::InContextOf => ("#444444", ""),
    };
    let path: Vec<String> = points
        .iter()
        .map(|(x, y)| format!("{x:.1},{y:.1}"))
        .collect();
    let _ = write!(
        svg,
        r#"<polyline points="{}" fill="none" stroke="{colour}" stroke-width="1.2"{dashes}/>"#,
        path.join(" ")
    );
    if !edge.head {
        return;
    }
    // Filled: supported by. Hollow: in the context of, challenges.
    let fill = match edge.relation {
        Relation::SupportedBy => colour,
        Relation::InContextOf | Relation::Challenges => "#ffffff",
    };
    let length = (x1 - x0).hypot(y1 - y0).max(1e-9);
    let (ux, uy) = ((x1 - x0) / length, (y1 - y0) / length);
    let (bx, by) = (x1 - 9.0 * ux, y1 - 9.0 * uy);
    let _ = write!(
        svg,
        r#"<polygon points="{x1:.1},{y1:.1} {:.1},{:.1} {:.1},{:.1}" fill="{fill}" stroke="{colour}" stroke-width="1.2"/>"#,
        bx - 4.0 * uy,
        by + 4.0 * ux,
        bx + 4.0 * uy,
        by - 4.0 * ux,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An argument with everything that a drawing can have, and more of it than usual.
    fn crowded() -> Argument {
        let text =
            "A text long enough to be broken into several lines, with a_very_long_word_in_it.";
        let mut argument = Argument::new("crowded", Node::new(Kind::Goal, "G-top", text));
        for name in ["C-1", "C-2", "C-3"] {
            argument.hang("G-top", Node::new(Kind::Context, name, text));
        }
        argument.hang("G-top", Node::new(Kind::Strategy, "S-1", text));
        argument.hang("S-1", Node::new(Kind::Justification, "J-1", text));
        for name in ["A-1", "A-2", "A-3", "A-4"] {
            argument.hang("S-1", Node::new(Kind::Assumption, name, text));
        }
        for goal in 0..6 {
            let id = format!("G-{goal}");
            argument.hang("S-1", Node::new(Kind::Goal, &id, text));
            argument.hang(&id, Node::new(Kind::Assumption, format!("A-g{goal}"), text));
            for leaf in 0..goal * 2 {
                let id_of_leaf = format!("Sn-{goal}-{leaf}");
                argument.hang(&id, Node::new(Kind::Solution, id_of_leaf, text));
            }
        }
        argument.hang("G-3", Node::new(Kind::Goal, "G-3-sub", text));
        argument.challenge("G-top", Node::new(Kind::CounterGoal, "CG-1", text));
        argument.hang("CG-1", Node::new(Kind::CounterSolution, "CSn-1", text));
        argument.hang("CG-1", Node::new(Kind::CounterSolution, "CSn-2", text));
        argument.challenge("G-2", Node::new(Kind::CounterGoal, "CG-2", text));
        argument.hang("CG-2", Node::new(Kind::CounterSolution, "CSn-3", text));
        argument.settle();
        argument
    }

    #[test]
    fn no_two_elements_overlap_and_every_element_is_drawn_within_the_picture() {
        let argument = crowded();
        let block = Layout::new(&argument, &[]).under(argument.top());
        assert_eq!(block.shapes.len(), argument.nodes().count());
        for (index, a) in block.shapes.iter().enumerate() {
            assert!(a.x >= 0.0 && a.y >= 0.0, "{}", a.node.id);
            assert!(
                a.x + a.w <= block.w + 1e-9 && a.y + a.h <= block.h + 1e-9,
                "{}",
                a.node.id
            );
            for b in &block.shapes[index + 1..] {
                let apart =
                    a.x + a.w <= b.x || b.x + b.w <= a.x || a.y + a.h <= b.y || b.y + b.h <= a.y;
                assert!(apart, "{} and {}", a.node.id, b.node.id);
            }
        }
    }

    #[test]
    fn no_line_goes_through_an_element() {
        let argument = crowded();
        let block = Layout::new(&argument, &[]).under(argument.top());
        for edge in &block.edges {
            for piece in edge.points.windows(2) {
                let ((x0, y0), (x1, y1)) = (piece[0], piece[1]);
                assert!(
                    x0 == x1 || y0 == y1,
                    "lines are upright or level: {piece:?}"
                );
                let (left, right) = (x0.min(x1), x0.max(x1));
                let (top, bottom) = (y0.min(y1), y0.max(y1));
                for shape in &block.shapes {
                    // Ends touch, and the slant of a parallelogram lets a line in by 8.
                    let (x, w) = (shape.x + 9.0, shape.w - 18.0);
                    let (y, h) = (shape.y + 1.0, shape.body - 2.0);
                    let through = left < x + w && right > x && top < y + h && bottom > y;
                    assert!(!through, "{piece:?} through {}", shape.node.id);
                }
            }
        }
    }

    #[test]
    fn text_fits_into_its_element() {
        let argument = crowded();
        let block = Layout::new(&argument, &[]).under(argument.top());
        for shape in &block.shapes {
            let rows =
                shape.id.len() + shape.lines.len() + usize::from(shape.node.standing.is_some());
            let (h, body) = (rows as f64 * LINE, shape.body);
            for line in &shape.lines {
                let w = text::width(line);
                let fits = match shape.node.kind {
                    Kind::Solution | Kind::CounterSolution => w.hypot(h) <= body,
                    // Within the ellipse: (w/2a)² + (h/2b)² ≤ 1.
                    Kind::Assumption | Kind::Justification => {
                        (w / shape.w).powi(2) + (h / body).powi(2) <= 1.0
                    }
                    _ => w < shape.w && h < body,
                };
                assert!(fits, "{}: {line}", shape.node.id);
            }
        }
    }

    #[test]
    fn a_folded_drawing_leaves_the_support_to_another() {
        let argument = crowded();
        let drawing = draw(&argument, argument.top(), &["G-5".to_owned()], "one");
        assert!(drawing.svg.contains(">G-5<") && !drawing.svg.contains("Sn-5-0"));
        let other = draw(&argument, argument.node("G-5").unwrap(), &[], "two");
        assert!(other.svg.contains("Sn-5-0") && !other.svg.contains(">G-4<"));
        assert!(
            other
                .svg
                .contains(r#"aria-labelledby="two-title two-desc""#)
        );
    }
}
