//! What colours, numbers and lines of the plane mean.

use passivity_scene::check::Verdict;
use passivity_scene::display::significant;

use super::draw::{REGIONS, line_of};
use super::{Mark, Tolerances};
use crate::parameters::{colour, scene};
use crate::svg::{Anchor, DARK, Pixel, Stroke, Svg, rectangle};

/// How high the key is.
pub(super) fn height(marks: &[Mark]) -> f64 {
    let mut nothing = Svg::new([1.0, 1.0]);
    draw(&mut nothing, marks, [0.0, 0.0]) + 60.0
}

/// Draws the key from its upper left corner; gives where it ends.
pub(super) fn draw(svg: &mut Svg, marks: &[Mark], [x, top]: Pixel) -> f64 {
    let mut y = top;
    let words = |svg: &mut Svg, y: f64, size: f64, words: &str| {
        svg.text(
            [x + 30.0, y + 12.0],
            size,
            Anchor::Start,
            &clipped(words, 40),
        );
    };
    for (fill, name) in REGIONS {
        let corners = rectangle([x, y], [x + 22.0, y + 14.0]);
        svg.area(&corners, fill);
        let mut edge = corners.to_vec();
        edge.extend(edge.first().copied());
        svg.line(&edge, Stroke::solid(DARK, 0.7));
        let more = if name == "locally stable" {
            ": up to the critical speed"
        } else {
            ""
        };
        words(svg, y, 14.0, &format!("{name}{more}"));
        y += 20.0;
    }
    y += 10.0;
    let thin = Stroke::solid(DARK, 1.0);
    svg.line(
        &[[x, y + 7.0], [x + 24.0, y + 7.0]],
        Stroke {
            dash: "3 4",
            ..thin
        },
    );
    words(svg, y, 14.0, "another stiffness K");
    y += 20.0;
    svg.line(&[[x, y + 7.0], [x + 20.0, y + 7.0]], thin);
    svg.area(
        &[
            [x + 25.0, y + 7.0],
            [x + 17.0, y + 4.0],
            [x + 17.0, y + 10.0],
        ],
        DARK,
    );
    words(svg, y, 14.0, "half the sampling period T");
    y += 20.0;
    svg.line(&[[x + 12.0, y + 4.0], [x + 12.0, y + 16.0]], thin);
    svg.area(
        &[[x + 12.0, y - 1.0], [x + 9.0, y + 7.0], [x + 15.0, y + 7.0]],
        DARK,
    );
    words(svg, y, 14.0, "half the encoder resolution Δ");
    y += 30.0;
    for (verdict, name) in [
        (Verdict::Passive, "a scene that is passive"),
        (Verdict::NotPassive, "one that is not passive"),
        (Verdict::Depends, "one of which neither is shown"),
    ] {
        scene(svg, [x + 11.0, y + 7.0], verdict, DARK);
        words(svg, y, 13.0, name);
        y += 20.0;
    }
    y += 10.0;
    for (number, mark) in marks.iter().enumerate() {
        scene(svg, [x + 11.0, y + 7.0], mark.verdict, colour(number));
        words(svg, y, 14.0, &format!("{}: {}", number + 1, mark.name));
        y += 17.0;
        let (beta, sigma) = mark.at;
        let verdict = mark.verdict.name().replace('_', " ");
        words(
            svg,
            y,
            12.0,
            &format!("({}, {}): {verdict}", significant(beta), significant(sigma)),
        );
        y += 16.0;
        if mark.tolerances != Tolerances::None {
            words(svg, y, 12.0, "at the hardest end of its tolerances");
            y += 16.0;
        }
        if let Some((_, name)) = &mark.speed {
            svg.line(&[[x, y + 7.0], [x + 24.0, y + 7.0]], line_of(number));
            words(svg, y, 12.0, &format!("critical line at {name}"));
            y += 16.0;
        }
        y += 5.0;
    }
    y
}

/// A name that fits its place.
fn clipped(name: &str, most: usize) -> String {
    if name.chars().count() <= most {
        return name.to_owned();
    }
    name.chars().take(most - 1).chain(['…']).collect()
}
