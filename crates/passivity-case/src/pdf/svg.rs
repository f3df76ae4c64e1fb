//! Pictures in the PDF: lines as lines, and text as text, which can be searched and read aloud.

use krilla::geom::{Size, Transform};
use krilla::surface::Surface;
use krilla_svg::{SurfaceExt, SvgSettings};
use resvg::usvg;

use crate::error::CaseError;

/// A picture with the fonts that it needs.
pub(super) struct Picture {
    tree: usvg::Tree,
}

impl Picture {
    /// Reads an SVG, with DejaVu Sans for its text.
    pub(super) fn read(svg: &str) -> Result<Self, CaseError> {
        let mut options = usvg::Options {
            font_family: "DejaVu Sans".to_owned(),
            ..usvg::Options::default()
        };
        let fonts = options.fontdb_mut();
        for data in [
            dejavu::sans::regular(),
            dejavu::sans::bold(),
            dejavu::sans::oblique(),
        ] {
            fonts.load_font_data(data.to_vec());
        }
        fonts.set_sans_serif_family("DejaVu Sans");
        let tree = usvg::Tree::from_str(svg, &options)
            .map_err(|error| CaseError::new(format!("pdf: picture: {error}")))?;
        Ok(Self { tree })
    }

    /// Width and height.
    pub(super) fn size(&self) -> (f32, f32) {
        (self.tree.size().width(), self.tree.size().height())
    }

    /// Draws the picture with its corner at (`x`, `y`).
    pub(super) fn draw(&self, surface: &mut Surface<'_>, x: f32, y: f32, scale: f32) {
        let (w, h) = self.size();
        let Some(size) = Size::from_wh(w * scale, h * scale) else {
            return;
        };
        surface.push_transform(&Transform::from_translate(x, y));
        let drawn = surface.draw_svg(&self.tree, size, SvgSettings::default());
        debug_assert!(drawn.is_some(), "a picture of a size that is not empty");
        surface.pop();
    }
}
