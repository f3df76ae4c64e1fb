//! Where samples come from: files in order, CSV as it is or compressed, Parquet, MCAP, or memory.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};

use passivity_scene::Scene;

use crate::log::chunk::Chunk;
use crate::log::csv::{self, Notation};
use crate::log::digits::{Digits, Seen};
use crate::log::error::TraceError;
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::lines::{self, Block, Lines};
#[cfg(feature = "mcap")]
use crate::log::mcap;
#[cfg(feature = "parquet")]
use crate::log::parquet;
use compressed::decompressed;
pub(crate) use compressed::{is_compressed, start};
pub use dialect::Dialect;
pub use several::dialects;

mod compressed;
mod dialect;
mod several;
mod shape;
mod transcript;

/// What one file, or memory, gives.
pub(crate) enum Reader {
    Csv(Lines<Box<dyn Read>>, Notation),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Table>),
    #[cfg(feature = "mcap")]
    Mcap(Box<mcap::Rows>),
    /// In memory.
    Memory(Box<dyn Iterator<Item = Chunk>>),
}

/// What a core is given.
pub(crate) enum Work {
    /// With the number of the file that it is in.
    Parse(Block, Notation, usize),
    Account(Box<Chunk>),
}

/// The samples of one or more files, in order.
pub(crate) struct Source {
    reader: Reader,
    /// Which of the files is being read.
    file: usize,
    /// The files, or none of a stream or of memory.
    files: Vec<PathBuf>,
    dialect: Dialect,
    block: usize,
}

impl Source {
    /// Of one file, or of memory.
    pub(crate) fn of(reader: Reader) -> Self {
        Self {
            reader,
            file: 0,
            files: Vec::new(),
            dialect: Dialect::default(),
            block: lines::BLOCK,
        }
    }

    /// Of files in order: the first one is opened, and its header read.
    pub(crate) fn open(
        paths: &[PathBuf],
        scene: &Scene,
        dialect: &Dialect,
        block: usize,
    ) -> Result<(Self, Layout), TraceError> {
        let Some(first) = paths.first() else {
            return Err(TraceError::new("empty", "a log needs a file"));
        };
        once(paths)?;
        let opened = open(first, block).and_then(|opened| opened.read(scene, dialect));
        let (reader, mut layout) = opened.map_err(|error| match paths.len() {
            1 => error,
            _ => error.of(&first.display().to_string()),
        })?;
        if let (Some(force), 2..) = (layout.force, paths.len()) {
            layout.digits = digits(paths, dialect, force).unwrap_or(layout.digits);
        }
        let source = Self {
            reader,
            file: 0,
            files: paths.to_vec(),
            dialect: dialect.clone(),
            block,
        };
        Ok((source, layout))
    }

    /// The names of the files, where there are several.
    pub(crate) fn names(&self) -> Vec<String> {
        match self.files.len() {
            0 | 1 => Vec::new(),
            _ => self
                .files
                .iter()
                .map(|file| file.display().to_string())
                .collect(),
        }
    }

    /// What the next core is to do; `None` at the end.
    pub(crate) fn next(&mut self, layout: &Layout) -> Option<Work> {
        loop {
            let file = self.file;
            let work = match &mut self.reader {
                Reader::Csv(lines, notation) => {
                    let block = lines.next_block();
                    block.map(|block| Work::Parse(block, *notation, file))
                }
                #[cfg(feature = "mcap")]
                Reader::Mcap(rows) => {
                    let block = rows.next_block();
                    block.map(|block| Work::Parse(block, Notation::default(), file))
                }
                #[cfg(feature = "parquet")]
                Reader::Parquet(table) => table
                    .next_chunk(layout)
                    .map(|chunk| Work::Account(Box::new(Chunk { file, ..chunk }))),
                Reader::Memory(chunks) => chunks
                    .next()
                    .map(|chunk| Work::Account(Box::new(Chunk { file, ..chunk }))),
            };
            if let Some(work) = work {
                return Some(work);
            }
            let path = self.files.get(self.file + 1)?;
            let next = open(path, self.block)
                .and_then(|opened| opened.go_on(layout, &self.dialect, &self.reader));
            self.file += 1;
            match next {
                Ok(reader) => self.reader = reader,
                Err(error) => {
                    // The log ends here.
                    self.files.clear();
                    self.reader = Reader::Memory(Box::new(std::iter::empty()));
                    return Some(Work::Account(Box::new(Chunk {
                        file: self.file,
                        error: Some(error),
                        ..Chunk::default()
                    })));
                }
            }
        }
    }
}

/// Refuses a file that is given twice: without times its motion would be accounted for once more, after a jump to its start.
fn once(paths: &[PathBuf]) -> Result<(), TraceError> {
    let mut known = BTreeSet::new();
    for path in paths {
        // A pipe goes on where it was left.
        let is_file = path.as_os_str() != "-" && path.is_file();
        let place = path.canonicalize().ok().filter(|_| is_file);
        if place.is_some_and(|place| !known.insert(place)) {
            let message =
                "the file is given twice: the files of a log are its parts, each of them once";
            return Err(TraceError::new("twice", message).of(&path.display().to_string()));
        }
    }
    Ok(())
}

/// The digits of a column at the start of a log, of which the first file may have few rows; `None` where that is not read
/// twice. What is wrong with another is said where it is read.
fn digits(paths: &[PathBuf], dialect: &Dialect, column: usize) -> Option<Digits> {
    let (mut seen, mut digits) = (Seen::default(), None);
    for path in paths {
        if path.as_os_str() == "-" || seen.is_done() {
            break;
        }
        let Ok(opened) = open(path, lines::BLOCK) else {
            break;
        };
        match opened {
            Opened::Csv(mut lines) => {
                let Ok((_, notation)) = dialect.names(&mut lines) else {
                    break;
                };
                lines.see(column, notation, &mut seen);
            }
            #[cfg(feature = "parquet")]
            Opened::Parquet(table) => seen = table.see(column, seen),
            #[cfg(feature = "mcap")]
            Opened::Mcap(_) => break,
        }
        digits = Some(seen.digits);
    }
    digits
}

/// A file whose header is still to be read.
pub(crate) enum Opened {
    Csv(Lines<Box<dyn Read>>),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Table>),
    #[cfg(feature = "mcap")]
    Mcap(mcap::Log),
}

/// Opens a file, or standard input for `-`, by what it starts with.
fn open(path: &Path, block: usize) -> Result<Opened, TraceError> {
    if path.as_os_str() == "-" {
        return opened(Box::new(std::io::stdin()), block, None);
    }
    let named = |error: std::io::Error| TraceError::io(&error);
    let file = File::open(path).map_err(named)?;
    opened(Box::new(file), block, Some(path))
}

/// The first bytes of an MCAP file.
const MCAP: [u8; 4] = [0x89, b'M', b'C', b'A'];

/// A stream, which may be compressed; Parquet and MCAP must be files.
pub(crate) fn opened(
    mut input: Box<dyn Read>,
    block: usize,
    path: Option<&Path>,
) -> Result<Opened, TraceError> {
    let start = start(&mut input)?;
    shape::is_read(&start)?;
    if start.starts_with(b"PAR1") {
        return match path {
            Some(path) => open_parquet(path),
            None => Err(TraceError::new(
                "parquet",
                "Parquet must be a file: it is read from its end",
            )),
        };
    }
    if start.starts_with(&MCAP) {
        return match path {
            Some(path) => open_mcap(path, block),
            None => Err(TraceError::new(
                "mcap",
                "MCAP must be a file: it is read twice",
            )),
        };
    }
    let compressed = is_compressed(&start);
    // What was read of a pipe cannot be read again.
    let whole: Box<dyn Read> = Box::new(Cursor::new(start.clone()).chain(input));
    if !compressed {
        return Ok(Opened::Csv(Lines::new(whole, block)));
    }
    let mut inside = decompressed(whole, &start)?;
    let start = self::start(&mut inside)?;
    shape::is_read(&start)?;
    if is_compressed(&start) {
        let message =
            "the file is compressed twice: decompress it once, with `gzip -d` or `zstd -d`";
        return Err(TraceError::new("compressed", message));
    }
    if start.starts_with(b"PAR1") {
        let message = "Parquet inside a compressed file is not read: decompress the file";
        return Err(TraceError::new("parquet", message));
    }
    if start.starts_with(&MCAP) {
        let message = "MCAP inside a compressed file is not read: decompress the file";
        return Err(TraceError::new("mcap", message));
    }
    let whole: Box<dyn Read> = Box::new(Cursor::new(start).chain(inside));
    Ok(Opened::Csv(Lines::new(whole, block)))
}

#[cfg(feature = "parquet")]
fn open_parquet(path: &Path) -> Result<Opened, TraceError> {
    Ok(Opened::Parquet(Box::new(parquet::Table::open(path)?)))
}

#[cfg(not(feature = "parquet"))]
fn open_parquet(_: &Path) -> Result<Opened, TraceError> {
    let message = "Parquet is not in this build: build it with the feature `parquet`";
    Err(TraceError::new("parquet", message))
}

#[cfg(feature = "mcap")]
#[allow(clippy::unnecessary_wraps)] // as without the feature
fn open_mcap(path: &Path, block: usize) -> Result<Opened, TraceError> {
    Ok(Opened::Mcap(mcap::Log::new(path, block)))
}

#[cfg(not(feature = "mcap"))]
fn open_mcap(_: &Path, _: usize) -> Result<Opened, TraceError> {
    let message = "MCAP is not in this build: build it with the feature `mcap`";
    Err(TraceError::new("mcap", message))
}

impl Opened {
    /// Reads the header.
    pub(crate) fn read(
        self,
        scene: &Scene,
        dialect: &Dialect,
    ) -> Result<(Reader, Layout), TraceError> {
        match self {
            Self::Csv(mut lines) => {
                let (layout, _, notation) = dialect.heading(&mut lines, scene)?;
                Ok((Reader::Csv(lines, notation), layout))
            }
            #[cfg(feature = "parquet")]
            Self::Parquet(table) => {
                let told = dialect.columns.as_ref();
                let layout = Layout::read(table.headings()?, told, &table.preview(), scene);
                let mut layout = layout.map_err(|error| table.lists_named(error))?;
                if let Some(force) = layout.force {
                    layout.digits = table.see(force, Seen::default()).digits;
                }
                Ok((Reader::Parquet(table), layout))
            }
            #[cfg(feature = "mcap")]
            Self::Mcap(log) => {
                let (rows, layout) = log.read(scene, dialect.columns.as_ref())?;
                Ok((Reader::Mcap(Box::new(rows)), layout))
            }
        }
    }

    /// Reads the header of a file that goes on with a log.
    fn go_on(
        self,
        layout: &Layout,
        dialect: &Dialect,
        #[cfg_attr(not(feature = "mcap"), allow(unused_variables))] before: &Reader,
    ) -> Result<Reader, TraceError> {
        let (reader, headings) = match self {
            #[cfg(feature = "mcap")]
            Self::Mcap(log) => {
                let Reader::Mcap(before) = before else {
                    let message = "an MCAP file goes on only with a log in MCAP";
                    return Err(TraceError::new("mcap", message));
                };
                return Ok(Reader::Mcap(Box::new(log.go_on(before)?)));
            }
            Self::Csv(mut lines) => {
                let (line, notation) = dialect.names(&mut lines)?;
                let names = csv::names(&line, notation)?;
                // Where the first file has dates, this one must: its rows say whether it does.
                let unit = |column| {
                    layout
                        .headings
                        .get(column)
                        .filter(|h: &&Heading| h.is_dated())
                };
                let heading = |(column, name)| Heading {
                    name,
                    unit: unit(column).and_then(|heading| heading.unit),
                };
                let headings: Vec<Heading> = names.into_iter().enumerate().map(heading).collect();
                (Reader::Csv(lines, notation), headings)
            }
            #[cfg(feature = "parquet")]
            Self::Parquet(table) => {
                let headings = table.headings()?;
                (Reader::Parquet(table), headings)
            }
        };
        if headings != layout.headings {
            let message = "the files of a log must have the same header as the first one";
            return Err(TraceError::new("header", message));
        }
        Ok(reader)
    }
}
