//! The frame of a chart: its axes with their ticks, and where a value lies in it.

use passivity_scene::display::significant;
use passivity_scene::plane::Extent;

use crate::svg::{Anchor, DARK, Pixel, Stroke, Svg, rectangle};

/// A chart's place in a picture, and what its axes show.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// What the axis of x shows.
    pub x: Extent,
    /// What the axis of y shows.
    pub y: Extent,
    /// The upper left corner.
    pub from: Pixel,
    /// The lower right corner.
    pub to: Pixel,
}

/// About how many pixels are between the labels of an axis.
const BETWEEN: [f64; 2] = [90.0, 40.0];

/// The size of a label.
const SIZE: f64 = 13.0;

impl Frame {
    /// One of numbers from 0 to 1, from the corner of the page on.
    #[cfg(test)]
    pub(crate) fn of_unit(to: Pixel) -> Self {
        let unit = Extent {
            from: 0.0,
            to: 1.0,
            log: false,
        };
        Self {
            x: unit,
            y: unit,
            from: [0.0, 0.0],
            to,
        }
    }

    /// Where a place of the chart is in the picture; outside it where the value is outside.
    #[must_use]
    pub fn pixel(&self, [x, y]: [f64; 2]) -> Pixel {
        let [left, top] = self.from;
        let [right, bottom] = self.to;
        [
            left + self.x.share(x) * (right - left),
            bottom + self.y.share(y) * (top - bottom),
        ]
    }

    /// The pixel, moved to the edge where it is outside.
    #[must_use]
    pub fn clamped(&self, place: [f64; 2]) -> Pixel {
        let [x, y] = self.pixel(place);
        [
            x.clamp(self.from[0], self.to[0]),
            y.clamp(self.from[1], self.to[1]),
        ]
    }

    /// Whether a place is within the chart, its edges included.
    #[must_use]
    pub fn contains(&self, [x, y]: [f64; 2]) -> bool {
        let inside = |share: f64| (-1e-9..=1.0 + 1e-9).contains(&share);
        inside(self.x.share(x)) && inside(self.y.share(y))
    }

    /// Draws the edge, the ticks and their labels.
    pub fn draw(&self, svg: &mut Svg, words: [&str; 2]) {
        self.draw_x(svg, words[0]);
        self.draw_y(svg, words[1]);
        self.draw_edge(svg);
    }

    /// Draws the edge alone.
    pub fn draw_edge(&self, svg: &mut Svg) {
        let mut edge = rectangle(self.from, self.to).to_vec();
        edge.extend(edge.first().copied());
        svg.line(&edge, Stroke::solid(DARK, 1.0));
    }

    /// Draws the ticks of x below the frame, with what they are of.
    pub fn draw_x(&self, svg: &mut Svg, words: &str) {
        let [left, _] = self.from;
        let [right, bottom] = self.to;
        for tick in ticks(&self.x, (right - left) / BETWEEN[0]) {
            let x = left + self.x.share(tick.at) * (right - left);
            let length = if tick.label.is_empty() { 3.0 } else { 6.0 };
            svg.line(
                &[[x, bottom], [x, bottom + length]],
                Stroke::solid(DARK, 1.0),
            );
            svg.text([x, bottom + 20.0], SIZE, Anchor::Middle, &tick.label);
        }
        svg.text(
            [0.5 * (left + right), bottom + 42.0],
            16.0,
            Anchor::Middle,
            words,
        );
    }

    /// Draws the ticks of y to the left of the frame, with what they are of.
    pub fn draw_y(&self, svg: &mut Svg, words: &str) {
        let [left, top] = self.from;
        let longest = self.ticks_beside(svg, &self.y, left, -1.0);
        let middle = 0.5 * (top + self.to[1]);
        svg.text_upwards([left - 20.0 - longest, middle], 16.0, words);
    }

    /// Draws the ticks of another unit of y to the right of the frame, with what they are of.
    pub fn draw_right(&self, svg: &mut Svg, extent: &Extent, words: &str) {
        let right = self.to[0];
        let longest = self.ticks_beside(svg, extent, right, 1.0);
        let middle = 0.5 * (self.from[1] + self.to[1]);
        svg.text_upwards([right + 28.0 + longest, middle], 14.0, words);
    }

    /// Ticks with labels at an edge; gives the width of the longest label.
    fn ticks_beside(&self, svg: &mut Svg, extent: &Extent, edge: f64, side: f64) -> f64 {
        let [top, bottom] = [self.from[1], self.to[1]];
        let anchor = if side < 0.0 {
            Anchor::End
        } else {
            Anchor::Start
        };
        let mut longest: f64 = 0.0;
        for tick in ticks(extent, (bottom - top) / BETWEEN[1]) {
            let y = bottom + extent.share(tick.at) * (top - bottom);
            let length = if tick.label.is_empty() { 3.0 } else { 6.0 };
            svg.line(
                &[[edge, y], [edge + side * length, y]],
                Stroke::solid(DARK, 1.0),
            );
            svg.text([edge + side * 9.0, y + 4.5], SIZE, anchor, &tick.label);
            longest = longest.max(width(&tick.label, SIZE));
        }
        longest
    }
}

/// What lines mean, side by side from this place on.
pub(crate) fn key(svg: &mut Svg, [mut x, y]: Pixel, lines: &[(Stroke<'_>, &str)]) {
    const LETTERS: f64 = 13.0;
    for (stroke, words) in lines {
        svg.line(&[[x, y], [x + 22.0, y]], *stroke);
        svg.text([x + 30.0, y + 5.0], LETTERS, Anchor::Start, words);
        x += 60.0 + width(words, LETTERS);
    }
}

/// About how wide words are.
#[must_use]
pub fn width(words: &str, size: f64) -> f64 {
    let letters = words.chars().count();
    0.6 * size * f64::from(u32::try_from(letters).unwrap_or(u32::MAX))
}

/// A tick of an axis; one between others has no label.
struct Tick {
    at: f64,
    label: String,
}

/// The ticks of an axis with about so many labels.
fn ticks(extent: &Extent, wanted: f64) -> Vec<Tick> {
    let wanted = wanted.max(2.0);
    if extent.log {
        return logarithmic(extent, wanted);
    }
    let span = extent.to - extent.from;
    let power = 10.0_f64.powf((span / wanted).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|n| n * power);
    let step = steps.into_iter().find(|step| span / step <= wanted);
    let step = step.unwrap_or(10.0 * power);
    let first = (extent.from / step - 1e-9).ceil();
    let count = ((extent.to / step + 1e-9).floor() - first).clamp(0.0, 50.0);
    let whole = |i: f64| {
        let at = (first + i) * step;
        // What rounding leaves of zero.
        let at = if at.abs() < 1e-9 * span { 0.0 } else { at };
        Tick {
            at,
            label: significant(at),
        }
    };
    let mut all = Vec::new();
    let mut i = 0.0;
    while i <= count {
        all.push(whole(i));
        i += 1.0;
    }
    all
}

fn logarithmic(extent: &Extent, wanted: f64) -> Vec<Tick> {
    let decades = (extent.to / extent.from).log10();
    let labelled: &[u8] = match decades {
        d if d > wanted => &[],
        d if 3.0 * d <= wanted => &[1, 2, 5],
        _ => &[1],
    };
    // Every so many decades, where even these are too many.
    let every = if labelled.is_empty() {
        (decades / wanted).ceil()
    } else {
        1.0
    };
    let mut all = Vec::new();
    let mut exponent = extent.from.log10().floor();
    while exponent <= extent.to.log10() {
        for digit in 1..=9_u8 {
            let at = f64::from(digit) * 10.0_f64.powf(exponent);
            let share = extent.share(at);
            if !(-1e-9..=1.0 + 1e-9).contains(&share) {
                continue;
            }
            let whole = digit == 1 && exponent.rem_euclid(every) == 0.0;
            let is_labelled = labelled.contains(&digit) || (labelled.is_empty() && whole);
            if every > 1.0 && digit > 1 {
                continue;
            }
            let label = if is_labelled {
                significant(at)
            } else {
                String::new()
            };
            all.push(Tick { at, label });
        }
        exponent += 1.0;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(extent: Extent, wanted: f64) -> Vec<String> {
        let all = ticks(&extent, wanted).into_iter().map(|tick| tick.label);
        all.filter(|label| !label.is_empty()).collect()
    }

    #[test]
    fn ticks_are_round_numbers_within_the_axis() {
        let linear = |from, to| Extent {
            from,
            to,
            log: false,
        };
        assert_eq!(labels(linear(0.0, 1.3), 6.0), ["0", "0.5", "1"]);
        assert_eq!(
            labels(linear(-0.3, 0.3), 6.0),
            ["-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"].map(String::from)[..]
        );
        let log = |from, to| Extent {
            from,
            to,
            log: true,
        };
        assert_eq!(labels(log(0.006, 3.0), 6.0), ["0.01", "0.1", "1"]);
        assert_eq!(
            labels(log(0.5, 20.0), 6.0),
            ["0.5", "1", "2", "5", "10", "20"]
        );
        assert_eq!(labels(log(1e-9, 1e9), 6.0).len(), 7);
    }

    #[test]
    fn a_value_lies_where_the_axes_say() {
        let frame = Frame {
            x: Extent {
                from: 1.0,
                to: 100.0,
                log: true,
            },
            y: Extent {
                from: 0.0,
                to: 2.0,
                log: false,
            },
            from: [10.0, 10.0],
            to: [110.0, 60.0],
        };
        let [x, y] = frame.pixel([10.0, 1.0]);
        assert!((x - 60.0).abs() < 1e-9 && (y - 35.0).abs() < 1e-9);
        assert!(!frame.contains([0.0, 1.0]) && frame.contains([1.0, 2.0]));
        assert_eq!(frame.clamped([0.0, 5.0]), [10.0, 10.0]);
    }
}
