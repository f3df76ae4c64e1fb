//! Pictures of sweeps: Fig. 5 of β, σ and the speed, and maps of any other parameters.

mod cells;
mod fig5;
mod maps;

pub use fig5::draw;
pub use maps::{Borders as MapBorders, MOST_MAPS, draw as draw_maps, shown};

use passivity_plot::frame::Frame;
use passivity_plot::svg::{DARK, HATCHED, Pixel, Stroke, Svg, rectangle};
use passivity_scene::plane::Extent;

use crate::sweep::{Grid, Row};
use cells::Cell;

/// The frame of the cells of two axes.
fn frame(columns: &[Cell], lines: &[Cell], from: Pixel, to: Pixel) -> Frame {
    let extent = |cells: &[Cell]| {
        let span = cells::span(cells);
        Extent {
            from: span.start,
            to: span.end,
            log: false,
        }
    };
    Frame {
        x: extent(columns),
        y: extent(lines),
        from,
        to,
    }
}

/// Fills a cell of a frame.
fn fill(svg: &mut Svg, frame: &Frame, column: &Cell, line: &Cell, colour: &str) {
    let corners = rectangle(
        frame.clamped([column.low, line.high]),
        frame.clamped([column.high, line.low]),
    );
    svg.cell(&corners, colour);
}

/// Marks a cell as undecided: hatched, with a cross.
fn undecided(svg: &mut Svg, frame: &Frame, column: &Cell, line: &Cell) {
    fill(svg, frame, column, line, HATCHED);
    cross(svg, frame.clamped([column.at, line.at]));
}

fn cross(svg: &mut Svg, [x, y]: Pixel) {
    let line = Stroke::solid(DARK, 1.5);
    svg.line(&[[x - 3.0, y - 3.0], [x + 3.0, y + 3.0]], line);
    svg.line(&[[x - 3.0, y + 3.0], [x + 3.0, y - 3.0]], line);
}

/// A swatch of a key with its edge.
fn swatch(svg: &mut Svg, [x, y]: Pixel, colour: &str) {
    let corners = rectangle([x, y], [x + 22.0, y + 14.0]);
    svg.area(&corners, colour);
    let mut edge = corners.to_vec();
    edge.extend(edge.first().copied());
    svg.line(&edge, Stroke::solid(DARK, 0.7));
}

/// The row of a point of the grid.
fn row(grid: &Grid, rows: &[Option<Row>], at: [usize; 3]) -> Option<Row> {
    rows.get(grid.index(at)).copied().flatten()
}
