//! What is said: text or JSON on standard output, the rest on standard error.

use std::borrow::Cow;
use std::io::{IsTerminal as _, Write as _};
use std::path::Path;

use passivity_scene::diagnostic::Look;
use passivity_scene::{AnyScene, Scene, SceneError};

use crate::exit::Failure;

/// For whom the result is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// Text for people.
    #[default]
    Text,
    /// One JSON document for programs.
    Json,
}

/// Whether a character moves a terminal's cursor or turns its text around.
pub(crate) fn is_hidden(c: char) -> bool {
    let turns = matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
    turns || (c.is_control() && c != '\n' && c != '\t')
}

/// Our own text with what hides in foreign names escaped.
pub(crate) fn legible(text: &str) -> Cow<'_, str> {
    without_hidden(text, |c, shown| shown.extend(c.escape_default()))
}

/// Says something on standard error.
pub(crate) fn tell(text: &str) {
    tell_drawn(&legible(text));
}

/// Says on standard error what was drawn to be legible, perhaps in colours.
pub(crate) fn tell_drawn(text: &str) {
    // Where it cannot be written to, nothing is left to say that on; the exit code still speaks.
    let _ = writeln!(std::io::stderr().lock(), "{}", text.trim_end());
}

/// Writes `text` and a line break to standard output. If its reader has gone there is nobody to tell, which
/// changes nothing of what is said by the exit code.
pub(crate) fn emit(text: &str) -> Result<(), Failure> {
    emit_to_reader(text).map(drop)
}

/// Writes as [`emit`] does, and says whether the reader is still there.
pub(crate) fn emit_to_reader(text: &str) -> Result<bool, Failure> {
    write_out(&legible(text))
}

fn write_out(text: &str) -> Result<bool, Failure> {
    let mut out = std::io::stdout().lock();
    let written = out
        .write_all(text.as_bytes())
        .and_then(|()| out.write_all(if text.ends_with('\n') { b"" } else { b"\n" }))
        .and_then(|()| out.flush());
    match written {
        Ok(()) => Ok(true),
        Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => Ok(false),
        Err(error) => Err(Failure::io("standard output", &error)),
    }
}

/// Writes a JSON document to standard output, with the version of this program.
pub(crate) fn emit_json(document: &impl serde::Serialize) -> Result<(), Failure> {
    write_out(&json_text(document)?).map(drop)
}

/// A JSON document as text, with the version of this program.
pub(crate) fn json_text(document: &impl serde::Serialize) -> Result<String, Failure> {
    let failed =
        |error: serde_json::Error| Failure::input(format!("this result cannot be JSON: {error}"));
    let mut document = serde_json::to_value(document).map_err(failed)?;
    if let serde_json::Value::Object(fields) = &mut document {
        fields.insert("version".to_owned(), env!("CARGO_PKG_VERSION").into());
    }
    let text = serde_json::to_string_pretty(&document).map_err(failed)?;
    Ok(escaped(&text).into_owned())
}

/// JSON with what hides in its texts escaped: such characters stand in texts only.
fn escaped(json: &str) -> Cow<'_, str> {
    without_hidden(json, |c, shown| {
        let mut units = [0; 2];
        for unit in c.encode_utf16(&mut units) {
            shown.push_str(&format!("\\u{unit:04x}"));
        }
    })
}

/// The text with each hidden character as `escape` writes it.
fn without_hidden(text: &str, escape: impl Fn(char, &mut String)) -> Cow<'_, str> {
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match is_hidden(c) {
            true => escape(c, &mut shown),
            false => shown.push(c),
        }
    }
    Cow::Owned(shown)
}

/// How diagnostics are drawn: in colours on a terminal unless `NO_COLOR` is set or the terminal is
/// dumb, and in ASCII where the locale has no other characters.
pub(crate) fn look() -> Look {
    let set = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
    let is_dumb = set("TERM").is_some_and(|term| term == "dumb");
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].into_iter().find_map(set);
    let is_unicode = locale.is_none_or(|locale| {
        let locale = locale.to_string_lossy().to_lowercase();
        locale.contains("utf-8") || locale.contains("utf8")
    });
    if is_dumb || !is_unicode {
        Look::Ascii
    } else if set("NO_COLOR").is_some() || !std::io::stderr().is_terminal() {
        Look::Plain
    } else {
        Look::Colours
    }
}

/// Reads a scene file of either kind, or standard input where the path is `-`.
pub(crate) fn scene_at(path: &Path) -> Result<AnyScene, SceneError> {
    if path.as_os_str() == "-" {
        AnyScene::from_reader("standard input", std::io::stdin().lock())
    } else {
        AnyScene::read(path)
    }
}

/// Reads a scene of a device of one joint, with every diagnostic when it cannot be read.
pub(crate) fn read_scene(path: &Path) -> Result<Scene, Failure> {
    let scene = if path.as_os_str() == "-" {
        Scene::from_reader("standard input", std::io::stdin().lock())
    } else {
        Scene::read(path)
    };
    scene.map_err(|error| Failure::Scene(error.render(look())))
}
