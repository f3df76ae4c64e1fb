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
//! sweep empties the file of rows before it says whose they are, and `.run` is written whole. Taking a sweep up leaves it as it is.

use std::collections::{HashMap, HashSet};
use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::ops::Range;
use std::path::{Path, PathBuf};

use passivity_scene::Point;
use passivity_scene::files::{self, Output};

use crate::error::SimError;
use crate::plan::Plan;
use crate::run;
use crate::sweep::csv;
use crate::sweep::disk::{ROWS, RUN, failed, plain, with_suffix};
use crate::sweep::form::Form;
use crate::sweep::grid::Grid;
use crate::sweep::manifest::{Manifest, beside};
#[cfg(feature = "parquet")]
use crate::sweep::parquet;
use crate::sweep::row::{Found, Row};
use crate::sweep::shard::Shard;

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
    /// The points whose rows these are.
    range: Range<usize>,
    /// What a shard says that it is.
    manifest: Option<Manifest>,
}

/// An opened file with what it had.
#[derive(Debug)]
pub struct Opened {
    /// The file.
    pub rows: Rows,
    /// The rows that were there, by the index of their point in the grid.
    pub found: Vec<(usize, Row)>,
}

fn marker(path: &Path) -> PathBuf {
    with_suffix(path, RUN)
}

/// Where rows go as they finish.
fn journal(path: &Path, form: Form) -> PathBuf {
    match form {
        Form::Csv => path.to_owned(),
        #[cfg(feature = "parquet")]
        Form::Parquet => with_suffix(path, ROWS),
    }
}

/// Refuses to replace the rows of a sweep that was left unfinished.
pub(super) fn spare_unfinished(path: &Path, form: Form) -> Result<(), SimError> {
    let mark = marker(path);
    match mark.exists() && journal(path, form).exists() {
        true => Err(SimError::File(format!(
            "`{}` is of a sweep that was not finished: take it up with --resume, or remove `{}`",
            path.display(),
            mark.display()
        ))),
        false => Ok(()),
    }
}

/// What tells one sweep from another: a hash of the scene, the grid and the shard, exactly.
fn fingerprint(scene: &Point, grid: &Grid, shard: Option<Shard>) -> String {
    let scene = grid.without(scene);
    let whole = format!("{scene:?}\n{grid:?}\n");
    match shard {
        None => format!("passivity sweep 2 {}\n", hash(&whole)),
        Some(shard) => format!("passivity sweep 2 {} {shard}\n", hash(&whole)),
    }
}

/// SHA-256 as hexadecimal digits.
pub(super) fn hash(text: &str) -> String {
    use sha2::Digest as _;
    let hash = sha2::Sha256::digest(text);
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
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
    open_as(path, scene, grid, None, resume)
}

/// Opens the file of a shard of a sweep, as [`open`] opens that of the whole. When it is finished it says
/// which shard of which sweep it is: a Parquet file in its metadata, for a CSV file the file beside it
/// whose name has `.manifest` appended.
///
/// # Errors
///
/// As [`open`].
pub fn open_shard(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    shard: Shard,
    resume: bool,
) -> Result<Opened, SimError> {
    open_as(path, scene, grid, Some(shard), resume)
}

fn open_as(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    shard: Option<Shard>,
    resume: bool,
) -> Result<Opened, SimError> {
    let mark = marker(path);
    let form = Form::of(path)?;
    let journal = journal(path, form);
    for file in [path, &mark, &journal] {
        plain(file)?;
    }
    let unfinished = mark.exists() && journal.exists();
    if !resume {
        spare_unfinished(path, form)?;
    }
    let mut rows = Rows {
        path: path.to_owned(),
        form,
        journal,
        file: None,
        buffer: String::new(),
        written: 0,
        range: shard.unwrap_or(Shard::WHOLE).range(grid.len()),
        manifest: shard.map(|shard| Manifest::new(scene, grid, shard)),
    };
    if resume && unfinished {
        return rows.take_up(&mark, scene, grid, shard);
    }
    let is_begun = is_only_begun(&rows.journal, grid)?;
    if resume && !is_begun && path.exists() {
        let found = finished(path, form, scene, grid, &rows.range)?;
        rows.written = found.len();
        return Ok(Opened { rows, found });
    }
    if resume && !is_begun && rows.journal.exists() {
        return Err(unbound(&rows.journal, "it has rows"));
    }
    rows.start(&mark, &fingerprint(scene, grid, shard), grid)?;
    Ok(Opened {
        rows,
        found: Vec::new(),
    })
}

/// Whether a start was killed before it said of which sweep the rows will be: there is no more than the header.
fn is_only_begun(journal: &Path, grid: &Grid) -> Result<bool, SimError> {
    let header = format!("{}\n", csv::header(grid));
    match fs::metadata(journal) {
        Ok(there) if there.len() <= header.len() as u64 => {
            let text = fs::read(journal).map_err(|error| failed(journal, &error))?;
            Ok(header.as_bytes().starts_with(&text))
        }
        Ok(_) | Err(_) => Ok(false),
    }
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
        // That of a file that is replaced.
        let said = beside(&self.path);
        if said.exists() {
            fs::remove_file(&said).map_err(|error| failed(&said, &error))?;
        }
        let mut file = File::create(journal).map_err(|error| failed(journal, &error))?;
        let written = writeln!(file, "{}", csv::header(grid)).and_then(|()| file.sync_all());
        written.map_err(|error| failed(journal, &error))?;
        files::write(mark, print).map_err(|error| failed(mark, &error))?;
        self.file = Some(file);
        Ok(())
    }

    /// Takes up a sweep that was left unfinished.
    fn take_up(
        mut self,
        mark: &Path,
        scene: &Point,
        grid: &Grid,
        shard: Option<Shard>,
    ) -> Result<Opened, SimError> {
        let saved = fs::read_to_string(mark).map_err(|error| failed(mark, &error))?;
        if saved != fingerprint(scene, grid, shard) {
            return Err(SimError::File(format!(
                "`{}` is of a sweep of another scene or other ranges: give the same ones, or \
                 another --out",
                self.path.display()
            )));
        }
        let journal = &self.journal;
        let (rows, length) = csv::read(journal, grid)?;
        let found = place(rows, grid, &self.range, journal, self.form)?;
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
            self.buffer = format!("{}\n", csv::header(grid));
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
    range: &Range<usize>,
) -> Result<Vec<(usize, Row)>, SimError> {
    let found = place(form.read(path, grid)?, grid, range, path, form)?;
    if found.len() < range.len() {
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
            let again = Row {
                within_rounding_of_edge: row.within_rounding_of_edge, // No file has it.
                ..Row::of(&run::outcome(&plan))
            };
            if again != *row {
                return Ok(false);
            }
        }
    }
    Ok(true)
}

/// The rows of a file with the indices of their points in the grid.
fn place(
    rows: Vec<Found>,
    grid: &Grid,
    range: &Range<usize>,
    path: &Path,
    form: Form,
) -> Result<Vec<(usize, Row)>, SimError> {
    let mut places = HashMap::with_capacity(range.len());
    for index in range.clone() {
        places.insert(grid.doubles(index).map(f64::to_bits), index);
    }
    let mut found = Vec::new();
    let mut seen = HashSet::new();
    for (number, (values, row)) in rows.into_iter().enumerate() {
        let index = places
            .get(&values.map(f64::to_bits))
            .ok_or_else(|| form.at(path, number, "a point that is not in these ranges"))?;
        if !seen.insert(*index) {
            return Err(form.at(path, number, "a point that was there before"));
        }
        found.push((*index, row));
    }
    Ok(found)
}

impl Rows {
    /// Adds a row, which reaches the file at once: a killed process loses none that was added.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: what is in it stays.
    pub fn add(&mut self, grid: &Grid, index: usize, row: &Row) -> Result<(), SimError> {
        csv::write_row(grid, index, row, &mut self.buffer);
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
                self.range.len()
            ))
        })
    }

    /// Replaces the file by one with every row in the order of the grid, all at once: `rows` are those of
    /// the points that are its own.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: the unordered one stays.
    pub fn finish(self, grid: &Grid, rows: &[Option<Row>]) -> Result<(), SimError> {
        if self.file.is_none() {
            // It was finished before; what it is may not have been said, or be said of another sweep.
            return match (self.form, &self.manifest) {
                (Form::Csv, Some(manifest)) => manifest.write(&self.path),
                _ => Ok(()),
            };
        }
        let named = self.range.clone().zip(rows);
        let rows = named.filter_map(|(index, row)| row.map(|row| Ok((index, row))));
        write_ordered(&self.path, self.form, grid, self.manifest.as_ref(), rows)?;
        if self.journal != self.path {
            fs::remove_file(&self.journal).map_err(|error| failed(&self.journal, &error))?;
        }
        let mark = marker(&self.path);
        fs::remove_file(&mark).map_err(|error| failed(&mark, &error))
    }
}

/// Writes a finished shard that was simulated in one go, without a file of the rows on the way: `rows` are
/// those of the points that are its own.
///
/// # Errors
///
/// A file that cannot be written: nothing is in its place then.
pub fn write_shard(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    shard: Shard,
    rows: &[Option<Row>],
) -> Result<(), SimError> {
    plain(path)?;
    let form = Form::of(path)?;
    spare_unfinished(path, form)?;
    let manifest = Manifest::new(scene, grid, shard);
    let named = shard.range(grid.len()).zip(rows);
    let rows = named.filter_map(|(index, row)| row.map(|row| Ok((index, row))));
    write_ordered(path, form, grid, Some(&manifest), rows)
}

/// Writes rows that come in the order of the grid, and puts the file in its place when all of them are
/// on the disk.
pub(super) fn write_ordered(
    path: &Path,
    form: Form,
    grid: &Grid,
    manifest: Option<&Manifest>,
    rows: impl Iterator<Item = Result<(usize, Row), SimError>>,
) -> Result<(), SimError> {
    let wrong = |error: &dyn std::fmt::Display| failed(path, error);
    // What cannot be written whole is of no use; the rows are in the journal.
    let output = Output::create(path).map_err(|error| wrong(&error))?;
    match form {
        Form::Csv => {
            let mut file = csv::Writer::new(output, grid).map_err(|error| wrong(&error))?;
            for row in rows {
                let (index, row) = row?;
                let added = file.add(grid, index, &row);
                added.map_err(|error| wrong(&error))?;
            }
            file.finish().map_err(|error| wrong(&error))?;
        }
        #[cfg(feature = "parquet")]
        Form::Parquet => {
            let said = manifest.map(Manifest::to_json);
            let file = parquet::Writer::new(output, grid, said);
            let mut file = file.map_err(|error| wrong(&error))?;
            for row in rows {
                let (index, row) = row?;
                let added = file.add(grid, index, &row);
                added.map_err(|error| wrong(&error))?;
            }
            file.finish(grid).map_err(|error| wrong(&error))?;
        }
    }
    match (form, manifest) {
        (Form::Csv, Some(manifest)) => manifest.write(path),
        _ => Ok(()),
    }
}
