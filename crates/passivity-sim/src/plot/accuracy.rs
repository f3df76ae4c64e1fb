//! Work and precision: the error of each method against its time per interval, log–log.

use passivity_plot::{PlotError, fitted};
use plotters::prelude::*;

use crate::accuracy::{Measured, Table};
use crate::plot::{Area, COLOURS, Drawn, svg};

/// The picture in pixels.
const SIZE: (u32, u32) = (1000, 640);

/// Errors below this are drawn on it, for a double has no more digits; without an error there is nothing to draw.
const FLOOR: f64 = 1e-17;

/// Draws the table of a scene as SVG text.
///
/// # Errors
///
/// A table that cannot be drawn.
pub fn draw(title: &str, table: &Table) -> Result<String, PlotError> {
    svg(SIZE, "accuracy", |root| chart(root, title, table))
}

fn chart(root: &Area<'_>, title: &str, table: &Table) -> Drawn {
    let (title, size) = fitted(title, f64::from(SIZE.0) - 32.0, 18.0);
    let times = table.rows.iter().map(|row| row.nanoseconds.max(0.1));
    let least = times.clone().fold(f64::INFINITY, f64::min).min(10.0);
    let most = times.fold(0.0, f64::max).max(1e3);
    let error = |row: &Measured| row.position.max(row.energy).clamp(FLOOR, 100.0);
    let mut chart = ChartBuilder::on(root)
        .margin(14)
        .caption(title, ("sans-serif", size))
        .x_label_area_size(46)
        .y_label_area_size(76)
        .build_cartesian_2d(
            (least * 0.4..most * 3.0).log_scale(),
            (FLOOR * 0.3..300.0).log_scale(),
        )?;
    chart
        .configure_mesh()
        .light_line_style(WHITE)
        .x_desc("time per interval (ns)")
        .y_desc("relative error of position and energy at the end")
        .x_label_formatter(&|x| power(*x))
        .y_label_formatter(&|y| power(*y))
        .axis_desc_style(("sans-serif", 15))
        .label_style(("sans-serif", 12))
        .draw()?;
    let names = [
        "closed-form",
        "exact",
        "enclosure",
        "reference",
        "euler",
        "rk4",
        "adaptive",
    ];
    for (name, colour) in names.into_iter().zip(COLOURS) {
        let of_method = |row: &&Measured| row.method.name() == name;
        let rows: Vec<&Measured> = table.rows.iter().filter(of_method).collect();
        if rows.is_empty() {
            continue;
        }
        let has_error = |row: &&Measured| row.position.max(row.energy) > 0.0;
        let (rows, exact): (Vec<&Measured>, Vec<&Measured>) = rows.into_iter().partition(has_error);
        let label = match exact.is_empty() {
            true => name.to_owned(),
            false => format!("{name}: error 0, not drawn"),
        };
        let line = rows.iter().map(|row| (row.nanoseconds, error(row)));
        chart.draw_series(LineSeries::new(line, colour.mix(0.6).stroke_width(1)))?;
        // A ring says that the outcome is not the reference's.
        let dots = rows.iter().map(|row| {
            let style = if row.same_outcome {
                colour.filled()
            } else {
                colour.stroke_width(2)
            };
            Circle::new((row.nanoseconds, error(row)), 6, style)
        });
        chart
            .draw_series(dots)?
            .label(label)
            .legend(move |(x, y)| Circle::new((x + 9, y), 5, colour.filled()));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::MiddleRight)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .label_font(("sans-serif", 13))
        .draw()?;
    Ok(())
}

/// A power of ten as 10ⁿ.
fn power(x: f64) -> String {
    let exponent = x.log10().round() as i32;
    let digits: String = exponent
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '0' => '⁰',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '4' => '⁴',
            '5' => '⁵',
            '6' => '⁶',
            '7' => '⁷',
            '8' => '⁸',
            _ => '⁹',
        })
        .collect();
    format!("10{digits}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Method;
    use crate::outcome::ExactOutcome;

    #[test]
    fn what_has_no_error_is_no_point() {
        let row = |method, position| Measured {
            method,
            position,
            velocity: 0.0,
            energy: 0.0,
            exact: ExactOutcome::AtRest,
            same_outcome: true,
            late: 0,
            nanoseconds: 100.0,
        };
        let drawn = |error| {
            let table = Table {
                intervals: 9,
                reference: ExactOutcome::AtRest,
                rows: vec![row(Method::ClosedForm, 1e-15), row(Method::Exact, error)],
                left_out: Vec::new(),
            };
            draw("test", &table).unwrap()
        };
        // Its sign in the key is left.
        let circles = |svg: &str| svg.matches("<circle").count();
        let [none, some] = [0.0, 1e-30].map(drawn);
        assert_eq!(circles(&none) + 1, circles(&some));
        assert!(none.contains("exact: error 0, not drawn"), "{none}");
        assert!(!some.contains("error 0"), "{some}");
    }
}
