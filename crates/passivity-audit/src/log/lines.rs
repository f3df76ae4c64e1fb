//! The lines of a text, read in blocks of whole ones.

use std::io::Read;

use crate::log::csv::{self, Notation};
use crate::log::digits::Seen;
use crate::log::error::TraceError;
use crate::log::held::Mark;

/// The longest line, in bytes.
pub(crate) const MAX_LINE: usize = 1 << 20;

/// What is wrong with a text in which nothing else ends a line.
pub(crate) const CARRIAGE_RETURNS: &str = "its lines end with a carriage return alone, as on old Macs: convert it with \
    `tr '\\r' '\\n'`";

/// How much is parsed at once by one core, in bytes, unless asked otherwise.
pub(crate) const BLOCK: usize = 1 << 20;

/// How many lines of comments may stand before the names of the columns.
const COMMENTS: usize = 1000;

/// How many lines are looked at for the names of the columns, where they do not stand in the first, and for a motion.
const EARLY: usize = 2000;

/// How a text starts.
pub(crate) struct Start {
    /// The line with the names of the columns.
    pub(crate) names: Vec<u8>,
    /// What stands between fields, where the text says so.
    pub(crate) delimiter: Option<u8>,
}

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
    /// How many bytes the lines before the rows have.
    before: u64,
    /// How many lines these are.
    taken: usize,
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
            before: 0,
            taken: 0,
        }
    }

    /// As [`new`](Self::new), where lines that are not read follow the input.
    pub(crate) const fn within(input: R, block: usize) -> Self {
        let mut lines = Self::new(input, block);
        lines.goes_on = true;
        lines
    }

    /// Reads what stands before the rows: comments, which start with `#` or `%`, and the names of the columns. Those are
    /// the first other line, or the last comment where that line is a row, as `numpy.savetxt` writes them; a line
    /// `sep=;` before them, as Excel has it, says what stands between fields.
    pub(crate) fn start(&mut self) -> Result<Start, TraceError> {
        let (mut delimiter, mut comment) = (None, None);
        for _ in 0..=COMMENTS {
            let line = self.peek()?;
            if let (None, Some([it])) = (delimiter, line.strip_prefix(b"sep=")) {
                delimiter = Some(*it);
                self.line()?;
                continue;
            }
            if line.starts_with(b"#") || line.starts_with(b"%") {
                comment = Some(self.line()?);
                continue;
            }
            let names = match comment.filter(|_| line.is_empty() || is_row(&line)) {
                Some(comment) => uncommented(&comment),
                None => self.line()?,
            };
            return Ok(Start { names, delimiter });
        }
        let message =
            format!("more than {COMMENTS} lines of comments before the names of the columns");
        Err(TraceError::new("header", message))
    }

    /// How many bytes have been taken as lines before the rows.
    pub(crate) const fn before(&self) -> u64 {
        self.before
    }

    /// The next line, which stands before the rows, without its break and without a byte order mark.
    pub(crate) fn line(&mut self) -> Result<Vec<u8>, TraceError> {
        let line = self.peek()?;
        let end = self.rest.iter().position(|byte| *byte == b'\n');
        let end = end.map_or(self.rest.len(), |end| end + 1);
        self.rest.drain(..end);
        self.before += end as u64;
        self.taken += 1;
        Ok(line)
    }

    /// The same, which stays.
    fn peek(&mut self) -> Result<Vec<u8>, TraceError> {
        loop {
            let end = self.rest.iter().position(|byte| *byte == b'\n');
            if end.is_some() || (self.ended && self.broken.is_none()) {
                let line = self.rest.get(..end.unwrap_or(self.rest.len()));
                return Ok(clean(line.unwrap_or_default()));
            }
            if let Some(error) = self.broken.take() {
                return Err(error);
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

    /// The first lines after the header, as far as they have been read, each with its number in the text from 1 on, blank
    /// lines counted.
    pub(crate) fn early(&self) -> Vec<(usize, &[u8])> {
        self.read().take(EARLY).collect()
    }

    /// Looks at the digits of the numbers of a column, row by row.
    pub(crate) fn see(&mut self, column: usize, notation: Notation, seen: &mut Seen) {
        let mut at = 0;
        while !seen.is_done() {
            let rest = self.rest.get(at..).unwrap_or_default();
            let end = memchr::memchr(b'\n', rest).map(|end| end + 1);
            let has_more = !self.ended && self.broken.is_none() && rest.len() <= MAX_LINE;
            if end.is_none() && has_more {
                self.fill(1 << 16);
                continue;
            }
            let line = rest.get(..end.unwrap_or(rest.len())).unwrap_or_default();
            if line.is_empty() {
                return;
            }
            let row = without_return(line.strip_suffix(b"\n").unwrap_or(line));
            seen.see(line.len(), csv::place(row, column, notation));
            at += line.len();
        }
    }

    /// The lines after the header that have been read, each with its number.
    fn read(&self) -> impl Iterator<Item = (usize, &[u8])> {
        let lines = self.rest.split_inclusive(|byte| *byte == b'\n');
        let whole = lines.filter(|line| self.ended || line.last() == Some(&b'\n'));
        let lines = whole.map(|line| without_return(line.strip_suffix(b"\n").unwrap_or(line)));
        let lines = (self.taken + 1..).zip(lines);
        lines.filter(|(_, line)| !line.trim_ascii().is_empty())
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

fn clean(line: &[u8]) -> Vec<u8> {
    let line = line.strip_prefix(b"\xef\xbb\xbf").unwrap_or(line);
    without_return(line).to_vec()
}

fn without_return(line: &[u8]) -> &[u8] {
    line.strip_suffix(b"\r").unwrap_or(line)
}

/// Whether a line after comments is a row: it starts as a number does.
fn is_row(line: &[u8]) -> bool {
    let start = line.trim_ascii_start();
    let start = start.strip_prefix(b"\"").unwrap_or(start);
    start
        .first()
        .is_some_and(|c| c.is_ascii_digit() || b"+-.".contains(c))
}

/// A comment without what makes it one.
fn uncommented(line: &[u8]) -> Vec<u8> {
    let marks = line.iter().take_while(|c| b"#%".contains(c)).count();
    let blanks = line.iter().skip(marks).take_while(|c| **c == b' ').count();
    line.get(marks + blanks..).unwrap_or_default().to_vec()
}
