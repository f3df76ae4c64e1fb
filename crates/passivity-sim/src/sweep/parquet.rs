//! A finished sweep as Parquet: the columns of the CSV, `at_interval` null where there is none.

use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, ConvertedType, Repetition, Type as Physical};
use parquet::column::reader::get_typed_column_reader;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader as _, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::Type;
use passivity_scene::files::Output;

use crate::error::SimError;
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
use crate::sweep::row::{Each, Found, Row};

/// The key under which a shard says what it is.
const MANIFEST: &str = "passivity.sweep";

/// The columns, in the order of the CSV.
fn schema(grid: &Grid) -> Result<Type, ParquetError> {
    let column = Type::primitive_type_builder;
    let names = grid.columns();
    let mut columns = Vec::new();
    for name in &names {
        columns.push(column(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED));
    }
    for name in ["paper", "exact"] {
        let text = column(name, Physical::BYTE_ARRAY).with_converted_type(ConvertedType::UTF8);
        columns.push(text.with_repetition(Repetition::REQUIRED));
    }
    columns.push(column("at_interval", Physical::INT64).with_repetition(Repetition::OPTIONAL));
    for name in ["xi", "velocity"] {
        columns.push(column(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED));
    }
    let built = columns
        .into_iter()
        .map(|column| column.build().map(Arc::new));
    let fields = built.collect::<Result<Vec<_>, _>>()?;
    Type::group_type_builder("sweep")
        .with_fields(fields)
        .build()
}

/// Rows that are encoded at once.
const GROUP: usize = 1 << 18;

/// A file of rows that are added in the order of the grid. The bytes are the same however many are
/// added at once.
pub(super) struct Writer {
    file: SerializedFileWriter<Output>,
    waiting: Vec<(usize, Row)>,
}

impl Writer {
    /// Starts a file; that of a shard says in `manifest` what it is.
    pub(super) fn new(
        file: Output,
        grid: &Grid,
        manifest: Option<String>,
    ) -> Result<Self, ParquetError> {
        let said = manifest.map(|text| vec![KeyValue::new(MANIFEST.to_owned(), text)]);
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(said)
            .build();
        let (schema, properties) = (Arc::new(schema(grid)?), Arc::new(properties));
        Ok(Self {
            file: SerializedFileWriter::new(file, schema, properties)?,
            waiting: Vec::new(),
        })
    }

    pub(super) fn add(&mut self, grid: &Grid, index: usize, row: &Row) -> Result<(), ParquetError> {
        self.waiting.push((index, *row));
        match self.waiting.len() {
            GROUP => self.put(grid),
            _ => Ok(()),
        }
    }

    fn put(&mut self, grid: &Grid) -> Result<(), ParquetError> {
        let mut group = self.file.next_row_group()?;
        write_group(&mut group, grid, &self.waiting)?;
        group.close()?;
        self.waiting.clear();
        Ok(())
    }

    /// Has the rows reach the disk, and then their name.
    pub(super) fn finish(mut self, grid: &Grid) -> Result<(), ParquetError> {
        if !self.waiting.is_empty() {
            self.put(grid)?;
        }
        self.file.into_inner()?.keep()?;
        Ok(())
    }
}

fn write_group(
    group: &mut SerializedRowGroupWriter<'_, Output>,
    grid: &Grid,
    rows: &[(usize, Row)],
) -> Result<(), ParquetError> {
    let axes: [fn([f64; 3]) -> f64; 3] = [|[x, _, _]| x, |[_, x, _]| x, |[_, _, x]| x];
    for axis in axes.into_iter().take(grid.columns().len()) {
        let values = rows.iter().map(|(index, _)| axis(grid.doubles(*index)));
        column::<DoubleType>(group, &values.collect::<Vec<_>>(), None)?;
    }
    let words: [fn(&Row) -> &'static str; 2] = [|row| row.paper.name(), |row| row.exact.name()];
    for word in words {
        let texts: Vec<ByteArray> = rows.iter().map(|(_, row)| word(row).into()).collect();
        column::<ByteArrayType>(group, &texts, None)?;
    }
    let intervals = rows.iter().filter_map(|(_, row)| row.at_interval);
    let there: Vec<i64> = intervals
        .map(i64::try_from)
        .collect::<Result<_, _>>()
        .map_err(|error| ParquetError::General(error.to_string()))?;
    let levels: Vec<i16> = rows
        .iter()
        .map(|(_, row)| i16::from(row.at_interval.is_some()))
        .collect();
    column::<Int64Type>(group, &there, Some(&levels))?;
    let states: [fn(&Row) -> f64; 2] = [|row| row.xi, |row| row.velocity];
    for state in states {
        let values: Vec<f64> = rows.iter().map(|(_, row)| state(row)).collect();
        column::<DoubleType>(group, &values, None)?;
    }
    Ok(())
}

fn column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, Output>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let missing = || ParquetError::General("a column too few".to_owned());
    let mut column = group.next_column()?.ok_or_else(missing)?;
    column.typed::<T>().write_batch(values, levels, None)?;
    column.close()
}

/// Reads a file of [`Writer`], a group of rows after the other.
pub(super) fn read(path: &Path, grid: &Grid, each: Each<'_>) -> Result<(), SimError> {
    let failed = |error| failed(path, &error);
    let reader = guarded(|| opened(path, grid)).map_err(|error: String| failed(error))?;
    let mut number = 0;
    for group in 0..reader.num_row_groups() {
        let rows = guarded(|| read_group(&*reader.get_row_group(group)?, grid));
        for row in rows.map_err(failed)? {
            each(number, row)?;
            number += 1;
        }
    }
    Ok(())
}

/// What a shard says that it is; `None` of a file that says nothing.
pub(super) fn manifest(path: &Path) -> Result<Option<String>, String> {
    guarded(|| {
        let reader = SerializedFileReader::new(File::open(path)?)?;
        let said = reader.metadata().file_metadata().key_value_metadata();
        let found = said.and_then(|said| said.iter().find(|pair| pair.key == MANIFEST));
        Ok(found.and_then(|pair| pair.value.clone()))
    })
}

/// The library asserts on some corrupt files: that is an error like any other.
fn guarded<T>(read: impl FnOnce() -> Result<T, ParquetError>) -> Result<T, String> {
    let reading = AssertUnwindSafe(|| read().map_err(|error| error.to_string()));
    catch_unwind(reading).unwrap_or_else(|_| Err("its contents contradict each other".to_owned()))
}

fn opened(path: &Path, grid: &Grid) -> Result<SerializedFileReader<File>, ParquetError> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let found = reader.metadata().file_metadata().schema();
    if *found != schema(grid)? {
        let message = "its columns are not those of a sweep";
        return Err(ParquetError::General(message.to_owned()));
    }
    Ok(reader)
}

/// The rows of a group.
fn read_group(group: &dyn RowGroupReader, grid: &Grid) -> Result<Vec<Found>, ParquetError> {
    let mut rows = Vec::new();
    let wrong = |what: String| ParquetError::General(what);
    let len = usize::try_from(group.metadata().num_rows())
        .map_err(|_| wrong("a group with less than no rows".to_owned()))?;
    let axes = grid.columns().len();
    let mut at_axes = Vec::new();
    for axis in 0..axes {
        at_axes.push(values::<DoubleType>(group, axis, len)?);
    }
    let paper = values::<ByteArrayType>(group, axes, len)?;
    let exact = values::<ByteArrayType>(group, axes + 1, len)?;
    let (there, levels) = optional::<Int64Type>(group, axes + 2, len)?;
    let mut there = there.into_iter();
    let xi = values::<DoubleType>(group, axes + 3, len)?;
    let velocity = values::<DoubleType>(group, axes + 4, len)?;
    let word = |text: &ByteArray| String::from_utf8_lossy(text.data()).into_owned();
    let outcomes = paper.iter().zip(&exact).zip(levels);
    let states = xi.into_iter().zip(velocity);
    for (i, (((paper, exact), level), (xi, velocity))) in outcomes.zip(states).enumerate() {
        let (paper, exact) = (word(paper), word(exact));
        let no_outcome = |text: &str| wrong(format!("`{text}` is no outcome"));
        let at_interval = match level {
            0 => None,
            _ => {
                let h = there.next().and_then(|h| u64::try_from(h).ok());
                Some(h.ok_or_else(|| wrong("`at_interval` is below zero".to_owned()))?)
            }
        };
        let row = Row {
            paper: PaperOutcome::named(&paper).ok_or_else(|| no_outcome(&paper))?,
            exact: ExactOutcome::named(&exact).ok_or_else(|| no_outcome(&exact))?,
            at_interval,
            xi,
            velocity,
            within_rounding_of_edge: None,
        };
        let mut point = [0.0; 3];
        for (value, column) in point.iter_mut().zip(&at_axes) {
            let found = column.get(i).copied();
            *value = found.ok_or_else(|| wrong("a column too short".to_owned()))?;
        }
        rows.push((point, row));
    }
    Ok(rows)
}

/// The values of a column without nulls.
fn values<T: DataType>(
    group: &dyn RowGroupReader,
    column: usize,
    len: usize,
) -> Result<Vec<T::T>, ParquetError> {
    let mut reader = get_typed_column_reader::<T>(group.get_column_reader(column)?);
    let mut values = Vec::new();
    while values.len() < len {
        let (records, _, _) = reader.read_records(len - values.len(), None, None, &mut values)?;
        if records == 0 {
            return Err(ParquetError::General("a column too short".to_owned()));
        }
    }
    Ok(values)
}

/// The values of a column with nulls, and for each row whether it has one.
fn optional<T: DataType>(
    group: &dyn RowGroupReader,
    column: usize,
    len: usize,
) -> Result<(Vec<T::T>, Vec<i16>), ParquetError> {
    let mut reader = get_typed_column_reader::<T>(group.get_column_reader(column)?);
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    while levels.len() < len {
        let most = len - levels.len();
        let (records, _, _) = reader.read_records(most, Some(&mut levels), None, &mut values)?;
        if records == 0 {
            return Err(ParquetError::General("a column too short".to_owned()));
        }
    }
    Ok((values, levels))
}
