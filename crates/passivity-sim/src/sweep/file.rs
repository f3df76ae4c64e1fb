//! The file of a sweep: a row per finished point, appended as they finish, in the order of the grid
//! once all have.
//!
//! While a sweep is unfinished a file beside it, its name with `.run` appended, says of which scene and
//! grid it is. A killed sweep leaves both; `open` with `resume` takes it up, drops a torn last line,
//! and refuses rows that are not of this sweep.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use passivity_scene::Point;

use crate::error::SimError;
use crate::outcome::{Exactly, Paper};
use crate::sweep::{Grid, Row};

/// The header of a sweep's file.
const HEADER: &str = "beta,sigma,speed,paper,exact,at_interval,xi,velocity";

/// A file that rows can be added to.
#[derive(Debug)]
pub struct Rows {
    path: PathBuf,
    file: File,
    buffer: String,
    waiting: usize,
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

fn failed(path: &Path, error: &io::Error) -> SimError {
    SimError::File(format!("`{}`: {error}", path.display()))
}

fn marker(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".run");
    PathBuf::from(name)
}

/// What tells one sweep from another: the scene and the grid, exactly.
fn fingerprint(scene: &Point, grid: &Grid) -> String {
    let mut scene = scene.clone();
    // These are the grid's.
    (scene.beta, scene.sigma) = (None, None);
    scene.start[1] = scene.start[0].clone();
    format!("passivity sweep 1\n{scene:?}\n{grid:?}\n")
}

/// Opens the file of a sweep: a new one, or with `resume` one that was left unfinished.
///
/// # Errors
///
/// A file that cannot be read or written, one of another sweep, one with a row that is none; without
/// `resume`, one that was left unfinished.
pub fn open(path: &Path, scene: &Point, grid: &Grid, resume: bool) -> Result<Opened, SimError> {
    let mark = marker(path);
    let print = fingerprint(scene, grid);
    if !resume && mark.exists() && path.exists() {
        return Err(SimError::File(format!(
            "`{}` is of a sweep that was not finished: take it up with --resume, or remove `{}`",
            path.display(),
            mark.display()
        )));
    }
    let mut found = Vec::new();
    let (mut length, mut text_length) = (0, fs::metadata(path).map_or(0, |file| file.len()));
    if resume && path.exists() {
        if mark.exists() {
            let saved = fs::read_to_string(&mark).map_err(|error| failed(&mark, &error))?;
            if saved != print {
                return Err(SimError::File(format!(
                    "`{}` is of a sweep of another scene or other ranges: give the same ones, or \
                     another --out",
                    path.display()
                )));
            }
        }
        let text = fs::read_to_string(path).map_err(|error| failed(path, &error))?;
        (found, length) = read(path, &text, grid)?;
        text_length = text.len() as u64;
    }
    fs::write(&mark, print).map_err(|error| failed(&mark, &error))?;
    let file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(path)
        .map_err(|error| failed(path, &error))?;
    if text_length > length {
        file.set_len(length).map_err(|error| failed(path, &error))?;
    }
    let mut rows = Rows {
        path: path.to_owned(),
        file,
        buffer: String::new(),
        waiting: 0,
        written: found.len(),
        total: grid.len(),
    };
    if length == 0 {
        rows.buffer = format!("{HEADER}\n");
        rows.flush()?;
    }
    Ok(Opened { rows, found })
}

/// The rows of a file, and how long it is without a torn last line.
fn read(path: &Path, text: &str, grid: &Grid) -> Result<(Vec<(usize, Row)>, u64), SimError> {
    let whole = text.rfind('\n').map_or(0, |end| end + 1);
    let name = path.display();
    let mut lines = text[..whole].lines();
    match lines.next() {
        None => return Ok((Vec::new(), 0)),
        Some(HEADER) => {}
        Some(_) => {
            return Err(SimError::File(format!(
                "`{name}`, line 1: expected the header `{HEADER}`"
            )));
        }
    }
    let mut places = HashMap::with_capacity(grid.len());
    for index in 0..grid.len() {
        places.insert(grid.doubles(index).map(f64::to_bits), index);
    }
    let mut found = Vec::new();
    let mut seen = vec![false; grid.len()];
    for (number, line) in lines.enumerate() {
        let at = |what: &str| SimError::File(format!("`{name}`, line {}: {what}", number + 2));
        let (values, row) = parse(line).ok_or_else(|| at("expected a row of a sweep"))?;
        let index = places
            .get(&values.map(f64::to_bits))
            .ok_or_else(|| at("a point that is not in these ranges"))?;
        if std::mem::replace(&mut seen[*index], true) {
            return Err(at("a point that was there before"));
        }
        found.push((*index, row));
    }
    Ok((found, whole as u64))
}

fn parse(line: &str) -> Option<([f64; 3], Row)> {
    let cells: Vec<&str> = line.split(',').collect();
    let [beta, sigma, speed, paper, exact, at, xi, velocity] = cells.as_slice() else {
        return None;
    };
    let number = |cell: &str| cell.parse::<f64>().ok();
    let row = Row {
        paper: Paper::named(paper)?,
        exact: Exactly::named(exact)?,
        at_interval: if at.is_empty() {
            None
        } else {
            Some(at.parse().ok()?)
        },
        xi: number(xi)?,
        velocity: number(velocity)?,
    };
    Some(([number(beta)?, number(sigma)?, number(speed)?], row))
}

fn write_row(grid: &Grid, index: usize, row: &Row, out: &mut String) {
    let [beta, sigma, speed] = grid.doubles(index);
    let (paper, exact) = (row.paper.name(), row.exact.name());
    let at = row.at_interval.map_or_else(String::new, |h| h.to_string());
    let (xi, velocity) = (row.xi, row.velocity);
    // Writing to a string does not fail.
    let _ = writeln!(
        out,
        "{beta:?},{sigma:?},{speed:?},{paper},{exact},{at},{xi:?},{velocity:?}"
    );
}

impl Rows {
    /// Adds a row; rows reach the file a few at a time.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: what is in it stays.
    pub fn add(&mut self, grid: &Grid, index: usize, row: &Row) -> Result<(), SimError> {
        const AT_ONCE: usize = 64;
        write_row(grid, index, row, &mut self.buffer);
        self.waiting += 1;
        if self.waiting >= AT_ONCE {
            self.flush()
        } else {
            Ok(())
        }
    }

    /// Writes what is waiting.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: what is in it stays.
    pub fn flush(&mut self) -> Result<(), SimError> {
        let result = self.file.write_all(self.buffer.as_bytes());
        result.map_err(|error| {
            SimError::File(format!(
                "`{}`: {error}; {} of {} points are kept: go on with --resume",
                self.path.display(),
                self.written,
                self.total
            ))
        })?;
        self.written += self.waiting;
        self.waiting = 0;
        self.buffer.clear();
        Ok(())
    }

    /// Replaces the file by one with every row in the order of the grid, all at once.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: the unordered one stays.
    pub fn finish(mut self, grid: &Grid, rows: &[Option<Row>]) -> Result<(), SimError> {
        self.flush()?;
        let mut name = self.path.as_os_str().to_owned();
        name.push(".tmp");
        let ordered = PathBuf::from(name);
        let write = || -> io::Result<()> {
            let mut file = io::BufWriter::new(File::create(&ordered)?);
            writeln!(file, "{HEADER}")?;
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
                .sync_all()?;
            fs::rename(&ordered, &self.path)
        };
        write().map_err(|error| {
            let _ = fs::remove_file(&ordered);
            failed(&self.path, &error)
        })?;
        let mark = marker(&self.path);
        fs::remove_file(&mark).map_err(|error| failed(&mark, &error))
    }
}
