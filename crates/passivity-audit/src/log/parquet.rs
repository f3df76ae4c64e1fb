//! Parquet traces: the same columns, read in batches.

use std::fs::File;
use std::path::Path;

use parquet::basic::Type as Physical;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::{ColumnReader, get_column_reader};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::schema::types::ColumnDescPtr;

use crate::log::chunk::{Chunk, Samples};
use crate::log::digits::Seen;
use crate::log::error::{TraceError, shown};
use crate::log::guarded::guarded;
use crate::log::header::Heading;
use crate::log::layout::{Form, Layout, MAX_COLUMNS};
use crate::log::numbers::Numbers;
use crate::log::preview::Preview;
use crate::log::running::near_number;
use crate::log::step::{above_zero, gap};
use crate::log::typed::{self, Meaning, broken, counts};
use crate::reading::Reading;

/// How many rows are decoded at once: of counts alone, of which there is little to keep;
const COUNTS: usize = 1 << 19;

/// and of others, so that what is computed of them does not have to leave the cache.
const ROWS: usize = 1 << 14;

/// A column that is read.
struct Wanted {
    column: usize,
    meaning: Meaning,
    reader: ColumnReader,
}

/// A Parquet file, open.
pub(crate) struct Table {
    file: SerializedFileReader<File>,
    group: usize,
    columns: Vec<Wanted>,
    left: u64,
    /// How many rows are read at the most.
    most: u64,
}

impl Table {
    pub(crate) fn open(path: &Path) -> Result<Self, TraceError> {
        let file = File::open(path).map_err(|error| TraceError::io(&error))?;
        let file = guarded("parquet", || {
            SerializedFileReader::new(file).map_err(|error| broken(&error))
        })?;
        Ok(Self {
            file,
            group: 0,
            columns: Vec::new(),
            left: 0,
            most: u64::MAX,
        })
    }

    /// The names of the columns, and the units that their types give.
    pub(crate) fn headings(&self) -> Result<Vec<Heading>, TraceError> {
        let schema = self.file.metadata().file_metadata().schema_descr();
        let heading = |column: &ColumnDescPtr| Heading {
            name: column.path().string(),
            unit: Meaning::of(column).ok().and_then(Meaning::unit),
        };
        guarded("parquet", || {
            Ok(schema.columns().iter().map(heading).collect())
        })
    }

    /// The error of a header, and which columns are lists, where nothing else is proposed.
    pub(crate) fn lists_named(&self, mut error: TraceError) -> TraceError {
        let schema = self.file.metadata().file_metadata().schema_descr();
        let mut lists = schema.columns().iter().filter(|c| c.max_rep_level() > 0);
        if let (None, Some(list)) = (&error.proposal, lists.next()) {
            let name = shown(list.path().string().as_bytes());
            let others = match lists.count() {
                0 => " holds lists, which are".to_owned(),
                n => format!(" and {n} more hold lists, which are"),
            };
            error.message = format!(
                "the column `{name}`{others} not read: write each element as a column of its own"
            );
        }
        error
    }

    /// The first rows, to judge the names by; what cannot be read is no number.
    pub(crate) fn preview(&self) -> Preview {
        let read = guarded("parquet", || {
            let group = self.file.get_row_group(0).map_err(|e| broken(&e))?;
            let schema = self.file.metadata().file_metadata().schema_descr();
            let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
            let mut columns = Vec::new();
            for column in 0..schema.num_columns().min(MAX_COLUMNS) {
                let values = match open_column(&*group, column) {
                    Ok(mut wanted) => {
                        typed::numbers(wanted.meaning, &mut wanted.reader, rows.min(Preview::ROWS))
                            .values
                    }
                    Err(_) => Vec::new(),
                };
                let near = values.iter().map(|x| Some(near_number(x)));
                let mut near: Vec<Option<f64>> = near.collect();
                near.resize(rows.min(Preview::ROWS), None);
                columns.push(near);
            }
            Ok(columns)
        });
        Preview {
            // What is wrong with the file is said where it is read.
            columns: read.unwrap_or_default(),
            ..Preview::default()
        }
    }

    /// Looks at the digits of the numbers of a column of texts, group by group.
    pub(crate) fn see(&self, column: usize, mut seen: Seen) -> Seen {
        let looked = guarded("parquet", || {
            for group in 0..self.file.num_row_groups() {
                let group = self.file.get_row_group(group).map_err(|e| broken(&e))?;
                let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
                let mut wanted = open_column(&*group, column)?;
                if wanted.meaning != Meaning::Text || seen.is_done() {
                    break;
                }
                typed::see(&mut wanted.reader, rows, &mut seen)?;
            }
            Ok(())
        });
        // What is wrong with the file is said where it is read.
        looked.unwrap_or_default();
        seen
    }

    /// The next stretch of rows; `None` after the last.
    pub(crate) fn next_chunk(&mut self, layout: &Layout) -> Option<Chunk> {
        let chunk = guarded("parquet", || self.read(layout));
        match chunk {
            Ok(chunk) => chunk,
            Err(error) => {
                // Nothing more can be read.
                self.group = usize::MAX;
                self.left = 0;
                Some(Chunk {
                    error: Some(error.row(0)),
                    ..Chunk::default()
                })
            }
        }
    }

    /// How many rows there are.
    pub(crate) fn rows(&self) -> Result<u64, TraceError> {
        let rows = self.file.metadata().file_metadata().num_rows();
        u64::try_from(rows).map_err(|_| TraceError::new("parquet", "a file with less than no rows"))
    }

    /// The row where the piece `i` of `n` ends: where a group does, if there are enough of them.
    pub(crate) fn cut(&self, rows: u64, i: u64, n: u64) -> u64 {
        let even = u128::from(rows) * u128::from(i) / u128::from(n.max(1));
        let even = u64::try_from(even).unwrap_or(rows);
        let groups = self.file.metadata().row_groups();
        if (groups.len() as u64) < n || i == 0 || i >= n {
            return even;
        }
        let mut start = 0;
        for group in groups {
            let next = start + u64::try_from(group.num_rows()).unwrap_or(0);
            if next > even {
                break;
            }
            start = next;
        }
        start
    }

    /// Goes to a row, from which on at most `most` are read.
    pub(crate) fn seek(&mut self, layout: &Layout, row: u64, most: u64) -> Result<(), TraceError> {
        self.most = most;
        let mut row = row;
        while row > 0 && most > 0 {
            let group = self
                .file
                .get_row_group(self.group)
                .map_err(|e| broken(&e))?;
            let rows = u64::try_from(group.metadata().num_rows()).unwrap_or(0);
            self.group += 1;
            if rows <= row {
                row -= rows;
                continue;
            }
            let opened = guarded("parquet", || {
                let (mut columns, left) = open_group(&*group, layout)?;
                let skipped = usize::try_from(row).unwrap_or(usize::MAX);
                for wanted in &mut columns {
                    typed::skip(&mut wanted.reader, skipped)?;
                }
                Ok((columns, left - row))
            });
            (self.columns, self.left) = opened?;
            row = 0;
        }
        Ok(())
    }

    fn read(&mut self, layout: &Layout) -> Result<Option<Chunk>, TraceError> {
        if self.most == 0 {
            return Ok(None);
        }
        while self.left == 0 {
            if self.group >= self.file.num_row_groups() {
                return Ok(None);
            }
            let group = self
                .file
                .get_row_group(self.group)
                .map_err(|e| broken(&e))?;
            (self.columns, self.left) = open_group(&*group, layout)?;
            self.group += 1;
        }
        let left = self.left.min(self.most);
        let most = match (layout.form, layout.force) {
            (Form::Count, None) => COUNTS,
            _ => ROWS,
        };
        let rows = most.min(usize::try_from(left).unwrap_or(usize::MAX));
        let mut chunk = Chunk::new(layout);
        let [mut starts, mut ends, mut fine] = std::array::from_fn(|_| Numbers::default());
        // How many rows are whole, and what is wrong with the next.
        let (mut whole, mut error) = (rows, None);
        for Wanted {
            column,
            meaning,
            reader,
        } in &mut self.columns
        {
            let mut keep = |len: usize, found: Option<TraceError>| {
                if let Some(found) = found.filter(|_| error.is_none() || len < whole) {
                    let row = u64::try_from(len).unwrap_or(u64::MAX);
                    error = Some(found.column(layout.name(*column)).row(row));
                    whole = len;
                }
            };
            if *column == layout.position && layout.form == Form::Count {
                let counts = counts(*meaning, reader, rows);
                keep(counts.values.len(), counts.error);
                chunk.samples = Samples::Counts(counts.values);
                continue;
            }
            let (read, found) = match Some(*column) == layout.force {
                true => {
                    let (read, roundings, found) = typed::forces(*meaning, reader, rows, layout);
                    chunk.forces.roundings = roundings;
                    (read, found)
                }
                false => typed::column(*meaning, reader, rows),
            };
            keep(read.len(), found);
            match *column {
                i if i == layout.position => starts = read,
                i if Some(i) == layout.end => ends = read,
                i if Some(i) == layout.dtau => {
                    for dtau in (0..read.len()).filter_map(|i| read.get(i)) {
                        match above_zero(dtau) {
                            Ok(dtau) => chunk.dtaus.push(dtau),
                            Err(found) => {
                                keep(chunk.dtaus.len(), Some(found));
                                break;
                            }
                        }
                    }
                }
                i if Some(i) == layout.time => chunk.times = read,
                i if Some(i) == layout.fine_column() => fine = read,
                i if Some(i) == layout.velocity => {
                    let near = (0..read.len()).filter_map(|i| read.get(i));
                    chunk.velocities = near
                        .map(|v| near_number(&v) * layout.per_velocity)
                        .collect();
                }
                column => {
                    let found = chunk.forces.values.push_all(read).err();
                    let len = chunk.forces.values.len();
                    keep(len, found.map(|found| found.column(layout.name(column))));
                }
            }
        }
        let (times, found) = layout.moments(std::mem::take(&mut chunk.times), &fine);
        chunk.times = times;
        if let Some(found) = found.filter(|_| chunk.times.len() < whole) {
            whole = chunk.times.len();
            error = Some(found.row(u64::try_from(whole).unwrap_or(u64::MAX)));
        }
        if layout.end.is_some()
            && let Some(row) = (1..whole).find(|row| ends.get(row - 1) != starts.get(*row))
        {
            whole = row;
            error = Some(gap(layout).row(u64::try_from(row).unwrap_or(u64::MAX)));
        }
        if let Samples::Any(samples) = &mut chunk.samples {
            starts.truncate(whole);
            if let Err(found) = samples.push_all(starts) {
                whole = samples.len();
                let row = u64::try_from(whole).unwrap_or(u64::MAX);
                error = Some(found.column(layout.name(layout.position)).row(row));
            }
        }
        chunk.truncate(whole);
        let last = whole.checked_sub(1).and_then(|last| ends.get(last));
        chunk.closing = last.map(Reading::Exact);
        self.left -= u64::try_from(rows).unwrap_or(0);
        self.most -= u64::try_from(rows).unwrap_or(0);
        if error.is_some() {
            self.left = 0;
            self.group = usize::MAX;
        }
        chunk.error = error;
        Ok(Some(chunk))
    }
}

/// The readers of the columns that are wanted, and how many rows there are.
fn open_group(
    group: &dyn RowGroupReader,
    layout: &Layout,
) -> Result<(Vec<Wanted>, u64), TraceError> {
    let rows = u64::try_from(group.metadata().num_rows())
        .map_err(|_| TraceError::new("parquet", "a group with less than no rows"))?;
    let open = |column| {
        let opened = open_column(group, column);
        opened.map_err(|error| error.column(layout.name(column)))
    };
    let columns: Result<_, _> = layout.read_columns().map(open).collect();
    Ok((columns?, rows))
}

fn open_column(group: &dyn RowGroupReader, column: usize) -> Result<Wanted, TraceError> {
    let descriptor = group.metadata().column(column).column_descr_ptr();
    let meaning = Meaning::of(&descriptor)?;
    let pages = group
        .get_column_page_reader(column)
        .map_err(|e| broken(&e))?;
    let pages = Checked {
        pages,
        physical: descriptor.physical_type(),
    };
    Ok(Wanted {
        column,
        meaning,
        reader: get_column_reader(descriptor, Box::new(pages)),
    })
}

/// Pages whose dictionaries hold the values that they claim: memory is set aside for the claim.
struct Checked {
    pages: Box<dyn PageReader>,
    physical: Physical,
}

impl Checked {
    fn check(&self, page: Option<Page>) -> Result<Option<Page>, ParquetError> {
        let Some(Page::DictionaryPage {
            buf, num_values, ..
        }) = &page
        else {
            return Ok(page);
        };
        // What one value takes at the least; a text has its length in front.
        let width = match self.physical {
            Physical::BOOLEAN | Physical::FIXED_LEN_BYTE_ARRAY => 1,
            Physical::INT32 | Physical::FLOAT | Physical::BYTE_ARRAY => 4,
            Physical::INT64 | Physical::DOUBLE => 8,
            Physical::INT96 => 12,
        };
        let most = buf.len() / width;
        if usize::try_from(*num_values).is_ok_and(|claimed| claimed <= most) {
            return Ok(page);
        }
        let message = format!("a dictionary of {num_values} values with room for {most}");
        Err(ParquetError::General(message))
    }
}

impl Iterator for Checked {
    type Item = Result<Page, ParquetError>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Checked {
    fn get_next_page(&mut self) -> Result<Option<Page>, ParquetError> {
        let page = self.pages.get_next_page()?;
        self.check(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>, ParquetError> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<(), ParquetError> {
        self.pages.skip_next_page()
    }

    fn at_record_boundary(&mut self) -> Result<bool, ParquetError> {
        self.pages.at_record_boundary()
    }
}
