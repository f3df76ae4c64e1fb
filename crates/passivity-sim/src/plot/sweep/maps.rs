//! Maps of the outcome over two parameters, one for each value of a third.

use passivity_plot::frame::Frame;
use passivity_plot::svg::{Anchor, BLACK, HATCHED, Stroke, Svg};
use passivity_scene::plane::Line;

use super::cells::cells;
use super::{cross, fill, frame, row, swatch, undecided};
use crate::outcome::ExactOutcome;
use crate::plot::label;
use crate::sweep::{Grid, Row};

/// The most maps in a picture.
pub const MOST_MAPS: usize = 12;

/// For each map that is shown, the borders of where the criterion holds: at every speed, up to the bound.
pub type Borders = Vec<[Vec<Line>; 2]>;

/// The greys of the outcomes that are certain, from light to dark.
const OUTCOMES: [(ExactOutcome, &str, &str); 3] = [
    (ExactOutcome::AtRest, "#e4e4e4", "comes to rest"),
    (ExactOutcome::NeverAtRest, "#9c9c9c", "never at rest"),
    (ExactOutcome::Growing, "#3c3c3c", "grows without end"),
];

/// Which values of the third axis are shown: all, or as many as there is room for, evenly.
#[must_use]
pub fn shown(grid: &Grid) -> Vec<usize> {
    let [_, _, third] = &grid.values;
    let count = third.len();
    if count <= MOST_MAPS {
        return (0..count).collect();
    }
    (0..MOST_MAPS)
        .map(|i| i * (count - 1) / (MOST_MAPS - 1))
        .collect()
}

/// Draws a sweep over parameters of a scene as SVG text.
#[must_use]
pub fn draw(title: &str, grid: &Grid, rows: &[Option<Row>], borders: &Borders) -> String {
    let maps = shown(grid);
    let across: usize = match maps.len() {
        0..=1 => 1,
        2..=4 => 2,
        5..=9 => 3,
        _ => 4,
    };
    let down = maps.len().div_ceil(across);
    let size: f64 = match across {
        1 => 480.0,
        2 => 380.0,
        3 => 290.0,
        _ => 230.0,
    };
    let (wide, high) = (size + 120.0, 0.85 * size + 100.0);
    let number = |n: usize| f64::from(u32::try_from(n).unwrap_or(u32::MAX));
    let width = (number(across) * wide + 40.0).max(760.0);
    let mut svg = Svg::new([width, 60.0 + number(down) * high + 90.0]);
    svg.title(28.0, 18.0, title);
    for (place, third) in maps.iter().enumerate() {
        let left = 90.0 + number(place % across) * wide;
        let top = 76.0 + number(place / across) * high;
        let [columns, lines, values] = &grid.values;
        let (columns, lines) = (cells(columns), cells(lines));
        let frame = frame(
            &columns,
            &lines,
            [left, top],
            [left + size, top + 0.85 * size],
        );
        for (column, line) in columns
            .iter()
            .flat_map(|c| lines.iter().map(move |l| (c, l)))
        {
            match row(grid, rows, [column.index, line.index, *third]).map(|row| row.exact) {
                None => {}
                Some(ExactOutcome::Undecided) => undecided(&mut svg, &frame, column, line),
                Some(outcome) => fill(&mut svg, &frame, column, line, colour(outcome)),
            }
        }
        for (lines, stroke) in borders.get(place).into_iter().flatten().zip(strokes()) {
            for line in lines {
                outline(&mut svg, &frame, line, stroke);
            }
        }
        let [x, y] = [0, 1].map(|i| {
            grid.parameters()
                .get(i)
                .map(|axis| axis.label())
                .unwrap_or_default()
        });
        frame.draw(&mut svg, [&x, &y]);
        if let Some(axis) = grid.parameters().get(2) {
            let value = values.double(*third);
            let words = format!(
                "{} = {} {}",
                axis.name(),
                label(value, &(0.0..value.abs())),
                axis.unit()
            );
            svg.text(
                [left + 0.5 * size, top - 8.0],
                14.0,
                Anchor::Middle,
                words.trim_end(),
            );
        }
    }
    key(&mut svg, 76.0 + number(down) * high, rows, borders);
    svg.finish()
}

fn colour(outcome: ExactOutcome) -> &'static str {
    let found = OUTCOMES.iter().find(|(of, _, _)| *of == outcome);
    found.map_or(HATCHED, |(_, colour, _)| colour)
}

/// The lines of the two borders: at every speed, up to the bound.
const fn strokes() -> [Stroke<'static>; 2] {
    [Stroke::solid(BLACK, 2.0), Stroke::dashed(BLACK, 2.0)]
}

fn outline(svg: &mut Svg, frame: &Frame, line: &[[f64; 2]], stroke: Stroke<'_>) {
    let way: Vec<_> = line.iter().map(|place| frame.clamped(*place)).collect();
    svg.line(&way, Stroke::solid("#ffffff", 4.0));
    svg.line(&way, stroke);
}

fn key(svg: &mut Svg, top: f64, rows: &[Option<Row>], borders: &Borders) {
    let mut x = 60.0;
    let mut next = |svg: &mut Svg, words: &str| {
        svg.text([x + 30.0, top + 12.0], 13.0, Anchor::Start, words);
        x += 46.0 + passivity_plot::frame::width(words, 13.0);
        x
    };
    let mut at = 60.0;
    for (_, colour, words) in OUTCOMES {
        swatch(svg, [at, top], colour);
        at = next(svg, words);
    }
    if rows.iter().flatten().any(|row| row.is_undecided()) {
        swatch(svg, [at, top], HATCHED);
        cross(svg, [at + 11.0, top + 7.0]);
        next(svg, "undecided");
    }
    let has =
        |of: fn(&[Vec<Line>; 2]) -> &Vec<Line>| borders.iter().any(|pair| !of(pair).is_empty());
    let kinds = [
        (has(|[every, _]| every), "border: passive at every speed"),
        (
            has(|[_, bound]| bound),
            "border: passive up to operator.max_speed",
        ),
    ];
    let mut at = 60.0;
    for ((there, words), stroke) in kinds.into_iter().zip(strokes()) {
        if there {
            svg.line(&[[at, top + 32.0], [at + 24.0, top + 32.0]], stroke);
            svg.text([at + 30.0, top + 37.0], 13.0, Anchor::Start, words);
            at += 46.0 + passivity_plot::frame::width(words, 13.0);
        }
    }
    let cells = "a cell stands for one point of the grid, and reaches half-way to the next";
    svg.text([60.0, top + 57.0], 13.0, Anchor::Start, cells);
}
