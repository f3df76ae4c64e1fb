//! The forms of a finished sweep's file: CSV and Parquet.

use std::path::{Path, PathBuf};

use passivity_scene::files::{Output, csv_name};

use crate::error::SimError;
use crate::sweep::csv;
use crate::sweep::disk::failed;
use crate::sweep::grid::Grid;
use crate::sweep::manifest::{Manifest, forget};
#[cfg(feature = "parquet")]
use crate::sweep::parquet;
use crate::sweep::row::{Each, Row};

/// How the rows of a finished sweep are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Form {
    /// The form that the name of a file asks for.
    pub(super) fn of(path: &Path) -> Result<Self, SimError> {
        let parquet = path
            .extension()
            .is_some_and(|end| end.eq_ignore_ascii_case("parquet"));
        if !parquet {
            return match csv_name(path) {
                Ok(()) => Ok(Self::Csv),
                Err(error) => Err(SimError::File(error.to_string())),
            };
        }
        #[cfg(feature = "parquet")]
        return Ok(Self::Parquet);
        #[cfg(not(feature = "parquet"))]
        Err(SimError::NotBuiltIn {
            what: "Parquet files are",
            feature: "parquet",
        })
    }

    /// Reads the rows of a finished file.
    pub(super) fn read(self, path: &Path, grid: &Grid, each: Each<'_>) -> Result<(), SimError> {
        match self {
            Self::Csv => csv::read(path, grid, each).map(drop),
            #[cfg(feature = "parquet")]
            Self::Parquet => parquet::read(path, grid, each),
        }
    }

    /// Whether a file that begins so may be one of rows.
    pub(super) fn begins(self, start: &[u8]) -> bool {
        match self {
            Self::Csv => csv::begins_with_header(start),
            #[cfg(feature = "parquet")]
            Self::Parquet => start.starts_with(b"PAR1"),
        }
    }

    /// The error at a row, from 0.
    pub(super) fn at(self, path: &Path, row: usize, what: &str) -> SimError {
        match self {
            Self::Csv => csv::at(path, row, what),
            #[cfg(feature = "parquet")]
            Self::Parquet => failed(path, &format!("row {}: {what}", row + 1)),
        }
    }
}

/// A file of rows that are added in the order of the grid, and that has its name once all are on the disk.
pub(super) struct Writer<'w> {
    path: PathBuf,
    grid: &'w Grid,
    manifest: Option<&'w Manifest>,
    rows: Rows,
}

enum Rows {
    Csv(csv::Writer),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::Writer>),
}

impl<'w> Writer<'w> {
    /// Starts a file; that of a shard says what it is.
    pub(super) fn new(
        path: &Path,
        form: Form,
        grid: &'w Grid,
        manifest: Option<&'w Manifest>,
    ) -> Result<Self, SimError> {
        let wrong = |error: &dyn std::fmt::Display| failed(path, error);
        // What cannot be written whole is of no use; the rows are in the journal.
        let output = Output::create(path).map_err(|error| wrong(&error))?;
        let rows = match form {
            Form::Csv => Rows::Csv(csv::Writer::new(output, grid).map_err(|error| wrong(&error))?),
            #[cfg(feature = "parquet")]
            Form::Parquet => {
                let writer = parquet::Writer::new(output, grid, manifest.map(Manifest::to_json));
                Rows::Parquet(Box::new(writer.map_err(|error| wrong(&error))?))
            }
        };
        let path = path.to_owned();
        Ok(Self {
            path,
            grid,
            manifest,
            rows,
        })
    }

    pub(super) fn add(&mut self, index: usize, row: &Row) -> Result<(), SimError> {
        let wrong = |error: &dyn std::fmt::Display| failed(&self.path, error);
        match &mut self.rows {
            Rows::Csv(file) => {
                let added = file.add(self.grid, index, row);
                added.map_err(|error| wrong(&error))
            }
            #[cfg(feature = "parquet")]
            Rows::Parquet(file) => {
                let added = file.add(self.grid, index, row);
                added.map_err(|error| wrong(&error))
            }
        }
    }

    /// Has the rows reach the disk, and then their name.
    pub(super) fn finish(self) -> Result<(), SimError> {
        let wrong = |error: &dyn std::fmt::Display| failed(&self.path, error);
        match self.rows {
            Rows::Csv(file) => file.finish().map_err(|error| wrong(&error))?,
            #[cfg(feature = "parquet")]
            Rows::Parquet(file) => {
                let finished = file.finish(self.grid).map_err(|error| wrong(&error));
                return finished;
            }
        }
        match self.manifest {
            Some(manifest) => manifest.write(&self.path),
            None => forget(&self.path),
        }
    }
}
