//! The file of a sweep: a row per finished point, written as it finishes, in the order of the grid
//! once all have.
//!
//! While a sweep is unfinished a file beside it, its name with `.run` appended, says by a hash of which
//! scene and grid it is; a Parquet file is only written at the end, until then its rows are CSV in a file
//! with `.rows` appended. A killed sweep leaves both; `open` with `resume` takes it up, drops a torn last
//! line, and refuses rows that are not of this sweep. A sweep that was finished has no `.run` file any
//! more. Whatever is taken up, some of its points are simulated again, and must be the same to the last bit.
//! The process that writes has `.run` locked.
//!
//! Wherever a process is killed, rows stand beside a `.run` file that says something only if they are of its sweep: a
//! new sweep empties the file of rows before it says whose they are. Taking a sweep up leaves it as it is.

use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::ops::Range;
use std::path::{Path, PathBuf};

use passivity_scene::Point;
use passivity_scene::files::Output;

use crate::error::SimError;
use crate::sweep::csv;
#[cfg(feature = "parquet")]
use crate::sweep::disk::ROWS;
use crate::sweep::disk::{BESIDE, OTHER, RUN, failed, is_own, plain, with_suffix};
use crate::sweep::form::{Form, Writer};
use crate::sweep::grid::Grid;
use crate::sweep::lock::Lock;
use crate::sweep::manifest::{Manifest, forget, spare};
use crate::sweep::order::{MOST_WAITING, in_order};
use crate::sweep::row::Row;
use crate::sweep::shard::Shard;
use crate::sweep::taken::Taken;
use crate::sweep::whose::{fingerprint, is_taken_up, of_another, unbound};

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
    /// That no other process writes here; `None` when the sweep was finished before.
    lock: Option<Lock>,
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
    /// Which points have their rows, of those that are its own; none where the file is new.
    pub done: Vec<bool>,
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

/// Refuses to replace the rows of a sweep that was left unfinished, or that another process is at, and a file that no
/// sweep wrote, there or beside them.
pub(super) fn spare_others(path: &Path, form: Form) -> Result<(), SimError> {
    spare(path)?;
    let mark = marker(path);
    if mark.exists() {
        let said = Lock::take(path, &mark)?.read()?;
        if !said.is_empty() && journal(path, form).exists() {
            return Err(unfinished(path));
        }
    }
    is_own(path, OTHER, |start| form.begins(start))
}

fn unfinished(path: &Path) -> SimError {
    SimError::File(format!(
        "`{}` is of a sweep that was not finished: take it up with --resume, or remove `{}`",
        path.display(),
        marker(path).display()
    ))
}

/// Opens the file of a sweep: a new one, or with `resume` one that was left unfinished.
///
/// A name that ends in `.parquet` is Parquet, any other CSV. `see` is given the rows that are there, each with the index of
/// its point in the grid.
///
/// # Errors
///
/// A file that cannot be read or written, one of another sweep, one with a row that is none; without
/// `resume`, one that was left unfinished; one that another process is writing.
pub fn open(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    resume: bool,
    mut see: impl FnMut(usize, &Row),
) -> Result<Opened, SimError> {
    open_as(path, scene, grid, None, resume, &mut see)
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
    mut see: impl FnMut(usize, &Row),
) -> Result<Opened, SimError> {
    open_as(path, scene, grid, Some(shard), resume, &mut see)
}

fn open_as(
    path: &Path,
    scene: &Point,
    grid: &Grid,
    shard: Option<Shard>,
    resume: bool,
    see: &mut dyn FnMut(usize, &Row),
) -> Result<Opened, SimError> {
    let mark = marker(path);
    let form = Form::of(path)?;
    let journal = journal(path, form);
    for file in [path, &mark, &journal] {
        plain(file)?;
    }
    spare(path)?;
    // A finished sweep is read alone, perhaps where nothing can be written.
    let mut lock = match resume && path.exists() && !mark.exists() {
        true => None,
        false => Some(Lock::take(path, &mark)?),
    };
    let said = lock
        .as_mut()
        .map_or_else(|| Ok(String::new()), Lock::read)?;
    let is_begun = is_only_begun(&journal, grid)?;
    if journal != path {
        is_own(&journal, BESIDE, |start| {
            is_begun || csv::begins_with_header(start)
        })?;
    }
    // A start that was killed may not have said all.
    let is_unfinished = journal.exists()
        && match is_begun {
            true => said.ends_with('\n'),
            false => !said.is_empty(),
        };
    if is_unfinished && !resume {
        return Err(unfinished(path));
    }
    if !resume {
        is_own(path, OTHER, |start| is_begun || form.begins(start))?;
    }
    let mut rows = Rows {
        path: path.to_owned(),
        form,
        journal,
        file: None,
        lock,
        buffer: String::new(),
        written: 0,
        range: shard.unwrap_or(Shard::WHOLE).range(grid.len()),
        manifest: shard.map(|shard| Manifest::new(scene, grid, shard)),
    };
    if is_unfinished {
        return rows.take_up(&said, scene, grid, shard, see);
    }
    if resume && !is_begun && path.exists() {
        let asked = Manifest::new(scene, grid, shard.unwrap_or(Shard::WHOLE));
        let done = rows
            .finished(scene, grid, see)
            .map_err(|error| of_another(path, form, &asked).unwrap_or(error))?;
        return Ok(Opened { rows, done });
    }
    if resume && !is_begun && rows.journal.exists() {
        return Err(unbound(path, "there are rows beside it"));
    }
    rows.start(&mark, &fingerprint(scene, grid, shard), grid)?;
    Ok(Opened {
        rows,
        done: Vec::new(),
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

impl Rows {
    /// Starts a new sweep: no rows first, then whose they will be.
    fn start(&mut self, mark: &Path, print: &str, grid: &Grid) -> Result<(), SimError> {
        let mut lock = match self.lock.take() {
            Some(lock) => lock,
            None => Lock::take(&self.path, mark)?,
        };
        let journal = &self.journal;
        forget(&self.path)?;
        // In place of what had the name, so that another name of that keeps it.
        let begun = Output::create(journal).and_then(|mut file| {
            writeln!(file, "{}", csv::header(grid))?;
            file.keep()?;
            OpenOptions::new().append(true).open(journal)
        });
        let file = begun.map_err(|error| failed(journal, &error))?;
        lock.write(print)?;
        self.file = Some(file);
        self.lock = Some(lock);
        Ok(())
    }

    /// Takes up a sweep that was left unfinished.
    fn take_up(
        mut self,
        said: &str,
        scene: &Point,
        grid: &Grid,
        shard: Option<Shard>,
        see: &mut dyn FnMut(usize, &Row),
    ) -> Result<Opened, SimError> {
        is_taken_up(&self.path, said, scene, grid, shard)?;
        let journal = &self.journal;
        let mut taken = Taken::new(Form::Csv, journal, grid, &self.range, see);
        let length = csv::read(journal, grid, &mut |number, found| {
            taken.take(number, found)
        })?;
        let done = taken.done;
        if !taken.sample.is_of(scene, grid)? {
            return Err(failed(journal, &"its points are not those of this scene"));
        }
        let opened = OpenOptions::new().append(true).open(journal);
        let file = opened.map_err(|error| failed(journal, &error))?;
        // Without the torn last line.
        file.set_len(length)
            .map_err(|error| failed(journal, &error))?;
        self.file = Some(file);
        self.written = count(&done);
        if length == 0 {
            self.buffer = format!("{}\n", csv::header(grid));
            self.put()?;
        }
        Ok(Opened { rows: self, done })
    }

    /// Takes up a sweep that was finished, once it is plain that its rows are of this one.
    fn finished(
        &mut self,
        scene: &Point,
        grid: &Grid,
        see: &mut dyn FnMut(usize, &Row),
    ) -> Result<Vec<bool>, SimError> {
        let path = &self.path;
        let mut taken = Taken::new(self.form, path, grid, &self.range, see);
        self.form
            .read(path, grid, &mut |number, found| taken.take(number, found))?;
        let done = taken.done;
        self.written = count(&done);
        if self.written < self.range.len() {
            return Err(unbound(path, "not every point of these ranges is there"));
        }
        match taken.sample.is_of(scene, grid)? {
            true => Ok(done),
            false => Err(unbound(path, "its points are not those of this scene")),
        }
    }
}

fn count(done: &[bool]) -> usize {
    done.iter().filter(|done| **done).count()
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
        result.map_err(|error| self.kept(&failed(&self.journal, &error)))
    }

    /// The error of a file that cannot be written, with what is on the disk nevertheless.
    fn kept(&self, error: &SimError) -> SimError {
        SimError::File(format!(
            "{error}; {} of {} points are kept: go on with --resume",
            self.written,
            self.range.len()
        ))
    }

    /// Replaces the file by one with every row in the order of the grid, all at once.
    ///
    /// # Errors
    ///
    /// A file that cannot be written: the unordered one stays.
    pub fn finish(self, grid: &Grid) -> Result<(), SimError> {
        let manifest = self.manifest.as_ref();
        if self.file.is_none() {
            // It was finished before; what it is may not have been said, or be said of another sweep.
            return match (self.form, manifest) {
                (Form::Csv, Some(manifest)) => manifest.write(&self.path),
                _ => Ok(()),
            };
        }
        let kept = |error| self.kept(&error);
        let mut file = Writer::new(&self.path, self.form, grid, manifest).map_err(kept)?;
        let mut add = |index, row: &Row| file.add(index, row).map_err(kept);
        let range = self.range.clone();
        in_order(&self.journal, grid, range, MOST_WAITING, &mut add)?;
        file.finish().map_err(kept)?;
        if self.journal != self.path {
            fs::remove_file(&self.journal).map_err(|error| failed(&self.journal, &error))?;
        }
        self.lock.map_or(Ok(()), Lock::remove)
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
    spare_others(path, form)?;
    let manifest = Manifest::new(scene, grid, shard);
    let mut file = Writer::new(path, form, grid, Some(&manifest))?;
    for (index, row) in shard.range(grid.len()).zip(rows) {
        if let Some(row) = row {
            file.add(index, row)?;
        }
    }
    file.finish()
}
