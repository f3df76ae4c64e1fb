//! A file of forces, one per sampling interval.

use std::path::Path;

use passivity_core::BigRational;

use crate::number;
use crate::parse::bytes_of;
use crate::parse::measure::Measure;
use crate::scene::Motion;
use crate::units::Unit;

/// The largest file of samples, in bytes.
pub const MAX_BYTES: u64 = 8 << 20;

/// The largest number of samples.
pub const MAX_SAMPLES: usize = 500_000;

/// The longest sample, in bytes: every double has a shorter spelling.
const MAX_CHARS: usize = 100;

/// The column that is read when the scene does not name one.
const COLUMN: &str = "f";

pub(super) struct Samples {
    pub(super) values: Vec<BigRational>,
    /// What the unit in the header tells, when there is one.
    pub(super) motion: Option<Motion>,
}

/// Reads the column `f` (or `column`) of a CSV file with a header, with its unit as in `f [N m]`;
/// or a file of one number a line in N or N·m (KΔ in a dimensionless scene).
pub(super) fn read(
    path: &Path,
    column: Option<&str>,
    dimensionless: bool,
) -> Result<Samples, String> {
    let bytes = bytes_of(path, MAX_BYTES)?;
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(bytes.as_slice());
    let mut layout: Option<Layout> = None;
    let mut values = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| match error.position() {
            Some(position) => format!("line {}: this is not CSV in UTF-8", position.line()),
            None => "this is not CSV in UTF-8".to_owned(),
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        let layout = match &layout {
            Some(layout) => layout,
            None => {
                let first = Layout::of(&record, column, dimensionless);
                let first = first.map_err(|message| format!("line {line}: {message}"))?;
                let is_header = first.is_header;
                let kept = layout.insert(first);
                if is_header {
                    continue;
                }
                kept
            }
        };
        let cell = record.get(layout.index).unwrap_or_default();
        if values.len() == MAX_SAMPLES {
            return Err(format!("line {line}: more than {MAX_SAMPLES} samples"));
        }
        let value = sample(cell).map_err(|message| format!("line {line}: {message}"))?;
        values.push(value * layout.unit.scale());
    }
    if values.is_empty() {
        return Err("there are no samples in it".to_owned());
    }
    Ok(Samples {
        values,
        motion: layout.and_then(|layout| layout.motion),
    })
}

fn sample(cell: &str) -> Result<BigRational, String> {
    if cell.len() > MAX_CHARS {
        return Err(format!("a sample may have at most {MAX_CHARS} characters"));
    }
    number::parse(cell).map_err(|error| error.to_string())
}

/// Where in a row the sample stands, and its unit.
struct Layout {
    index: usize,
    unit: Unit,
    motion: Option<Motion>,
    is_header: bool,
}

impl Layout {
    fn of(
        first: &csv::StringRecord,
        column: Option<&str>,
        dimensionless: bool,
    ) -> Result<Self, String> {
        let wanted = column.unwrap_or(COLUMN);
        let is_header = first.iter().any(|cell| number::parse(cell).is_err());
        if !is_header {
            return if first.len() == 1 && column.is_none() {
                Ok(Self {
                    index: 0,
                    unit: Unit::one(),
                    motion: None,
                    is_header,
                })
            } else {
                Err(format!("expected a header with a column `{wanted}`"))
            };
        }
        let found = first.iter().enumerate().find_map(|(index, cell)| {
            let (name, unit) = match cell.split_once('[') {
                Some((name, rest)) => (name.trim(), rest.strip_suffix(']')),
                None => (cell, Some("")),
            };
            (name == wanted).then_some((index, unit))
        });
        let Some((index, unit)) = found else {
            return Err(format!("the header has no column `{wanted}`"));
        };
        let unit = unit.ok_or("the unit in the header needs its closing `]`")?;
        let (unit, motion) = header_unit(unit, dimensionless)?;
        Ok(Self {
            index,
            unit,
            motion,
            is_header,
        })
    }
}

fn header_unit(text: &str, dimensionless: bool) -> Result<(Unit, Option<Motion>), String> {
    if text.is_empty() {
        return Ok((Unit::one(), None));
    }
    if dimensionless {
        return Err("forces of a dimensionless scene have no unit".to_owned());
    }
    let unit = Unit::parse(text).map_err(|error| error.to_string())?;
    match Measure::Force.accepts(unit.dimension()) {
        Some(motion) if unit.pi_power() == 0 => Ok((unit, motion)),
        _ => Err("the unit in the header is not one of force or torque".to_owned()),
    }
}
