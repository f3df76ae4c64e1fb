//! Lines of a text file, found from the middle of it.

use std::fs::File;
use std::io::{Read as _, Seek as _, SeekFrom};

use crate::log::error::TraceError;
use crate::log::lines::MAX_LINE;

/// A text file whose lines are looked for.
pub(crate) struct Text {
    pub(crate) file: File,
    pub(crate) len: u64,
}

/// How many bytes are looked at once.
const WINDOW: usize = 1 << 16;

impl Text {
    /// Reads what is there.
    fn at(&mut self, at: u64, bytes: &mut [u8]) -> std::io::Result<usize> {
        self.file.seek(SeekFrom::Start(at))?;
        let mut done = 0;
        while let Some(rest) = bytes.get_mut(done..).filter(|rest| !rest.is_empty()) {
            match self.file.read(rest)? {
                0 => break,
                read => done += read,
            }
        }
        Ok(done)
    }

    /// Where the line after the one at or around `at` starts; `None` when no line break follows.
    pub(crate) fn after_line(&mut self, at: u64) -> std::io::Result<Option<u64>> {
        let mut bytes = vec![0; WINDOW];
        let mut at = at;
        loop {
            let read = self.at(at, &mut bytes)?;
            let found = bytes.get(..read).unwrap_or_default();
            if let Some(end) = memchr::memchr(b'\n', found) {
                return Ok(Some(at + end as u64 + 1));
            }
            if read < WINDOW {
                return Ok(None);
            }
            at += read as u64;
        }
    }

    /// The start of a line, or `None` when nothing but blank space follows.
    fn unless_blank(&mut self, line: u64) -> std::io::Result<Option<u64>> {
        let mut bytes = vec![0; WINDOW];
        let mut at = line;
        loop {
            let read = self.at(at, &mut bytes)?;
            let found = bytes.get(..read).unwrap_or_default();
            if found.iter().any(|byte| !byte.is_ascii_whitespace()) {
                return Ok(Some(line));
            }
            if read < WINDOW {
                return Ok(None);
            }
            at += read as u64;
        }
    }

    /// Where the pieces `first` to `last`, of `n` of the bytes from `start` on, start and end, at starts of
    /// lines.
    pub(crate) fn shards(
        &mut self,
        start: u64,
        (first, last): (u64, u64),
        n: u64,
    ) -> std::io::Result<(u64, Option<u64>)> {
        let bytes = u128::from(self.len - start);
        let mut cut = |i: u64| -> std::io::Result<Option<u64>> {
            if i == n {
                return Ok(None);
            }
            let at = start + u64::try_from(bytes * u128::from(i) / u128::from(n)).unwrap_or(0);
            // The line that holds the byte before starts earlier.
            let line = match at == start {
                true => Some(start),
                false => self.after_line(at - 1)?,
            };
            match line {
                Some(line) => self.unless_blank(line),
                None => Ok(None),
            }
        };
        let from = match first {
            1 => Some(start),
            first => cut(first - 1)?,
        };
        let to = cut(last)?;
        Ok((from.unwrap_or(self.len), to))
    }

    /// Where two lines start, counted from 0 at `start`.
    pub(crate) fn lines(
        &mut self,
        start: u64,
        from: u64,
        to: Option<u64>,
    ) -> std::io::Result<(u64, Option<u64>)> {
        let first = match from {
            0 => Some(start),
            from => match self.skip(start, from)? {
                Some(line) => self.unless_blank(line)?,
                None => None,
            },
        };
        let last = match (first, to) {
            (Some(first), Some(to)) if to == from => Some(first),
            (Some(first), Some(to)) => match self.skip(first, to - from)? {
                Some(line) => self.unless_blank(line)?,
                None => None,
            },
            _ => None,
        };
        Ok((first.unwrap_or(self.len), last))
    }

    /// Where the line starts that comes so many after the one at `at`.
    fn skip(&mut self, at: u64, count: u64) -> std::io::Result<Option<u64>> {
        let mut bytes = vec![0; 16 * WINDOW];
        let (mut at, mut left) = (at, count);
        if left == 0 {
            return Ok(Some(at));
        }
        loop {
            let read = self.at(at, &mut bytes)?;
            let found = bytes.get(..read).unwrap_or_default();
            let breaks = memchr::memchr_iter(b'\n', found).count() as u64;
            if breaks >= left {
                let nth = usize::try_from(left - 1).unwrap_or(usize::MAX);
                let end = memchr::memchr_iter(b'\n', found).nth(nth);
                return Ok(end.map(|end| at + end as u64 + 1));
            }
            left -= breaks;
            at += read as u64;
            if read == 0 {
                return Ok(None);
            }
        }
    }

    /// Where the line starts that comes up to `count` before the one at `from`, and how many lines there
    /// are from it to that one, both counted.
    pub(crate) fn back(
        &mut self,
        start: u64,
        from: u64,
        count: usize,
    ) -> Result<(u64, usize), TraceError> {
        let most = (count + 1) as u64 * MAX_LINE as u64;
        let mut window = WINDOW as u64;
        loop {
            let at = from.saturating_sub(window).max(start);
            let size = usize::try_from(from - at).unwrap_or(usize::MAX);
            let mut bytes = vec![0; size];
            let read = self
                .at(at, &mut bytes)
                .map_err(|error| TraceError::io(&error))?;
            let before = bytes.get(..read).unwrap_or_default();
            // The last break is that before `from` itself.
            let mut starts = memchr::memrchr_iter(b'\n', before).skip(1);
            if let Some(found) = starts.by_ref().nth(count - 1) {
                return Ok((at + found as u64 + 1, count + 1));
            }
            if at == start {
                let lines = memchr::memchr_iter(b'\n', before).count();
                return Ok((start, lines + 1));
            }
            if window > most {
                let message = format!("a line longer than {MAX_LINE} bytes");
                return Err(TraceError::new("line_too_long", message));
            }
            window *= 4;
        }
    }
}
