//! The rows of a sweep as CSV.

use std::fmt::Write as _;
use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use passivity_scene::files::Output;

use crate::error::SimError;
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
use crate::sweep::row::{Found, Row};

/// The header of a sweep's file.
pub(super) fn header(grid: &Grid) -> String {
    format!(
        "{},paper,exact,at_interval,xi,velocity",
        grid.columns().join(",")
    )
}

/// The rows of a file, and how long it is without a torn last line.
pub(super) fn read(path: &Path, grid: &Grid) -> Result<(Vec<Found>, u64), SimError> {
    let bytes = fs::read(path).map_err(|error| failed(path, &error))?;
    let whole = bytes
        .iter()
        .rposition(|b| *b == b'\n')
        .map_or(0, |end| end + 1);
    let (lines, _torn) = bytes.split_at(whole);
    // What is no text becomes a line that is no row.
    let text = String::from_utf8_lossy(lines);
    let mut lines = text.lines();
    match lines.next() {
        None => return Ok((Vec::new(), 0)),
        Some(line) if line == header(grid) => {}
        Some(_) => {
            let expected = header(grid);
            return Err(failed(
                path,
                &format!("line 1: expected the header `{expected}`"),
            ));
        }
    }
    let mut rows = Vec::new();
    for (number, line) in lines.enumerate() {
        let row = parse(line, grid.columns().len());
        rows.push(row.ok_or_else(|| at(path, number, "expected a row of a sweep"))?);
    }
    Ok((rows, whole as u64))
}

/// The error at a row, from 0.
pub(super) fn at(path: &Path, row: usize, what: &str) -> SimError {
    failed(path, &format!("line {}: {what}", row + 2))
}

fn parse(line: &str, axes: usize) -> Option<Found> {
    let cells: Vec<&str> = line.split(',').collect();
    let (at_axes, [paper, exact, at, xi, velocity]) = cells.split_at_checked(axes)? else {
        return None;
    };
    let number = |cell: &str| cell.parse::<f64>().ok();
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
    let mut values = [0.0; 3];
    for (value, cell) in values.iter_mut().zip(at_axes) {
        *value = number(cell)?;
    }
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
