//! What the first lines of a CSV file say: the names of its columns, and of what kind their values are.

use super::{Notation, fields, moment, number, trimmed};
use crate::log::dates;
use crate::log::digits::Place;
use crate::log::error::{TraceError, legible};
use crate::log::header::Heading;
use crate::log::layout::Layout;
use crate::log::lines::CARRIAGE_RETURNS;
use crate::log::preview::Preview;
use crate::log::running::near_number;

/// What is said of text in another encoding.
const NO_UTF_8: &str = "the header is not UTF-8 text: convert the log, as with `iconv -f WINDOWS-1252 -t UTF-8 log.csv > \
    log-utf8.csv` where Excel wrote it";

/// The fields of a line, without their quotes; one that is written twice in them is one.
pub(crate) fn texts(line: &[u8], notation: Notation) -> Vec<String> {
    united(line, notation, |word| word.starts_with(['[', '(']))
}

/// Those of a line of units, without the brackets in which they stand.
pub(crate) fn units(line: &[u8], notation: Notation) -> Vec<String> {
    let units = united(line, notation, |_| false);
    let bare = |unit: String| {
        let pairs = [('[', ']'), ('(', ')')];
        let mut inner = pairs.iter().filter_map(|(open, close)| {
            let inner = unit.strip_prefix(*open)?.strip_suffix(*close)?;
            Some(inner.trim().to_owned())
        });
        inner.next().unwrap_or(unit)
    };
    units.into_iter().map(bare).collect()
}

/// The fields of a line. Where they stand apart by spaces, what has some within brackets is one of them, and so is one with the
/// next that `goes_on` with it: `t [s] f [N m]`.
fn united(line: &[u8], notation: Notation, goes_on: impl Fn(&str) -> bool) -> Vec<String> {
    let text = |field: &[u8]| {
        let text = String::from_utf8_lossy(trimmed(field)).trim().to_owned();
        match trimmed(field).len() < field.trim_ascii().len() {
            true => text.replace("\"\"", "\""),
            false => text,
        }
    };
    let texts = fields(line, notation.delimiter).map(text);
    if notation.delimiter != b' ' {
        return texts.collect();
    }
    let is_open = |name: &String| {
        let open = name.rfind(['[', '(']);
        open.is_some_and(|at| !name.get(at..).is_some_and(|rest| rest.contains([']', ')'])))
    };
    let mut names: Vec<String> = Vec::new();
    for word in texts {
        match names.last_mut() {
            Some(name) if goes_on(&word) || is_open(name) => *name = format!("{name} {word}"),
            _ => names.push(word),
        }
    }
    names
}

/// Whether a field is a number.
pub(crate) fn is_number(field: &[u8], notation: Notation) -> bool {
    value(field, notation).is_some()
}

/// The same, or a date with a time of day.
pub(crate) fn is_number_or_date(field: &[u8], notation: Notation) -> bool {
    is_number(field, notation) || dates::seconds(field).is_some()
}

/// What is to be done about names behind those of the fields of a row, where they are remarks or none.
pub(crate) fn surplus<'n>(
    mut names: impl ExactSizeIterator<Item = &'n String>,
    width: usize,
) -> String {
    let more = names.len().saturating_sub(width);
    let is_none = |name: &String| {
        let name = name.trim().to_lowercase();
        let remarks = ["comment", "comments", "kommentar", "remark", "note"];
        name.is_empty() || remarks.contains(&&*name)
    };
    match more > 0 && names.by_ref().skip(width).all(is_none) {
        true if more == 1 => {
            ": take the last name, with what stands before it, out of the header".to_owned()
        }
        true => {
            format!(": take the last {more} names, with what stands before each, out of the header")
        }
        false => String::new(),
    }
}

/// The fields of a header line.
pub(crate) fn names(line: &[u8], notation: Notation) -> Result<Vec<String>, TraceError> {
    let text = std::str::from_utf8(line).map_err(|_| TraceError::new("header", NO_UTF_8))?;
    if text.trim().is_empty() {
        return Err(TraceError::new(
            "header",
            "expected a header, found nothing",
        ));
    }
    if text.contains('\r') {
        return Err(TraceError::new("header", CARRIAGE_RETURNS));
    }
    // What stands between fields is ASCII, so that each of them is UTF-8 text again.
    let names = texts(text.as_bytes(), notation);
    if names
        .iter()
        .all(|name| is_number(name.as_bytes(), notation))
    {
        let message =
            "the first line holds numbers: a trace needs a header with the names of its columns";
        return Err(TraceError::new("header", message));
    }
    Ok(names)
}

/// The columns of a header line: those that hold dates in at least half of the first rows are in seconds. What is no date there
/// is an error of its row.
pub(crate) fn headings(
    line: &[u8],
    first: &[&[u8]],
    notation: Notation,
) -> Result<Vec<Heading>, TraceError> {
    let is_dated = |column| {
        let is_date = |line: &&&[u8]| {
            let field = fields(line, notation.delimiter).nth(column);
            field.is_some_and(|field| dates::seconds(trimmed(field)).is_some())
        };
        !first.is_empty() && 2 * first.iter().filter(is_date).count() >= first.len()
    };
    let heading = |(column, name)| Heading {
        name,
        unit: is_dated(column).then_some(dates::UNIT),
    };
    let names = names(line, notation)?;
    Ok(names.into_iter().enumerate().map(heading).collect())
}

/// The first rows as numbers near by.
pub(crate) fn preview(lines: &[&[u8]], headings: &[Heading], notation: Notation) -> Preview {
    let row = |line: &&[u8]| {
        let fields = fields(line, notation.delimiter).enumerate();
        let near = |(column, field)| {
            let is_dated = headings.get(column).is_some_and(Heading::is_dated);
            let moment = moment(trimmed(field), is_dated, notation).ok()?;
            Some(near_number(&moment))
        };
        fields.map(near).collect()
    };
    let lasting = |line: &&[u8]| {
        let fields = fields(line, notation.delimiter);
        fields.map(|field| dates::lasting(trimmed(field))).collect()
    };
    let of_rows =
        |row: &dyn Fn(&&[u8]) -> _| Preview::of_rows(&lines.iter().map(row).collect::<Vec<_>>());
    let lasting = of_rows(&lasting);
    let columns = 0..lasting.columns.len();
    let rows = of_rows(&row);
    let text = |column| {
        let line = lines.get(rows.no_number(column)?)?;
        let field = fields(line, notation.delimiter).nth(column)?;
        Some(String::from_utf8_lossy(trimmed(field)).trim().to_owned())
    };
    Preview {
        texts: columns.clone().map(text).collect(),
        lasting: columns.filter(|column| lasting.rises(*column)).collect(),
        delimiter: (!notation.decimal_comma).then_some(char::from(notation.delimiter)),
        ..rows
    }
}

/// Where the digits of the number in a column of a row are.
pub(crate) fn place(line: &[u8], column: usize, notation: Notation) -> Option<Place> {
    let field = fields(line, notation.delimiter).nth(column)?;
    Place::read(trimmed(field))
}

/// The double near a field that is a number.
fn value(field: &[u8], notation: Notation) -> Option<f64> {
    let number = number(field, notation).ok()?;
    Some(near_number(&number))
}

/// Whether numbers are written with a comma in some field.
pub(crate) fn has_decimal_commas(lines: &[&[u8]], delimiter: u8) -> bool {
    let comma = Notation {
        delimiter,
        decimal_comma: true,
    };
    // `1,000` may be a thousand.
    let is_sure = |field: &[u8]| {
        let mut parts = field.split(|byte| *byte == b',');
        let whole = parts.next().unwrap_or_default();
        matches!(whole, b"0" | b"-0") || parts.any(|it| it.len() != 3)
    };
    let fields = lines.iter().flat_map(|line| fields(line, delimiter));
    fields
        .map(trimmed)
        .any(|field| field.contains(&b',') && is_sure(field) && number(field, comma).is_ok())
}

/// Why the first field that would be a number if points and commas meant what they do not is none.
pub(crate) fn misread(lines: &[&[u8]], notation: Notation) -> Option<TraceError> {
    let other = Notation {
        decimal_comma: !notation.decimal_comma,
        ..notation
    };
    let fields = lines
        .iter()
        .flat_map(|line| fields(line, notation.delimiter));
    let mut errors = fields.map(trimmed).filter_map(|field| {
        let error = number(field, notation).err()?;
        number(field, other).is_ok().then_some(error)
    });
    errors.next()
}

/// What is said of a second header.
pub(super) const HEADER_AGAIN: &str = "the names of the columns stand here again: if the recording starts again here, make \
    what follows a log of its own, and else remove the line";

/// Whether a row has the names of the columns, as where a recording is started again in the same file; their units may have been
/// in a line of their own.
pub(super) fn is_header_again(line: &[u8], layout: &Layout, notation: Notation) -> bool {
    let names = texts(line, notation);
    let mut pairs = names.iter().zip(&layout.headings);
    names.len() == layout.width() && pairs.all(|(name, own)| own.name.starts_with(&**name))
}

/// What is wrong with a row that has more or fewer fields than the header has names.
pub(super) fn other_width(
    line: &[u8],
    width: usize,
    layout: &Layout,
    notation: Notation,
) -> TraceError {
    let mut message = format!("expected {} fields, found {width}", layout.width());
    if notation.decimal_comma && notation.delimiter == b',' {
        message
            .push_str(" (numbers with commas stand in quotes where fields stand apart by commas)");
    }
    let commas = Notation {
        delimiter: b';',
        decimal_comma: true,
    };
    let is_one = layout.width() == 1 && notation == Notation::default();
    if is_one && is_number(trimmed(line), commas) {
        message.push_str(&format!(
            " (if its numbers are written with a comma before the decimals, read the log{})",
            commas.with_options().replacen(',', "", 1)
        ));
    }
    message.push_str(&surplus(layout.headings.iter().map(|it| &it.name), width));
    // As one field it says nothing.
    let others = b";\t| ,".iter().filter(|_| width == 1);
    let mut others = others.map(|delimiter| Notation {
        delimiter: *delimiter,
        ..notation
    });
    if let Some(other) =
        others.find(|other| fields(line, other.delimiter).count() == layout.width())
    {
        message.push_str(&format!(
            " (its fields seem to stand apart by `{}`: write the names so, too, and read the log{})",
            legible(&char::from(other.delimiter).to_string()),
            other.with_options().replacen(',', "", 1)
        ));
    }
    TraceError::new("fields", message)
}
