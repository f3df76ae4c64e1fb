//! A stretch of a log in one file, found without reading what comes before it.
//!
//! A stretch is made of the intervals from one sample to another: of the samples a to b it accounts for the
//! intervals between, so that a stretch that ends at a sample is followed by one that starts at it. The
//! samples before the first are read as far as an account needs them.

use std::fmt;
use std::fs::File;
use std::io::{Read, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use passivity_scene::Scene;
use passivity_scene::display::hexadecimal;
use sha2::{Digest as _, Sha256};

use crate::ledger::Ledger;
use crate::log::comparison::Comparison;
#[cfg(feature = "parquet")]
use crate::log::digits::Seen;
use crate::log::error::{TraceError, shown};
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::lines::{self, Lines};
#[cfg(feature = "parquet")]
use crate::log::parquet::Table;
use crate::log::preview::Preview;
use crate::log::seek::Text;
use crate::log::source::{Dialect, Opened, Reader, Source, is_compressed, opened, start};
use crate::log::velocity::Velocities;
use crate::log::wraps;

/// Which intervals of a log are accounted for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stretch {
    /// From one sample to another, counted from 0; without the second to the end of the log.
    Samples(u64, Option<u64>),
    /// One of a number of pieces, counted from 1: of about as many bytes of CSV, or rows of Parquet.
    Shard(u64, u64),
    /// Several of them: from one, to another, of how many.
    Shards(u64, u64, u64),
}

impl Stretch {
    /// Reads `3/8`, the third of eight pieces, or `3-5/8`, the third to the fifth.
    ///
    /// # Errors
    ///
    /// Text that is something else.
    pub fn parse_shard(text: &str) -> Result<Self, TraceError> {
        let number = |text: &str| text.trim().parse::<u64>().ok();
        let numbers = text.split_once('/').and_then(|(pieces, n)| {
            let (i, j) = pieces.split_once('-').unwrap_or((pieces, pieces));
            Some((number(i)?, number(j)?, number(n)?))
        });
        match numbers {
            Some((i, j, n)) if 0 < i && i == j && j <= n => Ok(Self::Shard(i, n)),
            Some((i, j, n)) if 0 < i && i < j && j <= n => Ok(Self::Shards(i, j, n)),
            _ => Err(TraceError::new(
                "shard",
                format!(
                    "expected which piece of how many, from 1/8 to 8/8 or several in order, as in 3-5/8, found `{}`",
                    shown(text.as_bytes())
                ),
            )),
        }
    }
}

/// As it can be typed.
impl fmt::Display for Stretch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Samples(from, None) => write!(f, "{from}:"),
            Self::Samples(from, Some(to)) => write!(f, "{from}:{to}"),
            Self::Shard(i, n) => write!(f, "{i}/{n}"),
            Self::Shards(i, j, n) => write!(f, "{i}-{j}/{n}"),
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
            #[cfg(feature = "mcap")]
            Opened::Mcap(_) => {
                let message = "an MCAP file can only be read from its start: a piece of it cannot be accounted for alone";
                Err(TraceError::new("mcap", message))
            }
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
        .max(wraps::HISTORY)
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
    Ok(hexadecimal(&hash.finalize()))
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
    let (layout, said, notation) = dialect.heading(&mut lines, scene)?;
    let start = lines.before();
    let (from, to) = match stretch {
        Stretch::Samples(from, to) => text.lines(start, from, to),
        Stretch::Shard(i, n) => text.shards(start, (i, i), n),
        Stretch::Shards(i, j, n) => text.shards(start, (i, j), n),
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
    text.file.seek(SeekFrom::Start(before)).map_err(io)?;
    let stretch: Box<dyn Read> = Box::new(text.file.take(end - before));
    let lines = match to {
        Some(_) => Lines::within(stretch, block),
        None => Lines::new(stretch, block),
    };
    Ok(Piece {
        source: Source::of(Reader::Csv(lines, notation)),
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
    })
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
    let mut layout = said.layout(dialect, scene)?;
    if let Some(force) = layout.force {
        layout.digits = table.see(force, Seen::default()).digits;
    }
    let rows = table.rows()?;
    let (from, to) = match stretch {
        Stretch::Samples(from, to) => (from.min(rows), to.unwrap_or(rows).min(rows)),
        Stretch::Shard(i, n) => (table.cut(rows, i - 1, n), table.cut(rows, i, n)),
        Stretch::Shards(i, j, n) => (table.cut(rows, i - 1, n), table.cut(rows, j, n)),
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
    Ok(Piece {
        source: Source::of(Reader::Parquet(table)),
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
