//! Numbers beside marks and lines, none over another.

use crate::frame::{Frame, width};
use crate::svg::{Anchor, BLACK, DARK, Pixel, Stroke, Svg, rectangle};

/// What of the picture is taken.
pub(crate) struct Labels {
    from: Pixel,
    to: Pixel,
    boxes: Vec<[Pixel; 2]>,
}

const SIZE: f64 = 14.0;

/// How far strokes and the line itself stay from words on a line.
const CLEAR: f64 = 3.0;

/// Where a number is tried first around its mark, in turns from the right, clockwise: to the upper
/// right, above, to the upper left, …
const FIRST: [f64; 8] = [-0.125, -0.25, -0.375, 0.0, 0.5, 0.125, 0.375, 0.25];

/// How far from its mark a number may be, in steps of a ring.
const RINGS: u32 = 7;

impl Labels {
    pub(crate) const fn new(frame: &Frame) -> Self {
        Self {
            from: frame.from,
            to: frame.to,
            boxes: Vec::new(),
        }
    }

    /// Keeps the place of a mark free.
    pub(crate) fn take(&mut self, [x, y]: Pixel, radius: f64) {
        self.boxes
            .push([[x - radius, y - radius], [x + radius, y + radius]]);
    }

    /// Keeps a box free, of half a width and half a height around its middle.
    pub(crate) fn take_box(&mut self, [x, y]: Pixel, [half_width, half_height]: [f64; 2]) {
        let (from, to) = (
            [x - half_width, y - half_height],
            [x + half_width, y + half_height],
        );
        self.boxes.push([from, to]);
    }

    /// Keeps a line free.
    pub(crate) fn take_line(&mut self, way: &[Pixel]) {
        const STEP: f64 = 6.0;
        let mut at = 0.0;
        let length = length(way);
        while at < length {
            if let Some(place) = part_of(way, at / length) {
                self.take(place, 2.0);
            }
            at += STEP;
        }
    }

    fn is_free(&self, [from, to]: [Pixel; 2]) -> bool {
        let inside = from[0] >= self.from[0] + 2.0 && to[0] <= self.to[0] - 2.0;
        let inside = inside && from[1] >= self.from[1] + 2.0 && to[1] <= self.to[1] - 2.0;
        inside && self.is_apart(&[from, to], 0.0)
    }

    /// Whether a stroke from one place to another is clear of all that is taken.
    pub(crate) fn is_clear(&self, stroke: &[Pixel; 2]) -> bool {
        self.is_apart(stroke, CLEAR)
    }

    fn is_apart(&self, [from, to]: &[Pixel; 2], distance: f64) -> bool {
        self.boxes.iter().all(|[a, b]| {
            let apart = |i: usize| {
                let (low, high) = (from[i].min(to[i]), from[i].max(to[i]));
                high + distance <= a[i] || b[i] <= low - distance
            };
            apart(0) || apart(1)
        })
    }

    /// Takes the place of words with their middle there, if it is free.
    fn reserve(&mut self, [x, y]: Pixel, words: &str) -> bool {
        let half = 0.5 * width(words, SIZE);
        let taken = [[x - half, y - 0.5 * SIZE], [x + half, y + 0.5 * SIZE]];
        let free = self.is_free(taken);
        if free {
            self.boxes.push(taken);
        }
        free
    }

    /// Writes words beside a mark, with a line to it where they are far.
    pub(crate) fn beside(&mut self, svg: &mut Svg, place: Pixel, words: &str) {
        let half = 0.5 * width(words, SIZE);
        for ring in 0..RINGS {
            let away = 16.0 + 15.0 * f64::from(ring);
            let more = (0..8 * ring).map(|i| f64::from(i) / f64::from(8 * ring));
            for turn in FIRST.into_iter().chain(more) {
                let (sin, cos) = (std::f64::consts::TAU * turn).sin_cos();
                let at = [place[0] + (away + half - 6.0) * cos, place[1] + away * sin];
                if self.reserve(at, words) {
                    if ring > 0 {
                        let end = edge(place, at, [half + 2.0, 0.5 * SIZE + 1.0]);
                        svg.line(&[place, end], Stroke::solid(DARK, 0.7));
                    }
                    write(svg, at, words, BLACK);
                    return;
                }
            }
        }
        // No place is free: over what is there, but not lost.
        write(svg, [place[0] + 9.0 + half, place[1] - 9.0], words, BLACK);
    }

    /// Writes words on a line, where there is room.
    pub(crate) fn along(&mut self, svg: &mut Svg, way: &[Pixel], words: &str, colour: &str) {
        let parts = [
            0.5, 0.35, 0.65, 0.2, 0.8, 0.1, 0.9, 0.27, 0.73, 0.43, 0.57, 0.05, 0.95,
        ];
        for part in parts {
            let Some(place) = part_of(way, part) else {
                continue;
            };
            if self.reserve(place, words) {
                let [x, y] = place;
                let [dx, dy] = [0.5 * width(words, SIZE) + CLEAR, 0.5 * SIZE + CLEAR];
                svg.area(&rectangle([x - dx, y - dy], [x + dx, y + dy]), "#ffffff");
                write(svg, place, words, colour);
                return;
            }
        }
        if let Some(place) = part_of(way, 0.5) {
            self.beside(svg, place, words);
        }
    }
}

/// Where a line to the middle of a box meets its edge.
fn edge(from: Pixel, middle: Pixel, [half_width, half_height]: [f64; 2]) -> Pixel {
    let (dx, dy) = (middle[0] - from[0], middle[1] - from[1]);
    let inside = (half_width / dx.abs()).min(half_height / dy.abs()).min(1.0);
    [middle[0] - inside * dx, middle[1] - inside * dy]
}

/// Words with their middle at a place.
fn write(svg: &mut Svg, [x, y]: Pixel, words: &str, colour: &str) {
    let place = [x, y + 0.36 * SIZE];
    svg.text_over(place, SIZE, Anchor::Middle, words, colour);
}

/// How long a way is.
pub(crate) fn length(way: &[Pixel]) -> f64 {
    let pairs = way.iter().zip(way.iter().skip(1));
    pairs.map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1])).sum()
}

/// The place at a part of a way's length.
pub(crate) fn part_of(way: &[Pixel], part: f64) -> Option<Pixel> {
    let mut left = part * length(way);
    for (a, b) in way.iter().zip(way.iter().skip(1)) {
        let length = (b[0] - a[0]).hypot(b[1] - a[1]);
        if left <= length && length > 0.0 {
            let share = left / length;
            return Some([a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]);
        }
        left -= length;
    }
    way.last().copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_to_words_ends_at_their_edge() {
        let half = [10.0, 8.0];
        assert_eq!(edge([0.0, 0.0], [100.0, 0.0], half), [90.0, 0.0]);
        assert_eq!(edge([0.0, 50.0], [0.0, 0.0], half), [0.0, 8.0]);
        assert_eq!(edge([0.0, 0.0], [40.0, 40.0], half), [32.0, 32.0]);
        // From inside of the box there is no line.
        assert_eq!(edge([1.0, 1.0], [2.0, 2.0], half), [1.0, 1.0]);
    }

    #[test]
    fn thirteen_numbers_at_one_place_do_not_touch() {
        let frame = Frame::of_unit([600.0, 500.0]);
        let mut labels = Labels::new(&frame);
        let mut svg = Svg::new([600.0, 500.0]);
        labels.take([300.0, 250.0], 7.0);
        for number in 1..=13 {
            labels.beside(&mut svg, [300.0, 250.0], &number.to_string());
        }
        assert_eq!(labels.boxes.len(), 14, "each has its own place");
    }
}
