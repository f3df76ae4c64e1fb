//! A picture as SVG text: lines, areas, signs and words, in fractions of a pixel.

use std::fmt::{Display, Write as _};

use crate::title::fitted;

/// Okabe and Ito's palette: told apart by colour-blind readers too.
pub const COLOURS: [&str; 7] = [
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#8c6400", "#5a5a5a",
];

/// Black, and three greys from dark to light.
pub const BLACK: &str = "#000000";
/// Of axes and edges.
pub const DARK: &str = "#505050";
/// Of lines that are looked at last.
pub const LIGHT: &str = "#b0b0b0";

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke<'a> {
    /// A colour as SVG writes it.
    pub colour: &'a str,
    /// In pixels.
    pub width: f64,
    /// Lengths of dashes and gaps, as in `6 4`; empty for a line without gaps.
    pub dash: &'a str,
}

impl<'a> Stroke<'a> {
    /// A line without gaps.
    #[must_use]
    pub const fn solid(colour: &'a str, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: "",
        }
    }

    /// A dashed line.
    #[must_use]
    pub const fn dashed(colour: &'a str, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: "7 4",
        }
    }
}

/// Where a text stands to its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A picture that is being drawn.
#[derive(Clone, Debug)]
pub struct Svg {
    size: [f64; 2],
    body: String,
}

/// The name of the hatching that [`Svg`] defines, as a fill.
pub const HATCHED: &str = "url(#hatched)";

/// A place in pixels from the upper left corner.
pub type Pixel = [f64; 2];

impl Svg {
    /// A white picture of a width and a height.
    #[must_use]
    pub fn new(size: [f64; 2]) -> Self {
        let mut svg = Self {
            size,
            body: String::new(),
        };
        svg.area(&rectangle([0.0, 0.0], size), "#ffffff");
        svg
    }

    // Writing to a string cannot fail.
    fn put(&mut self, element: impl Display) {
        let _ = writeln!(self.body, "{element}");
    }

    /// A line through places.
    pub fn line(&mut self, places: &[Pixel], stroke: Stroke<'_>) {
        if places.len() < 2 {
            return;
        }
        let Stroke {
            colour,
            width,
            dash,
        } = stroke;
        let dash = match dash {
            "" => String::new(),
            dash => format!(" stroke-dasharray=\"{dash}\""),
        };
        let points = points(places);
        self.put(format_args!(
            "<polyline fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
             stroke-linejoin=\"round\"{dash} points=\"{points}\"/>"
        ));
    }

    /// The area within a closed line.
    pub fn area(&mut self, places: &[Pixel], fill: &str) {
        let points = points(places);
        self.put(format_args!(
            "<polygon fill=\"{fill}\" points=\"{points}\"/>"
        ));
    }

    /// The area of a cell: beside another one without a seam.
    pub fn cell(&mut self, places: &[Pixel], fill: &str) {
        let points = points(places);
        self.put(format_args!(
            "<polygon fill=\"{fill}\" shape-rendering=\"crispEdges\" points=\"{points}\"/>"
        ));
    }

    /// A disc with an edge.
    pub fn disc(&mut self, [x, y]: Pixel, radius: f64, fill: &str, edge: Stroke<'_>) {
        let Stroke { colour, width, .. } = edge;
        self.put(format_args!(
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{colour}\" \
             stroke-width=\"{width}\"/>"
        ));
    }

    /// Words of a size in pixels, their base line at a place with nothing below them.
    pub fn text(&mut self, place: Pixel, size: f64, anchor: Anchor, words: &str) {
        self.words(place, size, anchor, words, &format!("fill=\"{BLACK}\""));
    }

    /// A title over the whole width, its base line at a height: in smaller letters, or without its middle, where it is long.
    pub fn title(&mut self, y: f64, size: f64, title: &str) {
        /// What stays free on either side.
        const MARGIN: f64 = 16.0;
        let [wide, _] = self.size;
        let (title, size) = fitted(title, wide - 2.0 * MARGIN, size);
        self.text([0.5 * wide, y], size, Anchor::Middle, &title);
    }

    /// Words in a colour over what is drawn: a white rim keeps them readable. It is a text of its own below them, as
    /// not all viewers draw the rim of a text below its letters.
    pub fn text_over(
        &mut self,
        place: Pixel,
        size: f64,
        anchor: Anchor,
        words: &str,
        colour: &str,
    ) {
        self.words(place, size, anchor, words, RIM);
        self.words(place, size, anchor, words, &format!("fill=\"{colour}\""));
    }

    fn words(&mut self, [x, y]: Pixel, size: f64, anchor: Anchor, words: &str, paint: &str) {
        let anchor = anchor.name();
        let words = escaped(words);
        self.put(format_args!(
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-family=\"sans-serif\" font-size=\"{size}\" \
             text-anchor=\"{anchor}\" {paint}>{words}</text>"
        ));
    }

    /// Words from below to above, their middle at a place.
    pub fn text_upwards(&mut self, [x, y]: Pixel, size: f64, words: &str) {
        let words = escaped(words);
        self.put(format_args!(
            "<text transform=\"translate({x:.2} {y:.2}) rotate(-90)\" font-family=\"sans-serif\" \
             font-size=\"{size}\" text-anchor=\"middle\" fill=\"{BLACK}\">{words}</text>"
        ));
    }

    /// The picture as text.
    #[must_use]
    pub fn finish(self) -> String {
        let Self {
            size: [width, height],
            body,
        } = self;
        // Only where it is used: pictures may stand together in one document.
        let hatching = if body.contains(HATCHED) { HATCHING } else { "" };
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">\n{hatching}{body}</svg>\n"
        )
    }
}

/// How the rim of words is painted.
const RIM: &str = "fill=\"none\" stroke=\"#ffffff\" stroke-width=\"3\" stroke-linejoin=\"round\"";

/// Slanting grey lines.
const HATCHING: &str = "<defs><pattern id=\"hatched\" width=\"6\" height=\"6\" \
    patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" \
    fill=\"#ffffff\"/><rect width=\"2\" height=\"6\" fill=\"#808080\"/></pattern></defs>\n";

impl Anchor {
    const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

/// The corners of a rectangle between two opposite ones.
#[must_use]
pub const fn rectangle([left, top]: Pixel, [right, bottom]: Pixel) -> [Pixel; 4] {
    [[left, top], [right, top], [right, bottom], [left, bottom]]
}

fn points(places: &[Pixel]) -> String {
    let mut text = String::new();
    for [x, y] in places {
        // Writing to a string cannot fail.
        let _ = write!(text, "{x:.2},{y:.2} ");
    }
    text.trim_end().to_owned()
}

fn escaped(words: &str) -> String {
    words
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_escaped_and_a_line_needs_two_places() {
        let mut svg = Svg::new([10.0, 10.0]);
        svg.text([1.0, 2.0], 12.0, Anchor::Start, "a < b & c");
        svg.line(&[[1.0, 1.0]], Stroke::solid(BLACK, 1.0));
        let text = svg.finish();
        assert!(
            text.contains("a &lt; b &amp; c") && !text.contains("polyline"),
            "{text}"
        );
    }

    /// Of the letters of a text nothing is covered by a rim, in whatever order a viewer paints it.
    #[test]
    fn a_rim_is_a_text_below_the_words() {
        let mut svg = Svg::new([90.0, 30.0]);
        svg.text([1.0, 9.0], 12.0, Anchor::Start, "plain");
        svg.text_over([1.0, 20.0], 12.0, Anchor::Start, "over", COLOURS[0]);
        let svg = svg.finish();
        assert!(!svg.contains("paint-order"), "{svg}");
        let texts: Vec<&str> = svg
            .lines()
            .filter(|line| line.starts_with("<text"))
            .collect();
        let [plain, rim, words] = texts[..] else {
            panic!("{svg}");
        };
        assert!(rim.contains("fill=\"none\" stroke=\"#ffffff\"") && rim.contains(">over<"));
        assert!(words.contains("fill=\"#0072b2\"") && words.contains(">over<"));
        assert!(
            !plain.contains("stroke") && !words.contains("stroke"),
            "{svg}"
        );
    }
}
