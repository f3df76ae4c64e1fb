//! Breaking text into lines of a known width.

use ttf_parser::Face;

/// Size of the letters in pixels.
pub(super) const FONT: f64 = 11.0;

/// From one line to the next, in pixels.
pub(super) const LINE: f64 = 14.0;

/// Widths of the letters of DejaVu Sans, the widest of the fonts that the drawing asks for.
pub(super) struct Letters {
    face: Option<Face<'static>>,
}

impl Letters {
    pub(super) fn new() -> Self {
        // The font is part of the build; should it not be read, `width` falls back to a width that
        // no letter passes.
        Self {
            face: Face::parse(dejavu::sans::regular(), 0).ok(),
        }
    }

    /// The width of a text in pixels.
    pub(super) fn width(&self, text: &str) -> f64 {
        text.chars().map(|letter| self.letter(letter)).sum()
    }

    fn letter(&self, letter: char) -> f64 {
        let face = self.face.as_ref();
        let advance = face.and_then(|face| {
            let glyph = face.glyph_index(letter)?;
            let advance = f64::from(face.glyph_hor_advance(glyph)?);
            Some(advance / f64::from(face.units_per_em()))
        });
        advance.unwrap_or(1.0) * FONT
    }

    /// Lines of `text` no wider than `width`; a longer word is broken, after a hyphen, underscore,
    /// full stop or slash where it has one.
    pub(super) fn wrap(&self, text: &str, width: f64) -> Vec<String> {
        let mut lines = Vec::new();
        for paragraph in text.lines() {
            let mut line = String::new();
            for word in paragraph.split_whitespace() {
                let fits = self.width(word) <= width;
                let pieces: Vec<&str> = if fits {
                    vec![word]
                } else {
                    word.split_inclusive(['-', '_', '.', '/']).collect()
                };
                for (index, piece) in pieces.into_iter().enumerate() {
                    let space = if line.is_empty() || index > 0 {
                        ""
                    } else {
                        " "
                    };
                    let joined = format!("{line}{space}{piece}");
                    if self.width(&joined) <= width {
                        line = joined;
                        continue;
                    }
                    if !line.is_empty() {
                        lines.push(std::mem::take(&mut line));
                    }
                    for letter in piece.chars() {
                        if !line.is_empty() && self.width(&line) + self.letter(letter) > width {
                            lines.push(std::mem::take(&mut line));
                        }
                        line.push(letter);
                    }
                }
            }
            lines.push(line);
        }
        lines
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_is_wider_than_asked_and_no_letter_is_lost() {
        let letters = Letters::new();
        let text = "β = b/(KT) and a_very_long_word_that_does_not_fit_into_one_line at all";
        let lines = letters.wrap(text, 80.0);
        assert!(
            lines.iter().all(|line| letters.width(line) <= 80.0),
            "{lines:?}"
        );
        let squeezed = |t: &str| t.replace(' ', "");
        assert_eq!(squeezed(&lines.concat()), squeezed(text));
        assert!(lines.len() >= 5);
    }

    #[test]
    fn the_font_is_read() {
        // DejaVu Sans: `i` is 569 and `W` 2025 of 2048 units wide.
        let letters = Letters::new();
        assert!((letters.width("i") - FONT * 569.0 / 2048.0).abs() < 1e-9);
        assert!((letters.width("W") - FONT * 2025.0 / 2048.0).abs() < 1e-9);
    }
}
