//! Reading files of bounded size.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::diagnostic::{Diagnostic, Kind};

/// The bytes of a regular file of at most `most` bytes.
pub(super) fn read(path: &Path, most: u64) -> Result<Vec<u8>, Box<Diagnostic>> {
    let unreadable = |error: std::io::Error| {
        let message = match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            std::io::ErrorKind::PermissionDenied => "the file may not be read".to_owned(),
            _ => format!("the file cannot be read: {error}"),
        };
        Box::new(Diagnostic::new(Kind::Unreadable, message).expected("the path of a file"))
    };
    // Asked before opening: opening a pipe would wait for someone to write to it.
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    // What a shell hands over, as in `check <(…)`, is open already.
    let handed_over = ["/dev/fd", "/proc/self/fd", "/dev/stdin"];
    let is_open = handed_over.iter().any(|place| path.starts_with(place));
    let is_readable = metadata.is_file() || (is_open && !metadata.is_dir());
    if !is_readable {
        let what = if metadata.is_dir() {
            "this is a folder"
        } else {
            "this is a pipe or a device"
        };
        let diagnostic = Diagnostic::new(Kind::NotAFile, what).expected("a regular file");
        return Err(Box::new(diagnostic));
    }
    limited(File::open(path).map_err(unreadable)?, most)
}

/// The bytes of a stream of at most `most` bytes.
pub(super) fn limited(stream: impl Read, most: u64) -> Result<Vec<u8>, Box<Diagnostic>> {
    let mut bytes = Vec::new();
    let unreadable = |error: std::io::Error| {
        let message = format!("the scene cannot be read: {error}");
        Box::new(Diagnostic::new(Kind::Unreadable, message).expected("a stream that can be read"))
    };
    stream
        .take(most + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > most {
        return Err(Box::new(too_large(most)));
    }
    Ok(bytes)
}

/// What to say of a text of more than `most` bytes.
pub(super) fn too_large(most: u64) -> Diagnostic {
    Diagnostic::new(Kind::FileTooLarge, "the file is too large")
        .expected(format!("at most {most} bytes"))
}

/// The bytes as text, or the text up to the first byte that is not UTF-8, and what to say of it.
pub(super) fn text(bytes: Vec<u8>) -> Result<String, (String, Box<Diagnostic>)> {
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let byte = error.as_bytes().get(at).copied().unwrap_or_default();
        let shown = String::from_utf8_lossy(error.as_bytes()).into_owned();
        // The bad byte is shown as U+FFFD, of three bytes.
        let span = at..at + '\u{fffd}'.len_utf8();
        let diagnostic = Diagnostic::new(Kind::NotUtf8, "this byte is not UTF-8")
            .at(span)
            .expected("text in UTF-8")
            .found(format!("byte {byte:#04x}"));
        (shown, Box::new(diagnostic))
    })
}
