//! A document as PDF: tagged for those who have it read to them, with an outline and references
//! that lead somewhere, and the same bytes for the same document.

mod fonts;
mod layout;
mod lines;
mod structure;
mod svg;

use krilla::annotation::{Annotation, LinkAnnotation, Target};
use krilla::color::rgb;
use krilla::configure::{Accessibility, ConfigurationBuilder};
use krilla::destination::{Destination, XyzDestination};
use krilla::geom::{PathBuilder, Point, Rect};
use krilla::metadata::Metadata;
use krilla::outline::{Outline, OutlineNode};
use krilla::page::{Page, PageSettings};
use krilla::paint::{Fill, Stroke};
use krilla::surface::Surface;
use krilla::tagging::{Artifact, ArtifactType, ContentTag, Identifier, SpanTag};
use krilla::text::TextDirection;
use krilla::{Document as Pdf, SerializeSettings};

use crate::document::Document;
use crate::error::CaseError;
use fonts::{Fonts, Style};
use layout::{Item, Layout, MARGIN, Sheet};

/// Sets a document as PDF.
///
/// # Errors
///
/// A picture that is no SVG, or a reference to an id that the document does not have.
///
/// # Example
///
/// ```
/// use passivity_case::{document::Document, pdf};
///
/// let mut document = Document::new("A wall", "and a hand");
/// document.heading(2, "summary", "Summary");
/// document.say("It is passive.");
/// let bytes = pdf::write(&document).unwrap();
/// assert!(bytes.starts_with(b"%PDF-"));
/// assert_eq!(bytes, pdf::write(&document).unwrap());
/// ```
pub fn write(document: &Document) -> Result<Vec<u8>, CaseError> {
    let fonts = Fonts::load()?;
    let layout = Layout::of(&fonts, document)?;
    // PDF/UA-1: the writer refuses what is not accessible, such as a picture without words.
    let configuration = ConfigurationBuilder::new()
        .with_accessibility_validator(Accessibility::UA1)
        .finish()
        .map_err(|error| CaseError::new(format!("pdf: {error:?}")))?;
    let mut pdf = Pdf::new_with(SerializeSettings {
        enable_tagging: true,
        configuration,
        ..SerializeSettings::default()
    });
    let metadata = Metadata::new()
        .title(document.title.clone())
        .language("en".to_owned())
        .creator(format!("passivity {}", crate::case::VERSION));
    pdf.set_metadata(metadata);
    let mut drawn: Vec<Vec<Identifier>> = vec![Vec::new(); layout.pieces];
    for (number, sheet) in layout.sheets.iter().enumerate() {
        let (w, h) = sheet.size();
        let settings = PageSettings::from_wh(w, h)
            .ok_or_else(|| CaseError::new("pdf: a page without a size"))?;
        let mut page = pdf.start_page_with(settings);
        draw(
            &mut page.surface(),
            &fonts,
            &layout,
            sheet,
            number,
            &mut drawn,
        );
        links(&mut page, &layout, sheet, &mut drawn)?;
    }
    pdf.set_outline(outline(&layout));
    pdf.set_tag_tree(structure::tree(&layout.elements, &mut drawn));
    pdf.finish()
        .map_err(|error| CaseError::new(format!("pdf: {error:?}")))
}

fn fill(colour: [u8; 3]) -> Fill {
    let [r, g, b] = colour;
    Fill {
        paint: rgb::Color::new(r, g, b).into(),
        ..Fill::default()
    }
}

/// What is no part of the text: rules, boxes, page numbers.
fn artifact() -> ContentTag<'static> {
    ContentTag::Artifact(Artifact::with_kind(ArtifactType::Other))
}

fn draw(
    surface: &mut Surface<'_>,
    fonts: &Fonts,
    layout: &Layout<'_>,
    sheet: &Sheet,
    number: usize,
    drawn: &mut [Vec<Identifier>],
) {
    for item in &sheet.items {
        match item {
            Item::Box {
                x,
                y,
                w,
                h,
                fill: inside,
                border,
            } => {
                let Some(rect) = Rect::from_xywh(*x, *y, *w, *h) else {
                    continue;
                };
                let mut path = PathBuilder::new();
                path.push_rect(rect);
                let Some(path) = path.finish() else { continue };
                surface.start_tagged(artifact());
                surface.set_fill(inside.map(fill));
                surface.set_stroke(border.map(|[r, g, b]| Stroke {
                    paint: rgb::Color::new(r, g, b).into(),
                    width: 0.6,
                    ..Stroke::default()
                }));
                surface.draw_path(&path);
                surface.end_tagged();
            }
            Item::Text {
                x,
                y,
                size,
                style,
                text,
                piece,
            } => {
                // A repeated head of a table belongs to no piece.
                let tag = match drawn.get(*piece) {
                    Some(_) => ContentTag::Span(SpanTag::empty()),
                    None => artifact(),
                };
                let identifier = surface.start_tagged(tag);
                surface.set_stroke(None);
                surface.set_fill(Some(fill([20; 3])));
                let font = fonts.font(*style).clone();
                let at = Point::from_xy(*x, *y);
                surface.draw_text(at, font, *size, text, false, TextDirection::LeftToRight);
                surface.end_tagged();
                if let Some(identifiers) = drawn.get_mut(*piece) {
                    identifiers.push(identifier);
                }
            }
            Item::Picture {
                x,
                y,
                number,
                scale,
                piece,
            } => {
                let Some(picture) = layout.pictures.get(*number) else {
                    continue;
                };
                let identifier = surface.start_tagged(ContentTag::Other);
                picture.draw(surface, *x, *y, *scale);
                surface.end_tagged();
                if let Some(identifiers) = drawn.get_mut(*piece) {
                    identifiers.push(identifier);
                }
            }
            Item::Link { .. } => {}
        }
    }
    let (w, h) = sheet.size();
    let text = format!("{} / {}", number + 1, layout.sheets.len());
    let x = w - MARGIN - fonts.width(&text, Style::Plain, 8.0);
    surface.start_tagged(artifact());
    surface.set_stroke(None);
    surface.set_fill(Some(fill([90; 3])));
    let (at, font) = (
        Point::from_xy(x, h - MARGIN * 0.5),
        fonts.font(Style::Plain).clone(),
    );
    surface.draw_text(at, font, 8.0, &text, false, TextDirection::LeftToRight);
    surface.end_tagged();
}

fn links(
    page: &mut Page<'_>,
    layout: &Layout<'_>,
    sheet: &Sheet,
    drawn: &mut [Vec<Identifier>],
) -> Result<(), CaseError> {
    for item in &sheet.items {
        let Item::Link {
            x,
            y,
            w,
            h,
            to,
            piece,
        } = item
        else {
            continue;
        };
        let (number, height) = layout.places.get(to).ok_or_else(|| {
            CaseError::new(format!("pdf: a reference to `{to}`, which is nowhere"))
        })?;
        let Some(rect) = Rect::from_xywh(*x, *y, *w, *h) else {
            continue;
        };
        let place = XyzDestination::new(*number, Point::from_xy(MARGIN, *height));
        let target = Target::Destination(Destination::Xyz(place));
        let link = LinkAnnotation::new(rect, target);
        let annotation = Annotation::new_link(link, Some(format!("to {to}")));
        let identifier = page.add_tagged_annotation(annotation);
        if let Some(identifiers) = drawn.get_mut(*piece) {
            identifiers.push(identifier);
        }
    }
    Ok(())
}

/// Headings of the second level, with those of the third under them.
fn outline(layout: &Layout<'_>) -> Outline {
    let mut outline = Outline::new();
    let mut open: Option<OutlineNode> = None;
    for (level, text, page, y) in &layout.headings {
        let place = XyzDestination::new(*page, Point::from_xy(MARGIN, *y));
        let node = OutlineNode::new(text.clone(), place);
        match (&mut open, level) {
            (Some(parent), 3..) => parent.push_child(node),
            (_, _) => {
                if let Some(done) = open.replace(node) {
                    outline.push_child(done);
                }
            }
        }
    }
    if let Some(last) = open {
        outline.push_child(last);
    }
    outline
}
