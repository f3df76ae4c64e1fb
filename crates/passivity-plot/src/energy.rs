//! Energy along a trace: what friction dissipated beyond what was generated, and the passivity observer.

use passivity_scene::plane::Extent;

use crate::file::PlotError;
use crate::frame::{Frame, key};
use crate::svg::{COLOURS, LIGHT, Stroke, Svg};

/// A point of the course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// When, in sampling periods from the start.
    pub time: f64,
    /// E_d − E_gᴸ so far, at the least.
    pub net: f64,
    /// Σ f·Δξ so far.
    pub observer: f64,
}

/// Draws a course as SVG text, with energies in a unit.
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
///     Point { time: 1.0, net: 0.5, observer: -0.1 },
///     Point { time: 2.0, net: 0.9, observer: -0.2 },
/// ];
/// assert!(draw("a trace", "KΔ²", &course).unwrap().starts_with("<svg"));
/// assert!(draw("nothing", "J", &[]).is_err());
/// ```
pub fn draw(title: &str, unit: &str, course: &[Point]) -> Result<String, PlotError> {
    let finite = |p: &Point| p.time.is_finite() && p.net.is_finite() && p.observer.is_finite();
    let Some(last) = course.last().filter(|_| course.iter().all(finite)) else {
        return Err(PlotError::new("a trace of at least one interval is needed"));
    };
    let start = Point {
        time: 0.0,
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
    let extent = |from, to| Extent {
        from,
        to,
        log: false,
    };
    let frame = Frame {
        x: extent(0.0, if last.time > 0.0 { last.time } else { 1.0 }),
        y: extent(low - air, high + air),
        from: [110.0, 72.0],
        to: [868.0, 456.0],
    };
    let mut svg = Svg::new([900.0, 520.0]);
    svg.title(30.0, 20.0, title);
    let zero = [frame.x.from, frame.x.to].map(|x| frame.clamped([x, 0.0]));
    svg.line(&zero, Stroke::solid(LIGHT, 1.0));
    type Value = fn(&Point) -> f64;
    let series: [(&str, Value); 2] = [
        ("dissipated less generated, at least", |p| p.net),
        ("passivity observer −Σ f·Δx", |p| p.observer),
    ];
    let [net, observer] = [COLOURS[0], COLOURS[1]].map(|colour| Stroke::solid(colour, 2.0));
    for ((_, value), stroke) in series.iter().zip([net, observer]) {
        let line: Vec<_> = all().map(|p| frame.clamped([p.time, value(p)])).collect();
        svg.line(&line, stroke);
    }
    // Above the frame, where no curve is.
    let keys = [(net, series[0].0), (observer, series[1].0)];
    key(&mut svg, [frame.from[0], 54.0], &keys);
    frame.draw(
        &mut svg,
        [
            "time from the start (sampling periods)",
            &format!("energy from the start ({unit})"),
        ],
    );
    Ok(svg.finish())
}
