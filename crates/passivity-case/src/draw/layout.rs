//! The layout of an argument: a tree from the top, with contexts and counter goals at the side.

use std::collections::BTreeSet;

use super::text::{LINE, wrap};
use crate::gsn::{Argument, Kind, Node};

/// Room between elements.
const GAP: f64 = 22.0;
/// Room beside an element for the lines to its contexts.
const GUTTER: f64 = 42.0;
/// Size of the diamond under an undeveloped element.
pub(super) const DIAMOND: f64 = 14.0;
/// Solutions under one goal stand in at most so many columns.
const COLUMNS: usize = 4;
/// A drawing that is wider than this is set in rows, so that its letters can be read in print.
pub(super) const WIDEST: f64 = 860.0;

/// An element with its place.
#[derive(Clone, Debug)]
pub(super) struct Shape<'a> {
    pub(super) node: &'a Node,
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) w: f64,
    pub(super) h: f64,
    /// Height of the element itself, without the diamond under it.
    pub(super) body: f64,
    /// The id, in bold, and the text.
    pub(super) id: Vec<String>,
    pub(super) lines: Vec<String>,
    /// Whether what supports it is drawn elsewhere.
    pub(super) folded: bool,
}

/// What a line says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Relation {
    SupportedBy,
    InContextOf,
    Challenges,
}

/// A line of straight pieces with its arrow head at the last point.
#[derive(Clone, Debug)]
pub(super) struct Edge {
    pub(super) relation: Relation,
    /// Whether it ends in an arrow head, and not in another line.
    pub(super) head: bool,
    pub(super) points: Vec<(f64, f64)>,
}

/// A part of the drawing with its own origin.
#[derive(Clone, Debug, Default)]
pub(super) struct Block<'a> {
    pub(super) w: f64,
    pub(super) h: f64,
    /// Where a line from above arrives.
    port: (f64, f64),
    pub(super) shapes: Vec<Shape<'a>>,
    pub(super) edges: Vec<Edge>,
}

impl<'a> Block<'a> {
    fn absorb(&mut self, other: Self, dx: f64, dy: f64) {
        self.w = self.w.max(other.w + dx);
        self.h = self.h.max(other.h + dy);
        self.shapes
            .extend(other.shapes.into_iter().map(|mut shape| {
                shape.x += dx;
                shape.y += dy;
                shape
            }));
        self.edges.extend(other.edges.into_iter().map(|mut edge| {
            for point in &mut edge.points {
                point.0 += dx;
                point.1 += dy;
            }
            edge
        }));
    }

    fn edge(&mut self, relation: Relation, points: &[(f64, f64)]) {
        self.edges.push(Edge {
            relation,
            head: true,
            points: points.to_vec(),
        });
    }
}

/// Where the element stands that others are put beside.
struct Middle {
    left: f64,
    right: f64,
    height: f64,
    slant: f64,
}

impl<'a> Block<'a> {
    /// Puts contexts at the left, right-aligned, each on a line from the element's left side.
    fn put_left(&mut self, items: Vec<Self>, width: f64, middle: &Middle) {
        let mut y = 0.0;
        for item in items {
            let (end, bus) = ((width, y + item.h / 2.0), width + GUTTER / 2.0);
            let from = middle.height / 2.0;
            let start = (middle.left + middle.slant, from);
            let points = [start, (bus, from), (bus, end.1), end];
            self.edge(Relation::InContextOf, &points);
            let (dx, height) = (width - item.w, item.h);
            self.absorb(item, dx, y);
            y += height + GAP / 2.0;
        }
    }

    /// Puts what speaks against the element at its right, each on a line that ends in the element.
    ///
    /// Gives the height that they take.
    fn put_counters(&mut self, items: Vec<Self>, middle: &Middle) -> f64 {
        let mut y = 0.0;
        for item in items {
            // The head of a counter goal is its first shape.
            let (cx, cy) = item
                .shapes
                .first()
                .map_or((0.0, 0.0), |s| (s.x, LINE * 1.5));
            let dx = middle.right + GUTTER * 2.0;
            let points = [(dx + cx, y + cy), (middle.right, y + cy)];
            self.edge(Relation::Challenges, &points);
            let height = item.h;
            self.absorb(item, dx, y);
            y += height + GAP;
        }
        y
    }

    /// Puts assumptions at the right from `y` down, each on a line from the element's right side.
    fn put_right(&mut self, items: Vec<Self>, mut y: f64, middle: &Middle) {
        let (bus, from) = (middle.right + GUTTER / 2.0, middle.height - LINE);
        for item in items {
            let end = (middle.right + GUTTER, y + item.h / 2.0);
            let start = (middle.right - middle.slant, from);
            let points = [start, (bus, from), (bus, end.1), end];
            self.edge(Relation::InContextOf, &points);
            let height = item.h;
            self.absorb(item, end.0, y);
            y += height + GAP / 2.0;
        }
    }
}

/// Lays out the part of an argument under one element.
pub(super) struct Layout<'a> {
    argument: &'a Argument,
    /// Elements whose support is drawn elsewhere.
    folded: BTreeSet<String>,
    placed: BTreeSet<String>,
}

impl<'a> Layout<'a> {
    pub(super) fn new(argument: &'a Argument, folded: &[String]) -> Self {
        Self {
            argument,
            folded: folded.iter().cloned().collect(),
            placed: BTreeSet::new(),
        }
    }

    /// Everything under `root`.
    pub(super) fn under(&mut self, root: &'a Node) -> Block<'a> {
        let shape = self.shape(root);
        let (mut left, mut right) = (Vec::new(), Vec::new());
        // What is drawn elsewhere has its surroundings there.
        if !self.folded.contains(&root.id) {
            left = self.beside(root, &[Kind::Context, Kind::Justification]);
            right = self.beside(root, &[Kind::Assumption]);
        }
        // Many assumptions stand on both sides, for a lower drawing.
        while right.len() > left.len() + 1 {
            left.extend(right.pop());
        }
        let argument = self.argument;
        let counters: Vec<Block<'a>> = argument
            .nodes()
            .filter(|node| node.challenges.as_deref() == Some(root.id.as_str()))
            .map(|counter| self.under(counter))
            .collect();
        let left_width = left.iter().map(|b| b.w).fold(0.0, f64::max);
        let x = if left.is_empty() {
            0.0
        } else {
            left_width + GUTTER
        };
        let (w, h) = (shape.w, shape.h);
        let middle = Middle {
            left: x,
            right: x + w,
            height: h,
            // The sides of a parallelogram slant.
            slant: if root.kind == Kind::Strategy {
                8.0
            } else {
                0.0
            },
        };
        let mut block = Block::default();
        block.put_left(left, left_width, &middle);
        let below = block.put_counters(counters, &middle);
        block.put_right(right, below, &middle);
        block.w = block.w.max(middle.right);
        block.h = block.h.max(h);
        block.port = (x + w / 2.0, 0.0);
        block.shapes.insert(0, Shape { x, y: 0.0, ..shape });
        self.hang_supports(root, &mut block, h);
        block
    }

    fn hang_supports(&mut self, root: &'a Node, block: &mut Block<'a>, bottom: f64) {
        if self.folded.contains(&root.id) {
            return;
        }
        let supports: Vec<&'a Node> = root
            .supported_by
            .iter()
            .filter_map(|id| self.argument.node(id))
            .filter(|node| !self.placed.contains(&node.id))
            .collect();
        let (leaves, inner): (Vec<_>, Vec<_>) = supports
            .into_iter()
            .partition(|n| matches!(n.kind, Kind::Solution | Kind::CounterSolution));
        let mut parts: Vec<Block<'a>> = inner.into_iter().map(|node| self.under(node)).collect();
        if let [only] = leaves[..] {
            parts.push(self.under(only));
        } else if !leaves.is_empty() {
            let hanging = self.columns(&leaves);
            parts.push(hanging);
        }
        if parts.is_empty() {
            return;
        }
        let mut top = block.h.max(bottom) + GAP * 1.6;
        for (row, last) in rows(parts) {
            hang_row(block, row, last, top, bottom);
            top = block.h + GAP * 1.6;
        }
    }

    /// Solutions in columns, each column on a line that comes down at its left.
    fn columns(&mut self, leaves: &[&'a Node]) -> Block<'a> {
        let mut block = Block::default();
        let rows = leaves.len().div_ceil(COLUMNS);
        let mut x = 0.0;
        let mut trunks = Vec::new();
        for column in leaves.chunks(rows) {
            let trunk = x + 6.0;
            let mut y = 0.0;
            let mut widest: f64 = 0.0;
            for leaf in column {
                let shape = self.shape(leaf);
                let (w, h) = (shape.w, shape.h);
                let middle = y + h / 2.0;
                let start = (trunk, -GAP * 0.8);
                let end = (trunk + 16.0, middle);
                block.edge(Relation::SupportedBy, &[start, (trunk, middle), end]);
                block.shapes.push(Shape {
                    x: trunk + 16.0,
                    y,
                    ..shape
                });
                widest = widest.max(w);
                y += h + GAP / 2.0;
            }
            block.h = block.h.max(y - GAP / 2.0);
            trunks.push(trunk);
            x = trunk + 16.0 + widest + GAP / 2.0;
        }
        block.w = x - GAP / 2.0;
        // One line across all trunks; the line from above meets it at the nearest trunk's side.
        let (Some(&first), Some(&last)) = (trunks.first(), trunks.last()) else {
            return block;
        };
        block.edges.push(Edge {
            relation: Relation::SupportedBy,
            head: false,
            points: vec![(first, -GAP * 0.8), (last, -GAP * 0.8)],
        });
        block.port = (first, -GAP * 0.8);
        block
    }

    /// The contexts of some kinds beside an element, each a block of its own.
    fn beside(&mut self, node: &Node, kinds: &[Kind]) -> Vec<Block<'a>> {
        let found: Vec<&'a Node> = node
            .in_context_of
            .iter()
            .filter_map(|id| self.argument.node(id))
            .filter(|context| kinds.contains(&context.kind))
            .collect();
        found
            .into_iter()
            .map(|context| {
                let shape = self.shape(context);
                Block {
                    w: shape.w,
                    h: shape.h,
                    shapes: vec![shape],
                    ..Block::default()
                }
            })
            .collect()
    }

    /// An element sized to its text, at the origin.
    fn shape(&mut self, node: &'a Node) -> Shape<'a> {
        self.placed.insert(node.id.clone());
        // The ellipse and the circle are as large as their text's rectangle needs.
        let root_2 = std::f64::consts::SQRT_2;
        let inner = match node.kind {
            Kind::Goal | Kind::CounterGoal => 164.0,
            Kind::Strategy => 190.0,
            Kind::Context => 190.0,
            Kind::Assumption | Kind::Justification => 176.0,
            Kind::Solution | Kind::CounterSolution => 108.0,
        };
        let lines = wrap(&node.text, inner);
        // Bold letters are up to a fifth wider.
        let id = wrap(&node.id, inner / 1.2);
        // The id above the text, the standing below it.
        let extra = if node.standing.is_some() { 2.0 } else { 1.0 };
        let height = LINE * (lines.len() as f64 + extra);
        let (w, h) = match node.kind {
            Kind::Goal | Kind::CounterGoal | Kind::Context => (inner + 20.0, height + 14.0),
            Kind::Strategy => (inner + 52.0, height + 14.0),
            Kind::Assumption | Kind::Justification => (inner * root_2, height * root_2 + 4.0),
            Kind::Solution | Kind::CounterSolution => {
                let diameter = inner.hypot(height) + 8.0;
                (diameter, diameter)
            }
        };
        let folded = self.folded.contains(&node.id) && !node.supported_by.is_empty();
        let below = if node.is_undeveloped() || folded {
            DIAMOND + 4.0
        } else {
            0.0
        };
        Shape {
            node,
            x: 0.0,
            y: 0.0,
            w,
            h: h + below,
            body: h,
            id,
            lines,
            folded,
        }
    }
}

/// The parts in rows no wider than [`WIDEST`], with whether a row is the last one. The line to the
/// rows below goes down in the middle of a row, between two parts: such a row has an even number.
fn rows(parts: Vec<Block<'_>>) -> Vec<(Vec<Block<'_>>, bool)> {
    let mut rows: Vec<Vec<Block<'_>>> = Vec::new();
    let mut left: std::collections::VecDeque<Block<'_>> = parts.into();
    while !left.is_empty() {
        let mut count = 1;
        while count < left.len() && width_of(left.iter().take(count + 1)) <= WIDEST {
            count += 1;
        }
        if count < left.len() && count > 1 {
            count -= count % 2;
        }
        rows.push(left.drain(..count).collect());
    }
    let number = rows.len();
    let last = |(index, row)| (row, index + 1 == number);
    rows.into_iter().enumerate().map(last).collect()
}

fn width_of<'a, 'b: 'a>(parts: impl Iterator<Item = &'a Block<'b>>) -> f64 {
    parts.map(|part| part.w + GAP).sum::<f64>() - GAP
}

/// Hangs a row of parts under the port of a block, each on a line from `bottom`.
fn hang_row<'a>(block: &mut Block<'a>, row: Vec<Block<'a>>, last: bool, top: f64, bottom: f64) {
    let bus = top - GAP * 0.8;
    let half: f64 = if last || row.len() < 2 {
        width_of(row.iter()) / 2.0
    } else {
        width_of(row.iter().take(row.len() / 2)) + GAP / 2.0
    };
    let alone = !last && row.len() == 1;
    let port = block.port.0;
    // A part that is alone in its row leaves room at its left for the line to the rows below.
    let mut x = if alone { port + GAP } else { port - half };
    if x < 0.0 {
        let shift = -x;
        let whole = std::mem::take(block);
        let port = whole.port;
        block.absorb(whole, shift, 0.0);
        block.port = (port.0 + shift, port.1);
        x = 0.0;
    }
    let port = block.port.0;
    for part in row {
        let at = (x + part.port.0, top + part.port.1);
        // Columns of solutions bring their own lines, from the height of the bus on.
        block.edges.push(Edge {
            relation: Relation::SupportedBy,
            head: at.1 > bus,
            points: vec![(port, bottom), (port, bus), (at.0, bus), at],
        });
        let width = part.w;
        block.absorb(part, x, top);
        x += width + GAP;
    }
}
