//! The rows of a sweep as CSV.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::Path;

use passivity_scene::files::Output;

use crate::error::SimError;
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
use crate::sweep::row::{Each, Found, Row};

/// The columns behind the axes.
const OUTCOMES: &str = "paper,exact,at_interval,xi,velocity";

/// The header of a sweep's file.
pub(super) fn header(grid: &Grid) -> String {
    format!("{},{OUTCOMES}", grid.columns().join(","))
}

/// Whether a text begins with the header of some sweep.
pub(super) fn begins_with_header(text: &[u8]) -> bool {
    let line = text.split(|byte| *byte == b'\n').next();
    line.is_some_and(|line| line.trim_ascii_end().ends_with(OUTCOMES.as_bytes()))
}

/// Reads the rows of a file; how long it is without a torn last line.
pub(super) fn read(path: &Path, grid: &Grid, each: Each<'_>) -> Result<u64, SimError> {
    let file = File::open(path).map_err(|error| failed(path, &error))?;
    let mut file = BufReader::with_capacity(1 << 16, file);
    let (header, axes) = (header(grid), grid.columns().len());
    let (mut bytes, mut length, mut number) = (Vec::new(), 0, None);
    loop {
        bytes.clear();
        let read = file.read_until(b'\n', &mut bytes);
        let read = read.map_err(|error| failed(path, &error))?;
        let Some(line) = bytes.strip_suffix(b"\n") else {
            return Ok(length); // The end, or a torn line.
        };
        // What is no text is no row.
        let line = str::from_utf8(line).unwrap_or_default();
        let line = line.strip_suffix('\r').unwrap_or(line);
        number = match number {
            None if line == header => Some(0),
            None => {
                let message = format!("line 1: expected the header `{header}`");
                return Err(failed(path, &message));
            }
            Some(number) => {
                let row = parse(line, axes);
                let row = row.ok_or_else(|| at(path, number, "expected a row of a sweep"))?;
                each(number, row)?;
                Some(number + 1)
            }
        };
        length += read as u64;
    }
}

/// The error at a row, from 0.
pub(super) fn at(path: &Path, row: usize, what: &str) -> SimError {
    failed(path, &format!("line {}: {what}", row + 2))
}

fn parse(line: &str, axes: usize) -> Option<Found> {
    let mut cells = line.split(',');
    let number = |cell: &str| cell.parse::<f64>().ok();
    let mut values = [0.0; 3];
    for value in values.iter_mut().take(axes) {
        *value = number(cells.next()?)?;
    }
    let mut next = || cells.next();
    let [paper, exact, at, xi, velocity] = [next()?, next()?, next()?, next()?, next()?];
    if next().is_some() {
        return None;
    }
    let row = Row {
        paper: PaperOutcome::named(paper)?,
        exact: ExactOutcome::named(exact)?,
        at_interval: if at.is_empty() {
            None
        } else {
            Some(at.parse().ok()?)
        },
        xi: number(xi)?,
        velocity: number(velocity)?,
        within_rounding_of_edge: None,
    };
    Some((values, row))
}

/// Appends a row to a text.
pub(super) fn write_row(grid: &Grid, index: usize, row: &Row, out: &mut String) {
    let values = grid.doubles(index);
    for value in values.iter().take(grid.columns().len()) {
        // Writing to a string does not fail.
        let _ = write!(out, "{value:?},");
    }
    let (paper, exact) = (row.paper.name(), row.exact.name());
    let at = row.at_interval.map_or_else(String::new, |h| h.to_string());
    let (xi, velocity) = (row.xi, row.velocity);
    let _ = writeln!(out, "{paper},{exact},{at},{xi:?},{velocity:?}");
}

/// A file of rows that are added in order.
pub(super) struct Writer {
    file: Output,
    line: String,
}

impl Writer {
    pub(super) fn new(mut file: Output, grid: &Grid) -> io::Result<Self> {
        writeln!(file, "{}", header(grid))?;
        let line = String::new();
        Ok(Self { file, line })
    }

    pub(super) fn add(&mut self, grid: &Grid, index: usize, row: &Row) -> io::Result<()> {
        self.line.clear();
        write_row(grid, index, row, &mut self.line);
        self.file.write_all(self.line.as_bytes())
    }

    /// Has the rows reach the disk, and then their name.
    pub(super) fn finish(self) -> io::Result<()> {
        self.file.keep()
    }
}
