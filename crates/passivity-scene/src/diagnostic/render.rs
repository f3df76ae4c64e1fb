//! Diagnostics for people: the line, a mark under the place, and what was expected.

use std::fmt;
use std::ops::Range;

use miette::{
    GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteError, MietteSpanContents,
    SourceCode, SourceSpan, SpanContents,
};

use super::{Diagnostic, line_and_column};

/// How much of a line is shown before and after the place, in bytes.
const BEFORE: usize = 60;
const AFTER: usize = 100;

/// Width at which messages wrap.
const WIDTH: usize = 100;

/// How diagnostics are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// In colours, with lines of box-drawing characters.
    Colours,
    /// Without colours.
    Plain,
    /// Without colours, with lines of ASCII characters.
    Ascii,
}

impl From<bool> for Look {
    /// Colours, or none.
    fn from(colours: bool) -> Self {
        if colours { Self::Colours } else { Self::Plain }
    }
}

pub(super) fn all(name: &str, source: &str, diagnostics: &[Diagnostic], look: Look) -> String {
    let theme = match look {
        Look::Colours => GraphicalTheme::unicode(),
        Look::Plain => GraphicalTheme::unicode_nocolor(),
        Look::Ascii => GraphicalTheme::none(),
    };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(WIDTH)
        .with_links(false);
    let mut shown = String::new();
    for diagnostic in diagnostics {
        let excerpt = diagnostic
            .span
            .as_ref()
            .map(|span| Excerpt::new(name, source, span));
        let report = Report {
            diagnostic,
            excerpt,
            place: printable(name),
        };
        // Writing to a string cannot fail; should it, the plain message is still there.
        if handler.render_report(&mut shown, &report).is_err() {
            shown.push_str(&report.to_string());
        }
        shown.push('\n');
    }
    shown
}

/// The text without characters that move a terminal's cursor or turn its text around, each
/// replaced by as many bytes.
pub(super) fn printable(text: &str) -> String {
    let replaced = text.chars().map(|c| {
        let hidden = matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
        let spared = c == '\n' || c == '\t';
        match c.len_utf8() {
            // The end of a line elsewhere.
            1 if c == '\r' => " ",
            1 if c.is_control() && !spared => "?",
            2 if c.is_control() || hidden => "??",
            3 if hidden => "\u{fffd}",
            _ => return c.to_string(),
        }
        .to_owned()
    });
    replaced.collect()
}

/// The part of the text that is shown: the line of the place, or what is near it in a long one.
struct Excerpt {
    name: String,
    text: String,
    /// Where the excerpt starts in the whole text, in bytes and as line and column from 0.
    start: usize,
    line: usize,
    column: usize,
    /// The place, cut to the excerpt, in bytes of the whole text, and its line and column from 0.
    place: Range<usize>,
    place_line: usize,
    place_column: usize,
}

impl Excerpt {
    fn new(name: &str, source: &str, span: &Range<usize>) -> Self {
        let at = boundary_before(source, span.start.min(source.len()));
        let line_start = source
            .get(..at)
            .and_then(|s| s.rfind('\n'))
            .map_or(0, |n| n + 1);
        let rest = source.get(at..).unwrap_or_default();
        let line_end = at + rest.find('\n').unwrap_or(rest.len());
        let mut start = boundary_before(source, at.saturating_sub(BEFORE).max(line_start));
        let end = boundary_before(source, line_end.min(at + AFTER));
        // A line before, when it is short: usually the section's head.
        let previous = source
            .get(..line_start.saturating_sub(1))
            .filter(|_| line_start > 0);
        if let Some(previous) = previous.filter(|_| start == line_start) {
            let previous_start = previous.rfind('\n').map_or(0, |n| n + 1);
            if line_start - previous_start <= AFTER {
                start = previous_start;
            }
        }
        let (line, column) = line_and_column(source, start);
        let (place_line, place_column) = line_and_column(source, at);
        Self {
            name: printable(name),
            text: printable(source.get(start..end).unwrap_or_default()),
            start,
            line: line - 1,
            column: column - 1,
            place: at..boundary_before(source, span.end.clamp(at, end.max(at))),
            place_line: place_line - 1,
            place_column: place_column - 1,
        }
    }
}

fn boundary_before(text: &str, mut at: usize) -> usize {
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl SourceCode for Excerpt {
    fn read_span<'a>(
        &'a self,
        _span: &SourceSpan,
        context_lines_before: usize,
        _context_lines_after: usize,
    ) -> Result<Box<dyn SpanContents<'a> + 'a>, MietteError> {
        // Without context the question is where the place is; else, what to show around it.
        let (range, line, column) = if context_lines_before == 0 {
            (self.place.clone(), self.place_line, self.place_column)
        } else {
            (
                self.start..self.start + self.text.len(),
                self.line,
                self.column,
            )
        };
        let inner = range.start - self.start..range.end - self.start;
        let data = self
            .text
            .as_bytes()
            .get(inner)
            .ok_or(MietteError::OutOfBounds)?;
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            data,
            range.into(),
            line,
            column,
            1,
        )))
    }
}

struct Report<'a> {
    diagnostic: &'a Diagnostic,
    excerpt: Option<Excerpt>,
    place: String,
}

impl fmt::Debug for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.excerpt.is_none() {
            write!(f, "{}: ", self.place)?;
        }
        f.write_str(&self.diagnostic.message)
    }
}

impl std::error::Error for Report<'_> {}

impl miette::Diagnostic for Report<'_> {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.diagnostic.kind.name()))
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        // Without a place to write it under, what was expected goes with the help.
        let unplaced = self
            .diagnostic
            .expected
            .as_ref()
            .filter(|_| self.excerpt.is_none());
        let expected = unplaced.map(|expected| format!("expected {expected}"));
        let parts: Vec<&str> = expected
            .as_deref()
            .into_iter()
            .chain(self.diagnostic.help.as_deref())
            .collect();
        (!parts.is_empty()).then(|| Box::new(parts.join("; ")) as Box<dyn fmt::Display>)
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.excerpt
            .as_ref()
            .map(|excerpt| excerpt as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let excerpt = self.excerpt.as_ref()?;
        let label = match &self.diagnostic.expected {
            Some(expected) => format!("expected {expected}"),
            None => "here".to_owned(),
        };
        let place = excerpt.place.clone();
        let label = LabeledSpan::new_primary_with_span(Some(label), place);
        Some(Box::new(std::iter::once(label)))
    }
}
