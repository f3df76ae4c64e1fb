//! Files that are no CSV, and CSV with more than a header and rows: what they are, and how they are made readable.

use passivity_scene::{Motion, Scene};

use crate::log::columns::{quoted, same_unit};
use crate::log::csv::{self, Notation};
use crate::log::error::{TraceError, shown};
use crate::log::header::{is_unit, split};

/// How files start that are of a format that is not read, what they are, and what to do.
const FORMATS: [(&[u8], &str, &str); 15] = [
    (
        b"\xfd7zXZ",
        "compressed by xz",
        "decompress it with `xz -d`",
    ),
    (
        b"BZh",
        "compressed by bzip2",
        "decompress it with `bzip2 -d`",
    ),
    (
        b"\x04\x22\x4d\x18",
        "compressed by lz4",
        "decompress it with `lz4 -d`",
    ),
    (
        b"PK\x03\x04",
        "a ZIP archive, as Excel's and NumPy's files are",
        "unpack it, or save the table as CSV",
    ),
    (b"7z\xbc\xaf", "a 7z archive", "unpack it"),
    (b"\x89HDF", "HDF5, as MATLAB's newer files are", WRITE),
    (
        b"MATLAB ",
        "a MATLAB file",
        "write the table as CSV with `writetable`",
    ),
    (b"ARROW1", "of Arrow, as Feather is", WRITE),
    (b"FEA1", "Feather", WRITE),
    (b"\x93NUMPY", "a NumPy array", WRITE),
    (
        b"SQLite format 3",
        "SQLite, as ROS 2 bags of the type sqlite3 are",
        "convert a bag to MCAP with `ros2 bag convert`",
    ),
    (
        b"#ROSBAG V",
        "a ROS 1 bag",
        "convert it to MCAP with `mcap convert`",
    ),
    (b"{\"", "JSON", WRITE),
    (b"\xff\xfe", UTF_16, ICONV),
    (b"\xfe\xff", UTF_16, ICONV),
];

const WRITE: &str = "write the table as CSV or Parquet";
const UTF_16: &str = "text in UTF-16";
const ICONV: &str = "convert it with `iconv -f UTF-16 -t UTF-8`";

/// Refuses a file that starts as one of a format that is not read.
pub(super) fn is_read(start: &[u8]) -> Result<(), TraceError> {
    let is_it = |(magic, ..): &&(&[u8], &str, &str)| start.starts_with(magic);
    // Of text in UTF-16 without a mark at its start every second byte is zero.
    let is_zero = |at: usize| start.iter().skip(at).step_by(2).all(|byte| *byte == 0);
    let unmarked = match [is_zero(0), is_zero(1)] {
        [true, false] => Some((
            &b""[..],
            UTF_16,
            "convert it with `iconv -f UTF-16BE -t UTF-8`",
        )),
        [false, true] => Some((
            &b""[..],
            UTF_16,
            "convert it with `iconv -f UTF-16LE -t UTF-8`",
        )),
        _ => None,
    };
    let unmarked = unmarked.filter(|_| start.len() > 2);
    match FORMATS.iter().find(is_it).or(unmarked.as_ref()) {
        Some((_, what, remedy)) => {
            let message = format!("the file is {what}, which is not read: {remedy}");
            Err(TraceError::new("format", message))
        }
        None => Ok(()),
    }
}

/// What stands in the way of a header that is not understood, where the first lines tell.
pub(super) fn obstacle(
    line: &[u8],
    first: &[&[u8]],
    notation: Notation,
    scene: &Scene,
) -> Option<String> {
    let names = csv::texts(line, notation);
    let is_number = |text: &String| csv::is_number(text.as_bytes(), notation);
    let numbers = names.iter().filter(|name| is_number(name)).count();
    if 2 * numbers >= names.len() && numbers > 0 {
        let rows: Vec<&[u8]> = [line].into_iter().chain(first.iter().copied()).collect();
        return Some(nameless(&rows, notation, scene));
    }
    let first = csv::texts(first.first()?, notation);
    // A row may end with what stands between fields.
    let (filled, end) = match first.split_last() {
        Some((last, rest)) if last.is_empty() => (
            rest,
            ", the last of which is empty: take away what stands at the end of the rows, or write it behind the names, too",
        ),
        _ => (&first[..], ""),
    };
    let differ = names.len() != first.len() && !filled.is_empty() && filled.iter().all(is_number);
    differ.then(|| {
        let more = csv::surplus(names.iter(), first.len());
        let (names, row) = (names.len(), first.len());
        format!(
            "the names of the columns, `{}`, are {names}, but the first row has {row} fields{end}{more}",
            shown(line)
        )
    })
}

/// What is said of rows without names, with names that they may have, written as the rows are.
fn nameless(rows: &[&[u8]], notation: Notation, scene: &Scene) -> String {
    let width = csv::texts(rows.first().copied().unwrap_or_default(), notation).len();
    // Nothing says which of them is which.
    let names: Vec<String> = (1..=width).map(|n| format!("column{n}")).collect();
    let [time, position, force] = match scene.motion {
        Motion::Dimensionless => ["tau", "xi", "f"],
        Motion::Linear => ["t [s]", "x [mm]", "f [N]"],
        Motion::Rotary => ["t [s]", "x [rad]", "f [N m]"],
    };
    let count = if scene.given.has_encoder() {
        "`count` or "
    } else {
        ""
    };
    let (delimiter, tabs) = match notation.delimiter {
        b'\t' => ("\\t".to_owned(), " (each `\\t` is a tab)"),
        other => (char::from(other).to_string(), ""),
    };
    format!(
        "the first line holds numbers, not names: write a line before it with a name for each column, as `{}`{tabs}, and in place \
         of three of these names `{time}` for the column with the times, {count}`{position}` for that with the positions and \
         `{force}` for that with the forces, in the units of their numbers, and read it{}",
        names.join(&delimiter),
        match notation.with_options() {
            options if options.is_empty() => " again".to_owned(),
            options => options.replacen(',', "", 1),
        }
    )
}

/// The names of the columns with the units that stand in a line of their own after them: `time [s]`. `None` where that
/// line is something else.
pub(super) fn with_units(
    line: &[u8],
    first: &[&[u8]],
    notation: Notation,
) -> Result<Option<Vec<u8>>, TraceError> {
    let [Some(units), Some(next)] = [first.first(), first.get(1)] else {
        return Ok(None);
    };
    let names = csv::texts(line, notation);
    let (units, next) = (csv::units(units, notation), csv::texts(next, notation));
    let is_number = |text: &String| csv::is_number(text.as_bytes(), notation);
    // What has no unit may have anything there but a number.
    let are_units = units.len() == names.len()
        && units.iter().any(|text| is_unit(text))
        && !units.iter().any(|text| is_number(text) && text != "1")
        && next.iter().any(is_number);
    if !are_units {
        return Ok(None);
    }
    let with = |(name, unit): (&String, &String)| {
        let own = split(name).ok().and_then(|split| split.unit);
        match own {
            Some(own) if is_unit(unit) && !same_unit(&own, unit) => {
                let message =
                    format!("its name has the unit `{own}`, and the line after it `{unit}`");
                Err(TraceError::new("unit", message).column(name))
            }
            Some(_) => Ok(quoted(name)),
            None if matches!(&**unit, "" | "-" | "1") || unit.contains(['[', ']']) => {
                Ok(quoted(name))
            }
            None => Ok(quoted(&format!("{name} [{unit}]"))),
        }
    };
    let named: Result<Vec<String>, TraceError> = names.iter().zip(&units).map(with).collect();
    let delimiter = char::from(notation.delimiter).to_string();
    Ok(Some(named?.join(&delimiter).into_bytes()))
}

/// Whether a line has names, and those after it the rows of several columns, perhaps after a line of units: most fields of a
/// row are numbers or dates.
pub(super) fn is_header(line: &[u8], rows: &[&[u8]], notation: Notation) -> bool {
    let names = csv::texts(line, notation);
    let number = |text: &String| csv::is_number_or_date(text.as_bytes(), notation);
    let is_name = |text: &String| !number(text) && text.contains(char::is_alphabetic);
    // A name may be that of no field, and a row may end with what stands between fields. What starts with a word is a line
    // about a file, as `X0,0.0,0.0`.
    let is_row = |row: &[u8]| {
        let fields = csv::texts(row, notation);
        let numbers = fields.iter().filter(|text| number(text)).count();
        let is_as_wide = fields.len() > 1 && fields.len().abs_diff(names.len()) < 2;
        2 * numbers > fields.len() && is_as_wide && fields.first().is_some_and(number)
    };
    let named = names.iter().filter(|text| is_name(text)).count();
    let is_named = named > 1 && !names.iter().any(number);
    let rows = match rows.split_first() {
        Some((units, rows))
            if !is_row(units) && csv::texts(units, notation).len() == names.len() =>
        {
            rows
        }
        _ => rows,
    };
    is_named && !rows.is_empty() && rows.iter().take(2).all(|row| is_row(row))
}

/// Whether a header and most of the first rows have equally many fields.
pub(super) fn is_even(line: &[u8], first: &[&[u8]], notation: Notation) -> bool {
    let width = csv::texts(line, notation).len();
    let is_as_wide = |row: &&&[u8]| csv::texts(row, notation).len() == width;
    2 * first.iter().filter(is_as_wide).count() >= first.len()
}

/// Whether they are a table of several columns.
pub(super) fn is_table(line: &[u8], first: &[&[u8]], notation: Notation) -> bool {
    let width = csv::texts(line, notation).len();
    width > 1 && !first.is_empty() && is_even(line, first, notation)
}
