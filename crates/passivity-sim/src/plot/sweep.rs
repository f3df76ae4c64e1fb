//! Fig. 5: where in the (β, σ) plane the motion grows (a) and where it never comes to rest (b).

use passivity_plot::PlotError;
use plotters::prelude::*;

use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::plot::{Area, COLOURS, DASHED, Drawn, label, svg};
use crate::sweep::{Grid, Row};

/// Draws a sweep as SVG text: (a) growing, (b) never at rest, a shade for each speed from black for
/// the slowest to light grey, with the critical lines (9) of the speeds; in (b) dots where the paper's
/// detector sees the oscillation of some speed too.
///
/// # Errors
///
/// A sweep that cannot be drawn.
pub fn draw(grid: &Grid, rows: &[Option<Row>]) -> Result<String, PlotError> {
    svg((1280, 640), "sweep", |root| {
        let root = root.titled(
            "Outcome in the (β, σ) plane; dashed: critical lines, with the speed at the start",
            ("sans-serif", 18),
        )?;
        let (a, b) = root.split_horizontally(640);
        panel(&a, "(a) growing", grid, rows, ExactOutcome::Growing)?;
        panel(
            &b,
            "(b) never at rest; dots: |ξ̇| ≥ 0.01 at the end",
            grid,
            rows,
            ExactOutcome::NeverAtRest,
        )
    })
}

/// The indices of the speeds, the slowest first.
fn by_speed(grid: &Grid) -> Vec<(usize, f64)> {
    let speeds = grid.speed.iter().map(|v| crate::number::to_double(v).abs());
    let mut order: Vec<(usize, f64)> = speeds.enumerate().collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1));
    order
}

/// The edges of the cells around ascending values: half-way between neighbours.
fn cells(values: &[f64]) -> Vec<(f64, f64)> {
    let middle = |i: usize, j: usize| 0.5 * (values[i] + values[j]);
    let last = values.len() - 1;
    (0..=last)
        .map(|i| {
            let low = if i > 0 { middle(i - 1, i) } else { values[0] };
            let high = if i < last {
                middle(i, i + 1)
            } else {
                values[last]
            };
            // The outermost cells are as wide as their inner half.
            let low = if i == 0 { low - (high - low) } else { low };
            let high = if i == last {
                high + (high - low).max(0.0) * f64::from(i > 0)
            } else {
                high
            };
            (low, high)
        })
        .collect()
}

fn panel(
    area: &Area<'_>,
    title: &str,
    grid: &Grid,
    rows: &[Option<Row>],
    shown: ExactOutcome,
) -> Drawn {
    let order = |values: &[passivity_core::BigRational]| {
        let mut all: Vec<(f64, usize)> = values
            .iter()
            .enumerate()
            .map(|(i, x)| (crate::number::to_double(x), i))
            .collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        all
    };
    let (beta, sigma) = (order(&grid.beta), order(&grid.sigma));
    let values = |all: &[(f64, usize)]| all.iter().map(|(x, _)| *x).collect::<Vec<f64>>();
    let (columns, lines) = (cells(&values(&beta)), cells(&values(&sigma)));
    let span = |cells: &[(f64, f64)]| {
        let (low, high) = (cells[0].0, cells[cells.len() - 1].1);
        if high > low {
            low..high
        } else {
            low - 0.5..high + 0.5
        }
    };
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
    let shade = |rank: usize| {
        let steps = speeds.len().max(2) - 1;
        let level = 30 + 190 * rank / steps;
        let level = u8::try_from(level).unwrap_or(220);
        RGBColor(level, level, level)
    };
    // The fastest first: a slower one that does the same lies over it.
    for (rank, (speed, _)) in speeds.iter().enumerate().rev() {
        let colour = shade(rank).filled();
        for ((_, i), column) in beta.iter().zip(&columns) {
            for ((_, j), line) in sigma.iter().zip(&lines) {
                let index = (i * grid.sigma.len() + j) * grid.speed.len() + speed;
                let row = rows.get(index).copied().flatten();
                if row.is_some_and(|row| row.exact == shown) {
                    let corners = [(column.0, line.0), (column.1, line.1)];
                    chart.draw_series([Rectangle::new(corners, colour)])?;
                }
            }
        }
    }
    if shown == ExactOutcome::NeverAtRest {
        let middle = |(low, high): (f64, f64)| 0.5 * (low + high);
        for ((_, i), column) in beta.iter().zip(&columns) {
            for ((_, j), line) in sigma.iter().zip(&lines) {
                let first = (i * grid.sigma.len() + j) * grid.speed.len();
                let all = rows
                    .get(first..first + grid.speed.len())
                    .unwrap_or_default();
                if all
                    .iter()
                    .flatten()
                    .any(|row| row.paper == PaperOutcome::LimitCycle)
                {
                    let place = (middle(*column), middle(*line));
                    chart.draw_series([Circle::new(place, 2, COLOURS[7].filled())])?;
                }
            }
        }
    }
    for border in [
        [(0.5, height.start), (0.5, height.end)],
        [(width.start, 0.5), (width.end, 0.5)],
    ] {
        chart.draw_series(LineSeries::new(border, BLACK.mix(DASHED)))?;
    }
    for (rank, (_, speed)) in speeds.iter().enumerate() {
        let colour = COLOURS[rank % COLOURS.len()];
        let Some(ends) = critical_line(*speed, &width, &height) else {
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

/// The part of (β − ½)V + (σ − ½) = 0 (9) within the picture.
fn critical_line(
    speed: f64,
    width: &std::ops::Range<f64>,
    height: &std::ops::Range<f64>,
) -> Option<[(f64, f64); 2]> {
    let sigma = |beta: f64| 0.5 - (beta - 0.5) * speed;
    if speed == 0.0 {
        return Some([(width.start, 0.5), (width.end, 0.5)]);
    }
    let beta = |sigma: f64| 0.5 - (sigma - 0.5) / speed;
    let left = width.start.max(beta(height.end));
    let right = width.end.min(beta(height.start));
    (left < right).then(|| [(left, sigma(left)), (right, sigma(right))])
}
