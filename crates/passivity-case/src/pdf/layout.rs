//! Where everything goes: from the blocks of a document to pages.

mod table;

use std::collections::BTreeMap;

use super::fonts::{Fonts, Style};
use super::lines::{Set, set};
use super::structure::{Element, Role};
use super::svg::Picture;
use crate::document::{Block, Document, Figure, Line};
use crate::error::CaseError;

/// A4 upright, in points.
pub(super) const A4: (f32, f32) = (595.28, 841.89);
/// The margin on all sides.
pub(super) const MARGIN: f32 = 45.0;
const BODY: f32 = 9.5;
const SMALL: f32 = 8.0;
/// From base line to base line, as a multiple of the size of the letters.
const LEADING: f32 = 1.4;

/// Something on a page.
#[derive(Clone, Debug)]
pub(super) enum Item {
    /// A run of text with its base line at `y`; `piece` says what it is part of.
    Text {
        x: f32,
        y: f32,
        size: f32,
        style: Style,
        text: String,
        piece: usize,
    },
    /// A rectangle: fill and border as grey or colour.
    Box {
        x: f32,
        y: f32,
        w: f32,
        h: f32,
        fill: Option<[u8; 3]>,
        border: Option<[u8; 3]>,
    },
    /// A picture by its number, scaled.
    Picture {
        x: f32,
        y: f32,
        number: usize,
        scale: f32,
        piece: usize,
    },
    /// A reference: where it can be clicked, and the id it leads to.
    Link {
        x: f32,
        y: f32,
        w: f32,
        h: f32,
        to: String,
        piece: usize,
    },
}

/// A page.
#[derive(Clone, Debug, Default)]
pub(super) struct Sheet {
    pub(super) turned: bool,
    pub(super) items: Vec<Item>,
}

impl Sheet {
    pub(super) const fn size(&self) -> (f32, f32) {
        if self.turned { (A4.1, A4.0) } else { A4 }
    }
}

/// The pages, and what is on them.
pub(super) struct Layout<'a> {
    fonts: &'a Fonts,
    pub(super) sheets: Vec<Sheet>,
    pub(super) pictures: Vec<Picture>,
    /// Where each id is: page and height.
    pub(super) places: BTreeMap<String, (usize, f32)>,
    /// Headings for the outline: level, text, page, height.
    pub(super) headings: Vec<(u8, String, usize, f32)>,
    pub(super) elements: Vec<Element>,
    pub(super) pieces: usize,
    /// Whether the page on its side waits for its picture, under a heading.
    headed: bool,
    y: f32,
}

impl<'a> Layout<'a> {
    /// Lays out a document.
    pub(super) fn of(fonts: &'a Fonts, document: &Document) -> Result<Self, CaseError> {
        let mut layout = Self {
            fonts,
            sheets: vec![Sheet::default()],
            pictures: Vec::new(),
            places: BTreeMap::new(),
            headings: Vec::new(),
            elements: Vec::new(),
            pieces: 0,
            headed: false,
            y: MARGIN,
        };
        layout.title(document);
        let next = document.blocks.iter().skip(1).map(Some).chain([None]);
        for (block, next) in document.blocks.iter().zip(next) {
            // The heading of a wide picture goes onto the picture's page.
            if let (Block::Heading { .. }, Some(Block::Figure(Figure { wide: true, .. }))) =
                (block, next)
            {
                layout.new_sheet(true);
                layout.headed = true;
            }
            layout.block(block)?;
        }
        Ok(layout)
    }

    fn width(&self) -> f32 {
        self.sheet().size().0 - 2.0 * MARGIN
    }

    fn bottom(&self) -> f32 {
        self.sheet().size().1 - MARGIN
    }

    fn sheet(&self) -> &Sheet {
        // There is always a page: `of` starts with one.
        &self.sheets[self.sheets.len() - 1]
    }

    fn put(&mut self, item: Item) {
        if let Some(sheet) = self.sheets.last_mut() {
            sheet.items.push(item);
        }
    }

    fn new_sheet(&mut self, turned: bool) {
        self.sheets.push(Sheet {
            turned,
            items: Vec::new(),
        });
        self.y = MARGIN;
    }

    /// Starts a new page unless `height` fits on this one.
    fn room(&mut self, height: f32) {
        let full = self.y + height > self.bottom() && self.y > MARGIN;
        if full || self.sheet().turned && !self.headed {
            self.new_sheet(false);
        }
    }

    fn mark(&mut self, id: &str) {
        let place = (self.sheets.len() - 1, self.y);
        self.places.entry(id.to_owned()).or_insert(place);
    }

    fn title(&mut self, document: &Document) {
        let title = self.flow(&Line::text(&document.title), Style::Bold, 18.0, 0.0);
        self.elements.push(Element::Group(
            Role::Heading(1, document.title.clone()),
            title,
        ));
        let subtitle = self.flow(&Line::text(&document.subtitle), Style::Plain, BODY, 0.0);
        self.elements
            .push(Element::Group(Role::Paragraph, subtitle));
        self.y += 10.0;
    }

    fn block(&mut self, block: &Block) -> Result<(), CaseError> {
        match block {
            Block::Heading { level, id, text } => self.heading(*level, id, text),
            Block::Paragraph(line) => {
                let pieces = self.flow(line, Style::Plain, BODY, 0.0);
                self.elements.push(Element::Group(Role::Paragraph, pieces));
                self.y += 5.0;
            }
            Block::Verdict(good, line) => self.verdict(*good, line),
            Block::List(items) => self.list(items),
            Block::Table(table) => self.table(table),
            Block::Figure(figure) => self.figure(figure)?,
            Block::Listing(text) => self.listing(text),
        }
        Ok(())
    }

    fn heading(&mut self, level: u8, id: &str, text: &str) {
        let size = if level == 2 { 14.0 } else { 11.0 };
        self.y += size;
        // A heading does not stand alone at the foot of a page.
        self.room(size * 2.0 + 90.0);
        self.mark(id);
        self.headings
            .push((level, text.to_owned(), self.sheets.len() - 1, self.y));
        let pieces = self.flow(&Line::text(text), Style::Bold, size, 0.0);
        self.elements.push(Element::Group(
            Role::Heading(level.into(), text.to_owned()),
            pieces,
        ));
        if level == 2 {
            let (y, w) = (self.y, self.width());
            let rule = Item::Box {
                x: MARGIN,
                y,
                w,
                h: 1.2,
                fill: Some([31, 78, 121]),
                border: None,
            };
            self.put(rule);
            self.y += 4.0;
        }
        self.y += 4.0;
    }

    /// Text from the left margin plus `indent` to the right one, over pages.
    fn flow(&mut self, line: &Line, style: Style, size: f32, indent: f32) -> Vec<Element> {
        // After a page on its side the text goes on upright, in another width.
        self.room(size * LEADING);
        let lines = set(self.fonts, line, style, size, self.width() - indent);
        let (elements, numbers) = self.number(line);
        for line in lines {
            self.room(size * LEADING);
            self.draw(&line, MARGIN + indent, self.y, size, &numbers);
            self.y += size * LEADING;
        }
        elements
    }

    /// Gives each piece of a line a number of its own.
    fn number(&mut self, line: &Line) -> (Vec<Element>, Vec<usize>) {
        let numbers: Vec<usize> = (self.pieces..self.pieces + line.0.len()).collect();
        self.pieces += line.0.len();
        let elements = line
            .0
            .iter()
            .zip(&numbers)
            .map(|(inline, number)| match inline {
                crate::document::Inline::Link(..) => {
                    Element::Group(Role::Link, vec![Element::Piece(*number)])
                }
                _ => Element::Piece(*number),
            })
            .collect();
        (elements, numbers)
    }

    /// Draws a line with its top at `y`.
    fn draw(&mut self, line: &Set, x: f32, y: f32, size: f32, numbers: &[usize]) {
        for run in line {
            let piece = numbers.get(run.piece).copied().unwrap_or_default();
            if let Some(to) = &run.link {
                let (w, h) = (run.width, size * 1.2);
                self.put(Item::Link {
                    x: x + run.x,
                    y,
                    w,
                    h,
                    to: to.clone(),
                    piece,
                });
            }
            self.put(Item::Text {
                x: x + run.x,
                y: y + size,
                size,
                style: run.style,
                text: run.text.clone(),
                piece,
            });
        }
    }

    fn verdict(&mut self, good: bool, line: &Line) {
        let (fill, border) = if good {
            ([234, 245, 230], [47, 107, 42])
        } else {
            ([251, 228, 228], [161, 18, 18])
        };
        self.room(BODY * LEADING);
        let lines = set(self.fonts, line, Style::Bold, BODY, self.width() - 24.0);
        let h = lines.len() as f32 * BODY * LEADING + 12.0;
        self.room(h + 6.0);
        let (x, y, w) = (MARGIN, self.y, self.width());
        self.put(Item::Box {
            x,
            y,
            w,
            h,
            fill: Some(fill),
            border: Some(border),
        });
        self.put(Item::Box {
            x,
            y,
            w: 5.0,
            h,
            fill: Some(border),
            border: None,
        });
        let (elements, numbers) = self.number(line);
        for (index, line) in lines.iter().enumerate() {
            let top = y + 6.0 + index as f32 * BODY * LEADING;
            self.draw(line, x + 14.0, top, BODY, &numbers);
        }
        self.elements
            .push(Element::Group(Role::Paragraph, elements));
        self.y += h + 7.0;
    }

    fn list(&mut self, items: &[Line]) {
        let mut all = Vec::new();
        for item in items {
            self.room(BODY * LEADING);
            let (x, y) = (MARGIN + 4.0, self.y + BODY * 0.52);
            self.put(Item::Box {
                x,
                y,
                w: 3.0,
                h: 3.0,
                fill: Some([40; 3]),
                border: None,
            });
            let pieces = self.flow(item, Style::Plain, BODY, 14.0);
            all.push(Element::Group(Role::Item, pieces));
            self.y += 2.0;
        }
        self.elements.push(Element::Group(Role::List, all));
        self.y += 4.0;
    }

    fn listing(&mut self, text: &str) {
        let mut pieces = Vec::new();
        for line in text.lines() {
            pieces.extend(self.flow(&Line::code(line), Style::Mono, SMALL, 8.0));
        }
        let code = vec![Element::Group(Role::Code, pieces)];
        self.elements.push(Element::Group(Role::Paragraph, code));
        self.y += 6.0;
    }

    fn figure(&mut self, figure: &Figure) -> Result<(), CaseError> {
        let picture = Picture::read(&figure.svg)?;
        let (w, h) = picture.size();
        let caption_height = SMALL * LEADING * 2.0 + 8.0;
        if figure.wide && !self.headed {
            self.new_sheet(true);
        }
        self.headed = false;
        let top = if figure.wide { self.y } else { MARGIN };
        let most = self.bottom() - top - caption_height;
        // Never larger than drawn: 0.75 points make a pixel.
        let scale = (self.width() / w).min(most / h).min(0.75);
        if !figure.wide {
            self.room(h * scale + caption_height);
        }
        self.mark(&figure.id);
        let number = self.pictures.len();
        self.pictures.push(picture);
        let piece = self.pieces;
        self.pieces += 1;
        self.put(Item::Picture {
            x: MARGIN,
            y: self.y,
            number,
            scale,
            piece,
        });
        self.y += h * scale + 4.0;
        let width = self.width();
        let caption = Line::text(&figure.caption);
        let (elements, numbers) = self.number(&caption);
        for line in set(self.fonts, &caption, Style::Plain, SMALL, width) {
            self.draw(&line, MARGIN, self.y, SMALL, &numbers);
            self.y += SMALL * LEADING;
        }
        self.elements.push(Element::Group(
            Role::Figure(figure.alt.clone()),
            vec![
                Element::Piece(piece),
                Element::Group(Role::Caption, elements),
            ],
        ));
        self.y += 8.0;
        Ok(())
    }
}
