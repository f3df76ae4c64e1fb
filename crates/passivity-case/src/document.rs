//! The content of a document before it becomes HTML: headings, paragraphs, tables and figures.

/// A piece of a line of text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Inline {
    /// Plain text.
    Text(String),
    /// Text that stands out.
    Strong(String),
    /// A name, path or command, in letters of one width.
    Code(String),
    /// A hash, which may be broken anywhere.
    Hash(String),
    /// A reference to an element of the document: its id, and the text of the reference.
    Link(String, String),
}

/// A line or paragraph of text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line(pub Vec<Inline>);

impl Line {
    /// Plain text.
    #[must_use]
    pub fn text(text: impl Into<String>) -> Self {
        Self(vec![Inline::Text(text.into())])
    }

    /// A name, path or command.
    #[must_use]
    pub fn code(text: impl Into<String>) -> Self {
        Self(vec![Inline::Code(text.into())])
    }

    /// A hash.
    #[must_use]
    pub fn hash(hash: &passivity_evidence::Sha256) -> Self {
        Self(vec![Inline::Hash(hash.to_string())])
    }

    /// Text that stands out.
    #[must_use]
    pub fn strong(text: impl Into<String>) -> Self {
        Self(vec![Inline::Strong(text.into())])
    }

    /// A reference to the element with the id `to`.
    #[must_use]
    pub fn link(to: impl Into<String>, text: impl Into<String>) -> Self {
        Self(vec![Inline::Link(to.into(), text.into())])
    }

    /// The same line with more at its end.
    #[must_use]
    pub fn and(mut self, more: Self) -> Self {
        self.0.extend(more.0);
        self
    }

    /// Lines with `between` from one to the next.
    #[must_use]
    pub fn joined(lines: impl IntoIterator<Item = Self>, between: &str) -> Self {
        let mut all = Self::default();
        for (index, line) in lines.into_iter().enumerate() {
            if index > 0 {
                all.0.push(Inline::Text(between.to_owned()));
            }
            all = all.and(line);
        }
        all
    }
}

impl From<&str> for Line {
    fn from(text: &str) -> Self {
        Self::text(text)
    }
}

impl From<String> for Line {
    fn from(text: String) -> Self {
        Self::text(text)
    }
}

/// A row of a table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// An id that links can lead to.
    pub id: Option<String>,
    /// The cells; the first one names the row.
    pub cells: Vec<Line>,
}

impl<const N: usize> From<[Line; N]> for Row {
    fn from(cells: [Line; N]) -> Self {
        Self {
            id: None,
            cells: cells.to_vec(),
        }
    }
}

/// A table with a caption and a head.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// What the table shows.
    pub caption: String,
    /// The heads of the columns, each with its share of the width.
    pub head: Vec<(&'static str, u8)>,
    /// The rows.
    pub rows: Vec<Row>,
}

/// A picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Figure {
    /// Its id, to which links can lead.
    pub id: String,
    /// The picture as SVG.
    pub svg: String,
    /// What it shows, under it.
    pub caption: String,
    /// What it shows, for those who do not see it.
    pub alt: String,
    /// Whether it is so small that several stand side by side.
    pub small: bool,
}

/// A part of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// The contents: the parts, and the headings of level 2.
    Contents,
    /// The title of a part.
    Part(String),
    /// A heading, of level 2 or below: level 1 is the document's title.
    Heading {
        /// 2, 3 or 4.
        level: u8,
        /// Its id, to which links can lead.
        id: String,
        /// The heading.
        text: String,
    },
    /// A paragraph.
    Paragraph(Line),
    /// A statement that must not be missed, and whether it is good news.
    Verdict(bool, Line),
    /// A list.
    List(Vec<Line>),
    /// Two lists side by side, of the same weight, each with its heading.
    Beside([(String, Vec<Line>); 2]),
    /// A table.
    Table(Table),
    /// A picture.
    Figure(Figure),
    /// Commands or other text in letters of one width.
    Listing(String),
}

/// A document: its title and what it says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Document {
    /// The title.
    pub title: String,
    /// A line under the title.
    pub subtitle: String,
    /// What it says.
    pub blocks: Vec<Block>,
}

impl Document {
    /// A document that says nothing yet.
    #[must_use]
    pub fn new(title: impl Into<String>, subtitle: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            subtitle: subtitle.into(),
            blocks: Vec::new(),
        }
    }

    /// Begins a part.
    pub fn part(&mut self, title: &str) {
        self.blocks.push(Block::Part(title.to_owned()));
    }

    /// Adds a heading.
    pub fn heading(&mut self, level: u8, id: impl Into<String>, text: impl Into<String>) {
        self.blocks.push(Block::Heading {
            level,
            id: id.into(),
            text: text.into(),
        });
    }

    /// Adds a paragraph.
    pub fn say(&mut self, line: impl Into<Line>) {
        self.blocks.push(Block::Paragraph(line.into()));
    }

    /// Adds a list, unless it is empty.
    pub fn list(&mut self, items: Vec<Line>) {
        if !items.is_empty() {
            self.blocks.push(Block::List(items));
        }
    }

    /// Adds a table, unless it has no rows.
    pub fn table(&mut self, caption: &str, head: &[(&'static str, u8)], rows: Vec<Row>) {
        if !rows.is_empty() {
            let (caption, head) = (caption.to_owned(), head.to_vec());
            self.blocks.push(Block::Table(Table {
                caption,
                head,
                rows,
            }));
        }
    }
}

/// A text with a capital letter at its start.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// An id from any text: lower-case letters, digits and hyphens.
///
/// # Example
///
/// ```
/// use passivity_case::document::slug;
///
/// assert_eq!(slug("RE35, soft wall (β = 3/5)"), "re35-soft-wall-3-5");
/// assert_eq!(slug("…"), "x");
/// ```
#[must_use]
pub fn slug(text: &str) -> String {
    let mut out = String::new();
    for letter in text.chars().map(|c| c.to_ascii_lowercase()) {
        if letter.is_ascii_alphanumeric() {
            out.push(letter);
        } else if !out.ends_with('-') && !out.is_empty() {
            out.push('-');
        }
    }
    let out = out.trim_end_matches('-');
    if out.is_empty() {
        "x".to_owned()
    } else {
        out.chars().take(60).collect()
    }
}
