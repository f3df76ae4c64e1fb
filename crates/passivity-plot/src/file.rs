//! Writing a picture to a file.

use std::fmt;
use std::path::Path;
use std::sync::Arc;

use resvg::{tiny_skia, usvg};

/// Why a picture could not be drawn or written.
#[derive(Debug)]
pub struct PlotError {
    message: String,
}

impl PlotError {
    /// An error with a message in lower-case words.
    pub fn new(message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
        }
    }
}

impl fmt::Display for PlotError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for PlotError {}

/// Writes the picture: as SVG, or as PNG when the name ends in `.png`.
///
/// # Errors
///
/// A name that ends in neither, or a file that cannot be written.
///
/// # Example
///
/// ```
/// let picture = r#"<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4"/>"#;
/// let error = passivity_plot::save(picture, "plane.bmp".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "`plane.bmp`: expected a name that ends in .svg or .png");
/// ```
pub fn save(svg: &str, path: &Path) -> Result<(), PlotError> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    let bytes = match extension.as_deref() {
        Some("svg") => svg.as_bytes().to_vec(),
        Some("png") => to_png(svg)?,
        _ => {
            let name = path.display();
            return Err(PlotError::new(format!(
                "`{name}`: expected a name that ends in .svg or .png"
            )));
        }
    };
    std::fs::write(path, bytes)
        .map_err(|error| PlotError::new(format!("`{}`: {error}", path.display())))
}

/// The picture as the bytes of a PNG file, at twice the size, with the font DejaVu Sans.
///
/// # Errors
///
/// Text that is no SVG, or a picture too large for memory.
pub fn to_png(svg: &str) -> Result<Vec<u8>, PlotError> {
    const SCALE: f32 = 2.0;
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_data(dejavu::sans::regular().to_vec());
    fonts.load_font_data(dejavu::sans::bold().to_vec());
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
