//! A stretch of a log in one file, found without reading what comes before it.
//!
//! A stretch is made of the intervals from one sample to another: of the samples a to b it accounts for the
//! intervals between, so that a stretch that ends at a sample is followed by one that starts at it. The
//! samples before the first are read as far as an account needs them.

use std::fs::File;
use std::io::{Read, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use passivity_scene::Scene;
use sha2::{Digest as _, Sha256};

use crate::ledger::Ledger;
use crate::log::comparison::Comparison;
use crate::log::computed::EXACT_ROWS;
use crate::log::error::{TraceError, shown};
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::lines::{self, Lines, MAX_LINE};
#[cfg(feature = "parquet")]
use crate::log::parquet::Table;
use crate::log::preview::Preview;
use crate::log::source::{Dialect, Opened, Reader, Source, is_compressed, opened, start};
use crate::log::velocity::Velocities;

/// Which intervals of a log are accounted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stretch {
    /// From one sample to another, counted from 0; without the second to the end of the log.
    Samples(u64, Option<u64>),
    /// One of a number of pieces, counted from 1: of about as many bytes of CSV, or rows of Parquet.
    Shard(u64, u64),
}

impl Stretch {
    /// Reads `3/8`, the third of eight pieces.
    ///
    /// # Errors
    ///
    /// Text that is something else.
    pub fn parse_shard(text: &str) -> Result<Self, TraceError> {
        let parts = text.split_once('/');
        let numbers = parts.and_then(|(i, n)| i.trim().parse().ok().zip(n.trim().parse().ok()));
        match numbers {
            Some((i, n)) if i > 0 && i <= n => Ok(Self::Shard(i, n)),
            _ => Err(TraceError::new(
                "shard",
                format!(
                    "expected which piece of how many, as in 3/8, found `{}`",
                    shown(text.as_bytes())
                ),
            )),
        }
    }
}

impl FromStr for Stretch {
    type Err = TraceError;

    /// Reads `1000:2000`, `:1000` or `2000:`.
    fn from_str(text: &str) -> Result<Self, TraceError> {
        let wrong = || {
            TraceError::new(
                "range",
                format!(
                    "expected two samples, counted from 0, as in 1000:2000 or 2000:, found `{}`",
                    shown(text.as_bytes())
                ),
            )
        };
        let (from, to) = text.split_once(':').ok_or_else(wrong)?;
        let number = |text: &str| text.trim().parse::<u64>().map_err(|_| wrong());
        let from = if from.trim().is_empty() {
            0
        } else {
            number(from)?
        };
        let to = match to.trim() {
            "" => None,
            to => Some(number(to)?),
        };
        match to.is_some_and(|to| to < from) {
            true => Err(wrong()),
            false => Ok(Self::Samples(from, to)),
        }
    }
}

/// A stretch of a log, ready to be read.
pub(crate) struct Piece {
    pub(crate) source: Source,
    pub(crate) layout: Layout,
    pub(crate) heading: Said,
    pub(crate) place: Place,
    /// How many of the samples that come first are those up to the first one's own.
    pub(crate) lead: usize,
    /// How many samples of the log come before them, counted as far as it matters.
    pub(crate) before: usize,
}

/// What a log says before its samples.
#[derive(Clone, Debug)]
pub(crate) struct Said {
    pub(crate) headings: Vec<Heading>,
    pub(crate) preview: Preview,
}

/// Where in a log a stretch is: in bytes of CSV, in rows of Parquet.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(crate) struct Place {
    pub(crate) unit: String,
    /// Where the samples of the log start.
    pub(crate) start: u64,
    pub(crate) from: u64,
    pub(crate) to: u64,
    /// Whether the log ends there.
    pub(crate) ends: bool,
    /// A hash of the size, the start and the end of the log.
    pub(crate) log: String,
}

impl Piece {
    /// Finds a stretch of a log.
    pub(crate) fn open(
        path: &Path,
        scene: &Scene,
        dialect: &Dialect,
        stretch: Stretch,
        block: usize,
    ) -> Result<Self, TraceError> {
        let io = |error: std::io::Error| TraceError::io(&error);
        let mut file = File::open(path).map_err(io)?;
        let len = file.metadata().map_err(io)?.len();
        let log = identity(&mut file, len).map_err(io)?;
        file.rewind().map_err(io)?;
        if is_compressed(&start(&mut file)?) {
            let message = "a compressed file can only be read from its start: decompress it first";
            return Err(TraceError::new("compressed", message));
        }
        file.rewind().map_err(io)?;
        match opened(Box::new(file), block, Some(path))? {
            Opened::Csv(lines) => csv(path, (len, log), lines, (scene, dialect), stretch, block),
            #[cfg(feature = "parquet")]
            Opened::Parquet(table) => parquet(log, table, (scene, dialect), stretch),
        }
    }
}

/// How many samples before its own an interval is accounted for and compared by.
fn history(scene: &Scene) -> usize {
    let ledger = Ledger::of_scene(scene);
    let window = ledger.window() + 1;
    window
        .max(Comparison::history(&ledger))
        .max(Velocities::HISTORY)
        + 1
}

/// A hash of the size, the start and the end of a file.
fn identity(file: &mut File, len: u64) -> std::io::Result<String> {
    const ENDS: u64 = 1 << 16;
    let mut hash = Sha256::new();
    hash.update(len.to_le_bytes());
    for at in [0, len.saturating_sub(ENDS)] {
        let mut bytes = Vec::new();
        file.seek(SeekFrom::Start(at))?;
        (&mut *file).take(ENDS).read_to_end(&mut bytes)?;
        hash.update(&bytes);
    }
    let hash = hash.finalize();
    Ok(hash.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// A stretch of a CSV file.
fn csv(
    path: &Path,
    (len, log): (u64, String),
    mut lines: Lines<Box<dyn Read>>,
    (scene, dialect): (&Scene, &Dialect),
    stretch: Stretch,
    block: usize,
) -> Result<Piece, TraceError> {
    let io = |error: std::io::Error| TraceError::io(&error);
    let mut text = Text {
        file: File::open(path).map_err(io)?,
        len,
    };
    let line = lines.header()?;
    let first: Vec<Vec<u8>> = lines.first().into_iter().map(<[u8]>::to_vec).collect();
    let first: Vec<&[u8]> = first.iter().map(Vec::as_slice).collect();
    let (layout, said, notation) = dialect.heading(&line, &first, scene)?;
    let start = text.after_line(0).map_err(io)?.unwrap_or(len);
    let (from, to) = match stretch {
        Stretch::Samples(from, to) => text.lines(start, from, to),
        Stretch::Shard(i, n) => text.shard(start, i, n),
    }
    .map_err(io)?;
    let history = history(scene);
    let (before, lead) = match from == start {
        true => (start, 0),
        false => text.back(start, from, history)?,
    };
    // The sample that ends the stretch is read as well.
    let end = match to {
        Some(to) => text.after_line(to).map_err(io)?.unwrap_or(len),
        None => len,
    };
    // A stretch without a sample of its own reads nothing.
    let (before, end, lead) = match from >= len || to == Some(from) {
        true => (len, len, 0),
        false => (before, end, lead),
    };
    let rows = text.count(start, before, EXACT_ROWS).map_err(io)?;
    text.file.seek(SeekFrom::Start(before)).map_err(io)?;
    let stretch: Box<dyn Read> = Box::new(text.file.take(end - before));
    let lines = match to {
        Some(_) => Lines::within(stretch, block),
        None => Lines::new(stretch, block),
    };
    Ok(Piece {
        source: Source::of(Reader::Csv(lines, notation)).after(rows),
        layout,
        heading: said,
        place: Place {
            unit: "bytes".to_owned(),
            start,
            from,
            to: to.unwrap_or(len),
            ends: to.is_none(),
            log,
        },
        lead,
        before: rows,
    })
}

/// A text file whose lines are looked for.
struct Text {
    file: File,
    len: u64,
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
    fn after_line(&mut self, at: u64) -> std::io::Result<Option<u64>> {
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

    /// Where a piece of the bytes from `start` on starts and ends, at starts of lines.
    fn shard(&mut self, start: u64, i: u64, n: u64) -> std::io::Result<(u64, Option<u64>)> {
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
        let from = match i {
            1 => Some(start),
            i => cut(i - 1)?,
        };
        let to = cut(i)?;
        Ok((from.unwrap_or(self.len), to))
    }

    /// Where two lines start, counted from 0 at `start`.
    fn lines(
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

    /// How many lines there are from one to another, counted up to `most`.
    fn count(&mut self, from: u64, to: u64, most: usize) -> std::io::Result<usize> {
        let mut bytes = vec![0; WINDOW];
        let (mut at, mut count) = (from, 0);
        while at < to && count < most {
            let read = self.at(at, &mut bytes)?;
            let within = read.min(usize::try_from(to - at).unwrap_or(usize::MAX));
            let found = bytes.get(..within).unwrap_or_default();
            count += memchr::memchr_iter(b'\n', found).count();
            if read == 0 {
                break;
            }
            at += read as u64;
        }
        Ok(count.min(most))
    }

    /// Where the line starts that comes up to `count` before the one at `from`, and how many lines there
    /// are from it to that one, both counted.
    fn back(&mut self, start: u64, from: u64, count: usize) -> Result<(u64, usize), TraceError> {
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

/// A stretch of a Parquet file.
#[cfg(feature = "parquet")]
fn parquet(
    log: String,
    mut table: Box<Table>,
    (scene, dialect): (&Scene, &Dialect),
    stretch: Stretch,
) -> Result<Piece, TraceError> {
    let said = Said {
        headings: table.headings()?,
        preview: table.preview(),
    };
    let layout = said.layout(dialect, scene)?;
    let rows = table.rows()?;
    let (from, to) = match stretch {
        Stretch::Samples(from, to) => (from.min(rows), to.unwrap_or(rows).min(rows)),
        Stretch::Shard(i, n) => (table.cut(rows, i - 1, n), table.cut(rows, i, n)),
    };
    let ends = to >= rows;
    let (before, lead) = match from {
        0 => (0, 0),
        from if from >= rows => (rows, 0),
        from => {
            let before = from.saturating_sub(history(scene) as u64);
            (before, usize::try_from(from - before + 1).unwrap_or(0))
        }
    };
    let last = if ends { rows } else { to + 1 };
    // A stretch without a sample of its own reads nothing.
    let (before, last, lead) = match from == to && !ends {
        true => (rows, rows, 0),
        false => (before, last, lead),
    };
    table.seek(&layout, before, last - before)?;
    let rows_before = usize::try_from(before).unwrap_or(usize::MAX);
    Ok(Piece {
        source: Source::of(Reader::Parquet(table)).after(rows_before),
        layout,
        heading: said,
        place: Place {
            unit: "rows".to_owned(),
            start: 0,
            from,
            to,
            ends,
            log,
        },
        lead,
        before: rows_before,
    })
}

impl Said {
    /// The layout that it gives.
    pub(crate) fn layout(&self, dialect: &Dialect, scene: &Scene) -> Result<Layout, TraceError> {
        let headings = self.headings.clone();
        Layout::read(headings, dialect.columns.as_ref(), &self.preview, scene)
    }
}

/// How many bytes of CSV a core is given at once.
pub(crate) const fn block(asked: usize) -> usize {
    match asked {
        0 => lines::BLOCK,
        block => block,
    }
}

/// The path of a log that can be read from the middle.
pub(crate) fn is_file(path: &Path) -> Result<PathBuf, TraceError> {
    if path.as_os_str() == "-" {
        let message = "a piece of a log is read from a file, not from standard input";
        return Err(TraceError::new("io", message));
    }
    Ok(path.to_owned())
}
