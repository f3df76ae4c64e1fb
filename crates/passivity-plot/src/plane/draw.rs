//! The picture of the plane: regions, critical lines, scenes and the ways that lead from them.

use passivity_scene::plane::Extent;

use super::{Mark, key};
use crate::PlotError;
use crate::frame::Frame;
use crate::labels::Labels;
use crate::parameters::{colour, list, scenes};
use crate::svg::{Anchor, BLACK, COLOURS, DARK, Pixel, Stroke, Svg, rectangle};

/// The regions: globally and locally stable, limit cycles, unstable.
pub(super) const REGIONS: [(&str, &str); 4] = [
    ("#a9cf9d", "globally stable"),
    ("#e6f2e0", "locally stable"),
    ("#f6dcb2", "limit cycles"),
    ("#d4917d", "unstable"),
];

const FROM: Pixel = [96.0, 24.0];
const TO: Pixel = [700.0, 560.0];
const WIDTH: f64 = 1080.0;

/// Coordinates further apart than this factor are shown on a logarithmic axis.
const WIDE: f64 = 100.0;

/// Draws the plane with the marks in it, as SVG text.
///
/// From every mark start the ways of Fig. 4: a stiffer or softer wall moves it along the line
/// through the origin, halving the sampling period to twice β, a twice as fine encoder to twice σ.
///
/// # Errors
///
/// A mark whose coordinates are no finite numbers.
pub fn draw(marks: &[Mark]) -> Result<String, PlotError> {
    draw_on_axes(marks, [None, None])
}

/// The same with axes of which it is said whether they are logarithmic.
///
/// # Errors
///
/// See [`draw`].
pub fn draw_on_axes(marks: &[Mark], log: [Option<bool>; 2]) -> Result<String, PlotError> {
    let finite = |mark: &Mark| {
        let shown = mark.shown();
        let mut all = shown.as_flattened().iter().chain([&mark.at.0, &mark.at.1]);
        all.all(|x| x.is_finite())
    };
    if !marks.iter().all(finite) {
        return Err(PlotError::new(
            "plane: a scene lies too far out to be drawn",
        ));
    }
    let values = |of: fn([[f64; 2]; 2]) -> [f64; 2]| {
        let shown = marks.iter().map(Mark::shown);
        shown.flat_map(of).collect::<Vec<_>>()
    };
    let [log_x, log_y] = log;
    let frame = Frame {
        x: extent(&values(|[beta, _]| beta), log_x),
        y: extent(&values(|[_, sigma]| sigma), log_y),
        from: FROM,
        to: TO,
    };
    let mut svg = Svg::new([WIDTH, key::height(marks).max(TO[1] + 60.0)]);
    regions(&mut svg, &frame);
    for (number, mark) in marks.iter().enumerate() {
        ways(&mut svg, &frame, mark, colour(number));
    }
    let mut labels = Labels::new(&frame);
    for (number, mark) in marks.iter().enumerate() {
        critical_line(&mut svg, &frame, &mut labels, mark, line_of(number));
    }
    let less = if marks.iter().any(|mark| mark.has_costs) {
        ", less what further effects cost"
    } else {
        ""
    };
    let words = [format!("β = b/(KT){less}"), format!("σ = c/(KΔ){less}")];
    frame.draw(&mut svg, words.each_ref().map(String::as_str));
    names(&mut svg, &frame, &mut labels, marks);
    for (number, mark) in marks.iter().enumerate() {
        tolerances(&mut svg, &frame, mark, colour(number));
    }
    let placed = marks.iter().map(|mark| {
        let (beta, sigma) = mark.at;
        (Some(frame.clamped([beta, sigma])), mark.verdict)
    });
    for (place, numbers) in scenes(&mut svg, &mut labels, placed) {
        labels.beside(&mut svg, place, &list(&numbers));
    }
    key::draw(&mut svg, marks, [TO[0] + 28.0, FROM[1]]);
    Ok(svg.finish())
}

/// What an axis shows: at least the paper's window, with room for the ways to twice as much; effects
/// may cost more than all the friction there is.
fn extent(values: &[f64], log: Option<bool>) -> Extent {
    let most = values.iter().copied().fold(0.5, f64::max);
    let positive = values.iter().copied().filter(|x| *x > 0.0);
    let least_positive = positive.fold(0.5, f64::min);
    let least = values.iter().copied().fold(0.0, f64::min);
    let all_positive = values.iter().all(|x| *x > 0.0);
    if log.unwrap_or(all_positive && most > WIDE * least_positive) {
        return Extent {
            from: least_positive / 2.5,
            to: most * 2.5,
            log: true,
        };
    }
    Extent {
        from: 1.1 * least,
        to: (1.25 * most).max(1.25),
        log: false,
    }
}

fn regions(svg: &mut Svg, frame: &Frame) {
    let [x, y] = frame.pixel([0.5, 0.5]);
    let ([left, top], [right, bottom]) = (frame.from, frame.to);
    let corners = [[right, top], [left, top], [right, bottom], [left, bottom]];
    for (corner, (fill, _)) in corners.into_iter().zip(REGIONS) {
        svg.area(&rectangle([x, y], corner), fill);
    }
    svg.line(&[[x, top], [x, bottom]], Stroke::solid(DARK, 1.0));
    svg.line(&[[left, y], [right, y]], Stroke::solid(DARK, 1.0));
}

/// The names of the regions in their outer corners, where there is room, or beside a way that leads through.
fn names(svg: &mut Svg, frame: &Frame, labels: &mut Labels, marks: &[Mark]) {
    const SIZE: f64 = 12.0;
    let [x, y] = frame.pixel([0.5, 0.5]);
    let ([left, top], [right, bottom]) = (frame.from, frame.to);
    let corners = [[right, top], [left, top], [right, bottom], [left, bottom]];
    let ways: Vec<[Pixel; 2]> = marks
        .iter()
        .flat_map(|mark| {
            let (beta, sigma) = mark.at;
            let from = frame.clamped([beta, sigma]);
            [mark.faster, mark.finer].map(|(x, y)| [from, frame.clamped([x, y])])
        })
        .collect();
    for ([cx, cy], (_, name)) in corners.into_iter().zip(REGIONS) {
        let long = crate::frame::width(name, SIZE) + 8.0;
        if (cx - x).abs() < long || (cy - y).abs() < 24.0 {
            continue;
        }
        let height = cy + (y - cy).signum() * 12.0;
        let outer = cx + (x - cx).signum() * 0.5 * long;
        let inner = x - (x - cx).signum() * 0.5 * long;
        let is_free = |at: &f64| {
            let half = [0.5 * long, 8.0];
            !ways.iter().any(|way| crosses(way, [*at, height], half))
        };
        let at = [outer, inner].into_iter().find(is_free).unwrap_or(outer);
        let middle = [at, height];
        labels.take_box(middle, [0.5 * long, 8.0]);
        let place = [middle[0], middle[1] + 4.0];
        svg.text_over(place, SIZE, Anchor::Middle, name, BLACK);
    }
}

/// Whether a way along an axis leads through a box.
fn crosses([from, to]: &[Pixel; 2], middle: Pixel, half: [f64; 2]) -> bool {
    let mut axes = from.iter().zip(to).zip(middle.iter().zip(half));
    axes.all(|((a, b), (at, half))| a.min(*b) <= at + half && a.max(*b) >= at - half)
}

/// Where stiffness, sampling period and resolution move a mark (Fig. 4).
fn ways(svg: &mut Svg, frame: &Frame, mark: &Mark, colour: &str) {
    let seen: Vec<Pixel> = mark
        .softer
        .iter()
        .filter(|(beta, sigma)| frame.contains([*beta, *sigma]))
        .map(|(beta, sigma)| frame.pixel([*beta, *sigma]))
        .collect();
    svg.line(
        &seen,
        Stroke {
            colour,
            width: 1.0,
            dash: "3 4",
        },
    );
    let (beta, sigma) = mark.at;
    let from = frame.clamped([beta, sigma]);
    for (x, y) in [mark.faster, mark.finer] {
        let to = frame.clamped([x, y]);
        svg.line(&[from, to], Stroke::solid(colour, 1.0));
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = dx.hypot(dy);
        // A way that leaves the frame has no end in it.
        if length < 8.0 || !frame.contains([x, y]) {
            continue;
        }
        let (dx, dy) = (dx / length, dy / length);
        let back = [to[0] - 8.0 * dx, to[1] - 8.0 * dy];
        let head = [
            to,
            [back[0] - 3.0 * dy, back[1] + 3.0 * dx],
            [back[0] + 3.0 * dy, back[1] - 3.0 * dx],
        ];
        svg.area(&head, colour);
    }
}

/// The critical line of the scene with a number, counted from 0: dashed where its colour is that of another one before it.
pub(super) fn line_of(number: usize) -> Stroke<'static> {
    const DASHES: [&str; 4] = ["", "12 4", "2 3", "12 3 2 3"];
    let dash = DASHES.get(number / COLOURS.len() % DASHES.len());
    Stroke {
        dash: dash.copied().unwrap_or_default(),
        ..Stroke::solid(colour(number), 2.0)
    }
}

/// The line (β − ½)v + (σ − ½) = 0 (9) of a mark's speed bound; straight on linear axes alone.
fn critical_line(
    svg: &mut Svg,
    frame: &Frame,
    labels: &mut Labels,
    mark: &Mark,
    stroke: Stroke<'_>,
) {
    const STEPS: u32 = 400;
    let Some((speed, _)) = &mark.speed else {
        return;
    };
    let shares = (0..=STEPS).map(|i| f64::from(i) / f64::from(STEPS));
    let by_beta = shares.clone().map(|share| {
        let beta = frame.x.at(share);
        [beta, 0.5 - speed * (beta - 0.5)]
    });
    let by_sigma = shares.map(|share| {
        let sigma = frame.y.at(share);
        [0.5 + (0.5 - sigma) / speed, sigma]
    });
    let mut way: Vec<[f64; 2]> = by_beta
        .chain(by_sigma)
        .filter(|at| frame.contains(*at))
        .collect();
    way.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let way: Vec<Pixel> = way.into_iter().map(|at| frame.pixel(at)).collect();
    svg.line(&way, stroke);
    labels.take_line(&way);
}

/// The tolerances of a mark as a box.
fn tolerances(svg: &mut Svg, frame: &Frame, mark: &Mark, colour: &str) {
    let ([left, right], [low, high]) = (mark.beta, mark.sigma);
    if left < right || low < high {
        let (a, b) = (frame.clamped([left, high]), frame.clamped([right, low]));
        let mut edge = rectangle(a, b).to_vec();
        edge.extend(edge.first().copied());
        svg.line(&edge, Stroke::solid("#ffffff", 3.5));
        svg.line(&edge, Stroke::solid(colour, 1.5));
    }
}
