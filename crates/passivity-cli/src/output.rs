//! Writing results: text or JSON on standard output, pictures as SVG or PNG files.

use std::borrow::Cow;
use std::io::{IsTerminal as _, Write as _};
use std::path::Path;

use passivity_scene::Scene;

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
    if !text.contains(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match is_hidden(c) {
            true => shown.extend(c.escape_default()),
            false => shown.push(c),
        }
    }
    Cow::Owned(shown)
}

/// Says something on standard error.
pub(crate) fn tell(text: &str) {
    eprintln!("{}", legible(text));
}

/// Writes `text` and a line break to standard output.
pub(crate) fn emit(text: &str) -> Result<(), Failure> {
    let text = legible(text);
    write_out(&text)
}

fn write_out(text: &str) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.write_all(if text.ends_with('\n') { b"" } else { b"\n" }))
        .and_then(|()| out.flush())
        .map_err(|error| Failure::io("standard output", &error))
}

/// Writes a JSON document to standard output.
pub(crate) fn emit_json(document: &impl serde::Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string_pretty(document);
    let text =
        text.map_err(|error| Failure::input(format!("this result cannot be JSON: {error}")))?;
    write_out(&escaped(&text))
}

/// JSON with what hides in its texts escaped: such characters stand in texts only.
fn escaped(json: &str) -> Cow<'_, str> {
    if !json.contains(is_hidden) {
        return Cow::Borrowed(json);
    }
    let mut shown = String::with_capacity(json.len());
    for c in json.chars() {
        match is_hidden(c) {
            true => {
                let mut units = [0; 2];
                for unit in c.encode_utf16(&mut units) {
                    shown.push_str(&format!("\\u{unit:04x}"));
                }
            }
            false => shown.push(c),
        }
    }
    Cow::Owned(shown)
}

/// Refuses to write over what is read, and over what is no plain file: a device, a pipe, a folder, or a
/// link to whatever it may be.
#[cfg(any(feature = "audit", feature = "simulate"))]
pub(crate) fn may_be_written(output: &Path, inputs: &[&Path], verb: &str) -> Result<(), Failure> {
    let refuse = |why: &str| Err(Failure::input(format!("{}: {why}", output.display())));
    // What does not exist yet is no input, and nothing that is lost.
    let Ok(there) = output.symlink_metadata() else {
        return Ok(());
    };
    let same = |input: &&Path| match (output.canonicalize(), input.canonicalize()) {
        (Ok(output), Ok(input)) => output == input,
        _ => false,
    };
    if inputs.iter().any(same) {
        return refuse(&format!(
            "is read by this {verb}, and cannot be written by it"
        ));
    }
    if there.is_symlink() {
        return refuse("is a symbolic link: give the name of the file itself");
    }
    match there.is_file() {
        true => Ok(()),
        false => refuse("is no plain file, and is not replaced"),
    }
}

/// Reads a scene file, with every diagnostic when it cannot be read.
pub(crate) fn read_scene(path: &Path) -> Result<Scene, Failure> {
    Scene::read(path).map_err(|error| Failure::Scene(error.render(std::io::stderr().is_terminal())))
}
