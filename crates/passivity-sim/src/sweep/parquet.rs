//! A finished sweep as Parquet: the columns of the CSV, `at_interval` null where there is none.

use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::record::RowAccessor as _;
use parquet::schema::parser::parse_message_type;

use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::sweep::grid::Grid;
use crate::sweep::row::{Found, Row};

/// The columns, in the order of the CSV.
const SCHEMA: &str = "message sweep {
    required double beta;
    required double sigma;
    required double speed;
    required binary paper (UTF8);
    required binary exact (UTF8);
    optional int64 at_interval;
    required double xi;
    required double velocity;
}";

/// Rows that are encoded at once.
const GROUP: usize = 1 << 18;

/// Writes the rows that are there, in the order of the grid, and has them reach the disk.
pub(super) fn write(path: &Path, grid: &Grid, rows: &[Option<Row>]) -> Result<(), ParquetError> {
    let schema = Arc::new(parse_message_type(SCHEMA)?);
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
        for axis in axes {
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
pub(super) fn read(path: &Path) -> Result<Vec<Found>, String> {
    // The library asserts on some corrupt files: that is an error like any other.
    let reading = AssertUnwindSafe(|| rows_of(path).map_err(|error| error.to_string()));
    catch_unwind(reading).unwrap_or_else(|_| Err("its contents contradict each other".to_owned()))
}

fn rows_of(path: &Path) -> Result<Vec<Found>, ParquetError> {
    let reader = SerializedFileReader::new(File::open(path)?)?;
    let found = reader.metadata().file_metadata().schema();
    if *found != parse_message_type(SCHEMA)? {
        let message = "its columns are not those of a sweep";
        return Err(ParquetError::General(message.to_owned()));
    }
    let word = |text: &str| ParquetError::General(format!("`{text}` is no outcome"));
    let mut rows = Vec::new();
    for row in reader.get_row_iter(None)? {
        let row = row?;
        let (paper, exact) = (row.get_string(3)?, row.get_string(4)?);
        let values = [row.get_double(0)?, row.get_double(1)?, row.get_double(2)?];
        let at_interval = match row.get_long(5) {
            Ok(h) => Some(u64::try_from(h).map_err(|_| word(&h.to_string()))?),
            Err(_) => None, // null
        };
        let outcome = Row {
            paper: PaperOutcome::named(paper).ok_or_else(|| word(paper))?,
            exact: ExactOutcome::named(exact).ok_or_else(|| word(exact))?,
            at_interval,
            xi: row.get_double(6)?,
            velocity: row.get_double(7)?,
        };
        rows.push((values, outcome));
    }
    Ok(rows)
}
