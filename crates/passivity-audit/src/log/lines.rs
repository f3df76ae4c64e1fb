//! The lines of a text, read in blocks of whole ones.

use std::io::Read;

use crate::log::error::TraceError;
use crate::log::held::Mark;

/// The longest line, in bytes.
pub(crate) const MAX_LINE: usize = 1 << 20;

/// What is wrong with a text in which nothing else ends a line.
pub(crate) const CARRIAGE_RETURNS: &str = "its lines end with a carriage return alone, as on old Macs: convert it with \
    `tr '\\r' '\\n'`";

/// How much is parsed at once by one core, in bytes, unless asked otherwise.
pub(crate) const BLOCK: usize = 1 << 20;

/// How many rows are looked at before a header is judged.
const PREVIEWED: usize = 20;

/// Whole lines of a trace, in order.
pub(crate) struct Lines<R> {
    input: R,
    /// The start of a line that the last block did not hold whole.
    rest: Vec<u8>,
    ended: bool,
    /// What stopped the reading, once it has been told what came before it.
    broken: Option<TraceError>,
    block: usize,
    /// Whether lines that are not read follow.
    goes_on: bool,
}

/// A block of lines, or what stopped the reading after it.
#[derive(Debug, Default)]
pub(crate) struct Block {
    pub(crate) bytes: Vec<u8>,
    /// Whether the trace ends with this block; its last line may lack its line break then.
    pub(crate) last: bool,
    pub(crate) error: Option<TraceError>,
    /// Whether forces are as they were commanded, to the last bit: none is a decimal that was rounded.
    pub(crate) exact: bool,
    /// The rows that leave out forces.
    pub(crate) marks: Vec<Mark>,
}

impl<R: Read> Lines<R> {
    /// Reads from `input`, about `block` bytes at a time.
    pub(crate) const fn new(input: R, block: usize) -> Self {
        Self {
            input,
            rest: Vec::new(),
            ended: false,
            broken: None,
            block,
            goes_on: false,
        }
    }

    /// As [`new`](Self::new), where lines that are not read follow the input.
    pub(crate) const fn within(input: R, block: usize) -> Self {
        let mut lines = Self::new(input, block);
        lines.goes_on = true;
        lines
    }

    /// The first line, without its break and without a byte order mark.
    pub(crate) fn header(&mut self) -> Result<Vec<u8>, TraceError> {
        loop {
            if let Some(end) = self.rest.iter().position(|byte| *byte == b'\n') {
                let tail = self.rest.split_off(end + 1);
                let mut line = std::mem::replace(&mut self.rest, tail);
                line.truncate(end);
                return Ok(clean(line));
            }
            if let Some(error) = self.broken.take() {
                return Err(error);
            }
            if self.ended {
                return Ok(clean(std::mem::take(&mut self.rest)));
            }
            if self.rest.len() > MAX_LINE {
                if self.rest.contains(&b'\r') {
                    return Err(TraceError::new("header", CARRIAGE_RETURNS));
                }
                let message = format!("the header is longer than {MAX_LINE} bytes");
                return Err(TraceError::new("line_too_long", message));
            }
            self.fill(1 << 16);
        }
    }

    /// The first lines after the header, as far as they have been read.
    pub(crate) fn first(&self) -> Vec<&[u8]> {
        let lines = self.rest.split_inclusive(|byte| *byte == b'\n');
        let whole = lines.filter(|line| self.ended || line.last() == Some(&b'\n'));
        let trimmed = whole
            .map(<[u8]>::trim_ascii)
            .filter(|line| !line.is_empty());
        trimmed.take(PREVIEWED).collect()
    }

    /// Reads until `rest` has grown by `more` bytes, or the input ends or breaks: what was read until then is kept.
    fn fill(&mut self, more: usize) {
        let limit = u64::try_from(more).unwrap_or(u64::MAX);
        match (&mut self.input).take(limit).read_to_end(&mut self.rest) {
            Ok(read) => self.ended = read < more,
            Err(error) => self.broken = Some(TraceError::io(&error)),
        }
    }

    /// Whether the line that ends at `end` is blank: then what follows decides whether it may be. There are
    /// only so many blank lines that are waited for.
    fn is_blank_before(&self, end: usize) -> bool {
        let lines = self.rest.get(..end).unwrap_or_default();
        let written = lines.trim_ascii_end().len();
        let blank = lines.get(written..).unwrap_or_default();
        (written == 0 || blank.contains(&b'\n')) && blank.len() < MAX_LINE
    }

    /// The next block of whole lines; `None` after the last.
    pub(crate) fn next_block(&mut self) -> Option<Block> {
        let mut error = None;
        while !self.ended {
            if self.broken.is_none() {
                self.fill(self.block);
            }
            error = self.broken.take();
            if error.is_some() {
                break;
            }
            let whole = memchr::memrchr(b'\n', &self.rest);
            if self.ended || whole.is_some_and(|end| !self.is_blank_before(end)) {
                break;
            }
            if self.rest.len() > MAX_LINE {
                let message = format!("a line longer than {MAX_LINE} bytes");
                error = Some(TraceError::new("line_too_long", message));
                break;
            }
        }
        if self.ended && self.rest.is_empty() && error.is_none() {
            return None;
        }
        let mut bytes = std::mem::take(&mut self.rest);
        if !self.ended || error.is_some() {
            let end = memchr::memrchr(b'\n', &bytes).map_or(0, |end| end + 1);
            self.rest = bytes.split_off(end);
        }
        if error.is_some() || self.rest.len() > MAX_LINE {
            error = error.or_else(|| {
                let message = format!("a line longer than {MAX_LINE} bytes");
                Some(TraceError::new("line_too_long", message))
            });
            self.ended = true;
            self.rest = Vec::new();
        }
        Some(Block {
            bytes,
            last: self.ended && !self.goes_on,
            error,
            exact: false,
            marks: Vec::new(),
        })
    }
}

fn clean(mut line: Vec<u8>) -> Vec<u8> {
    if line.starts_with(b"\xef\xbb\xbf") {
        line.drain(..3);
    }
    if line.last() == Some(&b'\r') {
        line.pop();
    }
    line
}
