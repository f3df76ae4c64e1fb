//! Mistakes in a scene file: the place, what was found and what was expected.

mod kind;
mod render;

pub use kind::Kind;
pub use render::Look;

use std::fmt;
use std::ops::Range;

use serde_json::{Value, json};

/// How many diagnostics an error keeps: a file that has more is not a scene file.
pub const MAX_DIAGNOSTICS: usize = 30;

/// One thing that is wrong with a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    pub(crate) kind: Kind,
    pub(crate) message: String,
    pub(crate) key: Option<String>,
    pub(crate) span: Option<Range<usize>>,
    pub(crate) place: Option<(usize, usize)>,
    pub(crate) expected: Option<String>,
    pub(crate) found: Option<String>,
    pub(crate) help: Option<String>,
}

impl Diagnostic {
    pub(crate) fn new(kind: Kind, message: impl Into<String>) -> Self {
        Self {
            kind,
            message: message.into(),
            key: None,
            span: None,
            place: None,
            expected: None,
            found: None,
            help: None,
        }
    }

    pub(crate) fn at(mut self, span: Range<usize>) -> Self {
        self.span = Some(span);
        self
    }

    pub(crate) fn key(mut self, key: impl Into<String>) -> Self {
        self.key = Some(key.into());
        self
    }

    pub(crate) fn expected(mut self, expected: impl Into<String>) -> Self {
        self.expected = Some(expected.into());
        self
    }

    pub(crate) fn found(mut self, found: impl Into<String>) -> Self {
        self.found = Some(found.into());
        self
    }

    pub(crate) fn help(mut self, help: Option<String>) -> Self {
        self.help = help;
        self
    }

    /// What kind of mistake it is: for programs.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        self.kind
    }

    /// What is wrong, in a lower-case sentence without its full stop.
    #[must_use]
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The key it is about, with its section, as in `device.viscous`.
    #[must_use]
    pub fn scene_key(&self) -> Option<&str> {
        self.key.as_deref()
    }

    /// The line, counted from 1; `None` when no text was read.
    #[must_use]
    pub fn line(&self) -> Option<usize> {
        self.place.map(|(line, _)| line)
    }

    /// The column, counted from 1 in characters.
    #[must_use]
    pub fn column(&self) -> Option<usize> {
        self.place.map(|(_, column)| column)
    }

    /// Where in the text, in bytes.
    #[must_use]
    pub fn span(&self) -> Option<Range<usize>> {
        self.span.clone()
    }

    fn to_json(&self) -> Value {
        let at = match (self.place, &self.span) {
            (Some((line, column)), Some(span)) => {
                json!({"line": line, "column": column, "span": [span.start, span.end]})
            }
            _ => Value::Null,
        };
        json!({
            "kind": self.kind.name(),
            "message": self.message,
            "key": self.key,
            "at": at,
            "expected": self.expected,
            "found": self.found,
            "help": self.help,
        })
    }
}

/// Everything that is wrong with a scene.
///
/// # Example
///
/// ```
/// use passivity_scene::Scene;
///
/// let text = "[sampling]\nperiod = \"1 ms\"\n[wall]\nstifness = \"2 N m/rad\"\n";
/// let error = Scene::from_toml("typo", text).unwrap_err();
/// let first = &error.diagnostics()[0];
/// assert_eq!((first.kind().name(), first.line()), ("missing_key", Some(3)));
/// assert_eq!(error.diagnostics()[1].kind().name(), "unknown_key");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    name: String,
    source: String,
    diagnostics: Vec<Diagnostic>,
    left_out: usize,
}

impl SceneError {
    /// The error with its diagnostics in the order of the text; there must be at least one.
    pub(crate) fn new(name: &str, source: &str, mut diagnostics: Vec<Diagnostic>) -> Self {
        diagnostics.sort_by_key(|d| d.span.as_ref().map_or(0, |span| span.start));
        let left_out = diagnostics.len().saturating_sub(MAX_DIAGNOSTICS);
        diagnostics.truncate(MAX_DIAGNOSTICS);
        for diagnostic in &mut diagnostics {
            diagnostic.place = diagnostic
                .span
                .as_ref()
                .map(|span| line_and_column(source, span.start));
        }
        Self {
            name: name.to_owned(),
            source: source.to_owned(),
            diagnostics,
            left_out,
        }
    }

    /// What is wrong, in the order of the text: at least one, at most [`MAX_DIAGNOSTICS`].
    #[must_use]
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The error without what it says of a section or key, for readers of scenes that may lack it; `None` where
    /// nothing else is wrong.
    #[must_use]
    pub fn without(mut self, key: &str) -> Option<Self> {
        self.diagnostics
            .retain(|diagnostic| diagnostic.scene_key() != Some(key));
        (!self.diagnostics.is_empty()).then_some(self)
    }

    /// The scene's file, or its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The error for people: each place with the line it is in, marked, and what was expected.
    #[must_use]
    pub fn render(&self, look: impl Into<Look>) -> String {
        let mut shown = render::all(&self.name, &self.source, &self.diagnostics, look.into());
        if self.left_out > 0 {
            shown.push_str(&format!("  and {} more\n", self.left_out));
        }
        shown
    }

    /// The error for programs: `{"file": …, "errors": [{"kind", "message", "key", "at",
    /// "expected", "found", "help"}]}`, where `at` is `{"line", "column", "span"}` or null.
    #[must_use]
    pub fn to_json(&self) -> Value {
        let errors: Vec<Value> = self.diagnostics.iter().map(Diagnostic::to_json).collect();
        json!({"file": self.name, "errors": errors, "left_out": self.left_out})
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, diagnostic) in self.diagnostics.iter().enumerate() {
            if i > 0 {
                f.write_str("\n")?;
            }
            f.write_str(&render::printable(&self.name))?;
            if let Some((line, column)) = diagnostic.place {
                write!(f, ":{line}:{column}")?;
            } else if let Some(key) = &diagnostic.key {
                write!(f, ": {key}")?;
            }
            write!(f, ": {}", diagnostic.message)?;
            if let Some(expected) = &diagnostic.expected {
                write!(f, "; expected {expected}")?;
            }
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

/// The line and column of a byte, both from 1, the column in characters.
fn line_and_column(source: &str, at: usize) -> (usize, usize) {
    let mut at = at.min(source.len());
    while !source.is_char_boundary(at) {
        at -= 1;
    }
    let before = source.get(..at).unwrap_or_default();
    let line = before.bytes().filter(|b| *b == b'\n').count() + 1;
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    let column = before.get(line_start..).map_or(0, |s| s.chars().count()) + 1;
    (line, column)
}
