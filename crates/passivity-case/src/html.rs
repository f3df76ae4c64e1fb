//! A document as one self-contained HTML file, without scripts, fonts or other files.

use std::fmt::Write as _;

use crate::document::{Block, Document, Figure, Inline, Line, Table};
use crate::draw::escape;

/// How the document looks, on a screen and on paper.
const STYLE: &str = include_str!("style.css");

/// Writes the document.
///
/// # Example
///
/// ```
/// use passivity_case::{document::Document, html};
///
/// let mut document = Document::new("A wall & a hand", "");
/// document.heading(2, "summary", "Summary");
/// let page = html::write(&document);
/// assert!(page.contains("<title>A wall &amp; a hand</title>"));
/// assert!(page.contains(r#"<h2 id="summary">Summary</h2>"#));
/// ```
#[must_use]
pub fn write(document: &Document) -> String {
    let title = escape(&document.title);
    // Writing to a string cannot fail.
    let mut out = String::new();
    let _ = write!(
        out,
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}@page {{ @bottom-left {{ content: {}; }} }}\n\
         </style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#content\">Skip to the content</a>\n\
         <header>\n<h1>{title}</h1>\n<p>{}</p>\n</header>\n",
        css_string(&document.title),
        escape(&document.subtitle)
    );
    out.push_str("<main id=\"content\">\n");
    let mut section = false;
    for block in &document.blocks {
        let begins = match block {
            Block::Heading { level: 2, id, .. } => Some(id),
            _ => None,
        };
        let ends = begins.is_some() || matches!(block, Block::Part(_) | Block::Contents);
        if section && ends {
            out.push_str("</section>\n");
            section = false;
        }
        if let Some(id) = begins {
            section = true;
            let _ = writeln!(out, "<section aria-labelledby=\"{}\">", escape(id));
        }
        write_block(&mut out, document, block);
    }
    if section {
        out.push_str("</section>\n");
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

fn contents(document: &Document) -> String {
    let mut out =
        String::from("<nav aria-label=\"Contents\">\n<h2 id=\"contents\">Contents</h2>\n<ul>\n");
    for block in &document.blocks {
        let _ = match block {
            Block::Part(title) => writeln!(out, "<li class=\"of-part\">{}</li>", escape(title)),
            Block::Heading { level: 2, id, text } => writeln!(
                out,
                "<li><a href=\"#{}\">{}</a></li>",
                escape(id),
                escape(text)
            ),
            _ => Ok(()),
        };
    }
    out.push_str("</ul>\n</nav>");
    out
}

fn write_block(out: &mut String, document: &Document, block: &Block) {
    let _ = match block {
        Block::Contents => writeln!(out, "{}", contents(document)),
        Block::Part(title) => writeln!(out, "<p class=\"part\">{}</p>", escape(title)),
        Block::Heading { level, id, text } => {
            writeln!(
                out,
                "<h{level} id=\"{}\">{}</h{level}>",
                escape(id),
                escape(text)
            )
        }
        Block::Paragraph(line) => writeln!(out, "<p>{}</p>", inline(line)),
        Block::Verdict(good, line) => {
            let class = if *good { "good" } else { "bad" };
            writeln!(out, "<p class=\"verdict {class}\">{}</p>", inline(line))
        }
        Block::List(items) => writeln!(out, "{}", list(items)),
        Block::Beside(sides) => {
            let sides = sides.iter().fold(String::new(), |mut all, (title, items)| {
                let _ = write!(
                    all,
                    "<div>\n<h3>{}</h3>\n{}\n</div>\n",
                    escape(title),
                    list(items)
                );
                all
            });
            writeln!(out, "<div class=\"beside\">\n{sides}</div>")
        }
        Block::Table(table) => writeln!(out, "{}", write_table(table)),
        Block::Figure(figure) => writeln!(out, "{}", write_figure(figure)),
        // It may be wider than the page: then it scrolls, and the keyboard must reach it.
        Block::Listing(text) => {
            writeln!(
                out,
                "<pre tabindex=\"0\"><code>{}</code></pre>",
                escape(text)
            )
        }
    };
}

fn list(items: &[Line]) -> String {
    let items = items.iter().fold(String::new(), |mut all, item| {
        let _ = writeln!(all, "<li>{}</li>", inline(item));
        all
    });
    format!("<ul>\n{items}</ul>")
}

/// A table, in a frame that scrolls where the screen is narrower than the table.
fn write_table(table: &Table) -> String {
    let mut out = format!(
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{caption}\">\n<table \
         class=\"columns-{}\">\n<caption><span>{caption}</span></caption>\n<colgroup>",
        table.head.len(),
        caption = escape(&table.caption)
    );
    let whole: u32 = table.head.iter().map(|(_, share)| u32::from(*share)).sum();
    for (_, share) in &table.head {
        let percent = u32::from(*share) * 100 / whole.max(1);
        let _ = write!(out, "<col style=\"width:{percent}%\">");
    }
    out.push_str("</colgroup>\n<thead><tr>");
    for (name, _) in &table.head {
        let _ = write!(out, "<th scope=\"col\">{}</th>", escape(name));
    }
    out.push_str("</tr></thead>\n<tbody>\n");
    for row in &table.rows {
        let id = row
            .id
            .as_ref()
            .map_or(String::new(), |id| format!(" id=\"{}\"", escape(id)));
        let _ = write!(out, "<tr{id}>");
        for (index, cell) in row.cells.iter().enumerate() {
            let _ = if index == 0 {
                write!(out, "<th scope=\"row\">{}</th>", inline(cell))
            } else {
                write!(out, "<td>{}</td>", inline(cell))
            };
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody>\n</table>\n</div>");
    out
}

/// A figure as wide as the page; a check box shows it at its own size, in a frame that scrolls.
fn write_figure(figure: &Figure) -> String {
    let class = if figure.small { " class=\"small\"" } else { "" };
    let svg = figure.svg.trim_start();
    // Pictures drawn by others have no words for those who do not see them.
    let named = svg
        .split_once('>')
        .is_some_and(|(head, _)| head.contains("aria-label"));
    let svg = if named {
        svg.to_owned()
    } else {
        let label = escape(&figure.alt);
        svg.replacen(
            "<svg ",
            &format!("<svg role=\"img\" aria-label=\"{label}\" "),
            1,
        )
    };
    format!(
        "<figure id=\"{id}\"{class}>\n<label class=\"enlarge\"><input type=\"checkbox\"> Full \
         size</label>\n<div class=\"picture\">\n{}\n</div>\n<figcaption>{}</figcaption>\n</figure>",
        without_declaration(&svg).trim_end(),
        escape(&figure.caption),
        id = escape(&figure.id),
    )
}

/// SVG within HTML has no XML declaration and no document type.
fn without_declaration(svg: &str) -> &str {
    svg.find("<svg")
        .and_then(|start| svg.get(start..))
        .unwrap_or(svg)
}

fn inline(line: &Line) -> String {
    let mut out = String::new();
    for piece in &line.0 {
        let _ = match piece {
            Inline::Text(text) => write!(out, "{}", escape(text)),
            Inline::Strong(text) => write!(out, "<strong>{}</strong>", escape(text)),
            Inline::Code(text) => write!(out, "<code>{}</code>", breakable(text)),
            Inline::Hash(text) => write!(out, "<code class=\"hash\">{}</code>", escape(text)),
            Inline::Link(to, text) => {
                write!(out, "<a href=\"#{}\">{}</a>", escape(to), escape(text))
            }
        };
    }
    out
}

/// A name that may be broken after a slash, a colon, an underscore or a hyphen.
fn breakable(text: &str) -> String {
    let mut out = String::new();
    for piece in text.split_inclusive(['/', ':', '_', '-', '.']) {
        out.push_str(&escape(piece));
        out.push_str("<wbr>");
    }
    out.trim_end_matches("<wbr>").to_owned()
}

/// A string of CSS, which within a style element must not end it.
fn css_string(text: &str) -> String {
    let mut out = String::from("\"");
    for letter in text.chars() {
        if letter.is_alphanumeric() || " .,;:()–-".contains(letter) {
            out.push(letter);
        } else {
            let _ = write!(out, "\\{:x} ", u32::from(letter));
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_title_cannot_leave_the_style_sheet() {
        let page = write(&Document::new("a </style><script>\"\\", ""));
        assert_eq!(page.matches("</style>").count(), 1);
        assert!(!page.contains("<script"));
        assert!(css_string("a\"b\\").starts_with("\"a\\22 b\\5c "));
    }
}
