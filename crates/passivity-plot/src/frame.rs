//! The frame of a chart: its axes with their ticks, and where a value lies in it.

use passivity_scene::plane::Extent;

use crate::svg::{Anchor, DARK, Pixel, Stroke, Svg, rectangle};
use crate::ticks::{Along, SIZE, ticks};

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
        for tick in ticks(&self.x, Along::Page(right - left)) {
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
        for tick in ticks(extent, Along::Side(bottom - top)) {
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

#[cfg(test)]
mod tests {
    use super::*;

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
