//! Tables, over as many pages as they need.

use super::{A4, Item, LEADING, Layout, MARGIN, SMALL};
use crate::document::{Line, Row, Table};
use crate::pdf::fonts::Style;
use crate::pdf::lines::{Set, set};
use crate::pdf::structure::{Element, Role};

/// Room within a cell.
const PAD: f32 = 3.5;

impl Layout<'_> {
    pub(super) fn table(&mut self, table: &Table) {
        self.room(110.0);
        self.y += 3.0;
        let caption = self.flow(&Line::strong(&table.caption), Style::Bold, SMALL, 0.0);
        self.y += 2.0;
        let whole: f32 = table.head.iter().map(|(_, share)| f32::from(*share)).sum();
        let width = self.width();
        let widths: Vec<f32> = table
            .head
            .iter()
            .map(|(_, share)| width * f32::from(*share) / whole)
            .collect();
        let head = Row {
            id: None,
            cells: table
                .head
                .iter()
                .map(|(name, _)| Line::strong(*name))
                .collect(),
        };
        // Heads repeated on later pages are no further rows of the table.
        let head_row = self.row(&head, &widths, true, None);
        let head_row = vec![Element::Group(Role::Row, head_row)];
        let mut body = Vec::new();
        for row in &table.rows {
            let cells = self.row(row, &widths, false, Some(&head));
            body.push(Element::Group(Role::Row, cells));
        }
        self.elements.push(Element::Group(
            Role::Table,
            vec![
                Element::Group(Role::Caption, caption),
                Element::Group(Role::Head, head_row),
                Element::Group(Role::Body, body),
            ],
        ));
        self.y += 9.0;
    }

    /// A row, broken over pages only when it is taller than a page.
    fn row(
        &mut self,
        row: &Row,
        widths: &[f32],
        is_head: bool,
        head: Option<&Row>,
    ) -> Vec<Element> {
        let leading = SMALL * LEADING;
        let mut cells = Vec::new();
        let mut elements = Vec::new();
        for (index, (cell, width)) in row.cells.iter().zip(widths).enumerate() {
            let style = if index == 0 || is_head {
                Style::Bold
            } else {
                Style::Plain
            };
            let lines = set(self.fonts, cell, style, SMALL, width - 2.0 * PAD);
            let (pieces, numbers) = self.number(cell);
            let role = match (is_head, index) {
                (true, _) => Role::HeadCell(true),
                (false, 0) => Role::HeadCell(false),
                (false, _) => Role::Cell,
            };
            elements.push(Element::Group(role, pieces));
            cells.push((lines, numbers));
        }
        let total = cells
            .iter()
            .map(|(lines, _)| lines.len())
            .max()
            .unwrap_or(1)
            .max(1);
        let mut done = 0;
        while done < total {
            let left = total - done;
            let fits = ((self.bottom() - self.y - 2.0 * PAD) / leading)
                .floor()
                .max(0.0) as usize;
            let page = ((A4.1 - 2.0 * MARGIN - 3.0 * leading - 4.0 * PAD) / leading) as usize;
            if fits < left && (left <= page || fits < 4) {
                self.new_sheet(false);
                if let Some(head) = head {
                    self.repeated_head(head, widths);
                }
                if fits >= left || left <= page {
                    self.draw_row(row, &cells, widths, is_head, done..total);
                    return elements;
                }
                continue;
            }
            let now = left.min(fits.max(1));
            self.draw_row(row, &cells, widths, is_head, done..done + now);
            done += now;
        }
        elements
    }

    /// The head of a table once more, which a reader need not hear again.
    fn repeated_head(&mut self, head: &Row, widths: &[f32]) {
        let cells: Vec<(Vec<Set>, Vec<usize>)> = head
            .cells
            .iter()
            .zip(widths)
            .map(|(cell, width)| {
                let lines = set(self.fonts, cell, Style::Bold, SMALL, width - 2.0 * PAD);
                (lines, vec![usize::MAX; cell.0.len()])
            })
            .collect();
        let total = cells
            .iter()
            .map(|(lines, _)| lines.len())
            .max()
            .unwrap_or(1);
        self.draw_row(head, &cells, widths, true, 0..total);
    }

    fn draw_row(
        &mut self,
        row: &Row,
        cells: &[(Vec<Set>, Vec<usize>)],
        widths: &[f32],
        is_head: bool,
        range: std::ops::Range<usize>,
    ) {
        if let Some(id) = &row.id {
            self.mark(id);
        }
        let leading = SMALL * LEADING;
        let h = range.len() as f32 * leading + 2.0 * PAD;
        let mut x = MARGIN;
        for (index, ((lines, numbers), width)) in cells.iter().zip(widths).enumerate() {
            let fill = match (is_head, index) {
                (true, _) => Some([230, 237, 244]),
                (false, 0) => Some([247; 3]),
                (false, _) => None,
            };
            let (y, w) = (self.y, *width);
            self.put(Item::Box {
                x,
                y,
                w,
                h,
                fill,
                border: Some([150; 3]),
            });
            for (place, line) in lines.iter().skip(range.start).take(range.len()).enumerate() {
                let top = self.y + PAD + place as f32 * leading;
                self.draw(line, x + PAD, top, SMALL, numbers);
            }
            x += width;
        }
        self.y += h;
    }
}
