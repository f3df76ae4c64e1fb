//! The (β, σ) plane of Figs. 3 and 4: regions, critical lines, and where each scene sits.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::PlotError;

/// A scene in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What the legend calls it.
    pub name: String,
    /// β.
    pub beta: f64,
    /// σ.
    pub sigma: f64,
    /// The least and the largest β and σ within the tolerances, where they have any.
    pub tolerance: Option<[(f64, f64); 2]>,
    /// The speed of its critical line (9), in ticks per sample, and what the legend calls it.
    pub speed: Option<(f64, String)>,
    /// The verdict, for the legend.
    pub verdict: String,
}

const WIDTH: u32 = 1000;
const HEIGHT: u32 = 640;
const PLOT_WIDTH: u32 = 640;

/// Okabe and Ito's palette: told apart by colour-blind readers too.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(140, 100, 0),
    RGBColor(90, 90, 90),
];

const GREEN: RGBColor = RGBColor(223, 240, 216);
const YELLOW: RGBColor = RGBColor(252, 244, 210);
const ORANGE: RGBColor = RGBColor(252, 230, 210);
const RED: RGBColor = RGBColor(246, 214, 214);

/// Draws the plane with the marks in it, as SVG text.
///
/// From every mark start the ways of Fig. 4: a stiffer or softer wall moves it along the line
/// through the origin, halving the sampling period to twice β, a twice as fine encoder to twice σ.
///
/// # Errors
///
/// A mark whose coordinates are no finite numbers.
pub fn draw(marks: &[Mark]) -> Result<String, PlotError> {
    let finite = |mark: &Mark| {
        let ends = mark.tolerance.into_iter().flatten();
        let mut all = ends.chain([(mark.beta, mark.sigma)]);
        all.all(|(a, b)| a.is_finite() && b.is_finite())
    };
    if !marks.iter().all(finite) {
        return Err(PlotError::new(
            "plane: a scene lies too far out to be drawn",
        ));
    }
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)).into_drawing_area();
        draw_on(&root, marks).map_err(|error| PlotError::new(format!("plane: {error}")))?;
        root.present()
            .map_err(|error| PlotError::new(format!("plane: {error}")))?;
    }
    Ok(svg)
}

type Drawn = Result<(), Box<dyn std::error::Error>>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn draw_on(root: &Area<'_>, marks: &[Mark]) -> Drawn {
    root.fill(&WHITE)?;
    let (left, right) = root.split_horizontally(PLOT_WIDTH);
    let reach = |of: fn(&Mark) -> f64| marks.iter().map(of).fold(0.0_f64, f64::max);
    // At least the paper's window; room for the arrows to 2β and 2σ unless they lead far out.
    let beta = |m: &Mark| m.tolerance.map_or(m.beta, |[(_, most), _]| most);
    let sigma = |m: &Mark| m.tolerance.map_or(m.sigma, |[_, (_, most)]| most);
    let width = (reach(beta) * 1.25).max(1.25);
    let height = (reach(sigma) * 1.25).max(1.25);
    let mut chart = ChartBuilder::on(&left)
        .margin(16)
        .x_label_area_size(46)
        .y_label_area_size(60)
        .build_cartesian_2d(0.0..width, 0.0..height)?;
    let regions = [
        ((0.5, 0.5), (width, height), GREEN),
        ((0.0, 0.5), (0.5, height), YELLOW),
        ((0.5, 0.0), (width, 0.5), ORANGE),
        ((0.0, 0.0), (0.5, 0.5), RED),
    ];
    chart.draw_series(regions.map(|(a, b, colour)| Rectangle::new([a, b], colour.filled())))?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc("β = b/(KT)")
        .y_desc("σ = c/(KΔ)")
        .axis_desc_style(("sans-serif", 16))
        .label_style(("sans-serif", 13))
        .draw()?;
    let border = BLACK.mix(0.6).stroke_width(1);
    chart.draw_series(LineSeries::new([(0.5, 0.0), (0.5, height)], border))?;
    chart.draw_series(LineSeries::new([(0.0, 0.5), (width, 0.5)], border))?;
    for (mark, colour) in marks.iter().zip(COLOURS.iter().cycle()) {
        draw_ways(&mut chart, mark, *colour, (width, height))?;
        if let Some([(b0, b1), (s0, s1)]) = mark.tolerance {
            let corners = [(b0, s0), (b1, s1)];
            chart.draw_series([
                Rectangle::new(corners, colour.mix(0.3).filled()),
                Rectangle::new(corners, colour.stroke_width(1)),
            ])?;
        }
        if let Some((speed, _)) = &mark.speed {
            let line = critical_line(*speed, (width, height));
            chart.draw_series(LineSeries::new(line, colour.stroke_width(2)))?;
        }
    }
    let to_pixel = |x: f64, y: f64| chart.backend_coord(&(x, y));
    let mut spots = Vec::new();
    for (number, (mark, colour)) in marks.iter().zip(COLOURS.iter().cycle()).enumerate() {
        let place = to_pixel(mark.beta, mark.sigma);
        root.draw(&Circle::new(place, 5, colour.filled()))?;
        let label = (number + 1).to_string();
        let spot = free_spot(&spots, place);
        spots.push(spot);
        root.draw(&Text::new(
            label,
            spot,
            ("sans-serif", 15).into_font().color(colour),
        ))?;
    }
    legend(&right, marks)
}

/// A place near `place` for a number that no other number has taken.
fn free_spot(taken: &[(i32, i32)], place: (i32, i32)) -> (i32, i32) {
    let candidates = [
        (8, -16),
        (8, 4),
        (-16, -16),
        (-16, 4),
        (20, -16),
        (20, 4),
        (32, -16),
        (32, 4),
    ];
    let free = |(x, y): (i32, i32)| {
        taken
            .iter()
            .all(|(a, b)| (a - x).abs() > 11 || (b - y).abs() > 14)
    };
    let moved = candidates.map(|(dx, dy)| (place.0 + dx, place.1 + dy));
    moved
        .into_iter()
        .find(|spot| free(*spot))
        .unwrap_or(moved[0])
}

/// The critical line (9), σ = ½ − v(β − ½), within the window.
fn critical_line(speed: f64, (width, height): (f64, f64)) -> Vec<(f64, f64)> {
    let sigma = |beta: f64| 0.5 - speed * (beta - 0.5);
    let beta = |sigma: f64| 0.5 + (0.5 - sigma) / speed;
    // Through (½, ½), falling: it enters by the left or the upper edge and leaves by the right or
    // the lower one.
    let start = if sigma(0.0) <= height {
        (0.0, sigma(0.0))
    } else {
        (beta(height), height)
    };
    let end = if sigma(width) >= 0.0 {
        (width, sigma(width))
    } else {
        (beta(0.0), 0.0)
    };
    vec![start, end]
}

type Chart<'a, 'b> = ChartContext<
    'a,
    SVGBackend<'b>,
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
>;

/// Where stiffness, sampling period and resolution move a mark (Fig. 4).
fn draw_ways(
    chart: &mut Chart<'_, '_>,
    mark: &Mark,
    colour: RGBColor,
    (width, height): (f64, f64),
) -> Drawn {
    let thin = colour.mix(0.55).stroke_width(1);
    // Softer walls lie further out on the line through the origin.
    let out = [width / mark.beta, height / mark.sigma]
        .into_iter()
        .filter(|x| x.is_finite())
        .fold(f64::INFINITY, f64::min);
    if out.is_finite() {
        let far = (mark.beta * out, mark.sigma * out);
        let dashes = DashedLineSeries::new([(0.0, 0.0), far], 3, 4, thin);
        chart.draw_series(dashes)?;
    }
    let right = (mark.beta * 2.0).min(width);
    let up = (mark.sigma * 2.0).min(height);
    chart.draw_series(LineSeries::new(
        [(mark.beta, mark.sigma), (right, mark.sigma)],
        thin,
    ))?;
    chart.draw_series(LineSeries::new(
        [(mark.beta, mark.sigma), (mark.beta, up)],
        thin,
    ))?;
    for ((x, y), (dx, dy)) in [((right, mark.sigma), (-1, 0)), ((mark.beta, up), (0, 1))] {
        let head = EmptyElement::at((x, y))
            + Polygon::new(
                [
                    (0, 0),
                    (7 * dx + 3 * dy, 7 * dy + 3 * dx),
                    (7 * dx - 3 * dy, 7 * dy - 3 * dx),
                ],
                colour.mix(0.55).filled(),
            );
        chart.draw_series([head])?;
    }
    Ok(())
}

/// What colours, numbers and lines mean.
fn legend(area: &Area<'_>, marks: &[Mark]) -> Drawn {
    let text = |x: i32, y: i32, words: String, size: i32| {
        area.draw(&Text::new(
            words,
            (x, y),
            ("sans-serif", size).into_font().color(&BLACK),
        ))
    };
    let mut y = 20;
    let regions = [
        (GREEN, "globally stable"),
        (YELLOW, "locally stable: up to the critical speed"),
        (ORANGE, "limit cycles"),
        (RED, "unstable"),
    ];
    for (colour, name) in regions {
        area.draw(&Rectangle::new([(4, y), (22, y + 13)], colour.filled()))?;
        area.draw(&Rectangle::new([(4, y), (22, y + 13)], BLACK.mix(0.4)))?;
        text(30, y, name.to_owned(), 14)?;
        y += 22;
    }
    y += 10;
    let grey = RGBColor(90, 90, 90);
    for x in [4, 12, 20] {
        area.draw(&PathElement::new(
            [(x, y + 7), (x + 5, y + 7)],
            grey.stroke_width(1),
        ))?;
    }
    text(30, y, "another stiffness K".to_owned(), 14)?;
    y += 22;
    area.draw(&PathElement::new(
        [(4, y + 7), (22, y + 7)],
        grey.stroke_width(1),
    ))?;
    area.draw(&Polygon::new(
        [(24, y + 7), (17, y + 4), (17, y + 10)],
        grey.filled(),
    ))?;
    text(30, y, "half the sampling period T".to_owned(), 14)?;
    y += 22;
    area.draw(&PathElement::new(
        [(13, y), (13, y + 15)],
        grey.stroke_width(1),
    ))?;
    area.draw(&Polygon::new(
        [(13, y - 1), (10, y + 6), (16, y + 6)],
        grey.filled(),
    ))?;
    text(30, y, "half the encoder resolution Δ".to_owned(), 14)?;
    y += 32;
    for (number, (mark, colour)) in marks.iter().zip(COLOURS.iter().cycle()).enumerate() {
        // What does not fit is said, not cut off.
        if y > i32::try_from(HEIGHT).unwrap_or(i32::MAX) - 70 && number + 1 < marks.len() {
            text(30, y, format!("and {} more", marks.len() - number), 14)?;
            break;
        }
        area.draw(&Circle::new((12, y + 7), 5, colour.filled()))?;
        text(
            30,
            y,
            format!("{}  {}", number + 1, clipped(&mark.name, 40)),
            15,
        )?;
        y += 19;
        text(
            30,
            y,
            format!(
                "β = {}, σ = {}: {}",
                five(mark.beta),
                five(mark.sigma),
                mark.verdict
            ),
            12,
        )?;
        y += 17;
        if let Some((_, name)) = &mark.speed {
            area.draw(&PathElement::new(
                [(4, y + 6), (22, y + 6)],
                colour.stroke_width(2),
            ))?;
            text(30, y, format!("critical line at {name}"), 12)?;
            y += 17;
        }
        y += 8;
    }
    Ok(())
}

/// A name that fits its place.
fn clipped(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        return name.to_owned();
    }
    name.chars().take(most - 1).chain(['…']).collect()
}

/// About four significant digits.
fn five(x: f64) -> String {
    if x == 0.0 || (1e-3..1e5).contains(&x) {
        let digits = if x >= 100.0 { 1 } else { 4 };
        let text = format!("{x:.digits$}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{x:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn critical_lines_pass_through_the_corner_and_stay_in_the_window() {
        for speed in [0.01, 0.5, 1.0, 3.0, 100.0] {
            let window = (1.5, 1.25);
            let line = critical_line(speed, window);
            let ((x0, y0), (x1, y1)) = (line[0], line[1]);
            // Collinear with (½, ½): a cross product of numbers below 2, so rounding is < 1e-14.
            let cross = (x1 - x0) * (0.5 - y0) - (y1 - y0) * (0.5 - x0);
            assert!(cross.abs() < 1e-14, "{speed}: {cross}");
            for (x, y) in line {
                assert!((0.0..=window.0).contains(&x) && (0.0..=window.1).contains(&y));
            }
        }
    }

    #[test]
    fn a_point_too_far_out_is_an_error() {
        let mark = Mark {
            name: "far".to_owned(),
            beta: f64::INFINITY,
            sigma: 1.0,
            tolerance: None,
            speed: None,
            verdict: String::new(),
        };
        assert!(draw(&[mark]).is_err());
    }
}
