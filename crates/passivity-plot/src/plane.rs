//! The (β, σ) plane of Figs. 3 and 4: regions, critical lines, and where each scene sits.

use passivity_core::rational::{from_wide, to_wide};
use passivity_core::{BigRational, Interval, Loop, Parameter, Scalar as _, Wide};
use passivity_scene::Scene;
use passivity_scene::check::Report;
use passivity_scene::display::range;
use passivity_scene::number::nearest_f64;
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::PlotError;
use crate::critical::Borders;

/// A scene in the plane.
///
/// It stands at β and σ less what its effects cost beyond the ½ of sampling and the ½ of
/// quantization, so that the borders of the regions are its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// What the legend calls it.
    pub name: String,
    /// The least and the largest β less the cost, over the tolerances.
    pub beta: [f64; 2],
    /// The least and the largest σ less the cost.
    pub sigma: [f64; 2],
    /// Where walls of other stiffness stand, from stiff to soft.
    pub softer: Vec<(f64, f64)>,
    /// Where the scene stands with half the sampling period.
    pub faster: (f64, f64),
    /// Where it stands with half the resolution.
    pub finer: (f64, f64),
    /// Whether effects beyond sampling and quantization cost anything.
    pub has_costs: bool,
    /// The speed of its critical line (9), in ticks per sample, and what the legend calls it.
    pub speed: Option<(f64, String)>,
    /// The verdict, for the legend.
    pub verdict: String,
}

impl Mark {
    /// A scene and its report as a mark; `None` without an encoder, because σ needs one.
    #[must_use]
    pub fn of(scene: &Scene, report: &Report) -> Option<Self> {
        report.sigma.as_ref()?;
        let half = BigRational::one().half();
        let ends = |spare: &Interval<BigRational>| {
            [spare.lo(), spare.hi()].map(|x| nearest_f64(&(x + &half)))
        };
        let middle = |x: &Interval<BigRational>| nearest_f64(&x.middle());
        let bound = report.speed_bound.as_ref();
        let bound = bound.map(|v| (middle(v), format!("{} ticks/sample", range(v))));
        let at = scene.point().at;
        // Factors of softness in geometric steps of 9/8, 64 down and 64 up.
        let step = BigRational::new(9.into(), 8.into());
        let factors = (-64..=64_i32).map(|power| step.pow(power));
        Some(Self {
            name: report.scene.clone(),
            beta: ends(&report.spare.viscous),
            sigma: ends(&report.spare.coulomb),
            softer: factors
                .filter_map(|x| moved(&at, Parameter::Stiffness, &x.recip()))
                .collect(),
            faster: moved(&at, Parameter::Period, &half)?,
            finer: moved(&at, Parameter::Resolution, &half)?,
            has_costs: !at.is_plain(),
            speed: bound.filter(|(v, _)| *v > 0.0),
            verdict: report.verdict.name().replace('_', " "),
        })
    }

    /// The middle of the tolerances.
    fn middle(&self) -> (f64, f64) {
        let [a, b] = [self.beta, self.sigma].map(|[lo, hi]| 0.5 * (lo + hi));
        (a, b)
    }
}

/// Where a dimensionless loop stands with one parameter times a factor; `None` where a figure is
/// beyond what the kernel computes.
fn moved(at: &Loop<BigRational>, parameter: Parameter, factor: &BigRational) -> Option<(f64, f64)> {
    let wide = at.map(|_, x| Interval::point(to_wide(x)));
    let value = wide.get(parameter)?.map(|x| x.clone() * to_wide(factor));
    let loops = wide.with(parameter, value).with_costs(COST_BITS)?;
    let criterion = loops.map(|_, x| x.hi().clone()).dimensionless_criterion();
    let place = |spare: &Wide| from_wide(spare).map(|x| nearest_f64(&x) + 0.5);
    Some((place(&criterion.viscous)?, place(&criterion.coulomb)?))
}

/// Bits of the costs of a place in the picture: past those of a double.
const COST_BITS: u32 = 64;

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
    if marks
        .iter()
        .any(|mark| !mark.beta.iter().chain(&mark.sigma).all(|x| x.is_finite()))
    {
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
    let coloured = marks.iter().zip(COLOURS.iter().cycle());
    let placed: Vec<_> = coloured.enumerate().collect();
    let reach = |of: fn(&Mark) -> f64| {
        let all = placed.iter().map(|(_, (mark, _))| of(mark));
        all.fold(0.0_f64, f64::max)
    };
    // At least the paper's window; room for the arrows to 2β and 2σ unless they lead far out.
    let width = (reach(|m| m.beta[1]) * 1.25).max(1.25);
    let height = (reach(|m| m.sigma[1]) * 1.25).max(1.25);
    // Effects may cost more than all the friction there is.
    let left_end = -reach(|m| -m.beta[0]) * 1.1;
    let low_end = -reach(|m| -m.sigma[0]) * 1.1;
    let window = Window {
        x: (left_end, width),
        y: (low_end, height),
    };
    let mut chart = ChartBuilder::on(&left)
        .margin(16)
        .x_label_area_size(46)
        .y_label_area_size(60)
        .build_cartesian_2d(left_end..width, low_end..height)?;
    let regions = [
        ((0.5, 0.5), (width, height), GREEN),
        ((left_end, 0.5), (0.5, height), YELLOW),
        ((0.5, low_end), (width, 0.5), ORANGE),
        ((left_end, low_end), (0.5, 0.5), RED),
    ];
    chart.draw_series(regions.map(|(a, b, colour)| Rectangle::new([a, b], colour.filled())))?;
    let costs = marks.iter().any(|mark| mark.has_costs);
    let less = if costs {
        ", less what further effects cost"
    } else {
        ""
    };
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc(format!("β = b/(KT){less}"))
        .y_desc(format!("σ = c/(KΔ){less}"))
        .axis_desc_style(("sans-serif", 16))
        .label_style(("sans-serif", 13))
        .draw()?;
    let border = BLACK.mix(0.6).stroke_width(1);
    chart.draw_series(LineSeries::new([(0.5, low_end), (0.5, height)], border))?;
    chart.draw_series(LineSeries::new([(left_end, 0.5), (width, 0.5)], border))?;
    for (_, (mark, colour)) in &placed {
        draw_ways(&mut chart, mark, **colour, window)?;
        if let Some((speed, _)) = &mark.speed {
            let line = Borders::PAPER.critical_line(*speed, &(left_end..width), &(low_end..height));
            let line = line.into_iter().flatten();
            chart.draw_series(LineSeries::new(line, colour.stroke_width(2)))?;
        }
        let ([left, right], [low, high]) = (mark.beta, mark.sigma);
        if left < right || low < high {
            let corners = [(left, low), (right, high)];
            chart.draw_series([
                Rectangle::new(corners, colour.mix(0.25).filled()),
                Rectangle::new(corners, colour.stroke_width(1)),
            ])?;
        }
    }
    let to_pixel = |x: f64, y: f64| chart.backend_coord(&(x, y));
    let mut spots = Vec::new();
    for (number, (mark, colour)) in &placed {
        let (beta, sigma) = mark.middle();
        let place = to_pixel(beta, sigma);
        root.draw(&Circle::new(place, 5, colour.filled()))?;
        let label = (number + 1).to_string();
        let spot = free_spot(&spots, place);
        spots.push(spot);
        root.draw(&Text::new(
            label,
            spot,
            ("sans-serif", 15).into_font().color(*colour),
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

/// What the picture shows of the plane: from and to.
#[derive(Clone, Copy, Debug)]
struct Window {
    x: (f64, f64),
    y: (f64, f64),
}

type Chart<'a, 'b> = ChartContext<
    'a,
    SVGBackend<'b>,
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>,
>;

/// Where stiffness, sampling period and resolution move a mark (Fig. 4).
fn draw_ways(chart: &mut Chart<'_, '_>, mark: &Mark, colour: RGBColor, window: Window) -> Drawn {
    let thin = colour.mix(0.55).stroke_width(1);
    let (beta, sigma) = mark.middle();
    let (width, height) = (window.x.1, window.y.1);
    let seen =
        |(x, y): &(f64, f64)| (window.x.0..=width).contains(x) && (window.y.0..=height).contains(y);
    let softer = mark.softer.iter().copied().filter(seen);
    chart.draw_series(DashedLineSeries::new(softer, 3, 4, thin))?;
    let faster = mark.faster;
    let finer = (mark.finer.0, mark.finer.1.min(height));
    let right = faster.0.min(width);
    // Where it leads out of the picture, the way there is drawn as far as the edge.
    let share = if faster.0 > beta {
        (right - beta) / (faster.0 - beta)
    } else {
        1.0
    };
    let faster = (right, (sigma + share * (faster.1 - sigma)).max(window.y.0));
    chart.draw_series(LineSeries::new([(beta, sigma), faster], thin))?;
    chart.draw_series(LineSeries::new([(beta, sigma), finer], thin))?;
    for ((x, y), (dx, dy)) in [(faster, (-1, 0)), (finer, (0, 1))] {
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
        let (beta, sigma) = mark.middle();
        let place = format!("({}, {})", five(beta), five(sigma));
        text(30, y, format!("{place}: {}", mark.verdict), 12)?;
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
    if x == 0.0 || (1e-3..1e5).contains(&x.abs()) {
        let digits = if x.abs() >= 100.0 { 1 } else { 4 };
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
    fn a_point_too_far_out_is_an_error() {
        let mark = Mark {
            name: "far".to_owned(),
            beta: [0.0, f64::INFINITY],
            sigma: [1.0; 2],
            softer: Vec::new(),
            faster: (1.2, 0.6),
            finer: (0.6, 1.2),
            has_costs: false,
            speed: None,
            verdict: String::new(),
        };
        assert!(draw(&[mark]).is_err());
    }
}
