//! Errors in a trace, with their place.

use std::fmt;

use serde::Serialize;

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
}

impl TraceError {
    pub(crate) fn new(kind: &'static str, message: impl Into<String>) -> Self {
        Self {
            kind,
            row: None,
            column: None,
            message: message.into(),
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

    pub(crate) fn io(error: &std::io::Error) -> Self {
        Self::new("io", error.to_string())
    }
}

impl fmt::Display for TraceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(row) = self.row {
            write!(f, "row {row}")?;
        }
        if let Some(column) = &self.column {
            let separator = if self.row.is_some() { ", " } else { "" };
            write!(f, "{separator}column `{column}`")?;
        }
        if self.row.is_some() || self.column.is_some() {
            f.write_str(": ")?;
        }
        f.write_str(&self.message)
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

/// Foreign text as it may be shown: short, and without control characters.
pub(crate) fn shown(text: &[u8]) -> String {
    const MOST: usize = 40;
    let text = String::from_utf8_lossy(text);
    let mut shown: String = text
        .chars()
        .take(MOST)
        .flat_map(char::escape_default)
        .collect();
    if text.chars().count() > MOST {
        shown.push('…');
    }
    shown
}
