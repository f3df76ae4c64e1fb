//! Fig. 5: where in the (β, σ) plane the motion grows (a) and where it never comes to rest (b).

use std::ops::Range;

use passivity_core::BigRational;
use passivity_plot::PlotError;
use passivity_plot::critical::Borders;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use crate::number::to_double;
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::plot::{Area, COLOURS, DASHED, Drawn, label, svg};
use crate::sweep::{Grid, Row};

/// Draws a sweep as SVG text: (a) growing, (b) never at rest, a shade for each speed from black for
/// the slowest to light grey; in (b) dots where the paper's detector sees the oscillation of some
/// speed too. Crosses mark the points of which some speed is undecided.
///
/// The critical lines (9) of the speeds are those of the scene with all its effects.
///
/// # Errors
///
/// A sweep that cannot be drawn.
pub fn draw(grid: &Grid, rows: &[Option<Row>], borders: Borders) -> Result<String, PlotError> {
    svg((1280, 640), "sweep", |root| {
        let lines = "dashed: critical lines, with the speed at the start";
        let undecided = rows.iter().flatten().any(|row| row.is_undecided());
        let crosses = if undecided {
            "; crosses: undecided"
        } else {
            ""
        };
        let root = root.titled(
            &format!("Outcome in the (β, σ) plane; {lines}{crosses}"),
            ("sans-serif", 18),
        )?;
        let (a, b) = root.split_horizontally(640);
        let drawing = Drawing {
            grid,
            rows,
            borders,
        };
        drawing.panel(&a, "(a) growing", ExactOutcome::Growing)?;
        drawing.panel(
            &b,
            "(b) never at rest; dots: |ξ̇| ≥ 0.01 at the end",
            ExactOutcome::NeverAtRest,
        )
    })
}

/// What both panels show.
#[derive(Clone, Copy)]
struct Drawing<'a> {
    grid: &'a Grid,
    rows: &'a [Option<Row>],
    borders: Borders,
}

/// The indices of the speeds, the slowest first.
fn by_speed(grid: &Grid) -> Vec<(usize, f64)> {
    let speeds = grid.speed.iter().map(|v| to_double(v).abs());
    let mut order: Vec<(usize, f64)> = speeds.enumerate().collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1));
    order
}

/// A value of β or σ, and the edges half-way to its neighbours.
struct Cell {
    /// Which of the grid's values it is.
    index: usize,
    low: f64,
    high: f64,
}

impl Cell {
    const fn middle(&self) -> f64 {
        0.5 * (self.low + self.high)
    }
}

/// The cells of an axis, the least value first.
fn cells(values: &[BigRational]) -> Vec<Cell> {
    let mut sorted: Vec<(usize, f64)> = values.iter().map(to_double).enumerate().collect();
    sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
    let edges: Vec<f64> = sorted
        .iter()
        .zip(sorted.iter().skip(1))
        .map(|((_, a), (_, b))| 0.5 * (a + b))
        .collect();
    // The outermost cells are as wide as their inner half.
    let outer = |value: Option<&(usize, f64)>, edge: Option<&f64>| {
        value.map(|(_, x)| edge.map_or(*x, |edge| x + (x - edge)))
    };
    let least = outer(sorted.first(), edges.first());
    let most = outer(sorted.last(), edges.last());
    let lows = least.into_iter().chain(edges.iter().copied());
    let highs = edges.iter().copied().chain(most);
    let with_edges = sorted.iter().zip(lows.zip(highs));
    with_edges
        .map(|((index, _), (low, high))| Cell {
            index: *index,
            low,
            high,
        })
        .collect()
}

/// What the cells of an axis span, never empty.
fn span(cells: &[Cell]) -> Range<f64> {
    let low = cells.first().map_or(0.0, |cell| cell.low);
    let high = cells.last().map_or(0.0, |cell| cell.high);
    if high > low {
        low..high
    } else {
        low - 0.5..high + 0.5
    }
}

/// A drawing in the (β, σ) plane.
type Plane<'a> = ChartContext<'a, SVGBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

impl Drawing<'_> {
    fn panel(self, area: &Area<'_>, title: &str, shown: ExactOutcome) -> Drawn {
        let grid = self.grid;
        let (columns, lines) = (cells(&grid.beta), cells(&grid.sigma));
        let (width, height) = (span(&columns), span(&lines));
        let mut chart = ChartBuilder::on(area)
            .margin(12)
            .caption(title, ("sans-serif", 17))
            .x_label_area_size(44)
            .y_label_area_size(54)
            .build_cartesian_2d(width.clone(), height.clone())?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_desc("β = b/(KT)")
            .y_desc("σ = c/(KΔ)")
            .x_label_formatter(&|x| label(*x, &width))
            .y_label_formatter(&|y| label(*y, &height))
            .axis_desc_style(("sans-serif", 15))
            .label_style(("sans-serif", 12))
            .draw()?;
        let speeds = by_speed(grid);
        let row = |column: &Cell, line: &Cell, speed| {
            let index = grid.index([column.index, line.index, speed]);
            self.rows.get(index).copied().flatten()
        };
        let places = || {
            columns
                .iter()
                .flat_map(|c| lines.iter().map(move |l| (c, l)))
        };
        // The fastest first: a slower one that does the same lies over it.
        for (rank, (speed, _)) in speeds.iter().enumerate().rev() {
            let colour = shade(rank, speeds.len()).filled();
            for (column, line) in places() {
                if row(column, line, *speed).is_some_and(|row| row.exact == shown) {
                    let corners = [(column.low, line.low), (column.high, line.high)];
                    chart.draw_series([Rectangle::new(corners, colour)])?;
                }
            }
        }
        for (column, line) in places() {
            let all = || {
                let at = speeds.iter();
                at.filter_map(|(speed, _)| row(column, line, *speed))
            };
            let place = (column.middle(), line.middle());
            let oscillates = |row: Row| row.paper == PaperOutcome::LimitCycle;
            if shown == ExactOutcome::NeverAtRest && all().any(oscillates) {
                chart.draw_series([Circle::new(place, 2, COLOURS[7].filled())])?;
            }
            if all().any(|row| row.is_undecided()) {
                let colour = COLOURS[1].stroke_width(2);
                chart.draw_series([Cross::new(place, 4, colour)])?;
            }
        }
        draw_borders(&mut chart, self.borders, &speeds, &width, &height)
    }
}

/// From black for the slowest speed to light grey.
fn shade(rank: usize, speeds: usize) -> RGBColor {
    let level = 30 + 190 * rank / (speeds.max(2) - 1);
    let level = u8::try_from(level).unwrap_or(220); // 220 is the most there is.
    RGBColor(level, level, level)
}

/// The borders of β and σ, and the critical line (9) of each speed.
fn draw_borders(
    chart: &mut Plane<'_>,
    borders: Borders,
    speeds: &[(usize, f64)],
    width: &Range<f64>,
    height: &Range<f64>,
) -> Drawn {
    for border in [
        [(borders.beta, height.start), (borders.beta, height.end)],
        [(width.start, borders.sigma), (width.end, borders.sigma)],
    ] {
        chart.draw_series(LineSeries::new(border, BLACK.mix(DASHED)))?;
    }
    for ((_, speed), colour) in speeds.iter().zip(COLOURS.into_iter().cycle()) {
        let Some(ends) = borders.critical_line(*speed, width, height) else {
            continue;
        };
        let style = colour.mix(DASHED).stroke_width(2);
        chart
            .draw_series(LineSeries::new(ends, style))?
            .label(format!("{speed} ticks/sample"))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font(("sans-serif", 13))
        .draw()?;
    Ok(())
}
