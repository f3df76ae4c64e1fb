//! Energy along a trace: what friction dissipated beyond what was generated, and the passivity observer.

use plotters::prelude::*;

use crate::file::PlotError;

/// A point of the course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// After how many sampling intervals.
    pub interval: f64,
    /// E_d − E_gᴸ so far, at the least, in KΔ².
    pub net: f64,
    /// Σ f·Δξ so far, in KΔ².
    pub observer: f64,
}

/// Blue and vermilion of Okabe and Ito's palette: told apart by colour-blind readers too.
const NET: RGBColor = RGBColor(0, 114, 178);
const OBSERVER: RGBColor = RGBColor(213, 94, 0);

/// Draws a course as SVG text.
///
/// # Errors
///
/// A course without points, or with one that is not finite.
///
/// # Example
///
/// ```
/// use passivity_plot::energy::{Point, draw};
///
/// let course = [
///     Point { interval: 1.0, net: 0.5, observer: -0.1 },
///     Point { interval: 2.0, net: 0.9, observer: -0.2 },
/// ];
/// assert!(draw("a trace", &course).unwrap().starts_with("<svg"));
/// assert!(draw("nothing", &[]).is_err());
/// ```
pub fn draw(title: &str, course: &[Point]) -> Result<String, PlotError> {
    let finite = |p: &Point| p.interval.is_finite() && p.net.is_finite() && p.observer.is_finite();
    let Some(last) = course.last().filter(|_| course.iter().all(finite)) else {
        return Err(PlotError::new("a trace of at least one interval is needed"));
    };
    let start = Point {
        interval: 0.0,
        net: 0.0,
        observer: 0.0,
    };
    let all = || std::iter::once(&start).chain(course);
    let values = || all().flat_map(|p| [p.net, p.observer]);
    let (low, high) = (
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    );
    let air = (0.06 * (high - low)).max(1e-9 * (1.0 + high.abs().max(low.abs())));
    let mut text = String::new();
    let drawn = |text: &mut String| -> Result<(), Box<dyn std::error::Error>> {
        let root = SVGBackend::with_string(text, (900, 520)).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(title, ("sans-serif", 20))
            .margin(12)
            .margin_right(28)
            .x_label_area_size(42)
            .y_label_area_size(80)
            // Room above for the legend, at the height of its two lines.
            .build_cartesian_2d(0.0..last.interval.max(1.0), low - air..high + 3.5 * air)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.1))
            .x_desc("sampling intervals")
            .y_desc("energy from the start (KΔ²)")
            .axis_desc_style(("sans-serif", 15))
            .label_style(("sans-serif", 12))
            .draw()?;
        let zero = [(0.0, 0.0), (last.interval.max(1.0), 0.0)];
        chart.draw_series(LineSeries::new(zero, BLACK.mix(0.5)))?;
        type Key = fn(&Point) -> f64;
        let series: [(&str, Key, RGBColor); 2] = [
            ("dissipated less generated, at least", |p| p.net, NET),
            ("passivity observer Σ f·Δx", |p| p.observer, OBSERVER),
        ];
        for (label, key, colour) in series {
            let points = all().map(move |p| (p.interval, key(p)));
            chart
                .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
                .label(label)
                .legend(move |(x, y)| {
                    PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2))
                });
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE.mix(0.85))
            .border_style(BLACK.mix(0.3))
            .label_font(("sans-serif", 13))
            .draw()?;
        root.present()?;
        Ok(())
    };
    drawn(&mut text).map_err(|error| PlotError::new(error.to_string()))?;
    Ok(text)
}
