//! The region of the plane where the criterion holds: its outline and its border.

use super::column::{Plane, Speeds};
use super::extent::{Along, Extent};
use super::spans::{End, Span};

/// Places in the units of the axes, x and y.
pub type Line = Vec<[f64; 2]>;

/// Where the criterion holds within a window of the plane.
///
/// Every place of it is a decimal of a few digits at which the criterion holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    /// The parts of the region as closed lines, with the region on the left of the way.
    pub outlines: Vec<Line>,
    /// The parts of the outlines that are no edge of the window, in the same direction.
    pub borders: Vec<Line>,
}

/// How far from each other columns are at most, in parts of the window.
const COARSE: f64 = 1.0 / 16.0;

/// How far a border may be from the straight line between two columns, in parts of the window.
const STRAIGHT: f64 = 1.0 / 1200.0;

/// How near to each other columns are while the border only bends, in parts of the window.
const NEAREST: f64 = 1.0 / 4000.0;

/// A larger step of the border than this between the nearest columns is a jump.
const JUMP: f64 = 1.0 / 100.0;

/// The spans at a number of the outer axis.
#[derive(Clone, Debug)]
struct Column {
    share: f64,
    at: f64,
    spans: Vec<Span>,
}

impl Region {
    /// The region of a plane within a window, at the speeds asked for.
    #[must_use]
    pub fn of(plane: &Plane, window: &[Extent; 2], speeds: Speeds) -> Self {
        let inner = plane.inner();
        let finder = Finder {
            plane,
            inner,
            speeds,
            outer: *inner.other().of(window),
            inner_extent: *inner.of(window),
        };
        let columns = finder.columns();
        let mut region = Self::default();
        for strip in strips(&columns) {
            strip.outline(&mut region);
        }
        if inner == Along::X {
            // x and y change places, and with them left and right.
            for line in region.outlines.iter_mut().chain(&mut region.borders) {
                line.reverse();
                line.iter_mut().for_each(|place| place.swap(0, 1));
            }
        }
        region
    }
}

struct Finder<'a> {
    plane: &'a Plane,
    inner: Along,
    speeds: Speeds,
    outer: Extent,
    inner_extent: Extent,
}

impl Finder<'_> {
    fn column(&self, share: f64, beside: &[&Column]) -> Column {
        let axis = self.inner.other().of(&self.plane.axes);
        let at = self.outer.decimal(share, axis);
        // The middle of a span nearby: it may be narrower than a cell here.
        let middle = |span: &Span| {
            let [a, b] = span.ends.map(|end| self.inner_extent.share(end.at));
            self.inner_extent.at(0.5 * (a + b))
        };
        let spans = beside.iter().flat_map(|column| &column.spans);
        let hints: Vec<f64> = spans.map(middle).collect();
        Column {
            share,
            at,
            spans: self
                .plane
                .spans(self.inner, at, &self.inner_extent, self.speeds, &hints),
        }
    }

    /// The columns from one edge of the window to the other.
    fn columns(&self) -> Vec<Column> {
        let [first, last] = [0.0, 1.0].map(|share| self.column(share, &[]));
        let mut columns = self.between(&first, &last);
        columns.insert(0, first);
        columns.push(last);
        columns
    }

    /// The columns between two that are needed, in order.
    fn between(&self, a: &Column, b: &Column) -> Vec<Column> {
        let width = b.share - a.share;
        let apart = self.jumps(a, b);
        if !apart && width <= NEAREST {
            return Vec::new();
        }
        let share = 0.5 * (a.share + b.share);
        let mut middle = self.column(share, &[a, b]);
        // No decimal between them, or none that a double tells apart.
        if middle.at == a.at || middle.at == b.at {
            return Vec::new();
        }
        let alike = !apart && !self.jumps(a, &middle) && !self.jumps(&middle, b);
        if alike && width <= COARSE && self.is_straight(a, &middle, b) {
            return vec![middle];
        }
        loop {
            let (left, right) = self.both(a, &middle, b);
            // Where the region narrows to a tip, its span may have been missed from further away.
            let beside = [left.last().unwrap_or(a), right.first().unwrap_or(b)];
            let same = |column: &Column| column.spans.len() == middle.spans.len();
            let again = if beside.iter().all(|column| same(column)) {
                None
            } else {
                Some(self.column(share, &beside)).filter(|again| !same(again))
            };
            let Some(again) = again else {
                return left.into_iter().chain([middle]).chain(right).collect();
            };
            middle = again;
        }
    }

    /// The columns on either side of one, at the same time where there are many.
    fn both(&self, a: &Column, middle: &Column, b: &Column) -> (Vec<Column>, Vec<Column>) {
        if b.share - a.share <= COARSE {
            return (self.between(a, middle), self.between(middle, b));
        }
        std::thread::scope(|scope| {
            let right = scope.spawn(|| self.between(middle, b));
            let left = self.between(a, middle);
            match right.join() {
                Ok(right) => (left, right),
                Err(panic) => std::panic::resume_unwind(panic),
            }
        })
    }

    /// Whether the spans of neighbouring columns do not go on into each other: one of them ends, or its border
    /// jumps, or leaves the window.
    fn jumps(&self, a: &Column, b: &Column) -> bool {
        if a.spans.len() != b.spans.len() {
            return true;
        }
        let near = b.share - a.share <= NEAREST;
        let step = |x: &End, y: &End| {
            let step = self.inner_extent.share(x.at) - self.inner_extent.share(y.at);
            near && (step.abs() > JUMP || x.is_border != y.is_border)
        };
        let mut pairs = a.spans.iter().zip(&b.spans);
        pairs.any(|(x, y)| x.ends.iter().zip(&y.ends).any(|(x, y)| step(x, y)))
    }

    fn is_straight(&self, a: &Column, middle: &Column, b: &Column) -> bool {
        let share = |end: End| self.inner_extent.share(end.at);
        let off = |a: End, m: End, b: End| {
            let alike = a.is_border == m.is_border && m.is_border == b.is_border;
            alike && (0.5 * (share(a) + share(b)) - share(m)).abs() <= STRAIGHT
        };
        let mut all = a.spans.iter().zip(&middle.spans).zip(&b.spans);
        all.all(|((a, m), b)| {
            let ([a0, a1], [m0, m1], [b0, b1]) = (a.ends, m.ends, b.ends);
            off(a0, m0, b0) && off(a1, m1, b1)
        })
    }
}

/// A span through neighbouring columns.
struct Strip {
    /// Of each column its number and the span.
    parts: Vec<(f64, Span)>,
    /// Whether it begins at the edge of the window.
    starts_at_edge: bool,
    /// Whether it ends there.
    ends_at_edge: bool,
}

/// The strips of columns, in the order in which they begin.
fn strips(columns: &[Column]) -> Vec<Strip> {
    let mut done = Vec::new();
    let mut open: Vec<Strip> = Vec::new();
    for (i, column) in columns.iter().enumerate() {
        let last = i + 1 == columns.len();
        if open.len() != column.spans.len() {
            done.append(&mut open);
            let begin = |span: &Span| Strip {
                parts: vec![(column.at, *span)],
                starts_at_edge: i == 0,
                ends_at_edge: last,
            };
            open = column.spans.iter().map(begin).collect();
            continue;
        }
        for (strip, span) in open.iter_mut().zip(&column.spans) {
            strip.parts.push((column.at, *span));
            strip.ends_at_edge = last;
        }
    }
    done.append(&mut open);
    done
}

impl Strip {
    /// Adds the outline, counter-clockwise from its lower left corner, and its border.
    fn outline(&self, region: &mut Region) {
        let low = self.parts.iter().map(|(at, span)| (*at, span.low()));
        let high = self.parts.iter().rev().map(|(at, span)| (*at, span.high()));
        // Each place with whether the way to it is a border: that to the first one closes the outline.
        let mut way = side(low, !self.starts_at_edge);
        way.extend(side(high, !self.ends_at_edge));
        region
            .outlines
            .push(way.iter().map(|(place, _)| *place).collect());
        match way.iter().position(|(_, border)| !border) {
            Some(edge) => way.rotate_left(edge),
            None => way.extend(way.first().copied()),
        }
        let mut line: Line = Vec::new();
        for pair in way.windows(2) {
            let [(from, _), (to, border)] = pair else {
                continue;
            };
            if !border {
                finish(&mut line, region);
            } else if from != to {
                if line.is_empty() {
                    line.push(*from);
                }
                line.push(*to);
            }
        }
        finish(&mut line, region);
    }
}

/// The places of one side of a strip, each with whether the way to it is a border; `first` of that to
/// the first one.
fn side(ends: impl Iterator<Item = (f64, End)>, first: bool) -> Vec<([f64; 2], bool)> {
    let mut before: Option<bool> = None;
    ends.map(|(at, end)| {
        let border = before.map_or(first, |before| before || end.is_border);
        before = Some(end.is_border);
        ([at, end.at], border)
    })
    .collect()
}

fn finish(line: &mut Line, region: &mut Region) {
    if line.len() > 1 {
        region.borders.push(std::mem::take(line));
    }
    line.clear();
}

#[cfg(test)]
mod tests {
    use passivity_core::Truth;

    use super::*;
    use crate::parse::Axis;
    use crate::plane::extent::exact;
    use crate::scene::Scene;

    fn scene(more: &str) -> Scene {
        let text = format!(
            "[device]\nviscous = \"0.5 N s/m\"\ncoulomb = \"0.04 N\"\n[sampling]\nperiod = \"1 ms\"\n\
             [encoder]\nresolution = \"0.03 mm\"\n[wall]\nstiffness = \"0.2 N/mm\"\n{more}"
        );
        Scene::from_toml("arm", &text).unwrap()
    }

    fn plane(scene: &Scene, x: &str, y: &str) -> Plane {
        let axes = [x, y].map(|name| Axis::parse(name, scene).unwrap());
        Plane::new(scene, axes).unwrap()
    }

    const fn linear(from: f64, to: f64) -> Extent {
        Extent {
            from,
            to,
            log: false,
        }
    }

    #[test]
    fn the_border_of_a_plain_wall_is_that_of_the_formula() {
        // b ≥ KT/2 + B and c ≥ KΔ/2 + BΔ/T: K ≤ 1 − 2B and K ≤ 8/3 − 2B, K in N/mm, B in N s/m.
        let scene = scene("");
        let plane = plane(&scene, "stiffness", "damping");
        let region = Region::of(&plane, &[linear(0.0, 3.0), linear(0.0, 0.6)], Speeds::Every);
        assert_eq!(region.borders.len(), 1, "{region:?}");
        for [k, b] in &region.borders[0] {
            assert!((k - (1.0 - 2.0 * b)).abs() < 1e-5, "{k} {b}");
        }
        // From the axis of the stiffness to that of the damping, the region on the left.
        let ends = [
            region.borders[0].first().unwrap(),
            region.borders[0].last().unwrap(),
        ];
        assert!(ends[0][0] > 0.999 && ends[1][0] < 1e-5, "{ends:?}");
    }

    #[test]
    fn a_border_leaves_the_window_where_the_formula_says() {
        // K = 1 − 2B, in N/mm and N s/m, through each edge of the window.
        let scene = scene("");
        let plane = plane(&scene, "stiffness", "damping");
        for log in [false, true] {
            let extent = |from, to| Extent { from, to, log };
            for (stiffness, damping, ends) in [
                ([0.1, 3.0], [0.02, 0.6], [[0.96, 0.02], [0.1, 0.45]]),
                ([0.1, 0.7], [0.02, 0.3], [[0.7, 0.15], [0.4, 0.3]]),
            ] {
                let window = [stiffness, damping].map(|[from, to]| extent(from, to));
                let region = Region::of(&plane, &window, Speeds::Every);
                let border = region.borders.first().unwrap();
                for (found, expected) in [border.first(), border.last()].into_iter().zip(ends) {
                    let [k, b] = *found.unwrap();
                    let off = (k / expected[0] - 1.0)
                        .abs()
                        .max((b / expected[1] - 1.0).abs());
                    assert!(off < 1e-6, "{log}: {k} {b}, {expected:?}");
                }
            }
        }
    }

    #[test]
    fn beside_every_point_of_a_border_the_verdict_changes() {
        let late = "[operator]\nmax_speed = \"40 mm/s\"\n";
        let damped =
            "damping = \"0.1 N s/m\"\nunilateral = true\n[operator]\nmax_speed = \"40 mm/s\"\n";
        let lag = "[amplifier]\ntime_constant = \"0.2 ms\"\n";
        let memory = "damping = \"0.1 N s/m\"\n[operator]\nmax_speed = \"40 mm/s\"\n";
        for (more, x, y, window) in [
            (
                late,
                "stiffness",
                "damping",
                [linear(0.0, 5.0), linear(0.0, 2.0)],
            ),
            (
                late,
                "stiffness",
                "period",
                [linear(0.0, 5.0), linear(0.1, 4.0)],
            ),
            (
                late,
                "coulomb",
                "viscous",
                [linear(0.0, 0.1), linear(0.0, 1.0)],
            ),
            (
                late,
                "resolution",
                "rate",
                [linear(0.0, 0.3), linear(100.0, 2000.0)],
            ),
            (
                damped,
                "period",
                "resolution",
                [linear(0.1, 4.0), linear(0.0, 0.3)],
            ),
            (
                damped,
                "max_speed",
                "damping",
                [linear(1.0, 400.0), linear(0.0, 1.0)],
            ),
            (
                lag,
                "time_constant",
                "stiffness",
                [linear(0.01, 2.0), linear(0.0, 1.2)],
            ),
            (
                memory,
                "damping",
                "period",
                [linear(0.0, 0.6), linear(0.1, 3.0)],
            ),
        ] {
            let scene = scene(more);
            let plane = plane(&scene, x, y);
            for speeds in plane.speeds() {
                let region = Region::of(&plane, &window, speeds);
                let case = format!("{more} {x} {y} {speeds:?}");
                assert!(!region.borders.is_empty(), "{case}");
                for line in &region.borders {
                    for pair in line.windows(2) {
                        beside(&plane, &window, pair, speeds, &case);
                    }
                }
            }
        }
    }

    /// A point of the border passes, and one a little to the right of the way does not.
    fn beside(plane: &Plane, window: &[Extent; 2], pair: &[[f64; 2]], speeds: Speeds, case: &str) {
        let holds = |[x, y]: [f64; 2]| {
            let (x, y) = (exact(x).unwrap(), exact(y).unwrap());
            plane.holds([&x, &y], speeds) == Some(Truth::Holds)
        };
        let (from, to) = (pair[0], pair[1]);
        assert!(holds(from) && holds(to), "{case}: {pair:?}");
        let scale = window.map(|extent| extent.to - extent.from);
        let way = [0, 1].map(|i| (to[i] - from[i]) / scale[i]);
        let length = way[0].hypot(way[1]);
        let middle = [0, 1].map(|i| 0.5 * (from[i] + to[i]));
        let right = [way[1] / length, -way[0] / length];
        let out = [0, 1].map(|i| middle[i] + 2e-3 * right[i] * scale[i]);
        if [0, 1].iter().all(|i| out[*i] > 1e-9 * scale[*i]) {
            assert!(!holds(out), "{case}: {pair:?} {out:?}");
        }
    }
}
