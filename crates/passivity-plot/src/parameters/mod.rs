//! The plane of two parameters: where the criterion holds, its border, the scenes and what was measured.

mod key;
mod marks;

use passivity_core::{BigRational, Interval};
use passivity_scene::Axis;
use passivity_scene::check::Verdict;
use passivity_scene::number::nearest_f64;
use passivity_scene::plane::{Extent, Prediction, Region, Speeds};

pub(crate) use marks::{scene, scenes};

use crate::frame::Frame;
use crate::labels::{Labels, length, part_of};
use crate::svg::{BLACK, COLOURS, DARK, Pixel, Stroke, Svg, rectangle};

/// Scenes with the same border, and where the criterion holds for them.
#[derive(Clone, Debug)]
pub struct Group {
    /// Which of the marks they are.
    pub marks: Vec<usize>,
    /// The regions, the smaller one first.
    pub regions: Vec<(Speeds, Region)>,
    /// The bound on the speed for people, where there is one.
    pub bound: Option<String>,
}

/// A scene in the plane.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Its name.
    pub name: String,
    /// Its numbers on the axes over the tolerances; `None` where it has no place on an axis.
    pub ranges: Option<[Interval<BigRational>; 2]>,
    /// Those of the device at the hardest of the ends of the tolerances.
    pub at: Option<[f64; 2]>,
    /// What the key says of its numbers, with units.
    pub place: [String; 2],
    /// The verdict.
    pub verdict: Verdict,
}

/// A measured point.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Its numbers on the axes.
    pub at: [f64; 2],
    /// Whether it was stable.
    pub stable: bool,
    /// What the criterion says of it.
    pub prediction: Prediction,
}

/// All that the picture shows.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The axes.
    pub axes: &'a [Axis; 2],
    /// What is shown of them.
    pub window: [Extent; 2],
    /// The borders.
    pub groups: &'a [Group],
    /// The scenes.
    pub marks: &'a [Mark],
    /// What was measured.
    pub points: &'a [Point],
}

/// Passive at every speed: the darker one, in grey too.
const EVERY: &str = "#a9cf9d";
/// Passive up to the bound on the speed.
const BOUNDED: &str = "#e1f0da";

const FROM: Pixel = [96.0, 24.0];
const TO: Pixel = [700.0, 560.0];
const WIDTH: f64 = 1080.0;

/// Draws the picture as SVG text.
///
/// With one border the regions are shaded; with several each border is a line with the numbers of its
/// scenes and short strokes on the side that is passive.
#[must_use]
pub fn draw(picture: &Picture<'_>) -> String {
    let frame = frame(picture);
    let lines = key::height(picture);
    let mut svg = Svg::new([WIDTH, lines.max(TO[1] + 60.0)]);
    let mut labels = Labels::new(&frame);
    match picture.groups {
        [one] => shaded(&mut svg, &frame, one),
        many => outlined(&mut svg, &frame, many, &mut labels),
    }
    frame.draw(
        &mut svg,
        picture
            .axes
            .each_ref()
            .map(Axis::label)
            .each_ref()
            .map(String::as_str),
    );
    for (number, mark) in picture.marks.iter().enumerate() {
        tolerance_box(&mut svg, &frame, mark, colour(number));
    }
    for point in picture
        .points
        .iter()
        .filter(|point| frame.contains(point.at))
    {
        let place = frame.pixel(point.at);
        labels.take(place, 7.0);
        measured(&mut svg, place, point);
    }
    let marks = picture.marks.iter();
    let marks = marks.map(|mark| (place_of(&frame, mark), mark.verdict));
    let places = scenes(&mut svg, &mut labels, marks);
    let regions = picture.groups.iter().flat_map(|group| &group.regions);
    for border in regions.flat_map(|(_, region)| &region.borders) {
        labels.take_line(&pixels(&frame, border));
    }
    for (place, numbers) in places {
        labels.beside(&mut svg, place, &list(&numbers));
    }
    key::draw(&mut svg, picture, [TO[0] + 28.0, FROM[1]]);
    svg.finish()
}

/// Where the picture shows its window.
const fn frame(picture: &Picture<'_>) -> Frame {
    let [x, y] = picture.window;
    Frame {
        x,
        y,
        from: FROM,
        to: TO,
    }
}

/// The colour of the scene with a number, counted from 0.
pub(crate) fn colour(number: usize) -> &'static str {
    COLOURS
        .get(number % COLOURS.len())
        .copied()
        .unwrap_or(BLACK)
}

/// Where a scene is drawn: at the hardest end of its tolerances, at the edge where that is outside.
fn place_of(frame: &Frame, mark: &Mark) -> Option<Pixel> {
    Some(frame.clamped(mark.at?))
}

/// Whether a scene is drawn at the edge because it is outside the picture.
fn is_outside(window: &[Extent; 2], mark: &Mark) -> bool {
    let shares = mark
        .at
        .map(|[x, y]| [window[0].share(x), window[1].share(y)]);
    shares.is_some_and(|shares| {
        shares
            .iter()
            .any(|share| !(-1e-9..=1.0 + 1e-9).contains(share))
    })
}

/// The numbers of scenes for people, counted from 1: `1, 3–5`.
pub(crate) fn list(numbers: &[usize]) -> String {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for number in numbers {
        match runs.last_mut() {
            Some([_, last]) if *last + 1 == *number => *last = *number,
            _ => runs.push([*number, *number]),
        }
    }
    let words = runs.into_iter().map(|[first, last]| match last - first {
        0 => format!("{}", first + 1),
        1 => format!("{}, {}", first + 1, last + 1),
        _ => format!("{}–{}", first + 1, last + 1),
    });
    words.collect::<Vec<_>>().join(", ")
}

/// The regions of scenes with one border.
fn shaded(svg: &mut Svg, frame: &Frame, group: &Group) {
    for (speeds, region) in group.regions.iter().rev() {
        let fill = match speeds {
            Speeds::Every => EVERY,
            Speeds::UpToBound => BOUNDED,
        };
        for outline in &region.outlines {
            svg.area(&pixels(frame, outline), fill);
        }
    }
    for (speeds, region) in &group.regions {
        for border in &region.borders {
            svg.line(&pixels(frame, border), stroke(*speeds, BLACK));
        }
    }
}

fn pixels(frame: &Frame, line: &[[f64; 2]]) -> Vec<Pixel> {
    line.iter().map(|place| frame.clamped(*place)).collect()
}

/// The line of a border.
const fn stroke(speeds: Speeds, colour: &str) -> Stroke<'_> {
    match speeds {
        Speeds::Every => Stroke::solid(colour, 2.0),
        Speeds::UpToBound => Stroke::dashed(colour, 2.0),
    }
}

/// The borders of several devices, each at the speeds that its verdict is about.
fn outlined(svg: &mut Svg, frame: &Frame, groups: &[Group], labels: &mut Labels) {
    for group in groups {
        let Some((speeds, region)) = group.regions.last() else {
            continue;
        };
        let colour = group.marks.first().map_or(BLACK, |number| colour(*number));
        for border in &region.borders {
            svg.line(&pixels(frame, border), stroke(*speeds, colour));
        }
    }
    // Borders one on the other have one label.
    let mut labelled: Vec<(Vec<Pixel>, Vec<usize>)> = Vec::new();
    for group in groups {
        let borders = group.regions.last().map(|(_, region)| &region.borders);
        let ways = borders.into_iter().flatten();
        let ways = ways.map(|border| pixels(frame, border));
        let Some(longest) = ways.max_by(|a, b| length(a).total_cmp(&length(b))) else {
            continue;
        };
        match labelled.iter_mut().find(|(way, _)| is_on(way, &longest)) {
            Some((_, marks)) => marks.extend(&group.marks),
            None => labelled.push((longest, group.marks.clone())),
        }
    }
    for (way, marks) in &mut labelled {
        marks.sort_unstable();
        let is_of_one = groups.iter().any(|group| group.marks == *marks);
        let first = marks.first().filter(|_| is_of_one);
        let colour = first.map_or(BLACK, |number| colour(*number));
        labels.along(svg, way, &list(marks), colour);
    }
    // Strokes leave out the labels, of which they would seem to be a part.
    for group in groups {
        let borders = group.regions.last().map(|(_, region)| &region.borders);
        let colour = group.marks.first().map_or(BLACK, |number| colour(*number));
        for border in borders.into_iter().flatten() {
            let all = strokes(&pixels(frame, border)).into_iter();
            for ends in all.filter(|ends| labels.is_clear(ends)) {
                svg.line(&ends, Stroke::solid(colour, 1.0));
            }
        }
    }
}

/// Whether a way runs along another from end to end, as far as can be seen.
fn is_on(way: &[Pixel], other: &[Pixel]) -> bool {
    [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|part| {
        let places = part_of(way, part).zip(part_of(other, part));
        places.is_some_and(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) < 2.0)
    })
}

/// Short strokes on the left of a way, where the region is; left on a page, on which y goes down.
fn strokes(way: &[Pixel]) -> Vec<[Pixel; 2]> {
    const EVERY: f64 = 16.0;
    const LONG: f64 = 6.0;
    let mut all = Vec::new();
    let mut left_over = 0.5 * EVERY;
    for (a, b) in way.iter().zip(way.iter().skip(1)) {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        while left_over < length {
            let share = left_over / length;
            let place = [a[0] + share * dx, a[1] + share * dy];
            let end = [place[0] + LONG * dy / length, place[1] - LONG * dx / length];
            all.push([place, end]);
            left_over += EVERY;
        }
        left_over -= length;
    }
    all
}

/// Half the length of the ends of a bar.
const CAP: f64 = 9.0;

/// The lines of a scene's tolerances: a box, or a bar where only one of the axes has one; none where they
/// are too small to be seen.
fn tolerance_lines(frame: &Frame, mark: &Mark) -> Vec<Vec<Pixel>> {
    let Some(ranges) = &mark.ranges else {
        return Vec::new();
    };
    let corner = |end: fn(&Interval<BigRational>) -> &BigRational| {
        frame.clamped(ranges.each_ref().map(|range| nearest_f64(end(range))))
    };
    let (a, b) = (corner(Interval::lo), corner(Interval::hi));
    let (wide, high) = (b[0] - a[0] >= 1.0, a[1] - b[1] >= 1.0);
    let (dx, dy) = (if wide { 0.0 } else { CAP }, if high { 0.0 } else { CAP });
    if wide && high {
        let mut edge = rectangle([a[0], b[1]], [b[0], a[1]]).to_vec();
        edge.extend(edge.first().copied());
        vec![edge]
    } else if wide || high {
        // A bar with its ends.
        let end = |[x, y]: Pixel| vec![[x - dx, y - dy], [x + dx, y + dy]];
        vec![vec![a, b], end(a), end(b)]
    } else {
        Vec::new()
    }
}

/// Draws the tolerances of a scene.
fn tolerance_box(svg: &mut Svg, frame: &Frame, mark: &Mark, colour: &str) {
    let lines = tolerance_lines(frame, mark);
    for stroke in [Stroke::solid("#ffffff", 3.5), Stroke::solid(colour, 1.5)] {
        for line in &lines {
            svg.line(line, stroke);
        }
    }
}

/// A measured point: a full triangle where it was stable, a cross where not; a ring where the
/// criterion says more than was measured.
fn measured(svg: &mut Svg, [x, y]: Pixel, point: &Point) {
    if point.stable {
        let corners = [[x, y - 6.0], [x + 5.5, y + 4.0], [x - 5.5, y + 4.0]];
        svg.area(&corners, DARK);
    } else {
        let cross = Stroke::solid(DARK, 2.0);
        svg.line(&[[x - 4.5, y - 4.5], [x + 4.5, y + 4.5]], cross);
        svg.line(&[[x - 4.5, y + 4.5], [x + 4.5, y - 4.5]], cross);
    }
    if point.prediction == Prediction::Looser {
        svg.disc([x, y], 9.0, "none", Stroke::solid(COLOURS[1], 2.0));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_listed_in_runs() {
        assert_eq!(list(&[0]), "1");
        assert_eq!(list(&[0, 1, 4, 5, 6, 9]), "1, 2, 5–7, 10");
    }

    #[test]
    fn borders_on_each_other_are_one_way() {
        let way = [[0.0, 0.0], [100.0, 100.0]];
        assert!(is_on(&way, &[[0.0, 1.0], [50.0, 51.0], [100.0, 101.0]]));
        assert!(!is_on(&way, &[[0.0, 0.0], [50.0, 60.0], [100.0, 100.0]]));
    }

    #[test]
    fn strokes_point_to_the_left_of_the_way() {
        // To the right on the page: the left is above, at smaller y.
        let all = strokes(&[[0.0, 10.0], [40.0, 10.0]]);
        assert_eq!(all.len(), 2, "{all:?}");
        assert!(all.iter().all(|[from, to]| to[1] < from[1]));
    }
}
