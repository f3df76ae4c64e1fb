//! A finished sweep as Parquet: the columns of the CSV, `at_interval` null where there is none.

use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, ConvertedType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::RowAccessor as _;
use parquet::schema::types::Type;

use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::sweep::grid::Grid;
use crate::sweep::row::{Found, Row};

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

/// Writes the rows that are there, in the order of the grid, and has them reach the disk.
pub(super) fn write(path: &Path, grid: &Grid, rows: &[Option<Row>]) -> Result<(), ParquetError> {
    let schema = Arc::new(schema(grid)?);
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .build();
    let file = File::create(path)?;
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
    let all: Vec<(usize, Row)> = rows
        .iter()
        .enumerate()
        .filter_map(|(index, row)| row.map(|row| (index, row)))
        .collect();
    for rows in all.chunks(GROUP) {
        let mut group = writer.next_row_group()?;
        let axes: [fn([f64; 3]) -> f64; 3] = [|[x, _, _]| x, |[_, x, _]| x, |[_, _, x]| x];
        for axis in axes.into_iter().take(grid.columns().len()) {
            let values = rows.iter().map(|(index, _)| axis(grid.doubles(*index)));
            column::<DoubleType>(&mut group, &values.collect::<Vec<_>>(), None)?;
        }
        let words: [fn(&Row) -> &'static str; 2] = [|row| row.paper.name(), |row| row.exact.name()];
        for word in words {
            let texts: Vec<ByteArray> = rows.iter().map(|(_, row)| word(row).into()).collect();
            column::<ByteArrayType>(&mut group, &texts, None)?;
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
        column::<Int64Type>(&mut group, &there, Some(&levels))?;
        let states: [fn(&Row) -> f64; 2] = [|row| row.xi, |row| row.velocity];
        for state in states {
            let values: Vec<f64> = rows.iter().map(|(_, row)| state(row)).collect();
            column::<DoubleType>(&mut group, &values, None)?;
        }
        group.close()?;
    }
    writer.into_inner()?.sync_all()?;
    Ok(())
}

fn column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, File>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let missing = || ParquetError::General("a column too few".to_owned());
    let mut column = group.next_column()?.ok_or_else(missing)?;
    column.typed::<T>().write_batch(values, levels, None)?;
    column.close()
}

/// Reads a file of [`write`]; the reason in words when it is none.
pub(super) fn read(path: &Path, grid: &Grid) -> Result<Vec<Found>, String> {
    // The library asserts on some corrupt files: that is an error like any other.
    let reading = AssertUnwindSafe(|| rows_of(path, grid).map_err(|error| error.to_string()));
    catch_unwind(reading).unwrap_or_else(|_| Err("its contents contradict each other".to_owned()))
}

fn rows_of(path: &Path, grid: &Grid) -> Result<Vec<Found>, ParquetError> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let found = reader.metadata().file_metadata().schema();
    if *found != schema(grid)? {
        let message = "its columns are not those of a sweep";
        return Err(ParquetError::General(message.to_owned()));
    }
    let word = |text: &str| ParquetError::General(format!("`{text}` is no outcome"));
    let mut rows = Vec::new();
    for row in reader.get_row_iter(None)? {
        let row = row?;
        let axes = grid.columns().len();
        let (paper, exact) = (row.get_string(axes)?, row.get_string(axes + 1)?);
        let mut values = [0.0; 3];
        for (i, value) in values.iter_mut().enumerate().take(axes) {
            *value = row.get_double(i)?;
        }
        let at_interval = match row.get_long(axes + 2) {
            Ok(h) => Some(u64::try_from(h).map_err(|_| word(&h.to_string()))?),
            Err(_) => None, // null
        };
        let outcome = Row {
            paper: PaperOutcome::named(paper).ok_or_else(|| word(paper))?,
            exact: ExactOutcome::named(exact).ok_or_else(|| word(exact))?,
            at_interval,
            xi: row.get_double(axes + 3)?,
            velocity: row.get_double(axes + 4)?,
        };
        rows.push((values, outcome));
    }
    Ok(rows)
}
