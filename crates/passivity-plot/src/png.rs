//! A picture as PNG, with a font that is part of the program.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::io::Read as _;
use std::sync::{Arc, Mutex, PoisonError};

use flate2::read::DeflateDecoder;
use resvg::{tiny_skia, usvg};

use crate::PlotError;
use crate::file::by_number;

/// DejaVu Sans, compressed by this crate's `build.rs`.
const REGULAR: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/regular"));
const BOLD: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/bold"));

/// The picture as the bytes of a PNG file, at twice the size, with the font DejaVu Sans. Letters that the font does
/// not have, as Chinese and Japanese ones, are written by their numbers, as `\u{6a5f}`.
///
/// # Errors
///
/// Text that is no SVG, or a picture too large for memory.
pub fn to_png(svg: &str) -> Result<Vec<u8>, PlotError> {
    const SCALE: f32 = 2.0;
    let mut fonts = usvg::fontdb::Database::new();
    for weight in [REGULAR, BOLD] {
        let mut font = Vec::new();
        let read = DeflateDecoder::new(weight).read_to_end(&mut font);
        read.map_err(|error| PlotError::new(format!("the font of this build: {error}")))?;
        fonts.load_font_data(font);
    }
    fonts.set_sans_serif_family("DejaVu Sans");
    let options = usvg::Options {
        font_family: "DejaVu Sans".to_owned(),
        fontdb: Arc::new(fonts),
        ..usvg::Options::default()
    };
    let tree = parsed(&with_glyphs(svg, &options)?, &options)?;
    let size = tree.size().to_int_size().scale_by(SCALE);
    let too_large = || PlotError::new("picture: too large");
    let size = size.ok_or_else(too_large)?;
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height()).ok_or_else(too_large)?;
    pixels.fill(tiny_skia::Color::WHITE);
    let transform = tiny_skia::Transform::from_scale(SCALE, SCALE);
    resvg::render(&tree, transform, &mut pixels.as_mut());
    pixels
        .encode_png()
        .map_err(|error| PlotError::new(format!("picture: {error}")))
}

fn parsed(svg: &str, options: &usvg::Options<'_>) -> Result<usvg::Tree, PlotError> {
    usvg::Tree::from_str(svg, options).map_err(|error| PlotError::new(format!("picture: {error}")))
}

/// The picture without letters that the fonts do not have: of each letter in it, as a text of its own, they are asked.
fn with_glyphs<'a>(svg: &'a str, options: &usvg::Options<'_>) -> Result<Cow<'a, str>, PlotError> {
    let letters: BTreeSet<char> = svg.chars().filter(|c| !c.is_ascii()).collect();
    let texts: String = letters
        .iter()
        .map(|c| format!("<text>{c}</text>"))
        .collect();
    let missing = Mutex::new(BTreeSet::new());
    let usual = usvg::FontResolver::default_fallback_selector();
    let asking = usvg::Options {
        font_family: options.font_family.clone(),
        fontdb: Arc::clone(&options.fontdb),
        font_resolver: usvg::FontResolver {
            select_fallback: Box::new(|letter, tried, fonts| {
                let other = usual(letter, tried, fonts);
                if other.is_none() {
                    let mut missing = missing.lock().unwrap_or_else(PoisonError::into_inner);
                    missing.insert(letter);
                }
                other
            }),
            ..usvg::FontResolver::default()
        },
        ..usvg::Options::default()
    };
    parsed(
        &format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{texts}</svg>"),
        &asking,
    )?;
    drop(asking);
    let missing = missing.into_inner().unwrap_or_else(PoisonError::into_inner);
    Ok(by_number(svg, |c| missing.contains(&c)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::{Anchor, Svg};

    #[test]
    fn letters_that_the_font_does_not_have_are_written_by_their_numbers() {
        let drawn = |name: &str| {
            let mut svg = Svg::new([300.0, 30.0]);
            svg.text([5.0, 20.0], 12.0, Anchor::Start, name);
            to_png(&svg.finish()).unwrap()
        };
        assert_eq!(drawn("機械 1 β"), drawn("\\u{6a5f}\\u{68b0} 1 β"));
        assert_ne!(drawn("機"), drawn("械"));
        // What the font has is drawn.
        assert_ne!(drawn("σΔ²"), drawn("\\u{3c3}\\u{394}\\u{b2}"));
    }
}
