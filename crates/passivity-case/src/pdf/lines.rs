//! Breaking a line of the document into lines on the page.

use super::fonts::{Fonts, Style};
use crate::document::{Inline, Line};

/// A piece of text in one style, at its place in a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Run {
    pub(super) x: f32,
    pub(super) width: f32,
    pub(super) text: String,
    pub(super) style: Style,
    /// Which piece of the document's line it is part of.
    pub(super) piece: usize,
    /// The id that it leads to.
    pub(super) link: Option<String>,
}

/// A line on the page.
pub(super) type Set = Vec<Run>;

/// Sets a line of the document in lines of at most `width` points. `base` is the style of what has
/// no style of its own.
pub(super) fn set(fonts: &Fonts, line: &Line, base: Style, size: f32, width: f32) -> Vec<Set> {
    let mut setter = Setter {
        fonts,
        size,
        width,
        lines: vec![Vec::new()],
        x: 0.0,
    };
    let mut space = false;
    for (piece, inline) in line.0.iter().enumerate() {
        let (text, style, link) = match inline {
            Inline::Text(text) => (text, base, None),
            Inline::Strong(text) => (text, Style::Bold, None),
            Inline::Code(text) => (text, Style::Mono, None),
            Inline::Link(to, text) => (text, base, Some(to.clone())),
        };
        let text = fonts.printable(text);
        let style = fonts.style_for(text.trim_matches('\n'), style);
        for part in text.split_inclusive([' ', '\n']) {
            let word = part.trim_end_matches([' ', '\n']);
            if !word.is_empty() {
                setter.word(
                    word,
                    space,
                    &Run {
                        x: 0.0,
                        width: 0.0,
                        text: String::new(),
                        style,
                        piece,
                        link: link.clone(),
                    },
                );
                space = false;
            }
            space |= part.len() > word.len();
        }
    }
    setter.lines
}

struct Setter<'a> {
    fonts: &'a Fonts,
    size: f32,
    width: f32,
    lines: Vec<Set>,
    x: f32,
}

impl Setter<'_> {
    /// Sets a word, in pieces when it is wider than a line or made of a path.
    fn word(&mut self, word: &str, space: bool, like: &Run) {
        let gap = if space && self.x > 0.0 {
            self.fonts.width(" ", like.style, self.size)
        } else {
            0.0
        };
        let whole = self.fonts.width(word, like.style, self.size);
        // A mark that follows what it belongs to may hang over the edge a little.
        let hangs = !space && self.x > 0.0 && matches!(word, "," | "." | ";" | ":");
        if hangs || self.x + gap + whole <= self.width {
            self.place(word, gap, whole, like);
        } else if whole <= self.width && !word.contains(['/', '_']) {
            self.next();
            self.place(word, 0.0, whole, like);
        } else {
            self.pieces(word, gap, like);
        }
    }

    fn pieces(&mut self, word: &str, gap: f32, like: &Run) {
        let mut gap = gap;
        for piece in word.split_inclusive(['/', '_', ':', '-', '.', ',']) {
            let width = self.fonts.width(piece, like.style, self.size);
            if self.x + gap + width > self.width && self.x > 0.0 {
                self.next();
                gap = 0.0;
            }
            if width <= self.width {
                self.place(piece, gap, width, like);
            } else {
                self.letters(piece, like);
            }
            gap = 0.0;
        }
    }

    fn letters(&mut self, piece: &str, like: &Run) {
        for letter in piece.chars() {
            let letter = letter.to_string();
            let width = self.fonts.width(&letter, like.style, self.size);
            if self.x + width > self.width && self.x > 0.0 {
                self.next();
            }
            self.place(&letter, 0.0, width, like);
        }
    }

    fn next(&mut self) {
        self.lines.push(Vec::new());
        self.x = 0.0;
    }

    fn place(&mut self, text: &str, gap: f32, width: f32, like: &Run) {
        let Some(line) = self.lines.last_mut() else {
            return;
        };
        // What goes on in the same style becomes one run, with its spaces, so that copied text has
        // them too.
        match line.last_mut() {
            Some(last) if last.piece == like.piece => {
                if gap > 0.0 {
                    last.text.push(' ');
                }
                last.text.push_str(text);
                last.width += gap + width;
            }
            _ => {
                let text = if gap > 0.0 {
                    format!(" {text}")
                } else {
                    text.to_owned()
                };
                line.push(Run {
                    x: self.x,
                    width: gap + width,
                    text,
                    ..like.clone()
                });
            }
        }
        self.x += gap + width;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_line_passes_the_width_and_nothing_is_lost() {
        let fonts = Fonts::load().expect("fonts");
        let line = Line::text("The claim ")
            .and(Line::link("claim-TH-LIN", "TH-LIN"))
            .and(Line::text(" is in "))
            .and(Line::code("crates/passivity-core/src/generation.rs"))
            .and(Line::text(", with β ≥ ½ everywhere."));
        for width in [40.0, 80.0, 200.0, 1000.0] {
            let lines = set(&fonts, &line, Style::Plain, 9.0, width);
            let all: String = lines
                .iter()
                .flatten()
                .map(|run| run.text.as_str())
                .collect();
            let over = fonts.width(";", Style::Plain, 9.0);
            let squeezed: String = all.split(' ').collect();
            let expected =
                "TheclaimTH-LINisincrates/passivity-core/src/generation.rs,withβ≥½everywhere.";
            assert_eq!(squeezed, expected);
            for run in lines.iter().flatten() {
                assert!(run.x + run.width <= width + over + 1e-3, "{width}: {run:?}");
            }
        }
        let one = set(&fonts, &line, Style::Plain, 9.0, 10_000.0);
        let all: String = one[0].iter().map(|run| run.text.as_str()).collect();
        assert_eq!(
            all,
            "The claim TH-LIN is in crates/passivity-core/src/generation.rs, with β ≥ ½ everywhere."
        );
    }
}
