//! The file of a sweep: a row per finished point, written as it finishes, in the order of the grid
//! once all have.
//!
//! While a sweep is unfinished a file beside it, its name with `.run` appended, says of which scene and
//! grid it is; a Parquet file is only written at the end, until then its rows are CSV in a file with
//! `.rows` appended. A killed sweep leaves both; `open` with `resume` takes it up, drops a torn last
//! line, and refuses rows that are not of this sweep. A sweep that was finished has no `.run` file any
//! more: some of its points are then simulated again, and must be the same to the last bit.

use std::collections::{HashMap, HashSet};
use std::fmt::Write as _;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use passivity_scene::Point;

use crate::error::SimError;
use crate::outcome::{ExactOutcome, PaperOutcome};
use crate::plan::Plan;
use crate::run;
use crate::sweep::grid::Grid;
#[cfg(feature = "parquet")]
use crate::sweep::parquet;
use crate::sweep::row::{Found, Row};

/// The header of a sweep's file.
fn header(grid: &Grid) -> String {
    format!(
        "{},paper,exact,at_interval,xi,velocity",
        grid.columns().join(",")
    )
}

/// How the rows of a finished sweep are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Form {
    /// The form that the name of a file asks for.
    fn of(path: &Path) -> Result<Self, SimError> {
        let parquet = path
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("parquet"));
        if !parquet {
            return Ok(Self::Csv);
        }
        #[cfg(feature = "parquet")]
        return Ok(Self::Parquet);
        #[cfg(not(feature = "parquet"))]
        Err(SimError::NotBuiltIn {
            what: "Parquet files are",
            feature: "parquet",
        })
    }
}

/// A file that rows can be added to.
#[derive(Debug)]
pub struct Rows {
    /// What was asked for.
    path: PathBuf,
    form: Form,
    /// Where rows go as they finish: the same, except for Parquet.
    journal: PathBuf,
    /// `None` when the sweep was finished before.
    file: Option<File>,
    buffer: String,
    written: usize,
    total: usize,
}

/// An opened file with what it had.
#[derive(Debug)]
pub struct Opened {
    /// The file.
    pub rows: Rows,
    /// The rows that were there, by index.
    pub found: Vec<(usize, Row)>,
}

fn failed(path: &Path, error: &dyn std::fmt::Display) -> SimError {
    SimError::File(format!("`{}`: {error}", path.display()))
}

fn with_suffix(path: &Path, suffix: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(suffix);
    PathBuf::from(name)
}

fn marker(path: &Path) -> PathBuf {
    with_suffix(path, ".run")
}

/// What tells one sweep from another: the scene and the grid, exactly.
fn fingerprint(scene: &Point, grid: &Grid) -> String {
    let scene = grid.without(scene);
    format!("passivity sweep 1\n{scene:?}\n{grid:?}\n")
}

/// Opens the file of a sweep: a new one, or with `resume` one that was left unfinished.
///
/// A name that ends in `.parquet` is Parquet, any other CSV.
///
/// # Errors
///
/// A file that cannot be read or written, one of another sweep, one with a row that is none; without
/// `resume`, one that was left unfinished.
pub fn open(path: &Path, scene: &Point, grid: &Grid, resume: bool) -> Result<Opened, SimError> {
    let mark = marker(path);
    let form = Form::of(path)?;
    let journal = match form {
        Form::Csv => path.to_owned(),
        #[cfg(feature = "parquet")]
        Form::Parquet => with_suffix(path, ".rows"),
    };
    let print = fingerprint(scene, grid);
    let unfinished = mark.exists() && journal.exists();
    if !resume && unfinished {
        return Err(SimError::File(format!(
            "`{}` is of a sweep that was not finished: take it up with --resume, or remove `{}`",
            path.display(),
            mark.display()
        )));
    }
    let mut rows = Rows {
        path: path.to_owned(),
        form,
        journal,
        file: None,
        buffer: String::new(),
        written: 0,
        total: grid.len(),
    };
    if resume && !unfinished && path.exists() {
        let found = finished(path, form, scene, grid)?;
        rows.written = found.len();
        return Ok(Opened { rows, found });
    }
    let journal = &rows.journal;
    let (mut found, mut length) = (Vec::new(), 0);
    if resume && unfinished {
        let saved = fs::read_to_string(&mark).map_err(|error| failed(&mark, &error))?;
        if saved != print {
            return Err(SimError::File(format!(
                "`{}` is of a sweep of another scene or other ranges: give the same ones, or \
                 another --out",
                path.display()
            )));
        }
        (found, length) = read(journal, grid)?;
    }
    fs::write(&mark, print).map_err(|error| failed(&mark, &error))?;
    let file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(journal)
        .map_err(|error| failed(journal, &error))?;
    let metadata = file.metadata().map_err(|error| failed(journal, &error))?;
    if metadata.len() > length {
        file.set_len(length)
            .map_err(|error| failed(journal, &error))?;
    }
    rows.file = Some(file);
    rows.written = found.len();
    if length == 0 {
        rows.buffer = format!("{}\n", header(grid));
        rows.put()?;
    }
    Ok(Opened { rows, found })
}

/// The rows of a sweep that was finished, once it is plain that they are of this one.
fn finished(
    path: &Path,
    form: Form,
    scene: &Point,
    grid: &Grid,
) -> Result<Vec<(usize, Row)>, SimError> {
    let found = match form {
        Form::Csv => read(path, grid)?.0,
        #[cfg(feature = "parquet")]
        Form::Parquet => {
            let rows = parquet::read(path, grid).map_err(|error| failed(path, &error))?;
            place(rows.into_iter(), grid, &|number, what| {
                failed(path, &format!("row {}: {what}", number + 1))
            })?
        }
    };
    let refuse = |why: &str| {
        failed(
            path,
            &format!(
                "{why}, and no file `.run` says of which sweep it is: remove it to start anew"
            ),
        )
    };
    if found.len() < grid.len() {
        return Err(refuse("not every point of these ranges is there"));
    }
    // Points that ran to their end tell of the number of intervals too.
    const MOST: usize = 8;
    let (ended, ran): (Vec<_>, Vec<_>) =
        found.iter().partition(|(_, row)| row.at_interval.is_some());
    for group in [ended, ran] {
        for (index, row) in group.iter().step_by(group.len().div_ceil(MOST).max(1)) {
            let plan = Plan::compile(&grid.point(scene, *index))?;
            if Row::of(&run::outcome(&plan)) != *row {
                return Err(refuse("its points are not those of this scene"));
            }
        }
    }
    Ok(found)
}

/// The rows of a CSV file, and how long it is without a torn last line.
fn read(path: &Path, grid: &Grid) -> Result<(Vec<(usize, Row)>, u64), SimError> {
    let bytes = fs::read(path).map_err(|error| failed(path, &error))?;
    let whole = bytes
        .iter()
        .rposition(|b| *b == b'\n')
        .map_or(0, |end| end + 1);
    let (lines, _torn) = bytes.split_at(whole);
    // What is no text becomes a line that is no row.
    let text = String::from_utf8_lossy(lines);
    let at = |number: usize, what: &str| failed(path, &format!("line {}: {what}", number + 2));
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
        rows.push(
            parse(line, grid.columns().len())
                .ok_or_else(|| at(number, "expected a row of a sweep"))?,
        );
    }
    Ok((place(rows.into_iter(), grid, &at)?, whole as u64))
}

/// The rows with the indices of their points in the grid.
fn place(
    rows: impl Iterator<Item = Found>,
    grid: &Grid,
    at: &dyn Fn(usize, &str) -> SimError,
) -> Result<Vec<(usize, Row)>, SimError> {
    let mut places = HashMap::with_capacity(grid.len());
    for index in 0..grid.len() {
        places.insert(grid.doubles(index).map(f64::to_bits), index);
    }
    let mut found = Vec::new();
    let mut seen = HashSet::new();
    for (number, (values, row)) in rows.enumerate() {
        let index = places
            .get(&values.map(f64::to_bits))
            .ok_or_else(|| at(number, "a point that is not in these ranges"))?;
        if !seen.insert(*index) {
            return Err(at(number, "a point that was there before"));
        }
        found.push((*index, row));
    }
    Ok(found)
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
    };
    let mut values = [0.0; 3];
    for (value, cell) in values.iter_mut().zip(at_axes) {
        *value = number(cell)?;
    }
    Some((values, row))
}

fn write_row(grid: &Grid, index: usize, row: &Row, out: &mut String) {
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

impl Rows {
    /// Adds a row, which reaches the file at once: a killed process loses none that was added.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: what is in it stays.
    pub fn add(&mut self, grid: &Grid, index: usize, row: &Row) -> Result<(), SimError> {
        write_row(grid, index, row, &mut self.buffer);
        self.put()?;
        self.written += 1;
        Ok(())
    }

    /// Writes what is waiting.
    fn put(&mut self) -> Result<(), SimError> {
        let Some(file) = &mut self.file else {
            return Ok(());
        };
        let result = file.write_all(self.buffer.as_bytes());
        self.buffer.clear();
        result.map_err(|error| {
            SimError::File(format!(
                "`{}`: {error}; {} of {} points are kept: go on with --resume",
                self.journal.display(),
                self.written,
                self.total
            ))
        })
    }

    /// Replaces the file by one with every row in the order of the grid, all at once.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: the unordered one stays.
    pub fn finish(self, grid: &Grid, rows: &[Option<Row>]) -> Result<(), SimError> {
        if self.file.is_none() {
            return Ok(()); // It was finished before.
        }
        let ordered = with_suffix(&self.path, ".tmp");
        let written = match self.form {
            Form::Csv => {
                write_ordered(&ordered, grid, rows).map_err(|error| failed(&self.path, &error))
            }
            #[cfg(feature = "parquet")]
            Form::Parquet => {
                parquet::write(&ordered, grid, rows).map_err(|error| failed(&self.path, &error))
            }
        };
        let placed = written.and_then(|()| {
            fs::rename(&ordered, &self.path).map_err(|error| failed(&self.path, &error))
        });
        placed.inspect_err(|_| {
            // What could not be written whole is of no use; the rows are in the journal.
            let _ = fs::remove_file(&ordered);
        })?;
        if self.journal != self.path {
            fs::remove_file(&self.journal).map_err(|error| failed(&self.journal, &error))?;
        }
        let mark = marker(&self.path);
        fs::remove_file(&mark).map_err(|error| failed(&mark, &error))
    }
}

/// Writes a CSV file with every row in the order of the grid.
fn write_ordered(path: &Path, grid: &Grid, rows: &[Option<Row>]) -> io::Result<()> {
    let mut file = io::BufWriter::new(File::create(path)?);
    writeln!(file, "{}", header(grid))?;
    let mut line = String::new();
    for (index, row) in rows.iter().enumerate() {
        if let Some(row) = row {
            line.clear();
            write_row(grid, index, row, &mut line);
            file.write_all(line.as_bytes())?;
        }
    }
    file.into_inner()
        .map_err(io::IntoInnerError::into_error)?
        .sync_all()
}
