//! Pictures in the PDF: an SVG's paths, drawn as paths.

use krilla::color::rgb;
use krilla::geom::{Path, PathBuilder, Transform};
use krilla::num::NormalizedF32;
use krilla::paint::{Fill, FillRule, LineCap, LineJoin, Paint, Stroke, StrokeDash};
use krilla::surface::Surface;
use resvg::tiny_skia::PathSegment;
use resvg::usvg;

use crate::error::CaseError;

/// A picture with its text as outlines.
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
        surface.push_transform(&Transform::from_row(scale, 0.0, 0.0, scale, x, y));
        group(self.tree.root(), 1.0, surface);
        surface.pop();
    }
}

/// The pictures drawn here have solid paths, text and groups, and nothing else.
fn group(group: &usvg::Group, opacity: f32, surface: &mut Surface<'_>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(inner) => {
                self::group(inner, opacity * inner.opacity().get(), surface)
            }
            usvg::Node::Path(path) if path.is_visible() => draw_path(path, opacity, surface),
            usvg::Node::Text(text) => self::group(text.flattened(), opacity, surface),
            usvg::Node::Path(_) | usvg::Node::Image(_) => {}
        }
    }
}

fn draw_path(path: &usvg::Path, opacity: f32, surface: &mut Surface<'_>) {
    let t = path.abs_transform();
    let Some(shape) = shape(path) else { return };
    surface.push_transform(&Transform::from_row(t.sx, t.ky, t.kx, t.sy, t.tx, t.ty));
    let fill = path.fill().and_then(|fill| {
        Some(Fill {
            paint: paint(fill.paint())?,
            opacity: alpha(fill.opacity().get() * opacity),
            rule: match fill.rule() {
                usvg::FillRule::NonZero => FillRule::NonZero,
                usvg::FillRule::EvenOdd => FillRule::EvenOdd,
            },
        })
    });
    let stroke = path.stroke().and_then(|stroke| {
        Some(Stroke {
            paint: paint(stroke.paint())?,
            width: stroke.width().get(),
            miter_limit: stroke.miterlimit().get(),
            line_cap: match stroke.linecap() {
                usvg::LineCap::Butt => LineCap::Butt,
                usvg::LineCap::Round => LineCap::Round,
                usvg::LineCap::Square => LineCap::Square,
            },
            line_join: match stroke.linejoin() {
                usvg::LineJoin::Round => LineJoin::Round,
                usvg::LineJoin::Bevel => LineJoin::Bevel,
                usvg::LineJoin::Miter | usvg::LineJoin::MiterClip => LineJoin::Miter,
            },
            opacity: alpha(stroke.opacity().get() * opacity),
            dash: stroke.dasharray().map(|array| StrokeDash {
                array: array.to_vec(),
                offset: stroke.dashoffset(),
            }),
        })
    });
    if fill.is_some() || stroke.is_some() {
        surface.set_fill(fill);
        surface.set_stroke(stroke);
        surface.draw_path(&shape);
    }
    surface.pop();
}

fn shape(path: &usvg::Path) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for segment in path.data().segments() {
        match segment {
            PathSegment::MoveTo(p) => builder.move_to(p.x, p.y),
            PathSegment::LineTo(p) => builder.line_to(p.x, p.y),
            PathSegment::QuadTo(a, p) => builder.quad_to(a.x, a.y, p.x, p.y),
            PathSegment::CubicTo(a, b, p) => builder.cubic_to(a.x, a.y, b.x, b.y, p.x, p.y),
            PathSegment::Close => builder.close(),
        }
    }
    builder.finish()
}

/// Solid colours only: nothing here is drawn with gradients or patterns.
fn paint(paint: &usvg::Paint) -> Option<Paint> {
    match paint {
        usvg::Paint::Color(colour) => {
            Some(rgb::Color::new(colour.red, colour.green, colour.blue).into())
        }
        _ => None,
    }
}

fn alpha(opacity: f32) -> NormalizedF32 {
    NormalizedF32::new(opacity).unwrap_or(NormalizedF32::ONE)
}
