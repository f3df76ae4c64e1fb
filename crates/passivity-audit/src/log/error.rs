//! Errors in a trace, with their place.

use std::fmt;

use serde::Serialize;

use crate::log::guess::Proposal;
use crate::number::{MAX_BITS, Number};

/// A mistake in a trace.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TraceError {
    /// What kind of mistake it is, for programs.
    pub kind: &'static str,
    /// The row, from 1, the header not counted; `None` for the trace as a whole or its header.
    pub row: Option<u64>,
    /// The column, by its name.
    pub column: Option<String>,
    /// What is wrong, and what was expected.
    pub message: String,
    /// The file, where the log is of several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// What the header may mean, to be asked for in its place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub proposal: Option<Box<Proposal>>,
}

impl TraceError {
    pub(crate) fn new(kind: &'static str, message: impl Into<String>) -> Self {
        Self {
            kind,
            row: None,
            column: None,
            message: message.into(),
            file: None,
            proposal: None,
        }
    }

    pub(crate) fn row(mut self, row: u64) -> Self {
        self.row = Some(row);
        self
    }

    pub(crate) fn column(mut self, column: impl Into<String>) -> Self {
        self.column = Some(column.into());
        self
    }

    /// The same of a file.
    pub(crate) fn of(mut self, file: &str) -> Self {
        self.file = Some(file.to_owned());
        self
    }

    pub(crate) fn io(error: &std::io::Error) -> Self {
        Self::new("io", error.to_string())
    }
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let column = |name: &String| format!("column `{}`", shown(name.as_bytes()));
        let place = [
            self.file.as_deref().map(legible),
            self.row.map(|row| format!("row {row}")),
            self.column.as_ref().map(column),
        ];
        let place: Vec<String> = place.into_iter().flatten().collect();
        if !place.is_empty() {
            write!(f, "{}: ", place.join(", "))?;
        }
        f.write_str(&self.message)?;
        match &self.proposal {
            Some(proposal) => write!(f, "; {proposal}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for TraceError {}

/// Reads an exact number of bounded width.
pub(crate) fn number(literal: &str) -> Result<Number, TraceError> {
    let place = || shown(literal.as_bytes());
    let number = Number::parse(literal)
        .map_err(|error| TraceError::new(error.kind().name(), format!("`{}`: {error}", place())))?;
    if number.is_bounded() {
        return Ok(number);
    }
    let message = format!("`{}`: a number of more than {MAX_BITS} bits", place());
    Err(TraceError::new("number_too_long", message))
}

/// Foreign text as it may be shown: short, and without characters that move a terminal's cursor or
/// turn its text around.
pub(crate) fn shown(text: &[u8]) -> String {
    const MOST: usize = 40;
    let text = String::from_utf8_lossy(text);
    let first: String = text.chars().take(MOST).collect();
    let mut shown = legible(&first);
    if text.chars().nth(MOST).is_some() {
        shown.push('…');
    }
    shown
}

/// The whole of a text, such as the name of a file, with what hides in it escaped.
#[must_use]
pub fn legible(text: &str) -> String {
    let mut shown = String::new();
    for c in text.chars() {
        match hides(c) {
            true => shown.extend(c.escape_default()),
            false => shown.push(c),
        }
    }
    shown
}

/// Whether a text has characters that a terminal does not show as they are.
pub(crate) fn is_hidden(text: &str) -> bool {
    text.chars().any(hides)
}

fn hides(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}
