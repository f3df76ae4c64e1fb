//! Parquet traces: the same columns, read in batches.

use std::cell::Cell;
use std::fs::File;
use std::path::Path;
use std::sync::Once;

use parquet::basic::Type as Physical;
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl, get_column_reader};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::schema::types::ColumnDescPtr;

use crate::log::chunk::{Chunk, Samples};
use crate::log::error::{self, TraceError};
use crate::log::layout::{Form, Layout};
use crate::number::Number;
use crate::reading::Reading;

/// How many rows are decoded at once.
const ROWS: usize = 1 << 19;

/// A Parquet file, open.
pub(crate) struct Table {
    file: SerializedFileReader<File>,
    group: usize,
    columns: Vec<(usize, ColumnReader)>,
    left: u64,
}

fn broken(error: &ParquetError) -> TraceError {
    TraceError::new("parquet", format!("cannot be read as Parquet: {error}"))
}

thread_local! {
    /// Whether this thread is within [`guarded`].
    static GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// The library asserts on some corrupt files: what it says then is an error like any other, and
/// not said twice.
fn guarded<T>(read: impl FnOnce() -> Result<T, TraceError>) -> Result<T, TraceError> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let report = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            if !GUARDED.get() {
                report(panic);
            }
        }));
    });
    let read = std::panic::AssertUnwindSafe(read);
    GUARDED.set(true);
    let outcome = std::panic::catch_unwind(read);
    GUARDED.set(false);
    outcome.unwrap_or_else(|_| {
        let message = "cannot be read as Parquet: its contents contradict each other";
        Err(TraceError::new("parquet", message))
    })
}

impl Table {
    pub(crate) fn open(path: &Path) -> Result<Self, TraceError> {
        let file = File::open(path).map_err(|error| TraceError::io(&error))?;
        let file = guarded(|| SerializedFileReader::new(file).map_err(|error| broken(&error)))?;
        Ok(Self {
            file,
            group: 0,
            columns: Vec::new(),
            left: 0,
        })
    }

    /// The names of the columns.
    pub(crate) fn names(&self) -> Vec<String> {
        let schema = self.file.metadata().file_metadata().schema_descr();
        let name = |column: &ColumnDescPtr| column.path().string();
        schema.columns().iter().map(name).collect()
    }

    /// The next stretch of rows; `None` after the last.
    pub(crate) fn next_chunk(&mut self, layout: &Layout) -> Option<Chunk> {
        let chunk = guarded(|| self.read(layout));
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

    fn read(&mut self, layout: &Layout) -> Result<Option<Chunk>, TraceError> {
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
        let rows = ROWS.min(usize::try_from(self.left).unwrap_or(usize::MAX));
        let mut chunk = Chunk::default();
        let mut starts = Column::default();
        // How many rows are whole, and what is wrong with the next.
        let (mut whole, mut error) = (rows, None);
        for (column, reader) in &mut self.columns {
            let mut keep = |len: usize, found: Option<TraceError>| {
                if let Some(found) = found.filter(|_| error.is_none() || len < whole) {
                    let row = u64::try_from(len).unwrap_or(u64::MAX);
                    error = Some(found.column(layout.name(*column)).row(row));
                    whole = len;
                }
            };
            if *column == layout.position && layout.form == Form::Count {
                let counts = counts(reader, rows);
                keep(counts.values.len(), counts.error);
                chunk.samples = Samples::Counts(counts.values);
                continue;
            }
            let mut read = numbers(reader, rows);
            keep(read.values.len(), read.error.take());
            match *column {
                i if i == layout.position => starts = read,
                i if Some(i) == layout.end => {
                    let next = read.values.iter().zip(starts.values.iter().skip(1));
                    if let Some(row) = next.into_iter().position(|(end, start)| end != start) {
                        let message = "a row of a ledger starts where the row before it ends";
                        keep(row + 1, Some(TraceError::new("gap", message)));
                    }
                    read.values.truncate(whole);
                    chunk.closing = read.values.last().cloned().map(Reading::Exact);
                }
                i if Some(i) == layout.dtau => chunk.dtaus = read.values,
                i if Some(i) == layout.time => chunk.times = read.values,
                _ => {
                    let forces = read.values.into_iter();
                    chunk.forces = forces.map(|x| layout.force(x, 0.0)).collect();
                }
            }
        }
        if layout.form != Form::Count {
            let mut samples = Vec::with_capacity(starts.values.len());
            for x in starts.values.into_iter().take(whole) {
                match layout.sample(x) {
                    Ok(sample) => samples.push(sample),
                    Err(found) => {
                        whole = samples.len();
                        let row = u64::try_from(whole).unwrap_or(u64::MAX);
                        error = Some(found.column(layout.name(layout.position)).row(row));
                        break;
                    }
                }
            }
            chunk.samples = Samples::Any(samples);
        }
        chunk.truncate(whole);
        self.left -= u64::try_from(rows).unwrap_or(0);
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
) -> Result<(Vec<(usize, ColumnReader)>, u64), TraceError> {
    let rows = u64::try_from(group.metadata().num_rows())
        .map_err(|_| TraceError::new("parquet", "a group with less than no rows"))?;
    let wanted = [
        Some(layout.position),
        layout.end,
        layout.dtau,
        layout.time,
        layout.force,
    ];
    let mut columns = Vec::new();
    for column in wanted.into_iter().flatten() {
        let pages = group
            .get_column_page_reader(column)
            .map_err(|e| broken(&e))?;
        let descriptor = group.metadata().column(column).column_descr_ptr();
        let pages = Checked {
            pages,
            physical: descriptor.physical_type(),
        };
        columns.push((column, get_column_reader(descriptor, Box::new(pages))));
    }
    Ok((columns, rows))
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

/// The values of a column up to the first that is wrong.
struct Column<T> {
    values: Vec<T>,
    error: Option<TraceError>,
}

impl<T> Default for Column<T> {
    fn default() -> Self {
        Self {
            values: Vec::new(),
            error: None,
        }
    }
}

impl<T> Column<T> {
    fn map<U>(self, f: impl Fn(T) -> Result<U, TraceError>) -> Column<U> {
        let mut mapped = Column {
            values: Vec::with_capacity(self.values.len()),
            error: self.error,
        };
        for value in self.values {
            match f(value) {
                Ok(value) => mapped.values.push(value),
                Err(error) => {
                    mapped.error = Some(error);
                    break;
                }
            }
        }
        mapped
    }

    const fn wrong(error: TraceError) -> Self {
        Self {
            values: Vec::new(),
            error: Some(error),
        }
    }
}

/// Reads `rows` values.
fn values<T: DataType>(reader: &mut ColumnReaderImpl<T>, rows: usize) -> Column<T::T> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    let mut records = 0;
    let mut error = None;
    while records < rows && error.is_none() {
        match reader.read_records(rows - records, Some(&mut levels), None, &mut values) {
            Ok((0, _, _)) => {
                let message = format!("the column ends after {records} of {rows} rows");
                error = Some(TraceError::new("parquet", message));
            }
            Ok((got, _, _)) => records += got,
            Err(found) => error = Some(broken(&found)),
        }
    }
    if values.len() > records {
        let message = "a column of lists is no column of numbers";
        return Column::wrong(TraceError::new("type", message));
    }
    if values.len() < records {
        // Some rows have no value. A column that requires them has no levels.
        let most = levels.iter().copied().max().unwrap_or(0).max(1);
        let first = levels.iter().position(|level| *level < most);
        values.truncate(first.unwrap_or(0));
        error = Some(TraceError::new("missing", "expected a value, found none"));
    }
    Column { values, error }
}

fn counts(reader: &mut ColumnReader, rows: usize) -> Column<i64> {
    match reader {
        ColumnReader::Int64ColumnReader(reader) => values(reader, rows),
        ColumnReader::Int32ColumnReader(reader) => values(reader, rows).map(|n| Ok(i64::from(n))),
        ColumnReader::DoubleColumnReader(reader) => {
            values(reader, rows).map(|x| match Number::from_f64(x) {
                Some(Number::Small(n, 1)) => Ok(n),
                _ => Err(TraceError::new(
                    "count",
                    format!("expected a count, found {x}"),
                )),
            })
        }
        _ => Column::wrong(type_error(reader, "whole numbers")),
    }
}

fn numbers(reader: &mut ColumnReader, rows: usize) -> Column<Number> {
    let double = |x: f64| {
        Number::from_f64(x)
            .ok_or_else(|| TraceError::new("not_finite", format!("expected a number, found {x}")))
    };
    match reader {
        ColumnReader::Int64ColumnReader(reader) => {
            values(reader, rows).map(|n| Ok(Number::whole(n)))
        }
        ColumnReader::Int32ColumnReader(reader) => {
            values(reader, rows).map(|n| Ok(Number::whole(n.into())))
        }
        ColumnReader::DoubleColumnReader(reader) => values(reader, rows).map(double),
        ColumnReader::FloatColumnReader(reader) => values(reader, rows).map(|x| double(x.into())),
        ColumnReader::ByteArrayColumnReader(reader) => values(reader, rows).map(|text| {
            let text = text.data();
            let Ok(literal) = std::str::from_utf8(text) else {
                return Err(TraceError::new("number", "not UTF-8 text"));
            };
            error::number(literal)
        }),
        _ => Column::wrong(type_error(reader, "numbers")),
    }
}

fn type_error(reader: &ColumnReader, expected: &str) -> TraceError {
    let found = match reader {
        ColumnReader::BoolColumnReader(_) => Physical::BOOLEAN,
        ColumnReader::Int96ColumnReader(_) => Physical::INT96,
        ColumnReader::FixedLenByteArrayColumnReader(_) => Physical::FIXED_LEN_BYTE_ARRAY,
        ColumnReader::ByteArrayColumnReader(_) => Physical::BYTE_ARRAY,
        ColumnReader::FloatColumnReader(_) => Physical::FLOAT,
        ColumnReader::DoubleColumnReader(_) => Physical::DOUBLE,
        ColumnReader::Int32ColumnReader(_) => Physical::INT32,
        ColumnReader::Int64ColumnReader(_) => Physical::INT64,
    };
    TraceError::new("type", format!("expected {expected}, found {found}"))
}
