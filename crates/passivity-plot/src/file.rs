//! Writing a picture to a file.

use std::borrow::Cow;
use std::fmt;
use std::path::Path;

use passivity_scene::files::{self, Output};

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

/// Says whether a picture can be written to a file, before it is drawn: its name, and whether the file
/// can be made.
///
/// # Errors
///
/// See [`save`].
pub fn check_name(path: &Path) -> Result<(), PlotError> {
    kind(path)?;
    let made = Output::create(path);
    made.map(drop).map_err(|error| unwritable(path, &error))
}

fn unwritable(path: &Path, error: &std::io::Error) -> PlotError {
    PlotError::new(format!("`{}`: {error}", path.display()))
}

/// What the name of a file says of the picture in it.
enum Kind {
    Svg,
    Png,
}

fn kind(path: &Path) -> Result<Kind, PlotError> {
    let extension = path
        .extension()
        .and_then(|e| e.to_str())
        .map(str::to_ascii_lowercase);
    match extension.as_deref() {
        Some("svg") => Ok(Kind::Svg),
        Some("png") if cfg!(feature = "png") => Ok(Kind::Png),
        Some("png") => {
            let message = "PNG files are not in this build: build it with the feature `png`";
            Err(PlotError::new(message))
        }
        _ => {
            let name = path.display();
            Err(PlotError::new(format!(
                "`{name}`: expected a name that ends in .svg or .png"
            )))
        }
    }
}

/// Writes the picture: as SVG, or as PNG when the name ends in `.png`. Characters that no XML may have, as in names of
/// files that became a title, are written by their numbers.
///
/// # Errors
///
/// A name that ends in neither, or a file that cannot be written: then what was there stays.
///
/// # Example
///
/// ```
/// let picture = r#"<svg xmlns="http://www.w3.org/2000/svg" width="4" height="4"/>"#;
/// let error = passivity_plot::save(picture, "plane.bmp".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "`plane.bmp`: expected a name that ends in .svg or .png");
/// ```
pub fn save(svg: &str, path: &Path) -> Result<(), PlotError> {
    let svg = valid(svg);
    let bytes = match kind(path)? {
        Kind::Svg => svg.as_bytes().to_vec(),
        Kind::Png => png(&svg)?,
    };
    files::write(path, bytes).map_err(|error| unwritable(path, &error))
}

/// XML without the characters that it may not have.
fn valid(svg: &str) -> Cow<'_, str> {
    by_number(svg, |c| {
        let is_space = matches!(c, '\t' | '\n' | '\r');
        (c.is_control() && !is_space) || matches!(c, '\u{fffe}' | '\u{ffff}')
    })
}

/// A text with some of its characters by their numbers, as `\u{1b}`.
pub(crate) fn by_number(text: &str, is_refused: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_refused) {
        return Cow::Borrowed(text);
    }
    let mut told = String::with_capacity(text.len());
    for c in text.chars() {
        match is_refused(c) {
            true => told.extend(c.escape_unicode()),
            false => told.push(c),
        }
    }
    Cow::Owned(told)
}

#[cfg(feature = "png")]
fn png(svg: &str) -> Result<Vec<u8>, PlotError> {
    crate::to_png(svg)
}

#[cfg(not(feature = "png"))]
fn png(_: &str) -> Result<Vec<u8>, PlotError> {
    unreachable!("a name that ends in .png is refused by this build")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_picture_has_a_character_that_xml_refuses() {
        assert_eq!(valid("<text>β\n</text>"), "<text>β\n</text>");
        assert_eq!(
            valid("a\u{1b}[2J\u{0}\u{ffff}"),
            "a\\u{1b}[2J\\u{0}\\u{ffff}"
        );
    }
}
