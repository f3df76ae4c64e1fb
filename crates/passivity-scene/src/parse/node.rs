//! The tree that a scene is read from: the same for TOML and for JSON.

use std::ops::Range;

use serde_json::Value;
use toml_edit::{Document, Item, TableLike};

use crate::diagnostic::{Diagnostic, Kind};
use crate::json::kind_of;

/// A value and where it stands.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) content: Content,
    /// Where in the text; empty at 0 for JSON.
    pub(super) span: Range<usize>,
}

#[derive(Clone, Debug)]
pub(super) enum Content {
    /// Text, and where its first character stands when it was written without escapes.
    Text(String, Option<usize>),
    /// A number as it is spelt.
    Number(String),
    Bool(bool),
    Table(Vec<Entry>),
    List(Vec<Node>),
    /// Anything else, in words.
    Other(&'static str),
}

/// A key with its value.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) key: String,
    pub(super) key_span: Range<usize>,
    pub(super) node: Node,
}

impl Entry {
    /// A key with a text that stands in no file.
    pub(super) fn of_text(key: &str, text: &str) -> Self {
        Self {
            key: key.to_owned(),
            key_span: 0..0,
            node: Node {
                content: Content::Text(text.to_owned(), None),
                span: 0..0,
            },
        }
    }
}

impl Node {
    /// The place of a part of a text value, or of the whole value.
    pub(super) fn part(&self, part: Range<usize>) -> Range<usize> {
        match self.content {
            Content::Text(_, Some(start)) => start + part.start..start + part.end,
            _ => self.span.clone(),
        }
    }

    /// What the value is, in words.
    pub(super) const fn words(&self) -> &'static str {
        match self.content {
            Content::Text(..) => "text",
            Content::Number(_) => "a number",
            Content::Bool(_) => "a boolean",
            Content::Table(_) => "a table",
            Content::List(_) => "a list",
            Content::Other(words) => words,
        }
    }
}

/// The entries of a TOML document.
pub(super) fn from_toml(source: &str) -> Result<Vec<Entry>, Box<Diagnostic>> {
    let document = Document::parse(source).map_err(|error| Box::new(syntax(source, &error)))?;
    Ok(entries(source, document.as_table()))
}

fn syntax(source: &str, error: &toml_edit::TomlError) -> Diagnostic {
    // Some messages are of several lines; the place is shown from the span.
    let message = error.message().lines().collect::<Vec<_>>().join("; ");
    let kind = if message.contains("duplicate key") {
        Kind::Duplicate
    } else {
        Kind::Syntax
    };
    let span = error.span().unwrap_or(source.len()..source.len());
    let shown = match kind {
        Kind::Duplicate => "this key or section is given twice".to_owned(),
        _ => format!("this is not TOML: {message}"),
    };
    let diagnostic = Diagnostic::new(kind, shown).at(span);
    match message.contains("overflow") {
        true => diagnostic.expected(format!("a whole number of at most {}", i64::MAX)),
        false => diagnostic,
    }
}

fn entries(source: &str, table: &dyn TableLike) -> Vec<Entry> {
    let pairs = table.iter().map(|(name, item)| {
        let key = table.key(name);
        let node = item_node(source, item);
        Entry {
            key: name.to_owned(),
            key_span: key
                .and_then(toml_edit::Key::span)
                .unwrap_or_else(|| node.span.clone()),
            node,
        }
    });
    pairs.collect()
}

fn item_node(source: &str, item: &Item) -> Node {
    let content = match item {
        Item::Value(value) => return value_node(source, value),
        Item::Table(table) => Content::Table(entries(source, table)),
        Item::ArrayOfTables(tables) => {
            let node = |table: &toml_edit::Table| Node {
                content: Content::Table(entries(source, table)),
                span: table.span().unwrap_or(0..0),
            };
            Content::List(tables.iter().map(node).collect())
        }
        Item::None => Content::Other("nothing"),
    };
    Node {
        content,
        span: item.span().unwrap_or(0..0),
    }
}

fn value_node(source: &str, value: &toml_edit::Value) -> Node {
    let span = value.span().unwrap_or(0..0);
    let literal = source.get(span.clone()).unwrap_or_default();
    let content = match value {
        toml_edit::Value::String(text) => {
            let text = text.value().clone();
            // Between single quotes: a literal, or a basic string without escapes.
            let inner = span.start + 1;
            let verbatim = source.get(inner..span.end.saturating_sub(1)) == Some(text.as_str());
            Content::Text(text, verbatim.then_some(inner))
        }
        toml_edit::Value::Integer(_) | toml_edit::Value::Float(_) => {
            Content::Number(literal.replace('_', ""))
        }
        toml_edit::Value::Boolean(flag) => Content::Bool(*flag.value()),
        toml_edit::Value::Datetime(_) => Content::Other("a date"),
        toml_edit::Value::Array(list) => {
            Content::List(list.iter().map(|item| value_node(source, item)).collect())
        }
        toml_edit::Value::InlineTable(table) => Content::Table(entries(source, table)),
    };
    Node { content, span }
}

/// The entries of a JSON object.
pub(super) fn from_json(value: &Value) -> Result<Vec<Entry>, Box<Diagnostic>> {
    match json_node(value).content {
        Content::Table(entries) => Ok(entries),
        _ => {
            let what = kind_of(value);
            let message = format!("a scene is an object with its sections, this is {what}");
            Err(Box::new(Diagnostic::new(Kind::WrongType, message)))
        }
    }
}

fn json_node(value: &Value) -> Node {
    let content = match value {
        Value::Null => Content::Other("null"),
        Value::Bool(flag) => Content::Bool(*flag),
        Value::Number(number) => Content::Number(number.as_str().to_owned()),
        Value::String(text) => Content::Text(text.clone(), None),
        Value::Array(items) => Content::List(items.iter().map(json_node).collect()),
        Value::Object(fields) => Content::Table(
            fields
                .iter()
                .map(|(key, value)| Entry {
                    key: key.clone(),
                    key_span: 0..0,
                    node: json_node(value),
                })
                .collect(),
        ),
    };
    Node {
        content,
        span: 0..0,
    }
}
