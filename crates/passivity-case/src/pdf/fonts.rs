//! The letters of the PDF: DejaVu, which has the Greek and the signs that the text needs.

use krilla::text::Font;
use ttf_parser::Face;

use crate::error::CaseError;

/// How a piece of text looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    Plain,
    Bold,
    Mono,
}

/// A font, to measure with and to draw with.
struct Loaded {
    face: Face<'static>,
    font: Font,
}

/// The fonts of the three styles.
pub(super) struct Fonts {
    plain: Loaded,
    bold: Loaded,
    mono: Loaded,
}

impl Fonts {
    pub(super) fn load() -> Result<Self, CaseError> {
        let load = |data: &'static [u8]| -> Option<Loaded> {
            let face = Face::parse(data, 0).ok()?;
            Some(Loaded {
                face,
                font: Font::new(data.to_vec().into(), 0)?,
            })
        };
        let error = || CaseError::new("pdf: a font of this build cannot be read");
        Ok(Self {
            plain: load(dejavu::sans::regular()).ok_or_else(error)?,
            bold: load(dejavu::sans::bold()).ok_or_else(error)?,
            mono: load(dejavu::sans_mono::regular()).ok_or_else(error)?,
        })
    }

    const fn of(&self, style: Style) -> &Loaded {
        match style {
            Style::Plain => &self.plain,
            Style::Bold => &self.bold,
            Style::Mono => &self.mono,
        }
    }

    /// The font to draw with.
    pub(super) const fn font(&self, style: Style) -> &Font {
        &self.of(style).font
    }

    /// The width of a text in points.
    pub(super) fn width(&self, text: &str, style: Style, size: f32) -> f32 {
        let face = &self.of(style).face;
        let units: u32 = text
            .chars()
            .map(|letter| {
                let glyph = face.glyph_index(letter).unwrap_or_default();
                u32::from(face.glyph_hor_advance(glyph).unwrap_or_default())
            })
            .sum();
        units as f32 * size / f32::from(face.units_per_em())
    }

    /// The style, or the plain one where the style's font lacks a letter of the text.
    pub(super) fn style_for(&self, text: &str, style: Style) -> Style {
        let face = &self.of(style).face;
        if text
            .chars()
            .all(|letter| face.glyph_index(letter).is_some())
        {
            style
        } else {
            Style::Plain
        }
    }

    /// The text with a sign in the place of every letter that no font here has.
    pub(super) fn printable(&self, text: &str) -> String {
        text.chars()
            .map(|letter| match letter {
                '\t' => ' ',
                c if self.plain.face.glyph_index(c).is_some() => c,
                _ => '\u{fffd}',
            })
            .collect()
    }
}
