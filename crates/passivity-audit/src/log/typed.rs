//! The values of a Parquet column by its type: what it says is honoured, or the column is refused.

use num_bigint::BigInt;
use parquet::basic::{ConvertedType, LogicalType, TimeUnit, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{DataType, Int96};
use parquet::errors::ParquetError;
use parquet::schema::types::ColumnDescriptor;
use passivity_core::BigRational;

use crate::log::arrays::{DOUBLE, EXACT, SINGLE, count};
use crate::log::digits::{Place, Seen, half_a_unit};
use crate::log::error::{self, TraceError};
use crate::log::layout::Layout;
use crate::log::numbers::Numbers;
use crate::number::Number;

/// The largest power of ten by which decimals are divided.
const MAX_SCALE: i32 = 1000;

pub(crate) fn broken(error: &ParquetError) -> TraceError {
    TraceError::new("parquet", format!("cannot be read as Parquet: {error}"))
}

/// What the stored values mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    /// As they are stored.
    Plain,
    /// Whole numbers without a sign.
    Unsigned,
    /// Whole numbers over a power of ten.
    Decimal(i32),
    /// Times in a unit.
    Time(&'static str),
    /// A number as text.
    Text,
}

impl Meaning {
    /// Of a column's type; an error where its values are no numbers.
    pub(crate) fn of(column: &ColumnDescriptor) -> Result<Self, TraceError> {
        if column.max_rep_level() > 0 {
            let message = "expected numbers, found lists";
            return Err(TraceError::new("type", message));
        }
        let physical = column.physical_type();
        let meaning = match column.logical_type_ref() {
            // What older programs store is a day and the nanoseconds in it.
            _ if physical == Physical::INT96 => Some(Self::Time("ns")),
            Some(logical) => Self::of_logical(logical),
            None => Self::of_converted(column.converted_type(), physical),
        };
        let scale = column.type_scale();
        let fits = match (meaning, physical) {
            (Some(Self::Decimal(_)), _) if !(0..=MAX_SCALE).contains(&scale) => false,
            (Some(Self::Decimal(_)), Physical::INT32 | Physical::INT64) => true,
            (Some(Self::Decimal(_)), Physical::BYTE_ARRAY | Physical::FIXED_LEN_BYTE_ARRAY) => true,
            (Some(Self::Unsigned | Self::Time(_)), Physical::INT32 | Physical::INT64) => true,
            (Some(Self::Time(_)), Physical::INT96) => true,
            (Some(Self::Text), Physical::BYTE_ARRAY) => true,
            (Some(Self::Plain), Physical::INT32 | Physical::INT64) => true,
            (Some(Self::Plain), Physical::FLOAT | Physical::DOUBLE) => true,
            _ => false,
        };
        match meaning {
            Some(Self::Decimal(_)) if fits => Ok(Self::Decimal(scale)),
            Some(meaning) if fits => Ok(meaning),
            _ => {
                let logical = column.logical_type_ref();
                let of = match (logical, column.converted_type()) {
                    (Some(logical), _) => format!(" of the logical type {logical:?}"),
                    (None, ConvertedType::NONE) => String::new(),
                    (None, converted) => format!(" of the converted type {converted}"),
                };
                let message = format!("expected numbers, found {physical}{of}");
                Err(TraceError::new("type", message))
            }
        }
    }

    fn of_logical(logical: &LogicalType) -> Option<Self> {
        let unit = |unit: &TimeUnit| match unit {
            TimeUnit::MILLIS => "ms",
            TimeUnit::MICROS => "us",
            TimeUnit::NANOS => "ns",
        };
        match logical {
            LogicalType::Integer(integer) if integer.is_signed => Some(Self::Plain),
            LogicalType::Integer(_) => Some(Self::Unsigned),
            LogicalType::Decimal(_) => Some(Self::Decimal(0)),
            LogicalType::Time(time) => Some(Self::Time(unit(&time.unit))),
            LogicalType::Timestamp(time) => Some(Self::Time(unit(&time.unit))),
            LogicalType::String | LogicalType::Enum => Some(Self::Text),
            _ => None,
        }
    }

    fn of_converted(converted: ConvertedType, physical: Physical) -> Option<Self> {
        match converted {
            // Bytes without a type are text in many files.
            ConvertedType::NONE if physical == Physical::BYTE_ARRAY => Some(Self::Text),
            ConvertedType::NONE
            | ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64 => Some(Self::Plain),
            ConvertedType::UINT_8
            | ConvertedType::UINT_16
            | ConvertedType::UINT_32
            | ConvertedType::UINT_64 => Some(Self::Unsigned),
            ConvertedType::DECIMAL => Some(Self::Decimal(0)),
            ConvertedType::TIME_MILLIS | ConvertedType::TIMESTAMP_MILLIS => Some(Self::Time("ms")),
            ConvertedType::TIME_MICROS | ConvertedType::TIMESTAMP_MICROS => Some(Self::Time("us")),
            ConvertedType::UTF8 | ConvertedType::ENUM => Some(Self::Text),
            _ => None,
        }
    }

    /// The unit that the type gives.
    pub(crate) const fn unit(self) -> Option<&'static str> {
        match self {
            Self::Time(unit) => Some(unit),
            _ => None,
        }
    }

    /// A stored whole number of `bits` as what it means.
    fn whole(self, n: i64, bits: u32) -> Number {
        match self {
            Self::Unsigned if n < 0 => {
                let turned = i128::from(n) + (1_i128 << bits);
                match i64::try_from(turned) {
                    Ok(n) => Number::whole(n),
                    Err(_) => BigRational::from_integer(turned.into()).into(),
                }
            }
            Self::Decimal(scale) => over_ten(n.into(), scale),
            _ => Number::whole(n),
        }
    }
}

/// n/10^scale.
fn over_ten(n: BigInt, scale: i32) -> Number {
    let ten = BigInt::from(10);
    let power = num_traits::Pow::pow(&ten, scale.unsigned_abs());
    BigRational::new(n, power).into()
}

/// The nanoseconds since 1970 of a day of the Julian calendar and the nanoseconds in it.
fn since_1970(moment: &Int96) -> Number {
    const EPOCH: i128 = 2_440_588;
    const DAY: i128 = 86_400_000_000_000;
    let [low, high, day] = match moment.data() {
        [low, high, day] => [*low, *high, *day].map(i128::from),
        _ => [0; 3],
    };
    let nanoseconds = (day - EPOCH) * DAY + (high << 32) + low;
    match i64::try_from(nanoseconds) {
        Ok(nanoseconds) => Number::whole(nanoseconds),
        Err(_) => BigRational::from_integer(nanoseconds.into()).into(),
    }
}

/// The values of a column up to the first that is wrong.
pub(crate) struct Column<T> {
    pub(crate) values: Vec<T>,
    pub(crate) error: Option<TraceError>,
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
    let (mut values, mut levels) = (Vec::with_capacity(rows), Vec::with_capacity(rows));
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
    if values.len() < records {
        // Some rows have no value. A column that requires them has no levels.
        let most = levels.iter().copied().max().unwrap_or(0).max(1);
        let first = levels.iter().position(|level| *level < most);
        values.truncate(first.unwrap_or(0));
        error = Some(TraceError::new("missing", "expected a value, found none"));
    }
    Column { values, error }
}

/// Goes over `rows` values of a column.
pub(crate) fn skip(reader: &mut ColumnReader, rows: usize) -> Result<(), TraceError> {
    let skipped = match reader {
        ColumnReader::BoolColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::Int32ColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::Int64ColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::Int96ColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::FloatColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::DoubleColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::ByteArrayColumnReader(reader) => reader.skip_records(rows),
        ColumnReader::FixedLenByteArrayColumnReader(reader) => reader.skip_records(rows),
    };
    match skipped {
        Ok(skipped) if skipped == rows => Ok(()),
        Ok(skipped) => {
            let message = format!("the column ends after {skipped} of {rows} rows");
            Err(TraceError::new("parquet", message))
        }
        Err(error) => Err(broken(&error)),
    }
}

/// The counts of a column.
pub(crate) fn counts(meaning: Meaning, reader: &mut ColumnReader, rows: usize) -> Column<i64> {
    match (reader, meaning) {
        (ColumnReader::Int64ColumnReader(reader), Meaning::Plain) => values(reader, rows),
        (ColumnReader::Int32ColumnReader(reader), Meaning::Plain) => {
            values(reader, rows).map(|n| Ok(i64::from(n)))
        }
        (reader, meaning) => {
            let bits = match reader {
                ColumnReader::DoubleColumnReader(_) => DOUBLE,
                ColumnReader::FloatColumnReader(_) => SINGLE,
                _ => EXACT,
            };
            numbers(meaning, reader, rows).map(|x| count(&x, bits))
        }
    }
}

/// The numbers of a column up to the first that is wrong, and what is wrong with it.
pub(crate) fn column(
    meaning: Meaning,
    reader: &mut ColumnReader,
    rows: usize,
) -> (Numbers, Option<TraceError>) {
    match (&mut *reader, meaning) {
        (ColumnReader::DoubleColumnReader(reader), Meaning::Plain) => {
            let read = values(reader, rows);
            let (numbers, error) = Numbers::doubles(read.values);
            (numbers, error.or(read.error))
        }
        (ColumnReader::FloatColumnReader(reader), Meaning::Plain) => {
            let read = values(reader, rows);
            let doubles = read.values.into_iter().map(f64::from);
            let (numbers, error) = Numbers::doubles(doubles.collect());
            (numbers, error.or(read.error))
        }
        (ColumnReader::Int64ColumnReader(reader), Meaning::Plain | Meaning::Time(_)) => {
            let read = values(reader, rows);
            (Numbers::whole(read.values), read.error)
        }
        (ColumnReader::Int32ColumnReader(reader), Meaning::Plain | Meaning::Time(_)) => {
            let read = values(reader, rows);
            let wide = read.values.into_iter().map(i64::from);
            (Numbers::whole(wide.collect()), read.error)
        }
        (reader, meaning) => {
            let read = numbers(meaning, reader, rows);
            (read.values.into(), read.error)
        }
    }
}

/// The numbers of a column.
pub(crate) fn numbers(meaning: Meaning, reader: &mut ColumnReader, rows: usize) -> Column<Number> {
    let double = |x: f64| {
        Number::from_f64(x)
            .ok_or_else(|| TraceError::new("not_finite", format!("expected a number, found {x}")))
    };
    let of_bytes = |bytes: &[u8]| match meaning {
        Meaning::Decimal(scale) => bounded(over_ten(BigInt::from_signed_bytes_be(bytes), scale)),
        _ => spelled(bytes),
    };
    match reader {
        ColumnReader::Int64ColumnReader(reader) => {
            values(reader, rows).map(|n| Ok(meaning.whole(n, 64)))
        }
        ColumnReader::Int32ColumnReader(reader) => {
            values(reader, rows).map(|n| Ok(meaning.whole(n.into(), 32)))
        }
        ColumnReader::DoubleColumnReader(reader) => values(reader, rows).map(double),
        ColumnReader::FloatColumnReader(reader) => values(reader, rows).map(|x| double(x.into())),
        ColumnReader::ByteArrayColumnReader(reader) => {
            values(reader, rows).map(|bytes| of_bytes(bytes.data()))
        }
        ColumnReader::FixedLenByteArrayColumnReader(reader) => {
            values(reader, rows).map(|bytes| of_bytes(bytes.data()))
        }
        ColumnReader::Int96ColumnReader(reader) => {
            values(reader, rows).map(|moment| Ok(since_1970(&moment)))
        }
        ColumnReader::BoolColumnReader(_) => {
            Column::wrong(TraceError::new("type", "expected numbers"))
        }
    }
}

/// The forces of a column, and half a unit of the last digit of each, in KΔ, as in CSV: of whole numbers and decimals as
/// their types say. Doubles have no last digit.
pub(crate) fn forces(
    meaning: Meaning,
    reader: &mut ColumnReader,
    rows: usize,
    layout: &Layout,
) -> (Numbers, Vec<f64>, Option<TraceError>) {
    let half = match (&mut *reader, meaning) {
        (ColumnReader::ByteArrayColumnReader(reader), Meaning::Text) => {
            let read = values(reader, rows).map(|text| {
                let place = Place::read(text.data());
                let half = place.map_or(0.0, |place| layout.digits.half_a_unit(place));
                Ok((spelled(text.data())?, half * layout.size_of_force))
            });
            let (numbers, halves): (Vec<Number>, _) = read.values.into_iter().unzip();
            return (numbers.into(), halves, read.error);
        }
        (_, Meaning::Decimal(scale)) => half_a_unit(scale),
        (ColumnReader::Int32ColumnReader(_) | ColumnReader::Int64ColumnReader(_), _) => {
            half_a_unit(0)
        }
        _ => 0.0,
    };
    let (numbers, error) = column(meaning, reader, rows);
    let halves = vec![half * layout.size_of_force; numbers.len()];
    (numbers, halves, error)
}

/// Looks at the digits of `rows` texts.
pub(crate) fn see(
    reader: &mut ColumnReader,
    mut rows: usize,
    seen: &mut Seen,
) -> Result<(), TraceError> {
    /// How many are read at once.
    const SOME: usize = 1 << 10;
    let ColumnReader::ByteArrayColumnReader(reader) = reader else {
        return Ok(());
    };
    while rows > 0 && !seen.is_done() {
        let some = rows.min(SOME);
        let read = values(reader, some);
        for text in &read.values {
            // As in a line of its own.
            seen.see(text.len() + 1, Place::read(text.data()));
        }
        read.error.map_or(Ok(()), Err)?;
        rows -= some;
    }
    Ok(())
}

/// The number that a text spells.
fn spelled(text: &[u8]) -> Result<Number, TraceError> {
    match std::str::from_utf8(text) {
        Ok(literal) => error::number(literal),
        Err(_) => Err(TraceError::new("number", "not UTF-8 text")),
    }
}

fn bounded(number: Number) -> Result<Number, TraceError> {
    if number.is_bounded() {
        return Ok(number);
    }
    let message = format!("a number of more than {} bits", crate::number::MAX_BITS);
    Err(TraceError::new("number_too_long", message))
}
