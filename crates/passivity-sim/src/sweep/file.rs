//! The file of a sweep: a row per finished point, written as it finishes, in the order of the grid
//! once all have.
//!
//! While a sweep is unfinished a file beside it, its name with `.run` appended, says by a hash of which
//! scene and grid it is; a Parquet file is only written at the end, until then its rows are CSV in a file
//! with `.rows` appended. A killed sweep leaves both; `open` with `resume` takes it up, drops a torn last
//! line, and refuses rows that are not of this sweep. A sweep that was finished has no `.run` file any
//! more. Whatever is taken up, some of its points are simulated again, and must be the same to the last bit.
//!
//! Wherever a process is killed, rows stand beside a `.run` file only if they are of its sweep: a new
//! sweep empties the file of rows before it says whose they are, and `.run` is written beside, synced and
//! renamed. Taking a sweep up leaves it as it is.

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

/// What tells one sweep from another: a hash of the scene and the grid, exactly.
fn fingerprint(scene: &Point, grid: &Grid) -> String {
    use sha2::Digest as _;
    let scene = grid.without(scene);
    let hash = sha2::Sha256::digest(format!("{scene:?}\n{grid:?}\n"));
    let hash: String = hash.iter().map(|byte| format!("{byte:02x}")).collect();
    format!("passivity sweep 2 {hash}\n")
}

/// Refuses to write to what is no plain file.
fn plain(path: &Path) -> Result<(), SimError> {
    match path.symlink_metadata() {
        Ok(there) if !there.is_file() => {
            Err(failed(path, &"is no plain file, and is not replaced"))
        }
        // What does not exist yet is nothing that is lost.
        _ => Ok(()),
    }
}

/// Writes a small file whole: beside it first, on the disk, and then in its place.
fn write_whole(path: &Path, text: &str) -> io::Result<()> {
    let beside = with_suffix(path, ".tmp");
    let mut file = File::create(&beside)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    drop(file);
    fs::rename(&beside, path)?;
    sync_folder(path)
}

/// Brings a new name in a folder to the disk, where folders can be opened.
fn sync_folder(path: &Path) -> io::Result<()> {
    #[cfg(unix)]
    if let Some(folder) = path.parent() {
        let folder = match folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => folder,
        };
        File::open(folder)?.sync_all()?;
    }
    #[cfg(not(unix))]
    let _ = path;
    Ok(())
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
    for file in [path, &mark, &journal] {
        plain(file)?;
    }
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
    if resume && unfinished {
        return rows.take_up(&mark, scene, grid);
    }
    if resume && path.exists() {
        let found = finished(path, form, scene, grid)?;
        rows.written = found.len();
        return Ok(Opened { rows, found });
    }
    if resume && rows.journal.exists() {
        return Err(unbound(&rows.journal, "it has rows"));
    }
    rows.start(&mark, &fingerprint(scene, grid), grid)?;
    Ok(Opened {
        rows,
        found: Vec::new(),
    })
}

/// The error of rows that nothing says the sweep of.
fn unbound(path: &Path, why: &str) -> SimError {
    let message =
        format!("{why}, and no file `.run` says of which sweep it is: remove it to start anew");
    failed(path, &message)
}

impl Rows {
    /// Starts a new sweep: no rows first, then whose they will be.
    fn start(&mut self, mark: &Path, print: &str, grid: &Grid) -> Result<(), SimError> {
        let journal = &self.journal;
        let mut file = File::create(journal).map_err(|error| failed(journal, &error))?;
        let written = writeln!(file, "{}", header(grid)).and_then(|()| file.sync_all());
        written.map_err(|error| failed(journal, &error))?;
        write_whole(mark, print).map_err(|error| failed(mark, &error))?;
        self.file = Some(file);
        Ok(())
    }

    /// Takes up a sweep that was left unfinished.
    fn take_up(mut self, mark: &Path, scene: &Point, grid: &Grid) -> Result<Opened, SimError> {
        let saved = fs::read_to_string(mark).map_err(|error| failed(mark, &error))?;
        if saved != fingerprint(scene, grid) {
            return Err(SimError::File(format!(
                "`{}` is of a sweep of another scene or other ranges: give the same ones, or \
                 another --out",
                self.path.display()
            )));
        }
        let journal = &self.journal;
        let (found, length) = read(journal, grid)?;
        if !are_of(&found, scene, grid)? {
            return Err(failed(journal, &"its points are not those of this scene"));
        }
        let opened = OpenOptions::new().append(true).open(journal);
        let file = opened.map_err(|error| failed(journal, &error))?;
        // Without the torn last line.
        file.set_len(length)
            .map_err(|error| failed(journal, &error))?;
        self.file = Some(file);
        self.written = found.len();
        if length == 0 {
            self.buffer = format!("{}\n", header(grid));
            self.put()?;
        }
        Ok(Opened { rows: self, found })
    }
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
    if found.len() < grid.len() {
        return Err(unbound(path, "not every point of these ranges is there"));
    }
    if !are_of(&found, scene, grid)? {
        return Err(unbound(path, "its points are not those of this scene"));
    }
    Ok(found)
}

/// Whether some of the rows come out the same, to the last bit, when they are simulated again.
fn are_of(found: &[(usize, Row)], scene: &Point, grid: &Grid) -> Result<bool, SimError> {
    // Points that ran to their end tell of the number of intervals too.
    const MOST: usize = 8;
    let (ended, ran): (Vec<_>, Vec<_>) =
        found.iter().partition(|(_, row)| row.at_interval.is_some());
    for group in [ended, ran] {
        for (index, row) in group.iter().step_by(group.len().div_ceil(MOST).max(1)) {
            let plan = Plan::compile(&grid.point(scene, *index))?;
            if Row::of(&run::outcome(&plan)) != *row {
                return Ok(false);
            }
        }
    }
    Ok(true)
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
            let placed = fs::rename(&ordered, &self.path).and_then(|()| sync_folder(&self.path));
            placed.map_err(|error| failed(&self.path, &error))
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
