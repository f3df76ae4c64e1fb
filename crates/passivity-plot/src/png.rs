//! A picture as PNG, with a font that is part of the program.

use std::io::Read as _;
use std::sync::Arc;

use flate2::read::DeflateDecoder;
use resvg::{tiny_skia, usvg};

use crate::PlotError;

/// DejaVu Sans, compressed by this crate's `build.rs`.
const REGULAR: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/regular"));
const BOLD: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/bold"));

/// The picture as the bytes of a PNG file, at twice the size, with the font DejaVu Sans.
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
    let tree = usvg::Tree::from_str(svg, &options)
        .map_err(|error| PlotError::new(format!("picture: {error}")))?;
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
