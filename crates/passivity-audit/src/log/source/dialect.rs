//! How a CSV file is written, and what it may be where it is not understood.

use std::io::Read;

use passivity_scene::Scene;

use super::{shape, transcript};
use crate::log::columns::Columns;
use crate::log::csv::{self, Notation};
use crate::log::digits::Seen;
use crate::log::error::{TraceError, legible, shown};
use crate::log::guess;
use crate::log::layout::Layout;
use crate::log::lines::Lines;
use crate::log::piece::Said;
use crate::log::preview::Preview;

/// How the columns of a log are called, and how its numbers are written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Dialect {
    /// What the columns say; `None` where their names do.
    pub columns: Option<Columns>,
    /// What stands between the fields of CSV; `None` for a comma, or for a semicolon where numbers are
    /// written with commas.
    pub delimiter: Option<u8>,
    /// Whether numbers are written with a comma, as in `0,25`.
    pub decimal_comma: bool,
}

impl Dialect {
    /// What a CSV file says before its rows, of which the first ones are looked at.
    pub(crate) fn heading(
        &self,
        lines: &mut Lines<impl Read>,
        scene: &Scene,
    ) -> Result<(Layout, Said, Notation), TraceError> {
        let (line, notation) = self.names(lines)?;
        let (line, early) = (&line[..], lines.early());
        let rows: Vec<&[u8]> = early.iter().map(|(_, line)| *line).collect();
        if let Some(message) = transcript::remedy(line, &rows) {
            return Err(TraceError::new("format", message));
        }
        let told = self.columns.as_ref();
        let mut layout = layout(line, &rows, notation, told, scene).map_err(|error| {
            let below = self.lines_below(line, &early, notation);
            below.unwrap_or_else(|| otherwise(error, notation, (line, &rows), self, scene))
        })?;
        let said = Said {
            headings: layout.headings.clone(),
            preview: csv::preview(first(&rows), &layout.headings, notation),
        };
        if let Some(force) = layout.force {
            let mut seen = Seen::default();
            lines.see(force, notation, &mut seen);
            layout.digits = seen.digits;
        }
        Ok((layout, said, notation))
    }

    /// The line with the names of the columns, and how the text is written.
    pub(super) fn names(
        &self,
        lines: &mut Lines<impl Read>,
    ) -> Result<(Vec<u8>, Notation), TraceError> {
        let start = lines.start()?;
        let notation = self.notation(start.delimiter)?;
        let early = lines.early().into_iter().take(2);
        let early: Vec<&[u8]> = early.map(|(_, line)| line).collect();
        match shape::with_units(&start.names, &early, notation)? {
            Some(names) => {
                lines.line()?;
                Ok((names, notation))
            }
            None => Ok((start.names, notation)),
        }
    }

    /// What stands between fields, as far as was said, or else what may.
    fn delimiters(&self, own: Notation) -> Vec<u8> {
        match self.delimiter {
            Some(_) => vec![own.delimiter],
            None => vec![b';', b'\t', b'|', b' ', b','],
        }
    }

    /// The error of a text whose names seem to stand below its first line.
    fn lines_below(
        &self,
        line: &[u8],
        early: &[(usize, &[u8])],
        own: Notation,
    ) -> Option<TraceError> {
        let rows: Vec<&[u8]> = early.iter().map(|(_, line)| *line).collect();
        let with = |delimiter| Notation {
            delimiter,
            decimal_comma: own.decimal_comma || csv::has_decimal_commas(&rows, delimiter),
        };
        let notations: Vec<Notation> = self.delimiters(own).into_iter().map(with).collect();
        let is_header = |line: &[u8], rows: &[&[u8]]| {
            let mut notations = notations.iter();
            notations.any(|notation| shape::is_header(line, rows, *notation))
        };
        if is_header(line, &rows) {
            return None;
        }
        let mut below = early.iter().enumerate();
        let (_, (number, names)) = below.find(|(i, (_, line))| {
            let rows = rows.get(i + 1..).unwrap_or_default();
            is_header(line, rows)
        })?;
        let message = format!(
            "the names of the columns seem to stand in line {number}, `{}`: remove the lines before it, or write `#` at the \
             start of each of them",
            shown(names)
        );
        Some(TraceError::new("header", message))
    }

    /// How a text is written, which may say itself what stands between fields.
    fn notation(&self, said: Option<u8>) -> Result<Notation, TraceError> {
        let usual = if self.decimal_comma { b';' } else { b',' };
        let delimiter = self.delimiter.or(said).unwrap_or(usual);
        let refuse = |message: &str| Err(TraceError::new("delimiter", message));
        let is_number = delimiter.is_ascii_alphanumeric() || b"+-./\"".contains(&delimiter);
        if is_number || !(delimiter == b'\t' || (b' '..=b'~').contains(&delimiter)) {
            return refuse("what stands between fields must be one character that is in no number");
        }
        Ok(Notation {
            delimiter,
            decimal_comma: self.decimal_comma,
        })
    }
}

/// The rows by which a header is judged.
fn first<'r, 't>(rows: &'r [&'t [u8]]) -> &'r [&'t [u8]] {
    rows.get(..Preview::ROWS).unwrap_or(rows)
}

fn layout(
    line: &[u8],
    rows: &[&[u8]],
    notation: Notation,
    told: Option<&Columns>,
    scene: &Scene,
) -> Result<Layout, TraceError> {
    let headings = csv::headings(line, first(rows), notation)?;
    let mut preview = csv::preview(first(rows), &headings, notation);
    if preview.stands_still() {
        let later = rows.get(Preview::ROWS..).unwrap_or_default();
        preview.later = csv::preview(later, &headings, notation).columns;
    }
    Layout::read(headings, told, &preview, scene)
}

/// The error of a header, with what it says when its fields stand apart by another character, or its numbers are
/// written with a comma: where that makes sense, it is what is proposed.
fn otherwise(
    mut error: TraceError,
    own: Notation,
    (line, rows): (&[u8], &[&[u8]]),
    dialect: &Dialect,
    scene: &Scene,
) -> TraceError {
    let first = first(rows);
    let written = |proposal: &mut guess::Proposal, notation: Notation| {
        proposal.delimiter = notation.said_delimiter();
        proposal.decimal_comma = notation.decimal_comma;
    };
    if !shape::is_even(line, first, own) {
        error.proposal = None;
    }
    if let Some(proposal) = &mut error.proposal {
        written(proposal, own);
    }
    let mut read = own;
    let delimiters = dialect.delimiters(own);
    let with = |delimiter| Notation {
        delimiter,
        decimal_comma: own.decimal_comma || csv::has_decimal_commas(first, delimiter),
    };
    let there = |delimiter: &&u8| line.contains(*delimiter);
    for delimiter in delimiters.iter().filter(there).copied() {
        let notation = with(delimiter);
        // Names have other characters too: where these stand between fields, rows have as many.
        if notation == own || !shape::is_table(line, first, notation) {
            continue;
        }
        let united = shape::with_units(line, first, notation).ok().flatten();
        let (line, rows) = match &united {
            Some(line) => (&line[..], rows.get(1..).unwrap_or_default()),
            None => (line, rows),
        };
        let told = dialect.columns.as_ref();
        let proposal = match layout(line, rows, notation, told, scene) {
            Ok(layout) => layout.proposal(),
            Err(other) => {
                // As one column it says nothing.
                let is_one =
                    !line.contains(&own.delimiter) && shape::is_even(line, first, notation);
                if is_one && error.proposal.is_none() && other.proposal.is_none() {
                    let options = match notation.with_options().strip_prefix(", with ") {
                        Some(options) => format!(" ({options} says so)"),
                        None => String::new(),
                    };
                    let message = format!("{}{options}, and then {other}", apart(notation, own));
                    error = TraceError::new(other.kind, message);
                    read = notation;
                }
                other.proposal
            }
        };
        let Some(mut proposal) = proposal else {
            continue;
        };
        // Of two ways to read the header the one that tells more.
        let own_says = error.proposal.as_ref().map_or(0, |proposal| proposal.said);
        if own_says >= proposal.said {
            continue;
        }
        written(&mut proposal, notation);
        error.message = match delimiter == own.delimiter {
            true => "its numbers seem to be written with a comma".to_owned(),
            false => apart(notation, own),
        };
        error.column = None;
        error.proposal = Some(proposal);
    }
    let obstacle = shape::obstacle(line, first, own, scene).or_else(|| {
        // Of rows that stand apart otherwise under names that do not.
        let is_one = !line.contains(&own.delimiter);
        let others = delimiters.iter().chain(b" ").filter(there);
        let mut others = others.map(|delimiter| with(*delimiter)).filter(|_| is_one);
        others.find_map(|notation| {
            let obstacle = shape::obstacle(line, first, notation, scene)?;
            Some(format!("{}, and then {obstacle}", apart(notation, own)))
        })
    });
    if let Some(message) = obstacle.filter(|_| error.proposal.is_none()) {
        error = TraceError::new("header", message);
    } else if error.proposal.is_none()
        && let Some(why) = csv::misread(first, read)
    {
        error.message = format!("{}; {why}", error.message);
    }
    error
}

/// What is said where fields stand apart otherwise than was taken for granted.
fn apart(notation: Notation, own: Notation) -> String {
    let [text, usual] = [notation, own].map(|it| legible(&char::from(it.delimiter).to_string()));
    format!("its fields seem to stand apart by `{text}`, not by `{usual}`")
}
