//! Writing a picture to a file.

use std::fmt;
use std::path::Path;

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
        #[cfg(feature = "png")]
        Some("png") => crate::to_png(svg)?,
        #[cfg(not(feature = "png"))]
        Some("png") => {
            let message = "PNG files are not in this build: build it with the feature `png`";
            return Err(PlotError::new(message));
        }
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
