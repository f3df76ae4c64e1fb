//! CSV traces: blocks of whole lines, read in order and parsed apart from each other.
//!
//! A trace is numbers and commas, or another character between them, and it can be long: fields are read
//! in place, a single column of counts without looking for fields at all. A field may stand in double
//! quotes and hold the character between fields then; none can hold a line break.

use crate::ball::Ball;
use crate::log::chunk::{Chunk, Samples};
use crate::log::dates;
use crate::log::digits::{Digits, Place};
use crate::log::error::{self, TraceError, shown};
use crate::log::header::Heading;
use crate::log::layout::{Form, Layout};
use crate::log::lines::Block;
use crate::log::running::near_number;
use crate::log::slots::Slots;
use crate::log::step::{above_zero, gap};
use crate::number::{Number, decimal, short};
use crate::reading::Reading;
use crate::shell::with_options;
use first::{HEADER_AGAIN, is_header_again, other_width};
pub(crate) use first::{
    has_decimal_commas, headings, is_number, is_number_or_date, misread, names, place, preview,
    surplus, texts, units,
};

mod first;

/// What stands between fields, and before the decimals of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Notation {
    pub(crate) delimiter: u8,
    pub(crate) decimal_comma: bool,
}

impl Notation {
    /// What is to be said of the delimiter, where it is not taken for granted.
    pub(crate) fn said_delimiter(self) -> Option<char> {
        Some(char::from(self.delimiter)).filter(|c| *c != ',' || self.decimal_comma)
    }

    /// The options with which it is read, in a sentence that ends with them.
    pub(crate) fn with_options(self) -> String {
        with_options(self.said_delimiter(), self.decimal_comma)
    }
}

impl Default for Notation {
    fn default() -> Self {
        Self {
            delimiter: b',',
            decimal_comma: false,
        }
    }
}

/// The fields of a line, in the quotes in which they stand. Between two of them there may be a run of spaces, where it is
/// spaces that stand there, and some at the ends.
fn fields(line: &[u8], delimiter: u8) -> impl Iterator<Item = &[u8]> {
    let by_spaces = delimiter == b' ';
    let mut rest = Some(if by_spaces {
        line.trim_ascii_end()
    } else {
        line
    });
    std::iter::from_fn(move || {
        let text = rest?;
        let text = if by_spaces {
            text.trim_ascii_start()
        } else {
            text
        };
        let mut end = memchr::memchr(delimiter, text);
        if text.trim_ascii_start().first() == Some(&b'"') {
            // A quote within quotes is written twice: it closes and opens them.
            let mut is_open = false;
            let outside = text.iter().position(|byte| {
                is_open ^= *byte == b'"';
                *byte == delimiter && !is_open
            });
            // Quotes that are not closed enclose nothing.
            end = if is_open { end } else { outside };
        }
        rest = end.and_then(|end| text.get(end + 1..));
        text.get(..end.unwrap_or(text.len()))
    })
}

/// Parses a block. Rows in errors are counted from 0 at the start of the block.
pub(crate) fn parse(block: &Block, layout: &Layout, notation: Notation) -> Chunk {
    let mut chunk = read(block, layout, notation);
    complete(&mut chunk, layout);
    if block.exact {
        chunk.forces.roundings.fill(0.0);
    }
    chunk
}

/// Finds out what is known of the numbers; whether that can be said of all. The chunk ends before one that cannot be
/// read.
fn complete(chunk: &mut Chunk, layout: &Layout) -> bool {
    let found = chunk.complete(layout);
    let is_complete = found.is_ok();
    if let Err((row, error)) = found {
        chunk.truncate(row);
        chunk.unended = false;
        chunk.error = Some(error.row(row as u64));
    }
    is_complete
}

/// Reads the rows of a block.
fn read(block: &Block, layout: &Layout, notation: Notation) -> Chunk {
    let mut chunk = Chunk::new(layout);
    let bytes = &block.bytes[..];
    let plain = layout.form == Form::Count && layout.width() == 1;
    let mut counts = Vec::new();
    let done = match plain {
        true => parse_counts(bytes, &mut counts),
        false => 0,
    };
    if layout.form == Form::Count {
        chunk.samples = Samples::Counts(counts);
    }
    // The rest, if anything: other columns, and lines that are not plain counts.
    let mut rest = bytes.get(done..).unwrap_or_default();
    let mut blank: Option<u64> = None;
    let slots = Slots::of(layout, notation);
    if slots.is_some() {
        chunk.reserve(rest, layout);
    }
    while !rest.is_empty() {
        if let (None, Some(slots)) = (blank, &slots)
            && let Some(length) = slots.push(rest, layout, &mut chunk)
        {
            rest = rest.get(length..).unwrap_or_default();
            continue;
        }
        let (line, after) = match memchr::memchr(b'\n', rest) {
            Some(end) => (rest.get(..end), rest.get(end + 1..)),
            None => (Some(rest), None),
        };
        let line = line.unwrap_or_default();
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        let torn = after.is_none();
        rest = after.unwrap_or_default();
        if !complete(&mut chunk, layout) {
            return chunk;
        }
        let row = count(&chunk);
        if line.iter().all(u8::is_ascii_whitespace) {
            // Blank lines may stand at the end only.
            blank.get_or_insert(row);
            continue;
        }
        let result = match blank {
            Some(_) => Err(TraceError::new(
                "blank_row",
                "expected a row, found a blank line",
            )),
            None => push(line, layout, notation, &mut chunk),
        };
        chunk.unended = torn && result.is_ok();
        if let Err(mut error) = result {
            if is_header_again(line, layout, notation) {
                error = TraceError::new("header", HEADER_AGAIN);
            }
            if torn && error.kind != "blank_row" {
                error
                    .message
                    .push_str(" (the last line has no line break: it may be incomplete)");
            }
            chunk.error = Some(error.row(row));
            return chunk;
        }
    }
    let end = count(&chunk);
    if let (Some(row), false) = (blank, block.last) {
        let error = TraceError::new("blank_row", "expected a row, found a blank line");
        chunk.error = Some(error.row(row));
    } else if let Some(error) = &block.error {
        chunk.error = Some(error.clone().row(end));
    }
    chunk
}

fn count(chunk: &Chunk) -> u64 {
    u64::try_from(chunk.samples.len()).unwrap_or(u64::MAX)
}

/// Reads lines that are nothing but a count; gives how many bytes were.
fn parse_counts(bytes: &[u8], counts: &mut Vec<i64>) -> usize {
    counts.reserve(bytes.len() / 6);
    let mut done = 0;
    let mut rest = bytes.iter();
    loop {
        let (mut value, mut digits, mut negative) = (0_i64, 0_u32, false);
        loop {
            match rest.next() {
                Some(byte @ b'0'..=b'9') => {
                    value = value.wrapping_mul(10).wrapping_add(i64::from(byte - b'0'));
                    digits += 1;
                }
                Some(b'-') if digits == 0 && !negative => negative = true,
                Some(b'\r') if rest.as_slice().first() == Some(&b'\n') => {}
                Some(b'\n') if digits > 0 && digits <= 18 => break,
                // The end, or a line for the careful parser.
                _ => return done,
            }
        }
        counts.push(if negative { -value } else { value });
        done = bytes.len() - rest.as_slice().len();
    }
}

/// Appends a row.
fn push(
    line: &[u8],
    layout: &Layout,
    notation: Notation,
    chunk: &mut Chunk,
) -> Result<(), TraceError> {
    let (mut position, mut end, mut dtau) = (None, None, None);
    let (mut time, mut fine, mut force, mut velocity) = (None, None, None, None);
    let mut width = 0;
    for (i, field) in fields(line, notation.delimiter).enumerate() {
        width += 1;
        let slot = match i {
            _ if i == layout.position => &mut position,
            _ if Some(i) == layout.end => &mut end,
            _ if Some(i) == layout.dtau => &mut dtau,
            _ if Some(i) == layout.time => &mut time,
            _ if Some(i) == layout.fine_column() => &mut fine,
            _ if Some(i) == layout.force => &mut force,
            _ if Some(i) == layout.velocity => &mut velocity,
            _ => continue,
        };
        *slot = Some(trimmed(field));
    }
    if width != layout.width() {
        return Err(other_width(line, width, layout, notation));
    }
    let number_in = |field: Option<&[u8]>, column: usize| {
        number(field.unwrap_or_default(), notation)
            .map_err(|error| error.column(layout.name(column)))
    };
    let named = |error: TraceError| error.column(layout.name(layout.position));
    let position = position.unwrap_or_default();
    // Nothing is appended before the whole row is read.
    enum Sample {
        Count(i64),
        Any(Number, Ball),
    }
    let sample = match &chunk.samples {
        Samples::Counts(_) => Sample::Count(whole(position, notation).map_err(named)?),
        Samples::Any(samples) => {
            let x = number(position, notation).map_err(named)?;
            let (x, near) = samples.known(x).map_err(named)?;
            Sample::Any(x, near)
        }
    };
    let closing = match layout.end {
        Some(column) => Some(Reading::Exact(number_in(end, column)?)),
        None => None,
    };
    let dtau = match layout.dtau {
        Some(column) => {
            let lasts = above_zero(number_in(dtau, column)?);
            Some(lasts.map_err(|error| error.column(layout.name(column)))?)
        }
        None => None,
    };
    let time = match layout.time {
        Some(column) => {
            let is_dated = layout.headings.get(column).is_some_and(Heading::is_dated);
            let moment = moment(time.unwrap_or_default(), is_dated, notation);
            Some(moment.map_err(|error| error.column(layout.name(column)))?)
        }
        None => None,
    };
    let time = match (time, &layout.fine) {
        (Some(whole), Some(part)) => {
            let moment = part.moment(&whole, &number_in(fine, part.column)?);
            Some(moment.map_err(|error| error.column(layout.name(part.column)))?)
        }
        (time, _) => time,
    };
    let force = match layout.force {
        Some(column) => {
            let (number, rounding) = rounded(force.unwrap_or_default(), notation, layout.digits)
                .map_err(|error| error.column(layout.name(column)))?;
            let known = chunk.forces.values.known(number);
            let known = known.map_err(|error| error.column(layout.name(column)))?;
            Some((known, rounding * layout.size_of_force))
        }
        None => None,
    };
    let velocity = match layout.velocity {
        Some(column) => Some(near_number(&number_in(velocity, column)?)),
        None => None,
    };
    if let (Some(Reading::Exact(before)), true, Sample::Any(x, _)) =
        (&chunk.closing, closing.is_some(), &sample)
        && before != x
    {
        return Err(gap(layout));
    }
    match (&mut chunk.samples, sample) {
        (Samples::Counts(counts), Sample::Count(n)) => counts.push(n),
        (Samples::Any(samples), Sample::Any(x, near)) => samples.push((x, near)),
        (Samples::Counts(_), Sample::Any(..)) | (Samples::Any(_), Sample::Count(_)) => {}
    }
    chunk.closing = closing;
    chunk.dtaus.extend(dtau);
    if let Some(time) = time {
        chunk.times.push(time);
    }
    chunk
        .velocities
        .extend(velocity.map(|v| v * layout.per_velocity));
    if let Some((known, rounding)) = force {
        chunk.forces.values.push(known);
        chunk.forces.roundings.push(rounding);
    }
    Ok(())
}

fn trimmed(field: &[u8]) -> &[u8] {
    let field = field.trim_ascii();
    let inner = field
        .strip_prefix(b"\"")
        .and_then(|f| f.strip_suffix(b"\""));
    inner.unwrap_or(field)
}

fn number(field: &[u8], notation: Notation) -> Result<Number, TraceError> {
    refuse_point(field, notation)?;
    if let Some((n, d)) = short(field) {
        return Ok(Number::Small(n, d));
    }
    let comma = field.contains(&b',');
    if notation.decimal_comma && comma {
        let mut pointed = field.to_vec();
        for byte in &mut pointed {
            if *byte == b',' {
                *byte = b'.';
            }
        }
        return number(&pointed, Notation::default());
    }
    let text = std::str::from_utf8(field)
        .map_err(|_| TraceError::new("number", format!("`{}` is no number", shown(field))))?;
    error::number(text).map_err(|mut error| {
        if comma && !notation.decimal_comma {
            let delimiter = match notation.delimiter {
                b',' => "--delimiter ',' ",
                _ => "",
            };
            error.message.push_str(&format!(
                " (is the comma a decimal sign? then add {delimiter}--decimal-comma; if it stands between thousands, write \
                 the numbers without it)"
            ));
        }
        error
    })
}

/// Refuses a number with a point where a comma stands before decimals: the point may stand between thousands.
fn refuse_point(field: &[u8], notation: Notation) -> Result<(), TraceError> {
    if !notation.decimal_comma || !field.contains(&b'.') {
        return Ok(());
    }
    let message = format!(
        "`{}`: with --decimal-comma a point is neither a decimal sign nor read between thousands: write the numbers without \
         points between thousands, or with points before decimals in all columns and without --decimal-comma",
        shown(field)
    );
    Err(TraceError::new("number", message))
}

/// A number, or in a column of dates the seconds since 1970.
fn moment(field: &[u8], is_dated: bool, notation: Notation) -> Result<Number, TraceError> {
    if !is_dated {
        return number(field, notation);
    }
    dates::seconds(field).ok_or_else(|| {
        let message = format!(
            "expected a date and a time of day, as in `2023-11-14T22:13:20.5Z`, found `{}`",
            shown(field)
        );
        TraceError::new("date", message)
    })
}

fn whole(field: &[u8], notation: Notation) -> Result<i64, TraceError> {
    match number(field, notation)? {
        Number::Small(n, 1) => Ok(n),
        Number::Small(n, d) if n % d == 0 => Ok(n / d),
        _ => {
            let message = format!(
                "expected a count, which is a whole number of at most 64 bits, found `{}`",
                shown(field)
            );
            Err(TraceError::new("count", message))
        }
    }
}

/// A number, and how far off it may have been rounded: a fraction is exact.
fn rounded(text: &[u8], notation: Notation, digits: Digits) -> Result<(Number, f64), TraceError> {
    refuse_point(text, notation)?;
    if let Some((n, power)) = decimal(text) {
        let decimals = u8::try_from(power.ilog10()).unwrap_or(u8::MAX);
        return Ok((Number::Small(n, power), digits.half_a_unit_of(n, decimals)));
    }
    let half = Place::read(text).map_or(0.0, |place| digits.half_a_unit(place));
    Ok((number(text, notation)?, half))
}
