//! A document as one HTML file that needs nothing else: no script, no font, no other file.

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
/// assert!(page.contains(r##"<a href="#summary">"##));
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
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#content\">Skip to the content</a>\n\
         <header>\n<h1>{title}</h1>\n<p>{}</p>\n</header>\n",
        escape(&document.subtitle)
    );
    contents(&mut out, document);
    out.push_str("<main id=\"content\">\n");
    let mut section = false;
    for block in &document.blocks {
        if let Block::Heading { level: 2, id, .. } = block {
            if section {
                out.push_str("</section>\n");
            }
            section = true;
            let _ = writeln!(out, "<section aria-labelledby=\"{}\">", escape(id));
        }
        write_block(&mut out, block);
    }
    if section {
        out.push_str("</section>\n");
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

fn contents(out: &mut String, document: &Document) {
    out.push_str("<nav aria-label=\"Contents\">\n<h2 id=\"contents\">Contents</h2>\n<ol>\n");
    for block in &document.blocks {
        if let Block::Heading { level: 2, id, text } = block {
            let _ = writeln!(
                out,
                "<li><a href=\"#{}\">{}</a></li>",
                escape(id),
                escape(text)
            );
        }
    }
    out.push_str("</ol>\n</nav>\n");
}

fn write_block(out: &mut String, block: &Block) {
    let _ = match block {
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
        Block::List(items) => {
            let items: String = items.iter().fold(String::new(), |mut all, item| {
                let _ = writeln!(all, "<li>{}</li>", inline(item));
                all
            });
            writeln!(out, "<ul>\n{items}</ul>")
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

fn write_table(table: &Table) -> String {
    let mut out = format!(
        "<table>\n<caption>{}</caption>\n<colgroup>",
        escape(&table.caption)
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
    out.push_str("</tbody>\n</table>");
    out
}

fn write_figure(figure: &Figure) -> String {
    let class = if figure.wide { " class=\"wide\"" } else { "" };
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
        "<figure id=\"{}\"{class}>\n{}\n<figcaption>{}</figcaption>\n</figure>",
        escape(&figure.id),
        without_declaration(&svg).trim_end(),
        escape(&figure.caption)
    )
}

/// SVG within HTML has no XML declaration and no document type.
fn without_declaration(svg: &str) -> &str {
    svg.find("<svg").map_or(svg, |start| &svg[start..])
}

fn inline(line: &Line) -> String {
    let mut out = String::new();
    for piece in &line.0 {
        let _ = match piece {
            Inline::Text(text) => write!(out, "{}", escape(text)),
            Inline::Strong(text) => write!(out, "<strong>{}</strong>", escape(text)),
            Inline::Code(text) => write!(out, "<code>{}</code>", breakable(text)),
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
